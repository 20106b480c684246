//! A friction law by its limits at many pressures, as a function in Python gave them.

use archard::friction::Friction;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Limits straight between the pressures; below the first and beyond the last the coefficient of friction is held.
#[derive(Debug)]
pub struct Sampled {
    pressures: Vec<f64>,
    limits: Vec<f64>,
}

impl Sampled {
    /// Of rising pressures (Pa) and limits (Pa) that do not fall.
    pub fn new(pressures: Vec<f64>, limits: Vec<f64>) -> PyResult<Self> {
        let rises = pressures.is_sorted_by(|one, other| one < other);
        let sound =
            limits.is_sorted() && pressures.iter().chain(&limits).all(|one| one.is_finite());
        let begins = pressures.first().is_some_and(|&first| first > 0.0);
        if !rises || !sound || !begins || pressures.len() != limits.len() {
            return Err(PyValueError::new_err("limits of friction fall, or pressures do not rise"));
        }
        Ok(Self { pressures, limits })
    }

    /// The line that a pressure lies on: a point of it and its slope.
    fn line(&self, pressure: f64) -> [f64; 3] {
        let next = self.pressures.partition_point(|&known| known <= pressure);
        let at = |index: usize| (self.pressures[index], self.limits[index]);
        if next == 0 || next == self.pressures.len() {
            let (end, limit) = at(next.saturating_sub(1));
            return [end, limit, limit / end];
        }
        let ((low, below), (high, above)) = (at(next - 1), at(next));
        [low, below, (above - below) / (high - low)]
    }
}

impl Friction for Sampled {
    fn limit(&self, pressure: f64) -> f64 {
        let [at, limit, slope] = self.line(pressure);
        if pressure > 0.0 { (limit + slope * (pressure - at)).max(0.0) } else { 0.0 }
    }

    fn slope(&self, pressure: f64) -> f64 {
        self.line(pressure)[2]
    }
}
