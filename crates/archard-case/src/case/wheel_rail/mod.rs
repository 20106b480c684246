//! A case of a railway wheel on its rail: what to compute, in SI, and what to expect.

mod print;
mod running;
mod shape;

use std::fmt::{self, Display, Formatter};
use std::ops::ControlFlow;
use std::sync::Arc;

use archard::body::Material;
use archard::friction::Friction;
use archard::parameters::Invalid;
use archard::wear::{Input, WearLaw};
use archard_rail::conicity::{equivalent_conicity, rolling_radius_difference};
use archard_rail::contact::{self, Bodies, ContactError, Resolution};
use archard_rail::file::Format;
use archard_rail::search::{Onset, Search};
use archard_rail::setup::{Attitude, Setup, Side, Track, Wheelset};
use archard_rail::wear::{Journey, Pass, Route, Step, WearError, Worn, error_of};
use rayon::prelude::*;

pub use running::{Running, State, WHEEL_RAIL};
pub use shape::{RAILS, RailShape, WHEELS, WheelShape};

use super::chosen::Chosen;
use super::key::Key;
use super::problem::Problem;
use crate::output::{AtPoint, RailContact, RailResults, RailWear, rail_files};

/// Amplitude (m) of the lateral motion that the equivalent conicity is told for: that of UIC 519 and EN 15302.
pub const AMPLITUDE: f64 = 3e-3;

/// A wheel or a rail, with its profile.
#[derive(Debug, Clone, PartialEq)]
pub struct Rolled<S: 'static> {
    /// The user's name for it.
    pub name: String,
    /// What it is made of.
    pub material: Material,
    /// Its profile.
    pub profile: Chosen<S>,
    /// How it wears; `None` if it does not.
    pub wear: Option<Chosen<Box<dyn WearLaw>>>,
}

/// A checked case of a wheel on a rail, in SI. It prints as a case file that reads back to the same bits.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct WheelRailCase {
    /// What it is about.
    pub title: Option<String>,
    /// The wheel.
    pub wheel: Rolled<WheelShape>,
    /// The rail.
    pub rail: Rolled<RailShape>,
    /// The friction law.
    pub friction: Chosen<Box<dyn Friction>>,
    /// How the wheelset stands and runs.
    pub motion: Chosen<Running>,
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

/// What the set-up tells before any elasticity.
#[non_exhaustive]
#[derive(Debug, Clone, Default)]
pub struct WheelRailForecast {
    /// Roll (rad) of the wheelset.
    pub roll: f64,
    /// Each side with its first touch.
    pub sides: Vec<(Side, Onset)>,
    /// Rolling radius (m) of the right wheel less that of the left one, where both stand on their rails.
    pub radius_difference: Option<f64>,
    /// Equivalent conicity for an amplitude of 3 mm, where the wheelset steers itself back.
    pub conicity: Option<f64>,
    /// Points of the route.
    pub points: usize,
}

/// A wheel over its rail, ready to be pressed on in any state.
#[derive(Debug, Clone)]
pub struct Prepared {
    setup: Setup,
    bodies: Bodies,
    resolution: Resolution,
    /// How the case has the wheelset stand and run.
    pub running: Running,
    /// The formats in which the profiles of the wheel and of the rail were read.
    pub formats: [Format; 2],
}

impl WheelRailCase {
    /// Reads the profiles and puts wheel and rail into the track.
    ///
    /// # Errors
    /// If values of the case do not fit together.
    pub fn prepare(&self) -> Result<Prepared, Problem> {
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
        let setup = Setup::new(track, &rail.shape.curve, wheelset, &wheel.shape.curve)
            .map_err(|error| self.problem(error))?;
        let law = |wear: &Option<Chosen<Box<dyn WearLaw>>>, name: &str| match wear {
            None => Ok(None),
            Some(law) => {
                let key = Key::of(["body", name, "wear", law.choice.name]);
                Ok(Some(Arc::from(law.build().map_err(at(key))?)))
            }
        };
        let bodies = Bodies {
            wheel: self.wheel.material,
            rail: self.rail.material,
            friction: friction.into(),
            wear: [
                law(&self.wheel.wear, &self.wheel.name)?,
                law(&self.rail.wear, &self.rail.name)?,
            ],
        };
        let mut resolution = Resolution { join: running.join, ..Resolution::default() };
        resolution.elements = self.elements.unwrap_or(resolution.elements);
        let formats = [wheel.shape.format, rail.shape.format];
        let prepared = Prepared { setup, bodies, resolution, running, formats };
        self.hold(&prepared)?;
        Ok(prepared)
    }

