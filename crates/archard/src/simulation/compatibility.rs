//! Whether a problem is compatible with its motion and its laws: symmetric halves move along their plane of symmetry only and
//! rub alike on both sides, rolling needs a plane of pairs that particles pass, and a wear law what it asks for.

use super::{Error, Simulation};
use crate::body::Body;
use crate::friction::{Circumstance, Friction};
use crate::motion::{Drive, Guide, Motion, Rolling, Shift, Sliding};
use crate::problem::{ContactProblem, Heating};
use crate::wear::{Input, Per, WearLaw};

/// The axes of the frame.
const AXES: [&str; 2] = ["x", "y"];

impl Simulation {
    /// Whether the motion is possible on the frame.
    pub(super) fn check_frame(&self) -> Result<(), Error> {
        let (motion, frame) = (&self.problem.motion, &self.problem.frame);
        if motion.swing().is_some() && !self.problem.frame.is_uniform() {
            return Err(Error::NotUniform);
        }
        let rolling = motion.rolling().map(|rolling| rolling.direction);
        if let Some(direction) = motion.passing().map(|passing| passing.direction).or(rolling) {
            if !frame.is_plane() {
                return Err(Error::NotPlane);
            }
            if !frame.flow(direction)?.has_rows() && rolling.is_none() {
                return Err(Error::NoRows);
            }
        }
        if let Some(friction) = &self.problem.friction
            && inclined(&**friction, frame.mirrored())
        {
            return Err(Error::FrictionNotSymmetric);
        }
        crossed(motion, frame.mirrored())
            .map_or(Ok(()), |axis| Err(Error::NotSymmetric { axis: AXES[axis] }))
    }
}

impl ContactProblem {
    /// Whether there is all that the laws ask for.
    pub(super) fn check_inputs(&self) -> Result<(), Error> {
        if self.grips_by(Circumstance::Speed) && !self.motion.tells_speed() {
            return Err(Error::NoSpeedOfFriction);
        }
        if self.grips_by(Circumstance::Temperature) {
            self.tells_temperature().map_err(|reason| Error::NoTemperatureOfFriction { reason })?;
        }
        for body in &self.bodies {
            let Some(law) = &body.wear else { continue };
            let body = || body.name.clone();
            if law.inputs().contains(&Input::Temperature)
                && let Err(reason) = self.tells_temperature()
            {
                return Err(Error::NoTemperature { body: body(), reason });
            }
            match lacks(&**law, &self.bodies, self.friction.is_some(), &self.motion) {
                Some(Input::Speed) => return Err(Error::NoSpeed { body: body() }),
                Some(Input::Rolled) => return Err(Error::NotRolling { body: body() }),
                Some(_) => return Err(Error::NoFriction { body: body() }),
                None => {}
            }
            if lacks_cycles(&**law, &self.motion) {
                return Err(Error::NoCycle { body: body() });
            }
        }
        Ok(())
    }
}

/// What a wear law asks for and is not there.
pub fn lacks(
    law: &dyn WearLaw,
    bodies: &[Body; 2],
    friction: bool,
    motion: &Motion,
) -> Option<Input> {
    law.inputs().iter().copied().find(|input| match input {
        Input::Friction => !friction,
        Input::Speed => !motion.tells_speed(),
        Input::Temperature => Heating::for_laws(bodies, motion, friction).is_err(),
        Input::Rolled => motion.rolling().is_none(),
        Input::Vectors | Input::CrossShear | Input::Distance | Input::Depth => false,
    })
}

/// Whether a wear law takes whole cycles and there are none.
pub fn lacks_cycles(law: &dyn WearLaw, motion: &Motion) -> bool {
    let slides = matches!(motion, Motion::Sliding(Sliding { track: None, .. }));
    slides && law.per() == Per::Cycle
}

/// Whether axes of friction lie at an angle to planes of symmetry, so that it differs on both sides.
pub fn inclined(friction: &dyn Friction, mirrored: [bool; 2]) -> bool {
    mirrored != [false; 2] && !friction.map().is_aligned()
}

/// The axis, 0 for x and 1 for y, along which a motion takes bodies across a plane of symmetry; `None` where it
/// keeps to the planes there are.
pub fn crossed(motion: &Motion, mirrored: [bool; 2]) -> Option<usize> {
    let rolls = motion.rolling().map(rolls);
    let shifts = motion.shift().map(shifts);
    let passing = motion.sliding().and_then(|_| motion.passing());
    let passes = passing.map(|passing| [0, 1].map(|axis| axis == passing.direction.axis));
    let all = [rolls, shifts, passes];
    let moves = |axis: usize| all.into_iter().flatten().any(|moves| moves[axis]);
    (0..2).find(|&axis| mirrored[axis] && moves(axis))
}

/// Along which axes bodies that roll move.
fn rolls(rolling: &Rolling) -> [bool; 2] {
    let turns = rolling.lateral != Drive::Creepage(0.0) || rolling.spin != 0.0;
    [0, 1].map(|axis| axis == rolling.direction.axis || turns)
}

/// Along which axes bodies are shifted, or pushed.
fn shifts(shift: &Shift) -> [bool; 2] {
    let still = |guide: Guide| guide == Guide::Shift(0.0) || guide == Guide::Force(0.0);
    let stations = || shift.lead.iter().chain(&shift.cycle);
    [0, 1].map(|axis| !stations().all(|station| still(station.guides[axis])))
}
