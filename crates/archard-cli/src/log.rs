//! `archard log`: what a tribometer wrote, and what it tells of wear and friction.

use std::path::Path;

use archard_case::files::{self, Contents};
use archard_case::output::Place;
use archard_log::{Log, Options, ROWS};

use crate::failure::Failure;
use crate::say::say;

/// Reads a log, says what is in it, and writes rows for a fit if a file is named.
pub fn log(
    file: &Path,
    [columns, values]: [&[String]; 2],
    json: bool,
    output: Option<&Path>,
) -> Result<(), Failure> {
    let bytes = files::read(file, Contents::Numbers)
        .map_err(|error| Failure::wrong(format!("cannot read `{}`: {error}", file.display())))?;
    let options = Options { columns: pairs(columns)?, values: pairs(values)? };
    let log = Log::read(&file.display().to_string(), &bytes, &options)
        .map_err(|error| Failure::wrong(error.to_string()))?;
    match json {
        true => say(&format!("{:#}", log.json()))?,
        false => log.lines().iter().try_for_each(|line| say(line))?,
    }
    let told = log.rows();
    if let Some(output) = output.filter(|_| !told.is_empty()) {
        let wrong = |error: archard_case::output::Error| Failure::wrong(error.to_string());
        let text = format!("{ROWS}\n{}\n", told.join("\n"));
        let place = Place::free_or(output, |known| known == text.as_bytes()).map_err(wrong)?;
        place.write(text.as_bytes()).map_err(wrong)?;
    }
    match told.is_empty() {
        true => Err(Failure::NotConverged(
            "no step tells a wear coefficient; the reasons stand above".to_owned(),
        )),
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
