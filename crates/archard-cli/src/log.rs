//! `archard log`: what tribometers wrote, and what it gives of wear and friction.

use std::path::{Path, PathBuf};

use archard_case::files::{self, Contents, Inputs};
use archard_case::output::{Error, Place};
use archard_log::{Group, Log, Options, ROWS, ROWS_OF_PROFILES, groups, rows, with_profile};
use serde_json::{Value, json};

use crate::arguments::Log as Arguments;
use crate::failure::Failure;
use crate::plot;
use crate::say::{say, tell};

/// Reads logs, says what is in them, draws them, and writes rows for a fit if a file is named.
pub fn log(arguments: &Arguments) -> Result<(), Failure> {
    let Arguments { files, profile, .. } = arguments;
    if !profile.is_empty() && profile.len() != files.len() {
        return Err(Failure::wrong(format!(
            "there are {} logs and {} profiles: give each log a profile of its own with --profile FILE, in the same order",
            files.len(),
            profile.len()
        )));
    }
    let options = Options {
        columns: pairs(&arguments.column)?,
        values: pairs(&arguments.set)?,
        profile: !profile.is_empty(),
    };
    let (mut places, mut logs, mut wrong) = (vec![], vec![], vec![]);
    for (place, file) in files.iter().enumerate() {
        match read(file, &options) {
            Ok(log) => {
                places.push(place);
                logs.push(log);
            }
            // The others are read all the same.
            Err(why) => wrong.push(why),
        }
    }
    if files.len() == 1
        && let Some(why) = wrong.pop()
    {
        return Err(Failure::wrong(why));
    }
    let found = groups(&logs);
    show(&logs, &found, arguments.json)?;
    wrong.iter().for_each(|why| tell(&format!("error: {why}")));
    let inputs = Inputs::of(files.iter().chain(profile).cloned());
    if let Some(picture) = &arguments.picture {
        spare(&inputs, picture)?;
        let files = plot::log::draw(picture, &logs).map_err(|error| Failure::because(&error))?;
        if !arguments.json {
            files.iter().try_for_each(|file| say(&file.display().to_string()))?;
        }
    }
    let (heading, told) = match profile.is_empty() {
        true => (ROWS, rows(&logs)),
        false => {
            let own: Vec<&PathBuf> = places.iter().map(|place| &profile[*place]).collect();
            (ROWS_OF_PROFILES, rows_of_profiles(&logs, &own, arguments.output.as_deref())?)
        }
    };
    if let Some(output) = arguments.output.as_deref().filter(|_| !told.is_empty()) {
        spare(&inputs, output)?;
        let wrong = |error: Error| Failure::wrong(error.to_string());
        let text = format!("{heading}\n{}\n", told.join("\n"));
        let place = Place::free_or(output, |known| known == text.as_bytes()).map_err(wrong)?;
        place.write(text.as_bytes()).map_err(wrong)?;
    }
    if !wrong.is_empty() {
        return Err(Failure::wrong(format!(
            "{} of {} files are no logs that can be read; the reasons stand above",
            wrong.len(),
            files.len()
        )));
    }
    let untold = |log: &&Log| log.steps.iter().all(|step| step.k_over_area().is_none());
    let untold: Vec<&str> = logs.iter().filter(untold).map(|log| &*log.source).collect();
    match untold[..] {
        [] => Ok(()),
        _ if !profile.is_empty() => Ok(()),
        [_] if logs.len() == 1 => Err(Failure::NotConverged(
            "no step gives a wear coefficient; the reasons stand above".to_owned(),
        )),
        _ => Err(Failure::NotConverged(format!(
            "no step gives a wear coefficient in {}; the reasons stand above",
            untold.join(", ")
        ))),
    }
}

fn read(file: &Path, options: &Options) -> Result<Log, String> {
    let bytes = files::read(file, Contents::Numbers)
        .map_err(|error| format!("cannot read `{}`: {error}", file.display()))?;
    Log::read(&file.display().to_string(), &bytes, options).map_err(|error| error.to_string())
}

fn show(logs: &[Log], found: &[Group], as_json: bool) -> Result<(), Failure> {
    let names: Vec<String> = logs.iter().map(Log::name).collect();
    if as_json {
        let value: Value = match logs {
            [log] => log.json(),
            _ => json!({
                "logs": logs.iter().map(Log::json).collect::<Vec<_>>(),
                "groups": found.iter().map(|group| group.json(&names)).collect::<Vec<_>>(),
            }),
        };
        return say(&format!("{value:#}"));
    }
    for log in logs {
        log.lines().iter().try_for_each(|line| say(line))?;
    }
    if logs.len() > 1 {
        say("")?;
        logs.iter().try_for_each(|log| say(&log.line()))?;
    }
    found.iter().try_for_each(|group| say(&group.line(&names)))
}

/// The rows of logs with profiles, whose paths are those from the table.
fn rows_of_profiles(
    logs: &[Log],
    own: &[&PathBuf],
    table: Option<&Path>,
) -> Result<Vec<String>, Failure> {
    let folder = table.and_then(Path::parent).unwrap_or(Path::new(""));
    let row = |(log, file): (&Log, &&PathBuf)| {
        files::read(file, Contents::Numbers).map_err(|error| {
            Failure::wrong(format!("cannot read `{}`: {error}", file.display()))
        })?;
        let from = match file.strip_prefix(folder) {
            Ok(below) => below.to_owned(),
            Err(_) => std::path::absolute(file).unwrap_or_else(|_| file.to_path_buf()),
        };
        with_profile(log, &from.display().to_string())
            .map_err(|error| Failure::wrong(error.to_string()))
    };
    logs.iter().zip(own).map(row).collect()
}

/// Nothing is written over what is read.
fn spare(inputs: &Inputs, output: &Path) -> Result<(), Failure> {
    match inputs.has(output) {
        true => Err(Failure::wrong(format!(
            "`{}` is one of the files that are read: name another one",
            output.display()
        ))),
        false => Ok(()),
    }
}

/// Names and what stands behind their `=`.
fn pairs(options: &[String]) -> Result<Vec<(String, String)>, Failure> {
    let pair = |option: &String| {
        let (name, value) = option.split_once('=').ok_or_else(|| {
            Failure::wrong(format!("`{option}`: write a name and a value, like wear=\"Displacement [um]\" or load=\"5 N\""))
        })?;
        Ok((name.trim().to_owned(), value.trim().trim_matches('"').to_owned()))
    };
    options.iter().map(pair).collect()
}
