//! A case of a railway wheel on its rail: what to compute, in SI, and what to expect.

mod cracks;
mod forecast;
mod heat;
mod history;
mod keys;
mod limits;
mod prepared;
pub(super) mod print;
mod reprofiling;
mod running;
mod shape;

use std::ops::ControlFlow;
use std::sync::Arc;

use archard::body::{Material, Thermal};
use archard::friction::Friction;
use archard::parameters::{Invalid, Values};
use archard::wear::WearLaw;
use archard_rail::Part;
use archard_rail::contact::{Bodies, ContactError, FlangeWear, Resolution};
use archard_rail::curve::Curve;
use archard_rail::flange::{self, Flange};
use archard_rail::search::Onset;
use archard_rail::setup::{Attitude, Setup, Side, Track, Wheelset};
use archard_rail::wear::{ASKED, Cracks, Pass, Step, WearError};

pub use cracks::CRACKS;
pub use forecast::WheelRailForecast;
pub use limits::LIMITS;
pub use prepared::PreparedContact;
pub use reprofiling::REPROFILING;
pub use running::{State, WHEEL_RAIL, WheelsetMotion};
pub use shape::{RAILS, RailShape, Shape, WHEELS, WheelShape};

use super::chosen::ChosenPart;
use super::key::Key;
use super::problem::Problem;
use crate::output::{RailResults, rail_files};
use crate::verdict;

/// A wheel or a rail, with its profile.
#[derive(Debug, Clone, PartialEq)]
pub struct ProfiledPart<S: 'static> {
    /// The user's name for it.
    pub name: String,
    /// What it is made of.
    pub material: Material,
    /// Its indentation hardness (Pa), where it is known.
    pub hardness: Option<f64>,
    /// How it conducts heat, and how warm it is; `None` where nobody asks for it.
    pub thermal: Option<Thermal>,
    /// Its profile.
    pub profile: ChosenPart<S>,
    /// How it wears; `None` if it does not.
    pub wear: Option<ChosenPart<Box<dyn WearLaw>>>,
    /// How it wears where the flange of the wheel touches, if otherwise.
    pub flange_wear: Option<ChosenPart<Box<dyn WearLaw>>>,
    /// How it cracks; `None` where nobody asks for it.
    pub cracks: Option<ChosenPart<Cracks>>,
}

/// A checked case of a wheel on a rail, in SI. It prints as a case file that reads back to the same bits.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct WheelRailCase {
    /// What it is about.
    pub title: Option<String>,
    /// The wheel.
    pub wheel: ProfiledPart<WheelShape>,
    /// The rail.
    pub rail: ProfiledPart<RailShape>,
    /// The friction law.
    pub friction: ChosenPart<Box<dyn Friction>>,
    /// How the wheelset stands and runs.
    pub motion: ChosenPart<WheelsetMotion>,
    /// Limits of the wheel in service, by `LIMITS`.
    pub until: Values,
    /// How the wheel is turned again, by `REPROFILING`; empty where nobody asks for it.
    pub reprofiling: Values,
    /// Elements along x, and as many across, over the overlap of each patch, where they are given.
    pub elements: Option<usize>,
}

/// Why the contacts of a wheel, or its wear, are not found.
#[derive(Debug, thiserror::Error)]
pub enum RailError {
    /// Values of the case do not fit together.
    #[error("{}", .0.title())]
    Case(Box<Problem>),
    /// A value cannot be used.
    #[error("`{}`: {}", .0.parameter, .0.message)]
    Invalid(Invalid),
    /// There is no such contact at a point of the route.
    #[error("{}{cause}", .point.map_or_else(String::new, |point| format!("point {point} of the route: ")))]
    Contact {
        /// The point, numbered from 1; `None` without a route.
        point: Option<usize>,
        /// Why.
        cause: Box<ContactError>,
    },
    /// The route could not be gone through.
    #[error(transparent)]
    Wear(Box<WearError>),
}

