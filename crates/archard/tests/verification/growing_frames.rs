//! Runs in frames that are too small at first: they grow, and are those of frames that were large enough from the beginning.

use archard::simulation::history::number;
use archard::simulation::{Report, Run, Simulation, row};

use crate::common::case;

const PIN: &str = include_str!("../framed/pin_on_disc/case.toml");
const BOTH: &str = include_str!("../framed/pin_on_disc_both/case.toml");
const TRACK: &str = include_str!("../framed/pin_on_disc_track/case.toml");
const HERTZ: &str = include_str!("../framed/hertz/case.toml");
const SHIFTED: &str = include_str!("../framed/cattaneo_mindlin/case.toml");
const SWUNG: &str = include_str!("../framed/mccoll_fretting/case.toml");
const ROLLED: &str = include_str!("../framed/twin_disc/case.toml");
const LINE: &str = include_str!("../framed/carter/case.toml");

/// A case, settings of both runs, and frames that are too small and large enough for it: elements of the same size.
#[derive(Clone, Copy)]
struct Pair {
    name: &'static str,
    text: &'static str,
    settings: &'static [&'static str],
    small: &'static [&'static str],
    large: &'static [&'static str],
    /// By how much the rows may differ, relative; where steps are chosen by their error, the last ones.
    within: f64,
    chosen: bool,
}

/// Every state of a run as a row, and how many pairs its frame had.
fn rows(simulation: Simulation) -> Vec<(Vec<(String, f64)>, usize)> {
    let of = |report: Report<'_>| (row(&report), report.problem.frame.len());
    let mut run = Run::begin(simulation).unwrap();
    let mut rows = vec![of(run.report())];
    while run.step().unwrap() {
        rows.push(of(run.report()));
    }
    rows
}

/// Columns that say what a run took, or what of it is rounding.
const EFFORT: [&str; 10] = [
    "solves",
    "iterations",
    "applications",
    "residual",
    "steps",
    "rejected",
    "time_error",
    "pairs",
    "moment",
    "force_y",
];

impl Pair {
    fn holds(&self) {
        let Self { name, text, settings, small, large, within, chosen } = *self;
        let of = |frame: &[&str]| rows(case(text, &[settings, frame].concat()));
        let [grown, one] = [of(small), of(large)];
        let (first, last) = (grown[0].1, grown[grown.len() - 1].1);
        assert!(last > first || first > of_case(text, small), "{name}: {first} {last}");
        assert!(chosen || grown.len() == one.len(), "{name}: {} {}", grown.len(), one.len());
        let compared = if chosen { 1 } else { one.len() };
        for ((row, _), (expected, _)) in grown.iter().rev().zip(one.iter().rev()).take(compared) {
            let told =
                |(column, _): &&(String, f64)| !EFFORT.iter().any(|one| column.contains(one));
            for (column, value) in expected.iter().filter(told) {
                let found = number(row, column).unwrap();
                let all = one.iter().filter_map(|(row, _)| number(row, column));
                let scale = all.fold(0.0, |most: f64, one| most.max(one.abs()));
                // Where the edge lies between two pairs is told by pressures and gaps that are small.
                let within = if column.contains("area") { 100.0 * within } else { within };
                let off = (found - value).abs() / scale;
                assert!(
                    scale == 0.0 || off <= within || found.is_nan() && value.is_nan(),
                    "{name}, {column}: {found:e} {value:e} in\n{row:?}\n{expected:?}"
                );
            }
        }
    }
}

/// Pairs of the frame that a case gives.
fn of_case(text: &str, frame: &[&str]) -> usize {
    case(text, frame).problem.frame.len()
}

#[test]
fn bodies_that_slide() {
    let small = &["frame.size=[\"0.2 mm\", \"0.2 mm\"]", "frame.elements=[10, 10]"];
    let large = &["frame.size=[\"1.2 mm\", \"1.2 mm\"]", "frame.elements=[60, 60]"];
    Pair {
        name: "pin",
        text: PIN,
        settings: &["motion.sliding.distance=100 mm"],
        small,
        large,
        within: 1e-6,
        chosen: false,
    }
    .holds();
    let settings = &[
        "motion.sliding.step=",
        "motion.sliding.tolerance=1e-2",
        "motion.sliding.distance=200 mm",
    ];
    Pair { name: "pin, by error", text: PIN, settings, small, large, within: 5e-3, chosen: true }
        .holds();
    Pair { name: "both", text: BOTH, settings, small, large, within: 1e-6, chosen: false }.holds();
}

