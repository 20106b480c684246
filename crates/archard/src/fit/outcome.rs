//! What a fit found.

use super::{Estimate, Test};

/// A coefficient that was fitted.
#[derive(Debug, Clone, PartialEq)]
pub struct Coefficient {
    /// Its key.
    pub key: String,
    /// Its unit (SI).
    pub unit: String,
    /// Its value in the case.
    pub before: f64,
    /// What the tests say.
    pub estimate: Estimate,
    /// The tests.
    pub tests: Vec<Test>,
    /// What the case shows: each load, each quantity by its place, and points of progress and value (SI) at the median.
    pub curves: Vec<Shown>,
}

/// A curve to be drawn beside readings.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// The load (N), where tests have loads of their own.
    pub load: Option<f64>,
    /// The quantity, as its place in the list.
    pub quantity: usize,
    /// How far, and for each the values at the ends of the 95 % intervals of the next test, of the median, and the median: SI;
    /// `next low, low, median, high, next high`.
    pub points: Vec<(f64, [f64; 5])>,
}

/// A fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// What says how far readings are: the name of the column.
    pub progress: &'static str,
    /// What was measured: the names of the columns, a factor from SI to the unit shown, and that unit.
    pub quantities: Vec<(String, f64, &'static str)>,
    /// The coefficients.
    pub coefficients: Vec<Coefficient>,
    /// What has to be said.
    pub remarks: Vec<String>,
    /// Number of runs.
    pub runs: usize,
    /// Whether one run told all k.
    pub by_k_s: bool,
}
