//! The end of a run in one file: the last row, checks and totals.

use serde_json::{Map, Value, json};

use crate::body::contact_modulus;
use crate::closed_form::{Hertz, pin_on_disc};
use crate::problem::ContactProblem;
use crate::simulation::{Effort, Report};
use crate::wear::Rubbing;

/// What only the caller of a run knows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Totals {
    /// Time the run took (s).
    pub seconds: f64,
    /// Number of threads it was given.
    pub threads: usize,
    /// What the user was warned of, before the run and at its end.
    pub warnings: Vec<String>,
    /// Why the run stopped before its end, if it did.
    pub failure: Option<String>,
}

/// The state of a run after a step, as far as a summary needs it.
#[derive(Debug)]
pub(super) struct Standing {
    last: Value,
    wear: Value,
    closed_form: Value,
    effort: Effort,
    extent: f64,
}

impl Standing {
    /// What a report says; `row` is its row of the history.
    pub(super) fn of(report: &Report<'_>, row: &[(String, f64)]) -> Self {
        let last: Map<String, Value> =
            row.iter().map(|(column, value)| (column.clone(), json!(value))).collect();
        Self {
            last: last.into(),
            wear: wear(report),
            closed_form: closed_form(report),
            effort: report.effort,
            extent: report.extent,
        }
    }
}

/// The summary as JSON text; `iterations` is the sum over all steps.
pub(super) fn text(standing: Option<&Standing>, iterations: usize, totals: &Totals) -> String {
    let effort = standing.map(|standing| standing.effort).unwrap_or_default();
    let summary = json!({
        "program": "archard",
        "version": env!("CARGO_PKG_VERSION"),
        "complete": totals.failure.is_none(),
        "failure": totals.failure,
        "extent": standing.map(|standing| standing.extent),
        "last": standing.map(|standing| &standing.last),
        "wear": standing.map(|standing| &standing.wear),
        "closed_form": standing.map(|standing| &standing.closed_form),
        "seconds": totals.seconds,
        "threads": totals.threads,
        "steps": effort.steps,
        "rejected": effort.rejected,
        "solves": effort.solves,
        "iterations": iterations,
        "applications": effort.applications,
        "warnings": totals.warnings,
    });
    format!("{summary:#}\n")
}

/// For each body, the volume by the integral of its depth (the paper's eq. 56) and, where its law
/// says what that must be, k F s and how far the two are apart.
fn wear(report: &Report<'_>) -> Value {
    let Report { problem, state, effort, .. } = report;
    let bodies = problem.bodies.iter().zip(&state.worn).enumerate();
    let entries = bodies.map(|(index, (body, worn))| {
        let volume = problem.frame.integrate(worn);
        let mut entry = json!({ "worn_volume_m3": volume });
        if let Some(k) = coefficient(problem, index) {
            let expected = k * effort.load_distance;
            let difference = (expected > 0.0).then(|| volume / expected - 1.0);
            entry["coefficient_per_Pa"] = json!(k);
            entry["expected_volume_m3"] = json!(expected);
            entry["relative_difference"] = json!(difference);
        }
        (body.name.clone(), entry)
    });
    Value::Object(entries.collect())
}

/// The k (1/Pa) of a body whose depth of wear is k p s; `None` for one that does not wear or wears
/// by another law.
fn coefficient(problem: &ContactProblem, body: usize) -> Option<f64> {
    let law = problem.bodies[body].wear.as_ref()?;
    let ratio =
        |pressure: f64, slip: f64| law.depth(Rubbing { pressure, slip }) / (pressure * slip);
    // From far below to far above what contacts bear, so that no law with a threshold passes.
    let [k, others @ ..] =
        [(1e8, 1.0), (1e4, 1.0), (3e9, 1.0), (1e8, 1e-6)].map(|(p, s)| ratio(p, s));
    others.iter().all(|other| (other - k).abs() <= 1e-12 * k).then_some(k)
}

/// What closed forms say of bodies with curvatures: Hertz at the last load and, for a sphere rubbed
/// flat, the paper's eq. 55; with the numbers they start from.
fn closed_form(report: &Report<'_>) -> Value {
    let Report { problem, state, effort, .. } = report;
    let [Some(one), Some(other)] = problem.bodies.each_ref().map(|body| body.profile.curvatures())
    else {
        return Value::Null;
    };
    let curvatures = [one[0] + other[0], one[1] + other[1]];
    let modulus = contact_modulus(problem.bodies.each_ref().map(|body| body.material.as_ref()));
    let mut block = json!({ "curvatures_per_m": curvatures, "contact_modulus_Pa": modulus });
    if let Some(hertz) = Hertz::from_load(curvatures, modulus, state.load) {
        block["hertz"] = json!({
            "load_N": hertz.load,
            "semi_axes_m": hertz.semi_axes,
            "peak_pressure_Pa": hertz.peak_pressure,
            "approach_m": hertz.approach,
        });
    }
    let worn: f64 = [0, 1].into_iter().filter_map(|body| coefficient(problem, body)).sum();
    let spherical = (curvatures[0] - curvatures[1]).abs() <= 1e-9 * curvatures[0];
    if spherical && worn > 0.0 && problem.kinematics.slip(1.0) > 0.0 {
        let (radius, volume) = (1.0 / curvatures[0], worn * effort.load_distance);
        block["pin_on_disc"] = json!({
            "radius_m": radius,
            "coefficient_per_Pa": worn,
            "volume_m3": volume,
            "depth_m": pin_on_disc::depth(radius, volume),
        });
    }
    block
}
