//! How large the equations of meshed bodies are, known from their meshes alone.

use std::collections::HashSet;

use crate::body::Interpolation;
use crate::body::mesh::ContactMesh;

/// Numbers of unknowns of a body's equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Size {
    /// Three a node; zero where the body deforms as a half-space.
    pub unknowns: usize,
    /// Three a node of the zone that may touch.
    pub contact: usize,
    /// Whether they are those of finite elements inside the body: most of its equations do not see each other.
    pub sparse: bool,
}

/// Operations and memory (bytes) of finite elements in bodies that are meshed the finer the nearer to a face, as powers of the unknowns
/// through two sizes each. Factors ordered by least degree take 22 Gflop for 44,610 unknowns and 163 for 159,582; peak resident memory
/// of whole runs was 0.42 GB for 42,810 and 1.79 GB for 151,728.
fn sparse(unknowns: usize) -> [f64; 2] {
    let power = |[few, at_few]: [f64; 2], [many, at_many]: [f64; 2]| {
        let exponent = (at_many / at_few).ln() / (many / few).ln();
        at_few * (unknowns as f64 / few).powf(exponent)
    };
    [power([44_610.0, 22e9], [159_582.0, 163e9]), power([42_810.0, 0.42e9], [151_728.0, 1.79e9])]
}

/// Numbers in the factors: .15 GB of them for 44,610 unknowns and .69 GB for 159,582.
fn factors(unknowns: usize) -> f64 {
    let exponent = (0.69_f64 / 0.15).ln() / (159_582.0_f64 / 44_610.0).ln();
    0.15e9 / size_of::<f64>() as f64 * (unknowns as f64 / 44_610.0).powf(exponent)
}

impl Size {
    /// That of finite elements inside a body; `None` where nothing says what is inside.
    pub fn inside(meshed: &ContactMesh) -> Option<Self> {
        let nodes = meshed.volume.as_ref()?.nodes.len();
        Some(Self { unknowns: 3 * nodes, contact: 0, sparse: true })
    }

    /// That of a meshed body.
    pub fn of(ContactMesh { mesh, zone, .. }: &ContactMesh, interpolation: Interpolation) -> Self {
        let zone = zone.faces.iter().map(|&face| &mesh.faces[face]);
        let (nodes, contact) = match interpolation {
            Interpolation::Discontinuous => (
                mesh.faces.iter().map(|face| face.corners.as_slice().len()).sum(),
                zone.map(|face| face.corners.as_slice().len()).sum(),
            ),
            Interpolation::Continuous => {
                let used = mesh.faces.iter().flat_map(|face| face.corners.as_slice());
                let touching = zone.flat_map(|face| {
                    face.corners.as_slice().iter().map(|corner| (*corner, face.surface))
                });
                (used.collect::<HashSet<_>>().len(), touching.collect::<HashSet<_>>().len())
            }
        };
        Self { unknowns: 3 * nodes, contact: 3 * contact, sparse: false }
    }

    /// That of a mesh of so many elements at least: triangles have fewer nodes than quadrilaterals, and with
    /// continuous elements a closed surface of triangles has half as many nodes as elements.
    pub fn at_least(elements: usize, interpolation: Interpolation) -> Self {
        let unknowns = match interpolation {
            Interpolation::Discontinuous => 9 * elements,
            Interpolation::Continuous => 3 * (elements / 2),
        };
        Self { unknowns, contact: 0, sparse: false }
    }

    /// Operations on numbers while the body is condensed: two thirds of the cube of the unknowns for the factors, and for
    /// each column of the zone all rows forward and those of the zone back.
    pub fn operations(self) -> f64 {
        let (unknowns, contact) = (self.unknowns as f64, self.contact as f64);
        if self.unknowns == 0 {
            return 0.0;
        }
        if self.sparse {
            // All columns of the zone, where a run takes them: forward and back through the factors.
            return sparse(self.unknowns)[0] + 4.0 * contact * factors(self.unknowns);
        }
        2.0 / 3.0 * unknowns.powi(3) + contact * (unknowns.powi(2) + contact.powi(2))
    }

