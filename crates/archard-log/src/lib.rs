//! Logs of tribometers: text as instruments write it -> columns in SI -> steps and parts of the test -> wear rate and friction with
//! intervals that know that readings a second apart are not independent.
//!
//! [`Log::read`] knows nothing of cases, of simulation or of the terminal.

mod error;
mod noise;
mod number;
mod rate;
mod report;
mod roles;
mod steps;
mod table;
mod text;
mod unit;

pub use error::Error;
pub use rate::Rate;
pub use report::ROWS;

use steps::median;
use table::Table;
use unit::{FREE_FALL, Measure};

/// What a user adds to a log: columns by role, values by name.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Role and title: `wear`, `Displacement [um]`; `-` before the title turns its sign.
    pub columns: Vec<(String, String)>,
    /// `load`, `radius`, `speed` or `from`, and a quantity: `5 N`.
    pub values: Vec<(String, String)>,
}

/// A log, read and judged.
#[derive(Debug, Clone)]
pub struct Log {
    /// What messages call it.
    pub source: String,
    /// Lines that say what was read and what was derived: name and words.
    pub said: Vec<(String, String)>,
    /// Its steps, in order.
    pub steps: Vec<Step>,
}

/// A step of a test.
#[derive(Debug, Clone)]
pub struct Step {
    /// First and last line in the log.
    pub lines: [usize; 2],
    /// Readings under load and in motion.
    pub readings: usize,
    /// Readings before the load was on or the motion began, and after.
    pub idle: usize,
    /// Normal load (N).
    pub load: Option<f64>,
    /// How far the bodies slid (m).
    pub distance: f64,
    /// The steady part, and the second half of the step.
    pub steady: Option<Rate>,
    /// The rate of the second half alone.
    pub second_half: Option<Rate>,
    /// Distance and height (m) of each jump of the transducer.
    pub jumps: Vec<(f64, f64)>,
    /// Mean friction coefficient over the steady part, and its interval.
    pub friction: Option<(f64, [f64; 2])>,
    /// Why there is no wear coefficient, and what to do.
    pub refused: Option<String>,
}

impl Step {
    /// Wear coefficient over worn area, k/A (1/N), if it can be told.
    pub fn k_over_area(&self) -> Option<f64> {
        if self.refused.is_some() {
            return None;
        }
        Some(self.steady?.rate / self.load?)
    }
}

const VALUES: [(&str, Measure); 4] = [
    ("load", Measure::Force),
    ("radius", Measure::Length),
    ("speed", Measure::Speed),
    ("from", Measure::Length),
];

impl Options {
    fn value(&self, name: &str) -> Result<Option<f64>, Error> {
        let Some((_, text)) = self.values.iter().find(|(known, _)| known == name) else {
            return Ok(None);
        };
        let measure = VALUES.iter().find(|known| known.0 == name).map(|known| known.1);
        match unit::quantity(text) {
            Some((of, value)) if Some(of) == measure && value > 0.0 => Ok(Some(value)),
            _ => Err(Error::Option {
                option: format!("{name}={text}"),
                help: "write a value greater than zero and its unit, like load=\"5 N\" or from=\"100 m\"".to_owned(),
            }),
        }
    }

    fn check(&self) -> Result<(), Error> {
        let role = |name: &str| roles::ROLES.iter().any(|known| known.0 == name);
        let names = |all: Vec<&str>| format!("there are {}", all.join(", "));
        if let Some((name, _)) = self.columns.iter().find(|(name, _)| !role(name)) {
            let help = names(roles::ROLES.iter().map(|known| known.0).collect());
            return Err(Error::Option { option: format!("--column {name}"), help });
        }
        if let Some((name, _)) =
            self.values.iter().find(|(name, _)| !VALUES.iter().any(|known| known.0 == name))
        {
            let help = names(VALUES.iter().map(|known| known.0).collect());
            return Err(Error::Option { option: format!("--set {name}"), help });
        }
        Ok(())
    }
}

