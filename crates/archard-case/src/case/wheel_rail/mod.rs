//! A case of a railway wheel on its rail: what to compute, in SI, and what to expect.

mod print;
mod running;
mod shape;

use std::fmt::{self, Display, Formatter};

use archard::body::Material;
use archard::friction::Friction;
use archard::parameters::Invalid;
use archard_rail::contact::{self, Bodies, ContactError, Operation, Resolution};
use archard_rail::search::{Onset, Search};
use archard_rail::setup::{Setup, Side};

pub use running::{Running, WHEEL_RAIL};
pub use shape::{RAILS, Shape, WHEELS};

use super::chosen::Chosen;
use super::key::Key;
use super::problem::Problem;
use crate::output::RailContact;

/// A wheel or a rail.
#[derive(Debug, Clone, PartialEq)]
pub struct Rolled {
    /// The user's name for it.
    pub name: String,
    /// What it is made of.
    pub material: Material,
    /// Its profile.
    pub profile: Chosen<Shape>,
}

/// A checked case of a wheel on a rail, in SI. It prints as a case file that reads back to the same bits.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct WheelRailCase {
    /// What it is about.
    pub title: Option<String>,
    /// The wheel.
    pub wheel: Rolled,
    /// The rail.
    pub rail: Rolled,
    /// The friction law.
    pub friction: Chosen<Box<dyn Friction>>,
    /// How the wheelset stands and runs.
    pub motion: Chosen<Running>,
    /// Elements along x, and as many across, over the overlap of each patch, where they are given.
    pub elements: Option<usize>,
}

/// Why the contacts of a wheel are not found.
#[derive(Debug, thiserror::Error)]
pub enum RailError {
    /// Values of the case do not fit together.
    #[error("`{}`: {}", .0.parameter, .0.message)]
    Invalid(Invalid),
    /// There is no such contact.
    #[error(transparent)]
    Contact(#[from] ContactError),
}

impl From<Invalid> for RailError {
    fn from(invalid: Invalid) -> Self {
        Self::Invalid(invalid)
    }
}

/// What the set-up tells before any elasticity.
#[non_exhaustive]
#[derive(Debug, Clone, Default)]
pub struct WheelRailForecast {
    /// Roll (rad) of the wheelset.
    pub roll: f64,
    /// Each side with its first touch.
    pub sides: Vec<(Side, Onset)>,
}

/// A wheel over its rail, ready to be pressed on in any attitude.
#[derive(Debug, Clone)]
pub struct Prepared {
    setup: Setup,
    bodies: Bodies,
    resolution: Resolution,
    /// How the case has the wheelset stand and run.
    pub running: Running,
}

impl WheelRailCase {
    /// Reads the profiles and puts wheel and rail into the track.
    ///
    /// # Errors
    /// If values of the case do not fit together.
    pub fn prepare(&self) -> Result<Prepared, Invalid> {
        let (wheel, rail) = (self.wheel.profile.build()?, self.rail.profile.build()?);
        let mut running = self.motion.build()?;
        running.track.cant = rail.size;
        running.wheelset.nominal_radius = wheel.size;
        let setup = Setup::new(running.track, &rail.curve, running.wheelset, &wheel.curve)?;
        let bodies = Bodies {
            wheel: self.wheel.material,
            rail: self.rail.material,
            friction: self.friction.build()?.into(),
        };
        let mut resolution = Resolution { join: running.join, ..Resolution::default() };
        resolution.elements = self.elements.unwrap_or(resolution.elements);
        Ok(Prepared { setup, bodies, resolution, running })
    }

    /// The contacts of the wheels that are asked for.
    ///
    /// # Errors
    /// If a contact cannot be found.
    pub fn solve(&self) -> Result<Vec<RailContact>, RailError> {
        let prepared = self.prepare()?;
        prepared.contacts(&prepared.running)
    }
}

impl Prepared {
    /// The contacts of a wheelset that stands and runs like that.
    ///
    /// # Errors
    /// If a contact cannot be found.
    pub fn contacts(&self, running: &Running) -> Result<Vec<RailContact>, RailError> {
        let (mut attitude, mut velocity) = (running.attitude, running.velocity);
        if velocity.pitch.is_nan() {
            velocity.pitch = -velocity.forward / self.setup.wheelset().nominal_radius;
        }
        if !running.rolls {
            let operation = Operation { attitude, velocity, load: running.load };
            attitude.roll = contact::roll(&self.setup, &self.bodies, &operation, &self.resolution)?;
        }
        let solve = |&side: &Side| {
            let (attitude, velocity) = (side.attitude(attitude), side.velocity(velocity));
            let operation = Operation { attitude, velocity, load: running.load };
            let (bodies, resolution) = (&self.bodies, &self.resolution);
            let patches = contact::contact(&self.setup, bodies, &operation, resolution)?;
            Ok(RailContact { side, load: running.load, patches })
        };
        running.sides.iter().map(solve).collect()
    }

    /// What the set-up tells before any elasticity.
    fn forecast(&self) -> Result<WheelRailForecast, Invalid> {
        let mut attitude = self.running.attitude;
        if !self.running.rolls {
            attitude.roll = self.setup.roll(attitude.shift, attitude.yaw)?;
        }
        let touch = |&side: &Side| {
            let search = Search::new(&self.setup, side.attitude(attitude))?;
            let onset = search.onset();
            let onset =
                onset.ok_or_else(|| Invalid::new("shift", "the wheel is not over its rail"))?;
            Ok((side, onset))
        };
        let sides = self.running.sides.iter().map(touch).collect::<Result<_, Invalid>>()?;
        Ok(WheelRailForecast { roll: attitude.roll, sides })
    }
}

/// The forecast of a case and what is wrong with it.
pub(super) fn check(case: &WheelRailCase) -> (WheelRailForecast, Vec<Problem>) {
    let mut problems = vec![];
    for (body, kind) in [(&case.wheel, "wheel"), (&case.rail, "rail")] {
        let findings = body.profile.build().map(|shape| shape.findings).unwrap_or_default();
        let key = Key::of(["body", &body.name, "profile", kind, "file"]);
        let told = findings.iter().map(|one| Problem::warning(key.clone(), one.to_string()));
        problems.extend(told);
    }
    match case.prepare().and_then(|prepared| prepared.forecast()) {
        Ok(forecast) => (forecast, problems),
        Err(invalid) => {
            let key = Key::of(["motion", "wheel_rail"]).child(&invalid.parameter);
            problems.push(Problem::error(key, invalid.message));
            (WheelRailForecast::default(), problems)
        }
    }
}

impl Display for WheelRailForecast {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "roll              {:.5} mrad", 1e3 * self.roll)?;
        for (side, onset) in &self.sides {
            let name = if *side == Side::Left { "left" } else { "right" };
            let [x, y, z] = onset.at.point.to_array().map(|one| 1e3 * one);
            writeln!(f, "{name:<18}touches at a height of {:.4} mm", 1e3 * onset.height)?;
            writeln!(f, "                  x {x:.3} mm, y {y:.3} mm, z {z:.3} mm of the track")?;
        }
        Ok(())
    }
}
