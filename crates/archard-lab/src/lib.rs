//! Wear coefficients from what was measured.
//!
//! [`fit`] holds a table of tests against runs of a case, of a railway wheel profiles against runs of its route;
//! [`Study::estimate`] is the statistics, for any model that says what readings should be at a k.

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
pub use outcome::{Coefficient, DrawnCurve, Fit};
pub use runs::RunFollower;
pub use search::Request;
pub use shape::{Exponent, NEGLIGIBLE, REJECTED};
pub use surfaces::{Files, MeasuredFile, ScarReading};
pub use untold::Untold;
pub use within::{Expectation, FittedTest, NoFit, Reading, Test};

use archard_case::measured::Table;
use archard_case::{CaseFile, Task};

/// Fits the wear coefficients of a case to a table of measured tests: of two bodies in contact, or of a wheel on its rail. Of a wheel the
/// table has the columns `test`, `distance`, `file` of the worn profile, and `side` where both sides are computed.
///
/// # Errors
/// If case and table do not go together, a reading cannot be used, a run fails, or the tests do not tell a coefficient.
pub fn fit(file: &CaseFile, table: &Table, request: Request<'_>) -> Result<Fit, Error> {
    match file.task().map_err(|problems| Error::of_case(file, &problems))? {
        Task::Contact(resolved) => search::fit((file, *resolved), table, request),
        Task::WheelRail(resolved) => wheel::fit((file, &resolved.case), table, request),
        Task::Cam(_) | Task::Elastic(_) | Task::Gear(_) => Err(Error::Mismatch(
            "a fit is one of two bodies in contact, which wear, or of a wheel on its rail"
                .to_owned(),
        )),
    }
}

#[cfg(test)]
mod tests;
