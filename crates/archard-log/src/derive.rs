//! Distance, load and friction of each reading: from columns, from options, from the head of the log, or from one another.

use std::f64::consts::TAU;
use std::ops::Range;

use crate::error::Error;
use crate::head;
use crate::options::Options;
use crate::rate::FEWEST;
use crate::roles::{self, LogColumn};
use crate::steps::{ends, median, steps};
use crate::table::Table;
use crate::unit::FREE_FALL;

/// What is known of each reading, in SI.
#[derive(Debug)]
pub struct ReadingState {
    /// Time (s).
    pub time: Option<Vec<f64>>,
    /// Distance slid (m).
    pub distance: Vec<f64>,
    /// Radius of the track (m).
    pub radius: Option<Vec<f64>>,
    /// Sliding speed (m/s).
    pub speed: Option<Vec<f64>>,
    /// Normal load (N).
    pub load: Option<Vec<f64>>,
    /// Friction coefficient.
    pub friction: Option<Vec<f64>>,
    /// The column of the wear.
    pub wear: Option<LogColumn>,
    /// Whether a profile across the track says what was worn.
    pub profile: bool,
    /// The rows of each step.
    pub steps: Vec<Range<usize>>,
    /// What was read and derived: name and words.
    pub said: Vec<(String, String)>,
}

/// Collects what is to be said.
struct Reader<'a> {
    table: &'a Table,
    options: &'a Options,
    said: Vec<(String, String)>,
}

impl Reader<'_> {
    fn say(&mut self, name: &str, words: String) {
        self.said.push((name.to_owned(), words));
    }

    fn chosen(&mut self, role: &'static str) -> Result<Option<LogColumn>, Error> {
        let chosen = roles::choose(self.table, role, &self.options.columns)?;
        if let Some(chosen) = &chosen {
            let more = chosen.said.as_ref().map_or(String::new(), |said| format!(", {said}"));
            self.say(role, format!("`{}` in {}{more}", chosen.title, chosen.unit));
        }
        Ok(chosen)
    }

    fn column(&mut self, role: &'static str) -> Result<Option<Vec<f64>>, Error> {
        Ok(self.chosen(role)?.map(|chosen| chosen.values))
    }

    /// A value for each row: of the options, or else of the head if no column has it.
    fn given(
        &mut self,
        name: &'static str,
        column: Option<Vec<f64>>,
        steps: &[Range<usize>],
    ) -> Result<Option<Vec<f64>>, Error> {
        if let Some(values) = self.options.each(name, steps.len())? {
            let each = steps.iter().zip(values);
            return Ok(Some(each.flat_map(|(rows, value)| vec![value; rows.len()]).collect()));
        }
        if column.is_some() {
            return Ok(column);
        }
        let of_head = |stated: &head::HeaderValue| stated.value.filter(|value| *value > 0.0);
        let diameter = || head::of_diameter(self.table).filter(|_| name == "radius");
        let stated = head::stated(self.table, name).filter(|own| of_head(own).is_some());
        let Some(stated) = stated.or_else(diameter) else { return Ok(None) };
        let Some(value) = of_head(&stated) else { return Ok(None) };
        self.say(name, format!("`{}` in the head, line {}", stated.words, stated.line));
        Ok(Some(vec![value; self.table.lines.len()]))
    }

    /// What would tell the distance, by what there is.
    fn remedy(&self, laps: bool, [turns, radius, speed, time]: [bool; 4]) -> String {
        let table = self.table;
        let find = |names: &[&str]| table.columns.iter().find(|own| names.contains(&&*own.name));
        let mut ways = vec![];
        if !time && let Some(own) = find(&["timestamp", "time", "t"]) {
            ways.push(format!("the unit of the time with --column time=\"{} [s]\"", own.title));
        }
        if turns && !radius {
            let head = head::stated(table, "radius").map_or(String::new(), |stated| {
                format!(" (`{}` in line {} has no unit)", stated.words, stated.line)
            });
            ways.push(format!("the radius of the track with --set radius=\"10 mm\"{head}"));
            for own in
                table.columns.iter().filter(|own| ["xposition", "yposition"].contains(&&*own.name))
            {
                ways.push(format!(
                    "--column radius=\"{}\" if that stage counts from the axis (it stands at {:.3})",
                    own.title,
                    median(&own.values)
                ));
            }
        }
        if laps {
            ways.push("the stroke of a motion to and fro with --set stroke=\"10 mm\"".to_owned());
        }
        if !turns && !speed && time {
            ways.push("the speed with --set speed=\"0.1 m/s\"".to_owned());
        }
        ways.push("a column with --column distance=TITLE".to_owned());
        format!("give {}", ways.join(", or "))
    }
}

