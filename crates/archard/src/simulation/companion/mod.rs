//! How far off the elements of a run are, by the same run on fewer elements, and the increments of its cycles, by one with fewer.
//!
//! What a run on half as many elements differs by from this one is the error of that one, and more than that of this one.
//! Where both curves cross it is nothing, though both are off: therefore the difference of two such runs counts too, from
//! half of the progress to twice of it, lowered to what their errors leave at this run's elements by their order. Both
//! times a factor: a difference is three times the error of the finer run where the order is two,
//! and as large as it where it is one.

mod compared;
mod least_error;
mod tip;

use super::history::{self, Row, number};
use compared::Compared;
use least_error::{LeastError, Touch, is_tangential};
pub use tip::Tip;

/// Factors on the error that a difference tells by its order: as a rule, and where friction decides what slips and the second
/// order shows late.
const AS_A_RULE: f64 = 1.5;
const OF_FRICTION: f64 = 4.5;
/// The same at a tip, and under the edge of a body, which is a staircase of elements besides.
const OF_EDGED: f64 = 2.0;
/// Forces and creepages that differ by less, relative, are what was prescribed or what friction bears at most.
pub(super) const PRESCRIBED: f64 = 1e-6;
/// The factor on counted areas, which err by the elements along their rim.
const OF_AREAS: f64 = 3.0;
/// The least factor on peak pressures, which stand at the rim where bodies wear; and where cycles move the rim to and fro, so that
/// they stand on single elements.
const OF_PEAKS: [f64; 2] = [1.0, 3.0];
/// The tangential force, relative to the load, and the creepage below which errors are not told by their sizes.
const OF_LOAD: f64 = 0.01;
const LEAST_CREEPAGE: f64 = 1e-5;

/// What the elements and the increments of a run err by, from others that have fewer.
#[derive(Debug, Clone)]
pub struct Companion {
    /// Runs on fewer elements and on fewer still.
    grids: Compared,
    /// How many the run has, and they.
    elements: [f64; 3],
    order: f64,
    tip: Option<Tip>,
    /// On the error that a difference tells by its order.
    factor: f64,
    least: LeastError,
    increments: Option<Increments>,
    /// The relative error that is asked for.
    pub asked: f64,
}

/// What the increments of its cycles err by.
#[derive(Debug, Clone)]
struct Increments {
    /// Runs on the fewest elements, with all increments and with fewer.
    pair: Compared,
    factor: f64,
}

/// How the error of a run behaves in the size of its elements.
#[derive(Debug, Clone, PartialEq)]
pub struct Kind {
    /// Its order.
    pub order: f64,
    /// Where a body is sharp.
    pub tip: Option<Tip>,
    /// From where on (the motion's own unit) elements have which area (m^2).
    pub areas: Vec<[f64; 2]>,
    /// Whether friction decides what slips.
    pub slips_partly: bool,
    /// The least power of the pressure by which a body wears, and the largest under the unworn peak pressure; both 1 in
    /// proportion.
    pub steepness: [f64; 2],
    /// Whether a surface passes through the contact, as a whole or to and fro.
    pub passes: bool,
    /// Tangential tractions that pressures bring about between unlike bodies: Dundurs' constant, and half of what friction
    /// bears at most.
    pub coupled: f64,
    /// The pressure, relative to the unworn peak, up to which what friction bears grows with it as from an edge on.
    pub grows: f64,
    /// Whether bodies touch along a line, in plane strain.
    pub line: bool,
    /// The period of cycles, which tangential forces are relative to (the motion's own unit).
    pub period: Option<f64>,
}

/// What errs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The elements, by the run itself and the others.
    Elements,
    /// The elements, as foreseen before the run.
    Foreseen,
    /// The increments of a cycle.
    Increments,
}

impl Companion {
    /// Of a run with so many elements across its contact, compared with others on so many; the finer one first.
    pub fn new(rows: [Vec<Row>; 2], elements: [f64; 3], kind: Kind, asked: f64) -> Self {
        let late = kind.slips_partly && kind.order >= 2.0;
        let least = LeastError::new(elements[0], late, &kind);
        let Kind { order, tip, period, .. } = kind;
        let edged = order < 2.0 && period.is_none();
        let factor = match (late, edged) {
            (true, _) => OF_FRICTION,
            (_, true) => OF_EDGED,
            _ => AS_A_RULE,
        };
        let grids = Compared::new(rows, period, false);
        Self { grids, elements, order, tip, factor, least, increments: None, asked }
    }

