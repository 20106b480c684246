//! Height of spheres and cylinders, and how it changes with their unknowns.
//!
//! A sphere with the tangent plane w = p x + q y at the height c in the middle of the map is
//!
//! ```text
//! kappa/2 (x^2 + y^2 + w^2) - p x - q y + w = 0,    z = c + w,
//! ```
//!
//! where kappa is the curvature times m, m^2 = 1 + p^2 + q^2. Of a cylinder u runs along its axis, seen from above, and v across it; the axis lies
//! in the tangent plane w = g u + h v. With o = w - g u its surface is
//!
//! ```text
//! kappa/2 (v^2 + o^2/(1 + g^2)) - h v + o = 0,    z = c + g u + o,
//! ```
//!
//! m^2 = 1 + g^2 + h^2. Both are solved for w or o on the side of the map, without a difference of large numbers at small curvatures.

use std::f64::consts::{FRAC_PI_2, PI};

use super::Form;

/// Height c (m), slopes p and q, or g and h, kappa (1/m), and the angle (rad) from x to u.
pub(super) type Unknowns = [f64; 5];

/// Where kappa is.
pub(super) const CURVATURE: usize = 3;
const ANGLE: usize = 4;

/// Which shape it is, and what is known of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shape {
    form: Form,
    /// The curvature (1/m), where it is given.
    pub(super) given: Option<f64>,
}

impl Shape {
    /// The height (m) at a place (m) and its derivatives by the unknowns; `None` beyond the shape.
    pub(super) fn at(&self, unknowns: &Unknowns, place: [f64; 2]) -> Option<(f64, Unknowns)> {
        let [middle, one, other, _, angle] = *unknowns;
        let kappa = self.kappa(unknowns);
        let (height, mut slopes) = match self.form {
            Form::Sphere => sphere([one, other], kappa, place)?,
            _ => cylinder([one, other], kappa, angle, place)?,
        };
        if let Some(curvature) = self.given {
            let scale = curvature / length([one, other]);
            slopes[1] += slopes[CURVATURE] * scale * one;
            slopes[2] += slopes[CURVATURE] * scale * other;
        }
        Some((middle + height, slopes))
    }

    /// The curvature (1/m).
    pub(super) fn curvature(&self, unknowns: &Unknowns) -> f64 {
        self.kappa(unknowns) / length([unknowns[1], unknowns[2]])
    }

    fn kappa(&self, unknowns: &Unknowns) -> f64 {
        self.given
            .map_or(unknowns[CURVATURE], |curvature| curvature * length([unknowns[1], unknowns[2]]))
    }

    /// The angle (rad) from x to the axis of a cylinder, between -pi/2 and pi/2.
    pub(super) fn direction(&self, unknowns: &Unknowns) -> Option<f64> {
        let angle = unknowns[ANGLE];
        (self.form != Form::Sphere).then(|| angle - PI * (angle / PI).round())
    }

    /// How many unknowns are free.
    pub(super) fn count(&self) -> usize {
        self.is_free().into_iter().filter(|free| *free).count()
    }

    /// The values of the unknowns that are free.
    pub(super) fn free(&self, values: &Unknowns) -> Vec<f64> {
        let values = values.iter().zip(self.is_free()).filter(|(_, free)| *free);
        values.map(|(value, _)| *value).collect()
    }

    /// The unknowns a share of a step of the free ones on.
    pub(super) fn moved(&self, unknowns: &Unknowns, step: &[f64], share: f64) -> Unknowns {
        let mut next = *unknowns;
        let free = next.iter_mut().zip(self.is_free()).filter(|(_, free)| *free);
        free.zip(step).for_each(|((value, _), step)| *value += share * step);
        next
    }

    fn is_free(&self) -> [bool; 5] {
        [true, true, true, self.given.is_none(), self.form == Form::Cylinder]
    }
}

/// The shape that touches a surface of such height (m), slopes and second derivatives (1/m; along x, mixed, along y) in the middle.
pub(super) fn nearest(
    form: Form,
    height: f64,
    slope: [f64; 2],
    bend: [f64; 3],
) -> (Unknowns, Shape) {
    let [along_x, mixed, along_y] = bend;
    let mean = 0.5 * (along_x + along_y);
    let shape = Shape { form, given: None };
    let angle = match form {
        Form::Sphere => return ([height, slope[0], slope[1], -mean, 0.0], shape),
        Form::CylinderX => 0.0,
        Form::CylinderY => FRAC_PI_2,
        // The principal direction of the larger second derivative, or of the other one; the axis lies across the one that is larger in size.
        Form::Cylinder => {
            let upper = 0.5 * (2.0 * mixed).atan2(along_x - along_y);
            if mean >= 0.0 { upper + FRAC_PI_2 } else { upper }
        }
    };
    let (sin, cos) = angle.sin_cos();
    let across = along_x * sin * sin - 2.0 * mixed * sin * cos + along_y * cos * cos;
    let turned = [slope[0] * cos + slope[1] * sin, slope[1] * cos - slope[0] * sin];
    ([height, turned[0], turned[1], -across, angle], shape)
}

