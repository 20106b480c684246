//! The runs on coarser grids that come before one with an `accuracy`.

use std::error::Error as StdError;
use std::time::{Duration, Instant};

use archard::simulation::{Companions, Error, Observer, Report};
use archard::units::{self, Measure};
use archard_case::{Following, Resolved, Task, Unsettled};

use crate::arguments::Run;
use crate::failure::Failure;
use crate::interrupt::{Interrupted, Watch};
use crate::progress::Follower;
use crate::run::one_thread;

/// Shows them, and ends where that is asked for.
struct Follow<'a> {
    watch: Watch,
    follower: &'a mut Follower,
    begun: Instant,
    budget: Option<Duration>,
}

impl Following for Follow<'_> {
    fn plans(&mut self, elements: &[[usize; 2]]) {
        self.follower.plan(elements);
    }

    fn begins(&mut self, [nx, ny]: [usize; 2]) {
        let what = format!("estimating the discretisation error: {nx} x {ny} elements");
        self.follower.begin_before(what);
    }

    fn observer(&mut self) -> &mut dyn Observer {
        self
    }

    fn goes_on(&mut self) -> bool {
        self.budget.is_none_or(|budget| self.begun.elapsed() < budget)
    }

    fn falls_short(&mut self, why: &Unsettled) {
        self.follower.tell(&format!("{why}; the run goes on with that"));
    }
}

impl Observer for Follow<'_> {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        self.follower.observe(report)?;
        self.watch.observe(report)
    }
}

/// The task on the elements that its accuracy takes, and what says how far off they are.
pub fn settle(
    task: Task,
    (watch, follower): (&Watch, &mut Follower),
    arguments: &Run,
) -> Result<(Task, Option<Companions>), Failure> {
    let budget = arguments.budget.as_deref().map(budget).transpose()?;
    let resolved = match task {
        Task::Contact(resolved) if resolved.case.accuracy.is_some() => resolved,
        task if budget.is_none() => return Ok((task, None)),
        _ => {
            let message = "--budget: no `accuracy` is asked for that a grid is sought for";
            return Err(Failure::Wrong(message.to_owned()));
        }
    };
    let store = arguments.store();
    let small = arguments.threads.is_none() && resolved.case.is_small();
    let mut follow = Follow { watch: watch.clone(), follower, begun: Instant::now(), budget };
    let settle = || resolved.with_companions(store.as_ref(), &mut follow);
    let settled = if small { one_thread()?.install(settle) } else { settle() };
    let (resolved, companions) = settled.map_err(failure)?;
    if companions.is_some() {
        follower.tell(&grid(&resolved));
    }
    Ok((Task::Contact(Box::new(resolved)), companions))
}

/// A time that is given for the search.
fn budget(text: &str) -> Result<Duration, Failure> {
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
fn grid(resolved: &Resolved) -> String {
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

fn failure(error: Unsettled) -> Failure {
    let message = error.to_string();
    let Unsettled::Run { cause, .. } = &error else { return Failure::Wrong(message) };
    match &**cause {
        Error::Observer(cause) if cause.is::<Interrupted>() => {
            Failure::Interrupted(format!("{Interrupted} before the run had begun"))
        }
        cause if cause.is_of_convergence() => Failure::NotConverged(message),
        _ => Failure::Wrong(message),
    }
}
