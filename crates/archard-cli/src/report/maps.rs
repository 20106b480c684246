//! The fields of all outputs, packed for the maps and the surfaces of a page.

use std::path::{Path, PathBuf};

use anyhow::Result;
use archard_case::output::{Collection, Image, Surface};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

use super::figures::{Figure, rounded};
use crate::plot::CELLS;
use crate::plot::SLENDER;
use crate::plot::cells::Cells;
use crate::plot::figure::{COLOURS, Curves, Map, Mark, Panel, Pen, Shape, View};
use crate::plot::outline;
use crate::plot::results::{Results, within};
use crate::plot::scale::{Unit, phrase};
use crate::plot::tables::{Axis, size};

/// Most outputs shown: they are spread over the run, with its first and last.
const OUTPUTS: usize = 21;
/// The field that every output has.
const PRESSURE: &str = "pressure_Pa";
/// The largest whole number that a value is packed in.
const WHOLE: f64 = 32767.0;

/// Maps of a run, and how many of its outputs they leave out.
pub(super) struct Maps {
    pub(super) value: Value,
    /// The place on the page and the picture of each map at the last output.
    pub(super) pictures: Vec<(String, Figure)>,
    pub(super) left_out: usize,
    /// Whether some were put out on other elements than the last.
    pub(super) resampled: bool,
}

/// A field of all outputs shown.
struct Packed {
    name: String,
    unit: Unit,
    outputs: Vec<Vec<f64>>,
}

/// The maps of the run in a folder; nothing where fields are lines or were not put out.
pub(super) fn of(dir: &Path, results: &Results) -> Result<Option<Maps>> {
    if results.image.is_none() || results.shown_axes().len() < 2 {
        return Ok(None);
    }
    let all = Collection::read(&dir.join("fields.pvd"))?.outputs;
    let count = all.len().min(OUTPUTS);
    let chosen: Vec<_> =
        (0..count).map(|i| &all[i * (all.len() - 1) / (count - 1).max(1)]).collect();
    let windows = [results.worn_window(Axis::X)?, results.worn_window(Axis::Y)?];
    let files = chosen.iter().map(|(_, file)| dir.join(file));
    let seen = match results.surface {
        Some(_) => Seen::elements(files, windows)?,
        None => Seen::cells(files, windows)?,
    };
    let Some(Seen { edges, shape, shown, resampled, .. }) = &seen else { return Ok(None) };
    let (edges, shape, shown, resampled) = (*edges, *shape, shown.as_deref(), *resampled);
    let field = |name: &str| seen.as_ref()?.field(name);
    let mut fields = Vec::new();
    let mut add = |name: String, unit: fn(f64) -> Unit| {
        if let Some(outputs) = field(&name) {
            let most = outputs.iter().map(|values| size(values)).fold(0.0, f64::max);
            fields.push(Packed { unit: unit(most), name, outputs });
        }
    };
    add(PRESSURE.to_owned(), |_| Unit::pressure());
    for name in ["stick", "traction_x_Pa", "traction_y_Pa"] {
        add(name.to_owned(), |_| Unit::share());
    }
    for body in &results.bodies {
        add(format!("wear_{body}_m"), Unit::depth);
        add(format!("height_{body}_m"), Unit::depth);
    }
    let has = |name: &String| fields.iter().any(|field| field.name == *name);
    let whole = results.bodies.iter().all(|body| has(&format!("height_{body}_m")));
    if shape.contains(&0) || !whole {
        return Ok(None);
    }
    let across = Unit::across(windows.into_iter().flatten().map(f64::abs).fold(0.0, f64::max));
    let grid = Grid { edges: edges.map(|ends| ends.map(|end| end * across.factor)), shape, shown };
    let pictures = pictures(results, &fields, (&grid, &across))?;
    let shown = shown.map(|shown| {
        STANDARD.encode(shown.iter().flat_map(|part| part.to_le_bytes()).collect::<Vec<u8>>())
    });
    let places = |axis: usize| -> Vec<f64> {
        let [low, high] = edges[axis];
        let step = (high - low) / shape[axis] as f64;
        (0..shape[axis]).map(|i| rounded((low + (i as f64 + 0.5) * step) * across.factor)).collect()
    };
    let (column, _) = results.progress();
    let progress = results.progress_unit();
    let label = |(at, _): &&(f64, String)| {
        format!("{} {}", phrase(column).to_lowercase(), progress.show(*at))
    };
    let value = json!({
        "x": places(0),
        "y": places(1),
        "across": across.name,
        "outputs": chosen.iter().map(label).collect::<Vec<_>>(),
        "bodies": results.bodies,
        "shown": shown,
        "fields": fields.iter().map(|field| (field.name.clone(), field.packed())).collect::<serde_json::Map<_, _>>(),
    });
    Ok(Some(Maps { value, pictures, left_out: all.len() - count, resampled }))
}

/// The cells of a map: their edges in the unit shown, columns and rows, and of meshed bodies the element of each.
struct Grid<'a> {
    edges: [[f64; 2]; 2],
    shape: [usize; 2],
    shown: Option<&'a [i32]>,
}

