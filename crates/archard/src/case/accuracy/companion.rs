//! Runs on half and on a quarter of the elements, before the run itself: they say how far off its elements will be.

use std::error::Error as StdError;

use super::kind::{has_tip, kind, order};
use super::{BESIDE, MOST, OF_ELEMENTS, around, counted, increments, locate};
use crate::case::check::{Parts, check};
use crate::case::definition::{BuildError, Case};
use crate::case::file::Resolved;
use crate::case::problem::Severity;
use crate::frame::extent;
use crate::output::Store;
use crate::problem::{Beyond, Overlap};
use crate::simulation::history::{self, Row};
use crate::simulation::{Companion, Error, Observer, Part, Report, Simulation};

/// The fewest elements across the first contact of a companion.
const FEWEST: f64 = 3.0;
/// How many elements the finer companion may have at most, relative to the run along each axis.
const COARSER: f64 = 0.75;
/// Times a grid is made finer, or a frame larger.
const ROUNDS: usize = 12;
/// By how much a frame grows that was outgrown.
const GROWS: f64 = 1.4;
/// A frame closes in on what touches where that leaves less of it than this.
const CLOSES: f64 = 0.8;
/// How much finer a grid becomes beside what the estimate asks for, and at most.
const MARGIN: f64 = 1.15;
const FINER: [f64; 2] = [1.1, 2.0];

/// What follows the runs of companions.
pub trait Following {
    /// These come now, each on so many elements, and then the run itself on those that stand last: until some are found too
    /// few.
    fn plans(&mut self, _: &[[usize; 2]]) {}

    /// One begins, on so many elements.
    fn begins(&mut self, elements: [usize; 2]);

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
    #[error("on {} x {} elements, half as many as were to be taken: {cause}", .elements[0], .elements[1])]
    Run {
        /// Its elements.
        elements: [usize; 2],
        /// Why not.
        cause: Box<Error>,
    },
    /// A frame that is left whatever its size.
    #[error("the contact leaves a frame of {:.3} mm by {:.3} mm: give `frame.size`", 1e3 * .size[0], 1e3 * .size[1])]
    Outgrown {
        /// The largest that was tried (m).
        size: [f64; 2],
    },
    /// A grid that does not become fine enough.
    #[error(
        "the error by the elements stays at {error:.2e} on {} x {} elements at {place}, and {asked} was asked for: ask for less{hint}",
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

/// The rows of a run, which sides of the frame its contact came to, and how far (m) from the middle it reached.
#[derive(Default)]
struct Watched {
    rows: Vec<Row>,
    sides: Sides,
    reach: [f64; 2],
    beyond: Option<Beyond>,
}

/// The lower and the upper side along x, and along y.
type Sides = [[bool; 2]; 2];

impl Observer for Watched {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        self.rows.push(history::row(report));
        let elements = report.problem.frame.elements();
        let pressure = &report.state.pressure;
        let beyond = Beyond::of(report.problem, self.beyond.take());
        if let Some(Overlap { place, .. }) = beyond.overlap(report.problem, report.state) {
            let rectangle = report.problem.frame.rectangle();
            for (axis, sides) in self.sides.iter_mut().enumerate() {
                let off = 2.0 * (place[axis] - rectangle.centre[axis]);
                sides[0] |= off < -rectangle.size[axis];
                sides[1] |= off > rectangle.size[axis];
            }
        }
        self.beyond = Some(beyond);
        let Some(pressed) = extent(elements, |pair| pressure[pair] > 0.0) else { return Ok(()) };
        let spacing = report.problem.frame.spacing();
        for (axis, range) in pressed.into_iter().enumerate().filter(|(axis, _)| elements[*axis] > 1)
        {
            let far = elements[axis] - 2 * range.start.min(elements[axis] - range.end);
            self.reach[axis] = self.reach[axis].max(0.5 * far as f64 * spacing[axis]);
            self.sides[axis][0] |= range.start == 0;
            self.sides[axis][1] |= range.end == elements[axis];
        }
        Ok(())
    }
}

/// What runs on fewer elements came to.
enum Judged {
    /// By a companion, whose contact reached so far (m) from the middle.
    By(Box<Companion>, [f64; 2]),
    /// The contact left the frame at these sides.
    Outgrown(Sides),
    /// On so few elements no solution is found, and why.
    TooCoarse(Unsettled),
}

