//! Whether a result can be believed, in a few lines.

use archard::verdict::{Bound, Line, Verdict, Word};

use crate::failure::Failure;
use crate::number::four;
use crate::say::say;

/// Says the verdict of a run.
pub fn say_all(verdict: &Verdict) -> Result<(), Failure> {
    say(&format!("verdict           {}", verdict.word().text()))?;
    verdict.lines.iter().try_for_each(|line| say(&in_words(line)))
}

/// A line with its number, its bound and its word; what to do about it where it is not good.
pub fn in_words(line: &Line) -> String {
    let Line { subject, value, .. } = line;
    let (side, [doubtful, wrong]) = match line.bound {
        Bound::AtMost(bounds) => ("at most", bounds),
        Bound::AtLeast(bounds) => ("at least", bounds),
    };
    let word = line.word();
    let bound = if word == Word::Wrong { wrong } else { doubtful };
    let text = if word == Word::Good { String::new() } else { format!(": {}", line.text) };
    format!("  {subject:<16}{} ({side} {}) {}{text}", four(*value), four(bound), word.text())
}

/// Fails where the verdict is that the result is wrong.
pub fn judge(verdict: &Verdict, dir: &std::path::Path) -> Result<(), Failure> {
    let wrong = verdict.lines.iter().filter(|line| line.word() == Word::Wrong);
    let wrong: Vec<String> = wrong.map(ToString::to_string).collect();
    if wrong.is_empty() {
        return Ok(());
    }
    Err(Failure::NotConverged(format!(
        "the result is wrong: {}\nwhat was computed is in {}, marked as wrong",
        wrong.join("; "),
        dir.display()
    )))
}
