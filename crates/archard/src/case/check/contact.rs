//! The contact a closed form expects, before and after wear.

use super::Parts;
use crate::closed_form::hertz::{Hertz, Line};
use crate::closed_form::pin_on_disc;
use crate::motion::Control;
use crate::wear::Rubbing;

/// The contact of the unworn bodies under the full load, after Hertz.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Half of its extent along x and y (m); infinite along the line where cylinders touch.
    pub semi_axes: [f64; 2],
    /// Pressure at its centre (Pa).
    pub peak_pressure: f64,
    /// Approach of the bodies (m); none for a line contact.
    pub approach: Option<f64>,
    /// Normal force (N).
    pub load: f64,
}

/// What the geometric model of the pin on disc expects at the end of the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worn {
    /// Volume worn off both bodies (m^3).
    pub volume: f64,
    /// Total wear depth (m).
    pub depth: f64,
    /// Half of the scar's extent along x and y (m).
    pub semi_axes: [f64; 2],
}

impl Contact {
    /// The contact of the parts; `None` where there is no closed form.
    pub(super) fn of(parts: &Parts<'_>) -> Option<Self> {
        Self::under(parts, parts.schedule.control)
    }

    /// The same under another load or approach.
    pub(super) fn under(parts: &Parts<'_>, control: Control) -> Option<Self> {
        let curvatures = parts.curvatures()?;
        let modulus = parts.contact_modulus();
        let hertz = match control {
            Control::Load(load) => Hertz::from_load(curvatures, modulus, load),
            Control::Approach(approach) => Hertz::from_approach(curvatures, modulus, approach),
        };
        hertz.map(Self::from_hertz).or_else(|| Self::line(parts, control, curvatures, modulus))
    }

    fn from_hertz(hertz: Hertz) -> Self {
        let Hertz { semi_axes, peak_pressure, approach, load } = hertz;
        Self { semi_axes, peak_pressure, approach: Some(approach), load }
    }

    /// Cylinders that touch along a line as long as the frame.
    fn line(
        parts: &Parts<'_>,
        control: Control,
        curvatures: [f64; 2],
        modulus: f64,
    ) -> Option<Self> {
        let Control::Load(load) = control else { return None };
        let across = match curvatures {
            [x, 0.0] if x > 0.0 => 0,
            [0.0, y] if y > 0.0 => 1,
            _ => return None,
        };
        let length = parts.case.frame.size[1 - across];
        let line = Line::from_load(curvatures[across], modulus, load / length)?;
        let mut semi_axes = [f64::INFINITY; 2];
        semi_axes[across] = line.half_width;
        Some(Self { semi_axes, peak_pressure: line.peak_pressure, approach: None, load })
    }
}

impl Worn {
    /// The scar at the end; `None` without wear or without a closed form for it.
    ///
    /// The cap cut off an elliptic paraboloid has the volume of one cut off a sphere of radius
    /// sqrt(Rx Ry).
    pub(super) fn of(parts: &Parts<'_>, contact: &Contact) -> Option<Self> {
        let slip = parts.slip();
        let steady = matches!(parts.schedule.control, Control::Load(_)) && !parts.schedule.ramped;
        let curvatures =
            parts.curvatures().filter(|curvatures| curvatures.iter().all(|&c| c > 0.0))?;
        let coefficient = coefficient(parts, contact.peak_pressure);
        if !steady || slip == 0.0 || coefficient == 0.0 {
            return None;
        }
        let radius = 1.0 / (curvatures[0] * curvatures[1]).sqrt();
        let volume = coefficient * contact.load * slip;
        let depth = pin_on_disc::depth(radius, volume);
        let semi_axes = curvatures.map(|curvature| (2.0 * depth / curvature).sqrt());
        Some(Self { volume, depth, semi_axes })
    }
}

/// Depth worn off both bodies per pressure and distance slid (1/Pa), at that pressure (Pa).
pub(super) fn coefficient(parts: &Parts<'_>, pressure: f64) -> f64 {
    let mu = parts.friction_coefficient(pressure);
    let rubbing = Rubbing::new(pressure, 1.0).with_friction(mu * pressure, mu);
    parts.wear.iter().flatten().map(|law| law.slope(rubbing)).sum()
}
