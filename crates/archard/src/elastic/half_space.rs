//! What the tractions of a contact make of the inside of a half-space, or of a body with an image field.

use std::array;
use std::sync::Arc;

use glam::DVec3;
use rayon::prelude::*;

use super::maxima::Of;
use super::{ElasticError, Point, Response, Section, SectionResponse, von_mises};
use crate::body::Body;
use crate::compliance::Ends;
use crate::compliance::half_space::inside::Below;
use crate::frame::{ContactFrame, Rectangle, VectorField};
use crate::numerics::SAME;
use crate::stress::Components;

/// How deep below a side of the frame, relative to the distance from it, stresses are known where pressures go on beyond that side:
/// of an even pressure 1 % of the stress zz is missing there, and in the plane of the surface a third of the pressure at most.
const KNOWN: f64 = 0.25;

/// A half-space under the tractions of a contact.
///
/// Its axes are those of the body: x and y of the frame, z = 0 on the surface and negative in the body, for body 1 and for body 2.
#[derive(Debug)]
pub struct PressedHalfSpace {
    /// The stresses below its elements.
    pub below: Below,
    /// The sides that pressures are cut at, along x and y the lower and the upper (m); infinitely far away where they are not.
    sides: [[f64; 2]; 2],
    /// How deep (m) there is rigid ground.
    pub(super) ground: f64,
    /// What the ends of the body add, where it has an image field.
    pub(super) ends: Option<Arc<Ends>>,
}

