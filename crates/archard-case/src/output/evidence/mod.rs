//! What a run leaves to be judged: numbers collected from its reports, each against what was prescribed.
//!
//! Nothing here knows a bound: [`verdict`](crate::verdict) makes lines of the numbers.

mod edges;
mod extent;
mod limits;
mod roughness;
mod stations;
mod work;

use serde::{Deserialize, Serialize};

use crate::verdict::{self, Accuracy, Verdict};
use archard::body::Body;
use archard::estimate::Subject;
use archard::motion::{Control, Stepping};
use archard::problem::ContactProblem;
use archard::simulation::Report;
use archard::simulation::history::{ERROR, WORN_SECTION, WORN_VOLUME, number, of_body};

use archard::numerics::WRITTEN;
use edges::Edges;
use limits::Limits;
pub(crate) use stations::Stations;
use work::Cycle;

/// The numbers so far; the worst of all reports where nothing else is said.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Evidence {
    /// Load or approach off the one prescribed, relative to it.
    load: Option<f64>,
    /// Share of the load on the edges of the frame, and the number of pairs that bear it.
    edges: Option<Edges>,
    /// The pairs there, once they were looked for, and how many pairs the frame had then.
    border: Option<(usize, Vec<usize>)>,
    /// What is left of the balance of forces and of moments on bodies whose equations were solved.
    balance: Option<[f64; 2]>,
    /// By how much compliances that are approximated miss displacements, relative to the largest.
    missed: Option<f64>,
    /// The same of bodies that bear the contact on their own tetrahedra.
    carried: Option<f64>,
    /// Elements across the contact at the first output that bears a load.
    first: Option<f64>,
    /// Sizes (m) of the elements that the run went through, and how many lay across the contact when it was largest there.
    largest: Vec<(f64, f64)>,
    /// Elements across the stick zone at the end of bodies that are shifted; `None` where nothing sticks, or all does.
    stick: Option<f64>,
    /// Error of the division into steps at the end, and the tolerance asked for.
    time: Option<[f64; 2]>,
    /// Share of the solves that did not settle on what closing pairs slide before they touch.
    touch: Option<f64>,
    /// Work of the motion in a cycle against what friction dissipated.
    energy: Option<f64>,
    cycle: Cycle,
    /// Worn volume, or section, against what the prescribed load, or the dissipated energy, wears.
    volume: Option<f64>,
    /// Alternation and spikes of the pressures at outputs, relative to the largest.
    roughness: Option<f64>,
    /// Estimated errors.
    accuracy: Option<Accuracy>,
    worst_output: Option<f64>,
    /// The smallest Peclet number of a contact that is warmed.
    peclet: Option<f64>,
    /// How near the run comes to the limits of the theory.
    limits: Limits,
    /// What the stations left out of a table lose.
    stations: Option<Stations>,
}

impl Evidence {
    /// Takes up a report and its row of the history.
    pub fn take(&mut self, report: &Report<'_>, row: &[(String, f64)]) {
        let Report { problem, state, effort, .. } = report;
        worst(&mut self.load, missing(report));
        for (_, force, moment) in problem.compliance.balance() {
            let [known_force, known_moment] = self.balance.unwrap_or([0.0; 2]);
            self.balance = Some([force.max(known_force), moment.max(known_moment)]);
        }
        if report.output {
            let known = if carried(problem) { &mut self.carried } else { &mut self.missed };
            worst(known, problem.compliance.missed(&state.tractions()));
        }
        // Frames grow.
        let border = match self.border.take() {
            Some((pairs, border)) if pairs == problem.frame.len() => border,
            _ => edges::border(problem),
        };
        if let Some(edges) = edges::of(&problem.frame, &border, &state.pressure)
            && self.edges.is_none_or(|known| edges.share >= known.share)
        {
            self.edges = Some(edges);
        }
        self.border = Some((problem.frame.len(), border));
        if let Some(across) = extent::across(problem, |pair| state.pressure[pair] > 0.0) {
            if report.output {
                self.first.get_or_insert(across);
            }
            let element = problem.frame.spacing()[0];
            match self.largest.last_mut() {
                Some((known, largest)) if (*known / element - 1.0).abs() < WRITTEN => {
                    *largest = largest.max(across);
                }
                _ => self.largest.push((element, across)),
            }
        }
        let shifted = problem.motion.increments().is_some();
        self.stick = state.tangential.as_ref().filter(|_| shifted).and_then(|tangential| {
            let sticks = |pair: usize| tangential.sticks(problem, &state.pressure, pair);
            let slips = |pair: usize| state.pressure[pair] > 0.0 && !sticks(pair);
            let partial = (0..problem.frame.len()).any(slips);
            extent::across(problem, sticks).filter(|_| partial)
        });
        self.time = match (report.stepping, effort.time_error) {
            // An accuracy that is asked for has a line of its own.
            (Stepping::Tolerance(tolerance), Some(error)) if report.companions.is_none() => {
                Some([error, tolerance])
            }
            _ => None,
        };
        self.accuracy = report.companions.map(|companions| {
            let error = number(row, ERROR).unwrap_or(f64::NAN);
            if report.output {
                worst(&mut self.worst_output, Some(error));
            }
            Accuracy {
                error,
                largest: self.worst_output.unwrap_or_default(),
                asked: companions.asked,
                worst: companions.worst(row).map(|(column, _)| column),
                other: companions.worst_uncounted(row).filter(|(_, other)| *other > error),
            }
        });
        self.touch =
            (effort.unsettled > 0).then(|| effort.unsettled as f64 / effort.solves.max(1) as f64);
        worst(&mut self.energy, self.cycle.take(report, row));
        self.volume = volume(report, row);
        let flash = problem.flash(state);
        self.limits.take(report, flash.as_ref());
        if let Some(peclet) = flash.and_then(|flash| flash.peclet) {
            self.peclet = Some(self.peclet.map_or(peclet, |known| known.min(peclet)));
        }
        if report.output {
            let found = match carried(problem) {
                true => problem.alone(&state.pressure),
                false => roughness::of(problem, state),
            };
            worst(&mut self.roughness, found);
        }
        self.stations = problem.motion.table().and_then(Stations::of);
    }

