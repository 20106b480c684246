//! What the ends of a body change inside the half-space below its contact.
//!
//! Under the tractions of a contact the image field is one field c (`bem::image`), which a coarse mesh of the body knows everywhere: on
//! its surface by Somigliana's identity (`bem::interior`), in tetrahedra by their functions. Stresses are those of the half-space and c.
//! The same from twice as long elements, or by each tetrahedron alone, says how far c is off.

use std::fmt;

use glam::{DMat3, DVec3};
use rayon::prelude::*;

use super::known::Known;
use super::term::Term;
use crate::body::Body;
use crate::body::mesh::Mesh;
use crate::compliance::bem::contact::ContactError;
use crate::compliance::bem::image::{MOST_DEGREES, Polynomials};
use crate::compliance::bem::{Interior, Response, Surface};
use crate::compliance::fem;
use crate::frame::{ContactFrame, Rectangle, VectorField};
use crate::numerics::SAME;
use crate::numerics::quadrature::gauss_legendre;
use crate::stress::Components;

/// The field inside a body, by what finds it.
#[derive(Debug)]
pub(super) enum Inside {
    Surface(Box<Interior<'static>>),
    Volume(fem::Inside),
}

impl Inside {
    fn at(&self, place: DVec3) -> Option<Response> {
        match self {
            Self::Surface(interior) => interior.at(place),
            Self::Volume(inside) => inside.at(place),
        }
    }
}

/// What the ends of a body add to the half-space below its contact, in the axes of the body: z = 0 on its face and negative below.
pub struct Ends {
    field: Inside,
    /// That of longer elements on the surface.
    coarse: Option<Inside>,
    /// That where the body is moved under the contact (m), from elements as for `coarse`.
    moved: Vec<(DVec3, Inside)>,
    surface: Surface,
    frame: Rectangle,
    depth: f64,
}

impl fmt::Debug for Ends {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Ends").field("frame", &self.frame).finish_non_exhaustive()
    }
}

impl Ends {
    /// Of a body with an image field, by its index, that is moved under the contact by offsets (m), under tractions (Pa) on it along x, y
    /// and its outward normal; `None` of another body.
    ///
    /// # Errors
    /// If the body is not held, or its equations have no solution.
    pub fn new(
        bodies: [&Body; 2],
        (which, offsets): (usize, [Rectangle; 2]),
        frame: &ContactFrame,
        tractions: &VectorField,
    ) -> Result<Option<Self>, ContactError> {
        let rectangle = frame.rectangle();
        let Some(one) = Known::new(bodies, offsets, rectangle).of_body(which) else {
            return Ok(None);
        };
        let degree = one.degree_inside(&rectangle);
        let at = |rectangle: Rectangle| Polynomials::new(rectangle, degree);
        let loads = Term::forces(&at(rectangle), frame.elements(), tractions);
        let field = one.inside(&at(rectangle), &loads, true)?;
        let coarse = match field {
            Inside::Surface(_) => Some(one.inside(&at(rectangle), &loads, false)?),
            Inside::Volume(_) => None,
        };
        let there = |end: Rectangle| {
            let [x, y] = [0, 1].map(|axis| end.centre[axis] - rectangle.centre[axis]);
            Ok((DVec3::new(x, y, 0.0), one.inside(&at(end), &loads, false)?))
        };
        let moved = one.ends(&rectangle).map(there).collect::<Result<_, ContactError>>()?;
        let finite = &one.finite;
        let surface = Surface::new(&finite.meshed.mesh, finite.interpolation, finite.mirrored);
        let depth = depth_below(&finite.meshed.mesh, finite.mirrored, &rectangle);
        Ok(Some(Self { field, coarse, moved, surface, frame: rectangle, depth }))
    }

    /// How deep (m) the body is everywhere below the frame.
    pub fn depth(&self) -> f64 {
        self.depth
    }

    /// How deep (m) a place (m) lies below the nearest place of the surface; `None` outside of the body.
    pub fn depth_of(&self, place: [f64; 3]) -> Option<f64> {
        self.surface.depth(place.into())
    }

    /// The elements of the body, those that are not halved.
    pub fn surface(&self) -> &Surface {
        &self.surface
    }

    /// Displacement and stress that they add at a place (m); `None` outside of the body.
    pub fn at(&self, place: [f64; 3]) -> Option<Response> {
        self.field.at(place.into())
    }

    /// The stress (Pa) that they add there; no numbers outside of the body.
    pub fn stress(&self, place: [f64; 3]) -> Components {
        self.at(place).map_or([f64::NAN; 6], |own| components(own.stress))
    }

