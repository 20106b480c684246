//! The fields of all outputs, packed for the maps and the surfaces of a page.

use std::path::{Path, PathBuf};

use anyhow::Result;
use archard::output::{Collection, Image, Surface};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

use super::figures::rounded;
use crate::plot::cells::Cells;
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
    if shape.contains(&0) {
        return Ok(None);
    }
    let shown = shown.map(|shown| {
        STANDARD.encode(shown.iter().flat_map(|part| part.to_le_bytes()).collect::<Vec<u8>>())
    });
    let across = Unit::across(windows.into_iter().flatten().map(f64::abs).fold(0.0, f64::max));
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
    Ok(Some(Maps { value, left_out: all.len() - count, resampled }))
}

/// The outputs as a page shows them.
struct Seen {
    /// Lowest and highest place (m) along x and along y.
    edges: [[f64; 2]; 2],
    /// Columns and rows.
    shape: [usize; 2],
    /// Of meshed bodies the element that each cell shows, a row along x after the other; -1 beside them.
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
    /// Whole numbers of 16 bits, little endian, and what one of them is worth in the unit; the least of them is none.
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
