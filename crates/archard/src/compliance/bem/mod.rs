//! A finite body by boundary elements: its surface is divided into elements, and Kelvin's solution says how
//! tractions and displacements on them belong together.

mod alone;
mod assemble;
mod balance;
mod blocks;
mod conditions;
pub mod contact;
mod curvature;
pub mod element;
pub mod image;
mod integrate;
mod interior;
mod kelvin;
mod loads;
mod making;
mod patch;
mod rigid;
mod rules;
mod size;
mod solid;
mod strip;
mod surface;

pub use alone::{evaluate_alone, integrate_alone};
pub use balance::{Balance, forces};
pub use conditions::{AxisCondition, Condition, Conditions, Indeterminacy, basis_of};
pub use interior::{Interior, Response};
pub use kelvin::Evaluations;
pub use making::{Listener, Stage, StageProgress};
pub use patch::distance;
pub(crate) use rigid::left_free;
pub use size::{Size, memory};
pub use solid::advice;
pub use solid::{AssembledBody, Boundary, CondensedBody, Responses, Solid};
pub use surface::{Surface, TractionNode};

#[cfg(test)]
mod tests;
