//! Layers: a module imports only what stands below it (see ARCHITECTURE.md).

use std::fs;
use std::path::{Path, PathBuf};

/// The crates whose modules have layers; what stands above, `archard-lab`, the command and Python, is apart by being crates.
const CRATES: [&str; 2] = ["archard", "archard-case"];

/// The modules of the library from the ground up; those of one layer do not see each other. Those of `archard-case` begin with
/// `verdict`.
const LAYERS: &[&[&str]] = &[
    &["numerics", "parameters", "stress", "units"],
    &["wear", "friction"],
    &["body"],
    &["frame", "closed_form"],
    &["compliance", "motion"],
    &["elastic", "problem"],
    &["solve"],
    &["simulation", "estimate"],
    &["accuracy"],
    &["verdict", "measured"],
    &["files"],
    &["output"],
    &["case"],
];

fn layer(module: &str) -> Option<usize> {
    LAYERS.iter().position(|layer| layer.contains(&module))
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the source folder") {
        let path = entry.expect("a readable entry").path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// The modules of the crate a text names after `crate::`, braces included, each with its line.
fn imports(text: &str) -> Vec<(usize, String)> {
    let word = |text: &str| {
        text.trim_start()
            .chars()
            .take_while(|c| c.is_alphanumeric() || *c == '_')
            .collect::<String>()
    };
    let mut modules = Vec::new();
    for (at, found) in text.match_indices("crate::") {
        let line = text[..at].matches('\n').count() + 1;
        let rest = &text[at + found.len()..];
        match rest.strip_prefix('{') {
            Some(list) => modules.extend(outermost(list).iter().map(|part| (line, word(part)))),
            None => modules.push((line, word(rest))),
        }
    }
    modules.retain(|(_, module)| !module.is_empty());
    modules
}

/// The parts of a braced list, as far as its closing brace, parted by the commas that stand in no
/// further braces.
fn outermost(list: &str) -> Vec<String> {
    let (mut depth, mut parts) = (1, vec![String::new()]);
    for letter in list.chars() {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        match (letter, depth) {
            (_, 0) => break,
            (',', 1) => parts.push(String::new()),
            _ => parts.iter_mut().next_back().expect("one at least").push(letter),
        }
    }
    parts
}

/// The sources with their module and its layer.
fn layered_sources() -> Vec<(PathBuf, String, usize, String)> {
    let mut layered = Vec::new();
    for name in CRATES {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name).join("src");
        let mut files = Vec::new();
        sources(&root, &mut files);
        for file in files {
            let inside = file.strip_prefix(&root).expect("a file below the root").to_owned();
            let first = inside.iter().next().and_then(|first| Path::new(first).file_stem());
            let module = first.and_then(|stem| stem.to_str()).expect("a name").to_owned();
            if module != "lib" {
                let own = layer(&module)
                    .unwrap_or_else(|| panic!("`{module}` has no layer: add it to LAYERS"));
                layered.push((inside, module, own, fs::read_to_string(&file).expect("a text")));
            }
        }
    }
    layered
}

#[test]
fn modules_import_only_what_stands_below_them() {
    let mut wrong = Vec::new();
    for (file, module, own, text) in layered_sources() {
        for (line, import) in imports(&text) {
            if import != module && layer(&import).is_some_and(|other| other >= own) {
                wrong.push(format!("{}:{line}: {import}", file.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "imports from the same layer or above:\n{}", wrong.join("\n"));
}

/// Only the border knows files and looks at a clock, and nothing prints.
#[test]
fn the_library_is_silent_and_only_its_border_knows_files_and_time() {
    let border = layer("files").expect("a layer");
    let mut wrong = Vec::new();
    for (file, _, own, text) in layered_sources() {
        let code = text.split("#[cfg(test)]").next().unwrap_or_default().lines();
        let code: String = code.filter(|line| !line.trim_start().starts_with("//")).collect();
        let mut forbidden = vec!["println!", "print!"];
        if own < border {
            forbidden.extend(["std::fs", "File::", "Instant::", "SystemTime::"]);
        }
        wrong.extend(
            forbidden
                .iter()
                .filter(|word| code.contains(**word))
                .map(|word| format!("{}: {word}", file.display())),
        );
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_reader_of_imports_sees_braces_and_lines() {
    let names = |text: &str| imports(text).into_iter().map(|import| import.1).collect::<Vec<_>>();
    assert_eq!(
        names("use crate::{\n    body,\n    frame::{ContactFrame, VectorField},\n    wear,\n};"),
        ["body", "frame", "wear"]
    );
    assert_eq!(
        imports("\nlet x = crate::wear::Rubbing { pressure, slip };"),
        [(2, "wear".to_owned())]
    );
}

/// What a build from the source leaves unoptimised, for the time it takes, is optimised in what is shipped; and all that ships
/// anything is built so.
#[test]
fn what_is_shipped_is_optimised() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |name: &str| fs::read_to_string(root.join(name)).unwrap();
    let manifest = read("Cargo.toml");
    let levels = |profile: &str, level: char| -> Vec<String> {
        let section = manifest
            .split("\n[")
            .find_map(|section| section.strip_prefix(&format!("profile.{profile}.package]\n")));
        let ending = format!(".opt-level = {level}");
        let lines = section.unwrap().lines().filter(|line| line.contains("opt-level"));
        lines.map(|line| line.strip_suffix(&ending).unwrap().to_owned()).collect()
    };
    assert!(!levels("release", '0').is_empty());
    assert_eq!(levels("release", '0'), levels("dist", '3'));
    for (file, command) in [
        (".github/workflows/release.yml", "cargo build --profile dist"),
        (".github/workflows/python.yml", "args: --profile dist"),
        ("packaging/conda/recipe.yaml", "MATURIN_PEP517_ARGS: --profile dist"),
        ("packaging/homebrew/archard.rb", r#""install", "--profile", "dist""#),
        ("Containerfile", "cargo install --profile dist"),
        ("justfile", "maturin build --profile dist"),
    ] {
        assert!(read(file).contains(command), "{file}");
    }
}
