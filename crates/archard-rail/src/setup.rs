//! How the rail and the wheel of one side stand in the track.
//!
//! Everything is written for the right side: x forward, y to the right and z downwards, from the middle of the track
//! and the plane on top of the rails. The left side is its mirror image: [`Side::attitude`] and [`Side::velocity`] give
//! the wheelset as the mirror shows it, and what is computed from them has y to the field side of the left rail.

use glam::{DMat3, DVec3};

use crate::curve::Curve;
use crate::invalid::Invalid;

/// The right side of the track, or the left one seen in a mirror.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// As the formulas are written.
    Right,
    /// The mirror image: y, roll, yaw and their rates change sign.
    Left,
}

impl Side {
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

/// How a rail is laid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Track {
    /// Distance (m) between the inner faces of both rails.
    pub gauge: f64,
    /// Depth (m) below the top of the rail down to which the inner face counts.
    pub gauge_height: f64,
    /// Inclination (rad) of the rail towards the middle of the track.
    pub cant: f64,
}

impl Track {
    /// Standard gauge: 1435 mm, taken 14 mm below the top, rails inclined by 1:40.
    pub fn standard() -> Self {
        Self { gauge: 1.435, gauge_height: 14e-3, cant: 40f64.recip().atan() }
    }

    /// The rail in the track: inclined, its top at z = 0, its innermost point down to the gauge height at half the gauge.
    ///
    /// # Errors
    /// If a length is not greater than zero, or the cant not below a right angle.
    pub fn place(&self, rail: &Curve) -> Result<Curve, Invalid> {
        let half = Invalid::positive("gauge", self.gauge)? / 2.0;
        let depth = Invalid::positive("gauge_height", self.gauge_height)?;
        let cant = Invalid::within("cant", self.cant, std::f64::consts::FRAC_PI_2)?;
        short("rail", rail)?;
        let turned = rail.clone().moved(-cant, [0.0; 2]);
        let places = turned.samples(2e-5);
        let top = least(&turned, &places, |point| point[1]);
        let inner =
            least(
                &turned,
                &places,
                |point| {
                    if point[1] <= top + depth { point[0] } else { f64::INFINITY }
                },
            );
        Ok(turned.moved(0.0, [half - inner, -top]))
    }
}

/// Most length (m) of a profile that can stand in the track.
const LONGEST: f64 = 2.0;

/// Holds a profile against [`LONGEST`]: a longer one would take long to search, and is in another unit.
fn short(parameter: &'static str, curve: &Curve) -> Result<(), Invalid> {
    if curve.length() <= LONGEST {
        return Ok(());
    }
    let message =
        format!("a profile {} m long was probably read in the wrong unit", curve.length());
    Err(Invalid::new(parameter, message))
}

/// The least value of a function of the points of the curve, between the places too.
fn least(curve: &Curve, places: &[f64], value: impl Fn([f64; 2]) -> f64) -> f64 {
    let at = |along: f64| value(curve.point(along));
    let best = (0..places.len()).min_by(|&a, &b| at(places[a]).total_cmp(&at(places[b])));
    let best = best.unwrap_or(0);
    let (left, right) = (best.saturating_sub(1), (best + 1).min(places.len() - 1));
    let found = crate::roots::least(places[left], places[right], at);
    at(found).min(at(places[best]))
}

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
        Invalid::positive("flange_back_distance", self.flange_back_distance)?;
        Invalid::finite("flange_back_position", self.flange_back_position)?;
        Invalid::positive("nominal_radius", self.nominal_radius)?;
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
        Invalid::finite("shift", self.shift)?;
        Invalid::within("roll", self.roll, std::f64::consts::FRAC_PI_4)?;
        Invalid::within("yaw", self.yaw, std::f64::consts::FRAC_PI_4)?;
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

/// A rail in the track, and the wheel that runs on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Setup {
    rail: Curve,
    wheel: Curve,
    wheelset: Wheelset,
}

impl Setup {
    /// The rail and the wheel with those curves, in their own coordinates (m).
    ///
    /// # Errors
    /// If a length or an angle is out of its bounds, or if the wheel reaches to its axle.
    pub fn new(
        track: Track,
        rail: &Curve,
        wheelset: Wheelset,
        wheel: &Curve,
    ) -> Result<Self, Invalid> {
        let wheelset = wheelset.checked()?;
        short("wheel", wheel)?;
        let lowest = wheel.samples(1e-3).into_iter().map(|along| wheel.point(along)[1]);
        if lowest.fold(f64::INFINITY, f64::min) <= -wheelset.nominal_radius {
            return Err(Invalid::new(
                "nominal_radius",
                "the profile of the wheel reaches to the axle",
            ));
        }
        Ok(Self { rail: track.place(rail)?, wheel: wheel.clone(), wheelset })
    }

    /// The rail in the track (m).
    pub fn rail(&self) -> &Curve {
        &self.rail
    }

    /// The wheel in its own coordinates (m).
    pub fn wheel(&self) -> &Curve {
        &self.wheel
    }

    /// The lengths of the wheelset.
    pub fn wheelset(&self) -> &Wheelset {
        &self.wheelset
    }

    /// The middle of the axle (m) for that attitude and height: at height 0 an upright wheel has z = 0 of its profile on
    /// the plane of the tops of the rails, and a greater height is lower.
    pub fn centre(&self, attitude: &Attitude, height: f64) -> DVec3 {
        DVec3::new(0.0, attitude.shift, height - self.wheelset.nominal_radius)
    }
}