impl PressedHalfSpace {
    /// Why stresses inside a body cannot be had from the tractions of a frame alone; `None` where they can.
    pub fn refuses(bodies: [&Body; 2], which: usize) -> Option<&'static str> {
        let body = bodies[which];
        if body.uppermost().is_none() {
            return Some("is rigid and has no stress");
        }
        if bodies.iter().all(|body| body.profile.fitted().is_some()) {
            return Some("is round as the other body is, so that its stresses are not computed");
        }
        if body.finite.as_ref().is_some_and(|_| !body.has_image()) {
            return Some(
                "has a mesh that is not asked how it deforms: `elasticity = \"boundary_elements\"` is",
            );
        }
        if body.has_image() && !body.layers.is_empty() {
            return Some(
                "has layers on a body of finite shape, whose stresses are not computed: leave one of both out",
            );
        }
        let meshed = |body: &Body| body.finite.is_some() && !body.has_image();
        meshed(bodies[1 - which]).then_some(
            "is a half-space opposite a mesh, whose nodes are no frame: stresses in it are not computed",
        )
    }

    /// A half-space in contact, under tractions of the pairs (Pa) on body 1; `which` is its index, 0 or 1. `None` where it is no
    /// half-space under a uniform frame, and of strips.
    pub fn in_contact(
        bodies: [&Body; 2],
        which: usize,
        frame: &ContactFrame,
        tractions: &VectorField,
    ) -> Option<Self> {
        let image = bodies[which].has_image();
        if image { None } else { Self::below(bodies, which, frame, &on_body(which, tractions)) }
    }

    /// The same of a body that may have an image field, and is moved under the contact by offsets (m).
    ///
    /// # Errors
    /// If the equations of the image field have no solution.
    pub fn with_ends(
        bodies: [&Body; 2],
        (which, offsets): (usize, [Rectangle; 2]),
        frame: &ContactFrame,
        tractions: &VectorField,
    ) -> Result<Option<Self>, ElasticError> {
        let own = on_body(which, tractions);
        let Some(pressed) = Self::below(bodies, which, frame, &own) else { return Ok(None) };
        let ends = Ends::new(bodies, (which, offsets), frame, &own)?.map(Arc::new);
        Ok(Some(Self { ends, ..pressed }))
    }

    /// A half-space, whether its body ends somewhere or not, under tractions (Pa) on it.
    fn below(
        bodies: [&Body; 2],
        which: usize,
        frame: &ContactFrame,
        own: &VectorField,
    ) -> Option<Self> {
        // Strips are lines of their own.
        let strips = frame.is_line() && frame.elements()[1] > 1;
        if strips || Self::refuses(bodies, which).is_some() {
            return None;
        }
        let depth = Body::depths(bodies, frame.size()[0])[which];
        let body = bodies[which];
        let below = Below::new(body.uppermost()?, frame, own, depth)?;
        let below = below.layered(&body.layers, body.material.as_ref());
        let ground = if body.material.is_some() { f64::INFINITY } else { body.coated() };
        let mut sides = cut(frame, below.pressure());
        if !body.layers.is_empty() && sides.as_flattened().iter().any(|side| side.is_finite()) {
            // Layers carry stresses of pressures beyond the frame farther than a half-space does.
            sides = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        }
        Some(Self { below, sides, ground, ends: None })
    }

    /// The same where tractions repeat themselves with the frame, whose elements are an even number or one along each axis: nothing is
    /// cut, and displacements are measured from so far (m) below the contact.
    #[must_use]
    pub fn repeated(self, depth: f64) -> Self {
        let far = [f64::NEG_INFINITY, f64::INFINITY];
        Self { sides: [far; 2], below: self.below.repeated(depth), ..self }
    }

    /// Whether elements of four times the size fill a frame that repeats itself, an even number or one along each axis: errors are found
    /// on these.
    pub fn halves(elements: [usize; 2]) -> bool {
        elements.iter().all(|count| *count == 1 || count.is_multiple_of(8))
    }

    /// Whether there are errors of what is below.
    pub(super) fn is_judged(&self) -> bool {
        !self.below.repeats() || Self::halves(self.below.elements())
    }

    /// The same in one of its layers, or below all of them: see [`Below::within`].
    pub(super) fn within(&self, piece: usize) -> Self {
        let Self { sides, ground, .. } = *self;
        Self { below: self.below.within(piece), ends: self.ends.clone(), sides, ground }
    }

    /// Displacement and stress at a place (m); `None` above the surface, outside of the body, and where the stress depends on
    /// pressures beyond the frame.
    pub fn at(&self, place: [f64; 3]) -> Option<Response> {
        self.at_all(&[place])[0]
    }

    /// The same at places (m), which costs less than place by place where those as deep follow each other.
    pub fn at_all(&self, places: &[[f64; 3]]) -> Vec<Option<Response>> {
        let known: Vec<usize> = (0..places.len())
            .filter(|own| places[*own][2] <= 0.0 && self.reaches(places[*own]))
            .collect();
        let inside: Vec<[f64; 3]> = known.iter().map(|own| places[*own]).collect();
        let fields = self.below.fields(&inside);
        let response = |(place, (displacement, stress)): (&[f64; 3], &([f64; 3], Components))| {
            let own = Response { displacement: *displacement, stress: tensor(*stress) };
            let Some(ends) = &self.ends else { return Some(own) };
            let added = Response::from(ends.at(*place)?);
            let Response { mut displacement, mut stress } = own;
            displacement.iter_mut().zip(added.displacement).for_each(|(own, added)| *own += added);
            let all = stress.as_flattened_mut().iter_mut().zip(added.stress.as_flattened());
            all.for_each(|(own, added)| *own += added);
            Some(Response { displacement, stress })
        };
        let found: Vec<Option<Response>> = inside.par_iter().zip(&fields).map(response).collect();
        let mut all = vec![None; places.len()];
        known.into_iter().zip(found).for_each(|(index, found)| all[index] = found);
        all
    }

    /// Displacement and stress below an interface of layers at a place (m), where [`at`](Self::at) has those above it; `None` where there
    /// is no interface.
    pub fn under(&self, place: [f64; 3]) -> Option<Response> {
        let pieces = self.below.pieces();
        let near = |[top, _]: &[f64; 2]| (place[2] + top).abs() <= SAME * top;
        let piece = (1..pieces.len()).find(|piece| near(&pieces[*piece]))?;
        self.within(piece).at(place)
    }

    /// Displacement and stress at points.
    ///
    /// # Errors
    /// If a point lies above the surface or in rigid ground, or its stress depends on pressures beyond the frame.
    pub fn points(&self, points: &[Point]) -> Result<Vec<Response>, ElasticError> {
        let places: Vec<[f64; 3]> = points.iter().map(|point| point.place).collect();
        let at = |(point, found): (&Point, Option<Response>)| {
            let wrong = || match point.place[2] > 0.0 {
                true => ElasticError::Outside { point: point.clone() },
                false if self.depth_of(point.place).is_none() => {
                    ElasticError::Outside { point: point.clone() }
                }
                false if !self.is_solid(point.place) => {
                    ElasticError::Ground { point: point.clone() }
                }
                false => ElasticError::Cut { point: point.clone() },
            };
            found.ok_or_else(wrong)
        };
        points.iter().zip(self.at_all(&places)).map(at).collect()
    }

    /// The same with the points: of one on an interface of layers both what is above and, as a point of its own, what is below.
    ///
    /// # Errors
    /// As [`PressedHalfSpace::points`].
    pub fn both_sides(
        &self,
        points: &[Point],
    ) -> Result<(Vec<Point>, Vec<Response>), ElasticError> {
        let found = self.points(points)?;
        let each = points.iter().zip(found).flat_map(|(point, found)| {
            let name = format!("{} (below the interface)", point.name);
            let under = self.under(point.place);
            let under = under.map(|found| (Point { name, ..point.clone() }, found));
            [(point.clone(), found)].into_iter().chain(under)
        });
        Ok(each.unzip())
    }

    /// How deep (m) a place (m) lies below the surface; `None` outside of a body that ends somewhere.
    pub fn depth_of(&self, place: [f64; 3]) -> Option<f64> {
        self.ends.as_ref().map_or(Some(-place[2]), |ends| ends.depth_of(place))
    }

    /// Displacement and stress on a section; places where they are not known are left out.
    pub fn section(&self, section: &Section) -> SectionResponse {
        let corners = self.ends.as_ref().map(|ends| ends.surface().corners());
        let at = |places: &[DVec3]| {
            let below = |place: &DVec3| section.below_zero(*place).map(|own| own.to_array());
            let places: Vec<Option<[f64; 3]>> = places.iter().map(below).collect();
            let inside: Vec<[f64; 3]> = places.iter().flatten().copied().collect();
            let mut found = self.at_all(&inside).into_iter();
            places.iter().map(|place| place.and_then(|_| found.next().flatten())).collect()
        };
        section.responses(corners.as_deref(), at)
    }

    /// The stresses (Pa) in a plane at a depth (m), with an even one added, in the order of [`Components`]: a value below the centre of
    /// each element, no number where it is not known.
    pub fn plane(&self, depth: f64, initial: &Components) -> [Vec<f64>; 6] {
        let mut plane = self.below.plane(depth);
        let ends = self.ends.as_ref().map(|ends| {
            let [nx, ny] = self.below.elements();
            let columns: Vec<f64> = (0..nx).map(|column| self.below.place(column)[0]).collect();
            let rows: Vec<f64> = (0..ny).map(|row| self.below.place(row * nx)[1]).collect();
            ends.plane(depth, [&columns, &rows])
        });
        for (component, field) in plane.iter_mut().enumerate() {
            for (element, value) in field.iter_mut().enumerate() {
                let [x, y] = self.below.place(element);
                *value += match &ends {
                    _ if !self.knows([x, y, -depth]) => f64::NAN,
                    Some(Some(ends)) => initial[component] + ends[component][element],
                    Some(None) => f64::NAN,
                    None => initial[component],
                };
            }
        }
        plane
    }

    /// What is added to the stress (Pa) of even elements at a place (m): an even one, and what the ends of the body add.
    pub(super) fn added(&self, initial: &Components, place: [f64; 3]) -> Components {
        let Some(ends) = &self.ends else { return *initial };
        let ends = ends.stress(place);
        array::from_fn(|own| initial[own] + ends[own])
    }

    /// How far a measure of stresses (Pa) at a place (m) may be off, as what the ends of the body add is. None of the measures grows by
    /// more than it is of a change.
    pub(super) fn ends_miss(&self, of: Of, place: [f64; 3]) -> f64 {
        let Some(ends) = &self.ends else { return 0.0 };
        ends.missed(place, |change| of(&change).max(of(&change.map(|own| -own))))
    }

    /// By how much the equivalent stress (Pa) is off at most at places (m), as what the ends of the body add is, and the largest there;
    /// `None` of a half-space, and where none of the places is known.
    pub fn missed(&self, places: &[[f64; 3]]) -> Option<[f64; 2]> {
        self.ends.as_ref()?;
        let known = places.par_iter().filter_map(|place| {
            let stress = von_mises(&self.at(*place)?.stress);
            Some([self.ends_miss(crate::stress::von_mises, *place), stress])
        });
        known.reduce_with(|one, other| [0, 1].map(|own| one[own].max(other[own])))
    }

    /// The largest pressure (Pa).
    pub fn peak(&self) -> f64 {
        self.below.pressure().iter().copied().fold(0.0, f64::max)
    }

    /// How deep (m) stresses are known below the centre of an element, where they are deepest.
    pub fn known_depth(&self) -> f64 {
        let depth = |element: usize| {
            let [x, y] = self.below.place(element);
            KNOWN * self.distance_to_sides([x, y, 0.0])
        };
        let known = (0..self.below.pressure().len()).map(depth).fold(0.0, f64::max);
        known.min(self.ground).min(self.bottom())
    }

    /// Complains about the first of these depths (m) that stresses are not known at.
    ///
    /// # Errors
    /// If there is one.
    pub fn check(&self, depths: &[f64]) -> Result<(), ElasticError> {
        let known = self.known_depth();
        if known == 0.0 {
            return Err(ElasticError::Reach);
        }
        let deep = depths.iter().copied().find(|depth| *depth > known);
        deep.map_or(Ok(()), |depth| Err(ElasticError::Deep { depth, known }))
    }

    /// How deep (m) the body is everywhere below the frame.
    fn bottom(&self) -> f64 {
        self.ends.as_ref().map_or(f64::INFINITY, |ends| ends.depth())
    }

    /// Whether the stress at a place (m) is known in all places of the frame as deep.
    pub(super) fn knows(&self, place: [f64; 3]) -> bool {
        self.reaches(place) && -place[2] <= self.bottom()
    }

    /// Whether the stress at a place (m) depends on the pressures of the frame alone.
    fn reaches(&self, place: [f64; 3]) -> bool {
        -place[2] <= KNOWN * self.distance_to_sides(place) && self.is_solid(place)
    }

    /// Whether a place (m) is not in rigid ground, by more than rounding.
    fn is_solid(&self, place: [f64; 3]) -> bool {
        -place[2] <= self.ground * (1.0 + SAME)
    }

    /// How far (m) a place is from the sides that pressures are cut at.
    fn distance_to_sides(&self, place: [f64; 3]) -> f64 {
        let each = (0..2).map(|axis| {
            let [low, high] = self.sides[axis];
            (place[axis] - low).min(high - place[axis])
        });
        each.fold(f64::INFINITY, f64::min)
    }
}

