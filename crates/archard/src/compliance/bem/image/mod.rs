//! What the ends of a body change of the half-space below its flat zone: an image field, which is smooth.
//!
//! Let h and T be displacements and tractions of a half-space under a load of the zone. The body's field is h + c, where c has no
//! traction on the face of the zone, -T on the other free faces and -h where the body is held: smooth data, for which a coarse mesh
//! does. By Betti's theorem the displacement of the zone under a load p, seen by a load q, is that of the half-space and
//!
//! ```text
//! K_qp = integral over what is held of t_p . h_q  -  integral over what is free of T_q . u_p
//! ```
//!
//! with the body's own u and t, so that nothing is evaluated in the zone. Loads are polynomials on the zone.

mod field;
mod inside;
mod near;
mod zone;

use faer::Mat;
use glam::DVec3;
use rayon::prelude::*;

use super::contact::supported;
use super::loads::{LoadResponse, Loads};
use super::{AssembledBody, AxisCondition, Conditions, Indeterminacy, Surface};
use crate::body::mesh::Mesh;
use crate::body::{Finite, Material};
use crate::frame::Rectangle;
use crate::numerics::SAME;
use crate::numerics::dense::SolveError;

use near::on_the_face;
pub(in crate::compliance) use near::{Columns, Field, NearField};
pub use zone::Polynomials;

/// By how much polynomials may miss an image field, relative to the field: less than elements do.
pub const MISSED: f64 = 1e-4;
/// Degrees at most: nearer to an edge an image field is no polynomial.
pub const MOST_DEGREES: usize = 12;

/// Why there is no image field.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoImage {
    /// A body that is not held.
    #[error(transparent)]
    Undetermined(#[from] Indeterminacy),
    /// Equations without a solution.
    #[error(transparent)]
    Unsolved(#[from] SolveError),
}

/// A body whose zone lies on the flat face z = 0, below which it is, meshed without regard to the zone.
#[derive(Debug, Clone, Copy)]
pub struct ImageBody<'a> {
    pub finite: &'a Finite,
    pub mesh: &'a Mesh,
    pub material: &'a Material,
}

/// The degree of polynomials that an image field on a rectangle takes to be met to a tolerance, relative to what it is itself: it has
/// no singularity nearer than the mirror images of the rectangle in the planes of the body's other faces. `None` beyond
/// [`MOST_DEGREES`].
pub fn degree(
    mesh: &Mesh,
    mirrored: [bool; 2],
    rectangle: &Rectangle,
    tolerance: f64,
) -> Option<usize> {
    degree_by(mesh, (mirrored, 2.0), rectangle, tolerance)
}

/// The same for the field of the loads anywhere in the body: a place of a face is a singularity of what loads do there.
pub fn degree_inside(
    mesh: &Mesh,
    mirrored: [bool; 2],
    rectangle: &Rectangle,
    tolerance: f64,
) -> Option<usize> {
    degree_by(mesh, (mirrored, 1.0), rectangle, tolerance)
}

/// By singularities so many times as far from the rectangle as the planes of the faces.
fn degree_by(
    mesh: &Mesh,
    (mirrored, times): ([bool; 2], f64),
    rectangle: &Rectangle,
    tolerance: f64,
) -> Option<usize> {
    let signs = |mirrored: bool| if mirrored { vec![1.0, -1.0] } else { vec![1.0] };
    let [along_x, along_y] = mirrored.map(signs);
    let images = along_x.iter().flat_map(|x| along_y.iter().map(|y| DVec3::new(*x, *y, 1.0)));
    let images: Vec<DVec3> = images.collect();
    let corners = rectangle.corners().map(|[x, y]| DVec3::new(x, y, 0.0));
    let nearest = (0..mesh.faces.len()).flat_map(|face| {
        let (place, normal) = (DVec3::from(mesh.centre(face)), DVec3::from(mesh.area_vector(face)));
        let normal = normal.normalize_or_zero();
        let beside = normal.z < 1.0 - SAME;
        let seen = images.iter().filter(move |_| beside);
        seen.flat_map(move |image| {
            let (place, normal) = (*image * place, *image * normal);
            corners.map(|corner| {
                let there = corner + times * normal.dot(place - corner) * normal;
                zone::ratio(rectangle, there)
            })
        })
    });
    let ratio = nearest.fold(f64::INFINITY, f64::min);
    let degree = (tolerance.recip().ln() / ratio.ln()).ceil();
    (degree <= MOST_DEGREES as f64).then_some(degree.max(1.0) as usize)
}

/// Whether the face z = 0 of a body holds a rectangle: its corners and the middles of its sides.
pub fn holds(mesh: &Mesh, mirrored: [bool; 2], rectangle: &Rectangle) -> bool {
    let top = |face: &usize| {
        let place = DVec3::from(mesh.centre(*face));
        on_the_face(place, DVec3::from(mesh.area_vector(*face)).normalize_or_zero())
    };
    let faces: Vec<Vec<DVec3>> = (0..mesh.faces.len())
        .filter(top)
        .map(|face| {
            let corners = mesh.faces[face].corners.as_slice().iter();
            corners.map(|&corner| mesh.vertices[corner].into()).collect()
        })
        .collect();
    let near = SAME * mesh.extent();
    let on_one = |[along, across]: [f64; 2]| {
        let place = [along, across].into_iter().enumerate().map(|(axis, share)| {
            let place = rectangle.centre[axis] + 0.5 * share * rectangle.size[axis];
            if mirrored[axis] { place.abs() } else { place }
        });
        let place: Vec<f64> = place.collect();
        let place = DVec3::new(place[0], place[1], 0.0);
        faces.iter().any(|corners| super::distance(place, corners) <= near)
    };
    let steps = [-1.0, 0.0, 1.0];
    steps.iter().all(|&along| steps.iter().all(|&across| on_one([along, across])))
}

