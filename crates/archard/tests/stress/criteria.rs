//! Criteria of fatigue against values by hand and by another program.

use std::f64::consts::TAU;

use archard::closed_form::sliding_line;
use archard::stress::criteria::{
    Elastic, crossland, dang_van, fatemi_socie, findley, smith_watson_topper,
};
use archard::stress::{Components, smallest_ball};

const STEEL: Elastic = Elastic { young: 210e3, poisson: 0.3 };

/// Tension and torsion (MPa) that lag behind by an angle.
fn tension_and_torsion(lag: f64) -> Vec<Components> {
    let at = |step: i32| {
        let w = TAU * f64::from(step) / 64.0;
        [50.0 + 200.0 * w.sin(), 0.0, 0.0, 120.0 * (w - lag).sin(), 0.0, 0.0]
    };
    (0..64).map(at).collect()
}

/// A line of contact that rolls over, 1000 MPa, half a half-width deep, with a tenth of friction.
fn rolling() -> Vec<Components> {
    let at = |step: i32| {
        let (x, z) = (4.0 - 0.05 * f64::from(step), 0.5);
        sliding_line::stress([x, z], 0.1, 0.3).map(|value| 1000.0 * value)
    };
    (0..161).map(at).collect()
}

#[test]
fn criteria_have_the_values_of_known_paths() {
    type Known = [f64; 6];
    // By hand for the first path: 120; 250/3; 120 + 0.3 250; 120/G 1.5; 250 200/E; the ball of the second: hypot(200/3^.5, 120).
    let paths: [(Vec<Components>, Known); 3] = [
        (
            tension_and_torsion(TAU / 4.0),
            [120.0, 83.33333, 130.31256, 195.0, 2.228571e-3, 0.238095],
        ),
        (
            tension_and_torsion(0.0),
            [166.53328, 83.33333, 181.20499, 207.50662, 2.572105e-3, 0.387075],
        ),
        (rolling(), [250.74406, -3.14237, 174.09930, 250.62183, 3.103155e-3, 0.0]),
    ];
    for (path, known) in paths {
        let [amplitude, hydrostatic] = crossland(&path);
        let found = [
            amplitude,
            hydrostatic,
            dang_van(&path, 0.3),
            findley(&path, 0.3).0,
            fatemi_socie(&path, STEEL, (1.0, 500.0)).0,
            smith_watson_topper(&path, STEEL).0,
        ];
        for (index, (found, known)) in found.into_iter().zip(known).enumerate() {
            // Of Dang Van one other program alone is known.
            let within = if index == 2 { 1e-4 } else { 3e-6 };
            assert!(
                (found - known).abs() <= within * known.abs() + 1e-9,
                "{index}: {found} {known}"
            );
        }
    }
}

/// Tension to and fro about a mean, with a little of all else: planes of every direction around the axis are about as bad, and the search
/// for the worst ends.
#[test]
fn tension_about_even_around_its_axis_has_the_values_of_tension_alone() {
    let (mean, swing) = (30.0, 100.0);
    let most = mean + swing;
    for little in [0.0, 1e-6, 1e-4, 1e-2] {
        let at = |step: i32| {
            let (sin, cos) = (TAU * f64::from(step) / 10.0).sin_cos();
            [
                mean + swing * cos,
                -little,
                -little * (1.0 + 0.2 * cos),
                little * sin,
                little * cos,
                0.0,
            ]
        };
        let path: Vec<Components> = (0..10).map(at).collect();
        let [amplitude, hydrostatic] = crossland(&path);
        // By Mohr's circles: half of the swing at 45 degrees, a factor k turns the plane.
        let k = 0.3;
        let known = [
            (amplitude, swing / 3f64.sqrt()),
            (hydrostatic, most / 3.0),
            (dang_van(&path, k), 0.5 * swing + k * most / 3.0),
            (findley(&path, k).0, 0.5 * (k * most + (k * most).hypot(swing))),
            (smith_watson_topper(&path, STEEL).0, most * swing / STEEL.young),
        ];
        for (index, (found, known)) in known.into_iter().enumerate() {
            assert!(
                (found / known - 1.0).abs() < 1e-8 + 0.03 * little,
                "{little} {index}: {found} {known}"
            );
        }
    }
}

#[test]
fn the_smallest_ball_holds_all_points_and_rests_on_some() {
    let square = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [0.3, 0.2]];
    let (centre, radius) = smallest_ball(&square);
    assert!(centre.iter().all(|own| own.abs() < 1e-12) && (radius - 1.0).abs() < 1e-12);
    // An obtuse triangle rests on its longest side.
    let (centre, radius) = smallest_ball(&[[0.0, 0.0], [4.0, 0.0], [1.0, 0.5]]);
    assert!((centre[0] - 2.0).abs() < 1e-12 && centre[1].abs() < 1e-12);
    assert!((radius - 2.0).abs() < 1e-12);
    assert_eq!(smallest_ball(&[[3.0, 4.0], [3.0, 4.0]]), ([3.0, 4.0], 0.0));
    assert_eq!(smallest_ball::<2>(&[]).1, 0.0);
}
