//! What can be known of a case before it is run: closed forms, cost, and what is doubtful.

mod coarse;
mod conforming;
mod cycles;
mod density;
mod equivalent;
mod expected;
mod finite;
pub(super) mod footprint;
mod forecast;
mod foreseen;
mod geometry;
mod heat;
mod inside;
mod judge;
mod line;
mod meeting;
pub(super) mod memory;
pub(super) mod pace;
mod periodic;
mod rolling;
pub(super) mod runtime;
mod shift;
pub(super) mod slender;
mod surfaces;
mod texture;
mod track;
mod warmed;
pub(super) mod within;
mod words;
mod yielding;

pub use crate::files::free_memory;
pub use coarse::BesideHalfSpace;
pub use cycles::Cycles;
pub use equivalent::Equivalent;
pub use finite::Finiteness;
pub use forecast::{Forecast, Solves};
pub use surfaces::Surfaces;
pub(super) use surfaces::settle;
pub use yielding::YieldLimit;

use super::chosen::ChosenPart;
use super::definition::{BodyCase, BuildError, Case};
use super::key::Key;
use super::problem::{Problem, Severity};
use archard::body::{Body, Elasticity, Finite};
use archard::compliance::bem::Size;
use archard::estimate::{Course, Estimate, Estimator, Subject};
use archard::friction::Friction;
use archard::motion::{Control, Lever, Motion, Schedule};
use archard::parameters::Values;
use archard::simulation::fitted::{Kind, fitted};
use archard::simulation::refusal::{self, Part, Refusal};

/// The parts of a case, built.
pub(super) struct Parts<'a> {
    case: &'a Case,
    pub(super) bodies: [Body; 2],
    pub(super) friction: Option<Box<dyn Friction>>,
    pub(super) motion: Motion,
    pub(super) schedule: Schedule,
}

impl<'a> Parts<'a> {
    pub(super) fn of(case: &'a Case) -> Result<Self, BuildError> {
        let [first, second] = &case.bodies;
        let (motion, schedule) = case.motion.build()?;
        let bodies = [first.build(&case.frame)?, second.build(&case.frame)?];
        let mut parts = Self {
            case,
            friction: case.friction.as_ref().map(ChosenPart::build).transpose()?,
            motion: motion.of_bodies(&bodies),
            bodies,
            schedule,
        };
        warmed::warm(&mut parts);
        Ok(parts)
    }

