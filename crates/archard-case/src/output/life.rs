//! How long a part lasts: where a quantity first reaches its limit.
//!
//! A step ends beyond the limit. On it the quantity is taken to go as a power of the progress, as wear does that begins from nothing
//! (a depth under a point contact as its root); what lies between that and a straight line is the error of
//! reading. The error stated of the quantity there is divided by its slope.

use std::error::Error as StdError;
use std::fmt;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use archard::motion::{Motion, Progress};
use archard::simulation::history::{self, COLUMNS, Class, SCAR, number, of_body, stated};
use archard::simulation::{Observer, Report};

/// The value (SI) of a column of the history at which a run ends.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Limit {
    /// The column, of one body where there is one for each.
    pub column: String,
    /// The value (SI).
    pub value: f64,
}

impl Limit {
    /// The same of so many times the value.
    pub(crate) fn times(&self, factor: f64) -> Self {
        Self { column: self.column.clone(), value: factor * self.value }
    }

    /// The columns that can have one, of bodies of these names: each with its name in a case, which is without unit, and its unit.
    pub fn columns(bodies: [&str; 2]) -> Vec<(String, String, &'static str)> {
        let grows = |class: Class| matches!(class, Class::Depth | Class::Volume);
        let of_wear = |column: &&history::Column| {
            grows(column.class) && UNITS.contains(&column.unit) || SCAR.contains(&column.name)
        };
        let all = COLUMNS.iter().filter(of_wear).flat_map(|column| {
            let each = bodies.map(|body| of_body(column.name, body));
            let names = if each[0] == each[1] { each[..1].to_vec() } else { each.to_vec() };
            names.into_iter().map(|name| (name, column.unit))
        });
        all.map(|(name, unit)| {
            let key = name.strip_suffix(&format!("_{unit}")).unwrap_or(&name).to_owned();
            (key, name, written(unit))
        })
        .collect()
    }
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {:e}", self.column, self.value)
    }
}

/// Units of columns that grow with wear.
const UNITS: [&str; 4] = ["m", "m2", "m3", "kg"];

/// The unit of a column as a case has it.
fn written(unit: &'static str) -> &'static str {
    match unit {
        "m2" => "m^2",
        "m3" => "m^3",
        other => other,
    }
}

/// Where a limit was reached.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LimitPoint {
    /// The limit.
    pub limit: Limit,
    /// Progress of the motion there (its own unit).
    pub progress: f64,
    /// Its error; `None` where none is stated of the quantity.
    pub error: Option<f64>,
    /// Distance slid (m), where all of the contact slides.
    pub distance: Option<f64>,
    /// Time (s), where the speed is known.
    pub time: Option<f64>,
}

/// A state before: progress, and each quantity with what is stated of it.
type Before = (f64, Vec<(f64, Option<f64>)>);

/// How lives scatter from part to part, by a coefficient that tests told.
#[derive(Debug, Clone, PartialEq)]
pub struct Lives {
    /// The key of the coefficient.
    pub key: String,
    /// Where it was told.
    pub source: String,
    /// The 95 % interval of the median (the motion's own unit) by that of the coefficient; infinite beyond the motion.
    pub interval: Option<[f64; 2]>,
    /// Shares of parts, from small to large, and the life (the motion's own unit) that they do not reach; infinite beyond the motion.
    pub shares: Vec<[f64; 2]>,
    /// Why there are no shares but the half.
    pub untold: Option<String>,
}

impl Lives {
    /// The life that a share of the parts does not reach.
    pub fn of_share(&self, share: f64) -> Option<f64> {
        let same = |own: &&[f64; 2]| (own[0] - share).abs() < 1e-9;
        self.shares.iter().find(same).map(|own| own[1])
    }

    fn json(&self) -> Value {
        // A life beyond the motion is no number.
        let finite = |life: f64| life.is_finite().then_some(life);
        let of_share = |share: f64| self.of_share(share).and_then(finite);
        json!({
            "key": self.key,
            "source": self.source,
            "median": of_share(0.5),
            "interval_95": self.interval.map(|ends| ends.map(finite)),
            "B10": of_share(0.1),
            "B1": of_share(0.01),
            "shares": self.shares.iter().map(|[share, life]| json!([share, finite(*life)])).collect::<Vec<_>>(),
            "untold": self.untold,
        })
    }
}

/// Watches quantities until the first of them reaches its limit.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Life {
    limits: Vec<Limit>,
    before: Option<Before>,
    reached: Option<LimitPoint>,
    #[serde(skip)]
    lives: Option<Lives>,
}

/// A limit of a quantity that a run does not have.
#[derive(Debug, thiserror::Error)]
#[error(
    "`until`: this run has no column `{0}`; columns of its history.csv that grow with wear can have a limit"
)]
pub struct NoColumn(String);

impl Life {
    /// Until the first of these limits is reached.
    pub fn until(limits: Vec<Limit>) -> Self {
        Self { limits, ..Self::default() }
    }

    /// Where a limit was reached, if one was.
    pub fn reached(&self) -> Option<&LimitPoint> {
        self.reached.as_ref()
    }

    /// How lives scatter, if a coefficient with its scatter was given.
    pub fn lives(&self) -> Option<&Lives> {
        self.lives.as_ref()
    }

    /// Puts down how lives scatter.
    pub fn scatter(&mut self, lives: Lives) {
        self.lives = Some(lives);
    }

    /// The limits.
    pub fn limits(&self) -> &[Limit] {
        &self.limits
    }

