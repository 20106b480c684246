//! Runs in a window around the contact, held against runs in the whole frame.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use archard::body::profile::{Flat, Profile};
use archard::body::{Body, Material};
use archard::compliance::{Compliance, HalfSpace, Preconditioner};
use archard::frame::{ContactFrame, Part, VectorField};
use archard::motion::{Control, Sliding, Stepping};
use archard::problem::ContactState;
use archard::simulation::{Effort, Run, Simulation};
use archard::wear::{Archard, Rubbing, WearLaw};

use crate::common::{STEEL, case, peak, states};

/// States, with what they took and whether they were due for output.
type States = Vec<(ContactState, Effort, bool)>;

/// Half-spaces that count the windows that were asked for, and grant them or not.
#[derive(Debug)]
struct Counting {
    inner: HalfSpace,
    grants: bool,
    windows: Arc<AtomicUsize>,
}

impl Compliance for Counting {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        self.inner.apply(tractions)
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.inner.apply_normal(pressure, displacement);
    }

    fn normal_self_term(&self) -> f64 {
        self.inner.normal_self_term()
    }

    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        self.inner.normal_preconditioner(addition)
    }

    fn within(&self, part: &Part) -> Option<Box<dyn Compliance + '_>> {
        self.inner.within(part)
    }

    fn on(&self, frame: &ContactFrame) -> Option<Arc<dyn Compliance>> {
        self.windows.fetch_add(1, Ordering::Relaxed);
        self.inner.on(frame).filter(|_| self.grants)
    }

    fn least_displacement(&self, away: [usize; 2]) -> f64 {
        self.inner.least_displacement(away)
    }
}

/// The same on such half-spaces, and what counts their windows.
fn counting(mut simulation: Simulation, grants: bool) -> (Simulation, Arc<AtomicUsize>) {
    let problem = &mut simulation.problem;
    let materials = problem.bodies.each_ref().map(|body| body.material.as_ref());
    let inner = HalfSpace::new(materials, &problem.frame);
    let windows = Arc::new(AtomicUsize::new(0));
    problem.compliance = Arc::new(Counting { inner, grants, windows: Arc::clone(&windows) });
    (simulation, windows)
}

/// States in windows and in the whole frame, and the number of windows.
fn both(make: impl Fn() -> Simulation) -> ([States; 2], usize) {
    let mut windows = 0;
    let runs = [true, false].map(|grants| {
        let (simulation, count) = counting(make(), grants);
        let states = states(&simulation).unwrap();
        windows = windows.max(count.load(Ordering::Relaxed));
        states
    });
    (runs, windows)
}

fn assert_close(one: &[f64], other: &[f64], within: f64, what: &str) {
    assert_eq!(one.len(), other.len(), "{what}");
    let scale = peak(other).max(f64::MIN_POSITIVE);
    for (pair, (one, other)) in one.iter().zip(other).enumerate() {
        assert!((one - other).abs() <= within * scale, "{what} of {pair}: {one:e} {other:e}");
    }
}

/// Every state of two runs is the same.
fn assert_same([one, other]: [States; 2], problem: &Simulation, name: &str) {
    assert_eq!(one.len(), other.len(), "{name}");
    for ((one, effort, _), (other, whole, _)) in one.iter().zip(&other) {
        let at = format!("{name} at {:e}", one.progress);
        assert!((one.progress / other.progress - 1.0).abs() < 1e-6 || one.progress == 0.0, "{at}");
        assert!((one.approach / other.approach - 1.0).abs() < 1e-6, "{at}");
        assert!((one.load - other.load).abs() <= 1e-6 * other.load, "{at}");
        assert_close(&one.pressure, &other.pressure, 1e-5, &at);
        for body in 0..2 {
            assert_close(&one.worn(body), &other.worn(body), 1e-6, &at);
            let [one, other] = [one, other].map(|state| &state.surfaces[body].slid);
            assert_close(one, other, 1e-6, &at);
        }
        let gaps = [one, other].map(|state| state.gap_of(&problem.problem).into_owned());
        assert_close(&gaps[0], &gaps[1], 1e-6, &at);
        assert_eq!(effort.steps, whole.steps, "{at}");
        let highest = peak(&other.pressure);
        assert!((effort.centre_lag - whole.centre_lag).abs() <= 1e-5 * highest, "{at}");
    }
}

/// A ball of 50 mm on a flat, in a frame more than four times as wide as the contact is at first.
const BALL: &str = r#"
    [body.ball]
    material = { young = "210 GPa", poisson = 0.3 }
    profile.sphere = { radius = "50 mm" }
    wear.archard = { coefficient = "1.33e-13 1/Pa" }
    [body.flat]
    material = { young = "70 GPa", poisson = 0.3 }
    profile.flat = {}
    [friction]
    coulomb = { coefficient = 0.2 }
    [frame]
    size = ["1.6 mm", "1.8 mm"]
    elements = [80, 90]
    [motion.sliding]
    load = "10.2 N"
    distance = "60 mm"
    tolerance = 3e-3
    [solver]
    conjugate_gradient = { tolerance = 1e-9 }
"#;

