//! The house in numbers: a table of the crates, and of the folders of `archard`, whose columns fall and do not rise.
//!
//! `ARCHARD_HOUSE=1 cargo test -p archard --test house` (`just house`) writes the table anew. A commit that lets a column rise changes
//! the table with it and says why in its message.

mod prose;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

const CRATES: [&str; 8] = [
    "archard",
    "archard-case",
    "archard-lab",
    "archard-log",
    "archard-gear",
    "archard-rail",
    "archard-surface",
    "archard-cli",
];
const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/house.csv");

/// The columns: what is counted in each folder.
const COLUMNS: [&str; 6] = ["lines", "constants", "questions", "types", "tuples", "returns"];

/// How code outside `motion` asks a motion for its kind: by the names of what its answers can be, and by whether there is one.
const KINDS: [&str; 4] = ["Slip::", "Sequence::", "Passage::", "Lever::"];
const ANSWERS: [&str; 9] = [
    "driven",
    "increments",
    "lever_arm",
    "sliding_speed",
    "amplitude",
    "track",
    "passing",
    "stream",
    "table",
];

/// A source file of one folder, without comments, empty lines and unit tests.
struct Source {
    /// Its module path within the folder: `cycles/jump`; a `mod.rs` is its folder.
    module: String,
    lines: Vec<String>,
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> = fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    entries.sort();
    for path in entries {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() {
            if name != "tests" {
                files(&path, found);
            }
        } else if path.extension().is_some_and(|extension| extension == "rs")
            && !["tests", "fixture"].contains(&&*name)
        {
            found.push(path);
        }
    }
}

fn code(text: &str) -> Vec<String> {
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    code.lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && !line.starts_with("//"))
        .map(str::to_owned)
        .collect()
}

/// The folders of the table, each with its sources: a crate, or a module of `archard`.
fn folders() -> BTreeMap<String, Vec<Source>> {
    let mut folders: BTreeMap<String, Vec<Source>> = BTreeMap::new();
    for name in CRATES {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name).join("src");
        let mut found = Vec::new();
        files(&root, &mut found);
        for file in found {
            let inside = file.strip_prefix(&root).expect("a file of the crate").with_extension("");
            let parts: Vec<_> = inside.iter().map(|part| part.to_string_lossy()).collect();
            let module = parts.join("/");
            let module = module.strip_suffix("/mod").unwrap_or(&module).to_owned();
            let lines = code(&fs::read_to_string(&file).expect("a text"));
            if name == "archard" && module != "lib" {
                let folder = format!("archard/{}", parts[0]);
                let source = Source { module: module.clone(), lines: lines.clone() };
                folders.entry(folder).or_default().push(source);
            }
            folders.entry(name.to_owned()).or_default().push(Source { module, lines });
        }
    }
    folders
}

/// Whether a line declares a constant whose value is a number chosen there.
fn is_constant(line: &str) -> bool {
    let line = line.strip_prefix("pub ").or(line.strip_prefix("pub(crate) ")).unwrap_or(line);
    let line = line.strip_prefix("pub(super) ").unwrap_or(line);
    let number = |of: &str| {
        let of = of.trim_start_matches(['[', '&']);
        ["f64", "f32", "usize", "u8", "u32", "u64", "isize", "i32"]
            .iter()
            .any(|kind| of.starts_with(kind))
    };
    line.strip_prefix("const ").and_then(|rest| rest.split_once(": ")).is_some_and(
        |(name, kind)| {
            name.chars().all(|c| c.is_ascii_uppercase() || c == '_' || c.is_ascii_digit())
                && number(kind)
        },
    )
}

/// What a line asks a motion for its kind, one for each way of asking. To read an answer is no question.
fn questions(line: &str) -> usize {
    if line.starts_with("use ") {
        return 0;
    }
    let named = |kind: &&str| {
        let word = |at: usize| !line[..at].ends_with(char::is_alphanumeric);
        line.match_indices(*kind).filter(|(at, _)| word(*at)).count()
    };
    let kinds: usize = KINDS.iter().map(named).sum();
    let whether = |answer: &&&str| {
        ["(0.0)", "()", "(progress)"].iter().any(|taken| {
            line.contains(&format!("motion.{answer}{taken}.is_some"))
                || line.contains(&format!("motion.{answer}{taken}.is_none"))
        })
    };
    kinds + ANSWERS.iter().filter(whether).count() + line.matches("motion.stays()").count()
}

fn is_type(line: &str) -> bool {
    ["pub struct ", "pub enum ", "pub trait ", "pub type "]
        .iter()
        .any(|kind| line.starts_with(kind))
}

/// Parameters that take a tuple apart in the signature of a function: `(a, b): (A, B)`.
fn tuples(lines: &[String]) -> usize {
    let mut count = 0;
    let mut within = false;
    for line in lines {
        let begins = ["fn ", "pub fn ", "pub(super) fn ", "pub(crate) fn "]
            .iter()
            .any(|word| line.starts_with(word));
        within |= begins;
        if within {
            count += line.matches("): (").count() + line.matches("): &(").count();
        }
        within &= !(line.ends_with('{') || line.ends_with(';') || line.ends_with('}'));
    }
    count
}

