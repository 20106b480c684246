//! Cases of contact and wear, as people write them in files, and what comes of them.
//!
//! A [`CaseFile`] is read, checked and built to a [`Simulation`](archard::Simulation), or to an
//! [`ElasticBody`](archard::elastic::ElasticBody) where it has one body and no contact. The [observer](archard::simulation::Observer)
//! [`output::ResultFolder`] writes its results, the [`verdict`] says what can be believed of them.
//!
//! # From its text
//!
//! ```
//! use archard_case::CaseFile;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let text = r#"
//!     [body.pin]
//!     material = { young = "210 GPa", poisson = 0.3 }
//!     profile.sphere = { radius = "50 mm" }
//!     wear.archard = { coefficient = "1.33e-13 1/Pa" }
//!     [body.disc]
//!     material = { young = "210 GPa", poisson = 0.3 }
//!     profile.flat = {}
//!     [frame]
//!     size = ["1.2 mm", "1.2 mm"]
//!     elements = [30, 30]
//!     [motion.sliding]
//!     load = "10.2 N"
//!     distance = "500 mm"
//!     step = "5 mm"
//! "#;
//! let resolved = CaseFile::from_text("pin on disc", text, ".").resolve().map_err(|_| "mistakes")?;
//! assert_eq!(resolved.case.build()?.run(&mut [])?.steps, 100);
//! # Ok(())
//! # }
//! ```
//!
//!
//! Units are known here and nowhere below: what comes out of a case is in SI.

mod case;
pub mod files;
pub mod measured;
pub mod output;
pub mod verdict;

pub use case::*;
