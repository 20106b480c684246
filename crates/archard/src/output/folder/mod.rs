//! The result folder of a run.

#[cfg(test)]
mod tests;

use std::error::Error as StdError;
use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::summary::{self, Standing};
use super::table::{Table, number};
use super::worn_profiles::WornProfiles;
use super::{Error, Image, Totals, file, pvd, sections};
use crate::simulation::{Observer, Report, row};

/// The file of the profiles of bodies that roll.
const WORN_PROFILES: &str = "worn_profiles.csv";

/// Writes the results of a run into a folder as it goes; see [the module](super) for the files.
#[derive(Debug)]
pub struct ResultFolder {
    dir: PathBuf,
    history: Table,
    profiles: Table,
    /// The profiles of bodies that roll, once there are any.
    worn_profiles: Option<Table>,
    /// Progress and file of every output so far.
    outputs: Vec<(f64, String)>,
    iterations: usize,
    standing: Option<Standing>,
}

impl ResultFolder {
    /// Makes the folder and starts its files; results of an earlier run in it are removed, anything
    /// else is left alone.
    ///
    /// # Errors
    /// If the folder or a file in it cannot be written.
    pub fn create(dir: &Path, case_toml: &str) -> Result<Self, Error> {
        let fields = dir.join("fields");
        fs::create_dir_all(&fields)
            .map_err(|source| Error::Write { path: fields.clone(), source })?;
        clear(dir, &fields)?;
        file::write_whole(&dir.join("case.toml"), case_toml.as_bytes())?;
        Ok(Self {
            dir: dir.to_owned(),
            history: Table::create(dir.join("history.csv"))?,
            profiles: Table::create(dir.join("profiles.csv"))?,
            worn_profiles: None,
            outputs: Vec::new(),
            iterations: 0,
            standing: None,
        })
    }

    /// Writes `summary.json`, after a run that reached its end and after one that did not.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(self, totals: &Totals) -> Result<(), Error> {
        let text = summary::text(self.standing.as_ref(), self.iterations, totals);
        file::write_whole(&self.dir.join("summary.json"), text.as_bytes())
    }

    /// Takes up a report.
    fn take(&mut self, report: &Report<'_>) -> Result<(), Error> {
        let row = row(report);
        let cells: Vec<_> =
            row.iter().map(|(column, value)| (column.as_str(), number(*value))).collect();
        self.history.row(&cells)?;
        self.history.flush()?;
        if report.output {
            self.put_out(report)?;
        }
        self.iterations += report.effort.iterations;
        self.standing = Some(Standing::of(report, &row));
        Ok(())
    }

    /// Writes the fields and sections of a report.
    fn put_out(&mut self, report: &Report<'_>) -> Result<(), Error> {
        let image = Image::of(report.problem, report.state);
        let name = format!("fields/{:04}.vti", self.outputs.len());
        image.write(&self.dir.join(&name))?;
        let progress = report.state.progress;
        self.outputs.push((progress, name));
        let collection = pvd::collection(&self.outputs);
        file::write_whole(&self.dir.join("fields.pvd"), collection.as_bytes())?;
        let column = report.problem.kinematics.progress().column;
        sections::write(&mut self.profiles, (column, progress), &image)?;
        match WornProfiles::of(report.problem, report.state) {
            Some(profiles) => profiles.write(self.worn_profiles()?),
            None => Ok(()),
        }
    }

    /// The table of worn profiles, begun if it is not there yet.
    fn worn_profiles(&mut self) -> Result<&mut Table, Error> {
        let table = match self.worn_profiles.take() {
            Some(table) => table,
            None => Table::create(self.dir.join(WORN_PROFILES))?,
        };
        Ok(self.worn_profiles.insert(table))
    }
}

impl Observer for ResultFolder {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        Ok(self.take(report)?)
    }
}

/// Removes what an earlier run left and this one might not overwrite.
fn clear(dir: &Path, fields: &Path) -> Result<(), Error> {
    let refused = |source| Error::Write { path: fields.to_owned(), source };
    let mut old = ["summary.json", "fields.pvd", WORN_PROFILES].map(|name| dir.join(name)).to_vec();
    for entry in fs::read_dir(fields).map_err(refused)? {
        let path = entry.map_err(refused)?.path();
        if is_output(&path) {
            old.push(path);
        }
    }
    old.into_iter().try_for_each(|path| match fs::remove_file(&path) {
        Err(source) if source.kind() != io::ErrorKind::NotFound => {
            Err(Error::Write { path, source })
        }
        _ => Ok(()),
    })
}

/// Whether that is the name of a numbered output.
fn is_output(path: &Path) -> bool {
    let digits = |stem: &str| stem.len() >= 4 && stem.bytes().all(|byte| byte.is_ascii_digit());
    path.extension() == Some(OsStr::new("vti"))
        && path.file_stem().and_then(OsStr::to_str).is_some_and(digits)
}
