//! Steady rolling is of second order in the size of the elements: few of them do.

use approx::assert_relative_eq;
use archard::closed_form::carter;
use archard::closed_form::kalker::Coefficients;

use super::rolling::{Patch, coefficient, row};
use super::rolling_wear::{WEAR, twin_discs};
use crate::common::{Rows, case, states};

/// Carter's force relative to mu P with that many elements over the width of the contact, `beyond` of them next to it.
fn carters(across: f64, beyond: usize, relative: f64, options: &str) -> Rows {
    let elements = across.floor() as usize + beyond;
    let width = 0.4 * elements as f64 / across;
    let creepage = 0.003 * relative;
    row(&format!(
        r#"
        body.driver = {{ material = {{ young = "208 GPa", poisson = 0.3 }}, profile.cylinder.radius = "40 mm" }}
        body.driven = {{ material = {{ young = "208 GPa", poisson = 0.3 }}, profile.cylinder.radius = "40 mm" }}
        frame = {{ size = "{width} mm", elements = {elements}, length = "40 mm" }}
        friction.coulomb.coefficient = 0.3
        [motion.rolling]
        load = "7180.8 N"
        revolutions = 0
        {}
        "#,
        if options.is_empty() { format!("creepage = {creepage}") } else { options.to_owned() },
    ))
}

/// Carter's cylinders, wherever the edge of the contact falls inside an element.
#[test]
fn carters_cylinders_on_few_elements() {
    for (across, within) in [(16.0, 2e-3), (20.0, 1.5e-3), (40.0, 4e-4), (80.0, 1.5e-4)] {
        for offset in [0.0, 0.25, 0.5, 0.75] {
            for relative in [0.25, 0.5, 0.75] {
                let rows = carters(across + offset, 8, relative, "");
                let force = rows.last("force_x_N") / (0.3 * rows.last("load_N"));
                assert_relative_eq!(force, carter::relative_force(relative), max_relative = within);
            }
        }
    }
}

/// Force over mu P of balls without Poisson's ratio that roll with a quarter and a half of the creepage mu a/R, from a program of
/// another author on 56 elements across.
const BALLS: [(f64, f64); 2] = [(0.25, 0.51941), (0.5, 0.82879)];

/// A force a few elements tell, wherever the edges of contact and stick fall inside one.
#[test]
fn balls_on_few_elements() {
    for (across, within) in [(16.0, 2.5e-3), (24.0, 1e-3), (40.0, 3e-4)] {
        for (share, limit) in BALLS {
            for offset in [[0.1, 0.3], [0.45, 0.8], [0.7, 0.0]] {
                let [x, y] = offset.map(|offset| offset * 0.2 / across);
                let size = 0.2 * (across + 6.0) / across;
                let rows = row(&format!(
                    r#"
                    body.ball = {{ material = {{ young = "210 GPa", poisson = 0 }}, profile.sphere.radius = "20 mm" }}
                    body.other = {{ material = {{ young = "210 GPa", poisson = 0 }}, profile.sphere.radius = "20 mm" }}
                    friction.coulomb.coefficient = 0.3
                    [frame]
                    size = ["{size} mm", "{size} mm"]
                    centre = ["{x} mm", "{y} mm"]
                    elements = [{0}, {0}]
                    [motion.rolling]
                    load = "14 N"
                    creepage = {1}
                    revolutions = 0
                    "#,
                    across as usize + 6,
                    0.003 * share,
                ));
                let force = rows.last("force_x_N") / (0.3 * rows.last("load_N"));
                assert_relative_eq!(force, limit, max_relative = within);
            }
        }
    }
}

