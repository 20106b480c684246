//! A result folder on its way to a run: held, and as it was.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::lock::Lock;
use super::{HISTORY, ResultFolder, TABLES, checkpoint};
use crate::files::{self, Contents, Inputs};
use crate::output::elastic::{POINTS, SURFACE};
use crate::output::inside::SURFACES;
use crate::output::{CASE, COLLECTION, Collection, Error, FIELDS, Limit, Manifest, SUMMARY};
use archard::simulation::Simulation;

/// A folder that no other run writes into. What is in it stays as it is until the results begin, so that a case that
/// cannot be built costs no results.
#[derive(Debug)]
pub struct Claim {
    pub(super) dir: PathBuf,
    pub(super) lock: Lock,
    pub(in crate::output) manifest: Manifest,
    /// Files that a run adds at its end.
    more: Vec<String>,
    /// The limits at which it ends.
    pub(super) until: Vec<Limit>,
    /// Whether the folder was made for it.
    made: bool,
    /// Whether the folder holds the route of this run as far as it has come.
    pub(in crate::output) on_a_route: bool,
}

impl Claim {
    /// Makes the folder if none exists and holds it.
    ///
    /// # Errors
    /// If another run holds it, or it cannot be written to.
    pub fn take(dir: &Path) -> Result<Self, Error> {
        let made = !dir.exists();
        fs::create_dir_all(dir).map_err(|source| Error::Write { path: dir.to_owned(), source })?;
        let lock = Lock::take(dir)?;
        match Manifest::read(dir) {
            Ok(manifest) => {
                let (more, until) = (vec![], vec![]);
                let dir = dir.to_owned();
                Ok(Self { dir, lock, manifest, more, until, made, on_a_route: false })
            }
            Err(error) => {
                lock.give_up();
                Err(error)
            }
        }
    }

    /// The same for a run that adds files of these names at its end, such as [`Inside::files`](crate::output::Inside).
    #[must_use]
    pub fn adding(self, more: Vec<String>) -> Self {
        Self { more, ..self }
    }

    /// The same for a run that ends where the first of these limits is reached.
    #[must_use]
    pub fn until(self, until: Vec<Limit>) -> Self {
        Self { until, ..self }
    }

    /// The same for a run that reads these files, which stay as they are.
    #[must_use]
    pub fn sparing(self, inputs: Inputs) -> Self {
        Self { manifest: self.manifest.sparing(inputs), ..self }
    }

    /// Whether the folder holds the route of this run as far as it has come.
    pub fn is_on_a_route(&self) -> bool {
        self.on_a_route
    }

    /// The folder.
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// Whether the folder holds results of another case than the one whose printed form that is, or a case by itself.
    pub fn holds_another(&self, is_its: impl Fn(&str) -> bool) -> bool {
        match files::read(&self.dir.join(CASE), Contents::Text) {
            Ok(known) => !std::str::from_utf8(&known).is_ok_and(is_its),
            Err(_) => [SUMMARY, HISTORY].iter().any(|name| self.dir.join(name).exists()),
        }
    }

    /// Says whether a run may begin: nothing stands where its files go but what this program wrote.
    ///
    /// # Errors
    /// If something does, which is named.
    pub fn admit(&self) -> Result<(), Error> {
        let fixed = FIXED.into_iter().chain(TABLES).map(str::to_owned);
        let mut names = fixed.chain(self.more.iter().cloned()).chain(self.numbered());
        names.try_for_each(|name| self.manifest.admit(&name).map(|_| ())).map_err(|error| {
            match error {
                Error::NotOurs { path, .. } if self.is_of_an_earlier_version() => {
                    let help = "; this looks like the results of an earlier version: `--force` replaces them";
                    Error::NotOurs { path, help }
                }
                error => error,
            }
        })
    }

    /// Takes results of an earlier version, which left no list of its files, for what this program wrote: the files with
    /// names that it always gave, and the fields that its `fields.pvd` names. Of any other folder it takes nothing.
    #[must_use]
    pub fn adopting(mut self) -> Self {
        if self.is_of_an_earlier_version() {
            let fields = Collection::read(&self.dir.join(COLLECTION)).unwrap_or_default().outputs;
            let fields =
                fields.into_iter().map(|(_, name)| name).filter(|name| output(name).is_some());
            let fixed = FIXED.into_iter().chain(TABLES).chain([POINTS, SURFACE]).chain(SURFACES);
            let all = fixed.map(str::to_owned).chain(fields).chain(self.more.iter().cloned());
            let there: Vec<String> = all.filter(|name| self.dir.join(name).is_file()).collect();
            self.manifest.adopt(there);
        }
        self
    }

