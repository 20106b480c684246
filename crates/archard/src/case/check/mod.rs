//! What can be known of a case before it is run: closed forms, cost, and what is doubtful.

mod coarse;
mod contact;
mod creep;
mod cycles;
mod finite;
mod footprint;
mod forecast;
mod foreseen;
mod free;
mod geometry;
mod inside;
mod judge;
mod made;
mod meeting;
pub(super) mod memory;
mod partial_slip;
mod rolling;
mod shift;
pub(super) mod slender;
mod words;

pub use coarse::BesideHalfSpace;
pub use contact::{Contact, Worn};
pub use creep::{Creep, Track};
pub use cycles::Cycles;
pub use finite::Finiteness;
pub(super) use footprint::BYTES_A_PAIR;
pub use forecast::{Forecast, Solves};
pub use partial_slip::{Fretting, FrettingWear};

use super::definition::{BodyCase, Case};
use super::key::Key;
use super::problem::{Problem, Severity};
use crate::body::{Profile, contact_modulus, curvatures};
use crate::closed_form::free_rolling;
use crate::friction::Friction;
use crate::motion::{Motion, Schedule};
use crate::parameters::Invalid;
use crate::wear::WearLaw;
use made::Made;

/// The parts of a case, built.
struct Parts<'a> {
    case: &'a Case,
    profiles: [Box<dyn Profile>; 2],
    meshes: [Option<Made>; 2],
    wear: [Option<Box<dyn WearLaw>>; 2],
    friction: Option<Box<dyn Friction>>,
    motion: Motion,
    schedule: Schedule,
}

impl<'a> Parts<'a> {
    fn of(case: &'a Case) -> Result<Self, Invalid> {
        let [first, second] = &case.bodies;
        let wear = |body: &BodyCase| body.wear.as_ref().map(|wear| wear.build()).transpose();
        let made = |body: &BodyCase| body.finite.as_ref().map(Made::of).transpose();
        let (motion, schedule) = case.motion.build()?;
        Ok(Self {
            case,
            profiles: [first.profile.build()?, second.profile.build()?],
            meshes: [made(first)?, made(second)?],
            wear: [wear(first)?, wear(second)?],
            friction: case.friction.as_ref().map(|friction| friction.build()).transpose()?,
            motion,
            schedule,
        })
    }

    /// Contact modulus E* (Pa).
    fn contact_modulus(&self) -> f64 {
        contact_modulus(self.case.bodies.each_ref().map(|body| body.material.as_ref()))
    }

    /// Shear moduli (Pa), infinite for a rigid body, and Poisson ratios.
    fn elasticity(&self) -> ([f64; 2], [f64; 2]) {
        let materials = self.case.bodies.each_ref().map(|body| body.material);
        (
            materials.map(|material| material.map_or(f64::INFINITY, |one| one.shear_modulus())),
            materials.map(|material| material.map_or(0.0, |one| one.poisson)),
        )
    }

    /// Dundurs' constant beta; zero for bodies of one material.
    fn dundurs_beta(&self) -> f64 {
        let (moduli, poissons) = self.elasticity();
        free_rolling::dundurs_beta(moduli, poissons)
    }

    /// Curvatures of both bodies together along x and y (1/m), where both have them.
    fn curvatures(&self) -> Option<[f64; 2]> {
        let [first, second] = [self.curvatures_of(0)?, self.curvatures_of(1)?];
        Some([first[0] + second[0], first[1] + second[1]])
    }

    /// Curvatures of a body along x and y (1/m), where it has them: of its mesh and of the profile on it.
    fn curvatures_of(&self, body: usize) -> Option<[f64; 2]> {
        let mesh = self.meshes[body].as_ref().map(|made| made.curvatures);
        curvatures(&*self.profiles[body], mesh)
    }

    /// Whether the meshes, if there are any, are plane where the bodies touch.
    fn plane(&self) -> bool {
        self.meshes.iter().flatten().all(|made| made.curvatures == Some([0.0; 2]))
    }

