//! A contact problem: the choices composed, and what is known at the end of a step.

use crate::body::Body;
use crate::compliance::Compliance;
use crate::frame::ContactFrame;
use crate::kinematics::Kinematics;
use crate::wear::Rubbing;

/// Two bodies, where they may touch, how they deform there and how they move.
#[derive(Debug)]
pub struct ContactProblem {
    /// The bodies; body 1 first.
    pub bodies: [Body; 2],
    /// The pairs that may touch.
    pub frame: ContactFrame,
    /// How both bodies deform, seen from the frame.
    pub compliance: Box<dyn Compliance>,
    /// How the pairs rub.
    pub kinematics: Box<dyn Kinematics>,
}

impl ContactProblem {
    /// Whether any body wears.
    pub fn wears(&self) -> bool {
        self.bodies.iter().any(|body| body.wear.is_some())
    }

    /// Depths (m) the rubbing wears off body 1 and body 2.
    pub fn wear_depths(&self, rubbing: Rubbing) -> [f64; 2] {
        self.bodies.each_ref().map(|body| body.wear.as_ref().map_or(0.0, |law| law.depth(rubbing)))
    }

    /// Slope (m/Pa) of the total wear depth with respect to the pressure.
    pub fn wear_slope(&self, rubbing: Rubbing) -> f64 {
        self.bodies.iter().filter_map(|body| body.wear.as_ref()).map(|law| law.slope(rubbing)).sum()
    }
}

/// What is known of the contact at the end of a step.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactState {
    /// How far the motion has gone (its own unit).
    pub progress: f64,
    /// Approach of the bodies from first touch (m).
    pub approach: f64,
    /// Normal force (N).
    pub load: f64,
    /// Pressure (Pa), one value a pair.
    pub pressure: Vec<f64>,
    /// Normal gap (m), one value a pair; zero in contact.
    pub gap: Vec<f64>,
    /// Depth worn off body 1 and body 2 (m), one value a pair.
    pub worn: [Vec<f64>; 2],
}

impl ContactState {
    /// Bodies of that many pairs, apart and unworn.
    pub fn untouched(gap: &[f64]) -> Self {
        Self {
            progress: 0.0,
            approach: 0.0,
            load: 0.0,
            pressure: vec![0.0; gap.len()],
            gap: gap.to_vec(),
            worn: [vec![0.0; gap.len()], vec![0.0; gap.len()]],
        }
    }

    /// Total wear depth (m), one value a pair.
    pub fn total_worn(&self) -> Vec<f64> {
        self.worn[0].iter().zip(&self.worn[1]).map(|(a, b)| a + b).collect()
    }

    /// Number of pairs under pressure.
    pub fn pairs_in_contact(&self) -> usize {
        self.pressure.iter().filter(|&&pressure| pressure > 0.0).count()
    }
}
