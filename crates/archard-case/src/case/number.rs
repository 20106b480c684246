//! What a case has at a key.

use toml::de::DeTable;

use super::Case;
use super::problem::Source;
use super::tree::{Item, Node, Origin, Table};

/// A value of a case, in SI.
#[derive(Debug, Clone, PartialEq)]
pub enum ValueAt {
    /// A number and its unit, which is empty of a pure number.
    Number(f64, String),
    /// A text, or true or false.
    Text(String),
    /// A list, as a case file has it.
    List(String),
}

impl Case {
    /// The number (SI) at a dotted key, and its SI unit, which is empty of a pure number; `None` where the case has no
    /// number there.
    pub fn number_at(&self, key: &str) -> Option<(f64, String)> {
        match self.value_at(key)? {
            ValueAt::Number(value, unit) => Some((value, unit)),
            ValueAt::Text(_) | ValueAt::List(_) => None,
        }
    }

    /// The value at a dotted key; `None` where the case has none there, or a table.
    pub fn value_at(&self, key: &str) -> Option<ValueAt> {
        let text = self.to_string();
        let parsed = DeTable::parse(&text).ok()?;
        let origin = Origin { source: Source::File, start: 0, fixed: None };
        let printed = Table::from_toml(parsed.get_ref(), &origin);
        let path = super::overlay::read_path(key, Source::File)?;
        let ((first, _), rest) = path.split_first()?;
        let first = &printed.get(first)?.node;
        let found = rest.iter().try_fold(first, |node, (name, _)| within(node, name))?;
        value(found, &text)
    }
}

/// What a table, or a list by the number of an element, holds under a name.
fn within<'a>(node: &'a Node, name: &str) -> Option<&'a Node> {
    match &node.item {
        Item::Table(inner) => inner.get(name).map(|entry| &entry.node),
        Item::Array(values) => values.get(name.parse::<usize>().ok()?),
        _ => None,
    }
}

/// A value of a printed case.
fn value(node: &Node, text: &str) -> Option<ValueAt> {
    let number = |text: &str| -> Option<ValueAt> {
        let (number, unit) = text.split_once(' ')?;
        Some(ValueAt::Number(number.parse().ok()?, unit.to_owned()))
    };
    match &node.item {
        Item::Number { value, .. } => Some(ValueAt::Number(*value, String::new())),
        Item::Text(text) => Some(number(text).unwrap_or_else(|| ValueAt::Text(text.clone()))),
        Item::Boolean(value) => Some(ValueAt::Text(value.to_string())),
        Item::Array(_) => Some(ValueAt::List(text.get(node.at.span.clone())?.to_owned())),
        Item::Table(_) | Item::Date => None,
    }
}
