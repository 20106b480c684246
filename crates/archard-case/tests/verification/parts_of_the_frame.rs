//! Normal solves on the part of the frame around the contact, held against solves on all of it.

use std::sync::atomic::{AtomicUsize, Ordering};

use archard::body::profile::Flat;
use archard::compliance::{Compliance, HalfSpace, Preconditioner, WornLines};
use archard::frame::{ContactFrame, Direction, Measure, Part, VectorField};
use archard::motion::{Control, Stepping};
use archard::problem::ContactState;
use archard::simulation::Simulation;
use archard::solve::{Outcome, Start, Status, Step, press};
use proptest::prelude::*;

use crate::common::{Ball, STEEL, case, peak, solver, states};

const SIDE: f64 = 1.2e-3;
const ELEMENTS: [usize; 2] = [72, 60];

/// Steel half-spaces under a plane frame.
fn frame() -> ContactFrame {
    ContactFrame::uniform([SIDE, SIDE], ELEMENTS, [&Flat, &Flat]).unwrap()
}

fn half_space(frame: &ContactFrame) -> HalfSpace {
    HalfSpace::new([Some(&STEEL); 2], frame)
}

/// Displacement (m) under pressures (Pa).
fn displacement(compliance: &dyn Compliance, pressure: &[f64]) -> Vec<f64> {
    let mut displacement = vec![0.0; pressure.len()];
    compliance.apply_normal(pressure, &mut displacement);
    displacement
}

/// A random gap, in parts of the frame.
#[derive(Debug, Clone)]
struct Bodies {
    /// Where the spots are, as shares of the frame, and how much higher the second stands (m).
    spots: [[f64; 2]; 2],
    second: Option<f64>,
    radius: f64,
    /// Height of the roughness (m) and depth of a scar (m).
    rough: f64,
    scar: f64,
    /// What pairs give way to their own pressure (m/Pa).
    addition: f64,
}

impl Bodies {
    fn gap(&self, frame: &ContactFrame) -> Vec<f64> {
        let gap = |pair: usize| {
            let [x, y] = frame.place(pair);
            let ball = |[u, v]: [f64; 2]| {
                let (x, y) = (x - (u - 0.5) * SIDE, y - (v - 0.5) * SIDE);
                (x * x + 0.7 * y * y) / (2.0 * self.radius)
            };
            let second = self.second.map_or(f64::INFINITY, |low| ball(self.spots[1]) + low);
            let scatter = ((12.9898 * pair as f64 + 4.1).sin() * 43_758.545_3) % 1.0;
            ball(self.spots[0]).max(self.scar).min(second) + self.rough * scatter
        };
        (0..frame.len()).map(gap).collect()
    }
}

fn bodies() -> impl Strategy<Value = Bodies> {
    let place = || [0.1..0.9, 0.1..0.9];
    (
        [place(), place()],
        proptest::option::of(0.0..0.3e-6),
        5e-3..50e-3,
        prop_oneof![Just(0.0), 0.0..0.2e-6],
        prop_oneof![Just(0.0), 0.0..1e-6],
        prop_oneof![Just(0.0), 1e-17..1e-15],
    )
        .prop_map(|(spots, second, radius, rough, scar, addition)| Bodies {
            spots,
            second,
            radius,
            rough,
            scar,
            addition,
        })
}

/// What was solved on a part is what is solved on the frame, and nothing overlaps next to the part.
fn assert_alike(step: &Step<'_>, on_part: &Outcome, whole: &Outcome) {
    assert_eq!((on_part.status, whole.status), (Status::Converged, Status::Converged));
    let highest = peak(&whole.pressure);
    for (one, other) in on_part.pressure.iter().zip(&whole.pressure) {
        assert!((one - other).abs() < 1e-6 * highest, "{one:e}, {other:e} of {highest:e}");
    }
    let scale = whole.displacement.iter().copied().fold(0.0, f64::max);
    assert!((on_part.approach - whole.approach).abs() < 1e-7 * scale);
    let displaced = displacement(step.compliance, &on_part.pressure);
    let within = |pair: usize| on_part.part.is_none_or(|part| part.place(pair).is_some());
    for (pair, displaced) in displaced.iter().enumerate() {
        let pressure = on_part.pressure[pair];
        let gap = step.gap[pair] + displaced + step.addition[pair] * pressure - on_part.approach;
        assert!(gap > -1e-6 * scale, "{gap:e} of {scale:e}");
        if within(pair) {
            assert!((on_part.gap[pair] - gap).abs() < 1e-7 * scale);
            assert!((on_part.displacement[pair] - displaced).abs() < 1e-7 * scale);
        } else {
            // Far from the contact gaps are wider than displacements, and rounded where they are.
            let rounded = 1e-12 * scale.max(gap);
            assert!((on_part.gap[pair] + displaced - gap).abs() < rounded, "{gap:e} of {scale:e}");
            assert!(gap > 0.0, "{gap:e} of {scale:e}");
        }
    }
}

