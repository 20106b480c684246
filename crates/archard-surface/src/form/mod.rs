//! Nominal shapes, to be taken off: spheres and cylinders that fit best by nonlinear least squares.
//!
//! The sum of the squares of vertical distances is least, over all points that were measured. The unknowns are height and tangent plane in
//! the middle of the map, the curvature, and the direction of a cylinder (see [`shape`]); a plane is the curvature zero, so that
//! convex, flat and concave surfaces are one family. Gauss's and Newton's method starts from the best polynomial of second degree and
//! goes on until rounding hides what it gains.

mod jackknife;
mod shape;

use crate::fit::Normal;
use crate::level::{Level, Polynomial};
use crate::map::HeightMap;
use shape::{CURVATURE, Shape, Unknowns};

/// A nominal shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// A sphere.
    Sphere,
    /// A cylinder, whose axis lies in any direction.
    Cylinder,
    /// A cylinder whose axis lies along x, seen from above.
    CylinderX,
    /// A cylinder whose axis lies along y, seen from above.
    CylinderY,
}

/// The shape that fits a map best.
#[derive(Debug, Clone, PartialEq)]
pub struct Nominal {
    /// Curvature (1/m), the inverse of the radius: positive of a convex surface, negative of a concave one.
    pub curvature: f64,
    /// Standard deviation (1/m) of the curvature, see [`Nominal::of`]; zero where the radius was given.
    pub deviation: f64,
    /// Root of the mean square (m) of what the shape leaves.
    pub rest: f64,
    shape: Shape,
    unknowns: Unknowns,
}

/// Why a shape cannot be fitted.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NoForm {
    /// The map is wider than the shape.
    #[error("a radius of {radius:e} m is too small: the shape does not reach over the map")]
    Small {
        /// The radius (m) that was given.
        radius: f64,
    },
    /// No least sum of squares was found.
    #[error(
        "no such shape fits: the sum of squares still falls after {0} steps; mark what does not belong to it as not measured"
    )]
    NotConverged(usize),
    /// The heights are too large or too few for the equations.
    #[error("no such shape fits: the heights leave its equations without a solution")]
    Unsolvable,
}

/// Most steps of Gauss and Newton; the method gains digits in each.
const STEPS: usize = 100;
/// Most times that a step or a curvature is halved, down to rounding.
const HALVINGS: usize = 60;

impl Form {
    /// All, by the names that cases have for them.
    pub const ALL: [(&'static str, Self); 4] = [
        ("sphere", Self::Sphere),
        ("cylinder", Self::Cylinder),
        ("cylinder_x", Self::CylinderX),
        ("cylinder_y", Self::CylinderY),
    ];
}

impl Nominal {
    /// The shape that fits a map best, of that radius (m) if it is given.
    ///
    /// The standard deviation of the curvature is that of a delete-a-group jackknife (H. R. Künsch, *Ann. Statist.* 17 (1989) 1217) over
    /// 8 x 8 blocks of the map, linear in what each block counts. Neighbouring residuals go together on real surfaces, and a formula for
    /// independent ones would be too small by the root of the points in a patch that goes together. Blocks keep such patches whole but
    /// for those on their edges: patches as wide as a third of a block, a 24th of the map, make the deviation a ninth too small.
    ///
    /// # Errors
    /// If the given radius is too small for the map, or nothing fits.
    pub fn of(map: &HeightMap, form: Form, radius: Option<f64>) -> Result<Self, NoForm> {
        let (start, shape) = start(map, form);
        let mut fit = Fit { map, shape, unknowns: start };
        let within = (0..HALVINGS).any(|_| {
            let within = fit.squares(&fit.unknowns).is_finite();
            if !within {
                fit.unknowns[CURVATURE] *= 0.5;
            }
            within
        });
        if !within {
            return Err(NoForm::Unsolvable);
        }
        fit.solve()?;
        if let Some(radius) = radius {
            fit.shape.given = Some((1.0 / radius).copysign(fit.unknowns[CURVATURE]));
            if !fit.squares(&fit.unknowns).is_finite() {
                return Err(NoForm::Small { radius });
            }
            fit.solve()?;
        }
        let Fit { shape, unknowns, .. } = fit;
        let count = map.measured().count() as f64;
        Ok(Self {
            curvature: shape.curvature(&unknowns),
            deviation: jackknife::deviation(&fit),
            rest: (fit.squares(&unknowns) / count).sqrt(),
            shape,
            unknowns,
        })
    }

