//! Reads a case and shows what is wrong with it: file, line, the place underlined, what to do.

use std::ops::Range;

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use archard_case::{CaseFile, Problem, Severity, Task};

use crate::arguments::Case;
use crate::builtin;
use crate::failure::Failure;
use crate::say::{in_colour, tell};

/// The case of the arguments, with its options.
pub fn read(arguments: &Case) -> Result<CaseFile, Failure> {
    let file = builtin::read(&arguments.case)?;
    let file = arguments.set.iter().fold(file, |file, option| file.set(option));
    let file = arguments.limits().fold(file, |file, option| file.set_by("--until", option));
    Ok(arguments
        .accuracy()
        .into_iter()
        .fold(file, |file, option| file.set_by("--accuracy", option)))
}

/// The checked case of the arguments; problems are shown unless they are warnings and `quiet`.
pub fn resolve(arguments: &Case, quiet: bool) -> Result<Task, Failure> {
    checked(&read(arguments)?, quiet)
}

/// The same of a case that was read.
pub fn checked(file: &CaseFile, quiet: bool) -> Result<Task, Failure> {
    match file.task() {
        Ok(task) => {
            if !quiet {
                show(file, task.warnings());
            }
            Ok(task)
        }
        Err(problems) => {
            show(file, &problems);
            Err(Failure::Shown)
        }
    }
}

/// Prints problems.
pub fn show(file: &CaseFile, problems: &[Problem]) {
    let renderer = if in_colour() { Renderer::styled() } else { Renderer::plain() };
    let renderer = renderer.decor_style(DecorStyle::Ascii);
    for problem in problems {
        tell(&format!("{}\n", renderer.render(&[group(file, problem)])));
    }
}

/// A problem as the renderer takes it.
fn group<'a>(file: &'a CaseFile, problem: &'a Problem) -> Group<'a> {
    let level = match problem.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let group = Group::with_title(level.primary_title(problem.title()));
    let group = match &problem.location {
        None => group.element(Origin::path(file.name(archard_case::Source::File))),
        Some(at) => {
            let (lines, number, span) = lines_of(file.text(at.source), at.span.clone());
            group.element(
                Snippet::source(lines)
                    .line_start(number)
                    .path(file.name(at.source))
                    .annotation(AnnotationKind::Primary.span(span)),
            )
        }
    };
    match &problem.help {
        Some(help) => group.element(Level::HELP.message(help)),
        None => group,
    }
}

/// The lines that a span of a text lies in, the number of the first, and the span within them: the renderer looks through all
/// that it is given, once a problem.
fn lines_of(text: &str, span: Range<usize>) -> (&str, usize, Range<usize>) {
    let start = text.get(..span.start).and_then(|before| before.rfind('\n')).map_or(0, |at| at + 1);
    let after = text.get(span.end..).unwrap_or_default();
    let end = span.end.min(text.len()) + after.find('\n').unwrap_or(after.len());
    let number = 1 + text.as_bytes()[..start].iter().filter(|byte| **byte == b'\n').count();
    (&text[start..end], number, span.start - start..span.end - start)
}

#[cfg(test)]
mod tests {
    use super::lines_of;

    #[test]
    fn a_span_has_its_lines() {
        let text = "title = 1\n\nbody = {\n  a = 2 }\nlast";
        let of = |part: &str| {
            let start = text.find(part).unwrap();
            lines_of(text, start..start + part.len())
        };
        assert_eq!(of("title"), ("title = 1", 1, 0..5));
        assert_eq!(of("{\n  a"), ("body = {\n  a = 2 }", 3, 7..12));
        assert_eq!(of("last"), ("last", 5, 0..4));
        assert_eq!(lines_of(text, text.len()..text.len()), ("last", 5, 4..4));
        assert_eq!(lines_of("", 0..0), ("", 1, 0..0));
    }
}