    /// The same where cycles are divided into so many increments, and a run on the fewest elements into fewer.
    pub fn with_increments(self, fewer: Vec<Row>, counts: [usize; 2]) -> Self {
        let [own, less] = counts.map(|count| 1.0 / count as f64);
        let rows = [self.grids.rows[1].clone(), fewer];
        let pair = Compared::new(rows, self.grids.period, true);
        let increments = Increments { pair, factor: AS_A_RULE * own / (less - own) };
        Self { increments: Some(increments), ..self }
    }

    /// The error (in its unit) of a value in a column at some progress, by the elements; `None` for one that the others do
    /// not have.
    pub fn error(&self, column: &str, progress: f64, value: f64) -> Option<f64> {
        let difference = (value - self.grids.at(0, self.grids.column(column)?, progress)).abs();
        let coarser = self.grids.difference(column, progress)?;
        Some(self.enclosing(column, (progress, value), [difference, coarser]))
    }

    /// The error (in its unit) in a column at some progress by the increments of the cycles; `None` where there are none.
    pub fn by_increments(&self, column: &str, progress: f64) -> Option<f64> {
        let Increments { pair, factor } = self.increments.as_ref()?;
        Some(factor * pair.difference(column, progress)?)
    }

    /// The columns of the finer of both at some progress.
    pub fn row(&self, progress: f64) -> Row {
        let names = self.grids.rows[0].first().into_iter().flatten().map(|(name, _)| name);
        let values = self.grids.all_at(0, progress);
        let mut row: Row = names.cloned().zip(values).collect();
        row.iter_mut().take(1).for_each(|first| first.1 = progress);
        row
    }

    /// The error of the worst of the quantities that count, relative to it, in a row of the run, or of the finer of both
    /// where the run is still to come.
    pub fn worst(&self, row: &[(String, f64)], part: Part) -> f64 {
        let progress = row.first().map_or(0.0, |first| first.1);
        let wears = number(row, history::WEAR_DEPTH).is_some_and(|depth| depth > 0.0);
        let force = self.force(row);
        let [along, across] = history::CREEPAGE.map(|name| number(row, name).unwrap_or_default());
        let creepage = along.hypot(across).max(LEAST_CREEPAGE);
        // What hardly converges is no reason for more elements.
        let hardly = |name: &str| {
            !wears && self.at_tip(name, progress).is_some()
                || name == history::PEAK_PRESSURE && self.least.has_cusps()
        };
        let counted = row.iter().filter(|(name, _)| history::counts(name, wears) && !hardly(name));
        let errors = counted.filter_map(|(name, value)| {
            let size = match &**name {
                name if history::FORCE.contains(&name) => force,
                name if history::CREEPAGE.contains(&name) => creepage,
                _ => value.abs(),
            };
            let error = match part {
                Part::Foreseen => {
                    let difference = self.grids.difference(name, progress)?;
                    self.enclosing(name, (progress, *value), [0.0, difference])
                }
                Part::Elements => self.error(name, progress, *value)?,
                Part::Increments => self.by_increments(name, progress)?,
            };
            (size > 0.0).then_some(error / size)
        });
        errors.fold(0.0, f64::max)
    }

    /// Whether a depth that counts errs by more than is allowed where a tip is sharp, and would on so many times as many elements.
    pub fn stays_sharp(&self, row: &[(String, f64)], allowed: f64, finer: f64) -> bool {
        let progress = row.first().map_or(0.0, |first| first.1);
        let Some(tip) = &self.tip else { return false };
        // Coarse elements see half of what wears, or more.
        let worn = 2.0 * self.worn_off(tip, progress);
        let tip = tip.on_finer(finer);
        let mut depths = row.iter().filter(|(name, value)| history::is_depth(name) && *value > 0.0);
        tip.is_sharp(worn)
            && depths.any(|(name, value)| {
                let error = self.error(name, progress, *value).unwrap_or_default() / value;
                let order = tip.order(name, worn).unwrap_or(self.order);
                error * finer.powf(-order) > allowed
            })
    }

    /// What errors of tangential forces are relative to (N): the largest force of the cycle, and some of the load at least.
    fn force(&self, row: &[(String, f64)]) -> f64 {
        let of = |row: &[(String, f64)]| {
            let [x, y] = history::FORCE.map(|name| number(row, name).unwrap_or_default());
            x.hypot(y)
        };
        let progress = row.first().map_or(0.0, |first| first.1);
        let near = self.grids.around(0, progress).map(|row| row[0].1);
        let within = |period: f64| {
            move |other: &&Row| near.iter().any(|near| (near - other[0].1).abs() <= period)
        };
        let cycle = self.grids.period.into_iter().flat_map(|period| {
            self.grids.rows[0].iter().filter(within(period)).map(|row| of(row)).collect::<Vec<_>>()
        });
        let least = OF_LOAD * number(row, history::LOAD).unwrap_or_default();
        cycle.chain([of(row)]).fold(least, f64::max)
    }

