//! Pictures of a cam and its follower: what they bear over a turn, and what they lose.

use std::path::Path;

use anyhow::Result;
use serde_json::Value;

use super::figure::{COLOURS, Curves, Panel, Pen};
use super::gear::{course, names, summary_of};
use super::rows::Rows;
use super::{OVERVIEW, Picture};

/// The file of the follower.
const FOLLOWER: &str = "follower.csv";

/// What the folder of a cam and its follower holds.
pub(crate) struct Cam {
    around: Rows,
    face: Rows,
    course: Rows,
    pub(crate) summary: Value,
    pub(crate) mark: Option<String>,
}

/// Whether a folder is that of a cam and its follower.
pub(crate) fn is_one(dir: &Path) -> bool {
    dir.join(FOLLOWER).is_file()
}

impl Cam {
    /// Reads a folder.
    pub(crate) fn read(dir: &Path) -> Result<Self> {
        let (summary, mark) = summary_of(dir)?;
        Ok(Self {
            around: Rows::read(&dir.join("cam.csv"))?,
            face: Rows::read(&dir.join(FOLLOWER))?,
            course: Rows::read(&dir.join("course.csv"))?,
            summary,
            mark,
        })
    }

    /// All pictures.
    pub(super) fn pictures(&self) -> Vec<Picture> {
        vec![Picture::new("cam", self.panels()).sized(OVERVIEW)]
    }

    /// Depths over the angle of the cam and over the face of the follower, the peak pressure of a turn, and the deepest over the turns.
    pub(crate) fn panels(&self) -> Vec<Panel> {
        let names = names(&self.summary, "bodies");
        let mut panels = vec![];
        let turn = "Angle of the cam (deg)";
        let angles = self.around.numbers("angle_deg", 1.0);
        let face = "Place on the follower (mm)";
        let sides = [
            (&self.around, angles.clone(), turn, "Depth worn off"),
            (&self.face, self.face.numbers("place_m", 1e3), face, "Depth worn off"),
        ];
        for (index, ((rows, along, label, title), name)) in
            sides.into_iter().zip(&names).enumerate()
        {
            let depth = rows.numbers(&format!("wear_depth_{name}_m"), 1e6);
            if depth.iter().all(|depth| *depth == 0.0) {
                continue;
            }
            let mut curves = Curves::new();
            curves.add(along.into_iter().zip(depth), Pen::line(COLOURS[1 + index]), None);
            let title = format!("{title} {name}");
            panels.push(curves.panel([&*title, label, "Depth (um)"], |view| view.above_y(0.0)));
        }
        let mut curves = Curves::new();
        let pressure = self.around.numbers("peak_pressure_Pa", 1e-6);
        curves.add(angles.into_iter().zip(pressure), Pen::line(COLOURS[0]), None);
        let title = ["Peak pressure", turn, "Peak pressure (MPa)"];
        panels.push(curves.panel(title, |view| view.above_y(0.0)));
        panels.extend(course(&self.course, &names, ["turns", "Turns"]));
        panels
    }
}
