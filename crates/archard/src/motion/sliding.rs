//! Gross sliding: every pair in contact slides the same distance (pin on disc, block on ring, reciprocating).
//!
//! Without a track the surfaces stay opposite each other, as in the paper: both wear as if the one were as short as the
//! other. A disc, a ring or a flat under a stroke is longer. It *passes*: each of its points comes through the contact
//! once a turn, or once a stroke, and all points on a line along the motion wear equally.

use super::{
    APPROACH, Control, LOAD, Lever, Motion, Passage, Planned, Progress, Schedule, Sequence, Slip,
    Stepping, TOLERANCE, control, few_steps, pressing,
};
use crate::frame::Direction;
use crate::parameters::{Choice, Invalid, Parameter, Quantity, Values};

pub(super) const CHOICE: Choice<Planned> = Choice {
    name: "sliding",
    meaning: "sliding at constant load or approach: pin on disc, block on ring, reciprocating",
    parameters: &[
        LOAD,
        APPROACH,
        DISTANCE,
        RADIUS,
        LENGTH,
        STROKE,
        Parameter::optional(
            "ends",
            Quantity::Truth,
            "whether the ends of a stroke, where it turns, are resolved; not if not given",
        ),
        Parameter::optional(
            "passes",
            Quantity::Body,
            "the body that has the track; the other one stays in contact",
        ),
        Parameter::optional(
            "surfaces",
            Quantity::Word(&["stay", "pass"]),
            "whether both surfaces stay opposite each other, as they do without a track (stay), or slide past each other, both repeating themselves with the frame (pass)",
        ),
        Parameter::optional(
            "direction",
            Quantity::Word(&["x", "y"]),
            "axis of the frame along which the bodies slide; x if not given",
        ),
        Parameter::optional("turns", Quantity::Number, "turns, or strokes to and fro, in all"),
        Parameter::optional("time", Quantity::Time, "time in all"),
        SPEED,
        Parameter::optional(
            "frequency",
            Quantity::Frequency,
            "turns, or strokes to and fro, in a time (Hz or rpm)",
        ),
        STEP,
        TOLERANCE,
        Parameter::optional(
            "scheme",
            Quantity::Word(&["implicit", "explicit"]),
            "how a fixed step takes the pressure: at its end (implicit, the default) or at its start",
        ),
    ],
    build: |values| {
        let track = track(values)?;
        let (distance, speed) = course(values, track.as_ref())?;
        let explicit = values.word("scheme") == Some("explicit");
        let stepping = match values.one_of("step", "tolerance")? {
            (Some(step), _) if explicit => Stepping::Explicit(step),
            (Some(step), _) => Stepping::Implicit(step),
            (None, _) if explicit => {
                return Err(Invalid::new(
                    "scheme",
                    "the explicit scheme takes a `step`, not a `tolerance`",
                )
                .beside("tolerance"));
            }
            (None, tolerance) => Stepping::Tolerance(tolerance.unwrap_or_default()),
        };
        let axis = usize::from(values.word("direction") == Some("y"));
        let direction = Direction { axis, reversed: false };
        let ends = ends(values, track.as_ref(), explicit)?;
        let endless = values.word("surfaces") == Some("pass");
        Sliding { direction, track, speed, ends, endless }.over(
            distance,
            control(values)?,
            stepping,
        )
    },
};

const DISTANCE: Parameter =
    Parameter::optional("distance", Quantity::Length, "sliding distance in all");
const RADIUS: Parameter = Parameter::optional(
    "track_radius",
    Quantity::Length,
    "radius of the track on a disc, or of a ring",
);
const LENGTH: Parameter =
    Parameter::optional("track", Quantity::Length, "length of the track, instead: one turn");
const STROKE: Parameter =
    Parameter::optional("stroke", Quantity::Length, "stroke of a reciprocating motion, instead");
