//! Elastic contact of two smooth bodies without friction or wear.
//!
//! H. Hertz (1881), as in K. L. Johnson, *Contact Mechanics* (1985), section 4.2. Under the pressure
//! p0 sqrt(1 - (x/a)^2 - (y/b)^2) two half-spaces of modulus E* give way by
//!
//! ```text
//! (p0 a b / E*) [R_F(0, a^2, b^2) - x^2 R_D(0, b^2, a^2) / 3 - y^2 R_D(0, a^2, b^2) / 3],
//! ```
//!
//! which is Johnson's eqs. 4.25 and 4.26 with Carlson's symmetric integrals R_F and R_D for the
//! complete elliptic ones. They spare the choice of a major axis and keep their digits for circles
//! and for very long ellipses.

use std::f64::consts::PI;

use crate::body::Material;
use ellip::{elliprd, elliprf};

/// The contact of two bodies of constant curvature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hertz {
    /// Semi-axes of the contact along x and y (m).
    pub semi_axes: [f64; 2],
    /// Pressure at the centre (Pa).
    pub peak_pressure: f64,
    /// Approach of the bodies from first touch (m).
    pub approach: f64,
    /// Normal force (N).
    pub load: f64,
}

impl Hertz {
    /// The contact under a load (N) of bodies with these combined curvatures along x and y (1/m)
    /// and this contact modulus E* (Pa).
    ///
    /// `None` unless curvatures, modulus and load are all positive and finite.
    pub fn from_load(curvatures: [f64; 2], contact_modulus: f64, load: f64) -> Option<Self> {
        let shape = Shape::of(curvatures, contact_modulus, load)?;
        let a = (load * shape.bending / (PI * contact_modulus * curvatures[0])).cbrt();
        Some(shape.contact(a, contact_modulus, load))
    }

    /// The contact at an approach (m) of bodies with these combined curvatures along x and y (1/m)
    /// and this contact modulus E* (Pa).
    ///
    /// `None` unless curvatures, modulus and approach are all positive and finite.
    pub fn from_approach(
        curvatures: [f64; 2],
        contact_modulus: f64,
        approach: f64,
    ) -> Option<Self> {
        let shape = Shape::of(curvatures, contact_modulus, approach)?;
        let a = (2.0 * approach * shape.bending / (3.0 * curvatures[0] * shape.sinking)).sqrt();
        let load = PI * contact_modulus * curvatures[0] * a.powi(3) / shape.bending;
        Some(shape.contact(a, contact_modulus, load))
    }

    /// Pressure (Pa) at x and y (m) from the centre.
    pub fn pressure(&self, [x, y]: [f64; 2]) -> f64 {
        let [a, b] = self.semi_axes;
        self.peak_pressure * (1.0 - (x / a).powi(2) - (y / b).powi(2)).max(0.0).sqrt()
    }

    /// Area of the contact (m^2).
    pub fn contact_area(&self) -> f64 {
        PI * self.semi_axes[0] * self.semi_axes[1]
    }
}

/// The contact ellipse scaled to a = 1.
struct Shape {
    /// b / a.
    ratio: f64,
    /// R_D(0, (b/a)^2, 1), to which the curvature along x is proportional.
    bending: f64,
    /// R_F(0, 1, (b/a)^2), to which the approach is proportional.
    sinking: f64,
}

impl Shape {
    /// The shape these combined curvatures (1/m) lead to; `None` unless all numbers are positive and
    /// finite.
    fn of(curvatures: [f64; 2], contact_modulus: f64, loading: f64) -> Option<Self> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let [along_x, along_y] = curvatures;
        if ![along_x, along_y, contact_modulus, loading].into_iter().all(positive) {
            return None;
        }
        let square = squared_axis_ratio(along_x / along_y);
        Some(Self {
            ratio: square.sqrt(),
            bending: elliprd(0.0, square, 1.0).ok()?,
            sinking: elliprf(0.0, 1.0, square).ok()?,
        })
    }

    /// The contact of that semi-axis (m) along x.
    fn contact(&self, a: f64, contact_modulus: f64, load: f64) -> Hertz {
        let semi_axes = [a, self.ratio * a];
        Hertz {
            semi_axes,
            peak_pressure: 1.5 * load / (PI * semi_axes[0] * semi_axes[1]),
            approach: 1.5 * load * self.sinking / (PI * contact_modulus * a),
            load,
        }
    }
}

