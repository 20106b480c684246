//! A step of a test: the readings under load and in motion, their rate, friction, jumps and spikes.

use crate::derive::ReadingState;
use crate::number::four;
use crate::rate::{self, FEWEST, Rate};
use crate::steps::{ends, median, range};
use crate::table::Table;
use crate::transducer;
use std::ops::Range;

/// A step of a test.
#[derive(Debug, Clone, Default)]
pub struct Step {
    /// First and last line in the log.
    pub lines: [usize; 2],
    /// Readings under load and in motion.
    pub readings: usize,
    /// Readings before the load was on or the motion began, and after.
    pub idle: usize,
    /// Normal load (N).
    pub load: Option<f64>,
    /// The smallest and the largest load (N) of tenths of the readings, if they differ by so much that no one load made the wear.
    pub changed: Option<[f64; 2]>,
    /// Radius of the track (m).
    pub radius: Option<f64>,
    /// Sliding speed (m/s).
    pub speed: Option<f64>,
    /// How far the bodies slid (m).
    pub distance: f64,
    /// The steady part.
    pub steady: Option<Rate>,
    /// The rate of the second half alone.
    pub second_half: Option<Rate>,
    /// Distance and height (m) of each jump of the transducer.
    pub jumps: Vec<(f64, f64)>,
    /// Line and distance (m) of each reading that is off alone, and left out.
    pub spikes: Vec<(usize, f64)>,
    /// Depth over distance (m/m) that the transducer drifts at rest, by its rate in time before the motion.
    pub drift: Option<f64>,
    /// Mean friction coefficient over the steady part, and its interval.
    pub friction: Option<(f64, [f64; 2])>,
    /// Why there is no wear coefficient, and what to do.
    pub refused: Option<String>,
    /// What was read, for a picture.
    pub course: Course,
}

/// Readings under load and in motion.
#[derive(Debug, Clone, Default)]
pub struct Course {
    /// Distance (m) and depth (m), which grows with wear, without spikes.
    pub depth: Vec<[f64; 2]>,
    /// The same of the spikes.
    pub spikes: Vec<[f64; 2]>,
    /// Distance (m) and friction coefficient.
    pub friction: Vec<[f64; 2]>,
}

impl Step {
    /// Wear coefficient over worn area, k/A (1/N), if it can be told.
    pub fn k_over_area(&self) -> Option<f64> {
        if self.refused.is_some() {
            return None;
        }
        Some(self.steady?.rate / self.load?)
    }

