//! How a wheelset stands on its track and runs, as a case says it.

use std::sync::Arc;

use archard::friction::{Coulomb, Friction};
use archard::parameters::{Choice, Invalid, Quantity, Values};
use archard_rail::contact::Zone;
use archard_rail::search;
use archard_rail::setup::{Attitude, Side, Track, Velocity, Wheelset};
use archard_rail::wear::OperatingPoint;

use super::history::History;
use super::keys::{
    AXLE_MOMENT, AXLES, BACK, BACK_POSITION, CENTRE_HEIGHT, CURVATURE, DISTANCE, FLANGE_FRICTION,
    FLANGE_FROM, GAUGE, GAUGE_HEIGHT, JOIN, LATERAL, LOAD, MOMENT, PITCH, RATE, ROLL, ROLL_RATE,
    ROUTE, SHIFT, SIDE, SPEED, STEPS, SUPERELEVATION, TOLERANCE, VERTICAL, WEAR_SMOOTHING, YAW,
    YAW_RATE,
};

/// Columns (SI) by their names.
pub type Columns = Vec<(String, Vec<f64>)>;

/// How a wheelset stands on its track and runs.
#[derive(Debug, Clone)]
pub struct WheelsetMotion {
    /// The sides to compute.
    pub sides: Vec<Side>,
    /// Gauge (m), and the depth (m) down to which it counts.
    pub gauge: [f64; 2],
    /// Distance (m) between the backs of the wheels, and y (m) of the back on a profile.
    pub flange_back: [f64; 2],
    /// y (m) on the profile of the wheel where the flange begins that has friction or wear of its own.
    pub flange_from: Option<f64>,
    /// Whether the friction on the flange is its own.
    pub lubricated: bool,
    /// How it stands and runs.
    pub state: State,
    /// Distance (m) up to which overlaps are one patch.
    pub join: f64,
    /// The points of a route by their columns (SI), which count in the place of what is here; none without a route.
    pub route: Columns,
    /// Of a history, whose steps the route has, what points in their place may lose.
    pub within: Option<f64>,
    /// Distance (m) that the wheelset runs.
    pub distance: Option<f64>,
    /// Axles that pass the rail.
    pub axles: Option<f64>,
    /// Error that a step of wear may have, relative to all that is worn off.
    pub tolerance: f64,
    /// Waves (m) of the worn depth that keep half of their height.
    pub wear_smoothing: f64,
}

/// How a wheelset stands and runs at a point of its route.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// The vertical force (N) on each wheel, the mean of both.
    pub load: f64,
    /// How much more (N) the right wheel bears, and the left one less; by the balance in a curve where it is not given.
    pub transfer: Option<f64>,
    /// How much higher (m) the left rail is than the right one.
    pub superelevation: f64,
    /// Height (m) of the centre of mass over the rails.
    pub centre_height: f64,
    /// Creepage, lateral creepage and spin (1/m) of the right and of the left wheel where they are prescribed, as their sides see them.
    pub creepages: [[Option<f64>; 3]; 2],
    /// Lateral force (N) of the right and of the left wheel on its rail, positive to the field side, where another program has found it:
    /// what is computed is held against it.
    pub lateral_forces: [Option<f64>; 2],
    /// Shift and yaw, and the roll where it is given.
    pub attitude: Attitude,
    /// Whether the roll is given.
    pub rolls: bool,
    /// The velocities but for the pitch.
    pub velocity: Velocity,
    /// Rate (rad/s) of the turn about the axle; that of pure rolling at the nominal radius where it is not given.
    pub pitch: Option<f64>,
    /// Moment (N m) that drives the wheelset forward, from which the pitch follows.
    pub moment: Option<f64>,
    /// Curvature (1/m) of the track, positive to the right.
    pub curvature: f64,
    /// Coefficient of friction in the place of the law's.
    pub friction: Option<f64>,
    /// Coefficient of friction on the flange, where it differs.
    pub flange_friction: Option<f64>,
    /// y (m) on the profile of the wheel where the flange begins that has it.
    pub flange_from: f64,
    /// Share of the distance.
    pub share: f64,
}

