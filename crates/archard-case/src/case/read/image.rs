//! Whether a body of finite shape is taken as a half-space with an image field, where a case does not say.
//!
//! An image field takes a flat face, and loads on it alone. It is worth its polynomials where they are fewer than the pairs of the
//! zone, and its equations where they take less than those of a mesh whose nodes are the pairs. Polynomials have to be the more, the
//! nearer the edges lie (`bem::image::degree`), and so do elements: near an edge the mesh wins.

use archard::body::Elasticity;
use archard::compliance::bem::{Size, image};
use archard::frame::Rectangle;

use crate::case::definition::{BodyCase, FrameCase};
use crate::case::finite::{FiniteCase, NO_IMAGE};
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::case::reader::Reader;

/// The same body with what says how it deforms, and why; on a frame of its own if there is one.
pub(super) fn chosen(finite: FiniteCase, framed: bool) -> FiniteCase {
    let with = FiniteCase { elasticity: Elasticity::Image, why: Some(FLAT), ..finite.clone() };
    match against(&finite, &with, framed) {
        None => with,
        why => FiniteCase { why, ..finite },
    }
}

const FLAT: &str = "it touches with a flat face, away from its edges";

/// What speaks against an image field.
fn against(finite: &FiniteCase, with: &FiniteCase, framed: bool) -> Option<&'static str> {
    let Ok(coarse) = with.meshed() else {
        return Some(match finite.mesh.values.get("path") {
            Some(_) if finite.mirrored != [false; 2] => "its file holds a part of the body",
            Some(_) => {
                "its file has no tetrahedra alone, or no flat face along z that nothing holds"
            }
            None => "its zone lies on no flat face that reaches beyond it",
        });
    };
    if finite
        .supports
        .iter()
        .any(|(surface, support)| finite.touches_with(surface) || support.loads())
    {
        return Some("something else than the contact loads it, or holds the face that touches");
    }
    let Some((size, pairs)) = finite.zone().filter(|_| !framed) else {
        return (!framed || finite.zone().is_some()).then_some("its mesh says where it touches");
    };
    if coarse.volume.is_some() {
        return None;
    }
    let degree = image::degree(&coarse.mesh, [false; 2], &Rectangle::from(size), image::MISSED);
    let polynomials = degree.map_or(usize::MAX, |degree| (degree + 1) * (degree + 2) / 2);
    if polynomials > pairs[0] * pairs[1] {
        return Some("an edge is too near to its zone, or the zone has too few pairs");
    }
    let shape = finite.mesh.build().ok()?;
    let dense =
        Size::at_least(shape.at_least(finite.mirrored, &finite.held()), finite.interpolation);
    // The coarse mesh is halved once.
    let unknowns = 4 * Size::of(&coarse, finite.interpolation).unknowns;
    let fine = Size { unknowns, ..Size::default() };
    let less = "a mesh around so few elements takes less than an image field";
    (fine.operations() > dense.operations()).then_some(less)
}

impl Reader<'_> {
    /// Image fields, where both bodies go with them: one that is meshed where it touches takes that from the other.
    pub(super) fn images(&mut self, mut bodies: [BodyCase; 2]) -> Option<[BodyCase; 2]> {
        for body in bodies.iter().filter(|body| body.has_image()) {
            let supports = body
                .finite
                .iter()
                .flat_map(|finite| finite.supports.iter().map(move |support| (finite, support)));
            for (finite, (surface, support)) in supports {
                if support.loads() || finite.touches_with(surface) {
                    let message = "an image field is that of loads on the contact alone: leave this out, or give \
                                   `elasticity = \"boundary_elements\"`";
                    self.push(Problem::error(
                        Key::of(["body", &body.name, "supports", surface]),
                        message,
                    ));
                }
            }
        }
        let meshed = bodies.iter().any(BodyCase::is_meshed);
        for body in bodies.iter_mut().filter(|body| meshed && body.has_image()) {
            let Some(finite) = &mut body.finite else { continue };
            if finite.why.is_none() {
                let message = "an image field takes a half-space, a rigid body or another image field opposite, and the other body is meshed where it touches";
                let key = Key::of(["body", &body.name, "elasticity"]);
                self.push(Problem::error(key, message));
                return None;
            }
            finite.elasticity = Elasticity::BoundaryElements;
            finite.why = Some("the other body is meshed where it touches");
        }
        Some(bodies)
    }

    /// Whether a frame lies on the faces of bodies with image fields, and is their zone where both are given.
    pub(super) fn is_the_zone(
        &mut self,
        bodies: Option<&[BodyCase; 2]>,
        frame: &FrameCase,
    ) -> bool {
        let framed = self.framed;
        let images = bodies.into_iter().flatten().filter(|body| framed && body.has_image());
        for body in images {
            if body.finite.as_ref().is_some_and(|finite| finite.build(frame).is_err()) {
                self.push(Problem::error(Key::of(["frame", "size"]), NO_IMAGE));
                return false;
            }
            let zone = body.finite.as_ref().and_then(FiniteCase::zone);
            if zone.is_some_and(|(size, elements)| {
                (size, elements) != (frame.size, frame.elements) || frame.centre != [0.0; 2]
            }) {
                let message = "says where the bodies touch, and so does `frame`: give one of both";
                let mesh = Key::of(["body", &body.name, "mesh", "box", "contact"]);
                self.push(Problem::error(mesh, message).at_name());
                return false;
            }
        }
        true
    }
}
