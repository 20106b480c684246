//! The edge of the contact, between the pairs of a uniform grid.
//!
//! The pressures that a grid computes next to a smooth edge depend on where the edge lies between two pairs, linearly: with
//! pressures K s^(1/2) at a distance s from the edge, the last pair under pressure bears
//! [`PRESSED`] K h^(1/2) (t + [`FIRST`]) and the gap of the first open one is [`OPEN`] K h^(3/2) (1 - [`FIRST`] - t) / E*, t the
//! distance of the edge from the centre of the former over that h of the centres. Both together say what t is. The constants are
//! of the lattice alone: `tests/verification/edges.rs` finds them on a long line of contact.
//!
//! Where a body has an edge of its own and the last pair bears nearly as much as the one behind, the contact ends there. That edge
//! is taken to lie half way.
//!
//! An edge that wears grows into surfaces that are worn behind it and not before it. There pressures rise by another power:
//! K s^n with cot(pi n) = E* w' / (2 p), where w' is the slope of the wear behind the edge and p the pressure there, so that the
//! gap opens by the power 1 + n. It is continued from two open pairs.

use std::borrow::Cow;
use std::f64::consts::PI;
use std::ops::Range;

use super::{ContactProblem, ContactState};
use crate::body::{Body, contact_modulus};
use crate::frame::{ContactFrame, extent};

/// Pressure of the last pair under pressure, gap of the first open one, and how far behind the centre of a pair the edge lies
/// where it bears nothing.
const PRESSED: f64 = 0.9542;
/// See [`PRESSED`].
const OPEN: f64 = 1.646;
/// See [`PRESSED`].
const FIRST: f64 = 0.1747;
/// Largest share of the pressure behind that the last pair bears where pressures grow with the root of the distance from an edge:
/// 0.71 where the edge is at most an element away, and pressures at the edge are computed to a tenth.
pub(crate) const GROWS: f64 = 0.8;
/// Steepness of the wear, cot(pi n), up to which an edge counts as smooth: n is within 0.016 of a half. Chosen: with 0.02 or 0.1
/// areas of a worn pin change by less than half of their error.
const SMOOTH: f64 = 0.05;
/// Pairs on either side of an edge that say where it lies, and over which its direction is averaged, by the weights of a Gaussian
/// with a variance of as many.
const REACH: usize = 2;

impl ContactState {
    /// Area (m^2) in contact: on uniform frames up to the edge between pairs; elsewhere, and where it is less than four
    /// pairs wide, that of all pairs under pressure. No less than what bears the load under the hardness of a body that yields.
    pub fn contact_area(&self, problem: &ContactProblem) -> f64 {
        let (frame, touches) = (&problem.frame, |pair: usize| self.pressure[pair] > 0.0);
        let area = match self.edge(problem) {
            Some(edge) => frame.area_up_to(touches, |from, to| edge.between([from, to])),
            None => frame.area_where(touches),
        };
        area.max(frame.integrate(&self.pressure) / problem.hardness())
    }

    /// The edge of the contact between pairs; `None` where it is that of the elements.
    pub(crate) fn edge<'a>(&'a self, problem: &'a ContactProblem) -> Option<Edge<'a>> {
        let frame = &problem.frame;
        let modulus = contact_modulus(problem.bodies.each_ref().map(Body::uppermost));
        if !frame.is_uniform() || !modulus.is_finite() {
            return None;
        }
        let contact = extent(frame.elements(), |pair| self.pressure[pair] > 0.0)?;
        let few = |axis: usize| frame.elements()[axis] > 1 && contact[axis].len() < 2 * REACH;
        if few(0) || few(1) {
            return None;
        }
        let around = [0, 1].map(|axis| {
            let Range { start, end } = contact[axis];
            start.saturating_sub(REACH)..(end + REACH).min(frame.elements()[axis])
        });
        let known = self.gap.part.is_none_or(|part| part.holds(&around));
        let gap = if known { Cow::Borrowed(&self.gap.values[..]) } else { self.gap_of(problem) };
        let edged = problem.bodies.iter().any(|body| body.profile.sharpest() == 0.0);
        Some(Edge { frame, state: self, gap, modulus, edged })
    }
}

