//! Wear coefficients from what was measured.

mod effects;
mod estimate;
mod shape;
mod within;

pub use effects::Effects;
pub use estimate::{Common, Estimate, Model, NoEstimate, Study};
pub use shape::{Exponent, REJECTED};
pub use within::{Expected, Fitted, Reading, Test, Unfitted};

#[cfg(test)]
mod tests;
