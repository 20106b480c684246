//! What a run says, and what it leaves behind.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use super::{archard, case, printed, said, squeezed};

#[test]
fn a_run_leaves_a_case_that_runs_again() {
    let dir = TempDir::new().unwrap();
    let small = ["--set", "frame.elements=[12, 12]", "--set", "motion.sliding.step=50 mm"];
    let case = case("pin_on_disc");
    let mut arguments = vec!["run", case.to_str().unwrap()];
    arguments.extend(small);
    let ran = archard(&dir, &arguments).success();
    let results = "pin_on_disc--frame.elements=12x12--motion.sliding.step=50mm";
    let results = Path::new("results").join(results);
    let results = results.to_str().unwrap();
    assert!(printed(&ran).contains(results), "{}", printed(&ran));
    let again = archard(&dir, &["run", results, "-o", "again", "--quiet"]).success();
    let results = dir.path().join(results);
    for name in ["case.toml", "history.csv", "summary.json", "fields.pvd"] {
        assert!(results.join(name).is_file(), "{name}");
    }
    // So few elements are doubtful, which is said all the same.
    assert_eq!(printed(&again), "");
    assert!(squeezed(&said(&again)).contains("doubtful"), "{}", said(&again));
    for name in ["case.toml", "history.csv"] {
        let read = |folder: &Path| fs::read_to_string(folder.join(name)).unwrap();
        assert_eq!(read(&results), read(&dir.path().join("again")), "{name}");
    }
}

#[test]
fn results_in_a_folder_of_an_earlier_run_leave_other_files_alone() {
    let dir = TempDir::new().unwrap();
    let case = case("hertz");
    let arguments =
        ["run", case.to_str().unwrap(), "-o", "out", "--set", "frame.elements=[10, 10]"];
    archard(&dir, &arguments).success();
    fs::write(dir.path().join("out/notes.txt"), "mine").unwrap();
    archard(&dir, &arguments).success();
    assert_eq!(fs::read_to_string(dir.path().join("out/notes.txt")).unwrap(), "mine");
}

#[test]
fn an_output_folder_that_cannot_be_written_exits_with_two() {
    let dir = TempDir::new().unwrap();
    fs::write(dir.path().join("taken"), "a file, not a folder").unwrap();
    let case = case("hertz");
    let refused = archard(&dir, &["run", case.to_str().unwrap(), "-o", "taken/out"]).code(2);
    let said = said(&refused);
    assert!(said.contains("cannot write `taken/out"), "{said}");
}

#[test]
fn results_never_replace_the_case_itself() {
    let dir = TempDir::new().unwrap();
    archard(&dir, &["new", "hertz"]).success();
    let before = fs::read_to_string(dir.path().join("hertz/case.toml")).unwrap();
    let refused = archard(&dir, &["run", "hertz", "-o", "hertz"]).code(2);
    assert!(said(&refused).contains("results would take its place"));
    assert_eq!(fs::read_to_string(dir.path().join("hertz/case.toml")).unwrap(), before);
}

#[test]
fn a_solve_that_does_not_converge_exits_with_one_and_says_by_how_much() {
    let dir = TempDir::new().unwrap();
    let case = case("pin_on_disc");
    let option = "solver.conjugate_gradient.max_iterations=1";
    let arguments = ["run", case.to_str().unwrap(), "-o", "out", "--set", option];
    let failed = archard(&dir, &arguments).code(1);
    let said = said(&failed);
    for part in ["at distance 0.0 m did not converge", "residual", "1 iterations", "1.0e-8"] {
        assert!(said.contains(part), "{part} is not in\n{said}");
    }
    assert!(said.contains("what was computed so far is in out"), "{said}");
    let summary = fs::read_to_string(dir.path().join("out/summary.json")).unwrap();
    assert!(summary.contains("\"complete\": false"), "{summary}");
    assert!(summary.contains("did not converge"), "{summary}");
}

/// A frame that is too small for the scar grows with it: the run ends as in one that is large enough, and its pictures are
/// drawn.
#[test]
fn a_frame_grows_with_the_scar() {
    let dir = TempDir::new().unwrap();
    let case = case("pin_on_disc");
    let last = |folder: &str, frame: [&str; 2]| {
        let arguments = ["run", case.to_str().unwrap(), "-o", folder];
        let frame = frame.iter().flat_map(|setting| ["--set", setting]);
        archard(&dir, &arguments.into_iter().chain(frame).collect::<Vec<_>>()).success();
        let history = fs::read_to_string(dir.path().join(folder).join("history.csv")).unwrap();
        let (names, row) = (history.lines().next().unwrap(), history.lines().last().unwrap());
        let depth = names.split(',').position(|name| name == "wear_depth_m").unwrap();
        row.split(',').nth(depth).unwrap().parse::<f64>().unwrap()
    };
    let grown = last("grown", ["frame.size=[\"0.4 mm\", \"0.4 mm\"]", "frame.elements=[10, 10]"]);
    let large = last("large", ["frame.size=[\"1.2 mm\", \"1.2 mm\"]", "frame.elements=[30, 30]"]);
    assert!((grown / large - 1.0).abs() < 1e-7, "{grown:e} {large:e}");
    archard(&dir, &["report", "grown"]).success();
}

