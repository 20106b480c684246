//! The same run on coarser grids, before the run itself: they say how far off it will be.

use std::collections::VecDeque;
use std::error::Error as StdError;
use std::f64::consts::SQRT_2;

use super::grid::axes;
use super::regularity::{has_tip, order, regularity};
use super::{Grid, MOST, UNWORN};
use crate::estimate::Subject;
use crate::numerics::SAME;
use crate::simulation::history::{self, Row};
use crate::simulation::{Companion, Companions, Error, Observer, Report, Simulation};

/// How many times coarser the companions are, and whether their grids are moved by half an element along the motion and across.
/// Of some 6,000 sets, compared on random problems, this one enclosed most errors for the least work.
const COARSER: [(f64, [bool; 2]); 3] =
    [(2.0, [true, false]), (FARTHEST, [false, true]), (FARTHEST, [true, true])];
/// The same of lines of contact.
const OF_LINES: [(f64, [bool; 2]); 3] =
    [(2.0, [true, false]), (FARTHEST, [false; 2]), (FARTHEST, [true, false])];
/// How many times coarser the coarsest companion is.
pub const FARTHEST: f64 = 2.0 * SQRT_2;
/// One more where a run shows one state only, so that nothing before or after it says what agrees by chance.
const OF_ONE: (f64, [bool; 2]) = (SQRT_2, [false; 2]);
/// How much finer a grid becomes relative to what the estimate asks for.
const MARGIN: f64 = 1.15;
/// How many times finer a grid becomes at least and at most before it is judged again.
pub const FINER: [f64; 2] = [1.1, 2.0];
/// How much finer than the first grid one is whose error shows, with that of the first, what finer ones can reach.
const TOLD: f64 = 2.0;

/// What went wrong elsewhere.
pub type Failed = Box<dyn StdError + Send + Sync>;

/// What makes the run on a grid.
pub type Build<'a> = dyn FnMut(&Grid) -> Result<Simulation, Failed> + 'a;

/// What is told of a search; an error ends it.
pub type Watch<'a> = dyn FnMut(Event<'_>) -> Result<(), Failed> + Send + 'a;

/// What happens while a grid is sought.
#[derive(Debug, Clone, Copy)]
pub enum Event<'a> {
    /// These runs come now, each on so many elements, and then the run itself on those that stand last: until some are found too
    /// few.
    Plans(&'a [[usize; 2]]),
    /// One begins, on so many elements.
    Begins([usize; 2]),
    /// It shows a state; the error [`Enough`] ends that run alone.
    Shows(&'a Report<'a>),
    /// A grid was judged, and is not fine enough. An error ends the search with that one: a budget may be spent.
    Judged,
    /// The run goes through on a grid that is not fine enough, and why no finer one is taken.
    FallsShort(&'a AccuracyFailure),
}

/// What who watches answers to a state of a run whose rest is not needed: that run ends there, and errors are foreseen as far as
/// all runs go.
#[derive(Debug, Clone, Copy, thiserror::Error)]
#[error("the rest of the run is not needed")]
pub struct Enough;

/// Why no grid was found.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum AccuracyFailure {
    /// A run that cannot be built.
    #[error("{0}")]
    Build(Failed),
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
    /// Elements across the first contact that are too few to estimate their error.
    #[error(
        "{0:.1} elements across the first contact are too few to estimate their error: {UNWORN} at least"
    )]
    TooFew(f64),
}

impl AccuracyFailure {
    /// Whether whoever follows the runs stopped them.
    fn stops(&self) -> bool {
        matches!(self, Self::Run { cause, .. } if matches!(**cause, Error::Observer(_)))
    }
}

/// A run and the grid it is on.
#[derive(Debug)]
pub struct SettledRun {
    /// The run; its reports state errors.
    pub simulation: Simulation,
    /// Its grid.
    pub grid: Grid,
}

