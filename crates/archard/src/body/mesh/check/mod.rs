//! What is wrong with a surface, and where.

use crate::numerics::WRITTEN;

mod problem;
#[cfg(test)]
mod tests;

pub use problem::MeshProblem;

use std::collections::{BTreeMap, HashMap};

use super::measure::{cross, difference, dot, length};
use super::{Corners, Mesh};

/// Largest ratio of length to width that is not worth a warning; the message says it too.
const SLENDER: f64 = 20.0;
/// Largest angle between the corners of a quadrilateral (rad) that is not worth a warning.
const WARPED: f64 = 0.5;

impl Mesh {
    /// What is wrong with the surface, where x = 0 and y = 0 are or are not planes of symmetry.
    pub fn check(&self, mirrored: [bool; 2]) -> Vec<MeshProblem> {
        if let Some(problem) = self.unusable() {
            return vec![problem];
        }
        let planes = self.planes(mirrored);
        let mut problems = self.beyond(&planes);
        problems.extend(self.flat());
        problems.extend(self.duplicates());
        let edges = self.edges(&planes);
        if edges.is_empty() && problems.is_empty() {
            // What encloses nothing that can be told has no inside.
            let pieces = self.pieces(mirrored);
            let volume = self.volume(mirrored);
            let inverted = pieces.is_none() && volume < 0.0;
            problems.extend(inverted.then_some(MeshProblem::Inverted { volume }));
            problems.extend(pieces);
        }
        problems.extend(edges);
        problems.extend(self.unused());
        problems.extend(self.bent());
        problems.extend(self.slender());
        problems
    }

    /// The planes of symmetry, and what counts as on them.
    pub(super) fn planes(&self, mirrored: [bool; 2]) -> Planes {
        Planes { mirrored, tolerance: WRITTEN * self.extent() }
    }

    /// Puts vertices that count as on a plane of symmetry there.
    pub(super) fn put_on_planes(&mut self, mirrored: [bool; 2]) {
        let planes = self.planes(mirrored);
        for axis in (0..2).filter(|&axis| mirrored[axis]) {
            let near = |place: &&mut [f64; 3]| place[axis].abs() <= planes.tolerance;
            self.vertices.iter_mut().filter(near).for_each(|place| place[axis] = 0.0);
        }
    }

    /// Whether an edge lies on a plane of symmetry, where the surface is cut open.
    pub(super) fn is_cut(&self, planes: &Planes, edge: [usize; 2]) -> bool {
        let on =
            |axis: usize| edge.iter().all(|&v| self.vertices[v][axis].abs() <= planes.tolerance);
        (0..2).any(|axis| planes.mirrored[axis] && on(axis))
    }

    /// What makes all else meaningless.
    fn unusable(&self) -> Option<MeshProblem> {
        if self.faces.is_empty() {
            return Some(MeshProblem::Empty);
        }
        let vertices = self.vertices.len();
        for (face, element) in self.faces.iter().enumerate() {
            if let Some(&vertex) = element.corners.as_slice().iter().find(|&&v| v >= vertices) {
                return Some(MeshProblem::NoVertex { face, vertex, vertices });
            }
        }
        let finite = |place: &[f64; 3]| place.iter().all(|value| value.is_finite());
        let count = self.vertices.iter().filter(|place| !finite(place)).count();
        (count > 0).then_some(MeshProblem::Nowhere { count })
    }

