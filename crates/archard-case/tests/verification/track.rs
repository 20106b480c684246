//! Bodies that slide on a track: one stays in contact, the other passes under it.

use std::f64::consts::TAU;

use approx::assert_relative_eq;
use archard::closed_form::worn_track::worn;
use archard::problem::Surface;
use archard::simulation::Error;
use archard::simulation::history::number;
use archard::simulation::refusal::Part;

use crate::common::{Rows, case, states};

/// A ball of 3 mm on a disc, with these coefficients (mm^3/(N m)), after so many metres.
fn text(ball: f64, disc: f64, motion: &str) -> String {
    format!(
        r#"
        [body.ball]
        material = {{ young = "210 GPa", poisson = 0.3 }}
        profile.sphere = {{ radius = "3 mm" }}
        wear.archard = {{ coefficient = "{ball} mm^3/(N m)" }}
        [body.disc]
        material = {{ young = "210 GPa", poisson = 0.3 }}
        profile.flat = {{}}
        wear.archard = {{ coefficient = "{disc} mm^3/(N m)" }}
        [frame]
        size = ["0.6 mm", "0.6 mm"]
        elements = [41, 41]
        [motion.sliding]
        load = "10 N"
        {motion}
    "#
    )
}

const TRACK: &str = "track_radius = \"10 mm\"\npasses = \"disc\"\ndistance = \"600 m\"";

fn rows(text: &str, options: &[&str]) -> Rows {
    let mut rows = Rows::default();
    case(text, options).run(&mut [&mut rows]).expect("it converges");
    rows
}

/// Each body loses k F s, the disc over the whole track, and both have the shape that geometry gives them.
#[test]
fn volumes_follow_from_the_load_and_shapes_from_geometry() {
    let length = 0.01 * TAU;
    for (ball, disc) in [(1e-7, 5e-6), (1e-7, 3e-7), (2e-8, 8e-6)] {
        let found = rows(&text(ball, disc, TRACK), &["motion.sliding.tolerance=0.003"]);
        let worked = 10.0 * 600.0;
        let [ball, disc] = [ball, disc].map(|k| k * 1e-9);
        assert_relative_eq!(
            found.last("worn_volume_ball_m3") / (ball * worked),
            1.0,
            max_relative = 1e-9
        );
        assert_relative_eq!(
            found.last("worn_volume_disc_m3") / (disc * worked),
            1.0,
            max_relative = 1e-9
        );
        assert_relative_eq!(
            found.last("wear_rate_disc_m3_per_Nm") / disc,
            1.0,
            max_relative = 1e-9
        );
        let section = disc * worked / length;
        assert_relative_eq!(found.last("worn_section_disc_m2") / section, 1.0, max_relative = 1e-9);
        let rigid = worn([1.0 / 3e-3; 2], [ball, disc], length, worked);
        // Elasticity widens the scar.
        let ratio = |column: &str, rigid: f64| found.last(column) / rigid;
        assert_relative_eq!(ratio("wear_depth_ball_m", rigid.scar_depth), 1.0, max_relative = 0.02);
        assert_relative_eq!(
            ratio("wear_depth_disc_m", rigid.groove_depth),
            1.0,
            max_relative = 0.02
        );
        assert_relative_eq!(ratio("scar_width_m", rigid.extent[1]), 1.0, max_relative = 0.04);
        assert_relative_eq!(found.last("turns"), 600.0 / length, max_relative = 1e-12);
    }
}

/// A body of known density loses density k F s, off the whole track of one that passes; no other is weighed.
#[test]
fn what_is_worn_off_is_weighed_where_the_density_is_known() {
    let disc =
        text(1e-7, 5e-6, TRACK).replace("[body.disc]", "[body.disc]\ndensity = \"7.85 g/cm^3\"");
    let found = rows(&disc, &["motion.sliding.step=60 m"]);
    let loss = 7850.0 * 5e-15 * 10.0 * 600.0;
    assert_relative_eq!(found.last("mass_loss_disc_kg") / loss, 1.0, max_relative = 1e-9);
    assert!(number(&found.0[0], "mass_loss_ball_kg").is_none());
    let idle =
        text(0.0, 5e-6, TRACK).replace("[body.ball]", "[body.ball]\ndensity = \"7850 kg/m^3\"");
    let found = rows(&idle, &["motion.sliding.step=60 m", "body.ball.wear="]);
    assert!(number(&found.0[0], "mass_loss_ball_kg").is_none());
}

/// A disc that does not wear leaves the pin as if there were no track.
#[test]
fn on_a_hard_disc_the_pin_wears_as_without_a_track() {
    let options = ["motion.sliding.step=20 m"];
    let track = rows(&text(1e-7, 0.0, TRACK), &options);
    let plain = rows(&text(1e-7, 0.0, "distance = \"600 m\"\nsurfaces = \"stay\""), &options);
    for column in ["wear_depth_ball_m", "approach_m", "centre_pressure_Pa", "worn_volume_ball_m3"] {
        let both = track.column(column).into_iter().zip(plain.column(column)).skip(1);
        both.for_each(|(one, other)| assert_relative_eq!(one / other, 1.0, max_relative = 1e-7));
    }
}