    /// Refuses what wears without a distance, and laws that ask for what a profile does not keep.
    fn hold(&self, prepared: &Prepared) -> Result<(), Problem> {
        let Running { distance, axles, .. } = prepared.running;
        let motion = Key::of(["motion", "wheel_rail"]);
        let extents = [
            (distance, "distance", "how far the wheel runs"),
            (axles, "axles", "how many axles pass the rail"),
        ];
        let names = [&self.wheel.name, &self.rail.name];
        for ((law, (extent, key, meaning)), name) in
            prepared.bodies.wear.iter().zip(extents).zip(names)
        {
            let wear = Key::of(["body", name, "wear"]);
            let Some(law) = law else {
                if extent.is_some() {
                    let message = format!("{meaning} counts for nothing: `{name}` has no wear law");
                    return Err(Problem::error(motion.child(key), message));
                }
                continue;
            };
            if extent.is_none() {
                return Err(Problem::missing(
                    motion.child(key),
                    format!("{meaning}, since `{name}` wears"),
                ));
            }
            let kept = |input: &Input| {
                matches!(input, Input::Distance | Input::Depth | Input::Temperature)
            };
            if law.inputs().iter().any(kept) {
                let message = "the law asks for the distance slid before, the depth worn before or the temperature, which are not kept \
                               along a profile";
                return Err(Problem::error(wear, message));
            }
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
        let files = |prepared: Prepared| {
            rail_files(prepared.wears(), &prepared.running.sides, prepared.formats)
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

impl Prepared {
    /// Which of wheel and rail wear.
    pub fn wears(&self) -> [bool; 2] {
        self.bodies.wear.each_ref().map(Option::is_some)
    }

    /// The contacts at all points, and the wear over the route; `watch` is shown each step and may stop it.
    ///
    /// # Errors
    /// If a contact cannot be found, or the route not be gone through.
    pub fn solve(
        &self,
        watch: impl FnMut(Pass, &Step<'_>) -> ControlFlow<()>,
    ) -> Result<RailResults, RailError> {
        if self.wears() == [false; 2] {
            return Ok(RailResults { contacts: self.all(None)?, wear: None });
        }
        let journey = self.journey()?;
        let mut contacts = self.all(None)?;
        let travelled = journey.travel(watch)?;
        contacts.extend(self.all(Some(&travelled.worn))?);
        // Rails of other wear are met on the way: only a worn wheel keeps its conicity.
        let conicity = |worn: Option<&[Worn]>| {
            let setups = self.setups(worn);
            self.wears()[0]
                .then(|| {
                    equivalent_conicity(Side::both(&self.running.sides, &setups), AMPLITUDE).ok()
                })
                .flatten()
        };
        let [fine, coarse, hasty] =
            [&travelled.worn, &travelled.coarse, &travelled.hasty].map(|worn| conicity(Some(worn)));
        let error = fine.zip(coarse).zip(hasty);
        let error = error.map(|((fine, coarse), hasty)| error_of([fine, coarse, hasty]));
        let wear = RailWear {
            extent: [journey.route.distance, journey.route.axles],
            wears: self.wears(),
            conicity: [conicity(None), fine, error],
            formats: self.formats,
            travelled,
        };
        Ok(RailResults { contacts, wear: Some(wear) })
    }

    /// The contacts of a wheelset in that state, its roll found from both wheels under their load where it is not given.
    ///
    /// # Errors
    /// If a contact cannot be found.
    pub fn contacts(&self, state: &State) -> Result<Vec<RailContact>, RailError> {
        self.at_point(state, &self.setups(None), None)
    }

    /// The contacts at all points, with new profiles or with worn ones.
    fn all(&self, worn: Option<&[Worn]>) -> Result<Vec<RailContact>, RailError> {
        let states = self.running.states()?;
        let setups = self.setups(worn);
        // One point of new profiles is a contact by itself.
        let single = self.running.route.is_empty() && self.wears() == [false; 2];
        let found = states.par_iter().enumerate().map(|(index, state)| {
            let at = AtPoint { point: index + 1, worn: worn.is_some() };
            self.at_point(state, &setups, (!single).then_some(at))
        });
        let found: Vec<Result<Vec<RailContact>, RailError>> = found.collect();
        Ok(found.into_iter().collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
    }

    /// The contacts in a state. A roll that is not given is found from both wheels: of a contact by itself under their load, of a
    /// point of a route at first touch, as its wear is.
    fn at_point(
        &self,
        state: &State,
        setups: &[Setup],
        at: Option<AtPoint>,
    ) -> Result<Vec<RailContact>, RailError> {
        let point = at.map(|at| at.point);
        let wrong = |cause| RailError::Contact { point, cause: Box::new(cause) };
        let radius = self.setup.wheelset().nominal_radius;
        let operating = state.point(radius, &self.bodies.friction)?;
        let bodies = Bodies { friction: operating.friction.clone(), ..self.bodies.clone() };
        let both = Side::both(&self.running.sides, setups);
        let mut operation = operating.operation(both, &bodies, &self.resolution).map_err(wrong)?;
        if at.is_none() && !operating.rolls {
            let roll = contact::roll(&self.setup, &bodies, &operation, &self.resolution);
            operation.attitude.roll = roll.map_err(wrong)?;
        }
        let solve = |(side, setup): (&Side, &Setup)| {
            let own = operation.of_side(*side);
            let patches = contact::contact(setup, &bodies, &own, &self.resolution);
            Ok(RailContact { at, side: *side, load: own.load, patches: patches.map_err(wrong)? })
        };
        self.running.sides.iter().zip(setups).map(solve).collect()
    }

    /// The set-up of each side that is computed.
    fn setups(&self, worn: Option<&[Worn]>) -> Vec<Setup> {
        let side = |at: usize| match worn.and_then(|worn| worn.get(at)) {
            Some(worn) => self.setup.worn(worn.rail.curve(), worn.wheel.curve()),
            None => self.setup.clone(),
        };
        (0..self.running.sides.len()).map(side).collect()
    }

    /// The wheelset and its route.
    fn journey(&self) -> Result<Journey, Invalid> {
        let radius = self.setup.wheelset().nominal_radius;
        let states = self.running.states()?;
        let points = states.iter().map(|state| state.point(radius, &self.bodies.friction));
        let route = Route {
            points: points.collect::<Result<_, _>>()?,
            distance: self.running.distance.unwrap_or(0.0),
            axles: self.running.axles.unwrap_or(0.0),
        };
        Journey {
            setup: self.setup.clone(),
            sides: self.running.sides.clone(),
            bodies: self.bodies.clone(),
            route,
            resolution: self.resolution,
            tolerance: self.running.tolerance,
            smoothing: self.running.wear_smoothing,
        }
        .checked()
    }

    /// What the set-up tells before any elasticity.
    fn forecast(&self) -> Result<WheelRailForecast, Invalid> {
        let states = self.running.states()?;
        if !self.running.route.is_empty() || self.wears() != [false; 2] {
            self.journey()?;
        }
        let mut attitude = states[0].attitude;
        if !states[0].rolls {
            attitude.roll = self.setup.roll(&self.setup, attitude.shift, attitude.yaw)?;
        }
        let touch = |&side: &Side| {
            let onset = Search::first_touch(&self.setup, side.attitude(attitude))?;
            let onset =
                onset.ok_or_else(|| Invalid::new("shift", "the wheel is not over its rail"))?;
            Ok((side, onset))
        };
        let sides = self.running.sides.iter().map(touch).collect::<Result<_, Invalid>>()?;
        let both = [&self.setup; 2];
        let (shift, yaw, roll) = (attitude.shift, attitude.yaw, Some(attitude.roll));
        Ok(WheelRailForecast {
            roll: attitude.roll,
            sides,
            radius_difference: rolling_radius_difference(both, shift, yaw, roll).ok(),
            conicity: equivalent_conicity(both, AMPLITUDE).ok(),
            points: states.len(),
        })
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

impl Display for WheelRailForecast {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.points > 1 {
            writeln!(
                f,
                "route             {} points, the first of which touches like this:",
                self.points
            )?;
        }
        writeln!(f, "roll              {:.5} mrad", 1e3 * self.roll)?;
        for (side, onset) in &self.sides {
            let [x, y, z] = onset.at.point.to_array().map(|one| 1e3 * one);
            let height = 1e3 * onset.height;
            writeln!(f, "{:<18}touches at a height of {height:.4} mm", side.name())?;
            writeln!(f, "                  x {x:.3} mm, y {y:.3} mm, z {z:.3} mm of the track")?;
        }
        if let Some(difference) = self.radius_difference {
            writeln!(f, "rolling radii     right less left {:.4} mm", 1e3 * difference)?;
        }
        if let Some(conicity) = self.conicity {
            writeln!(f, "conicity          {conicity:.4} at an amplitude of 3 mm")?;
        }
        Ok(())
    }
}
