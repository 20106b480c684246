//! A wheel over its rail: contacts in any state, and the wear over a route.

use std::ops::ControlFlow;

use archard::friction::{Circumstances, Friction};
use archard::parameters::Invalid;
use archard_rail::conicity::equivalent_conicity;
use archard_rail::contact::{self, Bodies, ContactError, Resolution};
use archard_rail::file::Format;
use archard_rail::flange;
use archard_rail::gather::{self, HistoryPoints};
use archard_rail::setup::{Setup, Side};
use archard_rail::wear::{
    CONICITY, Cracks, Journey, Kept, Limit, Pass, Reprofiling, Route, RouteResult, Step,
    Thicknesses, WornSide, error_of,
};
use rayon::prelude::*;

use super::RailError;
use super::forecast::AMPLITUDE;
use super::running::{Columns, State, WheelsetMotion, title};
use crate::output::{
    AtPoint, Flank, RailContact, RailEconomy, RailHistory, RailLife as Life, RailPlan, RailResults,
    RailWear,
};

/// Coefficient of friction under a pressure (Pa), of surfaces that hardly slide and are cold where it depends on that.
fn coefficient(law: &dyn Friction, pressure: f64) -> f64 {
    law.factor(Circumstances::default()) * law.limit(pressure) / pressure
}

/// A wheel over its rail, ready to be pressed on in any state.
#[derive(Debug, Clone)]
pub struct PreparedContact {
    pub(super) setup: Setup,
    /// The same with groups of the points of measured profiles left out.
    pub(super) samples: Vec<Setup>,
    /// Indentation hardness (Pa) of the softer of both, where it is known.
    pub(super) hardness: Option<f64>,
    pub(super) bodies: Bodies,
    pub(super) resolution: Resolution,
    /// Limits of the wheel in service.
    pub(super) limits: Vec<Limit>,
    /// How wheel and rail crack.
    pub(super) cracks: [Option<Cracks>; 2],
    /// Limits that a wheel has which is turned again: those of its last radius.
    pub(super) planned: Vec<Limit>,
    /// Thicknesses of flanges that it is turned to; `None` where that is always the whole flange.
    pub(super) thicknesses: Option<Thicknesses>,
    /// How the wheel is turned again.
    pub(super) turning: Option<Reprofiling>,
    /// How the case has the wheelset stand and run.
    pub running: WheelsetMotion,
    /// The formats in which the profiles of the wheel and of the rail were read.
    pub formats: [Format; 2],
}

