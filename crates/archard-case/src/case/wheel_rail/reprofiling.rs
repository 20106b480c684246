//! How a wheel is turned again, `reprofiling` of a case.

use archard::parameters::{Bound, Invalid, Parameter, Quantity, Values};
use archard_rail::wear::Turning;

/// What a lathe leaves.
pub const REPROFILING: &[Parameter] = &[
    Parameter::optional("last_radius", Quantity::Length, "radius down to which the wheel runs"),
    Parameter::optional(
        "allowance",
        Quantity::Length,
        "what is turned off below the deepest wear; nothing if not given",
    )
    .bound(Bound::NonNegative),
];

/// What is given for a wheel of that radius (m); `None` where nobody asks for it.
pub(super) fn turning(values: &Values, radius: f64) -> Result<Option<Turning>, Invalid> {
    let allowance = values.number("allowance");
    let Some(last_radius) = values.number("last_radius") else {
        return match allowance {
            None => Ok(None),
            Some(_) => Err(Invalid::new(
                "last_radius",
                "is missing: the radius down to which the wheel runs",
            )),
        };
    };
    if last_radius >= radius {
        let message = format!(
            "{:.1} mm is not below the radius of the new wheel, {:.1} mm",
            1e3 * last_radius,
            1e3 * radius
        );
        return Err(Invalid::new("last_radius", message));
    }
    Ok(Some(Turning { radius, last_radius, allowance: allowance.unwrap_or(0.0) }))
}
