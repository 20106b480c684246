//! What is wrong with a surface, and where.

use std::collections::{BTreeMap, HashMap};

use super::measure::{cross, difference, dot, length};
use super::{Corners, Mesh};

/// Largest ratio of length to width that is not worth a warning.
const SLENDER: f64 = 20.0;
/// Largest angle between the corners of a quadrilateral (rad) that is not worth a warning.
const WARPED: f64 = 0.5;
/// What counts as on a plane, of the body's extent.
const ON_PLANE: f64 = 1e-6;

/// Something wrong with a surface.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshProblem {
    /// An element names a vertex that is not there.
    #[error(
        "element {face} names the vertex {vertex}, there are only {vertices}: write the mesh anew"
    )]
    NoVertex {
        /// The element.
        face: usize,
        /// The vertex it names.
        vertex: usize,
        /// How many there are.
        vertices: usize,
    },
    /// Places that are not numbers.
    #[error("{count} vertices lie nowhere (not a finite number): write the mesh anew")]
    Nowhere {
        /// How many.
        count: usize,
    },
    /// No elements at all.
    #[error("the surface has no elements: mesh it before it is saved")]
    Empty,
    /// Vertices beyond a plane of symmetry.
    #[error(
        "{count} vertices lie at negative {axis}, the first at {}: keep only the half at positive {axis}, or leave out the symmetry",
        at(.place)
    )]
    Beyond {
        /// The axis across the plane.
        axis: char,
        /// How many.
        count: usize,
        /// The first of them (m).
        place: [f64; 3],
    },
    /// Elements on a plane of symmetry, where the surface has to be open.
    #[error(
        "{count} elements lie on the plane of symmetry {axis} = 0, the first at {}: leave the cut open",
        at(.place)
    )]
    OnPlane {
        /// The axis across the plane.
        axis: char,
        /// How many.
        count: usize,
        /// The centre of the first of them (m).
        place: [f64; 3],
    },
    /// Edges of a single element.
    #[error(
        "the surface is open: {edges} edges belong to one element only, the first at {}; mesh what is missing, or merge vertices that lie on one another",
        at(.place)
    )]
    Open {
        /// How many.
        edges: usize,
        /// The middle of the first (m).
        place: [f64; 3],
    },
    /// Edges of more than two elements.
    #[error(
        "{edges} edges belong to more than two elements, the first at {}: remove the walls inside the body",
        at(.place)
    )]
    Branching {
        /// How many.
        edges: usize,
        /// The middle of the first (m).
        place: [f64; 3],
    },
    /// Neighbours of which one is seen from outside and one from inside.
    #[error(
        "neighbours at {edges} edges are seen from different sides, the first at {}: orient all elements counter-clockwise seen from outside",
        at(.place)
    )]
    Unlike {
        /// How many.
        edges: usize,
        /// The middle of the first (m).
        place: [f64; 3],
    },
    /// A surface turned inside out.
    #[error(
        "the surface encloses {volume:.3e} m^3, its inside is out: turn all elements (in Gmsh: Mesh > Reverse)"
    )]
    Inverted {
        /// The volume (m^3).
        volume: f64,
    },
    /// Elements with the same corners.
    #[error("{count} elements are there twice, the first at {}: keep one of each", at(.place))]
    Duplicate {
        /// How many.
        count: usize,
        /// The centre of the first (m).
        place: [f64; 3],
    },
    /// Elements without area.
    #[error("{count} elements have no area, the first at {}: remove or merge them", at(.place))]
    Flat {
        /// How many.
        count: usize,
        /// The centre of the first (m).
        place: [f64; 3],
    },
    /// Vertices of no element.
    #[error("{count} vertices belong to no element, the first at {}: remove them", at(.place))]
    Unused {
        /// How many.
        count: usize,
        /// The first of them (m).
        place: [f64; 3],
    },
    /// Quadrilaterals with a corner that points inwards.
    #[error(
        "{count} quadrilaterals have a corner that points inwards, the first at {}: divide them into triangles",
        at(.place)
    )]
    Concave {
        /// How many.
        count: usize,
        /// The centre of the first (m).
        place: [f64; 3],
    },
    /// Quadrilaterals far from flat.
    #[error(
        "{count} quadrilaterals are far from flat, the worst bent by {angle:.0} degrees at {}: divide them into triangles or refine",
        at(.place)
    )]
    Warped {
        /// How many.
        count: usize,
        /// The largest angle between the normals at their corners (degrees).
        angle: f64,
        /// The centre of the worst (m).
        place: [f64; 3],
    },
    /// Elements much longer than wide.
    #[error(
        "{count} elements are more than {SLENDER} times as long as wide, the worst {ratio:.0} times at {}: refine along the longer side",
        at(.place)
    )]
    Slender {
        /// How many.
        count: usize,
        /// The largest ratio.
        ratio: f64,
        /// The centre of the worst (m).
        place: [f64; 3],
    },
}