impl Log {
    /// Reads the bytes of a log; `source` is what messages call it.
    ///
    /// # Errors
    /// If it is no log, or nothing says how far the bodies slid.
    pub fn read(source: &str, bytes: &[u8], options: &Options) -> Result<Self, Error> {
        options.check()?;
        let table = Table::read(source, bytes)?;
        let titles = table.titles();
        if table.columns.len() == 2 && table.columns.iter().any(|own| own.name == "profile") {
            return Err(Error::Profile { log: source.to_owned(), line: table.heading, titles });
        }
        let mut said: Vec<(String, String)> = vec![];
        if let Some(rig) = roles::rig(&table) {
            said.push(("format".into(), format!("{rig}, by its headings")));
        }
        let mut taken = |role| -> Result<Option<Vec<f64>>, Error> {
            let chosen = roles::choose(&table, role, &options.columns)?;
            Ok(chosen.map(|chosen| {
                said.push((role.into(), format!("`{}` in {}", chosen.title, chosen.unit)));
                chosen.values
            }))
        };
        let time = taken("time")?;
        let distance = taken("distance")?;
        let laps = taken("laps")?;
        let speed = taken("speed")?;
        let rotation = taken("rotation")?;
        let radius = taken("radius")?;
        let load = taken("load")?;
        let force = taken("friction_force")?;
        let friction = taken("friction")?;
        let mass = taken("mass")?;
        let wear = roles::choose(&table, "wear", &options.columns)?;
        if let Some(wear) = &wear {
            said.push(("wear".into(), format!("`{}` in {}", wear.title, wear.unit)));
        }
        let rows = table.lines.len();
        let radius = options.value("radius")?.map(|own| vec![own; rows]).or(radius);
        let speed = options.value("speed")?.map(|own| vec![own; rows]).or(speed);
        let mut derive = |name: &str, words: String| said.push((name.into(), words));
        let distance = match (distance, &laps, &radius) {
            (Some(distance), Some(laps), None) => {
                let turns = laps[rows - 1] - laps[0];
                let radius = (distance[rows - 1] - distance[0]) / (std::f64::consts::TAU * turns);
                if radius.is_finite() && radius > 0.0 {
                    derive("radius", format!("{:.3} mm, from distance over laps", 1e3 * radius));
                }
                distance
            }
            (Some(distance), ..) => distance,
            (None, Some(laps), Some(radius)) => {
                derive("distance", "from laps and radius".into());
                laps.iter().zip(radius).map(|(laps, r)| std::f64::consts::TAU * r * laps).collect()
            }
            (None, ..) => {
                let turning = rotation.as_ref().zip(radius.as_ref()).map(|(n, r)| {
                    n.iter().zip(r).map(|(n, r)| std::f64::consts::TAU * n * r).collect()
                });
                let Some((speed, time)) = speed.or(turning).zip(time.as_ref()) else {
                    return Err(Error::NoDistance {
                        log: source.to_owned(),
                        line: table.heading,
                        titles,
                    });
                };
                derive("distance", "from speed and time".into());
                travelled(&speed, time)
            }
        };
        let load = match (options.value("load")?, load, force.as_ref().zip(friction.as_ref())) {
            (Some(load), ..) => Some(vec![load; rows]),
            (None, Some(load), _) => Some(load.iter().map(|own| own.abs()).collect()),
            (None, None, Some((force, mu))) => {
                let ratios: Vec<f64> = force.iter().zip(mu).map(|(f, mu)| (f / mu).abs()).collect();
                let own = median(&ratios);
                derive("load", format!("{own:.4} N, from friction force over coefficient"));
                own.is_finite().then(|| vec![own; rows])
            }
            _ => None,
        };
        if let (Some(mass), Some(load)) = (&mass, &load) {
            let ratio = median(mass) * FREE_FALL / median(load);
            if (ratio - 1.0).abs() < 0.01 {
                derive("mass", format!("the dead weight: its weight is {ratio:.3} of the load"));
            }
        }
        if let Some(time) = &time
            && let Some(row) = time.windows(2).position(|pair| pair[1] < pair[0])
        {
            derive(
                "time",
                format!(
                    "jumps back at line {}: see that no two tests stand in one file; the distance counts, not the time",
                    table.lines[row + 1]
                ),
            );
        }
        said.extend(table.said.iter().map(|words| ("reading".to_owned(), words.clone())));
        let friction = friction.or_else(|| {
            let (force, load) = force.as_ref().zip(load.as_ref())?;
            Some(force.iter().zip(load).map(|(force, load)| force / load).collect())
        });
        let from = options.value("from")?;
        let steps = steps::steps(&table, &distance)
            .into_iter()
            .map(|rows| {
                let lines = [table.lines[rows.start], table.lines[rows.end - 1]];
                let own = |all: &Vec<f64>| all[rows.clone()].to_vec();
                let wear = wear.as_ref().map(|wear| (own(&wear.values), wear));
                let (load, friction) = (load.as_ref().map(own), friction.as_ref().map(own));
                step(lines, own(&distance), wear, (load, friction), from)
            })
            .collect();
        Ok(Self { source: source.to_owned(), said, steps })
    }

    /// The step of the longest distance with a rate, or else the longest.
    pub fn main_step(&self) -> Option<&Step> {
        let longest = |one: &&Step, other: &&Step| one.distance.total_cmp(&other.distance);
        let told = self.steps.iter().filter(|step| step.steady.is_some()).max_by(longest);
        told.or_else(|| self.steps.iter().max_by(longest))
    }
}

