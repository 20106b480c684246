//! `archard fit`: wear coefficients of a case from measured tests.

use std::error::Error as StdError;
use std::fs;
use std::path::Path;

use archard::simulation::{Observer, Report};
use archard_case::Task;
use archard_case::files::Inputs;
use archard_case::measured::surface::Surface;
use archard_case::output::{Manifest, Store};
use archard_lab::{Error, Files, Fit, Request, RunFollower};

use crate::arguments::{Fit as Arguments, Run};
use crate::diagnose;
use crate::failure::Failure;
use crate::folder;
use crate::interrupt::{Interruption, Requests};
use crate::plot;
use crate::progress::Follower;
use crate::say::{on_terminal, say, tell};
use crate::table;
use crate::verdict;

/// Fits a case to a table.
pub fn fit(arguments: &Arguments) -> Result<(), Failure> {
    let file = diagnose::read(&arguments.case)?;
    let task = diagnose::checked(&file, arguments.quiet)?;
    let names = table::names(&arguments.column).map_err(Failure::wrong)?;
    // Columns of the surfaces that the table names.
    let (of_files, of_table): (Vec<_>, Vec<_>) =
        names.into_iter().partition(|(name, _)| Surface::has_column(name));
    let table = table::read(&arguments.data, &of_table).map_err(Failure::wrong)?;
    let dir = arguments.output.clone().unwrap_or_else(|| {
        let mut name =
            folder::default(&arguments.case.case, &arguments.case.settings()).into_os_string();
        name.push("_fit");
        name.into()
    });
    let uncertain: Vec<(String, f64)> = arguments
        .uncertain
        .iter()
        .map(|option| relative(option))
        .collect::<Result<_, _>>()
        .map_err(Failure::wrong)?;
    let wrong = |error: archard_case::output::Error| Failure::wrong(error.to_string());
    // Before the runs: they may take long, and are for nothing where their results find no place.
    let folder = arguments.data.parent().unwrap_or(Path::new(""));
    let cells = table.names().filter_map(|name| table.texts(name)).flatten();
    let named = cells.map(|cell| folder.join(cell)).filter(|path| path.is_file());
    let others = named.chain([arguments.data.clone()]);
    let inputs = Inputs::of(file.inputs().paths().map(Path::to_owned).chain(others));
    Manifest::spare_below(&dir, &inputs).map_err(wrong)?;
    let manifest = Manifest::read(&dir).map_err(wrong)?.sparing(inputs);
    FILES.iter().try_for_each(|name| manifest.admit(name).map(|_| ())).map_err(wrong)?;
    plot::admit_fit(&dir).map_err(|error| Failure::because(&error))?;
    let made = !dir.exists();
    fs::create_dir_all(&dir)
        .map_err(|error| Failure::wrong(format!("cannot make `{}`: {error}", dir.display())))?;
    let store = arguments.cache.clone().map(Store::new).or_else(Store::of_user);
    let mut follow = Follow::new(arguments.quiet);
    let request = Request {
        parameters: &arguments.parameter,
        uncertain: &uncertain,
        // What was put into the case on the command line was told, too.
        assumed: &[arguments.assume.clone(), arguments.case.settings()].concat(),
        files: Files { folder, columns: &of_files },
        dir: &dir,
        store: store.as_ref(),
        following: &mut follow,
    };
    let found = archard_lab::fit(&file, &table, request);
    follow.end();
    let found = found.map_err(|error| {
        if made {
            // Where runs were made for it, it is not empty and stays.
            let _ = fs::remove_dir(&dir);
        }
        failed(&error)
    })?;
    write(&dir, manifest, &found, &task.case_toml())?;
    if !arguments.quiet {
        say(found.to_string().trim_end())?;
        say(&format!("runs              {}", found.runs))?;
        say(&format!("results           {}", dir.display()))?;
    }
    verdict::doubts(&found.verdict(), arguments.quiet);
    if let Some(why) = found.rejected() {
        return Err(Failure::NotConverged(why));
    }
    match &task {
        Task::Contact(resolved) if !resolved.case.until.is_empty() => life(arguments, &dir),
        _ => Ok(()),
    }
}

