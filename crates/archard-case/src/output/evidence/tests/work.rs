//! Loops whose area is known.

use std::f64::consts::TAU;

use approx::assert_relative_eq;

use super::super::work::Cycle;
use super::report;
use crate::output::fixture::Run;
use archard::simulation::Effort;

/// Increments of a cycle, as the fixture has them.
const COUNT: usize = 8;
/// Amplitudes (m, N), and the angle by which the force runs ahead of the displacement.
const LOOP: [f64; 3] = [3e-6, 2.0, 0.4];

/// The area (J) of a polygon with its corners on an ellipse.
fn area([displacement, force, ahead]: [f64; 3]) -> f64 {
    let corners = COUNT as f64;
    0.5 * corners * (TAU / corners).sin() * displacement * force * ahead.sin()
}

/// How far the ends of three cycles are off: along each of x, y and n a loop, and what was dissipated (J).
fn off(loops: [[f64; 3]; 3], dissipated: f64) -> Vec<Option<f64>> {
    let (run, mut cycle) = (Run::fretting([3, 3]), Cycle::default());
    let steps = (1..=3 * COUNT).map(|step| {
        let place = step as f64 / COUNT as f64;
        let state = run.state(place);
        let columns = ["shift_x_m", "force_x_N", "shift_y_m", "force_y_N", "approach_m", "load_N"];
        let value = |column: usize| {
            let [displacement, force, ahead] = loops[column / 2];
            let angle = TAU * place;
            if column.is_multiple_of(2) {
                displacement * angle.sin()
            } else {
                force * (angle + ahead).sin()
            }
        };
        let row = (0..6).map(|column| (columns[column].to_owned(), value(column)));
        let effort = Effort { dissipated: [dissipated, 0.0], ..Effort::default() };
        let report = archard::simulation::Report { effort, ..report(&run, &state) };
        (step, cycle.take(&report, &row.collect::<Vec<_>>()))
    });
    let mut ends = vec![];
    for (step, off) in steps {
        if step % COUNT == 0 {
            ends.push(off);
        } else {
            assert_eq!(off, None);
        }
    }
    ends
}

/// Work of x, y and n adds up; the first cycle, from rest, is left out.
#[test]
fn the_work_of_loops_is_their_area() {
    let normal = [1e-6, 5.0, 0.2];
    let loops = [LOOP, [1e-6, 1.0, 0.3], normal];
    let work: f64 = loops.into_iter().map(area).sum();
    let [first, second, third] = off(loops, work)[..] else { panic!("three cycles") };
    assert_eq!(first, None);
    assert_relative_eq!(second.unwrap(), 0.0, epsilon = 1e-9);
    assert_relative_eq!(third.unwrap(), 0.0, epsilon = 1e-9);
    let missing = |share: f64| off(loops, share * work)[2].unwrap();
    assert_relative_eq!(missing(2.0), 0.5, max_relative = 1e-9);
    assert_relative_eq!(missing(0.5), 1.0, max_relative = 1e-9);
}

/// Work that friction did not take comes back negative; where all sticks it is held against the rectangle.
#[test]
fn loops_of_no_width_are_held_against_their_rectangle() {
    let still = [0.0; 3];
    let [displacement, force, _] = LOOP;
    let narrow = [displacement, force, 1e-4];
    let [_, _, off_narrow] = off([narrow, still, still], 0.0)[..] else { panic!("three cycles") };
    // The corners of the displacement reach its amplitude, those of the force nearly.
    let rectangle = 4.0 * displacement * force;
    let expected = area(narrow) / (0.02 * rectangle);
    assert_relative_eq!(off_narrow.unwrap(), expected, max_relative = 1e-3);
    assert_eq!(off([still; 3], 0.0)[2], Some(0.0));
    // Against the sense of friction.
    let back = off([[displacement, force, -0.4], still, still], area(LOOP))[2].unwrap();
    assert_relative_eq!(back, 2.0, max_relative = 1e-9);
}
