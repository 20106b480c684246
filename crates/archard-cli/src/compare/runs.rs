//! A run next to other runs.

use std::path::{Path, PathBuf};

use anyhow::Result;
use archard::simulation::history::{
    BODY_DEPTH, PEAK_PRESSURE, WEAR_DEPTH, WORN_SECTION, WORN_VOLUME, of_body,
};
use archard_case::verdict::Verdict;

use super::Comparison;
use crate::plot::results::Results;
use crate::plot::scale::Unit;
use crate::plot::tables::largest;
use crate::plot::{self};
use crate::report::quantity;

/// Compares the ends of runs, and shows their wear over the progress.
pub(super) fn compare(dir: &Path, results: &Results, others: &[PathBuf]) -> Result<Comparison> {
    let panels = vec![plot::compared(dir, results, others)?];
    let columns = columns(results);
    let mut comparison = Comparison {
        title: format!("`{}` compared with other runs, each at its end", dir.display()),
        lines: vec![],
        remarks: vec![],
        verdict: Verdict::default(),
        panels,
    };
    for path in others {
        let other = Results::read(path)?;
        let [end, own] = [&other, results].map(|run| largest(run.progress().1));
        if (end / own - 1.0).abs() > 1e-9 {
            let column = results.progress().0;
            let [there, here] = [end, own].map(|end| Unit::of_column(column, end).show(end));
            let words = format!("`{}` ends at {there}, this run at {here}", path.display());
            comparison.doubt(&words);
        }
        comparison.of_run(path, &other);
        let errors = [results, &other].into_iter().flat_map(|run| errors(run, &columns));
        comparison.state(errors);
        for (column, name, unit) in &columns {
            let Some((one, there)) = last(results, column).zip(last(&other, column)) else {
                continue;
            };
            if one == 0.0 && there == 0.0 {
                continue;
            }
            let difference = 100.0 * (there / one - 1.0);
            let difference = if difference.is_finite() {
                format!("{difference:+.2} %")
            } else {
                "none here".to_owned()
            };
            let value = format!(
                "{} here, {} in `{}`: {difference}",
                quantity(one, unit),
                quantity(there, unit),
                path.display()
            );
            comparison.lines.push([name.clone(), value]);
        }
    }
    Ok(comparison)
}

/// What runs are compared by: columns, their names in words and their units.
pub(super) fn columns(results: &Results) -> Vec<(String, String, &'static str)> {
    let mut columns = vec![(WEAR_DEPTH.to_owned(), "wear depth".to_owned(), "m")];
    for body in &results.bodies {
        for (column, name, unit) in [
            (BODY_DEPTH, "depth", "m"),
            (WORN_VOLUME, "volume", "m3"),
            (WORN_SECTION, "section", "m2"),
        ] {
            columns.push((of_body(column, body), format!("{name} of {body}"), unit));
        }
    }
    columns.push((PEAK_PRESSURE.to_owned(), "peak pressure".to_owned(), "Pa"));
    columns
}

/// The value of a run at its end.
fn last(run: &Results, column: &str) -> Option<f64> {
    run.history.column(column).ok().and_then(|values| values.last().copied())
}

/// The errors that a run states of some columns at its end, relative, with the names of these.
pub(super) fn errors(
    run: &Results,
    columns: &[(String, String, &str)],
) -> impl Iterator<Item = (f64, String)> {
    columns.iter().filter_map(|(column, name, _)| {
        let error = run.error(column)?.last().copied()?;
        let value = last(run, column).filter(|value| *value != 0.0)?;
        Some((error / value.abs(), format!("computed {name}")))
    })
}
