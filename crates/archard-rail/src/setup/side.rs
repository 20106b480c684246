//! The two sides of the track: the left one is the mirror image of the right one.

use glam::DVec3;

use serde::{Deserialize, Serialize};

use super::{Attitude, Velocity};

/// The right side of the track, or the left one seen in a mirror.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Side {
    /// As the formulas are written.
    Right,
    /// The mirror image: y, roll, yaw and their rates change sign.
    Left,
}

impl Side {
    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Left => "left",
        }
    }

    /// What the right side has and what the left one has, of those that are given; one that is not has what the first has.
    ///
    /// # Panics
    /// If nothing is given.
    pub fn both<'a, T>(sides: &[Self], of: &'a [T]) -> [&'a T; 2] {
        [Self::Right, Self::Left].map(|side| {
            let own = sides.iter().position(|&one| one == side);
            &of[own.unwrap_or(0)]
        })
    }

    /// The attitude as this side sees it.
    pub fn attitude(self, of: Attitude) -> Attitude {
        match self {
            Self::Right => of,
            Self::Left => Attitude { shift: -of.shift, roll: -of.roll, yaw: -of.yaw },
        }
    }

    /// The velocity as this side sees it.
    pub fn velocity(self, of: Velocity) -> Velocity {
        match self {
            Self::Right => of,
            Self::Left => Velocity { lateral: -of.lateral, roll: -of.roll, yaw: -of.yaw, ..of },
        }
    }

    /// A point or a velocity of this side (x, y, z) as the track has it.
    pub fn in_track(self, vector: DVec3) -> DVec3 {
        match self {
            Self::Right => vector,
            Self::Left => DVec3::new(vector.x, -vector.y, vector.z),
        }
    }
}
