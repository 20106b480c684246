//! Rows that `archard fit` reads.

use std::collections::HashSet;

use thiserror::Error;

use crate::steps::{near, range};
use crate::{Log, Step};

/// The heading of the rows.
pub const ROWS: &str = "test,distance [m],depth [um],u_depth [um],load [N]";

/// The heading of rows of logs with a profile of what was worn.
pub const ROWS_OF_PROFILES: &str = "test,distance [m],load [N],file";

/// One row a step with a wear coefficient, the wear over its steady part, without the heading [`ROWS`]; each has a name of its own.
pub fn rows<'a>(logs: impl IntoIterator<Item = &'a Log>) -> Vec<String> {
    let mut taken = HashSet::new();
    let mut named = |log: &Log| {
        let own = log.name();
        let others = (2..).map(|count| format!("{own}_{count}"));
        let free = std::iter::once(own.clone()).chain(others).find(|name| !taken.contains(name));
        let name = free.expect("one of all numbers");
        taken.insert(name.clone());
        name
    };
    let told = logs.into_iter().flat_map(|log| log.steps.iter().map(move |step| (log, step)));
    told.filter_map(|(log, step)| {
        step.k_over_area()?;
        let (rate, load) = (step.steady?, step.load?);
        let far = rate.part[1] - rate.part[0];
        let [depth, error] = [rate.rate, rate.deviation()].map(|own| 1e6 * own * far);
        let name = named(log);
        Some(format!("{name},{far:.6e},{depth:.6e},{error:.6e},{load:.6e}"))
    })
    .collect()
}

/// Why a profile cannot stand next to a log.
#[derive(Debug, Error, Clone, PartialEq)]
#[non_exhaustive]
pub enum NoMatch {
    /// No load.
    #[error("{log}: nothing says the load: give --set load=\"5 N\"")]
    NoLoad {
        /// The log.
        log: String,
    },
    /// No distance.
    #[error("{log}: the bodies did not slide")]
    NoDistance {
        /// The log.
        log: String,
    },
    /// Loads that differ.
    #[error(
        "{log}: the load goes from {low:.4} to {high:.4} N, and the profile was worn by all of it: give a test of one load"
    )]
    Loads {
        /// The log.
        log: String,
        /// The smallest load (N).
        low: f64,
        /// The largest load (N).
        high: f64,
    },
}

/// The row of a log with a profile of what was worn: the whole distance under load, running in too, without the heading
/// [`ROWS_OF_PROFILES`].
///
/// # Errors
/// If the log gives no load, no distance, or several loads.
pub fn with_profile(log: &Log, file: &str) -> Result<String, NoMatch> {
    let source = || log.source.clone();
    let slid: Vec<&Step> = log.steps.iter().filter(|step| step.distance > 0.0).collect();
    let far: f64 = slid.iter().map(|step| step.distance).sum();
    if far <= 0.0 {
        return Err(NoMatch::NoDistance { log: source() });
    }
    let loads: Option<Vec<f64>> = slid.iter().map(|step| step.load).collect();
    let Some(loads) = loads else { return Err(NoMatch::NoLoad { log: source() }) };
    let changed = slid.iter().filter_map(|step| step.changed).flatten();
    let [low, high] = range(&loads.into_iter().chain(changed).collect::<Vec<_>>());
    if !near(low, high) {
        return Err(NoMatch::Loads { log: source(), low, high });
    }
    Ok(format!("{},{far:.6e},{high:.6e},\"{}\"", log.name(), file.replace('"', "\"\"")))
}
