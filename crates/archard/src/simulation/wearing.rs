//! A contact that wears: the pressures at the end of an increment do the wear that they give way by.

use super::collector::{Collected, Collector, Foreseen};
use super::effort::Effort;
use super::error::Error;
use super::memory::{History, Increment};
use super::position::Position;
use super::setup::Simulation;
use crate::closed_form::flash_temperature::FAST;
use crate::compliance::WornLines;
use crate::frame::Part;
use crate::motion::Control;
use crate::numerics::vector;
use crate::problem::{ContactProblem, ContactState, Gap};

/// Times a step's wear is foreseen before it counts as not converged.
const PASSES: usize = 50;
/// How steep the energy may end, relative to how it began, on a way that is gone to its end.
const STEEPER: f64 = 0.5;
const HALVINGS: usize = 16;

impl History {
    /// The contact at the end of an increment in a position, from an undeformed gap (m), and the wear it makes.
    pub(super) fn contact_and_wear(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        position: &Position,
        (collector, undeformed): (&Collector<'_>, &[f64]),
        effort: &mut Effort,
    ) -> Result<Collected, Error> {
        let problem = &simulation.problem;
        let collect = |state: &ContactState| collector.collect(state, increment.advance, position);
        let mut made = collect(&self.state);
        for pass in 0..PASSES {
            let foreseen = made.foresee(&self.state.pressure);
            let shortens = collector.lines().is_none() && pass > 0;
            let from = shortens
                .then(|| (self.state.pressure.clone(), self.displacement.clone(), self.known));
            let gap = foreseen.gap_by_friction(undeformed, collector.lines());
            self.contact_wearing(simulation, increment, &gap, (collector, &foreseen), effort)?;
            made = collect(&self.state);
            if collector.agrees(&foreseen, &self.state, &made) {
                self.is_fast(problem)?;
                return Ok(made);
            }
            if let Some((pressure, mut displacement, known)) = from {
                if known != self.known {
                    effort.applications += 1;
                    problem.compliance.apply_normal(&pressure, &mut displacement);
                    self.find_displacement(problem, effort);
                }
                let from = (pressure, displacement);
                made = self.shorten(problem, increment, undeformed, from, made, &collect);
            }
        }
        Err(Error::NotConsistent {
            measure: problem.motion.progress,
            progress: increment.progress,
            passes: PASSES,
        })
    }

    /// Goes back on the way of pressures from earlier ones, as far as wear that rises more steeply than foreseen asks: to
    /// the least of the energy whose minimum the pressures at the end of the step are.
    ///
    /// Its derivative along the way, the gaps times the change of the forces, rises all the way.
    fn shorten(
        &mut self,
        problem: &ContactProblem,
        increment: Increment,
        undeformed: &[f64],
        (pressure, displacement): (Vec<f64>, Vec<f64>),
        made: Collected,
        collect: &dyn Fn(&ContactState) -> Collected,
    ) -> Collected {
        let measure = problem.frame.measure();
        let approach = match increment.control {
            Control::Load(_) => 0.0,
            Control::Approach(approach) => approach,
        };
        let ends = [pressure, self.state.pressure.clone()];
        let moved = [displacement, self.displacement.clone()];
        let at = |[one, other]: &[Vec<f64>; 2], way: f64| {
            vector::map([one, other], |[one, other]| one + way * (other - one))
        };
        let slope = |way: f64, made: &Collected| {
            let displacement = at(&moved, way);
            let pairs = made.pairs.as_ref();
            let term = |pair: usize| {
                let depth = pairs.map_or(0.0, |wear| wear.depth(pair));
                let closing = measure.closing.at(pair) * approach;
                let gap = undeformed[pair] + depth + displacement[pair] - closing;
                measure.weight.at(pair) * (ends[1][pair] - ends[0][pair]) * gap
            };
            (0..undeformed.len()).map(term).sum::<f64>()
        };
        let mut state = self.state.clone();
        let mut there = |way: f64| {
            state.pressure = at(&ends, way);
            let made = collect(&state);
            (slope(way, &made), made)
        };
        let before = there(0.0).0;
        if slope(1.0, &made) <= STEEPER * before.abs() {
            return made;
        }
        let (mut low, mut high, mut way) = (0.0, 1.0, 1.0);
        let mut found = made;
        for _ in 0..HALVINGS {
            way = 0.5 * (low + high);
            let (slope, made) = there(way);
            *(if slope > 0.0 { &mut high } else { &mut low }) = way;
            found = made;
        }
        self.state.pressure = at(&ends, way);
        self.displacement = at(&moved, way);
        found
    }

    /// Whether heat and friction settle, and the contact is passed fast enough, where laws go by the temperature.
    pub(super) fn is_fast(&self, problem: &ContactProblem) -> Result<(), Error> {
        if problem.grip(&self.state, |_| 0.0).is_err() {
            let passes = PASSES;
            let (measure, progress) = (problem.motion.progress, self.state.progress);
            return Err(Error::NotConsistent { measure, progress, passes });
        }
        let peclet = problem.flash_for_laws(&self.state).and_then(|flash| flash.peclet);
        match peclet.filter(|peclet| *peclet < FAST) {
            None => Ok(()),
            Some(peclet) => Err(Error::TooSlow {
                measure: problem.motion.progress,
                progress: self.state.progress,
                peclet,
            }),
        }
    }

    /// Deepest wear (m) that an advance under the present contact makes.
    pub fn deepest_wear(&self, problem: &ContactProblem, advance: f64) -> Result<f64, Error> {
        let position = Position::middle(problem, problem.motion.slip(advance));
        Ok(Collector::of(problem)?.collect(&self.state, advance, &position).deepest())
    }

    /// The contact under a gap (m) while wear gives way to the pressures.
    fn contact_wearing(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        gap: &[f64],
        (collector, foreseen): (&Collector<'_>, &Foreseen),
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let addition = foreseen.pair_slopes(gap.len());
        let wearing = (gap, &addition[..]);
        let Some((lines, slopes)) = collector.lines().zip(foreseen.line_slopes()) else {
            return self.contact(simulation, increment, wearing, &*problem.compliance, effort);
        };
        let pressure = self.state.pressure.clone();
        let weight = problem.frame.measure().weight;
        let [total] = vector::sum_with([weight], [&pressure], |[w], [pressure]| [w * pressure]);
        let worn = WornLines::new(&*problem.compliance, lines.flow, slopes, &pressure);
        if let Some(foreseen) = worn.foresee(gap, total, &pressure) {
            self.state.pressure = foreseen;
            self.known = Some(Part::none(problem.frame.elements()));
        }
        worn.add_wear(&self.state.pressure, 1.0, &mut self.displacement);
        self.contact(simulation, increment, wearing, &worn, effort)?;
        worn.add_wear(&self.state.pressure, -1.0, &mut self.displacement);
        if let Gap { values, part: Some(part) } = &mut self.state.gap {
            let within = part.cut(values);
            worn.add_wear(&self.state.pressure, 1.0, values);
            *values = part.pasted(&within, std::mem::take(values));
        }
        Ok(())
    }
}
