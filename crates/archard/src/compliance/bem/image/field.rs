//! The field of a half-space under a force on its surface, anywhere below.
//!
//! Boussinesq's and Cerruti's solutions (K. L. Johnson, *Contact Mechanics*, Cambridge 1985, sections 3.2 and 3.6) at once: with r
//! from the force to the place, z the depth, q the tangential part of the force f and p that of r, w = 1/(r + z),
//!
//! ```text
//! 4 pi G u = f/r + r (r.f)/r^3 + (1 - 2 nu) { w q - p [(p.q) w^2/r + f_z w/r] + z^ [(p.q) w/r + f_z/r] }
//! ```

use std::f64::consts::PI;

use glam::{DMat3, DVec3};

use crate::body::Material;

/// What a place inside is below: the half-space lies at z < 0, depths are turned over.
const OVER: DVec3 = DVec3::new(1.0, 1.0, -1.0);

/// A half-space at z < 0 under forces on the plane z = 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct HalfSpaceField {
    shear: f64,
    poisson: f64,
}

impl HalfSpaceField {
    pub fn new(material: &Material) -> Self {
        Self { shear: material.shear_modulus(), poisson: material.poisson }
    }

    /// Displacement (m/N) and traction (1/m^2) on a plane of that normal, at a place (m) seen from the force: column e for a unit
    /// force along axis e.
    pub fn at(&self, away: DVec3, normal: DVec3) -> [DMat3; 2] {
        let columns = DVec3::AXES.map(|force| self.under(OVER * away, OVER * normal, OVER * force));
        [0, 1].map(|which| {
            let [x, y, z] = columns.each_ref().map(|both| OVER * both[which]);
            DMat3::from_cols(x, y, z)
        })
    }

    /// The same for one force, depths counted positive.
    fn under(&self, r: DVec3, normal: DVec3, force: DVec3) -> [DVec3; 2] {
        let length = r.length();
        let unit = r / length;
        let (p, q) = (r.with_z(0.0), force.with_z(0.0));
        let w = 1.0 / (length + r.z);
        let (along, across) = (r.dot(force), p.dot(q));
        let outer = |a: DVec3, b: DVec3| DMat3::from_cols(b.x * a, b.y * a, b.z * a);
        // Kelvin's part.
        let cube = length.powi(3);
        let mut displacement = force / length + along / cube * r;
        let mut gradient = along / cube * DMat3::IDENTITY - outer(force, r) * (1.0 / cube)
            + outer(r, force) * (1.0 / cube)
            - outer(r, r) * (3.0 * along / length.powi(5));
        // What frees the surface; a = w, b = w^2/r and c = w/r with their gradients.
        let toward = unit + DVec3::Z;
        let (a, b, c) = (w, w * w / length, w / length);
        let slope_a = -w * w * toward;
        let slope_b = -2.0 * w.powi(3) / length * toward - w * w / length.powi(2) * unit;
        let slope_c = -w * w / length * toward - w / length.powi(2) * unit;
        let inward = across * b + force.z * c;
        let share = 1.0 - 2.0 * self.poisson;
        let down = across * c + force.z / length;
        displacement += share * (a * q - inward * p + down * DVec3::Z);
        let in_plane = DMat3::from_diagonal(DVec3::new(1.0, 1.0, 0.0));
        let slope_inward = b * q + across * slope_b + force.z * slope_c;
        let slope_down = c * q + across * slope_c - force.z / cube * r;
        gradient += share
            * (outer(q, slope_a) - inward * in_plane - outer(p, slope_inward)
                + outer(DVec3::Z, slope_down));
        let strain = 0.5 * (gradient + gradient.transpose());
        let trace = strain.x_axis.x + strain.y_axis.y + strain.z_axis.z;
        let lame = 2.0 * self.poisson / share;
        let stress = 2.0 * strain + lame * trace * DMat3::IDENTITY;
        [displacement / (4.0 * PI * self.shear), stress * normal / (4.0 * PI)]
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;
    use glam::{DMat3, DVec3};

    use super::HalfSpaceField;
    use crate::body::Material;
    use crate::numerics::quadrature::gauss_legendre;

    const MATERIAL: Material = Material { young: 2.6, poisson: 0.3 };

    /// On the surface Boussinesq's and Cerruti's displacements stand in every book.
    #[test]
    fn displacements_on_the_surface_are_known() {
        let field = HalfSpaceField::new(&MATERIAL);
        let [u, t] = field.at(DVec3::new(2.0, 0.0, 0.0), DVec3::Z);
        let unit = 1.0 / (4.0 * PI * MATERIAL.shear_modulus() * 2.0);
        let share = 1.0 - 2.0 * MATERIAL.poisson;
        assert_relative_eq!(
            u.z_axis.z,
            2.0 * (1.0 - MATERIAL.poisson) * unit,
            max_relative = 1e-14
        );
        assert_relative_eq!(u.x_axis.x, 2.0 * unit, max_relative = 1e-14);
        assert_relative_eq!(
            u.y_axis.y,
            2.0 * (1.0 - MATERIAL.poisson) * unit,
            max_relative = 1e-14
        );
        // What is pulled at draws its surroundings after it sideways: away from a pull along the outward normal.
        assert_relative_eq!(u.z_axis.x, share * unit, max_relative = 1e-14);
        assert_relative_eq!(u.x_axis.z, -share * unit, max_relative = 1e-14);
        assert!(t.abs_diff_eq(DMat3::ZERO, 1e-15));
    }

    /// The tractions on a half ball around the force balance it, and their moments vanish with it: each traction follows from the
    /// gradient of the displacement.
    #[test]
    fn tractions_balance_the_force_and_follow_from_displacements() {
        let field = HalfSpaceField::new(&MATERIAL);
        let mut force = DMat3::ZERO;
        for (down, weight) in gauss_legendre(24) {
            let z = 0.5 * (down - 1.0);
            for step in 0..48 {
                let turn = 2.0 * PI * (f64::from(step) + 0.5) / 48.0;
                let across = (1.0 - z * z).sqrt();
                let normal = DVec3::new(across * turn.cos(), across * turn.sin(), z);
                force += field.at(2.0 * normal, normal)[1] * (4.0 * 0.5 * weight * 2.0 * PI / 48.0);
            }
        }
        assert!(force.abs_diff_eq(-DMat3::IDENTITY, 1e-10), "{force}");
        let (place, step) = (DVec3::new(0.4, -0.7, -0.5), 1e-5);
        let slopes = DVec3::AXES.map(|axis| {
            let at = |sign: f64| field.at(place + sign * step * axis, axis)[0];
            (at(1.0) - at(-1.0)) * (0.5 / step)
        });
        for load in 0..3 {
            let gradient =
                DMat3::from_cols(slopes[0].col(load), slopes[1].col(load), slopes[2].col(load));
            let strain = 0.5 * (gradient + gradient.transpose());
            let trace = strain.x_axis.x + strain.y_axis.y + strain.z_axis.z;
            let shear = MATERIAL.shear_modulus();
            let lame = 2.0 * shear * MATERIAL.poisson / (1.0 - 2.0 * MATERIAL.poisson);
            let stress = 2.0 * shear * strain + lame * trace * DMat3::IDENTITY;
            for axis in DVec3::AXES {
                let found = field.at(place, axis)[1].col(load);
                assert!(found.abs_diff_eq(stress * axis, 1e-8), "{found} {}", stress * axis);
            }
        }
    }
}