/// A ball that does not wear makes a groove of its own radius: a segment of a circle, but for the elastic flattening.
#[test]
fn a_hard_ball_makes_a_groove_of_its_own_shape() {
    let found =
        rows(&text(0.0, 5e-6, TRACK), &["motion.sliding.tolerance=0.003", "body.ball.wear="]);
    let section: f64 = 5e-15 * 6000.0 / (0.01 * TAU);
    let width = (12.0 * 3e-3 * section).cbrt();
    let depth = width * width / (8.0 * 3e-3);
    assert_relative_eq!(found.last("worn_section_disc_m2") / section, 1.0, max_relative = 1e-9);
    assert_relative_eq!(found.last("wear_depth_disc_m") / depth, 1.0, max_relative = 0.03);
}

/// It does not matter which body comes first, or along which axis the track runs.
#[test]
fn bodies_and_axes_may_be_swapped() {
    let options = ["motion.sliding.step=60 m"];
    let straight = text(1e-7, 5e-6, TRACK);
    let (ball, disc) =
        (straight.find("[body.ball]").unwrap(), straight.find("[body.disc]").unwrap());
    let end = straight.find("[frame]").unwrap();
    let swapped =
        [&straight[..ball], &straight[disc..end], &straight[ball..disc], &straight[end..]].concat();
    let turned = format!("{straight}\ndirection = \"y\"");
    let straight = rows(&straight, &options);
    for other in [swapped, turned] {
        let other = rows(&other, &options);
        for column in [
            "wear_depth_ball_m",
            "wear_depth_disc_m",
            "approach_m",
            "worn_volume_disc_m3",
            "scar_length_m",
        ] {
            assert_relative_eq!(
                other.last(column) / straight.last(column),
                1.0,
                max_relative = 1e-9
            );
        }
    }
}

/// All points on a line of the track are worn equally; those of the ball are not.
#[test]
fn what_passes_wears_alike_along_the_track() {
    let simulation = case(&text(1e-7, 5e-6, TRACK), &["motion.sliding.step=100 m"]);
    let (last, ..) = states(&simulation).expect("it converges").pop().expect("states");
    for row in last.worn(1).chunks(41) {
        assert!(row.iter().all(|depth| *depth == row[0]));
    }
    assert!(last.worn(0).chunks(41).any(|row| row.iter().any(|depth| *depth != row[0])));
}

/// The error stated is no smaller than the true one, over five tolerances, and with its margin below 2.5 times them.
#[test]
fn steps_by_error_are_honest_on_a_track() {
    let text = text(1e-7, 5e-6, TRACK);
    let depths = |tolerance: &str| {
        let found = rows(&text, &["frame.elements=[31, 31]", tolerance]);
        (
            ["ball", "disc"].map(|body| found.last(&format!("wear_depth_{body}_m"))),
            found.last("time_error"),
        )
    };
    let (exact, _) = depths("motion.sliding.tolerance=3e-5");
    for tolerance in [3e-2, 1e-2, 3e-3, 1e-3, 3e-4] {
        let (found, stated) = depths(&format!("motion.sliding.tolerance={tolerance}"));
        let [total, right] = [found, exact].map(|depths| depths[0] + depths[1]);
        assert!((total / right - 1.0).abs() <= stated, "{tolerance}: {total:e}, {stated:e}");
        assert!(stated <= 2.5 * tolerance);
    }
}

/// Similarity: twice the track, twice the k of what passes.
#[test]
fn a_track_twice_as_long_takes_twice_the_coefficient() {
    let options = ["motion.sliding.step=60 m"];
    let short = rows(&text(1e-7, 2e-6, TRACK), &options);
    let long = rows(&text(1e-7, 4e-6, &TRACK.replace("10 mm", "20 mm")), &options);
    for column in ["wear_depth_ball_m", "wear_depth_disc_m", "approach_m", "peak_pressure_Pa"] {
        assert_relative_eq!(long.last(column) / short.last(column), 1.0, max_relative = 1e-12);
    }
}

/// Explicit steps and implicit ones enclose the depth, and come together.
#[test]
fn explicit_steps_on_a_track_meet_implicit_ones() {
    let coarse = ["frame.elements=[15, 15]", "frame.size=[\"0.8 mm\", \"0.8 mm\"]"];
    let depth = |more: &[&str]| {
        let found = rows(&text(1e-9, 5e-8, TRACK), &[&coarse[..], more].concat());
        found.last("wear_depth_m")
    };
    let (implicit, explicit) = ("motion.sliding.step=2 m", "motion.sliding.scheme=explicit");
    assert_relative_eq!(
        depth(&[implicit]) / depth(&[implicit, explicit]),
        1.0,
        max_relative = 0.02
    );
}