/// What may differ from point to point of a route: the name of a column and its quantity.
pub(super) const COLUMNS: &[(&str, Quantity)] = &[
    ("share", Quantity::Number),
    ("shift", Quantity::Length),
    ("yaw", Quantity::Angle),
    ("roll", Quantity::Angle),
    ("curvature", Quantity::Curvature),
    ("wheel_load", Quantity::Force),
    ("friction", Quantity::Number),
    ("flange_friction", Quantity::Number),
    ("speed", Quantity::Speed),
    ("lateral_speed", Quantity::Speed),
    ("vertical_speed", Quantity::Speed),
    ("pitch_rate", RATE),
    ("axle_moment", MOMENT),
    ("yaw_rate", RATE),
    ("roll_rate", RATE),
    ("load_transfer", Quantity::Force),
    ("superelevation", Quantity::Length),
    ("creepage_right", Quantity::Number),
    ("lateral_creepage_right", Quantity::Number),
    ("spin_right", Quantity::Curvature),
    ("creepage_left", Quantity::Number),
    ("lateral_creepage_left", Quantity::Number),
    ("spin_left", Quantity::Curvature),
    (LATERAL_FORCES[0], Quantity::Force),
    (LATERAL_FORCES[1], Quantity::Force),
];
/// The columns of lateral forces of the right and of the left wheel, as another program has found them.
pub(super) const LATERAL_FORCES: [&str; 2] = ["lateral_force_right", "lateral_force_left"];
/// The title of a column of a route, with its SI unit.
pub(super) fn title(name: &str) -> String {
    let known = COLUMNS.iter().find(|(known, _)| *known == name);
    match known.map_or("", |(_, quantity)| quantity.unit()) {
        "" => name.to_owned(),
        unit => format!("{name} [{unit}]"),
    }
}
/// The columns of prescribed creepages of the right and of the left wheel.
const CREEPAGES: [[&str; 3]; 2] = [
    ["creepage_right", "lateral_creepage_right", "spin_right"],
    ["creepage_left", "lateral_creepage_left", "spin_left"],
];
/// Acceleration (m/s^2) of gravity.
const GRAVITY: f64 = 9.80665;

