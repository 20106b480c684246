//! Displacements of the pairs of a uniform frame under a unit traction on one element.
//!
//! Johnson, *Contact Mechanics*, sections 3.2 and 3.6; Love, *Phil. Trans. R. Soc. A* 228 (1929) 377. With
//! r = hypot(x, y) and [F] the difference of an antiderivative over the corners of an element,
//!
//! ```text
//! Fxx = y asinh(x/|y|)   Fyy = x asinh(y/|x|)   Fxy = -r   Fxn = y ln r + x atan(y/x)
//! A_nn = S1 [Fxx + Fyy]  A_xx = A_nn + S2 [Fxx]  A_yy = A_nn + S2 [Fyy]
//! A_xy = S2 [Fxy]        A_xn = S3 [Fxn]         A_nx = -A_xn
//! ```
//!
//! In plane strain (Johnson, sections 2.2 to 2.4 and 5.6) elements are strips without end, and rows of them, one a slice of the
//! bodies, do not act on one another. With F = x ln|x| - x, [F] its difference over the edges, h the width and d how far below
//! the contact displacements are measured from,
//!
//! ```text
//! A_nn = sum (1 - nu^2)/(pi E) {-2 [F] + h (2 ln d - 1/(1 - nu))}   A_xn = S3 pi [|x|]
//! A_xx = sum (1 - nu^2)/(pi E) {-2 [F] + h (2 ln d + 1/(1 - nu))}
//! A_yy = sum 2 (1 + nu)/(pi E) {  -[F] + h ln d }
//! ```

use std::f64::consts::PI;

use std::sync::Arc;

use rayon::prelude::*;

use super::differences::differences;
use super::images::Image;
use super::shaft::Shaft;
use crate::body::Material;

/// The elastic constants of two half-spaces, as the formulas need them (1/Pa).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::compliance) struct Constants {
    /// S1: sum of (1 - nu^2)/(pi E).
    pub(in crate::compliance) normal: f64,
    /// S2: sum of nu (1 + nu)/(pi E).
    pub(in crate::compliance) tangential: f64,
    /// S3: difference of (1 + nu)(1 - 2 nu)/(2 pi E), body 1 less body 2; zero for like materials.
    pub(in crate::compliance) coupling: f64,
}

impl Constants {
    pub(in crate::compliance) fn of(materials: [Option<&Material>; 2]) -> Self {
        let sum = |part: fn(&Material) -> f64| -> f64 {
            materials.iter().flatten().map(|material| part(material)).sum()
        };
        let coupling = |material: Option<&Material>| {
            material
                .map_or(0.0, |m| (1.0 + m.poisson) * (1.0 - 2.0 * m.poisson) / (2.0 * PI * m.young))
        };
        Self {
            normal: sum(|m| (1.0 - m.poisson * m.poisson) / (PI * m.young)),
            tangential: sum(|m| m.poisson * (1.0 + m.poisson) / (PI * m.young)),
            coupling: coupling(materials[0]) - coupling(materials[1]),
        }
    }
}

/// Influence coefficients at offsets zero and greater, `[i + elements_x j]`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Influence {
    pub(super) constants: Constants,
    elements: [usize; 2],
    /// Half the size of an element along x and y (m).
    half: [f64; 2],
    /// In plane strain, what the depths of the bodies add to the displacements n, x and y (1/Pa), over the width of
    /// an element.
    depths: Option<[f64; 3]>,
    /// What layers add.
    pub(super) images: Arc<[Image]>,
    /// The body of a line of contact that is round, which its half-space stands for.
    shaft: Option<Shaft>,
}

impl Influence {
    pub(super) fn new(constants: Constants, elements: [usize; 2], spacing: [f64; 2]) -> Self {
        let half = spacing.map(|h| 0.5 * h);
        Self { constants, elements, half, depths: None, images: Arc::new([]), shaft: None }
    }

    /// The same with images of the layers that these half-spaces are the uppermost of.
    pub(super) fn layered(self, images: Vec<Image>) -> Self {
        Self { images: images.into(), ..self }
    }

    /// The same with one of them round, on a line of contact.
    pub(super) fn around(self, shaft: Option<Shaft>) -> Self {
        Self { shaft, ..self }
    }

