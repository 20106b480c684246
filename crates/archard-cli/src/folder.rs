//! Where the results of a run go, and what must not be lost there.

use std::path::{Path, PathBuf};

use archard_case::Task;
use archard_case::files::Inputs;
use archard_case::output::{Claim, Error};

use crate::arguments::{Case, Run};
use crate::failure::Failure;

/// Most letters that settings take in the name of a folder.
const LONGEST: usize = 100;

/// The folder of the arguments, held for a task as it was read: what is chosen for its accuracy need not be known yet.
pub fn claim(arguments: &Run, task: &Task, inputs: Inputs) -> Result<Claim, Failure> {
    let wrong = |error: Error| Failure::wrong(error.to_string());
    if let Some(dir) = &arguments.resume {
        let claim = Claim::take(dir).map_err(wrong)?.adding(task.files());
        let found = if let Task::Contact(_) = task { claim.find_run() } else { Ok(()) };
        return match found {
            Ok(()) => Ok(claim),
            Err(error) => {
                claim.give_up();
                Err(wrong(error))
            }
        };
    }
    let given = arguments.case();
    let Case { case, .. } = &given;
    let dir = arguments.output.clone().unwrap_or_else(|| default(case, &given.settings()));
    let claim = Claim::take(&dir).map_err(wrong)?.adding(task.files()).sparing(inputs);
    let claim = if arguments.force { claim.adopting() } else { claim };
    if let Err(error) = claim.admit() {
        claim.give_up();
        return Err(wrong(error));
    }
    let is_its = |known: &str| match task {
        Task::Contact(resolved) => resolved.is_printed(known),
        Task::Cam(_) | Task::Elastic(_) | Task::Gear(_) | Task::WheelRail(_) => {
            known == task.case_toml()
        }
    };
    if arguments.force || !claim.holds_another(is_its) {
        return Ok(claim);
    }
    claim.give_up();
    Err(Failure::wrong(format!(
        "`{}` holds another case or its results; choose another folder with -o, or replace them with --force",
        dir.display()
    )))
}

/// `results/NAME`: the name of the case file, or of its folder where the file is a `case.toml`. Settings laid over the
/// case follow: `results/NAME--frame.elements=3x3`.
pub fn default(case: &Path, settings: &[String]) -> PathBuf {
    let case = case.canonicalize().unwrap_or_else(|_| case.to_owned());
    let named_by_folder = case.file_name().is_some_and(|name| name == "case.toml");
    let name = match case.parent().and_then(Path::file_name) {
        _ if case.is_dir() => case.file_name(),
        Some(folder) if named_by_folder => Some(folder),
        _ => case.file_stem(),
    };
    let mut name = name.unwrap_or("case".as_ref()).to_owned();
    name.push(variant(settings));
    Path::new("results").join(name)
}

/// Settings as a part of a name: `--KEY=VALUE` each, without spaces, quotes and brackets, the numbers of lists joined
/// by `x`. What is too long, or has other characters, ends in a hash of the settings.
fn variant(settings: &[String]) -> String {
    let mut whole = true;
    let mut name = String::new();
    for setting in settings {
        name.push_str("--");
        for letter in setting.chars().filter(|letter| !" \t\n\"'[]{}".contains(*letter)) {
            let plain = letter.is_ascii_alphanumeric() || "._-+=".contains(letter);
            whole &= plain || letter == ',';
            name.push(if plain { letter } else { 'x' });
        }
    }
    if whole && name.len() <= LONGEST {
        return name;
    }
    // Every letter is of one byte.
    name.truncate(LONGEST);
    format!("{name}--{:016x}", hash(settings))
}

/// Fowler, Noll and Vo's hash of 64 bits (FNV-1a), the same on every machine.
fn hash(settings: &[String]) -> u64 {
    let bytes = settings.iter().flat_map(|setting| setting.bytes().chain([0]));
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

#[cfg(test)]
mod tests {
    use super::{LONGEST, hash, variant};

    fn named(settings: &[&str]) -> String {
        variant(&settings.iter().map(|&setting| setting.to_owned()).collect::<Vec<_>>())
    }

    #[test]
    fn settings_name_a_folder() {
        assert_eq!(named(&[]), "");
        assert_eq!(named(&["frame.elements=[3, 3]"]), "--frame.elements=3x3");
        assert_eq!(
            named(&["frame.size=[\"2 mm\", \"2 mm\"]", "friction="]),
            "--frame.size=2mmx2mm--friction="
        );
    }

    #[test]
    fn what_cannot_be_shown_has_a_hash() {
        let odd = [named(&["title=a/b"]), named(&["title=a:b"])];
        assert!(odd.iter().all(|name| name.starts_with("--title=axb--")), "{odd:?}");
        assert_ne!(odd[0], odd[1]);
        let long = named(&[&format!("title={}", "long ".repeat(100))]);
        assert_eq!(long.len(), LONGEST + 2 + 16);
        assert!(!named(&["title=../../up"]).contains('/'));
    }

    /// The authors' values: of nothing, and of "a".
    #[test]
    fn the_hash_is_theirs() {
        assert_eq!(hash(&[]), 0xcbf29ce484222325);
        let end = |hash: u64| hash.wrapping_mul(0x100000001b3);
        assert_eq!(hash(&["a".to_owned()]), end(0xaf63dc4c8601ec8c));
    }
}
