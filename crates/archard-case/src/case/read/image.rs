//! Whether a body of finite shape is taken as a half-space with an image field, where a case does not say.
//!
//! An image field takes a flat face, and loads on it alone. It is worth its polynomials where they are fewer than the elements of the
//! zone, and its equations where they take less than those of a mesh whose nodes are the pairs. Polynomials have to be the more, the
//! nearer the edges lie (`bem::image::degree`), and so do elements: near an edge the mesh wins.

use archard::body::Elasticity;
use archard::compliance::bem::{Size, image};
use archard::frame::Rectangle;

use crate::case::definition::{BodyCase, FiniteCase, FrameCase};
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::case::reader::{Reader, Section};
use crate::case::tree::Item;

/// The same body, with an image field if that does for its part; on a frame of its own if there is one.
pub(super) fn chosen(finite: FiniteCase, framed: bool) -> FiniteCase {
    let with = FiniteCase { elasticity: Elasticity::Image, ..finite.clone() };
    let suits = match finite.zone() {
        None => framed && with.meshed().is_ok(),
        Some(_) if framed => false,
        Some(zone) => pays(&finite, &with, zone).unwrap_or(false),
    };
    if suits && bears_no_load(&finite) { with } else { finite }
}

/// Whether nothing but the contact loads the body, and nothing holds the face that touches.
fn bears_no_load(finite: &FiniteCase) -> bool {
    finite.supports.iter().all(|(surface, support)| surface != "top" && !support.loads())
}

/// Whether an image field takes fewer polynomials than the zone has elements, and fewer operations than a mesh around the zone; `None`
/// where there is none.
fn pays(
    finite: &FiniteCase,
    with: &FiniteCase,
    (size, elements): ([f64; 2], [usize; 2]),
) -> Option<bool> {
    let coarse = with.meshed().ok()?;
    let degree = image::degree(&coarse.mesh, [false; 2], &Rectangle::from(size), image::MISSED)?;
    if (degree + 1) * (degree + 2) / 2 > elements[0] * elements[1] {
        return Some(false);
    }
    let shape = finite.mesh.build().ok()?;
    let dense =
        Size::at_least(shape.at_least(finite.mirrored, &finite.held()), finite.interpolation);
    let coarse = Size::of(&coarse, finite.interpolation).unknowns;
    // The coarse mesh is halved once.
    let fine = Size { unknowns: 4 * coarse, contact: 0 };
    Some(fine.operations() <= dense.operations())
}

impl Reader<'_> {
    /// Image fields, where both bodies go with them: one that is meshed where it touches takes that from the other.
    /// And where the case asks for stresses inside, which take a mesh around the zone.
    pub(super) fn images(
        &mut self,
        root: &Section<'_>,
        mut bodies: [BodyCase; 2],
    ) -> Option<[BodyCase; 2]> {
        let output = root.get("output").map(|(_, entry)| &entry.node.item);
        let asks = |name| matches!(output, Some(Item::Table(table)) if table.get(name).is_some());
        let inside = asks("points") || asks("sections");
        let meshed = inside || bodies.iter().any(BodyCase::is_meshed);
        for body in bodies.iter_mut().filter(|body| meshed && body.has_image()) {
            let Some(finite) = &mut body.finite else { continue };
            if finite.says && inside {
                continue;
            }
            if finite.says {
                let message = "an image field takes a half-space, a rigid body or another image field opposite, and the other body is meshed where it touches";
                let key = Key::of(["body", &body.name, "elasticity"]);
                self.push(Problem::error(key, message));
                return None;
            }
            finite.elasticity = Elasticity::BoundaryElements;
        }
        Some(bodies)
    }

    /// Whether a frame is the zone of a body with an image field, where both are given.
    pub(super) fn is_the_zone(
        &mut self,
        bodies: Option<&[BodyCase; 2]>,
        frame: &FrameCase,
    ) -> bool {
        let images = bodies.into_iter().flatten().filter(|body| body.has_image());
        for body in images {
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
