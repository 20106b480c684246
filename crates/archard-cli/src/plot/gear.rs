//! Pictures of two gears in mesh: what their flanks bear along the path of contact, and what they lose.

use std::path::Path;

use anyhow::Result;
use serde_json::{Map, Value};

use super::figure::{COLOURS, Curves, LegendPosition, PALE, Panel, Pen};
use super::results::{mark, read_summary};
use super::rows::Rows;
use super::{OVERVIEW, Picture};

/// The file of the flanks.
const FLANKS: &str = "flanks.csv";

/// What the folder of two gears holds.
pub(crate) struct Gears {
    flanks: Rows,
    course: Rows,
    pub(crate) summary: Value,
    pub(crate) mark: Option<String>,
}

/// Whether a folder is that of two gears.
pub(crate) fn is_one(dir: &Path) -> bool {
    dir.join(FLANKS).is_file()
}

impl Gears {
    /// Reads a folder.
    pub(crate) fn read(dir: &Path) -> Result<Self> {
        let (summary, mark) = summary_of(dir)?;
        Ok(Self {
            flanks: Rows::read(&dir.join(FLANKS))?,
            course: Rows::read(&dir.join("course.csv"))?,
            summary,
            mark,
        })
    }

    /// All pictures.
    pub(super) fn pictures(&self) -> Vec<Picture> {
        vec![Picture::new("flanks", self.panels()).sized(OVERVIEW)]
    }

    /// Depths over the path and over the meshes; pressures and shares, new and worn.
    pub(crate) fn panels(&self) -> Vec<Panel> {
        let path = self.flanks.numbers("path_m", 1e3);
        let names = names(&self.summary, "gears");
        let mut panels = vec![];
        let along = "Path of contact from T1 (mm)";
        let mut depths = Curves::new();
        for (index, name) in names.iter().enumerate() {
            let depth = self.flanks.numbers(&format!("wear_depth_{name}_m"), 1e6);
            if depth.iter().all(|depth| *depth == 0.0) {
                continue;
            }
            let line = path.iter().copied().zip(depth);
            depths.add(line, Pen::line(COLOURS[1 + index % 2]), Some(name));
        }
        let legend = LegendPosition::OutsideRightTop;
        let title = ["Depth worn off the flanks", along, "Depth (um)"];
        panels.push(depths.panel(title, |view| view.above_y(0.0).legend(legend)));
        for (title, label, columns, factor) in [
            (
                "Share of the load of a pair of teeth",
                "Share",
                ["new_load_share", "load_share"],
                1.0,
            ),
            (
                "Peak pressure",
                "Peak pressure (MPa)",
                ["new_peak_pressure_Pa", "peak_pressure_Pa"],
                1e-6,
            ),
        ] {
            let mut curves = Curves::new();
            let [new, worn] = columns.map(|column| self.flanks.numbers(column, factor));
            let changes = new != worn;
            let both = path.iter().copied();
            curves.add(both.clone().zip(new), Pen::broad(PALE[0]), changes.then_some("new"));
            if changes {
                curves.add(both.zip(worn), Pen::line(COLOURS[0]), Some("worn"));
            }
            let legend = LegendPosition::OutsideRightTop;
            panels
                .push(curves.panel([title, along, label], |view| view.above_y(0.0).legend(legend)));
        }
        panels.extend(course(&self.course, &names, ["meshes", "Meshes of a flank"]));
        panels
    }
}

/// The summary of a folder, and how far it can be believed.
pub(super) fn summary_of(dir: &Path) -> Result<(Value, Option<String>)> {
    let summary = dir.join("summary.json");
    let summary: Option<Map<String, Value>> =
        if summary.is_file() { Some(read_summary(&summary)?) } else { None };
    let mark = mark(summary.as_ref());
    Ok((summary.map_or(Value::Null, Value::Object), mark))
}

/// The names of the bodies that a summary has under a key.
pub(super) fn names(summary: &Value, key: &str) -> Vec<String> {
    let bodies = summary[key].as_array().into_iter().flatten();
    bodies.filter_map(|body| body["name"].as_str().map(str::to_owned)).collect()
}

/// The deepest wear of two bodies over passages: their column, and what they are called; `None` where there are none.
pub(super) fn course(rows: &Rows, names: &[String], [column, label]: [&str; 2]) -> Option<Panel> {
    let passages = rows.numbers(column, 1.0);
    if !passages.last().is_some_and(|last| *last > 0.0) {
        return None;
    }
    let mut course = Curves::new();
    for (index, name) in names.iter().enumerate() {
        let depth = rows.numbers(&format!("wear_depth_{name}_m"), 1e6);
        let line = passages.iter().copied().zip(depth);
        course.add(line, Pen::line(COLOURS[1 + index % 2]), Some(name));
    }
    let legend = LegendPosition::InsideTopLeft;
    let title = ["Deepest wear", label, "Depth (um)"];
    Some(course.panel(title, |view| view.above_y(0.0).legend(legend)))
}
