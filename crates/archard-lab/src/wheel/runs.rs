//! Runs of a route with coefficients in place of those of the case.

use std::ops::ControlFlow;
use std::time::Instant;

use archard_case::{CaseFile, PreparedContact, RailError, WheelRailCase, WheelsetMotion};
use archard_rail::setup::Side;
use archard_rail::wear::{Pass, Step, WearError, WornSide};

use super::super::Error;
use super::super::runs::RunFollower;
use super::wheel_of;

/// The sides of a route as they wore, by its three passes, the finest first.
pub(super) type Run = [Vec<WornSide>; 3];

/// What is shown each step of a route.
type Watch<'w> = &'w mut dyn FnMut(Pass, &Step<'_>) -> ControlFlow<()>;

/// Runs a route.
pub(super) struct Runs<'a> {
    file: &'a CaseFile,
    following: &'a mut dyn RunFollower,
    /// How the wheelset runs, over points in place of the steps of a history.
    running: WheelsetMotion,
    /// What those points lose, relative to all work of friction.
    pub lost: f64,
    /// Number of runs so far.
    pub count: usize,
}

/// The sides that a case computes.
pub(super) fn sides(case: &WheelRailCase) -> Vec<Side> {
    case.prepare().map(|prepared| prepared.running.sides).unwrap_or_default()
}

impl<'a> Runs<'a> {
    /// Of a case.
    pub fn of(
        file: &'a CaseFile,
        case: &WheelRailCase,
        following: &'a mut dyn RunFollower,
    ) -> Result<Self, Error> {
        let prepared = prepared(file, case)?;
        let on_a_route = prepared.on_a_route();
        let on_a_route = on_a_route.map_err(|error| Error::Mismatch(error.to_string()))?;
        let (running, lost) = match on_a_route {
            Some((route, history)) => (route.running, history.loss),
            None => (prepared.running, 0.0),
        };
        Ok(Self { file, following, running, lost, count: 0 })
    }

    /// y (m) on the profile where the flange begins.
    pub fn flange_from(&self) -> Option<f64> {
        self.running.flange_from
    }

    /// What is doubtful about the route of the case with values (1/Pa) at keys, in words.
    pub fn doubts(&mut self, settings: &[(&str, f64)]) -> Result<Vec<String>, Error> {
        let (mut prepared, described) = self.prepared(settings)?;
        prepared.running =
            WheelsetMotion { distance: prepared.running.distance, ..self.running.clone() };
        let found = self.follow(described, |watch| prepared.solve(watch))?;
        let verdict = found.verdict();
        Ok(verdict.complaints().map(ToString::to_string).collect())
    }

    /// The wheels after a distance (m) with values (1/Pa) at keys.
    pub fn run(&mut self, settings: &[(&str, f64)], distance: f64) -> Result<Run, Error> {
        let (mut prepared, described) = self.prepared(settings)?;
        prepared.running = WheelsetMotion { distance: Some(distance), ..self.running.clone() };
        let described = format!("{described}, {distance:.4e} m");
        let travelled = self.follow(described, |watch| prepared.travel(watch))?;
        Ok([travelled.worn, travelled.coarse, travelled.hasty])
    }

    /// The case with values (1/Pa) at keys, and these in words.
    fn prepared(&self, settings: &[(&str, f64)]) -> Result<(PreparedContact, String), Error> {
        let put = |(key, value): &(&str, f64)| format!("{key}={value:e} 1/Pa");
        let described = |(key, value): &(&str, f64)| format!("{key} = {value:.4e} 1/Pa");
        let described: Vec<String> = settings.iter().map(described).collect();
        let file = settings.iter().map(put).fold(self.file.clone(), CaseFile::set);
        Ok((prepared(&file, &wheel_of(&file)?)?, described.join(", ")))
    }

    /// Runs a route, and shows it to who follows.
    fn follow<T>(
        &mut self,
        described: String,
        run: impl FnOnce(Watch<'_>) -> Result<T, RailError>,
    ) -> Result<T, Error> {
        self.count += 1;
        self.following.begins(self.count, &described);
        let begun = Instant::now();
        let mut stopped = None;
        let following = &mut *self.following;
        let found = run(&mut |_, _| {
            stopped = following.stops();
            if stopped.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        self.following.ended(self.count, &described, Some(begun.elapsed().as_secs_f64()));
        if let Some(cause) = stopped {
            return Err(Error::Stopped { cause, runs: 0 });
        }
        found.map_err(|error| {
            let deep = matches!(&error, RailError::Wear(cause) if matches!(**cause, WearError::Deep { .. }));
            let why = match deep {
                true => format!("{error}; begin from smaller coefficients"),
                false => error.to_string(),
            };
            Error::Run { settings: described, why }
        })
    }
}

fn prepared(file: &CaseFile, case: &WheelRailCase) -> Result<PreparedContact, Error> {
    case.prepare().map_err(|problem| Error::Mismatch(file.describe(&problem)))
}
