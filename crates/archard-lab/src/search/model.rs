//! What runs say of readings at a coefficient: one run scaled, several interpolated, or one of its own.

use super::super::{Error, Expectation};
use super::{Run, Search, TRIED, of_load};

/// Factor between the k of a series of runs. A cubic through four of them is .023 (ln 2)^4 times the fourth derivative off;
/// where a reading goes over from one power of k to another within a factor of e, of powers a quarter apart, that is 2e-4 of it.
const APART: f64 = 2.0;

/// A model of the readings at one k.
pub(super) enum Model {
    /// A run in which k s is so many times that of the readings.
    Scaled(Run, f64),
    /// Four runs, and where k is between the inner ones, from 0 to 1.
    Between([Run; 4], f64),
    /// A run at this k, and two of others that tell the slope.
    Own(Run, [Run; 2]),
}

impl Search<'_> {
    /// The model at a logarithm of the coefficient of a target, under a load.
    pub(super) fn model(
        &mut self,
        place: usize,
        load: Option<f64>,
        log_k: f64,
    ) -> Result<Model, Error> {
        let log_scale = log_k - self.reference[place].ln();
        if self.by_k_s {
            let own = self.scale.get(&of_load(load)).copied().unwrap_or(1.0);
            return Ok(Model::Scaled(self.run(own, load)?, log_scale.exp() / own));
        }
        if self.between {
            let along = log_scale / APART.ln();
            let first = along.floor();
            let mut run = |offset: f64| self.run(APART.powf(first + offset), load);
            let runs = [run(-1.0)?, run(0.0)?, run(1.0)?, run(2.0)?];
            return Ok(Model::Between(runs, along - first));
        }
        let others = [self.run(1.0, load)?, self.run(TRIED, load)?];
        Ok(Model::Own(self.run(log_scale.exp(), load)?, others))
    }
}

impl Model {
    /// How far its runs go.
    pub fn end(&self) -> f64 {
        match self {
            Self::Scaled(run, _) | Self::Between([run, ..], _) | Self::Own(run, _) => run.end,
        }
    }

    /// What it says of a quantity at a place.
    pub fn at(&self, quantity: usize, place: f64) -> Expectation {
        match self {
            Self::Scaled(run, times) => run.at(quantity, place * times),
            Self::Between(runs, t) => {
                let logs = runs.each_ref().map(|run| run.at(quantity, place).log);
                let [log, slope] = cubic(logs, *t);
                Expectation { log, slope: slope / APART.ln() }
            }
            Self::Own(run, others) => {
                let [here, tried] = others.each_ref().map(|run| run.at(quantity, place).log);
                let log = run.at(quantity, place).log;
                Expectation { log, slope: (tried - here) / TRIED.ln() }
            }
        }
    }
}

/// The cubic through values at -1, 0, 1 and 2, and its slope, at a place.
pub(super) fn cubic([before, one, other, after]: [f64; 4], t: f64) -> [f64; 2] {
    let third = after - 3.0 * other + 3.0 * one - before;
    let second = other - 2.0 * one + before;
    let first = other - one;
    // Newton's divided differences, from 0, 1, -1 and 2.
    let value = one + t * (first + (t - 1.0) * (second / 2.0 + (t + 1.0) * third / 6.0));
    let slope = first + (2.0 * t - 1.0) * second / 2.0 + (3.0 * t * t - 1.0) * third / 6.0;
    [value, slope]
}

#[cfg(test)]
mod tests {
    use super::cubic;

    #[test]
    fn cubics_are_exact() {
        let curve = |t: f64| 0.3 - 1.2 * t + 0.7 * t * t - 0.4 * t * t * t;
        let values = [-1.0, 0.0, 1.0, 2.0].map(curve);
        for t in [0.0, 0.3, 0.9, 1.0] {
            let [value, slope] = cubic(values, t);
            assert!((value - curve(t)).abs() < 1e-14);
            assert!((slope - (-1.2 + 1.4 * t - 1.2 * t * t)).abs() < 1e-14);
        }
    }
}
