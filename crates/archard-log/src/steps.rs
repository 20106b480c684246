//! The steps of a log: rows of one step of the test, or of one run before distance, laps or time start again.

use std::ops::Range;

use crate::table::Table;

/// Names of columns that count the steps of a test, best first.
const STEPS: [&str; 6] = ["thisstep", "recipestep", "step", "sequenceid", "segment", "stage"];

/// The rows of each step: where the number of the step changes, or what counts up starts again.
pub fn steps(table: &Table, counters: &[&Vec<f64>]) -> Vec<Range<usize>> {
    let rows = table.lines.len();
    let changes = |values: &[f64]| values.windows(2).filter(|pair| pair[0] != pair[1]).count();
    // A counter of the readings changes in most rows; a step does not.
    let counts = STEPS.iter().filter_map(|name| table.columns.iter().find(|own| own.name == *name));
    let step = counts.into_iter().find(|own| 2 * changes(&own.values) < rows);
    let mut edges = vec![0];
    for row in 1..rows {
        let other = step.is_some_and(|own| own.values[row] != own.values[row - 1]);
        let start = edges[edges.len() - 1];
        if other || counters.iter().any(|own| starts_again(own, start, row)) {
            edges.push(row);
        }
    }
    edges.push(rows);
    edges.windows(2).map(|pair| pair[0]..pair[1]).collect()
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
