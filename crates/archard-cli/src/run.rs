//! `archard run`: a case through to its result folder.

use std::num::NonZero;
use std::path::Path;
use std::time::Instant;

use archard::body::Body;
use archard::case::{Forecast, Resolved, Task};
use archard::motion::{Rolling, Shift};
use archard::output::{self, Inside, Totals};
use archard::simulation::history::{
    self, CREEPAGE, FORCE, FRICTIONAL_POWER, MASS_LOSS, STICK_AREA, WORN_SECTION, WORN_VOLUME,
    of_body,
};
use archard::simulation::{Companion, Effort, Error, Observer, Simulation};
use archard::verdict::Verdict;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::arguments::{Report, Run};
use crate::companions;
use crate::diagnose;
use crate::elastic;
use crate::failure::Failure;
use crate::folder;
use crate::interrupt::{self, Interrupted, Watch};
use crate::number::{count, energy, four, mass};
use crate::progress::Follower;
use crate::report;
use crate::say::{say, tell};
use crate::standards;
use crate::underway::Underway;
use crate::verdict;

/// Threads a processor may be given at most.
const MOST_THREADS: usize = 8;

/// Runs a case.
pub fn run(arguments: &Run) -> Result<(), Failure> {
    // First of all: whatever works in parallel before it would fix the number of threads.
    set_threads(arguments)?;
    let watch = Watch::set();
    let task = diagnose::resolve(&arguments.case(), arguments.quiet)?;
    let (task, companion) = companions::settle(task, &watch, arguments)?;
    let case_toml = task.case_toml();
    let claim = folder::claim(arguments, &case_toml)?;
    let dir = claim.dir().to_owned();
    watch.hold(claim);
    let outcome = match &task {
        Task::Contact(resolved) => {
            let contact = || contact(resolved, companion, &case_toml, &watch, (arguments, &dir));
            match arguments.threads.is_none() && resolved.case.is_small() {
                true => one_thread()?.install(contact),
                false => contact(),
            }
        }
        Task::Elastic(_) if arguments.resume.is_some() => {
            Err(Failure::wrong("a body by itself is solved at once: there is no run to go on with"))
        }
        Task::Elastic(resolved) => elastic::run(resolved, &watch, arguments.quiet),
    };
    // A folder that is still held has nothing of this run in it.
    if let Some(claim) = watch.release() {
        claim.give_up();
    }
    outcome
}

/// Runs a case of two bodies in contact in the folder that is held.
fn contact(
    Resolved { case, forecast, warnings, .. }: &Resolved,
    companion: Option<Companion>,
    case_toml: &str,
    watch: &Watch,
    (arguments, dir): (&Run, &Path),
) -> Result<(), Failure> {
    let mut follower = Follower::new(arguments.quiet);
    let begun = Instant::now();
    let store = arguments.store();
    let built = match &store {
        Some(store) => case.build_keeping(store),
        None => case.build(),
    };
    let mut simulation = built.map_err(|error| Failure::wrong(error.to_string()))?;
    simulation.companion = companion;
    let doubts = store.map(|store| store.doubts()).unwrap_or_default();
    if !arguments.quiet {
        doubts.iter().for_each(|doubt| tell(&format!("warning: {doubt}\n")));
        if let Some(surfaces) = forecast.surfaces {
            tell(&format!("The surfaces {surfaces} (`motion.fretting.surfaces`).\n"));
        }
    }
    let warnings = warnings.iter().map(|warning| warning.title()).chain(doubts).collect();
    let mut kept = None;
    let begin = |claim: output::Claim| {
        let folder = match arguments.resume {
            None => claim.begin(case_toml)?,
            Some(_) => {
                let (folder, run) = claim.resume()?;
                kept = Some(run);
                folder
            }
        };
        Ok(Underway { folder, begun, warnings, bar: follower.bar() })
    };
    watch.begin(begin).map_err(|error| Failure::wrong(error.to_string()))?;
    let mut inside =
        Inside::at(case.points.clone()).on(case.sections.clone()).keeping(arguments.store());
    let mut watching = watch.clone();
    let observers: &mut [&mut dyn Observer] = &mut [&mut watching, &mut follower, &mut inside];
    let outcome = match kept {
        None => simulation.run(observers),
        Some(run) => simulation.resume(&run, observers),
    };
    let outcome = outcome.map_err(|error| failure(error, dir)).and_then(|effort| {
        let written = inside.write(dir, simulation.problem.bodies.each_ref());
        written.map_err(|error| Failure::wrong(error.to_string()))?;
        Ok(effort)
    });
    let (totals, judged, effort) = finish(watch, outcome)?;
    if !arguments.quiet {
        summarize((&simulation, forecast), &follower, &totals, effort, dir)?;
        verdict::say_all(&judged)?;
    }
    if arguments.report {
        let page = report::run(&Report { dirs: vec![dir.to_owned()], ..Report::default() });
        let page = page.map_err(|error| Failure::wrong(format!("{error:#}")))?;
        if !arguments.quiet {
            say(&format!("report            {}", page.display()))?;
        }
    }
    verdict::judge(&judged, dir)
}

