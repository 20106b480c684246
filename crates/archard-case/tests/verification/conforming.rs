//! Bodies, one of them hollow, as exact circles: Hertz's theory knows them by the sum of their curvatures.

use archard::body::contact_modulus;
use archard::closed_form::Hertz;

use super::accuracy::{answer, assert_within};
use crate::common::STEEL;

/// A case of two steel bodies under a load.
fn pressed([one, two]: [&str; 2], load: f64) -> String {
    let steel = "material = { young = \"210 GPa\", poisson = 0.3 }";
    format!(
        "accuracy = 0.02\n[body.one]\n{steel}\nprofile.{one}\n[body.two]\n{steel}\nprofile.{two}\n\
         [motion.indentation]\nload = \"{load} N\"\n"
    )
}

/// Exact circles keep their terms of fourth order, which nearly cancel: what is left of them is of the order of the square of
/// contact over radius.
#[test]
fn hollows_of_exact_circles_are_hertz_contacts() {
    let cases = [
        (
            ["sphere.radius = \"50 mm\"", "sphere.radius = \"-50.01 mm\""],
            [50.0, 50.0],
            [-50.01; 2],
            1.0,
        ),
        (["sphere.radius = \"-14.1 mm\"", "sphere.radius = \"14 mm\""], [14.0; 2], [-14.1; 2], 5.0),
        (
            [
                "sphere.radius = \"4.7625 mm\"",
                "disc = { radius = \"18.2 mm\", crown = \"-4.95 mm\" }",
            ],
            [4.7625; 2],
            [18.2, -4.95],
            0.5,
        ),
        (
            ["disc = { radius = \"9 mm\", crown = \"5 mm\" }", "cylinder.radius = \"-10 mm\""],
            [9.0, 5.0],
            [-10.0, f64::INFINITY],
            1.0,
        ),
        // A ball of a bearing in its groove: as much as 1/5 of the radius of the groove is in contact across.
        (
            ["sphere.radius = \"5.5 mm\"", "disc = { radius = \"20 mm\", crown = \"-5.72 mm\" }"],
            [5.5; 2],
            [20.0, -5.72],
            500.0,
        ),
    ];
    let modulus = contact_modulus([Some(&STEEL); 2]);
    for (profiles, one, two, load) in cases {
        let curvatures = [0, 1].map(|axis| 1e3 / one[axis] + 1e3 / two[axis]);
        let hertz = Hertz::from_load(curvatures, modulus, load).unwrap();
        let row = answer(&pressed(profiles, load), &[]);
        let beyond = [0, 1]
            .map(|axis| hertz.semi_axes[axis] * 1e3 / one[axis].abs())
            .map(|share| share * share);
        let off = beyond[0].max(beyond[1]);
        for (column, truth) in
            [("peak_pressure_Pa", hertz.peak_pressure), ("approach_m", hertz.approach)]
        {
            assert_within(&row, column, (truth, off * truth), &format!("{profiles:?}"));
        }
    }
}