    /// Strips of that width along x (m), without end along y, on bodies of these depths (m). Their displacements far away are
    /// those of half-spaces of other materials, `bases`, where there are layers.
    pub(super) fn plane_strain(
        constants: Constants,
        bases: [Option<&Material>; 2],
        depths: [f64; 2],
        elements: [usize; 2],
        width: f64,
    ) -> Self {
        let mut added = [0.0; 3];
        for (material, depth) in bases.into_iter().zip(depths) {
            let Some(Material { young, poisson, .. }) = material else { continue };
            let (normal, ln) = ((1.0 - poisson * poisson) / (PI * young), 2.0 * depth.ln());
            added[0] += normal * (ln - 1.0 / (1.0 - poisson));
            added[1] += normal * (ln + 1.0 / (1.0 - poisson));
            added[2] += (1.0 + poisson) / (PI * young) * ln;
        }
        let strips = Self::new(constants, elements, [width; 2]);
        Self { depths: Some(added), ..strips }
    }

    /// Square elements that wide on the same half-spaces: of the size of what the elements do to one another where
    /// they are strips, whose displacements under themselves grow with the depth of the bodies.
    fn square(&self) -> Self {
        let half = [self.half[0]; 2];
        Self { elements: [1, 1], half, depths: None, shaft: None, ..self.clone() }
    }

    /// Displacements under a unit traction on a strip (m/Pa): `factor` times minus [F], what the depth adds, and images by one
    /// of their scalars.
    fn strips(&self, factor: f64, added: f64, scalar: usize) -> Vec<f64> {
        let a = self.half[0];
        let antiderivative = |x: f64| {
            let images = self.images.iter().map(|image| image.scalars[scalar] * image.strip(x));
            images.sum::<f64>() - factor * (x * x.abs().ln() - x)
        };
        self.own_row(|x| 2.0 * a * added + antiderivative(x + a) - antiderivative(x - a))
    }

    /// Values at the offsets along x (m) of a row; none at those of other rows.
    fn own_row(&self, value: impl Fn(f64) -> f64) -> Vec<f64> {
        let [along, rows] = self.elements;
        let width = 2.0 * self.half[0];
        let mut values: Vec<f64> = (0..along).map(|i| value(width * i as f64)).collect();
        values.resize(along * rows, 0.0);
        values
    }

    pub(super) fn elements(&self) -> [usize; 2] {
        self.elements
    }

    /// Whether so many elements lie above the depth that displacements are measured from, where there is one: they have
    /// to be positive. Layers on something rigid need none, and may rise next to what presses them.
    pub(super) fn reaches(&self, elements: [usize; 2]) -> bool {
        let measured = self.depths.is_some_and(|added| added != [0.0; 3]);
        !measured || self.within([elements[0], 1]).nn().iter().all(|own| *own > 0.0)
    }

    /// The same on another number of elements of the same size.
    pub(super) fn within(&self, elements: [usize; 2]) -> Self {
        Self { elements, ..self.clone() }
    }

    /// The same on as few elements of twice the size as cover these.
    pub(super) fn coarser(&self) -> Self {
        let elements = self.elements.map(|n| n.div_ceil(2));
        Self { elements, half: self.half.map(|half| 2.0 * half), ..self.clone() }
    }

    /// Whether normal and tangential tractions act on one another.
    pub(super) fn couples(&self) -> bool {
        self.constants.coupling != 0.0 || self.images.iter().any(|image| image.scalars[1] != 0.0)
    }

    /// The larger tangential displacement under a unit traction on the element itself, less that of
    /// the neighbour along an axis (m/Pa).
    pub(super) fn rolling_self_term(&self, axis: usize) -> f64 {
        if self.depths.is_some() && axis == 1 {
            return self.square().rolling_self_term(axis);
        }
        let mut elements = [1, 1];
        elements[axis] = 2;
        let near = self.within(elements);
        let along = |kernel: Vec<f64>| kernel[0] - kernel[1];
        along(near.xx()).max(along(near.yy()))
    }

    /// The larger tangential displacement under a unit traction on the element itself (m/Pa).
    pub(super) fn tangential_self_term(&self) -> f64 {
        if self.depths.is_some() {
            return self.square().tangential_self_term();
        }
        let itself = self.within([1, 1]);
        itself.xx()[0].max(itself.yy()[0])
    }

    /// Normal displacement under a unit pressure on the element itself (m/Pa).
    pub(super) fn normal_self_term(&self) -> f64 {
        if !self.images.is_empty() {
            let itself = if self.depths.is_some() { self.square() } else { self.within([1, 1]) };
            return itself.nn()[0];
        }
        let [a, b] = self.depths.map_or(self.half, |_| [self.half[0]; 2]);
        4.0 * self.constants.normal * (b * (a / b).asinh() + a * (b / a).asinh())
    }

