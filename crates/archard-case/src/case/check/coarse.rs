//! What a half-space in the place of a meshed body would change, from a coarse mesh of the body.
//!
//! A body and a half-space under the same tractions differ by a smooth displacement, which a coarse mesh is
//! enough for. Here the tractions are a uniform pressure on the zone, and the mean over the zone is taken.

use std::fmt::{self, Display, Formatter};

use super::Parts;
use crate::case::chosen::ChosenPart;
use crate::case::definition::{BodyCase, BuildError, Case, FrameCase};
use crate::case::finite::FiniteCase;
use archard::body::mesh::Shape;
use archard::body::profile::PROFILES;
use archard::body::{Body, Elasticity, Interpolation};
use archard::compliance::bem::contact;
use archard::parameters::{Value, Values};
use archard::simulation;

/// Elements of the coarse zone along x and y, an even number for planes of symmetry.
const ELEMENTS: f64 = 2.0;
/// Ratio of neighbours away from it.
const GROWTH: f64 = 3.0;
/// Relative error of the integrals.
const TOLERANCE: f64 = 1e-3;

/// What a half-space in the place of a meshed body would change.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct BesideHalfSpace {
    /// The body.
    pub body: String,
    /// By how much more a half-space approaches under the load, relative to its approach after Hertz; negative
    /// where the body gives way more.
    pub share: f64,
}

impl Display for BesideHalfSpace {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let more = if self.share < 0.0 { "less" } else { "more" };
        let share = 100.0 * self.share.abs();
        let body = &self.body;
        writeln!(f, "half-space        in place of `{body}`: about {share:.1} % {more} approach")
    }
}

impl Case {
    /// What half-spaces in the place of meshed bodies would change; empty where no closed form gives the load and
    /// the approach. A mesh from a file cannot be made coarser and is left out.
    pub fn beside_half_spaces(&self) -> Vec<BesideHalfSpace> {
        let contact =
            Parts::of(self).ok().and_then(|parts| parts.subject().contact(parts.schedule.control));
        let Some((contact, approach)) = contact.and_then(|one| Some((one, one.approach?))) else {
            return vec![];
        };
        let found = self.bodies.iter().filter_map(|body| {
            let given = compliance(body, Elasticity::BoundaryElements)?;
            let half_space = compliance(body, Elasticity::HalfSpace)?;
            let share = (half_space - given) * contact.load / approach;
            Some(BesideHalfSpace { body: body.name.clone(), share })
        });
        found.collect()
    }
}

/// Mean displacement (m/N) of the zone of a body, meshed coarsely, for the force of a uniform pressure on it.
fn compliance(body: &BodyCase, elasticity: Elasticity) -> Option<f64> {
    let finite = body.finite.as_ref()?;
    let coarse = FiniteCase {
        mesh: coarse(finite)?,
        elasticity,
        interpolation: Interpolation::Discontinuous,
        tolerance: TOLERANCE,
        ..finite.clone()
    };
    let body = BodyCase {
        name: body.name.clone(),
        material: body.material.clone(),
        layers: vec![],
        profile: ChosenPart::named("flat", PROFILES)?,
        finite: Some(coarse),
        wear: None,
        depth: None,
        density: None,
        hardness: None,
        thermal: None,
    };
    mean(&body).ok()
}

fn mean(body: &BodyCase) -> Result<f64, BuildError> {
    let profile = body.profile.build()?;
    let body = body.build(&FrameCase::to_be_chosen())?;
    let rigid = Body {
        name: String::new(),
        profile: profile.into(),
        material: None,
        layers: vec![],
        finite: None,
        wear: None,
        depth: None,
        density: None,
        hardness: None,
        indentation_hardness: None,
        thermal: None,
    };
    let contact = contact::Contact::new([&body, &rigid], &contact::condense)
        .map_err(simulation::Refusals::from)?;
    let areas: Vec<f64> = (0..contact.frame.len()).map(|pair| contact.frame.area(pair)).collect();
    let (pressure, mut displacement) = (vec![1.0; areas.len()], vec![0.0; areas.len()]);
    contact.compliance.apply_normal(&pressure, &mut displacement);
    let area: f64 = areas.iter().sum();
    let volume: f64 = areas.iter().zip(&displacement).map(|(area, one)| area * one).sum();
    Ok(volume / (area * area))
}

/// The mesh with few elements; `None` where that cannot be.
fn coarse(finite: &FiniteCase) -> Option<ChosenPart<Box<dyn Shape>>> {
    let mut mesh = finite.mesh.clone();
    let mut contact: Values = mesh.values.section("contact")?.clone();
    contact.pair("elements")?;
    contact.insert("elements", Value::Pair([ELEMENTS; 2]));
    contact.insert("growth", Value::Number(GROWTH));
    mesh.values.insert("contact", Value::Section(contact));
    Some(mesh)
}
