//! A case as written: the file and the options laid over it.

use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

use archard::parameters::Invalid;
use archard_surface::HeightMap;
use toml::de::DeTable;

use super::accuracy;
use super::cam;
use super::check;
use super::chosen::ChosenPart;
use super::elastic;
use super::gear;
use super::key::{Key, Part};
use super::overlay;
use super::problem::{Location, Problem, Severity, Source, Target};
use super::reader::{Reader, Section};
use super::resolved::{
    ResolvedCam, ResolvedElastic, ResolvedGear, ResolvedWheelRail, RunnableCase, Task,
};
use super::surface::PreparedSurface;
use super::told::{PROBLEMS, told};
use super::tree::{Origin, Table};
use super::unclosed::unclosed;
use super::wheel_rail;
use crate::files::{self, Inputs};

/// A case as written.
#[derive(Debug, Clone)]
pub struct CaseFile {
    name: String,
    folder: PathBuf,
    text: String,
    /// What was laid over it, and what messages call each.
    options: Vec<(&'static str, String)>,
}

/// A case file that cannot be read.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
#[error("cannot read the case `{}`: {cause}", .path.display())]
pub struct Unreadable {
    /// The file.
    pub path: PathBuf,
    /// Why not.
    #[source]
    pub cause: io::Error,
}

impl CaseFile {
    /// Reads a file, or the `case.toml` of a folder.
    ///
    /// # Errors
    /// If there is no such file or it is not text.
    pub fn read(path: &Path) -> Result<Self, Unreadable> {
        let path = if path.is_dir() { path.join("case.toml") } else { path.to_owned() };
        match files::read_text(&path) {
            Ok(text) => {
                let folder = path.parent().map(Path::to_owned).unwrap_or_default();
                Ok(Self::from_text(path.display().to_string(), text, folder))
            }
            Err(cause) => Err(Unreadable { path, cause }),
        }
    }

    /// A case of that text. Messages call it by the name; file names in it are relative to the folder.
    pub fn from_text(
        name: impl Into<String>,
        text: impl Into<String>,
        folder: impl Into<PathBuf>,
    ) -> Self {
        Self { name: name.into(), folder: folder.into(), text: text.into(), options: vec![] }
    }

    /// The files that it reads: its own, and each that a text in it or in what is laid over it names, by itself or in quotes
    /// within a formula.
    pub fn inputs(&self) -> Inputs {
        let (laid, mut texts) = (self.laid(), vec![]);
        laid.table.texts(&mut texts);
        let parts = texts.iter().flat_map(|text| text.split(['"', '\'']).chain([&**text]));
        let named = parts.map(|name| self.folder.join(name)).chain([PathBuf::from(&self.name)]);
        Inputs::of(named.filter(|path| path.is_file()))
    }

    /// Lays an option `KEY=VALUE` over the case; later ones over earlier ones.
    #[must_use]
    pub fn set(self, option: impl Into<String>) -> Self {
        self.set_by("--set", option)
    }

    /// The same where the user gave it by an option of another name, which messages call it by.
    #[must_use]
    pub fn set_by(mut self, name: &'static str, option: impl Into<String>) -> Self {
        self.options.push((name, option.into()));
        self
    }

    /// The same file with another text.
    pub(super) fn with_text(&self, text: String) -> Self {
        Self { text, ..self.clone() }
    }

    /// The text of the file, without what is laid over it.
    pub fn to_text(&self) -> &str {
        &self.text
    }

    /// What messages call a source.
    pub fn name(&self, source: Source) -> &str {
        match source {
            Source::File => &self.name,
            Source::Option(index) => self.options.get(index).map_or("--set", |(name, _)| name),
        }
    }

    /// The text of a source.
    pub fn text(&self, source: Source) -> &str {
        match source {
            Source::File => &self.text,
            Source::Option(index) => self.options.get(index).map_or("", |(_, text)| text),
        }
    }

