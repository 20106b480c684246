//! Plane sections through a body, with the response of the body on a grid of places.

use glam::DVec3;
use rayon::prelude::*;

use super::{PressedHalfSpace, Response};
use crate::body::mesh;
use crate::compliance::bem::{Interior, Surface};
use crate::numerics::SAME;
use crate::parameters::{Bound, Parameter, Quantity};

/// Most places of a section that are looked at.
const MOST: f64 = 40_000.0;

/// Places of a section along the surface. A choice: what a picture resolves.
const PLACES: f64 = 128.0;

/// A plane section of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// The user's name for it.
    pub name: String,
    /// A place on it (m), from which the places of the grid are counted.
    pub through: [f64; 3],
    /// Its normal along x, y and z, of any length.
    pub normal: [f64; 3],
    /// Distance between places (m).
    pub spacing: f64,
    /// How far it reaches along its two axes (m), half of it to either side; through the whole body unless given.
    pub size: Option<[f64; 2]>,
}

/// The response of a body on a section of it.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionResponse {
    /// The name of the section.
    pub name: String,
    /// The places in the body (m).
    pub places: Vec<[f64; 3]>,
    /// Squares between four of the places, by their indices, around each.
    pub cells: Vec<[usize; 4]>,
    /// Displacement and stress at each place.
    pub responses: Vec<Response>,
}

/// Why a section has no places.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SectionError {
    /// A normal without length.
    #[error("the normal has no direction: give three numbers, one of them not zero")]
    NoNormal,
    /// More places than anyone waits for.
    #[error(
        "a section of {places:.1e} places: take a larger `spacing`, or a `size`, for {MOST} at most"
    )]
    TooMany {
        /// How many.
        places: f64,
    },
    /// A size that holds no square of the grid.
    #[error("is smaller than `spacing`: the section holds no square of the grid")]
    Small,
    /// Nothing ends a section of a half-space.
    #[error("a half-space has no end: give the `size` of the section")]
    Endless,
    /// No square of the grid lies in the body.
    #[error("misses the body: no square of the grid lies in it")]
    Misses,
}

impl SectionError {
    /// The parameter to change.
    pub fn parameter(&self) -> &'static str {
        match self {
            SectionError::NoNormal => "normal",
            SectionError::TooMany { .. } => "spacing",
            SectionError::Small => "size",
            SectionError::Endless | SectionError::Misses => "through",
        }
    }
}

impl PressedHalfSpace {
    /// A section along an axis through a place (m), twice as wide as the contact and as deep as that is wide, as far as stresses are
    /// known; `None` where nothing is pressed.
    pub fn section_through(&self, name: &str, place: [f64; 3], axis: usize) -> Option<Section> {
        let mut through = place;
        let axis = if self.below.is_line() { 0 } else { axis };
        let pressed = self.below.pressure().iter().enumerate().filter(|(_, p)| **p > 0.0);
        let places = pressed.map(|(element, _)| self.below.place(element)[axis]);
        let [low, high] = places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], own| {
            [low.min(own), high.max(own)]
        });
        let width = high - low + self.below.spacing()[axis];
        let frame = self.below.elements()[axis] as f64 * self.below.spacing()[axis];
        let across = (2.0 * width).min(frame);
        let deep = width.max(1.25 * through[2].abs()).min(self.known_depth());
        (through[axis], through[2]) = (0.5 * (low + high), 0.0);
        let mut normal = [0.0; 3];
        normal[1 - axis] = 1.0;
        let spacing = across / PLACES;
        let size = Some([across, 2.0 * deep]);
        (width > 0.0 && deep > 2.0 * spacing).then(|| Section {
            name: name.to_owned(),
            through,
            normal,
            spacing,
            size,
        })
    }
}

/// The grid of a section: its axes (m, a step each) and how far it reaches along them.
struct Grid {
    origin: DVec3,
    steps: [DVec3; 2],
    /// The first step along each axis, and how many places.
    first: [f64; 2],
    counts: [usize; 2],
}

