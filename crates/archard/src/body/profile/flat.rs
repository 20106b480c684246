//! The plane.

use super::Profile;
use crate::parameters::Choice;

pub(super) const CHOICE: Choice<Box<dyn Profile>> =
    Choice { name: "flat", meaning: "a plane", parameters: &[], build: |_| Ok(Box::new(Flat)) };

/// recess = 0.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Flat;

impl Profile for Flat {
    fn recess(&self, _x: f64, _y: f64) -> f64 {
        0.0
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some([0.0; 2])
    }
}
