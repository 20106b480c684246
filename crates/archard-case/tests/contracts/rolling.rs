//! Contracts of rolling: friction laws, what tractions do to the slip, and the solvers of friction.

use approx::assert_relative_eq;
use archard::body::Material;
use archard::closed_form::Hertz;
use archard::compliance::{Compliance, HalfSpace, SlipMap};
use archard::frame::{ContactFrame, Direction, Pairs, VectorField};
use archard::friction::{Circumstance, FRICTION, Friction, Table, onto_disc};
use archard::parameters::{Value, Values};
use archard::solve::Status;
use archard::solve::tangential::{self, FRICTION_SOLVERS, PrescribedForce};
use proptest::prelude::*;

use crate::common::{Ball, STEEL, choose};

/// Values (SI) to build each law with.
const FRICTION_EXAMPLES: &[(&str, &[(&str, Value)])] = &[
    ("coulomb", &[("coefficient", Value::Number(0.6))]),
    ("coulomb", &[("coefficient", Value::Number(0.0))]),
    ("tresca", &[("coefficient", Value::Number(0.4)), ("shear_strength", Value::Number(3e8))]),
    (
        "falling",
        &[
            ("coefficient", Value::Number(0.5)),
            ("least", Value::Number(0.2)),
            ("speed", Value::Number(1.7)),
        ],
    ),
    ("orthotropic", &[("coefficients", Value::Pair([0.1, 0.65])), ("angle", Value::Number(0.7))]),
];

/// Laws that need more than values.
fn other_friction_laws() -> Vec<(&'static str, Box<dyn Friction>)> {
    let table = Table::new(&[2e8, 1e9], &[0.5, 0.3]).expect("a table");
    let over = |circumstance| Table::over(circumstance, &[0.1, 5.0], &[0.5, 0.3]).expect("a table");
    let others = [Circumstance::Speed, Circumstance::Distance, Circumstance::Temperature];
    let others = others.map(|circumstance| ("table", Box::new(over(circumstance)) as _));
    others.into_iter().chain([("table", Box::new(table) as _)]).collect()
}

/// Every friction law by its name; each in the list has an example.
pub fn friction_laws() -> Vec<(&'static str, Box<dyn Friction>)> {
    let others = other_friction_laws();
    for choice in FRICTION {
        let known = FRICTION_EXAMPLES.iter().any(|example| example.0 == choice.name)
            || others.iter().any(|example| example.0 == choice.name);
        assert!(known, "`{}` needs a line in the contract list", choice.name);
    }
    let build = |(name, given): &(&'static str, &[(&'static str, Value)])| {
        let mut values = Values::default();
        given.iter().for_each(|(name, value)| values.insert(name, value.clone()));
        let choice = FRICTION.iter().find(|choice| choice.name == *name).expect("a listed name");
        (*name, (choice.build)(&values).expect("valid values"))
    };
    FRICTION_EXAMPLES.iter().map(build).chain(others).collect()
}

pub const DIRECTIONS: [Direction; 4] = [
    Direction { axis: 0, reversed: false },
    Direction { axis: 0, reversed: true },
    Direction { axis: 1, reversed: false },
    Direction { axis: 1, reversed: true },
];

/// Something softer than steel.
pub const BRASS: Material = Material { young: 100e9, poisson: 0.35 };

/// Elements of the small frame, and their number.
pub const ELEMENTS: [usize; 2] = [7, 6];
pub const PAIRS: usize = 42;

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub fn norm(fields: [&[f64]; 2]) -> f64 {
    (dot(fields[0], fields[0]) + dot(fields[1], fields[1])).sqrt()
}

