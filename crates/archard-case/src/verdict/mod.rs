//! Whether a result can be believed: a few lines, each with a number, its bound and a word.
//!
//! Every line compares what came out with what was *prescribed*, or with an independent estimate. The
//! bounds stand here and nowhere else. A wrong line fails a run, a doubtful one is a warning. What a line
//! is judged by is a plain number, so that a forecast, a run and a reader of results share the judgement.

mod bounds;
mod line;
mod warning;
mod words;

pub use bounds::{
    Accuracy, BY_HALF, EDGES, ELASTOMERS, HALF_SPACE, RAIL_STEEL, accuracy, angle, apart, balance,
    clearance, climbs, complete, conformity, constant, contact, creepage, edges, energy,
    first_contact, flanks, form, friction, gathered, hardness, heat, image, lateral, layers,
    length, load, map, measured, mesh, missing, modulus, nadal, next_test, of_run, radius,
    reshaped, rim, roughness, settled, shakedown, shaken, shape, shared, shear_yield, side,
    slenderness, slope, stated, stations, stick_zone, strips, temperature, time, tip, touch,
    volume, warned, worn, yields,
};
pub use line::{Bound, Line, Word, four};
pub use warning::Warning;
pub(crate) use words::{place_of, subject_at};

/// The lines of a run, in the order in which they are read.
#[non_exhaustive]
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Verdict {
    /// What was judged.
    pub lines: Vec<Line>,
}

impl Verdict {
    /// The worst word of all lines; good where there are none.
    pub fn word(&self) -> Word {
        self.lines.iter().map(Line::word).max().unwrap_or(Word::Good)
    }

    /// The verdict on what ended, or failed for a reason: what failed is not what was asked for.
    #[must_use]
    pub fn ended(mut self, failure: Option<&str>) -> Self {
        self.lines.extend(failure.map(complete));
        self
    }

    /// The same with all that the user was warned of: each is doubtful. What a line judges that is not good anyhow counts
    /// once.
    #[must_use]
    pub fn warned_of(mut self, warnings: &[Warning]) -> Self {
        let told: Vec<Line> = self.besides(warnings).map(|one| warned(&one.text)).collect();
        self.lines.extend(told);
        self
    }

    /// The warnings of what no line says that is not good.
    pub fn besides<'a>(&self, warnings: &'a [Warning]) -> impl Iterator<Item = &'a Warning> {
        let said: Vec<&str> = self.complaints().map(|line| line.subject).collect();
        warnings.iter().filter(move |one| one.judged.is_none_or(|subject| !said.contains(&subject)))
    }

    /// The word and how many checks it stands on: "good (7 checks)", "doubtful (1 of 7 checks)".
    pub fn in_words(&self) -> String {
        let (word, all) = (self.word(), self.lines.len());
        match word {
            Word::Good if all == 1 => "good (1 check)".to_owned(),
            Word::Good => format!("good ({all} checks)"),
            word => format!("{} ({} of {all} checks)", word.text(), self.complaints().count()),
        }
    }

    /// The lines that are not good.
    pub fn complaints(&self) -> impl Iterator<Item = &Line> {
        self.lines.iter().filter(|line| line.word() != Word::Good)
    }
}

impl FromIterator<Line> for Verdict {
    fn from_iter<I: IntoIterator<Item = Line>>(lines: I) -> Self {
        Self { lines: lines.into_iter().collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::{Bound, Line, Verdict, Warning, Word};

    fn line(value: f64) -> Line {
        Line::new("load", value, Bound::AtMost([0.1, 0.2]), "carried")
    }

    #[test]
    fn the_worst_line_counts_and_what_is_not_finite_is_wrong() {
        let verdict =
            |values: &[f64]| Verdict { lines: values.iter().copied().map(line).collect() };
        assert_eq!(verdict(&[]).word(), Word::Good);
        assert_eq!(verdict(&[0.1, 0.15]).word(), Word::Doubtful);
        assert_eq!(verdict(&[0.15, 0.25, 0.0]).word(), Word::Wrong);
        assert_eq!(verdict(&[f64::NAN]).word(), Word::Wrong);
        let said = [&[][..], &[0.1], &[0.1, 0.0], &[0.15, 0.05, 0.25]];
        let said = said.map(|values| verdict(values).in_words());
        let expected =
            ["good (0 checks)", "good (1 check)", "good (2 checks)", "wrong (2 of 3 checks)"];
        assert_eq!(said, expected);
        let complaints = verdict(&[0.15, 0.05, 0.25]);
        let complaints: Vec<f64> = complaints.complaints().map(|line| line.value).collect();
        assert_eq!(complaints, [0.15, 0.25]);
        let failed = verdict(&[0.0]).ended(Some("no luck\nat all"));
        assert_eq!((failed.word(), verdict(&[]).ended(None).word()), (Word::Wrong, Word::Good));
        assert_eq!(failed.complaints().count(), 1);
        let warned = verdict(&[0.0]).warned_of(&["upside down".to_owned().into()]);
        assert_eq!(warned.word(), Word::Doubtful);
        assert_eq!(warned.in_words(), "doubtful (1 of 2 checks)");
        assert_eq!(warned.lines[1].to_string(), "warning: upside down");
        let foreseen = Warning { judged: Some("load"), ..Warning::from("light".to_owned()) };
        let count = |value| verdict(&[value]).warned_of(std::slice::from_ref(&foreseen)).in_words();
        assert_eq!(
            [count(0.15), count(0.0)],
            ["doubtful (1 of 1 checks)", "doubtful (1 of 2 checks)"]
        );
        let least = |value| Line::new("elements", value, Bound::AtLeast([8.0, 2.0]), "across");
        assert_eq!(
            [9.0, 5.0, 1.0].map(|value| least(value).word()),
            [Word::Good, Word::Doubtful, Word::Wrong]
        );
        assert_eq!(least(f64::NAN).word(), Word::Wrong);
    }
}
