//! Coefficients of a fit as samples of a study.

use crate::arguments::Sweep;
use crate::diagnose;
use crate::failure::Failure;
use crate::fitted::{self, FitFile};

/// The arguments with the coefficients of `--from` the first samples.
pub fn with(arguments: &Sweep) -> Result<Sweep, Failure> {
    let mut all = arguments.clone();
    if let Some(path) = &arguments.from {
        let fit = fitted::read(path).map_err(Failure::wrong)?;
        let wrong = |why: String| Failure::wrong(format!("`{}`: {why}", path.display()));
        let mut samples = samples(&fit).map_err(wrong)?;
        let keys = fit.coefficients.iter().map(|own| &*own.key);
        let given = [&arguments.set, &arguments.over, &arguments.sample, &arguments.assume];
        let given = given.into_iter().flatten().map(String::as_str);
        let case = diagnose::read(&arguments.case())?;
        fitted::all_known(path, &case, &keys.chain(given).collect::<Vec<_>>())?;
        samples.append(&mut all.sample);
        all.sample = samples;
        all.together = fit.together;
    }
    if all.sample.is_empty() && all.samples.is_some() {
        return Err(Failure::wrong(
            "--samples counts samples: give --sample KEY=DISTRIBUTION or --from fit.json",
        ));
    }
    Ok(all)
}

/// `KEY=logstudent(median, scale, degrees of freedom)` of each coefficient: what the next test will have, by those that were
/// made.
fn samples(fit: &FitFile) -> Result<Vec<String>, String> {
    if fit.many {
        return Err(
            "three coefficients that were fitted together are not drawn: give --sample with each"
                .into(),
        );
    }
    let one = |own: &fitted::FittedCoefficient| {
        let [deviation, degrees] = own.next.clone().map_err(|why| {
            format!("{why}: make another test, or give --sample with a scatter of your own")
        })?;
        let (key, median, unit) = (&own.key, own.median, &own.unit);
        Ok(format!("{key}=logstudent({median:e} {unit}, {deviation:e}, {degrees})"))
    };
    fit.coefficients.iter().map(one).collect()
}