fn travelled(speed: &[f64], time: &[f64]) -> Vec<f64> {
    let mut far = 0.0;
    (0..speed.len())
        .map(|row| {
            if row > 0 {
                let passed =
                    0.5 * (speed[row] + speed[row - 1]).abs() * (time[row] - time[row - 1]);
                far += if passed > 0.0 { passed } else { 0.0 };
            }
            far
        })
        .collect()
}

fn step(
    lines: [usize; 2],
    distance: Vec<f64>,
    wear: Option<(Vec<f64>, &roles::Chosen)>,
    (load, friction): (Option<Vec<f64>>, Option<Vec<f64>>),
    start: Option<f64>,
) -> Step {
    let n = distance.len();
    // Under load is more than half of the load of the step, in motion all from the first to the last change of the distance.
    let most = load.as_ref().map(|load| median(load)).filter(|load| load.is_finite());
    let full = most.map(|most| {
        let load: &[f64] = load.as_deref().unwrap_or_default();
        let peak = load.iter().copied().fold(most, f64::max);
        median(&load.iter().copied().filter(|own| *own > 0.5 * peak).collect::<Vec<_>>())
    });
    let begins = distance.iter().position(|at| *at > distance[0]).unwrap_or(n).max(1) - 1;
    let ends = distance.iter().rposition(|at| *at < distance[n - 1]).map_or(0, |row| row + 1);
    let is_on = |row: &usize| {
        let on = load.as_ref().zip(full).is_none_or(|(load, full)| load[*row] > 0.5 * full);
        on && distance[*row].is_finite()
            && wear.as_ref().is_none_or(|(depth, _)| depth[*row].is_finite())
    };
    let rows: Vec<usize> = (begins..n.min(ends + 1)).filter(is_on).collect();
    let taken = |all: &[f64]| -> Vec<f64> { rows.iter().map(|row| all[*row]).collect() };
    let along: Vec<f64> = taken(&distance);
    let slid = along.last().zip(along.first()).map_or(0.0, |(last, first)| last - first);
    let mut step = Step {
        lines,
        readings: rows.len(),
        idle: n - rows.len(),
        load: full,
        distance: slid,
        steady: None,
        second_half: None,
        jumps: vec![],
        friction: None,
        refused: None,
    };
    let mut part = along.first().map_or(0.0, |first| first + 0.5 * slid);
    let mut still = false;
    if let Some((depth, chosen)) = &wear {
        let mut depth = taken(depth);
        still = depth.windows(2).all(|pair| pair[0] == pair[1]);
        let falls = depth.last().zip(depth.first()).is_some_and(|(last, first)| last < first);
        if falls && !chosen.grows {
            depth.iter_mut().for_each(|own| *own = -*own);
        }
        let jumps = rate::jumps(&depth);
        let places: Vec<usize> = jumps.iter().map(|jump| jump.0).collect();
        step.jumps = jumps.iter().map(|(row, height)| (along[*row], *height)).collect();
        step.steady = match start {
            _ if still => None,
            Some(start) => rate::from(start, &along, &depth, &places),
            None => rate::steady(&along, &depth, &places),
        };
        step.second_half =
            Some(()).filter(|()| !still).and_then(|()| rate::from(part, &along, &depth, &places));
        part = step.steady.map_or(part, |rate| rate.part[0]);
    }
    let later = along.partition_point(|at| *at < part);
    step.friction = friction.and_then(|mu| {
        let own: Vec<f64> =
            taken(&mu)[later..].iter().copied().filter(|mu| mu.is_finite()).collect();
        rate::mean(&own)
    });
    step.refused = refusal(&step, wear.as_ref().map(|wear| wear.1), still);
    step
}

/// Why a step has no wear coefficient.
fn refusal(step: &Step, wear: Option<&roles::Chosen>, still: bool) -> Option<String> {
    let Some(wear) = wear else {
        return Some(
            "no column holds a depth of wear: name it with --column wear=\"TITLE [um]\"".into(),
        );
    };
    if still && step.readings >= rate::FEWEST {
        return Some(format!(
            "all readings of `{}` are the same: the transducer read no wear",
            wear.title
        ));
    }
    let Some(rate) = step.steady else {
        return Some(format!(
            "{} readings under load and in motion are too few: a rate needs {}",
            step.readings,
            rate::FEWEST
        ));
    };
    if rate.interval[0] <= 0.0 && rate.interval[1] >= 0.0 {
        return Some(
            "the interval of the rate holds zero, so that wear cannot be told from drift of the transducer: test for longer, or weigh the specimen".into(),
        );
    }
    if rate.rate < 0.0 {
        return Some(format!(
            "`{}` falls: if it counts downwards as the specimen wears, say --column wear=\"-{}\"; else it grew or warmed",
            wear.title, wear.title
        ));
    }
    if step.load.is_none() {
        return Some(
            "no column holds a load: give --set load=\"5 N\", or --column load=TITLE".into(),
        );
    }
    None
}
