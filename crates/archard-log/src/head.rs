//! Values that stand above the table of a log: `Radius : 5.00 [mm]`, a name, a value and a unit in three cells, or a line of names over a
//! line of values.

use crate::number::{clock, number};
use crate::roles::ROLES;
use crate::table::{Table, heading, plain};
use crate::unit::{self, Measure};

/// A value above the table.
#[derive(Debug, Clone, PartialEq)]
pub struct HeaderValue {
    /// Its line.
    pub line: usize,
    /// As it stands there.
    pub words: String,
    /// In SI, if it has a unit.
    pub value: Option<f64>,
}

/// The value of a role, if one line above the table states it.
pub fn stated(table: &Table, role: &str) -> Option<HeaderValue> {
    let (_, measure, names) = ROLES.iter().find(|known| known.0 == role)?;
    let is = |name: &str| names.split(' ').any(|known| known == name);
    let above: Vec<&(usize, Vec<String>)> =
        table.asides.iter().filter(|(line, _)| *line < table.heading).collect();
    above.iter().enumerate().find_map(|(at, (line, cells))| {
        let below = above.get(at + 1).map(|(_, cells)| cells);
        cells.iter().enumerate().find_map(|(index, cell)| {
            let (name, rest) = cell.split_once([':', '=']).unwrap_or((cell, ""));
            let (name, unit) = heading(name);
            if !is(&name) {
                return None;
            }
            let later = cells[index + 1..].iter().find(|cell| !cell.is_empty());
            let own =
                if rest.trim().is_empty() { later.map_or("", |own| own) } else { rest.trim() };
            let behind = cells[index + 1..].iter().skip_while(|cell| cell.as_str() != own).nth(1);
            let over = below.and_then(|below| below.get(index)).map_or("", |own| own);
            let own = if value(own, table.decimal).is_some() { own } else { over };
            let units = [unit.as_deref(), behind.map(String::as_str)];
            of((own, table.decimal), &units, *measure, role).map(|value| HeaderValue {
                line: *line,
                words: format!("{name} {own}"),
                value,
            })
        })
    })
}

/// The radius of a track whose diameter is stated.
pub fn of_diameter(table: &Table) -> Option<HeaderValue> {
    let stated = stated(table, "diameter")?;
    Some(HeaderValue { value: stated.value.map(|value| 0.5 * value), ..stated })
}

/// The line and the seconds of a whole time that stands below the table, as `TotalTime` and `00:01:08.25`.
pub fn total(table: &Table) -> Option<(usize, f64)> {
    let last = table.lines.last()?;
    let mut below = table.asides.iter().filter(|(line, _)| line > last);
    let is_total = |cell: &String| plain(cell).contains("totaltime");
    let named = below.clone().any(|(_, cells)| cells.iter().any(is_total));
    let time = |(line, cells): &(usize, Vec<String>)| {
        let found = cells.iter().find_map(|cell| clock(cell))?;
        Some((*line, found.0))
    };
    below.find_map(time).filter(|(_, seconds)| named && *seconds > 0.0)
}

/// The leading number of a text, and what stands behind it.
fn split(text: &str) -> (&str, &str) {
    let text = text.trim();
    let end = text.find(|letter: char| !(letter.is_ascii_digit() || "+-.,".contains(letter)));
    text.split_at(end.unwrap_or(text.len()))
}

/// The leading number of a text, with the decimal sign of the readings if it may have that, or else the other.
fn value(text: &str, decimal: char) -> Option<f64> {
    let (value, _) = split(text);
    let other = if decimal == ',' { '.' } else { ',' };
    number(value, decimal).or_else(|| number(value, other))
}

/// A value in SI, of a text with a unit in it or behind it; `Some(None)` if it has no unit.
fn of(
    (text, decimal): (&str, char),
    units: &[Option<&str>],
    measure: Measure,
    role: &str,
) -> Option<Option<f64>> {
    let value = value(text, decimal)?;
    let (_, own) = split(text);
    let all = std::iter::once(own).chain(units.iter().flatten().copied());
    let mut known = all.filter(|unit| !unit.trim().is_empty()).filter_map(unit::known);
    Some(known.find_map(|(of, size)| match of {
        of if of == measure => Some(value * size),
        Measure::Mass if role == "load" => Some(value * size * unit::FREE_FALL),
        _ => None,
    }))
}
