//! The smooth faces of a surface of plane elements, and how it curves within them.
//!
//! A smooth face ends at edges where elements turn by more than the feature angle. Within it each corner has the
//! normal of the sphere through it and its neighbours (N. Max, *Journal of Graphics Tools* 4, 1999). Neighbours of
//! very different widths do not share a normal: there a plane goes over into a rounding, and the plane stays plane.
//! Between two corners the surface is the arc whose tangents are at right angles to their normals.

use std::collections::HashMap;

use glam::DVec3;

use super::Mesh;

/// Elements that turn by less (rad) lie in one plane.
const PLANE: f64 = 1e-3;
/// Ratio of widths beyond which neighbours that do not lie in one plane share no normal.
const UNLIKE: f64 = 3.0;

/// Edges of a surface between two elements.
pub(super) struct Turns<'a> {
    mesh: &'a Mesh,
    /// Ends, elements and the angle (rad) by which these turn.
    edges: Vec<([usize; 2], [usize; 2], f64)>,
}

impl<'a> Turns<'a> {
    /// Those of a mesh, in the order of their vertices.
    pub fn of(mesh: &'a Mesh) -> Self {
        let normals: Vec<DVec3> =
            (0..mesh.faces.len()).map(|face| DVec3::from(mesh.area_vector(face))).collect();
        let mut edges: Vec<_> = mesh
            .faces_at_edges()
            .into_iter()
            .filter_map(|(edge, faces)| match faces[..] {
                [(one, up), (other, also_up)] => {
                    // Elements that are seen from different sides turn as they would seen from the same one.
                    let sign = if up == also_up { -1.0 } else { 1.0 };
                    let (n, m) = (normals[one], sign * normals[other]);
                    let angle = n.cross(m).length().atan2(n.dot(m));
                    Some((edge, [one, other], angle))
                }
                _ => None,
            })
            .collect();
        edges.sort_unstable_by_key(|(edge, ..)| *edge);
        Self { mesh, edges }
    }

    /// The smooth face that each element belongs to, numbered by their first elements.
    pub fn faces(&self, feature_angle: f64) -> Vec<usize> {
        self.groups(|(_, [one, other], angle)| {
            let surfaces = [*one, *other].map(|face| self.mesh.faces[face].surface);
            surfaces[0] == surfaces[1] && *angle <= feature_angle
        })
    }

    /// The number of the group of each element, of those that hang together by such edges.
    fn groups(&self, joined: impl Fn(&([usize; 2], [usize; 2], f64)) -> bool) -> Vec<usize> {
        let mut groups = Groups::new(self.mesh.faces.len());
        for edge in self.edges.iter().filter(|edge| joined(edge)) {
            groups.join(edge.1[0], edge.1[1]);
        }
        let mut numbers = HashMap::new();
        (0..self.mesh.faces.len())
            .map(|face| {
                let next = numbers.len();
                *numbers.entry(groups.first(face)).or_insert(next)
            })
            .collect()
    }

    /// Unit normals at the corners of every element.
    pub fn normals(&self, feature_angle: f64, mirrored: [bool; 2]) -> Vec<[DVec3; 4]> {
        let planes = self.groups(|(_, _, angle)| *angle <= PLANE);
        let mut vertices: Vec<Vec<usize>> =
            vec![vec![]; planes.iter().max().map_or(0, |most| most + 1)];
        for (face, plane) in planes.iter().enumerate() {
            vertices[*plane].extend(self.mesh.faces[face].corners.as_slice());
        }
        let place = |vertex: usize| DVec3::from(self.mesh.vertices[vertex]);
        let width = |plane: usize, [a, b]: [usize; 2]| {
            let along = (place(b) - place(a)).normalize_or_zero();
            let away = |&vertex: &usize| (place(vertex) - place(a)).cross(along).length();
            vertices[plane].iter().map(away).fold(0.0, f64::max)
        };
        let mut corners = Groups::new(4 * self.mesh.faces.len());
        for (edge, [one, other], angle) in &self.edges {
            let [own, beside] = [*one, *other].map(|face| planes[face]);
            let alike = || {
                let [own, beside] = [own, beside].map(|plane| width(plane, *edge));
                own.max(beside) <= UNLIKE * own.min(beside)
            };
            if own == beside || (*angle <= feature_angle && alike()) {
                for vertex in edge {
                    corners.join(self.corner(*one, *vertex), self.corner(*other, *vertex));
                }
            }
        }
        let mut sums = vec![DVec3::ZERO; 4 * self.mesh.faces.len()];
        for (face, element) in self.mesh.faces.iter().enumerate() {
            let around = element.corners.as_slice();
            let count = around.len();
            for (corner, &vertex) in around.iter().enumerate() {
                let next = place(around[(corner + 1) % count]) - place(vertex);
                let last = place(around[(corner + count - 1) % count]) - place(vertex);
                let weight = next.length_squared() * last.length_squared();
                sums[corners.first(4 * face + corner)] += next.cross(last) / weight;
            }
        }
        let steep = (0.5 * feature_angle).sin();
        let normal = |face: usize, corner: usize| {
            let Some(&vertex) = self.mesh.faces[face].corners.as_slice().get(corner) else {
                return DVec3::ZERO;
            };
            let mut normal = sums[corners.first(4 * face + corner)].normalize_or_zero();
            // The image of a smooth face goes on in it.
            for (axis, _) in mirrored.iter().enumerate().filter(|(_, mirrored)| **mirrored) {
                let on = self.mesh.vertices[vertex][axis] == 0.0;
                if on && normal[axis].abs() <= steep {
                    normal[axis] = 0.0;
                }
            }
            normal.normalize_or_zero()
        };
        (0..self.mesh.faces.len()).map(|face| [0, 1, 2, 3].map(|at| normal(face, at))).collect()
    }

    /// The place of a vertex among the corners of all elements.
    fn corner(&self, face: usize, vertex: usize) -> usize {
        let corners = self.mesh.faces[face].corners;
        4 * face + corners.as_slice().iter().position(|&one| one == vertex).unwrap_or(0)
    }
}

/// How far the arc between two places with these normals rises above the middle of its chord.
pub(super) fn rise([a, b]: [DVec3; 2], [at_a, at_b]: [DVec3; 2]) -> DVec3 {
    let chord = b - a;
    let length = chord.length();
    let [one, other] = [-at_a.dot(chord), at_b.dot(chord)].map(|sine| (sine / length).asin());
    // An arc turns the same way at both ends; where it does not, the chord is as good.
    let bends = one * other > 0.0;
    if !bends {
        return DVec3::ZERO;
    }
    let angle = 2.0 * one * other / (one + other);
    let sum = at_a + at_b;
    let across = (sum - sum.dot(chord) / (length * length) * chord).normalize_or_zero();
    0.5 * length * (0.5 * angle).tan() * across
}

/// Things that belong together.
struct Groups(Vec<usize>);

impl Groups {
    fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    fn first(&self, mut one: usize) -> usize {
        while self.0[one] != one {
            one = self.0[one];
        }
        one
    }

    fn join(&mut self, one: usize, other: usize) {
        let (one, other) = (self.flat(one), self.flat(other));
        let (low, high) = (one.min(other), one.max(other));
        self.0[high] = low;
    }

    /// The first of its group, known at once afterwards.
    fn flat(&mut self, one: usize) -> usize {
        let first = self.first(one);
        let mut next = one;
        while self.0[next] != first {
            next = std::mem::replace(&mut self.0[next], first);
        }
        first
    }
}