#[test]
fn explicit_steps_beyond_their_bound_run_with_a_warning() {
    let dir = TempDir::new().unwrap();
    let case = case("pin_on_disc");
    let explicit = ["--set", "motion.sliding.scheme=explicit", "--set", "output.every=1 m"];
    let arguments = [&["run", case.to_str().unwrap(), "-o", "out"][..], &explicit].concat();
    let said = said(&archard(&dir, &arguments).success());
    assert!(said.contains("the explicit scheme is unstable with this step"), "{said}");
    assert!(said.contains("3.03 mm"), "{said}");
}

#[cfg(unix)]
#[test]
fn standard_output_may_be_closed_or_full() {
    let shell = |line: &str| {
        let program = assert_cmd::cargo::cargo_bin("archard");
        let case = case("hertz");
        let line =
            line.replace("CHECK", &format!("'{}' check '{}'", program.display(), case.display()));
        assert_cmd::Command::new("bash").args(["-o", "pipefail", "-c", &line]).assert()
    };
    shell("CHECK | head -n 1").code(0);
    let full = shell("CHECK > /dev/full").code(2);
    assert!(said(&full).contains("cannot write to standard output"), "{}", said(&full));
}

#[test]
fn threads_are_few_and_many_are_refused() {
    let dir = TempDir::new().unwrap();
    let hertz = case("hertz");
    let hertz = hertz.to_str().unwrap();
    let few = ["run", hertz, "-o", "few", "--quiet", "--set", "frame.elements=[41, 41]"];
    for (threads, known) in [(&[][..], 1), (&["--threads", "2"], 2)] {
        archard(&dir, &[&few, threads, &["--force"]].concat()).success();
        let summary = std::fs::read_to_string(dir.path().join("few/summary.json")).unwrap();
        assert!(summary.contains(&format!("\"threads\": {known}")), "{summary}");
    }
    archard(&dir, &["run", hertz, "-o", "out", "--threads", "1", "--quiet"]).success();
    let summary = fs::read_to_string(dir.path().join("out/summary.json")).unwrap();
    assert!(summary.contains("\"threads\": 1"), "{summary}");
    let refused = archard(&dir, &["run", hertz, "-o", "out", "--threads", "100000"]).code(2);
    assert!(said(&refused).contains("processors"), "{}", said(&refused));
}

/// On elements that are given, and where an accuracy asks for ever finer ones.
#[test]
fn friction_that_does_not_converge_exits_with_one() {
    let dir = TempDir::new().unwrap();
    let option = "friction_solver.newton.max_iterations=1";
    for name in ["carter", "twin_disc"] {
        let case = case(name);
        let arguments = ["run", case.to_str().unwrap(), "-o", "out", "--force", "--set", option];
        let said = said(&archard(&dir, &arguments).code(1));
        for part in ["revolution 0.0 did not converge", "1 iterations", "`friction_solver`"] {
            assert!(said.contains(part), "{part} is not in\n{said}");
        }
    }
    let summary = fs::read_to_string(dir.path().join("out/summary.json")).unwrap();
    assert!(summary.contains("\"complete\": false"), "{summary}");
}