/// Reads and derives.
///
/// # Errors
/// If nothing says how far the bodies slid, or columns contradict one another.
pub fn derive(table: &Table, options: &Options) -> Result<ReadingState, Error> {
    let mut read = Reader { table, options, said: vec![] };
    if let Some(rig) = roles::rig(table) {
        read.say("format", format!("{rig}, by its headings"));
    }
    let time = read.column("time")?;
    let distance = read.column("distance")?;
    let laps = read.column("laps")?;
    let speed = read.column("speed")?;
    let rotation = read.column("rotation")?;
    let radius = read.column("radius")?.map(|all| all.iter().map(|own| own.abs()).collect());
    let radius = match radius {
        Some(radius) => Some(radius),
        None => read.column("diameter")?.map(|all| all.iter().map(|own| 0.5 * own.abs()).collect()),
    };
    let load = read.column("load")?;
    let force = read.column("friction_force")?;
    let friction = read.column("friction")?;
    let mass = read.column("mass")?;
    let wear = read.chosen("wear")?;
    let counters: Vec<&Vec<f64>> = [&distance, &laps, &time].into_iter().flatten().collect();
    let steps = steps(table, &counters);
    let radius = read.given("radius", radius, &steps)?;
    let stroke = read.given("stroke", None, &steps)?;
    let speed = read.given("speed", speed, &steps)?;
    let rotation = read.given("rotation", rotation, &steps)?;
    let load = read.given("load", load, &steps)?;
    backwards(&mut read, time.as_deref(), &steps);

    if let Some((time, (line, whole))) = time.as_ref().zip(head::total(table)) {
        let own = |rows: &Range<usize>| ends(&time[rows.clone()]).map(|[first, last]| last - first);
        let passed = steps.iter().filter_map(own).sum::<f64>();
        agree(
            &mut read,
            ("the time of all readings".into(), &format!("line {line}")),
            passed / whole,
        )?;
    }
    let ways = ways((&time, &steps), &distance, (&laps, &stroke), (&speed, &rotation, &radius));
    let Some((name, distance)) = ways.first().cloned() else {
        let turns = laps.is_some() || rotation.is_some();
        let known = [turns, radius.is_some(), speed.is_some(), time.is_some()];
        let (log, line) = (table.source.clone(), table.heading);
        let (titles, remedy) = (table.titles(), read.remedy(laps.is_some(), known));
        return Err(Error::NoDistance { log, line, titles, remedy });
    };
    if name != COLUMN {
        read.say("distance", format!("from {name}"));
    }
    let far = |way: &[f64], rows: &Range<usize>| {
        ends(&way[rows.clone()]).map_or(f64::NAN, |[first, last]| last - first)
    };
    let longest = steps.iter().max_by(|one, other| one.len().cmp(&other.len()));
    let longest = longest.filter(|rows| rows.len() >= FEWEST);
    for (other, way) in ways[1..].iter().filter(|_| longest.is_some()) {
        let rows = longest.expect("a step");
        let names = (format!("the distance from {name}"), *other);
        agree(&mut read, names, far(&distance, rows) / far(way, rows))?;
    }
    let radius = radius.or_else(|| {
        let (laps, rows) = (laps.as_ref()?, longest?);
        let radius = far(&distance, rows) / (TAU * far(laps, rows));
        let is_one = radius.is_finite() && radius > 0.0 && stroke.is_none();
        is_one.then(|| {
            read.say("radius", format!("{:.3} mm, from distance over laps", 1e3 * radius));
            vec![radius; table.lines.len()]
        })
    });
    let speed = speed.or(turning(&rotation, &radius));
    let load = loaded(&mut read, load, [force.as_deref(), friction.as_deref(), mass.as_deref()])?;
    let friction = friction.or_else(|| {
        let (force, load) = force.as_ref().zip(load.as_ref())?;
        Some(force.iter().zip(load).map(|(force, load)| force / load).collect())
    });
    let mut said = read.said;
    said.extend(table.said.iter().map(|words| ("reading".to_owned(), words.clone())));
    let profile = options.profile;
    Ok(ReadingState { time, distance, radius, speed, load, friction, wear, profile, steps, said })
}

/// A column, as a way to the distance.
const COLUMN: &str = "its column";

type Values = Option<Vec<f64>>;

/// Each way to the distance, the best first.
fn ways(
    (time, steps): (&Values, &[Range<usize>]),
    distance: &Values,
    (laps, stroke): (&Values, &Values),
    (speed, rotation, radius): (&Values, &Values, &Values),
) -> Vec<(&'static str, Vec<f64>)> {
    let passed = |speed: &Vec<f64>| time.as_ref().map(|time| travelled(speed, time, steps));
    let per_turn = |length: &Values, factor: f64| {
        let (laps, length) = laps.as_ref().zip(length.as_ref())?;
        Some(laps.iter().zip(length).map(|(n, l)| factor * l * n).collect())
    };
    let all = [
        (COLUMN, distance.clone()),
        ("laps and radius", per_turn(radius, TAU).filter(|_| stroke.is_none())),
        ("cycles and stroke", per_turn(stroke, 2.0)),
        ("speed and time", speed.as_ref().and_then(passed)),
        ("rotational speed, radius and time", turning(rotation, radius).as_ref().and_then(passed)),
    ];
    all.into_iter().filter_map(|(name, way)| Some((name, way?))).collect()
}

