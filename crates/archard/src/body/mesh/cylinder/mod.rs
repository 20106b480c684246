//! A solid or hollow cylinder with plane ends.
//!
//! It touches with the side, its axis then lying along y, or with an end, its axis then standing
//! along z.

mod end;
mod side;

use std::f64::consts::PI;

use super::contact::{self, Layout};
use super::free::{self, SupportedSurfaces};
use super::{ContactMesh, MeshError, Shape};
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Shape>> = Choice {
    name: "cylinder",
    meaning: "a cylinder, hollow if it has a bore; its surfaces are side, bore and the ends: front and back, or top and bottom if it touches with the top",
    parameters: &[
        Parameter::required("radius", Quantity::Length, "radius of the side"),
        Parameter::required("length", Quantity::Length, "length from end to end"),
        Parameter::optional("bore", Quantity::Length, "radius of the bore; none: a solid cylinder"),
        contact::parameter(&[
            Parameter::required(
                "face",
                Quantity::Word(&["side", "top"]),
                "what touches: the side (axis along y) or the end at the top (axis along z)",
            ),
            contact::SIZE,
            contact::ELEMENTS,
            contact::GROWTH,
        ]),
        contact::DIVISIONS,
    ],
    build: |values| {
        let (radius, length) = (values.require("radius")?, values.require("length")?);
        let bore = values.number("bore");
        if let Some(bore) = bore
            && bore >= radius
        {
            let message = format!("must be less than the radius of {radius} m");
            return Err(Invalid::new("bore", message));
        }
        let face = values.section("contact").and_then(|contact| contact.word("face"));
        if face != Some("top") {
            let layout = Layout::read(values, [PI * radius, length])?;
            let layout = layout.around(free::BESIDE_WALL * (1.0 - bore.unwrap_or(0.0) / radius))?;
            return Ok(Box::new(Lying { radius, length, bore, layout }));
        }
        if bore.is_some() {
            let message = "a cylinder with a bore has no material in the middle of its top: let it touch with its \"side\", or leave out `bore`";
            return Err(Invalid::new("contact.face", message));
        }
        let layout = Layout::read(values, [2.0 * radius; 2])?;
        let Layout::Contact(contact) = layout else {
            return Err(Invalid::new("contact", "is missing"));
        };
        let diagonal = contact.size[0].hypot(contact.size[1]);
        if diagonal > 1.9 * radius {
            let message = format!(
                "the corners of the zone lie {} m from the axis, too close to the edge at {radius} m: take a smaller zone",
                0.5 * diagonal
            );
            return Err(Invalid::new("contact.size", message));
        }
        Ok(Box::new(Standing { radius, length, contact }))
    },
};

/// A cylinder with its axis along y, its highest line through the origin.
#[derive(Debug)]
struct Lying {
    /// Radius (m).
    radius: f64,
    /// Length (m).
    length: f64,
    /// Radius of the bore (m).
    bore: Option<f64>,
    layout: Layout,
}

/// A cylinder with its axis along z, its top centred on the origin.
#[derive(Debug)]
struct Standing {
    /// Radius (m).
    radius: f64,
    /// Length (m).
    length: f64,
    contact: contact::Contact,
}

impl Shape for Lying {
    fn mesh(
        &self,
        mirrored: [bool; 2],
        held: &SupportedSurfaces,
    ) -> Result<ContactMesh, MeshError> {
        self.layout.check(mirrored)?;
        Ok(self.divide(mirrored, self.longest(held)))
    }

    fn at_least(&self, mirrored: [bool; 2], held: &SupportedSurfaces) -> usize {
        let [around, along] =
            self.axes(mirrored, self.longest(held)).map(|axis| axis.places.len() - 1);
        around * along
    }

    fn slenderness(
        &self,
        _: &ContactMesh,
        mirrored: [bool; 2],
        held: &SupportedSurfaces,
    ) -> Option<f64> {
        let longest = self.longest(held);
        let [_, along] = self.axes(mirrored, longest);
        longest.is_finite().then(|| along.widest() / (2.0 * self.radius))
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some([1.0 / self.radius, 0.0])
    }
}

impl Shape for Standing {
    fn mesh(
        &self,
        mirrored: [bool; 2],
        held: &SupportedSurfaces,
    ) -> Result<ContactMesh, MeshError> {
        Layout::Contact(self.contact).check(mirrored)?;
        Ok(self.divide(mirrored, self.longest(held)))
    }

    fn at_least(&self, mirrored: [bool; 2], _held: &SupportedSurfaces) -> usize {
        self.contact.kept(mirrored).into_iter().product()
    }

    /// That of the generator itself, which no parameter overrules.
    fn slenderness(&self, _: &ContactMesh, _: [bool; 2], _: &SupportedSurfaces) -> Option<f64> {
        None
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some([0.0; 2])
    }
}

impl Lying {
    /// The longest element (m) along the axis that bending as a beam between its ends allows.
    fn longest(&self, held: &SupportedSurfaces) -> f64 {
        let diameter = 2.0 * self.radius;
        let across = ["side", "bore"].iter().any(|surface| held.at(surface));
        let ends = ["front", "back"].iter().any(|surface| held.at(surface));
        let bends = !across && ends && free::bends(diameter, self.length);
        let longest = if bends { free::longest(diameter) } else { f64::INFINITY };
        longest.max(free::LEAST * self.length)
    }
}

impl Standing {
    /// The longest elements (m) that bending allows: across the ends of a plate that is held at its edge, and
    /// along a pillar that is held underneath.
    fn longest(&self, held: &SupportedSurfaces) -> [f64; 2] {
        let (diameter, ends) = (2.0 * self.radius, held.at("bottom") || held.at("top"));
        let plate = !ends && held.at("side") && free::bends(self.length, self.radius);
        let pillar = ends && !held.at("side") && free::bends(diameter, self.length);
        let longest = |bends: bool, thickness: f64, size: f64| {
            if bends { free::longest(thickness).max(free::LEAST * size) } else { f64::INFINITY }
        };
        [longest(plate, self.length, diameter), longest(pillar, diameter, self.length)]
    }
}