impl Grid<'_> {
    /// The values of cells in rows, interpolated between their centres.
    fn rows(&self, values: &[f64], factor: f64) -> Vec<Vec<f64>> {
        let [columns, rows] = self.shape;
        let value = |place: usize| match self.shown {
            None => values[place],
            Some(shown) => usize::try_from(shown[place]).map_or(0.0, |part| values[part]),
        };
        let at = |x: usize, y: usize| {
            let value = factor * value(x + columns * y);
            if value.is_finite() { value } else { 0.0 }
        };
        let (wide, high) = (finer(columns), finer(rows));
        let between = |y: usize, x: usize| {
            let ([x0, x1], u) = neighbours(x, (columns, wide));
            let ([y0, y1], v) = neighbours(y, (rows, high));
            let along = |y: usize| (1.0 - u) * at(x0, y) + u * at(x1, y);
            (1.0 - v) * along(y0) + v * along(y1)
        };
        (0..rows * high).map(|y| (0..columns * wide).map(|x| between(y, x)).collect()).collect()
    }
}

impl Grid<'_> {
    /// The outline of the cells where a field is not zero at the last output, of those of a uniform frame.
    fn outline(&self, field: &Packed) -> Vec<Mark> {
        let values = field.outputs.last().filter(|_| self.shown.is_none());
        let rows: Vec<Vec<f64>> =
            values.iter().flat_map(|own| own.chunks(self.shape[0])).map(<[f64]>::to_vec).collect();
        let lines = outline::around(&rows, self.edges);
        let mark = |line: outline::Line| {
            let shape = Shape::Line(line.to_vec(), Pen::line(COLOURS[2]));
            Mark { shape, legend: None }
        };
        lines.into_iter().map(mark).collect()
    }
}

/// Parts that each of so many cells is divided into.
fn finer(cells: usize) -> usize {
    if cells > 1 { CELLS.div_ceil(cells) } else { 1 }
}

/// The two cells whose centres are nearest to that of a part, and the share of the second.
fn neighbours(part: usize, (cells, parts): (usize, usize)) -> ([usize; 2], f64) {
    let place = ((part as f64 + 0.5) / parts as f64 - 0.5).clamp(0.0, (cells - 1) as f64);
    let low = (place.floor() as usize).min(cells.saturating_sub(2));
    ([low, (low + 1).min(cells - 1)], place - low as f64)
}

