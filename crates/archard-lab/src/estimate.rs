//! k from tests: its median, its interval, that of the next test, and what they are made of.

use super::effects::{Effects, factor, known_factor};
use super::shape::{self, Exponent};
use super::within::{Expectation, FittedTest, NoFit, Test, correlation, shown, weights};

/// Degrees of freedom of what is known from elsewhere.
pub(super) const MANY: f64 = 1e6;
/// Rounds in which the uncertainty of readings and the fits settle.
const ROUNDS: usize = 4;
/// Readings scatter more than stated where chance would show it less often than this.
const CHANCE: f64 = 0.01;
/// Standard deviation of log k above which a test does not tell k: it may be a tenth or ten times as large.
pub(super) const UNTOLD: f64 = 1.2;

/// What is known of a coefficient that is common to all tests: a name, and a standard uncertainty of k, relative.
pub type Common = (String, f64);

/// A wear coefficient from tests.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// Median of the coefficients of tests.
    pub median: f64,
    /// Its 95 % interval; `None` where nothing gives the errors.
    pub interval: Option<[f64; 2]>,
    /// The 95 % interval of the coefficient that another test will show, read as these; `None` of one test.
    pub next: Option<[f64; 2]>,
    /// Standard deviation of the logarithm of that, and its degrees of freedom.
    pub predictive: Option<[f64; 2]>,
    /// Each test, by name: its coefficient and, where the errors of readings are known, its 95 % interval by them.
    pub tests: Vec<(String, f64, Option<[f64; 2]>)>,
    /// Scatter between tests without that of readings: the standard deviation of log k; `None` of one test.
    pub between: Option<f64>,
    /// Standard uncertainty of a reading of each quantity, relative, as the residuals show it or as it was stated.
    pub readings: Option<Vec<f64>>,
    /// How many times as much the readings scatter as their uncertainties say, where that is no chance.
    pub understated: Option<f64>,
    /// Agreement of one residual and the next, zero of independent readings.
    pub correlation: f64,
    /// The exponent of the distance, 1 by the law.
    pub distance: Option<Exponent>,
    /// The exponent of the load that k depends on, 0 where it is constant.
    pub loads: Option<Exponent>,
    /// Each load (N), its number of tests, its median and the 95 % interval.
    pub by_load: Vec<(f64, usize, f64, Option<[f64; 2]>)>,
    /// Standard uncertainties of the median by their sources, relative.
    pub budget: Vec<Common>,
    /// The fits of the tests.
    pub fitted: Vec<FittedTest>,
}

/// Tests and the names of what was measured in them.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// The names.
    pub quantities: Vec<String>,
    /// The tests.
    pub tests: Vec<Test>,
}

/// What a model says of the readings of a test (by its place) at a logarithm of k.
pub type Model<'a, E> = &'a mut dyn FnMut(usize, f64) -> Result<Vec<Expectation>, E>;

/// A test that has no k.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("test `{test}`: {cause}")]
pub struct NoEstimate<E: std::error::Error + 'static> {
    /// The test.
    pub test: String,
    /// Why.
    pub cause: NoFit<E>,
}

