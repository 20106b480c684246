//! The wear of a wheel and of a rail over a route.
//!
//! A route is a list of operating points, each with its share of the distance. At each of them the contacts are those of
//! [`contact`](mod@crate::contact) on one grid, with the profiles as they are worn. A line of a patch loses, on each metre that the patch
//! rolls, the depth of one passage times its width; a wheel loses this on its circumference, which passes once in as many metres,
//! and a rail at every axle. The sum over the route is the rate at which volumes go, and steps of Heun's method follow it.
//!
//! Waves shorter than the smoothing stand for what a route of a few points leaves out: between them lie all the others that a
//! wheel meets, so that no contact stays where it was to the millimetre.
//!
//! # Errors
//!
//! The route is gone through three times: as asked for, on half of the elements, and on half of the elements with steps about twice as
//! long. A value has the error of its grid, at most the difference of the first two, and that of its steps, at most that of the last two:
//! [`RouteResult::error`] is the sum of both. It holds for the profiles, the route, the smoothing and the wear law as given.

mod course;
mod cracks;
mod filter;
mod kept;
mod limits;
mod march;
mod measured;
mod rates;
mod thinner;
mod turning;
mod work;
mod worn_profile;

pub use course::{ASKED, COLUMNS, CONICITY, SideCourse};
pub use cracks::Cracks;
pub use kept::Kept;
pub use limits::Limit;
pub use march::Step;
pub use measured::ProfilePoint;
pub use thinner::{Economy, ReprofilingCut, Thicknesses};
pub use turning::{Plan, Reprofiling};
pub use worn_profile::WornProfile;

use std::ops::ControlFlow;
use std::sync::Arc;

use archard::friction::Friction;
use archard::parameters::Invalid;

use crate::bounds;
use crate::conicity::equivalent_conicity;
use crate::contact::{Bodies, ContactError, Resolution, Zone};
use crate::profile::Part;
use crate::setup::{Attitude, Setup, Side, Velocity};

/// How a wheelset stands and runs on a part of the route.
#[derive(Debug, Clone)]
pub struct OperatingPoint {
    /// Shift and yaw; its roll counts if `rolls`.
    pub attitude: Attitude,
    /// Whether the roll is given; where it is not, it is the one at which both wheels begin to touch at one height.
    pub rolls: bool,
    /// The velocities; the pitch does not count where a moment is given.
    pub velocity: Velocity,
    /// Moment (N m) that drives the wheelset forward, or brakes it; the pitch follows from it.
    pub moment: Option<f64>,
    /// Vertical force (N) on each wheel, the mean of both.
    pub load: f64,
    /// How much more (N) the right wheel bears, and the left one less.
    pub transfer: f64,
    /// Creepages that are prescribed, as in [`Operation`](crate::contact::Operation).
    pub creepages: [[Option<f64>; 3]; 2],
    /// Friction between wheel and rail.
    pub friction: Arc<dyn Friction>,
    /// Friction on the flange, where it differs.
    pub flange: Option<Zone>,
    /// Share of the distance, greater than zero; shares add up to one.
    pub share: f64,
}

/// Operating points, and how long they last.
#[derive(Debug, Clone)]
pub struct Route {
    /// The points.
    pub points: Vec<OperatingPoint>,
    /// Distance (m) that the wheelset runs.
    pub distance: f64,
    /// Axles like this one that pass a place of the rail meanwhile.
    pub axles: f64,
}

/// How far shares may be from adding up to one: files give them to a few digits.
pub const SHARES: f64 = 1e-3;

impl Route {
    /// The same with shares that add up to one to the last digit.
    ///
    /// # Errors
    /// If there are no points, a share is not greater than zero, they do not add up to one within [`SHARES`], or the distance or
    /// the number of axles is negative or not finite.
    pub fn checked(mut self) -> Result<Self, Invalid> {
        for (name, value) in [("distance", self.distance), ("axles", self.axles)] {
            if bounds::finite(name, value)? < 0.0 {
                return Err(Invalid::new(name, format!("{value} has to be 0 or more")));
            }
        }
        if self.points.is_empty() {
            return Err(Invalid::new("route", "a route needs a point or more"));
        }
        for (at, point) in self.points.iter().enumerate() {
            let named = |error: Invalid| {
                Invalid::new(error.parameter, format!("point {}: {}", at + 1, error.message))
            };
            bounds::positive("speed", point.velocity.forward).map_err(named)?;
            bounds::positive("share", point.share).map_err(named)?;
        }
        let sum: f64 = self.points.iter().map(|point| point.share).sum();
        if (sum - 1.0).abs() > SHARES || !sum.is_finite() {
            return Err(Invalid::new("share", format!("the shares add up to {sum}, not to 1")));
        }
        self.points.iter_mut().for_each(|point| point.share /= sum);
        Ok(self)
    }
}

