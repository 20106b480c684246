//! A wheel over its rail: contacts in any state, and the wear over a route.

use std::ops::ControlFlow;

use archard::parameters::Invalid;
use archard_rail::conicity::equivalent_conicity;
use archard_rail::contact::{self, Bodies, Resolution};
use archard_rail::file::Format;
use archard_rail::setup::{Setup, Side};
use archard_rail::wear::{Journey, Pass, Route, Step, Worn, error_of};
use rayon::prelude::*;

use super::RailError;
use super::forecast::AMPLITUDE;
use super::running::{Running, State};
use crate::output::{AtPoint, Flank, RailContact, RailResults, RailWear};

/// A wheel over its rail, ready to be pressed on in any state.
#[derive(Debug, Clone)]
pub struct Prepared {
    pub(super) setup: Setup,
    /// The same with groups of the points of measured profiles left out.
    pub(super) samples: Vec<Setup>,
    /// Indentation hardness (Pa) of the softer of both, where it is known.
    pub(super) hardness: Option<f64>,
    pub(super) bodies: Bodies,
    pub(super) resolution: Resolution,
    /// How the case has the wheelset stand and run.
    pub running: Running,
    /// The formats in which the profiles of the wheel and of the rail were read.
    pub formats: [Format; 2],
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
            return Ok(self.results(self.all(None)?, None));
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
        Ok(self.results(contacts, Some(wear)))
    }

    fn results(&self, contacts: Vec<RailContact>, wear: Option<RailWear>) -> RailResults {
        RailResults { contacts, flank: self.flank(), hardness: self.hardness, wear }
    }

    /// The steepest place of the flange, between its tip, the lowest point of the wheel, and the tread.
    fn flank(&self) -> Option<Flank> {
        let wheel = self.setup.wheel();
        let points: Vec<[f64; 2]> = wheel.nodes().iter().map(|&along| wheel.point(along)).collect();
        let tip = points.iter().max_by(|one, other| one[1].total_cmp(&other[1]))?;
        let mut flange: Vec<&[f64; 2]> =
            points.iter().filter(|point| point[0] > tip[0] && point[0] <= 0.0).collect();
        flange.sort_by(|one, other| one[0].total_cmp(&other[0]));
        let places = flange.windows(2).map(|pair| {
            let [one, other] = [pair[0], pair[1]];
            let angle = (other[1] - one[1]).abs().atan2(other[0] - one[0]);
            Flank { y: 0.5 * (one[0] + other[0]), angle }
        });
        places.max_by(|one, other| one.angle.total_cmp(&other.angle))
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
        let flank = self.flank();
        let solve = |(side, setup): (&Side, &Setup)| {
            let own = operation.of_side(*side);
            let patches = contact::contact(setup, &bodies, &own, &self.resolution);
            let patches = patches.map_err(wrong)?;
            // Worn profiles have the noise of the new ones.
            let patches = match at {
                Some(AtPoint { worn: true, .. }) => Ok(patches),
                _ => contact::sampled(patches, &self.samples, &bodies, &own, &self.resolution),
            };
            let patches = patches.map_err(wrong)?;
            // Friction where the flange would bear.
            let steepest = patches.iter().max_by(|one, other| {
                one.values.contact_angle.abs().total_cmp(&other.values.contact_angle.abs())
            });
            let peak = steepest.map(|patch| patch.values.peak_pressure).filter(|peak| *peak > 0.0);
            let nadal = flank
                .zip(peak)
                .and_then(|(flank, peak)| flank.nadal(bodies.friction.limit(peak) / peak));
            Ok(RailContact { at, side: *side, load: own.load, nadal, patches })
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
    pub(super) fn journey(&self) -> Result<Journey, Invalid> {
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
}
