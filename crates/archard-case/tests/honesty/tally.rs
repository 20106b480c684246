//! What was stated against what is true, and tables of it.

use std::collections::BTreeMap;
use std::fmt::Write;

/// What a value is good for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Use {
    Judged,
    /// It is the truth, as far as solvers tell.
    Exact,
    /// The truth is not known well enough.
    Unknown,
}

/// A value of a column, with the error stated and the truth.
#[derive(Debug, Clone)]
pub struct Value {
    /// The case it is of, by its number, and that case's motion.
    pub case: u64,
    pub motion: &'static str,
    pub column: String,
    pub progress: f64,
    pub found: f64,
    pub stated: f64,
    pub truth: f64,
    pub of_use: Use,
}

impl Value {
    /// Times its error that it is off; infinite where one of them is no number.
    pub fn beyond(&self) -> f64 {
        let times = (self.found - self.truth).abs() / self.stated;
        if times.is_nan() { f64::INFINITY } else { times }
    }
}

/// What some values come to.
#[derive(Debug, Clone, PartialEq)]
pub struct Tally {
    /// Those that are judged, and those that are exact or of unknown truth.
    pub values: usize,
    pub left_out: [usize; 2],
    /// Those off by more than is stated, and by more than three times of it.
    pub outside: usize,
    pub far: usize,
    /// Of the error stated over the true one.
    pub median: f64,
    pub ninth_decile: f64,
}

impl Tally {
    pub fn of(values: &[&Value]) -> Self {
        let of = |of_use: Use| values.iter().filter(move |value| value.of_use == of_use);
        let mut beyond: Vec<f64> = of(Use::Judged).map(|value| value.beyond()).collect();
        beyond.sort_by(f64::total_cmp);
        let above = |limit: f64| beyond.iter().filter(|times| **times > limit).count();
        let stated = |part: f64| {
            let last = beyond.len().saturating_sub(1) as f64;
            beyond.get(((1.0 - part) * last).round() as usize).map_or(f64::NAN, |times| 1.0 / times)
        };
        Self {
            values: beyond.len(),
            left_out: [Use::Exact, Use::Unknown].map(|left_out| of(left_out).count()),
            outside: above(1.0),
            far: above(3.0),
            median: stated(0.5),
            ninth_decile: stated(0.9),
        }
    }

    /// The share that is off by more than is stated, and that by more than three times of it.
    pub fn shares(&self) -> [f64; 2] {
        [self.outside, self.far].map(|count| count as f64 / self.values.max(1) as f64)
    }

    fn row(&self, name: &str) -> String {
        let inside = 100.0 * (1.0 - self.shares()[0]);
        let Self { values, left_out: [exact, unknown], outside, far, median, ninth_decile } = self;
        format!(
            "{name:30} {exact:7} {unknown:7} {values:7} {outside:7} {inside:8.1} {far:8} {median:7.1} {ninth_decile:8.1}\n"
        )
    }
}

/// A row for each name that values have, and one for all.
pub fn table(values: &[Value], title: &str, name: impl Fn(&Value) -> String) -> String {
    let mut groups = BTreeMap::<String, Vec<&Value>>::new();
    for value in values {
        groups.entry(name(value)).or_default().push(value);
    }
    let mut text = format!("{title:30} {:>7} {:>7} {:>7} ", "exact", "unknown", "judged");
    text += "outside inside % beyond 3  median decile 9\n";
    for (name, values) in groups {
        text += &Tally::of(&values).row(&name);
    }
    text + &Tally::of(&values.iter().collect::<Vec<_>>()).row("all")
}

/// The values that are off by most, each one the worst of its column in its case.
pub fn worst(values: &[Value], count: usize) -> Vec<Value> {
    let judged = values.iter().filter(|value| value.of_use == Use::Judged);
    let mut sorted: Vec<Value> = judged.cloned().collect();
    sorted.sort_by(|one, other| other.beyond().total_cmp(&one.beyond()));
    let mut worst: Vec<Value> = vec![];
    for value in sorted {
        let same = |known: &Value| known.case == value.case && known.column == value.column;
        if !worst.iter().any(same) {
            worst.push(value);
        }
    }
    worst.truncate(count);
    worst
}

/// Some values in words, and the text of each of their cases once.
pub fn listed(values: &[Value], text: impl Fn(u64) -> String) -> String {
    let mut list = String::new();
    for Value { case, motion, column, progress, found, stated, truth, .. } in values {
        let off = (found - truth) / truth.abs();
        let _ = writeln!(
            list,
            "case {case} ({motion}) at {progress:.4e}: {column} {found:.6e}, off by {off:+.2e} of {:.2e}",
            stated / truth.abs()
        );
    }
    let mut cases: Vec<u64> = values.iter().map(|value| value.case).collect();
    cases.sort_unstable();
    cases.dedup();
    for case in cases {
        let _ = writeln!(list, "\ncase {case}\n{}", text(case));
    }
    list
}
