//! Kelvin's solution: displacements and tractions in an infinite body that a point force makes.
//!
//! With r = y - x, e = r / |r| and n the outward normal at y,
//!
//! ```text
//! U_ij = [(3 - 4 nu) d_ij + e_i e_j] / (16 pi (1 - nu) r)
//! T_ij = -{[(1 - 2 nu) d_ij + 3 e_i e_j] e.n - (1 - 2 nu)(e_i n_j - e_j n_i)} / (8 pi (1 - nu) r^2)
//! ```
//!
//! i is the direction of the force at x, j that of the displacement or traction at y (C. A. Brebbia, J. C. F.
//! Telles and L. C. Wrobel, *Boundary Element Techniques*, Springer 1984, eqs. 5.10 and 5.13).
//! Displacements are those under a force of the size of the shear modulus.

use std::f64::consts::PI;
use std::iter::Sum;

use pulp::Simd;

/// Rows of a kernel's values: xx, xy, xz, yx, ... of T, then xx, yy, zz, xy, xz, yz of U.
pub(super) const TRACTIONS: usize = 9;
pub(super) const ALL: usize = 15;

/// Row of U_ij.
pub(super) const DISPLACEMENT: [[usize; 3]; 3] = [[9, 12, 13], [12, 10, 14], [13, 14, 11]];

/// What Kelvin's solution takes from the material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Kelvin {
    three_four: f64,
    one_two: f64,
    displacement: f64,
    traction: f64,
}

impl Kelvin {
    /// For that Poisson's ratio; displacements are divided by a length (m).
    pub fn new(poisson: f64, length: f64) -> Self {
        Self {
            three_four: 3.0 - 4.0 * poisson,
            one_two: 1.0 - 2.0 * poisson,
            displacement: 1.0 / (16.0 * PI * (1.0 - poisson) * length),
            traction: -1.0 / (8.0 * PI * (1.0 - poisson)),
        }
    }

    /// The constants in all lanes.
    #[inline(always)]
    pub fn lanes<S: Simd>(self, simd: S) -> Lanes<S> {
        Lanes {
            three_four: simd.splat_f64s(self.three_four),
            one_two: simd.splat_f64s(self.one_two),
            displacement: simd.splat_f64s(self.displacement),
            traction: simd.splat_f64s(self.traction),
            one: simd.splat_f64s(1.0),
            three: simd.splat_f64s(3.0),
        }
    }
}

/// How often Kelvin's solution was evaluated.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Evaluations {
    /// Its tractions alone.
    pub tractions: usize,
    /// Its displacements with them.
    pub both: usize,
}

impl Evaluations {
    /// Adds evaluations, with displacements or without.
    pub(super) fn count(&mut self, evaluations: usize, displacement: bool) {
        *(if displacement { &mut self.both } else { &mut self.tractions }) += evaluations;
    }
}

impl Sum for Evaluations {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), |sum, more| Self {
            tractions: sum.tractions + more.tractions,
            both: sum.both + more.both,
        })
    }
}

/// The constants in all lanes.
#[derive(Clone, Copy)]
pub(super) struct Lanes<S: Simd> {
    three_four: S::f64s,
    one_two: S::f64s,
    displacement: S::f64s,
    traction: S::f64s,
    one: S::f64s,
    three: S::f64s,
}

impl<S: Simd> Lanes<S> {
    /// The direction e of r = y - x, and 1 / |r|: root and quotient of many places at once do not wait for each
    /// other.
    #[inline(always)]
    pub fn direction(&self, simd: S, r: [S::f64s; 3]) -> [S::f64s; 4] {
        let square = simd.mul_add_e_f64s(
            r[2],
            r[2],
            simd.mul_add_e_f64s(r[1], r[1], simd.mul_f64s(r[0], r[0])),
        );
        let inverse = simd.div_f64s(self.one, simd.sqrt_f64s(square));
        let along = |axis: usize| simd.mul_f64s(r[axis], inverse);
        [along(0), along(1), along(2), inverse]
    }

    /// Values times an area, from the [direction](Self::direction), the area vector along n and the area; those of
    /// U only where `with_displacement`.
    #[inline(always)]
    pub fn values(
        &self,
        simd: S,
        [x, y, z, inverse]: [S::f64s; 4],
        n: [S::f64s; 3],
        area: S::f64s,
        with_displacement: bool,
        values: &mut [S::f64s; ALL],
    ) {
        let along =
            simd.mul_add_e_f64s(z, n[2], simd.mul_add_e_f64s(y, n[1], simd.mul_f64s(x, n[0])));
        let factor = simd.mul_f64s(self.traction, simd.mul_f64s(inverse, inverse));
        let normal = simd.mul_f64s(factor, along);
        let diagonal = simd.mul_f64s(self.one_two, normal);
        let three = simd.mul_f64s(self.three, normal);
        let skew = simd.mul_f64s(self.one_two, factor);
        let (nx, ny) = (simd.mul_f64s(skew, n[0]), simd.mul_f64s(skew, n[1]));
        let nz = simd.mul_f64s(skew, n[2]);
        let (tx, ty) = (simd.mul_f64s(three, x), simd.mul_f64s(three, y));
        let tz = simd.mul_f64s(three, z);
        values[0] = simd.mul_add_e_f64s(tx, x, diagonal);
        values[4] = simd.mul_add_e_f64s(ty, y, diagonal);
        values[8] = simd.mul_add_e_f64s(tz, z, diagonal);
        // Those of a pair differ by the sign of e_i n_j - e_j n_i.
        let odd = simd.sub_f64s(simd.mul_f64s(x, ny), simd.mul_f64s(y, nx));
        values[1] = simd.sub_f64s(simd.mul_f64s(tx, y), odd);
        values[3] = simd.mul_add_e_f64s(tx, y, odd);
        let odd = simd.sub_f64s(simd.mul_f64s(x, nz), simd.mul_f64s(z, nx));
        values[2] = simd.sub_f64s(simd.mul_f64s(tx, z), odd);
        values[6] = simd.mul_add_e_f64s(tx, z, odd);
        let odd = simd.sub_f64s(simd.mul_f64s(y, nz), simd.mul_f64s(z, ny));
        values[5] = simd.sub_f64s(simd.mul_f64s(ty, z), odd);
        values[7] = simd.mul_add_e_f64s(ty, z, odd);
        if with_displacement {
            let factor = simd.mul_f64s(self.displacement, simd.mul_f64s(area, inverse));
            let diagonal = simd.mul_f64s(self.three_four, factor);
            let (ux, uy) = (simd.mul_f64s(factor, x), simd.mul_f64s(factor, y));
            let uz = simd.mul_f64s(factor, z);
            values[9] = simd.mul_add_e_f64s(ux, x, diagonal);
            values[10] = simd.mul_add_e_f64s(uy, y, diagonal);
            values[11] = simd.mul_add_e_f64s(uz, z, diagonal);
            values[12] = simd.mul_f64s(ux, y);
            values[13] = simd.mul_f64s(ux, z);
            values[14] = simd.mul_f64s(uy, z);
        }
    }
}