const SPEED: Parameter = Parameter::optional("speed", Quantity::Speed, "mean speed of sliding");
const STEP: Parameter = Parameter::optional("step", Quantity::Length, "distance slid in one step");

/// Every pair in contact slides the same distance.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sliding {
    direction: Direction,
    /// The track of the body that passes; `None` where both stay.
    track: Option<Track>,
    /// Mean speed (m/s), where it is known.
    speed: Option<f64>,
    /// Whether the ends of a stroke are resolved: its surface swings then.
    ends: bool,
    /// Whether surfaces that repeat themselves slide past each other.
    endless: bool,
}

/// A track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Track {
    /// Its length (m): the circumference, or the stroke.
    pub length: f64,
    /// The body that passes: 0 for body 1, 1 for body 2.
    pub body: usize,
    /// Whether it is gone through to and fro.
    pub strokes: bool,
}

impl Track {
    /// Around body 0 or 1, at that radius (m).
    ///
    /// # Errors
    /// If there is no such body, or the radius is not greater than zero.
    pub fn around(body: usize, radius: f64) -> Result<Self, Invalid> {
        let length = std::f64::consts::TAU * RADIUS.admit(radius)?;
        Ok(Self { length, body: one_of_both(body)?, strokes: false })
    }

    /// To and fro on body 0 or 1, by strokes of that length (m).
    ///
    /// # Errors
    /// If there is no such body, or the length is not greater than zero.
    pub fn to_and_fro(body: usize, stroke: f64) -> Result<Self, Invalid> {
        Ok(Self { length: STROKE.admit(stroke)?, body: one_of_both(body)?, strokes: true })
    }

    /// Distance (m) of a turn, or of a stroke to and fro.
    pub fn cycle(&self) -> f64 {
        if self.strokes { 2.0 * self.length } else { self.length }
    }
}

fn one_of_both(body: usize) -> Result<usize, Invalid> {
    if body < 2 {
        return Ok(body);
    }
    Err(Invalid::new("passes", format!("body {body}: the bodies are 0 and 1")))
}

impl Sliding {
    /// Along x, both surfaces staying opposite each other.
    pub fn new() -> Self {
        Self::default()
    }

    /// The same along that direction.
    #[must_use]
    pub fn along(self, direction: Direction) -> Self {
        Self { direction, ..self }
    }

    /// The same on a track.
    #[must_use]
    pub fn on(self, track: Track) -> Self {
        Self { track: Some(track), ..self }
    }

    /// The same, surfaces that repeat themselves with the frame sliding past each other.
    #[must_use]
    pub fn endless(self) -> Self {
        Self { endless: true, ..self }
    }

    /// The same at that mean speed (m/s).
    #[must_use]
    pub fn at_speed(self, speed: f64) -> Self {
        Self { speed: Some(speed), ..self }
    }

    /// Sliding over a distance (m) at constant load or approach, in steps of a length (m) or by error.
    ///
    /// # Errors
    /// If a value is not greater than zero, or a step is longer than the distance or far too short for it.
    pub fn over(
        self,
        distance: f64,
        control: Control,
        stepping: Stepping,
    ) -> Result<Planned, Invalid> {
        let distance = DISTANCE.admit(distance)?;
        self.speed.map(|speed| SPEED.admit(speed)).transpose()?;
        if let Stepping::Implicit(step) | Stepping::Explicit(step) = stepping
            && step > distance
        {
            let message = "`step` is longer than `distance`";
            return Err(Invalid::new("step", message).beside("distance"));
        }
        if self.endless && matches!(stepping, Stepping::Explicit(_)) {
            let message = "surfaces that slide past each other take implicit steps";
            return Err(Invalid::new("scheme", message).beside("surfaces"));
        }
        let stepping = few_steps(stepping, STEP, distance)?;
        Ok((self.motion(), Schedule::steady(pressing(control)?, distance, stepping)))
    }

