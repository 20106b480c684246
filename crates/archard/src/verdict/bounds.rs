//! The lines there are, each with its bounds and what these were measured on.

use super::{Bound, Line};

/// The load that is carried against the one prescribed, relative to it.
///
/// Solvers end at residuals of 1e-8 (pressures) and 1e-6 (friction with pressures); a lost contact is off by 1.
pub fn load(off: f64) -> Line {
    Line::new("load", off, Bound::AtMost([1e-5, 1e-3]), "of the load prescribed is not carried")
}
