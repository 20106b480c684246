//! The inside of a body, in tetrahedra of ten nodes.

use std::collections::HashMap;

use glam::DVec3;

use super::tetrahedron::{EDGES, points, turn};
use super::{Corners, Face, Mesh};

/// The sides of a tetrahedron by their corners, counter-clockwise seen from outside.
const SIDES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

/// The inside of a body in tetrahedra of ten nodes, and the triangles of six nodes that are its surface.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Volume {
    /// Places of the nodes (m).
    pub nodes: Vec<[f64; 3]>,
    /// Of each tetrahedron the corners a, b, c and d, (b - a) x (c - a) . (d - a) being positive, and the nodes on its edges in the
    /// order of [`EDGES`](super::tetrahedron::EDGES).
    pub elements: Vec<[usize; 10]>,
    /// Of each triangle of the surface the corners, counter-clockwise seen from outside, and the nodes on the edges behind them.
    pub faces: Vec<[usize; 6]>,
    /// What the file calls the first of the nodes; those behind them are middles of edges that it has no nodes for.
    pub numbers: Vec<u64>,
}

/// A tetrahedron that is turned inside out or has no volume, by the places of its corners.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InvertedElement {
    /// Its number among the tetrahedra, the first being 0.
    pub element: usize,
}

/// The nodes of a tetrahedron of a file: four, or ten in the order of [`EDGES`](super::tetrahedron::EDGES).
#[derive(Debug, Clone, Copy)]
pub(super) enum Tetrahedron {
    Four([usize; 4]),
    Ten([usize; 10]),
}

impl Volume {
    /// Of tetrahedra between places (m). Nodes are put in the middles of edges that have none.
    pub(super) fn new(mut nodes: Vec<[f64; 3]>, tetrahedra: &[Tetrahedron]) -> Self {
        let mut middles: HashMap<[usize; 2], usize> = HashMap::new();
        let elements: Vec<[usize; 10]> = tetrahedra
            .iter()
            .map(|tetrahedron| match *tetrahedron {
                Tetrahedron::Ten(all) => all,
                Tetrahedron::Four(corners) => {
                    let mut all = [0; 10];
                    all[..4].copy_from_slice(&corners);
                    for (place, edge) in EDGES.iter().enumerate() {
                        let [one, other] = edge.map(|end| corners[end]);
                        let key = [one.min(other), one.max(other)];
                        all[4 + place] = *middles.entry(key).or_insert_with(|| {
                            let [a, b] = [nodes[one], nodes[other]].map(DVec3::from);
                            nodes.push((0.5 * (a + b)).to_array());
                            nodes.len() - 1
                        });
                    }
                    all
                }
            })
            .collect();
        let elements: Vec<[usize; 10]> =
            elements.into_iter().map(|element| turned(&nodes, element)).collect();
        let mut sides: HashMap<[usize; 3], Option<[usize; 6]>> = HashMap::new();
        let mut order = vec![];
        for element in &elements {
            for side in SIDES {
                let face = side_of(element, side);
                let key = key([face[0], face[1], face[2]]);
                sides.entry(key).and_modify(|known| *known = None).or_insert_with(|| {
                    order.push(key);
                    Some(face)
                });
            }
        }
        let faces = order.iter().filter_map(|key| sides[key]).collect();
        Self { nodes, elements, faces, numbers: vec![] }
    }

    /// Of tetrahedra by their corners, straight.
    pub fn of_corners(nodes: Vec<[f64; 3]>, corners: &[[usize; 4]]) -> Self {
        let tetrahedra: Vec<Tetrahedron> =
            corners.iter().map(|corners| Tetrahedron::Four(*corners)).collect();
        Self::new(nodes, &tetrahedra)
    }

    /// The surface, corners of triangles only, in the order of the [faces](Self::faces), each of the part of the index that is given for
    /// its corners in rising order.
    pub fn surface(&self, surfaces: Vec<String>, part: impl Fn([usize; 3]) -> usize) -> Mesh {
        let mut vertices = HashMap::new();
        let mut mesh = Mesh { vertices: vec![], faces: vec![], surfaces };
        for face in &self.faces {
            let corners = [face[0], face[1], face[2]];
            let own = corners.map(|node| {
                *vertices.entry(node).or_insert_with(|| {
                    mesh.vertices.push(self.nodes[node]);
                    mesh.vertices.len() - 1
                })
            });
            let corners = Corners::Triangle(own);
            mesh.faces.push(Face { corners, surface: part(key([face[0], face[1], face[2]])) });
        }
        mesh
    }

    /// A tetrahedron that is turned inside out somewhere.
    pub fn inverted(&self) -> Option<InvertedElement> {
        let upright = |element: &[usize; 10]| {
            let places = element.map(|node| DVec3::from(self.nodes[node]));
            points().into_iter().all(|(at, _)| turn(&places, at).determinant() > 0.0)
        };
        let element = self.elements.iter().position(|element| !upright(element))?;
        Some(InvertedElement { element })
    }

    /// The same, moved along z (m), or turned over at z = 0 behind that.
    pub(super) fn placed(mut self, up: f64, over: bool) -> Self {
        for node in &mut self.nodes {
            node[2] += up;
            if over {
                node[2] = -node[2];
            }
        }
        if over {
            let turned = |face: [usize; 6]| [face[0], face[2], face[1], face[5], face[4], face[3]];
            self.faces.iter_mut().for_each(|face| *face = turned(*face));
            let nodes = &self.nodes;
            self.elements.iter_mut().for_each(|element| *element = self::turned(nodes, *element));
        }
        self
    }
}

/// The same corners, whatever their order.
pub(super) fn key(mut corners: [usize; 3]) -> [usize; 3] {
    corners.sort_unstable();
    corners
}

/// The six nodes of a side.
fn side_of(element: &[usize; 10], side: [usize; 3]) -> [usize; 6] {
    let middle = |one: usize, other: usize| {
        let joins = |edge: &[usize; 2]| edge.contains(&one) && edge.contains(&other);
        element[4 + EDGES.iter().position(joins).unwrap_or(0)]
    };
    let [a, b, c] = side;
    [element[a], element[b], element[c], middle(a, b), middle(b, c), middle(c, a)]
}

/// The same nodes, so that the corners make a positive volume.
fn turned(nodes: &[[f64; 3]], element: [usize; 10]) -> [usize; 10] {
    let [a, b, c, d] = [0, 1, 2, 3].map(|corner| DVec3::from(nodes[element[corner]]));
    if (b - a).cross(c - a).dot(d - a) >= 0.0 {
        return element;
    }
    let [a, b, c, d, ab, bc, ca, ad, bd, cd] = element;
    [a, c, b, d, ca, bc, ab, ad, cd, bd]
}
