//! What chords of a sphere are longer or shorter by than distances on Lambert's map of it.
//!
//! Influences between two places depend on their chord. With places at r and r' from the pole of the map and D between them, of a sphere of
//! radius R,
//!
//! ```text
//! chord^2 - D^2 = [(r^2 - r'^2)^2 - (r^2 + r'^2) D^2]/(8 R^2)
//! ```
//!
//! but for terms of higher order in r^2/R^2. To first order an influence G(D) changes by G'(D)/(2 D) times this: a few products of powers of
//! r^2/R^2 with convolutions. Against harmonics of the sphere, pressures under a contact up to 66 degrees from the pole are met to 1e-3 in
//! layers and to 4e-3 on a ball in something rigid; on the map alone they are off by 2e-3 and 2e-2.

use super::influence::Influence;
use crate::body::profile::Round;
use crate::frame::{ContactFrame, Extent};
use crate::numerics::convolution::{Convolution, Parity, Spectrum};

/// Where the elements of a frame lie on a sphere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Curved {
    /// Radius (m) of the sphere.
    radius: f64,
    /// Middle of the first element (m).
    first: [f64; 2],
    /// Size of an element (m).
    spacing: [f64; 2],
}

impl Curved {
    /// Those of a frame on Lambert's map; `None` of another one.
    pub fn of(frame: &ContactFrame) -> Option<Self> {
        let wrap = frame.wrap().filter(|wrap| wrap.round == Round::Sphere)?;
        Some(Self { radius: wrap.radius, first: frame.place(0), spacing: frame.spacing() })
    }

    /// Those of a part of the frame.
    pub fn within(&self, part: &Extent) -> Self {
        let first = |axis: usize| self.first[axis] + self.spacing[axis] * part[axis].start as f64;
        Self { first: [0, 1].map(first), ..*self }
    }

    /// Elements of twice the size, from the same corner.
    pub fn coarser(&self) -> Self {
        let first = [0, 1].map(|axis| self.first[axis] + 0.5 * self.spacing[axis]);
        Self { first, spacing: self.spacing.map(|h| 2.0 * h), ..*self }
    }

    /// r^2/R^2 of so many elements.
    fn squares(&self, [nx, ny]: [usize; 2]) -> Vec<f64> {
        let along = |axis: usize, count: usize| -> Vec<f64> {
            let place = |i: usize| (self.first[axis] + self.spacing[axis] * i as f64) / self.radius;
            (0..count).map(|i| place(i).powi(2)).collect()
        };
        let (x, y) = (along(0, nx), along(1, ny));
        y.iter().flat_map(|y| x.iter().map(move |x| x + y)).collect()
    }
}

/// The change of the influence of a pressure, as fields and kernels.
#[derive(Debug)]
pub(super) struct Bending {
    /// r^2/R^2 of the elements.
    squares: Vec<f64>,
    /// G'(D)/(2 D) times D^2/8, and times R^2/8.
    kernels: [Spectrum; 2],
}

impl Bending {
    /// That of elements, for a convolution.
    pub fn new(curved: &Curved, influence: &Influence, convolution: &Convolution) -> Self {
        let elements = influence.elements();
        let near = influence.by_square();
        let far = |[x, y]: [usize; 2]| {
            let [a, b] = curved.spacing;
            (a * x as f64).powi(2) + (b * y as f64).powi(2)
        };
        let far = (0..near.len()).map(|index| far([index % elements[0], index / elements[0]]));
        let by_distance: Vec<f64> = far.zip(&near).map(|(far, near)| 0.125 * far * near).collect();
        let eighth = 0.125 * curved.radius * curved.radius;
        let by_place: Vec<f64> = near.iter().map(|near| eighth * near).collect();
        let kernels = [by_distance, by_place]
            .map(|kernel| convolution.spectrum(&kernel, elements[0], [Parity::Even; 2]));
        Self { squares: curved.squares(elements), kernels }
    }

    /// The displacements (m) under pressures (Pa), with the kernel on the map.
    pub fn apply(
        &self,
        (convolution, normal): (&Convolution, &Spectrum),
        pressure: &[f64],
        displacement: &mut [f64],
    ) {
        let times = |field: &[f64]| -> Vec<f64> {
            field.iter().zip(&self.squares).map(|(value, square)| value * square).collect()
        };
        let once = times(pressure);
        let twice = times(&once);
        let [mut by_one, mut by_two] = [vec![0.0; pressure.len()], vec![0.0; pressure.len()]];
        let [near, far] = self.kernels.each_ref();
        // With q of the displaced place and q' of the pressed one, (q - q')^2 far - (q + q') near.
        let kernels = [
            [(normal, 1.0), (near, -1.0), (far, 1.0)],
            [(near, -1.0), (far, -2.0), (far, 0.0)],
            [(far, 1.0), (far, 0.0), (far, 0.0)],
        ];
        let results = [&mut *displacement, &mut by_one[..], &mut by_two[..]];
        convolution.apply_matrix(kernels, [pressure, &once, &twice], results);
        let terms = by_one.iter().zip(&by_two).zip(&self.squares);
        displacement
            .iter_mut()
            .zip(terms)
            .for_each(|(up, ((one, two), square))| *up += square * (one + square * two));
    }
}
