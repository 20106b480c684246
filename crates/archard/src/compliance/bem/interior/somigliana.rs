//! The kernels of Somigliana's identity, multiplied by what stands on the surface.

use std::f64::consts::PI;

use glam::{DMat3, DVec3};

use super::Response;
use super::hooke::outer;
use crate::body::Material;

/// What the kernels take from the material.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kernels {
    poisson: f64,
    shear: f64,
}

/// A small part of the surface.
pub(super) struct Source {
    /// Its place less that of the point (m).
    pub r: DVec3,
    /// Outward, of the length of its area (m^2).
    pub area_vector: DVec3,
    /// Displacement (m).
    pub displacement: DVec3,
    /// Traction times area (N).
    pub force: DVec3,
}

impl Kernels {
    pub fn new(material: &Material) -> Self {
        Self { poisson: material.poisson, shear: material.shear_modulus() }
    }

    /// What a part of the surface adds to displacement and stress at the point.
    ///
    /// With e = r / |r|, n the area vector, f the force, u the displacement of the part:
    ///
    /// ```text
    /// 16 pi (1 - nu) G r U f = (3 - 4 nu) f + e (e.f)
    /// 8 pi (1 - nu) r^2 T u = -(1 - 2 nu) [(e.n) u - e (n.u) + n (e.u)] - 3 e (e.u)(e.n)
    /// 8 pi (1 - nu) r^2 D f = (1 - 2 nu) [f e + e f - I (e.f)] + 3 e e (e.f)
    /// 4 pi (1 - nu) r^3 S u / G = 3 (e.n) [(1 - 2 nu) I (e.u) + nu (u e + e u) - 5 e e (e.u)]
    ///     + 3 nu (n e + e n)(e.u) + (1 - 2 nu) [3 e e (n.u) + n u + u n] - (1 - 4 nu) I (n.u)
    /// ```
    pub fn response(&self, source: &Source) -> Response {
        let Source { area_vector: n, displacement: u, force: f, .. } = *source;
        let Self { poisson: nu, shear } = *self;
        let inverse = source.r.length_recip();
        let e = source.r * inverse;
        let factor = inverse * inverse / (8.0 * PI * (1.0 - nu));
        let one_two = 1.0 - 2.0 * nu;
        let (en, eu, ef, nu_dot) = (e.dot(n), e.dot(u), e.dot(f), n.dot(u));
        let from_force = ((3.0 - 4.0 * nu) * f + ef * e) * (0.5 * factor / (shear * inverse));
        let from_displacement =
            (one_two * (en * u - nu_dot * e + eu * n) + 3.0 * eu * en * e) * factor;
        let both = |a: DVec3, b: DVec3| outer(a, b) + outer(b, a);
        let squared = outer(e, e);
        let forced = one_two * (both(f, e) - ef * DMat3::IDENTITY) + 3.0 * ef * squared;
        let displaced = 3.0 * en * (nu * both(u, e) - 5.0 * eu * squared)
            + 3.0 * nu * eu * both(n, e)
            + one_two * (3.0 * nu_dot * squared + both(n, u))
            + (3.0 * one_two * en * eu - (1.0 - 4.0 * nu) * nu_dot) * DMat3::IDENTITY;
        Response {
            displacement: from_force + from_displacement,
            stress: factor * forced - 2.0 * factor * inverse * shear * displaced,
        }
    }
}
