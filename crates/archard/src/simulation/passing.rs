//! Wear of surfaces that pass: all points on a line along the motion wear equally.
//!
//! Where bodies roll, a particle on its passage to a pair slides the slip of that passage under the mean of the pressures at both ends,
//! and it is rubbed until it has left the last pair under pressure, as far as it slips under the limit of friction. With
//! that pairing of tractions and slip the worn section equals the work of the creepage in rows of pairs, as it does in
//! nature, to the last digits: by construction, so that it says nothing about the force itself. Between
//! scattered pairs some of the work is lost to the diffusion of the derivative, a few percent; there all of the wear
//! is scaled by what is missing. Both profiles wear evenly around, so that a line has one depth.

mod slid;

use std::sync::Arc;

use super::collector::Collector;
use super::error::Error;
use crate::frame::{Flow, Line, Passage};
use crate::motion::Slip;
use crate::problem::{ContactProblem, ContactState, Flash, UnwornRecess};
use crate::wear::{Per, Rubbing, WearLaw};

pub(super) use slid::distance_of_work;
use slid::{distances, grip_of_passages, rubbed_slip, work_ratio};

/// The wear laws of body 1 and body 2; `None` of one that does not wear.
pub(super) type Laws = [Option<Arc<dyn WearLaw>>; 2];

/// The lines of the surfaces that pass.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lines<'a> {
    pub problem: &'a ContactProblem,
    pub flow: Flow<'a>,
    /// Which bodies pass.
    pub bodies: [bool; 2],
    /// How often they pass while the motion advances by one (its own unit).
    pub passages: f64,
    /// Whether the distances that points slide are asked for.
    pub counts: bool,
}

/// What one passage through the contact wears off a line of the surfaces that pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WornLine {
    /// The place of its middle across the direction, along the other axis (m).
    pub place: f64,
    /// Its width (m).
    pub width: f64,
    /// Depths (m) worn off body 1 and body 2.
    pub depths: [f64; 2],
    /// Distance (m) that its points slide under pressure.
    pub slid: f64,
}

/// What one passage wears off each line of the surfaces that pass, under the contact as it is; nothing where none pass.
pub(super) fn passage(
    problem: &ContactProblem,
    state: &ContactState,
) -> Result<Vec<WornLine>, Error> {
    let Some(lines) = Collector::of(problem)?.lines() else { return Ok(vec![]) };
    let OfLines { depths, slips, .. } = OfLines::of(state, Lines { counts: true, ..lines }, 1.0);
    let told = |((line, depths), slid): ((&Line, [f64; 2]), f64)| {
        let passes = |body: usize| if lines.bodies[body] { depths[body] } else { 0.0 };
        WornLine { place: line.place, width: line.width, depths: [passes(0), passes(1)], slid }
    };
    Ok(lines.flow.lines().iter().zip(depths).zip(slips).map(told).collect())
}

/// What one passage wears by other laws, off lines whose points slid and wore so far (m) before: `before` says it of a body and the place
/// of a line in their order.
pub(super) fn passage_by(
    problem: &ContactProblem,
    state: &ContactState,
    laws: &Laws,
    before: impl Fn(usize, usize) -> [f64; 2],
) -> Result<Vec<WornLine>, Error> {
    let [mut one, mut two] = problem.bodies.clone();
    [one.wear, two.wear] = laws.clone();
    let ContactProblem { frame, compliance, friction, motion, .. } = problem;
    let problem = ContactProblem {
        bodies: [one, two],
        frame: frame.clone(),
        compliance: compliance.clone(),
        friction: friction.clone(),
        motion: motion.clone(),
        unworn: UnwornRecess::default(),
    };
    let mut state = state.clone();
    if let Some(lines) = Collector::of(&problem)?.lines() {
        for (body, surface) in state.surfaces.iter_mut().enumerate() {
            surface.slid.resize(surface.depth.len(), 0.0);
            for (index, line) in lines.flow.lines().iter().enumerate() {
                let [slid, depth] = before(body, index);
                for one in &line.passages {
                    let element = surface.grid.at(one.pair, [0; 2]);
                    (surface.slid[element], surface.depth[element]) = (slid, depth);
                }
            }
        }
    }
    passage(&problem, &state)
}

