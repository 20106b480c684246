//! How the house speaks: the comments, the names of types, and the length of the book.

use std::fs;
use std::path::Path;

use super::{CRATES, files};

/// Turns of speech that have to be read twice, which comments do without.
const TURNS: [&str; 6] = ["beside", "tells", "alike", "is none", "goes by", "of which"];

/// The comments of a file with one of these turns, outside of code.
fn turns(text: &str) -> Vec<String> {
    let comments = text.lines().map(str::trim).filter(|line| line.starts_with("//"));
    let prose = |line: &str| line.split('`').step_by(2).collect::<Vec<_>>().join(" ");
    let words = |line: &str| {
        let letters = |c: char| if c.is_alphanumeric() { c } else { ' ' };
        let words: String = line.chars().map(letters).collect();
        format!(" {} ", words.split_whitespace().collect::<Vec<_>>().join(" "))
    };
    let has = |line: &&str| {
        let words = words(&prose(line));
        TURNS.iter().any(|turn| words.contains(&format!(" {turn} ")))
    };
    comments.filter(has).map(str::to_owned).collect()
}

#[test]
fn comments_speak_plainly() {
    let mut all = vec![];
    for name in CRATES {
        all.push(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name));
    }
    all.push(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../python"));
    let mut found = vec![];
    for root in all {
        let mut sources = vec![];
        files(&root.join("src"), &mut sources);
        for path in sources {
            let text = fs::read_to_string(&path).expect("a source");
            found
                .extend(turns(&text).into_iter().map(|line| format!("{}: {line}", path.display())));
        }
    }
    assert!(found.is_empty(), "{} comments:\n{}", found.len(), found.join("\n"));
    assert_eq!(turns("// A pair beside it.\nlet beside = 1; // `beside`\n/// It tells.").len(), 2);
}

/// The name of a public type in a line, if it is a participle.
fn participle(line: &str) -> Option<&str> {
    let kinds = ["pub struct ", "pub enum ", "pub trait "];
    let name = kinds.iter().find_map(|kind| line.strip_prefix(kind))?;
    let name = name.split(|letter: char| !letter.is_alphanumeric()).next().unwrap_or_default();
    name.ends_with("ed").then_some(name)
}

#[test]
fn public_types_are_nouns() {
    let mut found = vec![];
    for name in CRATES {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name).join("src");
        let mut sources = vec![];
        files(&root, &mut sources);
        for path in sources {
            let text = fs::read_to_string(&path).expect("a source");
            let names = text.lines().filter_map(participle);
            found.extend(names.map(|name| format!("{}: {name}", path.display())));
        }
    }
    assert!(found.is_empty(), "name what they are:\n{}", found.join("\n"));
    assert_eq!(participle("pub struct Settled<'a> {"), Some("Settled"));
    assert_eq!(participle("pub struct Scar {"), None);
}

/// The most words of the book: what has a letter or a digit, signs of tables and formulas apart.
const BOOK: usize = 25_000;
/// The most bytes of ARCHITECTURE.md.
const ARCHITECTURE: usize = 10_000;

#[test]
fn the_book_stays_short() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |path: &Path| fs::read_to_string(path).expect("a text");
    let words = |text: &str| {
        text.split_whitespace().filter(|word| word.chars().any(char::is_alphanumeric)).count()
    };
    let pages = fs::read_dir(root.join("book/src")).expect("the book");
    let pages = pages.map(|page| page.expect("a page").path());
    let pages = pages.filter(|page| page.extension().is_some_and(|ending| ending == "md"));
    let book: usize = pages.map(|page| words(&read(&page))).sum();
    let architecture = read(&root.join("ARCHITECTURE.md")).len();
    println!("words of the book: {book}; bytes of ARCHITECTURE.md: {architecture}");
    assert!(book > 0 && book <= BOOK, "{book} words, and {BOOK} are the most: say it shorter");
    assert!(architecture <= ARCHITECTURE, "{architecture} bytes: PARTS.md has the parts");
    assert_eq!(words("| `a` | 3.5 | $x_1 + y$ |"), 4);
}
