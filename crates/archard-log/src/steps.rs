//! The steps of a log: rows of one step of the test, or of one run before the distance starts again.

use std::ops::Range;

use crate::table::Table;

/// Names of columns that count the steps of a test, best first.
const STEPS: [&str; 5] = ["thisstep", "recipestep", "step", "segment", "stage"];

/// The rows of each step: where the number of the step changes, or the distance goes back.
pub fn steps(table: &Table, distance: &[f64]) -> Vec<Range<usize>> {
    let rows = table.lines.len();
    let changes = |values: &[f64]| values.windows(2).filter(|pair| pair[0] != pair[1]).count();
    // A counter of the readings changes in most rows; a step does not.
    let counts = STEPS.iter().filter_map(|name| table.columns.iter().find(|own| own.name == *name));
    let step = counts.into_iter().find(|own| 2 * changes(&own.values) < rows);
    let mut edges = vec![0];
    for row in 1..rows {
        let other = step.is_some_and(|own| own.values[row] != own.values[row - 1]);
        if other || distance[row] < distance[row - 1] {
            edges.push(row);
        }
    }
    edges.push(rows);
    edges.windows(2).map(|pair| pair[0]..pair[1]).collect()
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