/// The sliding speed of a rotational speed at a radius.
fn turning(rotation: &Values, radius: &Values) -> Values {
    let (rotation, radius) = rotation.as_ref().zip(radius.as_ref())?;
    Some(rotation.iter().zip(radius).map(|(n, r)| TAU * (n * r).abs()).collect())
}

/// How far a speed comes in the time of each step: from one reading of both to the next, and nowhere until a time that jumped back is
/// later than it was before. A reading without speed or time has no place.
fn travelled(speed: &[f64], time: &[f64], steps: &[Range<usize>]) -> Vec<f64> {
    let mut far = 0.0;
    let within = |rows: &Range<usize>| -> Vec<f64> {
        let mut last: Option<[f64; 2]> = None;
        let place = |row: usize| {
            let now = [time[row], speed[row]];
            if now.iter().any(|own| !own.is_finite()) {
                return f64::NAN;
            }
            let [since, before] = last.unwrap_or(now);
            if now[0] >= since {
                far += 0.5 * (now[1] + before).abs() * (now[0] - since);
                last = Some(now);
            }
            far
        };
        rows.clone().map(place).collect()
    };
    steps.iter().flat_map(within).collect()
}

/// The load: given, or from friction force over coefficient, or a dead weight that stays the same.
fn loaded(
    read: &mut Reader<'_>,
    load: Values,
    [force, friction, mass]: [Option<&[f64]>; 3],
) -> Result<Values, Error> {
    let rows = read.table.lines.len();
    let from_force = force.zip(friction).map(|(force, mu)| {
        let ratios: Vec<f64> = force.iter().zip(mu).map(|(f, mu)| (f / mu).abs()).collect();
        median(&ratios)
    });
    let from_force = from_force.filter(|own| own.is_finite() && *own > 0.0);
    let weight = mass.map(|mass| median(mass) * FREE_FALL);
    if let Some(load) = load {
        let load: Vec<f64> = load.iter().map(|own| own.abs()).collect();
        if let Some(other) = from_force {
            let ratio = median(&load) / other;
            agree(read, ("the load".to_owned(), "friction force over coefficient"), ratio)?;
        }
        if let Some(ratio) = weight.map(|weight| weight / median(&load))
            && (ratio - 1.0).abs() < 0.01
        {
            read.say("mass", format!("the dead weight: its weight is {ratio:.3} of the load"));
        }
        return Ok(Some(load));
    }
    if let Some(own) = from_force {
        read.say("load", format!("{own:.4} N, from friction force over coefficient"));
        return Ok(Some(vec![own; rows]));
    }
    let is_still = |mass: &&[f64]| mass.windows(2).all(|pair| pair[0] == pair[1]);
    let Some(weight) = mass.filter(is_still).and(weight).filter(|own| *own > 0.0) else {
        return Ok(None);
    };
    read.say("load", format!("{weight:.4} N, the weight of a mass that stays the same"));
    Ok(Some(vec![weight; rows]))
}

/// The ratio from which on a unit is wrong: units that are taken for each other differ by 2 pi (turns and radians) and more; a choice
/// below that.
const UNITS: f64 = 5.0;
/// The ratio from which on two ways to a value are said to differ: a choice.
const DIFFER: f64 = 1.1;

/// Holds two ways to a value against each other: what only a unit makes is refused, and what differs is said.
fn agree(read: &mut Reader<'_>, (one, other): (String, &str), ratio: f64) -> Result<(), Error> {
    if !ratio.is_finite() || ratio <= 0.0 {
        return Ok(());
    }
    if !(1.0 / UNITS..=UNITS).contains(&ratio) {
        let (log, line) = (read.table.source.clone(), read.table.heading);
        let ratio = format!("{ratio:.4}");
        return Err(Error::Disagree { log, line, one, other: other.to_owned(), ratio });
    }
    if !(1.0 / DIFFER..=DIFFER).contains(&ratio) {
        read.say("see", format!("{one} is {ratio:.3} times that from {other}"));
    }
    Ok(())
}

/// Says where the time jumps back within a step.
fn backwards(read: &mut Reader<'_>, time: Option<&[f64]>, steps: &[Range<usize>]) {
    let Some(time) = time else { return };
    let within =
        |rows: &Range<usize>| (rows.start + 1..rows.end).find(|at| time[*at] < time[at - 1]);
    if let Some(row) = steps.iter().find_map(within) {
        let line = read.table.lines[row];
        read.say("time", format!("jumps back at line {line} and goes on: no distance is passed until the time before is reached again; correct it in the log"));
    }
    let again = steps.windows(2).find(|pair| time[pair[1].start] < time[pair[1].start - 1]);
    if let Some(pair) = again {
        let line = read.table.lines[pair[1].start];
        read.say(
            "time",
            format!("starts again at line {line}: a step of its own; give two tests two files"),
        );
    }
}
