//! Asks for what differs from one test to the next, and puts the answers into the case of the rig.
//!
//! Every answer is checked as part of the case at once, units too, and asked for again where it is wrong.

use std::io::{self, BufRead, Write};

use archard_case::{CaseFile, Problem, Severity};

/// Where answers come from and words go to.
pub(super) struct Talk<R, W> {
    pub reader: R,
    pub writer: W,
}

impl<R: BufRead, W: Write> Talk<R, W> {
    /// Asks one question; `None` where there are no more answers.
    pub(super) fn answer(&mut self, question: &str) -> io::Result<Option<String>> {
        write!(self.writer, "{question}: ")?;
        self.writer.flush()?;
        let mut answer = String::new();
        let read = self.reader.read_line(&mut answer)?;
        Ok((read > 0).then(|| answer.trim().to_owned()))
    }

    /// Asks for the values at these keys of a case, each with its words, and returns the case with the answers; `None` where they
    /// end before the questions do.
    pub(super) fn fill(
        &mut self,
        mut case: CaseFile,
        asks: &[(&str, &str)],
    ) -> io::Result<Option<CaseFile>> {
        writeln!(
            self.writer,
            "Enter keeps what stands in brackets; values have units, materials names"
        )?;
        writeln!(self.writer, "(`archard materials`) or {{ young = 210 GPa, poisson = 0.3 }}.\n")?;
        let mut known = problems(&case);
        for (key, words) in asks {
            // A key that an answer before has taken away is not asked for.
            while let Some(written) = case.written_at(key) {
                let Some(answer) = self.answer(&format!("{words} [{}]", bare(written)))? else {
                    return Ok(None);
                };
                let changed = Some(&answer).filter(|answer| !answer.is_empty());
                let Some(changed) = changed.and_then(|answer| case.rewritten(key, answer)) else {
                    break;
                };
                let found = problems(&changed);
                let wrong = found.iter().find(|one| one.severity == Severity::Error);
                let new = |one: &&Problem| !known.iter().any(|old| old.title() == one.title());
                let said: Vec<&Problem> = match wrong {
                    Some(wrong) => vec![wrong],
                    None => found.iter().filter(new).collect(),
                };
                for Problem { severity, message, help, .. } in said {
                    let help = help.as_ref().map_or_else(String::new, |help| format!("; {help}"));
                    writeln!(self.writer, "  {severity}: {message}{help}")?;
                }
                if wrong.is_none() {
                    (case, known) = (changed, found);
                    break;
                }
            }
        }
        Ok(Some(case))
    }
}

/// All that is wrong or doubtful in a case.
fn problems(case: &CaseFile) -> Vec<Problem> {
    case.task().map_or_else(|problems| problems, |task| task.warnings().to_vec())
}

/// A value without the quotes around all of it.
fn bare(written: &str) -> &str {
    let inside = written.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
    inside.filter(|inside| !inside.contains('"')).unwrap_or(written)
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::Talk;
    use crate::builtin::named;
    use crate::rigs::RIGS;
    use archard_case::CaseFile;

    /// The case of a rig, and what was said, after these answers.
    fn talk(rig: &str, answers: &str) -> (Option<CaseFile>, String) {
        let rig = RIGS.iter().find(|known| known.name == rig).unwrap();
        let text = named(rig.name).unwrap().text;
        let mut talk = Talk { reader: Cursor::new(answers.to_owned()), writer: Vec::new() };
        let case = talk.fill(CaseFile::from_text("case.toml", text, "."), rig.asks).unwrap();
        (case, String::from_utf8(talk.writer).unwrap())
    }

    #[test]
    fn enter_keeps_every_case_as_it_is() {
        for rig in RIGS {
            let (case, said) = talk(rig.name, &"\n".repeat(rig.asks.len()));
            assert_eq!(case.unwrap().to_text(), named(rig.name).unwrap().text);
            for (key, words) in rig.asks {
                assert!(said.contains(&format!("{words} [")), "{key}: {said}");
            }
        }
    }

    #[test]
    fn answers_stand_in_the_case_and_wrong_ones_are_asked_for_again() {
        let answers = "100Cr5\n100Cr6\n3\n3 mm\n304\n-5 N\n20 N\n";
        let (case, said) = talk("ball_on_flat", answers);
        let case = case.unwrap();
        let at = |key: &str| case.written_at(key).unwrap().to_owned();
        assert_eq!(at("body.ball.material"), "\"100Cr6\"");
        assert_eq!(at("body.ball.profile.sphere.radius"), "\"3 mm\"");
        assert_eq!(at("body.flat.material"), "304");
        assert_eq!(at("motion.indentation.load"), "\"20 N\"");
        for words in ["did you mean `100Cr6`?", "\"3 mm\" or \"3 m\"", "greater than zero"] {
            assert!(said.contains(words), "{words}: {said}");
        }
        assert_eq!(said.matches("load [10.2 N]").count(), 2);
        assert!(case.task().is_ok() && case.to_text().starts_with("title"));
    }

    #[test]
    fn nothing_comes_of_answers_that_end_early() {
        assert!(talk("twin_disc", "\n\n").0.is_none());
    }
}
