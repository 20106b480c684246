//! An elastic body by itself, through to its result folder.

use std::path::Path;
use std::time::Instant;

use archard::case::ResolvedElastic;
use archard::compliance::bem::Balance;
use archard::elastic::{Deformed, ElasticBody, von_mises};
use archard::output::{Totals, write_elastic};
use archard::verdict::{Line, Word};

use crate::failure::Failure;
use crate::number::four;
use crate::say::say;

/// Computes a body and writes its results into a folder.
pub fn run(resolved: &ResolvedElastic, dir: &Path, quiet: bool) -> Result<(), Failure> {
    let ResolvedElastic { case, warnings, .. } = resolved;
    let wrong = |error: &dyn std::error::Error| Failure::wrong(error.to_string());
    let body = case.build().map_err(|error| wrong(&error))?;
    let start = Instant::now();
    let deformed = body.solve().map_err(|error| wrong(&error))?;
    let totals = Totals {
        seconds: start.elapsed().as_secs_f64(),
        threads: rayon::current_num_threads(),
        warnings: warnings.iter().map(|warning| warning.title()).collect(),
        failure: None,
    };
    write_elastic(dir, &case.to_string(), (&body, &deformed), &totals)
        .map_err(|error| wrong(&error))?;
    if !quiet {
        summarize(&body, &deformed, &totals, dir)?;
    }
    let verdict = body.verdict(&deformed);
    match verdict.complaints().find(|line| line.word() == Word::Wrong) {
        Some(line) => Err(Failure::NotConverged(sentence(line))),
        None => Ok(()),
    }
}

/// A line of the verdict in words.
fn sentence(line: &Line) -> String {
    format!("the result is {}: {} {}", line.word().text(), four(line.value), line.text)
}

/// Says what came out and where it is.
fn summarize(
    body: &ElasticBody,
    deformed: &Deformed,
    totals: &Totals,
    dir: &Path,
) -> Result<(), Failure> {
    let largest = deformed.boundary.displacement.iter().map(|u| u.length()).fold(0.0, f64::max);
    say(&format!("displacement      {} um at most", four(largest * 1e6)))?;
    for (point, response) in body.points.iter().zip(&deformed.points) {
        let [x, y, z] = response.displacement.to_array().map(|u| four(u * 1e6));
        let stress = four(von_mises(&response.stress) * 1e-6);
        let name = &point.name;
        say(&format!("at `{name}`  displacement ({x}, {y}, {z}) um, von Mises {stress} MPa"))?;
    }
    let Balance { force, moment } = deformed.balance;
    let lines = archard::verdict::balance(force, moment);
    let [force, moment] = [force, moment].map(|share| four(100.0 * share));
    let word = lines.iter().map(Line::word).max().unwrap_or(Word::Good).text();
    say(&format!("left of balance   {force} % of the load, {moment} % of its moment: {word}"))?;
    // Long elements have been warned of before the run.
    for line in lines.iter().filter(|line| line.word() == Word::Doubtful) {
        say(&format!("warning           {}", sentence(line)))?;
    }
    let unknowns = deformed.surface.unknowns();
    say(&format!("time              {:.2} s, {unknowns} unknowns", totals.seconds))?;
    say(&format!("results           {}", dir.display()))
}