    /// How far the stress at a place (m) may be off, measured by `of`, without bound where that is not known: by what elements miss, and at most
    /// of the ends of its ways by what moving the body changes.
    pub fn missed(&self, place: [f64; 3], of: impl Fn(Components) -> f64) -> f64 {
        let place = DVec3::from(place);
        let Some(own) = self.field.at(place) else { return f64::INFINITY };
        let rough = match (&self.coarse, &self.field) {
            (Some(coarse), _) => coarse.at(place).map(|coarse| coarse.stress),
            (None, Inside::Volume(inside)) => inside.by_itself(place),
            (None, Inside::Surface(_)) => None,
        };
        let elements = rough.map_or(f64::INFINITY, |rough| of(components(rough - own.stress)));
        let middle = match &self.coarse {
            Some(coarse) => coarse.at(place).map(|coarse| coarse.stress),
            None => Some(own.stress),
        };
        let moved = self.moved.iter().map(|(offset, there)| {
            let change = there.at(place + *offset).zip(middle);
            change.map_or(f64::INFINITY, |(there, middle)| of(components(there.stress - middle)))
        });
        moved.fold(0.0, f64::max) + elements
    }

    /// The stresses (Pa) that they add at a depth (m), on a grid of columns and rows within the frame (m): of polynomials through Gauss
    /// points, as these fields are smooth below a contact. `None` where the depth leaves the body.
    pub fn plane(&self, depth: f64, [columns, rows]: [&[f64]; 2]) -> Option<[Vec<f64>; 6]> {
        let count = MOST_DEGREES + 1;
        let polynomials = Polynomials::new(self.frame, MOST_DEGREES);
        let axes = [0, 1].map(|axis| {
            let half = 0.5 * self.frame.size[axis];
            let point = |(x, weight): (f64, f64)| {
                let place = self.frame.centre[axis] + half * x;
                (place, half * weight, polynomials.along(axis, place))
            };
            gauss_legendre(count).into_iter().map(point).collect::<Vec<_>>()
        });
        let [x, y] = &axes;
        let found: Vec<Option<Response>> = (0..count * count)
            .into_par_iter()
            .map(|at| self.at([x[at % count].0, y[at / count].0, -depth]))
            .collect();
        let mut sums = vec![[0.0; 6]; count * count];
        for (at, found) in found.into_iter().enumerate() {
            let stress = components(found?.stress);
            let ((_, along, of_x), (_, across, of_y)) = (&x[at % count], &y[at / count]);
            for (index, sum) in sums.iter_mut().enumerate() {
                let share = along * across * of_x[index % count] * of_y[index / count];
                sum.iter_mut().zip(stress).for_each(|(sum, own)| *sum += share * own);
            }
        }
        let values = |axis: usize, places: &[f64]| -> Vec<Vec<f64>> {
            places.iter().map(|place| polynomials.along(axis, *place)).collect()
        };
        let (columns, rows) = (values(0, columns), values(1, rows));
        let component = |of: usize| -> Vec<f64> {
            let row = |row: &Vec<f64>| -> Vec<f64> {
                let of_x = |i: usize| (0..count).map(|j| row[j] * sums[i + count * j][of]).sum();
                let along: Vec<f64> = (0..count).map(of_x).collect();
                let at = |column: &Vec<f64>| along.iter().zip(column).map(|(a, b)| a * b).sum();
                columns.iter().map(at).collect()
            };
            rows.par_iter().flat_map_iter(row).collect()
        };
        Some([0, 1, 2, 3, 4, 5].map(component))
    }
}

/// How deep (m) a body is below all of a rectangle of its face: to the highest corner of elements off that face that reach below it.
fn depth_below(mesh: &Mesh, mirrored: [bool; 2], rectangle: &Rectangle) -> f64 {
    let near = SAME * mesh.extent();
    let depth = |face: usize| {
        let [low, high] = mesh.bounds([face]);
        let below = (0..2).all(|axis| {
            let [from, to] =
                [-0.5, 0.5].map(|share| rectangle.centre[axis] + share * rectangle.size[axis]);
            let meets = |from: f64, to: f64| low[axis] < to && high[axis] > from;
            meets(from, to) || mirrored[axis] && meets(-to, -from)
        });
        (below && low.z < -near).then_some(-high.z)
    };
    (0..mesh.faces.len()).filter_map(depth).fold(f64::INFINITY, f64::min)
}

/// Components in their order.
fn components(stress: DMat3) -> Components {
    let DMat3 { x_axis, y_axis, z_axis } = stress;
    [x_axis.x, y_axis.y, z_axis.z, y_axis.x, z_axis.x, z_axis.y]
}
