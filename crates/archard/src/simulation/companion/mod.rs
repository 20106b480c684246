//! The discretisation error of a run, by the same run on coarser grids.
//!
//! A companion is the whole run made coarser by a ratio r: elements and increments of a cycle r times as large, r^2 times the
//! tolerance of the steps. The grids of companions lie half an element apart, so that they do not agree by chance. The stated
//! error of a quantity is
//!
//! ```text
//! max |f_i - f_j| / (r_j^p - r_i^p)
//! ```
//!
//! over all pairs of runs, the run itself (r = 1) among them. Between its rows a run lies between two interpolations: the difference
//! is the distance to the nearer one, and the error is no less than the least distance to a farther one. Two companions are compared
//! from a quarter of the progress to four times of it, the run with each of them at its own progress. The order p is that of the quantity's class. This is the grid
//! convergence index (P. J. Roache, *J. Fluids Eng.* 116 (1994) 405; ASME V&V 20) for runs whose grids are moved besides. It has no
//! factor of safety, since it is the largest of many differences: 99 of 100 errors of a random sample are within it
//! (`tests/honesty.rs`).
//!
//! A count of elements changes by single ones, which no pair of runs may show. Two counts therefore differ by one row of elements
//! across the contact at least.

mod compared;

use std::f64::consts::PI;

use super::history::{self, Class, Row, number};
pub use compared::Companion;
use compared::{Compared, Difference};

/// The least ratio of two companions that are compared, the geometric mean of one and a root of two: their ratios are one of these
/// apart, but for the rounding of their numbers of elements.
const APART: f64 = 1.19;
/// Rows of elements that stick; with fewer, all grids may show that everything slips, since one row of a coarser grid is wider.
const UNSEEN: f64 = 2.0;
/// The tangential force, relative to the load, and the creepage below which errors are not told by their sizes.
const OF_LOAD: f64 = 0.01;
const LEAST_CREEPAGE: f64 = 1e-5;

/// Runs of a case on coarser grids.
#[derive(Debug, Clone)]
pub struct Companions {
    runs: Vec<Companion>,
    /// Each two of them whose ratios differ.
    pairs: Vec<Compared>,
    regularity: Regularity,
    /// The relative error that is asked for.
    pub asked: f64,
}

/// What decides how fast the quantities of a problem converge.
#[derive(Debug, Clone, PartialEq)]
pub struct Regularity {
    /// The power of the distance by which the sharper body recedes from where it is sharpest: 2 where both are smooth, 1 at the
    /// tip of a cone, 0 at an edge.
    pub sharpest: f64,
    /// Whether the pressure at the frame's centre is a value of its own, to which elements converge as they do elsewhere: not at
    /// a tip, nor on rough surfaces, nor where bodies yield. Else it is stated and does not count.
    pub centre: bool,
    /// Whether bodies roll and may stick, in less than an element too.
    pub may_stick: bool,
    /// The columns of what is prescribed.
    pub given: Vec<&'static str>,
    /// From where on (the motion's own unit) elements have which area (m^2).
    pub areas: Vec<[f64; 2]>,
    /// Whether bodies touch along a line, in plane strain.
    pub line: bool,
    /// The period of cycles (the motion's own unit).
    pub period: Option<f64>,
}

impl Regularity {
    /// The order by which quantities of a class converge at least; `None` where they have no limit, or none is known.
    fn order(&self, class: Class) -> Option<f64> {
        let has_edge = self.sharpest == 0.0;
        let has_tip = !has_edge && self.sharpest < 2.0;
        match class {
            Class::Uncertain => None,
            Class::Peak if has_edge => None,
            // Pressures at a tip go as the power n - 1 of the distance.
            Class::Peak | Class::Pressure if has_tip => {
                (self.sharpest > 1.0).then_some(self.sharpest - 1.0)
            }
            Class::Depth if has_tip => Some(0.5 * self.sharpest),
            _ => Some(1.0),
        }
    }

