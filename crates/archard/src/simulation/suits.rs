//! Whether a frame suits a motion: symmetric halves move along their plane of symmetry only, and rolling needs
//! rows of pairs.

use super::{Error, Simulation};
use crate::kinematics::{Drive, Guide, Rolling, Shift};

/// The axes of the frame.
const AXES: [&str; 2] = ["x", "y"];

impl Simulation {
    /// Whether the motion is possible on the frame.
    pub(super) fn check_frame(&self) -> Result<(), Error> {
        let kinematics = &self.problem.kinematics;
        if let Some(rolling) = kinematics.rolling() {
            self.check_rolling(rolling)?;
        }
        kinematics.shift().map_or(Ok(()), |shift| self.check_shift(shift))
    }

    fn check_rolling(&self, rolling: &Rolling) -> Result<(), Error> {
        let (frame, axis) = (&self.problem.frame, rolling.direction.axis);
        if !frame.is_grid() || !frame.is_plane() {
            return Err(Error::NoRows);
        }
        let mirrored = frame.mirrored();
        let turns = rolling.lateral != Drive::Creepage(0.0) || rolling.spin != 0.0;
        if mirrored[axis] {
            return Err(Error::NotSymmetric { axis: AXES[axis] });
        }
        if mirrored[1 - axis] && turns {
            return Err(Error::NotSymmetric { axis: AXES[1 - axis] });
        }
        Ok(())
    }

    fn check_shift(&self, shift: &Shift) -> Result<(), Error> {
        let still = |guide: Guide| guide == Guide::Shift(0.0) || guide == Guide::Force(0.0);
        for (axis, name) in AXES.into_iter().enumerate() {
            let mut stations = shift.lead.iter().chain(&shift.cycle);
            if self.problem.frame.mirrored()[axis]
                && !stations.all(|station| still(station.guides[axis]))
            {
                return Err(Error::NotSymmetric { axis: name });
            }
        }
        Ok(())
    }
}
