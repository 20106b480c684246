//! `archard compare`: a run next to measurements and other runs, or two scans of a surface, in numbers and as pictures.

mod course;
mod map;
mod profile;
mod runs;
pub mod scans;

use std::path::{MAIN_SEPARATOR, Path, PathBuf};

use anyhow::{Context, Error, Result, ensure};
use archard_case::files::{self, Contents};
use archard_case::measured::Table;
use archard_case::measured::surface::Surface;
use archard_case::verdict::{self, Verdict, Word};

use crate::plot::draw::Paper;
use crate::plot::figure::Panel;
use crate::plot::results::Results;
use crate::plot::tables::{Axis, largest};
use crate::plot::{self, Picture};
use crate::table;

/// What came of a comparison.
#[derive(Debug)]
pub(crate) struct Comparison {
    /// What was compared.
    pub(crate) title: String,
    /// What came out: names and values in words.
    pub(crate) lines: Vec<[String; 2]>,
    /// What has to be known.
    pub(crate) remarks: Vec<String>,
    /// Whether it can be believed: by the runs, by what was left out, and by the stated errors of what is compared.
    pub(crate) verdict: Verdict,
    pub(crate) panels: Vec<Panel>,
}

impl Comparison {
    /// The same with names of files and folders that leave out the place they are in.
    fn without(mut self, place: &Path) -> Self {
        let place = format!("{}{MAIN_SEPARATOR}", place.display());
        let panels = self.panels.iter_mut().flat_map(|panel| {
            let legends = panel.marks.iter_mut().filter_map(|mark| mark.legend.as_mut());
            legends.chain([&mut panel.title])
        });
        let judged = self.verdict.lines.iter_mut().map(|line| &mut line.text);
        let words = self.lines.iter_mut().flatten().chain(&mut self.remarks).chain(judged);
        for text in panels.chain(words).chain([&mut self.title]) {
            *text = text.replace(&place, "");
        }
        self
    }

    /// Adds what is doubtful.
    fn doubt(&mut self, what: &str) {
        self.verdict.lines.push(verdict::warned(what));
    }

    /// Adds the largest of some errors that are stated, relative, each with what it is of.
    fn state(&mut self, errors: impl IntoIterator<Item = (f64, String)>) {
        let worst = errors.into_iter().max_by(|one, other| one.0.total_cmp(&other.0));
        self.verdict.lines.extend(worst.map(|(error, what)| verdict::measured(error, &what)));
    }

    /// Adds how far a run can be believed.
    fn of_run(&mut self, dir: &Path, run: &Results) {
        let word = match (run.summary["verdict"]["word"].as_str(), &run.mark) {
            (Some("wrong"), _) => Word::Wrong,
            (Some("good"), None) => Word::Good,
            _ => Word::Doubtful,
        };
        let why = run.mark.as_deref().unwrap_or_default();
        let line = verdict::of_run(word, &format!("`{}`: {why}", dir.display()));
        self.verdict.lines.insert(0, line);
    }

    /// Names and values, with the verdict as the last of them.
    pub(crate) fn told(&self) -> Vec<[String; 2]> {
        let verdict = ["verdict".to_owned(), self.verdict.in_words()];
        self.lines.iter().cloned().chain([verdict]).collect()
    }

    /// What has to be known, and what is not good.
    pub(crate) fn remarks(&self) -> Vec<String> {
        let complaints = self.verdict.complaints().map(ToString::to_string);
        self.remarks.iter().cloned().chain(complaints).collect()
    }
}

/// How a run is compared.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Options {
    /// The column of a measured table that has a name, e.g. `z="Tiefe [um]"`; a profile has x (or y) and z, readings over the
    /// motion have distance, revolutions, cycle or time, and depth, volume, section or mass
    #[arg(long = "column", value_name = "NAME=TITLE")]
    pub columns: Vec<String>,
    /// The body that was measured; the one that wears deepest if not given
    #[arg(long, value_name = "BODY")]
    pub body: Option<String>,
    /// The measured profiles are level and placed as the run has them: they are not levelled and aligned
    #[arg(long)]
    pub levelled: bool,
    /// Where a program has written for a time what it holds in memory: names of files and folders leave it out
    #[arg(skip)]
    pub place: Option<PathBuf>,
}

/// Compares the run in a folder with each of the others, prints what came out and draws it; returns the pictures.
///
/// # Errors
/// If a folder or table cannot be read, or says nothing that can be compared.
pub fn run(
    dir: &Path,
    others: &[PathBuf],
    options: &Options,
) -> Result<(Vec<String>, Vec<PathBuf>)> {
    let (words, picture, mark) = picture(dir, others, options)?;
    let files = plot::write(dir, vec![picture], (mark.as_deref(), &Paper::default()))?;
    Ok((words, files))
}

