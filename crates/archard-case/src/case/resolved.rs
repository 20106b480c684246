//! What a case asks for, read and checked.

use super::accuracy::Chose;
use super::cam::{CamCase, CamForecast};
use super::check::Forecast;
use super::check::pace::Pace;
use super::check::runtime::Runtime;
use super::check::within::Within;
use super::definition::Case;
use super::elastic::{ElasticCase, ElasticForecast};
use super::gear::{GearCase, GearForecast};
use super::problem::Problem;
use super::wheel_rail::{WheelRailCase, WheelRailForecast};
use crate::output::{cam_files, elastic_files, gear_files};

/// A case that can be run.
#[non_exhaustive]
#[derive(Debug, Clone)]
pub struct RunnableCase {
    /// The case in SI.
    pub case: Case,
    /// Whether its frame was chosen.
    pub chose: Chose,
    /// What can be said about it before the run.
    pub forecast: Forecast,
    /// What may not be as it was meant.
    pub warnings: Vec<Problem>,
}

/// A case of one elastic body that can be computed.
#[non_exhaustive]
#[derive(Debug, Clone)]
pub struct ResolvedElastic {
    /// The case in SI.
    pub case: ElasticCase,
    /// What it will take.
    pub forecast: ElasticForecast,
    /// What may not be as it was meant.
    pub warnings: Vec<Problem>,
}

/// A case of a wheel on a rail that can be computed.
#[non_exhaustive]
#[derive(Debug, Clone)]
pub struct ResolvedWheelRail {
    /// The case in SI.
    pub case: WheelRailCase,
    /// What the set-up gives.
    pub forecast: WheelRailForecast,
    /// What may not be as it was meant.
    pub warnings: Vec<Problem>,
}

/// A case of two gears that can be computed.
#[non_exhaustive]
#[derive(Debug, Clone)]
pub struct ResolvedGear {
    /// The case in SI.
    pub case: GearCase,
    /// What a mesh is like before any wear.
    pub forecast: GearForecast,
    /// What may not be as it was meant.
    pub warnings: Vec<Problem>,
}

/// A case of a cam and its follower that can be computed.
#[non_exhaustive]
#[derive(Debug, Clone)]
pub struct ResolvedCam {
    /// The case in SI.
    pub case: CamCase,
    /// What a turn is like before any wear.
    pub forecast: CamForecast,
    /// What may not be as it was meant.
    pub warnings: Vec<Problem>,
}

/// What a case asks for.
#[derive(Debug, Clone)]
pub enum Task {
    /// Two bodies in contact.
    Contact(Box<RunnableCase>),
    /// One elastic body by itself.
    Elastic(Box<ResolvedElastic>),
    /// A cam and its follower.
    Cam(Box<ResolvedCam>),
    /// Two gears in mesh.
    Gear(Box<ResolvedGear>),
    /// A railway wheel on its rail.
    WheelRail(Box<ResolvedWheelRail>),
}

impl RunnableCase {
    /// What to expect of the run, and what of its verdict can be foreseen. Bodies with meshes are meshed coarsely for
    /// it, to be compared with half-spaces.
    pub fn expectations(&self) -> String {
        let beside: String =
            self.case.beside_half_spaces().iter().map(ToString::to_string).collect();
        let pace = Pace::of(self.forecast.operations);
        let time = Runtime::of(&self.case, &self.forecast);
        let meshes = pace.as_ref().and_then(|pace| Within::of_meshes(&self.case, pace));
        let frame = || Within::of_frame(&self.case, &self.forecast, time.as_ref()?);
        let within = meshes.or_else(frame).map_or_else(String::new, |within| within.to_string());
        let pace = pace.map_or_else(String::new, |pace| pace.to_string());
        let time = time.map_or_else(String::new, |time| time.to_string());
        let mut text = format!("# What to expect\n\n{}{pace}{time}{within}{beside}", self.forecast);
        match self.refined() {
            Some(refined) => text += &refined.to_string(),
            None if self.chose.size => text += "\nThe size of the frame was chosen.\n",
            None => {}
        }
        let lines = &self.forecast.verdict.lines;
        if !lines.is_empty() {
            text += "\n# Verdict foreseen\n\n";
            lines.iter().for_each(|line| text += &format!("  {}\n", line.in_words()));
        }
        text
    }
}

impl Task {
    /// What to expect of the run, in lines.
    pub fn expectations(&self) -> String {
        match self {
            Task::Contact(resolved) => resolved.expectations(),
            Task::Elastic(resolved) => format!("# What to expect\n\n{}", resolved.forecast),
            Task::Cam(resolved) => format!("# What to expect\n\n{}", resolved.forecast),
            Task::Gear(resolved) => format!("# What to expect\n\n{}", resolved.forecast),
            Task::WheelRail(resolved) => format!("# What to expect\n\n{}", resolved.forecast),
        }
    }

    /// The case in SI, as a case file.
    pub fn case_toml(&self) -> String {
        match self {
            Task::Contact(resolved) => resolved.case.to_string(),
            Task::Elastic(resolved) => resolved.case.to_string(),
            Task::Cam(resolved) => resolved.case.to_string(),
            Task::Gear(resolved) => resolved.case.to_string(),
            Task::WheelRail(resolved) => resolved.case.to_string(),
        }
    }

    /// The files of points and sections that its results have, by their names in the folder; for
    /// [`Claim::adding`](crate::output::Claim::adding).
    pub fn files(&self) -> Vec<String> {
        match self {
            Task::Contact(resolved) => {
                let Case { bodies, .. } = &resolved.case;
                resolved.case.inside().files(bodies.each_ref().map(|body| body.name.as_str()))
            }
            Task::Elastic(resolved) => {
                elastic_files(&resolved.case.points, &resolved.case.sections)
            }
            Task::Cam(_) => cam_files(),
            Task::Gear(_) => gear_files(),
            Task::WheelRail(resolved) => resolved.case.files(),
        }
    }

    /// What may not be as it was meant.
    pub fn warnings(&self) -> &[Problem] {
        match self {
            Task::Contact(resolved) => &resolved.warnings,
            Task::Elastic(resolved) => &resolved.warnings,
            Task::Cam(resolved) => &resolved.warnings,
            Task::Gear(resolved) => &resolved.warnings,
            Task::WheelRail(resolved) => &resolved.warnings,
        }
    }
}