    /// What closed forms look at.
    pub(super) fn subject(&self) -> Subject<'_> {
        Subject {
            bodies: &self.bodies,
            size: self.case.frame.size,
            line: self.case.frame.line,
            closed: self.case.frame.periodic,
            friction: self.friction.as_deref(),
            motion: &self.motion,
        }
    }

    /// What closed forms expect once the motion has gone so far (its own unit).
    pub(super) fn estimate(&self, estimator: &Estimator, progress: f64) -> Estimate {
        let control = self.schedule.control;
        let load_distance = match control {
            Control::Load(load)
                if !matches!(self.motion.lever_arm(), Some(Lever::Radius | Lever::Turn)) =>
            {
                Some(load * self.motion.slip(progress))
            }
            _ => None,
        };
        estimator.of(&self.subject(), &Course { control, progress, load_distance })
    }

    /// Contact modulus E* (Pa).
    pub(super) fn contact_modulus(&self) -> f64 {
        self.subject().contact_modulus()
    }

    /// Whether bodies of one elasticity touch, which layers are not part of.
    fn alike(&self) -> bool {
        let layered = self.bodies.iter().any(|body| !body.layers.is_empty());
        !layered && self.subject().dundurs_beta() == 0.0
    }

    /// Whether any body wears.
    pub(super) fn wears(&self) -> bool {
        self.bodies.iter().any(|body| body.wear.is_some())
    }

    /// The bodies that are meshed, as written and as built.
    fn meshed(&self) -> impl Iterator<Item = (&BodyCase, &Finite)> {
        let bodies = self.case.bodies.iter().zip(&self.bodies);
        bodies.filter_map(|(case, body)| Some((case, body.finite.as_ref()?)))
    }

    /// Whether the meshes, if there are any, are plane where the bodies touch.
    fn plane(&self) -> bool {
        self.meshed().all(|(_, finite)| finite.curvatures == Some([0.0; 2]))
    }

    /// The number of pairs.
    fn pairs(&self) -> usize {
        let [nx, ny] = self.case.frame.elements;
        match self.meshed().next().filter(|_| self.case.is_meshed()) {
            Some((_, finite)) => size(finite).contact / 3,
            None => nx * ny,
        }
    }

    /// The meshed body with the most unknowns.
    fn largest(&self) -> Option<&BodyCase> {
        let meshed = self.meshed().filter(|_| self.case.is_meshed());
        let sized = meshed.map(|(body, finite)| (body, size(finite)));
        let largest = sized.max_by_key(|(_, size)| (size.unknowns, size.contact));
        largest.map(|(body, _)| body)
    }

    /// The meshed body that planes of symmetry halve, and which.
    fn halved(&self) -> Option<(&BodyCase, [bool; 2])> {
        let mut bodies = self.case.bodies.iter();
        bodies.find_map(|body| {
            let mirrored = body.finite.as_ref().filter(|_| body.is_meshed())?.mirrored;
            (mirrored != [false; 2]).then_some((body, mirrored))
        })
    }

    /// A refusal where it can be put right; `None` where that is said there anyhow.
    fn refused(&self, refusal: Refusal) -> Option<Problem> {
        let Refusal { part, what, help } = refusal;
        let (key, at_name) = match part {
            Part::Wear(body) => (Key::of(["body", &body, "wear"]), false),
            Part::Hardness(body) => (Key::of(["body", &body, "hardness"]), false),
            Part::Friction => {
                let law = self.case.friction.as_ref().map_or("", |law| law.choice.name);
                (Key::of(["friction", law]), true)
            }
            Part::Motion => (Key::of(["motion", self.case.motion.choice.name]), true),
            Part::Profile(body) => (Key::of(["body", &body, "profile"]), false),
            Part::Material(body) => (Key::of(["body", &body]), false),
            Part::Frame => (Key::of(["frame"]), false),
            Part::Share(_) | Part::Bodies | Part::Value(_) => return None,
        };
        let problem = Problem::error(key, what);
        let problem = if help.is_empty() { problem } else { problem.help(help) };
        Some(if at_name { problem.at_name() } else { problem })
    }

    /// The motion of these bodies, with what follows from their axes and shapes.
    pub(super) fn motion_of_bodies(&self) -> Motion {
        self.motion.clone().of_bodies(&self.bodies)
    }

    /// What does not fit bodies that fit into each other, and keeps them from being pressed together.
    pub(super) fn unfit(&self) -> Option<Problem> {
        let kind = Kind { line: self.case.frame.line, closed: self.case.frame.periodic };
        let refusal = fitted(&self.bodies, kind, self.friction.is_some(), &self.motion);
        refusal.and_then(|refusal| self.refused(refusal))
    }

    /// The key of the frame's `size` or `elements`; where a body is meshed, that of its zone.
    fn frame_key(&self, name: &str) -> Key {
        let zone = |body: &&BodyCase| {
            body.finite.as_ref().is_some_and(|finite| body.is_meshed() || finite.zone().is_some())
        };
        let host = self.case.bodies.iter().find(zone);
        host.map_or_else(|| Key::of(["frame", name]), |body| self.zone_key(body, name))
    }

    /// The key of the `size` or `elements` of a body's zone; the zone itself where a file has it.
    fn zone_key(&self, body: &BodyCase, name: &str) -> Key {
        let key = Key::of(["body", &body.name, "mesh"]);
        let Some(finite) = &body.finite else { return key };
        let zone = key.child(finite.mesh.choice.name).child("contact");
        let has = |section: &Values| section.get(name).is_some();
        if finite.mesh.values.section("contact").is_some_and(has) { zone.child(name) } else { zone }
    }

    /// Whether the zone of the pairs is one of a file, which has places and no size of its own.
    fn zone_of_a_file(&self) -> bool {
        self.meshed().next().is_some_and(|(_, finite)| finite.meshed.placed)
    }

    /// What the frame is called: the zone of a mesh is one too.
    fn frame_word(&self) -> &'static str {
        if self.has_a_zone() { "zone" } else { "frame" }
    }

    /// Whether the frame is the zone of a mesh.
    fn has_a_zone(&self) -> bool {
        let zone = |body: &BodyCase| body.finite.as_ref().is_some_and(|one| one.zone().is_some());
        self.case.is_meshed() || self.case.bodies.iter().any(zone)
    }

    /// Whether the frame grows with the contact.
    fn grows(&self) -> bool {
        !self.case.is_meshed() && !self.case.frame.periodic
    }

    /// Distance slid in the whole motion (m).
    fn slip(&self) -> f64 {
        self.motion.slip(self.schedule.extent)
    }
}

