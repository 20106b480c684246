//! Wrong cases and what must be said about each.
//!
//! Every `.toml` file in `bad_cases/` begins with comments that state it:
//!
//! ```text
//! # set: KEY=VALUE                      an option laid over the case, any number of them
//! # error: PLACE, KEY: MESSAGE          a problem that must be found, one line each
//! # warning: PLACE, KEY: MESSAGE
//! ```
//!
//! PLACE is `line N` of the file, `set N` for the N-th option, or `case` where there is nothing to
//! point at. KEY is the key the problem names, `-` where it names none. MESSAGE is a part of the
//! message or of the help below it. Nothing but the problems stated may be found.

use std::fs;
use std::path::{Path, PathBuf};

use archard_case::{CaseFile, Problem, Severity, Source};

/// A problem a file says it has.
#[derive(Debug)]
struct Expected {
    /// Severity, place and key: "error: line 7, frame.size".
    head: String,
    message: String,
}

/// The bad cases.
fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad_cases");
    let mut files: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    files.sort();
    files
}

/// The comments with that label at the beginning of a file.
fn comments<'a>(text: &'a str, label: &'a str) -> impl Iterator<Item = &'a str> {
    let top = text.lines().take_while(|line| line.starts_with('#'));
    top.filter_map(move |line| line.strip_prefix("# ")?.strip_prefix(label)?.strip_prefix(": "))
}

fn expected(text: &str) -> Vec<Expected> {
    let mut expected = vec![];
    for label in ["error", "warning"] {
        for comment in comments(text, label) {
            let (head, message) = comment.split_once(": ").expect("PLACE, KEY: MESSAGE");
            let (head, message) = (format!("{label}: {head}"), message.to_owned());
            expected.push(Expected { head, message });
        }
    }
    expected
}

/// Severity, place and key of a problem, in the notation of the files.
fn head(file: &CaseFile, problem: &Problem) -> String {
    let place = match &problem.location {
        None => "case".to_owned(),
        Some(at) => match at.source {
            Source::File => format!("line {}", file.line(at)),
            Source::Option(index) => format!("set {}", index + 1),
        },
    };
    let key = Some(problem.key.to_string()).filter(|key| !key.is_empty()).unwrap_or("-".to_owned());
    format!("{}: {place}, {key}", problem.severity)
}

/// What is wrong with the way a file is judged.
fn mismatches(path: &Path) -> Vec<String> {
    let text = fs::read_to_string(path).unwrap();
    let mut expected = expected(&text);
    if expected.is_empty() {
        return vec!["states no problem".to_owned()];
    }
    let options = comments(&text, "set");
    let file = options.fold(CaseFile::read(path).unwrap(), |file, option| file.set(option));
    let (refused, found) = match file.task() {
        Ok(task) => (false, task.warnings().to_vec()),
        Err(problems) => (true, problems),
    };
    let mut mismatches = vec![];
    if refused != found.iter().any(|problem| problem.severity == Severity::Error) {
        mismatches.push("refused without an error, or taken with one".to_owned());
    }
    for problem in &found {
        let head = head(&file, problem);
        let said = format!("{}\n{}", problem.message, problem.help.as_deref().unwrap_or_default());
        let matching =
            expected.iter().position(|one| one.head == head && said.contains(&one.message));
        match matching {
            Some(place) => drop(expected.remove(place)),
            None => mismatches.push(format!("not stated: {head}: {said}")),
        }
    }
    mismatches
        .extend(expected.iter().map(|one| format!("not found: {}: {}", one.head, one.message)));
    mismatches
}

/// Cases with mistakes without end: as many as a screen shows are told, each in no more than a screen, and that there are more.
#[test]
fn no_more_is_told_than_a_screen_shows() {
    let name = "x".repeat(300_000);
    let many = |one: &dyn Fn(usize) -> String| (0..3_000).map(one).collect::<String>();
    for text in [
        many(&|at| format!("[x{at}]\na = 1\n")),
        many(&|at| format!("[body.x{at}]\na = 1\n")),
        format!("frame = {{ {} }}\n", many(&|at| format!("k{at} = 1, "))),
        many(&|_| "= 1\n".to_owned()),
        many(&|_| "a = 1\n".to_owned()),
        format!("[body.{name}]\na = 1\n"),
        format!("[body.a]\nmaterial = \"{name}\"\n"),
        format!("[frame]\nsize = [{}1, 2]\n", "9".repeat(300_000)),
    ] {
        let file = CaseFile::from_text("case.toml", text, ".");
        let Err(problems) = file.task() else { panic!("taken") };
        let told: usize = problems
            .iter()
            .map(|one| one.title().len() + one.help.as_deref().map_or(0, str::len))
            .sum();
        assert!(problems.len() <= 25 && told < 25 * 4_000, "{}: {told}", problems.len());
        let more = problems.iter().any(|problem| problem.message.starts_with("there is more"));
        assert_eq!(more, problems.len() == 25);
    }
}

#[test]
fn every_bad_case_is_refused_with_the_message_it_states() {
    let files = files();
    assert!(files.len() >= 100, "only {} bad cases found", files.len());
    let report: Vec<String> = files
        .iter()
        .flat_map(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            mismatches(path).into_iter().map(move |mismatch| format!("{name}: {mismatch}"))
        })
        .collect();
    assert!(report.is_empty(), "\n{}", report.join("\n"));
}
