//! Puts a mesh together from patches that share their edges.

use std::collections::HashMap;

use super::{Corners, Face, Mesh};

/// A mesh in the making: places that are the same to the last bit become one vertex.
#[derive(Debug)]
pub(super) struct Builder {
    mesh: Mesh,
    known: HashMap<[u64; 3], usize>,
    /// Coordinates smaller than this (m) are on a plane of symmetry.
    nothing: f64,
}

impl Builder {
    /// Nothing yet of a body of that extent (m).
    pub fn new(extent: f64) -> Self {
        Self { mesh: Mesh::default(), known: HashMap::new(), nothing: 1e-13 * extent }
    }

    /// The part of the surface of that name, made if it is new.
    pub fn surface(&mut self, name: &str) -> usize {
        let names = &mut self.mesh.surfaces;
        names.iter().position(|known| known == name).unwrap_or_else(|| {
            names.push(name.to_owned());
            names.len() - 1
        })
    }

    /// The vertex at a place (m), made if it is new.
    pub fn vertex(&mut self, place: [f64; 3]) -> usize {
        let place = place.map(|value| if value.abs() < self.nothing { 0.0 } else { value });
        let vertices = &mut self.mesh.vertices;
        *self.known.entry(place.map(f64::to_bits)).or_insert_with(|| {
            vertices.push(place);
            vertices.len() - 1
        })
    }

    /// Adds a quadrilateral, or the triangle it is where two corners are one.
    pub fn quad(&mut self, surface: usize, corners: [usize; 4]) {
        let [a, b, c, d] = corners;
        if a == b || a == c {
            self.triangle(surface, [a, c, d]);
        } else if b == c || c == d {
            self.triangle(surface, [a, b, d]);
        } else if d == a {
            self.triangle(surface, [a, b, c]);
        } else {
            self.mesh.faces.push(Face { corners: Corners::Quad(corners), surface });
        }
    }

    /// Adds a triangle.
    pub fn triangle(&mut self, surface: usize, corners: [usize; 3]) {
        self.mesh.faces.push(Face { corners: Corners::Triangle(corners), surface });
    }

    /// Number of elements so far.
    pub fn faces(&self) -> usize {
        self.mesh.faces.len()
    }

    /// Turns the elements from that one on, so that the other side is outside.
    pub fn turn(&mut self, from: usize) {
        for face in &mut self.mesh.faces[from..] {
            match &mut face.corners {
                Corners::Triangle(corners) => corners.reverse(),
                Corners::Quad(corners) => corners.reverse(),
            }
        }
    }

    /// The mesh.
    pub fn finish(self) -> Mesh {
        self.mesh
    }
}
