//! Contact and wear problems with an answer on paper: for estimates before a run, for curves next to
//! a result, and for tests.
//!
//! Everything takes and gives plain numbers in SI.

pub mod carter;
pub mod cattaneo_mindlin;
pub mod first_yield;
pub mod flash_temperature;
pub mod flat_punch_wear;
pub mod free_rolling;
pub mod fretting_wear;
pub mod hertz;
pub mod kalker;
pub mod pin_on_disc;
pub mod shakedown;
pub mod sliding_line;
pub mod sneddon;
pub mod spence;
pub mod standards;
pub mod strip;
pub mod twin_discs;
pub mod vermeulen_johnson;
pub mod worn_track;

pub use hertz::Hertz;
