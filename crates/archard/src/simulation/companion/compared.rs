//! Two runs of a case, compared wherever both have come to.

use crate::simulation::history::Row;

/// Two progresses are the same to this, relative.
const SAME: f64 = 1e-9;
/// Two places lie alike in their cycles to this part of a cycle.
const ALIKE: f64 = 1e-6;
/// The most by which a difference is scaled to where it is needed.
const MOST_SCALED: f64 = 4.0;

/// The rows of two runs, the finer one first. All have the same columns.
#[derive(Debug, Clone)]
pub(super) struct Compared {
    pub(super) rows: [Vec<Row>; 2],
    /// Where the coarser has rows, in their order.
    apart: Vec<Apart>,
    pub(super) period: Option<f64>,
    /// Whether they have different increments in a cycle: within it forces turn, and only what both show can be compared.
    within: bool,
}

/// How far two runs are apart at some progress.
#[derive(Debug, Clone)]
struct Apart {
    progress: f64,
    /// The finer one's value in each column, and the difference.
    columns: Vec<[f64; 2]>,
}

impl Compared {
    pub(super) fn new(rows: [Vec<Row>; 2], period: Option<f64>, within: bool) -> Self {
        let mut pair = Self { rows, apart: vec![], period, within };
        let places = pair.rows[1].iter().map(|row| row[0].1);
        let places = places.filter(|at| !within || pair.is_shown(*at));
        let apart = |progress: f64| {
            let [finer, coarser] = [0, 1].map(|which| pair.all_at(which, progress));
            let columns = finer.zip(coarser).map(|(finer, coarser)| [finer, finer - coarser]);
            Apart { progress, columns: columns.collect() }
        };
        pair.apart = places.map(apart).collect();
        pair
    }

    /// The place of a column in the rows.
    pub(super) fn column(&self, name: &str) -> Option<usize> {
        self.rows[0].first()?.iter().position(|(known, _)| known == name)
    }

    /// The largest difference of the two around some progress.
    pub(super) fn difference(&self, column: &str, progress: f64) -> Option<f64> {
        let column = self.column(column)?;
        let here = self.at(0, column, progress);
        let last = (2.0 * progress).max(progress + self.period.unwrap_or_default());
        let first = self.apart.partition_point(|apart| apart.progress < 0.5 * progress);
        let near = self.apart[first..].iter().take_while(|apart| apart.progress <= last);
        let itself = (!self.within).then(|| [here, here - self.at(1, column, progress)]);
        let difference = |[finer, difference]: [f64; 2]| {
            let scale = if finer == 0.0 { 1.0 } else { (here / finer).abs().min(MOST_SCALED) };
            scale * difference.abs()
        };
        let differences = near.map(|apart| apart.columns[column]).chain(itself).map(difference);
        Some(differences.fold(0.0, f64::max))
    }

    /// Whether the finer of both has a row there.
    fn is_shown(&self, progress: f64) -> bool {
        let [before, after] = self.beside(0, progress);
        [before, after].iter().any(|row| (row[0].1 - progress).abs() <= SAME * progress.abs())
    }

    /// A column of one of them at some progress.
    pub(super) fn at(&self, which: usize, column: usize, progress: f64) -> f64 {
        between(self.around(which, progress), column, progress)
    }

    /// All columns of one of them at some progress.
    pub(super) fn all_at(&self, which: usize, progress: f64) -> impl Iterator<Item = f64> {
        let around = self.around(which, progress);
        (0..around[0].len()).map(move |column| between(around, column, progress))
    }

    /// The rows of one of them before and behind some progress, or the only one there is. Runs jump over different cycles,
    /// in which forces turn: rows lie alike in their cycles where there are such.
    pub(super) fn around(&self, which: usize, progress: f64) -> [&Row; 2] {
        let rows = &self.rows[which];
        let Some(period) = self.period else { return self.beside(which, progress) };
        let behind = rows.partition_point(|row| row[0].1 < progress);
        let alike = |row: &&Row| {
            let cycles = (row[0].1 - progress) / period;
            (cycles - cycles.round()).abs() <= ALIKE
        };
        let before = rows[..behind].iter().rev().find(alike);
        let after = rows[behind..].iter().find(alike);
        match before.or(after).zip(after.or(before)) {
            Some((before, after)) => [before, after],
            None => self.beside(which, progress),
        }
    }

    /// The rows of one of them next to some progress.
    fn beside(&self, which: usize, progress: f64) -> [&Row; 2] {
        let rows = &self.rows[which];
        let behind = rows.partition_point(|row| row[0].1 < progress);
        [&rows[behind.saturating_sub(1)], &rows[behind.min(rows.len() - 1)]]
    }
}

/// A column at some progress between two rows: a power of it where all is positive, otherwise straight.
fn between([before, after]: [&Row; 2], column: usize, progress: f64) -> f64 {
    let (from, to) = (before[0].1, after[0].1);
    let (low, high) = (before[column].1, after[column].1);
    if to <= from {
        return high;
    }
    if [from, low, high].into_iter().all(|one| one > 0.0) {
        let share = (progress / from).ln() / (to / from).ln();
        return low * (high / low).powf(share);
    }
    low + (high - low) * ((progress - from) / (to - from)).clamp(0.0, 1.0)
}
