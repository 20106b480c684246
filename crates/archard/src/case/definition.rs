//! A case that passed every check: what to compute, in SI.

use super::chosen::Chosen;
use crate::body::{Body, Material, Profile};
use crate::compliance::HalfSpace;
use crate::frame::{ContactFrame, OffTheSurface};
use crate::friction::Friction;
use crate::kinematics::Motion;
use crate::parameters::Invalid;
use crate::problem::ContactProblem;
use crate::simulation::{Schedule, Simulation};
use crate::solve::Solver;
use crate::solve::tangential::FrictionSolver;
use crate::wear::WearLaw;

/// A checked case in SI. It prints as a case file that reads back to the same bits.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// What it is about.
    pub title: Option<String>,
    /// The bodies in the order in which they are written.
    pub bodies: [BodyCase; 2],
    /// The potential contact zone.
    pub frame: FrameCase,
    /// The friction between the bodies; `None` without.
    pub friction: Option<Chosen<Box<dyn Friction>>>,
    /// The motion.
    pub motion: Chosen<Motion>,
    /// The solver of the contact steps.
    pub solver: Chosen<Box<dyn Solver>>,
    /// The solver of friction.
    pub friction_solver: Chosen<Box<dyn FrictionSolver>>,
    /// When fields are put out.
    pub output: Output,
}

/// One body of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyCase {
    /// Its name.
    pub name: String,
    /// What it is made of; `None` if it is rigid.
    pub material: Option<Material>,
    /// Its shape.
    pub profile: Chosen<Box<dyn Profile>>,
    /// How it wears; `None` if it does not.
    pub wear: Option<Chosen<Box<dyn WearLaw>>>,
}

/// The frame of a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameCase {
    /// Size along x and y (m).
    pub size: [f64; 2],
    /// Number of elements along x and y.
    pub elements: [usize; 2],
}

/// When fields are put out; the end of the motion always is one of the places.
#[derive(Debug, Clone, PartialEq)]
pub enum Output {
    /// Each time the motion went on by that much (its own unit).
    Every(f64),
    /// At these places, rising (the motion's own unit).
    At(Vec<f64>),
}

/// A case whose parts cannot be put together; a checked one can.
#[derive(Debug, thiserror::Error)]
pub enum BuildError {
    /// Values that do not fit together.
    #[error(transparent)]
    Invalid(#[from] Invalid),
    /// The frame is larger than a body.
    #[error(transparent)]
    OffTheSurface(#[from] OffTheSurface),
}

impl Output {
    /// The places up to an extent (the motion's own unit), which is the last of them.
    pub fn places(&self, extent: f64) -> Vec<f64> {
        let inside = |place: &f64| *place < extent * (1.0 - 1e-9);
        let mut places: Vec<f64> = match self {
            Output::At(places) => places.iter().copied().filter(inside).collect(),
            Output::Every(interval) => {
                let intervals = (extent / interval).round();
                let whole = (intervals * interval - extent).abs() < 1e-9 * extent;
                // Where the extent is a multiple, parts of it are rounded less than sums.
                let place = |i: f64| if whole { extent * i / intervals } else { interval * i };
                (1..).map(|i| place(f64::from(i))).take_while(inside).collect()
            }
        };
        places.push(extent);
        places
    }
}

impl FrameCase {
    /// Size of an element along x and y (m).
    pub fn spacing(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.size[axis] / self.elements[axis] as f64)
    }
}

impl BodyCase {
    /// Builds the body.
    fn build(&self) -> Result<Body, Invalid> {
        Ok(Body {
            name: self.name.clone(),
            profile: self.profile.build()?,
            material: self.material,
            wear: self.wear.as_ref().map(Chosen::build).transpose()?,
        })
    }
}

impl Case {
    /// Puts the parts together.
    ///
    /// # Errors
    /// If they do not fit, which a checked case does.
    pub fn build(&self) -> Result<Simulation, BuildError> {
        let bodies = [self.bodies[0].build()?, self.bodies[1].build()?];
        let profiles = bodies.each_ref().map(|body| &*body.profile);
        let frame = ContactFrame::uniform(self.frame.size, self.frame.elements, profiles)?;
        let materials = bodies.each_ref().map(|body| body.material.as_ref());
        let compliance = Box::new(HalfSpace::new(materials, &frame));
        let Motion { kinematics, control, ramped, extent, stepping } = self.motion.build()?;
        let friction = self.friction.as_ref().map(Chosen::build).transpose()?;
        let outputs = self.output.places(extent);
        Ok(Simulation {
            problem: ContactProblem { bodies, frame, compliance, friction, kinematics },
            solver: self.solver.build()?,
            friction_solver: self.friction_solver.build()?,
            schedule: Schedule { control, ramped, extent, stepping, outputs },
        })
    }
}