    /// Whether a run is judged by a column.
    fn counts(&self, column: &str, wears: bool) -> bool {
        history::counts(column, wears) && (self.centre || column != history::CENTRE_PRESSURE)
    }

    /// Elements across a contact of that area (m^2) at some progress.
    fn across(&self, contact: f64, progress: f64) -> f64 {
        let reached = self.areas.iter().rev().find(|[from, _]| *from <= progress);
        let elements = reached.map_or(f64::INFINITY, |[_, element]| contact / element);
        if self.line { elements } else { 2.0 * (elements / PI).sqrt() }
    }
}

impl Companions {
    /// Of a run that asks for some accuracy.
    pub fn new(runs: Vec<Companion>, regularity: Regularity, asked: f64) -> Self {
        let period = regularity.period;
        let differ = |one: &Companion, other: &Companion| other.ratio > APART * one.ratio;
        let pairs = runs.iter().flat_map(|finer| {
            let coarser = runs.iter().filter(move |coarser| differ(finer, coarser));
            coarser.map(move |coarser| Compared::new([finer, coarser], period))
        });
        Self { pairs: pairs.collect(), runs, regularity, asked }
    }

    /// Whether two of them are on different grids, so that they foresee errors of the run.
    pub fn foresee(&self) -> bool {
        !self.pairs.is_empty()
    }

    /// Whether errors of a column are known, as far as its class goes.
    pub fn states(&self, column: &str) -> bool {
        let known = || self.regularity.order(history::class(column)).and(self.column(column));
        self.regularity.given.contains(&column) || known().is_some()
    }

    /// The error (in its unit) of a value in a column at some progress; `None` where none is known.
    pub fn error(&self, column: &str, progress: f64, value: f64) -> Option<f64> {
        let period = self.regularity.period;
        let shown = |run: &Companion, place| run.difference(place, (progress, value), period);
        self.error_by(column, (progress, value), shown)
    }

    /// The error of a value in a row of the run: no less than its solver leaves, unless it is prescribed.
    pub(super) fn stated(&self, row: &[(String, f64)], column: &str, value: f64) -> Option<f64> {
        let error = self.error(column, row.first()?.1, value)?;
        let residual = number(row, history::RESIDUAL).unwrap_or_default().max(f64::EPSILON);
        let prescribed = self.regularity.given.contains(&column);
        Some(if prescribed { error } else { error.max(residual * value.abs()) })
    }

    /// The error that the companions alone foresee.
    fn foreseen(&self, column: &str, progress: f64, value: f64) -> Option<f64> {
        self.error_by(column, (progress, value), |_, _| Some(Difference::from(0.0)))
    }

    /// The error of a value in a column, by how far it is from that of a companion.
    fn error_by(
        &self,
        column: &str,
        at: (f64, f64),
        difference: impl Fn(&Companion, usize) -> Option<Difference>,
    ) -> Option<f64> {
        if self.regularity.given.contains(&column) {
            return Some(0.0);
        }
        let class = history::class(column);
        let order = self.regularity.order(class)?;
        let place = self.column(column)?;
        let grain = self.grain(class, at);
        let shown = self.runs.iter().filter_map(|run| {
            let difference = difference(run, place)?.no_less(grain * (run.ratio - 1.0));
            Some(difference.times(1.0 / (run.ratio.powf(order) - 1.0)))
        });
        let around = self.pairs.iter().filter_map(|pair| {
            let [finer, coarser] = pair.ratios.map(|ratio| ratio.powf(order));
            Some(pair.difference(place, class.grows(), at)?.times(1.0 / (coarser - finer)))
        });
        shown.chain(around).reduce(Difference::and).map(Difference::bound)
    }

