//! Reads a table against a declaration of what it takes.

use std::path::Path;

use super::chosen::ChosenPart;
use super::key::Key;
use super::left_out;
use super::nearest::nearest;
use super::problem::{Problem, Source};
use super::quantity;
use super::tree::{Entry, Item, Node, Table};
use archard::parameters::{Bound, Choice, Invalid, Parameter, Quantity, Value, Values};

/// Reads one case and collects what is wrong with it.
pub(super) struct Reader<'a> {
    /// Where relative file names begin.
    pub folder: &'a Path,
    /// What was found so far.
    pub problems: Vec<Problem>,
    /// The names of the bodies, once they are read.
    pub bodies: Vec<String>,
    /// The line of contact, once the frame is read, if it is one.
    pub line: Option<Line>,
    /// The area (m^2) that repeats itself, once the frame is read, if it does.
    pub cell: Option<f64>,
    /// Whether the case has a frame, or an accuracy that one follows from.
    pub framed: bool,
}

/// A line of contact: what loads are shared over.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    /// Its length (m), if it is given.
    pub length: Option<f64>,
}

impl Line {
    /// Its length (m): one metre if none is given.
    pub fn length(self) -> f64 {
        self.length.unwrap_or(1.0)
    }
}

/// A table and its key.
#[derive(Clone)]
pub(super) struct Section<'a> {
    pub key: Key,
    pub table: &'a Table,
}

impl<'a> Section<'a> {
    /// The entry of that name with its key.
    pub fn get(&self, name: &str) -> Option<(Key, &'a Entry)> {
        self.table.get(name).map(|entry| (self.key.child(name), entry))
    }
}

