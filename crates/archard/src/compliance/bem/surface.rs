//! The surface of a body as boundary elements: their nodes, and what belongs to each.

use std::collections::HashMap;

use glam::DVec3;

use super::element::{element, evaluate};
use super::patch::Patch;
use super::rules::{OF_AREAS, Places, Rules};
use crate::body::Interpolation;
use crate::body::mesh::{Corners, Mesh};

/// A meshed surface with its nodes.
///
/// A node has a displacement. Tractions have nodes of their own: where continuous elements of several
/// surfaces meet, each surface has one.
#[derive(Debug, Clone)]
pub struct Surface {
    pub(super) patches: Vec<Patch>,
    /// Vertices of the mesh at the corners of every element.
    pub(super) corners: Vec<Corners>,
    /// Nodes of displacement and of traction by element and shape function.
    pub(super) local: Vec<[Local; 4]>,
    pub(super) nodes: Vec<DVec3>,
    pub(super) tractions: Vec<TractionNode>,
    /// Whether x and y are mirrored in the planes x = 0 and y = 0.
    pub(super) mirrored: [bool; 2],
    names: Vec<String>,
}

/// What a shape function multiplies: the displacement of a node and a traction.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Local {
    pub node: usize,
    pub traction: usize,
}

/// A node of tractions.
#[derive(Debug, Clone, Copy)]
pub struct TractionNode {
    /// The node of displacements at the same place.
    pub node: usize,
    /// The surface it is on.
    pub surface: usize,
    /// Where it is (m).
    pub place: DVec3,
    /// Outward unit normal, that of the elements around it weighed by their areas.
    pub normal: DVec3,
    /// The area it stands for (m^2), mirror images left out.
    pub area: f64,
}

impl Surface {
    /// The elements of a mesh, mirrored in the planes x = 0 and y = 0 where asked for.
    pub fn new(mesh: &Mesh, interpolation: Interpolation, mirrored: [bool; 2]) -> Self {
        let mut surface = Self {
            patches: vec![],
            corners: vec![],
            local: vec![],
            nodes: vec![],
            tractions: vec![],
            mirrored,
            names: mesh.surfaces.clone(),
        };
        let rules = Rules::new(1e-6);
        let mut places = Places::default();
        let (mut by_vertex, mut by_side) = (HashMap::new(), HashMap::new());
        for face in &mesh.faces {
            let corners = face.corners.as_slice();
            let element = element(interpolation, corners.len());
            let places_of = corners.iter().map(|&vertex| DVec3::from(mesh.vertices[vertex]));
            let patch = Patch::new(places_of.collect(), element);
            places.clear();
            rules.whole(&patch, [OF_AREAS; 2], &mut places);
            let mut local = [Local::default(); 4];
            for (index, &at) in element.nodes.iter().enumerate() {
                let place = patch.at(at);
                let node = if element.continuous {
                    *by_vertex.entry(corners[index]).or_insert_with(|| surface.add_node(place))
                } else {
                    surface.add_node(place)
                };
                let traction = *by_side
                    .entry((node, face.surface))
                    .or_insert_with(|| surface.add_traction(node, face.surface));
                local[index] = Local { node, traction };
                let (mut area, mut normal) = (0.0, DVec3::ZERO);
                for ((&s, &t), weight) in places.s.iter().zip(&places.t).zip(&places.weight) {
                    let vector = *weight * patch.area_vector([s, t]);
                    let share = evaluate(&element.shape[index], [s, t]);
                    area += share * vector.length();
                    normal += share * vector;
                }
                // Triangles and warped quadrilaterals: the normal at the node itself.
                let at_node = patch.area_vector(at).normalize_or_zero();
                let traction = &mut surface.tractions[traction];
                traction.area += area;
                traction.normal += if element.continuous { normal } else { at_node };
            }
            surface.patches.push(patch);
            surface.corners.push(face.corners);
            surface.local.push(local);
        }
        for traction in &mut surface.tractions {
            for (axis, _) in mirrored.iter().enumerate().filter(|(_, mirrored)| **mirrored) {
                if traction.place[axis] == 0.0 {
                    traction.normal[axis] = 0.0;
                }
            }
            traction.normal = traction.normal.normalize_or_zero();
        }
        surface
    }

    fn add_node(&mut self, place: DVec3) -> usize {
        self.nodes.push(place);
        self.nodes.len() - 1
    }

    fn add_traction(&mut self, node: usize, surface: usize) -> usize {
        let place = self.nodes[node];
        self.tractions.push(TractionNode { node, surface, place, normal: DVec3::ZERO, area: 0.0 });
        self.tractions.len() - 1
    }

    /// The nodes of tractions.
    pub fn traction_nodes(&self) -> &[TractionNode] {
        &self.tractions
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.patches.len()
    }

    /// Whether x = 0 and y = 0 are planes of symmetry.
    pub fn mirrored(&self) -> [bool; 2] {
        self.mirrored
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        3 * self.nodes.len()
    }

    /// Names of the surfaces.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The nodes of tractions of an element, in the order of its shape functions.
    pub fn tractions_of(&self, face: usize) -> impl Iterator<Item = usize> {
        let count = self.patches[face].element.nodes.len();
        self.local[face].into_iter().take(count).map(|local| local.traction)
    }

    /// Whether a node lies on a plane of symmetry and a direction points across it.
    pub(super) fn across_plane(&self, node: usize, direction: DVec3) -> bool {
        (0..2).any(|axis| {
            self.mirrored[axis] && self.nodes[node][axis] == 0.0 && direction[axis].abs() > 0.5
        })
    }

    /// The corners of the box around the surface and its mirror images (m).
    pub(crate) fn corners(&self) -> Vec<DVec3> {
        let corners = self.patches.iter().flat_map(|patch| &patch.corners);
        let [low, high] = corners
            .fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], one| {
                [low.min(*one), high.max(*one)]
            });
        let pick = |bits: usize| {
            let pick = |axis: usize| if bits >> axis & 1 == 1 { high[axis] } else { low[axis] };
            DVec3::new(pick(0), pick(1), pick(2))
        };
        let images = self.images();
        (0..8).flat_map(|bits| images.iter().map(move |image| *image * pick(bits))).collect()
    }

    /// Corners (m) of the parts of an element around each of its nodes, in the order of its shape functions.
    pub fn parts_of(&self, face: usize) -> Vec<[DVec3; 4]> {
        let corners = &self.patches[face].corners;
        let count = corners.len();
        let middle = corners.iter().sum::<DVec3>() / count as f64;
        let half = |one: usize, other: usize| 0.5 * (corners[one] + corners[other % count]);
        (0..count)
            .map(|at| [corners[at], half(at, at + 1), middle, half(at, at + count - 1)])
            .collect()
    }

    /// The images of a point in the planes of symmetry, itself first, as signs along x, y and z.
    pub(super) fn images(&self) -> Vec<DVec3> {
        let signs = |mirrored: bool| if mirrored { vec![1.0, -1.0] } else { vec![1.0] };
        let [along_x, along_y] = self.mirrored.map(signs);
        along_y.iter().flat_map(|y| along_x.iter().map(|x| DVec3::new(*x, *y, 1.0))).collect()
    }
}
