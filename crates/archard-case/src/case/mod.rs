//! Cases: from the file a user writes to a simulation, with every mistake named where it stands.
//!
//! A [`CaseFile`] is the text as written and the `--set` options laid over it.
//! [`CaseFile::resolve`] reads it against the declarations of the choices (profiles, wear laws,
//! motions, solvers), so that a new choice needs no reader, and checks what can be known before a
//! run. What comes out is a [`Case`] in SI, which prints as a case file and builds a
//! [`Simulation`](archard::simulation::Simulation), and a [`Forecast`] of the run; or all
//! [`Problem`]s at once.
//!
//! A case of one meshed body is an elastic problem without contact: an [`ElasticCase`], which builds an
//! [`ElasticBody`](archard::elastic::ElasticBody). A case with `motion.wheel_rail` is a [`WheelRailCase`]. [`CaseFile::task`]
//! separates them.
//!
//! # Case files
//!
//! TOML. A value with a dimension is a text with its unit (`"50 mm"`). The choice is the name of a
//! table (`profile.sphere = { radius = "50 mm" }`). The body written first is body 1.
//!
//! # Options
//!
//! `KEY=VALUE` puts a value at a dotted key, replacing what is there, tables included. The value is
//! read as TOML, or as plain text where it is not TOML. `KEY=` removes the key: to go from one of
//! two keys that exclude each other to the other, remove the first.

mod accuracy;
mod cam;
mod check;
mod chosen;
mod columns;
mod definition;
mod elastic;
mod file;
mod finite;
mod gear;
mod json;
mod key;
mod left_out;
mod lines;
mod material;
pub mod materials;
#[cfg(test)]
mod meshes;
mod nearest;
mod number;
mod overlay;
mod print;
mod problem;
mod quantity;
mod read;
mod reader;
mod resolved;
mod rewritten;
mod similar;
mod surface;
mod told;
mod tree;
mod unclosed;
mod wheel_rail;

pub use accuracy::{Chose, GridRange};
pub use cam::{CamCase, CamForecast};
pub use check::{
    BesideHalfSpace, Cycles, Equivalent, Finiteness, Forecast, Solves, Surfaces, free_memory,
};
pub use chosen::ChosenPart;
pub use definition::{BodyCase, BuildError, Case, FrameCase, LayerCase, Output};
pub use elastic::{ElasticCase, ElasticForecast};
pub use file::{CaseFile, Unreadable};
pub use gear::{GearCase, GearForecast};
pub use key::Key;
pub use material::MaterialCase;
pub use nearest::nearest;
pub use number::ValueAt;
pub use problem::{Location, Problem, Severity, Source};
pub use resolved::{
    ResolvedCam, ResolvedElastic, ResolvedGear, ResolvedWheelRail, RunnableCase, Task,
};
pub use similar::WearByKs;
pub use surface::{Preparation, PreparedSurface};
pub use told::told;
pub use wheel_rail::{
    PreparedContact, RailError, State, WheelRailCase, WheelRailForecast, WheelsetMotion,
};
