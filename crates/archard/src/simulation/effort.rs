//! What a step took, and what the run took so far.

use serde::{Deserialize, Serialize};

/// What a step took, and what the run took so far.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Effort {
    /// Steps accepted so far.
    pub steps: usize,
    /// Steps rejected so far.
    pub rejected: usize,
    /// Contact solves so far.
    pub solves: usize,
    /// Iterations of this step's solves, rejected ones included.
    pub iterations: usize,
    /// Applications of the compliance so far.
    pub applications: usize,
    /// Residual of the step's last solve.
    pub residual: f64,
    /// Estimate of the relative error of the wear depth that the division into steps has caused;
    /// `None` where no estimate is made.
    pub time_error: Option<f64>,
    /// What the pressure at the centre of the frame lags by (Pa): less this it is of second order in the steps; 0 where
    /// that is not known.
    pub centre_lag: f64,
    /// Increments so far that did not settle on what closing pairs slide before they touch.
    pub unsettled: usize,
    /// Cycles computed so far, those that were jumped over left out.
    pub true_cycles: usize,
    /// Energy (J) that friction has dissipated since the present cycle began, and in all whole cycles.
    pub dissipated: [f64; 2],
    /// Integral of the load over the distance slid (N m), to compare worn volumes with; in rolling, of
    /// the work of the creepages a revolution over the coefficient of friction (N), to compare worn
    /// sections with.
    pub load_distance: f64,
}
