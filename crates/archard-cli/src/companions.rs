//! The runs on coarser grids that come before one with an `accuracy`.

use std::time::{Duration, Instant};

use archard::accuracy::{AccuracyFailure, Event, Failed};
use archard::simulation::{Error, Observer, Simulation};
use archard::units::{self, Measure};
use archard_case::{Case, RunnableCase, Task};

use crate::arguments::Run;
use crate::equations::Equations;
use crate::failure::Failure;
use crate::interrupt::{Interruption, Watch};
use crate::progress::Follower;
use crate::run::one_thread;

/// How long a grid is sought; `None` for as long as it takes.
///
/// # Errors
/// If the argument says no time, or the task asks for no accuracy.
pub fn budget(task: &Task, arguments: &Run) -> Result<Option<Duration>, Failure> {
    let budget = arguments.budget.as_deref().map(time).transpose()?;
    let seeks = matches!(task, Task::Contact(resolved) if resolved.case.accuracy.is_some());
    if budget.is_some() && !seeks {
        let message = "--budget: no `accuracy` is asked for that a grid is sought for";
        return Err(Failure::Wrong(message.to_owned()));
    }
    Ok(budget)
}

/// A case on the elements that its accuracy takes.
pub struct SettledCase {
    /// The case.
    pub resolved: RunnableCase,
    /// Its simulation.
    pub simulation: Simulation,
    /// What is doubtful about kept compliances.
    pub doubts: Vec<String>,
    /// When it began; runs on coarser grids are none of its time.
    pub begun: Instant,
}

/// A case on the elements that its accuracy takes, which are sought as long as a budget lasts.
pub fn settle(
    resolved: RunnableCase,
    watch: &Watch,
    follower: &mut Follower,
    arguments: &Run,
    budget: Option<Duration>,
) -> Result<SettledCase, Failure> {
    let (begun, mut watching, store) = (Instant::now(), watch.clone(), arguments.store());
    let (small, sought) = (resolved.case.is_small(), resolved.case.accuracy.is_some());
    let equations = Equations::new(follower.bar(), arguments.quiet);
    let mut watched = |event: Event<'_>| -> Result<(), Failed> {
        match event {
            Event::Plans(elements) => follower.plan(elements),
            Event::Begins([nx, ny]) => {
                let what = format!("estimating the discretisation error: {nx} x {ny} elements");
                follower.begin_before(what);
            }
            Event::Shows(report) => {
                follower.observe(report)?;
                watching.observe(report)?;
            }
            Event::Judged if budget.is_some_and(|budget| begun.elapsed() >= budget) => {
                return Err("the budget is spent".into());
            }
            Event::Judged => {}
            Event::FallsShort(why) => {
                follower.tell(&format!("{why}; the run goes on with that"));
            }
        }
        Ok(())
    };
    let settle = || {
        let mut build = |case: &_| {
            Ok(Case::build_telling(case, store.as_ref(), &|making| equations.are(making))?)
        };
        resolved.settle(&mut build, &mut watched)
    };
    let settled = match arguments.threads.is_none() && small {
        true => one_thread()?.install(settle),
        false => settle(),
    };
    equations.done();
    let (resolved, simulation) = settled.map_err(failure)?;
    if sought {
        follower.tell(&grid(&resolved));
    }
    let doubts = store.map(|store| store.doubts()).unwrap_or_default();
    let begun = if sought { Instant::now() } else { begun };
    Ok(SettledCase { resolved, simulation, doubts, begun })
}

/// A time that is given for the search.
fn time(text: &str) -> Result<Duration, Failure> {
    let wrong = |why: String| Failure::Wrong(format!("--budget {text}: {why}"));
    let seconds = units::read(text, &Measure::TIME).map_err(|error| wrong(error.to_string()))?;
    let budget = Duration::try_from_secs_f64(seconds).map_err(|error| wrong(error.to_string()))?;
    if budget.is_zero() {
        Err(wrong("no grid is judged in no time".to_owned()))
    } else {
        Ok(budget)
    }
}

/// "the run takes 64 x 64 elements on 1.2 mm x 1.2 mm".
fn grid(resolved: &RunnableCase) -> String {
    let frame = &resolved.case.frame;
    let [x, y] = frame.size.map(|size| format!("{:.4} mm", 1e3 * size));
    let [nx, ny] = frame.elements;
    let grid = format!("the run takes {nx} x {ny} elements on {x} x {y}");
    let places = &resolved.case.doubles;
    match resolved.case.motion.build() {
        Ok((motion, _)) if !places.is_empty() => {
            let progress = motion.progress;
            let places: Vec<_> = places.iter().map(|&place| progress.length(place)).collect();
            format!("{grid}, twice as large from {} {} on", progress.name, places.join(", "))
        }
        _ => grid,
    }
}

fn failure(error: AccuracyFailure) -> Failure {
    let message = error.to_string();
    let AccuracyFailure::Run { cause, .. } = &error else { return Failure::Wrong(message) };
    match &**cause {
        Error::Observer(cause) if cause.is::<Interruption>() => {
            Failure::Interrupted(format!("{Interruption} before the run had begun"))
        }
        cause if cause.is_of_convergence() => Failure::NotConverged(message),
        _ => Failure::Wrong(message),
    }
}