impl Resolved {
    /// The case with the elements that its accuracy takes, and what says how far off they are; as it is where no accuracy
    /// is asked for.
    ///
    /// # Errors
    /// If a companion fails, the contact leaves every frame that is tried, or no grid is fine enough.
    pub fn with_companion(
        mut self,
        store: Option<&Store>,
        following: &mut dyn Following,
    ) -> Result<(Self, Option<Companion>), Unsettled> {
        let Some(accuracy) = self.case.accuracy else { return Ok((self, None)) };
        let parts = Parts::of(&self.case).map_err(Box::new)?;
        let order = order(&parts);
        // Rolling errs by the elements along it.
        let axis = parts.motion.axis();
        let outputs = self.case.output.places(parts.schedule.extent);
        // The error of the grid that was judged last, and where it is largest.
        let mut last = (f64::INFINITY, 0.0);
        for _ in 0..ROUNDS {
            let (companion, reach) = match self.judged(axis, accuracy, store, following)? {
                Judged::By(companion, reach) => (companion, reach),
                Judged::Outgrown(sides) => {
                    self.case = self.grown(sides)?;
                    self.settle_again()?;
                    continue;
                }
                Judged::TooCoarse(cause) => match self.refine([FINER[1], 1.0]) {
                    Ok(true) => continue,
                    // Finer elements than the memory holds tell no more of a solver that does not converge.
                    Ok(false) | Err(_) => return Err(cause),
                },
            };
            let worst = |part: Part| {
                let at = |&place: &f64| (companion.worst(&companion.row(place), part), place);
                // The first of those that are alike.
                let errors = outputs.iter().rev().map(at);
                errors.max_by(|one, other| one.0.total_cmp(&other.0)).unwrap_or_default()
            };
            let by_part = [Part::Foreseen, Part::Increments].map(worst);
            let errors = by_part.map(|(error, _)| error);
            let error = errors[0] + errors[1];
            let [(_, of_elements), (_, of_increments)] = by_part;
            let place = if errors[0] >= errors[1] { of_elements } else { of_increments };
            last = (error, place);
            let allowed = OF_ELEMENTS * accuracy;
            let chose = [self.chose.elements, self.chose.increments];
            if error <= allowed || chose == [false; 2] {
                return Ok((self, Some(*companion)));
            }
            let times = MOST / self.case.frame.elements[axis] as f64;
            if chose[0] && companion.stays_sharp(&companion.row(of_elements), allowed, times) {
                break;
            }
            // Each may take half of it, or what the other leaves.
            let finer = [(0, order), (1, 1.0)].map(|(part, order)| {
                let left = (allowed - errors[1 - part]).max(0.5 * allowed);
                let wanted = MARGIN * (errors[part] / left).powf(1.0 / order);
                let refines = chose[part] && errors[part] > left;
                if refines { wanted.clamp(FINER[0], FINER[1]) } else { 1.0 }
            });
            if finer == [1.0; 2] {
                return Ok((self, Some(*companion)));
            }
            self.close_in(reach);
            let known = self.case.frame.elements;
            match self.refine(finer) {
                Ok(true) => {}
                Ok(false) => break,
                Err(cause) => {
                    return Err(Unsettled::Wrong(format!(
                        "{accuracy} was asked for, and the error is {error:.1e} on {} x {} elements; on more: {cause}",
                        known[0], known[1]
                    )));
                }
            }
        }
        let (error, place) = last;
        let frame = self.case.frame;
        if error.is_infinite() {
            return Err(Unsettled::Outgrown { size: frame.size });
        }
        let parts = Parts::of(&self.case).map_err(Box::new)?;
        Err(Unsettled::TooCoarse {
            elements: frame.elements,
            error,
            place: parts.motion.progress().at(place),
            asked: accuracy,
            hint: if has_tip(&parts) { ", or for outputs once the tip is worn" } else { "" },
        })
    }

    /// Runs the case on fewer elements, and in fewer increments.
    fn judged(
        &self,
        axis: usize,
        accuracy: f64,
        store: Option<&Store>,
        following: &mut dyn Following,
    ) -> Result<Judged, Unsettled> {
        let elements = self.case.frame.elements;
        let across = self.across();
        if across < FEWEST / COARSER {
            return Err(Unsettled::Wrong(format!(
                "{across:.1} elements across the first contact are too few to tell what they err by: {} at least",
                FEWEST / COARSER
            )));
        }
        let coarser = |by: f64| {
            let share = (1.0 / by).max(FEWEST / across);
            elements.map(|n| if n == 1 { 1 } else { alike(n as f64 * share, n) })
        };
        let own = increments::of_rubbing(&self.case);
        let [half, quarter] = [coarser(2.0), coarser(4.0)];
        let fewer = own.map(|own| [own, increments::fewer(own)]);
        let runs = [(half, own), (quarter, own), (quarter, fewer.map(|[_, fewer]| fewer))];
        let wanted = if fewer.is_some() { 3 } else { 2 };
        let plan = runs.iter().take(wanted).map(|(grid, _)| *grid).chain([elements]);
        following.plans(&plan.collect::<Vec<_>>());
        let mut rows = vec![];
        let mut reach = [0.0; 2];
        for (grid, increments) in runs.into_iter().take(wanted) {
            match self.run(grid, increments, store, following) {
                Ok(run) if self.chose.size && run.sides != Sides::default() => {
                    return Ok(Judged::Outgrown(run.sides));
                }
                Ok(run) => {
                    reach = [0, 1].map(|axis| run.reach[axis].max(reach[axis]));
                    rows.push(run.rows);
                }
                Err(Unsettled::Run { elements, cause })
                    if cause.is_of_convergence() && self.chose.elements =>
                {
                    return Ok(Judged::TooCoarse(Unsettled::Run { elements, cause }));
                }
                Err(error) => return Err(error),
            }
        }
        let numbers = [elements, half, quarter].map(|grid| grid[axis] as f64);
        let mut rows = rows.into_iter();
        let grids = [rows.next(), rows.next()].map(Option::unwrap_or_default);
        let kind = kind(&self.case).map_err(Box::new)?;
        let companion = Companion::new(grids, numbers, kind, accuracy);
        let companion = match (rows.next(), fewer) {
            (Some(fewest), Some(counts)) => companion.with_increments(fewest, counts),
            _ => companion,
        };
        Ok(Judged::By(Box::new(companion), reach))
    }

