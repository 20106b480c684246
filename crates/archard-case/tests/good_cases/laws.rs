//! The examples of the laws are right.

use std::fs;

use archard::friction::{ABOUT_FRICTION, FRICTION};
use archard::parameters::About;
use archard::wear::{ABOUT_WEAR_LAWS, WEAR_LAWS};
use archard_case::CaseFile;

/// Motions: one of them suits any law.
const MOTIONS: [&str; 4] = [
    "sliding={load=10 N, distance=1 m, step=10 mm, speed=1 m/s}",
    "fretting={load=10 N, amplitude=[1 um, 0 um], cycles=2, increments=8}",
    "fretting={load=10 N, amplitude=[1 um, 1 um], phase=90 deg, cycles=2, increments=8}",
    "rolling={load=10 N, creepage=0.01, revolutions=10, step=1}",
];

/// Whether a case with the example in it is right under one of the motions.
fn is_right(about: &About, option: &str, more: &[&str]) -> bool {
    let dir = tempfile::tempdir().unwrap();
    for (name, content) in about.files {
        fs::write(dir.path().join(name), content).unwrap();
    }
    let text = "[body.one]\nmaterial = \"C45\"\nprofile.disc = { radius = \"20 mm\", crown = \"20 mm\" }\n\
                [body.two]\nmaterial = \"C45\"\nprofile.disc = { radius = \"20 mm\" }\n\
                [frame]\nsize = [\"0.6 mm\", \"0.6 mm\"]\nelements = [40, 40]\n";
    MOTIONS.iter().any(|motion| {
        let options = more.iter().copied().map(str::to_owned);
        let options = options.chain([option.to_owned(), format!("motion={{{motion}}}")]);
        let file = CaseFile::from_text("case.toml", text, dir.path());
        options.fold(file, CaseFile::set).resolve().is_ok()
    })
}

#[test]
fn every_law_is_told_about_with_an_example_that_is_right() {
    let names = |about: &'static [About]| about.iter().map(|one| one.name).collect::<Vec<_>>();
    let known: Vec<&str> = WEAR_LAWS.iter().map(|law| law.name).collect();
    assert_eq!(names(ABOUT_WEAR_LAWS), known);
    let known: Vec<&str> = FRICTION.iter().map(|law| law.name).collect();
    assert_eq!(names(ABOUT_FRICTION), known);
    for about in ABOUT_WEAR_LAWS {
        let option = format!("body.one.wear={{{}={}}}", about.name, about.example);
        assert!(is_right(about, &option, &["friction.coulomb.coefficient=0.3"]), "{option}");
        assert!(!about.source.is_empty());
    }
    for about in ABOUT_FRICTION {
        let option = format!("friction={{{}={}}}", about.name, about.example);
        assert!(is_right(about, &option, &[]), "{option}");
        assert!(!about.source.is_empty());
    }
    let wrong = About::new("archard", "", "{ k = 1 }");
    assert!(!is_right(&wrong, "body.one.wear={archard={k=1}}", &[]));
}
