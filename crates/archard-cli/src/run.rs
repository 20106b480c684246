//! `archard run`: a case through to its result folder.

use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::time::Instant;

use archard::body::Body;
use archard::case::{Resolved, Task};
use archard::kinematics::{Rolling, Shift};
use archard::output::{Inside, ResultFolder, Totals};
use archard::simulation::{Effort, Error, Simulation};

use crate::arguments::Run;
use crate::diagnose;
use crate::elastic;
use crate::failure::Failure;
use crate::interrupt::{Interrupted, Watch};
use crate::number::{count, energy, four};
use crate::progress::Follower;
use crate::say::say;

/// Threads a processor may be given at most.
const MOST_THREADS: usize = 8;

/// Runs a case.
pub fn run(arguments: &Run) -> Result<(), Failure> {
    // First of all: whatever works in parallel before it would fix the number of threads.
    set_threads(arguments)?;
    let task = diagnose::resolve(&arguments.case, arguments.quiet)?;
    let dir = arguments.output.clone().unwrap_or_else(|| default_folder(&arguments.case.case));
    keep_the_case(&arguments.case.case, &dir)?;
    let Resolved { case, warnings, .. } = match task {
        Task::Contact(resolved) => *resolved,
        Task::Elastic(resolved) => return elastic::run(&resolved, &dir, arguments.quiet),
    };
    let warnings = warnings.iter().map(|warning| warning.title()).collect();
    let mut folder = ResultFolder::create(&dir, &case.to_string())
        .map_err(|error| Failure::wrong(error.to_string()))?;
    let mut follower = Follower::new(arguments.quiet);
    let start = Instant::now();
    let built = match arguments.store() {
        Some(store) => {
            case.build_with(&|finite, material, job| store.condense(finite, material, job))
        }
        None => case.build(),
    };
    let simulation = built.map_err(|error| Failure::wrong(error.to_string()))?;
    let mut watch = Watch::set();
    let mut inside = Inside::at(case.points.clone());
    let outcome = simulation.run(&mut [&mut folder, &mut follower, &mut inside, &mut watch]);
    follower.finish();
    let totals = Totals {
        seconds: start.elapsed().as_secs_f64(),
        threads: rayon::current_num_threads(),
        warnings,
        failure: outcome.as_ref().err().map(ToString::to_string),
    };
    folder.finish(&totals).map_err(|error| Failure::wrong(error.to_string()))?;
    let effort = outcome.map_err(|error| failure(error, &dir))?;
    inside
        .write(&dir, simulation.problem.bodies.each_ref())
        .map_err(|error| Failure::wrong(error.to_string()))?;
    if arguments.quiet {
        return Ok(());
    }
    summarize(&simulation, &follower, &totals, effort, &dir)
}

/// `results/NAME`: the name of the case file, or of its folder where the file is a `case.toml`.
fn default_folder(case: &Path) -> PathBuf {
    let case = case.canonicalize().unwrap_or_else(|_| case.to_owned());
    let named_by_folder = case.file_name().is_some_and(|name| name == "case.toml");
    let name = match case.parent().and_then(Path::file_name) {
        _ if case.is_dir() => case.file_name(),
        Some(folder) if named_by_folder => Some(folder),
        _ => case.file_stem(),
    };
    Path::new("results").join(name.unwrap_or("case".as_ref()))
}

/// Refuses to write the resolved case over the case itself.
fn keep_the_case(case: &Path, dir: &Path) -> Result<(), Failure> {
    let case = if case.is_dir() { case.join("case.toml") } else { case.to_owned() };
    let written = dir.join("case.toml").canonicalize();
    match (case.canonicalize(), written) {
        (Ok(case), Ok(written)) if case == written => Err(Failure::wrong(format!(
            "the results would overwrite the case `{}`; choose another folder with -o",
            case.display()
        ))),
        _ => Ok(()),
    }
}

fn set_threads(arguments: &Run) -> Result<(), Failure> {
    let Some(threads) = arguments.threads else { return Ok(()) };
    let processors = std::thread::available_parallelism().map_or(1, NonZero::get);
    if threads.get() > MOST_THREADS * processors {
        let message = format!("--threads {threads}: this machine has {processors} processors");
        return Err(Failure::wrong(message));
    }
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads.get())
        .build_global()
        .map_err(|error| Failure::wrong(format!("cannot start {threads} threads: {error}")))
}

/// What an unfinished run means for the exit code.
fn failure(error: Error, dir: &Path) -> Failure {
    let message = format!("{error}\nwhat was computed so far is in {}", dir.display());
    match error {
        Error::Observer(cause) if cause.is::<Interrupted>() => Failure::Interrupted(message),
        Error::NotConverged { .. }
        | Error::FrictionNotConverged { .. }
        | Error::NotConsistent { .. }
        | Error::StepTooSmall { .. } => Failure::NotConverged(message),
        Error::FrameFull { .. }
        | Error::NotSymmetric { .. }
        | Error::NotPlane
        | Error::NotPassed(_)
        | Error::NotJoint
        | Error::Observer(_) => Failure::Wrong(message),
    }
}

/// Says what came out and where it is.
fn summarize(
    simulation: &Simulation,
    follower: &Follower,
    totals: &Totals,
    effort: Effort,
    dir: &Path,
) -> Result<(), Failure> {
    let number = |column: &str, factor: f64| four(follower.number(column).unwrap_or(0.0) * factor);
    say(&format!("peak pressure     {} MPa", number("peak_pressure_Pa", 1e-6)))?;
    say(&format!("approach          {} um", number("approach_m", 1e6)))?;
    say(&format!("contact area      {} mm^2", number("contact_area_m2", 1e6)))?;
    if let Some(rolling) = simulation.problem.kinematics.rolling() {
        summarize_rolling(simulation, rolling, follower)?;
    }
    if let Some(shift) = simulation.problem.kinematics.shift() {
        summarize_shift(simulation, shift, follower, effort)?;
    }
    if simulation.problem.wears() {
        say(&format!("wear depth        {} um", number("wear_depth_m", 1e6)))?;
        for Body { name, .. } in &simulation.problem.bodies {
            if let Some(volume) = follower.number(&format!("worn_volume_{name}_m3")) {
                say(&format!("worn volume       {} mm^3 off `{name}`", four(volume * 1e9)))?;
            }
            if let Some(section) = follower.number(&format!("worn_section_{name}_m2")) {
                say(&format!("worn section      {} mm^2 off `{name}`", four(section * 1e6)))?;
            }
        }
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
    let creepage = along_and_across([number("creepage"), number("lateral_creepage")], "");
    say(&format!("creepage          {creepage}"))?;
    if simulation.problem.friction.is_none() {
        return Ok(());
    }
    let [x, y] = [number("force_x_N"), number("force_y_N")];
    let units = [rolling.direction.forward(), rolling.direction.lateral()];
    let force = along_and_across(units.map(|unit| x * unit[0] + y * unit[1]), " N");
    say(&format!("creep force       {force}, on `{}`", simulation.problem.bodies[0].name))?;
    say(&format!("stick area        {} mm^2", four(number("stick_area_m2") * 1e6)))
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
        say(&format!("stick area        {} mm^2", four(number("stick_area_m2") * 1e6)))?;
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
