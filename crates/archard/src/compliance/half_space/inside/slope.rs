//! What tractions that vary within an element add to the stresses of even ones, at the centres of the elements.
//!
//! A traction of slope g along x differs from even elements by a sawtooth, g times h/(pi n) (-1)^(n+1) sin(2 pi n x/h) over all n,
//! even along y. Waves along one axis are in plane strain, and at the centre those count whose factor is i. With
//! a = 2 pi z/h the sums over n are
//!
//! ```text
//! i E     h/pi ln(1 + exp(-a))
//! i q E   h/pi a/(exp(a) + 1)
//! ```
//!
//! On the surface a traction adds (2 ln 2/pi) h g to the stress along itself; half an element deep a fiftieth of that is left.

use std::f64::consts::{PI, TAU};

use super::{Below, turned};
use crate::stress::Components;

/// What is added per slope (m) at a depth, along x and along y: to the components along that axis, across it and zz by the traction along
/// it, to xy by that across it, to xz or yz by the pressure.
pub(super) struct Varying([[f64; 5]; 2]);

impl Below {
    /// What slopes add at a depth (m).
    pub(super) fn varying(&self, depth: f64) -> Varying {
        let n = 2.0 * self.material(depth).poisson;
        let images = self.piece(depth).map_or(vec![], |(layers, piece)| layers.seen(piece, depth));
        let along = |axis: usize| {
            let h = self.spacing[axis];
            // The sums where a field decays over one distance and grows with another.
            let sums = |decay: f64, from: f64| {
                let a = TAU * decay / h;
                [h / PI * (-a).exp().ln_1p(), 2.0 * from / (a.exp() + 1.0)]
            };
            let [even, times] = sums(depth, depth);
            let mut own = [2.0 * even - times, n * even, times, even, times];
            for image in &images {
                for (sum, stress) in sums(image.distance, image.from).into_iter().zip(image.stress)
                {
                    let [_, _, _, sz, tz, ts, tn, _, _, sn] = stress;
                    own.iter_mut()
                        .zip([ts, tn, tz, sn, sz])
                        .for_each(|(own, add)| *own += sum * add);
                }
            }
            own
        };
        Varying([along(0), along(1)])
    }
}

impl Varying {
    /// What is added (Pa) at the centre of an element.
    pub(super) fn at(&self, below: &Below, element: usize) -> Components {
        let mut added = [0.0; 6];
        let axes = if below.depth.is_some() { 1 } else { 2 };
        for axis in 0..axes {
            let Some(slopes) = below.slopes(axis, element) else { continue };
            let [along, across, normal, shear, slant] = self.0[axis];
            let own = slopes[axis];
            added[axis] += along * own;
            added[1 - axis] += across * own;
            added[2] += normal * own;
            added[3] += shear * slopes[1 - axis];
            added[4 + axis] += slant * slopes[2];
        }
        turned(added)
    }
}

impl Below {
    /// How tractions change along an axis (Pa/m) at an element, where it and both of its neighbours are pressed.
    fn slopes(&self, axis: usize, element: usize) -> Option<[f64; 3]> {
        let step = if axis == 0 { 1 } else { self.elements[0] };
        let index = if axis == 0 { element % self.elements[0] } else { element / self.elements[0] };
        let pressed = |element: usize| self.tractions[2][element] > 0.0;
        if index == 0 || index + 1 >= self.elements[axis] {
            return None;
        }
        let [low, high] = [element - step, element + step];
        (pressed(low) && pressed(element) && pressed(high)).then(|| {
            let across = 2.0 * self.spacing[axis];
            [0, 1, 2]
                .map(|along| (self.tractions[along][high] - self.tractions[along][low]) / across)
        })
    }
}