fn start(outcome: &Outcome) -> Start<'_> {
    let Outcome { pressure, displacement, part, approach, .. } = outcome;
    Start { pressure, displacement, part: *part, approach: *approach }
}

/// Solves from nothing, then from the solution under another load, then from one that knows of the first spot alone.
fn is_the_same(bodies: &Bodies, load: f64, by_approach: bool) -> bool {
    let frame = frame();
    let compliance = half_space(&frame);
    let (gap, addition) = (bodies.gap(&frame), vec![bodies.addition; frame.len()]);
    let solver = solver("conjugate_gradient", 1e-9);
    let rest = Step {
        compliance: &compliance,
        gap: &gap,
        addition: &addition,
        elements: frame.elements(),
        measure: frame.measure(),
        control: Control::Load(load),
        hardness: f64::INFINITY,
    };
    let under_load = solver.solve(&rest, None);
    if under_load.status != Status::Converged {
        return false;
    }
    let control = if by_approach { Control::Approach(under_load.approach) } else { rest.control };
    let step = Step { control, ..rest };
    let whole = solver.solve(&step, None);
    let cold = press(&*solver, &step, None);
    assert_alike(&step, &cold, &whole);
    let lighter = press(&*solver, &Step { control: Control::Load(0.1 * load), ..rest }, None);
    let warm = press(&*solver, &step, Some(start(&lighter)));
    assert_alike(&step, &warm, &whole);
    let alone = Bodies { second: None, ..bodies.clone() }.gap(&frame);
    let one_spot = press(&*solver, &Step { gap: &alone, ..rest }, None);
    let from_one = press(&*solver, &step, Some(start(&one_spot)));
    assert_alike(&step, &from_one, &whole);
    let again = press(&*solver, &step, Some(start(&from_one)));
    assert_alike(&step, &again, &whole);
    cold.part.is_some()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

    #[test]
    fn a_part_gives_what_the_frame_gives(
        bodies in bodies(),
        load in 0.05..10.0f64,
        by_approach in proptest::bool::ANY,
    ) {
        is_the_same(&bodies, load, by_approach);
    }
}

/// Where it is far from the edges, a part serves: a small contact in a corner, and two apart.
#[test]
fn small_contacts_are_solved_on_parts() {
    let bodies = Bodies {
        spots: [[0.2, 0.3], [0.4, 0.45]],
        second: None,
        radius: 20e-3,
        rough: 0.0,
        scar: 0.0,
        addition: 0.0,
    };
    for second in [None, Some(0.05e-6)] {
        for by_approach in [false, true] {
            assert!(is_the_same(&Bodies { second, ..bodies.clone() }, 1.0, by_approach));
        }
    }
}

/// A spot far from where the last solve worked is found, and one under the whole frame is left to the frame.
#[test]
fn a_contact_that_appears_elsewhere_is_found() {
    let frame = frame();
    let compliance = half_space(&frame);
    let addition = vec![0.0; frame.len()];
    let solver = solver("conjugate_gradient", 1e-9);
    let spot = |u: f64, v: f64| Bodies {
        spots: [[u, v], [0.0; 2]],
        second: None,
        radius: 20e-3,
        rough: 0.0,
        scar: 0.0,
        addition: 0.0,
    };
    let here = spot(0.25, 0.25).gap(&frame);
    let step = Step {
        compliance: &compliance,
        gap: &here,
        addition: &addition,
        elements: frame.elements(),
        measure: frame.measure(),
        control: Control::Load(0.5),
        hardness: f64::INFINITY,
    };
    let first = press(&*solver, &step, None);
    assert!(first.part.is_some());
    for (u, v) in [(0.5, 0.3), (0.3, 0.5), (0.75, 0.25), (0.75, 0.8), (0.25, 0.9)] {
        let there = spot(u, v).gap(&frame);
        let both: Vec<f64> =
            here.iter().zip(&there).map(|(here, there)| here.min(*there)).collect();
        for gap in [&there, &both] {
            let step = Step { gap, ..step };
            let whole = solver.solve(&step, None);
            assert_alike(&step, &press(&*solver, &step, Some(start(&first))), &whole);
        }
    }
    let even = vec![0.0; frame.len()];
    let step = Step { gap: &even, ..step };
    assert_eq!(press(&*solver, &step, Some(start(&first))).status, Status::FrameFull);
    let step = Step { measure: Measure { closed: true, ..step.measure }, ..step };
    let all = press(&*solver, &step, Some(start(&first)));
    assert_eq!((all.status, all.part), (Status::Converged, None));
    assert!(all.pressure.iter().all(|pressure| *pressure > 0.0));
}

