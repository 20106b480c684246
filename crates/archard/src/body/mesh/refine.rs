//! Triangles divided where they have to be small, without gaps.
//!
//! A triangle is divided across its longest edge, and so is every neighbour whose edge that divides (M. C. Rivara,
//! *International Journal for Numerical Methods in Engineering* 20, 1984): angles stay above half of the smallest, and
//! every edge belongs to as many elements as before. New vertices lie on the smooth surface that the mesh stands for.

use std::collections::HashMap;

use glam::DVec3;

use super::smooth::{Turns, rise};
use super::{Corners, Face, MOST_OF_A_FILE, Mesh};

/// Normals whose cosine is more than this are those of one smooth surface.
const SAME: f64 = 0.999;

/// A mesh while elements are divided.
pub(super) struct Refined {
    mesh: Mesh,
    mirrored: [bool; 2],
    /// Normals at the corners of every element.
    normals: Vec<[DVec3; 4]>,
    /// The element of the first mesh that each is a part of.
    origin: Vec<usize>,
}

impl Refined {
    /// A mesh with nothing divided yet.
    pub fn new(mesh: Mesh, feature_angle: f64, mirrored: [bool; 2]) -> Self {
        let normals = Turns::of(&mesh).normals(feature_angle, mirrored);
        let origin = (0..mesh.faces.len()).collect();
        Self { mesh, mirrored, normals, origin }
    }

    /// The mesh, with the element of the first mesh that each element is a part of.
    pub fn finish(self) -> (Mesh, Vec<usize>) {
        (self.mesh, self.origin)
    }

    /// Divides elements until none of those that are meant has an edge longer than that (m); `false` where that takes
    /// more elements than anyone can compute with. `meant` is given the mesh, an element and where it comes from.
    pub fn until(&mut self, longest: f64, meant: impl Fn(&Mesh, usize, usize) -> bool) -> bool {
        loop {
            let too_long = |&face: &usize| {
                let length = self.length(self.longest(face));
                length > longest && meant(&self.mesh, face, self.origin[face])
            };
            let wanted: Vec<usize> = (0..self.mesh.faces.len()).filter(too_long).collect();
            if wanted.is_empty() {
                return true;
            }
            if self.mesh.faces.len() + wanted.len() > MOST_OF_A_FILE {
                return false;
            }
            self.divide(wanted);
        }
    }

    fn length(&self, [a, b]: [usize; 2]) -> f64 {
        self.place(a).distance(self.place(b))
    }

    fn place(&self, vertex: usize) -> DVec3 {
        self.mesh.vertices[vertex].into()
    }

    /// The ends of the longest edge of an element, the same for neighbours with two of one length.
    fn longest(&self, face: usize) -> [usize; 2] {
        let edges = self.mesh.faces[face].corners.edges().map(|[a, b]| [a.min(b), a.max(b)]);
        let longer = |one: &[usize; 2], other: &[usize; 2]| {
            self.length(*one).total_cmp(&self.length(*other)).then(one.cmp(other))
        };
        edges.max_by(longer).unwrap_or_default()
    }

    /// Divides elements across their longest edges, and whatever has to be divided with them.
    fn divide(&mut self, wanted: Vec<usize>) {
        let mut halved: HashMap<[usize; 2], Option<usize>> = HashMap::new();
        for face in wanted {
            self.fold(face);
            halved.insert(self.longest(face), None);
        }
        let at_edges = |edges: &HashMap<[usize; 2], Option<usize>>, face: &Face| {
            face.corners.edges().any(|[a, b]| edges.contains_key(&[a.min(b), a.max(b)]))
        };
        // Every element with a halved edge is halved across its longest one first.
        loop {
            let before = (halved.len(), self.mesh.faces.len());
            for face in 0..self.mesh.faces.len() {
                if at_edges(&halved, &self.mesh.faces[face]) {
                    self.fold(face);
                    if at_edges(&halved, &self.mesh.faces[face]) {
                        halved.insert(self.longest(face), None);
                    }
                }
            }
            if before == (halved.len(), self.mesh.faces.len()) {
                break;
            }
        }
        self.add_vertices(&mut halved);
        for face in 0..self.mesh.faces.len() {
            self.split(face, &halved);
        }
    }

    /// Makes two triangles of a quadrilateral, along its shorter diagonal.
    fn fold(&mut self, face: usize) {
        let Face { corners: Corners::Quad(corners), surface } = self.mesh.faces[face] else {
            return;
        };
        let first = usize::from(
            self.length([corners[1], corners[3]]) < self.length([corners[0], corners[2]]),
        );
        let normals = self.normals[face];
        let halves = [[0, 1, 2], [0, 2, 3]].map(|half| half.map(|at| (first + at) % 4));
        for (index, half) in halves.into_iter().enumerate() {
            let corners = Corners::Triangle(half.map(|at| corners[at]));
            let [a, b, c] = half.map(|at| normals[at]);
            self.put((index == 0).then_some(face), face, Face { corners, surface }, [a, b, c]);
        }
    }