impl MeshProblem {
    /// Whether results can be had all the same, if poorer ones.
    pub fn is_warning(&self) -> bool {
        use MeshProblem::{Concave, Slender, Unused, Warped};
        matches!(self, Concave { .. } | Slender { .. } | Unused { .. } | Warped { .. })
    }
}

fn at([x, y, z]: &[f64; 3]) -> String {
    format!("x = {x:.4e} m, y = {y:.4e} m, z = {z:.4e} m")
}

impl Mesh {
    /// What is wrong with the surface, where x = 0 and y = 0 are or are not planes of symmetry.
    pub fn check(&self, mirrored: [bool; 2]) -> Vec<MeshProblem> {
        if let Some(problem) = self.unusable() {
            return vec![problem];
        }
        let planes = Planes { mirrored, tolerance: ON_PLANE * self.extent() };
        let mut problems = self.beyond(&planes);
        problems.extend(self.flat());
        problems.extend(self.duplicates());
        let edges = self.edges(&planes);
        if edges.is_empty() && problems.is_empty() {
            let volume = self.volume(mirrored);
            problems.extend((volume < 0.0).then_some(MeshProblem::Inverted { volume }));
        }
        problems.extend(edges);
        problems.extend(self.unused());
        problems.extend(self.bent());
        problems.extend(self.slender());
        problems
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
    fn extent(&self) -> f64 {
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
            let corners = face.corners.as_slice();
            for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
                edges.entry([a.min(b), a.max(b)]).or_default()[usize::from(a > b)] += 1;
            }
        }
        let middle = |[a, b]: [usize; 2]| {
            let (a, b) = (self.vertices[a], self.vertices[b]);
            [0, 1, 2].map(|axis| 0.5 * (a[axis] + b[axis]))
        };
        let cut = |edge: [usize; 2]| {
            let on = |axis: usize| {
                edge.iter().all(|&v| self.vertices[v][axis].abs() <= planes.tolerance)
            };
            (0..2).any(|axis| planes.mirrored[axis] && on(axis))
        };
        let such = |wanted: &dyn Fn([usize; 2], [usize; 2]) -> bool| {
            first(
                edges
                    .iter()
                    .filter(|(edge, passes)| wanted(**edge, **passes))
                    .map(|(edge, _)| middle(*edge)),
            )
        };
        let open = such(&|edge, [up, down]| up + down == 1 && !cut(edge));
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
struct Planes {
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

#[cfg(test)]
mod tests {
    use super::MeshProblem;
    use crate::body::mesh::builder::Builder;
    use crate::body::mesh::tensor::{SIDES, block};
    use crate::body::mesh::{Corners, Face, Mesh};

    /// A cube of 1 m at positive x, y and z, two elements an edge.
    fn cube(mirrored: [bool; 2]) -> Mesh {
        let mut builder = Builder::new(1.0);
        let axis = &[0.0, 0.5, 1.0][..];
        block(&mut builder, [axis; 3], mirrored, SIDES, |place| place);
        builder.finish()
    }

    fn messages(mesh: &Mesh, mirrored: [bool; 2]) -> Vec<String> {
        mesh.check(mirrored).iter().map(ToString::to_string).collect()
    }