    /// The number of pairs.
    fn pairs(&self) -> usize {
        let [nx, ny] = self.case.frame.elements;
        self.meshes.iter().flatten().next().map_or(nx * ny, |made| made.size.contact / 3)
    }

    /// The meshed body with the most unknowns.
    fn largest(&self) -> Option<&BodyCase> {
        let meshed = self.case.bodies.iter().zip(&self.meshes);
        let sized = meshed.filter_map(|(body, made)| Some((body, made.as_ref()?.size)));
        let largest = sized.max_by_key(|(_, size)| (size.unknowns, size.contact));
        largest.map(|(body, _)| body)
    }

    /// The meshed body that planes of symmetry halve, and which.
    fn halved(&self) -> Option<(&BodyCase, [bool; 2])> {
        let mut bodies = self.case.bodies.iter();
        bodies.find_map(|body| {
            let mirrored = body.finite.as_ref()?.mirrored;
            (mirrored != [false; 2]).then_some((body, mirrored))
        })
    }

    /// The key of the frame's `size` or `elements`; where a body is meshed, that of its zone.
    fn frame_key(&self, name: &str) -> Key {
        let host = self.case.bodies.iter().find(|body| body.finite.is_some());
        host.map_or_else(|| Key::of(["frame", name]), |body| self.zone_key(body, name))
    }

    /// The key of the `size` or `elements` of a body's zone; the zone itself where a file has it.
    fn zone_key(&self, body: &BodyCase, name: &str) -> Key {
        let key = Key::of(["body", &body.name, "mesh"]);
        let Some(finite) = &body.finite else { return key };
        let zone = key.child(finite.mesh.choice.name).child("contact");
        if finite.mesh.values.section("contact").is_some() { zone.child(name) } else { zone }
    }

    /// What the frame is called: the zone of a mesh is one too.
    fn frame_word(&self) -> &'static str {
        if self.case.is_meshed() { "zone" } else { "frame" }
    }

    /// Largest tangential traction in any direction over the pressure (Pa); zero without friction.
    fn friction_coefficient(&self, pressure: f64) -> f64 {
        self.friction
            .as_deref()
            .map_or(0.0, |friction| friction.map().largest() * friction.limit(pressure) / pressure)
    }

    /// Distance slid in the whole motion (m).
    fn slip(&self) -> f64 {
        self.motion.slip(self.schedule.extent)
    }
}

/// Memory (bytes) that a run of a case takes, an estimate.
pub(super) fn memory_of(case: &Case) -> Result<f64, Invalid> {
    Parts::of(case).map(|parts| footprint::memory(&parts, Contact::of(&parts).as_ref()))
}

/// The forecast of a case and what is wrong or doubtful with it.
pub(super) fn check(case: &Case) -> (Forecast, Vec<Problem>) {
    match Parts::of(case) {
        Ok(parts) => {
            let forecast = Forecast::of(&parts);
            let problems = problems(&parts, &forecast);
            (forecast, problems)
        }
        // A case that was read has been built once already.
        Err(invalid) => {
            let problem = Problem::error(Key::default(), invalid.message);
            (Forecast::default(), vec![problem])
        }
    }
}

/// What is wrong or doubtful; nothing else is worth checking where the bodies do not meet.
fn problems(parts: &Parts<'_>, forecast: &Forecast) -> Vec<Problem> {
    let mut problems: Vec<Problem> = memory::problems(parts, forecast.memory).into_iter().collect();
    if parts.case.is_meshed() {
        if problems.iter().all(|problem| problem.severity == Severity::Warning) {
            problems.extend(meeting::problems(parts));
            problems.extend(inside::problems(parts));
            problems.extend(slender::problems(parts));
        }
        if problems.iter().any(|problem| problem.severity == Severity::Error) {
            return problems;
        }
    }
    // The gaps of a frame that does not fit are not made.
    if problems.iter().any(|problem| problem.severity == Severity::Error) {
        return problems;
    }
    let geometry = geometry::problems(parts);
    if geometry.is_empty() {
        problems.extend(judge::problems(parts, forecast));
    }
    problems.extend(geometry);
    problems
}
