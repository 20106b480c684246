//! Whether a result can be believed, in a few lines.

use archard::verdict::{Line, Verdict, Word};

use crate::failure::Failure;
use crate::say::say;

/// Says the verdict of a run.
pub fn say_all(verdict: &Verdict) -> Result<(), Failure> {
    say(&format!("verdict           {}", verdict.word().text()))?;
    verdict.lines.iter().try_for_each(|line: &Line| say(&format!("  {}", line.in_words())))
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
