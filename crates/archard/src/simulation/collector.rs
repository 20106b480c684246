//! How rubbing is collected into wear.
//!
//! Wear belongs to a surface, and surfaces move past each other. Where the surface of a body *stays*, each of its points
//! is under one pair and wears by what that pair goes through. Where it *passes*, its points go through all pairs on a
//! line along the motion, again and again, and [wear alike](super::passing).

use super::Error;
use super::passing::{Collected, Lines};
use crate::motion::Motion;
use crate::numerics::vector;
use crate::problem::{ContactProblem, ContactState};
use crate::wear::Rubbing;

/// Disagreement of the wear that a step foresaw with the wear it made, relative to the deepest: where laws alone are
/// linearised, and where friction is too, which in rolling changes with the wear.
const OF_LAWS: f64 = 1e-9;
const OF_LINES: f64 = 1e-6;
const OF_FRICTION: f64 = 0.02;

/// Collects the wear of both bodies.
#[derive(Debug, Clone, Copy)]
pub(super) struct Collector<'a> {
    problem: &'a ContactProblem,
    /// Which bodies stay.
    stays: [bool; 2],
    /// The lines of those that pass.
    lines: Option<Lines<'a>>,
}

/// The wear (m) of a step as straight lines in the pressures (Pa).
pub(super) struct Foreseen {
    /// Of surfaces that stay, one value a pair: the depth at zero pressure (m), and its slope (m/Pa).
    pairs: Option<[Vec<f64>; 2]>,
    /// Of surfaces that pass, the same, one value a line.
    lines: Option<[Vec<f64>; 2]>,
}

impl<'a> Collector<'a> {
    /// Of a motion in steps of wear.
    ///
    /// # Errors
    /// If surfaces do not pass along the frame.
    pub fn of(problem: &'a ContactProblem) -> Result<Self, Error> {
        let (bodies, direction, passages) = match &problem.motion {
            Motion::Rolling(rolling) => ([true; 2], rolling.direction, 1.0),
            Motion::Sliding | Motion::Shift(_) => {
                return Ok(Self { problem, stays: [true; 2], lines: None });
            }
        };
        let flow = problem.frame.flow(direction)?;
        let lines = Some(Lines { problem, flow, bodies, passages });
        Ok(Self { problem, stays: bodies.map(|passes| !passes), lines })
    }