    /// Normal displacement under pressure (m/Pa).
    pub(super) fn nn(&self) -> Vec<f64> {
        let normal = self.constants.normal;
        if let Some([added, ..]) = self.depths {
            let mut row = self.strips(2.0 * normal, added, 2);
            if let Some(shaft) = self.shaft {
                let plane = shaft.material.plane_strain_compliance() / PI;
                let a = self.half[0];
                let more = |x: f64| shaft.strip(x) + 2.0 * plane * (x * x.abs().ln() - x);
                let round = self.own_row(|x| more(x + a) - more(x - a));
                row.iter_mut().zip(round).for_each(|(own, more)| *own += more);
            }
            return row;
        }
        self.differences([-1.0, -1.0], |corner| {
            let images = self.images.iter().map(|image| image.scalars[2] * image.normal(corner));
            normal * (corner.fxx() + corner.fyy()) + images.sum::<f64>()
        })
    }

    /// What the displacement under a unit pressure on an element, felt from its middle, changes by with the square of the distance
    /// (1/(Pa m)); zero of the element itself.
    pub(super) fn by_square(&self) -> Vec<f64> {
        let ([nx, ny], [a, b]) = (self.elements, self.half);
        let value = |index: usize| {
            let (x, y) = (2.0 * a * (index % nx) as f64, 2.0 * b * (index / nx) as f64);
            let square = x * x + y * y;
            let images = self.images.iter();
            let images = images
                .map(|image| image.scalars[2] / (square + image.depth * image.depth).powf(1.5));
            let sum = self.constants.normal / square.powf(1.5) + images.sum::<f64>();
            if index == 0 { 0.0 } else { -2.0 * a * b * sum }
        };
        (0..nx * ny).into_par_iter().with_min_len(1024).map(value).collect()
    }

    /// A bound below the normal displacements under a unit pressure on an element (m/Pa) of the pairs at most so many
    /// elements away: as if all of it stood at its farthest corner, or edge. Layers and shafts may rise next to what presses them,
    /// and have no bound.
    pub(super) fn least_nn(&self, away: [usize; 2]) -> f64 {
        if !self.images.is_empty() || self.shaft.is_some() {
            return f64::NEG_INFINITY;
        }
        let normal = self.constants.normal;
        let [x, y] = [0, 1].map(|axis| self.half[axis] * (2 * away[axis] + 1) as f64);
        let [a, b] = self.half;
        match self.depths {
            Some(_) if away[1] > 0 => 0.0,
            Some([added, ..]) => 2.0 * a * (added - 2.0 * normal * x.ln()),
            None => 4.0 * a * b * normal / x.hypot(y),
        }
    }

    /// Displacement along x under a traction along x (m/Pa).
    pub(super) fn xx(&self) -> Vec<f64> {
        let Constants { normal, tangential, .. } = self.constants;
        if let Some([_, added, _]) = self.depths {
            return self.strips(2.0 * normal, added, 0);
        }
        self.differences([-1.0, -1.0], |corner| {
            let images = self.images.iter().map(|image| image.tangential(corner));
            (normal + tangential) * corner.fxx() + normal * corner.fyy() + images.sum::<f64>()
        })
    }

    /// Displacement along y under a traction along y (m/Pa).
    pub(super) fn yy(&self) -> Vec<f64> {
        let Constants { normal, tangential, .. } = self.constants;
        if let Some([.., added]) = self.depths {
            return self.strips(2.0 * (normal + tangential), added, 3);
        }
        self.differences([-1.0, -1.0], |corner| {
            let images = self.images.iter().map(|image| image.tangential(&corner.turned()));
            normal * corner.fxx() + (normal + tangential) * corner.fyy() + images.sum::<f64>()
        })
    }

    /// Displacement along x under a traction along y, and the reverse (m/Pa).
    pub(super) fn xy(&self) -> Vec<f64> {
        let tangential = self.constants.tangential;
        if self.depths.is_some() {
            return self.own_row(|_| 0.0);
        }
        self.differences([1.0, 1.0], |corner| {
            let images = self.images.iter().map(|image| image.aslant(corner));
            images.sum::<f64>() - tangential * corner.r
        })
    }

