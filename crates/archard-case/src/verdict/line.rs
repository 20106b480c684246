//! One line of a verdict.

/// How far something can be believed; the worst is the largest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Word {
    /// Within its bound.
    Good,
    /// Beyond the bound of what is good: a warning.
    Doubtful,
    /// Beyond all bounds: the result is not to be used.
    Wrong,
}

impl Word {
    /// The word itself.
    pub fn text(self) -> &'static str {
        match self {
            Word::Good => "good",
            Word::Doubtful => "doubtful",
            Word::Wrong => "wrong",
        }
    }
}

/// Where good ends and where wrong begins, in this order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// Larger numbers are worse.
    AtMost([f64; 2]),
    /// Smaller numbers are worse.
    AtLeast([f64; 2]),
}

/// One line of a verdict.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// What is judged, in a word or two: "load", "edges".
    pub subject: &'static str,
    /// The number; relative, unless `text` says otherwise.
    pub value: f64,
    /// What it is judged by.
    pub bound: Bound,
    /// What the number means and, where it is not good, what to do.
    pub text: String,
}

impl Line {
    /// A line.
    pub fn new(subject: &'static str, value: f64, bound: Bound, text: impl Into<String>) -> Self {
        Self { subject, value, bound, text: text.into() }
    }

    /// The judgement. What is not a number is wrong.
    pub fn word(&self) -> Word {
        let within = |bounds: [bool; 2]| match bounds {
            [true, _] => Word::Good,
            [false, true] => Word::Doubtful,
            [false, false] => Word::Wrong,
        };
        match self.bound {
            Bound::AtMost(bounds) => within(bounds.map(|bound| self.value <= bound)),
            Bound::AtLeast(bounds) => within(bounds.map(|bound| self.value >= bound)),
        }
    }
}

/// A number with four significant digits.
pub fn four(value: f64) -> String {
    if value == 0.0 {
        // Not "-0", which sums of nothing are.
        return "0".to_owned();
    }
    if !value.is_finite() {
        return value.to_string();
    }
    let digits = 3 - value.abs().log10().floor() as i32;
    if (-3..=6).contains(&digits) {
        format!("{value:.*}", digits.max(0) as usize)
    } else {
        format!("{value:.3e}")
    }
}
