//! Sums over all elements at one place.

use std::f64::consts::PI;
use std::ops::Range;

use super::far::Far;
use super::layers::half_space;
use super::rest::{self, Rest};
use super::tree::{Part, Tree};
use super::{Below, corner, strip};
use crate::stress::Components;

/// Stress (Pa), and displacement times twice the shear modulus (N/m), with z into the body.
pub(super) type Sums = (Components, [f64; 3]);

/// Adds what unit tractions along each axis do, so many times.
fn add(sums: &mut Sums, own: &Rest, tractions: [f64; 3]) {
    for (axis, traction) in tractions.into_iter().enumerate() {
        (0..6).for_each(|i| sums.0[i] += traction * own.0[axis][i]);
        (0..3).for_each(|i| sums.1[i] += traction * own.1[axis][i]);
    }
}

impl Below {
    /// What even elements do at a place and a depth (m).
    pub(super) fn sums(&self, at: [f64; 2], z: f64) -> Sums {
        if self.depth.is_some() {
            return self.strips(at[0], z);
        }
        let poisson = self.material(z).poisson;
        let tree = self.tree();
        let mut sums = Sums::default();
        // As forces, and by the antiderivatives at the corners of elements that are near.
        let far = Far::of(vec![half_space(z, poisson)]);
        let mut corners = [[0.0; 19]; 3];
        tree.parts(at, z, &mut |part| match part {
            Part::Square(square) => {
                square.each(at, |from, force| far.force(from, force, &mut sums));
            }
            Part::Elements(ranges) => self.corners(&ranges, |corner, change| {
                let own = corner::functions([0, 1].map(|axis| at[axis] - corner[axis]), z);
                for (sums, change) in corners.iter_mut().zip(change) {
                    sums.iter_mut().zip(own).for_each(|(sum, own)| *sum += change * own);
                }
            }),
        });
        for (axis, functions) in corners.iter().enumerate() {
            let own =
                (corner::stress(functions, poisson), corner::displacement(functions, poisson, z));
            let mut share = [0.0; 3];
            share[axis] = 1.0 / (2.0 * PI);
            add(&mut sums, &own, share);
        }
        let Some((layers, piece)) = self.piece(z) else { return sums };
        // What layers add.
        let (far, half) = (layers.far(piece, z), self.spacing.map(|h| 0.5 * h));
        tree.parts(at, far.near(), &mut |part| match part {
            Part::Square(square) => {
                square.each(at, |from, force| far.force(from, force, &mut sums));
            }
            Part::Elements([columns, rows]) => {
                for element in rows.flat_map(|j| columns.clone().map(move |i| (i, j))) {
                    let element = element.0 + self.elements[0] * element.1;
                    let tractions = [0, 1, 2].map(|axis| self.tractions[axis][element]);
                    if tractions != [0.0; 3] {
                        let place = self.place(element);
                        let from = [0, 1].map(|axis| at[axis] - place[axis]);
                        add(&mut sums, &far.element(from, half), tractions);
                    }
                }
            }
        });
        sums
    }

    /// The same of strips, from their edges.
    fn strips(&self, x: f64, z: f64) -> Sums {
        let poisson = self.material(z).poisson;
        let seen = self.piece(z).map_or(vec![], |(layers, piece)| layers.seen(piece, z));
        let mut sums = Sums::default();
        self.corners(&[0..self.elements[0], 0..1], |[edge, _], change| {
            let change = change.map(|change| change / PI);
            let functions = strip::functions(x - edge, z);
            let moved = strip::displacement(&functions, poisson, z);
            add(&mut sums, &(strip::stress(&functions, poisson), moved), change);
            if !seen.is_empty() {
                add(&mut sums, &rest::at_edge(&seen, x - edge), change);
            }
        });
        sums
    }

    /// The tractions by squares of elements.
    fn tree(&self) -> &Tree {
        let made = || Tree::of(&self.tractions, self.elements, (self.spacing, self.corner));
        self.tree.get_or_init(made)
    }

    /// The corners of elements, or the edges of strips, where tractions change (m), and by how much (Pa), were there no other elements.
    pub(super) fn corners(
        &self,
        [columns, rows]: &[Range<usize>; 2],
        mut see: impl FnMut([f64; 2], [f64; 3]),
    ) {
        let nx = self.elements[0];
        let line = self.depth.is_some();
        let at = |axis: usize, i: usize, j: usize| -> f64 {
            // The element whose lowest corner this is, counted from one.
            let inside = i > columns.start && i <= columns.end && j > rows.start && j <= rows.end;
            if inside { self.tractions[axis][i - 1 + nx * (j - 1)] } else { 0.0 }
        };
        let last = if line { rows.end } else { rows.end + 1 };
        for j in rows.start + 1..=last {
            for i in columns.start + 1..=columns.end + 1 {
                let change = [0, 1, 2].map(|axis| {
                    let [here, left] = [at(axis, i, j), at(axis, i - 1, j)];
                    let below = at(axis, i, j - 1) - at(axis, i - 1, j - 1);
                    if line { here - left } else { (here - left) - below }
                });
                if change != [0.0; 3] {
                    let corner = [i, j].map(|index| (index - 1) as f64);
                    see(
                        [0, 1].map(|axis| self.corner[axis] + self.spacing[axis] * corner[axis]),
                        change,
                    );
                }
            }
        }
    }
}