/// A wheelset on its track, to be sent over a route.
#[derive(Debug, Clone)]
pub struct Journey {
    /// The right side; the left one is its mirror image.
    pub setup: Setup,
    /// The sides whose wear is followed. A wheel that is not wears as the other does.
    pub sides: Vec<Side>,
    /// Materials and wear laws; friction is that of the points.
    pub bodies: Bodies,
    /// How cracks damage the wheel and the rail; `None` where nobody asks for it.
    pub cracks: [Option<Cracks>; 2],
    /// What it runs over.
    pub route: Route,
    /// Elements, and which stretches share a patch.
    pub resolution: Resolution,
    /// Error of a step that is let pass, relative to all that will be worn off.
    pub tolerance: f64,
    /// Waves (m) of the worn depth that keep half of their height.
    pub smoothing: f64,
    /// Changes of the thickness of the flange (m), for which is told what turning costs; empty of none.
    pub thinnings: Vec<f64>,
    /// Amplitude (m) of the lateral motion for which the equivalent conicity is told after each step; `None` of none, which takes less
    /// time.
    pub amplitude: Option<f64>,
}

/// Wheel and rail of a side.
#[derive(Debug, Clone, PartialEq)]
pub struct WornSide {
    /// The side.
    pub side: Side,
    /// Its wheel.
    pub wheel: WornProfile,
    /// Its rail.
    pub rail: WornProfile,
}

impl WornSide {
    /// Wheel and rail.
    pub fn profiles(&self) -> [&WornProfile; 2] {
        [&self.wheel, &self.rail]
    }
}

/// Why a route was not gone through.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum WearError {
    /// A value that cannot be used.
    #[error(transparent)]
    Invalid(#[from] Invalid),
    /// There is no contact at a point of the route.
    #[error("point {point} of the route, after {:.4} of the distance: {cause}", .progress)]
    Contact {
        /// The point, numbered from 1.
        point: usize,
        /// Share of the distance.
        progress: f64,
        /// Why.
        cause: Box<ContactError>,
    },
    /// The wear is deeper than the profile is round.
    #[error("the {} is worn down to where its profile ends or crosses itself, at y = {:.3} mm: shorten the distance", match .part { Part::Wheel => "wheel", Part::Rail => "rail" }, .y * 1e3)]
    Deep {
        /// Wheel or rail.
        part: Part,
        /// y (m) on the profile.
        y: f64,
    },
    /// Steps became too short.
    #[error(
        "after {progress:.4} of the distance the wear changes too fast to follow: give a longer `smoothing` or a larger `tolerance`"
    )]
    Unsteady {
        /// Share of the distance.
        progress: f64,
    },
    /// Nothing wears.
    #[error("neither the wheel nor the rail has a wear law")]
    Unworn,
    /// Whoever watched had it stopped.
    #[error("stopped after {progress:.4} of the distance")]
    Stopped {
        /// Share of the distance.
        progress: f64,
    },
}

/// What a route left.
#[derive(Debug, Clone)]
pub struct RouteResult {
    /// As asked for.
    pub worn: Vec<WornSide>,
    /// On half of the elements.
    pub coarse: Vec<WornSide>,
    /// On half of the elements, with longer steps.
    pub hasty: Vec<WornSide>,
    /// Steps taken as asked for.
    pub steps: usize,
    /// How far what wheels bore was off their load, relative to it: the mean over the route, at the worst step. It jumps where
    /// stretches of overlap become one patch.
    pub off: f64,
    /// What is told after each step of the three, in the same order.
    told: [Vec<SideCourse>; 3],
}

/// The error of a value that was found as asked for, on half of the elements, and there with longer steps: that of the grid and that of
/// the steps.
pub fn error_of([fine, coarse, hasty]: [f64; 3]) -> f64 {
    (fine - coarse).abs() + (coarse - hasty).abs()
}

impl RouteResult {
    /// The error of a value that is read off the profiles.
    pub fn error(&self, value: impl Fn(&[WornSide]) -> f64) -> f64 {
        error_of([&self.worn, &self.coarse, &self.hasty].map(|worn| value(worn)))
    }
}

