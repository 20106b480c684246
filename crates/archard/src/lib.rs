//! Archard predicts how surfaces in contact wear away.
//!
//! Two elastic bodies are pressed together and slide. Archard finds the pressure between them, lets
//! it wear the surfaces by the Holm-Archard law or one of yours, and repeats the two until the motion
//! is over. Boundary elements do the elasticity: nothing but the surfaces near the contact is
//! divided into elements.
//!

pub mod body;
pub mod closed_form;
pub mod compliance;
pub mod frame;
pub mod kinematics;
pub mod numerics;
pub mod output;
pub mod parameters;
pub mod problem;
pub mod simulation;
pub mod solve;
pub mod units;
pub mod wear;

pub use body::Body;
pub use compliance::Compliance;
pub use frame::ContactFrame;
pub use kinematics::Kinematics;
pub use problem::{ContactProblem, ContactState};
pub use simulation::Simulation;
pub use solve::Solver;
pub use wear::WearLaw;
