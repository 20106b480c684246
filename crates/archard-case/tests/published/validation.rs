//! The page of the book that holds the cases' numbers against their sources: written from what the cases give, and held against it.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{Expected, read};

/// What a page begins with.
const HEAD: &str = "\
# Validation

Every case of the repository against closed forms, independent solutions and published values: how many numbers hold it, and the one that uses most of its
bound. *Off* is relative to the source; the *bound* is what elements and steps of the case allow, some coarse because their source is. A star: with options
of the case changed. `expected.toml` of a case has all numbers, options, values and sources. `just test` runs all; `just pages` writes this page. [Accuracy](accuracy.md) has finer grids.

| case | numbers | uses most of its bound | source | off | bound |
|---|---|---|---|---|---|
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
        let Expected { column, at, point, options, source, .. } = &self.expected;
        let place = at.as_ref().or(point.as_ref());
        let place = place.map_or(String::new(), |place| format!(" at {place}"));
        let with = match options.is_empty() {
            true => "",
            false => " *",
        };
        format!("`{column}`{place}{with} | {source}")
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

/// How much of its bound a line uses, differences that are not shown being none.
fn used(line: &Line) -> f64 {
    let off = line.off().abs();
    if off < SMALL { 0.0 } else { off / line.expected.within }
}

/// Of the lines of a case the first that uses most of its bound.
fn worst(lines: &[Line]) -> &Line {
    let larger = |worst, line| if used(line) > used(worst) { line } else { worst };
    lines.iter().fold(&lines[0], larger)
}

/// What a line of the page begins with.
fn head(case: &str, count: usize) -> String {
    format!("| <a id=\"{case}\"></a>[{case}](../../cases/{case}/README.md) | {count} ")
}

/// The page that these lines make; a line for each case.
fn written(lines: &[Line]) -> String {
    let mut text = HEAD.to_owned();
    for group in lines.chunk_by(|one, next| one.case == next.case) {
        let _ = writeln!(text, "{}{}", head(&group[0].case, group.len()), worst(group).text());
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
    let groups: Vec<&[Line]> = lines.chunk_by(|one, next| one.case == next.case).collect();
    let known = |group: &&&[Line]| {
        let start = head(&group[0].case, group.len());
        let Some(rest) = text.lines().find_map(|known| known.strip_prefix(&start)) else {
            return false;
        };
        // Of two that use nearly as much either may stand there.
        let most = used(worst(group));
        group.iter().filter(|line| used(line) >= (1.0 - SAME) * most).any(|line| {
            let shown = rest.strip_prefix(&format!("| {} | ", line.key()));
            let shown = shown.and_then(|shown| shown.split(" |").next());
            let shown = shown.and_then(|shown| match shown {
                NOTHING => Some(0.0),
                percent => Some(0.01 * percent.strip_suffix(" %")?.parse::<f64>().ok()?),
            });
            // As many digits as are shown.
            let allowed = 0.6 * SMALL + SAME * line.off().abs();
            shown.is_some_and(|shown| (shown - line.off()).abs() <= allowed)
        })
    };
    let stale = groups.iter().filter(|group| !known(group));
    let mut stale: Vec<String> = stale
        .map(|group| {
            let (case, line) = (&group[0].case, worst(group).text());
            format!("book/src/validation.md is not current; `just pages`: {case} {line}")
        })
        .collect();
    let rows = text.lines().filter(|line| line.starts_with("| <a")).count();
    if rows != groups.len() {
        stale.push(format!("book/src/validation.md has {rows} lines, of {} cases", groups.len()));
    }
    stale
}
