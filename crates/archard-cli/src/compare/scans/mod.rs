//! `archard compare --before A --after B`: what is worn between two scans of a surface.

mod files;
mod options;
mod picture;
mod words;

use std::fs;
use std::path::{Path, PathBuf};

use archard_case::PreparedSurface;
use archard_surface::HeightMap;
use archard_surface::difference::{Difference, NoDifference, SectionPoint};
use serde_json::Value;

pub use options::Scans;

use crate::failure::Failure;
use crate::plot;
use crate::plot::draw::Paper;
use crate::report;
use crate::say::say;
use crate::surface;

/// Keys of `profile.surface` that would take off a part of what is worn, each in its own way before and after.
const WITH_WEAR: [&str; 3] = ["level", "form", "rough"];

/// Two scans and what is worn between them.
struct Compared<'a> {
    scans: &'a Scans,
    names: [String; 2],
    found: Difference,
    section: Vec<SectionPoint>,
}

/// What is worn between two scans, for a program that shows it by itself.
pub struct ScanWear {
    /// What the command prints.
    pub lines: Vec<String>,
    /// All numbers, in SI.
    pub numbers: Value,
    /// The later surface above the earlier one (m), on the points of the later scan.
    pub change: HeightMap,
    /// At each point -1 in a worn region, 1 in one that is piled up, 0 elsewhere.
    pub regions: Vec<i8>,
}

/// Compares two scans, says what is worn, and writes it into a folder.
pub fn run(scans: &Scans) -> Result<(), Failure> {
    let (Some(before), Some(after)) = (&scans.before, &scans.after) else {
        return Err(Failure::wrong("give both scans: --before FILE --after FILE"));
    };
    scans.options().and_then(|_| scans.progress()).map_err(Failure::wrong)?;
    let maps = [
        scan(before, [("--set", &scans.set), ("--set-before", &scans.set_before)])?,
        scan(after, [("--set", &scans.set), ("--set-after", &scans.set_after)])?,
    ];
    let names = [before, after].map(|path| path.display().to_string());
    let compared = Compared::of(&maps, names, scans)?;
    let dir = scans.output.clone().unwrap_or_else(|| default(before, after));
    write(&dir, &compared)?;
    compared.lines().iter().try_for_each(|line| say(line))?;
    say(&format!("{:<18}{}", "results", dir.display()))
}

/// What is worn between two maps of these names.
pub fn found(
    maps: &[HeightMap; 2],
    names: [String; 2],
    scans: &Scans,
) -> Result<ScanWear, Failure> {
    let compared = Compared::of(maps, names, scans)?;
    let (lines, numbers) = (compared.lines(), compared.json());
    let Difference { change, regions, .. } = compared.found;
    Ok(ScanWear { lines, numbers, change, regions })
}

impl<'a> Compared<'a> {
    fn of(
        [before, after]: &[HeightMap; 2],
        names: [String; 2],
        scans: &'a Scans,
    ) -> Result<Self, Failure> {
        let options = scans.options().map_err(Failure::wrong)?;
        let wrong =
            |error: NoDifference| Failure::wrong(format!("{}: {error}{}", names[1], hint(&error)));
        let found = Difference::between(before, after, &options).map_err(wrong)?;
        let section = found.section(before);
        Ok(Self { scans, names, found, section })
    }
}

/// The option that helps against a refusal.
fn hint(error: &NoDifference) -> &'static str {
    match error {
        NoDifference::Turned { .. } => " (`--turn DEGREES`)",
        NoDifference::Different { .. } => " (`--placed`)",
        NoDifference::AllWorn { .. } | NoDifference::NoReference { .. } => {
            " (`--worn X0,X1,Y0,Y1`)"
        }
        _ => "",
    }
}

/// The map of a scan.
fn scan(file: &Path, options: [(&'static str, &Vec<String>); 2]) -> Result<HeightMap, Failure> {
    let named = options.into_iter().flat_map(|(name, all)| all.iter().map(move |one| (name, one)));
    let PreparedSurface { map, steps } = surface::read(file, named)?;
    match steps.iter().find(|step| WITH_WEAR.contains(&step.key)) {
        Some(step) => Err(Failure::wrong(format!(
            "`{}`: takes off a part of what is worn, too; leave it out: the scans are levelled by what did not wear",
            step.key
        ))),
        None => Ok(map),
    }
}

/// `results/BEFORE_AFTER`, of the names of the files.
fn default(before: &Path, after: &Path) -> PathBuf {
    let stem = |path: &Path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    Path::new("results").join(format!("{}_{}", stem(before), stem(after)))
}

fn write(dir: &Path, compared: &Compared<'_>) -> Result<(), Failure> {
    fs::create_dir_all(dir)
        .map_err(|error| Failure::wrong(format!("cannot make `{}`: {error}", dir.display())))?;
    let failed = |error: &dyn std::error::Error| Failure::wrong(error.to_string());
    compared.write(dir).map_err(|error| failed(&error))?;
    plot::write(dir, vec![compared.picture()], (None, &Paper::default()))
        .and_then(|_| report::of_scans(dir))
        .map_err(|error| Failure::because(&error))
        .map(|_| ())
}
