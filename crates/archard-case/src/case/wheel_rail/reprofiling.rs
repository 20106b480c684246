//! How a wheel is turned again, `reprofiling` of a case.

use archard::parameters::{Bound, Invalid, Parameter, Quantity, Values};
use archard_rail::wear::{Reprofiling, Thicknesses};

/// What a lathe leaves.
pub const REPROFILING: &[Parameter] = &[
    Parameter::optional("last_radius", Quantity::Length, "radius down to which the wheel runs"),
    Parameter::optional(
        "allowance",
        Quantity::Length,
        "what is turned off below the deepest wear; nothing if not given",
    )
    .bound(Bound::NonNegative),
    Parameter::optional(
        "thinnest_flange",
        Quantity::Length,
        "least thickness of the flange that a lathe turns; always the whole flange if not given",
    ),
    Parameter::optional(
        "flange_step",
        Quantity::Length,
        "how much the next flange is thinner that a lathe turns; 0.5 mm, as of EN 13715, if not given",
    ),
];

/// Most thicknesses besides that of the new flange: each is looked at after each step.
const MOST: usize = 40;

/// The thicknesses that a flange of that thickness (m) is turned to, which is worn below another (m); `None` where nobody asks for it.
pub(super) fn thicknesses(
    values: &Values,
    new: Option<f64>,
    least: Option<f64>,
) -> Result<Option<Thicknesses>, Invalid> {
    let step = values.number("flange_step");
    let Some(thinnest) = values.number("thinnest_flange") else {
        return match step {
            None => Ok(None),
            Some(_) => {
                Err(Invalid::new("thinnest_flange", "is missing: `flange_step` goes down to it"))
            }
        };
    };
    let wrong = |message: String| Err(Invalid::new("thinnest_flange", message));
    let Some(new) = new else {
        return wrong("the wheel has no flange, or no tread at y = 0".to_owned());
    };
    if values.number("last_radius").is_none() {
        return Err(Invalid::new(
            "last_radius",
            "is missing: the radius down to which the wheel runs",
        ));
    }
    let (step, least) = (step.unwrap_or(0.5e-3), least.unwrap_or(0.0));
    let between = format!(
        "{:.2} mm has to lie between the {:.2} mm at which the flange is worn and the {:.2} mm of the new one",
        1e3 * thinnest,
        1e3 * least,
        1e3 * new
    );
    if !(least < thinnest && thinnest < new) {
        return wrong(between);
    }
    // Thicknesses of a drawing are told to hundredths.
    let thinner = ((new - thinnest) / step + 0.01).floor();
    if !(1.0..=MOST as f64).contains(&thinner) {
        let message =
            format!("{:.3} mm makes {thinner} thicknesses: 1 to {MOST} may be", 1e3 * step);
        return Err(Invalid::new("flange_step", message));
    }
    Ok(Some(Thicknesses { new, step, thinner: thinner as usize, least }))
}

/// What is given for a wheel of that radius (m); `None` where nobody asks for it.
pub(super) fn turning(values: &Values, radius: f64) -> Result<Option<Reprofiling>, Invalid> {
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
    Ok(Some(Reprofiling { radius, last_radius, allowance: allowance.unwrap_or(0.0) }))
}
