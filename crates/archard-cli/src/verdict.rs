//! Whether a result can be believed: in a line where it can, and by every check that says otherwise.

use archard_case::verdict::{Verdict, Word};

use crate::failure::Failure;
use crate::say::{self, say, tell};

/// The word of a verdict and how many checks it stands on, coloured where the terminal and the user take colours.
pub fn headline(verdict: &Verdict) -> String {
    painted(&verdict.in_words(), verdict.word(), say::out_in_colour())
}

/// Says the checks that are not good, or all of them.
pub fn say_lines(verdict: &Verdict, all: bool) -> Result<(), Failure> {
    let lines = verdict.lines.iter().filter(|line| all || line.word() != Word::Good);
    let colour = say::out_in_colour();
    lines
        .map(|line| painted(&format!("  {}", line.in_words()), line.word(), colour))
        .try_for_each(|line| say(&line))
}

/// A text in green, amber or red.
fn painted(text: &str, word: Word, colour: bool) -> String {
    let code = match word {
        Word::Good => 32,
        Word::Doubtful => 33,
        Word::Wrong => 31,
    };
    if colour { format!("\u{1b}[{code}m{text}\u{1b}[0m") } else { text.to_owned() }
}

/// Says what is doubtful where nothing else was said.
pub fn doubts(verdict: &Verdict, quiet: bool) {
    let doubtful = verdict.lines.iter().filter(|line| quiet && line.word() == Word::Doubtful);
    doubtful.for_each(|line| tell(&format!("doubtful: {line}")));
}

/// Fails where the verdict is that the result is wrong. What is doubtful is told where nothing else was.
pub fn judge(verdict: &Verdict, dir: &std::path::Path, quiet: bool) -> Result<(), Failure> {
    doubts(verdict, quiet);
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

#[cfg(test)]
mod tests {
    use archard_case::verdict::Word;

    use super::painted;

    #[test]
    fn words_have_the_colours_of_traffic_lights() {
        let shown = [Word::Good, Word::Doubtful, Word::Wrong].map(|word| painted("a", word, true));
        assert_eq!(shown, ["\u{1b}[32ma\u{1b}[0m", "\u{1b}[33ma\u{1b}[0m", "\u{1b}[31ma\u{1b}[0m"]);
        assert_eq!(painted("a", Word::Wrong, false), "a");
    }
}