/// (b/a)^2 for a ratio of the curvatures along x and y: the root q of
/// R_D(0, q, 1) / R_D(0, 1, q) = ratio, by bisection in ln q.
///
/// The ratio rises from 0 to infinity with q and passes 1 at q = 1; the root lies between 1 and the
/// square of the ratio, because b/a lies between 1 and the ratio itself.
fn squared_axis_ratio(curvature_ratio: f64) -> f64 {
    let bending = |y: f64, z: f64| elliprd(0.0, y, z).unwrap_or(f64::INFINITY);
    let ratio = |q: f64| bending(q, 1.0) / bending(1.0, q);
    let far = 2.0 * curvature_ratio.ln();
    let (mut low, mut high) = (far.min(0.0), far.max(0.0));
    while high - low > 1e-15 * (1.0 + high.abs()) {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if ratio(middle.exp()) < curvature_ratio {
            low = middle;
        } else {
            high = middle;
        }
    }
    (0.5 * (low + high)).exp()
}

/// The contact of two cylinders with parallel axes, per length.
///
/// Johnson, *Contact Mechanics*, eqs. 4.43 to 4.45. The approach of cylinders depends on how far below the contact it is
/// measured from, too: see [`Line::sinking`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Half width of the contact (m).
    pub half_width: f64,
    /// Pressure on the middle line (Pa).
    pub peak_pressure: f64,
    /// Normal force per length (N/m).
    pub load_per_length: f64,
}

impl Line {
    /// The contact under a load per length (N/m) of cylinders with this combined curvature (1/m) and
    /// this contact modulus E* (Pa).
    ///
    /// `None` unless all three are positive and finite.
    pub fn from_load(curvature: f64, contact_modulus: f64, load_per_length: f64) -> Option<Self> {
        let given = [curvature, contact_modulus, load_per_length];
        given.iter().all(|value| *value > 0.0 && value.is_finite()).then(|| Self {
            half_width: (4.0 * load_per_length / (PI * contact_modulus * curvature)).sqrt(),
            peak_pressure: (load_per_length * contact_modulus * curvature / PI).sqrt(),
            load_per_length,
        })
    }

    /// How far the surface of a body of that material comes closer to what lies that depth (m) below the middle line, in
    /// plane strain (m): Johnson, eq. 5.58. The approach of two bodies is the sum.
    pub fn sinking(&self, material: &Material, depth: f64) -> f64 {
        let Material { young, poisson, .. } = *material;
        let compliance = (1.0 - poisson * poisson) / (PI * young);
        let logarithm = 2.0 * (2.0 * depth / self.half_width).ln();
        compliance * self.load_per_length * (logarithm - poisson / (1.0 - poisson))
    }

    /// Pressure (Pa) at that distance (m) from the middle line.
    pub fn pressure(&self, distance: f64) -> f64 {
        self.peak_pressure * (1.0 - (distance / self.half_width).powi(2)).max(0.0).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Hertz, Line};

    /// E* of two bodies of one material.
    fn twin(young: f64, poisson: f64) -> f64 {
        0.5 * young / (1.0 - poisson * poisson)
    }

    /// Independent values: sphere of 50 mm, steel on steel, 10.2 N.
    #[test]
    fn sphere_on_flat() {
        let hertz = Hertz::from_load([20.0, 20.0], twin(210e9, 0.3), 10.2).unwrap();
        assert_relative_eq!(hertz.semi_axes[0], 0.1491058e-3, max_relative = 4e-7);
        assert_relative_eq!(hertz.semi_axes[1], 0.1491058e-3, max_relative = 4e-7);
        assert_relative_eq!(hertz.peak_pressure, 219.0547e6, max_relative = 3e-7);
        assert_relative_eq!(hertz.approach, 0.44465074e-6, max_relative = 2e-8);
    }

    /// Independent values: the twin discs of the paper's section 6.3.
    #[test]
    fn twin_discs() {
        let curvatures = [1.0 / 32.5e-3 + 1.0 / 32.3e-3, 8.0];
        let hertz = Hertz::from_load(curvatures, twin(208e9, 0.3), 300.0).unwrap();
        assert_relative_eq!(hertz.semi_axes[0], 0.2165120e-3, max_relative = 3e-7);
        assert_relative_eq!(hertz.semi_axes[1], 0.8265901e-3, max_relative = 1e-7);
        assert_relative_eq!(hertz.peak_pressure, 800.3693e6, max_relative = 1e-7);
        assert_relative_eq!(hertz.approach, 4.1798535e-6, max_relative = 2e-8);
    }

