//! Limits of a wheel in service, `until` of a case: any of them ends its life.

use archard::parameters::{Parameter, Quantity, Values};
use archard_rail::wear::{ASKED, CONICITY, Limit};

/// What limits a wheel may have.
pub const LIMITS: &[Parameter] = &[
    Parameter::optional(
        "standard",
        Quantity::Word(&["EN 15313"]),
        "limits of the flange by the diameter of the wheel, those that are not given",
    ),
    Parameter::optional("flange_thickness", Quantity::Length, "least thickness Sd"),
    Parameter::optional("flange_height", Quantity::Length, "largest height Sh"),
    Parameter::optional("flange_gradient", Quantity::Length, "least gradient qR"),
    Parameter::optional("tread_depth", Quantity::Length, "largest depth at the datum of the tread"),
    Parameter::optional("wheel_depth", Quantity::Length, "largest depth of the wheel"),
    Parameter::optional("turning_depth", Quantity::Length, "largest loss of radius by turning"),
    Parameter::optional("crack_damage", Quantity::Number, "largest damage of the wheel by cracks"),
    Parameter::optional(CONICITY, Quantity::Number, "largest equivalent conicity at 3 mm"),
];

/// The columns of these, and whether a wheel is worn below them.
const COLUMNS: [(&str, &str, bool); 8] = [
    ("flange_thickness", "flange_thickness_m", true),
    ("flange_height", "flange_height_m", false),
    ("flange_gradient", "flange_gradient_m", true),
    ("tread_depth", "tread_depth_m", false),
    ("wheel_depth", "wheel_depth_m", false),
    ("turning_depth", "turning_depth_m", false),
    ("crack_damage", ASKED[0], false),
    (CONICITY, CONICITY, false),
];

/// The limits that are given, and those of the standard for a wheel of that radius (m).
pub(super) fn limits(values: &Values, radius: f64) -> Vec<Limit> {
    let given = |(key, column, below): &(&str, &'static str, bool)| {
        values.number(key).map(|value| Limit { column, value, below: *below })
    };
    let mut limits: Vec<Limit> = COLUMNS.iter().filter_map(given).collect();
    if values.word("standard").is_some() {
        let standard = Limit::in_service(2.0 * radius).into_iter();
        let missing = standard.filter(|one| !limits.iter().any(|own| own.column == one.column));
        limits.extend(missing.collect::<Vec<_>>());
    }
    limits
}