/// Finishes the results of a run, whatever came of it.
fn finish(
    watch: &Watch,
    outcome: Result<Effort, Failure>,
) -> Result<(Totals, Verdict, Effort), Failure> {
    let Some(results) = watch.end() else {
        return Err(Failure::wrong("the run has no results"));
    };
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
        Error::Observer(cause) if cause.is::<Interrupted>() => interrupt::with_results(dir),
        Error::Observer(cause) if is_no_number(&*cause) => Failure::NotConverged(message),
        error if error.is_of_convergence() => Failure::NotConverged(message),
        _ => Failure::Wrong(message),
    }
}

/// Whether results are refused because they are no numbers.
fn is_no_number(cause: &(dyn std::error::Error + 'static)) -> bool {
    matches!(cause.downcast_ref(), Some(output::Error::NotFinite { .. }))
}

/// Says what came out and where it is.
fn summarize(
    (simulation, forecast): (&Simulation, &Forecast),
    follower: &Follower,
    totals: &Totals,
    effort: Effort,
    dir: &Path,
) -> Result<(), Failure> {
    let number = |column: &str, factor: f64| four(follower.number(column).unwrap_or(0.0) * factor);
    say(&format!("peak pressure     {} MPa", number(history::PEAK_PRESSURE, 1e-6)))?;
    say(&format!("approach          {} um", number(history::APPROACH, 1e6)))?;
    say(&format!("contact area      {} mm^2", number(history::CONTACT_AREA, 1e6)))?;
    if let Some(rolling) = simulation.problem.motion.rolling() {
        summarize_rolling(simulation, rolling, follower)?;
    }
    if let Some(shift) = simulation.problem.motion.shift() {
        summarize_shift(simulation, shift, follower, effort)?;
    }
    if let Some(largest) = follower.number(history::FLASH_TEMPERATURE) {
        let mean = number(history::MEAN_FLASH_TEMPERATURE, 1.0);
        say(&format!("flash temperature {} K at most, {mean} K in the mean", four(largest)))?;
    }
    if simulation.problem.wears() {
        say(&format!("wear depth        {} um", number(history::WEAR_DEPTH, 1e6)))?;
        for Body { name, .. } in &simulation.problem.bodies {
            if let Some(volume) = follower.number(&of_body(WORN_VOLUME, name)) {
                say(&format!("worn volume       {} mm^3 off `{name}`", four(volume * 1e9)))?;
            }
            if let Some(loss) = follower.number(&of_body(MASS_LOSS, name)) {
                say(&format!("mass loss         {} of `{name}`", mass(loss)))?;
            }
            if let Some(section) = follower.number(&of_body(WORN_SECTION, name)) {
                say(&format!("worn section      {} mm^2 off `{name}`", four(section * 1e6)))?;
            }
        }
        for equivalent in &forecast.equivalents {
            say(equivalent.to_string().trim_end())?;
        }
        standards::say_all(&simulation.problem, &follower.last)?;
    }
    let Effort { steps, solves, .. } = effort;
    say(&format!("time              {:.2} s, {steps} steps, {solves} solves", totals.seconds))?;
    say(&format!("results           {}", dir.display()))
}

/// Says how the bodies creep at last and, where there is friction, what they pass on.
fn summarize_rolling(
    simulation: &Simulation,
    rolling: &Rolling,
    follower: &Follower,
) -> Result<(), Failure> {
    let number = |column: &str| follower.number(column).unwrap_or(0.0);
    let creepage = along_and_across(CREEPAGE.map(number), "");
    say(&format!("creepage          {creepage}"))?;
    if simulation.problem.friction.is_none() {
        return Ok(());
    }
    let [x, y] = FORCE.map(number);
    let units = [rolling.direction.forward(), rolling.direction.lateral()];
    let force = along_and_across(units.map(|unit| x * unit[0] + y * unit[1]), " N");
    say(&format!("creep force       {force}, on `{}`", simulation.problem.bodies[0].name))?;
    let intensity = number(FRICTIONAL_POWER) / number(history::CONTACT_AREA);
    say(&format!("T gamma / A       {} N/mm^2, over the contact", four(intensity * 1e-6)))?;
    say(&format!("stick area        {} mm^2", four(number(STICK_AREA) * 1e6)))
}

/// Says what sticks at last, what friction dissipated, and how many cycles were computed where not all were.
fn summarize_shift(
    simulation: &Simulation,
    shift: &Shift,
    follower: &Follower,
    effort: Effort,
) -> Result<(), Failure> {
    if simulation.problem.friction.is_some() {
        let number = |column: &str| follower.number(column).unwrap_or(0.0);
        say(&format!("stick area        {} mm^2", four(number(STICK_AREA) * 1e6)))?;
        let [last, all] = effort.dissipated.map(energy);
        let last =
            if last == all { String::new() } else { format!(", {last} of it in the last cycle") };
        say(&format!("dissipated        {all}{last}"))?;
    }
    let cycles = simulation.schedule.extent / shift.period();
    if effort.true_cycles as f64 >= cycles - 0.5 {
        return Ok(());
    }
    say(&format!("cycles            {}, {} of them computed", count(cycles), effort.true_cycles))
}

/// Two components by the direction of rolling; one that is nothing but rounding beside the other is
/// left out.
fn along_and_across([along, across]: [f64; 2], unit: &str) -> String {
    const ROUNDING: f64 = 1e-6;
    if across.abs() <= ROUNDING * along.abs() {
        format!("{}{unit} along", four(along))
    } else if along.abs() <= ROUNDING * across.abs() {
        format!("{}{unit} across", four(across))
    } else {
        format!("{}{unit} along, {}{unit} across", four(along), four(across))
    }
}
