//! The wear of several runs on one picture.

use std::path::{Path, PathBuf};

use anyhow::{Result, ensure};
use archard::simulation::history::{BODY_DEPTH, WEAR_DEPTH, of_body};

use super::CELLS;
use super::figure::{self, Curves, PALE, Panel, Pen, View};
use super::results::Results;
use super::scale::{Unit, phrase};
use super::tables::largest;

/// Colours of the runs, the first of them under all others; those of the second on are black, vermilion,
/// green, purple and blue of M. Okabe and K. Ito.
const COLOURS: [&str; 6] =
    [PALE[1], figure::COLOURS[0], figure::COLOURS[2], "#009e73", "#cc79a7", figure::COLOURS[1]];
/// Where along the axis the bodies are named.
const NAMED_AT: f64 = 0.8;
/// How far below the curve, relative to the deepest wear.
const NAMED_BELOW: f64 = 0.09;

/// The deepest wear of each body and of all over the progress, for the run in `dir` and those in
/// `others`.
pub(crate) fn panel(dir: &Path, first: &Results, others: &[PathBuf]) -> Result<Panel> {
    let read: Vec<Results> = others.iter().map(|dir| Results::read(dir)).collect::<Result<_>>()?;
    let runs: Vec<&Results> = [first].into_iter().chain(&read).collect();
    let dirs: Vec<&Path> = [dir].into_iter().chain(others.iter().map(PathBuf::as_path)).collect();
    require_one_progress(&runs, &dirs)?;
    let most = |run: &&Results| run.history.column(WEAR_DEPTH).map_or(0.0, largest);
    let deepest = runs.iter().map(most).fold(0.0, f64::max);
    ensure!(deepest > 0.0, "nothing has worn in these runs, so there is nothing to compare");
    let column = first.progress().0;
    let end = runs.iter().map(|run| largest(run.progress().1)).fold(0.0, f64::max);
    let (along, unit) = (Unit::of_column(column, end), Unit::depth(deepest));
    let quantities = quantities(&runs);
    let mut curves = Curves::new();
    for (index, (run, name)) in runs.iter().zip(names(&dirs)).enumerate() {
        let mut legend = Some(&*name);
        for (quantity, _) in &quantities {
            let Ok(depths) = run.history.column(quantity) else { continue };
            let points = run.progress().1.iter().zip(depths);
            let points = points.map(|(s, depth)| (s * along.factor, depth * unit.factor));
            let colour = COLOURS[index % COLOURS.len()];
            match (index, depths.len() <= CELLS) {
                (0, _) => curves.add(points, Pen::under(colour), legend.take()),
                (_, true) => curves.mark(points, colour, legend.take()),
                (_, false) => curves.add(points, Pen::line(colour), legend.take()),
            }
        }
    }
    let note = |(quantity, name): &(String, &str)| {
        let place = NAMED_AT * end;
        let below = value_at(first, quantity, place)? - NAMED_BELOW * deepest;
        Some((name.to_string(), [place * along.factor, below * unit.factor]))
    };
    let notes = quantities.iter().filter_map(note);
    let labels = ["Wear depth", &along.label(&phrase(column)), &unit.label("Wear depth")];
    Ok(curves.panel(labels, |view| {
        let view = view.below_x(end * along.factor).above_y(0.0);
        notes.fold(view, |view: View, (words, place)| view.note(words, place))
    }))
}

/// Refuses runs whose motions are not measured equally.
fn require_one_progress(runs: &[&Results], dirs: &[&Path]) -> Result<()> {
    let column = runs[0].progress().0;
    for (run, dir) in runs.iter().zip(dirs) {
        let other = run.progress().0;
        ensure!(
            other == column,
            "`{}` cannot be compared: its progress is `{other}`, that of `{}` is `{column}`",
            dir.display(),
            dirs[0].display()
        );
    }
    Ok(())
}

/// Columns to compare and what to call them: the bodies that wear, and both together.
fn quantities<'a>(runs: &[&'a Results]) -> Vec<(String, &'a str)> {
    let wears = |column: &str| {
        runs.iter().any(|run| run.history.column(column).is_ok_and(|depths| largest(depths) > 0.0))
    };
    let bodies = runs.first().map(|run| &*run.bodies).unwrap_or_default();
    let mut quantities: Vec<(String, &str)> = bodies
        .iter()
        .map(|body| (of_body(BODY_DEPTH, body), &**body))
        .filter(|(column, _)| wears(column))
        .collect();
    if quantities.len() != 1 {
        quantities.push((WEAR_DEPTH.to_owned(), "both"));
    }
    quantities
}

/// The names of the folders, or all of their paths where two names are the same.
fn names(dirs: &[&Path]) -> Vec<String> {
    let name = |dir: &Path| {
        let dir = dir.canonicalize().unwrap_or_else(|_| dir.to_owned());
        dir.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
    };
    let names: Vec<String> = dirs.iter().map(|dir| name(dir)).collect();
    let twice = |name: &String| names.iter().filter(|other| *other == name).count() > 1;
    if names.iter().any(twice) {
        return dirs.iter().map(|dir| dir.display().to_string()).collect();
    }
    names
}

/// The value of a column where a run has come to a place, between two steps.
fn value_at(run: &Results, column: &str, place: f64) -> Option<f64> {
    let (progress, values) = (run.progress().1, run.history.column(column).ok()?);
    let next = progress.partition_point(|known| *known < place);
    let (from, to) = (next.checked_sub(1)?, next.min(progress.len() - 1));
    let span = progress[to] - progress[from];
    let share = if span > 0.0 { (place - progress[from]) / span } else { 0.0 };
    Some(values[from] + share * (values[to] - values[from]))
}