    /// Independent values: F = 1, E* = 1, 1/Rx + 1/Ry = 1; Ry/Rx, ax, ay, p0, delta.
    const ELLIPSES: [[f64; 5]; 4] = [
        [1.0, 1.144714, 1.144714, 0.364374, 0.655185],
        [2.0, 0.920954, 1.460450, 0.354991, 0.638204],
        [5.0, 0.718051, 2.075297, 0.320410, 0.573737],
        [20.0, 0.521587, 3.613907, 0.253302, 0.440509],
    ];

    #[test]
    fn ellipses() {
        for [ratio, ax, ay, p0, delta] in ELLIPSES {
            let curvatures = [ratio / (1.0 + ratio), 1.0 / (1.0 + ratio)];
            let hertz = Hertz::from_load(curvatures, 1.0, 1.0).unwrap();
            // Half a unit of the last digit printed.
            for (found, printed) in [
                (hertz.semi_axes[0], ax),
                (hertz.semi_axes[1], ay),
                (hertz.peak_pressure, p0),
                (hertz.approach, delta),
            ] {
                assert_relative_eq!(found, printed, epsilon = 5.1e-7);
            }
        }
    }

    #[test]
    fn turning_the_bodies_turns_the_ellipse() {
        let [one, other] = [[1.0, 7.0], [7.0, 1.0]].map(|k| Hertz::from_load(k, 2.0, 3.0).unwrap());
        assert_relative_eq!(one.semi_axes[0], other.semi_axes[1], max_relative = 1e-14);
        assert_relative_eq!(one.semi_axes[1], other.semi_axes[0], max_relative = 1e-14);
        assert_relative_eq!(one.approach, other.approach, max_relative = 1e-14);
    }

    #[test]
    fn the_approach_leads_back_to_the_load() {
        for along_y in [1.0, 1e-3, 1e-9, 1e6] {
            let hertz = Hertz::from_load([1.0, along_y], 3e11, 42.0).unwrap();
            let again = Hertz::from_approach([1.0, along_y], 3e11, hertz.approach).unwrap();
            assert_relative_eq!(again.load, 42.0, max_relative = 1e-13);
            assert_relative_eq!(again.peak_pressure, hertz.peak_pressure, max_relative = 1e-13);
        }
    }

    /// The pressures carry the load and a long ellipse is nearly a line contact across: a slice
    /// through the middle carries 3F/(4b) per length.
    #[test]
    fn a_long_ellipse_is_a_line_contact_across() {
        let hertz = Hertz::from_load([1.0, 1e-8], 1e11, 1e3).unwrap();
        let line = Line::from_load(1.0, 1e11, 0.75 * 1e3 / hertz.semi_axes[1]).unwrap();
        assert_relative_eq!(line.half_width, hertz.semi_axes[0], max_relative = 1e-6);
        assert_relative_eq!(line.peak_pressure, hertz.peak_pressure, max_relative = 1e-6);
        let place = 0.6 * hertz.semi_axes[0];
        assert_relative_eq!(hertz.pressure([place, 0.0]), 0.8 * hertz.peak_pressure);
        let mean = hertz.load / hertz.contact_area();
        assert_relative_eq!(mean, hertz.peak_pressure / 1.5, max_relative = 1e-14);
    }

    #[test]
    fn no_contact_without_curvature_load_or_elasticity() {
        assert_eq!(Hertz::from_load([1.0, 0.0], 1.0, 1.0), None);
        assert_eq!(Hertz::from_load([1.0, -1.0], 1.0, 1.0), None);
        assert_eq!(Hertz::from_load([1.0, 1.0], f64::INFINITY, 1.0), None);
        assert_eq!(Hertz::from_approach([1.0, 1.0], 1.0, 0.0), None);
        assert_eq!(Hertz::from_load([1.0, 1.0], 1.0, f64::NAN), None);
        assert_eq!(Line::from_load(0.0, 1.0, 1.0), None);
    }
}
