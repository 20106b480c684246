//! Coefficients of a fit as samples of a study.

use std::path::Path;

use archard_case::files::{self, Contents};
use archard_lab::Untold;
use serde_json::Value;

use crate::arguments::Sweep;
use crate::diagnose;
use crate::failure::Failure;

/// The arguments with the coefficients of `--from` the first samples.
pub fn with(arguments: &Sweep) -> Result<Sweep, Failure> {
    let mut all = arguments.clone();
    if let Some(path) = &arguments.from {
        let fit = read(path).map_err(Failure::wrong)?;
        let mut samples = samples(path, &fit).map_err(Failure::wrong)?;
        all_known(arguments, &fit)?;
        samples.append(&mut all.sample);
        all.sample = samples;
        all.together = fit["correlation_of_coefficients"]["value"].as_f64();
    }
    if all.sample.is_empty() && all.samples.is_some() {
        return Err(Failure::wrong(
            "--samples counts samples: give --sample KEY=DISTRIBUTION or --from fit.json",
        ));
    }
    Ok(all)
}

/// Refuses a prediction by coefficients that nobody has told: the case may have any number for a body that was not fitted.
fn all_known(arguments: &Sweep, fit: &Value) -> Result<(), Failure> {
    let file = diagnose::read(&arguments.case())?;
    // What is wrong with the case is shown where its rows are checked.
    let Ok(resolved) = file.resolve() else { return Ok(()) };
    let fitted = fit["coefficients"].as_array().into_iter().flatten();
    let fitted = fitted.filter_map(|own| own["key"].as_str());
    let given = [&arguments.set, &arguments.over, &arguments.sample, &arguments.assume];
    let given = given.into_iter().flatten().map(String::as_str);
    let told: Vec<&str> = fitted.chain(given).collect();
    let missing = Untold::of(&resolved.case, &told);
    if missing.is_empty() {
        return Ok(());
    }
    Err(Failure::wrong(format!(
        "`{}` has no {}: wear of that body, and what is worn off both together, would be that of a number which no test has \
         told; add {} to take it from the case, put another one there by --set, --over or --sample, or fit both bodies",
        arguments.from.as_deref().unwrap_or(Path::new("fit.json")).display(),
        Untold::values(&missing),
        Untold::options(&missing)
    )))
}

fn read(path: &Path) -> Result<Value, String> {
    let wrong = |why: String| format!("`{}`: {why}", path.display());
    let text = files::read(path, Contents::Text).map_err(|error| wrong(error.to_string()))?;
    serde_json::from_slice(&text).map_err(|error| wrong(error.to_string()))
}

/// `KEY=logstudent(median, scale, degrees of freedom)` of each coefficient: what the next test will have, by those that were
/// made.
fn samples(path: &Path, fit: &Value) -> Result<Vec<String>, String> {
    let name = path.display();
    let wrong = |why: &str| format!("`{name}`: {why}");
    let coefficients = fit["coefficients"].as_array().filter(|list| !list.is_empty());
    let coefficients = coefficients.ok_or_else(|| wrong("is no fit.json of `archard fit`"))?;
    if let Some(why) = fit["unsettled"].as_str() {
        return Err(wrong(why));
    }
    if fit["correlations"].as_array().is_some_and(|rows| rows.len() > 2) {
        return Err(wrong(
            "three coefficients that were fitted together are not drawn: give --sample with each",
        ));
    }
    let one = |own: &Value| {
        let damaged = || wrong("a coefficient is not whole; fit again");
        let key = own["key"].as_str().ok_or_else(damaged)?;
        if let Some(why) = own["rejected"].as_str() {
            return Err(wrong(&format!("the tests give no `{key}` to predict with: {why}")));
        }
        let number = |name: &str| own[name].as_f64();
        let (Some(deviation), Some(degrees)) =
            (number("next_test_log_deviation"), number("next_test_degrees_of_freedom"))
        else {
            return Err(wrong(&format!(
                "one test does not tell how the next one's `{key}` scatters: give --sample with a scatter of your own"
            )));
        };
        if degrees < 2.0 {
            return Err(wrong(&format!(
                "two tests tell next to nothing of how `{key}` scatters: make a third, or give --sample with a scatter of \
                 your own"
            )));
        }
        let (median, unit) =
            (number("median").ok_or_else(damaged)?, own["unit"].as_str().unwrap_or_default());
        // Tests that agree exactly scatter by nothing that could be drawn.
        let deviation = deviation.max(1e-9);
        Ok(format!("{key}=logstudent({median:e} {unit}, {deviation:e}, {degrees})"))
    };
    coefficients.iter().map(one).collect()
}
