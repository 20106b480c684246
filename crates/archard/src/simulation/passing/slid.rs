//! How far the surfaces slide on each passage to a pair, and on a line from edge to edge.

use crate::frame::{Flow, Line, Passage, VectorField};
use crate::friction::{Friction, Grip, Limits};
use crate::problem::{ContactProblem, ContactState};

/// The most by which wear is scaled for the work that is lost.
const MOST_LOST: f64 = 2.0;

/// Distances (m) that points slide in contact, one value a line: up to its edges in rows, in passages to and from pairs under
/// pressure elsewhere.
pub(super) fn distances(
    state: &ContactState,
    problem: &ContactProblem,
    flow: Flow<'_>,
    [means, slips]: [&[f64]; 2],
) -> Vec<f64> {
    let lines = flow.lines();
    if !flow.has_rows() {
        let rubs = |one: &&Passage| means[one.pair] > 0.0;
        let slides = |one: &Passage| one.times * slips[one.pair];
        return lines
            .iter()
            .map(|one| one.passages.iter().filter(rubs).map(slides).sum())
            .collect();
    }
    let edge = state.edge(problem);
    let touches = |pair: usize| state.pressure[pair] > 0.0;
    let end = |pairs| edge.as_ref().map_or(0.5, |edge| edge.between(pairs));
    // The part of the way between the centres of two pairs that lies in contact.
    let part = |[from, to]: [usize; 2]| match [from, to].map(touches) {
        [true, true] => 1.0,
        [true, false] => end([from, to]),
        [false, true] => end([to, from]),
        [false, false] => 0.0,
    };
    let at_side = |one: &Passage| if touches(one.pair) { 0.5 * slips[one.pair] } else { 0.0 };
    let distance = |line: &Line| {
        let all = &line.passages;
        let ways = all.iter().zip(&all[1..]);
        let between: f64 = ways.map(|(from, to)| part([from.pair, to.pair]) * slips[to.pair]).sum();
        let sides: f64 = [all.first(), all.last()].into_iter().flatten().map(at_side).sum();
        // An edge may lie before the centre of a pair that stands alone.
        (between + sides).max(0.0)
    };
    lines.iter().map(distance).collect()
}

/// The grip on the passage to each pair, where it scales the limit under the mean of the pressures to the mean of the limits;
/// of bodies that slide that at each pair, after points slid so much further (m).
pub(super) fn grip_of_passages(
    state: &ContactState,
    problem: &ContactProblem,
    flow: Flow<'_>,
    further: f64,
) -> Grip {
    let grip = problem.grip(state, |_| further).unwrap_or_else(|last| last);
    let (Some(friction), Some(_)) = (&problem.friction, &state.tangential) else { return grip };
    grip.map(|factors| {
        let limits = Limits::new(&**friction, &grip).all(&state.pressure);
        let means = flow.on_the_way(&state.pressure);
        let ratio = |(pair, limit): (usize, f64)| {
            let mean = friction.limit(means[pair].max(0.0));
            if mean > 0.0 { limit / mean } else { factors[pair] }
        };
        flow.on_the_way(&limits).into_iter().enumerate().map(ratio).collect()
    })
}

/// Distance slid under a unit limit of friction that goes with a unit of its work: one if friction is the same in all
/// directions, otherwise the mean of what resists less or more.
pub(in super::super) fn distance_of_work(
    state: &ContactState,
    friction: &dyn Friction,
    problem: &ContactProblem,
    flow: Flow<'_>,
) -> f64 {
    let Some(tangential) = &state.tangential else { return 1.0 };
    let grip = grip_of_passages(state, problem, flow, 0.0);
    let traction = tangential.traction.each_ref().map(|traction| flow.on_the_way(traction));
    let (mut distance, mut total) = (0.0, 0.0);
    for pair in 0..problem.frame.len() {
        let slip = tangential.slip.each_ref().map(|slip| slip[pair]);
        let work = traction[0][pair] * slip[0] + traction[1][pair] * slip[1];
        let work = problem.frame.area(pair) * work;
        distance += work / (friction.map().resistance(slip) * grip.at(pair));
        total += work;
    }
    if total == 0.0 { 1.0 } else { distance / total }
}