    /// The line a location begins on, counted from one.
    pub fn line(&self, location: &Location) -> usize {
        let text = self.text(location.source).as_bytes();
        let before = &text[..location.span.start.min(text.len())];
        1 + before.iter().filter(|&&byte| byte == b'\n').count()
    }

    /// A problem in one line: "case.toml:7: error: `frame.size`: ...".
    pub fn describe(&self, problem: &Problem) -> String {
        let place = match &problem.location {
            None => self.name.clone(),
            Some(at) => match at.source {
                Source::File => format!("{}:{}", self.name, self.line(at)),
                source => format!("{} {}", self.name(source), self.text(source)),
            },
        };
        format!("{place}: {}: {}", problem.severity, problem.title())
    }

    /// Reads and checks the case: of two bodies in contact, of one body by itself, of two gears, of a cam, or of a wheel on a rail.
    ///
    /// # Errors
    /// All that is wrong with it, and the warnings besides.
    pub fn task(&self) -> Result<Task, Vec<Problem>> {
        let laid = self.laid();
        if Reader::is_wheel_rail(&Section { key: Key::default(), table: &laid.table }) {
            let read = |reader: &mut Reader<'_>, root: &Section<'_>| reader.wheel_rail(root);
            let (case, forecast, warnings) = self.examine(laid, read, wheel_rail::check)?;
            return Ok(Task::WheelRail(Box::new(ResolvedWheelRail { case, forecast, warnings })));
        }
        if Reader::is_gear(&Section { key: Key::default(), table: &laid.table }) {
            let read = |reader: &mut Reader<'_>, root: &Section<'_>| reader.gear(root);
            let (case, forecast, warnings) = self.examine(laid, read, gear::check)?;
            return Ok(Task::Gear(Box::new(ResolvedGear { case, forecast, warnings })));
        }
        if Reader::is_cam(&Section { key: Key::default(), table: &laid.table }) {
            let read = |reader: &mut Reader<'_>, root: &Section<'_>| reader.cam(root);
            let (case, forecast, warnings) = self.examine(laid, read, cam::check)?;
            return Ok(Task::Cam(Box::new(ResolvedCam { case, forecast, warnings })));
        }
        if !Reader::is_elastic(&Section { key: Key::default(), table: &laid.table }) {
            return self.resolve_contact(laid).map(|resolved| Task::Contact(Box::new(resolved)));
        }
        let (case, forecast, warnings) =
            self.examine(laid, |reader, root| reader.elastic(root), elastic::check)?;
        Ok(Task::Elastic(Box::new(ResolvedElastic { case, forecast, warnings })))
    }

    /// The measured surface of a text that has a `profile.surface` alone.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub fn surface(&self) -> Result<HeightMap, Vec<Problem>> {
        self.prepared_surface().map(|prepared| prepared.map)
    }

