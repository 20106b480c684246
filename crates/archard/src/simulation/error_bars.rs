//! What is stated of each column of the history: its error by the steps and by the elements.

use super::companion::{Companion, PRESCRIBED};
use super::history::{
    CENTRE_PRESSURE, CONTACT_AREA, CREEPAGE, DISSIPATED, ERRORS, FORCE, FRICTIONAL_POWER, LOAD,
    MOMENT, PEAK_PRESSURE, Row, STICK_AREA, counts, is_of,
};
use super::{Effort, Report};
use crate::motion::Stepping;

/// Factor on the estimated error by the steps, unless that is known to enclose the true one: it may be half of that in the first
/// revolutions of twin discs (`tests/verification/accuracy.rs`).
pub(super) const OF_STEPS: f64 = 3.0;
/// The same where a surface swings: with three, the depth of one of McColl's flats was as far off as stated.
pub(super) const OF_SWINGS: f64 = 4.0;
/// The same on the lag of the pressures, which was the true one there or more.
const OF_LAG: f64 = 1.5;
/// How much more that is for the peak on a surface that swings, which stands on single elements.
const OF_LAGGING_PEAK: f64 = 3.0;
/// The same on the lag that is taken off the pressure at the centre: what was left was up to 0.15 of it there.
const OF_CENTRE: f64 = 0.3;
/// How much more that is where laws go by what was before.
const OF_MEMORY: f64 = 2.0;

/// What may be prescribed.
const GIVEN: [&str; 5] = [LOAD, FORCE[0], FORCE[1], CREEPAGE[0], CREEPAGE[1]];
/// What has errors beside.
const ESTIMATED: [&str; 6] =
    [PEAK_PRESSURE, CONTACT_AREA, STICK_AREA, MOMENT, FRICTIONAL_POWER, DISSIPATED];

/// Errors by the steps, where those are chosen by error, and by the elements, in the units of the columns.
pub(super) fn errors(report: &Report<'_>, companion: &Companion, row: &Row) -> Row {
    let Effort { pressure_error, centre_lag, .. } = report.effort;
    let depth = report.effort.enclosing_time_error();
    let by_error = matches!(report.stepping, Stepping::Tolerance(_));
    let estimated = |name: &str| ESTIMATED.iter().any(|column| is_of(column, name));
    let has =
        |(name, _): &&(String, f64)| counts(name, true) || counts(name, false) || estimated(name);
    let mut errors = vec![];
    for (name, value) in row.iter().filter(has) {
        // A load that is found goes by the pressures.
        let of_pressure = pressure_error.filter(|_| name.ends_with("_Pa") || name == LOAD);
        let relative = of_pressure.map(|lag| OF_LAG * lag).or(depth).unwrap_or_default();
        let space = companion.error(name, report.state.progress, *value);
        // What no grid changes no step does.
        let given = GIVEN.contains(&name.as_str())
            && space.is_some_and(|space| space <= PRESCRIBED * value.abs());
        let by_steps = match name.as_str() {
            _ if given => 0.0,
            CENTRE_PRESSURE if centre_lag != 0.0 => {
                let remembered = if report.problem.remembers() { OF_MEMORY } else { 1.0 };
                remembered * OF_CENTRE * centre_lag.abs()
            }
            PEAK_PRESSURE if report.state.swung.is_some() => {
                OF_LAGGING_PEAK * relative * value.abs()
            }
            _ => relative * value.abs(),
        };
        let by_increments = companion.by_increments(name, report.state.progress);
        if by_error || by_increments.is_some() {
            let time = by_steps + by_increments.unwrap_or_default();
            errors.push((format!("{}{name}", ERRORS[0]), time));
        }
        errors.extend(space.map(|error| (format!("{}{name}", ERRORS[1]), error)));
    }
    errors
}
