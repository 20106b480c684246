//! Cams and their followers: where they touch, how they slide on each other and wear.
//!
//! With the lift s over the angle, a cam of base radius R slides on a flat follower by R + s a radian; the contact moves over the cam by
//! R + s + s'', its radius of curvature, and over the follower by s''. A body loses k F' |v1 - v2|/v a passage, F' the load over the
//! width. Where the contact turns round on the follower that has no end; what is left there is Hertz's pressure swept along its path.

mod lift;
mod shape;
mod sweep;
mod wear;

use std::f64::consts::TAU;
use std::sync::Arc;

use archard::body::Material;
use archard::friction::Friction;
use archard::parameters::Invalid;
use archard::wear::WearLaw;

pub use lift::Lift;
pub use shape::{Follower, Profile, Touch};
pub use wear::WornCam;

use crate::laws::{Laws, Misfit, checked, contact_modulus};
use crate::line::hertz;

/// Angles of a turn at which the contact is known. A choice: half a degree apart; twice as far apart, they say how far off results are.
const ANGLES: usize = 720;

/// What presses a follower on its cam, along its way.
#[derive(Debug, Clone, PartialEq)]
pub enum Loading {
    /// A spring, and the inertia of the follower.
    Spring {
        /// Force (N) at no lift.
        preload: f64,
        /// Stiffness (N/m).
        stiffness: f64,
        /// Mass (kg) of the follower and what moves with it.
        mass: f64,
        /// Angular speed (rad/s) of the cam.
        speed: f64,
    },
    /// Forces (N) over the angle (rad), a turn of them, straight between rows.
    Table(Vec<[f64; 2]>),
}

impl Loading {
    /// The force (N) along the way of the follower.
    fn at(&self, angle: f64, touch: &Touch) -> f64 {
        match self {
            Self::Spring { preload, stiffness, mass, speed } => {
                preload + stiffness * touch.lift + mass * speed * speed * touch.bend
            }
            Self::Table(rows) => {
                let start = rows[0][0];
                let angle = start + (angle - start).rem_euclid(TAU);
                let next = rows.partition_point(|row| row[0] <= angle).clamp(1, rows.len() - 1);
                let ([from, low], [to, high]) = (rows[next - 1], rows[next]);
                low + (high - low) * (angle - from) / (to - from)
            }
        }
    }

    /// By how much (N/m) the force falls with what both bodies lose.
    fn stiffness(&self) -> f64 {
        match self {
            Self::Spring { stiffness, .. } => *stiffness,
            Self::Table(_) => 0.0,
        }
    }
}

/// A cam that presses on its follower.
#[derive(Debug, Clone)]
pub struct Cam {
    /// The shape of the cam.
    pub profile: Profile,
    /// The face of the follower.
    pub follower: Follower,
    /// What presses them together.
    pub loading: Loading,
    /// Width (m) of the contact.
    pub width: f64,
    /// Contact modulus (Pa), E* of Hertz.
    pub modulus: f64,
    /// Friction, for laws that ask for it.
    pub friction: Option<Arc<dyn Friction>>,
    /// How cam and follower wear; `None` if they do not.
    pub laws: [Option<Arc<dyn WearLaw>>; 2],
}

/// A cam and its follower at an angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// The angle (rad).
    pub angle: f64,
    /// Where they touch.
    pub touch: Touch,
    /// Load (N/m) over the width, at right angles to the contact.
    pub load: f64,
    /// Half-width (m) of the contact.
    pub half_width: f64,
    /// Peak pressure (Pa).
    pub peak_pressure: f64,
}

impl Cam {
    /// A cam and its follower of these materials, that touch over a width (m).
    ///
    /// # Errors
    /// If they do not touch along one line at all angles, the follower lifts off, or laws ask for what is not known.
    pub fn new(
        (profile, follower): (Profile, Follower),
        loading: Loading,
        width: f64,
        materials: [&Material; 2],
        laws: Laws,
    ) -> Result<Self, Misfit> {
        checked(&laws)?;
        let (friction, laws) = laws;
        let modulus = contact_modulus(materials);
        let cam = Self { profile, follower, loading, width, modulus, friction, laws };
        // Between the angles as well, where a table may have more rows.
        let angles = || angles(8 * cam.angles());
        shape::fits(&cam.profile, cam.follower, angles())?;
        for angle in angles() {
            let touch = Touch::new(&cam.profile, cam.follower, angle);
            let load = cam.loading.at(angle, &touch);
            if load <= 0.0 {
                let message = format!(
                    "the follower lifts off at {:.2} deg, where the force on it is {load:.4} N: more of it, a lower speed or a smaller mass",
                    angle.to_degrees()
                );
                let key = match cam.loading {
                    Loading::Spring { .. } => "preload",
                    Loading::Table(_) => "load",
                };
                return Err(Invalid::new(key, message).into());
            }
        }
        Ok(cam)
    }

    /// The cam and its follower at an angle (rad).
    pub fn station(&self, angle: f64) -> Station {
        let touch = Touch::new(&self.profile, self.follower, angle);
        let load = self.loading.at(angle, &touch) / (touch.cosine * self.width);
        let [half_width, peak_pressure] = hertz(load, touch.curvature, self.modulus);
        Station { angle, touch, load, half_width, peak_pressure }
    }

    /// Radii of curvature (m) of cam and follower at a station; those of hollows are negative, and of a flat infinite.
    pub fn radii(&self, station: &Station) -> [f64; 2] {
        let follower = match self.follower {
            Follower::Flat => f64::INFINITY,
            Follower::Round(radius) => radius,
        };
        [(station.touch.curvature - follower.recip()).recip(), follower]
    }

    /// The same all around.
    pub fn stations(&self) -> Vec<Station> {
        angles(self.angles()).map(|angle| self.station(angle)).collect()
    }

    /// How many angles of a turn are looked at: a multiple of [`ANGLES`], so many that none of the rows of a table lies between two.
    fn angles(&self) -> usize {
        let lift = match &self.profile {
            Profile::Lift { lift, .. } => lift.rows(),
            Profile::Eccentric { .. } => 0,
        };
        let loads = match &self.loading {
            Loading::Table(rows) => rows.len(),
            Loading::Spring { .. } => 0,
        };
        ANGLES * (lift.max(loads).saturating_sub(1)).div_ceil(ANGLES).max(1)
    }
}

/// So many angles (rad) of a turn.
fn angles(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |at| TAU * at as f64 / count as f64)
}
