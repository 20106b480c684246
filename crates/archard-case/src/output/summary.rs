//! The end of a run in one file: the last row, checks and totals.

use serde_json::{Map, Value, json};

use super::evidence::worn_over_coefficient;
use super::{Life, Standard, Stresses, closed_forms};
use crate::verdict::{Bound, Line, Verdict, Warning};
use archard::body::profile::Round;
use archard::estimate::{Estimator, Subject};
use archard::frame::Wrap;
use archard::motion::Passage;
use archard::simulation::history::{WORN_SECTION, WORN_VOLUME, number, of_body};
use archard::simulation::{Effort, Report};

/// What only the caller of a run knows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Totals {
    /// Time the run took (s).
    pub seconds: f64,
    /// Number of threads it was given.
    pub threads: usize,
    /// What the user was warned of, before the run and at its end.
    pub warnings: Vec<Warning>,
    /// Why the run stopped before its end, if it did.
    pub failure: Option<String>,
    /// The command that asked for the run, if one did.
    pub command: Option<String>,
}

/// The state of a run after a step, as far as a summary needs it.
#[derive(Debug)]
pub(super) struct Standing {
    last: Value,
    wear: Value,
    closed_form: Value,
    /// Whether the motion goes through cycles.
    cycles: bool,
    effort: Effort,
    extent: f64,
    /// What the coordinates of the frame are, where they are no axes of space.
    coordinates: Value,
    /// The column of its progress.
    progress: &'static str,
}

impl Standing {
    /// What a report says, with its row of the history and what closed forms say of it.
    pub(super) fn of(report: &Report<'_>, row: &[(String, f64)], estimator: &Estimator) -> Self {
        let last: Map<String, Value> =
            row.iter().map(|(column, value)| (column.clone(), json!(value))).collect();
        Self {
            last: last.into(),
            wear: wear(report, row),
            closed_form: closed_forms::of(report, estimator),
            cycles: report.problem.motion.increments().is_some(),
            effort: report.effort,
            extent: report.extent,
            coordinates: report.problem.frame.wrap().map_or(Value::Null, |wrap| coordinates(&wrap)),
            progress: report.problem.motion.progress.column,
        }
    }
}

/// The summary as JSON text; `iterations` is the sum over all steps.
pub(super) fn text(
    standing: Option<&Standing>,
    (iterations, verdict): (usize, &Verdict),
    (totals, told): (&Totals, &[String]),
    (life, stresses): (&Life, &Stresses),
) -> String {
    let effort = standing.map(|standing| standing.effort).unwrap_or_default();
    let cycles = standing.is_some_and(|standing| standing.cycles);
    let summary = json!({
        "program": "archard",
        "version": env!("CARGO_PKG_VERSION"),
        "command": totals.command,
        "complete": totals.failure.is_none(),
        "failure": totals.failure,
        "verdict": json_of(verdict),
        "life": standing.and_then(|standing| life.json(standing.progress)),
        "extent": standing.map(|standing| standing.extent),
        "coordinates": standing.map(|standing| &standing.coordinates),
        "last": standing.map(|standing| &standing.last),
        "wear": standing.map(|standing| &standing.wear),
        "closed_form": standing.map(|standing| &standing.closed_form),
        "stress": stresses.json(),
        "dissipated_J": cycles.then_some(effort.dissipated[1]),
        "true_cycles": cycles.then_some(effort.true_cycles),
        "seconds": totals.seconds,
        "threads": totals.threads,
        "steps": effort.steps,
        "rejected": effort.rejected,
        "solves": effort.solves,
        "iterations": iterations,
        "applications": effort.applications,
        "warnings": told,
    });
    format!("{summary:#}\n")
}

/// What the coordinates of a frame are that is drawn on a round surface.
fn coordinates(wrap: &Wrap) -> Value {
    let on = match wrap.round {
        Round::Sphere => "sphere",
        Round::Cylinder => "cylinder",
    };
    json!({ "on": on, "radius_m": wrap.radius, "meaning": wrap.coordinates() })
}

/// A verdict: its word, and each line with its number, its bounds and its word.
pub fn json_of(verdict: &Verdict) -> Value {
    let line = |line: &Line| {
        let (side, [doubtful, wrong]) = match line.bound {
            Bound::AtMost(bounds) => ("above", bounds),
            Bound::AtLeast(bounds) => ("below", bounds),
        };
        json!({
            "subject": line.subject,
            "value": line.value,
            "word": line.word().text(),
            format!("doubtful_{side}"): doubtful,
            format!("wrong_{side}"): wrong,
            "text": line.text,
            "words": line.finding(),
        })
    };
    let lines: Vec<Value> = verdict.lines.iter().map(line).collect();
    json!({ "word": verdict.word().text(), "lines": lines })
}

/// For each body, the volume by the integral of its depth (the paper's eq. 56), in rolling the section
/// across the direction; where it follows from the load, the work or the energy, also what it must be, and how far off it is;
/// of a test by a standard, what that says.
fn wear(report: &Report<'_>, row: &[(String, f64)]) -> Value {
    let problem = report.problem;
    let expected = worn_over_coefficient(report);
    let (measure, unit, column) = match problem.motion.surfaces[0] {
        Passage::Passes(None) => ("section", "m2", WORN_SECTION),
        _ => ("volume", "m3", WORN_VOLUME),
    };
    let standards = Standard::of(problem, row);
    let entries = problem.bodies.iter().enumerate().map(|(index, body)| {
        let worn = number(row, &of_body(column, &body.name)).unwrap_or(0.0);
        let mut entry = json!({ format!("worn_{measure}_{unit}"): worn });
        if let Some(k) = Subject::from(problem).wear_coefficient(index) {
            entry["coefficient_per_Pa"] = json!(k);
            if let Some(expected) = expected.map(|expected| k * expected) {
                let difference = (expected > 0.0).then(|| worn / expected - 1.0);
                entry[format!("expected_{measure}_{unit}")] = json!(expected);
                entry["relative_difference"] = json!(difference);
            }
        }
        if let Some(standard) = standards.iter().find(|standard| standard.body == index) {
            entry["standard"] = standard.json();
        }
        (body.name.clone(), entry)
    });
    Value::Object(entries.collect())
}
