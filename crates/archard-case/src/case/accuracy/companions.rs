//! The same run on coarser grids, before the run itself: they say how far off it will be.

use std::error::Error as StdError;
use std::f64::consts::SQRT_2;

use super::UNWORN;
use super::regularity::{has_tip, order, regularity};
use crate::case::check::{Parts, check};
use crate::case::definition::{BuildError, Case, MOST};
use crate::case::file::Resolved;
use crate::case::problem::Severity;
use crate::output::Store;
use archard::numerics::SAME;
use archard::simulation::history::{self, Row};
use archard::simulation::{Companion, Companions, Error, Observer, Report, Simulation};

/// How many times coarser the companions are, and whether their grids are moved by half an element along the motion and across.
/// Of some 6,000 sets, compared on random problems, this one enclosed most errors for the least work.
const COARSER: [(f64, [bool; 2]); 3] =
    [(2.0, [true, false]), (2.0 * SQRT_2, [false, true]), (2.0 * SQRT_2, [true, true])];
/// The same of lines of contact.
const OF_LINES: [(f64, [bool; 2]); 3] =
    [(2.0, [true, false]), (2.0 * SQRT_2, [false; 2]), (2.0 * SQRT_2, [true, false])];
/// One more where a run shows one state only, so that nothing before or after it tells what agrees by chance.
const OF_ONE: (f64, [bool; 2]) = (SQRT_2, [false; 2]);
/// How much finer a grid becomes beside what the estimate asks for, and at most.
const MARGIN: f64 = 1.15;
const FINER: [f64; 2] = [1.1, 2.0];
/// How much finer than the first grid one is whose error tells, with that of the first, what finer ones can reach.
const TOLD: f64 = 2.0;

/// What follows the runs of companions.
pub trait Following {
    /// These come now, each on so many elements, and then the run itself on those that stand last: until some are found too
    /// few.
    fn plans(&mut self, _: &[[usize; 2]]) {}

    /// One begins, on so many elements.
    fn begins(&mut self, elements: [usize; 2]);

    /// Whether finer grids may be tried once one is judged: a budget may be spent.
    fn goes_on(&mut self) -> bool {
        true
    }

    /// The run goes through on a grid that is not fine enough, and why no finer one is taken.
    fn falls_short(&mut self, _: &Unsettled) {}

    /// What observes it.
    fn observer(&mut self) -> &mut dyn Observer;

    /// Puts into it what the case does not say, as the run itself will have it.
    ///
    /// # Errors
    /// If that does not go.
    fn prepare(&mut self, _: &mut Simulation) -> Result<(), Box<dyn StdError + Send + Sync>> {
        Ok(())
    }
}

/// Why no grid was found.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum Unsettled {
    /// A companion that cannot be built.
    #[error(transparent)]
    Build(#[from] Box<BuildError>),
    /// A companion that did not run.
    #[error("estimating the discretisation error on {} x {} elements: {cause}", .elements[0], .elements[1])]
    Run {
        /// Its elements.
        elements: [usize; 2],
        /// Why not.
        cause: Box<Error>,
    },
    /// A grid that does not become fine enough.
    #[error(
        "the error stays at {error:.2e} on {} x {} elements at {place}, and {asked} was asked for{hint}",
        .elements[0], .elements[1]
    )]
    TooCoarse {
        /// The finest that was judged.
        elements: [usize; 2],
        /// Its estimated error.
        error: f64,
        /// Where it is largest.
        place: String,
        /// The accuracy.
        asked: f64,
        /// What else helps.
        hint: &'static str,
    },
    /// What was to be put into a companion did not go.
    #[error("{0}")]
    Unprepared(Box<dyn StdError + Send + Sync>),
    /// A case that became wrong with its elements.
    #[error("{0}")]
    Wrong(String),
}

impl Unsettled {
    /// Whether whoever follows the runs stopped them.
    fn stops(&self) -> bool {
        match self {
            Self::Run { cause, .. } => matches!(**cause, Error::Observer(_)),
            cause => matches!(cause, Self::Unprepared(_)),
        }
    }
}

/// The rows of a run.
#[derive(Default)]
struct Watched(Vec<Row>);

impl Observer for Watched {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        self.0.push(history::row(report));
        Ok(())
    }
}

/// What coarser runs came to.
enum Judged {
    /// By companions.
    By(Box<Companions>),
    /// On so few elements no solution is found, and why.
    TooCoarse(Unsettled),
}