    /// Gives the folder up as it was; one that was made for it and is empty is removed.
    pub fn give_up(self) {
        self.lock.give_up();
        if self.made {
            let _ = fs::remove_dir(self.dir);
        }
    }

    /// Removes what earlier runs wrote and begins the results of a case.
    ///
    /// # Errors
    /// If something else stands where its files go, or a file cannot be removed or written.
    pub fn begin(self, case_toml: &str) -> Result<ResultFolder, Error> {
        match self.admit() {
            Ok(()) => ResultFolder::begin(self, case_toml),
            Err(error) => {
                self.give_up();
                Err(error)
            }
        }
    }

    /// Ends what is left to do in a folder whose run has come to its end: parts of files and the checkpoint go, and the list is
    /// written in order.
    ///
    /// # Errors
    /// If a file cannot be removed or written.
    pub fn tidy(mut self) -> Result<(), Error> {
        self.manifest.remove_parts(|_| true);
        self.manifest.remove(checkpoint::NAME)?;
        self.manifest.settle()
    }

    /// Says whether there is a whole run to go on with, before there is a simulation to compare it with.
    ///
    /// # Errors
    /// If there is no checkpoint of this version, or it is damaged.
    pub fn find_run(&self) -> Result<(), Error> {
        checkpoint::find_any(self)
    }

    /// Goes on with the results of a simulation's run that was interrupted; the run itself comes with them, for
    /// [`Simulation::resume`]. What cannot be gone on with stays as it is.
    ///
    /// # Errors
    /// If there is no checkpoint of this version and this simulation, it is damaged, or files of the results are.
    pub fn resume(self, simulation: &Simulation) -> Result<(ResultFolder, Vec<u8>), Error> {
        match checkpoint::find(&self, simulation) {
            Ok((kept, run)) => Ok((ResultFolder::go_on(self, kept)?, run)),
            Err(error) => {
                self.give_up();
                Err(error)
            }
        }
    }

    /// Removes the outputs from a number on.
    pub(super) fn remove_fields(&mut self, first: usize) -> Result<(), Error> {
        let old = |name: &&str| output(name).is_some_and(|number| number >= first);
        let old: Vec<String> = self.manifest.names().filter(old).map(str::to_owned).collect();
        old.iter().try_for_each(|name| self.manifest.remove(name))
    }

    /// What stands in the folder of fields under the name of one.
    fn numbered(&self) -> impl Iterator<Item = String> {
        let entries = fs::read_dir(self.dir.join(FIELDS)).into_iter().flatten().flatten();
        let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
        names.filter(|name| number(name).is_some()).map(|name| format!("{FIELDS}/{name}"))
    }

    /// Whether the folder holds results and no list of them.
    fn is_of_an_earlier_version(&self) -> bool {
        let there = |name: &str| self.dir.join(name).is_file();
        let signed = || {
            let summary = files::read(&self.dir.join(SUMMARY), Contents::Text).ok();
            let summary: Option<Value> =
                summary.and_then(|text| serde_json::from_slice(&text).ok());
            summary.is_some_and(|summary| summary["program"] == "archard")
        };
        !self.manifest.exists() && there(CASE) && (there(HISTORY) && there(COLLECTION) || signed())
    }
}

/// Files that every run in contact writes, besides its tables.
const FIXED: [&str; 4] = [CASE, SUMMARY, COLLECTION, checkpoint::NAME];

/// The number of an output, by its name in the folder of results.
pub(super) fn output(name: &str) -> Option<usize> {
    let (folder, name) = name.split_once('/')?;
    if folder == FIELDS { number(name) } else { None }
}

/// The number of an output, if that is the name of one.
fn number(name: &str) -> Option<usize> {
    let path = Path::new(name);
    let digits = |stem: &&str| stem.len() >= 4 && stem.bytes().all(|byte| byte.is_ascii_digit());
    let fields = [Some(OsStr::new("vti")), Some(OsStr::new("vtu"))].contains(&path.extension());
    let stem = path.file_stem().and_then(OsStr::to_str).filter(|_| fields).filter(digits)?;
    // More digits than a number has are of no run that goes on.
    Some(stem.parse().unwrap_or(usize::MAX))
}
