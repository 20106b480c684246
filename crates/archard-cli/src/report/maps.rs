//! The fields of all outputs, packed for the maps and the surfaces of a page.

use std::path::Path;

use anyhow::Result;
use archard::output::{Collection, Image};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

use super::figures::rounded;
use crate::plot::cells::Cells;
use crate::plot::results::Results;
use crate::plot::scale::{Unit, phrase};
use crate::plot::tables::{Axis, size};

/// Most outputs shown: they are spread over the run, with its first and last.
const OUTPUTS: usize = 21;
/// The largest whole number that a value is packed in.
const WHOLE: f64 = 32767.0;

/// Maps of a run, and how many of its outputs they leave out.
pub(super) struct Maps {
    pub(super) value: Value,
    pub(super) left_out: usize,
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
    let images: Vec<Image> = chosen
        .iter()
        .map(|(_, file)| Ok(Image::of_output(&dir.join(file))?))
        .collect::<Result<_>>()?;
    let windows = [results.worn_window(Axis::X)?, results.worn_window(Axis::Y)?];
    let mut edges = [[0.0; 2]; 2];
    let mut shape = [0, 0];
    let mut field = |name: &str| -> Option<Vec<Vec<f64>>> {
        let outputs = images.iter().map(|image| {
            let cells = Cells::of(image, image.field(name)?, windows);
            edges = cells.edges;
            shape = [cells.rows.first().map_or(0, Vec::len), cells.rows.len()];
            Some(cells.rows.concat())
        });
        outputs.collect()
    };
    let mut fields = Vec::new();
    let mut add = |name: String, unit: fn(f64) -> Unit| {
        if let Some(outputs) = field(&name) {
            let most = outputs.iter().map(|values| size(values)).fold(0.0, f64::max);
            fields.push(Packed { unit: unit(most), name, outputs });
        }
    };
    add("pressure_Pa".to_owned(), |_| Unit::pressure());
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
        "fields": fields.iter().map(|field| (field.name.clone(), field.packed())).collect::<serde_json::Map<_, _>>(),
    });
    Ok(Some(Maps { value, left_out: all.len() - count }))
}

impl Packed {
    /// Whole numbers of 16 bits, little endian, and what one of them is worth in the unit.
    fn packed(&self) -> Value {
        let most = self.outputs.iter().map(|values| size(values)).fold(0.0, f64::max);
        let step = if most > 0.0 { most / WHOLE } else { 1.0 };
        let pack = |values: &Vec<f64>| {
            let bytes: Vec<u8> = values
                .iter()
                .flat_map(|value| ((value / step).round() as i16).to_le_bytes())
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