impl Resolved {
    /// The case with the elements, tolerance and increments that its accuracy takes, and what says how far off they are; as it is
    /// where no accuracy is asked for.
    ///
    /// # Errors
    /// If a companion fails, or no grid is fine enough.
    pub fn with_companions(
        mut self,
        store: Option<&Store>,
        following: &mut dyn Following,
    ) -> Result<(Self, Option<Companions>), Unsettled> {
        let Some(accuracy) = self.case.accuracy else { return Ok((self, None)) };
        let parts = Parts::of(&self.case).map_err(Box::new)?;
        let order = order(&parts);
        let outputs = self.case.output.places(parts.schedule.extent);
        // How fine a grid is, relative to the one at the beginning.
        let mut fineness = 1.0;
        // The first grid whose error tells an order: how fine it is, and how far off.
        let mut first: Option<[f64; 2]> = None;
        let mut reached: Option<(Self, Companions)> = None;
        let mut too_coarse = None;
        loop {
            if reached.is_some() && !following.goes_on() {
                break;
            }
            let judged = match self.judged(accuracy, store, following) {
                Err(cause) if reached.is_some() && !cause.stops() => break,
                judged => judged?,
            };
            let companions = match judged {
                Judged::By(companions) => companions,
                Judged::TooCoarse(cause) => match self.refine(FINER[1], order) {
                    Ok(true) => {
                        too_coarse = Some(cause);
                        continue;
                    }
                    Ok(false) | Err(_) if reached.is_some() => break,
                    // Finer elements than the memory holds tell no more of a solver that does not converge.
                    Ok(false) | Err(_) => return Err(cause),
                },
            };
            let errors = outputs.iter().map(|&place| companions.worst_foreseen(place));
            let error = errors.fold(0.0, f64::max);
            // Finer steps do not reduce the error of elements that are given.
            if error <= accuracy || !self.chose.elements {
                return Ok((self, Some(*companions)));
            }
            reached = Some((self.clone(), *companions));
            // The order follows from errors that are smaller than the value.
            if error < 1.0 {
                let [coarse, off] = *first.get_or_insert([fineness, error]);
                let observed = (off / error).ln() / (fineness / coarse).ln();
                let needed = (error / accuracy).powf(1.0 / observed.max(0.0));
                let elements = self.case.frame.elements.map(|n| needed * n as f64);
                if fineness >= TOLD * coarse && elements.iter().any(|&n| n > MOST as f64) {
                    break;
                }
            }
            let finer = (MARGIN * (error / accuracy).powf(1.0 / order)).clamp(FINER[0], FINER[1]);
            if !matches!(self.refine(finer, order), Ok(true)) {
                break;
            }
            fineness *= finer;
        }
        let Some((own, companions)) = reached else {
            let none = || Unsettled::Wrong("no grid was found that can be judged".to_owned());
            return Err(too_coarse.unwrap_or_else(none));
        };
        let at = |&place: &f64| (companions.worst_foreseen(place), place);
        // The first of those that are alike.
        let errors = outputs.iter().rev().map(at);
        let (error, place) =
            errors.max_by(|one, other| one.0.total_cmp(&other.0)).unwrap_or_default();
        let parts = Parts::of(&own.case).map_err(Box::new)?;
        following.falls_short(&Unsettled::TooCoarse {
            elements: own.case.frame.elements,
            error,
            place: parts.motion.progress.at(place),
            asked: accuracy,
            hint: if has_tip(&parts) { "; outputs once the tip is worn take fewer" } else { "" },
        });
        Ok((own, Some(companions)))
    }

    /// Runs the case on coarser grids.
    fn judged(
        &self,
        accuracy: f64,
        store: Option<&Store>,
        following: &mut dyn Following,
    ) -> Result<Judged, Unsettled> {
        let across = self.across();
        if across < UNWORN * (1.0 - SAME) {
            return Err(Unsettled::Wrong(format!(
                "{across:.1} elements across the first contact are too few to estimate their error: {UNWORN} at least"
            )));
        }
        let set = if self.case.frame.line { OF_LINES } else { COARSER };
        let grids =
            set.map(|(ratio, moved)| self.coarser(ratio, moved).map(|case| case.frame.elements));
        let grids = grids.into_iter().collect::<Result<Vec<_>, _>>()?;
        following.plans(&grids.into_iter().chain([self.case.frame.elements]).collect::<Vec<_>>());
        let mut runs: Vec<Companion> = vec![];
        let mut failed = None;
        let mut left = set.to_vec();
        left.reverse();
        while let Some((ratio, moved)) = left.pop() {
            let case = self.coarser(ratio, moved)?;
            let [own, less] = [&self.case, &case].map(|case| case.frame.elements);
            let shares = [0, 1].map(|axis| own[axis] as f64 / less[axis] as f64);
            let axes = if case.frame.line { 1.0 } else { 2.0 };
            let found = (shares[0] * shares[1]).powf(1.0 / axes);
            match self.run(case, store, following) {
                Ok(rows) => {
                    if runs.is_empty() && rows.len() == 1 {
                        left.insert(0, OF_ONE);
                    }
                    runs.push(Companion { ratio: found, rows });
                }
                Err(Unsettled::Run { elements, cause }) if cause.is_of_convergence() => {
                    failed = Some(Unsettled::Run { elements, cause });
                }
                Err(error) => return Err(error),
            }
        }
        let regularity = regularity(&self.case).map_err(Box::new)?;
        let companions = Companions::new(runs, regularity, accuracy);
        match failed {
            Some(cause) if !companions.foresee() && self.chose.elements => {
                Ok(Judged::TooCoarse(cause))
            }
            Some(cause) if !companions.foresee() => Err(cause),
            _ => Ok(Judged::By(Box::new(companions))),
        }
    }

    /// Runs a case on its elements.
    fn run(
        &self,
        case: Case,
        store: Option<&Store>,
        following: &mut dyn Following,
    ) -> Result<Vec<Row>, Unsettled> {
        let elements = case.frame.elements;
        let simulation = match store {
            Some(store) => case.build_keeping(store),
            None => case.build(),
        };
        let mut simulation = simulation.map_err(Box::new)?;
        following.prepare(&mut simulation).map_err(Unsettled::Unprepared)?;
        following.begins(elements);
        let mut watched = Watched::default();
        match simulation.run(&mut [&mut watched, following.observer()]) {
            Ok(_) => Ok(watched.0),
            Err(cause) => Err(Unsettled::Run { elements, cause: Box::new(cause) }),
        }
    }

    /// Forecasts and checks the case anew.
    pub(in crate::case) fn settle_again(&mut self) -> Result<(), Unsettled> {
        let (forecast, problems) = check(&self.case);
        if let Some(problem) = problems.iter().find(|one| one.severity == Severity::Error) {
            return Err(Unsettled::Wrong(problem.title()));
        }
        self.forecast = forecast;
        self.warnings.retain(|warning| !problems.iter().any(|one| one.key == warning.key));
        self.warnings.extend(problems);
        Ok(())
    }
}