/// Half-spaces that count what they are asked: the pairs that are displaced, and the bounds.
#[derive(Debug)]
struct Counted<'a> {
    bodies: Box<dyn Compliance + 'a>,
    asked: &'a AtomicUsize,
}

impl Compliance for Counted<'_> {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        self.bodies.apply(tractions)
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.asked.fetch_add(pressure.len(), Ordering::Relaxed);
        self.bodies.apply_normal(pressure, displacement);
    }

    fn normal_self_term(&self) -> f64 {
        self.bodies.normal_self_term()
    }

    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        self.bodies.normal_preconditioner(addition)
    }

    fn within(&self, part: &Part) -> Option<Box<dyn Compliance + '_>> {
        Some(Box::new(Counted { bodies: self.bodies.within(part)?, asked: self.asked }))
    }

    fn least_displacement(&self, away: [usize; 2]) -> f64 {
        self.asked.fetch_add(1, Ordering::Relaxed);
        self.bodies.least_displacement(away)
    }
}

/// What is asked to know that a ball touches nowhere else, in a frame 1.4 times as wide as its contact, is as many elements as
/// there are, some times over: four times the elements are not asked much more often each.
#[test]
fn what_is_beside_a_part_is_known_in_proportion_to_the_elements() {
    let asked_of = |count: usize| {
        let frame = ContactFrame::uniform([0.42e-3; 2], [count; 2], [&Flat, &Flat]).unwrap();
        let asked = AtomicUsize::new(0);
        let counted = Counted { bodies: Box::new(half_space(&frame)), asked: &asked };
        let gap: Vec<f64> = (0..frame.len())
            .map(|pair| frame.place(pair).map(|at| at * at).iter().sum::<f64>() / 0.1)
            .collect();
        let step = Step {
            compliance: &counted,
            gap: &gap,
            addition: &vec![0.0; frame.len()],
            elements: frame.elements(),
            measure: frame.measure(),
            control: Control::Load(10.2),
            hardness: f64::INFINITY,
        };
        let outcome = press(&*solver("conjugate_gradient", 1e-8), &step, None);
        assert!(outcome.status == Status::Converged && outcome.part.is_some());
        asked.load(Ordering::Relaxed) as f64 / frame.len() as f64
    };
    let [coarse, fine] = [96, 192].map(asked_of);
    assert!(fine < 1.5 * coarse && fine < 40.0, "{coarse} and {fine} times each element");
}

/// No displacement is below its bound, and far away the bound is nearly reached; on a line, where bodies may even rise, too.
#[test]
fn displacements_are_not_below_their_bound() {
    let line = ContactFrame::line([SIDE, 1e-3], [64, 1], [&Flat, &Flat]).unwrap();
    for (frame, compliance) in [
        (frame(), half_space(&frame())),
        (line.clone(), HalfSpace::plane_strain([Some(&STEEL); 2], [&[]; 2], [2e-4; 2], &line)),
    ] {
        let mut unit = vec![0.0; frame.len()];
        unit[0] = 1.0;
        let found = displacement(&compliance, &unit);
        let [nx, ny] = frame.elements();
        for (pair, found) in found.iter().enumerate() {
            let bound = compliance.least_displacement([pair % nx, pair / nx]);
            assert!(bound < *found, "{bound:e} {found:e} at {pair}");
        }
        let (bound, last) =
            (compliance.least_displacement([nx - 1, ny - 1]), found[frame.len() - 1]);
        assert!(last - bound < 0.02 * last.abs(), "{bound:e} {last:e}");
    }
}