    /// The height (m) at a place (m) from the middle of the map; not a number beyond the shape.
    pub fn height(&self, place: [f64; 2]) -> f64 {
        self.shape.at(&self.unknowns, place).map_or(f64::NAN, |(height, _)| height)
    }

    /// The radius (m) and its standard deviation, that of the curvature over the square of the curvature; no numbers of a plane.
    pub fn radius(&self) -> [f64; 2] {
        [1.0 / self.curvature.abs(), self.deviation / self.curvature.powi(2)]
    }

    /// The angle (rad) from x to the axis of a cylinder, seen from above, between -pi/2 and pi/2; `None` of a sphere.
    pub fn direction(&self) -> Option<f64> {
        self.shape.direction(&self.unknowns)
    }
}

impl HeightMap {
    /// The map less a nominal shape; what lies beyond the shape is not measured.
    #[must_use]
    pub fn without(&self, nominal: &Nominal) -> Self {
        self.less(|place| nominal.height(place))
    }
}

/// A fit under way.
struct Fit<'a> {
    map: &'a HeightMap,
    shape: Shape,
    unknowns: Unknowns,
}

impl Fit<'_> {
    /// The sum of squares (m^2); infinite where a point lies beyond the shape.
    fn squares(&self, unknowns: &Unknowns) -> f64 {
        let rest = |(place, height): ([f64; 2], f64)| {
            self.shape
                .at(unknowns, place)
                .map_or(f64::INFINITY, |(shape, _)| (height - shape).powi(2))
        };
        self.map.measured().map(rest).sum()
    }

    /// The equations of points for a change of the unknowns, each put into the sum that is asked for.
    fn linear(&self, sums: &mut [Normal], which: impl Fn([f64; 2]) -> usize) {
        for (place, height) in self.map.measured() {
            if let Some((shape, slopes)) = self.shape.at(&self.unknowns, place) {
                sums[which(place)].add(&self.shape.free(&slopes), height - shape);
            }
        }
    }

    fn solve(&mut self) -> Result<(), NoForm> {
        let mut sum = self.squares(&self.unknowns);
        for _ in 0..STEPS {
            let mut normal = [Normal::new(self.shape.count())];
            self.linear(&mut normal, |_| 0);
            let step = normal[0].solved();
            let gain = normal[0].gain(&step);
            if gain.is_nan() {
                return Err(NoForm::Unsolvable);
            }
            if gain <= f64::EPSILON * sum {
                return Ok(());
            }
            let shorter = (0..HALVINGS)
                .map(|times| self.shape.moved(&self.unknowns, &step, 0.5f64.powi(times as i32)));
            let better =
                shorter.map(|next| (self.squares(&next), next)).find(|(next, _)| *next < sum);
            // Rounding hides what a step gains: the sum is least.
            let Some((least, next)) = better else { return Ok(()) };
            (sum, self.unknowns) = (least, next);
        }
        Err(NoForm::NotConverged(STEPS))
    }
}

/// Where the fit begins: at the best polynomial of second degree.
fn start(map: &HeightMap, form: Form) -> (Unknowns, Shape) {
    let polynomial = Polynomial::of(map, Level::Quadratic);
    let [a, b] = [0, 1].map(|axis| map.place(axis, map.elements()[axis] - 1));
    let z = |x: f64, y: f64| polynomial.height([x, y]);
    // Differences of a polynomial of second degree are exact.
    let middle = z(0.0, 0.0);
    let slope = [(z(a, 0.0) - z(-a, 0.0)) / (2.0 * a), (z(0.0, b) - z(0.0, -b)) / (2.0 * b)];
    let bow = [
        (z(a, 0.0) + z(-a, 0.0) - 2.0 * middle) / (a * a),
        (z(0.0, b) + z(0.0, -b) - 2.0 * middle) / (b * b),
    ];
    let twist = (z(a, b) - z(a, -b) - z(-a, b) + z(-a, -b)) / (4.0 * a * b);
    shape::nearest(form, middle, slope, [bow[0], twist, bow[1]])
}

#[cfg(test)]
mod tests;
