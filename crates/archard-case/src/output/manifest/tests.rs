//! What a list of files keeps and what it spares.

use std::fs;
use std::path::Path;

use super::{FORMAT, Manifest, NAME};
use crate::files::Inputs;
use crate::output::Error;

fn write(manifest: &mut Manifest, name: &str, content: &str) {
    manifest.write(name, content.as_bytes()).unwrap();
}

fn names(dir: &Path) -> Vec<String> {
    Manifest::read(dir).unwrap().names().map(str::to_owned).collect()
}

#[test]
fn what_was_written_is_listed_and_goes_when_it_begins_anew() {
    let dir = tempfile::tempdir().unwrap();
    let mut manifest = Manifest::read(dir.path()).unwrap();
    manifest.begin(["case.toml"]).unwrap();
    write(&mut manifest, "case.toml", "one");
    write(&mut manifest, "fields/0000.vti", "one");
    write(&mut manifest, "checkpoint", "one");
    // Another writer adds its own, as stresses inside do at the end.
    write(&mut Manifest::read(dir.path()).unwrap(), "points.csv", "one");
    manifest.remove("checkpoint").unwrap();
    assert_eq!(names(dir.path()), ["case.toml", "fields/0000.vti", "points.csv"]);
    let mine = ["notes.txt", "checkpoint"].map(|name| dir.path().join(name));
    mine.iter().for_each(|path| fs::write(path, "mine").unwrap());
    Manifest::read(dir.path()).unwrap().begin(["summary.json"]).unwrap();
    let left = fs::read_dir(dir.path()).unwrap().count();
    assert_eq!(left, mine.len() + 1, "the folder of fields is empty and goes");
    assert_eq!(names(dir.path()), ["summary.json"]);
}

/// A removal that stops at a file, as a kill would: the case of what is left is still told.
#[test]
fn the_case_outlives_its_results() {
    let dir = tempfile::tempdir().unwrap();
    let mut manifest = Manifest::read(dir.path()).unwrap();
    for name in ["case.toml", "history.csv", "points.csv"] {
        write(&mut manifest, name, "one");
    }
    for stops in ["history.csv", "points.csv"] {
        let path = dir.path().join(stops);
        let _ = fs::remove_file(&path);
        fs::create_dir(&path).unwrap();
        let mut manifest = Manifest::read(dir.path()).unwrap();
        assert!(manifest.begin(["case.toml"]).is_err(), "{stops}");
        assert!(dir.path().join("case.toml").exists(), "{stops}");
        fs::remove_dir(&path).unwrap();
    }
}

/// Any byte of any file of a run that is done; what is written again counts anew.
#[test]
fn a_changed_byte_is_found_and_its_file_named() {
    let dir = tempfile::tempdir().unwrap();
    let mut manifest = Manifest::read(dir.path()).unwrap();
    let files = [("history.csv", "load_N\n20.5\n"), ("fields/0000.vti", "<a>1</a>")];
    files.iter().for_each(|(name, text)| write(&mut manifest, name, text));
    manifest.settle().unwrap();
    let verify = || Manifest::read(dir.path()).unwrap().verify();
    verify().unwrap();
    for (name, text) in files {
        let path = dir.path().join(name);
        for place in 0..text.len() {
            let mut bytes = text.as_bytes().to_vec();
            bytes[place] ^= 1;
            fs::write(&path, bytes).unwrap();
            let error = verify().unwrap_err();
            assert!(matches!(&error, Error::Read { path: told, .. } if *told == path), "{error}");
        }
        fs::write(&path, text).unwrap();
    }
    write(&mut manifest, "history.csv", "load_N\n21\n");
    verify().unwrap();
}

#[test]
fn what_others_wrote_is_in_the_way_and_stays() {
    let dir = tempfile::tempdir().unwrap();
    let [path, own] = ["profiles.csv", "case.toml"].map(|name| dir.path().join(name));
    let mut manifest = Manifest::read(dir.path()).unwrap();
    write(&mut manifest, "case.toml", "one");
    fs::write(&path, "mine").unwrap();
    let refused = |error: Error| matches!(&error, Error::NotOurs { path: p, .. } if *p == path);
    assert!(refused(manifest.claim("profiles.csv").unwrap_err()));
    assert!(refused(manifest.begin(["case.toml", "profiles.csv"]).unwrap_err()));
    assert_eq!([&path, &own].map(|path| fs::read_to_string(path).unwrap()), ["mine", "one"]);
    // A list of another program, too.
    fs::write(dir.path().join(NAME), "files:\n").unwrap();
    assert!(matches!(Manifest::read(dir.path()), Err(Error::NotOurs { .. })));
}

