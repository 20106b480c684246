//! What the command says of results that cannot be believed.

use std::fs;

use tempfile::TempDir;

use super::{archard, case, printed, said, squeezed};

/// The word on a subject in the summary of a folder.
fn word(dir: &TempDir, folder: &str, subject: &str) -> String {
    let text = fs::read_to_string(dir.path().join(folder).join("summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&text).unwrap();
    let lines = summary["verdict"]["lines"].as_array().unwrap();
    let line = lines.iter().find(|line| line["subject"] == subject).expect("a line");
    line["word"].as_str().unwrap().to_owned()
}

/// Few elements across the contact: a warning, in words and on the pictures.
#[test]
fn a_contact_of_few_elements_is_doubtful() {
    let dir = TempDir::new().unwrap();
    let hertz = case("hertz");
    let coarse = "frame.elements=[8, 8]";
    let options = ["run", hertz.to_str().unwrap(), "--set", coarse, "-o", "coarse"];
    let ran = printed(&archard(&dir, &options).success());
    let ran = squeezed(&ran);
    assert!(ran.contains("verdict doubtful (1 of 7 checks)"), "{ran}");
    assert!(ran.contains("elements doubtful: ") && ran.contains("(good from 8"), "{ran}");
    assert!(!ran.contains("load met to"), "{ran}");
    assert_eq!(word(&dir, "coarse", "elements"), "doubtful");
    assert_eq!(word(&dir, "coarse", "load"), "good");
    archard(&dir, &["plot", "coarse"]).success();
    let picture = fs::read_to_string(dir.path().join("coarse/plots/overview.svg")).unwrap();
    assert!(picture.contains("doubtful: elements"));
}

/// A body is elastic up to its strength: 219 MPa of friction and pressure reach 0.58 of 250 MPa, and so more than 100 MPa.
#[test]
#[ignore = "long: in .ci/long"]
fn a_body_that_yields_is_doubtful() {
    let dir = TempDir::new().unwrap();
    let sliding = case("sliding_stress");
    for (strength, known) in [("250 MPa", "good"), ("100 MPa", "doubtful")] {
        let strength = format!("output.stress.flat.yield_strength={strength}");
        let coarse = "frame.elements=[60, 60]";
        let options = ["--set", coarse, "--set", &strength, "-o", known];
        let options = [&["run", sliding.to_str().unwrap()], &options[..]].concat();
        archard(&dir, &options).success();
        assert_eq!(word(&dir, known, "yield"), known);
        assert_eq!(word(&dir, known, "stated"), "good");
    }
}

/// What was foreseen and is found counts once, whichever line finds it; a warning that no line repeats counts by itself.
#[test]
fn what_is_foreseen_counts_once() {
    let dir = TempDir::new().unwrap();
    let wear = "body.ball.wear.archard.coefficient=1e-13 1/Pa";
    let soft = "body.ball.material.hardness=100 MPa";
    let wide = [
        "frame.size=[\"2.7 mm\",\"2.7 mm\"]",
        "frame.elements=[48, 48]",
        "body.ball.profile.sphere.radius=2 mm",
        "body.ball.material.young=50 MPa",
        "body.flat.material.young=50 MPa",
    ];
    let narrow = ["frame.size=[\"0.3 mm\",\"0.3 mm\"]", "frame.elements=[30, 30]"];
    for (number, (options, subjects)) in [
        (&["frame.elements=[8, 8]"][..], &["elements"][..]),
        (&["frame.elements=[48, 48]", soft], &["hardness"]),
        (&["frame.elements=[8, 8]", soft], &["elements", "hardness"]),
        (&["frame.elements=[48, 48]", wear], &["warning"]),
        (&["frame.elements=[8, 8]", wear], &["elements", "warning"]),
        (&wide, &["half-space"]),
        (&[narrow[0], narrow[1]], &[]),
    ]
    .into_iter()
    .enumerate()
    {
        let hertz = case("hertz");
        let folder = format!("{number}");
        let set = options.iter().flat_map(|option| ["--set", option]);
        let run = ["run", hertz.to_str().unwrap(), "-o", &folder].into_iter().chain(set);
        let ran = squeezed(&printed(&archard(&dir, &run.collect::<Vec<_>>())));
        let summary = fs::read_to_string(dir.path().join(&folder).join("summary.json")).unwrap();
        let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
        let lines = summary["verdict"]["lines"].as_array().unwrap();
        let bad = lines.iter().filter(|line| line["word"] != "good");
        let mut bad: Vec<&str> = bad.map(|line| line["subject"].as_str().unwrap()).collect();
        bad.sort_unstable();
        assert_eq!(bad, subjects, "{options:?}");
        assert_eq!(summary["warnings"].as_array().unwrap().len(), bad.len(), "{options:?}");
        if !bad.is_empty() {
            let count = format!("({} of {} checks)", bad.len(), lines.len());
            assert!(ran.contains(&count), "{options:?}: {ran}");
        }
    }
}

/// One line where all is good; every check in words where that is asked for.
#[test]
fn a_good_verdict_is_one_line() {
    let dir = TempDir::new().unwrap();
    let hertz = case("hertz");
    let run = |more: &[&str]| {
        let options = [&["run", hertz.to_str().unwrap(), "-o", "out"], more].concat();
        printed(&archard(&dir, &options).success())
    };
    let brief = run(&[]);
    let verdict = brief.lines().position(|line| line.starts_with("verdict")).unwrap();
    assert_eq!(squeezed(brief.lines().nth(verdict).unwrap()), "verdict good (7 checks)");
    assert_eq!(brief.lines().count(), verdict + 1, "{brief}");
    let whole = run(&["--verbose"]);
    for line in ["load met to", "elements across the contact", "0 % of the load at the edge"] {
        assert!(whole.contains(line), "{line} is not in\n{whole}");
    }
    assert!(!whole.contains("at most") && !whole.contains('\u{1b}'), "{whole}");
    archard(&dir, &["run", "--quiet", "--verbose", hertz.to_str().unwrap()]).code(2);
}

/// A contact of a hundredth of an element, on an even number of them: four share it, with a ten thousandth of its pressure.
#[test]
fn a_contact_below_its_elements_is_wrong() {
    let dir = TempDir::new().unwrap();
    let hertz = case("hertz");
    let light = "motion.indentation.load=1e-9 N";
    archard(&dir, &["run", hertz.to_str().unwrap(), "--set", light, "-o", "light"]).code(1);
    assert_eq!(word(&dir, "light", "contact"), "wrong");
}

/// One element stands for the contact: its pressure is wrong by a factor, and so is the run, with everything written.
#[test]
fn a_contact_on_one_element_is_wrong() {
    let dir = TempDir::new().unwrap();
    let hertz = case("hertz");
    let coarse = ["frame.size=[\"2 mm\",\"2 mm\"]", "frame.elements=[5,5]"];
    let run =
        ["run", hertz.to_str().unwrap(), "--set", coarse[0], "--set", coarse[1], "-o", "wrong"];
    let failed = archard(&dir, &run).code(1);
    assert!(said(&failed).contains("the result is wrong: contact"), "{}", said(&failed));
    assert!(squeezed(&printed(&failed)).contains("verdict wrong ("));
    assert_eq!(word(&dir, "wrong", "contact"), "wrong");
    assert!(dir.path().join("wrong/fields/0000.vti").is_file());
    archard(&dir, &["plot", "wrong"]).success();
    let picture = fs::read_to_string(dir.path().join("wrong/plots/overview.svg")).unwrap();
    assert!(picture.contains("the result is wrong: contact"));
}

/// Frames that become wider before the scar does: few elements are left at the end, though the first frame had many.
#[test]
fn a_contact_that_wider_frames_do_not_resolve_is_doubtful() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let run = |folder: &str, doubles: &str| {
        let doubles = format!("frame.doubles={doubles}");
        let set =
            ["frame.elements=[40,40]", "motion.sliding.step=", "motion.sliding.tolerance=1e-2"];
        let set = set.into_iter().chain([doubles.as_str()]).flat_map(|key| ["--set", key]);
        let options = ["run", pin.to_str().unwrap(), "-o", folder];
        archard(&dir, &options.into_iter().chain(set).collect::<Vec<_>>()).success();
    };
    run("late", "[\"0.2 m\"]");
    run("early", "[\"10 mm\",\"20 mm\",\"30 mm\"]");
    assert_eq!(word(&dir, "late", "contact"), "good");
    assert_eq!(word(&dir, "early", "contact"), "doubtful");
}

/// Elements across the scar are foreseen by the widest frame.
#[test]
fn wider_frames_are_foreseen() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let foreseen = |more: &[&str]| {
        let set =
            ["--set", "frame.size=[\"0.8 mm\",\"0.8 mm\"]", "--set", "frame.elements=[60,60]"];
        let options = ["check", pin.to_str().unwrap(), "--json"];
        let options = [&options[..], &set, more].concat();
        let text = printed(&archard(&dir, &options).success());
        let check: serde_json::Value = serde_json::from_str(&text).unwrap();
        let lines = check["verdict_foreseen"]["lines"].as_array().unwrap();
        let of = |subject: &str| lines.iter().find(|line| line["subject"] == subject).unwrap();
        of("contact")["value"].as_f64().unwrap()
    };
    // A scar 0.959 mm wide, on elements of 0.8 mm / 60, or on some twice as large.
    for (more, expected) in [(&[][..], 71.9), (&["--set", "frame.doubles=[\"60 mm\"]"], 36.0)] {
        let across = foreseen(more);
        assert!((across - expected).abs() < 0.5, "{across} {expected}");
    }
}
