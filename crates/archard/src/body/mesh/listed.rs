//! The surfaces of a mesh with their places and sizes, so that they can be told apart.

use std::fmt::{self, Display, Formatter};

use super::{Mesh, Zone};

/// A surface of a mesh.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct MeshSurface {
    /// Its name.
    pub name: String,
    /// How many elements it has.
    pub elements: usize,
    /// How many of them may touch.
    pub touching: usize,
    /// The middle of the box around it along x, y and z (m).
    pub middle: [f64; 3],
    /// The sides of that box (m).
    pub size: [f64; 3],
}

impl Mesh {
    /// All surfaces that have elements, in their order.
    pub fn listed(&self, zone: &Zone) -> Vec<MeshSurface> {
        let mut faces: Vec<Vec<usize>> = vec![vec![]; self.surfaces.len()];
        for (face, element) in self.faces.iter().enumerate() {
            faces[element.surface].push(face);
        }
        let mut touching = vec![0; self.surfaces.len()];
        zone.faces.iter().for_each(|&face| touching[self.faces[face].surface] += 1);
        let all = self.surfaces.iter().zip(faces).zip(touching);
        let there = all.filter(|((_, faces), _)| !faces.is_empty());
        there
            .map(|((name, faces), touching)| {
                let elements = faces.len();
                let [low, high] = self.bounds(faces);
                let (middle, size) = ((0.5 * (low + high)).to_array(), (high - low).to_array());
                MeshSurface { name: name.clone(), elements, touching, middle, size }
            })
            .collect()
    }
}

/// "96 on `top`, 40 x 30 x 0 mm around (0, 0, 20) mm".
impl Display for MeshSurface {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { name, elements, touching, middle, size } = self;
        let most = size.iter().chain(middle).fold(0.0_f64, |most, value| most.max(value.abs()));
        let [middle, size] =
            [middle, size].map(|three| three.map(|value| millimetres(value, most)));
        let (middle, size) = (middle.join(", "), size.join(" x "));
        write!(f, "{elements} on `{name}`, {size} mm around ({middle}) mm")?;
        match touching {
            0 => Ok(()),
            all if all == elements => write!(f, ", may touch"),
            some => write!(f, ", {some} of them may touch"),
        }
    }
}

/// A length (m) in mm, to four digits of the largest next to it.
fn millimetres(value: f64, most: f64) -> String {
    let digits = 3.0 - (1e3 * most).log10().floor();
    let unit = 10f64.powf(digits.clamp(-3.0, 9.0));
    let rounded = (1e3 * value * unit).round() / unit;
    format!("{}", rounded + 0.0)
}