#[test]
fn surfaces_that_pass() {
    let small = &["frame.size=[\"0.2 mm\", \"0.2 mm\"]", "frame.elements=[21, 21]"];
    let large = &["frame.size=[\"0.8 mm\", \"0.8 mm\"]", "frame.elements=[84, 84]"];
    let odd = &[
        "frame.size=[\"0.7714285714285714 mm\", \"0.7714285714285714 mm\"]",
        "frame.elements=[81, 81]",
    ];
    assert!(large.len() == odd.len());
    Pair {
        name: "track",
        text: TRACK,
        settings: &["motion.sliding.tolerance=1e-2"],
        small,
        large: odd,
        within: 5e-3,
        chosen: true,
    }
    .holds();
    let small = &["frame.size=[\"0.24 mm\", \"2 mm\"]", "frame.elements=[21, 21]"];
    let large = &["frame.size=[\"0.56 mm\", \"5.904761904761905 mm\"]", "frame.elements=[49, 62]"];
    let odd = &["frame.size=[\"0.56 mm\", \"5.80952380952381 mm\"]", "frame.elements=[49, 61]"];
    assert!(large.len() == odd.len());
    let settings = &[
        "motion.rolling.tolerance=1e-2",
        "output.at=[1, 1000]",
        "motion.rolling.revolutions=2000",
    ];
    Pair {
        name: "twin discs",
        text: ROLLED,
        settings,
        small,
        large: odd,
        within: 5e-3,
        chosen: true,
    }
    .holds();
    let small = &["frame.size=0.22 mm", "frame.elements=40"];
    Pair {
        name: "Carter",
        text: LINE,
        settings: &[],
        small,
        large: &[],
        within: 1e-5,
        chosen: false,
    }
    .holds();
}

#[test]
fn bodies_that_are_shifted() {
    let small = &["frame.size=[\"0.0894635 mm\", \"0.0894635 mm\"]", "frame.elements=[12, 12]"];
    let large = &["frame.elements=[48, 48]"];
    Pair { name: "Hertz", text: HERTZ, settings: &[], small, large, within: 1e-6, chosen: false }
        .holds();
    let settings = &["motion.fretting.increments=16"];
    Pair { name: "Cattaneo", text: SHIFTED, settings, small, large, within: 1e-5, chosen: false }
        .holds();
    let settings = &["motion.fretting.increments=16", "body.flat.material.poisson=0.1"];
    Pair {
        name: "unlike bodies",
        text: SHIFTED,
        settings,
        small,
        large,
        within: 1e-5,
        chosen: false,
    }
    .holds();
    const WEAR: &str = "body.ball.wear.archard.coefficient=1e-6 mm^3/(N m)";
    let settings = &[
        "motion.fretting.increments=16",
        WEAR,
        "motion.fretting.amplitude=[\"0.3 um\", \"0 um\"]",
        "motion.fretting.cycles=30000",
        "motion.fretting.tolerance=1e-2",
        "output=",
    ];
    let large = &["frame.size=[\"0.715708 mm\", \"0.715708 mm\"]", "frame.elements=[96, 96]"];
    Pair {
        name: "fretting with wear",
        text: SHIFTED,
        settings,
        small,
        large,
        within: 5e-3,
        chosen: true,
    }
    .holds();
}

#[test]
fn surfaces_that_swing() {
    let small = &["frame.size=0.2 mm", "frame.elements=32"];
    Pair {
        name: "McColl",
        text: SWUNG,
        settings: &["motion.fretting.cycles=3000", "output.at=[1000]"],
        small,
        large: &[],
        within: 5e-3,
        chosen: true,
    }
    .holds();
}
