//! The history of a wheelset, as programs of vehicle dynamics write it: steps in time or along the track.

use archard::parameters::{Bound, Invalid, Parameter, Quantity, Values};
use archard::units::Measure;

use super::running::COLUMNS;
use crate::case::quantity::measure;
use crate::measured::Table;

/// The steps of a history, and what points in their place may lose.
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    /// The steps by the columns of a route (SI).
    pub steps: Vec<(String, Vec<f64>)>,
    /// What points in their place may lose, relative to all work of friction.
    pub within: f64,
}

/// What a history takes: its file, how exactly it is gathered, how its axes point, and the titles of columns that are called otherwise.
pub const HISTORY: &[Parameter] = &[
    Parameter::required(
        "file",
        Quantity::File,
        "CSV of a program of vehicle dynamics, a row a step",
    ),
    Parameter::optional(
        "within",
        Quantity::Number,
        "what gathering its steps to points may lose, relative to all work of friction; 0.02 if not given",
    ),
    Parameter::optional(
        "upwards",
        Quantity::Truth,
        "whether z of the program points upwards, and y to the left",
    ),
    title("distance", "along the track"),
    title("time", "which counts with the speed where there is no distance"),
    title("shift", "lateral shift of the wheelset"),
    title("yaw", "turn about the vertical"),
    title("roll", "turn about the direction of the track"),
    title("curvature", "curvature of the track"),
    title("radius", "radius of the track in place of its curvature, 0 where it is straight"),
    title("superelevation", "height of one rail over the other"),
    title("speed", "speed along the track"),
    title("wheel_load", "vertical force on each wheel"),
    title("q_right", "vertical force on the right wheel"),
    title("q_left", "vertical force on the left wheel"),
    title("friction", "coefficient of friction"),
    title("flange_friction", "coefficient of friction on the flange"),
    title("load_transfer", "how much more the right wheel bears, and the left one less"),
    title("lateral_speed", "speed of the wheelset across the track"),
    title("vertical_speed", "speed of the wheelset downwards"),
    title("yaw_rate", "rate of the yaw"),
    title("roll_rate", "rate of the roll"),
    title("pitch_rate", "rate of turning about the axle"),
    title("axle_moment", "moment that drives the wheelset"),
    title("creepage_right", "creepage of the right wheel"),
    title("lateral_creepage_right", "lateral creepage of the right wheel"),
    title("spin_right", "spin creepage of the right wheel"),
    title("creepage_left", "creepage of the left wheel"),
    title("lateral_creepage_left", "lateral creepage of the left wheel"),
    title("spin_left", "spin creepage of the left wheel"),
    title("lateral_force_right", "lateral force of the right wheel on its rail, to the field side"),
    title("lateral_force_left", "lateral force of the left wheel on its rail, to the field side"),
];

/// The title of a column.
const fn title(name: &'static str, meaning: &'static str) -> Parameter {
    Parameter::optional(name, Quantity::Text, meaning).bound(Bound::Any)
}

/// Columns that a route does not have.
const OTHERS: &[(&str, Quantity)] = &[
    ("distance", Quantity::Length),
    ("time", Quantity::Time),
    ("radius", Quantity::Length),
    ("q_right", Quantity::Force),
    ("q_left", Quantity::Force),
];

/// Other names that stand in the heads of such files, in small letters; the letters are those of EN 14363.
const NAMES: &[(&str, &[&str])] = &[
    ("distance", &["s", "track_position", "chainage", "x"]),
    ("time", &["t"]),
    ("shift", &["y", "lateral_displacement", "lateral_shift", "lateral_position"]),
    ("yaw", &["yaw_angle", "psi"]),
    ("roll", &["roll_angle", "phi"]),
    ("curvature", &["track_curvature", "kappa"]),
    ("radius", &["curve_radius", "track_radius", "r"]),
    ("superelevation", &["cant", "track_cant", "u"]),
    ("speed", &["v", "velocity", "vehicle_speed"]),
    ("q_right", &["qr", "q_r", "vertical_force_right", "right_vertical_force"]),
    ("q_left", &["ql", "q_l", "vertical_force_left", "left_vertical_force"]),
    ("friction", &["mu", "friction_coefficient"]),
    ("lateral_force_right", &["y_right", "yr", "y_r", "right_lateral_force"]),
    ("lateral_force_left", &["y_left", "yl", "y_l", "left_lateral_force"]),
];

/// Columns that say the same in two ways.
const EITHER: [(&str, &str); 5] = [
    ("curvature", "radius"),
    ("wheel_load", "q_right"),
    ("wheel_load", "q_left"),
    ("load_transfer", "q_right"),
    ("load_transfer", "q_left"),
];

/// What changes its sign where z points upwards and y to the left: all along y and z, and all turns about them.
const TURNED: &[&str] = &[
    "shift",
    "yaw",
    "yaw_rate",
    "pitch_rate",
    "lateral_speed",
    "vertical_speed",
    "curvature",
    "superelevation",
];

