//! What a verdict says of wheels: of errors, units, noise, wrong set-ups, climbing and shakedown.

use std::fs;
use std::ops::ControlFlow;

use archard_case::output::{Claim, RailResults, Totals, write_rail};
use archard_case::verdict::{self, Verdict, Word};
use archard_rail::contact::Quantities;
use tempfile::tempdir;

use super::{MANCHESTER, resolve};

/// Every error that is stated of a wheel belongs to the verdict, creepages relative to all slip of the patch.
#[test]
fn errors_of_creepages_are_judged() {
    let resolved = resolve(MANCHESTER, &[]).expect("a case");
    let results = resolved.case.solve(|_, _| ControlFlow::Continue(())).expect("a contact");
    // What is made of the errors of a patch with so much slip.
    type Change<'a> = &'a dyn Fn(&mut Quantities, f64);
    let judged = |change: Change<'_>| {
        let mut results = results.clone();
        let patch = &mut results.contacts[0].patches[0];
        let Quantities { creepage, lateral_creepage, spin, contact_area, .. } = patch.values;
        let radius = (contact_area / std::f64::consts::PI).sqrt();
        let slip = creepage.hypot(lateral_creepage).hypot(radius * spin);
        change(&mut patch.errors, slip);
        let dir = tempdir().unwrap();
        let mut claim = Claim::take(dir.path()).unwrap();
        write_rail(&mut claim, "", &results, &Totals::default()).unwrap()
    };
    assert_eq!(judged(&|_, _| {}).word(), Word::Good);
    let changes: [(&str, Change<'_>); 3] = [
        ("`creepage`", &|errors, slip| errors.creepage = 0.2 * slip),
        ("`lateral_creepage`", &|errors, slip| errors.lateral_creepage = 0.2 * slip),
        ("`spin_1_per_m`", &|errors, slip| errors.spin = 100.0 * slip),
    ];
    for (column, change) in changes {
        let verdict = judged(change);
        assert_eq!(verdict.word(), Word::Doubtful, "{column}");
        let line = verdict.complaints().next().unwrap().to_string();
        assert!(line.contains(column), "{line}");
    }
}

/// A wheel of 130 mm in inches is 5.1 "mm" wide: it is refused with the unit, and read where the unit is stated.
#[test]
fn profiles_in_another_unit_are_refused() {
    let dir = tempdir().unwrap();
    let path = dir.path().join("wheel.csv");
    let wheel = archard_rail::standard::wheel_s1002(1e-3).unwrap();
    let rows = wheel.points.iter().map(|[y, z]| format!("{:.6},{:.6}", y / 0.0254, z / 0.0254));
    fs::write(&path, format!("y,z\n{}\n", rows.collect::<Vec<_>>().join("\n"))).unwrap();
    let file = format!("body.wheel.profile.wheel.file={}", path.display());
    let options = ["body.wheel.profile.wheel.standard=", &file];
    let said = resolve(MANCHESTER, &options).expect_err("inches");
    assert!(said.contains("inches read as millimetres") && said.contains("unit"), "{said}");
    let unit = "body.wheel.profile.wheel.unit=25.4 mm";
    resolve(MANCHESTER, &[&options[..], &[unit]].concat()).expect("a wheel");
}

/// The contact and the verdict of a wheel in that file, on the rail of its standard.
fn judged_wheel(points: &[[f64; 2]], more: &[&str]) -> (Quantities, Quantities, Verdict) {
    let dir = tempdir().unwrap();
    let path = dir.path().join("wheel.csv");
    let rows = points.iter().map(|[y, z]| format!("{:.7},{:.7}", 1e3 * y, 1e3 * z));
    fs::write(&path, rows.collect::<Vec<_>>().join("\n")).unwrap();
    let file = format!("body.wheel.profile.wheel.file={}", path.display());
    let options = ["body.wheel.profile.wheel.standard=", &file];
    let resolved = resolve(MANCHESTER, &[&options[..], more].concat()).expect("a case");
    let results = resolved.case.solve(|_, _| ControlFlow::Continue(())).expect("a contact");
    let patch = results.contacts[0].patches[0].clone();
    let totals = Totals {
        warnings: resolved.warnings.iter().map(archard_case::Problem::warning_of).collect(),
        ..Totals::default()
    };
    (patch.values, patch.errors, verdict_of(&results, &totals))
}

fn verdict_of(results: &RailResults, totals: &Totals) -> Verdict {
    let dir = tempdir().unwrap();
    let mut claim = Claim::take(dir.path()).unwrap();
    write_rail(&mut claim, "", results, totals).unwrap()
}

/// Noise of 10 um from point to point, smoothed a little or well: pressure, area and force lie within their stated errors about those of
/// the profile without noise, and what is smoothed too little is doubtful.
#[test]
fn errors_cover_the_noise_of_a_measured_profile() {
    let clean = archard_rail::standard::wheel_s1002(0.35e-3).unwrap().points;
    let (truth, none, _) = judged_wheel(&clean, &[]);
    assert!(none.peak_pressure < 0.01 * truth.peak_pressure, "{}", none.peak_pressure);
    let mut outside = 0;
    for seed in 1..=6_u64 {
        // A sum of twelve has a variance of one.
        let mut state = seed;
        let mut one = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut noise = || (0..12).map(|_| one()).sum::<f64>() - 6.0;
        let noisy: Vec<_> = clean.iter().map(|[y, z]| [*y, z + 1e-5 * noise()]).collect();
        for smoothing in ["3 mm", "8 mm"] {
            let smoothed = format!("body.wheel.profile.wheel.smoothing={smoothing}");
            let (values, errors, verdict) = judged_wheel(&noisy, &[&smoothed]);
            let off = [
                (values.peak_pressure - truth.peak_pressure) / errors.peak_pressure,
                (values.contact_area - truth.contact_area) / errors.contact_area,
                (values.force_x - truth.force_x) / errors.force_x,
            ];
            outside += off.iter().filter(|off| off.abs() > 1.0).count();
            if smoothing == "3 mm" {
                assert_ne!(verdict.word(), Word::Good, "{:?}", verdict.lines);
            }
        }
    }
    // One in twenty by chance: of 36 more than five once in a hundred.
    assert!(outside <= 5, "{outside} of 36");
}

