//! A coarser run, and two of them compared wherever both have come to.

use crate::simulation::history::Row;

/// Two progresses are the same to this, relative; and two places in a cycle, to this part of it.
const SAME: f64 = 1e-6;
/// The largest ratio of the progress at which a difference counts to the present one, and of the sizes of both values.
const WINDOW: f64 = 4.0;

/// A run made coarser.
#[derive(Debug, Clone)]
pub struct Companion {
    /// How many times as large its elements are.
    pub ratio: f64,
    /// What it showed.
    pub rows: Vec<Row>,
}

impl Companion {
    /// A column at some progress. Runs jump over different cycles, in which forces turn: the rows between which it lies are at
    /// the same place of their cycles where there are such.
    pub(super) fn at(&self, column: usize, progress: f64, period: Option<f64>) -> f64 {
        let [power, _] = between(self.around(progress, period), column, progress);
        power
    }

    /// By how much a value at some progress differs from what this run shows there; `None` where it does not come that far, does not
    /// show that place of a cycle, or no number. Between its rows this run lies somewhere between two interpolations.
    pub(super) fn difference(
        &self,
        column: usize,
        (progress, value): (f64, f64),
        period: Option<f64>,
    ) -> Option<Difference> {
        if self.rows.last().is_none_or(|last| progress > last[0].1 * (1.0 + SAME)) {
            return None;
        }
        let around = match period {
            Some(period) => self.in_cycle(progress, period)?,
            None => self.beside(progress),
        };
        let [power, straight] = between(around, column, progress);
        let (low, high) = (power.min(straight), power.max(straight));
        let numbers = ![low, high, value].into_iter().any(f64::is_nan);
        numbers.then(|| Difference {
            least: (low - value).max(value - high).max(0.0),
            most: (high - value).max(value - low),
        })
    }

    fn around(&self, progress: f64, period: Option<f64>) -> [&Row; 2] {
        let in_cycle = period.and_then(|period| self.in_cycle(progress, period));
        in_cycle.unwrap_or_else(|| self.beside(progress))
    }

    /// The rows next to some progress at the same place of their cycles, or the only one there is.
    fn in_cycle(&self, progress: f64, period: f64) -> Option<[&Row; 2]> {
        let behind = self.rows.partition_point(|row| row[0].1 < progress);
        let alike = |row: &&Row| {
            let cycles = (row[0].1 - progress) / period;
            (cycles - cycles.round()).abs() <= SAME
        };
        let before = self.rows[..behind].iter().rev().find(alike);
        let after = self.rows[behind..].iter().find(alike);
        before.or(after).zip(after.or(before)).map(<[&Row; 2]>::from)
    }

    /// The rows next to some progress.
    fn beside(&self, progress: f64) -> [&Row; 2] {
        let behind = self.rows.partition_point(|row| row[0].1 < progress);
        [&self.rows[behind.saturating_sub(1)], &self.rows[behind.min(self.rows.len() - 1)]]
    }
}

/// How far two runs are apart, in the unit of the quantity: at least so much, and at most.
#[derive(Debug, Clone, Copy)]
pub(super) struct Difference {
    least: f64,
    most: f64,
}

impl Difference {
    /// No less than that.
    pub(super) const fn from(least: f64) -> Self {
        Self { least, most: f64::INFINITY }
    }

    /// Both multiplied.
    pub(super) fn times(self, factor: f64) -> Self {
        Self { least: factor * self.least, most: factor * self.most }
    }

    /// With some least difference.
    pub(super) fn no_less(self, than: f64) -> Self {
        Self { least: self.least.max(than), most: self.most.max(than) }
    }

    /// What is known by both.
    pub(super) fn and(self, other: Self) -> Self {
        Self { least: self.least.max(other.least), most: self.most.min(other.most) }
    }

    /// The largest that is known, and no less than the best known one may be.
    pub(super) fn bound(self) -> f64 {
        if self.most.is_finite() { self.least.max(self.most) } else { self.least }
    }
}

/// Two companions, the finer one first.
#[derive(Debug, Clone)]
pub(super) struct Compared {
    pub(super) ratios: [f64; 2],
    /// Where the coarser one has rows, in their order.
    apart: Vec<Apart>,
    period: Option<f64>,
}

/// How far two runs are apart at some progress.
#[derive(Debug, Clone)]
struct Apart {
    progress: f64,
    /// The coarser one's value in each column, and the difference; `None` where one of them is no number.
    columns: Vec<Option<(f64, Difference)>>,
}

impl Compared {
    pub(super) fn new(pair: [&Companion; 2], period: Option<f64>) -> Self {
        let [finer, coarser] = pair;
        let apart = coarser.rows.iter().map(|row| {
            let progress = row[0].1;
            let value = |(place, cell): (usize, &(String, f64))| {
                Some((cell.1, finer.difference(place, (progress, cell.1), period)?))
            };
            Apart { progress, columns: row.iter().enumerate().map(value).collect() }
        });
        Self { ratios: pair.map(|run| run.ratio), apart: apart.collect(), period }
    }

    /// The difference of the two around some progress, at which the run has a value; relative to their values where they grow.
    pub(super) fn difference(
        &self,
        column: usize,
        grows: bool,
        (progress, here): (f64, f64),
    ) -> Option<Difference> {
        let period = self.period.unwrap_or_default();
        let first = (progress / WINDOW).min(progress - period);
        let last = (WINDOW * progress).max(progress + period) * (1.0 + SAME);
        let from = self.apart.partition_point(|apart| apart.progress < first * (1.0 - SAME));
        let near = self.apart[from..].iter().take_while(|apart| apart.progress <= last);
        let difference = |apart: &Apart| {
            let (there, difference) = apart.columns[column]?;
            let scales = grows && there != 0.0;
            let scale = if scales { (here / there).abs().min(WINDOW) } else { 1.0 };
            Some(difference.times(scale))
        };
        near.filter_map(difference).reduce(Difference::and)
    }
}

/// A column at some progress between two rows, by a power of it where all is positive, and on a straight line.
fn between([before, after]: [&Row; 2], column: usize, progress: f64) -> [f64; 2] {
    let (from, to) = (before[0].1, after[0].1);
    let (low, high) = (before[column].1, after[column].1);
    if to <= from {
        return [high; 2];
    }
    let straight = low + (high - low) * ((progress - from) / (to - from)).clamp(0.0, 1.0);
    if [from, low, high].into_iter().all(|one| one > 0.0) {
        let share = (progress / from).ln() / (to / from).ln();
        return [low * (high / low).powf(share.clamp(0.0, 1.0)), straight];
    }
    [straight; 2]
}
