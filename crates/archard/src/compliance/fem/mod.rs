//! Bodies in tetrahedra, by finite elements: their image fields, and bodies that [bear](Carrier) a contact on their own nodes.
//!
//! As [on a surface](super::bem::image), what the ends of a body change of the half-space below its flat zone is smooth, and a mesh that
//! knows nothing of the zone does. Displacements are quadratic in each tetrahedron; what cubic functions would add to their energy says
//! how far they are off (P. Deuflhard, P. Leinen and H. Yserentant, IMPACT Comput. Sci. Eng. 1 (1989), 3).

mod bearing;
mod factors;
mod held;
mod image;
mod inside;
mod reduced;
mod stiffness;
mod surplus;
#[cfg(test)]
mod tests;
mod together;
mod triangle;

use std::sync::Arc;

use faer::Mat;

use crate::body::mesh::Volume;
use crate::body::{Finite, Material};
use crate::numerics::dense::SolveError;
use factors::Factors;
use held::{Held, held};
use stiffness::Stiffness;

pub use bearing::{Carrier, OnNodes, places};
pub use image::ImageField;
pub use inside::Inside;
pub use reduced::{Superelement, Unfit};

/// A body in tetrahedra under its supports, its equations factorised.
#[derive(Debug)]
pub struct Solid {
    volume: Arc<Volume>,
    material: Material,
    /// What supports hold, node by node and triangle by triangle of the surface.
    nodes: Vec<Held>,
    faces: Vec<Held>,
    stiffness: Stiffness,
    /// The number of each free direction of each node among the unknowns.
    numbers: Vec<[usize; 3]>,
    /// `None` where everything is held.
    factors: Option<Factors>,
}

impl Solid {
    /// Of a body that has a volume; its supports hold it and load it nowhere.
    ///
    /// # Errors
    /// If the equations are singular, or there is no memory for them.
    pub fn new(
        finite: &Finite,
        volume: &Arc<Volume>,
        material: &Material,
    ) -> Result<Self, SolveError> {
        let [nodes, faces] = held(finite, volume);
        let stiffness = Stiffness::new(volume, material);
        let (matrix, numbers) = stiffness.between_free(&nodes);
        let factors = matrix.as_ref().map(Factors::new).transpose()?;
        let (volume, material) = (Arc::clone(volume), *material);
        Ok(Self { volume, material, nodes, faces, stiffness, numbers, factors })
    }

    /// Number of unknowns.
    fn unknowns(&self) -> usize {
        self.factors.as_ref().map_or(0, Factors::size)
    }

    /// Puts what is sought (m) in the place of forces (N) along what is free, a column a load.
    fn solve_sought(&self, forces: &mut Mat<f64>) {
        if let Some(factors) = &self.factors {
            factors.solve(forces);
        }
    }

    /// Displacements (m) under forces (N), where what is held is displaced already: three values a node, one vector a load.
    fn solve(&self, displacements: &mut [Vec<f64>], forces: &[Vec<f64>]) {
        let mut sought = Mat::zeros(self.unknowns(), forces.len());
        let free = || {
            let nodes = self.nodes.iter().zip(&self.numbers).enumerate();
            nodes.flat_map(|(node, (held, numbers))| {
                (held.count..3).map(move |along| (node, held.basis[along], numbers[along]))
            })
        };
        let at =
            |values: &[f64], node: usize| glam::DVec3::from_slice(&values[3 * node..3 * node + 3]);
        for (load, (displaced, force)) in displacements.iter().zip(forces).enumerate() {
            let resisted = match displaced.iter().any(|one| *one != 0.0) {
                true => self.stiffness.times(displaced),
                false => vec![0.0; displaced.len()],
            };
            for (node, unit, number) in free() {
                sought[(number, load)] = (at(force, node) - at(&resisted, node)).dot(unit);
            }
        }
        self.solve_sought(&mut sought);
        for (load, displaced) in displacements.iter_mut().enumerate() {
            for (node, unit, number) in free() {
                let more = sought[(number, load)] * unit;
                for axis in 0..3 {
                    displaced[3 * node + axis] += more[axis];
                }
            }
        }
    }
}
