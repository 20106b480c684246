//! `archard run`: a case through to its result folder.

use std::num::NonZero;
use std::path::Path;

use archard::simulation::{Effort, Error, Observer};
use archard_case::output::{self, Lives, Stresses, Totals};
use archard_case::verdict::{Verdict, Warning};
use archard_case::{Problem, RunnableCase, Task};
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::arguments::{Report, Run};
use crate::cam;
use crate::companions::{self, SettledCase};
use crate::diagnose;
use crate::elastic;
use crate::failure::Failure;
use crate::folder;
use crate::gear;
use crate::interrupt::{self, Interruption, Watch};
use crate::lives::{FitSample, LifeForecast};
use crate::outcome::Outcome;
use crate::progress::Follower;
use crate::report;
use crate::say::tell;
use crate::underway::{self, Underway};
use crate::verdict;
use crate::wheel_rail;

/// Threads a processor may be given at most.
const MOST_THREADS: usize = 8;

/// Runs a case.
pub fn run(arguments: &Run) -> Result<(), Failure> {
    // First of all: whatever works in parallel before it would fix the number of threads.
    set_threads(arguments)?;
    let watch = Watch::set();
    let file = diagnose::read(&arguments.case())?;
    let told = FitSample::of(arguments)?;
    let file = match &told {
        Some(told) => told.put(arguments, file)?,
        None => file,
    };
    let task = diagnose::checked(&file, arguments.quiet)?;
    // The folder next: runs on coarser grids may take long, and are for nothing where it is refused.
    let claim = folder::claim(arguments, &task, file.inputs())?;
    let dir = claim.dir().to_owned();
    watch.hold(claim);
    let outcome = in_folder(&dir, (task, told), &watch, arguments);
    // A folder that is still held has nothing of this run in it.
    if let Some(claim) = watch.release() {
        claim.give_up();
    }
    outcome
}

/// Runs a case in the folder that is held.
fn in_folder(
    dir: &Path,
    (task, told): (Task, Option<FitSample>),
    watch: &Watch,
    arguments: &Run,
) -> Result<(), Failure> {
    let mut follower = Follower::new(arguments.quiet);
    let budget = companions::budget(&task, arguments)?;
    match &task {
        Task::Contact(resolved) => {
            let resolved = RunnableCase::clone(resolved);
            let settled = companions::settle(resolved, watch, &mut follower, arguments, budget)?;
            let small = settled.resolved.case.is_small();
            let resolved = &settled.resolved;
            let foresee =
                |told: FitSample| told.foresee(resolved, arguments, (watch, &mut follower));
            let lives = told.map(foresee).transpose()?.flatten();
            let contact = || contact((settled, lives), watch, follower, (arguments, dir));
            match arguments.threads.is_none() && small {
                true => one_thread()?.install(contact),
                false => contact(),
            }
        }
        Task::Cam(_) | Task::Elastic(_) | Task::Gear(_) if arguments.resume.is_some() => {
            Err(Failure::wrong("this case is solved at once: there is no run to go on with"))
        }
        Task::Elastic(resolved) => {
            elastic::run(resolved, watch, [arguments.quiet, arguments.verbose])
        }
        Task::Cam(resolved) => cam::run(resolved, watch, [arguments.quiet, arguments.verbose]),
        Task::Gear(resolved) => gear::run(resolved, watch, [arguments.quiet, arguments.verbose]),
        Task::WheelRail(resolved) => wheel_rail::run(resolved, watch, &mut follower, arguments),
    }
}