impl State {
    /// Puts a value (SI) in the place of the one of that name.
    ///
    /// # Errors
    /// If none exists of that name, or it cannot have that value.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), Invalid> {
        if !value.is_finite() {
            return Err(Invalid::new(
                "value",
                format!("`{name}` = {value} is not a finite number"),
            ));
        }
        let Self { load, attitude, velocity, .. } = self;
        let place = match name {
            "share" => &mut self.share,
            "shift" => &mut attitude.shift,
            "yaw" => &mut attitude.yaw,
            "roll" => {
                self.rolls = true;
                &mut attitude.roll
            }
            "curvature" => &mut self.curvature,
            "wheel_load" => load,
            "load_transfer" => self.transfer.insert(value),
            "superelevation" => &mut self.superelevation,
            "friction" => self.friction.insert(value),
            "flange_friction" => self.flange_friction.insert(value),
            "speed" => &mut velocity.forward,
            "lateral_speed" => &mut velocity.lateral,
            "vertical_speed" => &mut velocity.vertical,
            "pitch_rate" => {
                self.moment = None;
                self.pitch.insert(value)
            }
            "axle_moment" => {
                self.pitch = None;
                self.moment.insert(value)
            }
            "yaw_rate" => &mut velocity.yaw,
            "roll_rate" => &mut velocity.roll,
            _ => {
                if let Some([side, at]) = creepage(name) {
                    self.creepages[side][at] = Some(value);
                    return Ok(());
                }
                if let Some(side) = LATERAL_FORCES.iter().position(|own| *own == name) {
                    self.lateral_forces[side] = Some(value);
                    return Ok(());
                }
                let known = COLUMNS.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
                let message = format!("`{name}` is no value of a point: {known}");
                return Err(Invalid::new("value", message));
            }
        };
        *place = value;
        Ok(())
    }

    /// How much more (N) the right wheel bears than half of both: what is given, or by the quasi-static balance of the centre of mass
    /// in a curve, on wheels that roll so far (m) from each other.
    fn transferred(&self, apart: f64) -> f64 {
        // Outwards, to the left where the track curves to the right.
        let uncompensated =
            self.velocity.forward.powi(2) * self.curvature / GRAVITY - self.superelevation / apart;
        let balanced = -2.0 * self.load * uncompensated * self.centre_height / apart;
        self.transfer.unwrap_or(balanced)
    }

    /// As an operating point, for a wheelset and a law of friction where no coefficient is given.
    ///
    /// # Errors
    /// If the coefficient of friction is negative, or a wheel is lifted.
    pub fn point(
        &self,
        wheelset: &Wheelset,
        law: &Arc<dyn Friction>,
    ) -> Result<OperatingPoint, Invalid> {
        let radius = wheelset.nominal_radius;
        let transfer = self.transferred(2.0 * wheelset.arm());
        // A wheel that bears nothing is refused as such.
        if self.load > 0.0 && transfer.abs() >= self.load {
            let message = format!(
                "a transfer of {transfer:.4e} N lifts a wheel that bears {:.4e} N: look at speed, curvature, superelevation and \
                 the height of the centre of mass",
                self.load
            );
            return Err(Invalid::new("wheel_load", message));
        }
        let coulomb = |coefficient: f64| -> Result<Arc<dyn Friction>, Invalid> {
            Ok(Arc::new(Coulomb::new(coefficient)?))
        };
        let friction = self.friction.map_or_else(|| Ok(law.clone()), coulomb)?;
        let flange = self.flange_friction.map(coulomb).transpose()?;
        let flange = flange.map(|friction| Zone { from: self.flange_from, friction });
        let mut velocity = self.velocity;
        velocity.pitch = self.pitch.unwrap_or(-velocity.forward / radius);
        // The wheelset turns with its track: its outer wheel goes the longer way.
        velocity.yaw += self.curvature * velocity.forward;
        Ok(OperatingPoint {
            attitude: self.attitude.checked()?,
            rolls: self.rolls,
            velocity,
            moment: self.moment,
            load: self.load,
            flange,
            transfer,
            creepages: self.creepages,
            friction,
            share: self.share,
        })
    }
}

impl WheelsetMotion {
    /// The points of the route; what is here where none exists.
    ///
    /// # Errors
    /// If a column is not known, or a value cannot be used.
    pub fn states(&self) -> Result<Vec<State>, Invalid> {
        let Some((_, first)) = self.route.first() else { return Ok(vec![self.state]) };
        if !self.route.iter().any(|(name, _)| name == "share") {
            return Err(Invalid::new("route", "a column `share`, of the distance, is needed"));
        }
        if let Some((name, _)) = self.route.iter().find(|(_, values)| values.len() != first.len()) {
            let message = format!("`{name}` has not as many values as the other columns");
            return Err(Invalid::new("route", message));
        }
        let state = |row: usize| {
            let mut state = self.state;
            for (name, values) in &self.route {
                let named = |error: Invalid| {
                    Invalid::new("route", format!("point {}: {}", row + 1, error.message))
                };
                state.set(name, values[row]).map_err(named)?;
            }
            Ok(state)
        };
        (0..first.len()).map(state).collect()
    }
}