    /// The same, with what was done to the heights of the file.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub fn prepared_surface(&self) -> Result<PreparedSurface, Vec<Problem>> {
        let read = |reader: &mut Reader<'_>, root: &Section<'_>| reader.surface(root);
        let built = |map: &ChosenPart<PreparedSurface>| {
            let map = map.build();
            let key = || Key::of(["profile", "surface"]);
            let problem =
                |error: &Invalid| Problem::error(key().child(&error.parameter), &*error.message);
            let problems = map.as_ref().err().map(problem).into_iter().collect();
            (map, problems)
        };
        match self.examine(self.laid(), read, built)? {
            (_, Ok(map), _) => Ok(map),
            (_, Err(error), _) => Err(vec![Problem::error(Key::default(), error.message)]),
        }
    }

    /// Reads and checks a case of two bodies in contact.
    ///
    /// # Errors
    /// All that is wrong with it, and the warnings besides.
    pub fn resolve(&self) -> Result<RunnableCase, Vec<Problem>> {
        self.resolve_contact(self.laid())
    }

    fn resolve_contact(&self, laid: Laid) -> Result<RunnableCase, Vec<Problem>> {
        let implied = laid.implied;
        let read = |reader: &mut Reader<'_>, root: &Section<'_>| {
            let case = check::settle(reader.case(root)?);
            accuracy::choose(case, implied).map_err(|problem| reader.push(problem)).ok()
        };
        let ((case, chose), forecast, warnings) =
            self.examine(laid, read, |(case, _)| check::check(case))?;
        Ok(RunnableCase { case, chose, forecast, warnings })
    }

    /// The tree of the file with the options laid over it.
    fn laid(&self) -> Laid {
        let (mut table, syntax) = self.parse();
        let options = self.options.iter().enumerate();
        let problems = options
            .filter_map(|(index, (_, option))| overlay::apply(&mut table, index, option).err())
            .collect();
        let implied = accuracy::imply(&mut table);
        Laid { table, syntax, problems, implied }
    }

    /// Reads a case and checks it, if it could be read.
    fn examine<C, F>(
        &self,
        Laid { table, syntax, problems, .. }: Laid,
        read: impl FnOnce(&mut Reader<'_>, &Section<'_>) -> Option<C>,
        check: impl FnOnce(&C) -> (F, Vec<Problem>),
    ) -> Result<(C, F, Vec<Problem>), Vec<Problem>> {
        let mut reader = Reader {
            folder: &self.folder,
            problems,
            bodies: vec![],
            line: None,
            cell: None,
            framed: false,
        };
        let case = read(&mut reader, &Section { key: Key::default(), table: &table });
        let mut problems = reader.problems;
        let failed = |problems: &[Problem]| {
            problems.iter().any(|problem| problem.severity == Severity::Error)
        };
        let mut checked = None;
        if let Some(case) = case
            && syntax.problems.is_empty()
            && !failed(&problems)
        {
            let (forecast, doubts) = check(&case);
            problems.extend(doubts);
            checked = Some((case, forecast));
        }
        let problems = self.locate(problems, syntax, &table);
        match checked {
            Some((case, forecast)) if !failed(&problems) => Ok((case, forecast, problems)),
            _ => Err(problems),
        }
    }

    /// The tree of the file, and what is not TOML in it.
    fn parse(&self) -> (Table, Syntax) {
        let (table, errors) = DeTable::parse_recoverable(&self.text);
        let origin = Origin { source: Source::File, start: 0, fixed: None };
        let problems = errors.iter().take(PROBLEMS + 1).map(|error| Problem {
            location: error.span().map(|span| Location { source: Source::File, span }),
            ..Problem::error(Key::default(), error.message())
        });
        let mut problems: Vec<Problem> = problems.collect();
        let unclosed = problems.first().and_then(|_| unclosed(&self.text));
        if let (Some(first), Some(unclosed)) = (problems.first_mut(), &unclosed) {
            let help = format!("{unclosed}; is a bracket or a quote missing on a line above?");
            first.help = Some(help);
        }
        let syntax = Syntax { problems, unclosed: unclosed.is_some() };
        (Table::from_toml(table.get_ref(), &origin), syntax)
    }

    /// The bytes within the text of a value that are meant, or all of it where they cannot be told.
    fn narrowed(&self, at: Location, within: Option<&Range<usize>>) -> Location {
        let text = self.text(at.source);
        let span = within.and_then(|within| {
            let start = at.span.start + beginning(text.get(at.span.clone())?)?;
            let span = start + within.start..start + within.end;
            (span.end <= at.span.end && text.get(span.clone()).is_some()).then_some(span)
        });
        span.map_or(at.clone(), |span| Location { span, ..at })
    }

    /// The place to look at for a key that has nothing written: the accuracy that a frame was chosen for, or the end of
    /// the file, where the key would follow.
    fn place_of_unwritten(&self, key: &Key, table: &Table) -> Option<Location> {
        let first = key.parts().first()?;
        let accuracy = table.get("accuracy").filter(|_| *first == Part::Name("frame".to_owned()));
        let end = self.text.trim_end().len();
        let last_line = self.text[..end].rfind('\n').map_or(0, |place| place + 1);
        let end = || Location { source: Source::File, span: last_line..end };
        Some(accuracy.map_or_else(end, |entry| entry.node.at.clone()))
    }

    /// Looks up where each problem stands, in the order of the file. Beside broken TOML, keys are
    /// missing and values garbled only because of it: such problems are left out.
    /// Of more than are told the first, errors before warnings.
    fn locate(&self, mut found: Vec<Problem>, syntax: Syntax, table: &Table) -> Vec<Problem> {
        found.sort_by_key(|problem| problem.severity == Severity::Warning);
        let mut more = found.len() > PROBLEMS;
        found.truncate(PROBLEMS);
        let Syntax { problems: mut syntax, unclosed } = syntax;
        let line = |problem: &Problem| problem.location.as_ref().map(|at| self.line(at));
        let broken: Vec<usize> = syntax.iter().filter_map(line).collect();
        let located = found.into_iter().map(|problem| {
            let at = problem.location.clone();
            let at = at.or_else(|| table.locate(&problem.key, problem.target));
            let at = at.or_else(|| self.place_of_unwritten(&problem.key, table));
            Problem {
                location: at.map(|at| self.narrowed(at, problem.within.as_deref())),
                message: told(problem.message),
                help: problem.help.map(told),
                ..problem
            }
        });
        let independent = |problem: &Problem| {
            syntax.is_empty()
                || (!unclosed
                    && problem.target != Target::Missing
                    && line(problem).is_none_or(|line| !broken.contains(&line)))
        };
        let mut problems: Vec<Problem> = located.filter(independent).collect();
        // What follows something unclosed is read as its content: the first mistake says enough.
        syntax.dedup_by_key(|problem| if unclosed { None } else { line(problem) });
        problems.extend(syntax);
        problems.sort_by_key(|problem| {
            problem.location.as_ref().map(|location| (location.source, location.span.start))
        });
        more |= problems.len() > PROBLEMS;
        problems.truncate(PROBLEMS);
        if more {
            let message = "there is more, which is told once this is mended";
            let fails = problems.iter().any(|problem| problem.severity == Severity::Error);
            let severity = if fails { Severity::Error } else { Severity::Warning };
            problems.push(Problem { severity, ..Problem::error(Key::default(), message) });
        }
        problems
    }
}