proptest! {
    /// No traction without pressure, a limit that never falls, and a projection on the nearest
    /// admissible traction: one that is admissible stays, and any other is no nearer.
    #[test]
    fn friction_laws_bound_the_tractions(
        pressure in 0.0..3e9f64,
        more in 0.0..1e9f64,
        trial in prop::array::uniform2(-4e9..4e9f64),
        other in prop::array::uniform2(-1.0..1.0f64),
    ) {
        for (_, law) in friction_laws() {
            prop_assert_eq!(law.limit(0.0), 0.0);
            prop_assert_eq!(onto_disc(trial, law.limit(0.0)), [0.0; 2]);
            let limit = law.limit(pressure);
            prop_assert!(limit >= 0.0 && law.limit(pressure + more) >= limit);
            let found = onto_disc(trial, limit);
            let admissible = |[x, y]: [f64; 2]| x.hypot(y) <= limit * (1.0 + 1e-14);
            prop_assert!(admissible(found));
            let again = onto_disc(found, limit);
            let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
            prop_assert!(distance(found, again) <= 1e-14 * limit);
            if admissible(trial) {
                prop_assert!(distance(found, trial) <= 1e-14 * limit);
            }
            let other = other.map(|part| part * limit);
            if admissible(other) {
                prop_assert!(distance(trial, found) <= distance(trial, other) + 1e-6);
            }
            // The map keeps the work, and what it makes of the disc has the length of the limit.
            let (map, dot) = (law.map(), |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1]);
            let traction = map.apply(found);
            prop_assert!((map.length(traction) - found[0].hypot(found[1])).abs() <= 1e-12 * limit);
            let work = dot(traction, trial) - dot(found, map.apply(trial));
            prop_assert!(work.abs() <= 1e-12 * limit * map.largest() * trial[0].hypot(trial[1]));
            prop_assert!(dot(trial, map.apply(trial)) >= 0.0);
        }
    }
}

pub fn small_frame() -> ContactFrame {
    let ball = Ball { size: [1.2e-3, 0.9e-3], elements: ELEMENTS, ..Ball::pin_on_disc(1) };
    ball.problem().frame
}

/// Compliances of bodies of one kind, unlike, and one of them rigid.
pub fn compliances(frame: &ContactFrame) -> [HalfSpace; 3] {
    [[Some(&STEEL), Some(&STEEL)], [Some(&STEEL), Some(&BRASS)], [Some(&STEEL), None]]
        .map(|materials| HalfSpace::new(materials, frame))
}

pub fn apply(map: &dyn SlipMap, tractions: &[Vec<f64>; 2]) -> [Vec<f64>; 2] {
    let mut slip = [vec![0.0; PAIRS], vec![0.0; PAIRS]];
    let [one, two] = &mut slip;
    map.apply([&tractions[0], &tractions[1]], [one, two]);
    slip
}

/// Tractions made from numbers in a row, zero on the outermost elements.
fn inside(numbers: &[f64]) -> [Vec<f64>; 2] {
    let [nx, ny] = ELEMENTS;
    let edge = |pair: usize| {
        let (x, y) = (pair % nx, pair / nx);
        x == 0 || x + 1 == nx || y == 0 || y + 1 == ny
    };
    [0, 1].map(|axis| {
        let value = |pair| if edge(pair) { 0.0 } else { numbers[2 * pair + axis] };
        (0..PAIRS).map(value).collect()
    })
}

/// A compliance that knows nothing of rolling.
#[derive(Debug)]
pub struct Plain<'a>(pub &'a HalfSpace);

impl Compliance for Plain<'_> {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        self.0.apply(tractions)
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.0.apply_normal(pressure, displacement);
    }

    fn normal_self_term(&self) -> f64 {
        self.0.normal_self_term()
    }
}

/// Shows every map of every compliance along every direction: its own, and the one any compliance has.
fn for_each_map(frame: &ContactFrame, mut show: impl FnMut(&dyn SlipMap, Direction)) {
    for compliance in compliances(frame) {
        let plain = Plain(&compliance);
        for direction in DIRECTIONS {
            show(&*compliance.rolling(frame.flow(direction).unwrap()), direction);
            show(&*plain.rolling(frame.flow(direction).unwrap()), direction);
        }
    }
}

/// Numbers between -1 and 1 without an order.
pub fn arbitrary(seed: u32) -> Vec<f64> {
    (0..2 * PAIRS as u32).map(|i| f64::from(i * i + 17 * seed * (i + 3)).sin()).collect()
}

/// Tractions that vanish on the outermost elements never feed the slip.
#[test]
fn slip_maps_are_linear_and_monotone() {
    let frame = small_frame();
    for seed in 0..8 {
        let (one, other) = (inside(&arbitrary(seed)), inside(&arbitrary(seed + 100)));
        let combined =
            [0, 1].map(|axis| (0..PAIRS).map(|i| one[axis][i] - 3.0 * other[axis][i]).collect());
        for_each_map(&frame, |map, direction| {
            let images = [&one, &other, &combined].map(|tractions| apply(map, tractions));
            let [of_one, of_other, of_both] = images.each_ref().map(|image| image.concat());
            for ((found, one), other) in of_both.iter().zip(&of_one).zip(&of_other) {
                assert_relative_eq!(*found, one - 3.0 * other, epsilon = 1e-12 * map.own());
            }
            let work = dot(&one[0], &images[0][0]) + dot(&one[1], &images[0][1]);
            assert!(work >= 0.0, "{work} along {direction:?}");
        });
    }
}

