//! Which directions supports hold at the nodes of a volume.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::body::mesh::{Corners, Mesh, Volume};
use crate::body::{Finite, Support};
use crate::compliance::bem::contact::STEEP;
use crate::numerics::{SAME, WRITTEN};

/// Three directions at right angles: first those that are held, then those that are free.
#[derive(Debug, Clone, Copy)]
pub(super) struct Held {
    pub basis: [DVec3; 3],
    /// How many of them are held.
    pub count: usize,
}

impl Held {
    pub const FREE: Self = Self { basis: DVec3::AXES, count: 0 };

    /// Of directions that are held, each with the angle (rad) by which it may be off.
    fn of(directions: &[(DVec3, f64)]) -> Self {
        let mut basis = vec![];
        let add = |basis: &mut Vec<DVec3>, (direction, off): (DVec3, f64)| {
            let across = |basis: &[DVec3], one: DVec3| {
                basis.iter().fold(one, |rest, known| rest - rest.dot(*known) * *known)
            };
            let rest = across(basis, across(basis, direction));
            if basis.len() < 3 && rest.length() > off.max(SAME) * direction.length() {
                basis.push(rest.normalize());
            }
        };
        directions.iter().for_each(|direction| add(&mut basis, *direction));
        let count = basis.len();
        DVec3::AXES.into_iter().for_each(|axis| add(&mut basis, (axis, 0.0)));
        Self { basis: [basis[0], basis[1], basis[2]], count }
    }

    /// The part of a vector along what is held.
    pub fn held(&self, vector: DVec3) -> DVec3 {
        self.basis[..self.count].iter().map(|one| vector.dot(*one) * *one).sum()
    }

    /// The part of a vector along what is free.
    pub fn free(&self, vector: DVec3) -> DVec3 {
        self.basis[self.count..].iter().map(|one| vector.dot(*one) * *one).sum()
    }
}

/// What is held: of each node of a volume, and of each triangle of its surface.
pub(super) fn held(finite: &Finite, volume: &Volume) -> [Vec<Held>; 2] {
    let mesh = &finite.meshed.mesh;
    let support = |surface: usize| {
        finite.supports.iter().find(|(own, _)| *own == surface).map(|(_, support)| *support)
    };
    // Where a surface is smooth, its normal at a node is the mean over its triangles there; at an edge it has several.
    let mut normals: BTreeMap<(usize, usize), Vec<DVec3>> = BTreeMap::new();
    for (face, nodes) in volume.faces.iter().enumerate() {
        let surface = mesh.faces[face].surface;
        for node in nodes.iter().filter(|_| support(surface).is_some()) {
            let (known, own) = (normals.entry((*node, surface)).or_default(), normal(mesh, face));
            let turns = |one: &DVec3| one.dot(own) > STEEP * one.length() * own.length();
            match known.iter_mut().find(|one| turns(one)) {
                Some(one) => *one += own,
                None => known.push(own),
            }
        }
    }
    let extent = mesh.extent();
    let along = |surface: usize, normal: DVec3| along(support(surface), normal, extent);
    let mut directions: BTreeMap<usize, Vec<(DVec3, f64)>> = BTreeMap::new();
    for ((node, surface), normals) in normals {
        let held = normals.into_iter().flat_map(|normal| along(surface, normal));
        directions.entry(node).or_default().extend(held);
    }
    let mut nodes = vec![Held::FREE; volume.nodes.len()];
    directions.iter().for_each(|(node, directions)| nodes[*node] = Held::of(directions));
    let faces = (0..volume.faces.len())
        .map(|face| Held::of(&along(mesh.faces[face].surface, normal(mesh, face))));
    [nodes, faces.collect()]
}

/// The normal of a triangle of the surface, as long as its area (m^2) doubled.
fn normal(mesh: &Mesh, face: usize) -> DVec3 {
    match mesh.faces[face].corners {
        Corners::Triangle(corners) => {
            let [a, b, c] = corners.map(|corner| DVec3::from(mesh.vertices[corner]));
            (b - a).cross(c - a)
        }
        Corners::Quad(_) => DVec3::from(mesh.area_vector(face)),
    }
}

/// The directions that a support holds on a surface of that normal, as long as an area (m^2) doubled, of a body of that extent (m); each
/// with the angle (rad) by which it may be off, as places are written with seven digits.
fn along(support: Option<Support>, normal: DVec3, extent: f64) -> Vec<(DVec3, f64)> {
    match support {
        None => vec![],
        Some(Support::Roller) => vec![(normal, WRITTEN * extent / normal.length().sqrt())],
        Some(support) => {
            let holds = support.holds();
            let axes = DVec3::AXES.into_iter().zip(holds);
            axes.filter_map(|(axis, holds)| holds.then_some((axis, 0.0))).collect()
        }
    }
}