impl Study {
    /// The coefficient of these tests by a model, from a guess on and settled to a relative change; `common` is what is
    /// uncertain in all tests equally.
    ///
    /// # Errors
    /// If the model fails, or a test cannot tell k.
    pub fn estimate<E: std::error::Error>(
        &self,
        (guess, settled): (f64, f64),
        common: &[Common],
        model: Model<'_, E>,
    ) -> Result<Estimate, NoEstimate<E>> {
        let stated =
            self.tests.iter().flat_map(|test| &test.readings).all(|r| r.uncertainty.is_some());
        let mut of_quantity = vec![1.0; self.quantities.len()];
        let mut fitted =
            self.fit((&of_quantity, settled), &vec![guess.ln(); self.tests.len()], model)?;
        let mut found = None;
        for _ in 0..if stated { 0 } else { ROUNDS } {
            found = shown(&self.tests, &fitted, &of_quantity);
            let Some(found) = &found else { break };
            // One quantity weighs the same, whatever its error.
            let same = self.quantities.len() == 1 && of_quantity[0] != 1.0;
            of_quantity.clone_from(found);
            if same {
                break;
            }
            let from: Vec<f64> = fitted.iter().map(|fitted| fitted.log_k).collect();
            fitted = self.fit((&of_quantity, settled), &from, model)?;
        }
        let own = self.mean_uncertainties();
        let readings = match found {
            _ if stated => Some(own),
            None => None,
            // What was stated of all readings of a quantity stays.
            Some(shown) => {
                let stated = |place: usize| {
                    let readings = self.tests.iter().flat_map(|test| &test.readings);
                    let mut of_it = readings.filter(|r| r.quantity == place).peekable();
                    of_it.peek().is_some() && of_it.all(|r| r.uncertainty.is_some())
                };
                let of = |(place, shown)| if stated(place) { own[place] } else { shown };
                Some(shown.into_iter().enumerate().map(of).collect())
            }
        };
        Ok(self.conclude((fitted, of_quantity), readings, stated, common))
    }

    fn fit<E: std::error::Error>(
        &self,
        (of_quantity, settled): (&[f64], f64),
        from: &[f64],
        model: Model<'_, E>,
    ) -> Result<Vec<FittedTest>, NoEstimate<E>> {
        let one = |(index, test): (usize, &Test)| {
            let mut own = |log_k: f64| model(index, log_k);
            FittedTest::find(test, &weights(test, of_quantity), (from[index], settled), &mut own)
                .map_err(|cause| NoEstimate { test: test.name.clone(), cause })
        };
        self.tests.iter().enumerate().map(one).collect()
    }

