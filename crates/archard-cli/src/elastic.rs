//! An elastic body by itself, through to its result folder.

use std::path::Path;
use std::time::Instant;

use archard::elastic::{DeformedBody, ElasticBody, von_mises};
use archard_case::ResolvedElastic;
use archard_case::output::{Totals, write_elastic};

use crate::failure::Failure;
use crate::interrupt::Watch;
use crate::number::four;
use crate::say::say;
use crate::underway::solved;
use crate::verdict;

/// Computes a body and writes its results into the folder that is held.
pub fn run(
    resolved: &ResolvedElastic,
    watch: &Watch,
    [quiet, verbose]: [bool; 2],
) -> Result<(), Failure> {
    let ResolvedElastic { case, warnings, .. } = resolved;
    let wrong = |error: &dyn std::error::Error| Failure::wrong(error.to_string());
    let body = case.build().map_err(|error| wrong(&error))?;
    let start = Instant::now();
    let deformed = body.solve().map_err(|error| wrong(&error))?;
    let totals = solved(start, warnings);
    let Some(mut claim) = watch.release() else {
        return Err(Failure::wrong("the run has no folder"));
    };
    let judged = write_elastic(&mut claim, &case.to_string(), (&body, &deformed), &totals)
        .map_err(|error| wrong(&error))?;
    if !quiet {
        summarize(&body, &deformed, &totals, claim.dir())?;
    }
    if !quiet {
        say(&format!("verdict           {}", verdict::headline(&judged)))?;
        verdict::say_lines(&judged, verbose)?;
    }
    verdict::judge(&judged, claim.dir(), quiet)
}

/// Says what came out and where it is.
fn summarize(
    body: &ElasticBody,
    deformed: &DeformedBody,
    totals: &Totals,
    dir: &Path,
) -> Result<(), Failure> {
    let largest = deformed.largest_displacement();
    say(&format!("displacement      {} um at most", four(largest * 1e6)))?;
    for (point, response) in body.points.iter().zip(&deformed.points) {
        let [x, y, z] = response.displacement.map(|u| four(u * 1e6));
        let stress = four(von_mises(&response.stress) * 1e-6);
        let name = &point.name;
        say(&format!("at `{name}`  displacement ({x}, {y}, {z}) um, von Mises {stress} MPa"))?;
    }
    let unknowns = deformed.unknowns();
    say(&format!("time              {:.2} s, {unknowns} unknowns", totals.seconds))?;
    say(&format!("results           {}", dir.display()))
}
