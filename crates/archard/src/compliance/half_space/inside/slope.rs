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

impl Below {
    /// What is added (Pa) at the centre of an element, `depth` (m) below it.
    pub(super) fn varying(&self, depth: f64, element: usize) -> Components {
        let n = 2.0 * self.material.poisson;
        let axes = if self.depth.is_some() { 1 } else { 2 };
        let mut added = [0.0; 6];
        for axis in 0..axes {
            let Some([x, y, z]) = self.slopes(axis, element) else { continue };
            let h = self.spacing[axis];
            let a = TAU * depth / h;
            let (even, times) = (h / PI * (-a).exp().ln_1p(), h / PI * a / (a.exp() + 1.0));
            let own = match axis {
                0 => [2.0 * even - times, n * even, times].map(|factor| factor * x),
                _ => [n * even, 2.0 * even - times, times].map(|factor| factor * y),
            };
            added[..3].iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
            added[3] += even * if axis == 0 { y } else { x };
            added[4 + axis] += times * z;
        }
        turned(added)
    }

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
