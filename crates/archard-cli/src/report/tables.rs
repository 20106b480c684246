//! What a run came to, in tables: its numbers and its verdict.

use archard::motion::Control;
use archard::numerics::SAME;
use archard::simulation::history::{
    APPROACH, BODY_DEPTH, COLUMNS, CONTACT_AREA, CREEPAGE, CYCLE, Column, ERROR, FLASH_TEMPERATURE,
    FORCE, LOAD, MASS_LOSS, MEAN_FLASH_TEMPERATURE, PEAK_PRESSURE, SCAR, SHIFT, TRACK_WIDTH,
    WEAR_DEPTH, WEAR_RATE, WORN_SECTION, WORN_VOLUME, body_of, is_error, of_body,
};
use serde_json::Value;

use super::page::{Table, capital};
use super::words::{plain, quantity};
use crate::number::{count, percent};
use crate::plot::results::Results;
use crate::plot::scale::phrase;
use crate::plot::tables::size;

/// Columns that say how a run was computed, not what came of it.
const WORK: [&str; 8] = [
    "iterations",
    "residual",
    "solves",
    "rejected",
    "true_cycles",
    "time_error",
    "space_error",
    ERROR,
];

/// The last row of the history, each number with the error that is stated for it.
pub(super) fn results(results: &Results) -> Table {
    let history = &results.history;
    let last = |column: &str| history.column(column).ok().and_then(|values| values.last().copied());
    let still = |name: &str| {
        let whose = results.bodies.iter().position(|body| {
            let belongs = |column: &Column| body_of(column.name, name) == Some(body.as_str());
            COLUMNS.iter().any(belongs)
        });
        whose.is_some_and(|body| !results.has_worn(body))
    };
    let worn = (0..results.bodies.len()).filter(|&body| results.has_worn(body)).count();
    let mut rows = Vec::new();
    for name in history.names() {
        let errors = is_error(name);
        let Some(value) = last(name).filter(|value| value.is_finite() && !errors) else { continue };
        // What does not wear has nothing to say, and of one body the depth is that of both.
        let twice = name == WEAR_DEPTH && worn < 2;
        if WORK.contains(&name) || still(name) || twice {
            continue;
        }
        let (label, unit) = match label(&results.bodies, name) {
            (label, unit) if name == WEAR_DEPTH => (format!("{label} of both"), unit),
            named => named,
        };
        let value = but_rounding(results, name, (value, unit));
        let whole = unit.is_empty() && value == value.round();
        let shown = if whole { count(value) } else { quantity(value, unit) };
        rows.push(vec![label, shown, error(results, name, value, unit)]);
    }
    let (column, values) = results.progress();
    let end = values.last().copied().unwrap_or_default();
    let end = quantity(
        end,
        COLUMNS_OF_PROGRESS.iter().find(|(known, _)| *known == column).map_or("", |(_, unit)| unit),
    );
    let mut heads = vec!["Quantity", "Value", "Error"];
    if !states_errors(results) {
        heads.pop();
        rows.iter_mut().for_each(|row: &mut Vec<String>| row.truncate(2));
    }
    Table { caption: format!("Numbers at {} {end}", phrase(column).to_lowercase()), heads, rows }
}

/// Whether a run states errors at all.
fn states_errors(results: &Results) -> bool {
    results.history.names().any(is_error)
}

/// Units of forces and moments.
const FORCES: [&str; 2] = ["N", "Nm"];

/// What is nothing but rounding in a column: a force (N) or moment (N m) under the load, a component next to the other.
fn rounding(results: &Results, name: &str, unit: &str) -> f64 {
    let column = |name: &str| results.history.column(name).unwrap_or_default();
    if FORCES.contains(&unit) {
        return SAME * column(LOAD).last().copied().unwrap_or_default();
    }
    let pair = [SHIFT, CREEPAGE].into_iter().find(|pair| pair.contains(&name));
    SAME * pair.into_iter().flatten().map(|name| size(column(name))).fold(0.0, f64::max)
}

/// A value of a column, zero where it is nothing but rounding.
fn but_rounding(results: &Results, name: &str, (value, unit): (f64, &str)) -> f64 {
    if value.abs() < rounding(results, name, unit) { 0.0 } else { value }
}

/// What a case may prescribe, besides how far the motion goes.
const PRESCRIBED: [&str; 8] =
    [LOAD, APPROACH, SHIFT[0], SHIFT[1], FORCE[0], FORCE[1], CREEPAGE[0], CREEPAGE[1]];

/// The error of a number, or why it has none.
fn error(results: &Results, name: &str, value: f64, unit: &str) -> String {
    let prescribed = PRESCRIBED.contains(&name);
    let (progress, _) = results.progress();
    if [progress, "turns", "time_s", CYCLE].contains(&name) {
        return "prescribed".to_owned();
    }
    if name == APPROACH && is_pressed_by_approach(results) {
        return "prescribed".to_owned();
    }
    match stated(results, name) {
        // What symmetry makes nothing.
        Some(error) if value == 0.0 && error <= rounding(results, name, unit) => "exact".to_owned(),
        Some(error) if error <= SAME * value.abs() && prescribed => "prescribed".to_owned(),
        Some(error) if error <= SAME * value.abs() => "exact".to_owned(),
        Some(error) if value != 0.0 => format!("± {}", percent(error / value.abs())),
        Some(error) => format!("± {}", quantity(error, unit)),
        None => reason(name).to_owned(),
    }
}

