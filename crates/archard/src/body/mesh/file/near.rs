//! The zone that may touch, picked by a place: elements of one smooth face in a box, divided until they are small.

use glam::DVec3;

use crate::body::mesh::refine::Refined;
use crate::body::mesh::smooth::Turns;
use crate::body::mesh::{Mesh, MeshError, Zone};
use crate::numerics::WRITTEN;
use crate::numerics::triangle;
use crate::parameters::{Invalid, Parameter, Quantity, Value, Values};

/// What a zone that is picked by a place takes.
pub(super) const PARAMETERS: &[Parameter] = &[
    Parameter::required(
        "near",
        Quantity::Triple(&Quantity::Length),
        "the middle of the box, a place on the surface or close to it",
    )
    .bound(crate::parameters::Bound::Any),
    Parameter::required(
        "size",
        Quantity::OneOrThree(&Quantity::Length),
        "the sides of the box along x, y and z, or one for all",
    ),
    Parameter::optional(
        "elements",
        Quantity::Count,
        "elements are divided there until so many lie across the box; as they are in the file unless given",
    ),
    Parameter::optional("surface", Quantity::Text, "the surface it is on; any unless given"),
];

/// A zone that is picked by a place.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Near {
    /// The middle of the box (m).
    middle: DVec3,
    /// Half of its sides (m).
    half: DVec3,
    elements: Option<usize>,
    surface: Option<usize>,
}

impl Near {
    /// What the values ask for, on the surfaces of a mesh.
    pub fn read(values: &Values, mesh: &Mesh) -> Result<Self, Invalid> {
        let missing = |name: &str| Invalid::new(format!("contact.{name}"), "is missing");
        let size = match values.get("size") {
            Some(Value::Number(side)) => [*side; 3],
            Some(Value::Triple(sides)) => *sides,
            _ => return Err(missing("size")),
        };
        let surface = values.word("surface").map(|name| mesh.surface(name)).transpose();
        let surface =
            surface.map_err(|error| Invalid::new("contact.surface", error.to_string()))?;
        Ok(Self {
            middle: values.triple("near").ok_or_else(|| missing("near"))?.into(),
            half: 0.5 * DVec3::from(size),
            elements: values.number("elements").map(|number| number as usize),
            surface,
        })
    }

    /// The same on another mesh of the surface, where it divides no element and both have the same surfaces.
    pub fn alike(&self, mesh: &Mesh, other: &Mesh) -> Option<&Self> {
        (self.elements.is_none() && mesh.surfaces == other.surfaces).then_some(self)
    }

    /// The zone, with elements divided there.
    ///
    /// # Errors
    /// If no element lies there, or too many would.
    pub fn zone(
        &self,
        mesh: Mesh,
        feature_angle: f64,
        mirrored: [bool; 2],
    ) -> Result<(Mesh, Zone), MeshError> {
        let faces = Turns::of(&mesh).faces(feature_angle);
        let seed = self.nearest(&mesh, |face| self.may_be(&mesh, face));
        // Of a place far away nothing is near.
        if let Some((seed, distance)) = seed.filter(|(_, away)| *away <= self.half.length()) {
            let beside = |face: usize| faces[face] != faces[seed] && self.may_be(&mesh, face);
            let reach = distance + WRITTEN * self.half.max_element();
            if let Some((other, _)) = self.nearest(&mesh, beside).filter(|(_, away)| *away <= reach)
            {
                let name = |face: usize| mesh.surfaces[mesh.faces[face].surface].clone();
                return Err(MeshError::OnEdge { faces: vec![name(seed), name(other)] });
            }
        }
        let smooth = |origin: usize| seed.is_some_and(|(seed, _)| faces[origin] == faces[seed]);
        let normal = seed.map_or(DVec3::Z, |(seed, _)| mesh.area_vector(seed).into());
        let mut refined = Refined::new(mesh, feature_angle, mirrored);
        if let Some(elements) = self.elements {
            let width = 2.0 * self.across(normal) / elements.max(1) as f64;
            let meant =
                |mesh: &Mesh, face: usize, origin: usize| smooth(origin) && self.meets(mesh, face);
            if !refined.until(width, meant) {
                return Err(MeshError::TooFine { width });
            }
        }
        let (mesh, origin) = refined.finish();
        let inside = |face: usize| smooth(origin[face]) && self.holds(mesh.centre(face).into());
        let first = self.nearest(&mesh, inside).map(|(face, _)| face);
        let Some(first) = first else {
            let extent = mesh.bounds(0..mesh.faces.len()).map(|corner| corner.to_array());
            return Err(MeshError::NothingNear {
                size: (2.0 * self.half).to_array(),
                distance: seed.map_or(f64::INFINITY, |(_, distance)| distance),
                divided: self.elements.is_some(),
                extent,
            });
        };
        let faces = mesh.together(first, inside);
        Ok((mesh, Zone { faces, grid: None }))
    }

    /// Half of the shorter side of the box across a normal (m).
    fn across(&self, normal: DVec3) -> f64 {
        let along = normal.abs().max_position();
        (0..3)
            .filter(|&axis| axis != along)
            .map(|axis| self.half[axis])
            .fold(f64::INFINITY, f64::min)
    }

    fn may_be(&self, mesh: &Mesh, face: usize) -> bool {
        self.surface.is_none_or(|surface| mesh.faces[face].surface == surface)
    }

    /// Whether a place lies in the box.
    fn holds(&self, place: DVec3) -> bool {
        (place - self.middle).abs().cmple(self.half).all()
    }

    /// Whether an element may reach into the box.
    fn meets(&self, mesh: &Mesh, face: usize) -> bool {
        let [low, high] = mesh.bounds(std::iter::once(face));
        let normal = DVec3::from(mesh.area_vector(face)).normalize_or_zero();
        let corner = DVec3::from(mesh.vertices[mesh.faces[face].corners.as_slice()[0]]);
        low.cmple(self.middle + self.half).all()
            && high.cmpge(self.middle - self.half).all()
            && normal.dot(corner - self.middle).abs() <= normal.abs().dot(self.half)
    }

    /// The element nearest to the middle of the box of those that are meant, and its distance (m).
    fn nearest(&self, mesh: &Mesh, meant: impl Fn(usize) -> bool) -> Option<(usize, f64)> {
        let distance = |face: usize| {
            let corners = mesh.faces[face].corners.as_slice();
            let place = |corner: usize| DVec3::from(mesh.vertices[corners[corner]]);
            (2..corners.len())
                .map(|last| triangle::distance(self.middle, [0, last - 1, last].map(place)))
                .fold(f64::INFINITY, f64::min)
        };
        let faces = (0..mesh.faces.len()).filter(|&face| meant(face));
        faces.map(|face| (face, distance(face))).min_by(|one, other| one.1.total_cmp(&other.1))
    }
}