/// What passes on the force that a creepage makes is that creepage: tied pairs count in the sum. Their trend is taken from
/// solutions with plain ties, which take another creepage for the force, and another force for the creepage.
#[test]
fn a_force_given_is_that_of_the_creepage() {
    for direction in ["x", "-x"] {
        let turned = format!("direction = \"{direction}\"");
        let given = carters(20.3, 8, 0.5, &format!("creepage = 0.0015\n{turned}"));
        let force = given.last("force_x_N").abs();
        let found = carters(20.3, 8, 0.5, &format!("force = \"{force} N\"\n{turned}"));
        assert_relative_eq!(found.last("creepage"), 0.0015, max_relative = 5e-5);
        assert_relative_eq!(found.last("force_x_N").abs(), force, max_relative = 1e-6);
    }
}

/// Twin discs at 0.5 % creepage: deepest wear of a revolution over k_w (N/m) and force (N) in the limit of fine elements,
/// extrapolated from 160 and 240 of them across the contact by [`limits`].
const LIMITS: [f64; 2] = [1149.53, 161.037];

/// Deepest wear of a revolution over k_w, force, and section over the work of the creepage.
fn discs(across: usize) -> [f64; 3] {
    let elements = [across + 3; 2];
    let half = [0.2165120, 0.8265901];
    let size = half.map(|half| 2.0 * half * elements[0] as f64 / across as f64);
    let motion = "creepage = 0.005\nrevolutions = 1e-3\nstep = 1e-3";
    let rows = row(&twin_discs(size, elements, motion));
    let sections = ["worn_section_disc1_m2", "worn_section_disc2_m2"];
    let section: f64 = sections.map(|column| rows.last(column) / 1e-3).iter().sum();
    let work = rows.last("frictional_power_per_speed_N") / 0.6;
    let depth = rows.last("wear_depth_m") / 1e-3;
    [depth / WEAR, rows.last("force_x_N"), section / (WEAR * work)]
}

/// What few elements tell; the work of the creepage is what is worn to the tolerance of the solver.
#[test]
fn twin_discs_on_few_elements() {
    let [coarse, fine] = [20, 40].map(discs);
    for (which, limit) in LIMITS.into_iter().enumerate() {
        assert_relative_eq!(coarse[which], limit, max_relative = 2e-3);
        assert_relative_eq!(fine[which], limit, max_relative = 7e-4);
    }
    for found in [coarse, fine] {
        assert_relative_eq!(found[2], 1.0, max_relative = 1e-6);
    }
}

/// C11, C22 and C23 at a Poisson ratio of 1/4, extrapolated by [`limits`] from 80 and 160 elements across; Kalker's table
/// is within 0.4 % of them, in its outermost rows within 1.2 %.
const COEFFICIENTS: [(f64, [f64; 3]); 5] = [
    (0.1, [3.3177, 2.5281, 0.4713]),
    (0.5, [3.6265, 3.0135, 0.9278]),
    (1.0, [4.1145, 3.6698, 1.4658]),
    (2.0, [5.1016, 4.9104, 2.6239]),
    (10.0, [11.786, 12.950, 14.573]),
];

/// Where all sticks the traction grows without bound towards the trailing edge, and what is off depends on where that
/// falls inside an element.
#[test]
fn linear_theory_on_few_elements() {
    for (ratio, limits) in COEFFICIENTS {
        let kalker = Coefficients::at(ratio, 0.25).expect("in the table");
        let kalker = [kalker.longitudinal, kalker.lateral, kalker.lateral_spin];
        for (which, (limit, printed)) in limits.into_iter().zip(kalker).enumerate() {
            let digits = if (0.2..5.0).contains(&ratio) { 0.004 } else { 0.012 };
            assert_relative_eq!(limit, printed, max_relative = digits);
            let found = coefficient(ratio, 0.25, 40, which);
            assert_relative_eq!(found, limit, max_relative = 3e-3);
        }
    }
}

/// Lateral force over mu F, and lateral creepage over the half width (1/m), of a ball on so many elements across its
/// contact.
fn spun(cells: usize, friction: f64, motion: &'static str) -> (f64, f64) {
    let patch = Patch { ratio: 1.0, poisson: 0.25, cells, friction, motion };
    let (_, [a, _], problem, state) = patch.roll();
    let tangential = state.tangential.expect("friction");
    let force = tangential.force(&problem.frame)[1] / (friction * state.load);
    (force, tangential.creepage[1] / a)
}

