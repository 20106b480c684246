//! How displacements bend between the nodes of an element, from the nodes around it.
//!
//! Bilinear displacements on a plane surface leave out u'' (x^2 - x_node^2) / 2. Its integral along the surface with
//! the part of Kelvin's tractions that couples directions, (1 - 2 nu)(e_i n_j - e_j n_i) / r^2, is odd on every
//! element: under a smooth pressure, tangential displacements alternate from node to node by some
//! u'' h^2 / (2 pi^2) (1 - 2 nu) / (2 - 2 nu), h long the element. With second derivatives from a quadratic
//! polynomial through the nodes of the element and of those next to it in its plane, this is of the next order, on
//! parallelograms and what is nearly one.

use std::collections::HashMap;

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use glam::{DVec2, DVec3};

use super::element::CURVATURES;
use super::surface::Surface;
use crate::numerics::WRITTEN;

/// What a node's displacement counts for in the second derivatives of an element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Share {
    pub node: usize,
    /// The image of the node: signs of its displacement along x, y and z.
    pub image: DVec3,
    /// Second derivatives along s and t.
    pub curvatures: [f64; CURVATURES],
}

/// The shares of all nodes around, by element; none where an element bears no curvatures.
pub(super) fn curvatures(surface: &Surface) -> Vec<Vec<Share>> {
    let mut sides: HashMap<[usize; 2], Vec<usize>> = HashMap::new();
    for (face, corners) in surface.corners.iter().enumerate() {
        for side in sides_of(corners.as_slice()) {
            sides.entry(side).or_default().push(face);
        }
    }
    (0..surface.patches.len()).map(|face| Around::new(surface, &sides, face).shares()).collect()
}

/// Vertices at the ends of the sides of a face, the smaller first.
fn sides_of(corners: &[usize]) -> impl Iterator<Item = [usize; 2]> {
    (0..corners.len()).map(|at| {
        let (one, other) = (corners[at], corners[(at + 1) % corners.len()]);
        [one.min(other), one.max(other)]
    })
}

/// An element and the nodes around it, in its reference coordinates.
struct Around {
    nodes: Vec<(usize, DVec3, DVec2)>,
    /// Whether there are others next to it along s and along t.
    along: [bool; CURVATURES],
}

impl Around {
    fn new(surface: &Surface, sides: &HashMap<[usize; 2], Vec<usize>>, face: usize) -> Self {
        let mut around = Self { nodes: vec![], along: [false; CURVATURES] };
        if surface.patches[face].element.curvature.is_none()
            || !around.add(surface, face, face, DVec3::ONE)
        {
            return around;
        }
        for (at, side) in sides_of(surface.corners[face].as_slice()).enumerate() {
            // The sides of a quadrilateral run along s, t, s and t.
            let across = 1 - at % 2;
            let others = sides.get(&side).into_iter().flatten().filter(|&&other| other != face);
            for &other in others {
                around.along[across] |= around.add(surface, face, other, DVec3::ONE);
            }
            let ends = [at, at + 1].map(|at| surface.patches[face].corners[at % 4]);
            for axis in 0..2 {
                let reach = WRITTEN * surface.patches[face].radius;
                if surface.mirrored[axis] && ends.iter().all(|end| end[axis].abs() <= reach) {
                    let mut image = DVec3::ONE;
                    image[axis] = -1.0;
                    around.along[across] |= around.add(surface, face, face, image);
                }
            }
        }
        around
    }

    /// Adds the nodes of an image of an element if that lies in the plane of the face and bears curvatures, too.
    fn add(&mut self, surface: &Surface, face: usize, other: usize, image: DVec3) -> bool {
        let (patch, beside) = (&surface.patches[face], &surface.patches[other]);
        let middle = patch.middle();
        let normal = patch.normal(patch.middle_reference());
        let lies_in = |place: &DVec3| {
            (image * *place - middle).dot(normal).abs() <= WRITTEN * (patch.radius + beside.radius)
        };
        let alike = normal.dot(image * beside.normal(beside.middle_reference())) > 0.0;
        if beside.element.curvature.is_none() || !alike || !beside.corners.iter().all(lies_in) {
            return false;
        }
        let [s, t] = patch.tangents(patch.middle_reference());
        let (ss, st, tt) = (s.dot(s), s.dot(t), t.dot(t));
        let determinant = ss * tt - st * st;
        for local in &surface.local[other][..beside.element.nodes.len()] {
            let away = image * surface.nodes[local.node] - middle;
            let (along_s, along_t) = (away.dot(s), away.dot(t));
            let at = DVec2::new(tt * along_s - st * along_t, ss * along_t - st * along_s);
            self.nodes.push((local.node, image, at / determinant));
        }
        true
    }

