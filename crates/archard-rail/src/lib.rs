//! Where a wheel touches its rail.
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
