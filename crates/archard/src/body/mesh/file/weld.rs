//! Triangles without common vertices made a mesh: corners at the same place become one vertex.
//!
//! Programs compute a corner once for each triangle it belongs to, so that its places differ by rounding.

use std::collections::HashMap;

use crate::body::mesh::{Corners, Face, Mesh};
use crate::numerics::SAME;

/// Length of the cells that vertices are looked for in, in that distance: most corners lie within one.
const CELL: f64 = 16.0;

/// Triangles as a file has them, and the names of their surfaces.
#[derive(Default)]
pub(super) struct Triangles {
    surfaces: Vec<String>,
    triangles: Vec<(usize, [[f64; 3]; 3])>,
}

impl Triangles {
    /// The index of a surface of that name, which may be new.
    pub fn surface(&mut self, name: &str) -> usize {
        let name = if name.is_empty() { "surface" } else { name };
        let names = &mut self.surfaces;
        names.iter().position(|known| known == name).unwrap_or_else(|| {
            names.push(name.to_owned());
            names.len() - 1
        })
    }

    /// Adds a triangle of a surface.
    pub fn push(&mut self, surface: usize, corners: [[f64; 3]; 3]) {
        self.triangles.push((surface, corners));
    }

    /// The mesh of them, from numbers that are rounded by that much of themselves.
    pub fn weld(self, rounding: f64) -> Mesh {
        let corners = || self.triangles.iter().flat_map(|(_, corners)| corners);
        let farthest = corners().flatten().fold(0.0, |most: f64, value| most.max(value.abs()));
        let size = (0..3).map(|axis| {
            let ends = |[low, high]: [f64; 2], value: f64| [low.min(value), high.max(value)];
            let values = corners().map(|place| place[axis]);
            let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], ends);
            high - low
        });
        let same = (SAME * size.fold(0.0, f64::max)).max(rounding * farthest);
        let mut known = Known { same, ..Known::default() };
        let mut faces = vec![];
        for (surface, corners) in self.triangles {
            let corners = corners.map(|place| known.vertex(place));
            // A triangle of two places leaves no gap when it is gone.
            let [a, b, c] = corners;
            if a != b && b != c && c != a {
                faces.push(Face { corners: Corners::Triangle(corners), surface });
            }
        }
        Mesh { vertices: known.vertices, faces, surfaces: self.surfaces }
    }
}

/// Vertices, found by the cell they lie in.
#[derive(Default)]
struct Known {
    vertices: Vec<[f64; 3]>,
    cells: HashMap<[i64; 3], Vec<usize>>,
    /// How far (the file's unit) places of one vertex are apart at most.
    same: f64,
}

impl Known {
    /// The vertex at a place, which may be new.
    fn vertex(&mut self, place: [f64; 3]) -> usize {
        let cell = |off: f64| place.map(|value| self.cell(value + off));
        let ([low, high], own) = ([-self.same, self.same].map(cell), cell(0.0));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let near = self.cells.get(&[x, y, z]).into_iter().flatten();
                    if let Some(&found) = near.into_iter().find(|&&one| self.is_at(one, place)) {
                        return found;
                    }
                }
            }
        }
        let vertex = self.vertices.len();
        self.vertices.push(place);
        self.cells.entry(own).or_default().push(vertex);
        vertex
    }

    /// Which cell a coordinate lies in.
    fn cell(&self, value: f64) -> i64 {
        // All in one point: one cell.
        if self.same > 0.0 { (value / (CELL * self.same)).floor() as i64 } else { 0 }
    }

    fn is_at(&self, vertex: usize, place: [f64; 3]) -> bool {
        let pairs = self.vertices[vertex].iter().zip(place);
        pairs.into_iter().all(|(known, value)| (known - value).abs() <= self.same)
    }
}

#[cfg(test)]
mod tests {
    use super::Triangles;

    /// The faces of a tetrahedron of that size at a place, each corner moved by a little, another way for each face.
    fn tetrahedron(size: f64, place: f64, off: f64) -> Triangles {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mut triangles = Triangles::default();
        let surface = triangles.surface("");
        for (face, which) in [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].into_iter().enumerate() {
            let moved = |corner: usize| {
                let away = off * [1.0, -1.0, 0.5, -0.5][face];
                corners[corner].map(|value: f64| size * value + place + away)
            };
            triangles.push(surface, which.map(moved));
        }
        triangles
    }

    #[test]
    fn corners_that_differ_by_rounding_are_one_vertex() {
        for (size, place, off) in [
            (1.0, 0.0, 0.0),
            (10.0, 0.0, 1e-15),
            (1e-3, 0.0, 4e-13),
            (1e3, -1e5, 1e-11),
            (0.1, 0.3, 4e-11),
        ] {
            let mesh = tetrahedron(size, place, off).weld(f64::EPSILON);
            assert_eq!((mesh.vertices.len(), mesh.faces.len()), (4, 4), "{size}, {place}, {off}");
        }
    }

    /// Corners farther apart are others, in numbers of single precision only where these tell them apart.
    #[test]
    fn what_is_apart_stays_apart() {
        let vertices = |off, rounding| tetrahedron(1.0, 0.0, off).weld(rounding).vertices.len();
        assert_eq!(vertices(4e-8, f64::EPSILON), 12);
        assert_eq!(vertices(4e-8, f64::from(f32::EPSILON)), 4);
        assert_eq!(vertices(4e-7, f64::from(f32::EPSILON)), 12);
    }

    #[test]
    fn triangles_of_one_place_are_gone() {
        let mut triangles = Triangles::default();
        triangles.push(0, [[0.0; 3]; 3]);
        assert!(triangles.weld(f64::EPSILON).faces.is_empty());
    }
}