/// The motion of a wheel on a rail.
pub const WHEEL_RAIL: &[Choice<WheelsetMotion>] = &[Choice {
    name: "wheel_rail",
    meaning: "a railway wheelset on its track: patches, creepages and forces, and wear over a route",
    parameters: &[
        LOAD,
        SPEED,
        SIDE,
        GAUGE,
        GAUGE_HEIGHT,
        BACK,
        BACK_POSITION,
        SHIFT,
        YAW,
        ROLL,
        PITCH,
        AXLE_MOMENT,
        YAW_RATE,
        ROLL_RATE,
        LATERAL,
        VERTICAL,
        CURVATURE,
        SUPERELEVATION,
        CENTRE_HEIGHT,
        FLANGE_FRICTION,
        FLANGE_FROM,
        JOIN,
        ROUTE,
        STEPS,
        DISTANCE,
        AXLES,
        TOLERANCE,
        WEAR_SMOOTHING,
    ],
    build,
}];

/// Which side and which of its creepages a column prescribes.
fn creepage(name: &str) -> Option<[usize; 2]> {
    let at = |side: usize| Some([side, CREEPAGES[side].iter().position(|one| *one == name)?]);
    at(0).or_else(|| at(1))
}

fn build(values: &Values) -> Result<WheelsetMotion, Invalid> {
    let or = |name, default| values.number(name).unwrap_or(default);
    let sides = match values.word("side") {
        Some("left") => vec![Side::Left],
        Some("both") => vec![Side::Left, Side::Right],
        _ => vec![Side::Right],
    };
    let standard = Track::standard();
    let velocity = Velocity {
        forward: values.require("speed")?,
        lateral: or("lateral_speed", 0.0),
        vertical: or("vertical_speed", 0.0),
        roll: or("roll_rate", 0.0),
        yaw: or("yaw_rate", 0.0),
        pitch: 0.0,
    };
    let attitude = Attitude { shift: or("shift", 0.0), roll: or("roll", 0.0), yaw: or("yaw", 0.0) };
    let history = values.section("history");
    if history.is_some() && values.table("route").is_some() {
        return Err(Invalid::exclusive("history", "route", "keep one"));
    }
    let history = history.map(|own| History::read(own, velocity.forward)).transpose()?;
    let (route, within) = match history {
        Some(History { steps, within }) => (steps, Some(within)),
        None => (values.table("route").unwrap_or_default().to_vec(), None),
    };
    if values.number("pitch_rate").is_some() && values.number("axle_moment").is_some() {
        return Err(Invalid::exclusive("axle_moment", "pitch_rate", "keep one"));
    }
    let lubricated = values.number("flange_friction").is_some()
        || route.iter().any(|(name, _)| name == "flange_friction");
    let flange_from = values.number("flange_from");
    if lubricated && flange_from.is_none() {
        let message = "is missing: `flange_friction` counts from there on";
        return Err(Invalid::new("flange_from", message));
    }
    let running = WheelsetMotion {
        sides,
        flange_from,
        lubricated,
        gauge: [or("gauge", standard.gauge), or("gauge_height", standard.gauge_height)],
        flange_back: [or("flange_back", 1.36), or("flange_back_position", -0.07)],
        state: State {
            load: values.require("wheel_load")?,
            transfer: None,
            superelevation: or("superelevation", 0.0),
            centre_height: or("centre_height", 0.0),
            creepages: [[None; 3]; 2],
            lateral_forces: [None; 2],
            attitude: attitude.checked()?,
            rolls: values.number("roll").is_some(),
            velocity,
            pitch: values.number("pitch_rate"),
            moment: values.number("axle_moment"),
            curvature: or("curvature", 0.0),
            friction: None,
            flange_friction: values.number("flange_friction"),
            flange_from: flange_from.unwrap_or_default(),
            share: 1.0,
        },
        join: or("join", search::JOIN),
        route,
        within,
        distance: values.number("distance"),
        axles: values.number("axles"),
        tolerance: or("tolerance", 0.01),
        wear_smoothing: or("wear_smoothing", 2e-3),
    };
    running.states()?;
    Ok(running)
}
