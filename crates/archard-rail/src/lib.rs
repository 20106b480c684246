//! Where a railway wheel touches its rail, and how it creeps there.
//!
//! [`contact`](contact::contact) is the whole of it: a wheel under its load, and pressures and friction of each patch. The
//! parts that it is made of can be used alone. Everything is in SI units.
//!
//! ```
//! use std::sync::Arc;
//!
//! use archard::{Material, friction::Coulomb};
//! use archard_rail::contact::{Bodies, Operation, Resolution, contact};
//! use archard_rail::curve::Smoothing;
//! use archard_rail::setup::{Attitude, Setup, Track, Velocity, Wheelset};
//! use archard_rail::standard::{rail_60e1, wheel_s1002};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let rail = rail_60e1(0.2e-3)?.curve(Smoothing::NONE)?;
//! let wheel = wheel_s1002(0.2e-3)?.curve(Smoothing::NONE)?;
//! let wheelset =
//!     Wheelset { flange_back_distance: 1.36, flange_back_position: -0.07, nominal_radius: 0.46 };
//! let setup = Setup::new(Track::standard(), &rail, wheelset, &wheel)?;
//!
//! let steel = Material::new(210e9, 0.28)?;
//! let friction = Arc::new(Coulomb::new(0.3)?);
//! let bodies = Bodies { wheel: steel, rail: steel, thermal: [None, None], friction, flange: None, wear: [None, None], flange_wear: None, shear_yield: 800e6 };
//! let operation = Operation {
//!     attitude: Attitude { shift: 3e-3, roll: 0.0, yaw: 7e-3 },
//!     velocity: Velocity { forward: 2.0, pitch: -2.0 / 0.46, ..Velocity::default() },
//!     load: 10e3,
//!     transfer: 0.0,
//!     creepages: Default::default(),
//! };
//! for patch in contact(&setup, &bodies, &operation, &Resolution::default())? {
//!     let (of, error) = (patch.values, patch.errors);
//!     assert!(of.lateral_creepage > 0.0 && of.force_s < 0.0 && error.force_s < 0.01 * of.force_s.abs());
//! }
//! # Ok(())
//! # }
//! ```
//!
//! # The way of a profile
//!
//! [`mod@file`] reads a [`Profile`] and says what looks wrong about it ([`oddity`]); [`standard`] draws one. A [`curve`] goes
//! through its points or smooths them. [`setup`] puts rail and wheel into the track, [`search`] finds the patches of
//! contact, [`creepage`] says how the wheel slides in them, and [`mod@contact`] what that makes of a load.
//!
//! # Coordinates
//!
//! x points forward, y to the field side and z downwards. The material of a profile lies on the right hand of one who
//! walks from point to point: y ascends on a rail and descends on a wheel. The formulas are those of the right side of
//! the track, and the left side is its mirror image ([`setup::Side`]).

#![warn(missing_docs)]

mod bounds;
pub mod conicity;
pub mod contact;
pub mod creepage;
pub mod curve;
pub mod file;
pub mod flange;
pub mod gather;
pub mod oddity;
pub mod profile;
mod roots;
pub mod search;
pub mod setup;
mod sorted;
pub mod standard;
pub mod wear;

pub use archard::parameters::Invalid;
pub use profile::{Part, Profile};
