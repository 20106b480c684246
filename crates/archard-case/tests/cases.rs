//! The published cases: each gives what its folder says it has to.
//!
//! `expected.toml` next to a `case.toml`:
//!
//! ```toml
//! coarse = ["frame.elements=[30, 30]"]   # options of every run of the test
//! [[expect]]
//! column = "wear_depth_m"                # a result column
//! at = "500 mm"                          # progress of its row; the last row if left out
//! point = "middle"                       # inside of a body, instead: the point, the first of that name
//! value = "2.059002 um"                  # with a unit of the column's dimension, if it has one
//! within = 0.006                         # largest relative difference
//! known_to = 5e-6                        # relative uncertainty of the value, where an accuracy is judged by it too
//! source = "..."                         # where the value comes from
//! set = ["motion.sliding.step=10 mm"]    # more options, if any
//! ```

mod common;
mod published {
    mod accuracy;
    pub mod gallery;
    pub mod validation;
}

use std::error::Error;
use std::fs;
use std::num::NonZero;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::thread;

use archard::elastic::{self, Point, PressedHalfSpace, Response};
use archard::frame::{ContactFrame, VectorField};
use archard::simulation::{Observer, Report, offsets};
use archard::units::{self, Dimension, Measure};
use archard_case::output::{RailWear, Store, contact_row};
use archard_case::{CaseFile, Task};
use toml::de::{DeTable, DeValue};

use common::Rows;
use published::validation::{Line, held};

/// A number a case has to give.
#[derive(Clone)]
struct Expected {
    options: Vec<String>,
    column: String,
    at: Option<String>,
    point: Option<String>,
    value: String,
    within: f64,
    known_to: Option<f64>,
    source: String,
}

/// The folders of the cases.
fn folders() -> Vec<PathBuf> {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let entries = fs::read_dir(cases).unwrap().map(|entry| entry.unwrap().path());
    let mut folders: Vec<PathBuf> = entries.filter(|path| path.is_dir()).collect();
    folders.sort();
    folders
}

/// The text at a key, where there is one.
fn text(table: &DeTable<'_>, key: &str) -> Option<String> {
    Some(table.get(key)?.get_ref().as_str().expect("a text").to_owned())
}

/// The number at a key, where there is one.
fn float(table: &DeTable<'_>, key: &str) -> Option<f64> {
    match table.get(key)?.get_ref() {
        DeValue::Float(number) => Some(number.as_str().parse().expect("a number")),
        other => panic!("`{key}` is {}", other.type_str()),
    }
}

/// The list of texts at a key; empty where none exists.
fn texts(table: &DeTable<'_>, key: &str) -> Vec<String> {
    let list = table.get(key).map(|value| value.get_ref().as_array().expect("a list"));
    let texts = list.into_iter().flat_map(|list| list.iter());
    texts.map(|text| text.get_ref().as_str().expect("a text").to_owned()).collect()
}

/// Reads what a case has to give; keys it does not know are mistakes.
fn expected(file: &str) -> Vec<Expected> {
    let document = DeTable::parse(file).expect("TOML").into_inner();
    assert!(document.keys().all(|key| ["coarse", "expect"].contains(&&**key.get_ref())));
    let coarse = texts(&document, "coarse");
    let entries = document.get("expect").expect("`expect`").get_ref();
    let entry = |table: &DeTable<'_>| {
        let known = ["column", "at", "point", "value", "within", "known_to", "source", "set"];
        assert!(table.keys().all(|key| known.contains(&&**key.get_ref())), "{table:?}");
        let source = text(table, "source").filter(|source| !source.is_empty());
        Expected {
            options: [&coarse[..], &texts(table, "set")[..]].concat(),
            column: text(table, "column").expect("`column`"),
            at: text(table, "at"),
            point: text(table, "point"),
            value: text(table, "value").expect("`value`"),
            within: float(table, "within").expect("`within`"),
            known_to: float(table, "known_to"),
            source: source.unwrap_or_else(|| panic!("no source in {table:?}")),
        }
    };
    let entries = entries.as_array().expect("`[[expect]]`").iter();
    entries.map(|table| entry(table.get_ref().as_table().expect("a table"))).collect()
}

/// Columns without a unit.
const PURE: [&str; 8] = [
    "revolutions",
    "meshes",
    "share",
    "cycle",
    "turns",
    "true_cycles",
    "creepage",
    "lateral_creepage",
];

