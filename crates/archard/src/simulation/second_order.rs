//! What makes steady rolling of second order in the size of the elements where pairs form rows.
//!
//! The upwind difference alone is of first order, for two reasons:
//!
//! - The edge of the contact falls somewhere inside the first pair of a row. To ask for stick on the passage to that
//!   pair is wrong by where. Its traction is a share of that of the pair behind instead, the ratio of their limits:
//!   next to the edge both grow with the root of the distance. Its slip is not asked for.
//! - Friction points along the slip at a pair, the difference gives the slip half a passage ahead. Where spin turns the
//!   slip on the way, pairs that slip go by the mean of the passage to them and that to the pair behind.

use std::iter::successors;

use super::memory::History;
use crate::frame::Flow;
use crate::friction::Map;
use crate::motion::Drives;
use crate::numerics::vector;
use crate::problem::{ContactProblem, GROWS};
use crate::solve::tangential::{Tie, TurningPair};

/// Pairs behind the one at the edge that stick at least where the trend of the first two goes on to it: the third keeps the edge
/// of slip, next to which tractions bend, away from them.
const STICKING: usize = 3;

/// Ties of the pairs at which particles come under these pressures (Pa) to the pairs behind, where the friction (Pa) that they
/// allow grows from the edge on, by shares of what the pairs bear at most (Pa). Scattered pairs have none.
pub(super) fn entries(
    flow: Flow<'_>,
    (pressure, allowed): (&[f64], &[f64]),
    limit: &[f64],
) -> Vec<Tie> {
    if !flow.has_rows() {
        return vec![];
    }
    let (direction, elements) = (flow.direction(), flow.frame().elements());
    let tie = |pair: usize| {
        let before = direction.ahead(pair, elements).map_or(0.0, |ahead| pressure[ahead]);
        let to = direction.back().ahead(pair, elements)?;
        let enters = before == 0.0 && pressure[pair] > 0.0;
        let grows = allowed[pair] <= GROWS * allowed[to];
        (enters && grows && limit[to] >= limit[pair] && limit[to] > 0.0).then(|| Tie {
            pair,
            to,
            share: limit[pair] / limit[to],
        })
    };
    (0..limit.len()).filter_map(tie).collect()
}

/// The same where the share of its limit that a pair bears goes on to the edge as it does from pair to pair behind: it is smooth
/// there. It follows from tractions (Pa) that were found where it is the same at both, and keeps their sign and their limits. Rows
/// in which no more than [`STICKING`] pairs stick have no trend to go on.
pub(super) fn continued(
    ties: &[Tie],
    flow: Flow<'_>,
    map: Map,
    (limit, [t1, t2]): (&[f64], [&[f64]; 2]),
) -> Vec<Tie> {
    let (back, elements) = (flow.direction().back(), flow.frame().elements());
    let sticks = |pair: usize| map.sticks([t1[pair], t2[pair]], limit[pair]);
    let continued = |tie: &Tie| {
        let row = successors(Some(tie.to), |pair| back.ahead(*pair, elements));
        let sticking: Vec<usize> = row.take(STICKING).take_while(|pair| sticks(*pair)).collect();
        let [near, far, _] = sticking[..] else { return *tie };
        let along = |pair: usize| (t1[near] * t1[pair] + t2[near] * t2[pair]) / limit[pair];
        if along(near) <= 0.0 {
            return *tie;
        }
        let trend = 2.0 - along(far) / along(near);
        Tie { share: tie.share * trend.clamp(0.0, 1.0), ..*tie }
    };
    ties.iter().map(continued).collect()
}

/// Whether the slip turns on the way through the contact.
pub(super) fn turns(drives: &Drives, flow: Flow<'_>) -> bool {
    drives.spin != 0.0 && flow.has_rows()
}

impl History {
    /// The pairs that slip, each with the one behind.
    pub(super) fn turning(&self, problem: &ContactProblem, flow: Flow<'_>) -> Vec<TurningPair> {
        let known = self.state.tangential.as_ref().zip(problem.friction.as_ref());
        let Some((tangential, friction)) = known else { return vec![] };
        let pressure = &self.state.pressure;
        let slips = |pair: &usize| {
            let limit = tangential.grip.at(*pair) * friction.limit(pressure[*pair]);
            limit > 0.0 && !tangential.sticks(problem, pressure, *pair)
        };
        let (back, elements) = (flow.direction().back(), flow.frame().elements());
        let turning = |pair| Some(TurningPair { pair, behind: back.ahead(pair, elements)? });
        (0..pressure.len()).filter(slips).filter_map(turning).collect()
    }
}

/// Slips of unequal passages as if each were of the mean length: a creepage is one slip then.
pub(super) fn to_mean_passages(flow: Flow<'_>, slip: &mut [f64]) {
    let advance = flow.advance();
    if let Some(advances) = flow.advances() {
        vector::update(slip, [&advances], |slip, [own]| slip * advance / own);
    }
}

/// The reverse of [`to_mean_passages`].
pub(super) fn to_own_passages(flow: Flow<'_>, slip: &mut [f64]) {
    let advance = flow.advance();
    if let Some(advances) = flow.advances() {
        vector::update(slip, [&advances], |slip, [own]| slip * own / advance);
    }
}
