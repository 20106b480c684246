//! What a fit found.

use super::{Estimate, MeasuredFile, Test};

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
    /// Whether its law was asked to be assumed though the tests do not wear by it.
    pub assumed: bool,
    /// The tests.
    pub tests: Vec<Test>,
    /// What the case shows: each load, each quantity by its place, and points of progress and value (SI) at the median.
    pub curves: Vec<DrawnCurve>,
}

/// A curve to be drawn next to readings.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnCurve {
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
    /// How the errors of (the logarithms of) coefficients that were fitted together correlate, a row each; empty of others.
    pub together: Vec<Vec<f64>>,
    /// What was taken from profiles and height maps.
    pub surfaces: Vec<MeasuredFile>,
    /// What has to be said.
    pub remarks: Vec<String>,
    /// What is doubtful about the runs.
    pub doubts: Vec<String>,
    /// Number of runs.
    pub runs: usize,
    /// Whether one run told all k.
    pub by_k_s: bool,
    /// By how much the ratio of both coefficients in the runs differs from that of the readings (its logarithm), where runs did
    /// not bring them together; `None` where they did.
    pub unsettled: Option<f64>,
}

/// Fewest tests that tell how two coefficients go together.
const FEWEST: usize = 3;

impl Fit {
    /// The correlation of the logarithms of two coefficients over the tests that tell both, or of their errors where they were fitted
    /// together, and the number of tests; `None` where there are no two coefficients, or fewer than three such tests.
    pub fn correlation(&self) -> Option<(f64, usize)> {
        let [one, other] = &self.coefficients[..] else { return None };
        if let [row, _] = &self.together[..] {
            return Some((row[1], one.tests.len()));
        }
        let of =
            |name: &str| other.estimate.tests.iter().find(|own| own.0 == name).map(|own| own.1);
        let pairs =
            one.estimate.tests.iter().filter_map(|own| Some([own.1.ln(), of(&own.0)?.ln()]));
        let pairs: Vec<[f64; 2]> = pairs.collect();
        if pairs.len() < FEWEST {
            return None;
        }
        let count = pairs.len() as f64;
        let mean = [0, 1].map(|i| pairs.iter().map(|pair| pair[i]).sum::<f64>() / count);
        let sum = |i: usize, j: usize| -> f64 {
            pairs.iter().map(|pair| (pair[i] - mean[i]) * (pair[j] - mean[j])).sum()
        };
        let size = (sum(0, 0) * sum(1, 1)).sqrt();
        let correlation = if size > 0.0 { (sum(0, 1) / size).clamp(-1.0, 1.0) } else { 0.0 };
        Some((correlation, pairs.len()))
    }
}
