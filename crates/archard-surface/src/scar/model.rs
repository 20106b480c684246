//! What readings of a profile should be, how they scatter, and generalised least squares.
//!
//! A height is that of the unworn body at the shifted place, less what is worn off, on a line: `h(x - s) - w(x - s, A) + a + b x`. Errors
//! are white noise with weights, texture, and a misfit of the model as a share of its own depth, of one
//! correlation length.

use faer::linalg::solvers::{Llt, Solve};
use faer::{Mat, Side};

use super::blocks::Blocks;
use super::shape::Shape;

/// The numbers that are found by linear equations: height (m), tilt over the profile (m) and growth of the section.
pub(super) const LINEAR: usize = 3;

/// What a profile is held against.
pub(super) struct Model<'a> {
    pub blocks: &'a Blocks,
    /// Height (m) of the unworn body at a place (m) from the middle of the contact.
    pub nominal: &'a dyn Fn(f64) -> f64,
    pub shape: &'a Shape,
    /// Places from the middle of the profile, over its span.
    pub along: Vec<f64>,
}

/// How readings scatter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scatter {
    /// Standard deviations (m) of white noise and of texture, and of the misfit as a share of the depth.
    pub noise: f64,
    pub texture: f64,
    pub misfit: f64,
    /// Correlation length (m) of texture and misfit: the integral of their correlation, to one side.
    pub length: f64,
}

impl Scatter {
    /// Correlation length (m) of noise and texture together, of readings a step apart (m): the integral of their correlation, to one side.
    pub fn correlated(&self, step: f64) -> f64 {
        let [noise, texture] = [self.noise, self.texture].map(|own| own * own);
        (noise * step + texture * self.length) / (noise + texture)
    }

    /// The covariance (m^2) of texture so far apart (m).
    pub fn texture(&self, far: f64) -> f64 {
        self.texture * self.texture * correlation(far, self.length)
    }

    /// The covariance of misfits so far apart (m), as a share of the depths.
    pub fn misfit(&self, far: f64) -> f64 {
        self.misfit * self.misfit * correlation(far, self.length)
    }
}

/// The correlation of B. Matern's process of the order 3/2 (*Spatial Variation*, 1960), whose slopes are finite, over a length.
fn correlation(far: f64, length: f64) -> f64 {
    let far = 2.0 * far.abs() / length;
    (1.0 + far) * (-far).exp()
}

/// The covariance of readings and its inverse.
pub(super) struct Covariance {
    pub whole: Mat<f64>,
    inverse: Llt<f64>,
}

impl Covariance {
    /// Of a matrix; `None` where it is not positive.
    fn of(whole: Mat<f64>) -> Option<Self> {
        let inverse = whole.llt(Side::Lower).ok()?;
        Some(Self { whole, inverse })
    }

    /// Its inverse times a vector.
    pub fn solve(&self, vector: &[f64]) -> Vec<f64> {
        let column = Mat::from_fn(vector.len(), 1, |i, _| vector[i]);
        let found = self.inverse.solve(column);
        (0..vector.len()).map(|i| found[(i, 0)]).collect()
    }

    /// The diagonal of its inverse.
    pub fn inverse_diagonal(&self) -> Vec<f64> {
        let size = self.whole.nrows();
        let found = self.inverse.solve(Mat::<f64>::identity(size, size));
        (0..size).map(|i| found[(i, i)]).collect()
    }

    /// The logarithm of its determinant.
    fn log_determinant(&self) -> f64 {
        let lower = self.inverse.L();
        (0..self.whole.nrows()).map(|i| 2.0 * lower[(i, i)].ln()).sum()
    }
}

/// A fit by generalised least squares.
pub(super) struct Gls {
    pub covariance: Covariance,
    pub numbers: Vec<f64>,
    /// The covariance of the numbers.
    pub uncertain: Mat<f64>,
    pub residuals: Vec<f64>,
    /// Columns of the numbers, each times the inverse of the covariance.
    pub weighted: Vec<Vec<f64>>,
    /// The logarithm of the restricted likelihood (H. D. Patterson and R. Thompson, *Biometrika* 58 (1971) 545).
    pub likelihood: f64,
}

