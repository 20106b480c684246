//! The shells of a surface: elements that hang together by edges, and which side of each is the outside.
//!
//! Neighbours at an edge run along it in opposite directions where they are seen from the same side. A closed shell
//! then has the sign of the volume it encloses. A shell within an odd number of others is a cavity and faces inwards.
//! Whether a point lies within a shell follows from the solid angle of the shell there, which is 4 pi or nothing.

use std::collections::HashMap;

use glam::DVec3;

use super::{Corners, Mesh, MeshProblem};
use crate::numerics::triangle::solid_angle;

/// Shells beyond which nothing is oriented and no cavity is sought: a heap of triangles, not a body.
const MOST: usize = 1000;

/// Elements that hang together.
struct Shell {
    /// Its elements.
    faces: Vec<usize>,
    /// How many others it lies within.
    depth: usize,
}

impl Mesh {
    /// Turns elements so that neighbours agree and shells face the outside of the body, where every shell is closed but
    /// for the planes of symmetry. Any other surface stays as it is.
    pub(super) fn orient(&mut self, mirrored: [bool; 2]) {
        let Some((shells, turned)) = self.agreed() else { return };
        if shells.len() > MOST || !self.is_closed(mirrored) || self.crossing(&shells).is_some() {
            return;
        }
        let before = self.clone();
        for (face, _) in turned.iter().enumerate().filter(|(_, turned)| **turned) {
            self.faces[face].corners.reverse();
        }
        for shell in self.nested(shells, mirrored) {
            let outward = if shell.depth % 2 == 0 { 1.0 } else { -1.0 };
            let volume = self.volume_under(shell.faces.iter().copied(), mirrored);
            if volume == 0.0 {
                *self = before;
                return;
            }
            if outward * volume < 0.0 {
                shell.faces.iter().for_each(|&face| self.faces[face].corners.reverse());
            }
        }
    }

    /// Shells that are no cavities of one body.
    pub(super) fn pieces(&self, mirrored: [bool; 2]) -> Option<MeshProblem> {
        let (shells, _) = self.agreed()?;
        let problem = |shells: &[Vec<usize>]| {
            let second = self.centre(*shells.get(1)?.first()?);
            Some(MeshProblem::Pieces { pieces: shells.len(), place: second })
        };
        if shells.len() > MOST {
            return problem(&shells);
        }
        if let Some(place) = self.crossing(&shells) {
            return Some(MeshProblem::Crossing { place });
        }
        let nested = self.nested(shells, mirrored).into_iter();
        let bodies = nested.filter(|shell| shell.depth % 2 == 0).map(|shell| shell.faces);
        problem(&bodies.collect::<Vec<_>>())
    }

    /// The elements at every edge, with whether they run from its lower vertex to the higher.
    pub(super) fn faces_at_edges(&self) -> HashMap<[usize; 2], Vec<(usize, bool)>> {
        let mut edges: HashMap<[usize; 2], Vec<(usize, bool)>> = HashMap::new();
        for (face, element) in self.faces.iter().enumerate() {
            for [a, b] in element.corners.edges() {
                edges.entry([a.min(b), a.max(b)]).or_default().push((face, a < b));
            }
        }
        edges
    }

    /// Shells and which elements have to be turned for neighbours to agree; `None` where they cannot.
    fn agreed(&self) -> Option<(Vec<Vec<usize>>, Vec<bool>)> {
        let mut beside: Vec<Vec<(usize, bool)>> = vec![vec![]; self.faces.len()];
        for faces in self.faces_at_edges().into_values() {
            if let [(one, up), (other, also_up)] = faces[..] {
                beside[one].push((other, up == also_up));
                beside[other].push((one, up == also_up));
            }
        }
        let mut turned: Vec<Option<bool>> = vec![None; self.faces.len()];
        let mut shells = vec![];
        for first in 0..self.faces.len() {
            if turned[first].is_some() {
                continue;
            }
            turned[first] = Some(false);
            let mut shell = vec![first];
            let mut next = 0;
            while let Some(&face) = shell.get(next) {
                next += 1;
                for &(other, unlike) in &beside[face] {
                    let wanted = turned[face].map(|turned| turned != unlike);
                    match turned[other] {
                        None => {
                            turned[other] = wanted;
                            shell.push(other);
                        }
                        known if known != wanted => return None,
                        _ => {}
                    }
                }
            }
            shell.sort_unstable();
            shells.push(shell);
        }
        Some((shells, turned.into_iter().map(|turned| turned == Some(true)).collect()))
    }

    /// The shells with the number of others around each.
    fn nested(&self, shells: Vec<Vec<usize>>, mirrored: [bool; 2]) -> Vec<Shell> {
        let boxes: Vec<[DVec3; 2]> =
            shells.iter().map(|shell| self.bounds(shell.iter().copied())).collect();
        let images = images(mirrored);
        let depth = |own: usize| {
            let place = DVec3::from(self.centre(shells[own][0]));
            let around = (0..shells.len()).filter(|&other| {
                let [low, high] = boxes[other];
                let near = place.cmpge(low).all() && place.cmple(high).all();
                other != own && near && self.is_within(place, &shells[other], &images)
            });
            around.count()
        };
        let depths: Vec<usize> = (0..shells.len()).map(depth).collect();
        shells.into_iter().zip(depths).map(|(faces, depth)| Shell { faces, depth }).collect()
    }

    /// Whether a place lies within a closed shell and its mirror images.
    fn is_within(&self, place: DVec3, shell: &[usize], images: &[DVec3]) -> bool {
        let angle = |&face: &usize| -> f64 {
            let corners = self.faces[face].corners.as_slice();
            let seen = |image: DVec3, corner: usize| {
                image * DVec3::from(self.vertices[corners[corner]]) - place
            };
            let of = |image: &DVec3| -> f64 {
                let turned = image.x * image.y;
                let folded = (2..corners.len()).map(|last| {
                    solid_angle([0, last - 1, last].map(|corner| seen(*image, corner)))
                });
                turned * folded.sum::<f64>()
            };
            images.iter().map(of).sum()
        };
        let all: f64 = shell.iter().map(angle).sum();
        all.abs() > 2.0 * std::f64::consts::PI
    }

    /// Whether every edge belongs to two elements, or to one on a plane of symmetry.
    fn is_closed(&self, mirrored: [bool; 2]) -> bool {
        let planes = self.planes(mirrored);
        let edges = self.faces_at_edges();
        edges.iter().all(|(edge, faces)| match faces.len() {
            1 => self.is_cut(&planes, *edge),
            count => count == 2,
        })
    }
}

impl Corners {
    /// Turns the element over.
    fn reverse(&mut self) {
        match self {
            Corners::Triangle(corners) => corners.swap(1, 2),
            Corners::Quad(corners) => corners.swap(1, 3),
        }
    }

    /// The ends of its edges, in order.
    pub(super) fn edges(&self) -> impl Iterator<Item = [usize; 2]> {
        let corners = self.as_slice();
        corners.iter().zip(corners.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
    }
}

/// The images of a place, itself first, as signs along x, y and z.
fn images(mirrored: [bool; 2]) -> Vec<DVec3> {
    let signs = |mirrored: bool| if mirrored { &[1.0, -1.0][..] } else { &[1.0] };
    let [along_x, along_y] = mirrored.map(signs);
    along_x.iter().flat_map(|x| along_y.iter().map(|y| DVec3::new(*x, *y, 1.0))).collect()
}
