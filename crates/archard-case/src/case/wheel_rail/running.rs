//! How a wheelset stands on its track and runs, as a case says it.

use archard::parameters::{Bound, Choice, Invalid, Parameter, Quantity, Values};
use archard_rail::search;
use archard_rail::setup::{Attitude, Side, Track, Velocity, Wheelset};

/// How a wheelset stands on its track and runs.
#[derive(Debug, Clone)]
pub struct Running {
    /// The sides to compute.
    pub sides: Vec<Side>,
    /// Track and wheelset; the cant of the rail and the nominal radius of the wheel are with their profiles.
    pub track: Track,
    /// The lengths of the wheelset.
    pub wheelset: Wheelset,
    /// The vertical force (N) on each wheel.
    pub load: f64,
    /// Shift, yaw and, where it is given, roll.
    pub attitude: Attitude,
    /// Whether the roll is given.
    pub rolls: bool,
    /// The velocities; the pitch is NaN where it is not given.
    pub velocity: Velocity,
    /// Distance (m) up to which overlaps are one patch.
    pub join: f64,
}

/// The motion of a wheel on a rail.
pub const WHEEL_RAIL: &[Choice<Running>] = &[Choice {
    name: "wheel_rail",
    meaning: "a railway wheelset at one place of its track: patches, creepages and forces",
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
        YAW_RATE,
        ROLL_RATE,
        LATERAL,
        VERTICAL,
        JOIN,
    ],
    build,
}];

const LOAD: Parameter =
    Parameter::required("wheel_load", Quantity::Force, "vertical force on a wheel");
const SPEED: Parameter = Parameter::required("speed", Quantity::Speed, "speed along the track");
const SIDE: Parameter = Parameter::optional(
    "side",
    Quantity::Word(&["right", "left", "both"]),
    "which wheel; right if not given",
);
const GAUGE: Parameter = Parameter::optional(
    "gauge",
    Quantity::Length,
    "distance between the inner faces of the rails; 1435 mm if not given",
);
const GAUGE_HEIGHT: Parameter = Parameter::optional(
    "gauge_height",
    Quantity::Length,
    "depth below the top of the rails down to which it counts; 14 mm if not given",
);
const BACK: Parameter = Parameter::optional(
    "flange_back",
    Quantity::Length,
    "distance between the backs of the wheels; 1360 mm if not given",
);
const BACK_POSITION: Parameter = Parameter::optional(
    "flange_back_position",
    Quantity::Length,
    "y of the back on the profile of the wheel; -70 mm if not given",
)
.bound(Bound::Any);
const SHIFT: Parameter =
    Parameter::optional("shift", Quantity::Length, "lateral shift of the wheelset to the right")
        .bound(Bound::Any);
const YAW: Parameter = Parameter::optional(
    "yaw",
    Quantity::Angle,
    "turn about the vertical, positive where the right wheel goes back",
)
.bound(Bound::Any);
const ROLL: Parameter = Parameter::optional(
    "roll",
    Quantity::Angle,
    "turn about the direction of the track, positive where the right wheel goes down; found from both wheels if not given",
)
.bound(Bound::Any);
/// A rate of turning.
const RATE: Quantity = Quantity::Measured { name: "a rate of turning", unit: "rad/s" };
const PITCH: Parameter = Parameter::optional(
    "pitch_rate",
    RATE,
    "rate of turning about the axle, negative forward; that of pure rolling at the nominal radius if not given",
)
.bound(Bound::Any);
const YAW_RATE: Parameter =
    Parameter::optional("yaw_rate", RATE, "rate of the yaw").bound(Bound::Any);
const ROLL_RATE: Parameter =
    Parameter::optional("roll_rate", RATE, "rate of the roll").bound(Bound::Any);
const LATERAL: Parameter =
    Parameter::optional("lateral_speed", Quantity::Speed, "speed to the right").bound(Bound::Any);
const VERTICAL: Parameter =
    Parameter::optional("vertical_speed", Quantity::Speed, "speed downwards").bound(Bound::Any);
const JOIN: Parameter = Parameter::optional(
    "join",
    Quantity::Length,
    "distance up to which overlaps are one patch; 4 mm if not given",
)
.bound(Bound::NonNegative);

fn build(values: &Values) -> Result<Running, Invalid> {
    let or = |name, default| values.number(name).unwrap_or(default);
    let sides = match values.word("side") {
        Some("left") => vec![Side::Left],
        Some("both") => vec![Side::Left, Side::Right],
        _ => vec![Side::Right],
    };
    let standard = Track::standard();
    Ok(Running {
        sides,
        track: Track {
            gauge: or("gauge", standard.gauge),
            gauge_height: or("gauge_height", standard.gauge_height),
            cant: 0.0,
        },
        wheelset: Wheelset {
            flange_back_distance: or("flange_back", 1.36),
            flange_back_position: or("flange_back_position", -0.07),
            nominal_radius: f64::NAN,
        },
        load: values.require("wheel_load")?,
        attitude: Attitude { shift: or("shift", 0.0), roll: or("roll", 0.0), yaw: or("yaw", 0.0) }
            .checked()?,
        rolls: values.number("roll").is_some(),
        velocity: Velocity {
            forward: values.require("speed")?,
            lateral: or("lateral_speed", 0.0),
            vertical: or("vertical_speed", 0.0),
            roll: or("roll_rate", 0.0),
            yaw: or("yaw_rate", 0.0),
            pitch: or("pitch_rate", f64::NAN),
        },
        join: or("join", search::JOIN),
    })
}
