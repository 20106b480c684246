//! The steps of a log: rows of one step of the test, or of one run before distance, laps or time start again.

use std::ops::Range;

use crate::table::Table;

/// Names of columns that count the steps of a test, best first.
const STEPS: [&str; 6] = ["thisstep", "recipestep", "step", "sequenceid", "segment", "stage"];

/// The rows of each step: where the number of the step changes, or what counts up starts again.
pub fn steps(table: &Table, counters: &[&Vec<f64>]) -> Vec<Range<usize>> {
    let rows = table.lines.len();
    let counters: Vec<Vec<f64>> = counters.iter().map(|own| held(own)).collect();
    let changes = |values: &[f64]| values.windows(2).filter(|pair| pair[0] != pair[1]).count();
    // A counter of the readings changes in most rows; a step does not.
    let counts = STEPS.iter().filter_map(|name| table.columns.iter().find(|own| own.name == *name));
    let step = counts.map(|own| held(&own.values)).find(|own| 2 * changes(own) < rows);
    let mut edges = vec![0];
    for row in 1..rows {
        let other = step.as_ref().is_some_and(|own| own[row] != own[row - 1]);
        let start = edges[edges.len() - 1];
        if other || counters.iter().any(|own| starts_again(own, start, row)) {
            edges.push(row);
        }
    }
    edges.push(rows);
    edges.windows(2).map(|pair| pair[0]..pair[1]).collect()
}

/// Values where a cell without one holds the last before it, or else the first behind it.
fn held(values: &[f64]) -> Vec<f64> {
    let mut last = ends(values).map_or(f64::NAN, |[first, _]| first);
    let hold = |own: &f64| {
        last = if own.is_nan() { last } else { *own };
        last
    };
    values.iter().map(hold).collect()
}

/// The first and the last value that is a number.
pub fn ends(values: &[f64]) -> Option<[f64; 2]> {
    let mut known = values.iter().copied().filter(|own| own.is_finite());
    let first = known.next()?;
    Some([first, known.next_back().unwrap_or(first)])
}

/// The smallest and the largest of values.
pub fn range(values: &[f64]) -> [f64; 2] {
    let ends = |[low, high]: [f64; 2], own: &f64| [low.min(*own), high.max(*own)];
    values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], ends)
}

/// Whether two values are the same within a hundredth: loads, radii and speeds of tests that are repeated (a choice).
pub fn near(one: f64, other: f64) -> bool {
    (one - other).abs() <= 0.01 * one.abs().max(other.abs())
}

/// Whether what counts up falls at a row, and has not passed what was reached there with the next one, as after a reading that is off.
fn starts_again(values: &[f64], start: usize, row: usize) -> bool {
    let reached = values[row - 1];
    let returns = values.get(row + 1).is_some_and(|next| *next >= reached);
    // A spike upwards falls back to what was there before it.
    let spike = row >= start + 2 && values[row] >= values[row - 2];
    values[row] < reached && !returns && !spike
}

/// The middle value; NaN of nothing.
pub fn median(values: &[f64]) -> f64 {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    match sorted.len() {
        0 => f64::NAN,
        n if n % 2 == 1 => sorted[n / 2],
        n => 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]),
    }
}
