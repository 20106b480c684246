//! Damage over a run of fretting: what jumps over cycles make of it.

use std::fs;

use crate::common::resolved;

const CASE: &str = include_str!("../../../../cases/fretting_life/case.toml");

/// The largest damage at each depth, after so many cycles under a coefficient of wear.
fn damage(cycles: usize, wear: &str, stepping: &[&str]) -> Vec<f64> {
    let mut options = vec![
        format!("motion.fretting.cycles={cycles}"),
        format!("body.flat.wear.archard.coefficient=\"{wear}\""),
        format!("body.cylinder.wear.archard.coefficient=\"{wear}\""),
        r#"output={ at=[1] }"#.to_owned(),
        r#"output.stress.flat={ depths=["5 um", "10 um", "20 um"], fatigue={ crossland=0.3 }, damage={ criterion="crossland", strength="900 MPa", exponent=-0.2 } }"#.to_owned(),
    ];
    options.extend(stepping.iter().map(|own| (*own).to_owned()));
    let options: Vec<&str> = options.iter().map(String::as_str).collect();
    let case = resolved(CASE, &options).case;
    let simulation = case.build().unwrap();
    let mut inside = case.inside();
    simulation.run(&mut [&mut inside]).unwrap();
    let dir = tempfile::tempdir().unwrap();
    inside.write(dir.path(), &simulation.problem).unwrap();
    let table = fs::read_to_string(dir.path().join("damage_flat.csv")).unwrap();
    let mut rows = table.lines();
    assert_eq!(rows.next(), Some("depth_m,damage,damage_left"));
    rows.map(|row| row.split(',').nth(1).unwrap().parse().unwrap()).collect()
}

#[test]
#[ignore = "long: in .ci/long"]
fn jumps_over_cycles_leave_the_damage_that_it_is() {
    const ALL: &[&str] = &["motion.fretting.tolerance=", "motion.fretting.jump=1"];
    let (hardly, much) = ("1e-14 1/MPa", "2e-5 1/MPa");
    // Without wear a cycle is as the one before: the first has another beginning, and friction is that of its end.
    let [once, often] = [1, 40].map(|cycles| damage(cycles, hardly, ALL));
    for (once, often) in once.iter().zip(&often) {
        assert!((often / (40.0 * once) - 1.0).abs() < 0.02, "{often} {once}");
    }
    let [every, some] = [ALL, &[]].map(|stepping| damage(40, much, stepping));
    for (every, some) in every.iter().zip(&some) {
        assert!((some / every - 1.0).abs() < 0.1, "{every:e} {some:e}");
    }
    // What wears is damaged less, or this says nothing of wear.
    assert!(every[0] < 0.7 * often[0], "{every:?} {often:?}");
}