/// Lines that wear across the part's edge are the same lines within it.
#[test]
fn worn_lines_are_solved_on_parts() {
    for axis in [0, 1] {
        let frame = frame();
        let elastic = half_space(&frame);
        let bodies = Bodies {
            spots: [[0.35, 0.6], [0.0; 2]],
            second: None,
            radius: 20e-3,
            rough: 0.0,
            scar: 0.0,
            addition: 0.0,
        };
        let (gap, addition) = (bodies.gap(&frame), vec![0.0; frame.len()]);
        let solver = solver("conjugate_gradient", 1e-9);
        let rest = Step {
            compliance: &elastic,
            gap: &gap,
            addition: &addition,
            elements: frame.elements(),
            measure: frame.measure(),
            control: Control::Load(1.0),
            hardness: f64::INFINITY,
        };
        let unworn = press(&*solver, &rest, None);
        let flow = frame.flow(Direction { axis, reversed: false }).unwrap();
        let lines = ELEMENTS[1 - axis];
        for self_terms in [0.01, 0.3] {
            let slope = |line: usize| self_terms * (1.0 + 0.3 * (line as f64).sin());
            let slopes: Vec<f64> =
                (0..lines).map(|line| slope(line) * elastic.normal_self_term()).collect();
            let worn = WornLines::new(&elastic, flow, &slopes, &unworn.pressure);
            let step = Step { compliance: &worn, ..rest };
            let unknown = Start { part: unworn.part, ..start(&unworn) };
            let pressed = displacement(&worn, &unworn.pressure);
            let known = Start { displacement: &pressed, part: None, ..unknown };
            let on_part = press(&*solver, &step, Some(known));
            assert!(on_part.part.is_some());
            assert_alike(&step, &on_part, &solver.solve(&step, Some(known)));
        }
    }
}

/// The gap (m) that belongs to the pressures, approach and wear of a state, from nothing else.
fn gap_of(simulation: &Simulation, state: &ContactState) -> Vec<f64> {
    let problem = &simulation.problem;
    let displaced = displacement(&*problem.compliance, &state.pressure);
    let gaps = problem.frame.gap().iter().zip(displaced).zip(state.total_worn());
    gaps.map(|((gap, displaced), worn)| gap + displaced + worn - state.approach).collect()
}

fn assert_gap(simulation: &Simulation, state: &ContactState, tolerance: f64) {
    let expected = gap_of(simulation, state);
    let scale = peak(&expected);
    for (found, expected) in state.gap_of(&simulation.problem).iter().zip(&expected) {
        assert!((found - expected).abs() < tolerance * scale, "{found:e} {expected:e} {scale:e}");
    }
}

/// States tell the gap of the whole frame: of pairs that stay, and of lines whose wear goes beyond the part.
#[test]
fn the_gap_is_known_everywhere() {
    let sliding = Ball::pin_on_disc(48).sliding(0.04, Stepping::Implicit(0.01), &[]);
    for (state, ..) in states(&sliding).unwrap() {
        assert_gap(&sliding, &state, 1e-7);
    }
    let track = r#"
        [body.ball]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.sphere = { radius = "3 mm" }
        wear.archard = { coefficient = "2e-8 mm^3/(N m)" }
        [body.disc]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.flat = {}
        wear.archard = { coefficient = "8e-6 mm^3/(N m)" }
        [frame]
        size = ["0.6 mm", "0.5 mm"]
        elements = [48, 40]
        [motion.sliding]
        load = "10 N"
        track_radius = "10 mm"
        passes = "disc"
        distance = "20 m"
        step = "5 m"
    "#;
    let track = case(track, &[]);
    let states = states(&track).unwrap();
    assert!(states.len() == 5 && peak(&states[4].0.worn(1)) > 0.0);
    for (state, ..) in states {
        assert_gap(&track, &state, 1e-5);
    }
}

/// A frame twice as wide with elements of the same size shows the same contact, after as many solves.
#[test]
fn wider_frames_change_nothing() {
    let last = |ball: Ball| {
        let simulation = ball.sliding(0.1, Stepping::Tolerance(3e-3), &[]);
        states(&simulation).unwrap().pop().unwrap()
    };
    let narrow = Ball { size: [0.8e-3; 2], solver_tolerance: 1e-9, ..Ball::pin_on_disc(40) };
    let wide = Ball { size: [1.6e-3; 2], elements: [80; 2], ..narrow };
    let ([(one, took, _), (other, took_wide, _)], middle) = ([last(narrow), last(wide)], 20);
    assert_eq!(took.solves, took_wide.solves);
    let highest = peak(&one.pressure);
    for pair in 0..1600 {
        let there = pair % 40 + middle + 80 * (pair / 40 + middle);
        assert!((one.pressure[pair] - other.pressure[there]).abs() < 1e-6 * highest);
    }
    let total: f64 = one.pressure.iter().sum();
    assert!((other.pressure.iter().sum::<f64>() / total - 1.0).abs() < 1e-8);
}
