//! The scar of bodies that slide over each other.

use super::{Course, Subject};
use crate::closed_form::pin_on_disc;
use crate::motion::Lever;

/// The scar that the geometric model of the pin on disc expects.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WornCap {
    /// Radius (m) of the sphere whose cap is worn off.
    pub radius: f64,
    /// The k of both bodies together (1/Pa).
    pub coefficient: f64,
    /// Volume worn off both bodies (m^3).
    pub volume: f64,
    /// Total wear depth (m).
    pub depth: f64,
    /// Half of the scar's extent along x and y (m).
    pub semi_axes: [f64; 2],
}

impl WornCap {
    /// The scar so far; `None` unless bodies that are convex along both axes slide, stay opposite each other and wear.
    ///
    /// The cap cut off an elliptic paraboloid has the volume of one cut off a sphere of radius
    /// sqrt(Rx Ry).
    pub(super) fn of(subject: &Subject<'_>, course: &Course) -> Option<Self> {
        let curvatures = subject.curvatures().filter(|both| both.iter().all(|&one| one > 0.0))?;
        let coefficient = subject.total_wear_coefficient()?;
        if subject.motion.lever_arm() != Some(Lever::Even) || !subject.motion.stays() {
            return None;
        }
        let radius = 1.0 / (curvatures[0] * curvatures[1]).sqrt();
        let volume = coefficient * course.load_distance?;
        let depth = pin_on_disc::depth(radius, volume);
        let semi_axes = curvatures.map(|curvature| (2.0 * depth / curvature).sqrt());
        Some(Self { radius, coefficient, volume, depth, semi_axes })
    }
}