    /// The lines that follow.
    pub fn verdict(&self) -> Verdict {
        let balance = self.balance.map(|[force, moment]| verdict::balance(force, moment));
        let lines = [
            self.load.map(verdict::load),
            self.edges.map(|Edges { share, pairs }| verdict::edges(share, pairs)),
            self.first.map(verdict::first_contact),
            self.largest.iter().map(|(_, across)| *across).reduce(f64::min).map(verdict::contact),
            self.stick.map(verdict::stick_zone),
            self.time.map(|[error, tolerance]| verdict::time(error, tolerance)),
            self.accuracy.as_ref().map(verdict::accuracy),
            self.touch.map(verdict::touch),
            self.energy.map(verdict::energy),
            self.volume.map(verdict::volume),
            self.roughness.map(verdict::roughness),
            self.peclet.map(verdict::heat),
            self.missed.map(verdict::image),
            self.carried.map(verdict::mesh),
        ];
        let balance = balance.into_iter().flatten();
        let width = self.largest.iter().map(|(element, across)| element * across);
        let width = width.reduce(f64::min);
        let stations = self.stations.iter().flat_map(|stations| stations.lines(width));
        let lines = lines.into_iter().flatten().chain(balance).chain(stations);
        Verdict { lines: lines.chain(self.limits.lines()).collect() }
    }
}

/// Whether tetrahedra inside a body bear the contact.
fn carried(problem: &ContactProblem) -> bool {
    problem.bodies.iter().any(Body::carries)
}

/// Keeps the larger of two numbers; what is not a number stays.
fn worst(known: &mut Option<f64>, found: Option<f64>) {
    if let Some(found) = found {
        *known = Some(keep(*known, found));
    }
}

/// The larger of two numbers, or the one that is not a number.
fn keep(known: Option<f64>, found: f64) -> f64 {
    known.filter(|known| *known >= found || known.is_nan()).unwrap_or(found)
}

/// Load or approach off the one prescribed, relative to it; where nothing is prescribed, whether anything is there.
fn missing(report: &Report<'_>) -> Option<f64> {
    let state = report.state;
    let (prescribed, found) = match report.prescribed {
        Control::Load(load) => (load, state.load),
        Control::Approach(approach) => (approach, state.approach),
    };
    match (prescribed == 0.0, report.prescribed) {
        (true, Control::Load(_)) => Some(if found == 0.0 { 0.0 } else { f64::INFINITY }),
        (true, Control::Approach(_)) => None,
        (false, _) => Some((found / prescribed - 1.0).abs()),
    }
}

/// What worn volumes or sections are over the wear coefficient: in sliding F s (N m), in rolling the work of the creepages
/// over the coefficient of friction (N), in cycles the dissipated energy over it. `None` where that does not hold.
pub(super) fn worn_over_coefficient(report: &Report<'_>) -> Option<f64> {
    let Report { problem, effort, .. } = report;
    if !problem.frame.is_plane() {
        // Pressures in other directions than the load's wear too.
        return None;
    }
    if problem.motion.driven(0.0).is_some() && problem.compliance.couples() {
        // Friction shifts the pressures of unlike bodies, whose moment does work as well.
        return None;
    }
    if !ends_a_cycle(problem, report.state.progress) {
        return None;
    }
    match problem.motion.increments() {
        Some(shift) if shift.end_pressure => None,
        Some(_) => Some(effort.dissipated[1] / Subject::from(*problem).friction_coefficient()?),
        None => Some(effort.load_distance),
    }
}

/// Worn volume or section off [what follows](worn_over_coefficient) with the load prescribed; the larger of both bodies.
/// `None` where laws are not so simple, or nothing has worn.
fn volume(report: &Report<'_>, row: &[(String, f64)]) -> Option<f64> {
    let Report { problem, .. } = report;
    let subject = Subject::from(*problem);
    let expected = worn_over_coefficient(report)?;
    let off = |body: usize| {
        let k = subject.wear_coefficient(body)?;
        let name = &problem.bodies[body].name;
        let columns = [WORN_VOLUME, WORN_SECTION].map(|column| of_body(column, name));
        let worn = columns.iter().find_map(|column| number(row, column))?;
        (k * expected > 0.0).then(|| (worn / (k * expected) - 1.0).abs())
    };
    let mut both = None;
    (0..2).for_each(|body| worst(&mut both, off(body)));
    both
}

/// Whether whole cycles are done, which count as dissipated; always where there are none.
fn ends_a_cycle(problem: &ContactProblem, progress: f64) -> bool {
    problem.motion.increments().is_none_or(|shift| {
        let cycles = progress / shift.period();
        (cycles - cycles.round()).abs() < WRITTEN
    })
}

#[cfg(test)]
mod tests;
