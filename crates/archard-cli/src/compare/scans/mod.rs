//! `archard compare --before A --after B`: what is worn between two scans of a surface.

mod files;
mod options;
mod picture;
mod words;

use std::fs;
use std::path::{Path, PathBuf};

use archard_surface::difference::{Difference, SectionPoint};

pub use options::Scans;

use crate::failure::Failure;
use crate::plot;
use crate::plot::draw::Paper;
use crate::report;
use crate::say::say;
use crate::surface;

/// Two scans and what is worn between them.
struct Compared<'a> {
    scans: &'a Scans,
    names: [String; 2],
    found: Difference,
    section: Vec<SectionPoint>,
}

/// Compares two scans, says what is worn, and writes it into a folder.
pub fn run(scans: &Scans) -> Result<(), Failure> {
    let (Some(before), Some(after)) = (&scans.before, &scans.after) else {
        return Err(Failure::wrong("give both scans: --before FILE --after FILE"));
    };
    let options = scans.options().map_err(Failure::wrong)?;
    let maps = [surface::read(before, &scans.set)?.map, surface::read(after, &scans.set)?.map];
    let found = Difference::between(&maps[0], &maps[1], &options)
        .map_err(|error| Failure::wrong(format!("{}: {error}", after.display())))?;
    let section = found.section(&maps[0]);
    let names = [before, after].map(|path| path.display().to_string());
    let compared = Compared { scans, names, found, section };
    let dir = scans.output.clone().unwrap_or_else(|| default(before, after));
    write(&dir, &compared)?;
    compared.lines().iter().try_for_each(|line| say(line))?;
    say(&format!("{:<18}{}", "results", dir.display()))
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