impl Section {
    /// What a section is described by in a case.
    pub const PARAMETERS: &'static [Parameter] = &[
        Parameter::required(
            "through",
            Quantity::Triple(&Quantity::Length),
            "a place on the section",
        )
        .bound(Bound::Any),
        Parameter::required(
            "normal",
            Quantity::Triple(&Quantity::Number),
            "the normal of the section along x, y and z, like [0, 1, 0]",
        )
        .bound(Bound::Any),
        Parameter::required("spacing", Quantity::Length, "distance between places"),
        Parameter::optional(
            "size",
            Quantity::Pair(&Quantity::Length),
            "how far the section reaches along its two axes: x, or y where the normal is along x, then across it; through the whole body unless given, which a half-space does not end",
        ),
    ];

    /// Whether there is something to see on it.
    ///
    /// # Errors
    /// If there are no places, or too many.
    pub fn check(&self, surface: &Surface) -> Result<(), SectionError> {
        self.shows(Some(&surface.corners()), |place| surface.depth(place).is_some())
    }

    /// The same on a half-space, whose surface is z = 0.
    ///
    /// # Errors
    /// As [`Section::check`], and if nothing ends the section.
    pub fn check_half_space(&self) -> Result<(), SectionError> {
        self.shows(None, |place| self.below_zero(place).is_some())
    }

    /// A place in a half-space: on its surface where rounding alone says that it is not. `None` above.
    pub(super) fn below_zero(&self, place: DVec3) -> Option<DVec3> {
        let near = SAME * self.spacing;
        (place.z <= near).then(|| place.with_z(place.z.min(0.0)))
    }

    fn shows(
        &self,
        corners: Option<&[DVec3]>,
        holds: impl Fn(DVec3) -> bool + Sync,
    ) -> Result<(), SectionError> {
        let grid = self.grid(corners)?;
        let inside = |column: usize, row: usize| holds(grid.place(column, row));
        let square = |&cell: &usize| {
            let (column, row) = (cell % (grid.counts[0] - 1), cell / (grid.counts[0] - 1));
            [[0, 0], [1, 0], [1, 1], [0, 1]].iter().all(|[x, y]| inside(column + x, row + y))
        };
        let cells = (grid.counts[0].max(1) - 1) * (grid.counts[1].max(1) - 1);
        let found = (0..cells).into_par_iter().any(|cell| square(&cell));
        if found { Ok(()) } else { Err(SectionError::Misses) }
    }

    /// The response of a body on it; without places where [`Section::check`] complains.
    pub(super) fn sample(&self, surface: &Surface, interior: &Interior<'_>) -> SectionResponse {
        let at = |place: &DVec3| interior.at(*place).map(Response::from);
        self.responses(Some(&surface.corners()), |places| places.par_iter().map(at).collect())
    }

    /// What is found at its places within the corners of a body, where anything is.
    pub(super) fn responses(
        &self,
        corners: Option<&[DVec3]>,
        at: impl Fn(&[DVec3]) -> Vec<Option<Response>>,
    ) -> SectionResponse {
        let mut sampled = SectionResponse {
            name: self.name.clone(),
            places: vec![],
            cells: vec![],
            responses: vec![],
        };
        let Ok(grid) = self.grid(corners) else { return sampled };
        let [columns, rows] = grid.counts;
        let places: Vec<DVec3> =
            (0..columns * rows).map(|index| grid.place(index % columns, index / columns)).collect();
        let responses = at(&places);
        let corners = |column: usize, row: usize| {
            let first = column + columns * row;
            [first, first + 1, first + 1 + columns, first + columns]
        };
        let squares = (1..rows).flat_map(|row| (1..columns).map(move |x| corners(x - 1, row - 1)));
        let whole = squares.filter(|cell| cell.iter().all(|&corner| responses[corner].is_some()));
        let mut index = vec![None; responses.len()];
        for cell in whole {
            let cell = cell.map(|corner| {
                *index[corner].get_or_insert_with(|| {
                    sampled.places.push(places[corner].to_array());
                    sampled.responses.extend(responses[corner]);
                    sampled.places.len() - 1
                })
            });
            sampled.cells.push(cell);
        }
        sampled
    }

    /// The places of the section within the box around the corners of a body; of its `size` alone where it has none.
    fn grid(&self, corners: Option<&[DVec3]>) -> Result<Grid, SectionError> {
        let normal = DVec3::from(self.normal);
        if normal == DVec3::ZERO {
            return Err(SectionError::NoNormal);
        }
        if self.size.is_some_and(|size| size.iter().any(|side| *side < self.spacing)) {
            return Err(SectionError::Small);
        }
        if corners.is_none() && self.size.is_none() {
            return Err(SectionError::Endless);
        }
        let [along, across, _] = mesh::axes(normal);
        let origin = DVec3::from(self.through);
        let range = |axis: usize| {
            let unit = [along, across][axis];
            let seen = |corner: &DVec3| (*corner - origin).dot(unit) / self.spacing;
            let box_of = |corners: &[DVec3]| {
                let none = [f64::INFINITY, f64::NEG_INFINITY];
                corners
                    .iter()
                    .map(seen)
                    .fold(none, |[low, high], one| [low.min(one), high.max(one)])
            };
            let [low, high] = corners.map_or([f64::NEG_INFINITY, f64::INFINITY], box_of);
            let reach = self.size.map_or(f64::INFINITY, |size| 0.5 * size[axis] / self.spacing);
            // What ends on a step ends with it, whatever rounding says.
            let near = 1e-6;
            let [low, high] = [low.max(-reach) - near, high.min(reach) + near];
            [low.ceil(), high.floor()]
        };
        let ranges = [range(0), range(1)];
        let counts = ranges.map(|[low, high]| (high - low + 1.0).max(0.0));
        let places = counts[0] * counts[1];
        if places > MOST {
            return Err(SectionError::TooMany { places });
        }
        if counts.iter().any(|count| *count < 2.0) {
            return Err(SectionError::Misses);
        }
        Ok(Grid {
            origin,
            steps: [self.spacing * along, self.spacing * across],
            first: ranges.map(|[low, _]| low),
            counts: counts.map(|count| count as usize),
        })
    }
}

impl Grid {
    fn place(&self, column: usize, row: usize) -> DVec3 {
        let steps = [self.first[0] + column as f64, self.first[1] + row as f64];
        self.origin + steps[0] * self.steps[0] + steps[1] * self.steps[1]
    }
}