#[test]
fn rolling_says_what_to_expect_and_what_came_out() {
    let dir = TempDir::new().unwrap();
    let case = case("twin_disc");
    let checked = printed(&archard(&dir, &["check", case.to_str().unwrap()]).success());
    for line in [
        "saturation        creepage 0.00802 (all slips, mu a/R)",
        "stick share       0.261 (strip theory)",
        "creep force       155 N along (Vermeulen-Johnson)",
        "wear depth        26.0 um at the end (incremental model)",
        "contact solves    about 50",
    ] {
        assert!(checked.contains(line), "{line} is not in\n{checked}");
    }
    let contact = ["motion.rolling.revolutions=0", "motion.rolling.tolerance=", "output="];
    let mut arguments = vec!["run", case.to_str().unwrap(), "-o", "out"];
    arguments.extend(contact.iter().flat_map(|option| ["--set", option]));
    let ran = archard(&dir, &arguments).success();
    assert!(said(&ran).contains("100 %  revolution 0"), "{}", said(&ran));
    let printed = printed(&ran);
    let printed = squeezed(&printed);
    for line in ["creepage 0.005000 along", "worn section (disc2) 0 mm^2"] {
        assert!(printed.contains(line), "{line} is not in\n{printed}");
    }
    let force = printed.split("creep force (disc1) ").nth(1).unwrap();
    let force = force.split_whitespace().next().unwrap();
    assert!((force.parse::<f64>().unwrap() / (0.895 * 180.0) - 1.0).abs() < 0.01, "{printed}");
    assert!(printed.contains("N along"), "{printed}");
    // Where no force is passed on, no work of it is either.
    let free = ["--set", "frame.elements=40", "--set", "accuracy=0.2"];
    let free = [&["run", "free_rolling_unlike", "-o", "free"], &free[..]].concat();
    let printed = squeezed(&super::printed(&archard(&dir, &free).success()));
    assert!(printed.contains("T gamma / A 0 N/mm^2"), "{printed}");
    assert!(printed.contains("areas and volumes are those of 20.00 mm"), "{printed}");
    archard(&dir, &["report", "free"]).success();
    let page = fs::read_to_string(dir.path().join("free/report.html")).unwrap();
    assert!(page.contains("areas and volumes are those of 20.00 mm"));
}

#[test]
#[ignore = "long: in .ci/long"]
fn fretting_leaves_its_loop_and_says_what_it_dissipated() {
    let dir = TempDir::new().unwrap();
    let case = case("cattaneo_mindlin");
    let options =
        ["frame.elements=[16, 16]", "motion.fretting.increments=8", "motion.fretting.cycles=2"];
    let mut arguments = vec!["run", case.to_str().unwrap(), "-o", "out"];
    arguments.extend(options.iter().flat_map(|option| ["--set", option]));
    let ran = archard(&dir, &arguments).success();
    assert!(said(&ran).contains("100 %  cycle 2,"), "{}", said(&ran));
    let printed = printed(&ran);
    let printed = squeezed(&printed);
    for text in ["stick area 0.0", "nJ of it in the last cycle"] {
        assert!(printed.contains(text), "{text} is not in\n{printed}");
    }
    // The beginning of each cycle and its increments.
    let loops = fs::read_to_string(dir.path().join("out/fretting_loop.csv")).unwrap();
    assert_eq!(loops.lines().count(), 1 + 2 * (1 + 8), "{loops}");
    archard(&dir, &["plot", "out"]).success();
    assert!(dir.path().join("out/plots/fretting_loop.svg").is_file());
    archard(&dir, &["report", "out"]).success();
    let page = fs::read_to_string(dir.path().join("out/report.html")).unwrap();
    let across = page.split("<tr>").find(|row| row.contains(">Shift y<")).unwrap();
    assert!(across.contains("<td>0 mm</td>"), "{}", &across[..across.len().min(300)]);
}

/// The approach that a case gives is no result, and its load is one.
#[test]
fn under_a_given_approach_the_load_is_told() {
    let dir = TempDir::new().unwrap();
    let options = ["frame.elements=[16, 16]", "motion.indentation.increments=16", "accuracy=0.2"];
    let mut arguments = vec!["run", "spence", "-o", "out", "--report"];
    arguments.extend(options.iter().flat_map(|option| ["--set", option]));
    let printed = squeezed(&printed(&archard(&dir, &arguments).success()));
    for text in ["approach 2.500 um prescribed", " N +- "] {
        assert!(printed.contains(text), "{text} is not in\n{printed}");
    }
    let page = fs::read_to_string(dir.path().join("out/report.html")).unwrap();
    let row = |name: &str| {
        let row = page.split("<tr>").find(|row| row.contains(name) && row.contains("</td>"));
        row.unwrap_or_default().to_owned()
    };
    assert!(row(">Approach<").contains("prescribed"), "{}", row(">Approach<"));
    assert!(row(">Load<").contains("±"), "{}", row(">Load<"));
}

#[test]
fn twin_discs_on_hardly_any_elements_do_not_panic() {
    for elements in ["[3, 3]", "[2, 5]"] {
        let dir = TempDir::new().unwrap();
        let case = case("twin_disc");
        let option = format!("frame.elements={elements}");
        let arguments = ["run", case.to_str().unwrap(), "-o", "out", "-q", "--set", &option];
        let ran = archard(&dir, &arguments);
        let code = ran.get_output().status.code();
        assert!(code.is_some_and(|code| code < 3), "{elements}: {code:?}: {}", said(&ran));
        assert!(!said(&ran).contains("panicked"), "{elements}: {}", said(&ran));
    }
}
