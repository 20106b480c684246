//! The command `archard` as a library, for the program of that name and the Python package: [`main`], and in [`library`] what it
//! makes of result folders.
//!
//! Exit codes: 0 done, 1 did not converge, 2 the case (or the command line) is wrong, 3 a run was interrupted, by SIGINT
//! (Ctrl-C), SIGTERM or SIGHUP. Other commands leave these signals as they are: they have nothing to save.

mod arguments;
mod below;
mod builtin;
mod cam;
mod check;
mod companions;
mod compare;
mod diagnose;
mod doctor;
mod elastic;
mod equations;
mod failure;
mod fit;
mod fitted;
mod folder;
mod gear;
mod interrupt;
mod laws;
pub mod library;
mod line_contact;
mod lines;
mod lives;
mod log;
mod materials;
mod meant;
mod new;
mod number;
mod outcome;
mod paraview;
mod plot;
mod progress;
mod report;
mod rigs;
mod run;
mod say;
mod shell;
mod standards;
mod surface;
mod sweep;
mod table;
mod underway;
mod validate;
mod verdict;
mod watch;
mod wheel_rail;

use std::ffi::OsString;
use std::path::PathBuf;

use clap::Parser;

use arguments::{Arguments, Command};
use failure::Failure;

/// Does what a command line asks for, the words after `archard`, and returns the exit code.
///
/// A run takes over the signals of the process, and a second one may end it.
pub fn main(words: Vec<OsString>) -> u8 {
    let line = std::iter::once("archard".into()).chain(words.iter().cloned());
    let arguments = match Arguments::try_parse_from(line) {
        Ok(arguments) => arguments,
        Err(error) => return meant::show(error),
    };
    underway::typed(words);
    let outcome = match arguments.command {
        Command::Run(arguments) => run::run(&arguments),
        Command::Check(arguments) => check::check(&arguments),
        Command::New(arguments) => new::new(&arguments),
        Command::Laws { name } => laws::laws(name.as_deref()),
        Command::Materials { name } => materials::materials(name.as_deref()),
        Command::Watch { dir } => watch::watch(&dir),
        Command::Log(arguments) => log::log(&arguments),
        Command::Doctor => doctor::doctor(),
        Command::Surface { file, set, output } => surface::surface(&file, &set, output.as_deref()),
        Command::Completions { shell } => shell::completions(shell),
        Command::Man { dir } => shell::man(&dir),
        Command::Paraview { dir } => paraview::write(&dir),
        Command::Sweep(arguments) => sweep::sweep(&arguments),
        Command::Fit(arguments) => fit::fit(&arguments),
        Command::Validate(arguments) => validate::run(&arguments),
        Command::Report(arguments) => report::run(&arguments)
            .map_err(|error| Failure::because(&error))
            .and_then(|file| say::say(&file.display().to_string())),
        Command::Compare(arguments) => compared(&arguments),
        Command::Plot(arguments) => {
            drawn(&arguments).map_err(|error| Failure::because(&error)).and_then(|files| {
                files.iter().try_for_each(|file| say::say(&file.display().to_string()))
            })
        }
    };
    match outcome {
        Ok(()) => 0,
        Err(failure) => {
            failure.report();
            failure.code()
        }
    }
}

/// Compares two scans, or a run with what is named.
fn compared(arguments: &arguments::Compare) -> Result<(), Failure> {
    let Some(dir) = &arguments.dir else {
        return compare::scans::run(&arguments.scans);
    };
    let (words, files) = compare::run(dir, &arguments.others, &arguments.options)
        .map_err(|error| Failure::because(&error))?;
    words.iter().try_for_each(|line| say::say(line))?;
    files.iter().try_for_each(|file| say::say(&file.display().to_string()))
}

/// Draws what a folder has, or what is asked for of a study.
fn drawn(arguments: &arguments::Plot) -> anyhow::Result<Vec<PathBuf>> {
    let (dir, paper) = (&arguments.dir, arguments.paper());
    match &arguments.quantity[..] {
        [] => plot::run(dir, &arguments.with, &paper),
        columns => plot::of_study(dir, columns, &paper),
    }
}