impl Gls {
    /// The numbers of columns nearest to heights.
    pub fn of(covariance: Covariance, columns: &[Vec<f64>], heights: &[f64]) -> Option<Self> {
        let weighted: Vec<Vec<f64>> = columns.iter().map(|own| covariance.solve(own)).collect();
        let count = columns.len();
        let information = Mat::from_fn(count, count, |i, j| dot(&columns[i], &weighted[j]));
        let inverse = information.llt(Side::Lower).ok()?;
        let sums = Mat::from_fn(count, 1, |i, _| dot(&weighted[i], heights));
        let found = inverse.solve(&sums);
        let numbers: Vec<f64> = (0..count).map(|i| found[(i, 0)]).collect();
        let residual = |at: usize| {
            heights[at]
                - numbers.iter().zip(columns).map(|(own, column)| own * column[at]).sum::<f64>()
        };
        let residuals: Vec<f64> = (0..heights.len()).map(residual).collect();
        let lower = inverse.L();
        let of_numbers: f64 = (0..count).map(|i| 2.0 * lower[(i, i)].ln()).sum();
        let square = dot(&residuals, &covariance.solve(&residuals));
        let likelihood = -0.5 * (square + covariance.log_determinant() + of_numbers);
        let uncertain = inverse.solve(Mat::<f64>::identity(count, count));
        likelihood.is_finite().then_some(Self {
            covariance,
            numbers,
            uncertain,
            residuals,
            weighted,
            likelihood,
        })
    }
}

impl<'a> Model<'a> {
    pub fn new(blocks: &'a Blocks, nominal: &'a dyn Fn(f64) -> f64, shape: &'a Shape) -> Self {
        let middle = blocks.places.iter().sum::<f64>() / blocks.len() as f64;
        let along = blocks.places.iter().map(|place| (place - middle) / blocks.span()).collect();
        Self { blocks, nominal, shape, along }
    }

    /// What the model has worn off (m) at each place.
    pub fn worn(&self, shift: f64, grown: f64) -> Vec<f64> {
        self.blocks.places.iter().map(|place| self.shape.worn(place - shift, grown)).collect()
    }

    /// Heights of the model (m).
    pub fn heights(&self, shift: f64, grown: f64) -> Vec<f64> {
        let height = |place: &f64| {
            let place = place - shift;
            (self.nominal)(place) - self.shape.worn(place, grown)
        };
        self.blocks.places.iter().map(height).collect()
    }

    /// The columns of height, tilt and growth, and the heights that they are to make up.
    pub fn linear(&self, shift: f64, grown: f64) -> (Vec<Vec<f64>>, Vec<f64>) {
        // A derivative over a few per cent: depths are cubic at most in places.
        let [low, high] = [0.98, 1.02].map(|factor| self.heights(shift, factor * grown));
        let growth: Vec<f64> =
            low.iter().zip(&high).map(|(low, high)| (high - low) / (0.04 * grown)).collect();
        let left = |((z, model), growth): ((&f64, &f64), &f64)| z - model + growth * grown;
        let model = self.heights(shift, grown);
        let heights = self.blocks.heights.iter().zip(&model).zip(&growth).map(left).collect();
        (vec![vec![1.0; self.blocks.len()], self.along.clone(), growth], heights)
    }

    /// The columns of height and tilt, and the heights less the model's.
    pub fn line(&self, shift: f64, grown: f64) -> (Vec<Vec<f64>>, Vec<f64>) {
        let model = self.heights(shift, grown);
        let heights = self.blocks.heights.iter().zip(&model).map(|(z, model)| z - model).collect();
        (vec![vec![1.0; self.blocks.len()], self.along.clone()], heights)
    }

    /// A step (m) of places over which a section hardly bends, and that is seen between blocks.
    pub fn near(&self, grown: f64) -> f64 {
        (1e-3 * self.shape.width(grown)).max(0.2 * self.blocks.step())
    }

    /// How heights change with the place.
    pub fn by_place(&self, shift: f64, grown: f64) -> Vec<f64> {
        let step = self.near(grown);
        let [low, high] = [-step, step].map(|step| self.heights(shift + step, grown));
        low.iter().zip(&high).map(|(low, high)| (high - low) / (2.0 * step)).collect()
    }

    /// The covariance of readings with these weights, where so much is worn off (m).
    pub fn covariance(
        &self,
        scatter: Scatter,
        weights: &[f64],
        worn: &[f64],
    ) -> Option<Covariance> {
        let places = &self.blocks.places;
        let noise = scatter.noise * scatter.noise;
        Covariance::of(Mat::from_fn(places.len(), places.len(), |i, j| {
            let far = places[i] - places[j];
            let own = if i == j { noise / weights[i] } else { 0.0 };
            own + scatter.texture(far) + scatter.misfit(far) * worn[i] * worn[j]
        }))
    }
}

/// The product of two vectors.
pub(super) fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

/// What a positive matrix times gives columns; `None` where it is not positive.
pub(super) fn solved(matrix: &Mat<f64>, columns: &Mat<f64>) -> Option<Mat<f64>> {
    Some(matrix.llt(Side::Lower).ok()?.solve(columns))
}