/// A spin that lets most of the contact stick.
const SPIN: &str = "spin = \"4 1/m\"";

/// The lateral creepage that lets a spin of 10 / m pass without a lateral force is a small difference of large ones; of
/// bodies that stick, C23 sqrt(a b) / C22 of it, which Kalker's table has to half a percent.
#[test]
fn lateral_creepage_against_spin() {
    let (force, creepage) = spun(60, 100.0, "spin = \"10 1/m\"\nlateral_force = \"0 N\"");
    assert!(force.abs() < 1e-6);
    let [_, lateral, spin] = COEFFICIENTS[2].1;
    let creepage = creepage / 10.0;
    assert_relative_eq!(creepage, -spin / lateral, max_relative = 4e-3);
    let kalker = Coefficients::at(1.0, 0.25).expect("in the table");
    assert_relative_eq!(creepage, -kalker.lateral_spin / kalker.lateral, max_relative = 5e-3);
}

/// Pure spin that lets most of the contact stick: the lateral force in the limit of fine elements, from 120 and 160 of
/// them by [`limits`].
const SPUN: f64 = 0.215122;

#[test]
fn pure_spin_on_few_elements() {
    let (force, _) = spun(20, 0.3, SPIN);
    assert_relative_eq!(force, SPUN, max_relative = 5e-3);
}

/// Under a limit that does not grow with the pressure pairs that are tied slip at their own: the force is the sum of all.
#[test]
fn tied_pairs_slip_at_their_limits() {
    let text = twin_discs([0.52, 2.2], [24, 24], "creepage = 0.2\nrevolutions = 0");
    let law = "[friction.tresca]\nshear_strength = \"200 MPa\"\ncoefficient = 0.6";
    let simulation = case(&text.replace("[friction.coulomb]\n        coefficient = 0.6", law), &[]);
    let (state, ..) = states(&simulation).expect("it converges").swap_remove(0);
    let frame = &simulation.problem.frame;
    let limits: Vec<f64> =
        state.pressure.iter().map(|pressure| (0.6 * pressure).min(200e6)).collect();
    let force = state.tangential.expect("friction").force(frame)[0];
    assert_relative_eq!(force, frame.integrate(&limits), max_relative = 1e-4);
    assert!(force < 0.9 * 0.6 * state.load, "no pair reaches the strength");
}

/// Where spin lets all slip friction runs around the centre, and nothing is left of it to either side.
#[test]
fn spin_that_slips_all_over_pushes_nowhere() {
    let (force, _) = spun(20, 0.3, "spin = \"2e5 1/m\"");
    assert!(force.abs() < 5e-3, "{force} of mu F");
}

/// Prints the limits above. They are extrapolated for errors that fall with the square of the size of the elements.
#[test]
#[ignore = "prints numbers that other tests cite"]
fn limits() {
    let limit = |coarse: f64, fine: f64, ratio: f64| fine + (fine - coarse) / (ratio * ratio - 1.0);
    let [coarse, fine] = [160, 240].map(discs);
    for which in 0..2 {
        println!("twin discs {which}: {:.3}", limit(coarse[which], fine[which], 1.5));
    }
    let [coarse, fine] = [120, 160].map(|cells| spun(cells, 0.3, SPIN).0);
    println!("spin: {:.6}", limit(coarse, fine, 4.0 / 3.0));
    for (ratio, _) in COEFFICIENTS {
        let found = [0, 1, 2].map(|which| {
            let [coarse, fine] = [80, 160].map(|cells| coefficient(ratio, 0.25, cells, which));
            limit(coarse, fine, 2.0)
        });
        println!("a/b {ratio}: {:.4} {:.4} {:.4}", found[0], found[1], found[2]);
    }
}
