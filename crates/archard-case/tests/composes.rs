//! What composes: every elasticity with every motion and what goes on top of them runs, or is refused with a reason.
//!
//! `ARCHARD_COMPOSES=1 cargo test --workspace --test composes` writes the page of the book anew.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use archard_case::{CaseFile, Severity};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/composes.md");

const STEEL: &str = "material = { young = \"210 GPa\", poisson = 0.3 }";
const RUBBER: &str = "material = { young = \"10 MPa\", poisson = 0.45 }";
const THERMAL: &str = "thermal = { conductivity = \"50 W/(m K)\", diffusivity = \"13 mm^2/s\", temperature = \"20 degC\" }";

/// Bodies and a frame: what the upper and the lower body have besides what is laid on them, and the frame.
struct Elasticity {
    name: &'static str,
    upper: &'static str,
    lower: &'static str,
    frame: &'static str,
    /// Whether the upper body is steel as the lower one.
    like: bool,
}

const GRID: &str = "frame = { size = [\"0.6 mm\", \"0.6 mm\"], elements = [16, 16] }";

const ELASTICITIES: [Elasticity; 7] = [
    Elasticity {
        name: "like half-spaces",
        upper: "profile.sphere.radius = \"10 mm\"",
        lower: "profile.flat = {}",
        frame: GRID,
        like: true,
    },
    Elasticity {
        name: "unlike half-spaces",
        upper: "profile.sphere.radius = \"10 mm\"",
        lower: "profile.flat = {}",
        frame: GRID,
        like: false,
    },
    Elasticity {
        name: "layers",
        upper: "profile.sphere.radius = \"10 mm\"",
        lower: "profile.flat = {}\nlayers = [{ thickness = \"5 um\", young = \"300 GPa\", poisson = 0.2 }]",
        frame: GRID,
        like: true,
    },
    Elasticity {
        name: "a line of contact",
        upper: "profile.cylinder = { radius = \"10 mm\", axis = \"y\" }",
        lower: "profile.flat = {}",
        frame: "frame = { size = \"0.6 mm\", elements = 64, length = \"1 mm\" }",
        like: true,
    },
    Elasticity {
        name: "surfaces that repeat themselves",
        upper: "profile.wave = { amplitude = \"0.1 um\", length_x = \"0.6 mm\", length_y = \"0.6 mm\" }",
        lower: "profile.flat = {}",
        frame: "frame = { size = [\"0.6 mm\", \"0.6 mm\"], elements = [16, 16], periodic = true }",
        like: true,
    },
    Elasticity {
        name: "a body with an image field",
        upper: "profile.sphere.radius = \"10 mm\"",
        lower: "mesh.box.size = [\"8 mm\", \"4 mm\", \"4 mm\"]\nsupports = { bottom = \"clamped\" }",
        frame: GRID,
        like: true,
    },
    Elasticity {
        name: "a meshed body",
        upper: "profile.sphere.radius = \"10 mm\"",
        lower: "mesh.box = { size = [\"4 mm\", \"4 mm\", \"4 mm\"], contact = { face = \"top\", size = [\"0.6 mm\", \"0.6 mm\"], elements = [8, 8] } }\nsupports = { bottom = \"clamped\" }\nelasticity = \"boundary_elements\"",
        frame: "",
        like: true,
    },
];

/// Motions: name, and the table.
const MOTIONS: [(&str, &str); 12] = [
    ("indentation", "indentation = { load = \"1 N\", increments = 4 }"),
    (
        "fretting, surfaces stay",
        "fretting = { load = \"1 N\", amplitude = [\"0.1 um\", \"0 um\"], increments = 8, surfaces = \"stay\" }",
    ),
    (
        "fretting, surfaces swing",
        "fretting = { load = \"1 N\", amplitude = [\"50 um\", \"0 um\"], cycles = 10, surfaces = \"swing\" }",
    ),
    (
        "sliding, surfaces stay",
        "sliding = { load = \"1 N\", distance = \"1 m\", surfaces = \"stay\", speed = \"1 m/s\", tolerance = 0.01 }",
    ),
    (
        "sliding, surfaces pass",
        "sliding = { load = \"1 N\", distance = \"1 m\", surfaces = \"pass\", speed = \"1 m/s\", tolerance = 0.01 }",
    ),
    (
        "sliding on a track",
        "sliding = { load = \"1 N\", distance = \"1 m\", track_radius = \"5 mm\", passes = \"lower\", speed = \"1 m/s\", tolerance = 0.01 }",
    ),
    (
        "a stroke with its ends",
        "sliding = { load = \"1 N\", distance = \"1 m\", stroke = \"5 mm\", ends = true, passes = \"lower\", tolerance = 0.01 }",
    ),
    ("rotation", "rotation = { load = \"1 N\", revolutions = 10, tolerance = 0.01 }"),
    (
        "rolling",
        "rolling = { load = \"1 N\", creepage = 0.001, revolutions = 10, speed = \"1 m/s\", tolerance = 0.01 }",
    ),
    (
        "a sweep of creepages",
        "creepage_sweep = { load = \"1 N\", creepage = 0.01, speed = \"1 m/s\", increments = 4 }",
    ),
    ("a path", "path = { file = \"path.csv\" }"),
    ("a table of stations", "table = { file = \"stations.csv\", cycles = 10, tolerance = 0.01 }"),
];