/// Wear of the lines under the contact as it is, in one passage.
pub(super) struct OfLines {
    /// Depth worn off body 1 and body 2 (m), one value a line.
    pub depths: Vec<[f64; 2]>,
    /// Wear (m) of both under a unit pressure (Pa) on one pair more, one value a line.
    pub slopes: Vec<f64>,
    /// Sum of the pressures (Pa), weighted by the areas of the pairs, one value a line.
    pub pressures: Vec<f64>,
    /// Distance (m) that a point slides under pressure, one value a line; empty where it is not asked for.
    pub slips: Vec<f64>,
}

impl OfLines {
    /// In the middle of so many passages.
    pub fn of(state: &ContactState, lines: Lines<'_>, passages: f64) -> Self {
        let Lines { problem, flow, bodies, passages: each, counts } = lines;
        let pressure = &state.pressure;
        let weight = problem.frame.measure().weight;
        let further = 0.5 * problem.motion.slip(passages / each);
        let grip = grip_of_passages(state, problem, flow, further);
        let (means, slips, scale) = match problem.motion.slip {
            Slip::Sought(_) => {
                let means = flow.on_the_way(pressure);
                let slips = rubbed_slip(state, problem, flow, (&means, &grip));
                let rows = flow.has_rows();
                let scale = if rows {
                    1.0
                } else {
                    work_ratio(state, problem, flow, ([&means, &slips], &grip))
                };
                (means, slips, scale)
            }
            // A point slides the length of every element.
            Slip::Given(..) => {
                let all = || vec![flow.advance(); pressure.len()];
                (pressure.clone(), flow.advances().unwrap_or_else(all), 1.0)
            }
        };
        let lines = flow.lines();
        let rubs = |one: &&Passage| means[one.pair] > 0.0;
        let points = lines.iter().flat_map(|line| line.passages.iter().filter(rubs));
        let direction = |pair: usize| match &state.tangential {
            Some(tangential) => tangential.slip.each_ref().map(|slip| slip[pair]),
            None => flow.direction().forward(),
        };
        let all = || vec![flow.advance(); means.len()];
        let rolls = problem.motion.lever_arm().is_none();
        let rolled = rolls.then(|| flow.advances().unwrap_or_else(all));
        let flash = problem.flash_for_laws(state);
        let warm = flash.as_ref().and_then(|flash| temperatures(flash, problem, flow));
        // The slip of a passage that was slid only in part was as fast there.
        let speed = |pair: usize| {
            let rolled = rolled.as_ref()?[pair];
            let [x, y] = direction(pair);
            Some(problem.motion.speed? * x.hypot(y) / rolled)
        };
        let rubbing = |pair: usize, times: f64| {
            let slip = scale * times * slips[pair];
            let distance = rolled.as_ref().map_or(0.0, |rolled| times * rolled[pair]);
            let rubbing = problem.rubbing(means[pair], slip, direction(pair)).rolling(distance);
            let rubbing = rubbing.gripping(grip.at(pair));
            let rubbing = speed(pair).map_or(rubbing, |speed| rubbing.at_speed(speed));
            rubbing.at_temperature(warm.as_ref().map_or(0.0, |warm| warm[pair]))
        };
        let points = points.map(|one| rubbing(one.pair, 1.0));
        let mut on_lines =
            if counts { distances(state, problem, flow, [&means, &slips]) } else { vec![] };
        on_lines.iter_mut().for_each(|slid| *slid *= scale);
        let ages = [0, 1].map(|body| ages(problem, state, body, (&lines, &on_lines), passages));
        let of_points: Vec<(usize, f64)> = lines
            .iter()
            .enumerate()
            .flat_map(|(index, line)| {
                let rubbed = line.passages.iter().filter(rubs);
                rubbed.map(|one| (index, scale * slips[one.pair])).collect::<Vec<_>>()
            })
            .collect();
        // Half of what a law takes at once is its own.
        let before = |body: usize, line: usize, own: f64| {
            let [distance, depth]: [f64; 2] = ages[body][line];
            [(distance - 0.5 * own).max(0.0), depth]
        };
        let increments = problem.wearing(bodies, Per::Increment);
        let wear = problem.wear(points, increments, |body, point| {
            let (line, own) = of_points[point];
            before(body, line, own)
        });
        // All that a point goes through on a line.
        let whole = lines.iter().map(|line| {
            let part = |one: &Passage| rubbing(one.pair, one.times);
            let parts = line.passages.iter().filter(rubs).map(part);
            parts.reduce(Rubbing::then).unwrap_or(Rubbing::new(0.0, 0.0))
        });
        let whole: Vec<Rubbing> = whole.collect();
        let cycles = problem.wearing(bodies, Per::Cycle);
        let passage = problem
            .wear(whole.iter().copied(), cycles, |body, line| before(body, line, whole[line].slip));
        let mut collected =
            Self { depths: vec![], slopes: vec![], pressures: vec![], slips: on_lines };
        let mut point = 0;
        for (index, line) in lines.iter().enumerate() {
            let mut depths = passage.depths.each_ref().map(|depths| depths[index]);
            let (mut slope, mut sum) = (passage.slopes[index] * whole[index].pressure, 0.0);
            for one in &line.passages {
                sum += one.share * weight.at(one.pair) * pressure[one.pair];
                if rubs(&one) {
                    for (depth, worn) in depths.iter_mut().zip(&wear.depths) {
                        *depth += one.times * worn[point];
                    }
                    slope += one.times * wear.slopes[point] * means[one.pair];
                    point += 1;
                }
            }
            collected.depths.push(depths);
            collected.slopes.push(if sum > 0.0 { slope / sum } else { 0.0 });
            collected.pressures.push(sum);
        }
        collected.spread_slopes();
        collected
    }

