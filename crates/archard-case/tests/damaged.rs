//! Case files, meshes, tables and kept compliances that are damaged at random: an error or a case, soon.
//!
//! Some hundreds in every test, ten minutes of each in `just soak`. What fails is named by its seed:
//! `ARCHARD_SEED=17 cargo test --test damaged -- --include-ignored --skip length` tries that one.

#[path = "common/damage.rs"]
mod damage;
#[path = "common/random.rs"]
mod random;

use std::fs;
use std::path::{Path, PathBuf};

use archard::body::{Finite, Material};
use archard::compliance::bem::contact::Job;
use archard::frame::VectorField;
use archard_case::output::Store;
use archard_case::{CaseFile, Problem, Task};

use damage::{attempt, damaged};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Checks a case and puts everything into words that would be shown.
fn examine(file: &CaseFile) {
    let say = |problems: &[Problem]| {
        for problem in problems {
            assert!(!file.describe(problem).is_empty());
        }
    };
    match file.task() {
        Ok(task) => {
            say(task.warnings());
            let shown = match &task {
                Task::Contact(contact) => format!("{}{}", contact.case, contact.forecast),
                Task::Elastic(elastic) => format!("{}{}", elastic.case, elastic.forecast),
                Task::Cam(cam) => format!("{}{}", cam.case, cam.forecast),
                Task::Gear(gear) => format!("{}{}", gear.case, gear.forecast),
                Task::WheelRail(wheel) => format!("{}{}", wheel.case, wheel.forecast),
            };
            assert!(!shown.contains("NaN"), "{shown}");
        }
        Err(problems) => {
            assert!(!problems.is_empty());
            say(&problems);
        }
    }
}

/// The published cases: where each is, and what is written there.
fn published() -> Vec<(PathBuf, Vec<u8>)> {
    let folders = fs::read_dir(root().join("cases")).unwrap();
    let mut cases: Vec<PathBuf> = folders.map(|folder| folder.unwrap().path()).collect();
    cases.sort();
    let read = |folder: PathBuf| Some((folder.clone(), fs::read(folder.join("case.toml")).ok()?));
    cases.into_iter().filter_map(read).collect()
}

fn cases(quick: u64, long: bool) {
    let known = published();
    let texts: Vec<Vec<u8>> = known.iter().map(|case| case.1.clone()).collect();
    attempt("case files", quick, long, |random| {
        let (folder, text) = &known[random.below(known.len())];
        let text = damaged(text, &texts, random);
        examine(&CaseFile::from_text("case", String::from_utf8_lossy(&text), folder));
    });
}

/// Surfaces that are named in the meshes, so that what is behind the reader sees them too.
const ELASTIC: &str = r#"
    [body.block]
    material = { young = "1 GPa", poisson = 0.25 }
    mesh.file = { path = "block" }
    supports = { "bottom side" = "clamped", top = { pressure = "1 MPa" } }
"#;

fn meshes(quick: u64, long: bool) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("block");
    let meshes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../archard/tests/meshes");
    let mut names: Vec<PathBuf> =
        fs::read_dir(meshes).unwrap().map(|file| file.unwrap().path()).collect();
    names.retain(|name| name.extension().is_some_and(|end| end == "msh" || end == "stl"));
    names.sort();
    let files: Vec<Vec<u8>> = names.iter().map(|name| fs::read(name).unwrap()).collect();
    attempt("meshes", quick, long, |random| {
        let bytes = damaged(&files[random.below(files.len())], &files, random);
        fs::write(&path, bytes).unwrap();
        examine(&CaseFile::from_text("case", ELASTIC, folder.path()));
    });
}

/// Heights on a grid, and a path.
const TABLES: [&str; 3] = [
    "x_mm,y_mm,z_um\n-1,-1,0\n0,-1,1\n1,-1,0\n-1,0,1\n0,0,3\n1,0,1\n-1,1,0\n0,1,1\n1,1,0\n",
    "x_mm,z_um\n-1,0\n-0.5,1.5\n0,2e0\n0.5,1.5\n1,0\n",
    "# a path\ntime_s,load_N,shift_x_um,force_y_N\n0,0,0,0\n1,10,0,0\n2,10,1.5,0.1\n3,5,-1.5,-0.1\n",
];

fn tables(quick: u64, long: bool) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("table.csv");
    let known = TABLES.map(|table| table.as_bytes().to_vec());
    let case = fs::read_to_string(root().join("cases/cattaneo_mindlin/case.toml")).unwrap();
    attempt("tables", quick, long, |random| {
        let which = random.below(known.len());
        fs::write(&path, damaged(&known[which], &known, random)).unwrap();
        let file = CaseFile::from_text("case", &*case, folder.path());
        examine(&match which {
            2 => file.set("motion={ path = { file = 'table.csv' } }"),
            _ => file.set("body.ball.profile={ table = { file = 'table.csv' } }"),
        });
    });
}

/// A rigid ball on a coarse block.
const MESHED: &str = r#"
    [body.ball]
    rigid = true
    profile.sphere = { radius = "50 mm" }
    [body.block]
    material = { young = "1 GPa", poisson = 0.3 }
    mesh.box = { size = ["10 mm", "10 mm", "10 mm"], contact = { face = "top", size = ["2 mm", "2 mm"], elements = [4, 4] } }
    supports = { bottom = "clamped" }
    symmetry = ["x", "y"]
    boundary_elements.tolerance = 1e-2
    [motion.indentation]
    load = "1 N"
"#;

/// What unit pressures do, with compliances kept in a folder.
fn displaced(folder: &Path) -> Vec<f64> {
    let resolved = CaseFile::from_text("case", MESHED, ".").resolve().expect("a case");
    let store = Store::new(folder);
    let condense =
        |finite: &Finite, material: &Material, job: &Job<'_>| store.condense(finite, material, job);
    let problem = resolved.case.build_with(&condense).expect("a checked case").problem;
    let mut unit = VectorField::zeros(problem.frame.len());
    unit.n.fill(1.0);
    problem.compliance.apply(&unit).n
}

fn kept(quick: u64, long: bool) {
    let folder = tempfile::tempdir().unwrap();
    let expected = displaced(folder.path());
    let file = fs::read_dir(folder.path()).unwrap().next().expect("a file").unwrap().path();
    let whole = fs::read(&file).unwrap();
    attempt("kept compliances", quick, long, |random| {
        fs::write(&file, damaged(&whole, std::slice::from_ref(&whole), random)).unwrap();
        // Computed anew, to the bit.
        assert_eq!(displaced(folder.path()), expected);
    });
}

#[test]
#[ignore = "long: in .ci/long"]
fn damaged_cases_are_refused_or_read() {
    cases(4000, false);
}

#[test]
fn damaged_meshes_are_refused_or_read() {
    meshes(1500, false);
}

#[test]
#[ignore = "long: in .ci/long"]
fn damaged_tables_are_refused_or_read() {
    tables(2500, false);
}

#[test]
fn damaged_compliances_are_computed_anew() {
    kept(20, false);
}

#[test]
#[ignore = "takes ten minutes; `just soak` runs it"]
fn damaged_cases_at_length() {
    cases(0, true);
}

#[test]
#[ignore = "takes ten minutes; `just soak` runs it"]
fn damaged_meshes_at_length() {
    meshes(0, true);
}

#[test]
#[ignore = "takes ten minutes; `just soak` runs it"]
fn damaged_tables_at_length() {
    tables(0, true);
}

#[test]
#[ignore = "takes ten minutes; `just soak` runs it"]
fn damaged_compliances_at_length() {
    kept(0, true);
}
