//! Solvers of one contact step: pressures here, friction in [`tangential`].
//!
//! The problem: p >= 0, g >= 0, p g = 0 on every pair; where bodies yield, p <= H too, and pairs that bear H may overlap: that is
//! how deep they are imprinted. The gap is
//! g = gap of the undeformed surfaces - approach + (C + D) p, where C is the compliance and D a
//! diagonal addition that an implicit wear step puts there. Either the load or the approach is
//! given; the other follows. On frames that are not uniform the approach closes each gap by its own
//! share, forces are sums by areas, and C is symmetric in the product that has the areas for weights:
//! the [measure](Measure) of the frame says how pairs count.
//!
//! [`press`] hands a solver the part of the frame around the contact, where that is much smaller. Without a solution to start
//! from, it asks coarser elements for one, where a first guess is far off.
//!
//! A new solver is one file here and one line in [`SOLVERS`].

mod accept;
mod blocks;
mod cells;
mod conjugate_gradient;
mod contact_set;
#[doc(hidden)]
pub mod monolithic;
mod nested;
mod part;
mod residual;
mod semismooth;
mod start;
pub mod tangential;
mod uzawa;

use std::fmt::Debug;

#[doc(hidden)]
pub use accept::press;
pub(crate) use cells::Cells;
pub use conjugate_gradient::ConjugateGradient;
pub use uzawa::Uzawa;

use crate::compliance::{Compliance, normal_displacement};
use crate::frame::{Measure, Part};
use crate::motion::Control;
use crate::numerics::vector;
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity, Values};

/// One normal contact step.
#[derive(Debug)]
pub struct Step<'a> {
    /// How the bodies deform.
    pub compliance: &'a dyn Compliance,
    /// Gap of the undeformed surfaces at zero approach, wear included (m), one value a pair.
    pub gap: &'a [f64],
    /// What a pressure on a pair opens its gap by next to the elasticity (m/Pa): one value a pair.
    pub addition: &'a [f64],
    /// Number of pairs along x and y, where they form a grid.
    pub elements: [usize; 2],
    /// How the pairs count.
    pub measure: Measure<'a>,
    /// The given load or approach.
    pub control: Control,
    /// The largest pressure (Pa) that the bodies bear, under which they yield: infinite of elastic ones.
    pub hardness: f64,
}

impl Step<'_> {
    /// The load (N) that the pairs bear where all of them yield; infinite of elastic bodies.
    pub(crate) fn most(&self) -> f64 {
        if self.hardness.is_infinite() {
            return f64::INFINITY;
        }
        self.measure.load(&vec![self.hardness; self.gap.len()])
    }

    /// What comes of a load that the pairs do not bear even where all of them yield; `None` of one that they bear.
    fn overloaded(&self) -> Option<Outcome> {
        match self.control {
            Control::Load(load) if load >= self.most() => {}
            _ => return None,
        }
        let pairs = self.gap.len();
        let yielding = vec![self.hardness; pairs];
        let displacement = normal_displacement(self.compliance, &yielding);
        let open = vector::map([self.gap, &displacement, self.addition], |[gap, up, addition]| {
            gap + up + addition * self.hardness
        });
        let closing = |pair: usize| self.measure.closing.at(pair);
        let closed = (0..pairs).filter(|&pair| closing(pair) > 0.0);
        let approach =
            closed.map(|pair| open[pair] / closing(pair)).fold(f64::NEG_INFINITY, f64::max);
        Some(Outcome {
            status: Status::FrameFull,
            gap: (0..pairs).map(|pair| open[pair] - closing(pair) * approach).collect(),
            pressure: yielding,
            displacement,
            part: None,
            approach,
            iterations: 0,
            residual: f64::INFINITY,
            applications: 1,
        })
    }
}

/// A solution to start an iteration from.
#[derive(Debug, Clone, Copy)]
pub struct Start<'a> {
    /// Pressure (Pa), one value a pair.
    pub pressure: &'a [f64],
    /// Displacement the compliance makes of it (m), one value a pair.
    pub displacement: &'a [f64],
    /// Where in the frame that displacement is known; everywhere if `None`.
    pub part: Option<Part>,
    /// Approach (m).
    pub approach: f64,
}

/// How a solve ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// The residual is below the tolerance.
    Converged,
    /// The iterations allowed did not suffice.
    OutOfIterations,
    /// Every pair is in contact, and the surfaces do not end there: the frame is too small for the load.
    FrameFull,
}

/// What a solve found and what it took.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// How it ended; the fields hold the last iterate in any case.
    pub status: Status,
    /// Pressure (Pa), one value a pair.
    pub pressure: Vec<f64>,
    /// Displacement the compliance makes of it (m), one value a pair.
    pub displacement: Vec<f64>,
    /// Gap (m), one value a pair.
    pub gap: Vec<f64>,
    /// The part of the frame that was solved on; all of it if `None`. Beside it nothing touches, the displacement is not
    /// known and left out of the gap.
    pub part: Option<Part>,
    /// Approach (m).
    pub approach: f64,
    /// Iterations done.
    pub iterations: usize,
    /// Violation of the contact conditions relative to the pressures: see [`Settings::tolerance`].
    pub residual: f64,
    /// How often the compliance was applied.
    pub applications: usize,
}

/// What every solver is told.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Bound on the residual; of pressures, |p - q| / |p| (2-norms) with q the pressure p - g / c cut off below 0 and
    /// above the hardness (c: the compliance of a pair to its own pressure). It measures both open gaps under pressure and penetrations.
    pub tolerance: f64,
    /// Iterations allowed.
    pub max_iterations: usize,
}

/// Solves one step.
pub trait Solver: Debug + Send + Sync {
    /// Finds the pressures of a step, from those of an earlier one where there is one.
    fn solve(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome;

    /// What it was told.
    fn settings(&self) -> Settings;
}

/// The solvers a case can name; the first is the default.
pub const SOLVERS: &[Choice<Box<dyn Solver>>] = &[conjugate_gradient::CHOICE, uzawa::CHOICE];

/// Relaxation of projections that converge below 2, the faster the closer to it (B. He and L.-Z. Liao, *J. Optim. Theory Appl.* 112
/// (2002) 111, take as much).
const RELAXATION: f64 = 1.8;

/// Bound on the residual where a case gives none.
const TOLERANCE: f64 = 1e-8;

/// The parameters every solver takes.
const PARAMETERS: &[Parameter] = &[BOUND, MOST];
const BOUND: Parameter =
    Parameter::optional("tolerance", Quantity::Number, "bound on the residual")
        .bound(Bound::Between(0.0, 1.0));
const MOST: Parameter =
    Parameter::optional("max_iterations", Quantity::Count, "iterations allowed in a solve");

impl Settings {
    /// A bound on the residual and how many iterations are allowed.
    ///
    /// # Errors
    /// If the bound is not between 0 and 1, or no iteration is allowed.
    pub fn new(tolerance: f64, max_iterations: usize) -> Result<Self, Invalid> {
        MOST.admit(max_iterations as f64)?;
        Ok(Self { tolerance: BOUND.admit(tolerance)?, max_iterations })
    }

    /// The values given, the others as the solver has them.
    fn read(values: &Values, otherwise: Self) -> Result<Self, Invalid> {
        let tolerance = values.number("tolerance").unwrap_or(otherwise.tolerance);
        let count = values.number("max_iterations").map(|count| count as usize);
        Self::new(tolerance, count.unwrap_or(otherwise.max_iterations))
    }
}