    /// Memory (bytes) while the body is condensed: the matrix, factorised in its place, the right-hand sides of
    /// the zone, once more while their rows are exchanged, and the compliance found from them.
    ///
    /// Peak resident memory of whole runs was 94 MB for 2,808 unknowns, 300 of them in the zone, and 530 MB for
    /// 6,840 and 1,200.
    pub fn memory(self) -> f64 {
        if self.sparse {
            let contact = self.contact as f64;
            return sparse(self.unknowns)[1] + size_of::<f64>() as f64 * contact * contact;
        }
        let (unknowns, contact) = (self.unknowns as f64, self.contact as f64);
        let equations =
            if self.unknowns == 0 { 0.0 } else { unknowns * (unknowns + 2.0 * contact + 1.0) };
        size_of::<f64>() as f64 * (equations + contact * contact)
    }
}

/// Memory (bytes) that the contact of two bodies takes at most at one time, `None` for those without mesh: each
/// is condensed in turn next to what is left of the other, then both are brought to the pairs, which are those of
/// the first, and added up.
pub fn memory(bodies: [Option<Size>; 2]) -> f64 {
    let [first, second] = match bodies {
        [None, second] => [second, None],
        both => both,
    };
    let Some(first) = first else { return 0.0 };
    let own = (first.contact as f64).powi(2);
    let stages = match second {
        None => [first.memory(), size_of::<f64>() as f64 * 3.0 * own, 0.0],
        Some(second) => {
            let (pairs, nodes) = (first.contact as f64, second.contact as f64);
            let brought = 2.0 * own + nodes * nodes + 3.0 * pairs * nodes;
            [
                first.memory(),
                size_of::<f64>() as f64 * own + second.memory(),
                size_of::<f64>() as f64 * brought.max(3.0 * own),
            ]
        }
    };
    stages.into_iter().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::{Size, memory};
    use crate::body::Interpolation::{Continuous, Discontinuous};
    use crate::body::mesh::{ContactMesh, Corners, Face, Mesh, Zone};

    /// A closed wedge: two triangles and three quadrilaterals on six vertices; the zone is the top triangle.
    fn wedge() -> ContactMesh {
        let triangle = |corners| Face { corners: Corners::Triangle(corners), surface: 0 };
        let quad = |corners| Face { corners: Corners::Quad(corners), surface: 1 };
        let faces = vec![
            triangle([3, 4, 5]),
            triangle([0, 2, 1]),
            quad([0, 1, 4, 3]),
            quad([1, 2, 5, 4]),
            quad([2, 0, 3, 5]),
        ];
        let mesh = Mesh { vertices: vec![[0.0; 3]; 6], faces, surfaces: vec![] };
        ContactMesh {
            mesh,
            zone: Zone { faces: vec![0], grid: None },
            placed: true,
            ..ContactMesh::default()
        }
    }

    #[test]
    fn unknowns_are_counted_and_bounded_from_below() {
        let size = |interpolation| Size::of(&wedge(), interpolation);
        assert_eq!(size(Discontinuous), Size { unknowns: 3 * 18, contact: 9, sparse: false });
        assert_eq!(size(Continuous), Size { unknowns: 3 * 6, contact: 9, sparse: false });
        for interpolation in [Discontinuous, Continuous] {
            let least = Size::at_least(5, interpolation).unknowns;
            assert!(least > 0 && least <= size(interpolation).unknowns);
        }
    }

    /// 15,000 unknowns, a quarter of them in the zone: the matrix of 1.8 GB is the largest part.
    #[test]
    fn a_body_of_fifteen_thousand_unknowns_fits_into_six_gigabytes() {
        let body = Size { unknowns: 15_000, contact: 3_750, sparse: false };
        let alone = memory([Some(body), None]);
        assert!(alone > 1.8e9 && alone < 3e9, "{alone:e}");
        let both = memory([Some(body), Some(body)]);
        assert!(both > alone && both < 6e9, "{both:e}");
        assert_eq!(memory([None, Some(body)]), alone);
        assert_eq!(memory([None, None]), 0.0);
        // As a half-space only the pairs count.
        let pairs = Size { unknowns: 0, ..body };
        assert_eq!(memory([Some(pairs), None]), 8.0 * 3.0 * 3750.0 * 3750.0);
    }
}
