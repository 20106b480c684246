//! The result folder of a run.

use std::error::Error as StdError;
use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::summary::{self, Standing};
use super::table::{Table, number};
use super::{Error, Image, Totals, file, pvd, sections};
use crate::simulation::{Observer, Report, row};

/// Writes the results of a run into a folder as it goes; see [the module](super) for the files.
#[derive(Debug)]
pub struct ResultFolder {
    dir: PathBuf,
    history: Table,
    profiles: Table,
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
        sections::write(&mut self.profiles, (column, progress), &image)
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
    let mut old = vec![dir.join("summary.json"), dir.join("fields.pvd")];
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

#[cfg(test)]
mod tests {
    use std::fs;

    use approx::assert_relative_eq;
    use serde_json::Value;
    use tempfile::tempdir;

    use super::ResultFolder;
    use crate::output::fixture::{COEFFICIENTS, LOAD, Run};
    use crate::output::{Error, Image, Totals};

    /// A run of three steps with outputs at its start and end, and the folder it left.
    fn folder() -> tempfile::TempDir {
        let dir = tempdir().unwrap();
        let run = Run::pin_on_disc([9, 8]);
        let mut folder = ResultFolder::create(dir.path(), "title = \"a pin\"\n").unwrap();
        run.show(&mut folder, &[0.0, 0.1, 0.3, 0.5], |s| s == 0.0 || s == 0.5);
        let totals = Totals { seconds: 1.5, threads: 2, ..Totals::default() };
        folder.finish(&totals).unwrap();
        dir
    }

    #[test]
    fn the_history_has_a_row_a_step() {
        let dir = folder();
        let mut table = csv::Reader::from_path(dir.path().join("history.csv")).unwrap();
        let header = table.headers().unwrap().clone();
        let column = |name: &str| header.iter().position(|column| column == name).unwrap();
        let rows: Vec<_> = table.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 4);
        assert_eq!(&rows[2][column("distance_m")], "0.3");
        assert_eq!(&rows[2][column("time_error")], "");
        let volume: f64 = rows[3][column("worn_volume_disc_m3")].parse().unwrap();
        assert_relative_eq!(volume, COEFFICIENTS[1] * LOAD * 0.5, max_relative = 1e-13);
    }

    #[test]
    fn the_fields_are_those_of_the_state() {
        let dir = folder();
        let run = Run::pin_on_disc([9, 8]);
        let image = Image::read(&dir.path().join("fields/0001.vti")).unwrap();
        assert_eq!(image, Image::of(&run.problem, &run.state(0.5)));
        assert!(!dir.path().join("fields/0002.vti").exists());
        let collection = fs::read_to_string(dir.path().join("fields.pvd")).unwrap();
        assert!(collection.contains("timestep=\"0.5\" file=\"fields/0001.vti\""), "{collection}");
    }

    #[test]
    fn the_profiles_have_both_axes_of_each_output() {
        let dir = folder();
        let mut table = csv::Reader::from_path(dir.path().join("profiles.csv")).unwrap();
        let header: Vec<String> = table.headers().unwrap().iter().map(str::to_owned).collect();
        let known = "distance_m axis coordinate_m pressure_Pa gap_m wear_pin_m wear_disc_m wear_m height_pin_m height_disc_m";
        assert_eq!(header.join(" "), known);
        let axes: Vec<String> = table.records().map(|row| row.unwrap()[1].to_owned()).collect();
        assert_eq!(axes.len(), 2 * (9 + 8));
        assert_eq!(axes.iter().filter(|axis| *axis == "y").count(), 2 * 8);
    }

    #[test]
    fn the_summary_closes_the_volumes() {
        let dir = folder();
        let text = fs::read_to_string(dir.path().join("summary.json")).unwrap();
        let summary: Value = serde_json::from_str(&text).unwrap();
        for (name, k) in ["pin", "disc"].into_iter().zip(COEFFICIENTS) {
            let wear = &summary["wear"][name];
            assert_relative_eq!(
                wear["expected_volume_m3"].as_f64().unwrap(),
                k * LOAD * 0.5,
                max_relative = 1e-14
            );
            assert!(wear["relative_difference"].as_f64().unwrap().abs() < 1e-13);
        }
        assert_eq!(summary["complete"], true);
        assert_eq!(summary["iterations"], 40);
        assert_eq!(summary["applications"], 44);
        assert_eq!(summary["last"]["distance_m"], 0.5);
        assert!(summary["last"]["time_error"].is_null());
        // Hertz and eq. 55 of this sphere.
        let known = &summary["closed_form"];
        let peak = known["hertz"]["peak_pressure_Pa"].as_f64().unwrap();
        assert_relative_eq!(peak, 219.0547e6, max_relative = 3e-7);
        let depth = known["pin_on_disc"]["depth_m"].as_f64().unwrap();
        assert_relative_eq!(depth, 2.078040e-6, max_relative = 3e-7);
    }

    #[test]
    fn a_run_without_a_step_has_a_summary() {
        let dir = tempdir().unwrap();
        let folder = ResultFolder::create(dir.path(), "").unwrap();
        let totals = Totals { failure: Some("no luck".to_owned()), ..Totals::default() };
        folder.finish(&totals).unwrap();
        let text = fs::read_to_string(dir.path().join("summary.json")).unwrap();
        let summary: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(summary["complete"], false);
        assert_eq!(summary["failure"], "no luck");
        assert!(summary["last"].is_null());
    }

    #[test]
    fn a_new_run_removes_the_results_of_the_old_one_only() {
        let dir = folder();
        for name in ["notes.txt", "fields/mine.vti"] {
            fs::write(dir.path().join(name), "keep").unwrap();
        }
        ResultFolder::create(dir.path(), "").unwrap();
        let there = |name: &str| dir.path().join(name).exists();
        assert!(there("notes.txt") && there("fields/mine.vti"));
        assert!(!there("summary.json") && !there("fields.pvd") && !there("fields/0000.vti"));
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_named() {
        let dir = tempdir().unwrap();
        fs::write(dir.path().join("taken"), "").unwrap();
        let error = ResultFolder::create(&dir.path().join("taken"), "").unwrap_err();
        assert!(matches!(&error, Error::Write { path, .. } if path.ends_with("taken/fields")));
        assert!(error.to_string().contains("taken"), "{error}");
    }
}