    /// Displacement along x under a normal traction (m/Pa).
    pub(super) fn xn(&self) -> Vec<f64> {
        let coupling = self.constants.coupling;
        if self.depths.is_some() {
            let a = self.half[0];
            let antiderivative = |x: f64| {
                let images = self.images.iter().map(|image| image.scalars[1] * image.pull(x));
                PI * coupling * x.abs() + images.sum::<f64>()
            };
            return self.own_row(|x| antiderivative(x + a) - antiderivative(x - a));
        }
        self.differences([1.0, -1.0], |c| {
            let images = self.images.iter().map(|image| image.scalars[1] * image.coupling(c));
            coupling * (c.y * c.r.ln() + c.x * (c.y / c.x).atan()) + images.sum::<f64>()
        })
    }

    /// Displacement along y under a normal traction (m/Pa).
    pub(super) fn yn(&self) -> Vec<f64> {
        let coupling = self.constants.coupling;
        if self.depths.is_some() {
            return self.own_row(|_| 0.0);
        }
        self.differences([-1.0, 1.0], |c| {
            let images = self.images.iter();
            let images = images.map(|image| image.scalars[1] * image.coupling(&c.turned()));
            coupling * (c.x * c.r.ln() + c.y * (c.x / c.y).atan()) + images.sum::<f64>()
        })
    }

    /// Differences over the corners of the elements of an antiderivative, which is even (1) or odd
    /// (-1) along x and along y: only corners with x and y above zero are evaluated.
    fn differences(
        &self,
        parity: [f64; 2],
        antiderivative: impl Fn(&Corner) -> f64 + Sync,
    ) -> Vec<f64> {
        let [nx, ny] = self.elements;
        let place = |axis: usize, index: usize| self.half[axis] * (2 * index + 1) as f64;
        let logarithms = |axis: usize| -> Vec<f64> {
            (0..self.elements[axis]).map(|index| place(axis, index).ln()).collect()
        };
        let (ln_x, ln_y) = (logarithms(0), logarithms(1));
        let values = (0..nx * ny).into_par_iter().with_min_len(1024).map(|index| {
            let (i, j) = (index % nx, index / nx);
            let (x, y) = (place(0, i), place(1, j));
            antiderivative(&Corner { x, y, r: x.hypot(y), ln_x: ln_x[i], ln_y: ln_y[j] })
        });
        differences(values.collect(), self.elements, parity)
    }
}

/// A corner of an element, seen from a pair; x and y above zero (m).
pub(super) struct Corner {
    pub x: f64,
    pub y: f64,
    pub r: f64,
    ln_x: f64,
    ln_y: f64,
}

impl Corner {
    /// y asinh(x/y).
    fn fxx(&self) -> f64 {
        self.y * ((self.x + self.r).ln() - self.ln_y)
    }

    /// x asinh(y/x).
    fn fyy(&self) -> f64 {
        self.x * ((self.y + self.r).ln() - self.ln_x)
    }

    /// With x and y exchanged.
    fn turned(&self) -> Self {
        let Self { x, y, r, ln_x, ln_y } = *self;
        Self { x: y, y: x, r, ln_x: ln_y, ln_y: ln_x }
    }
}

#[cfg(test)]
mod tests {
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    use super::{Constants, Corner, Influence};
    use crate::body::Material;

    /// Steel-like, with G = 1.
    const SOLID: Material = Material { young: 2.6, poisson: 0.3 };

    fn corner(x: f64, y: f64) -> Corner {
        Corner { x, y, r: x.hypot(y), ln_x: x.ln(), ln_y: y.ln() }
    }

