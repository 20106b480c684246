//! Coefficients of a fit (`fit.json`), for a study or a run of another case.

use std::path::Path;

use archard_case::CaseFile;
use archard_case::files::{self, Contents};
use archard_lab::Untold;
use serde_json::Value;

use crate::failure::Failure;

/// A coefficient that tests told.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedCoefficient {
    /// Its key in the case that was fitted.
    pub key: String,
    /// Its unit.
    pub unit: String,
    /// Its median.
    pub median: f64,
    /// The 95 % interval of the median.
    pub interval: Option<[f64; 2]>,
    /// The deviation of the logarithm of the next test's and its degrees of freedom, or why they are unknown.
    pub next: Result<[f64; 2], String>,
}

/// What a `fit.json` holds.
#[derive(Debug, Clone, PartialEq)]
pub struct FitFile {
    /// Its coefficients, one at least.
    pub coefficients: Vec<FittedCoefficient>,
    /// How two of them go together.
    pub together: Option<f64>,
    /// Whether three and more were fitted together, so that pairs tell too little.
    pub many: bool,
}

/// Reads a `fit.json`.
///
/// # Errors
/// If it is not one, is damaged, or gives no coefficient to predict with.
pub fn read(path: &Path) -> Result<FitFile, String> {
    let wrong = |why: &str| format!("`{}`: {why}", path.display());
    let text = files::read(path, Contents::Text).map_err(|error| wrong(&error.to_string()))?;
    let fit: Value = serde_json::from_slice(&text).map_err(|error| wrong(&error.to_string()))?;
    let all = fit["coefficients"].as_array().filter(|list| !list.is_empty());
    let all = all.ok_or_else(|| wrong("is no fit.json of `archard fit`"))?;
    if let Some(why) = fit["unsettled"].as_str() {
        return Err(wrong(why));
    }
    let one = |own: &Value| fitted(own).map_err(|why| wrong(&why));
    Ok(FitFile {
        coefficients: all.iter().map(one).collect::<Result<_, _>>()?,
        together: fit["correlation_of_coefficients"]["value"].as_f64(),
        many: fit["correlations"].as_array().is_some_and(|rows| rows.len() > 2),
    })
}

fn fitted(own: &Value) -> Result<FittedCoefficient, String> {
    let damaged = || "a coefficient is not whole; fit again".to_owned();
    let key = own["key"].as_str().ok_or_else(damaged)?;
    if let Some(why) = own["rejected"].as_str() {
        return Err(format!("the tests give no `{key}` to predict with: {why}"));
    }
    let number = |name: &str| own[name].as_f64();
    let next = match (number("next_test_log_deviation"), number("next_test_degrees_of_freedom")) {
        (Some(_), Some(degrees)) if degrees < 2.0 => {
            Err(format!("two tests tell next to nothing of how `{key}` scatters"))
        }
        // Tests that agree exactly scatter by nothing that could be drawn.
        (Some(deviation), Some(degrees)) => Ok([deviation.max(1e-9), degrees]),
        _ => Err(format!("one test does not tell how the next one's `{key}` scatters")),
    };
    let ends = own["interval_95"].as_array().map(|ends| ends.iter().map(Value::as_f64).collect());
    let ends: Option<Vec<f64>> = ends.unwrap_or_default();
    Ok(FittedCoefficient {
        key: key.to_owned(),
        unit: own["unit"].as_str().unwrap_or_default().to_owned(),
        median: number("median").filter(|median| *median > 0.0).ok_or_else(damaged)?,
        interval: ends.and_then(|ends| <[f64; 2]>::try_from(ends).ok()),
        next,
    })
}

/// Refuses a prediction by coefficients that nobody has told: the case may have any number for a body that was not fitted. `given` are
/// keys, or settings that begin with one.
///
/// # Errors
/// If there are such.
pub fn all_known(path: &Path, case: &CaseFile, given: &[&str]) -> Result<(), Failure> {
    // What is wrong with the case is shown where its rows are checked.
    let Ok(resolved) = case.resolve() else { return Ok(()) };
    let missing = Untold::of(&resolved.case, given);
    if missing.is_empty() {
        return Ok(());
    }
    Err(Failure::wrong(format!(
        "`{}` has no {}: wear of that body, and what is worn off both together, would be that of a number which no test has \
         told; add {} to take it from the case, put another one there by an option, or fit both bodies",
        path.display(),
        Untold::values(&missing),
        Untold::options(&missing)
    )))
}