    /// The error (in its unit) of a value at some progress that differences tell, of the run and of the finer of the others from
    /// the next coarser one, or the least there is.
    fn enclosing(
        &self,
        column: &str,
        (progress, value): (f64, f64),
        [difference, coarser]: [f64; 2],
    ) -> f64 {
        let at_tip = self.at_tip(column, progress);
        let order = at_tip.unwrap_or(self.order).min(self.order);
        let [own, half, quarter] = self.elements.map(|elements| elements.powf(-order));
        let lowered = (half - own) / (quarter - half);
        let lowered = if lowered.is_finite() { lowered } else { 1.0 };
        let factor = self.factor(column, own / (half - own), at_tip.is_some());
        let told = factor * difference.max(lowered * coarser);
        // What has no bound is not known at all.
        let told = if at_tip.is_some() { told.min(value.abs()) } else { told };
        if told <= PRESCRIBED * value.abs() && self.is_given(column, progress) {
            return told;
        }
        let at = |name: &str| {
            let column = self.grids.column(name);
            column.map_or(0.0, |column| self.grids.at(0, column, progress))
        };
        let [x, y] = history::FORCE.map(at);
        let touch = Touch {
            contact: at(history::CONTACT_AREA),
            stick: at(history::STICK_AREA),
            load: at(history::LOAD),
            force: x.hypot(y),
        };
        let astray = at_tip.filter(|_| self.tip.as_ref().is_some_and(|tip| !tip.centred));
        let missed = astray.map_or(0.0, |order| self.least.of_tip(order, progress, touch.contact));
        told.max(missed * value.abs()).max(self.least.of(column, (progress, value), touch))
    }

    /// Whether a column that no grid changes is what was prescribed: creepages, or forces that creepages follow from. Other forces
    /// are all that friction bears then, as far as the elements see.
    fn is_given(&self, column: &str, progress: f64) -> bool {
        let follows = |name: &&str| {
            let creepage = self.grids.column(name);
            let creepage = creepage.map_or(0.0, |creepage| self.grids.at(0, creepage, progress));
            let difference = self.grids.difference(name, progress).unwrap_or_default();
            difference > PRESCRIBED * creepage.abs()
        };
        history::CREEPAGE.contains(&column)
            || is_tangential(column) && history::CREEPAGE.iter().any(follows)
    }

    /// The order by which a column converges at a tip that is sharp at some progress, where it does so more slowly than others.
    fn at_tip(&self, column: &str, progress: f64) -> Option<f64> {
        let tip = self.tip.as_ref()?;
        tip.order(column, self.worn_off(tip, progress))
    }

    /// How deep (m) a tip is worn at some progress.
    fn worn_off(&self, tip: &Tip, progress: f64) -> f64 {
        self.grids.column(&tip.depth).map_or(0.0, |worn| self.grids.at(0, worn, progress))
    }

