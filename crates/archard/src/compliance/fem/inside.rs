//! Displacements and stresses inside a body in tetrahedra.
//!
//! Stresses of quadratic displacements are best at four points of a tetrahedron (J. Barlow, Int. J. Numer. Methods Eng. 10 (1976), 243).
//! They are linear between these, and a node has the mean of the tetrahedra around it, weighed by their volumes (E. Hinton and
//! J. S. Campbell, Int. J. Numer. Methods Eng. 8 (1974), 461).

use std::sync::Arc;

use glam::{DMat3, DVec3};
use rayon::prelude::*;

use super::bearing::Carrier;
use super::stiffness::lame;
use crate::body::Material;
use crate::body::mesh::Volume;
use crate::body::mesh::tetrahedron::{EDGES, Place, slopes, turn, values};
use crate::compliance::bem::{Response, Surface};

/// A place by its coordinates is outside of a tetrahedron by this share of it at most: plane sides cut curved surfaces short.
const OUTSIDE: f64 = 0.1;
/// Steps after which coordinates in a curved tetrahedron are known, or the place lies far from it.
const STEPS: usize = 20;

/// The inside of a body whose nodes are displaced.
#[derive(Debug)]
pub struct Inside {
    volume: Arc<Volume>,
    /// Displacements (m) and stresses (Pa) of the nodes.
    nodes: Vec<Response>,
    /// Stresses (Pa) at the corners of each tetrahedron by itself.
    corners: Vec<[DMat3; 4]>,
    /// The box around each tetrahedron (m).
    boxes: Vec<[DVec3; 2]>,
}

impl Carrier {
    /// The inside under tractions (Pa) of the pairs, three a pair, and all else that loads the body.
    pub fn inside(&self, tractions: &[f64]) -> Inside {
        Inside::new(self.volume(), self.material(), &self.nodes(tractions))
    }
}

impl Inside {
    pub(super) fn new(volume: &Arc<Volume>, material: &Material, displacements: &[f64]) -> Self {
        let at = |node: usize| DVec3::from_slice(&displacements[3 * node..][..3]);
        let of_element = |element: &[usize; 10]| corners(volume, material, element, &at);
        let found: Vec<_> = volume.elements.par_iter().map(of_element).collect();
        let mut sums = vec![(0.0, DMat3::ZERO); volume.nodes.len()];
        for (element, (weight, corners)) in volume.elements.iter().zip(&found) {
            let of_node = |own: usize| match own {
                0..4 => corners[own],
                _ => 0.5 * (corners[EDGES[own - 4][0]] + corners[EDGES[own - 4][1]]),
            };
            for (own, node) in element.iter().enumerate() {
                sums[*node].0 += *weight;
                sums[*node].1 += *weight * of_node(own);
            }
        }
        let node = |(node, (weight, sum)): (usize, (f64, DMat3))| Response {
            displacement: at(node),
            stress: if weight > 0.0 { sum * (1.0 / weight) } else { DMat3::ZERO },
        };
        let nodes = sums.into_iter().enumerate().map(node).collect();
        let around = |element: &[usize; 10]| {
            let places = element.map(|node| DVec3::from(volume.nodes[node]));
            let low = places.into_iter().fold(DVec3::INFINITY, DVec3::min);
            let high = places.into_iter().fold(DVec3::NEG_INFINITY, DVec3::max);
            let margin = OUTSIDE * (high - low).max_element();
            [low - margin, high + margin]
        };
        let boxes = volume.elements.iter().map(around).collect();
        let corners = found.into_iter().map(|(_, corners)| corners).collect();
        Self { volume: Arc::clone(volume), nodes, corners, boxes }
    }

    /// The response at a point (m); `None` outside the body. A point outside by less than a tenth of an element is one of it.
    pub fn at(&self, point: DVec3) -> Option<Response> {
        let (element, at) = self.locate(point)?;
        let mut all = Response { displacement: DVec3::ZERO, stress: DMat3::ZERO };
        for (node, share) in self.volume.elements[element].iter().zip(values(at)) {
            all.displacement += share * self.nodes[*node].displacement;
            all.stress += share * self.nodes[*node].stress;
        }
        Some(all)
    }

