//! `archard validate`: the measured sets of the repository, and the page of the book that is made of them.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use super::{archard, printed, said};

/// The page is the one that the command makes; `ARCHARD_PAGES` writes it.
#[test]
#[ignore = "long: in .ci/long"]
fn the_page_of_measured_wear_is_current() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let dir = TempDir::new().unwrap();
    let sets = root.join("validation");
    let arguments = ["validate", sets.to_str().unwrap(), "-o", "measured.md"];
    let words = printed(&archard(&dir, &arguments).success());
    assert!(words.contains("inside          9 of 9") && words.contains("rejected"), "{words}");
    let made = fs::read_to_string(dir.path().join("measured.md")).unwrap();
    let page = root.join("book/src/measured.md");
    if std::env::var_os("ARCHARD_PAGES").is_some() {
        fs::write(page, &made).unwrap();
        return;
    }
    let known = fs::read_to_string(page).unwrap();
    assert_eq!(made, known, "ARCHARD_PAGES=1 writes it anew");
}

#[test]
fn folders_without_sets_and_wrong_sets_are_told() {
    let dir = TempDir::new().unwrap();
    fs::create_dir_all(dir.path().join("sets/one")).unwrap();
    let refused = |said: &str| {
        let told = self::said(&archard(&dir, &["validate", "sets"]).code(2));
        assert!(told.contains(said), "{told}");
    };
    refused("a set is a folder with `set.toml`");
    let set = dir.path().join("sets/one/set.toml");
    fs::write(&set, "title = \"one\"\nsauce = \"nobody\"\n").unwrap();
    refused("sauce");
    let whole = "title = \"one\"\nsource = \"nobody\"\nlicence = \"none\"\nread = \"nothing\"\n";
    fs::write(&set, format!("{whole}[coefficient]\nsource = \"he\"\nuncertainty = -1\n")).unwrap();
    refused("coefficient.uncertainty");
    fs::write(&set, whole).unwrap();
    refused("case.toml");
    // A page of somebody else stays.
    fs::write(dir.path().join("mine.md"), "mine").unwrap();
    let sets = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/te67");
    archard(&dir, &["validate", sets.to_str().unwrap(), "-o", "mine.md", "-q"]).code(2);
    assert_eq!(fs::read_to_string(dir.path().join("mine.md")).unwrap(), "mine");
}
