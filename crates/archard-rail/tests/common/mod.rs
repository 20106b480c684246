//! The benchmark's files, which are not in the repository.

// Each test takes what it needs of them.
#![allow(dead_code)]

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use archard_rail::Part;
use archard_rail::curve::Smoothing;
use archard_rail::file::{Document, Format, read};
use archard_rail::setup::{Attitude, Setup, Track, Velocity, Wheelset};

/// The folder that `ARCHARD_WHEEL_RAIL` names; `None`, with a note, if it is unset.
pub fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("ARCHARD_WHEEL_RAIL").map(PathBuf::from);
    if folder.is_none() {
        eprintln!("skipped: set ARCHARD_WHEEL_RAIL to the folder with the Manchester benchmark");
    }
    folder
}

/// A file of the folder.
pub fn document(folder: &Path, name: &str, format: Format) -> Document {
    let bytes = std::fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    read(&bytes, format).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The benchmark's wheel on its rail, which is inclined already.
pub fn setup(folder: &Path) -> Setup {
    let curve = |name, part| {
        let profile = document(folder, name, Format::Simpack(part)).profile;
        profile.curve(Smoothing::NONE).unwrap()
    };
    let rail = curve("MBench_UIC60_v3.prr", Part::Rail);
    let wheel = curve("MBench_S1002_v3.prw", Part::Wheel);
    let track = Track { cant: 0.0, ..Track::standard() };
    let wheelset =
        Wheelset { flange_back_distance: 1.36, flange_back_position: -0.07, nominal_radius: 0.46 };
    Setup::new(track, &rail, wheelset, &wheel).unwrap()
}

/// A row of the table: values by the names of their columns (mm, N, rad).
pub struct Row(HashMap<String, f64>);

impl Row {
    /// The value of a column.
    pub fn get(&self, name: &str) -> f64 {
        self.0[name]
    }

    /// How the wheelset stands.
    pub fn attitude(&self) -> Attitude {
        Attitude {
            shift: self.get("Y_WS") * 1e-3,
            roll: self.get("ROLL_WS"),
            yaw: self.get("YAW_WS"),
        }
    }

    /// How it moves.
    pub fn velocity(&self) -> Velocity {
        Velocity {
            forward: self.get("VX_WS") * 1e-3,
            pitch: self.get("VPITCH_WS"),
            ..Velocity::default()
        }
    }
}

/// The rows of the table.
pub fn rows(folder: &Path) -> Vec<Row> {
    let text = std::fs::read_to_string(folder.join("manchester_right.csv")).unwrap();
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &str| {
        let cells = names.iter().zip(line.split(','));
        let cells = cells.filter_map(|(name, cell)| Some(((*name).to_owned(), cell.parse().ok()?)));
        Row(cells.collect())
    };
    lines.map(row).collect()
}