    /// The factor on a difference in a column, where the error is so many times as large by its order, at a tip or not.
    fn factor(&self, column: &str, by_order: f64, at_tip: bool) -> f64 {
        let factor = if at_tip { self.factor.max(OF_EDGED) } else { self.factor };
        let factor = factor * by_order;
        match column {
            history::PEAK_PRESSURE => {
                factor.max(OF_PEAKS[usize::from(self.grids.period.is_some())])
            }
            column if column.contains("_area_") => OF_AREAS,
            _ => factor,
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Companion, Kind, Part, Row};

    const KIND: Kind = Kind {
        order: 2.0,
        tip: None,
        areas: vec![],
        slips_partly: false,
        steepness: [1.0; 2],
        passes: false,
        coupled: 0.0,
        grows: f64::INFINITY,
        line: false,
        period: None,
    };

    /// Depths s^(1/2) (1 + c / n^2) on n elements.
    fn depths(n: f64) -> Vec<Row> {
        let row = |i: i32| {
            let s = f64::from(i) * f64::from(i);
            vec![
                ("distance_m".to_owned(), s),
                ("wear_depth_m".to_owned(), s.sqrt() * (1.0 + 3.0 / (n * n))),
            ]
        };
        (0..20).map(row).collect()
    }

    /// An error of the second order is enclosed, at one and a half of it, also where the run itself shows no difference.
    #[test]
    fn errors_of_the_second_order_are_enclosed() {
        let companion = Companion::new([depths(12.0), depths(6.0)], [24.0, 12.0, 6.0], KIND, 0.01);
        let truth = 7.0;
        let error = truth * 3.0 / (24.0 * 24.0);
        for value in [truth + error, companion.row(49.0)[1].1] {
            let found = companion.error("wear_depth_m", 49.0, value).unwrap();
            assert_relative_eq!(found, 1.5 * error, max_relative = 0.02);
        }
        assert_relative_eq!(
            companion.row(50.0)[1].1,
            50f64.sqrt() * (1.0 + 3.0 / 144.0),
            max_relative = 1e-12
        );
        let row = vec![("distance_m".to_owned(), 49.0), ("wear_depth_m".to_owned(), truth)];
        assert_relative_eq!(
            companion.worst(&row, Part::Foreseen),
            1.5 * error / truth,
            max_relative = 0.03
        );
    }

    /// What lies farther ahead than twice the progress says nothing of it.
    #[test]
    fn what_comes_late_is_no_error_of_what_was_before() {
        let late = |n: f64| {
            let mut rows = depths(n);
            let off = 1.0 + 1.0 / n;
            rows.iter_mut().filter(|row| row[0].1 > 100.0).for_each(|row| row[1].1 *= off);
            rows
        };
        let kind = KIND;
        let companion = Companion::new([late(12.0), late(6.0)], [24.0, 12.0, 6.0], kind, 0.01);
        let error = |place: usize| companion.worst(&depths(24.0)[place], Part::Foreseen);
        assert_relative_eq!(error(7), 1.5 * 3.0 / (24.0 * 24.0), max_relative = 0.03);
        assert!(error(8) > 2.0 * error(7), "{} and {}", error(8), error(7));
    }

    /// A force that turns within each cycle, of which some are computed, in five increments.
    fn forces(n: f64, cycles: &[u32]) -> Vec<Row> {
        forces_in(5, n, cycles)
    }

    /// The same in so many increments.
    fn forces_in(count: u32, n: f64, cycles: &[u32]) -> Vec<Row> {
        let row = |at: f64| {
            let force =
                (20.0 - 1e-3 * at) * (1.0 + 1.0 / (n * n)) * (std::f64::consts::TAU * at).sin();
            vec![
                ("cycle".to_owned(), at),
                ("load_N".to_owned(), 50.0),
                ("force_x_N".to_owned(), force),
            ]
        };
        let part = move |i: u32| f64::from(i) / f64::from(count);
        let within = |cycle: u32| (1..=count).map(move |i| f64::from(cycle - 1) + part(i));
        [0.0].into_iter().chain(cycles.iter().copied().flat_map(within)).map(row).collect()
    }

    /// Runs that jump over different cycles are compared at the same place of a cycle.
    #[test]
    fn jumps_over_other_cycles_are_no_difference() {
        let grids = [forces(12.0, &[1, 400, 1000, 1600]), forces(6.0, &[1, 300, 900, 1000, 1600])];
        let kind = Kind { period: Some(1.0), ..KIND };
        let companion = Companion::new(grids, [24.0, 12.0, 6.0], kind, 0.01);
        let error = 1.5 / (24.0 * 24.0);
        for row in forces(24.0, &[200, 500, 1000, 1600]).split_off(1) {
            let found = companion.worst(&row, Part::Elements);
            assert!(found < 1.2 * error, "{found} at {}", row[0].1);
        }
        let row = &forces(24.0, &[1000])[1];
        assert_relative_eq!(companion.worst(row, Part::Foreseen), error, max_relative = 0.1);
    }

    /// Other increments of the same cycles are compared where both have them, not with what lies between.
    #[test]
    fn increments_between_those_of_the_other_are_no_difference() {
        let cycles = [1, 400, 1000];
        let [few, more] = [15, 20].map(|count| forces_in(count, 6.0, &cycles));
        let kind = Kind { period: Some(1.0), ..KIND };
        let grids = [forces_in(20, 12.0, &cycles), more];
        let companion = Companion::new(grids, [24.0, 12.0, 6.0], kind, 0.01);
        let companion = companion.with_increments(few, [20, 15]);
        for row in &forces_in(20, 24.0, &cycles)[1..] {
            let found = companion.worst(row, Part::Increments);
            assert!(found < 1e-9, "{found} at {}", row[0].1);
        }
    }
}
