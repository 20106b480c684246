//! Contracts of bodies shifted against each other: motions in increments, and what tractions do to the slip.

use approx::assert_relative_eq;
use archard::compliance::{Compliance, HalfSpace, PairStatus, SlipMap};
use archard::frame::{ContactFrame, Part, VectorField};
use archard::motion::{Drive, MOTIONS, Motion, Schedule};
use archard::parameters::{Value, Values};

use crate::common::Ball;

use super::rolling::{PAIRS, Plain, apply, arbitrary, compliances, dot, small_frame};

/// A motion of that name out of numbers (SI) and one value of another kind.
fn motion(
    name: &str,
    numbers: &[(&'static str, f64)],
    other: (&'static str, Value),
) -> (Motion, Schedule) {
    let mut values = Values::default();
    numbers.iter().for_each(|(name, number)| values.insert(name, Value::Number(*number)));
    values.insert(other.0, other.1);
    let choice = MOTIONS.iter().find(|choice| choice.name == name).expect("a listed name");
    (choice.build)(&values).expect("valid values")
}

/// Every motion that shifts bodies against each other, with the cycles it makes.
fn motions() -> [((Motion, Schedule), f64); 4] {
    let column = |name: &str, values: [f64; 3]| (name.to_owned(), values.to_vec());
    let table = Value::Table(vec![
        column("time", [0.0, 1.0, 3.0]),
        column("load", [5.0, 10.0, 5.0]),
        column("force_x", [0.0, 2.0, 0.0]),
    ]);
    let [forward, apart] = [Value::Pair([1e-6, 0.0]), Value::Pair([2.0, 1.0])];
    let circle = [("load", 50.0), ("phase", 1.5), ("increments", 8.0), ("cycles", 3.0)];
    let press = [("increments", 5.0), ("cycles", 3.0)];
    [
        (motion("indentation", &press, ("load", Value::Number(10.0))), 3.0),
        (motion("fretting", &[("approach", 1e-6)], ("amplitude", forward)), 1.0),
        (motion("fretting", &circle, ("force_amplitude", apart)), 3.0),
        (motion("path", &[("increments", 4.0), ("cycles", 2.0)], ("file", table)), 2.0),
    ]
}

/// Increments go forward, end with the cycle and lead where the next cycle begins; no motion makes pairs
/// slide that friction could hold.
#[test]
fn motions_in_increments_come_back() {
    for ((motion, schedule), cycles) in motions() {
        let shift = motion.increments().expect("a motion in increments");
        assert_eq!(shift.cycle.len(), shift.places.len());
        assert!(shift.places[0] > 0.0 && shift.places.windows(2).all(|pair| pair[0] < pair[1]));
        assert_relative_eq!(schedule.extent, cycles * shift.period());
        assert_eq!(motion.slip(0.1), 0.0);
        assert!(motion.progress.column.contains(char::is_alphabetic));
        let guided = |guide: Drive| !guide.is_still();
        let moves = shift.cycle.iter().any(|station| station.guides.into_iter().any(guided));
        assert_eq!(shift.moves(), moves);
        if !shift.released {
            assert_eq!(shift.lead.last(), shift.cycle.last());
        }
    }
}

/// Shows every map of every compliance: its own, and the one any compliance has.
fn for_each_map(frame: &ContactFrame, mut show: impl FnMut(&dyn SlipMap, &HalfSpace)) {
    for compliance in compliances(frame) {
        let plain = Plain(&compliance);
        show(&*compliance.shifting(frame), &compliance);
        show(&*plain.shifting(frame), &compliance);
    }
}

/// Tractions of numbers in a row.
fn tractions(numbers: &[f64]) -> [Vec<f64>; 2] {
    [0, 1].map(|axis| (0..PAIRS).map(|pair| numbers[2 * pair + axis]).collect())
}

fn work(one: &[Vec<f64>; 2], other: &[Vec<f64>; 2]) -> f64 {
    dot(&one[0], &other[0]) + dot(&one[1], &other[1])
}

/// The slip is the tangential displacement; symmetric and positive, and its largest self term is known.
#[test]
fn shifted_bodies_slip_by_their_displacement() {
    let frame = small_frame();
    for_each_map(&frame, |map, compliance| {
        for seed in 0..4 {
            let (one, other) = (tractions(&arbitrary(seed)), tractions(&arbitrary(seed + 100)));
            let (of_one, of_other) = (apply(map, &one), apply(map, &other));
            let [t1, t2] = one.clone();
            let displacement = compliance.apply(&VectorField { t1, t2, n: vec![0.0; PAIRS] });
            let expected = [displacement.t1, displacement.t2].concat();
            for (found, expected) in of_one.concat().iter().zip(expected) {
                assert_relative_eq!(*found, expected, epsilon = 1e-12 * map.own());
            }
            let (own, across) = (work(&one, &of_one), work(&one, &of_other));
            assert!(own > 0.0);
            assert_relative_eq!(across, work(&other, &of_one), epsilon = 1e-12 * own);
        }
        let mut unit = [vec![0.0; PAIRS], vec![0.0; PAIRS]];
        let terms = [0, 1].map(|axis| {
            unit[axis][PAIRS / 2] = 1.0;
            let term = apply(map, &unit)[axis][PAIRS / 2];
            unit[axis][PAIRS / 2] = 0.0;
            term
        });
        assert_relative_eq!(map.own(), terms[0].max(terms[1]), max_relative = 1e-12);
    });
}

/// On a part of the frame, the map is that of a frame of that size; on elements of twice the size, a
/// traction on four elements displaces their middle by the mean of what it displaces the four by.
#[test]
fn maps_on_other_elements_are_those_of_their_frames() {
    let frame = small_frame();
    let [dx, dy] = frame.spacing();
    for compliance in compliances(&frame) {
        let map = compliance.shifting(&frame);
        let part = map.within(&Part::inside([4, 5], [[0, 1], [0, 1]])).expect("a part");
        let size = [4.0 * dx, 5.0 * dy];
        let smaller = Ball { size, elements: [4, 5], ..Ball::pin_on_disc(1) }.problem().frame;
        let numbers = arbitrary(3);
        let [x, y] = [&numbers[..20], &numbers[20..40]];
        let image = |map: &dyn SlipMap| {
            let (mut one, mut two) = (vec![0.0; 20], vec![0.0; 20]);
            map.apply([x, y], [&mut one, &mut two]);
            [one, two].concat()
        };
        // Each of the compliances of like bodies, unlike ones and with one rigid, on the smaller frame.
        let same = compliances(&smaller)
            .into_iter()
            .map(|compliance| image(&*compliance.shifting(&smaller)))
            .filter(|expected| {
                let off = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-12 * map.own();
                image(&*part).iter().zip(expected).all(off)
            });
        assert_eq!(same.count(), 1);

        let coarser = map.coarser().expect("coarser elements");
        assert_eq!((coarser.elements, coarser.slip), ([4, 3], 1.0));
        let quad = [16, 17, 23, 24];
        let mut fine = [vec![0.0; PAIRS], vec![0.0; PAIRS]];
        quad.iter().for_each(|&pair| fine[0][pair] = 1.0);
        let four = apply(&*map, &fine);
        let mean = quad.iter().map(|&pair| four[0][pair]).sum::<f64>() / 4.0;
        let mut unit = [vec![0.0; 12], vec![0.0; 12]];
        unit[0][1 + 4] = 1.0;
        let (mut one, mut two) = (vec![0.0; 12], vec![0.0; 12]);
        coarser.map.apply([&unit[0], &unit[1]], [&mut one, &mut two]);
        // In the middle a square is displaced by some more than its corners' neighbours are.
        assert_relative_eq!(one[5], mean, max_relative = 0.15);
    }
}

/// What undoes a slip is symmetric and positive whatever sticks and slips, and where all sticks nearly the
/// inverse.
#[test]
fn undoing_a_slip_is_symmetric_and_positive() {
    let frame = small_frame();
    for_each_map(&frame, |map, _| {
        let precondition = |slip: &[Vec<f64>; 2], status: &[PairStatus]| {
            let (mut one, mut two) = (vec![0.0; PAIRS], vec![0.0; PAIRS]);
            map.precondition([&slip[0], &slip[1]], status, [&mut one, &mut two]);
            [one, two]
        };
        let all = vec![PairStatus::Stick; PAIRS];
        let third = |pair: usize| match pair % 3 {
            0 => PairStatus::Slip { diagonal: pair as f64 * map.own() },
            _ => PairStatus::Stick,
        };
        let some: Vec<PairStatus> = (0..PAIRS).map(third).collect();
        for status in [&all, &some] {
            let (one, other) = (tractions(&arbitrary(5)), tractions(&arbitrary(6)));
            let (of_one, of_other) = (precondition(&one, status), precondition(&other, status));
            let own = work(&one, &of_one);
            assert!(own > 0.0);
            assert_relative_eq!(
                work(&one, &of_other),
                work(&other, &of_one),
                epsilon = 1e-12 * own
            );
        }
        // The form of the inverse over that of what undoes: 1 to 2.4 on this frame of 42 pairs.
        for seed in 0..4 {
            let t = tractions(&arbitrary(seed));
            let slip = apply(map, &t);
            let share = work(&slip, &precondition(&slip, &all)) / work(&slip, &t);
            assert!((0.4..2.5).contains(&share), "{share}");
        }
    });
}
