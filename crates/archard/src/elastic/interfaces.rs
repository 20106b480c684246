//! What crosses the interfaces of layers, and what each side of them bears along the surface: by this layers peel, spall and crack.

use super::PressedHalfSpace;
use super::maxima::{Layer, Maximum, Of};
use crate::compliance::half_space::inside::Below;
use crate::stress::{Components, along_surface, orthogonal_shear};

/// The largest stresses at an interface, tension positive.
#[derive(Debug, Clone, PartialEq)]
pub struct Interface {
    /// How deep it is (m).
    pub depth: f64,
    /// The largest stress zz across it (Pa), which opens it where it is tension.
    pub pull: Maximum,
    /// The least stress zz across it (Pa).
    pub press: Maximum,
    /// The largest shear along it (Pa).
    pub shear: Maximum,
    /// Above it.
    pub above: Side,
    /// Below it; `None` where rigid ground is.
    pub below: Option<Side>,
}

/// The largest and the least normal stress along the surface (Pa) at one side of an interface.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    /// The largest: tension where it is positive.
    pub most: Maximum,
    /// The least: pressure where it is negative.
    pub least: Maximum,
}

impl Side {
    /// What is sought, the least with its sign reversed.
    pub(super) const MEASURES: [Of; 2] =
        [|stress| along_surface(stress)[0], |stress| -along_surface(stress)[1]];

    /// With the sign of the least as it is.
    pub(super) fn signed([most, least]: [Option<Maximum>; 2]) -> [Option<Maximum>; 2] {
        [most, least.map(reversed)]
    }
}

fn reversed(found: Maximum) -> Maximum {
    Maximum { value: -found.value, ..found }
}

/// What is sought on both sides: along the surface, then across the interface.
pub(super) const SOUGHT: [Of; 5] = [
    Side::MEASURES[0],
    Side::MEASURES[1],
    |stress| stress[2],
    |stress| -stress[2],
    orthogonal_shear,
];

/// The largest at the interfaces, from where they are largest in planes at both sides of each in turn.
pub(super) fn interfaces(
    pressed: &PressedHalfSpace,
    levels: [&Below; 3],
    initial: &Components,
    layers: &[Layer],
) -> Vec<Interface> {
    let pieces = pressed.below.pieces();
    let climb = |from: &Layer, sought: usize| {
        let own = pressed.within(from.piece);
        let levels = levels.map(|below| below.within(from.piece));
        let [x, y] = from.faces[sought].1;
        let depths = [from.depth; 2];
        let of = (SOUGHT[sought], initial);
        own.below_surface(levels.each_ref(), of, [x, y, -from.depth], &depths)
    };
    let side = |from: &Layer| Side { most: climb(from, 0), least: reversed(climb(from, 1)) };
    let is_face = |own: &&Layer| {
        let [top, end] = pieces[own.piece];
        !own.faces.is_empty() && (own.depth == end || own.depth == top && top > 0.0)
    };
    let mut found: Vec<Interface> = vec![];
    for from in layers.iter().filter(is_face) {
        match found.last_mut().filter(|last| last.depth == from.depth) {
            Some(last) => last.below = Some(side(from)),
            None => found.push(Interface {
                depth: from.depth,
                pull: climb(from, 2),
                press: reversed(climb(from, 3)),
                shear: climb(from, 4),
                above: side(from),
                below: None,
            }),
        }
    }
    found
}
