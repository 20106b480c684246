//! Whether a frame suits a motion: symmetric halves move along their plane of symmetry only, and rolling needs
//! a plane of pairs that particles pass.

use super::{Error, Simulation};
use crate::kinematics::{Drive, Guide, Kinematics, Rolling, Shift};

/// The axes of the frame.
const AXES: [&str; 2] = ["x", "y"];

impl Simulation {
    /// Whether the motion is possible on the frame.
    pub(super) fn check_frame(&self) -> Result<(), Error> {
        let (kinematics, frame) = (&*self.problem.kinematics, &self.problem.frame);
        if let Some(rolling) = kinematics.rolling() {
            if !frame.is_plane() {
                return Err(Error::NotPlane);
            }
            frame.flow(rolling.direction)?;
        }
        crossed(kinematics, frame.mirrored())
            .map_or(Ok(()), |axis| Err(Error::NotSymmetric { axis: AXES[axis] }))
    }
}

/// The axis, 0 for x and 1 for y, along which a motion takes bodies across a plane of symmetry; `None` where it
/// keeps to the planes there are.
pub(crate) fn crossed(kinematics: &dyn Kinematics, mirrored: [bool; 2]) -> Option<usize> {
    let rolls = kinematics.rolling().map(rolls);
    let shifts = kinematics.shift().map(shifts);
    let moves = |axis: usize| [rolls, shifts].into_iter().flatten().any(|moves| moves[axis]);
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