/// What a column holds, by the unit at the end of its name; `None` for a pure number.
fn measure(column: &str) -> Option<Measure> {
    let measure = match column.rsplit('_').next() {
        _ if PURE.contains(&column) => return None,
        _ if column.ends_with("_m3_per_Nm") => Measure::WEAR_COEFFICIENT,
        Some("m") => Measure::LENGTH,
        Some("m2") => Measure::length_to_the(2.0),
        Some("m3") => Measure::length_to_the(3.0),
        Some("Pa") => Measure::PRESSURE,
        Some("N") => Measure::FORCE,
        Some("K") => Measure::in_si("a difference of temperatures", "K").expect("a unit"),
        Some("Nm" | "J") => Measure { dimension: Dimension::ENERGY, ..Measure::FORCE },
        _ => panic!("the column `{column}` has no unit known here"),
    };
    Some(measure)
}

/// A value of a column (SI).
fn read(text: &str, column: &str) -> f64 {
    match measure(column) {
        Some(measure) => units::read(text, &measure).expect("a value with its unit"),
        None => text.parse().expect("a number"),
    }
}

/// What a case gives: a row a step, and a row a point inside of a body.
struct Results {
    points: Vec<(String, Vec<(String, f64)>)>,
    rows: Rows,
}

/// The results of the case in a folder, run with these options.
fn run(folder: &Path, options: &[String], store: &Store) -> Result<Results, String> {
    let file = CaseFile::read(folder).map_err(|error| error.to_string())?;
    let file = options.iter().fold(file, |file, option| file.set(option));
    let task = file.task().map_err(|problems| {
        problems.iter().map(|problem| file.describe(problem)).collect::<Vec<_>>().join("\n")
    })?;
    let resolved = match task {
        Task::Contact(resolved) => resolved,
        Task::Elastic(resolved) => {
            let body = resolved.case.build().map_err(|error| error.to_string())?;
            let deformed = body.solve().map_err(|error| error.to_string())?;
            let points = named(&body.points, &deformed.points);
            return Ok(Results { points, rows: Rows::default() });
        }
        Task::Cam(resolved) => {
            let results = resolved.case.solve().map_err(|problem| problem.title())?;
            return Ok(Results { points: vec![], rows: Rows(results.course()) });
        }
        Task::Gear(resolved) => {
            let results = resolved.case.solve().map_err(|problem| problem.title())?;
            return Ok(Results { points: vec![], rows: Rows(results.course()) });
        }
        Task::WheelRail(resolved) => {
            let results = resolved.case.solve(|_, _| ControlFlow::Continue(()));
            let results = results.map_err(|error| error.to_string())?;
            // What wears is told last, a row a step.
            let patches = results.contacts.iter().flat_map(|contact| &contact.patches);
            let steps = results.wear.iter().flat_map(RailWear::rows);
            let rows = patches.map(contact_row).chain(steps.map(|(_, row)| row)).collect();
            return Ok(Results { points: vec![], rows: Rows(rows) });
        }
    };
    // Cases of the same body share its compliance.
    let settled = resolved.settle(&mut |case| Ok(case.build_keeping(store)?), &mut |_| Ok(()));
    let (resolved, simulation) = settled.map_err(|error| error.to_string())?;
    let (mut rows, mut last) = (Rows::default(), Last::default());
    simulation.run(&mut [&mut rows, &mut last]).map_err(|error| error.to_string())?;
    let problem = &simulation.problem;
    let mut points = vec![];
    for which in 0..2 {
        let bodies = problem.bodies.each_ref();
        let Some((frame, tractions)) = &last.0 else { continue };
        let placed = (which, offsets(&problem.bodies, &problem.motion));
        let pressed = PressedHalfSpace::with_ends(bodies, placed, frame, tractions);
        if let Some(pressed) = pressed.map_err(|error| error.to_string())? {
            let wanted = &resolved.case.points[which];
            let found = pressed.both_sides(wanted).map_err(|error| error.to_string())?;
            points.extend(named(&found.0, &found.1));
        }
    }
    Ok(Results { points, rows })
}

/// The last tractions, and the frame that they are on, which may have grown.
#[derive(Default)]
struct Last(Option<(ContactFrame, VectorField)>);

impl Observer for Last {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn Error + Send + Sync>> {
        let tractions = report.problem.tractions(report.state);
        self.0 = Some((report.problem.frame.clone(), tractions));
        Ok(())
    }
}

/// A row a point.
fn named(points: &[Point], found: &[Response]) -> Vec<(String, Vec<(String, f64)>)> {
    let rows = points.iter().zip(found);
    rows.map(|(point, response)| (point.name.clone(), elastic::row(response))).collect()
}

