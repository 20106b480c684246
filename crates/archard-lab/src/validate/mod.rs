//! Measured tests next to what is predicted of them.
//!
//! Each test of a [`Set`] is left out once: the others give the coefficient, by which the case predicts what was measured of it. After ASME
//! V&V 20 the comparison error E = S - D, simulation less data, is held against the uncertainties of the numbers (half the elements),
//! of the input (the 95 % interval of the next test) and of the data. A set whose tests the law does not fit is rejected, with the reason.

mod predict;
mod report;
mod set;

use std::path::Path;

pub use report::in_markdown;
pub use set::{FILE, ReportedCoefficients, Set};

use super::{Error, RunFollower};
use archard_case::output::Store;

/// A measured value and its prediction (SI).
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The test.
    pub test: String,
    /// What was measured.
    pub quantity: String,
    /// A factor from SI to the unit shown, and that unit.
    pub unit: (f64, &'static str),
    /// The data.
    pub measured: f64,
    /// The simulation.
    pub predicted: f64,
    /// The simulation that wears the measured section, of depths and widths of profiles: whether the shape is right, whatever the coefficient.
    pub at_own_section: Option<f64>,
    /// Halves of the 95 % intervals of their logarithms, by the data (zero where nothing is stated), by the input (the coefficient; of other
    /// tests with the error of a reading in it) and by the numbers.
    pub halves: [f64; 3],
}

impl Comparison {
    /// The comparison error, simulation less data, over the data.
    pub fn error(&self) -> f64 {
        self.predicted / self.measured - 1.0
    }

    /// The 95 % interval about the prediction in which the measured value lies where the model is right.
    pub fn interval(&self) -> [f64; 2] {
        let half = self.halves.iter().map(|half| half * half).sum::<f64>().sqrt();
        [self.predicted * (-half).exp(), self.predicted * half.exp()]
    }

    /// Whether it does.
    pub fn holds(&self) -> bool {
        let [low, high] = self.interval();
        (low..=high).contains(&self.measured)
    }
}

/// What came of a set.
#[derive(Debug, Clone, PartialEq)]
pub struct Validation {
    /// The set.
    pub set: Set,
    /// Values and predictions, or why the law is rejected.
    pub outcome: Result<Vec<Comparison>, String>,
    /// The coefficient that each test was predicted with, in words.
    pub coefficients: Vec<[String; 2]>,
    /// What is doubtful about the runs that predict.
    pub doubts: Vec<String>,
}

/// Predicts the tests of a set.
///
/// # Errors
/// If the files of a set cannot be used, or a run fails.
pub fn validate(
    set: &Set,
    (dir, store): (&Path, Option<&Store>),
    following: &mut dyn RunFollower,
) -> Result<Validation, Error> {
    predict::Prediction::of(set, (dir, store), following)?.validated()
}