/// The modules of its folder that a source imports.
fn imports(source: &Source, known: &BTreeSet<&str>) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for tree in used(&source.lines) {
        let mut add = |path: &[&str]| {
            // The deepest module that the path names.
            let longest = (1..=path.len())
                .rev()
                .map(|n| path[..n].join("/"))
                .find(|path| known.contains(&**path));
            if let Some(module) = longest.filter(|module| *module != source.module) {
                found.insert(module);
            }
        };
        for path in leaves(&tree) {
            let parts: Vec<&str> = path.split("::").collect();
            let own: Vec<&str> = source.module.split('/').collect();
            match parts[0] {
                "crate" => add(&parts[1..]),
                "super" => {
                    let up = parts.iter().take_while(|part| **part == "super").count();
                    let kept = own.len().saturating_sub(up);
                    add(&own[..kept].iter().chain(&parts[up..]).copied().collect::<Vec<_>>());
                }
                first if known.contains(&*format!("{}/{first}", source.module)) => {
                    add(&own.iter().chain(&parts).copied().collect::<Vec<_>>());
                }
                _ => {}
            }
        }
    }
    found
}

/// What each `use` names, without blanks.
fn used(lines: &[String]) -> Vec<String> {
    let begins = |line: &str| {
        let line = line.strip_prefix("pub ").unwrap_or(line);
        line.strip_prefix("use ").map(str::to_owned)
    };
    let mut trees = Vec::new();
    let mut lines = lines.iter();
    while let Some(line) = lines.next() {
        let Some(mut tree) = begins(line) else { continue };
        while !tree.ends_with(';') {
            let Some(more) = lines.next() else { break };
            tree.push_str(more);
        }
        trees.push(tree.trim_end_matches(';').split_whitespace().collect());
    }
    trees
}

/// The single paths of a `use` with braces.
fn leaves(tree: &str) -> Vec<String> {
    let Some(open) = tree.find('{') else { return vec![tree.to_owned()] };
    let (stem, inside) = (&tree[..open], &tree[open + 1..tree.rfind('}').unwrap_or(tree.len())]);
    let (mut depth, mut part, mut parts) = (0, String::new(), Vec::new());
    for letter in inside.chars() {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(std::mem::take(&mut part));
                continue;
            }
            _ => {}
        }
        part.push(letter);
    }
    parts.push(part);
    let leaves = parts.iter().filter(|part| !part.is_empty()).flat_map(|part| leaves(part));
    leaves.map(|leaf| format!("{stem}{leaf}")).collect()
}

/// Imports that lie on a circle: from a module to one that comes back to it. A module and the `mod.rs` that collects it, or its
/// parts, count as any other two.
fn returns(sources: &[Source]) -> usize {
    let known: BTreeSet<&str> = sources.iter().map(|source| &*source.module).collect();
    let arrows: BTreeMap<&str, BTreeSet<String>> =
        sources.iter().map(|source| (&*source.module, imports(source, &known))).collect();
    let reaches = |from: &str, to: &str| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![from.to_owned()]);
        while let Some(module) = open.pop() {
            if module == to {
                return true;
            }
            if seen.insert(module.clone()) {
                open.extend(arrows.get(&*module).into_iter().flatten().cloned());
            }
        }
        false
    };
    arrows
        .iter()
        .flat_map(|(from, to)| to.iter().map(move |to| (*from, to)))
        .filter(|(from, to)| reaches(to, from))
        .count()
}

fn counted(folder: &str, sources: &[Source]) -> [usize; COLUMNS.len()] {
    let lines = || sources.iter().flat_map(|source| &source.lines);
    let questions = if folder == "archard/motion" {
        0
    } else {
        let outside = sources
            .iter()
            .filter(|source| folder != "archard" || !source.module.starts_with("motion"));
        outside.flat_map(|source| &source.lines).map(|line| questions(line)).sum()
    };
    [
        lines().count(),
        lines().filter(|line| is_constant(line)).count(),
        questions,
        lines().filter(|line| is_type(line)).count(),
        sources.iter().map(|source| tuples(&source.lines)).sum(),
        returns(sources),
    ]
}

fn table() -> BTreeMap<String, [usize; COLUMNS.len()]> {
    folders().iter().map(|(folder, sources)| (folder.clone(), counted(folder, sources))).collect()
}

fn kept() -> BTreeMap<String, Vec<usize>> {
    let text = fs::read_to_string(TABLE).expect("the table");
    let rows = text.lines().skip(1).map(|row| {
        let mut cells = row.split(',');
        let folder = cells.next().expect("a folder").to_owned();
        (folder, cells.map(|cell| cell.parse().expect("a number")).collect())
    });
    rows.collect()
}

