//! The shapes of cams and followers, and how they run, as a case says.

use std::f64::consts::TAU;

use archard::parameters::{Bound, Choice, Invalid, Parameter, Quantity, Values};
use archard_gear::cam::{Follower, Lift, Loading, Profile};

/// A cam.
#[derive(Debug, Clone, PartialEq)]
pub struct CamShape {
    /// Its shape.
    pub profile: Profile,
    /// Forces (N) on the follower over the angle (rad), where the table of the lift has them.
    pub loads: Option<Vec<[f64; 2]>>,
}

/// The profiles of cams.
pub const CAMS: &[Choice<CamShape>] = &[
    Choice {
        name: "cam",
        meaning: "a cam that lifts its follower as a table says",
        parameters: &[
            Parameter::required("base_radius", Quantity::Length, "radius of the base circle"),
            Parameter::required(
                "file",
                Quantity::Table(&[
                    ("angle", Quantity::Angle),
                    ("lift", Quantity::Length),
                    ("load", Quantity::Force),
                ]),
                "CSV with columns angle_deg and lift_mm of the follower over one turn, the last row the first one 360 deg later; \
                 load_N as well where nothing else presses it on the cam",
            ),
        ],
        build: |values| {
            let rows = |name: &str| rows(values, name);
            let Some(lifts) = rows("lift")? else {
                return Err(Invalid::new(
                    "file",
                    "the column `lift` is missing: angle_deg and lift_mm",
                ));
            };
            let profile = Profile::Lift {
                base_radius: values.require("base_radius")?,
                lift: Lift::new(lifts)?,
            };
            let loads = rows("load")?;
            if let Some([first, .., last]) = loads.as_deref()
                && first[1] != last[1]
            {
                let message = "the column `load` does not close: its last row has to be the first, a turn later";
                return Err(Invalid::new("file", message));
            }
            Ok(CamShape { profile, loads })
        },
    },
    Choice {
        name: "eccentric",
        meaning: "a circle that turns about another point than its middle; the follower is lowest at 0 deg",
        parameters: &[
            Parameter::required("radius", Quantity::Length, "radius of the circle"),
            Parameter::required(
                "eccentricity",
                Quantity::Length,
                "distance of its middle from the axis",
            ),
        ],
        build: |values| {
            let [radius, eccentricity] =
                [values.require("radius")?, values.require("eccentricity")?];
            if eccentricity >= radius {
                let message = "the axis lies outside of the circle: smaller than the radius";
                return Err(Invalid::new("eccentricity", message).beside("radius"));
            }
            let profile = Profile::Eccentric { radius, eccentricity };
            Ok(CamShape { profile, loads: None })
        },
    },
];

/// The faces of followers.
pub const FOLLOWERS: &[Choice<Follower>] = &[
    Choice {
        name: "flat",
        meaning: "a flat face, at right angles to the way of the follower",
        parameters: &[],
        build: |_| Ok(Follower::Flat),
    },
    Choice {
        name: "cylinder",
        meaning: "a round face that does not turn, its middle on the line of the way of the follower",
        parameters: &[Parameter::required("radius", Quantity::Length, "radius of the face")],
        build: |values| Ok(Follower::Round(values.require("radius")?)),
    },
];

/// Rows of the angle (rad) and a column; `None` where there is no such column.
fn rows(values: &Values, name: &str) -> Result<Option<Vec<[f64; 2]>>, Invalid> {
    let columns = values.table("file").unwrap_or_default();
    let column =
        |name: &str| columns.iter().find(|(known, _)| known == name).map(|(_, values)| values);
    if let Some((other, _)) =
        columns.iter().find(|(name, _)| !["angle", "lift", "load"].contains(&&**name))
    {
        let message =
            format!("the column `{other}` is not known: angle_deg, lift_mm and load_N are");
        return Err(Invalid::new("file", message));
    }
    let Some(angles) = column("angle") else {
        let message = "the column `angle` is missing: angle_deg and lift_mm";
        return Err(Invalid::new("file", message));
    };
    let both = column(name).map(|values| angles.iter().zip(values));
    Ok(both.map(|both| both.map(|(angle, value)| [*angle, *value]).collect()))
}

/// How a cam runs.
#[derive(Debug, Clone, PartialEq)]
pub struct CamDrive {
    /// Width (m) of the contact.
    pub width: f64,
    /// What presses them together; `None` where the table of the lift has it.
    pub loading: Option<Loading>,
    /// Turns of the cam; `None` where they are not given.
    pub turns: Option<f64>,
}

/// The motion of cams.
pub const CAM: &[Choice<CamDrive>] = &[Choice {
    name: "cam",
    meaning: "a cam turns on its follower, which moves along a line through the axis of the cam",
    parameters: &[
        Parameter::required("width", Quantity::Length, "width of the contact"),
        Parameter::optional(
            "preload",
            Quantity::Force,
            "force on the follower, along its way, at no lift",
        ),
        Parameter::optional(
            "spring",
            Quantity::Measured { name: "a stiffness", unit: "N/m" },
            "stiffness of the spring that presses the follower on the cam",
        ),
        Parameter::optional(
            "mass",
            Quantity::Measured { name: "a mass", unit: "kg" },
            "mass of the follower and of what moves with it: its inertia adds to the load",
        ),
        Parameter::optional("frequency", Quantity::Frequency, "turns in a time, for the inertia"),
        Parameter::optional("turns", Quantity::Number, "turns of the cam").bound(Bound::Positive),
    ],
    build: |values| {
        let [preload, spring, mass, frequency] =
            ["preload", "spring", "mass", "frequency"].map(|name| values.number(name));
        for (name, own, other, beside) in
            [("frequency", mass, frequency, "mass"), ("mass", frequency, mass, "frequency")]
        {
            if own.is_some() && other.is_none() {
                let message =
                    format!("`{beside}` counts for nothing without it: inertia needs both");
                return Err(Invalid::new(name, message).beside(beside));
            }
        }
        let given = preload.or(spring).or(mass).is_some();
        let loading = given.then(|| Loading::Spring {
            preload: preload.unwrap_or(0.0),
            stiffness: spring.unwrap_or(0.0),
            mass: mass.unwrap_or(0.0),
            speed: TAU * frequency.unwrap_or(0.0),
        });
        Ok(CamDrive { width: values.require("width")?, loading, turns: values.number("turns") })
    },
}];