/// Runs the case with its limits at the medians, into a folder of the fit: how long it lasts, and how lives scatter.
fn life(arguments: &Arguments, dir: &Path) -> Result<(), Failure> {
    let run = Run {
        case: Some(arguments.case.case.clone()),
        set: arguments.case.set.clone(),
        accuracy: arguments.case.accuracy.clone(),
        until: arguments.case.until.clone(),
        from: Some(dir.join("fit.json")),
        assume: arguments.assume.clone(),
        output: Some(dir.join("life")),
        // It is a part of the fit, as its other runs are.
        force: true,
        cache: arguments.cache.clone(),
        quiet: arguments.quiet,
        ..Run::default()
    };
    crate::run::run(&run)?;
    let drawn = plot::run(&dir.join("life"), &[], &plot::draw::Paper::default());
    drawn.map(|_| ()).map_err(|error| Failure::because(&error))
}

/// Says what is run, and ends it where that is asked for.
pub(crate) struct Follow {
    requests: Requests,
    quiet: bool,
    shown: Option<Follower>,
}

impl Follow {
    pub(crate) fn new(quiet: bool) -> Self {
        Self { requests: Requests::set(), quiet, shown: None }
    }

    /// Clears what is shown.
    pub(crate) fn end(&mut self) {
        self.shown.take().and_then(|shown| shown.bar()).inspect(|bar| bar.finish_and_clear());
    }
}

impl RunFollower for Follow {
    fn begins(&mut self, _: usize, _: &str) {
        self.shown = Some(Follower::new(self.quiet || !on_terminal()));
    }

    fn ended(&mut self, run: usize, settings: &str, seconds: Option<f64>) {
        self.end();
        if !self.quiet {
            let took = seconds.map_or("done before".to_owned(), |took| format!("{took:.1} s"));
            tell(&format!("run {run} ({settings}): {took}"));
        }
    }

    fn observer(&mut self) -> &mut dyn Observer {
        self
    }

    fn stops(&mut self) -> Option<Box<dyn StdError + Send + Sync>> {
        self.requests.any().then(|| Interruption.into())
    }
}

impl Observer for Follow {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        if let Some(shown) = &mut self.shown {
            shown.observe(report)?;
        }
        if self.requests.any() { Err(Interruption.into()) } else { Ok(()) }
    }
}

/// A key and its relative uncertainty, of `motion.sliding.load=1%`.
fn relative(option: &str) -> Result<(String, f64), String> {
    let like = || {
        format!("`{option}`: write a key and its standard uncertainty, like motion.sliding.load=1%")
    };
    let (key, text) = option.split_once('=').ok_or_else(like)?;
    let number = text.trim().strip_suffix('%').ok_or_else(like)?;
    let percent: f64 = number.trim().parse().map_err(|_| like())?;
    Ok((key.trim().to_owned(), percent / 100.0))
}

/// The files of a fit, but for its pictures.
const FILES: [&str; 2] = ["fit.csv", "fit.json"];

fn write(dir: &Path, mut manifest: Manifest, found: &Fit, case_toml: &str) -> Result<(), Failure> {
    let mut told = found.json();
    // As it was given: with the coefficients that it had before.
    told["case"] = case_toml.into();
    let texts = [found.csv(), format!("{told:#}\n")];
    for (name, text) in FILES.into_iter().zip(texts) {
        let written = manifest.write(name, text.as_bytes());
        written.map_err(|error| Failure::wrong(error.to_string()))?;
    }
    plot::draw_fit(dir, found).map(|_| ()).map_err(|error| Failure::because(&error))
}

pub(crate) fn failed(error: &Error) -> Failure {
    match error {
        Error::Stopped { .. } => Failure::Interrupted(error.to_string()),
        error if error.is_of_convergence() => Failure::NotConverged(error.to_string()),
        error => Failure::wrong(error.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::relative;

    #[test]
    fn uncertainties_are_percentages() {
        assert_eq!(
            relative("motion.sliding.load=1 %"),
            Ok(("motion.sliding.load".to_owned(), 0.01))
        );
        for wrong in ["load", "load=1 N", "load=x%"] {
            assert!(relative(wrong).is_err(), "{wrong}");
        }
    }
}