/// The size of the equations of a meshed body; a half-space in its place has no unknowns.
fn size(finite: &Finite) -> Size {
    let size = Size::of(&finite.meshed, finite.interpolation);
    match finite.elasticity {
        Elasticity::BoundaryElements => size,
        Elasticity::FiniteElements => {
            Size { contact: size.contact, ..Size::inside(&finite.meshed).unwrap_or(size) }
        }
        Elasticity::Reduced => match &finite.meshed.reduced {
            // A matrix of many rows has few values in each.
            Some(matrix) => Size {
                unknowns: matrix.size(),
                contact: size.contact,
                sparse: matrix.entries.len() < matrix.size() * matrix.size() / 4,
            },
            None => size,
        },
        // The last of its meshes has four times as many elements.
        Elasticity::Image => Size::inside(&finite.meshed).unwrap_or(Size {
            unknowns: 4 * size.unknowns,
            contact: 0,
            sparse: false,
        }),
        Elasticity::HalfSpace => Size { unknowns: 0, ..size },
    }
}

impl Case {
    /// What closed forms expect at these places of the motion (its own unit), under the load or approach of its end.
    pub fn estimates(&self, progress: impl Iterator<Item = f64>) -> Vec<Estimate> {
        let estimator = Estimator::default();
        let parts = Parts::of(self).ok();
        let at =
            |parts: Parts<'_>| progress.map(|place| parts.estimate(&estimator, place)).collect();
        parts.map_or(vec![], at)
    }
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
        Err(error) => {
            let problem = Problem::error(Key::default(), error.to_string());
            (Forecast::default(), vec![problem])
        }
    }
}

/// What is wrong or doubtful; nothing else is worth checking where the bodies do not meet.
fn problems(parts: &Parts<'_>, forecast: &Forecast) -> Vec<Problem> {
    let sound = |problems: &[Problem]| problems.iter().all(|one| one.severity == Severity::Warning);
    let mut problems: Vec<Problem> = memory::problems(parts, forecast.memory).into_iter().collect();
    if parts.case.is_meshed() && sound(&problems) {
        problems.extend(meeting::problems(parts));
        problems.extend(slender::problems(parts));
    }
    if sound(&problems) {
        problems.extend(inside::problems(parts));
    }
    problems.extend(meeting::of_images(parts));
    problems.extend(surfaces::too_long(parts));
    let (uniform, periodic) = (!parts.case.is_meshed(), parts.case.frame.periodic);
    let of_frame = refusal::of_frame(&parts.motion, uniform, periodic);
    problems.extend(of_frame.and_then(|refusal| parts.refused(refusal)));
    let roaming = refusal::roaming(&parts.bodies, &parts.motion);
    problems.extend(roaming.and_then(|refusal| parts.refused(refusal)));
    problems.extend(parts.unfit());
    // The gaps of a frame that does not fit are not made.
    if !sound(&problems) {
        return problems;
    }
    let mut geometry = line::problems(parts);
    geometry.extend(periodic::problem(parts));
    if geometry.is_empty() {
        geometry = geometry::problems(parts);
    }
    if geometry.is_empty() {
        problems.extend(judge::problems(parts, forecast));
    }
    problems.extend(geometry);
    problems
}
