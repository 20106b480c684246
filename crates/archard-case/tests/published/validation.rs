//! The page of the book that holds the cases' numbers against their sources: written from what the cases give, and held against it.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{Expected, read};

/// What a page begins with.
const HEAD: &str = "\
# Validation

Every case of the repository beside what its source says: closed forms, independent solutions, published values. `cargo test`
runs all of them and holds them against these bounds and against this page, which `just pages` writes. *Off* is the relative
difference of ours from the source, and *bound* what is allowed for the elements and steps of the case; some are
coarse, because their source is. What finer ones give stands under [accuracy](accuracy.md).
";

/// How much of a difference may change before the page is out of date.
const SAME: f64 = 0.05;
/// The smallest difference that is shown, and what stands for smaller ones.
const SMALL: f64 = 1e-4;
const NOTHING: &str = "< 0.01 %";

/// A number that a case gave.
pub struct Line {
    pub case: String,
    pub expected: Expected,
    pub found: f64,
}

impl Line {
    fn off(&self) -> f64 {
        self.found / read(&self.expected.value, &self.expected.column) - 1.0
    }

    /// What separates the line from others.
    fn key(&self) -> String {
        let Expected { column, at, point, options, value, source, .. } = &self.expected;
        let place = at.as_ref().or(point.as_ref());
        let place = place.map_or(String::new(), |place| format!(" at {place}"));
        let with = match options.is_empty() {
            true => String::new(),
            false => format!(" (`{}`)", options.join("`, `")),
        };
        format!("`{column}`{place}{with} | {source} | {value}")
    }

    fn text(&self) -> String {
        let off = match self.off() {
            off if off.abs() < 0.5 * SMALL => NOTHING.to_owned(),
            off => format!("{:+.2} %", 100.0 * off),
        };
        let bound = 100.0 * self.expected.within;
        // What binary fractions leave in the last digits is no part of it.
        let rounded = (1e8 * bound).round() / 1e8;
        let bound = if bound < 0.01 { format!("{bound:.0e}") } else { format!("{rounded}") };
        format!("| {} | {off} | {bound} % |", self.key())
    }
}

fn page() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/validation.md")
}

/// The page that these lines make; a table for each case.
fn written(lines: &[Line]) -> String {
    let mut text = HEAD.to_owned();
    for group in lines.chunk_by(|one, next| one.case == next.case) {
        let case = &group[0].case;
        let about = "../../cases";
        let _ = write!(text, "\n## {case}\n\n[What it is about]({about}/{case}/README.md).\n\n");
        text += "| quantity | source | its value | off | bound |\n|---|---|---|---|---|\n";
        group.iter().for_each(|line| text += &format!("{}\n", line.text()));
    }
    text
}

/// Writes the page where `ARCHARD_PAGES` is set; otherwise says what on it is not so.
pub fn held(mut lines: Vec<Line>) -> Vec<String> {
    lines.sort_by(|one, other| one.case.cmp(&other.case));
    if std::env::var_os("ARCHARD_PAGES").is_some() {
        fs::write(page(), written(&lines)).expect("a page that can be written");
        return vec![];
    }
    let text = fs::read_to_string(page()).expect("the page of validation");
    let known = |line: &&Line| {
        let start = format!("| {} | ", line.key());
        let rest = text.lines().find_map(|known| known.strip_prefix(&start));
        let shown = rest.and_then(|rest| rest.split(" |").next());
        let shown = shown.and_then(|shown| match shown {
            NOTHING => Some(0.0),
            percent => Some(0.01 * percent.strip_suffix(" %")?.parse::<f64>().ok()?),
        });
        // As many digits as are shown.
        let allowed = 0.6 * SMALL + SAME * line.off().abs();
        shown.is_some_and(|shown| (shown - line.off()).abs() <= allowed)
    };
    let stale = lines.iter().filter(|line| !known(line));
    let mut stale: Vec<String> = stale
        .map(|line| format!("book/src/validation.md is not current; `just pages`: {}", line.text()))
        .collect();
    let rows = text.lines().filter(|line| line.starts_with("| `")).count();
    if rows != lines.len() {
        stale.push(format!("book/src/validation.md has {rows} rows, the cases {}", lines.len()));
    }
    stale
}
