//! What an element does by the images of a layer, where these are farther away than it is wide: as points that Gauss's rule places.
//!
//! With rho^2 = r^2 + D^2 and u = (rho - D)/r, a wave of order n in the angle that decays by exp(-k D) is, integrated over all k,
//!
//! ```text
//! exp(-kD) Jn(kr)        u^n/rho
//! k exp(-kD) Jn(kr)      u^n (n rho + D)/rho^3
//! k^2 exp(-kD) Jn(kr)    u^n ((n^2 - 1) rho^2 + 3 n D rho + 3 D^2)/rho^5
//! ```
//!
//! over 2 pi (from I. S. Gradshteyn & I. M. Ryzhik, *Table of Integrals, Series, and Products*, 6.611, and its derivatives). All of an angle
//! follows from 15 functions of r, which are kept on a grid of asinh(r/D) and interpolated.

use std::f64::consts::PI;
use std::sync::OnceLock;

use super::layers::Seen;
use super::rest::{Rest, at_corner};
use super::sums::Sums;

/// Functions of the distance.
const FUNCTIONS: usize = 15;
/// Points that are interpolated between.
const POINTS: usize = 6;
/// The step of the grid in asinh(r/D): six points with that step are within 1e-8 of what they have at most.
const STEP: f64 = 0.05;
/// Gauss's rules: how far away the nearest of an element is at least, over its width, and the points from -1 to 1 with their weights.
/// At most 1e-5 of the stress of one element is missed: h^(2n) f^(2n) (n!)^4 / ((2n + 1) (2n)!^3), with f as 1/rho^2.
const RULES: [(f64, &[[f64; 2]]); 3] = [
    (250.0, &[[0.0, 2.0]]),
    (8.0, &[[-0.577_350_269_189_625_8, 1.0], [0.577_350_269_189_625_8, 1.0]]),
    (
        2.5,
        &[
            [-0.861_136_311_594_052_6, 0.347_854_845_137_453_9],
            [-0.339_981_043_584_856_3, 0.652_145_154_862_546_1],
            [0.339_981_043_584_856_3, 0.652_145_154_862_546_1],
            [0.861_136_311_594_052_6, 0.347_854_845_137_453_9],
        ],
    ),
];

/// Functions of the distance along the surface, at a depth.
#[derive(Debug)]
pub(super) struct Far {
    seen: Vec<Seen>,
    /// The distance of the nearest image (m).
    near: f64,
    /// At the points of the grid, that of r = 0 after those before it, each once it is needed; none where a single image is summed as fast.
    grid: Vec<OnceLock<[f64; FUNCTIONS]>>,
}

/// Points on the grid below r = 0.
const BELOW: usize = POINTS / 2;
/// How far the grid reaches, in distances of the nearest image: farther than any frame is wide. Its size goes with the logarithm.
const REACH: f64 = 1e7;

impl Far {
    pub fn of(seen: Vec<Seen>) -> Self {
        let near = seen.iter().map(|image| image.distance).fold(f64::INFINITY, f64::min);
        let points = (REACH.asinh() / STEP).ceil() as usize + 2 * POINTS;
        let points = if seen.len() > 1 { points } else { 0 };
        Self { seen, near, grid: (0..points).map(|_| OnceLock::new()).collect() }
    }

    /// The distance of the nearest image (m).
    pub fn near(&self) -> f64 {
        self.near
    }

    /// What an element around a place does there, `from` it along x and y to the point, of these half widths (m).
    pub fn element(&self, from: [f64; 2], half: [f64; 2]) -> Rest {
        let away = from[0].hypot(from[1]).hypot(self.near);
        let width = 2.0 * half[0].max(half[1]);
        let Some((_, rule)) = RULES.iter().find(|(least, _)| away >= least * width) else {
            return self.exactly(from, half);
        };
        let mut sum: Rest = Default::default();
        for [dx, one] in rule.iter() {
            for [dy, other] in rule.iter() {
                let at = [from[0] + dx * half[0], from[1] + dy * half[1]];
                add(&mut sum, &self.point(at), one * other * half[0] * half[1]);
            }
        }
        sum
    }

    fn exactly(&self, [x, y]: [f64; 2], [a, b]: [f64; 2]) -> Rest {
        let mut sum: Rest = Default::default();
        for (dx, dy, sign) in [(a, b, 1.0), (-a, b, -1.0), (a, -b, -1.0), (-a, -b, 1.0)] {
            let own = at_corner(&self.seen, [x + dx, y + dy]);
            add(&mut sum, &own, sign / (2.0 * PI));
        }
        sum
    }

    /// Adds what a force (N) along x, y and into the body does so far away (m).
    pub fn force(&self, from: [f64; 2], force: &[f64; 3], sums: &mut Sums) {
        let (stresses, moved) = self.point(from);
        for axis in 0..3 {
            (0..6).for_each(|own| sums.0[own] += force[axis] * stresses[axis][own]);
            (0..3).for_each(|own| sums.1[own] += force[axis] * moved[axis][own]);
        }
    }

