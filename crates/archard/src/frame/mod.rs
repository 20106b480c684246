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

mod field;

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
        let touch = frame.gap.iter().copied().fold(f64::INFINITY, f64::min);
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

    /// Value of a smooth field at the frame's centre: the pair's own where one sits there, otherwise
    /// the mean of the two or four around it, corrected for curvature by their next neighbours.
    pub fn at_centre(&self, field: &[f64]) -> f64 {
        let [nx, ny] = self.elements;
        let weights = |n: usize| -> Vec<(usize, f64)> {
            match (n % 2, n) {
                (1, _) => vec![(n / 2, 1.0)],
                (_, 2) => vec![(0, 0.5), (1, 0.5)],
                _ => [-1.0, 9.0, 9.0, -1.0]
                    .iter()
                    .enumerate()
                    .map(|(i, w)| (n / 2 - 2 + i, w / 16.0))
                    .collect(),
            }
        };
        let along_x = weights(nx);
        let row = |iy: usize| along_x.iter().map(|(ix, w)| w * field[ix + nx * iy]).sum::<f64>();
        weights(ny).iter().map(|(iy, w)| w * row(*iy)).sum()
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
