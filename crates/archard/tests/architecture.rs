//! Layers: a module imports only what stands below it (see ARCHITECTURE.md).

use std::fs;
use std::path::{Path, PathBuf};

/// The modules of the library from the ground up; those of one layer do not see each other.
const LAYERS: &[&[&str]] = &[
    &["numerics", "parameters", "units"],
    &["wear"],
    &["body"],
    &["frame", "closed_form"],
    &["compliance", "kinematics"],
    &["problem"],
    &["solve"],
    &["simulation"],
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

/// The modules of the crate a line names: after `crate::`, braces included.
fn imports(line: &str) -> Vec<String> {
    let word = |text: &str| {
        text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>()
    };
    let mut modules = Vec::new();
    for (at, found) in line.match_indices("crate::") {
        let rest = &line[at + found.len()..];
        match rest.strip_prefix('{') {
            Some(list) => modules.extend(list.split(',').map(|part| word(part.trim()))),
            None => modules.push(word(rest)),
        }
    }
    modules
}

#[test]
fn modules_import_only_what_stands_below_them() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    let mut wrong = Vec::new();
    for file in files {
        let inside = file.strip_prefix(&root).expect("a file below the root");
        let module = inside
            .iter()
            .next()
            .and_then(|first| Path::new(first).file_stem())
            .and_then(|stem| stem.to_str());
        let Some(module) = module.filter(|module| *module != "lib") else { continue };
        let own =
            layer(module).unwrap_or_else(|| panic!("`{module}` has no layer: add it to LAYERS"));
        for (number, line) in fs::read_to_string(&file).expect("a text").lines().enumerate() {
            for import in imports(line).iter().filter(|import| *import != module) {
                if layer(import).is_some_and(|other| other >= own) {
                    wrong.push(format!("{}:{}: {}", inside.display(), number + 1, line.trim()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "imports from the same layer or above:\n{}", wrong.join("\n"));
}

#[test]
fn the_reader_of_imports_sees_braces() {
    assert_eq!(imports("use crate::{body, frame::ContactFrame};"), ["body", "frame"]);
    assert_eq!(imports("let x = crate::wear::Rubbing { pressure, slip };"), ["wear"]);
}
