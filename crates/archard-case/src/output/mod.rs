//! What a run leaves behind: a folder of files that spreadsheets, Python and ParaView read.
//!
//! [`ResultFolder`] observes a run and writes
//!
//! - `case.toml`: the case as resolved;
//! - `history.csv`: a row a step, units in the names of the columns;
//! - `profiles.csv`: at each output the sections through the contact;
//! - `length_profiles.csv`, where a surface swings: at each output its worn section and depth from end to end;
//! - `worn_profiles.csv`, where bodies roll: at each output their transverse profiles, before and after;
//! - `distributions.csv`, of rough surfaces: at each output the pressure, gap and heights that each share reaches;
//! - `fretting_loop.csv`, where bodies are shifted to and fro: force over shift in the first cycle and in
//!   every one in which an output falls due, a row an increment;
//! - `fields.pvd`, the [`Collection`] of outputs for ParaView, and for each `fields/NNNN.vti`, the [`Image`] of all
//!   fields; on frames that are no uniform grid `fields/NNNN.vtu`, the [`Surface`] with all fields;
//! - `summary.json`: the last row, checks and totals;
//! - `manifest.txt`: the names of all these, so that nothing else is ever replaced or removed, and, once the run is done, their sums;
//! - `checkpoint`, until the run has come to its end: all that it needs to go on after an interruption.
//!
//! Where points inside of bodies in contact or sections through them are asked for, [`Inside`] adds at the end
//! `points.csv`, a row a point, `surface_1.vtu` or `surface_2.vtu` with displacements, tractions, stresses and wear, and
//! a [`Sheet`] a section, `sections/BODY_NAME.vtu`. Half-spaces have no surface files; where their largest stresses are asked for,
//! `stress_BODY.csv` has a row a depth, `stress_BODY.vtr` the field, and `damage_BODY.csv` the damage over a run.
//!
//! Of an elastic body without contact, [`write_elastic`] writes `case.toml`, `surface.vtu` with displacements,
//! tractions and stresses, `points.csv` with a row a point, `sections/NAME.vtu`, and `summary.json`.
//!
//! Of a wheel on a rail, [`write_rail`] writes `case.toml`, `contacts.csv` with a row a patch, the
//! [`Image`] of each in `patches`, and `summary.json`; where they wear over a route also `wear.csv` with a row a point of a profile, `dimensions.csv` with a row a step, and the worn profiles.
//!
//! Of two gears, [`write_gear`] writes `case.toml`, `flanks.csv` with a row a station of the path of contact, `course.csv` with a row a
//! step, and `summary.json`. Of a cam and its follower, [`write_cam`] writes `case.toml`, `cam.csv` with a row an angle, `follower.csv` with
//! a row a place, `course.csv` and `summary.json`.
//!
//! All of them are complete after every step, so an interrupted run can be read. [`Claim`] keeps other runs out of the
//! folder.

mod cam;
mod closed_forms;
mod contacts;
mod damage;
mod derived;
mod distributions;
mod elastic;
mod evidence;
mod fields;
mod file;
mod folder;
mod fretting_loop;
mod gear;
mod image;
mod inside;
mod length_profiles;
mod life;
mod limit;
mod lines;
mod manifest;
mod names;
mod place;
mod planes;
mod rail_errors;
mod rail_service;
mod rail_wear;
mod sections;
mod sheet;
mod standards;
mod store;
mod stress;
mod stress_errors;
mod summary;
mod surface;
mod table;
mod vtk;
mod worn_profiles;
mod worn_surface;

#[cfg(test)]
#[path = "tests/fixture.rs"]
mod fixture;

use std::io;
use std::path::{Path, PathBuf};

use archard::simulation::ResumeError;

