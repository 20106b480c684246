//! The cases that come with the program, and cases by their name or path.

use std::fs;
use std::path::{Path, PathBuf};

use archard_case::output::Store;
use archard_case::{CaseFile, nearest};

use crate::failure::Failure;
use crate::rigs::RIGS;

/// Files, each with its name.
pub type Files = &'static [(&'static str, &'static [u8])];

/// A case to start from.
#[derive(Debug)]
pub struct Builtin {
    /// Its name.
    pub name: &'static str,
    /// Its case file.
    pub text: &'static str,
    /// Files the case reads, each with its name.
    pub files: Files,
}

/// All of them.
pub const CASES: &[Builtin] = &[
    without_files("hertz", include_str!("../cases/hertz/case.toml")),
    without_files("sliding_stress", include_str!("../cases/sliding_stress/case.toml")),
    without_files("manchester", include_str!("../cases/manchester/case.toml")),
    Builtin {
        name: "wheel_wear",
        text: include_str!("../cases/wheel_wear/case.toml"),
        files: &[
            ("route.csv", include_bytes!("../cases/wheel_wear/route.csv")),
            ("regions.csv", include_bytes!("../cases/wheel_wear/regions.csv")),
            ("run.csv", include_bytes!("../cases/wheel_wear/run.csv")),
        ],
    },
    Builtin {
        name: "rail_curve",
        text: include_str!("../cases/rail_curve/case.toml"),
        files: &[("axles.csv", include_bytes!("../cases/rail_curve/axles.csv"))],
    },
    without_files("pin_on_disc", include_str!("../cases/pin_on_disc/case.toml")),
    without_files("pin_on_disc_both", include_str!("../cases/pin_on_disc_both/case.toml")),
    without_files("pin_on_disc_track", include_str!("../cases/pin_on_disc_track/case.toml")),
    without_files("coated_disc", include_str!("../cases/coated_disc/case.toml")),
    without_files("fretting_life", include_str!("../cases/fretting_life/case.toml")),
    without_files("coating_stress", include_str!("../cases/coating_stress/case.toml")),
    without_files("rubber_layer", include_str!("../cases/rubber_layer/case.toml")),
    without_files("soft_liner", include_str!("../cases/soft_liner/case.toml")),
    without_files("wavy_surface", include_str!("../cases/wavy_surface/case.toml")),
    without_files("block_on_ring", include_str!("../cases/block_on_ring/case.toml")),
    without_files("reciprocating_ball", include_str!("../cases/reciprocating_ball/case.toml")),
    without_files("carter", include_str!("../cases/carter/case.toml")),
    without_files("kalker_creepage", include_str!("../cases/kalker_creepage/case.toml")),
    without_files("free_rolling_unlike", include_str!("../cases/free_rolling_unlike/case.toml")),
    without_files("twin_disc", include_str!("../cases/twin_disc/case.toml")),
    without_files(
        "twin_disc_accelerated",
        include_str!("../cases/twin_disc_accelerated/case.toml"),
    ),
    without_files("roller_finite", include_str!("../cases/roller_finite/case.toml")),
    without_files("thrust_roller", include_str!("../cases/thrust_roller/case.toml")),
    without_files("ball_in_groove", include_str!("../cases/ball_in_groove/case.toml")),
    without_files("cattaneo_mindlin", include_str!("../cases/cattaneo_mindlin/case.toml")),
    without_files("spence", include_str!("../cases/spence/case.toml")),
    without_files("punch_indentation", include_str!("../cases/punch_indentation/case.toml")),
    without_files(
        "punch_indentation_block",
        include_str!("../cases/punch_indentation_block/case.toml"),
    ),
    without_files("punch_fretting_block", include_str!("../cases/punch_fretting_block/case.toml")),
    without_files("punch_fretting", include_str!("../cases/punch_fretting/case.toml")),
    Builtin {
        name: "crossing_ball",
        text: include_str!("../cases/crossing_ball/case.toml"),
        files: &[("stations.csv", include_bytes!("../cases/crossing_ball/stations.csv"))],
    },
    Builtin {
        name: "cam_follower",
        text: include_str!("../cases/cam_follower/case.toml"),
        files: &[("lift.csv", include_bytes!("../cases/cam_follower/lift.csv"))],
    },
    without_files("gear_flanks", include_str!("../cases/gear_flanks/case.toml")),
    without_files("hip", include_str!("../cases/hip/case.toml")),
    without_files("mccoll_fretting", include_str!("../cases/mccoll_fretting/case.toml")),
    without_files("fretting_sphere", include_str!("../cases/fretting_sphere/case.toml")),
    without_files(
        "running_in_flat_punch",
        include_str!("../cases/running_in_flat_punch/case.toml"),
    ),
    without_files("fretting_energy", include_str!("../cases/fretting_energy/case.toml")),
    without_files("running_in_law", include_str!("../cases/running_in_law/case.toml")),
    without_files("custom_expression", include_str!("../cases/custom_expression/case.toml")),
    without_files(
        "wheel_steel_twin_disc",
        include_str!("../cases/wheel_steel_twin_disc/case.toml"),
    ),
    without_files("orthotropic_pin", include_str!("../cases/orthotropic_pin/case.toml")),
    without_files("orthotropic_fretting", include_str!("../cases/orthotropic_fretting/case.toml")),
    without_files(
        "orthotropic_twin_disc",
        include_str!("../cases/orthotropic_twin_disc/case.toml"),
    ),
    Builtin {
        name: "patch_test",
        text: include_str!("../cases/patch_test/case.toml"),
        files: &[("block.msh", include_bytes!("../cases/patch_test/block.msh"))],
    },
    Builtin {
        name: "hollow_sphere",
        text: include_str!("../cases/hollow_sphere/case.toml"),
        files: &[("octant.msh", include_bytes!("../cases/hollow_sphere/octant.msh"))],
    },
    Builtin {
        name: "pin_in_bush",
        text: include_str!("../cases/pin_in_bush/case.toml"),
        files: &[
            ("bush.msh", include_bytes!("../cases/pin_in_bush/bush.msh")),
            ("pin.msh", include_bytes!("../cases/pin_in_bush/pin.msh")),
            ("pin_of_5_degrees.msh", include_bytes!("../cases/pin_in_bush/pin_of_5_degrees.msh")),
        ],
    },
    Builtin {
        name: "warm_twin_disc",
        text: include_str!("../cases/warm_twin_disc/case.toml"),
        files: &[("wear.csv", include_bytes!("../cases/warm_twin_disc/wear.csv"))],
    },
    without_files("ground_pin", include_str!("../cases/ground_pin/case.toml")),
    without_files("rough_on_flat", include_str!("../cases/rough_on_flat/case.toml")),
    without_files("rough_on_rough", include_str!("../cases/rough_on_rough/case.toml")),
    Builtin {
        name: "rough_surface",
        text: include_str!("../cases/rough_surface/case.toml"),
        files: &[("surface.csv", include_bytes!("../cases/rough_surface/surface.csv"))],
    },
];