    /// Takes the frame in, on elements as large as before, where nothing touched in a good part of it.
    fn close_in(&mut self, reach: [f64; 2]) {
        if !(self.chose.size && self.chose.elements && self.case.doubles.is_empty()) {
            return;
        }
        let spacing = self.case.frame.spacing();
        let frame = &mut self.case.frame;
        let axes = if frame.line { 1 } else { 2 };
        for axis in 0..axes {
            let size = around(BESIDE * reach[axis], spacing[axis]);
            if reach[axis] > 0.0 && size < CLOSES * frame.size[axis] {
                frame.size[axis] = size;
                frame.elements[axis] = counted(size / spacing[axis], frame.elements[axis]);
            }
        }
    }

    /// Takes that many times as many elements along each axis, and increments; whether so many are allowed.
    fn refine(&mut self, [elements, increments]: [f64; 2]) -> Result<bool, Unsettled> {
        if elements > 1.0 {
            let refined = |n: usize| if n == 1 { 1 } else { counted(elements * n as f64, n) };
            let refined = self.case.frame.elements.map(refined);
            if refined.iter().any(|&n| n as f64 > MOST) {
                return Ok(false);
            }
            self.case.frame.elements = refined;
        }
        if increments > 1.0 {
            increments::refine(&mut self.case, increments);
        }
        self.settle_again()?;
        Ok(true)
    }

    /// The case in a frame that is larger towards some sides, with elements as large as before where their number was
    /// chosen.
    fn grown(&self, sides: Sides) -> Result<Case, Unsettled> {
        let mut case = self.case.clone();
        let before = case.frame;
        let parts = Parts::of(&self.case).map_err(Box::new)?;
        for (axis, touched) in
            sides.into_iter().enumerate().filter(|(axis, _)| before.elements[*axis] > 1)
        {
            let part = 0.5 * (GROWS - 1.0) * before.size[axis];
            let [below, above] = match self.chose.place {
                true => touched.map(|touched| if touched { part } else { 0.0 }),
                false => [if touched == [false; 2] { 0.0 } else { part }; 2],
            };
            case.frame.centre[axis] += 0.5 * (above - below);
            case.frame.size[axis] += below + above;
        }
        let held = locate::within(case.frame.rectangle(), locate::known(&parts));
        (case.frame.centre, case.frame.size) = (held.centre, held.size);
        if held == before.rectangle() {
            return Err(Unsettled::Outgrown { size: held.size });
        }
        if self.chose.elements {
            for axis in 0..2 {
                let larger = case.frame.size[axis] / before.size[axis];
                if larger > 1.0 {
                    let elements = before.elements[axis];
                    case.frame.elements[axis] = counted(larger * elements as f64, elements);
                }
            }
        }
        Ok(case)
    }

    /// Elements across the first contact; infinitely many where no closed form tells.
    fn across(&self) -> f64 {
        let contact = self.forecast.estimate.contact;
        let spacing = self.case.frame.spacing();
        contact.map_or(f64::INFINITY, |contact| {
            [0, 1]
                .map(|axis| 2.0 * contact.semi_axes[axis] / spacing[axis])
                .into_iter()
                .fold(f64::INFINITY, f64::min)
        })
    }

    /// Runs the case on other elements, in other increments.
    fn run(
        &self,
        elements: [usize; 2],
        increments: Option<usize>,
        store: Option<&Store>,
        following: &mut dyn Following,
    ) -> Result<Watched, Unsettled> {
        let mut case = self.case.clone();
        case.frame.elements = elements;
        if let Some(count) = increments {
            increments::set(&mut case, count);
        }
        let simulation = match store {
            Some(store) => case.build_keeping(store),
            None => case.build(),
        };
        let mut simulation = simulation.map_err(Box::new)?;
        following.prepare(&mut simulation).map_err(Unsettled::Unprepared)?;
        following.begins(elements);
        let mut watched = Watched::default();
        match simulation.run(&mut [&mut watched, following.observer()]) {
            Ok(_) => Ok(watched),
            Err(Error::FrameFull { .. } | Error::SwungOut { .. }) if self.chose.size => {
                Ok(Watched { sides: [[true; 2]; 2], ..watched })
            }
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

/// The number of elements next to some number, even or odd as that of the run: at the apex there is a pair on all grids, or on
/// none.
fn alike(wanted: f64, run: usize) -> usize {
    let odd = run % 2;
    odd + 2 * ((0.5 * (wanted - odd as f64)).round() as usize).max(1)
}