    fn motion(self) -> Motion {
        let passage = |body: usize| match self.track.filter(|track| track.body == body) {
            None if self.endless && body == 1 => Passage::Recurs,
            None => Passage::Stays,
            Some(track) if self.ends => Passage::Swings(0.5 * track.length, Some(track)),
            track => Passage::Passes(track),
        };
        Motion {
            progress: Progress::DISTANCE,
            direction: self.direction,
            surfaces: [0, 1].map(passage),
            slip: Slip::Given(1.0, Lever::Even),
            sequence: Sequence::Steady,
            speed: self.speed,
        }
    }
}

/// The track that is given.
fn track(values: &Values) -> Result<Option<Track>, Invalid> {
    const LENGTHS: [&str; 3] = ["track_radius", "track", "stroke"];
    let mut given = LENGTHS.iter().filter_map(|name| Some((*name, values.number(name)?)));
    let first = given.next();
    if let (Some((first, _)), Some((second, _))) = (first, given.next()) {
        return Err(Invalid::exclusive(second, first, "keep one"));
    }
    let Some((name, value)) = first else {
        let needs = |name| {
            Invalid::new(
                name,
                format!("`{name}` needs a track: give `track_radius`, `track` or `stroke`"),
            )
        };
        return match ["passes", "turns", "frequency"]
            .into_iter()
            .find(|name| values.get(name).is_some())
        {
            Some(name) => Err(needs(name)),
            None => Ok(None),
        };
    };
    if values.word("surfaces").is_some() {
        return Err(Invalid::exclusive("surfaces", name, "on a track one surface passes"));
    }
    let Some(body) = values.body("passes") else {
        let message = format!("`{name}` needs the body that has the track, `passes`");
        return Err(Invalid::new(name, message));
    };
    let length = if name == "track_radius" { std::f64::consts::TAU * value } else { value };
    Ok(Some(Track { length, body, strokes: name == "stroke" }))
}

/// Whether the ends of a stroke are to be resolved.
fn ends(values: &Values, track: Option<&Track>, explicit: bool) -> Result<bool, Invalid> {
    match track {
        _ if !values.is_true("ends") => Ok(false),
        Some(_) if explicit => {
            let message = "the ends of a stroke are resolved by the implicit scheme only";
            Err(Invalid::new("ends", message).beside("scheme"))
        }
        Some(track) if track.strokes => Ok(true),
        _ => Err(Invalid::new("ends", "only a `stroke` has ends")),
    }
}

/// Distance (m) and mean speed (m/s), from what is given of distance, turns, time, speed and frequency.
fn course(values: &Values, track: Option<&Track>) -> Result<(f64, Option<f64>), Invalid> {
    let cycle = track.map(Track::cycle);
    // Each pair says the same of distance and of speed.
    let per_cycle = |name| Some(values.number(name)? * cycle?);
    let distances = [("distance", values.number("distance")), ("turns", per_cycle("turns"))];
    let speeds = [("speed", values.number("speed")), ("frequency", per_cycle("frequency"))];
    let distance = one_of_two(distances, "m")?;
    let speed = one_of_two(speeds, "m/s")?;
    match (distance, speed, values.number("time")) {
        (Some((name, distance)), Some((_, speed)), Some(time)) => {
            if !same(distance, speed * time) {
                let message = format!(
                    "`time` contradicts `{name}`: at that speed {} m take {} s",
                    rounded(distance),
                    rounded(distance / speed)
                );
                return Err(Invalid::new("time", message).beside(name));
            }
            Ok((distance, Some(speed)))
        }
        (Some((_, distance)), None, Some(time)) => Ok((distance, Some(distance / time))),
        (Some((_, distance)), speed, None) => Ok((distance, speed.map(|(_, speed)| speed))),
        (None, Some((_, speed)), Some(time)) => Ok((speed * time, Some(speed))),
        (None, _, _) => {
            let more = if track.is_some() { ", `turns`" } else { "" };
            let message = format!(
                "how far the bodies slide is missing: `distance`{more}, or `time` and `speed`"
            );
            Err(Invalid::new("distance", message))
        }
    }
}

