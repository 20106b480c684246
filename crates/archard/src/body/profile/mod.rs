//! The shape of a body's surface near the contact.
//!
//! A profile gives the *recess*: how far the surface lies below the plane through its highest
//! region, measured along the normal into the body. The recesses of the two bodies add up to the
//! geometric gap. A new profile is one file here and one line in [`PROFILES`].

mod axisymmetric_power;
mod cylinder;
mod disc;
mod fitted;
mod flat;
mod flat_end;
mod paraboloid;
mod power;
mod self_affine;
mod sphere;
mod table;
mod wave;

use std::fmt::Debug;

pub use axisymmetric_power::AxisymmetricPower;
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use fitted::{ClearanceFit, Round};
pub use flat::Flat;
pub use flat_end::FlatEnd;
pub use paraboloid::Paraboloid;
pub use power::Power;
pub use self_affine::{Roughness, SelfAffine};
pub use sphere::Sphere;
pub use table::Table;
pub use wave::Wave;

use crate::parameters::Choice;

/// The shape of a surface as its recess below the plane of contact.
pub trait Profile: Debug + Send + Sync {
    /// Recess (m), positive into the body, at x and y (m) from the frame's centre.
    ///
    /// Not a number where the surface does not reach.
    fn recess(&self, x: f64, y: f64) -> f64;

    /// Where the surface is known, whatever the place along the other axis: the least and the largest place along x, and
    /// along y (m).
    fn extent(&self) -> [[f64; 2]; 2] {
        [[f64::NEG_INFINITY, f64::INFINITY]; 2]
    }

    /// Places along x and y (m) at which the shape was measured, rising; none along an axis where a formula gives it.
    fn places(&self) -> [&[f64]; 2] {
        [&[]; 2]
    }

    /// The power of the distance by which the surface recedes where it is sharpest: 2 where it is round, 1 at the tip of a
    /// cone, 0 at an edge. From 1 on downwards the unworn pressure has no bound there.
    fn sharpest(&self) -> f64 {
        2.0
    }

    /// Curvatures (1/m) along x and y at the centre, where the shape is smooth and has them;
    /// estimates before a run use them.
    fn curvatures(&self) -> Option<[f64; 2]> {
        None
    }

    /// What the surface is of a body that fits into another one, so that the frame is drawn on it; `None` of others.
    fn fitted(&self) -> Option<ClearanceFit> {
        None
    }
}

/// The profiles a case can name.
pub const PROFILES: &[Choice<Box<dyn Profile>>] = &[
    sphere::CHOICE,
    paraboloid::CHOICE,
    cylinder::CHOICE,
    disc::CHOICE,
    fitted::BALL,
    fitted::SOCKET,
    fitted::SHAFT,
    fitted::BUSH,
    flat::CHOICE,
    flat_end::CHOICE,
    power::CHOICE,
    axisymmetric_power::CHOICE,
    table::CHOICE,
    wave::CHOICE,
    self_affine::CHOICE,
];

/// Recess (m) of a circle of that radius (m), negative where it is hollow, at a distance (m) from its apex, without cancellation;
/// not a number beyond the circle.
pub fn circle_recess(radius: f64, distance: f64) -> f64 {
    let square = distance * distance;
    square / (radius + (radius * radius - square).sqrt().copysign(radius))
}
