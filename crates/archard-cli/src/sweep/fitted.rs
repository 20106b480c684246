//! Coefficients of a fit as samples of a study.

use std::path::Path;

use archard::files::{self, Contents};
use serde_json::Value;

use crate::arguments::Sweep;

/// The arguments with the coefficients of `--from` the first samples.
pub fn with(arguments: &Sweep) -> Result<Sweep, String> {
    let mut all = arguments.clone();
    if let Some(path) = &arguments.from {
        let fit = read(path)?;
        let mut samples = samples(path, &fit)?;
        samples.append(&mut all.sample);
        all.sample = samples;
        all.together = fit["correlation_of_coefficients"]["value"].as_f64();
    }
    if all.sample.is_empty() && all.samples.is_some() {
        return Err("--samples counts samples: give --sample KEY=DISTRIBUTION or --from fit.json"
            .to_owned());
    }
    Ok(all)
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
