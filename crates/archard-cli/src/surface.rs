//! `archard surface`: what is in the file of a measured surface.

use std::path::Path;

use archard_case::CaseFile;
use archard_surface::Texture;

use crate::diagnose::show;
use crate::failure::Failure;
use crate::number::four;
use crate::say::say;

/// Reads a file, with keys of `profile.surface`, and says what is in it.
pub fn surface(file: &Path, options: &[String]) -> Result<(), Failure> {
    let path = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
    let name = toml_text(&path.display().to_string());
    let text = format!("profile.surface.file = {name}");
    let read = CaseFile::from_text(file.display().to_string(), text, "");
    let set = |case: CaseFile, option: &String| case.set(format!("profile.surface.{option}"));
    let case = options.iter().fold(read, set);
    let map = case.surface().map_err(|problems| {
        show(&case, &problems);
        Failure::Shown
    })?;
    let [nx, ny] = map.elements();
    let [width, height] = map.size().map(|size| four(1e3 * size));
    let [dx, dy] = map.pixel().map(|size| four(1e6 * size));
    let line = |name: &str, value: String, meaning: &str| {
        say(format!("{name:<10}{value:<24}{meaning}").trim_end())
    };
    line("size", format!("{width} x {height} mm"), "")?;
    line("points", format!("{nx} x {ny}"), "")?;
    line("pixel", format!("{dx} x {dy} um"), "")?;
    line("missing", map.missing().to_string(), "points without a height")?;
    let of = Texture::of(&map);
    let um = |value: f64| format!("{} um", four(1e6 * value));
    line("Sa", um(of.mean_deviation), "mean deviation")?;
    line("Sq", um(of.rms), "rms height")?;
    line("Ssk", four(of.skewness), "skewness")?;
    line("Sku", four(of.kurtosis), "kurtosis, 3 of a Gaussian")?;
    line("Sp", um(of.peak), "highest peak")?;
    line("Sv", um(of.pit), "deepest pit")?;
    line("Sz", um(of.height()), "from pit to peak")?;
    line("Sdq", four(of.rms_gradient), "rms gradient")?;
    line("Sdr", format!("{} %", four(100.0 * of.developed)), "developed area")
}

/// A text as TOML has it.
fn toml_text(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
