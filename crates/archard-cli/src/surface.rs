//! `archard surface`: what is in the file of a measured surface, and what preparing took off it.

use std::path::Path;

use archard_case::verdict::Verdict;
use archard_case::{CaseFile, Preparation, PreparedSurface};
use archard_surface::{Form, HeightMap, Nominal, Spectrum, Texture, Window};

use crate::diagnose::show;
use crate::failure::Failure;
use crate::number::four;
use crate::plot;
use crate::say::say;
use crate::verdict;

/// Distances of points, in pixels, for which the report says what they do not resolve.
const COARSER: [f64; 3] = [2.0, 4.0, 8.0];

/// Reads a file, with keys of `profile.surface`, says what is in it, and draws it if a picture is named.
pub fn surface(file: &Path, options: &[String], picture: Option<&Path>) -> Result<(), Failure> {
    let PreparedSurface { map, steps } = read(file, options.iter().map(|one| ("--set", one)))?;
    for step in &steps {
        line(step.key, &step.said, "")?;
    }
    size(&map)?;
    texture(&map)?;
    let nominal = Nominal::of(&map, Form::Sphere, None);
    line("sphere", &sphere(&nominal), "")?;
    let spectrum = Spectrum::of(&map, Window::Hann);
    let spectrum = spectrum.map_err(|error| Failure::wrong(error.to_string()))?;
    resolved(&map, &spectrum)?;
    let verdict = judged(&map, &steps, nominal.as_ref().ok());
    line("verdict", &verdict::headline(&verdict), "")?;
    verdict::say_lines(&verdict, false)?;
    let Some(picture) = picture else { return Ok(()) };
    let files = plot::surface::draw(picture, &map, &spectrum);
    let files = files.map_err(|error| Failure::because(&error))?;
    files.iter().try_for_each(|file| say(&file.display().to_string()))
}

/// The map in a file, prepared as keys of `profile.surface` ask for, each behind the name of its option; what is wrong is shown.
pub(crate) fn read<'a>(
    file: &Path,
    options: impl Iterator<Item = (&'static str, &'a String)>,
) -> Result<PreparedSurface, Failure> {
    let path = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
    let name = toml_text(&path.display().to_string());
    let text = format!("profile.surface.file = {name}");
    let read = CaseFile::from_text(file.display().to_string(), text, "");
    let set = |case: CaseFile, (name, option): (&'static str, &String)| {
        case.set_by(name, format!("profile.surface.{option}"))
    };
    let case = options.fold(read, set);
    case.prepared_surface().map_err(|problems| {
        show(&case, &problems);
        Failure::Shown
    })
}

fn line(name: &str, value: &str, meaning: &str) -> Result<(), Failure> {
    say(format!("{name:<10}{value:<24}{meaning}").trim_end())
}

fn size(map: &HeightMap) -> Result<(), Failure> {
    let [nx, ny] = map.elements();
    let [width, height] = map.size().map(|size| four(1e3 * size));
    let [dx, dy] = map.pixel().map(|size| four(1e6 * size));
    line("size", &format!("{width} x {height} mm"), "")?;
    line("points", &format!("{nx} x {ny}"), "")?;
    line("pixel", &format!("{dx} x {dy} um"), "")?;
    line("missing", &map.missing().to_string(), "points without a height")
}

fn texture(map: &HeightMap) -> Result<(), Failure> {
    let of = Texture::of(map);
    let known = |value: f64, unit: &str| match value.is_finite() {
        true => format!("{}{unit}", four(value)),
        false => "none".to_owned(),
    };
    let um = |value: f64| known(1e6 * value, " um");
    line("Sa", &um(of.mean_deviation), "mean deviation")?;
    line("Sq", &um(of.rms), "rms height")?;
    line("Ssk", &known(of.skewness, ""), "skewness")?;
    line("Sku", &known(of.kurtosis, ""), "kurtosis, 3 of a Gaussian")?;
    line("Sp", &um(of.peak), "highest peak")?;
    line("Sv", &um(of.pit), "deepest pit")?;
    line("Sz", &um(of.height()), "from pit to peak")?;
    line("Sdq", &known(of.rms_gradient, ""), "rms gradient")?;
    line("Sdr", &known(100.0 * of.developed, " %"), "developed area")?;
    line("curvature", &known(1e-3 * of.rms_curvature, " 1/mm"), "rms mean curvature")
}

/// Whether what is said can be believed: by points without a height, those that were filled, and the error of the radius.
fn judged(map: &HeightMap, steps: &[Preparation], sphere: Option<&Nominal>) -> Verdict {
    let points = map.heights().len() as f64;
    let filled: usize = steps.iter().map(|step| step.filled).sum();
    let error = sphere.filter(|found| is_round(found)).map(|found| {
        let [radius, deviation] = found.radius();
        archard_case::verdict::measured(deviation / radius, "radius of the sphere")
    });
    let lines = [archard_case::verdict::missing((map.missing() + filled) as f64 / points)];
    lines.into_iter().chain(error).collect()
}

/// Whether the curvature stands out from its error.
fn is_round(found: &Nominal) -> bool {
    found.curvature.abs() > 2.0 * found.deviation
}

/// The sphere that fits what is left.
fn sphere<E: std::fmt::Display>(nominal: &Result<Nominal, E>) -> String {
    match nominal {
        Ok(found) if is_round(found) => {
            let side = if found.curvature > 0.0 { "convex" } else { "concave" };
            let [radius, deviation] = found.radius().map(|length| four(1e3 * length));
            format!("{side}, radius {radius} mm, standard deviation {deviation} mm")
        }
        Ok(found) => {
            let [curvature, deviation] = [found.curvature, found.deviation].map(four);
            format!(
                "none: the curvature, {curvature} 1/m, is within two standard deviations, {deviation} 1/m, of a plane"
            )
        }
        Err(error) => format!("none: {error}"),
    }
}

/// What points further apart do not resolve.
fn resolved(map: &HeightMap, spectrum: &Spectrum) -> Result<(), Failure> {
    say("points further apart leave out, of the mean squares of height, slope and curvature:")?;
    let pixel = map.pixel()[0].max(map.pixel()[1]);
    COARSER.into_iter().try_for_each(|factor| {
        let left = spectrum.unresolved(factor * pixel);
        let shares = [left.height, left.slope, left.curvature];
        let [height, slope, curvature] = shares.map(|share| four(100.0 * share));
        let distance = format!("{} um", four(1e6 * factor * pixel));
        line(&distance, &format!("  {height} %, {slope} %, {curvature} %"), "")
    })
}

/// A text as TOML has it.
fn toml_text(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
