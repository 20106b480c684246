//! Readings taken as a motion went on next to the history of a run.

use anyhow::{Context, Result, ensure};
use archard::motion::Progress;
use archard::simulation::history::{BODY_DEPTH, MASS_LOSS, WORN_SECTION, WORN_VOLUME, of_body};
use archard::units::Measure;
use archard_case::measured::Table;
use archard_case::verdict::Verdict;

use super::{Comparison, percent, unused};
use crate::plot::figure::{COLOURS, Curves, PALE, Pen};
use crate::plot::results::Results;
use crate::plot::scale::{Unit, phrase};
use crate::plot::tables::{largest, size};
use crate::report::quantity;

/// Names of what measures a motion, with the column of the history and the measure.
fn courses() -> [(&'static str, &'static str, Measure); 6] {
    [
        ("distance", "distance_m", Measure::LENGTH),
        ("revolutions", "revolutions", Measure::NUMBER),
        ("cycles", "cycle", Measure::NUMBER),
        ("cycle", "cycle", Measure::NUMBER),
        ("turns", "turns", Measure::NUMBER),
        ("time", Progress::TIME.column, Measure::TIME),
    ]
}

/// Names of readings of a body, with the column of the history, the measure, its SI unit and the unit of pictures.
type Quantity = (&'static str, &'static str, Measure, &'static str, fn(f64) -> Unit);

fn quantities() -> [Quantity; 4] {
    [
        ("depth", BODY_DEPTH, Measure::LENGTH, "m", Unit::depth),
        ("volume", WORN_VOLUME, Measure::VOLUME, "m3", Unit::volume),
        ("section", WORN_SECTION, Measure::AREA, "m2", Unit::section),
        ("mass", MASS_LOSS, Measure::MASS, "kg", Unit::mass),
    ]
}

/// Compares what is worn off a body with readings.
pub(super) fn compare(results: &Results, table: &Table, body: usize) -> Result<Comparison> {
    let name = &results.bodies[body];
    let known = courses().into_iter().find(|(called, column, _)| {
        table.names().any(|known| known == *called) && results.history.column(column).is_ok()
    });
    let (course, column, measure) = known.with_context(|| {
        let names: Vec<&str> = courses()
            .into_iter()
            .filter(|(_, column, _)| results.history.column(column).is_ok())
            .map(|(called, ..)| called)
            .collect();
        format!(
            "`{}` has neither a column x or y, as profiles have, nor one of {}, as readings over the motion of this run have; its columns are {}. Name one by --column, like distance=\"Weg [m]\"",
            table.source(),
            names.join(", "),
            table.titles()
        )
    })?;
    let places = table.all_numbers(course, &measure)?;
    let progress = results.history.column(column)?;
    let mut comparison = Comparison {
        title: format!("{name} over the {course} compared with `{}`", table.source()),
        lines: vec![],
        remarks: vec![],
        verdict: Verdict::default(),
        panels: vec![],
    };
    let mut used = vec![course];
    for (called, column, measure, si, unit) in quantities() {
        let Some(values) = table.numbers(called, &measure)? else { continue };
        let column = of_body(column, name);
        let Ok(computed) = results.history.column(&column) else {
            let why =
                if called == "mass" { "give the body its density" } else { "this run has none" };
            comparison.doubt(&format!("not compared: {called} of {name}; {why}"));
            continue;
        };
        used.push(called);
        let mut taken = vec![];
        for (row, (&far, value)) in places.iter().zip(values).enumerate() {
            let Some(value) = value else { continue };
            table.worn(row, (course, far), (called, value))?;
            taken.push((far, value));
        }
        add(
            results,
            &mut comparison,
            (course, progress),
            Compared { called, si, unit, computed, body },
            &taken,
        )?;
    }
    ensure!(
        !comparison.panels.is_empty(),
        "`{}` has no reading of depth, volume, section or mass that this run has too; its columns are {}. Name one by --column, like depth=\"Tiefe [um]\"",
        table.source(),
        table.titles()
    );
    comparison.remarks.extend(unused(table, &used));
    Ok(comparison)
}

/// A quantity of a body, its SI unit and that of pictures, and its history.
struct Compared<'a> {
    called: &'a str,
    si: &'a str,
    unit: fn(f64) -> Unit,
    computed: &'a [f64],
    body: usize,
}

/// Adds one quantity.
fn add(
    results: &Results,
    comparison: &mut Comparison,
    (course, progress): (&str, &[f64]),
    compared: Compared<'_>,
    taken: &[(f64, f64)],
) -> Result<()> {
    let Compared { called, si, unit, computed, body } = compared;
    let end = largest(progress);
    let within: Vec<(f64, f64)> =
        taken.iter().copied().filter(|(s, _)| (0.0..=end * (1.0 + 1e-9)).contains(s)).collect();
    ensure!(
        !within.is_empty(),
        "no reading of the {called} was taken within the run, which ends at {course} {}",
        Unit::of_column(results.progress().0, end).show(end)
    );
    if within.len() < taken.len() {
        comparison.doubt(&format!(
            "readings of the {called} beyond the end of the run, left out: {}",
            taken.len() - within.len()
        ));
    }
    let pairs: Vec<(f64, f64)> =
        within.iter().map(|(s, value)| (*value, value_at(progress, computed, *s))).collect();
    let rms = (pairs.iter().map(|(m, c)| (c - m).powi(2)).sum::<f64>() / pairs.len() as f64).sqrt();
    let (measured, last) = pairs[pairs.len() - 1];
    let line = |name: String, value: String| [name, value];
    comparison.lines.push(line(format!("{called}: readings"), within.len().to_string()));
    let most = pairs.iter().map(|pair| pair.0.abs().max(pair.1.abs())).fold(0.0, f64::max);
    comparison.lines.push(line(
        format!("{called}: difference, RMS"),
        format!("{}, {:.1} % of the largest", quantity(rms, si), 100.0 * rms / most),
    ));
    comparison.lines.push(line(
        format!("{called}: at the last reading"),
        format!(
            "measured {}, computed {}: {}",
            quantity(measured, si),
            quantity(last, si),
            percent(measured, last)
        ),
    ));
    let along = Unit::of_column(
        if course == "distance" {
            "distance_m"
        } else if course == "time" {
            "time_s"
        } else {
            course
        },
        end,
    );
    let unit = unit(most.max(size(computed)));
    let mut curves = Curves::new();
    let points =
        progress.iter().zip(computed).map(|(s, value)| (s * along.factor, value * unit.factor));
    curves.add(points, Pen::line(COLOURS[1 + body % 2]), Some("computed"));
    curves.mark(
        taken.iter().map(|(s, value)| (s * along.factor, value * unit.factor)),
        PALE[1 + body % 2],
        Some("measured"),
    );
    let title = format!("{} of {}", phrase(called), results.bodies[body]);
    let labels = [&*title, &along.label(&phrase(course)), &unit.label(&phrase(called))];
    comparison.panels.push(curves.panel(labels, |view| view.above_y(0.0)));
    Ok(())
}

/// The value between two steps.
fn value_at(progress: &[f64], values: &[f64], place: f64) -> f64 {
    let next = progress.partition_point(|known| *known < place).min(progress.len() - 1);
    let before = next.saturating_sub(1);
    let span = progress[next] - progress[before];
    let share = if span > 0.0 { ((place - progress[before]) / span).min(1.0) } else { 0.0 };
    values[before] + share * (values[next] - values[before])
}
