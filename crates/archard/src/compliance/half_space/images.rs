//! A stack of layers as a half-space and images at depths below its surface.
//!
//! The compliance of a stack over that of its uppermost layer is written as a sum of exponentials,
//!
//! ```text
//! k C(k) = C_top + sum a_j exp(-k d_j)
//! ```
//!
//! for its four scalars at once. Each term is the compliance of a half-space as it is felt from a depth d_j, whose influence on
//! rectangles has a closed form: with X and Y from the corners of an element, R^2 = X^2 + Y^2 + d^2,
//!
//! ```text
//! exp(-kd)/k           X asinh(Y/hypot(X, d)) + Y asinh(X/hypot(Y, d)) - d atan(XY/(d R))
//! kx^2/k^3 exp(-kd)    X asinh(Y/hypot(X, d)) + d [atan(d Y/(X R)) - atan(Y/X)]
//! kx ky/k^3 exp(-kd)   R - d ln(R + d)
//! i kx/k^2 exp(-kd)    X [atan(d Y/(X R)) - atan(Y/X)] - Y ln(R + d) - d asinh(Y/hypot(X, d))
//! ```
//!
//! over 2 pi. The depths lie evenly on a logarithmic scale between the thickness of the uppermost layer and what the stack reaches;
//! the weights follow from least squares over all wave numbers that matter, and their sum is exact, so that the far field is that
//! of the base.

use std::f64::consts::PI;

use faer::Mat;

use super::influence::Corner;
use super::sphere;
use super::stack::{Scalars, Stack};
use crate::body::profile::Round;
use crate::body::{Layer, Material};
use crate::frame::Wrap;

/// Images of a stack: with as many, stacks whose moduli differ by up to tenfold are met to 1e-7 to 1e-5. By how much a stack is
/// missed is computed, and bounded by `MISSED`.
pub(super) const COUNT: usize = 32;
/// The same of round layers, whose compliance approaches that of a half-space by 1/(kR) as waves become shorter, and the depth of the
/// first one over the radius: shells and rings of a fiftieth to twice their radius are met to 1e-5.
pub(super) const ROUND: (usize, f64) = (48, 1e-3);
/// Wave numbers that the weights are fitted on, for each image.
pub(super) const SAMPLES: usize = 25;
/// The depth of the first image over the thickness of the uppermost layer, and that of the last over the reach of the stack.
pub(super) const DEPTHS: [f64; 2] = [0.8, 12.0];
/// The least wave number over the deepest image, and the greatest over the thickness of the uppermost layer: exp(-20) is left.
pub(super) const WAVES: [f64; 2] = [1e-3, 25.0];
/// What the sum of the weights, which is known, counts in the least squares: it is met to the square of this below what the
/// others miss, and much more would drown them in rounding.
const EXACTLY: f64 = 1e4;

/// An image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Image {
    /// How far below the surface (m).
    pub depth: f64,
    /// What it adds to the compliance times the wave number, over 2 pi (1/Pa).
    pub scalars: Scalars,
}

impl Image {
    /// What it adds under an element to the displacement along x under a traction along x, from a corner (m/Pa).
    pub fn tangential(&self, corner: &Corner) -> f64 {
        let [along, _, _, across] = self.scalars;
        let [x, y] = [corner.x, corner.y];
        let d = self.depth;
        // kx^2/k^3 and ky^2/k^3.
        let along = along * (x * (y / x.hypot(d)).asinh() + d * self.turn(x, y));
        along + across * (y * (x / y.hypot(d)).asinh() + d * self.turn(y, x))
    }

    /// The same normally, for a scalar of one.
    pub fn normal(&self, &Corner { x, y, .. }: &Corner) -> f64 {
        let d = self.depth;
        let far = x.hypot(y).hypot(d);
        x * (y / x.hypot(d)).asinh() + y * (x / y.hypot(d)).asinh() - d * (x * y / (d * far)).atan()
    }

    /// The displacement along x under a traction along y.
    pub fn aslant(&self, &Corner { r, .. }: &Corner) -> f64 {
        let [along, _, _, across] = self.scalars;
        let far = r.hypot(self.depth);
        (along - across) * (far - self.depth * (far + self.depth).ln())
    }

    /// The displacement along x under a pressure, for a scalar of one.
    pub fn coupling(&self, &Corner { x, y, r, .. }: &Corner) -> f64 {
        let d = self.depth;
        y * (r.hypot(d) + d).ln() + d * (y / x.hypot(d)).asinh() - x * self.turn(x, y)
    }

    /// atan(d y/(x R)) - atan(y/x).
    fn turn(&self, x: f64, y: f64) -> f64 {
        let far = x.hypot(y).hypot(self.depth);
        (self.depth * y).atan2(x * far) - y.atan2(x)
    }

    /// Under a strip, from an edge: along or across the strip and normally, for a scalar of one.
    pub fn strip(&self, x: f64) -> f64 {
        let d = self.depth;
        2.0 * x - x * (x * x + d * d).ln() - 2.0 * d * (x / d).atan()
    }

    /// The displacement along x under a pressure on a strip, from an edge, for a scalar of one.
    pub fn pull(&self, x: f64) -> f64 {
        let d = self.depth;
        2.0 * x * (x / d).atan() - d * (x * x + d * d).ln()
    }
}

