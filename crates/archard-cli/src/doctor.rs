//! `archard doctor`: what the machine has, what it does with it, and whether results come out right on it.

use std::fs;
use std::num::NonZero;
use std::path::Path;
use std::thread::available_parallelism;
use std::time::Instant;

use archard::numerics::single::lanes;
use archard::simulation::history::{self, number};
use archard::simulation::{Observer, Report};
use archard_case::output::Store;
use archard_case::{CaseFile, Task, free_memory};

use crate::builtin::CASES;
use crate::failure::Failure;
use crate::say::say;

/// Examines the machine and runs a self-test.
pub fn doctor() -> Result<(), Failure> {
    say(&format!("archard            {}", env!("CARGO_PKG_VERSION")))?;
    say(&format!("system             {} on {}", std::env::consts::OS, std::env::consts::ARCH))?;
    let threads = available_parallelism().map_or(1, NonZero::get);
    say(&format!("threads            {threads}"))?;
    say(&format!("vectors            {} numbers of double precision at once", lanes()))?;
    say(&format!("memory             {:.1} GB free", 1e-9 * free_memory()))?;
    say(&format!("cache              {}", cache()))?;
    let begun = Instant::now();
    let found = [pressure(), depth(), creep_force()];
    let seconds = begun.elapsed().as_secs_f64();
    let mut wrong = vec![];
    for outcome in found {
        match outcome {
            Ok(line) => say(&format!("self-test          {line}"))?,
            Err(line) => wrong.push(line),
        }
    }
    if wrong.is_empty() {
        say(&format!("                   passed in {seconds:.1} s"))
    } else {
        Err(Failure::NotConverged(format!("the self-test failed: {}", wrong.join("; "))))
    }
}

/// Where compliances are kept, whether that can be written to, and what it holds.
fn cache() -> String {
    let store = std::env::var_os("ARCHARD_CACHE").map(|dir| Store::new(Path::new(&dir)));
    let Some(store) = store.or_else(Store::of_user) else {
        return "none: no folder of the user, compliances of meshed bodies are not kept".to_owned();
    };
    let folder = store.folder();
    let Ok(entries) = fs::read_dir(folder) else {
        return format!("{} (not there yet)", folder.display());
    };
    let sizes: Vec<u64> =
        entries.flatten().filter_map(|entry| Some(entry.metadata().ok()?.len())).collect();
    let megabytes = 1e-6 * sizes.iter().sum::<u64>() as f64;
    let locked = fs::metadata(folder).is_ok_and(|data| data.permissions().readonly());
    let state = if locked { ", which cannot be written to" } else { "" };
    format!("{} ({} files, {megabytes:.0} MB){state}", folder.display(), sizes.len())
}

/// The peak pressure of a ball on a flat against Hertz's.
fn pressure() -> Result<String, String> {
    let (row, task) = last_row("hertz", &[])?;
    let Task::Contact(resolved) = task else { return Err("no contact".to_owned()) };
    let expected = resolved.forecast.estimate.contact.ok_or("no closed form")?.peak_pressure;
    let found = number(&row, history::PEAK_PRESSURE).ok_or("no peak pressure")?;
    compared("peak pressure of a ball, against Hertz", found, expected, 5e-3)
}

/// The depth of a pin after 500 mm against an independent axisymmetric solution.
fn depth() -> Result<String, String> {
    let (row, _) = last_row("pin_on_disc", &[])?;
    let found = number(&row, history::WEAR_DEPTH).ok_or("no depth")?;
    compared("worn depth of a pin, against an axisymmetric solution", found, 2.059002e-6, 6e-3)
}

/// The creep force of rolling cylinders at half of saturation against Carter's, three quarters of mu P.
fn creep_force() -> Result<String, String> {
    let (row, _) = last_row("carter", &["accuracy=0.001"])?;
    let found = number(&row, history::FORCE[0]).ok_or("no force")?;
    compared("creep force of cylinders, against Carter", found, 0.75 * 2154.24, 5e-4)
}

fn compared(what: &str, found: f64, expected: f64, within: f64) -> Result<String, String> {
    let off = found / expected - 1.0;
    let line = format!("{what}: off by {:.1e}", off.abs());
    if off.abs() <= within { Ok(line) } else { Err(format!("{line}, {within:e} is allowed")) }
}

/// The last row of a run of a built-in case, and what was run.
fn last_row(name: &str, options: &[&str]) -> Result<(history::Row, Task), String> {
    struct Last(history::Row);
    impl Observer for Last {
        fn observe(
            &mut self,
            report: &Report<'_>,
        ) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
            self.0 = history::row(report);
            Ok(())
        }
    }
    let builtin = CASES.iter().find(|builtin| builtin.name == name).ok_or("no such case")?;
    let file = CaseFile::from_text(name, builtin.text, "");
    let file = options.iter().fold(file, |file, option| file.set(*option));
    let task = file
        .task()
        .map_err(|problems| problems.first().map(|problem| problem.title()).unwrap_or_default())?;
    let mut last = Last(vec![]);
    if let Task::Contact(resolved) = &task {
        let simulation = resolved.case.build().map_err(|error| error.to_string())?;
        simulation.run(&mut [&mut last]).map_err(|error| error.to_string())?;
    }
    Ok((last.0, task))
}