    /// The stress (Pa) at a point (m) by its tetrahedron alone, from which the mean over several differs by as much as it may be off
    /// (O. C. Zienkiewicz and J. Z. Zhu, Int. J. Numer. Methods Eng. 24 (1987), 337).
    pub fn by_itself(&self, point: DVec3) -> Option<DMat3> {
        let (element, at) = self.locate(point)?;
        Some(self.corners[element].iter().zip(at).map(|(corner, share)| *corner * share).sum())
    }

    /// The tetrahedron at a point (m), and the coordinates there.
    fn locate(&self, point: DVec3) -> Option<(usize, Place)> {
        let near = |(element, [low, high]): (usize, &[DVec3; 2])| {
            let within = point.cmpge(*low).all() && point.cmple(*high).all();
            let at = within.then(|| self.coordinates(element, point)).flatten()?;
            Some((at.into_iter().fold(f64::INFINITY, f64::min), element, at))
        };
        let found = self.boxes.iter().enumerate().filter_map(near);
        let (least, element, at) = found.max_by(|one, other| one.0.total_cmp(&other.0))?;
        (least > -OUTSIDE).then_some((element, at))
    }

    /// Displacements (m) and stresses (Pa) at the corners of a surface: a value a node of displacements, and one a node of tractions.
    pub fn on(&self, surface: &Surface) -> (Vec<DVec3>, Vec<DMat3>) {
        let tractions = surface.traction_nodes();
        let count = tractions.iter().map(|own| own.node + 1).max().unwrap_or(0);
        let mut displacements = vec![DVec3::ZERO; count];
        let mut stresses = vec![DMat3::ZERO; tractions.len()];
        for (face, nodes) in self.volume.faces.iter().enumerate() {
            for (traction, node) in surface.tractions_of(face).zip(nodes) {
                displacements[tractions[traction].node] = self.nodes[*node].displacement;
                stresses[traction] = self.nodes[*node].stress;
            }
        }
        (displacements, stresses)
    }

    /// Coordinates of a point in a tetrahedron or beyond it.
    fn coordinates(&self, element: usize, point: DVec3) -> Option<Place> {
        let places = self.volume.elements[element].map(|node| DVec3::from(self.volume.nodes[node]));
        let mut at = [0.25; 4];
        for _ in 0..STEPS {
            let shares = values(at);
            let there: DVec3 = places.iter().zip(shares).map(|(place, share)| share * *place).sum();
            let step = turn(&places, at).inverse() * (point - there);
            if !step.is_finite() {
                return None;
            }
            for axis in 0..3 {
                at[axis + 1] += step[axis];
                at[0] -= step[axis];
            }
            if step.abs().max_element() < crate::numerics::SAME {
                break;
            }
        }
        Some(at)
    }
}

/// The volume (m^3) of a tetrahedron, about, and the stresses (Pa) at its corners.
fn corners(
    volume: &Volume,
    material: &Material,
    element: &[usize; 10],
    at: &impl Fn(usize) -> DVec3,
) -> (f64, [DMat3; 4]) {
    // Where an integral of the second degree is exact (O. C. Zienkiewicz and R. L. Taylor, The Finite Element Method).
    let far = 0.25 - 0.05 * 5.0_f64.sqrt();
    let near = 1.0 - 3.0 * far;
    let places = element.map(|node| DVec3::from(volume.nodes[node]));
    let [lame, shear] = lame(material);
    let stress = |corner: usize| {
        let mut place = [far; 4];
        place[corner] = near;
        let inverse = turn(&places, place).inverse().transpose();
        let mut gradient = DMat3::ZERO;
        for (node, slope) in element.iter().zip(slopes(place)) {
            let (own, slope) = (at(*node), inverse * slope);
            gradient += DMat3::from_cols(slope.x * own, slope.y * own, slope.z * own);
        }
        let trace = gradient.x_axis.x + gradient.y_axis.y + gradient.z_axis.z;
        shear * (gradient + gradient.transpose()) + lame * trace * DMat3::IDENTITY
    };
    let found = [0, 1, 2, 3].map(stress);
    let sum: DMat3 = found[0] + found[1] + found[2] + found[3];
    let corners = found.map(|own| (own - sum * far) * (1.0 / (near - far)));
    (turn(&places, [0.25; 4]).determinant() / 6.0, corners)
}
