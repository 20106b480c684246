//! A motion carried through: contact and wear step after step.

mod adaptive;
mod advance;
mod builder;
mod checkpoint;
mod collector;
mod companion;
mod contact;
mod cycles;
mod derivative;
mod digest;
mod effort;
mod error;
pub mod fitted;
mod free;
mod friction;
pub mod history;
mod march;
mod memory;
mod moving;
mod passing;
mod periodic;
mod placed;
mod position;
mod positions;
mod recurring;
pub mod refusal;
mod report;
mod rolling;
mod run;
mod scar;
mod second_order;
mod setup;
mod shift;
mod spread;
mod stations;
mod steps;
mod surroundings;
mod swing;
mod touch;
mod trial;
mod turning;
mod wearing;
mod whole;
mod wider;
mod worn;

pub use builder::{Builder, line_of_contact};
#[doc(hidden)]
pub use companion::{Companion, Companions, Regularity};
pub use contact::Contact;
pub use derivative::Derivative;
#[doc(hidden)]
pub use digest::digest;
pub use effort::Effort;
pub use error::{Error, ResumeError};
pub use history::row;
#[doc(hidden)]
pub use march::March;
pub use passing::WornLine;
#[doc(hidden)]
pub use periodic::repeats;
#[doc(hidden)]
pub use positions::solves_of_a_step;
pub use refusal::Refusals;
#[doc(hidden)]
pub use report::Kept;
pub use report::{Observer, Report};
pub use run::Run;
pub use scar::{worn_extent, worn_middle, worn_profile};
pub use setup::Simulation;
#[doc(hidden)]
pub use swing::offsets;
#[doc(hidden)]
pub use wider::{Wider, can_widen};
