//! What the tractions of a contact make of the inside of a half-space.

use glam::DVec3;

use super::{ElasticError, Point, Response, Sampled, Section};
use crate::body::Body;
use crate::compliance::half_space::inside::Below;
use crate::frame::{ContactFrame, VectorField};
use crate::numerics::SAME;
use crate::stress::Components;

/// How deep below a side of the frame, relative to the distance from it, stresses are known where pressures go on beyond that side:
/// of an even pressure 1 % of the stress zz is missing there, and in the plane of the surface a third of the pressure at most.
const KNOWN: f64 = 0.25;

/// A half-space under the tractions of a contact.
///
/// Its axes are those of the body: x and y of the frame, z = 0 on the surface and negative in the body, for body 1 and for body 2.
#[derive(Debug)]
pub struct Pressed {
    /// The stresses below its elements.
    pub below: Below,
    /// The sides that pressures are cut at, along x and y the lower and the upper (m); infinitely far away where they are not.
    sides: [[f64; 2]; 2],
    /// How deep (m) there is rigid ground.
    pub(super) ground: f64,
}

impl Pressed {
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
        if body.has_image() {
            return Some(
                "has an image field, whose stresses are not computed: take `elasticity = \"boundary_elements\"`",
            );
        }
        let meshed = |body: &Body| body.finite.is_some() && !body.has_image();
        meshed(bodies[1 - which]).then_some(
            "is a half-space opposite a mesh, whose nodes are no frame: stresses in it are not computed",
        )
    }

    /// A body in contact, under tractions of the pairs (Pa) on body 1; `which` is its index, 0 or 1. `None` where it is no
    /// half-space under a uniform frame.
    pub fn in_contact(
        bodies: [&Body; 2],
        which: usize,
        frame: &ContactFrame,
        tractions: &VectorField,
    ) -> Option<Self> {
        if Self::refuses(bodies, which).is_some() {
            return None;
        }
        // What friction does to body 1 it does to body 2 the other way; pressures press both.
        let turned = |own: &[f64]| own.iter().map(|t| if which == 0 { *t } else { -t }).collect();
        let [t1, t2] = [&tractions.t1, &tractions.t2].map(|own| turned(own));
        let own = VectorField { t1, t2, n: tractions.n.clone() };
        let depth = Body::depths(bodies, frame.size()[0])[which];
        let body = bodies[which];
        let below = Below::new(body.uppermost()?, frame, &own, depth)?;
        let below = below.layered(&body.layers, body.material.as_ref());
        let ground = if body.material.is_some() { f64::INFINITY } else { body.coated() };
        let mut sides = cut(frame, below.pressure());
        if !body.layers.is_empty() && sides.as_flattened().iter().any(|side| side.is_finite()) {
            // Layers carry stresses of pressures beyond the frame farther than a half-space does.
            sides = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        }
        Some(Self { below, sides, ground })
    }

    /// The same where tractions repeat themselves with the frame, whose elements are an even number or one along each axis: nothing is cut.
    #[must_use]
    pub fn repeated(self) -> Self {
        let far = [f64::NEG_INFINITY, f64::INFINITY];
        Self { sides: [far; 2], below: self.below.repeated(), ..self }
    }

    /// The same in one of its layers, or below all of them: see [`Below::within`].
    pub(super) fn within(&self, piece: usize) -> Self {
        Self { below: self.below.within(piece), ..*self }
    }

    /// Displacement and stress at a place (m); `None` above the surface, and where the stress depends on pressures beyond the
    /// frame.
    pub fn at(&self, place: [f64; 3]) -> Option<Response> {
        (place[2] <= 0.0 && self.knows(place)).then(|| Response {
            displacement: self.below.displacement(place),
            stress: tensor(self.below.stress(place)),
        })
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
        let at = |point: &Point| {
            let wrong = || match point.place[2] > 0.0 {
                true => ElasticError::Outside { point: point.clone() },
                false if !self.is_solid(point.place) => {
                    ElasticError::Ground { point: point.clone() }
                }
                false => ElasticError::Cut { point: point.clone() },
            };
            self.at(point.place).ok_or_else(wrong)
        };
        points.iter().map(at).collect()
    }

    /// The same with the points: of one on an interface of layers both what is above and, as a point of its own, what is below.
    ///
    /// # Errors
    /// As [`Pressed::points`].
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

    /// Displacement and stress on a section; places where they are not known are left out.
    pub fn section(&self, section: &Section) -> Sampled {
        section.responses(None, |place: DVec3| self.at(section.below_zero(place)?.to_array()))
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
        known.min(self.ground)
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

    /// Whether the stress at a place (m) depends on the pressures of the frame alone.
    pub(super) fn knows(&self, place: [f64; 3]) -> bool {
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