impl Reader<'_> {
    fn surroundings(&self) -> quantity::Surroundings<'_> {
        quantity::Surroundings { folder: self.folder, line: self.line, cell: self.cell }
    }

    pub fn push(&mut self, problem: Problem) {
        self.problems.push(problem);
    }

    /// The table inside a section, or a problem that says what it is for.
    pub fn table<'t>(
        &mut self,
        section: &Section<'t>,
        name: &str,
        meaning: &str,
    ) -> Option<Section<'t>> {
        match section.get(name) {
            Some((key, entry)) => self.as_table(key, &entry.node),
            None => {
                self.missing(section.key.child(name), meaning);
                None
            }
        }
    }

    /// A value as a table, or a problem.
    pub fn as_table<'t>(&mut self, key: Key, node: &'t Node) -> Option<Section<'t>> {
        match &node.item {
            Item::Table(table) => Some(Section { key, table }),
            other => {
                let message =
                    format!("expected a table `{{ key = value, ... }}`, found {}", other.kind());
                self.push(Problem::error(key, message));
                None
            }
        }
    }

    pub fn missing(&mut self, key: Key, meaning: &str) {
        self.push(Problem::missing(key, format!("is missing: {meaning}")));
    }

    /// Complains about entries that are none of the known ones.
    pub fn unknown(&mut self, section: &Section<'_>, what: &str, known: &[&str]) {
        for entry in section.table.0.iter().filter(|entry| !known.contains(&entry.name.as_str())) {
            let meant = nearest(&entry.name, known);
            let message = match meant {
                Some(meant) => format!("is not a known {what}; did you mean `{meant}`?"),
                None => format!("is not a known {what}"),
            };
            let left_out = left_out::remedy(&entry.name).filter(|_| meant.is_none());
            let help = match (left_out, known) {
                (Some(remedy), _) => remedy,
                (None, []) => "nothing is set here".to_owned(),
                (None, known) => format!("known here: {}", known.join(", ")),
            };
            self.push(Problem::error(section.key.child(&entry.name), message).at_name().help(help));
        }
    }

    /// The choice a section makes by the name of its table; `None` if it makes none or a wrong one.
    pub fn choice<T>(
        &mut self,
        section: &Section<'_>,
        what: &str,
        choices: &'static [Choice<T>],
    ) -> Option<(ChosenPart<T>, T)> {
        let names: Vec<&str> = choices.iter().map(|choice| choice.name).collect();
        self.unknown(section, what, &names);
        let mut named = section.table.0.iter().filter_map(|entry| {
            choices.iter().find(|choice| choice.name == entry.name).map(|choice| (choice, entry))
        });
        let (choice, entry) = named.next()?;
        let surplus: Vec<&Entry> = named.map(|(_, entry)| entry).collect();
        for second in &surplus {
            let message = format!("a second {what} beside `{}`: keep one", entry.name);
            let key = section.key.child(&second.name);
            self.push(Problem::error(key, message).at_name());
        }
        let table = self.as_table(section.key.child(&entry.name), &entry.node)?;
        let chosen = self.parameters(&table, choice)?;
        match chosen.build() {
            Ok(built) if surplus.is_empty() => Some((chosen, built)),
            Ok(_) => None,
            Err(invalid) => {
                self.invalid(&table, invalid);
                None
            }
        }
    }

    /// The values a choice takes; `None` if any of them is wrong.
    fn parameters<T>(
        &mut self,
        section: &Section<'_>,
        choice: &'static Choice<T>,
    ) -> Option<ChosenPart<T>> {
        let before = self.problems.len();
        let (values, files) = self.values(section, choice.parameters);
        (self.problems.len() == before).then_some(ChosenPart { choice, values, files })
    }

    /// The values of a declared list of parameters, and the files they came from.
    pub fn values(
        &mut self,
        section: &Section<'_>,
        parameters: &'static [Parameter],
    ) -> (Values, Vec<(&'static str, std::path::PathBuf)>) {
        self.values_among(section, parameters, &[])
    }

    /// The same of a section that has other keys too.
    pub fn values_among(
        &mut self,
        section: &Section<'_>,
        parameters: &'static [Parameter],
        others: &[&'static str],
    ) -> (Values, Vec<(&'static str, std::path::PathBuf)>) {
        let open = |parameter: &&Parameter| parameter.quantity == Quantity::Constants;
        let declared = parameters.iter().filter(|parameter| !open(parameter));
        let names: Vec<&str> = declared.map(|parameter| parameter.name).collect();
        let constants = parameters.iter().find(open);
        if constants.is_none() {
            self.unknown(section, "key", &[&names[..], others].concat());
        }
        let (mut values, mut files) = (Values::default(), vec![]);
        // Factors of powers come last: their unit follows from an exponent read before.
        let (last, first): (Vec<&Parameter>, Vec<_>) = parameters
            .iter()
            .partition(|parameter| matches!(parameter.quantity, Quantity::PowerFactor { .. }));
        if let Some(parameter) = constants {
            let constants = self.constants(section, &names);
            values.insert(parameter.name, Value::Constants(constants));
        }
        for parameter in first.into_iter().chain(last).filter(|parameter| !open(parameter)) {
            match section.get(parameter.name) {
                None if parameter.required => {
                    self.missing(section.key.child(parameter.name), parameter.meaning);
                }
                None => {}
                Some((key, entry)) => {
                    let inner = match (parameter.quantity, &entry.node.item) {
                        (Quantity::Section(inner), _)
                        | (Quantity::TextOr(inner), Item::Table(_)) => Some(inner),
                        _ => None,
                    };
                    if let Some(inner) = inner {
                        if let Some(section) = self.as_table(key, &entry.node) {
                            let (inside, inner_files) = self.values(&section, inner);
                            values.insert(parameter.name, Value::Section(inside));
                            files.extend(inner_files);
                        }
                        continue;
                    }
                    match quantity::read(&entry.node, parameter, &values, &self.surroundings()) {
                        Ok((Value::Word(name), _)) if parameter.quantity == Quantity::Body => {
                            match self.bodies.iter().position(|known| *known == name) {
                                Some(index) => {
                                    values.insert(parameter.name, Value::Body(index, name));
                                }
                                None => {
                                    let known = self.bodies.join(", ");
                                    let message = format!("there is no body `{name}`");
                                    let help = format!("the bodies here: {known}");
                                    self.push(Problem::error(key, message).help(help));
                                }
                            }
                        }
                        Ok((value, file)) => {
                            values.insert(parameter.name, value);
                            files.extend(file.map(|file| (parameter.name, file)));
                        }
                        Err(quantity::Wrong { message, help, within }) => {
                            self.push(Problem { help, within, ..Problem::error(key, message) });
                        }
                    }
                }
            }
        }
        (values, files)
    }

    /// The entries of a table that are not declared, each a number or text with a unit.
    fn constants(&mut self, section: &Section<'_>, declared: &[&str]) -> Vec<(String, String)> {
        let mut constants = vec![];
        for entry in section.table.0.iter().filter(|entry| !declared.contains(&&*entry.name)) {
            match quantity::constant(&entry.node) {
                Ok(text) => constants.push((entry.name.clone(), text)),
                Err(quantity::Wrong { message, help, .. }) => {
                    let key = section.key.child(&entry.name);
                    self.push(Problem { help, ..Problem::error(key, message) });
                }
            }
        }
        constants
    }

    /// A number without unit that is zero or greater and whole.
    pub fn count(&mut self, key: Key, node: &Node) -> Option<usize> {
        const COUNT: Parameter = Parameter::required("", Quantity::Count, "");
        match quantity::read(node, &COUNT, &Values::default(), &self.surroundings()) {
            Ok((Value::Number(number), _)) => Some(number as usize),
            Ok(_) => None,
            Err(wrong) => {
                self.push(Problem { help: wrong.help, ..Problem::error(key, wrong.message) });
                None
            }
        }
    }

    /// What `name` says in `section`, true or false, `Some(None)` where it says nothing; `None` if it is wrong.
    pub fn boolean(&mut self, section: &Section<'_>, name: &str) -> Option<Option<bool>> {
        match section.get(name).map(|(key, entry)| (key, &entry.node.item)) {
            None => Some(None),
            Some((_, Item::Boolean(said))) => Some(Some(*said)),
            Some((key, other)) => {
                let message = format!("expected true or false, found {}", other.kind());
                self.push(Problem::error(key, message));
                None
            }
        }
    }

    /// A value of that quantity, greater than zero.
    pub fn number(&mut self, key: Key, node: &Node, quantity: Quantity) -> Option<f64> {
        let parameter = Parameter::required("", quantity, "");
        match quantity::read(node, &parameter, &Values::default(), &self.surroundings()) {
            Ok((Value::Number(number), _)) => Some(number),
            Ok(_) => None,
            Err(wrong) => {
                self.push(Problem { help: wrong.help, ..Problem::error(key, wrong.message) });
                None
            }
        }
    }

    /// A value of that quantity, of any sign.
    pub fn any_number(&mut self, key: Key, node: &Node, quantity: Quantity) -> Option<f64> {
        let parameter = Parameter::required("", quantity, "").bound(Bound::Any);
        match quantity::read(node, &parameter, &Values::default(), &self.surroundings()) {
            Ok((Value::Number(number), _)) => Some(number),
            Ok(_) => None,
            Err(wrong) => {
                self.push(Problem { help: wrong.help, ..Problem::error(key, wrong.message) });
                None
            }
        }
    }

    /// Values that do not fit together. Where they are several keys of the table, it points
    /// at the one an option set last, since that one upset the case.
    pub fn invalid(&mut self, section: &Section<'_>, invalid: Invalid) {
        let named = section.table.0.iter().filter(|entry| {
            entry.name == invalid.parameter || invalid.beside.contains(&&*entry.name)
        });
        let last =
            named.clone().max_by_key(|entry| (entry.at.source, entry.name == invalid.parameter));
        let Some(last) = last.filter(|entry| entry.at.source != Source::File) else {
            let key =
                invalid.parameter.split('.').fold(section.key.clone(), |key, name| key.child(name));
            let Invalid { message, help, within, .. } = invalid;
            let (help, within) = (help.map(String::from), within.map(Box::new));
            return self.push(Problem { help, within, ..Problem::error(key, message) });
        };
        let within =
            invalid.within.clone().map(Box::new).filter(|_| last.name == invalid.parameter);
        let problem = Problem::error(section.key.child(&last.name), &*invalid.message);
        let problem = Problem { help: invalid.help.clone().map(String::from), within, ..problem };
        let other = named.clone().rfind(|entry| invalid.exclusive && entry.name != last.name);
        self.push(match other {
            Some(other) => {
                let key = section.key.child(&other.name);
                let name = &other.name;
                problem
                    .help(format!("`--set {key}=`, with nothing behind the `=`, removes `{name}`"))
            }
            None => problem,
        });
    }
}
