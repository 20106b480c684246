//! Bodies that slide on a track: the scar on the one that stays, the groove in the one that passes.

use super::{Course, Subject};
use crate::closed_form::worn_track::{WornTrack, worn};

/// Both bodies, as they wear without elasticity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OnTrack {
    /// Scar and groove.
    pub worn: WornTrack,
    /// Volumes worn off body 1 and body 2 (m^3): k F s.
    pub volumes: [f64; 2],
    /// Section of the groove (m^2).
    pub section: f64,
    /// Along the track: 0 for x, 1 for y.
    pub axis: usize,
}

impl OnTrack {
    /// So far; `None` without a track, or where the bodies are not convex against each other along both axes.
    pub(super) fn of(subject: &Subject<'_>, course: &Course) -> Option<Self> {
        let track = subject.motion.track()?;
        let curvatures = subject.curvatures().filter(|both| both.iter().all(|&one| one > 0.0))?;
        let coefficient = |body: usize| match &subject.bodies[body].wear {
            Some(_) => subject.wear_coefficient(body),
            None => Some(0.0),
        };
        let coefficients = [coefficient(0)?, coefficient(1)?];
        let load_distance = course.load_distance.filter(|&worked| worked > 0.0)?;
        let axis = subject.motion.direction.axis;
        let both = [coefficients[1 - track.body], coefficients[track.body]];
        if both == [0.0; 2] {
            return None;
        }
        let worn =
            worn([curvatures[axis], curvatures[1 - axis]], both, track.length, load_distance);
        let volumes = coefficients.map(|k| k * load_distance);
        Some(Self { worn, volumes, section: volumes[track.body] / track.length, axis })
    }

    /// Half of the extent (m) of the worn contact along x and y.
    pub fn semi_axes(&self) -> [f64; 2] {
        [0, 1].map(|axis| 0.5 * self.worn.extent[usize::from(axis != self.axis)])
    }
}