    /// The step of these rows; `start` is where the steady part begins (m), if a user says so.
    pub(crate) fn of(
        table: &Table,
        all: &ReadingState,
        rows: Range<usize>,
        start: Option<f64>,
    ) -> Self {
        let own = |values: &Option<Vec<f64>>| values.as_ref().map(|all| all[rows.clone()].to_vec());
        let distance = &all.distance[rows.clone()];
        let (load, friction, time) = (own(&all.load), own(&all.friction), own(&all.time));
        let wear = all.wear.as_ref().map(|wear| &wear.values[rows.clone()]);
        let full = load.as_deref().map(full).filter(|load| load.is_finite());
        let is_on = |row: &usize| {
            let on = load.as_ref().zip(full).is_none_or(|(load, full)| load[*row] > 0.5 * full);
            on && distance[*row].is_finite() && wear.is_none_or(|depth| depth[*row].is_finite())
        };
        let n = distance.len();
        // In motion are all from the first to the last change of the distance.
        let [first, last] = ends(distance).unwrap_or_default();
        let begins = distance.iter().position(|at| *at > first).unwrap_or(n).max(1) - 1;
        let end = distance.iter().rposition(|at| *at < last).map_or(0, |row| row + 1);
        let taken: Vec<usize> = (begins..n.min(end + 1)).filter(is_on).collect();
        let of = |all: &[f64]| -> Vec<f64> { taken.iter().map(|row| all[*row]).collect() };
        let along = of(distance);
        let slid = along.last().zip(along.first()).map_or(0.0, |(last, first)| last - first);
        let middle = |values: Option<Vec<f64>>| {
            values.map(|values| median(&of(&values))).filter(|value| value.is_finite())
        };
        let mut step = Step {
            lines: [table.lines[rows.start], table.lines[rows.end - 1]],
            readings: taken.len(),
            idle: n - taken.len(),
            load: full,
            changed: load.as_deref().and_then(|load| changed(&of(load))),
            radius: middle(own(&all.radius)),
            speed: middle(own(&all.speed)),
            distance: slid,
            ..Step::default()
        };
        let mut part = along.first().map_or(0.0, |first| first + 0.5 * slid);
        let mut still = false;
        if let (Some(raw), Some(chosen)) = (wear, &all.wear) {
            let read = of(raw);
            still = read.windows(2).all(|pair| pair[0] == pair[1]);
            let falls = read.last().zip(read.first()).is_some_and(|(last, first)| last < first);
            let sign = if falls && !chosen.grows { -1.0 } else { 1.0 };
            let depth: Vec<f64> = read.iter().map(|own| sign * own).collect();
            let lines: Vec<usize> = taken.iter().map(|row| table.lines[rows.start + row]).collect();
            let kept = step.take(&along, &depth, &lines);
            if !still {
                step.rates(kept, start, part);
            }
            let rest: Vec<usize> = (0..begins).filter(is_on).collect();
            if let Some(time) = &time {
                let moved =
                    taken.last().zip(taken.first()).map(|(last, first)| time[*last] - time[*first]);
                let at = |all: &[f64], sign: f64| -> Vec<f64> {
                    rest.iter().map(|row| sign * all[*row]).collect()
                };
                step.rests(&at(time, 1.0), &at(raw, sign), moved.unwrap_or_default());
            }
            part = step.steady.map_or(part, |rate| rate.part[0]);
        }
        if let Some(mu) = friction.map(|mu| of(&mu)) {
            let all = along.iter().zip(&mu).filter(|(_, mu)| mu.is_finite());
            step.course.friction = all.map(|(at, mu)| [*at, *mu]).collect();
            let later = step.course.friction.iter().filter(|point| point[0] >= part);
            step.friction = rate::mean(&later.map(|point| point[1]).collect::<Vec<_>>());
        }
        let slides = n < FEWEST || distance.iter().any(|at| *at > first);
        step.refused = step.refusal(all, still, slides, table.heading);
        step
    }

    /// Distance and depth without the spikes, which are noted.
    fn take(&mut self, along: &[f64], depth: &[f64], lines: &[usize]) -> [Vec<f64>; 2] {
        let spikes = transducer::spikes(depth);
        self.spikes = spikes.iter().map(|row| (lines[*row], along[*row])).collect();
        self.course.spikes = spikes.iter().map(|row| [along[*row], depth[*row]]).collect();
        let kept = || (0..depth.len()).filter(|row| spikes.binary_search(row).is_err());
        self.course.depth = kept().map(|row| [along[row], depth[row]]).collect();
        [along, depth].map(|all| kept().map(|row| all[row]).collect())
    }

    /// The rates of the steady part and of what follows the middle (m).
    fn rates(&mut self, [along, depth]: [Vec<f64>; 2], start: Option<f64>, middle: f64) {
        let jumps = transducer::jumps(&depth);
        let places: Vec<usize> = jumps.iter().map(|jump| jump.0).collect();
        self.jumps = jumps.iter().map(|(row, height)| (along[*row], *height)).collect();
        self.steady = match start {
            Some(start) => rate::from(start, &along, &depth, &places),
            None => rate::steady(&along, &depth, &places),
        };
        self.second_half = rate::from(middle, &along, &depth, &places);
    }

