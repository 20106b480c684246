//! Axes that bodies turn about, from which follows how they creep over a curved or tilted contact.
//!
//! A place y across the direction of rolling is `R + y sin t -+ z cos t` from the axis of a body: R the distance of the middle of the
//! contact, t the tilt of the axis, z = K y^2/2 how far the surface between both bodies rises towards body 1, K half of the difference of their
//! curvatures. Bodies that roll in the middle creep elsewhere by what their speeds differ by:
//!
//! ```text
//! c(y) = y (sin t1/R1 - sin t2/R2) - K y^2/2 (cos t1/R1 + cos t2/R2)
//! ```
//!
//! the first a spin, the second a bow (H. L. Heathcote, *Proc. Inst. Automobile Engineers* 15 (1921) 569; K. L. Johnson, *Contact
//! Mechanics*, section 8.5).

use super::Drives;
use crate::parameters::{Bound, Invalid, Parameter, Quantity, Values};

/// The axis that a body turns about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Its distance (m) from the middle of the contact; negative where it lies on the side of the other body, as that of an outer race.
    pub radius: f64,
    /// Its tilt (rad) from the plane of contact: positive where places farther along y are farther from it, a right angle where it is normal.
    pub tilt: f64,
}

const OF_AXES: &[Parameter] = &[
    Parameter::required(
        "radius",
        Quantity::Length,
        "distance of the axis from the middle of the contact, negative of an outer race",
    )
    .bound(Bound::Any),
    Parameter::optional(
        "angle",
        Quantity::Angle,
        "tilt of the axis from the plane of contact, positive where places farther along y are farther from it; 0 if not given",
    )
    .bound(Bound::Any),
];

/// The axis of body 1.
pub(super) const AXIS_ONE: Parameter = Parameter::optional(
    "axis_one",
    Quantity::Section(OF_AXES),
    "axis that body 1 turns about: with that of body 2 the creepage differs over the contact as the shapes say",
);
/// The axis of body 2.
pub(super) const AXIS_TWO: Parameter =
    Parameter::optional("axis_two", Quantity::Section(OF_AXES), "axis that body 2 turns about");

/// The axes that are given; `None` where neither is.
pub(super) fn read(values: &Values) -> Result<Option<[Axis; 2]>, Invalid> {
    let axis = |name: &'static str| -> Result<Option<Axis>, Invalid> {
        let Some(section) = values.section(name) else { return Ok(None) };
        let (radius, tilt) = (section.require("radius")?, section.number("angle").unwrap_or(0.0));
        if radius == 0.0 {
            return Err(Invalid::new(name, "the axis lies in the contact: give its distance"));
        }
        Ok(Some(Axis { radius, tilt }))
    };
    match (axis("axis_one")?, axis("axis_two")?) {
        (None, None) => Ok(None),
        (Some(one), Some(two)) if values.number("spin").is_none() => Ok(Some([one, two])),
        (Some(_), Some(_)) => {
            let message = "follows from the axes: give these or the spin";
            Err(Invalid::new("spin", message).beside("axis_one"))
        }
        (one, _) => {
            let (given, missing) =
                if one.is_some() { ("axis_one", "axis_two") } else { ("axis_two", "axis_one") };
            let message = format!("the axis of the other body is missing: `{missing}`");
            Err(Invalid::new(given, message))
        }
    }
}

impl Drives {
    /// Those of bodies of such curvatures (1/m) across the direction of rolling, convex positive.
    pub(super) fn about_axes(self, curvatures: [f64; 2]) -> Self {
        let Some([one, two]) = self.axes else { return self };
        let between = 0.5 * (curvatures[0] - curvatures[1]);
        let spin = one.tilt.sin() / one.radius - two.tilt.sin() / two.radius;
        let bow = -0.5 * between * (one.tilt.cos() / one.radius + two.tilt.cos() / two.radius);
        Self { spin, bow, ..self }
    }
}
