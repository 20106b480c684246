//! Vectors at the pairs of a frame, and sums of fields over it.

use super::grid::Grid;
use super::{ContactFrame, Shape, VectorField};

/// The axes of the frame.
const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl ContactFrame {
    /// The unit vectors t1, t2 and n of a pair in the axes of the frame.
    pub fn basis(&self, pair: usize) -> [[f64; 3]; 3] {
        match &self.shape {
            Shape::Uniform(Grid { wrap: Some(wrap), .. }) => wrap.basis(self.place(pair)),
            Shape::Uniform(_) => AXES,
            Shape::Described(described) => described.pairs.bases.get(pair).copied().unwrap_or(AXES),
        }
    }

    /// The components along t1, t2 and n of a pair of a vector in the axes of the frame.
    pub fn resolve(&self, pair: usize, vector: [f64; 3]) -> [f64; 3] {
        if self.is_plane() {
            return vector;
        }
        self.basis(pair).map(|unit| unit.iter().zip(vector).map(|(u, v)| u * v).sum())
    }

    /// The vector in the axes of the frame with these components along t1, t2 and n of a pair.
    pub fn compose(&self, pair: usize, [t1, t2, n]: [f64; 3]) -> [f64; 3] {
        if self.is_plane() {
            return [t1, t2, n];
        }
        let basis = self.basis(pair);
        [0, 1, 2].map(|axis| t1 * basis[0][axis] + t2 * basis[1][axis] + n * basis[2][axis])
    }

    /// What the pairs are displaced by against each other, in their bases, when body 2 moves by a vector in
    /// the axes of the frame.
    pub fn moved(&self, vector: [f64; 3]) -> VectorField {
        if self.is_plane() {
            let [t1, t2, n] = vector.map(|component| vec![component; self.len()]);
            return VectorField { t1, t2, n };
        }
        let mut field = VectorField::zeros(self.len());
        for pair in 0..self.len() {
            [field.t1[pair], field.t2[pair], field.n[pair]] = self.resolve(pair, vector);
        }
        field
    }

    /// Corners (m) of the part of the surface that a pair stands for, in order.
    pub fn outline(&self, pair: usize) -> Vec<[f64; 3]> {
        match &self.shape {
            Shape::Uniform(grid) => {
                let ([x, y], [dx, dy]) = (grid.place(pair), grid.spacing());
                [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]
                    .map(|[a, b]| [x + a * dx, y + b * dy, 0.0])
                    .to_vec()
            }
            Shape::Described(described) => described.pairs.outlines[pair].clone(),
        }
    }

    /// Integral of a field over the frame (its unit times m^2).
    pub fn integrate(&self, field: &[f64]) -> f64 {
        match &self.shape {
            Shape::Uniform(_) => field.iter().sum::<f64>() * self.element_area(),
            Shape::Described(described) => {
                field.iter().zip(&described.pairs.areas).map(|(value, area)| value * area).sum()
            }
        }
    }

    /// Area (m^2) of the pairs for which something holds.
    pub fn area_where(&self, holds: impl Fn(usize) -> bool) -> f64 {
        let pairs = (0..self.len()).filter(|&pair| holds(pair));
        match &self.shape {
            Shape::Uniform(_) => pairs.count() as f64 * self.element_area(),
            Shape::Described(described) => pairs.map(|pair| described.pairs.areas[pair]).sum(),
        }
    }

    /// Force (N) of tractions (Pa) in the axes of the frame; what mirror images cancel is zero.
    pub fn force(&self, tractions: &VectorField) -> [f64; 3] {
        let VectorField { t1, t2, n } = tractions;
        let sums = if self.is_plane() {
            [t1, t2, n].map(|part| self.integrate(part))
        } else {
            (0..self.len()).fold([0.0; 3], |sum, pair| {
                let traction = self.compose(pair, [t1[pair], t2[pair], n[pair]]);
                [0, 1, 2].map(|axis| sum[axis] + self.area(pair) * traction[axis])
            })
        };
        let [x, y] = self.mirrored();
        [if x { 0.0 } else { sums[0] }, if y { 0.0 } else { sums[1] }, sums[2]]
    }
}