/// What `cargo test` leaves out runs in `.ci/run`, by its name in `.ci/long`.
#[test]
fn long_tests_run_by_name() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut sources = vec![];
    for name in CRATES {
        for part in ["src", "tests"] {
            let folder = root.join("crates").join(name).join(part);
            if folder.exists() {
                everything(&folder, &mut sources);
            }
        }
    }
    let mut long = BTreeSet::new();
    for path in sources {
        let text = fs::read_to_string(&path).expect("a source");
        let marked = text.split("#[ignore = \"long: in .ci/long\"]\n").skip(1);
        let name = |rest: &str| {
            let name = rest.split_once("fn ")?.1;
            Some(name.split('(').next()?.to_owned())
        };
        long.extend(marked.filter_map(name));
    }
    let listed = fs::read_to_string(root.join(".ci/long")).expect("the names of long tests");
    let listed: BTreeSet<String> = listed.lines().map(str::to_owned).collect();
    assert_eq!(long, listed);
}

/// All Rust below a folder, tests too.
fn everything(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            everything(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// Sources of more lines than a reader keeps in mind, each with what keeps it together.
const LONG: [(&str, &str); 6] = [
    ("archard-case/src/case/print.rs", "one case, key by key"),
    ("archard/src/simulation/history.rs", "one table of columns"),
    ("archard/src/wear/expression/parser.rs", "one grammar"),
    ("archard-case/src/case/wheel_rail/mod.rs", "one case, with all that is asked of it"),
    ("archard-case/src/verdict/bounds.rs", "one list, a function a line of the verdict"),
    ("archard-cli/src/plot/results.rs", "one type: the files of a result folder"),
];
/// The most lines of others.
const LINES: usize = 400;

#[test]
fn long_sources_have_a_reason() {
    let mut sources = vec![];
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for name in CRATES {
        files(&crates.join(name).join("src"), &mut sources);
    }
    let long = |path: &&PathBuf| {
        let text = fs::read_to_string(path).expect("a source");
        text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default().lines().count() > LINES
    };
    let name = |path: &PathBuf| {
        path.strip_prefix(&crates).expect("a crate").to_string_lossy().replace('\\', "/")
    };
    let found: BTreeSet<String> = sources.iter().filter(long).map(name).collect();
    let known: BTreeSet<String> = LONG.iter().map(|(path, _)| (*path).to_owned()).collect();
    println!("sources of more than {LINES} lines: {}", found.len());
    assert_eq!(found, known, "divide it by its ideas, or give the reason that keeps it whole");
}

#[test]
fn no_column_of_the_house_rises() {
    let now = table();
    if std::env::var_os("ARCHARD_HOUSE").is_some() {
        let mut text = format!("folder,{}\n", COLUMNS.join(","));
        for (folder, row) in &now {
            writeln!(text, "{folder},{}", row.map(|value| value.to_string()).join(","))
                .expect("a text");
        }
        fs::write(TABLE, &text).expect("the table");
        println!("{text}");
    }
    let kept = kept();
    let mut risen = Vec::new();
    for (folder, row) in &now {
        let before = kept.get(folder).cloned().unwrap_or_else(|| vec![0; COLUMNS.len()]);
        for ((column, now), before) in COLUMNS.iter().zip(row).zip(before) {
            if *now > before {
                risen.push(format!("{folder}: {column} {before} -> {now}"));
            }
        }
    }
    assert!(
        risen.is_empty(),
        "write the table anew with ARCHARD_HOUSE=1 and say in the commit why these rise:\n{}",
        risen.join("\n")
    );
}

#[test]
fn the_counts_are_what_they_are_called() {
    let lines = |text: &str| code(text);
    let text = "const A: f64 = 0.3;\n// const B: f64 = 1.0;\npub const NAME: &str = \"x\";\n\nconst C: [f64; 2] = [1.0; 2];\n#[cfg(test)]\nconst D: f64 = 1.0;";
    assert_eq!(lines(text).len(), 3);
    assert_eq!(lines(text).iter().filter(|line| is_constant(line)).count(), 2);
    assert_eq!(questions("if motion.driven(0.0).is_some() && slip == Slip::Given(1.0, arm) {"), 2);
    assert_eq!(questions("use crate::motion::Slip::{self, Given};"), 0);
    assert_eq!(questions("StickSlip::open(3), motion.track()?.length"), 0);
    assert_eq!(
        tuples(&lines(
            "fn f(\n    (a, b): (f64, f64),\n    c: f64,\n) -> f64 {\n    let (x, y): (f64, f64) = c;"
        )),
        1
    );
    assert_eq!(leaves("a::{b,c::{d,e}}"), ["a::b", "a::c::d", "a::c::e"]);
    let source =
        |module: &str, text: &str| Source { module: module.to_owned(), lines: lines(text) };
    let circle = [
        source("run", "use super::run::march::March;\nuse crate::solve::press;"),
        source("run/march", "use super::Error;\nuse super::step::{self, Step};"),
        source("run/step", "fn f() {}"),
    ];
    // `run` to `march` and back; `march` to `step` does not come back.
    assert_eq!(returns(&circle), 2);
    assert_eq!(returns(&circle[1..]), 0);
}