    /// The lines of surfaces that pass.
    pub fn lines(&self) -> Option<Lines<'a>> {
        self.lines
    }

    /// What the lines wear under the contact as it is.
    pub fn collect(&self, state: &ContactState) -> Option<Collected> {
        self.lines.map(|lines| Collected::of(state, lines))
    }

    /// Whether any body stays that wears.
    fn any_stays(&self) -> bool {
        (0..2).any(|body| self.stays[body] && self.problem.bodies[body].wear.is_some())
    }

    /// The wear of an advance (the motion's unit) about the contact as it is, and what its lines wear.
    pub fn foresee(
        &self,
        state: &ContactState,
        collected: Option<&Collected>,
        advance: f64,
    ) -> Foreseen {
        let pairs = self.any_stays().then(|| {
            let line = |&pressure: &f64| {
                let rubbing = self.rubbing(pressure, advance);
                let slope = self.problem.wear_slope(rubbing, self.stays);
                (self.depth(rubbing) - slope * pressure, slope)
            };
            let (constant, slope) = state.pressure.iter().map(line).unzip();
            [constant, slope]
        });
        let lines = self.lines.zip(collected).map(|(lines, collected)| {
            let times = advance * lines.passages;
            let slope = collected.slopes.iter().map(|slope| times * slope).collect();
            let constant = |line: usize| {
                times * (collected.total(line) - collected.slopes[line] * collected.pressures[line])
            };
            [(0..collected.pressures.len()).map(constant).collect(), slope]
        });
        Foreseen { pairs, lines }
    }

    /// Whether a step wears as it was foreseen.
    pub fn agrees(
        &self,
        foreseen: &Foreseen,
        state: &ContactState,
        collected: Option<&Collected>,
        advance: f64,
    ) -> bool {
        let pairs = foreseen.pairs.as_ref().is_none_or(|line| {
            let of = |pair: usize| {
                let pressure = state.pressure[pair];
                (pressure, self.depth(self.rubbing(pressure, advance)))
            };
            lies_on(line, (0..state.pressure.len()).map(of), OF_LAWS)
        });
        let lines = self.lines.zip(collected).zip(foreseen.lines.as_ref());
        pairs
            && lines.is_none_or(|((lines, collected), line)| {
                let times = advance * lines.passages;
                let of = |line: usize| (collected.pressures[line], times * collected.total(line));
                let rolls = self.problem.motion.rolling().is_some();
                let allowed = if rolls { OF_FRICTION } else { OF_LINES };
                lies_on(line, (0..collected.pressures.len()).map(of), allowed)
            })
    }

    /// Wears both bodies by an advance (the motion's unit) under the contact as it is.
    pub fn wear(&self, state: &mut ContactState, collected: Option<&Collected>, advance: f64) {
        let ContactState { pressure, worn, .. } = state;
        if self.any_stays() {
            for (pair, &pressure) in pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
                let depths = self.problem.wear_depths(self.rubbing(pressure, advance), self.stays);
                worn.iter_mut().zip(depths).for_each(|(worn, depth)| worn[pair] += depth);
            }
        }
        let Some((lines, collected)) = self.lines.zip(collected) else { return };
        let times = advance * lines.passages;
        for (line, depths) in lines.flow.planes().iter().zip(&collected.depths) {
            for one in &line.passages {
                for (worn, depth) in worn.iter_mut().zip(depths) {
                    worn[one.pair] += times * one.share * depth;
                }
            }
        }
    }

    /// Deepest wear (m) that an advance under the contact as it is makes.
    pub fn deepest(&self, state: &ContactState, advance: f64) -> f64 {
        let depth = |&pressure: &f64| self.depth(self.rubbing(pressure, advance));
        let pairs = match self.any_stays() {
            true => state.pressure.iter().map(depth).fold(0.0, f64::max),
            false => 0.0,
        };
        let lines = self.lines.zip(self.collect(state));
        let lines = lines.map(|(lines, made)| advance * lines.passages * made.deepest());
        pairs + lines.unwrap_or(0.0)
    }

    /// What a pair of surfaces that stay goes through.
    fn rubbing(&self, pressure: f64, advance: f64) -> Rubbing {
        self.problem.rubbing(pressure, self.problem.motion.slip(advance))
    }

    /// Depth (m) worn off the bodies that stay.
    fn depth(&self, rubbing: Rubbing) -> f64 {
        self.problem.wear_depths(rubbing, self.stays).iter().sum()
    }
}

impl Foreseen {
    /// The gap (m) of surfaces at zero pressure, opened by what wears then.
    pub fn opened(&self, gap: &[f64], lines: Option<Lines<'_>>) -> Vec<f64> {
        let mut opened = match &self.pairs {
            Some([constant, _]) => vector::map([gap, constant], |[gap, constant]| gap + constant),
            None => gap.to_vec(),
        };
        if let (Some([constant, _]), Some(Lines { flow, .. })) = (&self.lines, lines) {
            for (line, depth) in flow.planes().iter().zip(constant) {
                line.passages.iter().for_each(|one| opened[one.pair] += one.share * depth);
            }
        }
        opened
    }

    /// How pairs give way by wear to their own pressure (m/Pa).
    pub fn pair_slopes(&self, pairs: usize) -> Vec<f64> {
        self.pairs.as_ref().map_or_else(|| vec![0.0; pairs], |[_, slope]| slope.clone())
    }

    /// How lines do to the pressure (Pa) on one of their pairs.
    pub fn line_slopes(&self) -> Option<&[f64]> {
        self.lines.as_ref().map(|[_, slope]| &slope[..])
    }
}

/// Whether depths (m) at pressures (Pa) lie on straight lines, relative to the deepest.
fn lies_on(
    [constant, slope]: &[Vec<f64>; 2],
    found: impl Iterator<Item = (f64, f64)>,
    allowed: f64,
) -> bool {
    let (mut error, mut deepest) = (0.0f64, 0.0f64);
    for ((constant, slope), (pressure, depth)) in constant.iter().zip(slope).zip(found) {
        error = error.max((constant + slope * pressure - depth).abs());
        deepest = deepest.max(depth);
    }
    error <= allowed * deepest
}