    /// What the transducer drifts under load before the motion (m over s), if zero is not in its interval; the steady rate may be
    /// wrong by as much over the time that the motion took.
    fn rests(&mut self, time: &[f64], depth: &[f64], moved: f64) {
        let still = depth.windows(2).all(|pair| pair[0] == pair[1]);
        let Some(rest) = rate::rate(time, depth, &[]).filter(|_| !still) else { return };
        let drift = rest.rate * moved / self.distance;
        let told = rest.interval[0] > 0.0 || rest.interval[1] < 0.0;
        let Some(steady) = self.steady.as_mut().filter(|_| told && drift.is_finite()) else {
            return;
        };
        self.drift = Some(drift);
        steady.interval[0] -= drift.max(0.0);
        steady.interval[1] -= drift.min(0.0);
    }

    /// Why it has no wear coefficient.
    fn refusal(
        &self,
        all: &ReadingState,
        still: bool,
        slides: bool,
        heading: usize,
    ) -> Option<String> {
        if !slides {
            return Some("the bodies did not slide in this step".into());
        }
        let Some(wear) = &all.wear else {
            if all.profile {
                return Some("what was worn stands in the profile: `archard fit` reads it by the row of `-o ROWS.csv`".into());
            }
            return Some(
                "no column holds a depth of wear: name it with --column wear=\"TITLE [um]\", or give a profile across the track with --profile FILE"
                    .into(),
            );
        };
        let title = &wear.title;
        if still && self.readings >= FEWEST {
            return Some(format!(
                "all readings of `{title}` are the same: the transducer read no wear"
            ));
        }
        let Some(rate) = self.steady else {
            return Some(format!(
                "{} readings under load and in motion are too few: a rate needs {FEWEST}",
                self.readings
            ));
        };
        if let Some(radius) = self.radius.filter(|radius| rate.rate.abs() * self.distance > *radius)
        {
            return Some(format!(
                "`{title}` in {} would be worn by {:.3} m, more than the radius of the track of {:.3} m: correct its unit in line {heading} of the log",
                wear.unit,
                rate.rate.abs() * self.distance,
                radius
            ));
        }
        if rate.interval[0] <= 0.0 && rate.interval[1] >= 0.0 {
            return Some(
                "the interval of the rate holds zero, so that wear cannot be told from drift of the transducer: test for longer, or weigh the specimen".into(),
            );
        }
        if rate.rate < 0.0 {
            return Some(format!(
                "`{title}` falls: if it counts downwards as the specimen wears, say --column wear=\"-{title}\"; else it grew or warmed"
            ));
        }
        if self.load.is_none() {
            return Some(
                "no column holds a load: give --set load=\"5 N\", or --column load=TITLE".into(),
            );
        }
        self.changed.map(|[low, high]| {
            format!(
                "the load goes from {} to {} N in this step, and no single load belongs to the rate: give the readings of each load a log of their own",
                four(low),
                four(high)
            )
        })
    }
}

/// Share of the load from which on a change counts: half of it is the most that one load misses the others by (a choice).
const CHANGE: f64 = 0.1;

/// The smallest and the largest median of tenths of the readings, if they differ by more than that share of the median of all.
fn changed(load: &[f64]) -> Option<[f64; 2]> {
    let tenths = load.chunks(load.len().div_ceil(10).max(1)).map(median);
    let [low, high] = range(&tenths.collect::<Vec<_>>());
    (load.len() >= FEWEST && high - low > CHANGE * median(load)).then_some([low, high])
}

/// The load that is on: the median of readings above half of the largest, spikes apart.
fn full(load: &[f64]) -> f64 {
    let middle = median(load);
    let peak = match transducer::spikes(load) {
        spikes if spikes.is_empty() => load.iter().copied().fold(middle, f64::max),
        spikes => (0..load.len())
            .filter(|row| spikes.binary_search(row).is_err())
            .map(|row| load[row])
            .fold(middle, f64::max),
    };
    median(&load.iter().copied().filter(|own| *own > 0.5 * peak).collect::<Vec<_>>())
}