/// What goes on top: its letter on the page, and what it adds to the lower body, to friction and to the case.
const EXTRAS: [(&str, &str, &str, &str); 5] = [
    ("", "", "friction.coulomb.coefficient = 0.3", ""),
    ("y", "hardness = \"1 GPa\"", "", ""),
    ("f", "", "friction.orthotropic = { coefficients = [0.3, 0.2] }", ""),
    ("h", THERMAL, "friction.coulomb.coefficient = 0.3", ""),
    ("a", "", "friction.coulomb.coefficient = 0.3", "accuracy = 0.05"),
];

/// The case of a cell.
fn text(elasticity: &Elasticity, motion: &str, extra: (&str, &str, &str, &str)) -> String {
    let (_, lower, friction, top) = extra;
    let upper_material = if elasticity.like { STEEL } else { RUBBER };
    // The error of an accuracy chooses the elements.
    let frame = if top.is_empty() || elasticity.frame.contains("periodic") {
        elasticity.frame.to_owned()
    } else {
        elasticity.frame.replace(", elements = [16, 16]", "").replace(", elements = 64", "")
    };
    let motion =
        if top.is_empty() { motion.to_owned() } else { motion.replace(", tolerance = 0.01", "") };
    let wear = "wear.archard.coefficient = \"1e-7 mm^3/(N m)\"";
    // A share of the heat where one body passes, both bodies' data where they roll.
    let rolls = motion.starts_with("roll") || motion.starts_with("creepage");
    let (upper_heat, lower) = match lower == THERMAL {
        true if rolls => (THERMAL, THERMAL.to_owned()),
        true => ("", THERMAL.replace("thermal = {", "thermal = { share = 1,")),
        false => ("", lower.to_owned()),
    };
    format!(
        "{top}\n{frame}\n{friction}\nmotion.{motion}\n[body.upper]\n{upper_material}\n{}\n{wear}\n{upper_heat}\n\
         [body.lower]\n{STEEL}\n{}\n{wear}\n{lower}\n",
        elasticity.upper, elasticity.lower
    )
}

/// Why a cell does not run; `None` where it does.
fn refused(text: &str) -> Option<String> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = "time_s,load_N,shift_x_um\n0,1,0\n1,1,0.1\n2,1,0\n";
    fs::write(folder.path().join("path.csv"), path).expect("a path");
    let stations = "duration_s,load_N,offset_two_x_mm\n0.5,1,0\n0.5,1,0.1\n";
    fs::write(folder.path().join("stations.csv"), stations).expect("stations");
    let file = CaseFile::from_text("case.toml", text, folder.path().to_owned());
    let problems = file.resolve().err()?;
    let first = problems.iter().find(|problem| problem.severity == Severity::Error);
    Some(first.map_or_else(String::new, |problem| problem.message.clone()))
}

/// What stands for a case that runs.
const RUNS: &str = "\u{2022}";

/// What stands for the result of a case: a dot, or the number of the reason why it is refused.
fn mark(reasons: &mut Vec<String>, refused: Option<String>) -> String {
    let Some(reason) = refused else { return RUNS.to_owned() };
    let known = reasons.iter().position(|one| *one == reason);
    let index = known.unwrap_or_else(|| {
        reasons.push(reason);
        reasons.len() - 1
    });
    (index + 1).to_string()
}

/// The page, and how many cases run.
fn page() -> (String, usize) {
    let mut page = "# What composes\n\nEach motion with each elasticity. A dot runs; a number is the reason below for which the case is refused. \
         Letters have what differs with more on top: y yield, f friction of two axes, h heat, a `accuracy`. A test makes this page.\n\n"
        .to_owned();
    let mut reasons: Vec<String> = vec![];
    let mut count = 0;
    let mut rows = MOTIONS.map(|(motion, _)| format!("| {motion} |"));
    for elasticity in &ELASTICITIES {
        for ((_, table), row) in MOTIONS.iter().zip(&mut rows) {
            let marks =
                EXTRAS.map(|extra| mark(&mut reasons, refused(&text(elasticity, table, extra))));
            count += marks.iter().filter(|mark| *mark == RUNS).count();
            let _ = write!(row, " {}", marks[0]);
            for ((letter, ..), other) in EXTRAS.iter().zip(&marks) {
                if *other != marks[0] {
                    let _ = write!(row, " {letter}{other}");
                }
            }
            row.push_str(" |");
        }
    }
    let names = ELASTICITIES.map(|elasticity| elasticity.name).join(" | ");
    let rule = "|---".repeat(ELASTICITIES.len() + 1);
    let _ = writeln!(page, "| | {names} |\n{rule}|\n{}", rows.join("\n"));
    page.push_str("\n## Reasons\n\n");
    for (index, reason) in reasons.iter().enumerate() {
        let _ = writeln!(page, "{}. {reason}", index + 1);
    }
    (page, count)
}

/// The page says what the program does today.
#[test]
fn the_page_says_what_composes() {
    let (made, count) = page();
    assert!(count > 100, "{made}");
    if std::env::var_os("ARCHARD_COMPOSES").is_some() {
        fs::write(PAGE, &made).expect("the page");
    }
    let known = fs::read_to_string(Path::new(PAGE)).unwrap_or_default();
    assert_eq!(known, made, "write it anew with ARCHARD_COMPOSES=1");
}