    /// The longest side of the box around the vertices (m).
    pub(crate) fn extent(&self) -> f64 {
        let side = |axis: usize| {
            let values = self.vertices.iter().map(|place| place[axis]);
            let (low, high) = values
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                    (low.min(value), high.max(value))
                });
            high - low
        };
        (0..3).map(side).fold(0.0, f64::max)
    }

    /// Vertices beyond the planes of symmetry and elements on them.
    fn beyond(&self, planes: &Planes) -> Vec<MeshProblem> {
        let mut problems = vec![];
        for (place, axis) in ['x', 'y'].into_iter().enumerate().filter(|(i, _)| planes.mirrored[*i])
        {
            let beyond = self.vertices.iter().filter(|vertex| vertex[place] < -planes.tolerance);
            problems.extend(first(beyond.copied()).map(|(count, place)| MeshProblem::Beyond {
                axis,
                count,
                place,
            }));
            let on = (0..self.faces.len()).filter(|&face| {
                let corners = &self.faces[face].corners;
                corners
                    .as_slice()
                    .iter()
                    .all(|&v| self.vertices[v][place].abs() <= planes.tolerance)
            });
            problems.extend(
                first(on.map(|face| self.centre(face)))
                    .map(|(count, place)| MeshProblem::OnPlane { axis, count, place }),
            );
        }
        problems
    }

    fn flat(&self) -> Option<MeshProblem> {
        let flat = (0..self.faces.len()).filter(|&face| {
            let longest = self.longest_edge(face);
            length(self.area_vector(face)) <= 1e-12 * longest * longest
        });
        first(flat.map(|face| self.centre(face)))
            .map(|(count, place)| MeshProblem::Flat { count, place })
    }

    fn duplicates(&self) -> Option<MeshProblem> {
        let mut known: HashMap<Vec<usize>, usize> = HashMap::new();
        let twice = (0..self.faces.len()).filter(|&face| {
            let mut corners = self.faces[face].corners.as_slice().to_vec();
            corners.sort_unstable();
            known.insert(corners, face).is_some()
        });
        let twice: Vec<usize> = twice.collect();
        first(twice.into_iter().map(|face| self.centre(face)))
            .map(|(count, place)| MeshProblem::Duplicate { count, place })
    }

    /// Edges where the surface is open, branches or turns over.
    fn edges(&self, planes: &Planes) -> Vec<MeshProblem> {
        // How many elements pass the edge from its lower to its higher vertex, and the other way.
        let mut edges: BTreeMap<[usize; 2], [usize; 2]> = BTreeMap::new();
        for face in &self.faces {
            for [a, b] in face.corners.edges() {
                edges.entry([a.min(b), a.max(b)]).or_default()[usize::from(a > b)] += 1;
            }
        }
        let such = |wanted: &dyn Fn([usize; 2], [usize; 2]) -> bool| {
            let edges = edges.iter().filter(|(edge, passes)| wanted(**edge, **passes));
            // Of its ends the one that came first: vertices of the file come before those of divided elements.
            first(edges.map(|([vertex, _], _)| self.vertices[*vertex]))
        };
        let open = such(&|edge, [up, down]| up + down == 1 && !self.is_cut(planes, edge));
        let branching = such(&|_, [up, down]| up + down > 2);
        let unlike = such(&|_, [up, down]| up + down == 2 && up != 1);
        [
            open.map(|(edges, place)| MeshProblem::Open { edges, place }),
            branching.map(|(edges, place)| MeshProblem::Branching { edges, place }),
            unlike.map(|(edges, place)| MeshProblem::Unlike { edges, place }),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    fn unused(&self) -> Option<MeshProblem> {
        let mut used = vec![false; self.vertices.len()];
        for face in &self.faces {
            face.corners.as_slice().iter().for_each(|&vertex| used[vertex] = true);
        }
        let unused = used.iter().zip(&self.vertices).filter(|(used, _)| !**used);
        first(unused.map(|(_, place)| *place))
            .map(|(count, place)| MeshProblem::Unused { count, place })
    }

    /// Quadrilaterals that are concave or far from flat.
    fn bent(&self) -> Vec<MeshProblem> {
        let (mut concave, mut warped) = (vec![], vec![]);
        for (face, element) in self.faces.iter().enumerate() {
            let Corners::Quad(corners) = element.corners else { continue };
            let normal = self.area_vector(face);
            let normals = [0, 1, 2, 3].map(|i| {
                let place = |step: usize| self.vertices[corners[(i + step) % 4]];
                cross(difference(place(1), place(0)), difference(place(3), place(0)))
            });
            if normals.iter().any(|corner| dot(*corner, normal) < 0.0) {
                concave.push(self.centre(face));
                continue;
            }
            let angle = [(0, 2), (1, 3)]
                .map(|(a, b)| {
                    length(cross(normals[a], normals[b])).atan2(dot(normals[a], normals[b]))
                })
                .into_iter()
                .fold(0.0, f64::max);
            if angle > WARPED {
                warped.push((angle, self.centre(face)));
            }
        }
        let mut problems = vec![];
        problems.extend(
            first(concave.into_iter()).map(|(count, place)| MeshProblem::Concave { count, place }),
        );
        problems.extend(worst(&warped).map(|(count, angle, place)| MeshProblem::Warped {
            count,
            angle: angle.to_degrees(),
            place,
        }));
        problems
    }

    fn slender(&self) -> Option<MeshProblem> {
        let slender: Vec<_> = (0..self.faces.len())
            .map(|face| (self.slenderness(face), face))
            .filter(|(ratio, _)| *ratio > SLENDER && ratio.is_finite())
            .map(|(ratio, face)| (ratio, self.centre(face)))
            .collect();
        worst(&slender).map(|(count, ratio, place)| MeshProblem::Slender { count, ratio, place })
    }

    /// How much longer than wide an element is: 1 for a square and for an equilateral triangle.
    fn slenderness(&self, face: usize) -> f64 {
        let longest = self.longest_edge(face);
        let ratio = longest * longest / length(self.area_vector(face));
        match self.faces[face].corners {
            Corners::Triangle(_) => ratio * 0.75_f64.sqrt() / 2.0,
            Corners::Quad(_) => ratio,
        }
    }

    fn longest_edge(&self, face: usize) -> f64 {
        let corners = self.faces[face].corners;
        let corners = corners.as_slice();
        let ends = corners.iter().zip(corners.iter().cycle().skip(1));
        ends.map(|(&a, &b)| length(difference(self.vertices[a], self.vertices[b])))
            .fold(0.0, f64::max)
    }
}

/// Planes of symmetry.
pub(super) struct Planes {
    mirrored: [bool; 2],
    /// How close to a plane (m) is on it.
    tolerance: f64,
}

/// How many there are and the first of them, if there are any.
fn first(mut places: impl Iterator<Item = [f64; 3]>) -> Option<(usize, [f64; 3])> {
    let first = places.next()?;
    Some((1 + places.count(), first))
}

/// How many there are and the one of the largest value, if there are any.
fn worst(places: &[(f64, [f64; 3])]) -> Option<(usize, f64, [f64; 3])> {
    let worst = places.iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
    Some((places.len(), worst.0, worst.1))
}