/// A list that somebody else made up names nothing outside of its folder, and a folder may be a link.
#[test]
fn no_name_leads_out_of_the_folder() {
    let [dir, other] = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
    let victim = other.path().join("victim");
    fs::write(&victim, "mine").unwrap();
    let way = format!("../{}/victim", other.path().file_name().unwrap().display());
    let list = format!("{FORMAT}wrote {way}\nwrote {}\n", victim.display());
    fs::write(dir.path().join(NAME), list).unwrap();
    let mut manifest = Manifest::read(dir.path()).unwrap();
    manifest.begin([]).unwrap();
    for name in [way.as_str(), "", "..", "/elsewhere", "a\nb"] {
        assert!(manifest.claim(name).is_err(), "{name}");
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(other.path(), dir.path().join("fields")).unwrap();
        fs::rename(&victim, other.path().join("0000.vti")).unwrap();
        fs::write(dir.path().join(NAME), format!("{FORMAT}wrote fields/0000.vti\n")).unwrap();
        assert!(Manifest::read(dir.path()).unwrap().begin([]).is_err());
        assert!(manifest.claim("fields/0000.vti").is_err());
        fs::rename(other.path().join("0000.vti"), &victim).unwrap();
    }
    assert_eq!(fs::read_to_string(&victim).unwrap(), "mine");
}

/// Names that no result has stay, whoever put them into the list, in the folder and below it.
#[test]
fn a_list_is_not_believed_for_what_is_never_written() {
    let dir = tempfile::tempdir().unwrap();
    let mut manifest = Manifest::read(dir.path()).unwrap();
    write(&mut manifest, "case.toml", "one");
    let mine = ["thesis.docx", "fields/data.csv", "sub/deep/data.csv"];
    let path = dir.path().join(NAME);
    let mut list = fs::read_to_string(&path).unwrap();
    for name in mine {
        fs::create_dir_all(dir.path().join(name).parent().unwrap()).unwrap();
        fs::write(dir.path().join(name), "mine").unwrap();
        list += &format!("wrote {name}\n");
    }
    fs::write(&path, list).unwrap();
    let mut manifest = Manifest::read(dir.path()).unwrap();
    assert!(mine.iter().all(|name| manifest.claim(name).is_err()));
    manifest.begin(["case.toml"]).unwrap();
    let kept = |name: &&str| fs::read_to_string(dir.path().join(name)).unwrap() == "mine";
    assert!(mine.iter().all(kept) && !dir.path().join("case.toml").exists());
    assert!(manifest.claim("notes.txt").is_err(), "no name of a result");
}

/// A file of an earlier run that is read now, under whatever name, is neither replaced nor removed.
#[test]
fn what_is_read_is_spared() {
    let dir = tempfile::tempdir().unwrap();
    let mut manifest = Manifest::read(dir.path()).unwrap();
    for name in ["case.toml", "points.csv"] {
        write(&mut manifest, name, "one");
    }
    let read = dir.path().join("read.csv");
    fs::hard_link(dir.path().join("points.csv"), &read).unwrap();
    let mut manifest = manifest.sparing(Inputs::of([read]));
    let spared = |refused: Result<(), Error>| matches!(refused, Err(Error::Input { .. }));
    assert!(spared(manifest.write("points.csv", b"two").map(|_| ())));
    assert!(spared(manifest.remove("points.csv")) && spared(manifest.begin([])));
    let left = ["case.toml", "points.csv"].map(|name| dir.path().join(name));
    assert!(left.iter().all(|path| fs::read_to_string(path).unwrap() == "one"));
}

/// Wherever a kill tears the list, no name comes out that was not written, and it goes on.
#[test]
fn a_torn_list_has_no_other_names() {
    let dir = tempfile::tempdir().unwrap();
    let mut manifest = Manifest::read(dir.path()).unwrap();
    manifest.begin([]).unwrap();
    for name in ["fields/0000.vti", "fields/0001.vti"] {
        manifest.claim(name).unwrap();
    }
    let path = dir.path().join(NAME);
    let whole = fs::read(&path).unwrap();
    for length in FORMAT.len()..whole.len() {
        fs::write(&path, &whole[..length]).unwrap();
        let mut torn = Manifest::read(dir.path()).unwrap();
        assert!(torn.names().all(|name| manifest.has(name)), "{length}");
        torn.claim("summary.json").unwrap();
        let known = names(dir.path());
        let of = |name: &String| manifest.has(name) || name == "summary.json";
        assert!(known.contains(&"summary.json".to_owned()) && known.iter().all(of), "{known:?}");
    }
}