pub use cam::{CamResults, cam_files, write_cam};
pub(crate) use closed_forms::blocks as estimate_json;
pub use contacts::{
    AtPoint, Flank, RailContact, RailHistory, RailResults, contact_row, rail_files, write_rail,
};
pub use damage::WantedDamage;
pub use derived::RowsOfRun;
pub use elastic::{elastic_files, elastic_verdict, write_elastic};
pub(crate) use evidence::Stations;
pub use fields::{Field, fields};
pub use folder::{Claim, ResultFolder, RouteKeeper};
pub use gear::{GearResults, gear_files, write_gear};
pub use image::Image;
pub use inside::{Inside, InsideError};
pub use life::{Life, Limit, LimitPoint, Lives, NoColumn};
pub use lines::Rows;
pub use manifest::Manifest;
pub use place::Place;
pub use planes::Planes;
pub use rail_service::{RailEconomy, RailLife, RailPlan};
pub use rail_wear::{ProfileWear, RailWear};
pub use sheet::Sheet;
pub use standards::Standard;
pub use store::Store;
pub use stress::{COMPONENTS, Stresses, WORST, WantedFatigue, WantedStresses};
pub use summary::Totals;
pub use summary::json_of as verdict_json;
pub use surface::Surface;
pub use vtk::Collection;
pub use worn_surface::{RELIEF, WornSurface, bodies};

/// The file of the case as resolved.
const CASE: &str = "case.toml";
/// The file of the end of a run.
const SUMMARY: &str = "summary.json";
/// The file that lists the outputs.
const COLLECTION: &str = "fields.pvd";
/// The folder of the outputs.
const FIELDS: &str = "fields";

/// What a file of fields is called.
fn extension(path: &Path) -> String {
    path.extension().map_or_else(String::new, |extension| format!(".{}", extension.display()))
}

/// A result that cannot be written or read.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A limit of a quantity that the run does not have.
    #[error(transparent)]
    NoColumn(#[from] NoColumn),
    /// The file system refuses to write.
    #[error("cannot write `{}`: {source}", .path.display())]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// Something stands where a file goes that this program did not write.
    #[error(
        "`{}` is in the way, and nothing says that archard wrote it: move it, or choose another folder{help}",
        .path.display()
    )]
    NotOurs {
        /// What stands there.
        path: PathBuf,
        /// What else can be done.
        help: &'static str,
    },
    /// A file that a command reads stands where one of its results goes.
    #[error("`{}` is read here, and results would take its place: choose another folder with -o", .path.display())]
    Input {
        /// The file.
        path: PathBuf,
    },
    /// A file was removed while it was written.
    #[error("`{}` was removed or moved while the run wrote into it; what it held is lost", .path.display())]
    Removed {
        /// The file.
        path: PathBuf,
    },
    /// Another run writes into the folder.
    #[error(
        "another run{} writes into `{}`; wait for its end, or choose another folder with -o",
        .process.map_or_else(String::new, |process| format!(" (process {process})")),
        .dir.display()
    )]
    InUse {
        /// The folder.
        dir: PathBuf,
        /// The process that holds it, where it can be told.
        process: Option<u32>,
    },
    /// A folder whose run is another one.
    #[error("`{}` stays as it is: {source}", .dir.display())]
    NotResumed {
        /// The folder.
        dir: PathBuf,
        /// Why not.
        source: ResumeError,
    },
    /// A folder without a run to go on with.
    #[error("`{}` holds no run to go on with: {why}", .dir.display())]
    NoCheckpoint {
        /// The folder.
        dir: PathBuf,
        /// What is the matter, and what to do.
        why: &'static str,
    },
    /// A number that cannot be read.
    #[error(
        "`{name}` is not a finite number at {place}; the step is not kept, this is a fault of the program or of a value far out of range"
    )]
    NotFinite {
        /// The column or field.
        name: String,
        /// Where the motion was.
        place: String,
    },
    /// The file system refuses to read.
    #[error("cannot read `{}`: {source}", .path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A file of fields, or the list of them, that is damaged or comes from another program.
    #[error("`{}` is not a complete {} file of this program: {what}", .path.display(), extension(.path))]
    NotAnImage {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        what: String,
    },
}
