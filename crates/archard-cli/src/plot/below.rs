//! Sections through bodies: the equivalent stress over the peak pressure, with the contact and the layers.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use archard::numerics::WRITTEN;
use archard::simulation::history::PEAK_PRESSURE;
use archard_case::output::Sheet;

use super::figure::{COLOURS, Contours, Curves, Panel, Pen, View};
use super::results::Results;
use super::scale::Unit;
use super::tables::Axis;
use super::{LINE, MAP, Picture, shakedown};

/// Most lines of a section, whose values are in steps of 1, 2 or 5.
const LINES: f64 = 9.0;
/// Share of a section next to the surface that holds no words.
const BARE: f64 = 0.04;
/// Dashes of a line across a section.
const DASHES: usize = 40;

/// The sections of a result folder, by their names.
pub(super) fn sheets(dir: &Path) -> Result<Vec<(String, Sheet)>> {
    let Ok(entries) = fs::read_dir(dir.join("sections")) else { return Ok(vec![]) };
    let files = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let mut files: Vec<_> =
        files.filter(|file| file.extension().is_some_and(|end| end == "vtu")).collect();
    files.sort();
    let read = |file: &std::path::PathBuf| {
        let name = file.file_stem().context("a section has no name")?.to_string_lossy();
        Ok((name.into_owned(), Sheet::read(file)?))
    };
    files.iter().map(read).collect()
}

/// Equivalent stresses on a grid that stands on the surface.
struct Grid {
    /// The axis that it runs along, and its place (m) along the other one.
    along: Axis,
    across: f64,
    /// Places (m) along that axis and along z, rising.
    places: [Vec<f64>; 2],
    /// Values (Pa), a row along x after the other; no number where none is known.
    rows: Vec<Vec<f64>>,
}

impl Grid {
    /// Of a section; `None` of one that runs across z or lies askew.
    fn of(sheet: &Sheet) -> Option<Self> {
        let stress = sheet.fields.iter().find(|field| field.name == "von_mises_Pa")?;
        let ends = |axis: usize| {
            let places = sheet.points.iter().map(|point| point[axis]);
            places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], one| {
                [low.min(one), high.max(one)]
            })
        };
        let [[left, right], [near, far], [low, high]] = [0, 1, 2].map(ends);
        let size = (right - left).max(far - near).max(high - low);
        let same = |a: f64, b: f64| (a - b).abs() <= WRITTEN * size;
        let (axis, across) = match () {
            () if same(near, far) => (0, near),
            () if same(left, right) => (1, left),
            () => return None,
        };
        let rising = |axis: usize| {
            let mut places: Vec<f64> = sheet.points.iter().map(|point| point[axis]).collect();
            places.sort_by(f64::total_cmp);
            places.dedup_by(|next, kept| same(*next, *kept));
            places
        };
        let places = [rising(axis), rising(2)];
        let mut rows = vec![vec![f64::NAN; places[0].len()]; places[1].len()];
        for (point, value) in sheet.points.iter().zip(&stress.values) {
            let [column, row] = [(0, point[axis]), (1, point[2])].map(|(own, place)| {
                places[own].partition_point(|known| *known < place && !same(*known, place))
            });
            rows[row][column] = *value;
        }
        let known = rows.iter().flatten().filter(|value| !value.is_nan()).count();
        let along = if axis == 0 { Axis::X } else { Axis::Y };
        // What is askew has other places in each row.
        (places.iter().all(|own| own.len() > 1) && 2 * known >= rows.len() * places[0].len())
            .then_some(Self { along, across, places, rows })
    }

    /// The largest value (Pa), and its column and row.
    fn largest(&self) -> (f64, [usize; 2]) {
        let each = self.rows.iter().enumerate();
        let each = each.flat_map(|(row, values)| {
            values.iter().enumerate().map(move |(column, value)| (*value, [column, row]))
        });
        let none = (f64::NEG_INFINITY, [0, 0]);
        each.fold(none, |best, own| if own.0 > best.0 { own } else { best })
    }
}

/// The sections, and how far the bodies are from yielding and flowing.
pub(super) fn pictures(results: &Results) -> Result<Vec<Picture>> {
    let sections = panels(results)?;
    let sections = (!sections.is_empty()).then(|| Picture::new("below", sections).sized(MAP));
    let map = shakedown::panel(results)?.map(|panel| Picture::new("shakedown", vec![panel]));
    Ok(sections.into_iter().chain(map).collect())
}

/// A panel a section, as far as there was a contact.
fn panels(results: &Results) -> Result<Vec<Panel>> {
    let peak = results.history.column(PEAK_PRESSURE)?.last().copied().unwrap_or_default();
    let grids = results.sheets.iter().filter_map(|(name, sheet)| Some((name, Grid::of(sheet)?)));
    let shown = grids.filter(|(_, grid)| peak > 0.0 && grid.largest().0 > 0.0);
    Ok(shown.map(|(name, grid)| panel(results, (name, peak), &grid)).collect())
}

