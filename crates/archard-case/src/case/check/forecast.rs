//! What to expect of a run, and what it costs.

use std::fmt;

use super::cycles::Cycles;
use super::equivalent::Equivalent;
use super::expected::{write_contact, write_wear};
use super::finite::Finiteness;
use super::footprint::memory;
use super::surfaces::Surfaces;
use super::words::{length, three};
use super::yielding::YieldLimit;
use super::{Parts, foreseen, size};
use crate::case::definition::BodyCase;
use crate::verdict::Verdict;
use archard::body::mesh::MeshSurface;
use archard::body::{Elasticity, Finite};
use archard::estimate::{Estimate, Estimator};
use archard::motion::{Sequence, Stepping};
use archard::simulation::solves_of_a_step;

/// What to expect of a run.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Forecast {
    /// What closed forms expect at the end of the motion.
    pub estimate: Estimate,
    /// Elements across the unworn contact along x and y; `None` where there is no closed form.
    pub cells_across: Option<[f64; 2]>,
    /// Wear coefficients by pressure and by work, of bodies for which one follows from the other.
    pub equivalents: Vec<Equivalent>,
    /// Where bodies of a known hardness yield first, without friction.
    pub yieldings: Vec<YieldLimit>,
    /// Cycles; `None` where the bodies are not pressed and shifted step by step.
    pub cycles: Option<Cycles>,
    /// How the surfaces of bodies that fret meet, where closed forms tell the width of the contact.
    pub surfaces: Option<Surfaces>,
    /// Contact solves.
    pub solves: Solves,
    /// Number of pairs.
    pub pairs: usize,
    /// Meshed bodies that are computed by boundary elements, with their numbers of unknowns.
    pub unknowns: Vec<(String, usize)>,
    /// What says how meshed bodies deform, in words: the body, that, and why where the case does not say so.
    pub ways: Vec<(String, &'static str, Option<&'static str>)>,
    /// Bodies whose mesh is a file, with their surfaces.
    pub files: Vec<(String, Vec<MeshSurface>)>,
    /// What meshed bodies may differ by from half-spaces; empty where no closed form says.
    pub finiteness: Vec<Finiteness>,
    /// Memory (bytes), an estimate.
    pub memory: f64,
    /// Operations on numbers to factorise and condense the equations of meshed bodies.
    pub operations: f64,
    /// What of the verdict on a run can be foreseen.
    pub verdict: Verdict,
}

/// A number of contact solves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Solves {
    /// Known.
    Exactly(u64),
    /// Known but for steps that take several: pressures, friction and wear are made to agree.
    AtLeast(u64),
    /// Estimated, where steps are chosen by their error.
    About(u64),
}

impl Default for Solves {
    fn default() -> Self {
        Self::Exactly(0)
    }
}

impl Forecast {
    pub(super) fn of(parts: &Parts<'_>) -> Self {
        let estimate = parts.estimate(&Estimator::default(), parts.schedule.extent);
        let spacing = parts.case.frame.spacing();
        let [nx, ny] = parts.case.frame.elements;
        let forecast = Self {
            estimate,
            cells_across: estimate.contact.map(|contact| {
                let cells = |axis: usize| 2.0 * contact.semi_axes[axis] / spacing[axis];
                [cells(0).min(nx as f64), cells(1).min(ny as f64)]
            }),
            equivalents: Equivalent::of(parts),
            yieldings: YieldLimit::of(parts),
            cycles: Cycles::of(parts),
            surfaces: Surfaces::of(parts),
            solves: Solves::of(parts),
            pairs: parts.pairs(),
            unknowns: unknowns(parts),
            ways: ways(parts),
            files: files(parts),
            finiteness: Finiteness::of(parts, estimate.contact.as_ref()),
            memory: memory(parts),
            operations: parts.meshed().map(|(_, finite)| size(finite).operations()).sum(),
            verdict: Verdict::default(),
        };
        Self { verdict: foreseen::verdict(parts, &forecast), ..forecast }
    }
}