/// The pictures of pressure and wear at the last output.
fn pictures(
    results: &Results,
    fields: &[Packed],
    (grid, across): (&Grid<'_>, &Unit),
) -> Result<Vec<(String, Figure)>> {
    let has = |name: &str| fields.iter().any(|field| field.name == name);
    let mut stick = String::new();
    if has("stick") {
        stick += " Inside the orange outline the bodies stick, outside it they slip.";
    }
    if has("traction_x_Pa") {
        stick +=
            " Where scripts run, arrows show the traction on body 1, the longest at its largest.";
    }
    let words = format!("Pressure over the contact at the output chosen.{stick}");
    let mut wanted =
        vec![("map-pressure".to_owned(), PRESSURE.to_owned(), "Pressure".to_owned(), words)];
    for (body, name) in
        results.bodies.iter().enumerate().filter(|(body, _)| results.has_worn(*body))
    {
        let words = format!("Depth worn off {name} at the output chosen.");
        wanted.push((
            format!("map-wear-{body}"),
            format!("wear_{name}_m"),
            format!("Wear of {name}"),
            words,
        ));
    }
    let mut pictures = Vec::new();
    for (id, name, title, words) in wanted {
        if let Some(field) = fields.iter().find(|field| field.name == name) {
            let mut panel = panel((&title, field), (grid, across));
            if let Some(stick) = fields.iter().find(|own| own.name == "stick" && name == PRESSURE) {
                panel.marks.extend(grid.outline(stick));
            }
            pictures.push((id, Figure::pictured(&panel, words)?));
        }
    }
    Ok(pictures)
}

/// The map of a field at the last output.
fn panel((title, field): (&str, &Packed), (grid, across): (&Grid<'_>, &Unit)) -> Panel {
    let values = field.outputs.last().map_or(&[][..], Vec::as_slice);
    let mut curves = Curves::new();
    curves.map(Map { edges: grid.edges, rows: grid.rows(values, field.unit.factor) });
    let [one, other] = grid.edges.map(|[low, high]| high - low);
    let to_scale = one.max(other) <= SLENDER * one.min(other);
    let title = format!("{title} ({})", field.unit.name);
    let labels = [&*title, &across.label("x"), &across.label("y")];
    curves.panel(labels, |view| View { to_scale, ..view })
}

/// The outputs as a page shows them.
struct Seen {
    /// Lowest and highest place (m) along x and along y.
    edges: [[f64; 2]; 2],
    /// Columns and rows.
    shape: [usize; 2],
    /// Of meshed bodies the element that each cell shows, a row along x after the other; -1 next to them.
    shown: Option<Vec<i32>>,
    /// Whether some outputs were on other elements.
    resampled: bool,
    /// The values of a field at every output: of each cell, or of each element where cells show elements.
    values: Values,
}

/// What finds the values of a field at every output.
type Values = Box<dyn Fn(&str) -> Option<Vec<Vec<f64>>>>;

impl Seen {
    fn field(&self, name: &str) -> Option<Vec<Vec<f64>>> {
        (self.values)(name)
    }

    /// Uniform grids, in as many cells as can be told apart.
    fn cells(files: impl Iterator<Item = PathBuf>, windows: [[f64; 2]; 2]) -> Result<Option<Self>> {
        let images: Vec<Image> =
            files.map(|file| Ok(Image::of_output(&file)?)).collect::<Result<_>>()?;
        let Some(last) = images.last() else { return Ok(None) };
        let resampled = images.iter().any(|image| !image.is_on(last));
        let images: Vec<Image> = images.iter().map(|image| image.resampled(last)).collect();
        let Some(first) = images.first() else { return Ok(None) };
        let Some(pressure) = first.field(PRESSURE) else { return Ok(None) };
        let Cells { edges, rows } = Cells::of(first, pressure, windows);
        let shape = [rows.first().map_or(0, Vec::len), rows.len()];
        let values = move |name: &str| {
            let of =
                |image: &Image| Some(Cells::of(image, image.field(name)?, windows).rows.concat());
            images.iter().map(of).collect()
        };
        Ok(Some(Self { edges, shape, shown: None, resampled, values: Box::new(values) }))
    }

    /// Meshed bodies, on their own elements.
    fn elements(
        files: impl Iterator<Item = PathBuf>,
        windows: [[f64; 2]; 2],
    ) -> Result<Option<Self>> {
        let surfaces: Vec<Surface> =
            files.map(|file| Ok(Surface::read(&file)?)).collect::<Result<_>>()?;
        let Some(first) = surfaces.first() else { return Ok(None) };
        let (image, shown) = first.raster();
        let [columns, rows] = [0, 1].map(|axis| {
            let within = |&i: &usize| within(windows[axis], image.centre(axis, i));
            (0..image.elements[axis]).filter(within).collect::<Vec<usize>>()
        });
        let edges = [(0, &columns), (1, &rows)].map(|(axis, cells)| {
            let half = 0.5 * image.spacing[axis];
            let ends = [cells.first(), cells.last()];
            let ends = ends.map(|cell| image.centre(axis, cell.copied().unwrap_or_default()));
            [ends[0] - half, ends[1] + half]
        });
        let cell = |row: usize, column: usize| {
            let part = shown[column + image.elements[0] * row];
            part.and_then(|part| i32::try_from(part).ok()).unwrap_or(-1)
        };
        let shape = [columns.len(), rows.len()];
        let shown = rows.iter().flat_map(|&row| columns.iter().map(move |&column| (row, column)));
        let shown = Some(shown.map(|(row, column)| cell(row, column)).collect());
        let values = move |name: &str| {
            let of = |surface: &Surface| {
                Some(surface.parts(name)?.into_iter().map(|(_, value)| value).collect())
            };
            surfaces.iter().map(of).collect()
        };
        Ok(Some(Self { edges, shape, shown, resampled: false, values: Box::new(values) }))
    }
}

impl Packed {
    /// Whole numbers of 16 bits, little endian, and what one of them is worth in the unit; the least of them stands for a hole.
    fn packed(&self) -> Value {
        let most = self.outputs.iter().map(|values| size(values)).fold(0.0, f64::max);
        let step = if most > 0.0 { most / WHOLE } else { 1.0 };
        let pack = |values: &Vec<f64>| {
            let bytes: Vec<u8> = values
                .iter()
                .flat_map(|value| match value.is_nan() {
                    true => i16::MIN.to_le_bytes(),
                    false => ((value / step).round() as i16).to_le_bytes(),
                })
                .collect();
            STANDARD.encode(bytes)
        };
        json!({
            "unit": self.unit.name,
            "step": step * self.unit.factor,
            "outputs": self.outputs.iter().map(pack).collect::<Vec<_>>(),
        })
    }
}

#[cfg(test)]
mod tests {
    use base64::Engine;
    use base64::engine::general_purpose::STANDARD;

    use super::{Packed, Unit};

    /// What is not known is no number of the page, and no zero either.
    #[test]
    fn what_is_not_known_is_told_from_zero() {
        let outputs = vec![vec![f64::NAN, 0.0, -2e6], vec![1e6, f64::NAN, 2e6]];
        let packed = Packed { name: "one".to_owned(), unit: Unit::pressure(), outputs }.packed();
        let shown = |output: usize| -> Vec<i16> {
            let text = packed["outputs"][output].as_str().unwrap();
            let bytes = STANDARD.decode(text).unwrap();
            bytes.chunks(2).map(|two| i16::from_le_bytes([two[0], two[1]])).collect()
        };
        assert_eq!(shown(0), [i16::MIN, 0, -32767]);
        assert_eq!(shown(1)[1..], [i16::MIN, 32767]);
    }
}