/// The length of the vector normal to a tangent plane of those slopes.
fn length(slopes: [f64; 2]) -> f64 {
    (1.0 + slopes[0].powi(2) + slopes[1].powi(2)).sqrt()
}

/// Height above the middle and derivatives of a sphere.
fn sphere([p, q]: [f64; 2], kappa: f64, [x, y]: [f64; 2]) -> Option<(f64, Unknowns)> {
    let square = x * x + y * y;
    let rise = 0.5 * kappa * square - p * x - q * y;
    let root = root(1.0 - 2.0 * kappa * rise)?;
    let w = -2.0 * rise / (1.0 + root);
    Some((w, [1.0, x / root, y / root, -0.5 * (square + w * w) / root, 0.0]))
}

/// Height above the middle and derivatives of a cylinder.
fn cylinder([g, h]: [f64; 2], kappa: f64, angle: f64, [x, y]: [f64; 2]) -> Option<(f64, Unknowns)> {
    let (sin, cos) = angle.sin_cos();
    let (u, v) = (x * cos + y * sin, y * cos - x * sin);
    let steep = 1.0 + g * g;
    let rise = 0.5 * kappa * v * v - h * v;
    let root = root(1.0 - 2.0 * kappa * rise / steep)?;
    let o = -2.0 * rise / (1.0 + root);
    let by_slope = u + kappa * o * o * g / (steep * steep * root);
    let by_curvature = -0.5 * (v * v + o * o / steep) / root;
    let by_angle = g * v + u * (kappa * v - h) / root;
    Some((g * u + o, [1.0, by_slope, v / root, by_curvature, by_angle]))
}

/// The root of what is positive.
fn root(square: f64) -> Option<f64> {
    (square > 0.0).then(|| square.sqrt())
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Form, Shape, Unknowns};

    /// Derivatives against differences over a small step.
    #[test]
    fn derivatives_are_those_of_the_height() {
        let unknowns: Unknowns = [0.2, 0.3, -0.4, 0.5, 0.6];
        for (form, given) in [
            (Form::Sphere, None),
            (Form::Sphere, Some(0.4)),
            (Form::Cylinder, None),
            (Form::Cylinder, Some(-0.4)),
        ] {
            let shape = Shape { form, given };
            let height = |unknowns: &Unknowns| shape.at(unknowns, [0.7, -0.3]).unwrap().0;
            let slopes = shape.at(&unknowns, [0.7, -0.3]).unwrap().1;
            let free = shape.is_free();
            for index in (0..5).filter(|&index| free[index]) {
                let at = |step: f64| {
                    let mut moved = unknowns;
                    moved[index] += step;
                    height(&moved)
                };
                let difference = (at(1e-5) - at(-1e-5)) / 2e-5;
                assert_relative_eq!(
                    slopes[index],
                    difference,
                    max_relative = 1e-8,
                    epsilon = 1e-10
                );
            }
        }
    }

    /// All points of a sphere and of a cylinder have their radius from a centre or an axis, however they are tilted.
    #[test]
    fn points_lie_on_the_shape() {
        let unknowns: Unknowns = [0.2, 0.3, -0.4, 0.5, 0.6];
        let [middle, g, h, _, angle] = unknowns;
        let places = (0..25).map(|i| [0.1 * f64::from(i % 5 - 2), 0.1 * f64::from(i / 5 - 2)]);
        for (form, [p, q]) in [
            (Form::Sphere, [g, h]),
            (
                Form::Cylinder,
                [g * angle.cos() - h * angle.sin(), g * angle.sin() + h * angle.cos()],
            ),
        ] {
            let shape = Shape { form, given: None };
            let radius = 1.0 / shape.curvature(&unknowns);
            let length = (1.0 + p * p + q * q).sqrt();
            let normal = [-p / length, -q / length, 1.0 / length];
            let centre = [-radius * normal[0], -radius * normal[1], middle - radius * normal[2]];
            for [x, y] in places.clone() {
                let z = shape.at(&unknowns, [x, y]).unwrap().0;
                let from = [x - centre[0], y - centre[1], z - centre[2]];
                let axis = [angle.cos(), angle.sin(), g];
                let along = if form == Form::Sphere {
                    0.0
                } else {
                    from.iter().zip(axis).map(|(one, other)| one * other).sum::<f64>()
                        / (1.0 + g * g).sqrt()
                };
                let square: f64 = from.iter().map(|one| one * one).sum();
                assert_relative_eq!((square - along * along).sqrt(), radius, max_relative = 1e-12);
            }
        }
    }
}