    /// Gives lines that do not touch yet the slope of the nearest that do.
    fn spread_slopes(&mut self) {
        let touching: Vec<usize> =
            (0..self.pressures.len()).filter(|&line| self.pressures[line] > 0.0).collect();
        let (Some(&first), Some(&last)) = (touching.first(), touching.last()) else { return };
        let (low, high) = (self.slopes[first], self.slopes[last]);
        self.slopes[..first].fill(low);
        self.slopes[last..].fill(high);
    }

    /// Depth (m) of a line on both bodies.
    pub fn total(&self, line: usize) -> f64 {
        self.depths[line].iter().sum()
    }

    /// Depth (m) of the deepest line on both bodies.
    pub fn deepest(&self) -> f64 {
        (0..self.depths.len()).map(|line| self.total(line)).fold(0.0, f64::max)
    }
}

/// Temperatures (K) of the surfaces while they are rubbed at each pair, in rolling on the way there.
fn temperatures(flash: &Flash, problem: &ContactProblem, flow: Flow<'_>) -> Option<Vec<f64>> {
    if problem.motion.lever_arm().is_some() {
        return flash.temperatures();
    }
    let bulk = flash.bulk?;
    Some(flow.on_the_way(&flash.rise).iter().map(|rise| bulk + rise).collect())
}

/// How far (m) the points of lines slid and how deep (m) they wore on a body, in the middle of so many passages with those
/// slips (m); empty where no law asks.
fn ages(
    problem: &ContactProblem,
    state: &ContactState,
    body: usize,
    (lines, slips): (&[Line], &[f64]),
    passages: f64,
) -> Vec<[f64; 2]> {
    if !problem.ages() {
        return vec![];
    }
    let age = |(line, slip): (&Line, &f64)| {
        let mut sums = [0.0; 3];
        for one in &line.passages {
            let surface = &state.surfaces[body];
            let [distance, depth] = surface.before(surface.grid.at(one.pair, [0; 2]));
            let parts = [one.share, distance, depth];
            sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += one.share * part);
        }
        let [whole, distance, depth] = sums;
        [distance / whole + 0.5 * passages * slip, depth / whole]
    };
    lines.iter().zip(slips).map(age).collect()
}