/// The one of two values that is given; an error where both are and differ.
fn one_of_two(
    [(first, one), (second, other)]: [(&'static str, Option<f64>); 2],
    unit: &str,
) -> Result<Option<(&'static str, f64)>, Invalid> {
    match (one, other) {
        (Some(one), Some(other)) if !same(one, other) => {
            let message = format!(
                "`{second}` contradicts `{first}`: on this track it comes to {} {unit}, not {} {unit}",
                rounded(other),
                rounded(one)
            );
            Err(Invalid::new(second, message).beside(first))
        }
        (Some(one), _) => Ok(Some((first, one))),
        (None, other) => Ok(other.map(|other| (second, other))),
    }
}

/// Whether two values are the same, as people round them.
fn same(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-3 * one.abs().max(other.abs())
}

/// A number to four digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::CHOICE;
    use crate::motion::{Motion, Schedule};
    use crate::parameters::{Value, Values};

    fn built(numbers: &[(&'static str, f64)]) -> Result<(Motion, Schedule), String> {
        let mut values = Values::default();
        numbers.iter().for_each(|(name, value)| values.insert(name, Value::Number(*value)));
        values.insert("load", Value::Number(10.0));
        values.insert("tolerance", Value::Number(0.01));
        if numbers.iter().any(|(name, _)| ["track_radius", "track", "stroke"].contains(name)) {
            values.insert("passes", Value::Body(1, "disc".to_owned()));
        }
        (CHOICE.build)(&values).map_err(|invalid| invalid.message)
    }

    /// A disc of 10 mm track radius at 2 turns a second for 5 s: 10 turns, 0.2 pi m; two of the five say the others.
    #[test]
    fn distance_turns_time_and_speed_follow_from_two() {
        let turn = 0.02 * std::f64::consts::PI;
        let radius = ("track_radius", 0.01);
        for two in [
            [("turns", 10.0), ("frequency", 2.0)],
            [("turns", 10.0), ("time", 5.0)],
            [("turns", 10.0), ("speed", 2.0 * turn)],
            [("time", 5.0), ("speed", 2.0 * turn)],
            [("time", 5.0), ("frequency", 2.0)],
            [("distance", 10.0 * turn), ("time", 5.0)],
        ] {
            let (sliding, schedule) = built(&[radius, two[0], two[1]]).unwrap();
            assert_relative_eq!(schedule.extent, 10.0 * turn, max_relative = 1e-14);
            assert_relative_eq!(sliding.speed.unwrap(), 2.0 * turn, max_relative = 1e-14);
            assert_relative_eq!(sliding.track().unwrap().length, turn, max_relative = 1e-14);
        }
        // To and fro is twice the stroke.
        let (sliding, schedule) = built(&[("stroke", 0.01), ("turns", 5000.0)]).unwrap();
        assert_relative_eq!(schedule.extent, 100.0);
        assert_relative_eq!(sliding.track().unwrap().length, 0.01);
    }

    #[test]
    fn contradictions_and_gaps_are_named() {
        let error = |numbers: &[(&'static str, f64)]| built(numbers).unwrap_err();
        let radius = ("track_radius", 0.01);
        assert!(error(&[("time", 5.0)]).contains("`distance`"));
        assert!(error(&[("distance", 1.0), ("turns", 5.0)]).contains("needs a track"));
        assert!(
            error(&[radius, ("distance", 1.0), ("turns", 5.0)]).contains("contradicts `distance`")
        );
        assert!(error(&[radius, ("track", 0.01), ("turns", 5.0)]).contains("exclude"));
        let thrice = [radius, ("distance", 1.0), ("speed", 0.1), ("time", 20.0)];
        assert!(error(&thrice).contains("`time` contradicts"));
        assert!(
            error(&[radius, ("speed", 0.1), ("frequency", 9.0), ("time", 1.0)])
                .contains("contradicts `speed`")
        );
    }
}