impl PreparedContact {
    /// All that a route is computed from, in words: profiles, points and tables that a case only names as well.
    pub fn computed_from(&self) -> String {
        let Self { setup, bodies, running, resolution, cracks, .. } = self;
        format!("{setup:?} {bodies:?} {running:?} {resolution:?} {cracks:?}")
    }

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
        self.go_on(Kept::default(), watch)
    }

    /// The same from a step on that was kept of this route.
    ///
    /// # Errors
    /// As [`solve`](Self::solve).
    pub fn go_on(
        &self,
        kept: Kept,
        watch: impl FnMut(Pass, &Step<'_>) -> ControlFlow<()>,
    ) -> Result<RailResults, RailError> {
        if let Some((route, history)) = self.on_a_route()? {
            return Ok(RailResults { history: Some(history), ..route.go_on(kept, watch)? });
        }
        if self.wears() == [false; 2] {
            return Ok(self.results(self.all(None)?, None));
        }
        let journey = self.journey()?;
        let mut contacts = self.all(None)?;
        let travelled = journey.go_on(kept, watch)?;
        contacts.extend(self.all(Some(&travelled.worn))?);
        // Rails of other wear are met on the way: only a worn wheel keeps its conicity.
        let conicity = |worn: Option<&[WornSide]>| {
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
        let lives = Life::of(&self.limits, &self.running.sides, &travelled);
        let plans = self.turning.iter().flat_map(|turning| {
            RailPlan::of(turning, &self.planned, &self.running.sides, &travelled)
        });
        let economies = self.turning.zip(self.thicknesses).map(|(turning, thicknesses)| {
            RailEconomy::of(
                (&turning, &thicknesses),
                &self.planned,
                &self.running.sides,
                &travelled,
            )
        });
        let wear = RailWear {
            economies: economies.unwrap_or_default(),
            plans: plans.collect(),
            lives,
            extent: [journey.route.distance, journey.route.axles],
            wears: self.wears(),
            cracks: self.cracks.map(|cracks| cracks.is_some()),
            conicity: [conicity(None), fine, error],
            formats: self.formats,
            travelled,
        };
        Ok(self.results(contacts, Some(wear)))
    }

    fn results(&self, contacts: Vec<RailContact>, wear: Option<RailWear>) -> RailResults {
        let (flank, hardness) = (self.flank(), self.hardness);
        RailResults { contacts, flank, hardness, wear, history: None }
    }

    /// The same over the route that stands for the steps of its history, and what that loses; `None` without a history.
    ///
    /// # Errors
    /// If a contact cannot be found.
    pub fn on_a_route(&self) -> Result<Option<(Self, RailHistory)>, RailError> {
        let Some(within) = self.running.within else { return Ok(None) };
        let (route, history) = self.gathered(within)?;
        let running = WheelsetMotion { route, within: None, ..self.running.clone() };
        Ok(Some((Self { running, ..self.clone() }, history)))
    }

    /// The wear over the route alone; `watch` is shown each step and may stop it.
    ///
    /// # Errors
    /// If nothing wears, or the route cannot be gone through.
    pub fn travel(
        &self,
        watch: impl FnMut(Pass, &Step<'_>) -> ControlFlow<()>,
    ) -> Result<RouteResult, RailError> {
        Ok(self.journey()?.travel(watch)?)
    }

    /// The route that stands for the steps of a history, and what it loses.
    fn gathered(&self, within: f64) -> Result<(Columns, RailHistory), RailError> {
        let journey = self.journey()?;
        let columns: Vec<_> =
            self.running.route.iter().filter(|(name, _)| name != "share").collect();
        let shares = journey.route.points.iter().map(|point| point.share);
        let values =
            |row: usize| columns.iter().map(|(_, values)| values[row]).collect::<Vec<f64>>();
        let steps = shares.enumerate().map(|(row, share)| (share, values(row)));
        let steps: Vec<gather::Step> = steps.collect();
        let work = |values: &[f64]| -> Result<Vec<f64>, ContactError> {
            let mut state = self.running.state;
            for ((name, _), value) in columns.iter().zip(values) {
                state.set(name, *value)?;
            }
            let point = state.point(self.setup.wheelset(), &self.bodies.friction)?;
            journey.work(&point)
        };
        let gathered = gather::gather(&steps, within, work);
        let HistoryPoints { mut points, loss } =
            gathered.map_err(|cause| RailError::Contact { point: None, cause: Box::new(cause) })?;
        points.sort_by(|one, other| other.weight.total_cmp(&one.weight));
        let mut route: Columns =
            vec![("share".to_owned(), points.iter().map(|one| one.weight).collect())];
        for (at, (name, _)) in columns.iter().enumerate() {
            route.push((name.clone(), points.iter().map(|one| one.values[at]).collect()));
        }
        let names = route.iter().map(|(name, _)| title(name));
        let rows = names.zip(route.iter().map(|(_, values)| values.clone())).collect();
        let climb = self.climb()?;
        Ok((route, RailHistory { steps: steps.len(), loss, climb, rows }))
    }

    /// The largest lateral over vertical force of a wheel at a step of a history, relative to Nadal's limit there; `None` where the history
    /// has no lateral forces.
    fn climb(&self) -> Result<Option<f64>, Invalid> {
        let Some(flank) = self.flank() else { return Ok(None) };
        let mut most = None;
        for state in self.running.states()? {
            let point = state.point(self.setup.wheelset(), &self.bodies.friction)?;
            let bodies = point.between(&self.bodies);
            let pressure = bodies.shear_yield;
            let friction = coefficient(&**bodies.friction_at(flank.y), pressure);
            for (lateral, sign) in state.lateral_forces.into_iter().zip([1.0, -1.0]) {
                let vertical = point.load + sign * point.transfer;
                let over = lateral.zip(flank.nadal(friction));
                let over = over.map(|(lateral, limit)| lateral / vertical / limit);
                most = over.into_iter().chain(most).reduce(f64::max);
            }
        }
        Ok(most)
    }

    /// The steepest place of the flange, between its tip and the tread.
    fn flank(&self) -> Option<Flank> {
        let wheel = self.setup.wheel();
        let points: Vec<[f64; 2]> = wheel.nodes().iter().map(|&along| wheel.point(along)).collect();
        let tip = flange::tip(wheel)?;
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
    fn all(&self, worn: Option<&[WornSide]>) -> Result<Vec<RailContact>, RailError> {
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
        let operating = state.point(self.setup.wheelset(), &self.bodies.friction)?;
        let bodies = operating.between(&self.bodies);
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
            let nadal = flank.zip(peak).and_then(|(flank, peak)| {
                flank.nadal(coefficient(&**bodies.friction_at(flank.y), peak))
            });
            let told = state.lateral_forces[usize::from(*side == Side::Left)];
            Ok(RailContact { at, side: *side, load: own.load, nadal, told, patches })
        };
        self.running.sides.iter().zip(setups).map(solve).collect()
    }

    /// The set-up of each side that is computed.
    fn setups(&self, worn: Option<&[WornSide]>) -> Vec<Setup> {
        let side = |at: usize| match worn.and_then(|worn| worn.get(at)) {
            Some(worn) => self.setup.worn(worn.rail.curve(), worn.wheel.curve()),
            None => self.setup.clone(),
        };
        (0..self.running.sides.len()).map(side).collect()
    }

    /// Whether a limit asks for the conicity after each step.
    fn weaves(&self) -> bool {
        self.limits.iter().any(|limit| limit.column == CONICITY)
    }

    /// The wheelset and its route.
    pub(super) fn journey(&self) -> Result<Journey, Invalid> {
        let states = self.running.states()?;
        let wheelset = self.setup.wheelset();
        let points = states.iter().enumerate().map(|(row, state)| {
            let named = |error: Invalid| {
                Invalid::new(error.parameter, format!("point {}: {}", row + 1, error.message))
            };
            state.point(wheelset, &self.bodies.friction).map_err(named)
        });
        let route = Route {
            points: points.collect::<Result<_, _>>()?,
            distance: self.running.distance.unwrap_or(0.0),
            axles: self.running.axles.unwrap_or(0.0),
        };
        Journey {
            setup: self.setup.clone(),
            sides: self.running.sides.clone(),
            bodies: self.bodies.clone(),
            cracks: self.cracks,
            route,
            resolution: self.resolution,
            tolerance: self.running.tolerance,
            smoothing: self.running.wear_smoothing,
            thinnings: self.thicknesses.map(|own| own.changes()).unwrap_or_default(),
            amplitude: self.weaves().then_some(AMPLITUDE),
        }
        .checked()
    }
}