/// The edge of a contact.
pub(crate) struct Edge<'a> {
    frame: &'a ContactFrame,
    state: &'a ContactState,
    /// Gap (m), one value a pair.
    gap: Cow<'a, [f64]>,
    modulus: f64,
    /// Whether a body has an edge of its own.
    edged: bool,
}

impl Edge<'_> {
    /// Where the edge lies between a pair under pressure and an open neighbour: the distance from the former over that of both.
    pub fn between(&self, [inside, outside]: [usize; 2]) -> f64 {
        let axis = usize::from(inside.abs_diff(outside) != 1 || self.frame.elements()[0] == 1);
        let spacing = self.frame.spacing()[axis];
        let gap = |pair: usize| self.gap[pair].max(0.0);
        let behind = self.after(outside, inside, axis);
        let behind = behind.filter(|&pair| self.state.pressure[pair] > 0.0);
        let steepness = behind.map_or(0.0, |behind| self.steepness(inside, behind, spacing));
        if steepness > SMOOTH {
            let power = f64::atan2(1.0, steepness) / PI;
            let far = self.after(inside, outside, axis).map_or(0.0, gap);
            let [near, far] = [gap(outside), far].map(|gap| gap.powf(1.0 / (1.0 + power)));
            if far > near {
                return (1.0 - near / (far - near)).clamp(-FIRST, 1.0);
            }
        }
        let pressure = &self.state.pressure;
        let falls = |behind: usize| pressure[inside] <= GROWS * pressure[behind];
        if self.edged && behind.is_some_and(|behind| !falls(behind)) {
            return 0.5;
        }
        let pressed = pressure[inside] / PRESSED * self.turned(inside, axis);
        let open = gap(outside) * self.modulus / (OPEN * spacing);
        let both = pressed + open;
        if both > 0.0 { pressed / both - FIRST } else { -FIRST }
    }

    /// The pair on the line from one to its neighbour along an axis that follows; `None` beyond the frame.
    fn after(&self, from: usize, to: usize, axis: usize) -> Option<usize> {
        let [columns, rows] = self.frame.elements();
        let along = |pair: usize| [pair % columns, pair / columns][axis];
        let next = (2 * along(to)).checked_sub(along(from))?;
        (next < [columns, rows][axis]).then_some((2 * to).wrapping_sub(from))
    }

    /// How much less an edge is worn than the pair behind, over what pressures rise by from there: cot(pi n), with n the power of
    /// the distance by which they do. Zero where wear does not fall to the edge.
    fn steepness(&self, inside: usize, behind: usize, spacing: f64) -> f64 {
        let slope = (self.state.worn_at(behind) - self.state.worn_at(inside)).max(0.0) / spacing;
        0.5 * self.modulus * slope / self.state.pressure[behind]
    }

    /// Cosine of the angle between an axis and the normal of the edge at a pair.
    fn turned(&self, pair: usize, axis: usize) -> f64 {
        let elements = self.frame.elements();
        let spacing = self.frame.spacing();
        let middle = [pair % elements[0], pair / elements[0]].map(|index| index as i64);
        let mut normal = [0.0; 2];
        let reach = REACH as i64;
        for y in -reach..=reach {
            for x in -reach..=reach {
                let at = [0, 1].map(|axis| {
                    (middle[axis] + [x, y][axis]).clamp(0, elements[axis] as i64 - 1) as usize
                });
                if self.state.pressure[at[0] + elements[0] * at[1]] > 0.0 {
                    let weight = (-0.5 * (x * x + y * y) as f64 / REACH as f64).exp();
                    normal[0] += weight * x as f64 / spacing[0];
                    normal[1] += weight * y as f64 / spacing[1];
                }
            }
        }
        let length = normal[0].hypot(normal[1]);
        if length > 0.0 { (normal[axis] / length).abs() } else { 1.0 }
    }
}