fn panel(results: &Results, (name, peak): (&str, f64), grid: &Grid) -> Panel {
    let (largest, [column, row]) = grid.largest();
    let levels = levels(largest / peak);
    let [along, up] = &grid.places;
    let size = [along, up].map(|own| own[own.len() - 1] - own[0]);
    let unit = Unit::across(0.5 * size[0].max(size[1]));
    let scaled = |own: &[f64]| own.iter().map(|place| place * unit.factor).collect::<Vec<_>>();
    let over = |row: &Vec<f64>| row.iter().map(|value| value / peak).collect();
    let rows: Vec<Vec<f64>> = grid.rows.iter().map(over).collect();
    // Where lines are named: on the way from the largest value into the body.
    let values: Vec<f64> = rows.iter().map(|row| row[column]).collect();
    let places = [scaled(along), scaled(up)];
    let inward = if up[0].abs() > up[up.len() - 1].abs() { -1 } else { 1 };
    let named: Vec<(String, [f64; 2])> = levels
        .iter()
        .filter_map(|level| {
            let place = crossing((&places[1], &values), (row, inward), *level)?;
            let clear = place.abs() > BARE * size[1] * unit.factor;
            clear.then(|| (trimmed(*level), [places[0][column], place]))
        })
        .collect();
    let ends = [0, 1].map(|own| [places[own][0], places[own][places[own].len() - 1]]);
    let mut curves = Curves::new();
    let worst = (places[0][column], places[1][row]);
    curves.contours(Contours { places, rows, levels }, "over p0");
    let body = results.bodies.iter().position(|body| name.starts_with(&format!("{body}_")));
    for depth in body.map_or(vec![], |body| interfaces(results, body)) {
        let z = f64::from(inward) * depth * unit.factor;
        let dash =
            |index: usize| ends[0][0] + (ends[0][1] - ends[0][0]) * index as f64 / DASHES as f64;
        for index in (0..DASHES).step_by(2).filter(|_| (ends[1][0]..=ends[1][1]).contains(&z)) {
            curves.add([(dash(index), z), (dash(index + 1), z)], Pen::line("#ffffff"), None);
        }
    }
    for [low, high] in pressed(results, grid) {
        let within = [low, high].map(|end| (end * unit.factor).clamp(ends[0][0], ends[0][1]));
        curves.add(within.map(|x| (x, 0.0)), Pen::broad(COLOURS[2]), None);
    }
    curves.mark([worst], COLOURS[2], None);
    let title = format!(
        "Von Mises over p0 = {}: {}, {} = {}",
        Unit::pressure().show(peak),
        name.replace('_', ", "),
        if grid.along == Axis::X { "y" } else { "x" },
        unit.show(if grid.across.abs() < LINE * size[0] { 0.0 } else { grid.across }),
    );
    let labels = [&*title, &unit.label(grid.along.name()), &unit.label("z")];
    curves.panel(labels, |view| {
        let view = View { ends: ends.map(|own| own.map(Some)), to_scale: true, ..view };
        named.into_iter().fold(view, |view, (words, place)| view.note_in(words, place, "#ffffff"))
    })
}

/// Values in steps of 1, 2 or 5 up to the largest.
fn levels(largest: f64) -> Vec<f64> {
    let power = 10f64.powf((largest / LINES).log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|own| own * power);
    let step = step.into_iter().find(|own| largest / own <= LINES).unwrap_or(largest);
    (1..=LINES as usize).map(|line| line as f64 * step).filter(|level| *level < largest).collect()
}

/// A level without needless digits.
fn trimmed(level: f64) -> String {
    let digits = (0..6).find(|digits| {
        let power = 10f64.powi(*digits);
        (level * power - (level * power).round()).abs() < 1e-6
    });
    format!("{level:.*}", digits.unwrap_or(6) as usize)
}

/// The first place from one on, up or down, where values at places pass a level.
fn crossing(
    (places, values): (&[f64], &[f64]),
    (from, step): (usize, i32),
    level: f64,
) -> Option<f64> {
    let next = |index: usize| index.checked_add_signed(step as isize);
    let mut index = from;
    while let Some(other) = next(index).filter(|own| *own < values.len()) {
        let [one, two] = [values[index], values[other]];
        if one >= level && two < level {
            let share = (one - level) / (one - two);
            return Some(places[index] + share * (places[other] - places[index]));
        }
        index = other;
    }
    None
}

/// Depths (m) of the lower faces of the layers of a body.
fn interfaces(results: &Results, body: usize) -> Vec<f64> {
    let Some(case) = &results.case else { return vec![] };
    let layers = case.bodies[body].layers.iter().map(|own| own.layer.thickness);
    layers
        .scan(0.0, |depth, thickness| {
            *depth += thickness;
            Some(*depth)
        })
        .collect()
}

/// Where (m) along a section the surface is pressed, from end to end; none on a mesh, whose places are its own.
fn pressed(results: &Results, grid: &Grid) -> Vec<[f64; 2]> {
    let Some(image) = results.image.as_ref().filter(|_| results.surface.is_none()) else {
        return vec![];
    };
    let Some(pressure) = image.field("pressure_Pa") else { return vec![] };
    let (along, across) = (grid.along.index(), 1 - grid.along.index());
    let line = (grid.across - image.origin[across]) / image.spacing[across];
    let line = (line.floor().max(0.0) as usize).min(image.elements[across] - 1);
    let mut all: Vec<[f64; 2]> = vec![];
    let mut before = false;
    for index in 0..image.elements[along] {
        let element = if along == 0 {
            index + image.elements[0] * line
        } else {
            line + image.elements[0] * index
        };
        let now = pressure[element] > 0.0;
        let [low, high] =
            [-0.5, 0.5].map(|half| image.centre(along, index) + half * image.spacing[along]);
        match all.last_mut() {
            Some(last) if now && before => last[1] = high,
            _ if now => all.push([low, high]),
            _ => {}
        }
        before = now;
    }
    all
}