    /// Puts a part of an element in its place or at the end.
    fn put(&mut self, place: Option<usize>, of: usize, face: Face, [a, b, c]: [DVec3; 3]) {
        let normals = [a, b, c, DVec3::ZERO];
        match place {
            Some(place) => (self.mesh.faces[place], self.normals[place]) = (face, normals),
            None => {
                self.mesh.faces.push(face);
                self.normals.push(normals);
                self.origin.push(self.origin[of]);
            }
        }
    }

    /// A vertex in the middle of every halved edge, on the smooth surfaces that meet there.
    fn add_vertices(&mut self, halved: &mut HashMap<[usize; 2], Option<usize>>) {
        let mut sides: HashMap<[usize; 2], Vec<[DVec3; 2]>> = HashMap::new();
        for (face, normals) in self.mesh.faces.iter().zip(&self.normals) {
            let corners = face.corners.as_slice();
            for (at, &a) in corners.iter().enumerate() {
                let next = (at + 1) % corners.len();
                let b = corners[next];
                let key = [a.min(b), a.max(b)];
                if halved.contains_key(&key) {
                    let ends = if a < b { [at, next] } else { [next, at] };
                    sides.entry(key).or_default().push(ends.map(|end| normals[end]));
                }
            }
        }
        let mut edges: Vec<[usize; 2]> = halved.keys().copied().collect();
        edges.sort_unstable();
        for edge in edges {
            let ends = edge.map(|vertex| self.place(vertex));
            let mut middle = 0.5 * (ends[0] + ends[1]);
            let rises: Vec<[DVec3; 2]> = sides[&edge]
                .iter()
                .map(|normals| {
                    [rise(ends, *normals), (normals[0] + normals[1]).normalize_or_zero()]
                })
                .collect();
            middle += together(&rises);
            for axis in (0..2).filter(|&axis| self.mirrored[axis]) {
                // On a plane of symmetry vertices stay on it.
                if edge.iter().all(|&vertex| self.mesh.vertices[vertex][axis] == 0.0) {
                    middle[axis] = 0.0;
                }
            }
            self.mesh.vertices.push(middle.to_array());
            halved.insert(edge, Some(self.mesh.vertices.len() - 1));
        }
    }

    /// Divides a triangle by the vertices on its edges, the one on the longest first.
    fn split(&mut self, face: usize, halved: &HashMap<[usize; 2], Option<usize>>) {
        let Face { corners: Corners::Triangle(corners), surface } = self.mesh.faces[face] else {
            return;
        };
        let middle = |[a, b]: [usize; 2]| halved.get(&[a.min(b), a.max(b)]).copied().flatten();
        let [low, high] = self.longest(face);
        let Some(top) = middle([low, high]) else { return };
        let first = (0..3).find(|&at| {
            let (a, b) = (corners[at], corners[(at + 1) % 3]);
            [a.min(b), a.max(b)] == [low, high]
        });
        let order = [0, 1, 2].map(|at| (first.unwrap_or(0) + at) % 3);
        let [a, b, c] = order.map(|at| (corners[at], self.normals[face][at]));
        let between = |(vertex, normal): (usize, DVec3), other: (usize, DVec3)| {
            let middle = middle([vertex, other.0])?;
            Some((middle, (normal + other.1).normalize_or_zero()))
        };
        let m = (top, (a.1 + b.1).normalize_or_zero());
        let mut parts = vec![];
        match between(b, c) {
            None => parts.push([m, b, c]),
            Some(p) => parts.extend([[m, b, p], [m, p, c]]),
        }
        match between(c, a) {
            None => parts.push([a, m, c]),
            Some(q) => parts.extend([[a, m, q], [q, m, c]]),
        }
        for (index, part) in parts.into_iter().enumerate() {
            let corners = Corners::Triangle(part.map(|(vertex, _)| vertex));
            let normals = part.map(|(_, normal)| normal);
            self.put((index == 0).then_some(face), face, Face { corners, surface }, normals);
        }
    }
}

/// What moves a place by the rises of all surfaces that meet there: of two that meet in an edge, each along its normal.
fn together(rises: &[[DVec3; 2]]) -> DVec3 {
    match *rises {
        [[one, n], [other, m]] if n.dot(m).abs() < SAME => {
            let (cosine, [up, out]) = (n.dot(m), [one.dot(n), other.dot(m)]);
            let share = 1.0 - cosine * cosine;
            ((up - cosine * out) * n + (out - cosine * up) * m) / share
        }
        _ => rises.iter().map(|[rise, _]| *rise).sum::<DVec3>() / rises.len().max(1) as f64,
    }
}