impl ImageBody<'_> {
    /// K (m/N): row and column d m + i for the i-th of m polynomials as a traction along axis d. Where planes of symmetry halve the
    /// body, what is not symmetric is zero.
    ///
    /// # Errors
    /// If the body is not held, or its equations have no solution.
    pub fn compliance(&self, polynomials: &Polynomials) -> Result<Mat<f64>, NoImage> {
        let Self { finite, mesh, material } = *self;
        let surface = Surface::new(mesh, finite.interpolation, finite.mirrored);
        let conditions = Conditions::new(&surface, |node| supported(finite, node), &[])?;
        let columns = Columns::new(polynomials, finite.mirrored);
        let near = NearField::new(material, polynomials, &columns);
        let at = |node: &super::TractionNode| {
            near.off_the_face(node.place, node.normal).unwrap_or_else(|| near.nothing())
        };
        let fields: Vec<Field> = surface.traction_nodes().par_iter().map(at).collect();
        let loads = loads(&surface, &conditions, &fields);
        let equations =
            AssembledBody::under((&surface, &conditions), material, finite.tolerance, &loads)
                .map_err(SolveError::from)?;
        let loaded = equations.factorise()?.loaded();
        let work = work(&surface, &conditions, (&fields, &loads, &loaded));
        let size = 3 * columns.polynomials;
        let mut compliance = Mat::zeros(size, size);
        for (row, &q) in columns.kept.iter().enumerate() {
            for (column, &p) in columns.kept.iter().enumerate() {
                compliance[(q, p)] = 0.5 * (work[(row, column)] + work[(column, row)]);
            }
        }
        Ok(compliance)
    }
}

/// What undoes the fields: tractions on free faces, displacements of what is held.
fn loads(surface: &Surface, conditions: &Conditions, fields: &[Field]) -> Loads {
    let count = fields.first().map_or(0, |field| field.traction.len());
    let mut loads = Loads {
        tractions: vec![vec![0.0; count]; 3 * fields.len()],
        displacements: vec![vec![0.0; count]; 3 * surface.nodes.len()],
    };
    for (index, (node, field)) in surface.traction_nodes().iter().zip(fields).enumerate() {
        let condition = &conditions.tractions[index];
        for (direction, (unit, given)) in condition.basis.iter().zip(condition.given).enumerate() {
            if let AxisCondition::Displacement(_) = given {
                let own = conditions.own(node.node, *unit);
                let along = conditions.nodes[node.node].basis[own];
                let values = field.displacement.iter().map(|value| -value.dot(along));
                loads.displacements[3 * node.node + own] = values.collect();
            } else {
                let values = field.traction.iter().map(|value| -value.dot(*unit));
                loads.tractions[3 * index + direction] = values.collect();
            }
        }
    }
    loads
}

/// Betti's integrals, from what was found: row by seeing load, column by acting one.
fn work(
    surface: &Surface,
    conditions: &Conditions,
    (fields, loads, loaded): (&[Field], &Loads, &LoadResponse),
) -> Mat<f64> {
    let count = loads.count();
    let images = surface.images().len() as f64;
    let rows = 3 * fields.len();
    // What acts, weighed by areas, and what sees it.
    let (mut acting, mut seeing) = (Mat::zeros(rows, count), Mat::zeros(rows, count));
    for (index, (node, field)) in surface.traction_nodes().iter().zip(fields).enumerate() {
        let condition = &conditions.tractions[index];
        let held = conditions.nodes[node.node];
        for (direction, (unit, given)) in condition.basis.iter().zip(condition.given).enumerate() {
            let row = 3 * index + direction;
            for load in 0..count {
                let weight = images * node.area;
                let (displacement, traction) = (field.displacement[load], field.traction[load]);
                if let AxisCondition::Displacement(_) = given {
                    let own = conditions.own(node.node, *unit);
                    let along = held.basis[own];
                    let found = loaded.traction(conditions, (node.node, own), load);
                    acting[(row, load)] = weight * (traction.dot(along) + found);
                    seeing[(row, load)] = displacement.dot(along);
                } else {
                    let moved: DVec3 = (0..3)
                        .map(|own| {
                            let value = match held.known[own] {
                                Some(_) => loads.displacements[3 * node.node + own][load],
                                None => loaded.displacement(conditions, (node.node, own), load),
                            };
                            value * held.basis[own]
                        })
                        .sum();
                    acting[(row, load)] = -weight * (displacement + moved).dot(*unit);
                    seeing[(row, load)] = traction.dot(*unit);
                }
            }
        }
    }
    seeing.transpose() * acting
}
