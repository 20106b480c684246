//! The keys of the motion of a wheelset: name, quantity, bound and meaning of each.

use archard::parameters::{Bound, Parameter, Quantity};

use super::history::HISTORY;
use super::running::COLUMNS;

pub(super) const LOAD: Parameter =
    Parameter::required("wheel_load", Quantity::Force, "vertical force on a wheel");
pub(super) const SPEED: Parameter =
    Parameter::required("speed", Quantity::Speed, "speed along the track");
pub(super) const SIDE: Parameter = Parameter::optional(
    "side",
    Quantity::Word(&["right", "left", "both"]),
    "which wheel; right if not given",
);
pub(super) const GAUGE: Parameter = Parameter::optional(
    "gauge",
    Quantity::Length,
    "distance between the inner faces of the rails; 1435 mm if not given",
);
pub(super) const GAUGE_HEIGHT: Parameter = Parameter::optional(
    "gauge_height",
    Quantity::Length,
    "depth below the top of the rails down to which it counts; 14 mm if not given",
);
pub(super) const BACK: Parameter = Parameter::optional(
    "flange_back",
    Quantity::Length,
    "distance between the backs of the wheels; 1360 mm if not given",
);
pub(super) const BACK_POSITION: Parameter = Parameter::optional(
    "flange_back_position",
    Quantity::Length,
    "y of the back on the profile of the wheel; -70 mm if not given",
)
.bound(Bound::Any);
pub(super) const SHIFT: Parameter =
    Parameter::optional("shift", Quantity::Length, "lateral shift of the wheelset to the right")
        .bound(Bound::Any);
pub(super) const YAW: Parameter = Parameter::optional(
    "yaw",
    Quantity::Angle,
    "turn about the vertical, positive where the right wheel goes back",
)
.bound(Bound::Any);
pub(super) const ROLL: Parameter = Parameter::optional(
    "roll",
    Quantity::Angle,
    "turn about the direction of the track, positive where the right wheel goes down; found from both wheels if not given",
)
.bound(Bound::Any);
/// A rate of turning.
pub(super) const RATE: Quantity = Quantity::Measured { name: "a rate of turning", unit: "rad/s" };
pub(super) const PITCH: Parameter = Parameter::optional(
    "pitch_rate",
    RATE,
    "rate of turning about the axle, negative forward; that of pure rolling at the nominal radius if not given",
)
.bound(Bound::Any);
/// A moment.
pub(super) const MOMENT: Quantity = Quantity::Measured { name: "a moment", unit: "N m" };
pub(super) const AXLE_MOMENT: Parameter = Parameter::optional(
    "axle_moment",
    MOMENT,
    "moment that drives the wheelset forward, negative where it brakes, 0 of one that runs free; the rate of turning follows",
)
.bound(Bound::Any);
pub(super) const YAW_RATE: Parameter =
    Parameter::optional("yaw_rate", RATE, "rate of the yaw").bound(Bound::Any);
pub(super) const ROLL_RATE: Parameter =
    Parameter::optional("roll_rate", RATE, "rate of the roll").bound(Bound::Any);
pub(super) const LATERAL: Parameter =
    Parameter::optional("lateral_speed", Quantity::Speed, "speed to the right").bound(Bound::Any);
pub(super) const VERTICAL: Parameter =
    Parameter::optional("vertical_speed", Quantity::Speed, "speed downwards").bound(Bound::Any);
pub(super) const JOIN: Parameter = Parameter::optional(
    "join",
    Quantity::Length,
    "distance up to which overlaps are one patch; 4 mm if not given",
)
.bound(Bound::NonNegative);

pub(super) const CURVATURE: Parameter = Parameter::optional(
    "curvature",
    Quantity::Curvature,
    "curvature of the track, positive to the right: the wheelset turns with it",
)
.bound(Bound::Any);
pub(super) const ROUTE: Parameter = Parameter::optional(
    "route",
    Quantity::Table(COLUMNS),
    "CSV of operating points, a row each: `share` of the distance and any value above that differs from point to point, or \
     `friction`",
)
.bound(Bound::Any);
pub(super) const FLANGE_FRICTION: Parameter = Parameter::optional(
    "flange_friction",
    Quantity::Number,
    "coefficient of friction on the flange, where it differs, as where it is lubricated",
)
.bound(Bound::NonNegative);
pub(super) const FLANGE_FROM: Parameter = Parameter::optional(
    "flange_from",
    Quantity::Length,
    "y on the profile of the wheel where the flange begins that has friction or wear of its own: it reaches from there to the tip",
)
.bound(Bound::Any);
pub(super) const STEPS: Parameter = Parameter::optional(
    "history",
    Quantity::Section(HISTORY),
    "the history of a program of vehicle dynamics, gathered to the points of a route",
);
pub(super) const SUPERELEVATION: Parameter = Parameter::optional(
    "superelevation",
    Quantity::Length,
    "height of the left rail over the right one, as of a curve to the right",
)
.bound(Bound::Any);
pub(super) const CENTRE_HEIGHT: Parameter = Parameter::optional(
    "centre_height",
    Quantity::Length,
    "height of the centre of mass over the rails: the wheels share their load in a curve by the quasi-static balance",
);
pub(super) const DISTANCE: Parameter =
    Parameter::optional("distance", Quantity::Length, "distance that a wheel runs which wears");
pub(super) const AXLES: Parameter =
    Parameter::optional("axles", Quantity::Number, "axles that pass a rail which wears");
pub(super) const TOLERANCE: Parameter = Parameter::optional(
    "tolerance",
    Quantity::Number,
    "error of a step of wear, relative to all that is worn off; 0.01 if not given",
);
pub(super) const WEAR_SMOOTHING: Parameter = Parameter::optional(
    "wear_smoothing",
    Quantity::Length,
    "waves of worn depth of this length keep half of their height; 2 mm if not given",
)
.bound(Bound::NonNegative);
