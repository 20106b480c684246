//! A number of a case by its key.

use toml::de::DeTable;

use super::Case;
use super::problem::Source;
use super::tree::{Item, Origin, Table};

impl Case {
    /// The number (SI) at a dotted key, and its SI unit, which is empty of a pure number; `None` where the case has no
    /// number there.
    pub fn number_at(&self, key: &str) -> Option<(f64, String)> {
        let text = self.to_string();
        let parsed = DeTable::parse(&text).ok()?;
        let origin = Origin { source: Source::File, start: 0, fixed: None };
        let printed = Table::from_toml(parsed.get_ref(), &origin);
        let path = super::overlay::read_path(key, Source::File)?;
        let ((last, _), tables) = path.split_last()?;
        let mut table = &printed;
        for (name, _) in tables {
            match &table.get(name)?.node.item {
                Item::Table(inner) => table = inner,
                _ => return None,
            }
        }
        match &table.get(last)?.node.item {
            Item::Number { value, .. } => Some((*value, String::new())),
            Item::Text(text) => {
                let (number, unit) = text.split_once(' ')?;
                Some((number.parse().ok()?, unit.to_owned()))
            }
            _ => None,
        }
    }
}
