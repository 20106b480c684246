//! What the ends of a body in tetrahedra change of the half-space below its zone.

use faer::Mat;
use glam::DVec3;
use rayon::prelude::*;

use super::surplus::Surplus;
use super::triangle::points;
use super::{Inside, Solid};
use crate::compliance::bem::image::{Columns, Field, NearField, Polynomials};

/// Triangles on which fields are found at once.
const BATCH: usize = 256;

/// The image field of a body between polynomials on its zone.
#[derive(Debug)]
pub struct ImageField {
    /// K (m/N): row and column d m + i for the i-th of m polynomials as a traction along axis d.
    pub compliance: Mat<f64>,
    /// What cubic functions would change in it (m/N), about.
    pub change: Mat<f64>,
}

impl Solid {
    /// The image field of loads on a rectangle of the face z = 0, below which the body lies.
    pub fn image(&self, polynomials: &Polynomials) -> ImageField {
        let columns = Columns::new(polynomials, [false; 2]);
        let near = NearField::new(&self.material, polynomials, &columns);
        let mut surplus = Surplus::new(&self.volume, columns.count());
        let (compliance, displacements) = self.found(&near, Some(&mut surplus));
        let change = surplus.energy(self, &displacements, &near);
        ImageField { compliance, change }
    }

    /// K (m/N) of the image field alone.
    pub fn compliance(&self, polynomials: &Polynomials) -> Mat<f64> {
        let columns = Columns::new(polynomials, [false; 2]);
        self.found(&NearField::new(&self.material, polynomials, &columns), None).0
    }

    /// What the ends of the body add inside to the field of the half-space under loads (N): d m + i is that of the i-th of m polynomials
    /// along axis d.
    pub fn inside(&self, polynomials: &Polynomials, loads: &[f64]) -> Inside {
        let columns = Columns::new(polynomials, [false; 2]);
        let (_, each) = self.found(&NearField::new(&self.material, polynomials, &columns), None);
        let mut displacements = vec![0.0; 3 * self.volume.nodes.len()];
        for (own, load) in each.iter().zip(loads) {
            displacements.iter_mut().zip(own).for_each(|(sum, own)| *sum += load * own);
        }
        Inside::new(&self.volume, &self.material, &displacements)
    }

    /// K (m/N), and the displacements (m) of all nodes, one vector a load; the tractions that act are laid on cubic functions too.
    fn found(
        &self,
        near: &NearField<'_>,
        surplus: Option<&mut Surplus>,
    ) -> (Mat<f64>, Vec<Vec<f64>>) {
        let loads = near.loads();
        let count = 3 * self.volume.nodes.len();
        let mut forces = vec![vec![0.0; count]; loads];
        let work = self.undo(near, &mut forces, surplus);
        let mut displacements = vec![vec![0.0; count]; loads];
        let held: Vec<usize> =
            (0..self.nodes.len()).filter(|node| self.nodes[*node].count > 0).collect();
        let fields: Vec<Field> = held
            .par_iter()
            .map(|node| near.at(DVec3::from(self.volume.nodes[*node]), DVec3::Z))
            .collect();
        for (&node, field) in held.iter().zip(&fields) {
            for (displaced, value) in displacements.iter_mut().zip(&field.displacement) {
                let back = -self.nodes[node].held(*value);
                displaced[3 * node..3 * node + 3].copy_from_slice(&back.to_array());
            }
        }
        let given = displacements.clone();
        self.solve(&mut displacements, &forces);
        let reactions: Vec<Vec<f64>> = displacements
            .par_iter()
            .zip(&forces)
            .map(|(displaced, force)| {
                let mut reaction = self.stiffness.times(displaced);
                reaction.iter_mut().zip(force).for_each(|(reaction, force)| *reaction -= force);
                reaction
            })
            .collect();
        let dot = |one: &[f64], other: &[f64]| -> f64 {
            one.iter().zip(other).map(|(one, other)| one * other).sum()
        };
        // By Betti's theorem, with what is held and what is free of the half-space's own field in `work`.
        let of = |(q, p): (usize, usize)| {
            work[(q, p)] + dot(&forces[q], &displacements[p]) - dot(&reactions[p], &given[q])
        };
        let pairs: Vec<(usize, usize)> =
            (0..loads).flat_map(|q| (0..loads).map(move |p| (q, p))).collect();
        let found: Vec<f64> = pairs.par_iter().map(|pair| of(*pair)).collect();
        let compliance =
            Mat::from_fn(loads, loads, |q, p| 0.5 * (found[q * loads + p] + found[p * loads + q]));
        (compliance, displacements)
    }

    /// Forces (N) that take the tractions of the half-space from what is free of the surface, one vector a load; and Betti's integrals of
    /// the half-space's own field: row by seeing load, column by acting one.
    fn undo(
        &self,
        near: &NearField<'_>,
        forces: &mut [Vec<f64>],
        mut surplus: Option<&mut Surplus>,
    ) -> Mat<f64> {
        let (loads, rule) = (forces.len(), points());
        let mut work: Mat<f64> = Mat::zeros(loads, loads);
        let faces: Vec<usize> = (0..self.volume.faces.len()).collect();
        for batch in faces.chunks(BATCH) {
            let of_face = |face: &usize| {
                let places =
                    self.volume.faces[*face].map(|node| DVec3::from(self.volume.nodes[node]));
                let at = |point: &super::triangle::Point| {
                    let [place, normal] = point.on(&places);
                    near.off_the_face(place, normal.normalize())
                        .map(|field| (field, normal.length()))
                };
                rule.iter().map(at).collect::<Vec<_>>()
            };
            let fields: Vec<_> = batch.par_iter().map(of_face).collect();
            // Displacements, and tractions (N) on what is held and on what is free, three rows a point.
            let rows = 3 * rule.len() * batch.len();
            let [mut displaced, mut held, mut freed] = [(); 3].map(|()| Mat::zeros(rows, loads));
            for (index, (&face, fields)) in batch.iter().zip(&fields).enumerate() {
                let support = self.faces[face];
                for (point, (of_point, field)) in rule.iter().zip(fields).enumerate() {
                    let Some((Field { displacement, traction }, area)) = field else { continue };
                    let free: Vec<DVec3> =
                        traction.iter().map(|traction| -*area * support.free(*traction)).collect();
                    for (load, back) in free.iter().enumerate() {
                        let force = &mut forces[load];
                        for (node, share) in self.volume.faces[face].iter().zip(of_point.nodes) {
                            for axis in 0..3 {
                                force[3 * node + axis] += share * back[axis];
                            }
                        }
                        let pulled = *area * support.held(traction[load]);
                        for axis in 0..3 {
                            let row = 3 * (rule.len() * index + point) + axis;
                            displaced[(row, load)] = displacement[load][axis];
                            held[(row, load)] = pulled[axis];
                            freed[(row, load)] = back[axis];
                        }
                    }
                    if let Some(surplus) = &mut surplus {
                        surplus.load(face, of_point, &free);
                    }
                }
            }
            work += displaced.transpose() * &held + freed.transpose() * &displaced;
        }
        work
    }
}