    /// Displacement at a place under a rectangle centred at the origin, from an antiderivative known
    /// for positive arguments.
    fn under_rectangle(
        place: [f64; 2],
        half: [f64; 2],
        parity: [f64; 2],
        antiderivative: impl Fn(Corner) -> f64,
    ) -> f64 {
        let mut sum = 0.0;
        for (side_x, side_y) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
            let (x, y) = (place[0] + side_x * half[0], place[1] + side_y * half[1]);
            let reflected = |value: f64, parity: f64| if value < 0.0 { parity } else { 1.0 };
            // A tiny distance stands for the limit at a corner below the place itself.
            let value = antiderivative(corner(x.abs().max(1e-300), y.abs().max(1e-300)));
            sum += side_x * side_y * reflected(x, parity[0]) * reflected(y, parity[1]) * value;
        }
        sum
    }

    /// Table "Rectangle under uniform traction" of independent values (half sides 1 and 0.5, G = 1,
    /// nu = 0.3, z into the solid), eight digits. With n out of the solid, pressure is -t_n: the
    /// tangential displacements under a normal traction have the opposite sign.
    #[test]
    fn every_component_agrees_with_independent_values() {
        let Constants { normal: s1, tangential: s2, coupling: s3 } =
            Constants::of([Some(&SOLID), None]);
        let rows = [
            ([0.0, 0.0], [0.53611068, 0.0, 0.0, 0.67396772, 0.0, 0.62801537]),
            (
                [0.5, 0.25],
                [0.48396964, -0.02978748, -0.03274933, 0.60502795, 0.00888135, 0.57032690],
            ),
            (
                [1.0, 0.5],
                [0.26805534, -0.05513172, -0.04234452, 0.33698386, 0.03647507, 0.31400769],
            ),
            (
                [-1.5, 0.75],
                [0.14469597, 0.03450645, -0.02050983, 0.18902158, -0.02409565, 0.16238293],
            ),
        ];
        for (place, [uz_pz, ux_pz, uy_pz, ux_qx, uy_qx, uy_qy]) in rows {
            let at =
                |parity, f: &dyn Fn(Corner) -> f64| under_rectangle(place, [1.0, 0.5], parity, f);
            let both_odd = [-1.0, -1.0];
            let close =
                |value: f64, expected: f64| assert_abs_diff_eq!(value, expected, epsilon = 1e-8);
            close(at(both_odd, &|c| s1 * (c.fxx() + c.fyy())), uz_pz);
            close(at(both_odd, &|c| (s1 + s2) * c.fxx() + s1 * c.fyy()), ux_qx);
            close(at(both_odd, &|c| s1 * c.fxx() + (s1 + s2) * c.fyy()), uy_qy);
            close(at([1.0, 1.0], &|c| -s2 * c.r), uy_qx);
            close(at([1.0, -1.0], &|c| -s3 * (c.y * c.r.ln() + c.x * (c.y / c.x).atan())), ux_pz);
            close(at([-1.0, 1.0], &|c| -s3 * (c.x * c.r.ln() + c.y * (c.x / c.y).atan())), uy_pz);
        }
    }

    #[test]
    fn the_grid_holds_the_rectangles_at_its_offsets() {
        let half = [0.3, 0.2];
        let influence = Influence::new(Constants::of([Some(&SOLID), None]), [4, 5], [0.6, 0.4]);
        let Constants { normal: s1, tangential: s2, coupling: s3 } = influence.constants;
        let grids =
            [influence.nn(), influence.xx(), influence.xy(), influence.xn(), influence.yn()];
        for index in 0..20 {
            let place = [0.6 * (index % 4) as f64, 0.4 * (index / 4) as f64];
            let expected = [
                under_rectangle(place, half, [-1.0, -1.0], |c| s1 * (c.fxx() + c.fyy())),
                under_rectangle(place, half, [-1.0, -1.0], |c| (s1 + s2) * c.fxx() + s1 * c.fyy()),
                under_rectangle(place, half, [1.0, 1.0], |c| -s2 * c.r),
                under_rectangle(place, half, [1.0, -1.0], |c| {
                    s3 * (c.y * c.r.ln() + c.x * (c.y / c.x).atan())
                }),
                under_rectangle(place, half, [-1.0, 1.0], |c| {
                    s3 * (c.x * c.r.ln() + c.y * (c.x / c.y).atan())
                }),
            ];
            for (grid, expected) in grids.iter().zip(expected) {
                assert_abs_diff_eq!(grid[index], expected, epsilon = 1e-14);
            }
        }
    }

    /// Table of independent values, unit square: A33 = .3927698966, A11 = .4769348745 for G = 1,
    /// nu = 0.3.
    #[test]
    fn self_terms_of_the_unit_square() {
        let influence = Influence::new(Constants::of([None, Some(&SOLID)]), [1, 1], [1.0, 1.0]);
        assert_relative_eq!(influence.normal_self_term(), 0.3927698966, max_relative = 1e-9);
        assert_relative_eq!(influence.nn()[0], influence.normal_self_term(), max_relative = 1e-14);
        assert_relative_eq!(influence.xx()[0], 0.4769348745, max_relative = 1e-9);
    }
}
