//! Bodies read from files: Gmsh's `.msh` (2.2 and 4.1) and STL, text or binary, and the input of CalculiX and Abaqus, `.inp`.

mod error;
mod faces;
mod gmsh;
mod inp;
mod inside;
mod matrix;
mod near;
mod solid;
mod source;
mod stl;
mod weld;

pub use error::{Fault, MeshFileError, Place};

#[cfg(test)]
mod tests;

use std::f64::consts::PI;
use std::sync::Arc;

use super::reduced::Holds;
use super::{
    ContactMesh, MOST_OF_A_FILE, Mesh, MeshError, Shape, SupportedSurfaces, Zone, thickness,
};
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity};
use inside::Inside;
use matrix::{Matrix, PLACES, Places};
use near::Near;
use solid::Solid;

/// Where elements turn by more (rad) is an edge of the body: a cylinder of ten plane strips has none along them, a
/// chamfer of 45 degrees has two.
const FEATURE_ANGLE: f64 = 40.0 * PI / 180.0;

/// Units a file may be in, and how long they are (m).
const UNITS: [(&str, f64); 6] =
    [("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9), ("in", 0.0254)];

pub(super) const CHOICE: Choice<Box<dyn Shape>> = Choice {
    name: "file",
    meaning: "a body from a file: Gmsh's .msh (2.2 or 4.1), .inp of CalculiX or Abaqus, or its surface as .stl; its coordinates are the true places",
    parameters: &[
        Parameter::required("path", Quantity::File, "the file"),
        Parameter::optional(
            "contact",
            Quantity::TextOr(near::PARAMETERS),
            "what may touch: the name of a surface, which is a physical group of the .msh, a solid or a face of the .stl; or a place on it",
        ),
        Parameter::optional(
            "feature_angle",
            Quantity::Angle,
            "edges of the body are where elements turn by more: surfaces are divided there; only an .stl of one solid unless given, at 40 degrees",
        )
        .bound(Bound::UpTo(0.0, PI)),
        Parameter::optional(
            "unit",
            Quantity::Word(&["m", "cm", "mm", "um", "nm", "in"]),
            "the unit of the coordinates; m unless given",
        ),
        Parameter::optional(
            "compliance",
            Quantity::File,
            "the stiffness or flexibility of the body at the nodes of `contact`, in place of its elements: a superelement of Abaqus or CalculiX (.mtx), Nastran (DMIG) or in Matrix Market, with the same numbers of nodes",
        ),
        Parameter::optional(
            "compliance_unit",
            Quantity::Word(&matrix::WORDS),
            "the unit of its values, one of stiffness or of flexibility; newtons in `unit` unless given",
        ),
        Parameter::optional(
            "places",
            Quantity::Table(PLACES),
            "where its nodes are, where the mesh numbers its own otherwise or the matrix names none: a CSV of node, x_mm, y_mm and z_mm, its rows in the order of the matrix",
        ),
    ],
    build: |values| {
        let (name, bytes) =
            values.file("path").ok_or_else(|| Invalid::new("path", "is missing"))?;
        let unit = values.word("unit").unwrap_or("m");
        let scale = UNITS.iter().find(|known| known.0 == unit).map_or(1.0, |known| known.1);
        let Solid { mut mesh, inside } =
            parse(bytes).map_err(|error| Invalid::new("path", format!("{name}, {error}")))?;
        if mesh.faces.len() > MOST_OF_A_FILE {
            let count = mesh.faces.len();
            let message = format!(
                "{name} has {count} elements, {MOST_OF_A_FILE} are the most: mesh it coarser, in Gmsh by a larger `Mesh.MeshSizeMin`, and divide the elements of the contact by `contact.elements`"
            );
            return Err(Invalid::new("path", message));
        }
        mesh.vertices.as_flattened_mut().iter_mut().for_each(|value| *value *= scale);
        let angle = values.number("feature_angle");
        let feature_angle = angle.unwrap_or(FEATURE_ANGLE);
        if angle.is_none() && stl::is_stl(bytes) && mesh.surfaces.len() == 1 {
            mesh.split(feature_angle, |_| "face".to_owned());
        } else {
            solid::divide(&mut mesh, angle, FEATURE_ANGLE);
        }
        let inside = inside.map(|inside| Inside::new(inside, scale, angle, FEATURE_ANGLE));
        if let Some(fault) = inside.as_ref().and_then(Inside::fault) {
            return Err(Invalid::new("path", format!("{name}: {fault}")));
        }
        let contact = match (values.word("contact"), values.section("contact")) {
            (Some(surface), _) => Contact::Surface(mesh.surface(surface)?),
            (_, Some(place)) => Contact::Near(Near::read(place, &mesh)?),
            (None, None) => Contact::None,
        };
        let places = values.table("places").map(Places::read).transpose()?;
        let matrix = match values.parsed("compliance", matrix::parse) {
            None if places.is_some() => {
                let message = "says where the nodes of a `compliance` are: give that too, or leave this out";
                return Err(Invalid::new("places", message));
            }
            None => None,
            Some((name, parsed)) => {
                let unit = values.word("compliance_unit");
                let unit = unit.and_then(|unit| matrix::UNITS.iter().find(|known| known.0 == unit));
                let unit = unit.copied().unwrap_or(("", Holds::Stiffness, 1.0 / scale));
                let matrix = parsed.and_then(|parsed| Matrix::new(parsed, unit, places));
                let matrix = matrix.map_err(|wrong| Invalid::new("compliance", wrong.of(name)))?;
                Some((name.to_owned(), matrix))
            }
        };
        Ok(Box::new(File { mesh, inside, contact, feature_angle, matrix }))
    },
};

/// What the bytes of a file hold, in the file's unit.
///
/// # Errors
/// If the bytes are none of the formats, or broken, or hold no surface of straight elements.
fn parse(bytes: &[u8]) -> Result<Solid, MeshFileError> {
    let text = bytes.trim_ascii_start();
    if text.starts_with(b"$") {
        gmsh::parse(bytes)
    } else if stl::is_stl(bytes) {
        Ok(Solid { mesh: stl::parse(bytes)?, inside: None })
    } else if inp::is_inp(bytes) {
        inp::parse(bytes)
    } else {
        Err(MeshFileError { place: Place::Line(1), fault: Fault::UnknownFormat })
    }
}

/// A body from a file, with the part of its surface that may touch.
#[derive(Debug)]
struct File {
    mesh: Mesh,
    inside: Option<Inside>,
    contact: Contact,
    /// Elements that turn by more (rad) meet in an edge of the body.
    feature_angle: f64,
    /// How its nodes give way, and the file that says so.
    matrix: Option<(String, Matrix)>,
}

/// What of a file may touch.
#[derive(Debug)]
enum Contact {
    None,
    /// All of a surface, by its index.
    Surface(usize),
    /// What is near a place.
    Near(Near),
}

impl Shape for File {
    fn mesh(
        &self,
        mirrored: [bool; 2],
        _held: &SupportedSurfaces,
    ) -> Result<ContactMesh, MeshError> {
        let mut mesh = self.mesh.clone();
        mesh.put_on_planes(mirrored);
        mesh.orient(mirrored);
        let (mesh, zone) = match &self.contact {
            Contact::None => (mesh, Zone::default()),
            Contact::Surface(surface) => {
                let zone = mesh.zone_of(*surface);
                (mesh, zone)
            }
            Contact::Near(near) => near.zone(mesh, self.feature_angle, mirrored)?,
        };
        Ok(ContactMesh { mesh, zone, placed: true, ..ContactMesh::default() })
    }

    fn at_least(&self, _mirrored: [bool; 2], _held: &SupportedSurfaces) -> usize {
        self.mesh.faces.len()
    }

    fn coarse(
        &self,
        rectangle: Option<[[f64; 2]; 2]>,
        _mirrored: [bool; 2],
        held: &SupportedSurfaces,
    ) -> Option<ContactMesh> {
        let named = match &self.contact {
            Contact::None => None,
            Contact::Surface(surface) => Some(self.mesh.surfaces[*surface].as_str()),
            Contact::Near(_) => return None,
        };
        self.inside.as_ref()?.below(rectangle.map(|[centre, _]| centre), held, named)
    }

    fn filled(&self) -> Option<Result<ContactMesh, MeshError>> {
        let inside = self.inside.as_ref()?;
        let zone = match &self.contact {
            Contact::None => Ok(Zone::default()),
            Contact::Surface(surface) => inside.zone(&self.mesh.surfaces[*surface]),
            Contact::Near(near) => {
                inside.near(near.alike(&self.mesh, &inside.mesh)?, self.feature_angle)
            }
        };
        Some(zone.and_then(|zone| {
            let reduced = match &self.matrix {
                None => None,
                Some((name, matrix)) => {
                    let reduced = matrix.at(inside, &zone);
                    Some(reduced.map_err(|wrong| MeshError::Matrix { message: wrong.of(name) })?)
                }
            };
            Ok(ContactMesh { reduced: reduced.map(Arc::new), ..inside.placed(zone) })
        }))
    }

    fn slenderness(
        &self,
        meshed: &ContactMesh,
        mirrored: [bool; 2],
        held: &SupportedSurfaces,
    ) -> Option<f64> {
        thickness::longest(meshed, mirrored, held)
    }
}

impl Mesh {
    /// The elements of the surface of that name, as a zone that may touch.
    ///
    /// # Errors
    /// If there is no such surface.
    pub fn zone(&self, surface: &str) -> Result<Zone, MeshError> {
        Ok(self.zone_of(self.surface(surface)?))
    }

    /// The index of the surface of that name.
    fn surface(&self, surface: &str) -> Result<usize, MeshError> {
        self.surfaces.iter().position(|name| name == surface).ok_or_else(|| {
            let (name, known) = (surface.to_owned(), self.surfaces.clone());
            MeshError::NoSurface { name, known }
        })
    }

    /// The elements of a surface.
    fn zone_of(&self, surface: usize) -> Zone {
        let faces = self.faces.iter().enumerate();
        let faces = faces.filter(|(_, face)| face.surface == surface).map(|(index, _)| index);
        Zone { faces: faces.collect(), grid: None }
    }
}
