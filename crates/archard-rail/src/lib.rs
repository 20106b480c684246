//! Where a railway wheel touches its rail, and how it creeps there.
//!
//! The crate knows shapes and motions, and no forces: a solver of contact takes from it the undeformed gap in the tangent
//! plane of each patch of contact, its frame and its creepages. Everything is in SI units.
//!
//! ```
//! use archard_rail::creepage::Creepage;
//! use archard_rail::curve::Smoothing;
//! use archard_rail::search::{JOIN, Search};
//! use archard_rail::setup::{Attitude, Setup, Track, Velocity, Wheelset};
//! use archard_rail::standard::{rail_60e1, wheel_s1002};
//!
//! # fn main() -> Result<(), archard_rail::Invalid> {
//! let rail = rail_60e1(0.2e-3)?.curve(Smoothing::NONE)?;
//! let wheel = wheel_s1002(0.2e-3)?.curve(Smoothing::NONE)?;
//! let wheelset =
//!     Wheelset { flange_back_distance: 1.36, flange_back_position: -0.07, nominal_radius: 0.46 };
//! let setup = Setup::new(Track::standard(), &rail, wheelset, &wheel)?;
//!
//! let search = Search::new(&setup, Attitude { shift: 3e-3, roll: 0.0, yaw: 7e-3 })?;
//! let onset = search.onset().expect("the wheel stands over the rail");
//! let velocity = Velocity { forward: 2.0, pitch: -2.0 / 0.46, ..Velocity::default() };
//! for patch in search.patches(onset.height + 25e-6, JOIN)? {
//!     let gap = search.gap(&patch).grid(&[-1e-3, 0.0, 1e-3], &[-1e-3, 0.0, 1e-3]);
//!     let creepage = Creepage::new(&search, &patch, &velocity, patch.approach());
//!     assert!(gap[4] < 0.0 && creepage.lateral > 0.0);
//! }
//! # Ok(())
//! # }
//! ```
//!
//! # The way of a profile
//!
//! [`mod@file`] reads a [`Profile`] and tells what looks wrong about it ([`oddity`]); [`standard`] draws one. A [`curve`] goes
//! through its points or smooths them. [`setup`] puts rail and wheel into the track, [`search`] finds the patches of
//! contact, and [`creepage`] says how the wheel slides in them.
//!
//! # Coordinates
//!
//! x points forward, y to the field side and z downwards. The material of a profile lies on the right hand of one who
//! walks from point to point: y ascends on a rail and descends on a wheel. The formulas are those of the right side of
//! the track, and the left side is its mirror image ([`setup::Side`]).

#![warn(missing_docs)]

pub mod creepage;
pub mod curve;
pub mod file;
pub mod invalid;
pub mod oddity;
pub mod profile;
mod roots;
pub mod search;
pub mod setup;
pub mod standard;

pub use invalid::Invalid;
pub use profile::{Part, Profile};
