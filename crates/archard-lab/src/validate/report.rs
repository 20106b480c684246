//! Validated sets in words, as JSON and as a page.

use std::fmt::{self, Write};

use serde_json::{Value, json};

use super::{Comparison, Validation};
use archard_case::verdict::four;

impl Validation {
    /// How many of the values lie where they were predicted, and how many there are.
    pub fn held(&self) -> [usize; 2] {
        let all = self.outcome.as_deref().unwrap_or_default();
        [all.iter().filter(|own| own.holds()).count(), all.len()]
    }

    /// As JSON, in SI.
    pub fn json(&self) -> Value {
        let value = |own: &Comparison| {
            json!({
                "test": own.test, "quantity": own.quantity, "measured": own.measured, "predicted": own.predicted,
                "relative_half_95": { "data": (own.halves[0] > 0.0).then_some(own.halves[0]), "input": own.halves[1], "numbers": own.halves[2] },
                "interval_95": own.interval(), "error": own.error(), "inside": own.holds(), "at_own_section": own.at_own_section,
            })
        };
        let all = self.outcome.as_deref().unwrap_or_default();
        json!({
            "title": self.set.title,
            "source": self.set.source,
            "licence": self.set.licence,
            "read": self.set.read,
            "coefficients": self.coefficients,
            "doubts": self.doubts,
            "rejected": self.outcome.as_ref().err(),
            "values": all.iter().map(value).collect::<Vec<_>>(),
            "inside": self.held(),
        })
    }
}

/// In words.
impl fmt::Display for Validation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.set.title)?;
        let all = match &self.outcome {
            Err(why) => return writeln!(f, "  rejected        {why}"),
            Ok(all) => all,
        };
        for [test, words] in &self.coefficients {
            writeln!(f, "  k for {test:<9} {words}")?;
        }
        for own in all {
            let Shown { measured, predicted, interval, error } = Shown::of(own);
            writeln!(
                f,
                "  {:<15} {}: measured {measured}, predicted {predicted} ({interval}): {error}, {}",
                own.test,
                own.quantity,
                if own.holds() { "inside" } else { "outside" }
            )?;
        }
        for doubt in &self.doubts {
            writeln!(f, "  {doubt}")?;
        }
        let [held, count] = self.held();
        writeln!(f, "  inside          {held} of {count}")
    }
}

/// Sets as a page: what was measured, what was predicted, and whether it lies inside.
pub fn in_markdown(all: &[Validation]) -> String {
    let mut text = String::new();
    // Into a string nothing can fail.
    let _ = page(&mut text, all);
    text
}

fn page(text: &mut String, all: &[Validation]) -> fmt::Result {
    let held = all
        .iter()
        .map(Validation::held)
        .fold([0, 0], |sum, own| [sum[0] + own[0], sum[1] + own[1]]);
    writeln!(
        text,
        "{} of {} measured values lie inside their 95 % intervals.\n",
        held[0], held[1]
    )?;
    for own in all {
        let set = &own.set;
        writeln!(text, "## {}\n", set.title)?;
        writeln!(
            text,
            "{} {} Licence: {}.\n",
            sentence(&set.source),
            sentence(&set.read),
            set.licence
        )?;
        let values = match &own.outcome {
            Err(why) => {
                writeln!(text, "Rejected: {why}.\n")?;
                continue;
            }
            Ok(values) => values,
        };
        match &set.coefficient {
            Some(given) => writeln!(
                text,
                "The coefficients are those of others, to {} % (standard uncertainty): {}\n",
                four(100.0 * given.uncertainty),
                sentence(&given.source)
            )?,
            None => writeln!(text, "The coefficient of each test is that of the others.\n")?,
        }
        text.push_str(
            "| test | measured | predicted | 95 % interval | error | at its own section |\n|---|---|---|---|---|---|\n",
        );
        for own in values {
            let Shown { measured, predicted, interval, error } = Shown::of(own);
            let at_own = |value: f64| percent(value / own.measured - 1.0);
            writeln!(
                text,
                "| {}, {} | {measured} | {predicted} | {interval}{} | {error} | {} |",
                own.test,
                own.quantity,
                if own.holds() { "" } else { " **outside**" },
                own.at_own_section.map(at_own).unwrap_or_default()
            )?;
        }
        for doubt in &own.doubts {
            writeln!(text, "\nOf the runs: {}", sentence(doubt))?;
        }
        writeln!(text)?;
    }
    Ok(())
}

/// A value and its prediction, in words.
struct Shown {
    measured: String,
    predicted: String,
    interval: String,
    error: String,
}

impl Shown {
    fn of(own: &Comparison) -> Self {
        let (factor, unit) = own.unit;
        let number = |value: f64| four(value * factor);
        let [low, high] = own.interval().map(number);
        Self {
            measured: match own.halves[0] > 0.0 {
                true => format!("{} {unit} ± {:.1} %", number(own.measured), 100.0 * own.halves[0]),
                false => format!("{} {unit}", number(own.measured)),
            },
            predicted: format!("{} {unit}", number(own.predicted)),
            interval: format!("{low} .. {high}"),
            error: percent(own.error()),
        }
    }
}

fn percent(share: f64) -> String {
    format!("{:+.1} %", 100.0 * share)
}

/// A text with its full stop.
fn sentence(text: &str) -> String {
    format!("{}.", text.trim_end_matches('.'))
}