/// Which of the three times a route is gone through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pass {
    /// With longer steps on half of the elements.
    Hasty,
    /// On half of the elements.
    Coarse,
    /// As asked for.
    Fine,
}

impl Journey {
    /// The same, checked, with shares that add up to one.
    ///
    /// # Errors
    /// As [`Route::checked`] and [`Resolution::checked`], and if the tolerance is not between 0 and 1 or the smoothing negative.
    pub fn checked(mut self) -> Result<Self, Invalid> {
        self.resolution = self.resolution.checked()?;
        if !(self.tolerance > 0.0 && self.tolerance < 1.0) {
            let message = format!("{} has to lie between 0 and 1", self.tolerance);
            return Err(Invalid::new("tolerance", message));
        }
        if bounds::finite("smoothing", self.smoothing)? < 0.0 {
            return Err(Invalid::new(
                "smoothing",
                format!("{} has to be 0 or more", self.smoothing),
            ));
        }
        self.route = self.route.checked()?;
        Ok(self)
    }

    /// Sends the wheelset over its route, three times; `watch` is shown each step and may stop it.
    ///
    /// # Errors
    /// If a value cannot be used, nothing wears, a contact is not found, the wear goes too deep, or it was stopped.
    pub fn travel(
        &self,
        watch: impl FnMut(Pass, &Step<'_>) -> ControlFlow<()>,
    ) -> Result<RouteResult, WearError> {
        self.go_on(Kept::default(), watch)
    }

    /// The same from a step on that was kept of this journey: what comes is the same to the bit.
    ///
    /// # Errors
    /// As [`travel`](Self::travel).
    pub fn go_on(
        &self,
        mut kept: Kept,
        mut watch: impl FnMut(Pass, &Step<'_>) -> ControlFlow<()>,
    ) -> Result<RouteResult, WearError> {
        let Self { route, resolution, .. } = self.clone().checked()?;
        let Resolution { elements, .. } = resolution;
        if self.bodies.wear.iter().all(Option::is_none) {
            return Err(WearError::Unworn);
        }
        let mut pass = |pass, elements, tolerance| {
            let journey = Self {
                route: route.clone(),
                resolution: Resolution { elements, ..resolution },
                tolerance,
                ..self.clone()
            };
            let from = kept.begin(pass);
            journey.march(from, |place, worn| {
                let progress = place.progress;
                let conicity = journey.conicity(worn);
                let told = worn.iter().map(|one| SideCourse {
                    progress,
                    side: one.side,
                    values: [journey.told(one), vec![conicity]].concat(),
                    thinner: journey.thinned(one),
                });
                kept.take(pass, place, told);
                watch(pass, &Step { progress, worn, kept: &kept })
            })
        };
        // The error of a step grows with its square.
        let loose = (4.0 * self.tolerance).min(1.0);
        let hasty = pass(Pass::Hasty, elements / 2, loose)?;
        let coarse = pass(Pass::Coarse, elements / 2, self.tolerance)?;
        let fine = pass(Pass::Fine, elements, self.tolerance)?;
        let [of_hasty, of_coarse, told] = kept.told;
        Ok(RouteResult {
            worn: fine.worn,
            coarse: coarse.worn,
            hasty: hasty.worn,
            steps: fine.steps,
            off: fine.off,
            told: [told, of_coarse, of_hasty],
        })
    }

    /// The equivalent conicity of worn profiles; not a number where nobody asks for it, or the wheelset does not steer itself back.
    fn conicity(&self, worn: &[WornSide]) -> f64 {
        let setup = |one: &WornSide| self.setup.worn(one.rail.curve(), one.wheel.curve());
        let of = |amplitude| {
            let setups: Vec<Setup> = worn.iter().map(setup).collect();
            equivalent_conicity(Side::both(&self.sides, &setups), amplitude).ok()
        };
        self.amplitude.and_then(of).unwrap_or(f64::NAN)
    }

    /// The profiles as they are before the first metre.
    ///
    /// # Errors
    /// If the wheel reaches to its axle.
    pub fn unworn(&self) -> Result<Vec<WornSide>, Invalid> {
        let rail = WornProfile::rail(&self.setup.rail_in_its_coordinates(), self.smoothing)?;
        let radius = self.setup.wheelset().nominal_radius;
        let wheel = WornProfile::wheel(self.setup.wheel(), radius, self.smoothing)?;
        let of = |&side: &Side| WornSide { side, wheel: wheel.clone(), rail: rail.clone() };
        Ok(self.sides.iter().map(of).collect())
    }
}
