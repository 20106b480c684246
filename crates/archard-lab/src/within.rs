//! Least squares within a test: the k that its readings ask for, and what is left of them.

/// A reading of a test.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The line of the table.
    pub line: u64,
    /// What was measured, as a place in a list of quantities.
    pub quantity: usize,
    /// How far the motion had gone (its unit, SI).
    pub progress: f64,
    /// What was measured (SI), greater than zero.
    pub value: f64,
    /// Its standard uncertainty, relative to it.
    pub uncertainty: Option<f64>,
}

/// A test: one specimen, or pair of specimens, run once.
#[derive(Debug, Clone, PartialEq)]
pub struct Test {
    /// What it is called.
    pub name: String,
    /// Its load (N), where tests have loads of their own.
    pub load: Option<f64>,
    /// Its readings.
    pub readings: Vec<Reading>,
}

/// What a model says of a reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expectation {
    /// Natural logarithm of the value.
    pub log: f64,
    /// Its derivative with respect to the logarithm of k.
    pub slope: f64,
}

/// A test with the k that fits it best.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedTest {
    /// Natural logarithm of k.
    pub log_k: f64,
    /// Derivatives of the logarithms of the values with respect to that of k.
    pub slopes: Vec<f64>,
    /// Logarithms of the values less those expected.
    pub residuals: Vec<f64>,
}

/// Iterations of a fit; the last changes are far below any reading then.
pub(super) const ITERATIONS: usize = 60;
/// Largest change of log k at once.
pub(super) const STRIDE: f64 = 1.0;
/// Sum of squares of the slopes below which readings do not tell k: a change of k by a factor of e is one of 1 % then.
pub(super) const FLAT: f64 = 1e-4;

/// Why a test has no k.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoFit<E> {
    /// The model failed.
    #[error(transparent)]
    Model(#[from] E),
    /// Any k would do.
    #[error("its readings cannot tell k: the model gives nearly the same values whatever k is")]
    Flat,
    /// There is no best k.
    #[error("no k fits its readings best")]
    Unsettled,
}

/// Weights of the readings: 1 / variance, by their own uncertainties or those of their quantities.
pub fn weights(test: &Test, of_quantity: &[f64]) -> Vec<f64> {
    let weight = |reading: &Reading| {
        let own = reading.uncertainty.unwrap_or(of_quantity[reading.quantity]);
        1.0 / (own * own)
    };
    test.readings.iter().map(weight).collect()
}

impl FittedTest {
    /// The best k of a test by Gauss and Newton, from a guess of its logarithm on until it changes by less than given.
    ///
    /// # Errors
    /// If the model fails, or the readings do not tell k.
    pub fn find<E>(
        test: &Test,
        weights: &[f64],
        (guess, settled): (f64, f64),
        model: &mut dyn FnMut(f64) -> Result<Vec<Expectation>, E>,
    ) -> Result<Self, NoFit<E>> {
        let mut log_k = guess;
        let mut stride = STRIDE;
        let mut last = 0.0;
        for _ in 0..ITERATIONS {
            let fitted = Self::at(test, log_k, &model(log_k)?);
            let sum = |part: &dyn Fn(usize) -> f64| -> f64 {
                (0..weights.len()).map(|j| weights[j] * part(j)).sum()
            };
            let information = sum(&|j| fitted.slopes[j].powi(2));
            if information <= FLAT * weights.iter().sum::<f64>() {
                return Err(NoFit::Flat);
            }
            let change = sum(&|j| fitted.slopes[j] * fitted.residuals[j]) / information;
            // Runs jump a little with k: between two sides of a jump there is no better k.
            if change.abs() <= settled || change * last < 0.0 && last.abs() <= settled {
                return Ok(fitted);
            }
            // To and fro: by half, so that it ends.
            if change * last < 0.0 {
                stride = 0.5 * last.abs();
            }
            last = change.clamp(-stride, stride);
            log_k += last;
        }
        Err(NoFit::Unsettled)
    }

    fn at(test: &Test, log_k: f64, expected: &[Expectation]) -> Self {
        let left =
            |(reading, expected): (&Reading, &Expectation)| reading.value.ln() - expected.log;
        Self {
            log_k,
            slopes: expected.iter().map(|expected| expected.slope).collect(),
            residuals: test.readings.iter().zip(expected).map(left).collect(),
        }
    }

    /// Variance of log k by the readings alone, in units of that of the weights.
    pub fn variance(&self, weights: &[f64]) -> f64 {
        1.0 / self.slopes.iter().zip(weights).map(|(slope, w)| w * slope * slope).sum::<f64>()
    }
}

/// Standard deviations of the readings of each quantity without uncertainties of their own that the residuals show, relative; `None` where
/// no test has a reading more than it takes to tell k. Tests are fitted with the weights of these.
pub fn shown(tests: &[Test], fitted: &[FittedTest], known: &[f64]) -> Option<Vec<f64>> {
    let mut squares = vec![0.0; known.len()];
    let mut degrees = vec![0.0; known.len()];
    for (test, fitted) in tests.iter().zip(fitted) {
        let weights = weights(test, known);
        let variance = fitted.variance(&weights);
        for (j, reading) in test.readings.iter().enumerate() {
            if reading.uncertainty.is_some() {
                continue;
            }
            squares[reading.quantity] += fitted.residuals[j].powi(2);
            degrees[reading.quantity] += 1.0 - weights[j] * fitted.slopes[j].powi(2) * variance;
        }
    }
    let enough = |degrees: f64| degrees > 0.5;
    let all = squares.iter().sum::<f64>() / degrees.iter().sum::<f64>();
    if !enough(degrees.iter().sum()) || all <= 0.0 {
        return None;
    }
    let own = |(square, degrees): (&f64, &f64)| match enough(*degrees) && *square > 0.0 {
        true => (square / degrees).sqrt(),
        false => all.sqrt(),
    };
    Some(squares.iter().zip(&degrees).map(own).collect())
}

/// How much the residuals of one reading and the next of a series agree, from 0 to 0.9; zero where that may be chance.
///
/// Wear accumulates: what one reading is off, the next one is too, and they are not two independent readings.
pub fn correlation(fitted: &[FittedTest]) -> f64 {
    const CHANCE: f64 = 1.645;
    let (mut products, mut squares, mut count) = (0.0, 0.0, 0.0);
    for residuals in fitted.iter().map(|fitted| &fitted.residuals) {
        let size = residuals.len() as f64;
        let square = residuals.iter().map(|r| r * r).sum::<f64>();
        let product = residuals.windows(2).map(|pair| pair[0] * pair[1]).sum::<f64>();
        // The fitted k makes independent residuals disagree a little.
        products += product + square / size;
        squares += square;
        count += size - 1.0;
    }
    let correlation = if squares > 0.0 { products / squares } else { 0.0 };
    if correlation * f64::sqrt(count) > CHANCE { correlation.min(0.9) } else { 0.0 }
}