/// Unknowns of the bodies that are computed by boundary elements.
fn unknowns(parts: &Parts<'_>) -> Vec<(String, usize)> {
    let solved = |(_, finite): &(_, &Finite)| finite.elasticity != Elasticity::HalfSpace;
    let meshed = parts.meshed().filter(solved);
    meshed.map(|(body, finite)| (body.name.clone(), size(finite).unknowns)).collect()
}

/// What says how meshed bodies deform.
fn ways(parts: &Parts<'_>) -> Vec<(String, &'static str, Option<&'static str>)> {
    let way = |body: &BodyCase| {
        let finite = body.finite.as_ref()?;
        let way = match finite.elasticity {
            Elasticity::Image => "half-space and image field",
            Elasticity::BoundaryElements => "mesh around its zone",
            Elasticity::FiniteElements => "finite elements inside",
            Elasticity::Reduced => "compliance from a file",
            Elasticity::HalfSpace => "half-space on its mesh",
        };
        Some((body.name.clone(), way, finite.why))
    };
    parts.case.bodies.iter().filter_map(way).collect()
}

/// The surfaces of bodies whose mesh is a file.
fn files(parts: &Parts<'_>) -> Vec<(String, Vec<MeshSurface>)> {
    let of = |body: &BodyCase| Some((body.name.clone(), body.finite.as_ref()?.listed()?));
    parts.case.bodies.iter().filter_map(of).collect()
}

impl Solves {
    /// One for the contact before a motion that starts under load, and one a step.
    pub(in crate::case) fn of(parts: &Parts<'_>) -> Self {
        if let (Some(shift), Some(cycles)) = (parts.motion.increments(), Cycles::of(parts)) {
            return cycles.solves(parts, shift);
        }
        let first = u64::from(!parts.schedule.ramped);
        let rolling = parts.motion.driven(0.0);
        let wears = rolling.is_some()
            && parts.motion.sequence == Sequence::Steady
            && parts.schedule.extent > 0.0
            && parts.wears();
        let coupled = rolling.is_some() && parts.friction.is_some() && !parts.alike();
        match parts.schedule.stepping {
            Stepping::Implicit(step) | Stepping::Explicit(step) => {
                let steps = (parts.schedule.extent / step - 1e-9).ceil() as u64;
                let solves = first + steps * of_a_step(parts);
                // How far surfaces swing depends on what the bodies give way.
                match (parts.motion.amplitude(), wears || coupled) {
                    (Some(_), _) => Self::About(solves),
                    (None, true) => Self::AtLeast(solves),
                    (None, false) => Self::Exactly(solves),
                }
            }
            Stepping::Jumps(_) | Stepping::ToOutputs => Self::AtLeast(first),
            Stepping::Tolerance(tolerance) => {
                let outputs = parts.case.output.places(parts.schedule.extent).len();
                let law = match (rolling, parts.motion.amplitude()) {
                    (Some(_), _) => IN_ROLLING,
                    (None, Some(_)) => WHERE_SURFACES_SWING,
                    (None, None) => WHERE_ALL_SLIDES,
                };
                let solves = by_error(law, tolerance, outputs);
                Self::About(first + (solves - first) * of_a_step(parts))
            }
        }
    }
}

/// Solves of steps chosen by error: those that no tolerance spares, and those over the inverse root of the tolerance.
type Law = [f64; 2];

/// The column `solves` of `pin_on_disc` with its ten outputs ended at 49, 58, 79, 133 and 259 for tolerances of 1e-2, 3e-3, 1e-3,
/// 3e-4 and 1e-4 (60 x 60 elements: 49, 58, 79, 133 and 217), which the sum meets within a seventh. A tenth or ten times the
/// distance changed it by up to a third.
const WHERE_ALL_SLIDES: Law = [24.0, 2.1];
/// The steps of `mccoll_fretting`, three solves each.
const WHERE_SURFACES_SWING: Law = [28.0, 3.5];
/// Rates of wear change less. The column `solves` of `twin_disc` ended at 45, 47, 58, 94 and 169 for the same tolerances, which the
/// sum meets within a sixth. Three times the creepage changed it by up to a fifth, a tenth or ten times the revolutions by up
/// to a third.
const IN_ROLLING: Law = [26.0, 1.3];