/// Whether the case gives the approach, and the load is what came of it.
fn is_pressed_by_approach(results: &Results) -> bool {
    let planned = results.case.as_ref().and_then(|case| case.motion.build().ok());
    planned.is_some_and(|(_, schedule)| matches!(schedule.control, Control::Approach(_)))
}

/// The error that is stated of a column, or of the worn volume that it is a multiple of.
fn stated(results: &Results, name: &str) -> Option<f64> {
    let of = |column: &str| results.error(column).and_then(|errors| errors.last().copied());
    let last = |column: &str| results.history.column(column).ok()?.last().copied();
    let of_volume = || {
        let multiple = |body: &String| {
            [MASS_LOSS, WEAR_RATE].into_iter().any(|own| of_body(own, body) == name)
        };
        let volume = of_body(WORN_VOLUME, results.bodies.iter().find(|body| multiple(body))?);
        let relative = of(&volume)? / last(&volume).filter(|volume| *volume > 0.0)?;
        Some(relative * last(name)?.abs())
    };
    of(name).or_else(of_volume)
}

/// Why no error is stated of a column.
fn reason(name: &str) -> &'static str {
    match name {
        _ if SCAR.contains(&name) || name == TRACK_WIDTH => {
            "not estimated: about one element at each end"
        }
        FLASH_TEMPERATURE | MEAN_FLASH_TEMPERATURE => "not estimated: follows the pressures",
        _ => "not estimated: does not count for the accuracy",
    }
}

/// The columns of the progress that have units.
const COLUMNS_OF_PROGRESS: [(&str, &str); 2] = [("distance_m", "m"), ("time_s", "s")];

/// What a column is called, with its body where it belongs to one, and its unit.
pub(super) fn label(bodies: &[String], name: &str) -> (String, &'static str) {
    let called = |name: &str, unit: &str| {
        let bare = name.strip_suffix(unit).map_or(name, |bare| bare.trim_end_matches('_'));
        phrase(if unit.is_empty() { name } else { bare })
    };
    if let Some(column) = COLUMNS.iter().find(|column| column.name == name) {
        return (called(name, column.unit), column.unit);
    }
    for body in bodies {
        let belongs = |column: &&Column| body_of(column.name, name) == Some(body.as_str());
        if let Some(column) = COLUMNS.iter().find(belongs) {
            let bare = column.name.replacen("_BODY", "", 1);
            return (format!("{} of {body}", called(&bare, column.unit)), column.unit);
        }
    }
    let unit = COLUMNS_OF_PROGRESS.iter().find(|(known, _)| *known == name);
    let unit = unit.map_or("", |(_, unit)| unit);
    (called(name, unit), unit)
}

/// What is read first: name, value and error of a few numbers at the end.
pub(super) fn first(results: &Results) -> Vec<[String; 3]> {
    let last = |column: &str| {
        let values = results.history.column(column).ok()?;
        values.last().copied().filter(|value| *value != 0.0)
    };
    let mut names: Vec<String> = Vec::new();
    for body in &results.bodies {
        names.extend([BODY_DEPTH, WORN_VOLUME, WORN_SECTION].map(|column| of_body(column, body)));
    }
    if names.iter().all(|name| last(name).is_none()) {
        names.extend([LOAD, APPROACH, CONTACT_AREA, FORCE[0]].map(str::to_owned));
    }
    names.extend([SCAR[0], SCAR[1], TRACK_WIDTH].map(str::to_owned));
    names.extend([PEAK_PRESSURE, FLASH_TEMPERATURE].map(str::to_owned));
    let errors = states_errors(results);
    let shown = |name: String| {
        let (label, unit) = label(&results.bodies, &name);
        let value = but_rounding(results, &name, (last(&name)?, unit));
        if value == 0.0 {
            return None;
        }
        let error = if errors { error(results, &name, value, unit) } else { String::new() };
        let error = if error.starts_with("not") { String::new() } else { error };
        Some([label, quantity(value, unit), error])
    };
    names.into_iter().filter_map(shown).collect()
}

/// The verdict, line by line.
pub(super) fn verdict(summary: &Value) -> Table {
    let lines = summary["verdict"]["lines"].as_array().map_or(&[][..], Vec::as_slice);
    let row = |line: &Value| {
        let text = |key: &str| line[key].as_str().map(str::to_owned);
        // Summaries of earlier versions have no words of their own.
        let value = || line["value"].as_f64().map_or_else(|| "no number".to_owned(), plain);
        let words = text("words");
        let words =
            words.unwrap_or_else(|| format!("{} {}", value(), text("text").unwrap_or_default()));
        let [subject, word] = ["subject", "word"].map(|key| text(key).unwrap_or_default());
        vec![capital(&subject), word, words]
    };
    Table {
        caption: "What was judged".to_owned(),
        heads: vec!["Check", "Verdict", "Finding"],
        rows: lines.iter().map(row).collect(),
    }
}
