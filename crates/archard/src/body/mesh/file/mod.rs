//! Surfaces read from files: Gmsh's `.msh` (2.2 and 4.1) and STL, text or binary.

mod error;
mod gmsh;
mod source;
mod stl;

pub use error::{Fault, MeshFileError, Place};

#[cfg(test)]
mod tests;

use super::{Mesh, MeshError, Meshed, Shape, Supported, Zone, thickness};
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

/// Units a file may be in, and how long they are (m).
const UNITS: [(&str, f64); 6] =
    [("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9), ("in", 0.0254)];

pub(super) const CHOICE: Choice<Box<dyn Shape>> = Choice {
    name: "file",
    meaning: "a surface from a file: Gmsh's .msh (2.2 or 4.1) or .stl; its coordinates are the true places",
    parameters: &[
        Parameter::required("path", Quantity::File, "the file"),
        Parameter::optional(
            "contact",
            Quantity::Text,
            "the surface that may touch: a physical group of the .msh, a solid of the .stl",
        ),
        Parameter::optional(
            "unit",
            Quantity::Word(&["m", "cm", "mm", "um", "nm", "in"]),
            "the unit of the coordinates; m unless given",
        ),
    ],
    build: |values| {
        let (name, bytes) =
            values.file("path").ok_or_else(|| Invalid::new("path", "is missing"))?;
        let unit = values.word("unit").unwrap_or("m");
        let scale = UNITS.iter().find(|known| known.0 == unit).map_or(1.0, |known| known.1);
        let mut mesh =
            parse(bytes).map_err(|error| Invalid::new("path", format!("{name}, {error}")))?;
        mesh.vertices.as_flattened_mut().iter_mut().for_each(|value| *value *= scale);
        let zone = match values.word("contact") {
            Some(surface) => mesh.zone(surface)?,
            None => Zone::default(),
        };
        Ok(Box::new(File { mesh, zone }))
    },
};

/// The surface in the bytes of a file, in the file's unit.
///
/// # Errors
/// If the bytes are none of the formats, or broken, or hold no surface of straight elements.
pub(super) fn parse(bytes: &[u8]) -> Result<Mesh, MeshFileError> {
    let text = bytes.trim_ascii_start();
    if text.starts_with(b"$") {
        gmsh::parse(bytes)
    } else if stl::is_stl(bytes) {
        stl::parse(bytes)
    } else {
        Err(MeshFileError { place: Place::Line(1), fault: Fault::UnknownFormat })
    }
}

/// A surface from a file, with the part of it that may touch.
#[derive(Debug)]
struct File {
    mesh: Mesh,
    zone: Zone,
}

impl Shape for File {
    fn mesh(&self, _mirrored: [bool; 2], _held: &Supported) -> Result<Meshed, MeshError> {
        Ok(Meshed { mesh: self.mesh.clone(), zone: self.zone.clone(), placed: true })
    }

    fn at_least(&self, _mirrored: [bool; 2], _held: &Supported) -> usize {
        self.mesh.faces.len()
    }

    fn slenderness(&self, meshed: &Meshed, mirrored: [bool; 2], held: &Supported) -> Option<f64> {
        thickness::longest(meshed, mirrored, held)
    }
}

impl Mesh {
    /// The elements of the surface of that name, as a zone that may touch.
    ///
    /// # Errors
    /// If there is no such surface.
    pub fn zone(&self, surface: &str) -> Result<Zone, MeshError> {
        let Some(wanted) = self.surfaces.iter().position(|name| name == surface) else {
            let (name, known) = (surface.to_owned(), self.surfaces.clone());
            return Err(MeshError::NoSurface { name, known });
        };
        let faces = self.faces.iter().enumerate();
        let faces = faces.filter(|(_, face)| face.surface == wanted).map(|(index, _)| index);
        Ok(Zone { faces: faces.collect(), grid: None })
    }
}