/// The run on the elements, tolerance and increments that an accuracy (a relative error) takes, with what says how far off they are.
///
/// Begins with a grid that is a first guess. `build` makes the run on one, and on coarser ones in its frame; `watch` is told what
/// happens, and an error of it ends the search.
///
/// ```
/// use archard::accuracy::{Grid, settle};
/// use archard::body::contact_modulus;
/// use archard::body::profile::{Flat, Sphere};
/// use archard::closed_form::Hertz;
/// use archard::motion::{Control, Indentation};
/// use archard::simulation::history::{APPROACH, number, row, stated};
/// use archard::simulation::Run;
/// use archard::{Body, Material, Simulation};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let steel = Material::new(210e9, 0.3)?;
/// let ball = Body::new("ball", Sphere::new(50e-3)?).material(steel);
/// let flat = Body::new("flat", Flat).material(steel);
/// let pressed = Indentation::new(1).under(Control::Load(10.2))?;
/// let mut build = |grid: &Grid| {
///     let builder = Simulation::builder([ball.clone(), flat.clone()], pressed.clone());
///     Ok(builder.frame([0.36e-3; 2], grid.elements).build()?)
/// };
/// let settled = settle(0.01, Grid::new([24; 2]), &mut build, &mut |_| Ok(()))?;
/// let run = Run::begin(settled.simulation)?;
/// # let mut run = run;
/// # while run.step()? {}
///
/// let row = row(&run.report());
/// let value = |name: &str| number(&row, name);
/// let approach = value(APPROACH).ok_or("no approach")?;
/// let error = stated(APPROACH, value).ok_or("no error")?;
/// let hertz = Hertz::from_load([20.0; 2], contact_modulus([Some(&steel); 2]), 10.2);
/// let hertz = hertz.ok_or("no contact of Hertz")?;
/// assert!((approach - hertz.approach).abs() <= error && error <= 0.01 * approach);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// If a run cannot be built, a companion fails, or elements are too few to begin with.
pub fn settle(
    accuracy: f64,
    grid: Grid,
    build: &mut Build<'_>,
    watch: &mut Watch<'_>,
) -> Result<SettledRun, AccuracyFailure> {
    let mut search = Search { accuracy, grid, build, watch };
    // How fine a grid is, relative to the one at the beginning.
    let mut fineness = 1.0;
    // The first grid whose error gives an order: how fine it is, and how far off.
    let mut first: Option<[f64; 2]> = None;
    let mut reached: Option<(Grid, Judges)> = None;
    let mut too_coarse = None;
    loop {
        if reached.is_some() && (search.watch)(Event::Judged).is_err() {
            break;
        }
        let (mut own, judged) = match search.judged() {
            Err(cause) if reached.is_some() && !cause.stops() => break,
            // Finer elements than the memory holds tell no more of a solver that does not converge.
            Err(AccuracyFailure::Build(cause)) => {
                return Err(too_coarse.unwrap_or(AccuracyFailure::Build(cause)));
            }
            judged => judged?,
        };
        let order = order(&own.problem.bodies);
        let judges = match judged {
            Ok(judges) => judges,
            Err(cause) => match search.grid.finer(FINER[1], order) {
                Some(finer) => {
                    search.grid = finer;
                    too_coarse = Some(cause);
                    continue;
                }
                None if reached.is_some() => break,
                None => return Err(cause),
            },
        };
        let errors = judges.places(&own);
        let errors = errors.into_iter().map(|place| judges.companions.worst_foreseen(place));
        let error = errors.fold(0.0, f64::max);
        // Finer steps do not reduce the error of elements that are given.
        if error <= accuracy || !search.grid.refines {
            own.companions = Some(judges.companions);
            return Ok(SettledRun { simulation: own, grid: search.grid });
        }
        reached = Some((search.grid.clone(), judges));
        // The order follows from errors that are smaller than the value.
        if error < 1.0 {
            let [coarse, off] = *first.get_or_insert([fineness, error]);
            let observed = (off / error).ln() / (fineness / coarse).ln();
            let needed = (error / accuracy).powf(1.0 / observed.max(0.0));
            let elements = search.grid.elements.map(|n| needed * n as f64);
            if fineness >= TOLD * coarse && elements.iter().any(|&n| n > MOST as f64) {
                break;
            }
        }
        let finer = (MARGIN * (error / accuracy).powf(1.0 / order)).clamp(FINER[0], FINER[1]);
        let Some(grid) = search.grid.finer(finer, order) else { break };
        search.grid = grid;
        fineness *= finer;
    }
    search.falls_short(reached)
}

/// Coarser runs, and how far all of them go where one was ended.
struct Judges {
    companions: Companions,
    end: Option<f64>,
}

impl Judges {
    /// The outputs of a run that they judge, and where they end.
    fn places(&self, own: &Simulation) -> Vec<f64> {
        let mut places = own.schedule.outputs.clone();
        if let Some(end) = self.end {
            places.retain(|place| *place < end);
            places.push(end);
        }
        places
    }
}

/// What is sought, and for whom.
struct Search<'a, 'b> {
    accuracy: f64,
    grid: Grid,
    build: &'a mut Build<'b>,
    watch: &'a mut Watch<'b>,
}