    #[track_caller]
    fn only(mesh: &Mesh, mirrored: [bool; 2], expected: &str) {
        let messages = messages(mesh, mirrored);
        assert!(messages.len() == 1 && messages[0].contains(expected), "{messages:?}");
    }

    #[test]
    fn good_surfaces_have_no_problems() {
        for mirrored in [[false, false], [true, false], [false, true], [true, true]] {
            assert_eq!(messages(&cube(mirrored), mirrored), [""; 0]);
        }
    }

    #[test]
    fn open_and_branching_surfaces_are_found() {
        only(&cube([true, false]), [false, false], "open: 8 edges");
        let mut mesh = cube([false, false]);
        let first = mesh.faces.remove(0);
        only(&mesh, [false, false], "open: 4 edges");
        mesh.faces.push(first);
        let Corners::Quad([a, b, c, d]) = first.corners else { unreachable!() };
        mesh.faces.push(Face { corners: Corners::Quad([d, c, b, a]), ..first });
        let messages = messages(&mesh, [false, false]);
        assert!(messages[0].contains("1 elements are there twice"), "{messages:?}");
        assert!(messages[1].contains("4 edges belong to more than two"), "{messages:?}");
    }

    #[test]
    fn orientation_is_checked() {
        let mut mesh = cube([false, false]);
        let turn = |face: &mut Face| {
            if let Corners::Quad(corners) = &mut face.corners {
                corners.reverse();
            }
        };
        turn(&mut mesh.faces[3]);
        only(&mesh, [false, false], "neighbours at 4 edges");
        turn(&mut mesh.faces[3]);
        mesh.faces.iter_mut().for_each(turn);
        only(&mesh, [false, false], "encloses -1.000e0 m^3");
        let mut mesh = cube([true, true]);
        mesh.faces.iter_mut().for_each(turn);
        only(&mesh, [true, true], "encloses -4.000e0 m^3");
    }

    #[test]
    fn planes_of_symmetry_are_kept_clear() {
        let mut mesh = cube([true, false]);
        mesh.vertices.iter_mut().for_each(|vertex| vertex[0] -= 0.25);
        let found = messages(&mesh, [true, false]);
        assert!(found[0].contains("lie at negative x, the first at x = -2.5000e-1 m"), "{found:?}");
        only(&cube([false, false]), [true, false], "4 elements lie on the plane of symmetry x = 0");
    }

    #[test]
    fn poor_elements_are_warned_of() {
        let mut mesh = cube([false, false]);
        mesh.vertices.iter_mut().for_each(|vertex| vertex[2] *= 40.0);
        only(&mesh, [false, false], "16 elements are more than 20 times");
        assert!(mesh.check([false, false])[0].is_warning());
        let mut mesh = cube([false, false]);
        mesh.vertices.push([3.0; 3]);
        only(&mesh, [false, false], "1 vertices belong to no element");
        let middle = mesh.vertices.iter().position(|place| *place == [0.5, 0.5, 1.0]).unwrap();
        mesh.vertices.pop();
        mesh.vertices[middle] = [0.5, 0.5, 1.4];
        let messages = messages(&mesh, [false, false]);
        assert!(messages.iter().any(|message| message.contains("far from flat")), "{messages:?}");
        mesh.vertices[middle] = [0.1, 0.1, 1.0];
        only(&mesh, [false, false], "1 quadrilaterals have a corner that points inwards");
    }

    #[test]
    fn what_cannot_be_used_is_said_alone() {
        assert_eq!(Mesh::default().check([false; 2]), [MeshProblem::Empty]);
        let mut mesh = cube([false, false]);
        mesh.faces[0].corners = Corners::Triangle([0, 1, 99]);
        only(&mesh, [false; 2], "element 0 names the vertex 99");
        let mut mesh = cube([false, false]);
        mesh.vertices[0][0] = f64::NAN;
        only(&mesh, [false; 2], "1 vertices lie nowhere");
        let mut mesh = cube([false, false]);
        let corner = mesh.vertices[0];
        mesh.vertices.iter_mut().for_each(|vertex| vertex[2] = corner[2]);
        assert!(mesh.check([false; 2]).iter().any(|p| matches!(p, MeshProblem::Flat { .. })));
    }
}
