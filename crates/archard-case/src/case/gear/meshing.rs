//! How two gears mesh, as a case says.

use archard::parameters::{Bound, Choice, Invalid, Parameter, Quantity, Values};
use archard_gear::{Pair, Sharing};

/// How two gears mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct GearMesh {
    /// Distance (m) of the axes.
    pub centre_distance: f64,
    /// Width (m) of the teeth that touch.
    pub width: f64,
    /// Torque (N m) on the first gear.
    pub torque: f64,
    /// How pairs of teeth share the load.
    pub sharing: Sharing,
    /// Meshes of a flank of the first gear; `None` where they are not given.
    pub meshes: Option<f64>,
    /// Whether these are turns of the first gear, rather than meshes of any flank: the other gear makes fewer or more.
    pub turns: bool,
}

const MESHES: Parameter =
    Parameter::optional("meshes", Quantity::Number, "meshes of each flank, of both gears");
const TURNS: Parameter = Parameter::optional(
    "turns",
    Quantity::Number,
    "turns of the first gear, instead of the meshes: a mesh of each of its flanks",
);
const STIFFNESS: Parameter = Parameter::optional(
    "stiffness",
    Quantity::Measured { name: "a stiffness over the width", unit: "N/m^2" },
    "of one pair of teeth along the path: pairs share the load as springs, and wear shifts it; without it, by thirds",
);
const SHARE: Parameter = Parameter::optional(
    "share",
    Quantity::Table(&[("path", Quantity::Length), ("share", Quantity::Number)]),
    "CSV with columns path_mm and share, instead: the share of the load over the distance from T1, as `archard check` prints it",
);

/// The motion of gears.
pub const MESH: &[Choice<GearMesh>] = &[Choice {
    name: "mesh",
    meaning: "the flanks of two spur gears go through meshes",
    parameters: &[
        Parameter::required("centre_distance", Quantity::Length, "distance of the axes"),
        Parameter::required("width", Quantity::Length, "width of the teeth that touch"),
        Parameter::required(
            "torque",
            Quantity::Measured { name: "a torque", unit: "N m" },
            "torque on the first gear",
        )
        .bound(Bound::Positive),
        STIFFNESS,
        SHARE,
        MESHES,
        TURNS,
    ],
    build: |values| {
        let (meshes, turns) = match (values.number("meshes"), values.number("turns")) {
            (Some(_), Some(_)) => {
                let message = "are the meshes of the flanks: give one of both";
                return Err(Invalid::new("turns", message).beside("meshes"));
            }
            (meshes, turns) => (meshes.or(turns), turns.is_some()),
        };
        Ok(GearMesh {
            centre_distance: values.require("centre_distance")?,
            width: values.require("width")?,
            torque: values.require("torque")?,
            sharing: sharing(values)?,
            meshes,
            turns,
        })
    },
}];

fn sharing(values: &Values) -> Result<Sharing, Invalid> {
    let Some(columns) = values.table("share") else {
        return Ok(values.number("stiffness").map_or(Sharing::Thirds, Sharing::Springs));
    };
    if values.number("stiffness").is_some() {
        let message = "says how the load is shared: give this or the `stiffness`";
        return Err(Invalid::new("share", message).beside("stiffness"));
    }
    let column = |name: &str| {
        let found = columns.iter().find(|(known, _)| known == name);
        found.map(|(_, values)| values).ok_or_else(|| {
            Invalid::new("share", format!("the column `{name}` is missing: path_mm and share"))
        })
    };
    let rows = column("path")?.iter().zip(column("share")?);
    Sharing::table(rows.map(|(place, share)| [*place, *share]).collect())
}

impl GearMesh {
    /// Meshes of a flank of the second gear for one of the first.
    pub(super) fn of_gear_two(&self, pair: &Pair) -> f64 {
        let [one, two] = pair.gears;
        if self.turns { one.teeth / two.teeth } else { 1.0 }
    }
}