impl Search<'_, '_> {
    /// The run on the grid as it is, and what coarser runs say of it: or why no solution is found on so few elements.
    fn judged(&mut self) -> Result<(Simulation, Result<Judges, AccuracyFailure>), AccuracyFailure> {
        let own = (self.build)(&self.grid).map_err(AccuracyFailure::Build)?;
        let across = across(&own);
        if across < UNWORN * (1.0 - SAME) {
            return Err(AccuracyFailure::TooFew(across));
        }
        let set = if axes(&own) == 1 { OF_LINES } else { COARSER };
        let first = &self.grid.clone();
        let coarser = |(ratio, moved)| first.coarser(&own, ratio, moved);
        let mut left = VecDeque::from(set.map(coarser));
        let plans: Vec<_> = left.iter().chain([first]).map(|grid| grid.elements).collect();
        self.tell(first, Event::Plans(&plans))?;
        let mut runs: Vec<Companion> = vec![];
        let (mut failed, mut ended) = (None, false);
        while let Some(grid) = left.pop_front() {
            match self.run(&grid) {
                Ok((rows, enough)) => {
                    ended |= enough;
                    if runs.is_empty() && rows.len() == 1 {
                        left.push_back(coarser(OF_ONE));
                    }
                    runs.push(Companion { ratio: grid.beside(first, axes(&own)), rows });
                }
                Err(AccuracyFailure::Run { elements, cause }) if cause.is_of_convergence() => {
                    failed = Some(AccuracyFailure::Run { elements, cause });
                }
                Err(error) => return Err(error),
            }
        }
        let end = ended.then(|| end(&runs));
        let companions = Companions::new(runs, regularity(&own), self.accuracy);
        match failed {
            Some(cause) if !companions.foresee() && self.grid.refines => Ok((own, Err(cause))),
            Some(cause) if !companions.foresee() => Err(cause),
            _ => Ok((own, Ok(Judges { companions, end }))),
        }
    }

    /// Tells who watches of a run on a grid.
    fn tell(&mut self, grid: &Grid, event: Event<'_>) -> Result<(), AccuracyFailure> {
        (self.watch)(event).map_err(|cause| {
            let cause = Box::new(Error::Observer(cause));
            AccuracyFailure::Run { elements: grid.elements, cause }
        })
    }

    /// The rows of a run, and whether it was ended before its end.
    fn run(&mut self, grid: &Grid) -> Result<(Vec<Row>, bool), AccuracyFailure> {
        let elements = grid.elements;
        let simulation = (self.build)(grid).map_err(AccuracyFailure::Build)?;
        self.tell(grid, Event::Begins(elements))?;
        let mut watched = Watched { rows: vec![], enough: false, watch: self.watch };
        match simulation.run(&mut [&mut watched]) {
            Ok(_) => Ok((watched.rows, watched.enough)),
            Err(cause) => Err(AccuracyFailure::Run { elements, cause: Box::new(cause) }),
        }
    }

    /// The run on the finest grid that was judged, which is not fine enough.
    fn falls_short(
        mut self,
        reached: Option<(Grid, Judges)>,
    ) -> Result<SettledRun, AccuracyFailure> {
        let Some((grid, judges)) = reached else {
            return Err(AccuracyFailure::Build("no grid was found that can be judged".into()));
        };
        let mut own = (self.build)(&grid).map_err(AccuracyFailure::Build)?;
        let at = |place: f64| (judges.companions.worst_foreseen(place), place);
        // The first of those that are equal.
        let errors = judges.places(&own).into_iter().rev().map(at);
        let (error, place) =
            errors.max_by(|one, other| one.0.total_cmp(&other.0)).unwrap_or_default();
        let tip = has_tip(&own.problem.bodies);
        let why = AccuracyFailure::TooCoarse {
            elements: grid.elements,
            error,
            place: own.problem.motion.progress.at(place),
            asked: self.accuracy,
            hint: if tip { "; outputs once the tip is worn take fewer" } else { "" },
        };
        self.tell(&grid, Event::FallsShort(&why))?;
        own.companions = Some(judges.companions);
        Ok(SettledRun { simulation: own, grid })
    }
}

/// Elements across the first contact, or across the frame where no closed form gives it.
fn across(own: &Simulation) -> f64 {
    let frame = &own.problem.frame;
    let contact = Subject::from(&own.problem).contact(own.schedule.control);
    let elements = (0..axes(own)).map(|axis| {
        let across = contact.map_or(frame.size()[axis], |contact| 2.0 * contact.semi_axes[axis]);
        across / frame.spacing()[axis]
    });
    elements.fold(f64::INFINITY, f64::min)
}

/// How far all runs go.
fn end(runs: &[Companion]) -> f64 {
    let last = |run: &Companion| run.rows.last().map_or(f64::INFINITY, |row| row[0].1);
    runs.iter().map(last).fold(f64::INFINITY, f64::min)
}

/// The rows of a run, whether they are enough, and who is shown it.
struct Watched<'a, 'b> {
    rows: Vec<Row>,
    enough: bool,
    watch: &'a mut Watch<'b>,
}

impl Observer for Watched<'_, '_> {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Failed> {
        self.rows.push(history::row(report));
        match (self.watch)(Event::Shows(report)) {
            Err(cause) if cause.is::<Enough>() => self.enough = true,
            told => told?,
        }
        Ok(())
    }

    fn ends(&self) -> bool {
        self.enough
    }
}
