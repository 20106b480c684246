//! Two bodies that touch along a line which passes, through to their result folder: gears, and a cam with its follower.

use std::time::Instant;

use archard_case::Problem;
use archard_case::output::{Claim, Error, Totals};
use archard_case::verdict::Verdict;

use crate::failure::Failure;
use crate::interrupt::Watch;
use crate::number::four;
use crate::say::say;
use crate::underway::solved;
use crate::verdict;

/// What came out, in lines of a name and a value.
pub type Lines = Vec<(&'static str, String)>;

/// Solves a case, and writes what came out into the folder that is held.
pub fn run<R>(
    warnings: &[Problem],
    watch: &Watch,
    [quiet, verbose]: [bool; 2],
    solve: impl FnOnce() -> Result<R, Problem>,
    write: impl FnOnce(&mut Claim, &R, &Totals) -> Result<Verdict, Error>,
    lines: impl FnOnce(&R) -> Lines,
) -> Result<(), Failure> {
    let start = Instant::now();
    let results = solve().map_err(|problem| Failure::wrong(problem.title()))?;
    let totals = solved(start, warnings);
    let Some(mut claim) = watch.release() else {
        return Err(Failure::wrong("the run has no folder"));
    };
    let judged =
        write(&mut claim, &results, &totals).map_err(|error| Failure::wrong(error.to_string()))?;
    if !quiet {
        let rest = [
            ("time", format!("{:.2} s", totals.seconds)),
            ("results", claim.dir().display().to_string()),
            ("verdict", verdict::headline(&judged).to_string()),
        ];
        for (name, value) in lines(&results).into_iter().chain(rest) {
            say(&format!("{name:<17} {value}"))?;
        }
        verdict::say_lines(&judged, verbose)?;
    }
    verdict::judge(&judged, claim.dir(), quiet)
}

/// The deepest wear (m) of a body and its error, and where it is.
pub fn depth([depth, error]: [f64; 2], name: &str, place: &str) -> (&'static str, String) {
    let (depth, error) = (four(1e6 * depth), four(1e6 * error));
    ("wear depth", format!("{depth} um  +- {error}  of `{name}`, {place}"))
}

/// The worn volume (m^3) of what that is, and its error.
pub fn volume([volume, error]: [f64; 2], what: &str) -> (&'static str, String) {
    ("worn volume", format!("{} mm^3  +- {}  of {what}", four(1e9 * volume), four(1e9 * error)))
}

/// The life in passages of that name, where limits end it: the body that reaches its depth (m) first, and the error of the passages.
pub fn life(
    names: &[String; 2],
    (life, limited): (Option<(usize, [f64; 2])>, bool),
    [last, wanted]: [f64; 2],
    passages: &str,
) -> Option<(&'static str, String)> {
    let text = match life {
        Some((body, [depth, error])) => {
            let of = format!("{} um of `{}`", four(1e6 * depth), names[body]);
            format!("{} {passages}  +- {}, to {of}", four(last), four(error))
        }
        None if !limited => return None,
        None => format!("more than {} {passages}", four(wanted)),
    };
    Some(("life", text))
}