/// Solves with steps chosen by error: three a step, one step between two outputs at least.
fn by_error([spared_by_none, over_root]: Law, tolerance: f64, outputs: usize) -> u64 {
    let steps_by_error = (spared_by_none + over_root / tolerance.sqrt()).ceil() as u64;
    steps_by_error.max(1 + 3 * outputs as u64)
}

/// Solves of a step: one, or one a position of surfaces that swing.
fn of_a_step(parts: &Parts<'_>) -> u64 {
    let axis = parts.motion.direction.axis;
    let element = parts.case.frame.spacing()[axis];
    let contact = parts.subject().contact(parts.schedule.control);
    let length = contact.map(|contact| 2.0 * contact.semi_axes[axis]);
    solves_of_a_step(&parts.motion, (element, parts.case.frame.elements[axis]), length).unwrap_or(1)
}

impl fmt::Display for Solves {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Solves::Exactly(solves) => write!(f, "{solves}"),
            Solves::AtLeast(solves) => write!(f, "at least {solves}"),
            Solves::About(solves) => {
                write!(f, "about {solves} (the steps are chosen by their error)")
            }
        }
    }
}

impl fmt::Display for Forecast {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_contact(f, &self.estimate, self.cells_across)?;
        self.yieldings.iter().try_for_each(|yielding| yielding.fmt(f))?;
        write_wear(f, &self.estimate)?;
        self.equivalents.iter().try_for_each(|equivalent| equivalent.fmt(f))?;
        if let Some(cycles) = self.cycles.filter(|cycles| cycles.total > 1) {
            cycles.fmt(f)?;
        }
        if let Some(surfaces) = self.surfaces {
            writeln!(f, "surfaces          {surfaces}")?;
        }
        writeln!(f, "contact solves    {}", self.solves)?;
        self.write_size(f)?;
        writeln!(f, "memory            about {:.0} MB", (self.memory * 1e-6).max(1.0))
    }
}

impl Forecast {
    fn write_size(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for Finiteness { body, distance, approach, .. } in &self.finiteness {
            let (distance, share) = (length(*distance), three(100.0 * approach));
            writeln!(
                f,
                "half-space        {share} % of the approach where `{body}` ends, {distance} away"
            )?;
        }
        for (body, surfaces) in &self.files {
            let elements: usize = surfaces.iter().map(|surface| surface.elements).sum();
            writeln!(f, "elements          {elements} of `{body}`")?;
            surfaces.iter().try_for_each(|one| writeln!(f, "                  {one}"))?;
        }
        for (body, way, why) in &self.ways {
            let why = why.map_or_else(String::new, |why| format!(": {why}"));
            writeln!(f, "elasticity        {way} for `{body}`{why}")?;
        }
        for (body, unknowns) in &self.unknowns {
            writeln!(f, "unknowns          {unknowns} of `{body}`")?;
        }
        let meshed = !(self.unknowns.is_empty() && self.finiteness.is_empty());
        let pairs = if meshed { "pairs   " } else { "elements" };
        writeln!(f, "{pairs}          {}", self.pairs)
    }
}

impl fmt::Display for Cycles {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.computed {
            Solves::Exactly(cycles) if cycles == self.total => {
                writeln!(f, "cycles            {cycles}")
            }
            Solves::Exactly(cycles) | Solves::AtLeast(cycles) => {
                writeln!(f, "cycles            {cycles} computed of {}", self.total)
            }
            Solves::About(cycles) => {
                writeln!(f, "cycles            about {cycles} computed of {}", self.total)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{WHERE_ALL_SLIDES, by_error};

    /// Three solves for a step between each two outputs and one at the start.
    #[test]
    fn outputs_ask_for_solves() {
        assert_eq!(by_error(WHERE_ALL_SLIDES, 1e-2, 100), 301);
    }
}
