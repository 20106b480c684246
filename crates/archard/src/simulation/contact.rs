//! One contact: bodies pressed together and, where they are driven, the friction between them, solved once.

use std::sync::Arc;

use super::builder::Builder;
use super::effort::Effort;
use super::error::Error;
use super::march::Stepper;
use super::passing::{self, WornLine};
use super::placed::Placed;
use super::setup::Simulation;
use super::swing::offsets;
use crate::body::Body;
use crate::compliance::half_space::Periodic;
use crate::elastic::{ElasticError, PressedHalfSpace};
use crate::motion::{Control, Motion, Rolling, Station, Stepping};
use crate::numerics::vector::in_pool;
use crate::parameters::Invalid;
use crate::problem::{ContactProblem, ContactState};
use crate::wear::WearLaw;

/// A contact that was solved: pressures, gaps, and tractions where bodies are driven with friction.
///
/// ```
/// use archard::body::profile::{Flat, Sphere};
/// use archard::motion::Control;
/// use archard::{Body, Contact, Material};
///
/// let steel = Material::new(210e9, 0.3)?;
/// let ball = Body::new("ball", Sphere::new(50e-3)?).material(steel);
/// let flat = Body::new("flat", Flat).material(steel);
/// let pressed = Contact::between([ball, flat], Control::Load(10.2))?;
/// let contact = pressed.frame([0.36e-3; 2], [48; 2]).solve()?;
/// // Hertz: 219.3 MPa and 0.4443 um.
/// assert!((contact.peak_pressure() / 219.3e6 - 1.0).abs() < 5e-3);
/// assert!((contact.approach() / 0.4443e-6 - 1.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Contact {
    pub(super) simulation: Simulation,
    placed: Placed,
    state: ContactState,
    effort: Effort,
}

impl Contact {
    /// Begins with two bodies, body 1 first, that a load (N) or an approach (m) presses together without friction.
    ///
    /// # Errors
    /// If the control is not greater than zero.
    pub fn between(bodies: [Body; 2], control: Control) -> Result<Builder, Invalid> {
        Ok(Simulation::builder(bodies, Motion::pressed(control)?))
    }

    /// Begins with two bodies that roll steadily.
    ///
    /// # Errors
    /// If the control is not greater than zero, or a drive, the spin or the speed is not one to compute with.
    pub fn rolling(
        bodies: [Body; 2],
        rolling: Rolling,
        control: Control,
    ) -> Result<Builder, Invalid> {
        Ok(Simulation::builder(bodies, rolling.over(0.0, control, Stepping::ToOutputs)?))
    }

    /// Begins with two bodies that are pressed together as at a station and then shifted or pushed there, in so many increments
    /// each where the way counts. They do not wear on the way.
    ///
    /// # Errors
    /// If a value of the station is not one to compute with, or there are no increments or too many of them.
    pub fn shifted(
        bodies: [Body; 2],
        station: Station,
        increments: usize,
    ) -> Result<Builder, Invalid> {
        let unworn = bodies.map(|body| Body { wear: None, ..body });
        Ok(Simulation::builder(unworn, Motion::shifted(station, increments)?))
    }

    /// The contact that a simulation begins with.
    ///
    /// # Errors
    /// If a solve does not converge or the contact fills the frame.
    pub fn at_first(simulation: Simulation) -> Result<Self, Error> {
        let (placed, stepper) = in_pool(|| Stepper::begin(&simulation))?;
        let (state, effort) = (stepper.state().clone(), stepper.effort());
        Ok(Self { simulation, placed, state, effort })
    }

    /// The bodies, the frame of pairs, which may have grown, the compliance and the laws.
    pub fn problem(&self) -> &ContactProblem {
        &self.placed.in_frame(&self.simulation).unwrap_or(&self.simulation).problem
    }

    /// All that is known of it, one value a pair.
    pub fn state(&self) -> &ContactState {
        &self.state
    }

    /// Solves, iterations and applications of the compliance that it took.
    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// Pressure (Pa), one value a pair of the frame, x running fastest.
    pub fn pressure(&self) -> &[f64] {
        &self.state.pressure
    }

    /// Largest pressure (Pa) of a pair.
    pub fn peak_pressure(&self) -> f64 {
        self.pressure().iter().copied().fold(0.0, f64::max)
    }

    /// Normal gap (m), one value a pair; zero in contact.
    pub fn gap(&self) -> Vec<f64> {
        self.state.gap_of(self.problem()).into_owned()
    }

    /// Approach (m) of the bodies from first touch.
    pub fn approach(&self) -> f64 {
        self.state.approach
    }

    /// Normal force (N).
    pub fn load(&self) -> f64 {
        self.state.load
    }

    /// Area (m^2) of the pairs under pressure.
    pub fn area(&self) -> f64 {
        self.state.contact_area(self.problem())
    }

    /// Tractions of friction (Pa) on body 1 along x and y, one value a pair; `None` without friction.
    pub fn traction(&self) -> Option<&[Vec<f64>; 2]> {
        self.state.tangential.as_ref().map(|tangential| &tangential.traction)
    }

    /// Force of friction (N) on body 1 along x and y; zero without friction.
    pub fn force(&self) -> [f64; 2] {
        let tangential = self.state.tangential.as_ref();
        tangential.map_or([0.0; 2], |tangential| tangential.force(&self.problem().frame))
    }

    /// Stresses and displacements below the surface of a body, by its index 0 or 1, under the tractions of the contact.
    ///
    /// # Errors
    /// If the body is rigid, meshed, or round as the other one, or touches in strips: no half-space under a uniform frame stands for it.
    pub fn below(&self, body: usize) -> Result<PressedHalfSpace, ElasticError> {
        let problem = self.problem();
        let (bodies, frame) = (problem.bodies.each_ref(), &problem.frame);
        if let Some(why) = PressedHalfSpace::refuses(bodies, body) {
            return Err(ElasticError::Unknown { body, why });
        }
        let moved = (body, offsets(&problem.bodies, &problem.motion));
        let pressed =
            PressedHalfSpace::with_ends(bodies, moved, frame, &problem.tractions(&self.state))?;
        let why = "is no half-space under a uniform frame without strips: run its case with `output.points`";
        let pressed = pressed.ok_or(ElasticError::Unknown { body, why })?;
        let depth = Periodic::depths(bodies, frame)[body];
        let repeats = problem.compliance.repeats();
        Ok(if repeats { pressed.repeated(depth) } else { pressed })
    }

    /// Depths (m) that one passage wears off each line of surfaces that pass; none where none pass.
    ///
    /// # Errors
    /// If surfaces do not pass along the frame.
    pub fn passage(&self) -> Result<Vec<WornLine>, Error> {
        passing::passage(self.problem(), &self.state)
    }

    /// The same by other wear laws, off lines whose points slid and wore so far (m) before; `before` says it of a body and a line, in
    /// the order of the lines.
    ///
    /// # Errors
    /// If surfaces do not pass along the frame.
    pub fn passage_by(
        &self,
        laws: &[Option<Arc<dyn WearLaw>>; 2],
        before: impl Fn(usize, usize) -> [f64; 2],
    ) -> Result<Vec<WornLine>, Error> {
        passing::passage_by(self.problem(), &self.state, laws, before)
    }
}

impl Builder {
    /// Puts the parts together and solves the contact that the motion begins with.
    ///
    /// # Errors
    /// As [`Builder::build`], and if a solve does not converge or the contact fills the frame.
    pub fn solve(self) -> Result<Contact, Error> {
        Contact::at_first(self.build()?)
    }
}