/// The images of balls, of what is around them and of layers. What couples pressures and friction has the sign of body 1.
pub(super) fn of_bodies(
    materials: [Option<&Material>; 2],
    layers: [&[Layer]; 2],
    wrap: Option<Wrap>,
) -> Vec<Image> {
    let of = |body: usize| {
        let hollow = wrap.filter(|wrap| wrap.hollow == body).map(|wrap| (wrap.round, wrap.radius));
        let (layers, base) = (layers[body], materials[body]);
        let stack = Stack { layers, base, hollow };
        let images = match (wrap.filter(|wrap| wrap.round == Round::Sphere), base, layers) {
            (Some(wrap), Some(material), _) if wrap.hollow != body => {
                sphere::ball(material, wrap.radius).0
            }
            (Some(_), Some(_), _) | (_, _, [_, ..]) => images(&stack).0,
            _ => vec![],
        };
        let sign = if body == 0 { 1.0 } else { -1.0 };
        images.into_iter().map(move |image| Image {
            scalars: [0, 1, 2, 3].map(|i| if i == 1 { sign } else { 1.0 } * image.scalars[i]),
            ..image
        })
    };
    of(0).chain(of(1)).collect()
}

/// The images of a stack, and by how much they miss its compliance at most, relative to that of its uppermost layer; none, and
/// without bound, where their equations have no solution.
pub(super) fn images(stack: &Stack<'_>) -> (Vec<Image>, f64) {
    if let Some((Round::Sphere, radius)) = stack.hollow {
        return sphere::hollow(stack, radius);
    }
    let (reach, thickness) = (stack.reach(), stack.layers[0].thickness);
    let (count, first) = match stack.hollow {
        Some((_, radius)) => (ROUND.0, (DEPTHS[0] * thickness).min(ROUND.1 * radius)),
        None => (COUNT, DEPTHS[0] * thickness),
    };
    let last = DEPTHS[1] * reach;
    let depths = geometric(first, last, count);
    let waves = geometric(WAVES[0] / last, DEPTHS[0] * WAVES[1] / first, SAMPLES * count);
    let (top, bottom) = (stack.top(), stack.bottom());
    let less_top = |scalars: Scalars| -> Scalars { [0, 1, 2, 3].map(|i| scalars[i] - top[i]) };
    let wanted: Vec<Scalars> = waves.iter().map(|&k| less_top(stack.compliance(k))).collect();
    let fitted = fit((&depths, reach), &waves, (&wanted, Some(less_top(bottom))));
    let Some((weights, missed)) = fitted else { return (vec![], f64::INFINITY) };
    let image = |(depth, weights): (&f64, Scalars)| Image {
        depth: *depth,
        scalars: weights.map(|weight| weight / (2.0 * PI)),
    };
    (depths.iter().zip(weights).map(image).collect(), missed / top[2])
}

/// Weights of exponentials of these depths (m) whose sum is what is wanted at the waves (1/m), and in the limit of the longest where
/// there is one; by how much they miss it at most. `None` where their equations have no solution.
pub(super) fn fit<const N: usize>(
    (depths, reach): (&[f64], f64),
    waves: &[f64],
    (wanted, longest): (&[[f64; N]], Option<[f64; N]>),
) -> Option<(Vec<[f64; N]>, f64)> {
    // The longest waves count as what they do to displacements.
    let weight = |row: usize| match waves.get(row) {
        Some(k) => (k * reach).recip().max(1.0),
        None => EXACTLY,
    };
    let term = |row: usize, image: usize| match waves.get(row) {
        Some(k) => (-k * depths[image]).exp(),
        None => 1.0,
    };
    let sought: Vec<[f64; N]> = wanted.iter().copied().chain(longest).collect();
    let (rows, count) = (sought.len(), depths.len());
    let terms = Mat::from_fn(rows, count, |row, image| weight(row) * term(row, image));
    let sums = Mat::from_fn(rows, N, |row, i| weight(row) * sought[row][i]);
    let weights = least_squares(&terms, &sums)?;
    let missed = wanted.iter().enumerate().flat_map(|(row, wanted)| {
        let (weights, term) = (&weights, &term);
        (0..N).map(move |i| {
            let sum: f64 = (0..count).map(|image| weights[(image, i)] * term(row, image)).sum();
            (wanted[i] - sum).abs()
        })
    });
    let missed = missed.fold(0.0, f64::max);
    let weights = (0..count).map(|image| std::array::from_fn(|i| weights[(image, i)])).collect();
    Some((weights, missed))
}

/// The smallest weights that solve A w = b in the sense of least squares, apart from rounding; `None` where a number is not finite.
fn least_squares(terms: &Mat<f64>, sums: &Mat<f64>) -> Option<Mat<f64>> {
    let parts = terms.thin_svd().ok()?;
    let values = parts.S().column_vector();
    let projected = parts.U().transpose() * sums;
    let rounding = terms.nrows() as f64 * f64::EPSILON;
    let scaled = Mat::from_fn(values.nrows(), sums.ncols(), |row, column| {
        let kept = values[row] > rounding * values[0];
        if kept { projected[(row, column)] / values[row] } else { 0.0 }
    });
    Some(parts.V() * scaled)
}

/// Numbers from the first to the last in a constant ratio.
pub(super) fn geometric(first: f64, last: f64, count: usize) -> Vec<f64> {
    let ratio = (last / first).ln() / (count - 1) as f64;
    (0..count).map(|index| first * (ratio * index as f64).exp()).collect()
}