    /// Takes up a state by its row of the history.
    ///
    /// # Errors
    /// If it has no such column.
    pub fn take(&mut self, motion: &Motion, row: &[(String, f64)]) -> Result<(), NoColumn> {
        if self.limits.is_empty() || self.reached.is_some() {
            return Ok(());
        }
        let progress = number(row, motion.progress.column).unwrap_or_default();
        let value = |limit: &Limit| {
            let value = number(row, &limit.column).ok_or(NoColumn(limit.column.clone()))?;
            Ok((value, stated(&limit.column, |column| number(row, column))))
        };
        let values: Vec<_> = self.limits.iter().map(value).collect::<Result<_, NoColumn>>()?;
        let before = self.before.replace((progress, values.clone()));
        let (from, earlier) = before.unwrap_or_else(|| (0.0, vec![(0.0, None); values.len()]));
        let crossed = self
            .limits
            .iter()
            .zip(values)
            .zip(earlier)
            .filter(|((limit, now), _)| now.0 >= limit.value);
        let places = crossed.map(|((limit, now), then)| {
            let (place, error) = crossing([(from, then), (progress, now)], limit.value);
            (limit, place, error)
        });
        let first = places.min_by(|one, other| one.1.total_cmp(&other.1));
        self.reached = first.map(|(limit, place, error)| {
            let distance = motion.sliding_distance(place);
            let time = match motion.progress {
                Progress::TIME => Some(place),
                _ => distance.zip(motion.sliding_speed()).map(|(slip, speed)| slip / speed),
            };
            LimitPoint { limit: limit.clone(), progress: place, error, distance, time }
        });
        Ok(())
    }

    /// As it stands in `summary.json`; `None` where no limit is given.
    pub(super) fn json(&self, progress: &str) -> Option<Value> {
        if self.limits.is_empty() {
            return None;
        }
        let limits: Vec<Value> = self
            .limits
            .iter()
            .map(|one| json!({ "column": one.column, "value": one.value }))
            .collect();
        let reached = self.reached.as_ref().map(|one| {
            json!({
                "column": one.limit.column,
                progress: one.progress,
                "error": one.error,
                "sliding_distance_m": one.distance,
                "duration_s": one.time,
            })
        });
        let lives = self.lives.as_ref().map(Lives::json);
        Some(
            json!({ "until": limits, "progress": progress, "reached": reached, "distribution": lives }),
        )
    }
}

/// Where a quantity with what is stated of it passes a limit between two places, and the error of that.
fn crossing(ends: [(f64, (f64, Option<f64>)); 2], limit: f64) -> (f64, Option<f64>) {
    let [(from, (low, error_before)), (to, (high, error))] = ends;
    if low >= limit || high <= low {
        return (from, error_before);
    }
    let straight = from + (to - from) * (limit - low) / (high - low);
    let error_there = error.map(|after| {
        let before = error_before.unwrap_or(after);
        before.max(after)
    });
    if from <= 0.0 || low <= 0.0 {
        // From nothing on: between a straight line and a root.
        let root = to * (limit / high).powi(2);
        let place = 0.5 * (straight + root);
        let slope = high / to;
        return (place, error_there.map(|error| 0.5 * (straight - root).abs() + error / slope));
    }
    let exponent = (high / low).ln() / (to / from).ln();
    let place = from * (limit / low).powf(1.0 / exponent);
    let slope = exponent * limit / place;
    (place, error_there.map(|error| (place - straight).abs() + error / slope))
}

impl Observer for Life {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        if self.limits.is_empty() {
            return Ok(());
        }
        Ok(self.take(&report.problem.motion, &history::row(report))?)
    }

    fn ends(&self) -> bool {
        self.reached.is_some()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Limit, crossing};

    /// Of what goes as a power, the place is exact; the error covers it and that of the quantity.
    #[test]
    fn powers_are_read_between_steps() {
        let depth = |progress: f64| 2e-6 * progress.sqrt();
        let limit = 3e-6;
        let ends = [2.0, 2.6].map(|at| (at, (depth(at), Some(0.01 * depth(at)))));
        let (place, error) = crossing(ends, limit);
        assert_relative_eq!(place, 2.25, max_relative = 1e-12);
        // A depth that is 1 % off is reached 2 % earlier or later.
        let error = error.expect("an error");
        assert!((0.02 * 2.25..0.03 * 2.25).contains(&error), "{error}");
        let (first, error) = crossing([(0.0, (0.0, None)), (4.0, (depth(4.0), Some(0.0)))], limit);
        assert!((first - 2.25).abs() <= error.expect("an error"), "{first}");
        assert_eq!(crossing([(2.0, (depth(2.0), None)), (2.6, (depth(2.6), None))], limit).1, None);
    }

    #[test]
    fn columns_have_names_without_units() {
        let columns = Limit::columns(["pin", "disc"]);
        let of =
            |key: &str| columns.iter().find(|column| column.0 == key).map(|one| (&*one.1, one.2));
        assert_eq!(of("wear_depth_pin"), Some(("wear_depth_pin_m", "m")));
        assert_eq!(of("worn_volume_disc"), Some(("worn_volume_disc_m3", "m^3")));
        assert_eq!(of("wear_depth"), Some(("wear_depth_m", "m")));
        assert_eq!(of("scar_width"), Some(("scar_width_m", "m")));
        assert_eq!((of("wear_rate_pin"), of("peak_pressure")), (None, None));
    }
}