/// What came of comparing a run with each of the others, in words and as a picture, and what both have to say besides.
///
/// # Errors
/// As [`run`].
pub(crate) fn picture(
    dir: &Path,
    others: &[PathBuf],
    options: &Options,
) -> Result<(Vec<String>, Picture, Option<String>)> {
    let results = Results::read(dir)?;
    let mut words = Vec::new();
    let mut panels = Vec::new();
    for comparison in of(dir, &results, others, options)? {
        words.push(comparison.title.clone());
        words.extend(comparison.told().iter().map(|[name, value]| format!("  {name:<34}{value}")));
        words.extend(comparison.remarks().iter().map(|remark| format!("  {remark}")));
        panels.extend(comparison.panels);
    }
    Ok((words, Picture::new("compare", panels), results.mark))
}

/// What came of comparing a run with each of some tables and folders.
///
/// # Errors
/// As [`run`].
pub(crate) fn of(
    dir: &Path,
    results: &Results,
    others: &[PathBuf],
    options: &Options,
) -> Result<Vec<Comparison>> {
    let (folders, tables): (Vec<PathBuf>, Vec<PathBuf>) =
        others.iter().cloned().partition(|path| path.is_dir());
    let mut all = Vec::new();
    if !folders.is_empty() {
        all.push(runs::compare(dir, results, &folders)?);
    }
    for path in tables {
        let mut one = measured(results, &path, options)?;
        one.state(runs::errors(results, &runs::columns(results)));
        all.push(one);
    }
    all.iter_mut().for_each(|one| one.of_run(dir, results));
    Ok(match &options.place {
        Some(place) => all.into_iter().map(|one| one.without(place)).collect(),
        None => all,
    })
}

/// A run next to a measured table.
fn measured(results: &Results, path: &Path, options: &Options) -> Result<Comparison> {
    let name = path.display().to_string();
    let bytes =
        files::read(path, Contents::Text).with_context(|| format!("cannot read `{name}`"))?;
    if let Some(surface) = Surface::of_file(&name, &bytes, files::free_memory()) {
        return map::compare(results, &surface?, body(results, options)?, options.levelled);
    }
    let names = table::names(&options.columns).map_err(Error::msg)?;
    let table = Table::read(&name, &bytes)?.naming(&names)?;
    let has = |name: &str| table.names().any(|known| known == name);
    let body = body(results, options)?;
    if !has("x") && !has("y") {
        return course::compare(results, &table, body);
    }
    let surface = Surface::of(&table)?;
    let mut comparison = match surface.axis() {
        Some(axis) => {
            let axis = [Axis::X, Axis::Y][axis];
            let readings = profile::readings(&surface, axis);
            let (source, of) = (table.source(), (body, axis));
            profile::compare(results, (source, readings), of, options.levelled)?
        }
        None => map::compare(results, &surface, body, options.levelled)?,
    };
    comparison.remarks.extend(unused(&table, &["x", "y", "z"]));
    Ok(comparison)
}

/// The index of the body that is compared.
fn body(results: &Results, options: &Options) -> Result<usize> {
    if let Some(name) = &options.body {
        let known = results.bodies.iter().position(|body| body == name);
        return known.with_context(|| {
            format!("--body {name}: the bodies are {}", results.bodies.join(" and "))
        });
    }
    let depth = |body: &usize| {
        let column = archard::simulation::history::of_body(
            archard::simulation::history::BODY_DEPTH,
            &results.bodies[*body],
        );
        results.history.column(&column).map_or(0.0, largest)
    };
    let deepest =
        (0..results.bodies.len()).max_by(|one, other| depth(one).total_cmp(&depth(other)));
    let deepest = deepest.context("the run has no bodies")?;
    // Of two that wear equally the first would be a guess.
    let others = (0..results.bodies.len()).filter(|body| *body != deepest);
    let alike =
        others.map(|body| depth(&body)).any(|other| other > 0.99 * depth(&deepest) && other > 0.0);
    ensure!(!alike, "both bodies wear equally: say which was measured by --body");
    Ok(deepest)
}

/// What has to be said of the columns of a table that are not used.
fn unused(table: &Table, used: &[&str]) -> Option<String> {
    let others = table.others(used);
    let others: Vec<String> = others.iter().map(|title| format!("`{title}`")).collect();
    (!others.is_empty()).then(|| format!("not used: column {}", others.join(", ")))
}

/// A difference relative to a value, in per cent.
fn percent(measured: f64, computed: f64) -> String {
    let difference = 100.0 * (computed / measured - 1.0);
    match difference.is_finite() {
        true => format!("computed {difference:+.1} % against measured"),
        false => "no ratio".to_owned(),
    }
}