/// The number in a column at a point or at the given progress, which is the first column.
fn number(Results { points, rows }: &Results, expected: &Expected) -> Option<f64> {
    let Expected { column, at, point, .. } = expected;
    let row = match (at, point) {
        (None, None) => rows.0.last()?,
        (_, Some(name)) => &points.iter().find(|(known, _)| known == name)?.1,
        (Some(at), None) => {
            let place = read(at, &rows.0.first()?.first()?.0);
            rows.0.iter().find(|row| (row[0].1 - place).abs() <= 1e-9 * place)?
        }
    };
    row.iter().find_map(|(known, value)| (known == column).then_some(*value))
}

/// What a case gives, and what it gives otherwise than it has to.
fn outcome(folder: &Path, store: &Store) -> (Vec<Line>, Vec<String>) {
    let case = folder.file_name().unwrap().to_string_lossy().into_owned();
    let Ok(file) = fs::read_to_string(folder.join("expected.toml")) else {
        return (vec![], vec![format!("{case}: there is no expected.toml")]);
    };
    let mut runs: Vec<(Vec<String>, Result<Results, String>)> = vec![];
    let (mut lines, mut mismatches) = (vec![], vec![]);
    for one in expected(&file) {
        if !runs.iter().any(|(options, _)| *options == one.options) {
            runs.push((one.options.clone(), run(folder, &one.options, store)));
        }
        let results = &runs.iter().find(|(options, _)| *options == one.options).unwrap().1;
        let at = one.at.as_ref().or(one.point.as_ref());
        let name = format!("{case}: {} at {at:?} with {:?}", one.column, one.options);
        let found = match results {
            Err(error) => {
                mismatches.push(format!("{name}: {error}"));
                continue;
            }
            Ok(results) => number(results, &one),
        };
        let value = read(&one.value, &one.column);
        let Some(found) = found else {
            mismatches.push(format!("{name}: no such number"));
            continue;
        };
        if (found - value).abs() > one.within * value.abs() {
            let difference = found / value - 1.0;
            mismatches.push(format!("{name}: {found:e} is {difference:+.2e} from {}", one.value));
        }
        lines.push(Line { case: case.clone(), expected: one, found });
    }
    if lines.is_empty() && mismatches.is_empty() {
        mismatches.push(format!("{case}: expects nothing"));
    }
    (lines, mismatches)
}

#[test]
#[ignore = "long: in .ci/long"]
fn every_case_gives_what_it_has_to_and_the_page_says_so() {
    let folders = folders();
    let kept = tempfile::tempdir().unwrap();
    let store = Store::new(kept.path());
    assert!(folders.len() >= 3, "{folders:?}");
    // Most cases are too small to keep several processors busy: each takes one after the other.
    let (waiting, report) = (Mutex::new(folders.iter()), Mutex::new((vec![], vec![])));
    let work = || {
        loop {
            let Some(folder) = waiting.lock().unwrap().next() else { return };
            let (lines, mismatches) = outcome(folder, &store);
            let mut report = report.lock().unwrap();
            report.0.extend(lines);
            report.1.extend(mismatches);
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, NonZero::get) {
            scope.spawn(work);
        }
    });
    let (lines, mismatches) = report.into_inner().unwrap();
    assert!(mismatches.is_empty(), "\n{}", mismatches.join("\n"));
    let stale = held(lines);
    assert!(stale.is_empty(), "\n{}", stale.join("\n"));
}

/// The options of the commands a `README.md` shows: `--set KEY=VALUE`, quoted as for a shell.
fn options_shown(readme: &str) -> Vec<Vec<String>> {
    let joined = readme.replace("\\\n", " ");
    let commands = joined.lines().filter(|line| line.trim_start().starts_with("cargo run"));
    commands.map(|command| command.split(" --set ").skip(1).map(unquoted).collect()).collect()
}

/// The first word of a command line, without the quotes a shell removes.
fn unquoted(text: &str) -> String {
    let (mut word, mut quote) = (String::new(), None);
    for letter in text.trim_start().chars() {
        match (quote, letter) {
            (Some(open), _) if open == letter => quote = None,
            (None, '"' | '\'') => quote = Some(letter),
            (None, ' ') => break,
            _ => word.push(letter),
        }
    }
    word
}

#[test]
fn the_gallery_shows_every_case() {
    assert_eq!(published::gallery::held(&folders()), None);
}

#[test]
#[ignore = "long: in .ci/long"]
fn every_case_explains_itself_in_commands_that_are_right() {
    for folder in folders() {
        let readme = fs::read_to_string(folder.join("README.md")).expect("a README.md");
        let commands = options_shown(&readme);
        assert!(!commands.is_empty(), "{} shows no command", folder.display());
        for options in commands {
            let file = CaseFile::read(&folder).unwrap();
            let file = options.iter().fold(file, |file, option| file.set(option));
            assert!(file.task().is_ok(), "{}: {options:?}", folder.display());
        }
    }
}