/// Distance (m) that particles slide under the limit of friction on the passage to each pair: the work of the tractions
/// on the slip over the limit. Where they slip all the way it is the slip; the element in which they pass from stick
/// to slip, and the one in which they leave the contact, count by the part that slips. Where the first pair of a row,
/// which is tied, slips backwards, the work is taken from the passages behind.
pub(super) fn rubbed_slip(
    state: &ContactState,
    problem: &ContactProblem,
    flow: Flow<'_>,
    (means, grip): (&[f64], &Grip),
) -> Vec<f64> {
    let Some(tangential) = &state.tangential else { return vec![0.0; means.len()] };
    let [x, y] = &tangential.slip;
    let whole = |pair: usize| x[pair].hypot(y[pair]);
    let Some(friction) = &problem.friction else { return (0..means.len()).map(whole).collect() };
    let [one, two] = tangential.traction.each_ref().map(|traction| flow.on_the_way(traction));
    let (map, limits) = (friction.map(), Limits::new(&**friction, grip));
    // The part of a pair, and the work that it makes too much after some that was.
    let part = |pair: usize, owed: f64| {
        let limit = limits.at(pair, means[pair].max(0.0)) * map.resistance([x[pair], y[pair]]);
        if limit == 0.0 {
            return (whole(pair), owed);
        }
        let work = one[pair] * x[pair] + two[pair] * y[pair] - owed;
        let part = (work / limit).clamp(0.0, whole(pair));
        (part, (limit * part - work).max(0.0))
    };
    if !flow.has_rows() {
        return (0..means.len()).map(|pair| part(pair, 0.0).0).collect();
    }
    let mut rubbed = vec![0.0; means.len()];
    for line in flow.lines().iter() {
        let mut owed = 0.0;
        for one in &line.passages {
            (rubbed[one.pair], owed) = part(one.pair, owed);
        }
    }
    rubbed
}

/// Work of the rigid slip on the tractions relative to that of friction on the slip: one for the bodies themselves,
/// more where a derivative on scattered pairs diffuses the displacements.
pub(super) fn work_ratio(
    state: &ContactState,
    problem: &ContactProblem,
    flow: Flow<'_>,
    ([means, rubbed], grip): ([&[f64]; 2], &Grip),
) -> f64 {
    let (Some(tangential), Some(friction)) = (&state.tangential, &problem.friction) else {
        return 1.0;
    };
    let [t1, t2] = tangential.traction.clone();
    let n = vec![0.0; t1.len()];
    let displacement = problem.compliance.apply(&VectorField { t1, t2, n });
    let taken = flow.gained([&displacement.t1, &displacement.t2]);
    let slips = |pair: usize| tangential.slip.each_ref().map(|slip| slip[pair]);
    let rigid = |pair: usize| -> f64 {
        let works =
            |axis: usize| tangential.traction[axis][pair] * (slips(pair)[axis] + taken[axis][pair]);
        problem.frame.area(pair) * (works(0) + works(1))
    };
    let (map, limits) = (friction.map(), Limits::new(&**friction, grip));
    let rubbed = |one: &Passage| {
        let limit = limits.at(one.pair, means[one.pair].max(0.0)) * map.resistance(slips(one.pair));
        one.times * limit * rubbed[one.pair]
    };
    let rigid: f64 = (0..means.len()).map(rigid).sum();
    let lines = flow.lines();
    let rubbed = lines.iter().map(|one| one.width * one.passages.iter().map(rubbed).sum::<f64>());
    let images = if problem.frame.mirrored()[1 - flow.direction().axis] { 2.0 } else { 1.0 };
    let rubbed = images * flow.advance() * rubbed.sum::<f64>();
    let ratio = rigid / rubbed;
    // What hardly slips works by its residuals.
    if ratio.is_finite() { ratio.clamp(1.0 / MOST_LOST, MOST_LOST) } else { 1.0 }
}