/// The slip of a pair under a unit traction on it alone, pair by pair behind the foremost.
#[test]
fn slip_maps_know_their_largest_self_term() {
    let frame = small_frame();
    for_each_map(&frame, |map, direction| {
        let behind = (0..PAIRS).filter(|&pair| direction.ahead(pair, ELEMENTS).is_some());
        let terms = behind.flat_map(|pair| {
            [0, 1].map(|axis| {
                let mut tractions = [vec![0.0; PAIRS], vec![0.0; PAIRS]];
                tractions[axis][pair] = 1.0;
                apply(map, &tractions)[axis][pair]
            })
        });
        assert_relative_eq!(map.own(), terms.fold(0.0, f64::max), max_relative = 1e-10);
    });
}

/// Differences taken in the transforms are those taken of the displacements; on the foremost pairs,
/// which have none ahead, they may be others.
#[test]
fn half_spaces_roll_as_any_compliance_does() {
    let frame = small_frame();
    let numbers = arbitrary(1);
    let all = [0, 1].map(|axis| (0..PAIRS).map(|pair| numbers[2 * pair + axis]).collect());
    for compliance in compliances(&frame) {
        for direction in DIRECTIONS {
            let plain = Plain(&compliance);
            let map = compliance.rolling(frame.flow(direction).unwrap());
            let found = apply(&*map, &all);
            let expected = apply(&*plain.rolling(frame.flow(direction).unwrap()), &all);
            for (pair, (found, expected)) in
                found.concat().iter().zip(expected.concat()).enumerate()
            {
                if direction.ahead(pair % PAIRS, ELEMENTS).is_some() {
                    assert_relative_eq!(*found, expected, epsilon = 1e-12 * map.own());
                }
            }
        }
    }
}

/// The pairs of a frame without their rows.
fn as_a_cloud(frame: &ContactFrame) -> ContactFrame {
    let all = 0..frame.len();
    let place = |pair| {
        let [x, y] = frame.place(pair);
        [x, y, 0.0]
    };
    let pairs = Pairs {
        places: all.clone().map(place).collect(),
        areas: all.clone().map(|pair| frame.area(pair)).collect(),
        gap: frame.gap().to_vec(),
        outlines: all.map(|pair| frame.outline(pair)).collect(),
        ..Pairs::default()
    };
    ContactFrame::described(pairs).unwrap()
}

/// Where pairs lie in rows and nothing says so, particles pass them all the same: the slip over a length is that of
/// rows, rubbing is that of the passage from the pair ahead, and the strips are the rows.
#[test]
fn pairs_in_rows_roll_as_any_do() {
    let frame = small_frame();
    let cloud = as_a_cloud(&frame);
    let numbers = arbitrary(1);
    let all = [0, 1].map(|axis| (0..PAIRS).map(|pair| numbers[2 * pair + axis]).collect());
    let pressure: Vec<f64> = numbers[..PAIRS].iter().map(|number| number.abs()).collect();
    for compliance in compliances(&frame) {
        for direction in DIRECTIONS {
            let plain = Plain(&compliance);
            let flows = [&frame, &cloud].map(|frame| frame.flow(direction).unwrap());
            let [rows, other] = flows.map(|flow| {
                let map = plain.rolling(flow);
                (apply(&*map, &all).concat(), map.own(), flow.advance())
            });
            for (one, other_one) in rows.0.iter().zip(&other.0) {
                let [one, other] = [one / rows.2, other_one / other.2];
                assert_relative_eq!(one, other, epsilon = 1e-10 * rows.1 / rows.2);
            }
            let means = flows.map(|flow| flow.on_the_way(&pressure));
            for pair in (0..PAIRS).filter(|&pair| direction.ahead(pair, ELEMENTS).is_some()) {
                assert_relative_eq!(means[0][pair], means[1][pair], epsilon = 1e-12);
            }
            let [rows, strips] = flows.map(|flow| (flow.lines(), flow.advance()));
            assert_eq!(rows.0.len(), strips.0.len());
            for (row, strip) in rows.0.iter().zip(strips.0.iter()) {
                assert_relative_eq!(row.width, strip.width, max_relative = 1e-12);
                assert_relative_eq!(row.place, strip.place, epsilon = 1e-12 * row.width);
                for one in &strip.passages {
                    let of_row = row.passages.iter().find(|other| other.pair == one.pair);
                    let (share, times) = of_row.map_or((0.0, 0.0), |one| (one.share, one.times));
                    assert_relative_eq!(one.share, share, epsilon = 1e-12);
                    let [found, known] = [one.times * strips.1, times * rows.1];
                    assert_relative_eq!(found, known, epsilon = 1e-12 * rows.1);
                }
            }
        }
    }
}

