//! How two scans are compared.

use std::path::PathBuf;

use archard::units::{self, Measure};
use archard_surface::difference::Options;
use clap::ValueHint;

/// Two scans of a surface.
#[derive(Debug, Clone, Default, clap::Args)]
#[group(id = "two scans")]
pub struct Scans {
    /// The scan before the test, in the place of a run: Digital Surf (.sur), SDF (.sdf), X3P (.x3p), Gwyddion (.gwy), NetCDF
    /// (.nc), NumPy (.npy), or a matrix of heights (.csv, .txt, .asc)
    #[arg(long, value_name = "FILE", requires = "after", conflicts_with = "dir", value_hint = ValueHint::FilePath)]
    pub before: Option<PathBuf>,
    /// The scan of the same place after the test
    #[arg(long, value_name = "FILE", requires = "before", value_hint = ValueHint::FilePath)]
    pub after: Option<PathBuf>,
    /// A key of `profile.surface` and its value, for both scans
    #[arg(long = "set", value_name = "KEY=VALUE", requires = "before")]
    pub set: Vec<String>,
    /// The same for the scan before the test alone, over what is set for both
    #[arg(long, value_name = "KEY=VALUE", requires = "before")]
    pub set_before: Vec<String>,
    /// The same for the scan after it alone
    #[arg(long, value_name = "KEY=VALUE", requires = "before")]
    pub set_after: Vec<String>,
    /// The part of the later scan in which wear is to be found, from its middle, like "-0.2 mm,0.2 mm,-1 mm,1 mm"; all else did
    /// not wear
    #[arg(long, value_name = "X0,X1,Y0,Y1", requires = "before", allow_hyphen_values = true)]
    pub worn: Option<String>,
    /// The largest turn between the scans that is sought, in degrees
    #[arg(long, value_name = "DEGREES", default_value_t = 5.0, requires = "before")]
    pub turn: f64,
    /// Both scans have the same middle and neither is turned: only the level is found
    #[arg(long, requires = "before")]
    pub placed: bool,
    /// The name of the test, for the data of a fit
    #[arg(long, value_name = "NAME", requires = "before")]
    pub test: Option<String>,
    /// Column and value of the progress at the later scan, for the data of a fit, like distance_m=500
    #[arg(long, value_name = "COLUMN=VALUE", requires = "before")]
    pub at: Option<String>,
    /// The folder of the results; results/BEFORE_AFTER if not given
    #[arg(short, long, value_name = "DIR", requires = "before")]
    pub output: Option<PathBuf>,
}

impl Scans {
    /// What is known of the scans.
    pub(super) fn options(&self) -> Result<Options, String> {
        if !(0.0..=180.0).contains(&self.turn) {
            return Err(format!("--turn {}: give an angle from 0 to 180 degrees", self.turn));
        }
        let worn = self.worn.as_deref().map(rectangle).transpose()?;
        Ok(Options { turn: self.turn.to_radians(), placed: self.placed, worn })
    }

    /// Column and value of the progress, which stays open if it is not given.
    pub(super) fn progress(&self) -> Result<(&str, &str), String> {
        let Some(at) = self.at.as_deref() else { return Ok(("distance_m", "")) };
        let parts = at.split_once('=').map(|(column, value)| (column.trim(), value.trim()));
        let named = |column: &str| {
            !column.is_empty() && column.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        };
        parts
            .filter(|(column, value)| named(column) && value.parse().is_ok_and(f64::is_finite))
            .ok_or_else(|| format!("--at {at}: write a column and a number, like distance_m=500"))
    }
}

/// A rectangle (m): from where to where along x and y.
fn rectangle(text: &str) -> Result<[[f64; 2]; 2], String> {
    let like = |why: String| {
        format!("--worn {text}: write four lengths, like \"-0.2 mm,0.2 mm,-1 mm,1 mm\"{why}")
    };
    let ends: Vec<f64> = text
        .split(',')
        .map(|part| units::read(part.trim(), &Measure::LENGTH))
        .collect::<Result<_, _>>()
        .map_err(|error| like(format!(": {error}")))?;
    match ends[..] {
        [x0, x1, y0, y1] if x0 < x1 && y0 < y1 => Ok([[x0, x1], [y0, y1]]),
        [_, _, _, _] => Err(like(": the lower end of each axis comes first".to_owned())),
        _ => Err(like(String::new())),
    }
}

#[cfg(test)]
mod tests {
    use super::rectangle;

    #[test]
    fn parts_are_four_lengths() {
        let part = rectangle("-0.2 mm, 0.2 mm,-1 mm,1000 um").unwrap();
        for (one, other) in part.as_flattened().iter().zip([-2e-4, 2e-4, -1e-3, 1e-3]) {
            assert!((one - other).abs() < 1e-15, "{part:?}");
        }
        for wrong in ["1 mm", "1,2,3,4", "2 mm,1 mm,0 mm,1 mm", "1 N,2 N,3 N,4 N"] {
            assert!(rectangle(wrong).is_err(), "{wrong}");
        }
    }
}
