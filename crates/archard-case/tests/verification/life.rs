//! Runs that end where a quantity reaches its limit.

use approx::assert_relative_eq;
use archard::simulation::Observer;
use archard_case::CaseFile;
use archard_case::output::{Life, Limit, LimitPoint};

use crate::common::{Rows, case};

const CASE: &str = include_str!("../framed/pin_on_disc/case.toml");
/// Coefficient (1/Pa) and load (N) of the case.
const WEARS: f64 = 1.33e-13 * 10.2;

/// Where a limit is reached, and the rows until there.
fn lives(limits: &[(&str, f64)], options: &[&str]) -> (Option<LimitPoint>, Rows) {
    let limit =
        |(column, value): &(&str, f64)| Limit { column: (*column).to_owned(), value: *value };
    let (mut rows, mut life) = (Rows::default(), Life::until(limits.iter().map(limit).collect()));
    let observers: &mut [&mut dyn Observer] = &mut [&mut rows, &mut life];
    case(CASE, options).run(observers).expect("a run");
    (life.reached().cloned(), rows)
}

/// Worn volumes are k F s, so that a volume gives the distance, and the run ends on the step that passes it.
#[test]
fn volumes_last_as_long_as_load_and_coefficient_say() {
    let volume = WEARS * 0.2;
    let (reached, rows) = lives(&[("worn_volume_pin_m3", volume), ("wear_depth_pin_m", 1.0)], &[]);
    let reached = reached.expect("the limit of the volume");
    assert_eq!(reached.limit.column, "worn_volume_pin_m3");
    assert_relative_eq!(reached.progress, 0.2, max_relative = 1e-6);
    assert_eq!((reached.distance, reached.time), (Some(reached.progress), None));
    let worn =
        |row: usize| archard::simulation::history::number(&rows.0[row], "worn_volume_pin_m3");
    let last = rows.0.len() - 1;
    assert!(worn(last).expect("a volume") >= volume && worn(last - 1).expect("a volume") < volume);
    assert!(rows.last("distance_m") < 0.5);
}

/// Between two steps a depth is read as it grows: the run that goes on by short steps passes the limit there too.
#[test]
fn depths_are_read_between_steps() {
    let place =
        |step: &str| lives(&[("wear_depth_pin_m", 1e-6)], &[step]).0.expect("the limit").progress;
    let [long, short] =
        ["motion.sliding.step=\"20 mm\"", "motion.sliding.step=\"2 mm\""].map(place);
    // Implicit steps of a tenth of the way err by per cents themselves.
    assert_relative_eq!(long, short, max_relative = 0.06);
}

/// What is not reached ends with the motion, and what a run does not have is told.
#[test]
fn limits_out_of_reach_end_nothing() {
    let (reached, rows) = lives(&[("wear_depth_pin_m", 1e-3)], &[]);
    assert_eq!(reached, None);
    assert_relative_eq!(rows.last("distance_m"), 0.5);
    let mut life =
        Life::until(vec![Limit { column: "worn_section_pin_m2".to_owned(), value: 1.0 }]);
    let error = case(CASE, &[]).run(&mut [&mut life]).expect_err("no such column");
    assert!(error.to_string().contains("no column `worn_section_pin_m2`"), "{error}");
}

/// A case says its limits by name and with units, and prints them so that they read back.
#[test]
fn cases_have_limits() {
    let file = CaseFile::from_text("case", CASE, ".")
        .set("until={ wear_depth_pin = \"2 um\", worn_volume_disc = \"3 mm^3\" }");
    let resolved = file.resolve().expect("a case");
    let limits: Vec<_> = resolved.case.until.iter().map(|one| (&*one.column, one.value)).collect();
    assert_eq!(limits.len(), 2);
    for (column, value) in [("worn_volume_disc_m3", 3e-9), ("wear_depth_pin_m", 2e-6)] {
        assert!(limits.contains(&(column, value)), "{limits:?}");
    }
    let again = CaseFile::from_text("case", resolved.case.to_string(), ".");
    assert_eq!(again.resolve().expect("a case").case.until, resolved.case.until);
}

/// Where bodies turn, a pair slides by its distance from the axis: a life is in revolutions, and there is no one distance.
#[test]
fn bodies_that_turn_slide_no_one_distance() {
    let text = "frame = { size = [\"1.4 mm\", \"1.4 mm\"], elements = [28, 28] }
        body.pin = { rigid = true, profile.sphere.radius = \"50 mm\" }
        body.disc = { material = { young = \"210 GPa\", poisson = 0.3 }, profile.flat = {}, wear.archard.coefficient = \"1e-13 1/Pa\" }
        motion.rotation = { load = \"20 N\", revolutions = 10, tolerance = 0.01 }";
    let limit = Limit { column: "worn_volume_disc_m3".to_owned(), value: 1e-14 };
    let mut life = Life::until(vec![limit]);
    case(text, &[]).run(&mut [&mut life]).expect("a run");
    let reached = life.reached().expect("the limit");
    assert!(reached.progress > 0.0 && reached.distance.is_none() && reached.time.is_none());
}

/// Runs on coarser grids go no farther than the limit asks for: what comes behind it may be out of reach, as where a shaft wears its
/// bush until all of the frame touches. The life lies within its error of that of finer elements.
#[test]
fn companions_end_where_the_life_does() {
    let text = "accuracy = 0.03
        frame = { plane_strain = true, size = \"9 mm\" }
        body.bush = { material = { young = \"3.5 GPa\", poisson = 0.36 }, profile.cylinder = { radius = \"-10.5 mm\", axis = \"y\" },
            wear.archard.coefficient = \"1e-13 1/Pa\" }
        body.shaft = { rigid = true, profile.cylinder = { radius = \"10 mm\", axis = \"y\" } }
        motion.sliding = { load = \"5 N/mm\", distance = \"20 km\" }
        until = { wear_depth_bush = \"20 um\" }";
    let life = |options: &[&str]| {
        let file =
            options.iter().fold(CaseFile::from_text("case", text, "."), |file, own| file.set(*own));
        let resolved = file.resolve().expect("a case");
        let until = resolved.case.until.clone();
        let settled = resolved.settle(&mut |case| Ok(case.build()?), &mut |_| Ok(()));
        let (_, simulation) = settled.expect("companions that end");
        let mut life = Life::until(until);
        simulation.run(&mut [&mut life]).expect("a run");
        life.reached().cloned().expect("the limit")
    };
    let [coarse, fine] = [life(&[]), life(&["accuracy=0.005"])];
    let error = coarse.error.expect("an error");
    assert!((coarse.progress - fine.progress).abs() <= error, "{coarse:?} {fine:?}");
    assert!(error < 0.2 * coarse.progress, "{coarse:?}");
}
