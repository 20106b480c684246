//! The contact frame: the pairs of points that may touch, and the fields that live on them.
//!
//! Conventions, here and everywhere above:
//!
//! - SI units. Only `case` and `output` know others.
//! - n is the outward normal of body 1. Gaps are body 2 minus body 1 in {t1, t2, n}; tractions act
//!   on body 1. Compression has a negative normal traction, and what a user sees is the pressure
//!   p = -t_n >= 0. The relative displacement of the pairs is
//!   k = k_g + k_o + w n - C L with C the sum of the compliances of both bodies (the paper's
//!   eq. 29, its bodies condensed), so that the normal gap is g + w - approach + C p.
//! - t1 is the x axis of the frame and t2 the y axis. Friction on body 1 points along the slip of
//!   body 2 over body 1.
//! - A pair is the centre of a rectangular element of uniform traction; pair i = ix + nx iy.

mod direction;
mod field;

pub use direction::Direction;
pub use field::VectorField;

use rayon::prelude::*;

use crate::body::Profile;

/// The pairs of a uniform rectangular grid, centred at the origin, and their geometric gap.
#[derive(Debug, Clone)]
pub struct ContactFrame {
    /// Size along x and y (m).
    size: [f64; 2],
    /// Number of elements along x and y.
    elements: [usize; 2],
    /// Gap of the undeformed bodies at first touch (m).
    gap: Vec<f64>,
}

/// A frame some part of which lies beyond a body's surface.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("the surface of body {} does not reach the pair at x = {:e} m, y = {:e} m", .body + 1, .place[0], .place[1])]
pub struct OffTheSurface {
    /// The body's index, 0 or 1.
    pub body: usize,
    /// Where (m).
    pub place: [f64; 2],
}

impl ContactFrame {
    /// A frame of that size (m) and number of elements between two profiles.
    ///
    /// # Errors
    /// If a profile has no surface at some pair.
    pub fn uniform(
        size: [f64; 2],
        elements: [usize; 2],
        profiles: [&dyn Profile; 2],
    ) -> Result<Self, OffTheSurface> {
        let mut frame = Self { size, elements, gap: vec![] };
        let recess = |pair: usize| {
            let [x, y] = frame.place(pair);
            profiles.map(|profile| profile.recess(x, y))
        };
        let gap: Vec<f64> = (0..frame.len())
            .into_par_iter()
            .with_min_len(4096)
            .map(|pair| recess(pair).iter().sum())
            .collect();
        if let Some(pair) = gap.iter().position(|gap| !gap.is_finite()) {
            let body = usize::from(recess(pair)[0].is_finite());
            return Err(OffTheSurface { body, place: frame.place(pair) });
        }
        frame.gap = gap;
        // The bodies may touch between pairs, where the apex of most profiles is.
        let apex: f64 = profiles.iter().map(|profile| profile.recess(0.0, 0.0)).sum();
        let touch = frame.gap.iter().copied().fold(apex, f64::min);
        frame.gap.iter_mut().for_each(|gap| *gap -= touch);
        Ok(frame)
    }

    /// Number of pairs.
    pub fn len(&self) -> usize {
        self.elements[0] * self.elements[1]
    }

    /// Whether there are no pairs.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Size along x and y (m).
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// Number of elements along x and y.
    pub fn elements(&self) -> [usize; 2] {
        self.elements
    }

    /// Size of an element along x and y (m).
    pub fn spacing(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.size[axis] / self.elements[axis] as f64)
    }

    /// Area of an element (m^2).
    pub fn element_area(&self) -> f64 {
        let [dx, dy] = self.spacing();
        dx * dy
    }

    /// Gap of the undeformed, unworn bodies at first touch (m), one value a pair.
    pub fn gap(&self) -> &[f64] {
        &self.gap
    }

    /// Where a pair is (m from the centre of the frame).
    pub fn place(&self, pair: usize) -> [f64; 2] {
        let index = [pair % self.elements[0], pair / self.elements[0]];
        let spacing = self.spacing();
        [0, 1].map(|axis| {
            // Symmetric to the last bit, so that symmetric problems stay symmetric.
            0.5 * spacing[axis] * (2.0 * index[axis] as f64 + 1.0 - self.elements[axis] as f64)
        })
    }

    /// Integral of a field over the frame (its unit times m^2).
    pub fn integrate(&self, field: &[f64]) -> f64 {
        field.iter().sum::<f64>() * self.element_area()
    }

    /// Value of a field at the frame's centre, in the field's unit: the pair's own where one sits
    /// there, otherwise the mean of the two or four around it, corrected for curvature by their next
    /// neighbours unless the field vanishes at one of those, as pressures do outside a contact.
    pub fn at_centre(&self, field: &[f64]) -> f64 {
        let nearest = self.weigh(field, centre_nearest).0;
        match self.weigh(field, centre_smooth) {
            (value, true) => value,
            (_, false) => nearest,
        }
    }

    /// Weighs the values around the centre, and whether none of them is zero.
    fn weigh(&self, field: &[f64], weights: fn(usize) -> Vec<(usize, f64)>) -> (f64, bool) {
        let [along_x, along_y] = self.elements.map(weights);
        let (mut sum, mut whole) = (0.0, true);
        for (iy, weight_y) in &along_y {
            for (ix, weight_x) in &along_x {
                let value = field[ix + self.elements[0] * iy];
                sum += weight_x * weight_y * value;
                whole &= value != 0.0;
            }
        }
        (sum, whole)
    }
}

/// Weights of the one or two places at the middle of `n`.
fn centre_nearest(n: usize) -> Vec<(usize, f64)> {
    if n.is_multiple_of(2) { vec![(n / 2 - 1, 0.5), (n / 2, 0.5)] } else { vec![(n / 2, 1.0)] }
}

/// Weights that are exact for cubics, where there are places enough.
fn centre_smooth(n: usize) -> Vec<(usize, f64)> {
    if n.is_multiple_of(2) && n >= 4 {
        let weights = [-1.0, 9.0, 9.0, -1.0].into_iter().enumerate();
        weights.map(|(i, weight)| (n / 2 - 2 + i, weight / 16.0)).collect()
    } else {
        centre_nearest(n)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::ContactFrame;
    use crate::body::profile::PROFILES;
    use crate::parameters::Values;

    #[test]
    fn the_centre_of_a_smooth_field_is_exact_for_cubics() {
        let flat = || {
            (PROFILES.iter().find(|choice| choice.name == "flat").unwrap().build)(&Values::default())
        };
        for elements in [[5, 5], [6, 5], [5, 6], [4, 8]] {
            let profiles = [flat().unwrap(), flat().unwrap()];
            let frame = ContactFrame::uniform([2.0, 1.0], elements, [&*profiles[0], &*profiles[1]])
                .unwrap();
            let cubic = |[x, y]: [f64; 2]| 3.0 + x - 2.0 * y + x * y + x * x - y * y * y;
            let field: Vec<f64> = (0..frame.len()).map(|pair| cubic(frame.place(pair))).collect();
            assert_relative_eq!(frame.at_centre(&field), 3.0, epsilon = 1e-13);
        }
    }
}
