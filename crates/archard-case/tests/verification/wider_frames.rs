//! Runs that go on in a frame twice as wide, held against k F s and runs in one frame.

use archard::problem::ContactState;
use archard::simulation::{Run, Simulation};

use crate::common::{case, peak, states};

const PIN: &str = include_str!("../framed/pin_on_disc/case.toml");
const TRACK: &str = include_str!("../framed/pin_on_disc_track/case.toml");

fn simulation(text: &str, options: &[&str]) -> Simulation {
    case(text, options)
}

/// Area of an element times the depths worn off a body (m^3).
fn volume(simulation: &Run, body: usize) -> f64 {
    let report = simulation.report();
    report.problem.frame.integrate(&report.state.worn(body))
}

/// Volumes are k F s in every row, whichever frame they were worn in, and the rest is what one fine frame finds but for
/// what its larger elements err by.
#[test]
fn volumes_stay_and_depths_are_those_of_one_frame() {
    for stepping in ["motion.sliding.step=10 mm", "motion.sliding.tolerance=3e-3"] {
        let explicit = stepping.contains("step");
        let common = ["motion.sliding.step=", stepping, "frame.elements=[80, 80]"];
        let wide = simulation(
            PIN,
            &[&common[..], &["frame.size=[\"1.2 mm\", \"1.2 mm\"]", "frame.elements=[160, 160]"]]
                .concat(),
        );
        let doubles =
            [&common[..], &["frame.size=[\"0.6 mm\", \"0.6 mm\"]", "frame.doubles=[\"55 mm\"]"]]
                .concat();
        let doubles = simulation(PIN, &doubles);
        let mut run = Run::begin(doubles).unwrap();
        let (mut before, mut sizes) = (0.0, vec![]);
        let mut depths = vec![];
        while run.step().unwrap() {
            let report = run.report();
            let expected = 1.33e-13 * report.effort.load_distance;
            let found = volume(&run, 0);
            assert!((found / expected - 1.0).abs() < 1e-12, "{found:e} {expected:e}");
            assert!(found > before);
            before = found;
            sizes.push(report.problem.frame.size()[0]);
            depths.push((report.state.progress, peak(&report.state.worn(0))));
        }
        let (narrow, wider) = (sizes[0], *sizes.last().unwrap());
        assert!((narrow, wider) == (0.6e-3, 1.2e-3), "{narrow} {wider}");
        assert!(sizes.is_sorted());
        let one = states(&wide).unwrap();
        if explicit {
            for ((at, depth), (state, ..)) in depths.iter().zip(&one[1..]) {
                assert_eq!(*at, state.progress);
                let expected = peak(&state.worn(0));
                // Before, the same elements; after, those twice as large.
                let allowed = if *at < 0.0601 { 1e-8 } else { 1.5e-3 };
                assert!((depth / expected - 1.0).abs() < allowed, "{at} {depth:e} {expected:e}");
            }
        }
        let expected = peak(&one.last().unwrap().0.worn(0));
        let (_, depth) = depths.last().unwrap();
        assert!((depth / expected - 1.0).abs() < 1e-3, "{depth:e} {expected:e}");
    }
}

/// Of a surface that passes, the groove goes on next to the smaller frame, along both axes.
#[test]
fn grooves_go_on() {
    for along in ["x", "y"] {
        let direction = format!("motion.sliding.direction={along}");
        let common = ["frame.elements=[60, 60]", direction.as_str()];
        let of = |more: &[&'static str]| simulation(TRACK, &[&common[..], more].concat());
        let run = |simulation: Simulation| states(&simulation).unwrap().pop().unwrap().0;
        let wide = of(&["frame.size=[\"0.72 mm\", \"0.72 mm\"]", "frame.elements=[120, 120]"]);
        let doubles = of(&["frame.size=[\"0.36 mm\", \"0.36 mm\"]", "frame.doubles=[\"60 m\"]"]);
        let [one, other] = [run(wide), run(doubles)];
        for body in 0..2 {
            let (expected, found) = (peak(&one.worn(body)), peak(&other.worn(body)));
            assert!((found / expected - 1.0).abs() < 3e-3, "{body} {found:e} {expected:e}");
            let section = |worn: &[f64], n: usize| {
                let middle = n / 2;
                let at = |i: usize| if along == "x" { middle + n * i } else { i + n * middle };
                (0..n).map(|i| worn[at(i)]).sum::<f64>() * 0.72e-3 / n as f64
            };
            let [expected, found] = [section(&one.worn(body), 120), section(&other.worn(body), 60)];
            if body == 1 {
                assert!((found / expected - 1.0).abs() < 1e-6, "{found:e} {expected:e}");
                // The groove is the same along its way, to the edge.
                let first = if along == "x" { 60 * 30 } else { 30 };
                let (edge, middle) = (other.worn(1)[first], other.worn(1)[30 + 60 * 30]);
                assert!((edge - middle).abs() < 1e-12 * middle, "{edge:e} {middle:e}");
            }
        }
    }
}

/// What pairs have slid under pressure goes over with them: a law that runs in by the distance wears as in one frame.
#[test]
fn points_keep_the_distance_they_slid() {
    const RUNS_IN: [&str; 3] = [
        "body.pin.wear=",
        "body.pin.wear.running_in.initial_coefficient=1.33e-12 1/Pa",
        "body.pin.wear.running_in.final_coefficient=1.33e-13 1/Pa",
    ];
    let common = [
        &RUNS_IN[..],
        &["body.pin.wear.running_in.running_in_distance=30 mm", "motion.sliding.step=10 mm"],
    ];
    let of = |frame: &[&'static str]| {
        let options = [&common.concat()[..], frame].concat();
        states(&case(PIN, &options)).unwrap().into_iter().map(|state| state.0).collect::<Vec<_>>()
    };
    let one = of(&["frame.size=[\"1.8 mm\", \"1.8 mm\"]", "frame.elements=[120, 120]"]);
    let doubles = of(&[
        "frame.size=[\"0.9 mm\", \"0.9 mm\"]",
        "frame.elements=[60, 60]",
        "frame.doubles=[\"20 mm\"]",
    ]);
    let volume = |state: &ContactState, side: f64| -> f64 {
        let element = side * side;
        state.worn(0).iter().map(|worn| worn * element).sum()
    };
    let side = |state: &ContactState| if state.progress < 0.025 { 15e-6 } else { 30e-6 };
    for (state, other) in one.iter().zip(&doubles).skip(1) {
        assert_eq!(state.progress, other.progress);
        let (expected, found) = (volume(state, 15e-6), volume(other, side(other)));
        assert!(
            (found / expected - 1.0).abs() < 2e-3,
            "{}: {found:e} {expected:e}",
            state.progress
        );
    }
    assert!(doubles.len() > 10 && one.len() == doubles.len());
}