/// What is wrong with a set-up is never good: a profile upside down, a flange 85 mm from the back of its wheel, a contact that bears twice
/// its load, a pressure above the shakedown limit, a wheel that slides.
#[test]
fn a_wrong_set_up_is_not_good() {
    let clean = archard_rail::standard::wheel_s1002(0.35e-3).unwrap().points;
    let (_, _, verdict) = judged_wheel(&clean, &[]);
    assert_eq!(verdict.word(), Word::Good, "{:?}", verdict.lines);
    let turned: Vec<_> = clean.iter().map(|[y, z]| [*y, -z]).collect();
    assert_eq!(judged_wheel(&turned, &[]).2.word(), Word::Doubtful);
    let said = resolve(MANCHESTER, &["motion.wheel_rail.flange_back_position=-140 mm"]);
    let said = said.expect_err("a thick flange");
    assert!(
        said.contains("85.0 mm from the back") && said.contains("flange_back_position"),
        "{said}"
    );
    let words = |options: &[&str], change: &dyn Fn(&mut RailResults)| {
        let case = resolve(MANCHESTER, options).expect("a case").case;
        let mut results = case.solve(|_, _| ControlFlow::Continue(())).expect("a contact");
        change(&mut results);
        let verdict = verdict_of(&results, &Totals::default());
        let subjects = verdict.complaints().map(|line| line.subject).collect::<Vec<_>>();
        (verdict.word(), subjects)
    };
    let twice = |results: &mut RailResults| results.contacts[0].load *= 0.5;
    assert_eq!(words(&[], &twice), (Word::Wrong, vec!["load"]));
    // 720 MPa on k = 600 MPa/(3 sqrt 3): 6.2 k; on k = 1 GPa/(3 sqrt 3) 3.7 k, with 0.30 of friction used.
    let soft =
        |hardness: &str| words(&[&*format!("body.rail.material.hardness={hardness}")], &|_| {});
    assert_eq!(soft("800 MPa"), (Word::Doubtful, vec!["shakedown"]));
    assert_eq!(soft("1 GPa"), (Word::Doubtful, vec!["shakedown"]));
    assert_eq!(soft("1.3 GPa"), (Word::Good, vec![]));
    let braked = words(&["motion.wheel_rail.pitch_rate=-3.4 rad/s"], &|_| {});
    assert_eq!(braked, (Word::Doubtful, vec!["creepage"]));
}

/// With 0.3 of friction used at 4 k the surface index of shakedown, f - k/p, is 0.05; without friction 4 k is the limit.
#[test]
fn shakedown_is_that_of_its_formulas() {
    let hardness = 3.0 * 3.0_f64.sqrt();
    for (over_k, friction, index) in [(4.0, 0.3, 0.05), (5.0, 0.2, 0.0), (2.5, 0.35, -0.05)] {
        let over = verdict::shaken(over_k / hardness, friction);
        let surface = friction * over_k;
        assert!((friction - 1.0 / over_k - index).abs() < 1e-12);
        assert!((over - surface.max(over_k / 4.0)).abs() < 1e-12, "{over}");
    }
}

/// A wheel on its flange is held up by it: lateral over vertical force is the tangent of the inclination less or more friction, and
/// above Nadal's limit; on its tread it is far below.
#[test]
fn a_wheel_that_may_climb_is_doubtful() {
    let judged = |shift: &str| {
        let set = [
            &*format!("motion.wheel_rail.shift={shift}"),
            "motion.wheel_rail.roll=",
            "motion.wheel_rail.yaw=0 rad",
        ];
        let resolved = resolve(MANCHESTER, &set).expect("a case");
        let results = resolved.case.solve(|_, _| ControlFlow::Continue(())).expect("a contact");
        let contact = results.contacts[0].clone();
        let dir = tempdir().unwrap();
        let mut claim = Claim::take(dir.path()).unwrap();
        let verdict = write_rail(&mut claim, "", &results, &Totals::default()).unwrap();
        (contact, verdict.complaints().map(ToString::to_string).collect::<String>())
    };
    let (tread, words) = judged("0 mm");
    let [lateral, vertical] = tread.forces();
    assert!(lateral.abs() < 0.1 * vertical && !words.contains("Nadal"), "{words}");
    let (flange, words) = judged("7 mm");
    let [lateral, vertical] = flange.forces();
    let [patch] = &flange.patches[..] else { panic!("{} patches", flange.patches.len()) };
    let angle = patch.values.contact_angle.abs().tan();
    let ends = [-0.3, 0.3].map(|mu| (angle + mu) / (1.0 - mu * angle));
    assert!((ends[0]..=ends[1]).contains(&(lateral / vertical)), "{lateral} {vertical} {ends:?}");
    assert!(words.contains("Nadal"), "{words}");
    // A flange of 70 degrees and a coefficient of .36, of textbooks: 1.2003; one of 60 degrees .8451.
    let limit = |degrees: f64| {
        archard_case::output::Flank { y: 0.0, angle: degrees.to_radians() }.nadal(0.36).unwrap()
    };
    assert!((limit(70.0) - 1.20029).abs() < 1e-5 && (limit(60.0) - 0.84510).abs() < 1e-5);
}