/// Where the text of a value begins behind its quotes; `None` where what is written is not what is meant.
fn beginning(written: &str) -> Option<usize> {
    let quotes = ["\"\"\"", "'''", "\"", "'"];
    let quote = quotes.into_iter().find(|quote| written.starts_with(quote)).unwrap_or_default();
    let inside = &written[quote.len()..];
    // TOML leaves out a line break behind three quotes.
    let breaks = ["\r\n", "\n"].into_iter().filter(|_| quote.len() == 3);
    let left_out = breaks.into_iter().find(|first| inside.starts_with(first)).map_or(0, str::len);
    let escaped = quote.starts_with('"') && inside.contains('\\');
    // A list or table of an option that lost its quotes.
    let whole = quote.is_empty() && written.starts_with(['[', '{']);
    (!escaped && !whole).then_some(quote.len() + left_out)
}

/// A tree with what is wrong with it so far.
struct Laid {
    table: Table,
    syntax: Syntax,
    /// Whether the tolerance of the steps follows from the accuracy.
    implied: bool,
    /// What is wrong with the options.
    problems: Vec<Problem>,
}

/// What is not TOML in a file.
struct Syntax {
    problems: Vec<Problem>,
    /// Whether a list, a table or a header never ends.
    unclosed: bool,
}
