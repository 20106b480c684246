//! What the results of two bodies have in common that touch along a line which passes: gears, and a cam with its follower.

use archard_gear::{Limit, Moment};
use serde_json::{Value, json};

use super::summary::json_of;
use super::table::{Table, number};
use super::{CASE, Claim, Error, SUMMARY, Totals};
use crate::verdict::{self, Line, Verdict};

/// The file of how bodies became so, a row a step.
pub(super) const COURSE: &str = "course.csv";

/// Rows of a file: values (SI) by the names of their columns.
pub type Rows = Vec<Vec<(String, f64)>>;

/// Writes the files of results, the summary last.
///
/// # Errors
/// If a file cannot be removed or written.
pub(super) fn write(
    claim: &mut Claim,
    case_toml: &str,
    files: &[(&'static str, Rows)],
    verdict: Verdict,
    totals: &Totals,
    summary: impl FnOnce() -> Value,
) -> Result<Verdict, Error> {
    claim.admit()?;
    let manifest = &mut claim.manifest;
    manifest.begin([CASE, files[0].0])?;
    manifest.write(CASE, case_toml.as_bytes())?;
    for (file, rows) in files {
        let mut table = Table::create(manifest.claim(file)?)?;
        for row in rows {
            let row = row.iter().map(|(name, value)| (&**name, number(*value)));
            table.row(&row.collect::<Vec<_>>())?;
        }
        table.flush()?;
        table.sync()?;
    }
    let verdict = verdict.warned_of(&totals.warnings).ended(totals.failure.as_deref());
    let mut whole = serde_json::Map::new();
    for part in [about(&verdict, totals), summary()] {
        if let Value::Object(part) = part {
            whole.extend(part);
        }
    }
    let whole = Value::Object(whole);
    manifest.write(SUMMARY, format!("{whole:#}\n").as_bytes())?;
    manifest.settle()?;
    Ok(verdict)
}

/// What every summary has.
fn about(verdict: &Verdict, totals: &Totals) -> Value {
    json!({
        "program": "archard",
        "version": env!("CARGO_PKG_VERSION"),
        "complete": totals.failure.is_none(),
        "failure": totals.failure,
        "verdict": json_of(verdict),
        "seconds": totals.seconds,
        "threads": totals.threads,
        "warnings": totals.warnings.iter().map(|warning| &warning.text).collect::<Vec<_>>(),
        "command": totals.command,
    })
}

/// The deepest wear (m) of both bodies step by step, over passages of that name.
pub(super) fn course(passages: &str, names: &[String; 2], course: &[Moment]) -> Rows {
    let row = |moment: &Moment| {
        let deepest = |body: usize| moment.depths[body].iter().copied().fold(0.0, f64::max);
        let depth = |body: usize| (format!("wear_depth_{}_m", names[body]), deepest(body));
        vec![(passages.to_owned(), moment.passages), depth(0), depth(1)]
    };
    course.iter().map(row).collect()
}

/// Whether a body of a hardness (Pa), where it is known, and a Young's modulus (Pa) bears a peak pressure (Pa), and whether a half-space
/// stands for it where the contact reaches over that share of its radius.
pub(super) fn borne(
    name: &str,
    (hardness, modulus): (Option<f64>, f64),
    peak: f64,
    share: f64,
) -> [Line; 2] {
    let pressed = match hardness {
        Some(hardness) => verdict::hardness(peak / hardness, name),
        None => verdict::modulus(peak / modulus, name),
    };
    [pressed, verdict::radius(share, name)]
}

/// The life of the body that reaches its limit first, in passages of that name, and its error.
pub(super) fn life(
    (body, passages): (&str, &str),
    names: &[String; 2],
    life: Option<(Limit, f64)>,
    last: &Moment,
) -> Option<Value> {
    let (limit, error) = life?;
    Some(json!({
        body: names[limit.body],
        "wear_depth_m": limit.depth,
        passages: last.passages,
        "error": error,
    }))
}
