//! Wear of cycles that are jumped over, from the rubbing of one that was computed.
//!
//! What a pair slides in a cycle hardly depends on a little wear; how it is pressed does. A cycle that
//! wore the depth d under the pressure p of its most pressed instant stands for the law d' (p'), a line
//! through (p, d), and the cycles of a jump wear implicitly by it: a normal contact solve with the slope
//! on the diagonal of the compliance.

use super::chain::{Chain, Leg};
use super::shift::Rig;
use super::{Effort, Error, Simulation};
use crate::kinematics::Control;
use crate::numerics::vector::{map, sum};
use crate::problem::ContactProblem;

/// Wear a cycle as a function of the pressure at its most pressed instant.
#[derive(Debug, Clone)]
pub(super) struct Rate {
    /// Depth at zero pressure (m) and slope (m/Pa) of body 1 and body 2, one value a pair.
    constant: [Vec<f64>; 2],
    slope: [Vec<f64>; 2],
    /// The contact at the most pressed instant.
    reference: Chain,
    control: Control,
    /// Gap (m) that friction opens there.
    opened: Vec<f64>,
    /// Whether pairs in contact stuck throughout the cycle.
    pub sticks: bool,
    /// Distance slid in terms of the pressure at that instant (m), one value a pair.
    slip: Vec<f64>,
    /// Energy dissipated (J).
    dissipated: f64,
}

impl Rate {
    /// Of the cycle that a rig has gone through, the most pressed instant of which is kept beside it.
    pub fn of(rig: &Rig, reference: &Rig, control: Control, problem: &ContactProblem) -> Self {
        let state = &reference.chain.state;
        let pairs = state.pressure.len();
        let pressed: Vec<bool> = state.pressure.iter().map(|&pressure| pressure > 0.0).collect();
        let [constant, slope] = [false, true].map(|of_slope| {
            [0, 1].map(|body| {
                let value = |pair: usize| {
                    let (depth, rise) = (rig.rubbed.depths[body][pair], rig.rubbed.slopes[body][pair]);
                    match (pressed[pair], of_slope) {
                        (true, true) => rise / state.pressure[pair],
                        (true, false) => depth - rise,
                        (false, true) => 0.0,
                        (false, false) => depth,
                    }
                };
                (0..pairs).map(value).collect::<Vec<f64>>()
            })
        });
        let slope = slope.map(|slope| spread(slope, &pressed, problem.frame.elements()));
        let slip = map([&rig.rubbed.work, &state.pressure], |[work, pressure]| {
            if pressure > 0.0 { work / pressure } else { 0.0 }
        });
        let slip = spread(slip, &pressed, problem.frame.elements());
        let slides = |pair: usize| pressed[pair] && rig.rubbed.slip[pair] == 0.0;
        let couples = problem.compliance.couples();
        let opened = match state.tangential.as_ref().filter(|_| couples) {
            Some(tangential) => reference.opened(problem, &tangential.traction),
            None => vec![0.0; pairs],
        };
        Self {
            constant,
            slope,
            reference: reference.chain.clone(),
            control,
            opened,
            sticks: problem.friction.is_some() && (0..pairs).any(slides),
            slip,
            dissipated: rig.rubbed.dissipated,
        }
    }

    /// Wears the bodies for a number of cycles in a number of steps, while the rate goes evenly from this
    /// one to another; by how much, relative to it, the pressures' part of the wear changes on the way.
    pub fn wear_on(
        &self,
        other: &Rate,
        rig: &mut Rig,
        (cycles, steps): (usize, usize),
        simulation: &Simulation,
        effort: &mut Effort,
    ) -> Result<f64, Error> {
        let problem = &simulation.problem;
        let pairs = problem.frame.len();
        let mut chain = self.reference.clone();
        chain.state.worn.clone_from(&rig.chain.state.worn);
        let progress = chain.state.progress;
        let leg = Leg { advance: 0.0, progress, control: self.control };
        let length = cycles as f64 / steps as f64;
        let (mut changed, mut made) = (0.0, 0.0);
        for step in 0..steps {
            let along = (step as f64 + 0.5) / steps as f64;
            let blend = |one: &[f64], two: &[f64]| {
                map([one, two], |[one, two]| (1.0 - along) * one + along * two)
            };
            let line = [0, 1].map(|body| {
                (
                    blend(&self.constant[body], &other.constant[body]),
                    blend(&self.slope[body], &other.slope[body]),
                )
            });
            let slip = blend(&self.slip, &other.slip);
            let opened = blend(&self.opened, &other.opened);
            let addition: Vec<f64> = map([&line[0].1, &line[1].1], |[one, two]| length * (one + two));
            let constant = map([&line[0].0, &line[1].0], |[one, two]| length * (one + two));
            let undeformed = chain.undeformed_gap(problem);
            let gap = map([&undeformed, &opened, &constant], |[gap, opened, constant]| {
                gap + opened + constant
            });
            let before = chain.state.pressure.clone();
            chain.meet(simulation, leg, &gap, &addition, &*problem.compliance, effort)?;
            let [work] = sum([&slip, &chain.state.pressure], |[slip, pressure]| [slip * pressure]);
            rig.chain.load_distance += length * work * problem.frame.element_area();
            let dissipated = (1.0 - along) * self.dissipated + along * other.dissipated;
            effort.dissipated[1] += length * dissipated;
            for pair in 0..pairs {
                let pressure = chain.state.pressure[pair];
                let mut total = 0.0;
                for body in 0..2 {
                    let (constant, slope) = (line[body].0[pair], line[body].1[pair]);
                    let depth = length * (constant + slope * pressure).max(0.0);
                    chain.state.worn[body][pair] += depth;
                    total += depth;
                }
                changed += (addition[pair] * (before[pair] - pressure)).powi(2);
                made += total * total;
            }
        }
        rig.chain.state.worn = chain.state.worn;
        Ok(if made > 0.0 { steps as f64 * (changed / made).sqrt() } else { 0.0 })
    }
}

/// Gives pairs that are not pressed the value of the nearest that are.
fn spread(mut field: Vec<f64>, pressed: &[bool], [nx, ny]: [usize; 2]) -> Vec<f64> {
    let mut known = pressed.to_vec();
    let mut rim: Vec<usize> = (0..known.len()).filter(|&pair| known[pair]).collect();
    while !rim.is_empty() {
        let mut next: Vec<(usize, f64, f64)> = vec![];
        let mut index = std::collections::HashMap::new();
        for &pair in &rim {
            let (x, y) = (pair % nx, pair / nx);
            let neighbours = [
                (x > 0).then(|| pair - 1),
                (x + 1 < nx).then(|| pair + 1),
                (y > 0).then(|| pair - nx),
                (y + 1 < ny).then(|| pair + nx),
            ];
            for neighbour in neighbours.into_iter().flatten().filter(|&pair| !known[pair]) {
                let at = *index.entry(neighbour).or_insert_with(|| {
                    next.push((neighbour, 0.0, 0.0));
                    next.len() - 1
                });
                next[at].1 += field[pair];
                next[at].2 += 1.0;
            }
        }
        rim = next.iter().map(|&(pair, ..)| pair).collect();
        for (pair, sum, count) in next {
            (field[pair], known[pair]) = (sum / count, true);
        }
    }
    field
}
