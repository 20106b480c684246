//! Worn sections that a run of the case shows, which measured profiles are held against.

use std::error::Error as StdError;

use super::runs::{built, described, passing, put};
use super::untold::laws;
use super::{Error, RunFollower};
use archard::numerics::WRITTEN;
use archard::simulation::{self, Observer, Report, worn_profile};
use archard_case::output::Store;
use archard_case::{Case, CaseFile};
use archard_surface::scar::Shape;

/// Runs of a case for the shapes of its scars.
pub(super) struct Shapes<'a, 'f> {
    file: &'a CaseFile,
    case: Case,
    store: Option<&'a Store>,
    following: &'a mut (dyn RunFollower + 'f),
    /// Whether runs have half the elements of the case along each axis.
    halved: bool,
    /// What was put into the case, how far the run went, and what it shows.
    known: Vec<(Vec<Setting>, f64, Sections)>,
}

/// A key with a value (SI) and its unit.
pub(super) type Setting = (String, f64, String);

/// Sections through the middle, by body and axis, step by step.
type Sections = [[Vec<Vec<[f64; 2]>>; 2]; 2];

impl<'a, 'f> Shapes<'a, 'f> {
    pub fn of(
        (file, case): (&'a CaseFile, Case),
        (store, following): (Option<&'a Store>, &'a mut (dyn RunFollower + 'f)),
        halved: bool,
    ) -> Self {
        Self { file, case, store, following, halved, known: vec![] }
    }

    /// All coefficients of wear times a factor.
    pub fn scaled(&self, factor: f64) -> Vec<Setting> {
        let own = |(table, law): (String, &str)| {
            let key = format!("{table}.{law}.coefficient");
            self.case.number_at(&key).map(|(value, unit)| (key, factor * value, unit))
        };
        match factor {
            1.0 => vec![],
            _ => laws(&self.case).into_iter().filter_map(own).collect(),
        }
    }

    /// The section of a body along an axis at a share of a run with some settings, and how it grew there.
    pub fn at(
        &mut self,
        (body, axis): (usize, usize),
        (settings, share): (&[Setting], f64),
    ) -> Result<Shape, Error> {
        let place = match self.known.iter().position(|own| own.0 == settings && own.1 == share) {
            Some(place) => place,
            None => {
                let shown = self.run(settings, share)?;
                self.known.push((settings.to_vec(), share, shown));
                self.known.len() - 1
            }
        };
        let steps = &self.known[place].2[body][axis];
        let none = || {
            let name = &self.case.bodies[body].name;
            Error::Mismatch(format!(
                "runs of the case show no worn section of `{name}` along {}, which a profile can be held against: give `section`, `width` or `depth` \
                 as numbers",
                ["x", "y"][axis]
            ))
        };
        Shape::of(steps).ok_or_else(none)
    }

    fn run(&mut self, settings: &[Setting], share: f64) -> Result<Sections, Error> {
        let file = settings.iter().fold(self.file.clone(), put);
        let settings = described(settings);
        let mut case = file
            .resolve()
            .map_err(|problems| {
                let why: Vec<String> = problems.iter().map(|own| file.describe(own)).collect();
                Error::Case { settings: settings.clone(), why: why.join("; ") }
            })?
            .case;
        if self.halved {
            case.frame.elements = case.frame.elements.map(|count| count.div_ceil(2));
        }
        let failed = |why: String| Error::Run { settings: settings.clone(), why };
        let mut simulation = built(&case, self.store).map_err(|error| failed(error.to_string()))?;
        simulation.schedule = passing(&simulation.problem.motion, &simulation.schedule, &[share]);
        let mut recorder = Recorder { share, shown: Sections::default() };
        match simulation.run(&mut [&mut recorder, self.following.observer()]) {
            Ok(_) => Ok(recorder.shown),
            Err(simulation::Error::Observer(cause)) => Err(Error::Stopped { cause, runs: 0 }),
            Err(error) => Err(failed(error.to_string())),
        }
    }
}

/// Keeps worn sections up to a share of the run.
struct Recorder {
    share: f64,
    shown: Sections,
}

impl Observer for Recorder {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        if report.state.progress > self.share * report.extent * (1.0 + WRITTEN) {
            return Ok(());
        }
        for (body, own) in self.shown.iter_mut().enumerate() {
            for (axis, steps) in own.iter_mut().enumerate() {
                steps.extend(worn_profile(report, (body, axis)));
            }
        }
        Ok(())
    }
}