    /// The least squares of a polynomial 1, s, t, s t, and s^2 and t^2 where there are nodes along them.
    fn shares(&self) -> Vec<Share> {
        let squares: Vec<usize> = (0..CURVATURES).filter(|&along| self.along[along]).collect();
        if squares.is_empty() {
            return vec![];
        }
        let count = self.nodes.len();
        let polynomial = |at: DVec2, term: usize| match term {
            0 => 1.0,
            1 => at.x,
            2 => at.y,
            3 => at.x * at.y,
            _ => 0.5 * at[squares[term - 4]].powi(2),
        };
        let terms =
            Mat::from_fn(count, 4 + squares.len(), |row, term| polynomial(self.nodes[row].2, term));
        let fit = terms.qr().solve_lstsq(Mat::<f64>::identity(count, count));
        let share = |(index, &(node, image, _)): (usize, &(usize, DVec3, DVec2))| {
            let mut curvatures = [0.0; CURVATURES];
            for (term, &along) in squares.iter().enumerate() {
                curvatures[along] = fit[(4 + term, index)];
            }
            Share { node, image, curvatures }
        };
        self.nodes.iter().enumerate().map(share).collect()
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::super::surface::Surface;
    use super::super::tests::cube;
    use super::{Share, curvatures};
    use crate::body::Interpolation;

    /// A quadratic displacement that planes of symmetry mirror.
    fn quadratic(place: DVec3) -> DVec3 {
        let DVec3 { x, y, z } = place;
        DVec3::new(x * z, y * z, 3.0 * x * x - y * y + 2.0 * z * z)
    }

    /// Second derivatives of it along a vector.
    fn bend(along: DVec3) -> DVec3 {
        let twice = |a: DMat3| along.dot(a * along);
        let symmetric = |xx, yy, zz, xy, xz, yz| {
            DMat3::from_cols(DVec3::new(xx, xy, xz), DVec3::new(xy, yy, yz), DVec3::new(xz, yz, zz))
        };
        DVec3::new(
            twice(symmetric(0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
            twice(symmetric(0.0, 0.0, 0.0, 0.0, 0.0, 1.0)),
            twice(symmetric(6.0, -2.0, 4.0, 0.0, 0.0, 0.0)),
        )
    }

    /// What shares make of that displacement along s and t.
    fn found(surface: &Surface, shares: &[Share]) -> [DVec3; 2] {
        [0, 1].map(|along| {
            let part = |share: &Share| {
                share.curvatures[along] * share.image * quadratic(surface.nodes[share.node])
            };
            shares.iter().map(part).sum()
        })
    }

    #[test]
    fn quadratic_displacements_bend_as_they_do() {
        // Parallelograms of different sizes.
        let moved = |p: DVec3| {
            let p = p * (DVec3::ONE + DVec3::new(1.0, 0.2, 0.7) * p);
            DVec3::new(p.x + 0.3 * p.y + 0.2 * p.z, p.y - 0.2 * p.z, 1.5 * p.z)
        };
        let surface =
            Surface::new(&cube(3, false, moved), Interpolation::Discontinuous, [false; 2]);
        let mut checked = 0;
        for (face, shares) in curvatures(&surface).iter().enumerate() {
            let patch = &surface.patches[face];
            let tangents = patch.tangents(patch.middle_reference());
            for (found, tangent) in found(&surface, shares).into_iter().zip(tangents) {
                assert!(found.distance(bend(tangent)) < 1e-10, "{face} {found}");
                checked += 1;
            }
        }
        assert_eq!(checked, 2 * 6 * 9);
    }

    #[test]
    fn single_elements_and_other_planes_do_not_count() {
        let bows_of = |divisions, triangles, interpolation| {
            let mesh = cube(divisions, triangles, |place| place);
            curvatures(&Surface::new(&mesh, interpolation, [false; 2]))
        };
        let (continuous, discontinuous) = (Interpolation::Continuous, Interpolation::Discontinuous);
        assert!(bows_of(1, false, discontinuous).iter().all(Vec::is_empty));
        assert!(bows_of(2, false, discontinuous).iter().all(|shares| shares.len() == 12));
        for (triangles, interpolation) in
            [(false, continuous), (true, continuous), (true, discontinuous)]
        {
            assert!(bows_of(2, triangles, interpolation).iter().all(Vec::is_empty));
        }
    }

    /// Beside a plane of symmetry an element has its own image.
    #[test]
    fn images_bend_with_the_elements() {
        let mut mesh = cube(1, false, |place| place);
        // Without the sides on the planes of symmetry.
        mesh.faces.retain(|face| ![0, 2].contains(&face.surface));
        let surface = Surface::new(&mesh, Interpolation::Discontinuous, [true; 2]);
        let all = curvatures(&surface);
        for (face, shares) in all.iter().enumerate() {
            let patch = &surface.patches[face];
            let tangents = patch.tangents(patch.middle_reference());
            for (found, tangent) in found(&surface, shares).into_iter().zip(tangents) {
                // Upright sides have nothing above or below them.
                let expected = if tangent.z == 0.0 { bend(tangent) } else { DVec3::ZERO };
                assert!(found.distance(expected) < 1e-10, "{face} {found}");
            }
        }
    }
}