impl History {
    /// Of the values of its table; `speed` (m/s) counts where a file of times has none.
    ///
    /// # Errors
    /// With the line or the column, anything that cannot be read, and distances or times that do not rise.
    pub fn read(values: &Values, speed: f64) -> Result<Self, Invalid> {
        let wrong = |message: String| Invalid::new("history", message);
        let Some((name, bytes)) = values.file("file") else {
            return Err(wrong("`file` is missing".to_owned()));
        };
        let table = Table::read(name, bytes).map_err(|error| wrong(error.to_string()))?;
        let given = HISTORY.iter().filter_map(|one| Some((one.name, values.word(one.name)?)));
        // A title that has no unit in the file may be given one: "y [mm]" of `y`.
        let united = |(name, title): (&str, &str)| match title.split_once(" [") {
            Some((own, unit)) if !table.has(title) => (format!("{name} [{unit}"), own.to_owned()),
            _ => (name.to_owned(), title.to_owned()),
        };
        let mut names: Vec<(String, String)> = given.map(united).collect();
        for (name, others) in NAMES {
            let known = table.has(name) || values.word(name).is_some();
            let other = others.iter().find(|other| table.has(other) && !known);
            names.extend(other.map(|other| ((*name).to_owned(), (*other).to_owned())));
        }
        let names: Vec<(&str, &str)> = names.iter().map(|(name, own)| (&**name, &**own)).collect();
        let table = table.naming(&names).map_err(|error| wrong(error.to_string()))?;
        let has = |name: &str| table.names().any(|own| own == name);
        if let Some((one, other)) = EITHER.iter().find(|(one, other)| has(one) && has(other)) {
            let message = format!("{name} has both `{one}` and `{other}`: keep one of them");
            return Err(wrong(message));
        }
        if has("q_right") != has("q_left") {
            let message = "the force on one wheel alone: `q_right` and `q_left` count together";
            return Err(wrong(format!("{name} has {message}")));
        }
        let column = |name: &str| {
            let known = COLUMNS.iter().chain(OTHERS).find(|(known, _)| *known == name);
            let quantity = known.map_or(Quantity::Number, |(_, quantity)| *quantity);
            let measure = measure(quantity, &Values::default()).unwrap_or(Measure::NUMBER);
            let read = || table.all_numbers(name, &measure);
            has(name).then(read).transpose().map_err(|error| wrong(error.to_string()))
        };
        let mut steps = vec![];
        for (name, _) in COLUMNS.iter().filter(|(name, _)| *name != "share") {
            steps.extend(column(name)?.map(|values| ((*name).to_owned(), values)));
        }
        if let Some(radius) = column("radius")? {
            let curvature = |radius: &f64| if *radius == 0.0 { 0.0 } else { 1.0 / radius };
            steps.push(("curvature".to_owned(), radius.iter().map(curvature).collect()));
        }
        if let (Some(right), Some(left)) = (column("q_right")?, column("q_left")?) {
            let both = |sign: f64| right.iter().zip(&left).map(move |(r, l)| 0.5 * (r + sign * l));
            steps.push(("wheel_load".to_owned(), both(1.0).collect()));
            steps.push(("load_transfer".to_owned(), both(-1.0).collect()));
        }
        if steps.is_empty() {
            let titles = table.titles();
            let message = format!(
                "{name} has none of the columns of a history, `shift [mm]` and the like; it has {titles}: name them, as \
                 history.shift = \"its title\""
            );
            return Err(wrong(message));
        }
        if values.is_true("upwards") {
            let turned = steps.iter_mut().filter(|(name, _)| TURNED.contains(&name.as_str()));
            turned.for_each(|(_, values)| values.iter_mut().for_each(|value| *value = -*value));
        }
        let along = match (column("distance")?, column("time")?) {
            (Some(distance), _) => distance,
            (None, Some(time)) => {
                let speeds = steps.iter().find(|(name, _)| name == "speed").map(|(_, own)| own);
                travelled(&time, speeds, speed)
            }
            (None, None) => {
                let message =
                    format!("{name} has neither a distance nor a time: add `s [m]` or `t [s]`");
                return Err(wrong(message));
            }
        };
        if let Some(row) = along.windows(2).position(|pair| pair[1] < pair[0]) {
            let line = table.lines()[row + 1];
            return Err(wrong(format!(
                "{name}, line {line}: the way falls, it has to rise from row to row"
            )));
        }
        steps.insert(0, ("share".to_owned(), shares(&along)));
        standing(&mut steps);
        if steps[0].1.is_empty() {
            return Err(wrong(format!("{name} goes no way: a history needs two rows or more")));
        }
        let within = values.number("within").unwrap_or(0.02);
        if !(within > 0.0 && within < 1.0) {
            return Err(wrong(format!("`within` = {within} has to lie between 0 and 1")));
        }
        Ok(Self { steps, within })
    }
}

/// The way (m) at times (s), by the trapezoidal rule.
fn travelled(time: &[f64], speeds: Option<&Vec<f64>>, speed: f64) -> Vec<f64> {
    let at = |row: usize| speeds.map_or(speed, |speeds| speeds[row]);
    let mut way = vec![0.0];
    for row in 1..time.len() {
        let mean = 0.5 * (at(row - 1) + at(row));
        way.push(way[row - 1] + mean * (time[row] - time[row - 1]));
    }
    way
}

/// The part of the way that each row stands for: half of that to its neighbours.
fn shares(along: &[f64]) -> Vec<f64> {
    let last = along.len() - 1;
    let whole = along[last] - along[0];
    let share =
        |row: usize| 0.5 * (along[(row + 1).min(last)] - along[row.saturating_sub(1)]) / whole;
    (0..along.len()).map(share).collect()
}

/// Leaves out rows that stand for no way.
fn standing(steps: &mut [(String, Vec<f64>)]) {
    let keep: Vec<bool> = steps[0].1.iter().map(|share| *share > 0.0).collect();
    for (_, values) in steps {
        let mut kept = keep.iter();
        values.retain(|_| *kept.next().unwrap_or(&false));
    }
}
