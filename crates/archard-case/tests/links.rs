//! Links of the book, the README and the pages of cases lead somewhere: to files that are there, and to headings in them.

use std::fs;
use std::path::{Path, PathBuf};

/// The Markdown files under a folder.
fn pages(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            pages(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            found.push(path);
        }
    }
}

/// A text without its blocks of code.
fn prose(text: &str) -> String {
    text.split("```").step_by(2).collect::<Vec<_>>().join("\n")
}

/// The targets of links and pictures: what stands in parentheses behind brackets.
fn targets(text: &str) -> Vec<String> {
    let text = prose(text);
    let behind = text.split("](").skip(1);
    behind.filter_map(|rest| Some(rest.split_once(')')?.0.to_owned())).collect()
}

/// How a heading is linked to: in small letters, words joined by hyphens, without signs.
fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase();
    let kept = kept.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.collect::<String>().trim().replace(' ', "-")
}

fn anchors(text: &str) -> Vec<String> {
    let headings = prose(text);
    let headings =
        headings.lines().filter_map(|line| Some(line.strip_prefix('#')?.trim_start_matches('#')));
    headings.map(anchor).collect()
}

/// What a page links to that is not there.
fn broken(page: &Path) -> Vec<String> {
    let text = fs::read_to_string(page).unwrap();
    let gone = |target: &String| {
        if target.contains("://") || target.starts_with("mailto:") {
            return false;
        }
        let (file, heading) =
            target.split_once('#').map_or((&**target, None), |(f, h)| (f, Some(h)));
        let path = if file.is_empty() { page.to_owned() } else { page.with_file_name(file) };
        let markdown = path.extension().is_some_and(|extension| extension == "md");
        match heading.filter(|_| markdown) {
            Some(heading) => !fs::read_to_string(path)
                .is_ok_and(|text| anchors(&text).iter().any(|known| known == heading)),
            None => !path.exists(),
        }
    };
    let targets = targets(&text).into_iter().filter(gone);
    targets.map(|target| format!("{}: {target}", page.display())).collect()
}

#[test]
fn links_lead_somewhere() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut found =
        vec![root.join("README.md"), root.join("ARCHITECTURE.md"), root.join("CONTRIBUTING.md")];
    for folder in ["book/src", "cases", "examples"] {
        pages(&root.join(folder), &mut found);
    }
    assert!(found.len() > 40, "{found:?}");
    let broken: Vec<String> = found.iter().flat_map(|page| broken(page)).collect();
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

#[test]
fn every_page_stands_in_the_summary() {
    let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src");
    let summary = fs::read_to_string(book.join("SUMMARY.md")).unwrap();
    let listed = targets(&summary);
    for entry in fs::read_dir(&book).unwrap() {
        let name = entry.unwrap().file_name().to_string_lossy().into_owned();
        if name.ends_with(".md") && name != "SUMMARY.md" {
            assert!(listed.contains(&name), "{name}");
        }
    }
}

#[test]
fn broken_links_are_noticed() {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("page.md");
    fs::write(
        &page,
        "# A `b` c\n[one](#a-b-c) [two](#none) [three](gone.md)\n```\n[four](code)\n```\n",
    )
    .unwrap();
    let found = broken(&page);
    assert_eq!(found.len(), 2, "{found:?}");
}