    /// The least difference between the run and a companion, over r - 1. An area in whole elements differs by a row of them across
    /// the contact, or by as many as may stick unseen; what friction makes differs by half a row where so few stick.
    fn grain(&self, class: Class, (progress, value): (f64, f64)) -> f64 {
        let at = |name: &str| {
            let first = self.runs.first()?;
            Some(first.at(self.column(name)?, progress, self.regularity.period))
        };
        let contact = at(history::CONTACT_AREA).unwrap_or_default();
        let across = self.regularity.across(contact, progress);
        let sticks = || at(history::STICK_AREA).is_none_or(|area| across * area > UNSEEN * contact);
        let of_friction =
            matches!(class, Class::Force | Class::Shift | Class::Volume | Class::Depth);
        match class {
            _ if contact == 0.0 => 0.0,
            Class::Count if sticks() => contact / across,
            Class::Count => UNSEEN * contact / across,
            _ if self.regularity.may_stick && of_friction && !sticks() => {
                0.5 * value.abs() / across
            }
            _ => 0.0,
        }
    }

    /// The columns of the finest companion at some progress.
    pub fn row(&self, progress: f64) -> Row {
        let finest = self.runs.iter().min_by(|one, other| one.ratio.total_cmp(&other.ratio));
        let Some(finest) = finest else { return vec![] };
        let names = finest.rows.first().into_iter().flatten().map(|(name, _)| name.clone());
        let value = |(place, name)| (name, finest.at(place, progress, self.regularity.period));
        let mut row: Row = names.enumerate().map(value).collect();
        row.iter_mut().take(1).for_each(|first| first.1 = progress);
        row
    }

    /// The column of the worst of the quantities that count and its error, relative to it, in a row of the run; `None` where none
    /// has an error.
    pub fn worst(&self, row: &[(String, f64)]) -> Option<(String, f64)> {
        self.worst_by(row, |name, value| self.stated(row, name, value))
    }

    /// The same of areas, pressures, volumes and depths that do not count.
    pub fn worst_uncounted(&self, row: &[(String, f64)]) -> Option<(String, f64)> {
        let wears = wears(row);
        let others = row.iter().filter(|(name, value)| {
            *value != 0.0 && !history::counts(name, wears) && history::class(name).grows()
        });
        let errors = others.filter_map(|(name, value)| {
            Some((name.clone(), self.stated(row, name, *value)? / value.abs()))
        });
        errors.max_by(|one, other| one.1.total_cmp(&other.1))
    }

    /// The error of the worst that counts at some progress of the run that is still to come.
    pub fn worst_foreseen(&self, progress: f64) -> f64 {
        let row = self.row(progress);
        let worst = self.worst_by(&row, |name, value| self.foreseen(name, progress, value));
        worst.map_or(0.0, |(_, error)| error)
    }

    fn worst_by(
        &self,
        row: &[(String, f64)],
        error: impl Fn(&str, f64) -> Option<f64>,
    ) -> Option<(String, f64)> {
        let force = self.force(row);
        let [along, across] = history::CREEPAGE.map(|name| number(row, name).unwrap_or_default());
        let creepage = along.hypot(across).max(LEAST_CREEPAGE);
        // Where bodies wear at a given approach, the load fades to nothing.
        let load = self.largest(history::LOAD);
        let wears = wears(row);
        let counted = row.iter().filter(|(name, _)| self.regularity.counts(name, wears));
        let errors = counted.filter_map(|(name, value)| {
            let size = match &**name {
                name if history::FORCE.contains(&name) => force,
                name if history::CREEPAGE.contains(&name) => creepage,
                history::LOAD => load,
                _ => value.abs(),
            };
            let error = (size > 0.0).then_some(error(name, *value)? / size)?;
            Some((name.clone(), error))
        });
        errors.filter(|(_, error)| *error > 0.0).max_by(|one, other| one.1.total_cmp(&other.1))
    }