    /// What a unit force does so far away (m).
    fn point(&self, [x, y]: [f64; 2]) -> Rest {
        let r = (x * x + y * y).sqrt();
        let [c, s] = if r > 0.0 { [x / r, y / r] } else { [1.0, 0.0] };
        let [zz, m, d, sz, mean, half, third, tz, even, odd, along, into, pushed, turned, sunk] =
            self.functions(r);
        let (c2, s2) = (c * c - s * s, 2.0 * c * s);
        let (c3, s3) = (c * c2 - s * s2, s * c2 + c * s2);
        let stresses = [
            [
                c * (mean + half) + c3 * third,
                c * (mean - half) - c3 * third,
                c * tz,
                s * half + s3 * third,
                even - c2 * odd,
                -s2 * odd,
            ],
            [
                s * (mean - half) + s3 * third,
                s * (mean + half) - s3 * third,
                s * tz,
                c * half - c3 * third,
                -s2 * odd,
                even + c2 * odd,
            ],
            [m - c2 * d, m + c2 * d, zz, -s2 * d, c * sz, s * sz],
        ];
        let moved = [
            [pushed - c2 * turned, -s2 * turned, c * sunk],
            [-s2 * turned, pushed + c2 * turned, s * sunk],
            [c * along, s * along, into],
        ];
        (stresses, moved)
    }

    /// All functions at a distance (m).
    fn functions(&self, r: f64) -> [f64; FUNCTIONS] {
        if self.grid.is_empty() {
            return self.summed(r);
        }
        let at = (r / self.near).asinh() / STEP;
        let first = (at.floor() as usize).min(self.grid.len() - POINTS - 1);
        let t = at - first as f64;
        // Lagrange's polynomials through -2, ..., 3.
        let [a, b, d, e, f] = [t + 2.0, t + 1.0, t - 1.0, t - 2.0, t - 3.0];
        let weights = [
            -b * t * d * e * f / 120.0,
            a * t * d * e * f / 24.0,
            -a * b * d * e * f / 12.0,
            a * b * t * e * f / 12.0,
            -a * b * t * d * f / 24.0,
            a * b * t * d * e / 120.0,
        ];
        let mut sum = [0.0; FUNCTIONS];
        for (index, weight) in weights.iter().enumerate() {
            let point = first + 1 + index;
            let at = || (point as f64 - BELOW as f64) * STEP;
            let row = self.grid[point].get_or_init(|| self.summed(self.near * at().sinh()));
            sum.iter_mut().zip(row).for_each(|(sum, own)| *sum += weight * own);
        }
        sum
    }

    /// The functions at a distance (m): the sums over all images. At distances below zero those of odd order are reversed.
    fn summed(&self, r: f64) -> [f64; FUNCTIONS] {
        let mut sum = [0.0; FUNCTIONS];
        for image in &self.seen {
            let d = image.distance;
            let rho = (r * r + d * d).sqrt();
            // Divisions take longer than all else.
            let (one, u) = (1.0 / rho, r / (rho + d));
            let [scale, square] = [one / (2.0 * PI), one * one];
            let moved = [scale, scale * u, scale * u * u, scale * u * u * u];
            let even = [0, 1, 2, 3].map(|n| moved[n] * square * (n as f64 * rho + d));
            let times = [0, 1, 2, 3].map(|n| {
                let order = n as f64;
                let near = 3.0 * d * (order * rho + d);
                moved[n] * square * square * ((order * order - 1.0) * rho * rho + near)
            });
            let kernels = [(even, 1.0, 0), (times, image.from, 1)];
            for (kernel, factor, part) in kernels {
                let [zz, ss, nn, sz, tz, ts, tn, tsz, nz, sn] =
                    image.stress[part].map(|own| own * factor);
                let apart = 0.5 * (ts - tn);
                let own = [
                    zz * kernel[0],
                    0.5 * (ss + nn) * kernel[0],
                    0.5 * (ss - nn) * kernel[2],
                    -sz * kernel[1],
                    -0.5 * (ts + tn) * kernel[1],
                    -0.5 * (apart + sn) * kernel[1],
                    0.5 * (apart - sn) * kernel[3],
                    -tz * kernel[1],
                    0.5 * (tsz + nz) * kernel[0],
                    0.5 * (tsz - nz) * kernel[2],
                ];
                sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
            }
            let kernels = [(moved, 1.0, 0), (even, image.from, 1)];
            for (kernel, factor, part) in kernels {
                let [along, into, pushed, sunk, across] = image.moved[part].map(|own| own * factor);
                let own = [
                    -along * kernel[1],
                    into * kernel[0],
                    0.5 * (pushed + across) * kernel[0],
                    0.5 * (pushed - across) * kernel[2],
                    -sunk * kernel[1],
                ];
                sum[10..].iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
            }
        }
        sum
    }
}

/// Adds so many times what there is.
fn add(sum: &mut Rest, own: &Rest, factor: f64) {
    for axis in 0..3 {
        (0..6).for_each(|i| sum.0[axis][i] += factor * own.0[axis][i]);
        (0..3).for_each(|i| sum.1[axis][i] += factor * own.1[axis][i]);
    }
}