impl RailError {
    /// Whether a value cannot be used, rather than what came of it.
    pub fn is_of_a_value(&self) -> bool {
        let invalid = |cause: &ContactError| matches!(cause, ContactError::Invalid(_));
        match self {
            Self::Case(_) | Self::Invalid(_) => true,
            Self::Contact { cause, .. } => invalid(cause),
            Self::Wear(cause) => matches!(**cause, WearError::Invalid(_)),
        }
    }
}

impl From<Invalid> for RailError {
    fn from(invalid: Invalid) -> Self {
        Self::Invalid(invalid)
    }
}

impl From<WearError> for RailError {
    fn from(cause: WearError) -> Self {
        Self::Wear(Box::new(cause))
    }
}

impl From<Problem> for RailError {
    fn from(problem: Problem) -> Self {
        Self::Case(Box::new(problem))
    }
}

/// Points (y and z, m) of a profile in the track.
pub type Outline = Vec<(f64, f64)>;

impl WheelRailCase {
    /// Reads the profiles and puts wheel and rail into the track.
    ///
    /// # Errors
    /// If values of the case do not fit together.
    pub fn prepare(&self) -> Result<PreparedContact, Problem> {
        let at = |key: Key| {
            move |error: Invalid| Problem::error(key.child(&error.parameter), error.message)
        };
        let of_body = |name: &str, kind: &str| at(Key::of(["body", name, "profile", kind]));
        let wheel = self.wheel.profile.build().map_err(of_body(&self.wheel.name, "wheel"))?;
        let rail = self.rail.profile.build().map_err(of_body(&self.rail.name, "rail"))?;
        let running = self.motion.build().map_err(at(Key::of(["motion", "wheel_rail"])))?;
        let friction =
            self.friction.build().map_err(at(Key::of(["friction", self.friction.choice.name])))?;
        let ([gauge, gauge_height], [distance, position]) = (running.gauge, running.flange_back);
        let track = Track { gauge, gauge_height, cant: rail.cant };
        let wheelset = Wheelset {
            flange_back_distance: distance,
            flange_back_position: position,
            nominal_radius: wheel.radius,
        };
        let radius = rail.radius;
        let place = |rail: &Curve, wheel: &Curve| {
            let setup = Setup::new(track, rail, wheelset, wheel);
            let setup = setup.and_then(|setup| match radius {
                Some(radius) => setup.on_a_roller(radius),
                None => Ok(setup),
            });
            setup.map_err(|error| self.problem(error))
        };
        let setup = place(&rail.shape.curve, &wheel.shape.curve)?;
        self.hold_flange(&setup)?;
        let groups = rail.shape.samples.len().max(wheel.shape.samples.len());
        let sample = |group: usize| {
            let of = |shape: &Shape| shape.samples.get(group).unwrap_or(&shape.curve).clone();
            place(&of(&rail.shape), &of(&wheel.shape))
        };
        let samples = (0..groups).map(sample).collect::<Result<_, _>>()?;
        let hardness = [self.wheel.hardness, self.rail.hardness].into_iter().flatten();
        let hardness = hardness.min_by(f64::total_cmp);
        let law = |wear: &Option<ChosenPart<Box<dyn WearLaw>>>, [name, table]: [&str; 2]| match wear
        {
            None => Ok(None),
            Some(law) => {
                let key = Key::of(["body", name, table, law.choice.name]);
                Ok::<_, Problem>(Some(Arc::from(law.build().map_err(at(key))?)))
            }
        };
        let Self { wheel: own, rail: other, .. } = self;
        let flange_wear = [
            law(&own.flange_wear, [&own.name, "flange_wear"])?,
            law(&other.flange_wear, [&other.name, "flange_wear"])?,
        ];
        self.hold_zones(&running)?;
        let flange_wear = running.flange_from.map(|from| FlangeWear { from, wear: flange_wear });
        let bodies = Bodies {
            wheel: self.wheel.material,
            rail: self.rail.material,
            thermal: [self.wheel.thermal, self.rail.thermal],
            friction: friction.into(),
            flange: None,
            shear_yield: verdict::shear_yield(hardness.unwrap_or(verdict::RAIL_STEEL)),
            wear: [law(&own.wear, [&own.name, "wear"])?, law(&other.wear, [&other.name, "wear"])?],
            flange_wear: flange_wear.filter(|flange| flange.wear.iter().any(Option::is_some)),
        };
        let mut resolution = Resolution { join: running.join, ..Resolution::default() };
        resolution.elements = self.elements.unwrap_or(resolution.elements);
        let formats = [wheel.shape.format, rail.shape.format];
        let limits = limits::limits(&self.until, wheel.radius);
        let cracks = self.cracks()?;
        let turning = reprofiling::turning(&self.reprofiling, wheel.radius)
            .map_err(at(Key::of(["reprofiling"])))?;
        let last = turning.map_or(wheel.radius, |turning| turning.last_radius);
        let planned = limits::limits(&self.until, last);
        let flange = Flange::of(setup.wheel(), setup.wheelset().flange_back_position);
        let least = planned.iter().find(|limit| limit.column == "flange_thickness_m");
        let thicknesses = reprofiling::thicknesses(
            &self.reprofiling,
            flange.map(|flange| flange.thickness),
            least.map(|limit| limit.value),
        );
        let thicknesses = thicknesses.map_err(at(Key::of(["reprofiling"])))?;
        let prepared = PreparedContact {
            thicknesses,
            planned,
            setup,
            samples,
            hardness,
            bodies,
            resolution,
            running,
            limits,
            cracks,
            turning,
            formats,
        };
        self.hold(&prepared)?;
        Ok(prepared)
    }

