//! The lengths of a wheelset, how it stands and how it moves.

use std::f64::consts::FRAC_PI_4;

use glam::{DMat3, DVec3};

use crate::bounds;
use archard::parameters::Invalid;

/// The lengths of a wheelset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wheelset {
    /// Distance (m) between the inner faces of both wheels.
    pub flange_back_distance: f64,
    /// y (m) of the inner face of the wheel in the coordinates of its profile: negative.
    pub flange_back_position: f64,
    /// Distance (m) from the axle to z = 0 of the profile.
    pub nominal_radius: f64,
}

impl Wheelset {
    /// The y (m) of the origin of the profile from the middle of the axle.
    pub fn arm(&self) -> f64 {
        self.flange_back_distance / 2.0 - self.flange_back_position
    }

    /// The same lengths, checked.
    ///
    /// # Errors
    /// If the distance or the radius is not greater than zero, or the position not finite.
    pub fn checked(self) -> Result<Self, Invalid> {
        bounds::positive("flange_back_distance", self.flange_back_distance)?;
        bounds::finite("flange_back_position", self.flange_back_position)?;
        bounds::positive("nominal_radius", self.nominal_radius)?;
        Ok(self)
    }
}

/// Where the wheelset stands, except for its height.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Attitude {
    /// y (m) of the middle of the axle, positive to the right.
    pub shift: f64,
    /// Turn (rad) about x, positive if the right wheel goes down.
    pub roll: f64,
    /// Turn (rad) about the rolled z, positive if the right wheel goes back.
    pub yaw: f64,
}

impl Attitude {
    /// The turn from the axes of the wheelset to those of the track: yaw about the rolled z, then roll about x.
    pub fn rotation(&self) -> DMat3 {
        DMat3::from_rotation_x(self.roll) * DMat3::from_rotation_z(self.yaw)
    }

    /// The same, checked.
    ///
    /// # Errors
    /// If the shift is not finite, or if an angle is not below a quarter of pi.
    pub fn checked(self) -> Result<Self, Invalid> {
        bounds::finite("shift", self.shift)?;
        bounds::within("roll", self.roll, FRAC_PI_4)?;
        bounds::within("yaw", self.yaw, FRAC_PI_4)?;
        Ok(self)
    }
}

/// How the wheelset moves.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Velocity {
    /// Speed (m/s) along x.
    pub forward: f64,
    /// Speed (m/s) along y, positive to the right.
    pub lateral: f64,
    /// Speed (m/s) along z, positive downwards.
    pub vertical: f64,
    /// Rate (rad/s) of the roll.
    pub roll: f64,
    /// Rate (rad/s) of the yaw.
    pub yaw: f64,
    /// Rate (rad/s) of the turn about the axle: negative for a wheelset that rolls forward.
    pub pitch: f64,
}

impl Velocity {
    /// The velocity of the middle of the axle (m/s).
    pub fn translation(&self) -> DVec3 {
        DVec3::new(self.forward, self.lateral, self.vertical)
    }

    /// The vector of rotation (rad/s) in the axes of the track: pitch about the axle, yaw about the rolled z, roll
    /// about x.
    pub fn rotation(&self, attitude: &Attitude) -> DVec3 {
        attitude.rotation() * DVec3::new(0.0, self.pitch, 0.0)
            + DMat3::from_rotation_x(attitude.roll) * DVec3::new(0.0, 0.0, self.yaw)
            + DVec3::new(self.roll, 0.0, 0.0)
    }
}
