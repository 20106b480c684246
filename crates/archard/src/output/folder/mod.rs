//! The result folder of a run.

#[cfg(test)]
mod tests;

use std::error::Error as StdError;
use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::closed_forms::ClosedForms;
use super::elastic::POINTS;
use super::fretting_loop::FrettingLoop;
use super::inside::SURFACES;
use super::summary::{self, Standing};
use super::table::{Table, number};
use super::worn_profiles::WornProfiles;
use super::{Error, Image, Surface, Totals, file, pvd, sections};
use crate::simulation::{Observer, Report, row};

/// The file of the profiles of bodies that roll.
const WORN_PROFILES: &str = "worn_profiles.csv";
/// The file of force over shift.
const FRETTING_LOOP: &str = "fretting_loop.csv";

/// Writes the results of a run into a folder as it goes; see [the module](super) for the files.
#[derive(Debug)]
pub struct ResultFolder {
    dir: PathBuf,
    history: Table,
    profiles: Table,
    /// The profiles of bodies that roll, once there are any.
    worn_profiles: Option<Table>,
    /// The loops of bodies that are shifted, once there are any, and the one under way.
    fretting_loops: Option<Table>,
    fretting_loop: FrettingLoop,
    /// Progress and file of every output so far.
    outputs: Vec<(f64, String)>,
    iterations: usize,
    closed_forms: ClosedForms,
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
            fretting_loops: None,
            fretting_loop: FrettingLoop::default(),
            outputs: Vec::new(),
            iterations: 0,
            closed_forms: ClosedForms::default(),
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
        if self.fretting_loop.take(report, &row) {
            let table = begun(&mut self.fretting_loops, &self.dir.join(FRETTING_LOOP))?;
            self.fretting_loop.write(table)?;
        }
        self.iterations += report.effort.iterations;
        self.standing = Some(Standing::of(report, &row, self.closed_forms.of(report)));
        Ok(())
    }

    /// Writes the fields and sections of a report.
    fn put_out(&mut self, report: &Report<'_>) -> Result<(), Error> {
        self.put_out_fields(report)?;
        let collection = pvd::collection(&self.outputs);
        file::write_whole(&self.dir.join("fields.pvd"), collection.as_bytes())?;
        match WornProfiles::of(report.problem, report.state) {
            Some(profiles) => {
                profiles.write(begun(&mut self.worn_profiles, &self.dir.join(WORN_PROFILES))?)
            }
            None => Ok(()),
        }
    }
}

impl ResultFolder {
    /// Writes the fields of a report and their sections.
    fn put_out_fields(&mut self, report: &Report<'_>) -> Result<(), Error> {
        let Report { problem, state, .. } = report;
        let progress = (problem.kinematics.progress().column, state.progress);
        let name = format!("fields/{:04}", self.outputs.len());
        let name = if problem.frame.is_uniform() {
            let (image, name) = (Image::of(problem, state), format!("{name}.vti"));
            image.write(&self.dir.join(&name))?;
            sections::write(&mut self.profiles, progress, &image)?;
            name
        } else {
            let (surface, name) = (Surface::of(problem, state), format!("{name}.vtu"));
            surface.write(&self.dir.join(&name))?;
            sections::write_surface(&mut self.profiles, progress, &surface)?;
            name
        };
        self.outputs.push((state.progress, name));
        Ok(())
    }
}

/// A table, begun at that path if it is not there yet.
fn begun<'a>(table: &'a mut Option<Table>, path: &Path) -> Result<&'a mut Table, Error> {
    let begun = match table.take() {
        Some(begun) => begun,
        None => Table::create(path.to_owned())?,
    };
    Ok(table.insert(begun))
}

impl Observer for ResultFolder {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        Ok(self.take(report)?)
    }
}

/// Removes what an earlier run left and this one might not overwrite.
fn clear(dir: &Path, fields: &Path) -> Result<(), Error> {
    let refused = |source| Error::Write { path: fields.to_owned(), source };
    let names = ["summary.json", "fields.pvd", WORN_PROFILES, FRETTING_LOOP, POINTS];
    let mut old: Vec<PathBuf> =
        names.into_iter().chain(SURFACES).map(|name| dir.join(name)).collect();
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
    [Some(OsStr::new("vti")), Some(OsStr::new("vtu"))].contains(&path.extension())
        && path.file_stem().and_then(OsStr::to_str).is_some_and(digits)
}
