//! Studies made up by runs of published cases, and fits to them.

use std::error::Error as StdError;
use std::fmt::Write;
use std::path::Path;

use archard::simulation::history::{self, number};
use archard::simulation::{Observer, Report};
use archard_case::CaseFile;
use archard_case::measured::Table;
use archard_lab::{Coefficient, Error, Files, Fit, Request, RunFollower, fit};

use super::framed;

/// Numbers of a normal distribution, by Box and Muller.
pub struct Normal(pub fastrand::Rng);

impl Normal {
    pub fn draw(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.0.f64()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.0.f64()).cos()
    }
}

#[derive(Default)]
pub struct Rows(pub Vec<Vec<(String, f64)>>);

impl Observer for Rows {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        self.0.push(history::row(report));
        Ok(())
    }
}

pub fn published(name: &str, options: &[&str]) -> CaseFile {
    let path = framed::folder(name);
    let file = CaseFile::read(&path).unwrap();
    options.iter().fold(file, |file, option| file.set(*option))
}

/// How tests are made: what scatters between them, and by how much readings are off.
pub struct Made<'a> {
    pub file: CaseFile,
    /// The bodies with the median of their coefficients (1/Pa).
    pub bodies: &'a [(&'a str, f64)],
    /// Columns of the table, of the history, and the factor between them.
    pub columns: &'a [(&'a str, &'a str, f64)],
    pub tests: usize,
    pub seed: u64,
}

pub const SCATTER: f64 = 0.2;

pub const READING: f64 = 0.04;

impl Made<'_> {
    /// Tests, each a run with coefficients of its own, read four times.
    pub fn table(&self, progress: &str) -> String {
        let mut random = Normal(fastrand::Rng::with_seed(self.seed));
        let names: Vec<&str> = self.columns.iter().map(|column| column.0).collect();
        let mut text = format!("test,{progress},{}\n", names.join(","));
        for test in 0..self.tests {
            let with = |file: CaseFile, (body, median): &(&str, f64)| {
                let k = median * (SCATTER * random.draw()).exp();
                file.set(format!("body.{body}.wear.archard.coefficient=\"{k:e} 1/Pa\""))
            };
            let file = self.bodies.iter().fold(self.file.clone(), with);
            let mut rows = Rows::default();
            file.resolve().unwrap().case.build().unwrap().run(&mut [&mut rows]).unwrap();
            let count = rows.0.len() - 1;
            for reading in 1..=4 {
                let row = &rows.0[reading * count / 4];
                let mut cells = format!("{test},{}", row[0].1);
                for (_, column, factor) in self.columns {
                    let off = (READING * random.draw()).exp();
                    let _ = write!(cells, ",{}", number(row, column).unwrap() * factor * off);
                }
                let _ = writeln!(text, "{cells}");
            }
        }
        text
    }
}

/// Ends a fit at the first step of a run.
pub struct Until(pub Option<usize>, pub Vec<Option<f64>>);

impl RunFollower for Until {
    fn begins(&mut self, run: usize, _: &str) {
        if self.0 == Some(run) {
            self.0 = Some(0);
        }
    }

    fn ended(&mut self, _: usize, _: &str, seconds: Option<f64>) {
        self.1.push(seconds);
    }

    fn observer(&mut self) -> &mut dyn Observer {
        self
    }
}

impl Observer for Until {
    fn observe(&mut self, _: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        if self.0 == Some(0) { Err("interrupted".into()) } else { Ok(()) }
    }
}

pub fn fitted(file: &CaseFile, text: &str, parameter: Option<&str>) -> Result<Fit, Error> {
    let dir = tempfile::tempdir().unwrap();
    fitted_in(dir.path(), file, (text, parameter), &mut Until(None, vec![]))
}

/// A fit that takes the wear at some keys from the case.
pub fn assuming(file: &CaseFile, text: &str, keys: &[&str]) -> Result<Fit, Error> {
    let dir = tempfile::tempdir().unwrap();
    let assumed: Vec<String> = keys.iter().map(|key| (*key).to_owned()).collect();
    let table = Table::read("tests.csv", text.as_bytes()).unwrap();
    let request = Request {
        parameters: &[],
        uncertain: &[],
        assumed: &assumed,
        files: Files { folder: dir.path(), columns: &[] },
        dir: dir.path(),
        store: None,
        following: &mut Until(None, vec![]),
    };
    fit(file, &table, request)
}

pub fn fitted_in(
    dir: &Path,
    file: &CaseFile,
    (text, parameter): (&str, Option<&str>),
    following: &mut dyn RunFollower,
) -> Result<Fit, Error> {
    let table = Table::read("tests.csv", text.as_bytes()).unwrap();
    let files = Files { folder: dir, columns: &[] };
    let parameters: Vec<String> = parameter.into_iter().map(str::to_owned).collect();
    let parameters = &parameters;
    let request =
        Request { parameters, uncertain: &[], assumed: &[], files, dir, store: None, following };
    fit(file, &table, request)
}

/// The median lies in its interval, the interval is one of tests that scatter as these, and the law is not rejected.
pub fn assert_found(own: &Coefficient, median: f64) {
    let estimate = &own.estimate;
    let [low, high] = estimate.interval.unwrap();
    assert!(low < median && median < high, "{median:e}: {low:e} {high:e}");
    let [next_low, next_high] = estimate.next.unwrap();
    assert!(next_low < low && high < next_high);
    // By chance a deviation of few tests is a third to twice that of all.
    let between = estimate.between.unwrap();
    assert!((0.3 * SCATTER..2.2 * SCATTER).contains(&between), "{between}");
    for reading in estimate.readings.iter().flatten() {
        assert!(
            (0.5 * READING..2.0 * READING).contains(reading) || own.tests.len() < 4,
            "{reading}"
        );
    }
    assert_eq!(own.rejected(), None);
}