    /// What errors of tangential forces are relative to (N): in cycles the largest force of any, since runs jump over most of
    /// them; some of the load at least.
    fn force(&self, row: &[(String, f64)]) -> f64 {
        let of = |row: &[(String, f64)]| {
            let [x, y] = history::FORCE.map(|name| number(row, name).unwrap_or_default());
            x.hypot(y)
        };
        let turns = self.regularity.period.is_some();
        let cycles = self.runs.iter().filter(|_| turns).flat_map(|run| &run.rows);
        let least = OF_LOAD * number(row, history::LOAD).unwrap_or_default();
        cycles.map(|row| of(row)).chain([of(row)]).fold(least, f64::max)
    }

    /// The largest value in a column of any companion.
    fn largest(&self, column: &str) -> f64 {
        let Some(place) = self.column(column) else { return 0.0 };
        let rows = self.runs.iter().flat_map(|run| &run.rows);
        rows.map(|row| row[place].1).fold(0.0, f64::max)
    }

    /// The place of a column in the rows.
    fn column(&self, name: &str) -> Option<usize> {
        let row = self.runs.first()?.rows.first()?;
        row.iter().position(|(known, _)| known == name)
    }
}

/// Whether anything is worn in a row.
fn wears(row: &[(String, f64)]) -> bool {
    number(row, history::WEAR_DEPTH).is_some_and(|depth| depth > 0.0)
}

#[cfg(test)]
mod tests {
    use super::{Companion, Companions, Regularity};
    use crate::simulation::history::{APPROACH, LOAD, RESIDUAL, Row};

    const RESIDUAL_LEFT: f64 = 1e-6;

    fn row(progress: f64, approach: f64) -> Row {
        let cells = [("distance_m", progress), (LOAD, 10.0), (APPROACH, approach)];
        let cells = cells.into_iter().chain([(RESIDUAL, RESIDUAL_LEFT)]);
        cells.map(|(name, value)| (name.to_owned(), value)).collect()
    }

    /// Companions that show the rows of these progresses.
    fn companions(progresses: [&[f64]; 3], approach: impl Fn(f64, f64) -> f64) -> Companions {
        let runs = [2.0, 2.8, 2.9].into_iter().zip(progresses).map(|(ratio, progresses)| {
            let rows = progresses.iter().map(|&place| row(place, approach(place, ratio)));
            Companion { ratio, rows: rows.collect() }
        });
        let regularity = Regularity {
            sharpest: 2.0,
            centre: true,
            may_stick: false,
            given: vec![LOAD],
            areas: vec![[0.0, 1e-12]],
            line: false,
            period: None,
        };
        Companions::new(runs.collect(), regularity, 0.01)
    }

    /// Between rows, where all values lie between the interpolations of others, errors are not zero: as the rows come closer,
    /// none is below that of the elements.
    #[test]
    fn values_between_interpolations_have_errors() {
        // Between a straight line and a power of the distance.
        let approach = |place: f64, ratio: f64| (0.5 + place.sqrt()) * (1.0 + 1e-3 * ratio);
        let far: [&[f64]; 3] = [&[1.0, 64.0], &[1.1, 60.0], &[1.2, 62.0]];
        let known = companions(far, approach);
        for place in [2.0, 4.0, 8.0, 16.0, 32.0] {
            let value = approach(place, 1.0);
            let error = known.stated(&row(place, value), APPROACH, value).unwrap();
            assert!(error >= 1e-3 * value, "{place}: {error} of {value}");
        }
    }

    /// What all runs agree on errs by what its solver leaves; what is prescribed does not.
    #[test]
    fn no_error_is_below_the_residual() {
        let places: [&[f64]; 3] = [&[1.0, 2.0]; 3];
        let row = row(1.0, 3.0);
        let known = companions(places, |_, _| 3.0);
        assert_eq!(known.stated(&row, APPROACH, 3.0), Some(RESIDUAL_LEFT * 3.0));
        assert_eq!(known.stated(&row, LOAD, 10.0), Some(0.0));
    }
}
