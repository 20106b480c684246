//! Result folders that are damaged at random: pictures or an error, soon.

use std::fs;
use std::path::{Path, PathBuf};

use archard::problem::ContactState;
use tempfile::tempdir;

use super::super::draw::Paper;
use super::super::results::Results;
use super::super::{rolling, run, sliding};
use super::damage::{attempt, damaged};
use super::{problem, slide, state, write};

/// The files of a folder and their contents.
fn files(dir: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let entries = fs::read_dir(dir).unwrap().map(|entry| entry.unwrap().path());
    let mut paths: Vec<PathBuf> =
        entries.flat_map(|path| if path.is_dir() { inside(&path) } else { vec![path] }).collect();
    paths.sort();
    paths.into_iter().map(|path| (path.clone(), fs::read(path).unwrap())).collect()
}

fn inside(dir: &Path) -> Vec<PathBuf> {
    fs::read_dir(dir).unwrap().map(|entry| entry.unwrap().path()).collect()
}

/// Damages one file of a folder at a time, reads the folder, makes the pictures and, now and then, draws them.
fn folders(quick: u64, long: bool) {
    let dir = tempdir().unwrap();
    let [slid, pressed] = ["slid", "pressed"].map(|name| dir.path().join(name));
    slide(&slid, [0.9e-13, 0.4e-13], true);
    let contact = problem([0.0; 2], "indentation", &[("load", 10.2)]);
    let states: Vec<ContactState> = [0.0, 0.5, 1.0]
        .map(|share| ContactState {
            progress: share,
            ..state(&contact, 10.2 * share, 0.0, [0.0; 2])
        })
        .to_vec();
    write(&pressed, "", &contact, &states, true);
    let known = [slid, pressed].map(|dir| (files(&dir), dir));
    let all: Vec<Vec<u8>> =
        known.iter().flat_map(|known| &known.0).map(|file| file.1.clone()).collect();
    attempt("result folders", quick, long, |random| {
        let (files, dir) = &known[random.below(known.len())];
        let (path, whole) = &files[random.below(files.len())];
        fs::write(path, damaged(whole, &all, random)).unwrap();
        if let Ok(results) = Results::read(dir) {
            let made = if results.rolls() { rolling(&results) } else { sliding(&results) };
            // Drawing takes a hundred times as long as all before it.
            if made.is_ok() && random.chance(0.02) {
                let _ = run(dir, &[], &Paper::default());
            }
        }
        fs::write(path, whole).unwrap();
    });
}

#[test]
fn damaged_folders_are_drawn_or_refused() {
    folders(150, false);
}

#[test]
#[ignore = "takes ten minutes; `just soak` runs it"]
fn damaged_folders_at_length() {
    folders(0, true);
}
