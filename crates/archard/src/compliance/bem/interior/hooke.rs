//! Strains and stresses from what is known on the surface.

use glam::{DMat3, DVec3};

use crate::body::Material;

/// Hooke's law of an isotropic body.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hooke {
    /// Lame's constants (Pa).
    lame: f64,
    shear: f64,
}

impl Hooke {
    pub fn new(material: &Material) -> Self {
        let shear = material.shear_modulus();
        let lame = 2.0 * shear * material.poisson / (1.0 - 2.0 * material.poisson);
        Self { lame, shear }
    }

    /// The stress (Pa) under a gradient of displacement, columns along x, y and z.
    pub fn stress(&self, gradient: DMat3) -> DMat3 {
        self.lame * trace(gradient) * DMat3::IDENTITY
            + self.shear * (gradient + gradient.transpose())
    }

    /// The gradient of displacement on a surface with these tangents, from the derivatives of the displacement
    /// along them and the traction (Pa).
    ///
    /// With the part T that the tangents determine, T n = 0, the gradient is T + q n and sigma n = t is solved
    /// for q.
    pub fn gradient(&self, tangents: [DVec3; 2], slopes: [DVec3; 2], traction: DVec3) -> DMat3 {
        let normal = tangents[0].cross(tangents[1]).normalize();
        let inverse = DMat3::from_cols(tangents[0], tangents[1], normal).inverse();
        let along = DMat3::from_cols(slopes[0], slopes[1], DVec3::ZERO) * inverse;
        let pull = traction.dot(normal);
        let stretch = (pull - self.lame * trace(along)) / (self.lame + 2.0 * self.shear);
        let shear = (traction - pull * normal) / self.shear - along.transpose() * normal;
        along + outer(stretch * normal + shear, normal)
    }
}

/// A displacement that is linear in the place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Linear {
    /// A place (m) and the displacement there (m).
    pub place: DVec3,
    pub displacement: DVec3,
    /// Its gradient, columns along x, y and z.
    pub gradient: DMat3,
}

impl Linear {
    /// The displacement (m) at another place (m).
    pub fn at(&self, place: DVec3) -> DVec3 {
        self.displacement + self.gradient * (place - self.place)
    }

    /// The mirror image, by signs along x, y and z.
    pub fn mirrored(self, image: DVec3) -> Self {
        let mirror = DMat3::from_diagonal(image);
        Self {
            place: image * self.place,
            displacement: image * self.displacement,
            gradient: mirror * self.gradient * mirror,
        }
    }
}

fn trace(matrix: DMat3) -> f64 {
    matrix.x_axis.x + matrix.y_axis.y + matrix.z_axis.z
}

/// The matrix a b^T.
pub(super) fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}
