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
#[ignore = "long: in .ci/long"]
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

/// Kept and gone on with at every state, a run whose frame grows comes to the same bits.
#[test]
fn runs_that_grow_are_kept() {
    let frame = &["frame.size=[\"0.2 mm\", \"0.2 mm\"]", "frame.elements=[10, 10]"][..];
    let line = &["frame.size=0.09 mm", "frame.elements=16"][..];
    for (text, options) in [
        (PIN, &["motion.sliding.distance=40 mm"][..]),
        (TRACK, &["motion.sliding.tolerance=3e-2"]),
        (SHIFTED, &["motion.fretting.increments=16", "motion.fretting.cycles=1"]),
        (SWUNG, &["motion.fretting.cycles=300", "output.at=[100]"]),
    ] {
        let frame = if text == SWUNG { line } else { frame };
        let options = [options, frame].concat();
        let mut whole = Run::begin(case(text, &options)).unwrap();
        let mut parts = Run::begin(case(text, &options)).unwrap();
        let first = of_case(text, &options);
        while whole.step().unwrap() {
            parts.step().unwrap();
            parts = Run::resume(case(text, &options), &parts.checkpoint()).unwrap();
            let [one, other] = [&whole, &parts].map(|run| run.report());
            assert_eq!(one.problem.frame.len(), other.problem.frame.len());
            assert!(one.state == other.state, "{}", one.state.progress);
        }
        assert!(whole.report().problem.frame.len() > first, "{first}");
    }
}

/// A contact at one side of its frame makes it grow there, and values at the centre stay those of the place.
#[test]
fn frames_grow_where_they_are_too_small() {
    let frame = |centre: &'static str, size: &'static str, elements: &'static str| {
        let step = "motion.sliding.step=10 mm";
        case(PIN, &[step, "motion.sliding.distance=100 mm", centre, size, elements])
    };
    let small = frame(
        "frame.centre=[\"0.14 mm\", \"0 mm\"]",
        "frame.size=[\"0.6 mm\", \"1 mm\"]",
        "frame.elements=[30, 50]",
    );
    let large = frame(
        "frame.centre=[\"0.14 mm\", \"0 mm\"]",
        "frame.size=[\"1.4 mm\", \"1.2 mm\"]",
        "frame.elements=[70, 60]",
    );
    let [small, large] = [small, large].map(|simulation| {
        let mut run = Run::begin(simulation).unwrap();
        while run.step().unwrap() {}
        run
    });
    let [one, other] = [&small, &large].map(|run| run.report());
    let [low, high] = [-0.5, 0.5].map(|side| {
        let rectangle = one.problem.frame.rectangle();
        rectangle.centre[0] + side * rectangle.size[0]
    });
    assert!(low < -0.2e-3 && high < 0.45e-3, "{low} {high}");
    for column in ["centre_pressure_Pa", "wear_depth_m", "approach_m", "peak_pressure_Pa"] {
        let [found, expected] = [&one, &other].map(|report| number(&row(report), column).unwrap());
        assert!((found / expected - 1.0).abs() < 1e-7, "{column}: {found} {expected}");
    }
    assert_eq!(one.problem.frame.centre()[1], 0.0);
    assert!((one.problem.frame.centre()[0] - 14e-5).abs() < 1e-15);
}

/// A measured surface whose readings end on one side holds the frame there alone.
#[test]
fn frames_end_with_the_readings_and_grow_elsewhere() {
    let dir = tempfile::TempDir::new().unwrap();
    let places = |from: i32, to: i32| (from..=to).map(|index| 0.02 * f64::from(index));
    let mut table = "x_mm,y_mm,z_mm\n".to_owned();
    for y in places(-30, 30) {
        for x in places(-30, 12) {
            table += &format!("{x},{y},{}\n", -(x * x + y * y) / 100.0);
        }
    }
    std::fs::write(dir.path().join("ball.csv"), table).unwrap();
    let text = PIN.replace(
        "profile.sphere = { radius = \"50 mm\" }",
        &format!("profile.table.file = \"{}\"", dir.path().join("ball.csv").display()),
    );
    let frame = [
        "frame.size=[\"0.3 mm\", \"0.3 mm\"]",
        "frame.elements=[15, 15]",
        "motion.sliding.distance=300 mm",
    ];
    let mut run = Run::begin(case(&text, &frame)).unwrap();
    while run.step().unwrap() {}
    let report = run.report();
    let rectangle = report.problem.frame.rectangle();
    let [low, high] = [-0.5, 0.5]
        .map(|side| [0, 1].map(|axis| rectangle.centre[axis] + side * rectangle.size[axis]));
    assert!(high[0] < 0.251e-3 && high[0] > 0.2e-3, "{high:?}");
    assert!(low[0] < -0.3e-3 && low[1] < -0.3e-3 && high[1] > 0.3e-3, "{low:?} {high:?}");
}