/// Runs a case of two bodies in contact in the folder that is held.
fn contact(
    (settled, lives): (SettledCase, Option<LifeForecast>),
    watch: &Watch,
    mut follower: Follower,
    (arguments, dir): (&Run, &Path),
) -> Result<(), Failure> {
    let SettledCase { resolved, simulation, doubts, begun } = settled;
    let RunnableCase { case, forecast, warnings, .. } = &resolved;
    follower.begin();
    if !arguments.quiet {
        doubts.iter().for_each(|doubt| tell(&format!("warning: {doubt}\n")));
        if let Some(surfaces) = forecast.surfaces {
            tell(&format!("The surfaces {surfaces} (`motion.fretting.surfaces`).\n"));
        }
    }
    let doubts = doubts.into_iter().map(Warning::from);
    let warnings = warnings.iter().map(Problem::warning_of).chain(doubts).collect();
    let mut kept = None;
    let begin = |claim: output::Claim| {
        let (folder, command) = match arguments.resume {
            None => {
                let claim = claim.until(case.until.clone());
                (claim.begin(&case.to_string())?, underway::command())
            }
            Some(_) => {
                // Going on removes the summary.
                let commands = underway::commands(dir);
                let (folder, run) = claim.resume(&simulation)?;
                kept = Some(run);
                (folder, commands)
            }
        };
        Ok(Underway { folder, begun, command, warnings, bar: follower.bar() })
    };
    watch.begin(begin).map_err(|error| Failure::wrong(error.to_string()))?;
    let mut inside = case.inside().keeping(arguments.store());
    let mut watching = watch.clone();
    let observers: &mut [&mut dyn Observer] = &mut [&mut watching, &mut follower, &mut inside];
    let outcome = match kept {
        None => simulation.run(observers),
        Some(run) => simulation.resume(&run, observers),
    };
    let mut stresses = Stresses::default();
    let outcome = outcome.map_err(|error| failure(error, dir)).and_then(|effort| {
        let written = inside.write(dir, &simulation.problem);
        stresses = written.map_err(|error| Failure::wrong(error.to_string()))?;
        Ok(effort)
    });
    let mut life = watch.life();
    // Of a run that failed no life is known.
    let lives = lives.filter(|_| outcome.is_ok()).map(|lives| lives.about(&life));
    lives.iter().for_each(|lives| life.scatter(lives.clone()));
    let below = stresses.json();
    let (totals, judged, effort) = finish(watch, (lives, stresses), outcome)?;
    let page = match arguments.report {
        true => Some(report::run(&Report { dirs: vec![dir.to_owned()], ..Report::default() })),
        false => None,
    };
    let page = page.transpose().map_err(|error| Failure::because(&error))?;
    if !arguments.quiet {
        let outcome = Outcome {
            simulation: &simulation,
            life: &life,
            forecast,
            follower: &follower,
            totals: &totals,
            stresses: &below,
            effort,
            verdict: &judged,
            verbose: arguments.verbose,
            dir,
            page,
        };
        outcome.say()?;
    }
    verdict::judge(&judged, dir, arguments.quiet)
}

/// Finishes the results of a run, whatever came of it.
fn finish(
    watch: &Watch,
    (lives, stresses): (Option<Lives>, Stresses),
    outcome: Result<Effort, Failure>,
) -> Result<(Totals, Verdict, Effort), Failure> {
    let Some(mut results) = watch.end() else {
        return Err(Failure::wrong("the run has no results"));
    };
    lives.into_iter().for_each(|lives| results.folder.scatter(lives));
    results.folder.stressed(stresses);
    let cause = outcome.as_ref().err().map(Failure::cause);
    match (results.finish(cause), outcome) {
        (Ok((totals, verdict)), Ok(effort)) => Ok((totals, verdict, effort)),
        (Err(error), Ok(_)) => Err(Failure::wrong(error.to_string())),
        (Ok(_), Err(failure)) => Err(failure),
        (Err(error), Err(failure)) => Err(failure.and(&error)),
    }
}

fn set_threads(arguments: &Run) -> Result<(), Failure> {
    let Some(threads) = arguments.threads else { return Ok(()) };
    let processors = std::thread::available_parallelism().map_or(1, NonZero::get);
    if threads.get() > MOST_THREADS * processors {
        let message = format!("--threads {threads}: this machine has {processors} processors");
        return Err(Failure::wrong(message));
    }
    ThreadPoolBuilder::new()
        .num_threads(threads.get())
        .build_global()
        .map_err(|error| Failure::wrong(format!("cannot start {threads} threads: {error}")))
}

/// One thread, for small contacts.
pub fn one_thread() -> Result<ThreadPool, Failure> {
    let pool = ThreadPoolBuilder::new().num_threads(1).build();
    pool.map_err(|error| Failure::wrong(format!("cannot start a thread: {error}")))
}

/// What an unfinished run means for the exit code.
fn failure(error: Error, dir: &Path) -> Failure {
    // A folder that was removed has nothing left to point at.
    let kept = match dir.join("history.csv").is_file() {
        true => format!("\nwhat was computed so far is in {}", dir.display()),
        false => String::new(),
    };
    let message = format!("{error}{kept}");
    match error {
        Error::Observer(cause) if cause.is::<Interruption>() => interrupt::with_results(dir),
        Error::Observer(cause) if is_no_number(&*cause) => Failure::NotConverged(message),
        error if error.is_of_convergence() => Failure::NotConverged(message),
        _ => Failure::Wrong(message),
    }
}

/// Whether results are refused because they are no numbers.
fn is_no_number(cause: &(dyn std::error::Error + 'static)) -> bool {
    matches!(cause.downcast_ref(), Some(output::Error::NotFinite { .. }))
}