/// Tractions on a body, of those on body 1: what friction does to body 1 it does to body 2 the other way; pressures press both.
fn on_body(which: usize, tractions: &VectorField) -> VectorField {
    let turned = |own: &[f64]| own.iter().map(|t| if which == 0 { *t } else { -t }).collect();
    let [t1, t2] = [&tractions.t1, &tractions.t2].map(|own| turned(own));
    VectorField { t1, t2, n: tractions.n.clone() }
}

/// The sides of a frame that pressures are cut at.
fn cut(frame: &ContactFrame, pressure: &[f64]) -> [[f64; 2]; 2] {
    let (elements, corner, size) = (frame.elements(), frame.rectangle().corner(), frame.size());
    let open = !frame.measure().closed;
    let axes = if frame.is_line() { 1 } else { 2 };
    [0, 1].map(|axis| {
        let pressed = |index: usize| {
            let own = |pair: usize| [pair % elements[0], pair / elements[0]][axis];
            (0..pressure.len()).any(|pair| own(pair) == index && pressure[pair] > 0.0)
        };
        let ends = [(0, corner[axis]), (elements[axis] - 1, corner[axis] + size[axis])];
        let far = [f64::NEG_INFINITY, f64::INFINITY];
        [0, 1].map(|end| {
            let (index, place) = ends[end];
            if open && axis < axes && pressed(index) { place } else { far[end] }
        })
    })
}

/// Components as a matrix.
pub fn tensor([xx, yy, zz, xy, xz, yz]: Components) -> [[f64; 3]; 3] {
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}
