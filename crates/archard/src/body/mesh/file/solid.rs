//! What is inside a body, from the tetrahedra of a file.

use std::collections::HashMap;

use crate::body::mesh::volume::{Tetrahedron, key};
use crate::body::mesh::{Mesh, Volume};

/// What a file holds.
#[derive(Debug, Clone)]
pub(super) struct Solid {
    /// The surface.
    pub mesh: Mesh,
    /// What is inside, with its own surface, triangle by triangle.
    pub inside: Option<(Volume, Mesh)>,
}

/// The name of what no element of the file names.
const UNNAMED: &str = "surface";

/// The inside of a body and its surface, from the numbers of the nodes of tetrahedra, four or ten in the order of a [`Volume`], where
/// nodes of these numbers lie, and names of triangles by the numbers of their corners.
///
/// # Errors
/// The number of a node that is not there.
pub(super) fn inside(
    tetrahedra: &[Vec<u64>],
    place: impl Fn(u64) -> Option<[f64; 3]>,
    named: Vec<([u64; 3], String)>,
) -> Result<(Volume, Mesh), u64> {
    let (mut places, mut called, mut indices) = (vec![], vec![], HashMap::new());
    let mut read = vec![];
    for numbers in tetrahedra {
        let mut own = vec![];
        for number in numbers {
            let known = indices.get(number).copied();
            own.push(match known {
                Some(index) => index,
                None => {
                    places.push(place(*number).ok_or(*number)?);
                    called.push(*number);
                    indices.insert(*number, places.len() - 1);
                    places.len() - 1
                }
            });
        }
        if let Ok(ten) = own.as_slice().try_into() {
            read.push(Tetrahedron::Ten(ten));
        } else if let Ok(four) = own.as_slice().try_into() {
            read.push(Tetrahedron::Four(four));
        }
    }
    let volume = Volume { numbers: called, ..Volume::new(places, &read) };
    let mut surfaces: Vec<String> = vec![];
    let mut parts: HashMap<[usize; 3], usize> = HashMap::new();
    for (corners, name) in named {
        let [Some(&a), Some(&b), Some(&c)] = corners.map(|corner| indices.get(&corner)) else {
            continue;
        };
        let surface = surfaces.iter().position(|known| *known == name).unwrap_or_else(|| {
            surfaces.push(name);
            surfaces.len() - 1
        });
        // What is named first stands.
        parts.entry(key([a, b, c])).or_insert(surface);
    }
    let bare = |face: &[usize; 6]| !parts.contains_key(&key([face[0], face[1], face[2]]));
    let unnamed = surfaces.len();
    if volume.faces.iter().any(bare) {
        surfaces.push(UNNAMED.to_owned());
    }
    let mesh = volume.surface(surfaces, |corners| parts.get(&corners).copied().unwrap_or(unnamed));
    Ok((volume, mesh))
}

/// Divides surfaces at the edges where elements turn by more than an angle (rad); where the file names none, by that angle or another.
pub(super) fn divide(mesh: &mut Mesh, angle: Option<f64>, other: f64) {
    if let Some(angle) = angle {
        mesh.split(angle, str::to_owned);
    } else if mesh.surfaces == [UNNAMED] {
        mesh.split(other, |_| "face".to_owned());
    }
}