    /// Root mean square of the stated uncertainties of each quantity.
    fn mean_uncertainties(&self) -> Vec<f64> {
        let of = |quantity: usize| {
            let readings = self.tests.iter().flat_map(|test| &test.readings);
            let own = readings.filter(|reading| reading.quantity == quantity);
            let squares: Vec<f64> =
                own.filter_map(|reading| Some(reading.uncertainty?.powi(2))).collect();
            (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt()
        };
        (0..self.quantities.len()).map(of).collect()
    }

    fn conclude(
        &self,
        (fitted, of_quantity): (Vec<FittedTest>, Vec<f64>),
        readings: Option<Vec<f64>>,
        stated: bool,
        common: &[Common],
    ) -> Estimate {
        let weights: Vec<Vec<f64>> =
            self.tests.iter().map(|test| weights(test, &of_quantity)).collect();
        let correlation = correlation(&fitted);
        let extra = self.degrees();
        let understated =
            (stated && extra > 0.0).then(|| excess(&fitted, &weights, extra)).flatten();
        // Independent readings in one of a series, and what was understated.
        let factor_of_variance =
            (1.0 + correlation) / (1.0 - correlation) * understated.unwrap_or(1.0).powi(2);
        let known = readings.is_some();
        let variances: Vec<f64> = (fitted.iter().zip(&weights))
            .map(
                |(fitted, weights)| {
                    if known { factor_of_variance * fitted.variance(weights) } else { 0.0 }
                },
            )
            .collect();
        let log_ks: Vec<f64> = fitted.iter().map(|fitted| fitted.log_k).collect();
        let effects = Effects::of(&log_ks, &variances);
        let reading_degrees = match stated && understated.is_none() {
            true => MANY,
            false => (extra * (1.0 - correlation) / (1.0 + correlation)).max(1.0),
        };
        let interval = |middle: f64, deviation: f64, degrees: f64| {
            let half = factor(degrees) * deviation;
            [(middle - half).exp(), (middle + half).exp()]
        };
        let tests = (self.tests.iter().zip(&fitted).zip(&variances)).map(|((test, fitted), v)| {
            let own = known.then(|| interval(fitted.log_k, v.sqrt(), reading_degrees));
            (test.name.clone(), fitted.log_k.exp(), own)
        });
        let shared: f64 = common.iter().map(|(_, u)| u * u).sum();
        let (mean, own) = match effects {
            Some(effects) => (effects.mean, Some((effects.deviation, effects.degrees))),
            None => (log_ks[0], known.then(|| (variances[0].sqrt(), reading_degrees))),
        };
        let with_common = |deviation: f64, degrees: f64| {
            let all = (deviation * deviation + shared).sqrt();
            // Welch and Satterthwaite: what is common is known from elsewhere.
            let degrees = if deviation > 0.0 { degrees * (all / deviation).powi(4) } else { MANY };
            (all, degrees.min(MANY))
        };
        let total = own.map(|(deviation, degrees)| with_common(deviation, degrees));
        let next = effects.map(|effects| with_common(effects.next, effects.degrees));
        let by_load = shape::by_load(&self.tests, &fitted, &variances);
        Estimate {
            median: mean.exp(),
            interval: total.map(|(deviation, degrees)| interval(mean, deviation, degrees)),
            next: next.map(|(deviation, degrees)| interval(mean, deviation, degrees)),
            predictive: next.map(|(deviation, degrees)| [deviation, degrees]),
            tests: tests.collect(),
            between: effects.map(|effects| effects.between),
            understated,
            correlation,
            distance: shape::over_distance((&self.tests, &fitted), &weights, correlation),
            loads: shape::over_loads(&self.tests, &fitted),
            by_load: by_load
                .into_iter()
                .map(|(load, count, mean, effects)| {
                    let own = effects.map(|own| interval(mean, own.deviation, own.degrees));
                    (load, count, effects.map_or(mean, |own| own.mean).exp(), own)
                })
                .collect(),
            budget: budget((effects, &variances), own.map(|own| own.0), known, common),
            readings,
            fitted,
        }
    }

    /// Readings beyond what it takes to tell each k.
    fn degrees(&self) -> f64 {
        self.tests.iter().map(|test| test.readings.len() as f64 - 1.0).sum()
    }
}

impl Estimate {
    /// Whether the tests tell so little of k that it may as well be a tenth or ten times as large, whatever they scatter.
    pub fn is_flat(&self) -> bool {
        let wide =
            |interval: [f64; 2]| (interval[1] / interval[0]).ln() > 2.0 * known_factor() * UNTOLD;
        self.tests.iter().all(|(_, _, interval)| interval.is_some_and(wide))
    }
}

/// How many times as much residuals scatter as the weights say; `None` where that may be chance.
fn excess(fitted: &[FittedTest], weights: &[Vec<f64>], degrees: f64) -> Option<f64> {
    use statrs::distribution::{ChiSquared, ContinuousCDF};
    let squares: f64 = (fitted.iter().zip(weights))
        .flat_map(|(fitted, weights)| fitted.residuals.iter().zip(weights).map(|(r, w)| w * r * r))
        .sum();
    let p = 1.0 - ChiSquared::new(degrees).ok()?.cdf(squares);
    (p < CHANCE).then(|| (squares / degrees).sqrt())
}

/// Sources that further tests make less of.
pub(super) const OWN: [&str; 3] =
    ["scatter between tests", "readings", "scatter between tests, readings included"];

/// Standard uncertainties of the median by their sources.
fn budget(
    (effects, variances): (Option<Effects>, &[f64]),
    own: Option<f64>,
    known: bool,
    common: &[Common],
) -> Vec<Common> {
    let mut budget = vec![];
    if let Some(own) = own {
        let reading = variances.iter().sum::<f64>() / variances.len() as f64;
        let between = effects.map_or(0.0, |effects| effects.between.powi(2));
        let share = |part: f64| match between + reading > 0.0 {
            true => own * (part / (between + reading)).sqrt(),
            false => 0.0,
        };
        match (effects, known) {
            (Some(_), true) => {
                budget.push((OWN[0].to_owned(), share(between)));
                budget.push((OWN[1].to_owned(), share(reading)));
            }
            (Some(_), false) => budget.push((OWN[2].to_owned(), own)),
            (None, _) => budget.push((OWN[1].to_owned(), own)),
        }
    }
    budget.extend(common.iter().cloned());
    budget
}
