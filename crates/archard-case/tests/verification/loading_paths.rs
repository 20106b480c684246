//! Loads and forces along paths from a table: a sphere under an oblique force (Mindlin and Deresiewicz),
//! and an oscillation written out.

use std::fmt::Write;

use approx::assert_relative_eq;
use archard::problem::{ContactProblem, ContactState};

use crate::common::{case, states};

use super::cattaneo_mindlin::sphere;

/// The states of a sphere of some Poisson ratio on 64 x 64 elements, led along a table.
fn along(table: &str, increments: usize, poisson: f64) -> (ContactProblem, Vec<ContactState>) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("path.csv");
    std::fs::write(&file, table).expect("a file");
    let text = sphere(64, poisson, "");
    let (text, _) = text.split_once("[motion").expect("a motion");
    let motion = format!("[motion.path]\nfile = {:?}\nincrements = {increments}", file);
    let simulation = case(&format!("{text}\n{motion}"), &[]);
    let states = states(&simulation).expect("it converges");
    (simulation.problem, states.into_iter().map(|(state, ..)| state).collect())
}

/// From 5 N on load and force rise together, the force 0.2 times as fast, less than mu = 0.3: nothing
/// slips, and each increment of the pressures brings 0.2 of itself as traction, under which a circle moves
/// (1 - nu/2) / (1 - nu) times as far as under the pressure. At the edge of the first contact the tractions of the
/// increments begin, in whole elements.
#[test]
fn an_oblique_force_within_friction_makes_nothing_slip() {
    let table = "time_s,load_N,force_x_N\n0,5,0\n1,10.2,1.04\n";
    for poisson in [0.0, 0.3] {
        let (problem, states) = along(table, 40, poisson);
        let (first, last) = (&states[0], &states[40]);
        let tangential = last.tangential.as_ref().expect("friction");
        let largest = last.pressure.iter().copied().fold(0.0, f64::max);
        let mut most = 0.0f64;
        for pair in 0..problem.frame.len() {
            let expected = 0.2 * (last.pressure[pair] - first.pressure[pair]);
            let off = (tangential.traction[0][pair] - expected).abs();
            most = most.max(off / (0.3 * largest));
        }
        let stick = tangential.stick_area(&problem, &last.pressure);
        let contact = last.pairs_in_contact() as f64 * problem.frame.element_area();
        let ratio = (1.0 - poisson / 2.0) / (1.0 - poisson);
        let expected = 0.2 * ratio * (last.approach - first.approach);
        assert!(most < 0.02, "{most}");
        assert!(stick > 0.98 * contact, "{}", stick / contact);
        assert_relative_eq!(tangential.shift[0], expected, max_relative = 2e-3);
    }
}

/// From nothing on load and force rise together: nothing slips, the traction is 0.2 of the pressure everywhere,
/// and the bodies are shifted by (1 - nu/2) / (1 - nu) times 0.2 of the approach, however few the increments. Single
/// pairs are off where an increment ends at the edge of the contact, in whole elements.
#[test]
fn an_oblique_force_from_nothing_sticks_where_pairs_touch() {
    let table = "time_s,load_N,force_x_N\n0,0,0\n1,10.2,2.04\n";
    for (increments, within, local) in [(5, 5e-3, 0.04), (20, 2e-3, 0.02)] {
        let (problem, states) = along(table, increments, 0.3);
        let last = &states[increments];
        let tangential = last.tangential.as_ref().expect("friction");
        let stick = tangential.stick_area(&problem, &last.pressure);
        let contact = last.pairs_in_contact() as f64 * problem.frame.element_area();
        assert_relative_eq!(stick, contact, max_relative = 1e-12);
        let expected = 0.2 * 0.85 / 0.7 * last.approach;
        assert_relative_eq!(tangential.shift[0], expected, max_relative = within);
        let largest = last.pressure.iter().copied().fold(0.0, f64::max);
        for pair in 0..problem.frame.len() {
            let [x, y] = [0, 1].map(|axis| tangential.traction[axis][pair]);
            let off = (x - 0.2 * last.pressure[pair]).hypot(y) / largest;
            assert!(off < local, "{pair}: {off}");
        }
    }
}

/// The increments of an oscillation, line by line: the forces are those of the motion itself.
#[test]
fn a_table_of_an_oscillation_is_the_oscillation() {
    let amplitude = 0.06;
    let mut table = "time_s,load_N,shift_x_um\n".to_owned();
    for line in 0..=8 {
        let shift = amplitude * (f64::from(line) * std::f64::consts::TAU / 8.0).sin();
        writeln!(table, "{line},10.2,{shift}").expect("a text");
    }
    let motion = format!("amplitude = [\"{amplitude} um\", \"0 um\"]\nincrements = 8");
    let simulation = case(&sphere(64, 0.3, &motion), &[]);
    let known = states(&simulation).expect("it converges");
    let (problem, found) = along(&table, 1, 0.3);
    assert_eq!(known.len(), found.len());
    for ((known, ..), found) in known.iter().zip(&found) {
        let [known, found] = [known, found]
            .map(|state| state.tangential.as_ref().expect("friction").force(&problem.frame)[0]);
        assert_relative_eq!(known, found, epsilon = 1e-6);
    }
}
