//! Volumes as test standards compute them from scars and tracks, where one body alone wears, against what was worn.
//!
//! The standards take both bodies to be rigid. Elasticity widens a scar: Hertz's contact and the scar of rigid bodies add
//! about in squares, as in the program's estimates. A width b is then off by 2 (a/b)^2, with a Hertz's half width, and by
//! half an element at each end.

use approx::assert_relative_eq;
use archard::closed_form::standards::segment;
use archard::simulation::Simulation;
use archard_case::output::Standard;

use crate::common::{Rows, case};

/// A ball of 3 mm on a flat, one of them worn, 10 N.
fn ball(wears: &str, coefficient: &str, motion: &str, options: &[&str]) -> Simulation {
    let text = r#"
        [body.ball]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.sphere = { radius = "3 mm" }
        [body.flat]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.flat = {}
        [frame]
        size = ["0.7 mm", "0.7 mm"]
        elements = [71, 71]
        [motion.sliding]
        load = "10 N"
        passes = "flat"
        distance = "800 m"
        tolerance = 0.01
    "#;
    let law = format!("body.{wears}.wear.archard.coefficient={coefficient}");
    case(&[text, motion].concat(), &[&[&*law], options].concat())
}

const TURNS: &str = "track_radius = \"10 mm\"";
const STROKES: &str = "stroke = \"10 mm\"";

/// Half width (m) of Hertz's contact of that ball.
fn hertz() -> f64 {
    (0.75 * 10.0 * 3e-3 * 2.0 * 0.91 / 210e9_f64).cbrt()
}

/// The standards at the end of a run, and its last row.
fn after(simulation: &Simulation) -> (Vec<Standard>, Rows) {
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).expect("it converges");
    (Standard::of(&simulation.problem, rows.0.last().expect("a row")), rows)
}

/// The only standard there is; it is about that body.
fn only(found: &[Standard], name: &str, body: usize) -> Standard {
    let [standard] = found else { panic!("{found:?}") };
    assert_eq!((standard.name, standard.body), (name, body));
    *standard
}

/// How far a section, which depends on the third power of its width, may be off.
fn within(width: f64, element: f64, hertz: f64) -> f64 {
    3.0 * (element / width + 2.0 * (hertz / width).powi(2))
}

/// A flat of 0.47 mm on a ball. The share of Hertz's contact in it, (a/d)^2, is 1.5 %; the second moments of the scar are
/// exact to the square of an element.
#[test]
fn g99_and_g133_have_the_cap_of_a_ball() {
    let turns = ball("ball", "1e-7 mm^3/(N m)", TURNS, &[]);
    let (found, _) = after(&turns);
    assert!(only(&found, "ASTM G99", 0).difference().abs() < (hertz() / 0.47e-3).powi(2));
    let strokes = ball("ball", "1e-7 mm^3/(N m)", STROKES, &[]);
    let (found, _) = after(&strokes);
    assert!(only(&found, "ASTM G133", 0).difference().abs() < (hertz() / 0.47e-3).powi(2));
}

/// A track of 0.28 mm on a flat; under strokes its volume needs no formula.
#[test]
fn g99_has_the_track_of_a_disc() {
    let turns = ball("flat", "5e-6 mm^3/(N m)", TURNS, &[]);
    let (found, _) = after(&turns);
    let track = only(&found, "ASTM G99", 1);
    let most = within(track.width, 0.7e-3 / 71.0, hertz());
    assert!(track.difference().abs() < most, "{}", track.difference());
    let (found, _) = after(&ball("flat", "1e-6 mm^3/(N m)", STROKES, &[]));
    assert_eq!(found, []);
}

/// No standard is about bodies that stay opposite each other, or about an ellipsoid.
#[test]
fn other_motions_and_shapes_have_no_standard() {
    for options in [
        &["motion.sliding.track_radius=", "motion.sliding.passes="][..],
        &["body.ball.profile={paraboloid={radius_x=3 mm, radius_y=4 mm}}"],
    ] {
        let (found, _) = after(&ball("ball", "1e-7 mm^3/(N m)", TURNS, options));
        assert_eq!(found, []);
    }
}

/// A block of 6 mm on a ring of 17.5 mm radius, in plane strain, after that distance.
fn block(distance: &str) -> Simulation {
    let text = r#"
        [body.block]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.flat = {}
        wear.archard = { coefficient = "1e-6 mm^3/(N m)" }
        [body.ring]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.cylinder = { radius = "17.5 mm", axis = "y" }
        [frame]
        size = "1.6 mm"
        elements = 320
        length = "6 mm"
        [motion.sliding]
        load = "300 N"
        track_radius = "17.5 mm"
        passes = "ring"
        tolerance = 0.003
    "#;
    case(text, &[&format!("motion.sliding.distance={distance}")])
}

/// The chord b and the section A of the scar are those of the ring, A = r^2 asin(b/2r) - (b/4) sqrt(4 r^2 - b^2), the
/// better the further Hertz's half width, 0.098 mm, lies behind. The width is off by an element and by the share that
/// elasticity has in it, A by three times that; at 100 m that is 7 %.
#[test]
fn the_scar_of_a_block_takes_the_shape_of_the_ring() {
    let (radius, element) = (17.5e-3, 1.6e-3 / 320.0);
    let hertz = (4.0 * 50e3 * radius * 2.0 * 0.91 / (std::f64::consts::PI * 210e9)).sqrt();
    let differences = ["3 m", "20 m", "100 m"].map(|distance| {
        let (found, rows) = after(&block(distance));
        let standard = only(&found, "ASTM G77", 0);
        let most = within(standard.width, element, hertz);
        assert!(standard.difference().abs() < most, "{}: {most}", standard.difference());
        let worn = rows.last("worn_volume_block_m3") / 6e-3;
        let chord = segment(radius, rows.last("scar_length_m")).unwrap();
        assert_relative_eq!(chord / worn - 1.0, standard.difference(), epsilon = 1e-12);
        assert_relative_eq!(rows.last("scar_width_m"), 6e-3, max_relative = 1e-12);
        chord / worn - 1.0
    });
    assert!(differences.is_sorted_by(|one, next| one > next), "{differences:?}");
}