    /// The curve (m) of a profile of the wheel that was measured after wear; unit and axes of columns are those of the new one.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn worn_wheel(&self, name: &str, bytes: &[u8]) -> Result<Curve, Invalid> {
        shape::other(&self.wheel.profile.values, Part::Wheel, (name, bytes))
    }

    /// How wheel and rail crack.
    fn cracks(&self) -> Result<[Option<Cracks>; 2], Problem> {
        let of = |name: &str, cracks: &Option<ChosenPart<Cracks>>, wears: bool| {
            let Some(cracks) = cracks else { return Ok(None) };
            let key = Key::of(["body", name, "cracks", cracks.choice.name]);
            if !wears {
                let message = "cracks compete with wear: give the body a wear law";
                return Err(Problem::error(key, message));
            }
            let at = |error: Invalid| Problem::error(key.child(&error.parameter), error.message);
            cracks.build().map(Some).map_err(at)
        };
        let Self { wheel, rail, .. } = self;
        Ok([
            of(&wheel.name, &wheel.cracks, wheel.wear.is_some())?,
            of(&rail.name, &rail.cracks, rail.wear.is_some())?,
        ])
    }

    /// Refuses a flange that lies farther from its back than any is thick: y = 0 of the profile is elsewhere.
    fn hold_flange(&self, setup: &Setup) -> Result<(), Problem> {
        let back = setup.wheelset().flange_back_position;
        let Some([y, _]) = flange::tip(setup.wheel()) else { return Ok(()) };
        if (0.0..=flange::THICKEST).contains(&(y - back)) {
            return Ok(());
        }
        let message = format!(
            "the tip of the flange, y = {:.1} mm, is {:.1} mm from the back of the wheel, y = {:.1} mm, and no flange is thicker \
             than {:.0} mm: shift or mirror y of the file, or give `flange_back_position`",
            1e3 * y,
            1e3 * (y - back),
            1e3 * back,
            1e3 * flange::THICKEST
        );
        Err(Problem::error(Key::of(["body", &self.wheel.name, "profile", "wheel"]), message))
    }

    /// Refuses limits of a wheel that does not wear, and those that it is beyond from the first.
    fn hold_limits(&self, prepared: &PreparedContact) -> Result<(), Problem> {
        let until = Key::of(["until"]);
        if !prepared.wears()[0] {
            let message = format!("`{}` has no wear law: it reaches no limit", self.wheel.name);
            return Err(Problem::error(until, message));
        }
        let setup = &prepared.setup;
        let flange = Flange::of(setup.wheel(), setup.wheelset().flange_back_position);
        for limit in &prepared.limits {
            let key = limit.column.strip_suffix("_m").unwrap_or(limit.column);
            if limit.column == ASKED[0] && prepared.cracks[0].is_none() {
                let message =
                    format!("`{}` has no model of cracks: give `cracks.t_gamma`", self.wheel.name);
                return Err(Problem::error(until.child("crack_damage"), message));
            }
            let new = match (key, &flange) {
                ("flange_thickness", Some(flange)) => flange.thickness,
                ("flange_height", Some(flange)) => flange.height,
                ("flange_gradient", Some(flange)) => flange.gradient,
                (flange, None) if flange.starts_with("flange") => {
                    let message = "the wheel has no flange, or no tread at y = 0";
                    return Err(Problem::error(until.child(key), message));
                }
                _ => continue,
            };
            if limit.is_reached(new) {
                let message = format!(
                    "the new wheel has {:.2} mm, beyond the limit of {:.2} mm",
                    1e3 * new,
                    1e3 * limit.value
                );
                let given = if self.until.number(key).is_some() { key } else { "standard" };
                return Err(Problem::error(until.child(given), message));
            }
        }
        Ok(())
    }

    /// Refuses what wears without a distance, and laws that ask for what a profile does not keep.
    fn hold(&self, prepared: &PreparedContact) -> Result<(), Problem> {
        let WheelsetMotion { distance, axles, .. } = prepared.running;
        if !prepared.limits.is_empty() {
            self.hold_limits(prepared)?;
        }
        if prepared.turning.is_some() && !prepared.wears()[0] {
            let message = format!("`{}` has no wear law: nothing is turned", self.wheel.name);
            return Err(Problem::error(Key::of(["reprofiling"]), message));
        }
        heat::hold(self, &prepared.bodies)?;
        let motion = Key::of(["motion", "wheel_rail"]);
        let extents = [
            (distance, "distance", "how far the wheel runs"),
            (axles, "axles", "how many axles pass the rail"),
        ];
        let names = [&self.wheel.name, &self.rail.name];
        for ((law, (extent, key, meaning)), name) in
            prepared.bodies.wear.iter().zip(extents).zip(names)
        {
            if law.is_none() {
                if extent.is_some() {
                    let message = format!("{meaning} counts for nothing: `{name}` has no wear law");
                    return Err(Problem::error(motion.child(key), message));
                }
                continue;
            }
            if extent.is_none() {
                return Err(Problem::missing(
                    motion.child(key),
                    format!("{meaning}, since `{name}` wears"),
                ));
            }
        }
        Ok(())
    }

    /// Refuses a flange that has something of its own and begins nowhere, one that has nothing, and one that wears on a body that does not.
    fn hold_zones(&self, running: &WheelsetMotion) -> Result<(), Problem> {
        let own = [
            (&self.wheel.name, &self.wheel.wear, &self.wheel.flange_wear),
            (&self.rail.name, &self.rail.wear, &self.rail.flange_wear),
        ];
        let from = Key::of(["motion", "wheel_rail", "flange_from"]);
        let mut wears = false;
        for (name, wear, on_the_flange) in own {
            let Some(law) = on_the_flange else { continue };
            wears = true;
            let key = Key::of(["body", name, "flange_wear", law.choice.name]);
            if wear.is_none() {
                let message = format!("`{name}` has no `wear`, by which all but the flange wears");
                return Err(Problem::error(key, message));
            }
            if running.flange_from.is_none() {
                let message = "y on the profile of the wheel where the flange begins, which has a wear law of its own";
                return Err(Problem::missing(from, message.to_owned()));
            }
        }
        if running.flange_from.is_some() && !running.lubricated && !wears {
            let message = "counts for nothing: the flange has neither `flange_friction` nor a `flange_wear` of its own";
            return Err(Problem::error(from, message));
        }
        Ok(())
    }

    /// What is wrong with a value of the set-up, at its place in the case.
    fn problem(&self, error: Invalid) -> Problem {
        let wheel = Key::of(["body", &self.wheel.name, "profile", "wheel"]);
        let rail = Key::of(["body", &self.rail.name, "profile", "rail"]);
        let motion = Key::of(["motion", "wheel_rail"]);
        let key = match &*error.parameter {
            "wheel" => wheel,
            "nominal_radius" => wheel.child("radius"),
            "rail" => rail,
            "cant" => rail.child("cant"),
            "rail_radius" => rail.child("radius"),
            "flange_back_distance" => motion.child("flange_back"),
            "velocity" => motion.child("speed"),
            "load" => motion.child("wheel_load"),
            "smoothing" => motion.child("wear_smoothing"),
            "share" => motion.child("route"),
            other => motion.child(other),
        };
        Problem::error(key, error.message)
    }

    /// The points (y and z, m) of the rail and of the wheel of each side in the track, as they touch first at the first point: those
    /// of the wheel below its axle.
    ///
    /// # Errors
    /// If values do not fit together.
    pub fn outlines(&self) -> Result<Vec<[Outline; 2]>, Problem> {
        let prepared = self.prepare()?;
        let forecast = prepared.forecast().map_err(|error| self.problem(error))?;
        let state = prepared.running.states().map_err(|error| self.problem(error))?[0];
        let setup = &prepared.setup;
        let outline = |(side, onset): &(Side, Onset)| {
            let attitude = side.attitude(Attitude { roll: forecast.roll, ..state.attitude });
            let wheel = setup.wheel().nodes().iter().map(|&along| {
                setup.below_the_axle(setup.wheel().point(along), &attitude, onset.height)
            });
            let rail = setup.rail().nodes().iter().map(|&along| setup.rail().point(along));
            let sign = if *side == Side::Left { -1.0 } else { 1.0 };
            let in_track = |[y, z]: [f64; 2]| (sign * y, z);
            [rail.map(in_track).collect(), wheel.map(in_track).collect()]
        };
        Ok(forecast.sides.iter().map(outline).collect())
    }

    /// The files of its results but for the case, by their names in the folder.
    pub(super) fn files(&self) -> Vec<String> {
        let files = |prepared: PreparedContact| {
            let WheelsetMotion { sides, within, .. } = &prepared.running;
            rail_files(prepared.wears(), sides, prepared.formats, within.is_some())
        };
        self.prepare().map(files).unwrap_or_default()
    }

    /// The contacts at all points, and the wear over the route; `watch` is shown each step and may stop it.
    ///
    /// # Errors
    /// If a contact cannot be found, or the route not be gone through.
    pub fn solve(
        &self,
        watch: impl FnMut(Pass, &Step<'_>) -> ControlFlow<()>,
    ) -> Result<RailResults, RailError> {
        self.prepare()?.solve(watch)
    }
}

/// The forecast of a case and what is wrong with it.
pub(super) fn check(case: &WheelRailCase) -> (WheelRailForecast, Vec<Problem>) {
    let mut problems = vec![];
    let wheel = case.wheel.profile.build().map(|wheel| wheel.shape.findings).unwrap_or_default();
    let rail = case.rail.profile.build().map(|rail| rail.shape.findings).unwrap_or_default();
    for (name, kind, findings) in
        [(&case.wheel.name, "wheel", wheel), (&case.rail.name, "rail", rail)]
    {
        let key = Key::of(["body", name, "profile", kind, "file"]);
        let told = findings.iter().map(|one| Problem::warning(key.clone(), one.to_string()));
        problems.extend(told);
    }
    let forecast = case
        .prepare()
        .and_then(|prepared| prepared.forecast().map_err(|error| case.problem(error)));
    match forecast {
        Ok(forecast) => (forecast, problems),
        Err(problem) => {
            problems.push(problem);
            (WheelRailForecast::default(), problems)
        }
    }
}
