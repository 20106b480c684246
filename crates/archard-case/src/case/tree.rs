//! The case as written: a tree of values that know where they stand.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::key::{Key, Part};
use super::problem::{Location, Source, Target};

/// A value and where it stands.
#[derive(Debug, Clone)]
pub(super) struct Node {
    pub item: Item,
    pub at: Location,
}

/// A value.
#[derive(Debug, Clone)]
pub(super) enum Item {
    Text(String),
    /// A number as it was written, its value, and whether it was written as a whole number.
    Number {
        text: String,
        value: f64,
        whole: bool,
    },
    Boolean(bool),
    Array(Vec<Node>),
    Table(Table),
    /// A date or a time: no case has any use of it.
    Date,
}

/// Entries in the order in which they were written.
#[derive(Debug, Clone, Default)]
pub(super) struct Table(pub Vec<Entry>);

/// A key and its value.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    pub name: String,
    /// Where the key stands.
    pub at: Location,
    pub node: Node,
}

/// Where the parser's spans belong: the text, and what they begin at or are replaced by.
#[derive(Debug, Clone)]
pub(super) struct Origin {
    pub source: Source,
    /// Where the parsed text begins in the source (bytes).
    pub start: usize,
    /// The span all locations get where the parsed text is not literally in the source.
    pub fixed: Option<Range<usize>>,
}

impl Origin {
    pub fn locate(&self, span: Range<usize>) -> Location {
        let span = self.fixed.clone().unwrap_or(span.start + self.start..span.end + self.start);
        Location { source: self.source, span }
    }
}

impl Item {
    /// What kind of value it is, with its article.
    pub fn kind(&self) -> &'static str {
        match self {
            Item::Text(_) => "a text",
            Item::Number { .. } => "a number",
            Item::Boolean(_) => "true or false",
            Item::Array(_) => "a list",
            Item::Table(_) => "a table",
            Item::Date => "a date",
        }
    }
}

impl Node {
    pub fn from_toml(value: &Spanned<DeValue<'_>>, origin: &Origin) -> Self {
        let item = match value.get_ref() {
            DeValue::String(text) => Item::Text(text.to_string()),
            DeValue::Integer(integer) => Item::Number {
                text: integer.to_string(),
                value: i128::from_str_radix(integer.as_str(), integer.radix())
                    .map_or(f64::INFINITY, |value| value as f64),
                whole: true,
            },
            DeValue::Float(float) => Item::Number {
                text: float.to_string(),
                value: float.as_str().parse().unwrap_or(f64::NAN),
                whole: false,
            },
            DeValue::Boolean(value) => Item::Boolean(*value),
            DeValue::Datetime(_) => Item::Date,
            DeValue::Array(values) => {
                Item::Array(values.iter().map(|value| Self::from_toml(value, origin)).collect())
            }
            DeValue::Table(table) => Item::Table(Table::from_toml(table, origin)),
        };
        Self { item, at: origin.locate(value.span()) }
    }

    fn texts<'a>(&'a self, found: &mut Vec<&'a str>) {
        match &self.item {
            Item::Text(text) => found.push(text),
            Item::Array(nodes) => nodes.iter().for_each(|node| node.texts(found)),
            Item::Table(table) => table.texts(found),
            Item::Number { .. } | Item::Boolean(_) | Item::Date => {}
        }
    }
}

impl Table {
    pub fn from_toml(table: &DeTable<'_>, origin: &Origin) -> Self {
        let mut entries: Vec<Entry> = table
            .iter()
            .map(|(key, value)| Entry {
                name: key.get_ref().to_string(),
                at: origin.locate(key.span()),
                node: Node::from_toml(value, origin),
            })
            .collect();
        entries.sort_by_key(|entry| entry.at.span.start);
        Self(entries)
    }

    pub fn get(&self, name: &str) -> Option<&Entry> {
        self.0.iter().find(|entry| entry.name == name)
    }

    pub fn get_mut(&mut self, name: &str) -> Option<&mut Entry> {
        self.0.iter_mut().find(|entry| entry.name == name)
    }

    /// All texts in it, at any depth.
    pub fn texts<'a>(&'a self, found: &mut Vec<&'a str>) {
        self.0.iter().for_each(|entry| entry.node.texts(found));
    }

    /// Where a key stands, or what of it there is; `None` if not even its first part is there.
    pub fn locate(&self, key: &Key, target: Target) -> Option<Location> {
        let mut table = Some(self);
        let mut node = None;
        let mut deepest = None;
        for part in key.parts() {
            let found = match part {
                Part::Name(name) => table.and_then(|table| table.get(name)).map(|entry| {
                    deepest = Some(&entry.at);
                    &entry.node
                }),
                Part::Index(index) => match node.map(|node: &Node| &node.item) {
                    Some(Item::Array(values)) => values.get(*index),
                    _ => None,
                },
            };
            let Some(found) = found else { return deepest.cloned() };
            table = match &found.item {
                Item::Table(table) => Some(table),
                _ => None,
            };
            node = Some(found);
        }
        match node {
            Some(node) if target == Target::Value && !matches!(node.item, Item::Table(_)) => {
                Some(node.at.clone())
            }
            _ => deepest.cloned(),
        }
    }
}
