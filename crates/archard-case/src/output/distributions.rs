//! How pressures, gaps and heights of rough surfaces are distributed: the value that each share of the surface reaches.
//!
//! That of heights is the bearing curve (the areal material ratio of ISO 25178-2, read from share to height).

use super::Error;
use super::table::{Table, number};
use archard::problem::{ContactProblem, ContactState};

/// The file, a block of rows for each output.
pub(super) const DISTRIBUTIONS: &str = "distributions.csv";

/// Shares from none to all: whole per cent.
const PARTS: usize = 100;

/// Adds the distributions of rough surfaces to a table. Pressures are those of the contact, gaps and heights those of the frame;
/// heights count from their mean.
pub(super) fn write(
    table: &mut Table,
    problem: &ContactProblem,
    state: &ContactState,
) -> Result<(), Error> {
    let gap = state.gap_of(problem);
    let pressures = state.pressure.iter().copied().filter(|pressure| *pressure > 0.0);
    let mut columns = vec![
        ("pressure_Pa".to_owned(), falling(pressures)),
        ("gap_m".to_owned(), falling(gap.iter().map(|gap| gap.max(0.0)))),
    ];
    for (index, body) in problem.bodies.iter().enumerate() {
        let heights = problem.heights(state, index);
        let mean = heights.iter().sum::<f64>() / heights.len() as f64;
        let above = falling(heights.into_iter().map(|height| height - mean));
        columns.push((format!("height_{}_m", body.name), above));
    }
    for part in 0..=PARTS {
        let share = part as f64 / PARTS as f64;
        let mut row = vec![(problem.motion.progress.column, number(state.progress))];
        row.push(("fraction", number(share)));
        row.extend(columns.iter().map(|(name, all)| (&name[..], number(reached(all, share)))));
        table.row(&row)?;
    }
    table.flush()
}

/// Values from the largest down.
fn falling(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(|one, other| other.total_cmp(one));
    values
}

/// The value that a share of all reaches or exceeds, of values that fall; zero of none.
fn reached(falling: &[f64], share: f64) -> f64 {
    let Some(last) = falling.len().checked_sub(1) else { return 0.0 };
    let place = share * last as f64;
    let before = (place as usize).min(last);
    let after = (before + 1).min(last);
    // The zero turns -0, which would be shown, into 0.
    falling[before] + (place - before as f64) * (falling[after] - falling[before]) + 0.0
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{falling, reached};

    /// Heights that are spread evenly from 0 to 4: a quarter lies above 3.
    #[test]
    fn a_share_reaches_its_value() {
        let all = falling((0..=400).map(|i| f64::from((i * 7) % 401) * 0.01));
        assert_eq!([0.0, 1.0].map(|share| reached(&all, share)), [4.0, 0.0]);
        assert_relative_eq!(reached(&all, 0.25), 3.0, max_relative = 1e-12);
        assert_eq!(reached(&[], 0.5), 0.0);
    }
}