/// What is computed in a window is what is computed in the frame: steps by error and given ones, by their ends or starts; both
/// bodies; a law that remembers; by the work of friction; off the middle; under an approach.
#[test]
fn windows_change_nothing() {
    let law = |law: &str| format!("body.flat.wear.{law}");
    let cases: [(&str, Vec<String>); 8] = [
        ("by error", vec![]),
        (
            "given steps",
            vec!["motion.sliding.tolerance=".into(), "motion.sliding.step=5 mm".into()],
        ),
        (
            "long steps",
            vec![
                "motion.sliding.tolerance=".into(),
                "motion.sliding.step=300 mm".into(),
                "motion.sliding.distance=300 mm".into(),
            ],
        ),
        (
            "by their starts",
            vec![
                "motion.sliding.tolerance=".into(),
                "motion.sliding.step=0.2 mm".into(),
                "motion.sliding.scheme=\"explicit\"".into(),
                "motion.sliding.distance=2 mm".into(),
            ],
        ),
        (
            "running in",
            vec![law(
                r#"running_in={ initial_coefficient = "2e-13 1/Pa", final_coefficient = "1e-13 1/Pa", running_in_distance = "20 mm" }"#,
            )],
        ),
        ("off the middle", vec![r#"frame.centre=["0.45 mm", "-0.3 mm"]"#.into()]),
        (
            "an approach",
            vec!["motion.sliding.load=".into(), "motion.sliding.approach=0.6 um".into()],
        ),
        ("energy", vec![law(r#"energy={ coefficient = "6e-13 1/Pa" }"#)]),
    ];
    for (name, options) in cases {
        let options: Vec<&str> = options.iter().map(String::as_str).collect();
        let make = || case(BALL, &options);
        let (runs, windows) = both(make);
        assert!(windows > 0, "{name}: {windows}");
        assert_same(runs, &make(), name);
    }
}

/// A ball next to whose contact a second one stands back (m).
#[derive(Debug)]
struct Two(f64);

impl Profile for Two {
    fn recess(&self, x: f64, y: f64) -> f64 {
        let ball = |middle: f64| ((x - middle).powi(2) + y * y) / 0.1;
        ball(-0.5e-3).min(ball(0.55e-3) + self.0)
    }
}

fn two(stands_back: f64, law: impl WearLaw + 'static) -> Simulation {
    let pin = Body::new("pin", Two(stands_back)).material(STEEL).wear(law);
    let soft = Material::new(70e9, 0.3).unwrap();
    let disc = Body::new("disc", Flat).material(soft);
    let sliding = Sliding::new().over(40e-3, Control::Load(10.2), Stepping::Tolerance(3e-3));
    let builder = Simulation::builder([pin, disc], sliding.unwrap());
    builder.frame([2.4e-3, 1.6e-3], [96, 64]).build().unwrap()
}

/// What touches far away later on is noticed, whatever the window was.
#[test]
fn what_touches_later_is_not_missed() {
    for stands_back in [0.2e-6, 0.9e-6, 1.2e-6] {
        let make = || two(stands_back, Archard::new(4e-13).unwrap());
        let (runs, windows) = both(make);
        assert!(windows > 0);
        let load = |state: &ContactState| -> f64 {
            (0..96 * 64).filter(|pair| pair % 96 > 48).map(|pair| state.pressure[pair]).sum()
        };
        let [first, last] = [0, runs[0].len() - 1].map(|state| load(&runs[0][state].0));
        assert!(last > 0.0 && (stands_back < 1e-6 || first == 0.0), "{stands_back:e}");
        assert_same(runs, &make(), &format!("{stands_back:e}"));
    }
}

/// Wears what is open, too.
#[derive(Debug)]
struct Everywhere;

impl WearLaw for Everywhere {
    fn depth(&self, rubbing: Rubbing) -> f64 {
        (1e-13 * rubbing.pressure + 1e-7) * rubbing.slip
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        1e-13 * rubbing.slip
    }
}

/// A law that wears open surfaces has no window, and wears the corners of the frame.
#[test]
fn open_pairs_that_wear_count() {
    let ([one, _], windows) = both(|| two(1.0, Everywhere));
    assert_eq!(windows, 0);
    let (last, ..) = one.last().unwrap();
    assert!((last.worn(0)[0] / (1e-7 * 40e-3) - 1.0).abs() < 1e-9, "{:e}", last.worn(0)[0]);
}

/// A run that is kept and gone on with at every step ends in the same bits.
#[test]
fn runs_in_windows_are_kept() {
    let wide = [
        "frame.size=[\"2.4 mm\", \"2.4 mm\"]",
        "frame.elements=[96, 96]",
        "motion.sliding.distance=150 mm",
    ];
    let make = || case(BALL, &wide);
    let mut plain = Run::begin(make()).unwrap();
    let mut kept = Run::begin(make()).unwrap();
    while plain.step().unwrap() {
        kept = Run::resume(make(), &kept.checkpoint()).unwrap();
        assert!(kept.step().unwrap());
        assert_eq!(plain.report().state, kept.report().state);
        assert_eq!(plain.report().effort, kept.report().effort);
    }
    let (simulation, windows) = counting(make(), true);
    let mut run = Run::begin(simulation).unwrap();
    while run.step().unwrap() {}
    assert!(windows.load(Ordering::Relaxed) > 1);
    assert_eq!(run.report().state, plain.report().state);
}