/// Nothing passes across a plane of symmetry.
#[test]
fn a_track_does_not_cross_a_plane_of_symmetry() {
    let text = r#"
        [body.punch]
        rigid = true
        profile.power = { coefficient = "0.75 1/m^3", exponent = 4 }
        wear.archard = { coefficient = "1e-8 1/Pa" }
        [body.block]
        material = { young = "210 GPa", poisson = 0.3 }
        mesh.box = { size = ["1 m", "1 m", "1 m"], contact = { face = "top", size = ["0.2 m", "0.2 m"], elements = [4, 4] } }
        supports = { bottom = "clamped" }
        symmetry = ["x"]
        [motion.sliding]
        approach = "0.05 mm"
        track = "2 m"
        passes = "punch"
        distance = "1 m"
        step = "1 m"
    "#;
    let refused = std::panic::catch_unwind(|| case(text, &[]).run(&mut []));
    // The check of the case says so, or the run does.
    assert!(!matches!(refused, Ok(Ok(_))));
    if let Ok(Err(error)) = refused {
        assert!(matches!(&error, Error::Refused(all) if all.0[0].part == Part::Motion), "{error}");
    }
}

/// The profile of a track from end to end: places (m) and worn sections (m^2).
fn along(text: &str, options: &[&str]) -> (Rows, Vec<(f64, f64)>) {
    let simulation = case(text, options);
    let mut rows = Rows::default();
    let mut states = crate::common::States::of(&simulation);
    simulation.run(&mut [&mut rows, &mut states]).expect("it converges");
    let state = &states.0[states.0.len() - 1].0;
    let swings = |surface: &&Surface| surface.grid.swings().is_some();
    let surface = state.surfaces.iter().find(swings).expect("a surface that swings");
    let means = surface.along(0);
    let frame = &simulation.problem.frame;
    let middle = 0.5 * (means.len() as f64 - 1.0);
    let place = |index: usize| (index as f64 - middle) * frame.spacing()[0];
    let section = |(index, [mean, _]): (usize, [f64; 2])| (place(index), mean * frame.size()[1]);
    (rows, means.into_iter().enumerate().map(section).collect())
}

/// While the wear is small against the elastic approach, the pressures stay Hertz's: the section of a stroke L is k F s / L
/// where all of the contact passes, half of it where the middle of the contact turns, and zero where it does not reach.
#[test]
fn a_stroke_ends_where_the_contact_turns() {
    let stroke = "stroke = \"1.6 mm\"\npasses = \"disc\"\ndistance = \"0.4 m\"\nends = true";
    let (ball, disc) = (1e-7, 5e-6);
    for (direction, step) in [("x", "tolerance = 0.003"), ("x", "step = \"0.1 m\"")] {
        let motion = format!("{stroke}\n{step}\ndirection = \"{direction}\"");
        let (rows, profile) = along(&text(ball, disc, &motion), &["output={}"]);
        let worked = 10.0 * 0.4;
        for (body, k) in [("ball", ball), ("disc", disc)] {
            let volume = rows.last(&format!("worn_volume_{body}_m3"));
            assert_relative_eq!(volume / (k * 1e-9 * worked), 1.0, max_relative = 1e-9);
        }
        let section = disc * 1e-9 * worked / 1.6e-3;
        assert_relative_eq!(rows.last("worn_section_disc_m2") / section, 1.0, max_relative = 2e-3);
        // Half the width of the contact is 58 um, an element 15 um.
        for &(place, found) in &profile {
            let beyond = place.abs() - 0.8e-3;
            let share = found / section;
            match beyond {
                _ if beyond < -90e-6 => assert_relative_eq!(share, 1.0, max_relative = 0.01),
                _ if beyond > 90e-6 => assert!(share < 1e-3, "{share} at {place}"),
                _ => assert!((0.0..1.01).contains(&share), "{share} at {place}"),
            }
        }
        let at = |end: f64| {
            let near = profile.windows(2).find(|pair| pair[0].0 <= end && end < pair[1].0);
            let [(from, one), (to, two)] = near.expect("an end")[..] else { panic!("a pair") };
            one + (two - one) * (end - from) / (to - from)
        };
        let halves = 0.5 * (at(-0.8e-3) + at(0.8e-3)) / section;
        assert_relative_eq!(halves, 0.5, epsilon = 0.02);
    }
}

/// Far from its ends a stroke wears as a surface that passes, and the ball likewise; ends that wear on reach further in.
#[test]
#[ignore = "long: in .ci/long"]
fn a_long_stroke_passes() {
    let stroke = "stroke = \"3 mm\"\npasses = \"disc\"\ndistance = \"40 m\"\ntolerance = 0.003";
    let text = text(1e-7, 1e-6, stroke);
    let passes = rows(&text, &["output={}"]);
    let ends = rows(&text, &["output={}", "motion.sliding.ends=true"]);
    for (column, within) in [
        ("worn_section_disc_m2", 5e-3),
        ("wear_depth_ball_m", 1e-2),
        ("wear_depth_disc_m", 1e-2),
        ("scar_width_m", 1e-2),
        ("turns", 1e-12),
    ] {
        assert_relative_eq!(ends.last(column) / passes.last(column), 1.0, epsilon = within);
    }
}