const fn without_files(name: &'static str, text: &'static str) -> Builtin {
    Builtin { name, text, files: &[] }
}

impl Builtin {
    /// What it is about: the title in its file.
    pub fn title(&self) -> &str {
        let title = self.text.lines().find_map(|line| line.strip_prefix("title = "));
        title.unwrap_or_default().trim_matches('"')
    }

    /// The folder that its files are in: nowhere if it has none, otherwise next to the kept compliances.
    pub fn folder(&self) -> Result<PathBuf, Failure> {
        if self.files.is_empty() {
            return Ok(PathBuf::new());
        }
        let Self { name, files, .. } = self;
        let next = format!("write the case and its files out by `archard new {name}`");
        let kept = std::env::var_os("ARCHARD_CACHE").map(Store::new).or_else(Store::of_user);
        let kept = kept.ok_or_else(|| Failure::wrong(format!("no place for files: {next}")))?;
        let put = |(file, bytes): &(&str, &[u8])| kept.put(&format!("cases/{name}/{file}"), bytes);
        files
            .iter()
            .try_for_each(|file| put(file).map(|_| ()))
            .map_err(|error| Failure::wrong(format!("{error}: {next}")))?;
        Ok(kept.folder().join("cases").join(name))
    }
}

/// The case of a name, or of a rig; either may be written with spaces or hyphens.
pub fn named(name: &str) -> Option<&'static Builtin> {
    let plain = name.trim().to_lowercase().replace([' ', '-'], "_");
    let rig = RIGS.iter().find(|rig| rig.name == plain).map(|rig| rig.case);
    CASES.iter().find(|builtin| builtin.name == rig.unwrap_or(&plain))
}

/// The case at a path or, where nothing is there, the built-in one of that name.
pub fn read(path: &Path) -> Result<CaseFile, Failure> {
    let plain = path.components().count() == 1;
    match path.to_str().filter(|_| plain && !path.exists()).and_then(named) {
        Some(builtin) => {
            let folder = builtin.folder()?;
            Ok(CaseFile::from_text(builtin.name, builtin.text, folder))
        }
        None => CaseFile::read(path).map_err(|error| {
            let hint = if path.exists() { String::new() } else { meant(path) };
            Failure::wrong(format!("{error}{hint}"))
        }),
    }
}

/// What else may have been meant by the path of a case that is not there, if it has a name like one.
fn meant(path: &Path) -> String {
    let Some(name) = path.file_name().and_then(|name| name.to_str()) else { return String::new() };
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let beside = fs::read_dir(folder.unwrap_or(Path::new("."))).into_iter().flatten().flatten();
    let is_case = |path: &PathBuf| {
        path.join("case.toml").is_file() || path.extension().is_some_and(|kind| kind == "toml")
    };
    let beside = beside.map(|entry| entry.path()).filter(is_case);
    let mut known: Vec<String> =
        beside.filter_map(|path| Some(path.file_name()?.to_str()?.to_owned())).collect();
    if folder.is_none() {
        known.extend(CASES.iter().map(|builtin| builtin.name.to_owned()));
        known.extend(RIGS.iter().map(|rig| rig.name.to_owned()));
    }
    let known: Vec<&str> = known.iter().map(String::as_str).collect();
    match nearest(name, &known) {
        Some(near) => format!("; did you mean `{}`?", path.with_file_name(near).display()),
        None if folder.is_none() => "; `archard new --list` shows the built-in cases".to_owned(),
        None => String::new(),
    }
}
