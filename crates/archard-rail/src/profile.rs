//! The measured or drawn points of the cross-section of a rail or a wheel.
//!
//! The points are in metres, y to the field side and z downwards. They run so that the material lies on the right
//! hand: y ascends on a rail and descends on a wheel.

use crate::curve::{Curve, Smoothing};
use archard::parameters::Invalid;

/// Most points of a profile: searches for loops take a time that grows with their square.
pub const MOST_POINTS: usize = 20_000;

/// Which of the two bodies a profile belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    /// The rail: y ascends from point to point.
    Rail,
    /// The wheel: y descends from point to point.
    Wheel,
}

impl Part {
    /// The sign of the step in y from point to point where the surface faces the other part: 1 or -1.
    pub fn direction(self) -> f64 {
        match self {
            Self::Rail => 1.0,
            Self::Wheel => -1.0,
        }
    }
}

/// The points of a cross-section.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// Points (m): y to the field side, z downwards.
    pub points: Vec<[f64; 2]>,
}

impl Profile {
    /// The profile of those points (m).
    ///
    /// # Errors
    /// If there are fewer than three points, more than [`MOST_POINTS`], or if a coordinate is not finite or lies beyond a
    /// kilometre.
    pub fn new(points: Vec<[f64; 2]>) -> Result<Self, Invalid> {
        if points.len() < 3 {
            let message =
                format!("a profile needs three points or more, and this has {}", points.len());
            return Err(Invalid::new("points", message));
        }
        if points.len() > MOST_POINTS {
            let message =
                format!("{} points are more than {MOST_POINTS}: thin them out", points.len());
            return Err(Invalid::new("points", message));
        }
        match points.iter().position(|point| !point.iter().all(|value| value.abs() < 1e3)) {
            Some(at) => {
                let message =
                    format!("point {} is not finite, or farther than a kilometre", at + 1);
                Err(Invalid::new("points", message))
            }
            None => Ok(Self { points }),
        }
    }

    /// The curve through the points, or near them if it is smoothed.
    ///
    /// # Errors
    /// If the wavelength is negative or not finite, or if fewer than three points are apart.
    pub fn curve(&self, smoothing: Smoothing) -> Result<Curve, Invalid> {
        Curve::new(&self.points, smoothing)
    }

    /// The points in the opposite order.
    #[must_use]
    pub fn reversed(mut self) -> Self {
        self.points.reverse();
        self
    }

    /// Each point with its y times the first and its z times the second factor: -1 mirrors.
    #[must_use]
    pub fn scaled(mut self, factors: [f64; 2]) -> Self {
        for point in &mut self.points {
            *point = [point[0] * factors[0], point[1] * factors[1]];
        }
        self
    }

    /// Each point moved by those distances (m) along y and z.
    #[must_use]
    pub fn shifted(mut self, by: [f64; 2]) -> Self {
        for point in &mut self.points {
            *point = [point[0] + by[0], point[1] + by[1]];
        }
        self
    }
}
