//! The files of a pin that frets.

use approx::assert_relative_eq;
use serde_json::Value;
use tempfile::{TempDir, tempdir};

use super::{summary, table};
use crate::output::fixture::{AMPLITUDE, DISSIPATED, FRICTION, LOAD, Run};
use crate::output::{ResultFolder, Totals};
use archard::body::{Material, contact_modulus};
use archard::closed_form::cattaneo_mindlin::PartialSlip;
use archard::closed_form::fretting_wear::WornOut;

/// The folder of the pin at these cycles, every increment of them, outputs at the start and at the end of
/// the last.
fn fretted(run: &Run, cycles: &[u32]) -> TempDir {
    let dir = tempdir().unwrap();
    let mut folder = ResultFolder::create(dir.path(), "").unwrap();
    let end = f64::from(cycles[cycles.len() - 1]);
    let increment = |cycle: u32| (1..=8).map(move |step| f64::from(8 * (cycle - 1) + step) / 8.0);
    let places: Vec<f64> =
        [0.0].into_iter().chain(cycles.iter().copied().flat_map(increment)).collect();
    run.show(&mut folder, &places, |cycle| cycle == 0.0 || cycle == end);
    folder.finish(&Totals::default()).unwrap();
    dir
}

/// A block of the closed forms.
fn block(summary: &Value, name: &str) -> impl Fn(&str) -> f64 {
    let block = summary["closed_form"][name].clone();
    move |key| block[key].as_f64().unwrap()
}

#[test]
fn loops_begin_where_the_cycle_before_ended() {
    let (header, rows) = table(&fretted(&Run::fretting([9, 8]), &[1, 2, 3]), "fretting_loop.csv");
    let known = "cycle shift_x_m shift_y_m force_x_N force_y_N load_N stick_area_m2";
    assert_eq!(header, known);
    // The first cycle and the one that ends with the output, but not the second.
    let cycles: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    let expected =
        [0.0, 2.0].into_iter().flat_map(|start| (0..=8).map(move |i| start + f64::from(i) / 8.0));
    assert_eq!(cycles, expected.collect::<Vec<_>>());
    let turn = &rows[2];
    assert_relative_eq!(turn[1], AMPLITUDE, max_relative = 1e-14);
    assert_relative_eq!(turn[3], 0.5 * FRICTION * LOAD, max_relative = 1e-14);
    assert_relative_eq!(turn[5], LOAD, max_relative = 1e-14);
}

#[test]
fn a_cycle_behind_a_jump_begins_with_its_first_increment() {
    let (_, rows) = table(&fretted(&Run::fretting([9, 8]), &[1, 100]), "fretting_loop.csv");
    assert_eq!(rows.len(), 9 + 8);
    assert_eq!((rows[8][0], rows[9][0], rows[16][0]), (1.0, 99.125, 100.0));
}

#[test]
fn bodies_that_are_not_shifted_have_no_loop() {
    let dir = fretted(&Run::fretting([9, 8]), &[1]);
    let file = dir.path().join("fretting_loop.csv");
    assert!(file.exists());
    let mut folder = ResultFolder::create(dir.path(), "").unwrap();
    assert!(!file.exists());
    Run::pin_on_disc([6, 5]).show(&mut folder, &[0.0, 0.5], |_| true);
    assert!(!file.exists());
}

#[test]
fn the_summary_counts_cycles_and_what_they_dissipate() {
    let fretted = summary(&fretted(&Run::fretting([9, 8]), &[1, 2, 3]));
    assert_eq!(fretted["true_cycles"], 3);
    assert_relative_eq!(fretted["dissipated_J"].as_f64().unwrap(), 3.0 * DISSIPATED);
    let slid = summary(&super::folder());
    assert!(slid["true_cycles"].is_null() && slid["dissipated_J"].is_null());
}

#[test]
fn the_summary_has_the_closed_forms_of_fretting() {
    let run = Run::fretting([9, 8]);
    let summary = summary(&fretted(&run, &[1]));
    let steel = Material { young: 210e9, poisson: 0.3 };
    let sphere = PartialSlip::new(50e-3, [Some(&steel); 2], LOAD, FRICTION).unwrap();
    let force = sphere.force(AMPLITUDE);
    let known = block(&summary, "cattaneo_mindlin");
    for (key, value) in [
        ("contact_radius_m", sphere.contact_radius),
        ("sliding_force_N", FRICTION * LOAD),
        ("sliding_shift_m", sphere.sliding_shift),
        ("shift_amplitude_m", AMPLITUDE),
        ("force_amplitude_N", force),
        ("stick_radius_m", sphere.stick_radius(force)),
        ("dissipated_per_cycle_J", sphere.dissipation(force)),
    ] {
        assert_relative_eq!(known(key), value, max_relative = 1e-13);
    }
    let modulus = contact_modulus([Some(&steel); 2]);
    let end = WornOut::new(50e-3, modulus, LOAD, sphere.stick_radius(force)).unwrap();
    let known = block(&summary, "fretting_wear");
    assert_relative_eq!(known("approach_m"), end.approach, max_relative = 1e-13);
    assert_relative_eq!(known("worn_volume_m3"), end.volume(), max_relative = 1e-12);
    for name in ["pin_on_disc", "spence"] {
        assert!(summary["closed_form"][name].is_null(), "{name}");
    }
}

/// Spence's stick ratio and load of a rigid sphere on steel: independent values.
#[test]
fn the_summary_has_the_stick_of_unlike_bodies() {
    let dir = tempdir().unwrap();
    let mut folder = ResultFolder::create(dir.path(), "").unwrap();
    let run = Run::pressed([9, 8], 0.23801);
    run.show(&mut folder, &[0.0, 1.0], |_| true);
    folder.finish(&Totals::default()).unwrap();
    let summary = summary(&dir);
    let known = block(&summary, "spence");
    // (1 - 2 nu)/(2 (1 - nu)) of steel; negative where the second body is the more compliant.
    assert_relative_eq!(known("coupling"), -0.4 / 1.4, max_relative = 1e-13);
    // The solution is known to 2e-4.
    assert_relative_eq!(known("stick_ratio"), 0.8, max_relative = 2e-4);
    let modulus = summary["closed_form"]["contact_modulus_Pa"].as_f64().unwrap();
    let frictionless = 4.0 / 3.0 * modulus * known("contact_radius_m").powi(3) / 50e-3;
    assert_relative_eq!(known("load_N") / frictionless, 1.0389, max_relative = 1e-4);
    assert!(summary["closed_form"]["cattaneo_mindlin"].is_null());
    assert!(!dir.path().join("fretting_loop.csv").exists());
}