/// What drives a small problem: rigid slip of an element (relative to mu p0 times its self term) along x
/// and y, how it turns over the frame, and forces along x and y (relative to the limit) instead.
struct Drives {
    slip: [f64; 2],
    spin: f64,
    forces: &'static [([f64; 2], f64)],
}

const DRIVES: &[Drives] = &[
    Drives { slip: [0.3, 0.0], spin: 0.0, forces: &[] },
    Drives { slip: [0.2, -0.2], spin: 0.0, forces: &[] },
    Drives { slip: [0.1, 0.0], spin: 0.3, forces: &[] },
    Drives { slip: [2.0, 1.0], spin: 1.0, forces: &[] },
    Drives { slip: [0.0, 0.1], spin: 0.0, forces: &[([1.0, 0.0], 0.5)] },
    Drives { slip: [0.0, 0.0], spin: 0.2, forces: &[([1.0, 0.0], -0.4), ([0.0, 1.0], 0.3)] },
];

/// Twin discs on 15 x 15 elements: all solvers find the same tractions, and they obey the law.
#[test]
fn friction_solvers_agree() {
    let elements = [15, 15];
    let ball = Ball { size: [0.52e-3, 2e-3], elements, ..Ball::pin_on_disc(1) };
    let frame = ball.problem().frame;
    let compliance = HalfSpace::new([Some(&STEEL), Some(&STEEL)], &frame);
    let hertz = Hertz::from_load([61.7, 8.0], 115e9, 300.0).unwrap();
    let limit: Vec<f64> =
        (0..frame.len()).map(|pair| 0.6 * hertz.pressure(frame.place(pair))).collect();
    let zeros = vec![0.0; frame.len()];
    let [largest, bears] = [norm([&limit, &zeros]), frame.integrate(&limit)];
    for direction in DIRECTIONS {
        let map = compliance.rolling(frame.flow(direction).unwrap());
        let unit = map.own() * 0.6 * hertz.peak_pressure;
        for Drives { slip, spin, forces } in DRIVES {
            let turned = |pair: usize| {
                let [x, y] = frame.place(pair).map(|place| spin * place / 1e-3);
                [unit * (slip[0] - y), unit * (slip[1] + x)]
            };
            let rigid =
                [0, 1].map(|axis| (0..frame.len()).map(|i| turned(i)[axis]).collect::<Vec<_>>());
            let prescribed: Vec<PrescribedForce> = forces
                .iter()
                .map(|&(direction, share)| PrescribedForce { direction, force: share * bears })
                .collect();
            let step = tangential::Step {
                map: &*map,
                elements,
                measure: frame.measure(),
                limit: &limit,
                rigid: [&rigid[0], &rigid[1]],
                prescribed: &prescribed,
            };
            let outcomes = FRICTION_SOLVERS.iter().map(|choice| {
                let solver = choose(FRICTION_SOLVERS, choice.name, &[("tolerance", 1e-8)]);
                let outcome = solver.solve(&step, None);
                assert_eq!(outcome.status, Status::Converged, "{}", choice.name);
                assert!(outcome.residual <= 1e-8, "{}", choice.name);
                (choice.name, outcome)
            });
            let outcomes: Vec<_> = outcomes.collect();
            let (_, first) = &outcomes[0];
            for (name, outcome) in &outcomes {
                let apart = [0, 1].map(|axis| {
                    let pairs = outcome.traction[axis].iter().zip(&first.traction[axis]);
                    pairs.map(|(one, other)| one - other).collect::<Vec<_>>()
                });
                let apart = norm([&apart[0], &apart[1]]) / largest;
                assert!(apart < 1e-4, "{name}: {apart:e} apart along {direction:?}");
                let sizes = outcome.traction[0].iter().zip(&outcome.traction[1]);
                for ((x, y), limit) in sizes.zip(&limit) {
                    assert!(x.hypot(*y) <= limit + 1e-8 * largest, "{name}");
                }
                for prescribed in &prescribed {
                    let force = [0, 1].map(|axis| frame.integrate(&outcome.traction[axis]));
                    let force =
                        force[0] * prescribed.direction[0] + force[1] * prescribed.direction[1];
                    assert_relative_eq!(force, prescribed.force, epsilon = 1e-7 * bears);
                }
            }
        }
    }
}
