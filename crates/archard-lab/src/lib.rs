//! Wear coefficients from what was measured.
//!
//! [`fit`] holds a table of tests against runs of a case, [`fit_wheel`] profiles of railway wheels against runs of their route; [`Study::estimate`] is the statistics, for any model that says what
//! readings should be at a k.

mod computed;
mod curve;
mod effects;
mod error;
mod estimate;
mod joint;
mod kept;
mod measurement;
mod more;
mod next;
mod outcome;
mod quantity;
mod report;
mod runs;
mod search;
mod shape;
mod surfaces;
mod untold;
pub mod validate;
mod wheel;
mod within;

pub use effects::Effects;
pub use error::Error;
pub use estimate::{Common, Estimate, Model, NoEstimate, Study};
pub use more::More;
pub use next::{next_test, together};
pub use outcome::{Coefficient, Fit, Shown};
pub use runs::Following;
pub use search::{Request, fit};
pub use shape::{Exponent, NEGLIGIBLE, REJECTED};
pub use surfaces::{Files, Measured, Taken};
pub use untold::Untold;
pub use wheel::fit as fit_wheel;
pub use within::{Expected, Fitted, Reading, Test, Unfitted};

#[cfg(test)]
mod tests;
