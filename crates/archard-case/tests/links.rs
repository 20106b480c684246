//! Links of the book, the README and the pages of cases lead somewhere: to files that are there, and to headings in them. Code that
//! a page shows as that of a file stands in it.

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
    // And to what has a name of its own.
    let named = text.split("<a id=\"").skip(1).filter_map(|rest| rest.split('"').next());
    headings.map(anchor).chain(named.map(str::to_owned)).collect()
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
        ["README", "ARCHITECTURE", "PARTS", "CONTRIBUTING", "ROADMAP", "SECURITY", "paper/paper"]
            .map(|page| root.join(page).with_extension("md"))
            .to_vec();
    for folder in ["book/src", "cases", "examples"] {
        pages(&root.join(folder), &mut found);
    }
    assert!(found.len() > 40, "{found:?}");
    let broken: Vec<String> = found.iter().flat_map(|page| broken(page)).collect();
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

/// Blocks of a page that name the file they are from, ```` ```rust,ignore,file=crates/a.rs ````, and do not stand in it as
/// they are; and how many do.
fn strange_code(root: &Path, text: &str) -> (Vec<String>, usize) {
    let blocks = text.split("\n```").skip(1).step_by(2);
    let named = blocks.filter_map(|block| {
        let (head, code) = block.split_once('\n')?;
        Some((head.split_once("file=")?.1, code))
    });
    let (own, strange): (Vec<_>, Vec<_>) = named.partition(|(file, code)| {
        fs::read_to_string(root.join(file)).is_ok_and(|source| source.contains(code.trim_end()))
    });
    let told = strange.iter().map(|(file, code)| format!("{file}:\n{code}"));
    (told.collect(), own.len())
}

#[test]
fn code_of_the_book_stands_in_the_files_it_names() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut found = vec![];
    pages(&root.join("book/src"), &mut found);
    found.push(root.join("ARCHITECTURE.md"));
    let checked = found.iter().map(|page| strange_code(&root, &fs::read_to_string(page).unwrap()));
    let (strange, own): (Vec<_>, Vec<_>) = checked.unzip();
    let strange = strange.concat();
    assert!(strange.is_empty(), "\n{}", strange.join("\n"));
    // The walk to a wear law has five, the architecture one.
    assert!(own.iter().sum::<usize>() >= 6, "{own:?}");
}

#[test]
fn strange_code_is_noticed() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.rs"), "fn a() {\n    b()\n}\n").unwrap();
    let block = |file: &str, code: &str| format!("A\n```rust,ignore,file={file}\n{code}\n```\n");
    let count = |text: &str| {
        let (strange, own) = strange_code(folder.path(), text);
        (strange.len(), own)
    };
    assert_eq!(count(&block("a.rs", "    b()\n}")), (0, 1));
    assert_eq!(count(&(block("a.rs", "    c()") + &block("b.rs", "b()"))), (2, 0));
    assert_eq!(count("A\n```rust\nelse\n```\n"), (0, 0));
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
