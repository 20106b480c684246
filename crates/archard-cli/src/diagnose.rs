//! Reads a case and shows what is wrong with it: file, line, the place underlined, what to do.

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use archard::case::{CaseFile, Problem, Severity, Task};

use crate::arguments::Case;
use crate::builtin;
use crate::failure::Failure;
use crate::say::{in_colour, tell};

/// The case of the arguments, with its options.
pub fn read(arguments: &Case) -> Result<CaseFile, Failure> {
    let file = builtin::read(&arguments.case)?;
    Ok(arguments.set.iter().fold(file, |file, option| file.set(option)))
}

/// The checked case of the arguments; problems are shown unless they are warnings and `quiet`.
pub fn resolve(arguments: &Case, quiet: bool) -> Result<Task, Failure> {
    let file = read(arguments)?;
    match file.task() {
        Ok(task) => {
            if !quiet {
                show(&file, task.warnings());
            }
            Ok(task)
        }
        Err(problems) => {
            show(&file, &problems);
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
        None => group.element(Origin::path(file.name(archard::case::Source::File))),
        Some(at) => group.element(
            Snippet::source(file.text(at.source))
                .path(file.name(at.source))
                .annotation(AnnotationKind::Primary.span(at.span.clone())),
        ),
    };
    match &problem.help {
        Some(help) => group.element(Level::HELP.message(help)),
        None => group,
    }
}
