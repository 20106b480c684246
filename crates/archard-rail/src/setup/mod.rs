//! How the rail and the wheel of one side stand in the track.
//!
//! Everything is written for the right side: x forward, y to the right and z downwards, from the middle of the track
//! and the plane on top of the rails. The left side is its mirror image: [`Side::attitude`] and [`Side::velocity`] give
//! the wheelset as the mirror shows it, and what is computed from them has y to the field side of the left rail.

mod roller;
mod side;
mod top;
mod track;
mod wheelset;

pub use roller::Roller;
pub(crate) use roller::Turned;
pub use side::Side;
pub use track::{RailPlacement, Track};
pub use wheelset::{Attitude, Velocity, Wheelset};

use glam::DVec3;

use crate::curve::Curve;
use archard::parameters::Invalid;
use top::Top;

/// Distance (m) between the places of a profile between which a depth is looked for.
const STEP: f64 = 2e-4;
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

/// A rail in the track, and the wheel that runs on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Setup {
    rail: Curve,
    placing: RailPlacement,
    wheel: Curve,
    wheelset: Wheelset,
    roller: Roller,
    /// What is looked up at every state: the rail from above, and places (m) along the wheel and the rail.
    top: Top,
    samples: [Vec<f64>; 2],
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
        let placing = track.place(rail)?;
        Ok(Self::standing(placing, rail, wheelset, wheel, Roller::default()))
    }

    /// The same with other curves (m), in their own coordinates, each where the one before it stands: a worn rail is lower
    /// than a new one.
    #[must_use]
    pub fn worn(&self, rail: &Curve, wheel: &Curve) -> Self {
        Self::standing(self.placing, rail, self.wheelset, wheel, self.roller)
    }

    /// The same on a roller of that radius (m) at the top of the rail.
    ///
    /// # Errors
    /// If the radius is not greater than zero, or the profile of the rail reaches to the axis of the roller.
    pub fn on_a_roller(self, radius: f64) -> Result<Self, Invalid> {
        let depths = self.samples[1].iter().map(|&along| self.rail.point(along)[1]);
        let roller = Roller::new(radius, depths.fold(f64::NEG_INFINITY, f64::max))?;
        Ok(Self { roller, ..self })
    }

    fn standing(
        placing: RailPlacement,
        rail: &Curve,
        wheelset: Wheelset,
        wheel: &Curve,
        roller: Roller,
    ) -> Self {
        let (rail, wheel) = (placing.curve(rail), wheel.clone());
        let (top, samples) = (Top::new(&rail), [&wheel, &rail].map(|curve| curve.samples(STEP)));
        Self { rail, placing, wheel, wheelset, roller, top, samples }
    }

    /// Where the rail has that y (m along its curve) as it is seen from above, if it reaches there.
    pub(crate) fn below(&self, y: f64) -> Option<f64> {
        self.top.below(&self.rail, y)
    }

    /// Places (m along the curves) of the wheel and of the rail, all nodes among them, between which a depth is looked for.
    pub(crate) fn samples(&self) -> &[Vec<f64>; 2] {
        &self.samples
    }

    /// The rail in the track (m).
    pub fn rail(&self) -> &Curve {
        &self.rail
    }

    /// The rail in its own coordinates (m).
    pub fn rail_in_its_coordinates(&self) -> Curve {
        self.placing.own(&self.rail)
    }

    /// Where the profile of the rail stands.
    pub fn placing(&self) -> &RailPlacement {
        &self.placing
    }

    /// The wheel in its own coordinates (m).
    pub fn wheel(&self) -> &Curve {
        &self.wheel
    }

    /// The lengths of the wheelset.
    pub fn wheelset(&self) -> &Wheelset {
        &self.wheelset
    }

    /// Whether the rail is a roller.
    pub fn roller(&self) -> Roller {
        self.roller
    }

    /// The middle of the axle (m) for that attitude and height: at height 0 an upright wheel has z = 0 of its profile on
    /// the plane of the tops of the rails, and a greater height is lower.
    pub fn centre(&self, attitude: &Attitude, height: f64) -> DVec3 {
        DVec3::new(0.0, attitude.shift, height - self.wheelset.nominal_radius)
    }

    /// The point (y and z, m) in the track of a point of the wheel's profile that lies below the axle.
    pub fn below_the_axle(&self, [y, z]: [f64; 2], attitude: &Attitude, height: f64) -> [f64; 2] {
        let own = DVec3::new(0.0, self.wheelset.arm() + y, self.wheelset.nominal_radius + z);
        let point = attitude.rotation() * own + self.centre(attitude, height);
        [point.y, point.z]
    }
}
