//! Matrices of stiffness or flexibility at the nodes of a body, from other programs.
//!
//! A format is one file here and one arm of [`read`]. All of them become rows with the node and the direction they stand for, and
//! values, as far as the file gives them; what is missing of a symmetric matrix follows.

mod bulk;
mod lists;
mod market;
mod places;
#[cfg(test)]
mod tests;
mod user;

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use super::inside::Inside;
use crate::body::mesh::Zone;
use crate::body::mesh::reduced::{Holds, ReducedMatrix};
use crate::numerics::WRITTEN;

pub(super) use places::{PLACES, Places};

/// What is wrong with a matrix, and in which line where that is known.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Wrong {
    pub line: Option<usize>,
    pub message: String,
}

impl Wrong {
    fn at(line: usize, message: impl Into<String>) -> Self {
        Self { line: Some(line), message: message.into() }
    }

    fn all(message: impl Into<String>) -> Self {
        Self { line: None, message: message.into() }
    }

    /// The same as a sentence about a file of that name.
    pub fn of(&self, name: &str) -> String {
        match self.line {
            Some(line) => format!("{name}, line {line}: {}", self.message),
            None => format!("{name}: {}", self.message),
        }
    }
}

/// Units of matrices: what they hold, and how much of it in SI one is.
pub(super) const UNITS: [(&str, Holds, f64); 8] = [
    ("N/m", Holds::Stiffness, 1.0),
    ("N/mm", Holds::Stiffness, 1e3),
    ("kN/mm", Holds::Stiffness, 1e6),
    ("lbf/in", Holds::Stiffness, POUND / INCH),
    ("m/N", Holds::Flexibility, 1.0),
    ("mm/N", Holds::Flexibility, 1e-3),
    ("um/N", Holds::Flexibility, 1e-6),
    ("in/lbf", Holds::Flexibility, INCH / POUND),
];
/// The names of these.
pub(super) const WORDS: [&str; 8] =
    ["N/m", "N/mm", "kN/mm", "lbf/in", "m/N", "mm/N", "um/N", "in/lbf"];
/// An inch (m) and a pound of force (N), as they are defined.
const INCH: f64 = 0.0254;
const POUND: f64 = 4.448_221_615_260_5;

/// A row by the number of its node and its direction, 0 to 2 along x, y and z.
type Label = (i64, usize);

/// A matrix as its file has it.
#[derive(Debug, Default)]
pub(super) struct Written {
    /// `None` where a file gives values by rows alone.
    labels: Option<Vec<Label>>,
    size: usize,
    entries: Vec<(usize, usize, f64)>,
    /// Whether values on both sides of the diagonal are all there, where that is said.
    full: bool,
    /// Whether the file itself says that it holds a stiffness.
    stiffness: bool,
    digits: usize,
}

impl Written {
    /// The index of a row, which is a new one where nothing has named it.
    fn row(&mut self, label: Label, known: &mut HashMap<Label, usize>) -> usize {
        *known.entry(label).or_insert_with(|| {
            self.labels.get_or_insert_default().push(label);
            self.size += 1;
            self.size - 1
        })
    }

    /// A value with the digits that it is written with.
    fn value(&mut self, word: &str, line: usize) -> Result<f64, Wrong> {
        let value = real(word)
            .ok_or_else(|| Wrong::at(line, format!("expected a number, found `{}`", cut(word))))?;
        let digits = word.trim_start_matches(['+', '-']).chars();
        let digits = digits
            .take_while(|c| c.is_ascii_digit() || *c == '.')
            .filter(char::is_ascii_digit)
            .skip_while(|c| *c == '0')
            .count();
        self.digits = self.digits.max(digits);
        Ok(value)
    }

    fn name(&self, row: usize) -> String {
        let axis = |along: usize| ["x", "y", "z"].get(along).copied();
        match self.labels.as_ref().map(|labels| labels[row]) {
            None => format!("row {}", row + 1),
            Some((node, along)) => match axis(along) {
                Some(axis) => format!("node {node} along {axis}"),
                None => format!("node {node} in direction {}", along + 1),
            },
        }
    }

    /// The values on and below the diagonal, each once, if the matrix can be one of stiffness or flexibility.
    fn lower(&self) -> Result<Vec<(usize, usize, f64)>, Wrong> {
        let mut all = self.entries.clone();
        let key = |(row, column, _): &(usize, usize, f64)| {
            (*row.min(column), *row.max(column), row < column)
        };
        all.sort_by_key(key);
        let mut diagonal = vec![0.0; self.size];
        all.iter().filter(|one| one.0 == one.1).for_each(|one| diagonal[one.0] = one.2);
        if let Some(row) = diagonal.iter().position(|value| *value <= 0.0) {
            let (name, value) = (self.name(row), diagonal[row]);
            return Err(Wrong::all(format!(
                "{name} has {value:e} on the diagonal, where a body resists: give the matrix of a part that its nodes deform"
            )));
        }
        let off = |row: usize, column: usize, one: f64, other: f64| {
            (one - other).abs() > WRITTEN * (diagonal[row] * diagonal[column]).sqrt()
        };
        let pairs = |two: &[(usize, usize, f64)]| two[0].0 == two[1].1 && two[0].1 == two[1].0;
        let twice = |two: &[(usize, usize, f64)]| two[0].0 == two[1].0 && two[0].1 == two[1].1;
        if let Some(two) = all.windows(2).find(|two| twice(two)) {
            let (row, column) = (self.name(two[0].0), self.name(two[0].1));
            return Err(Wrong::all(format!("the value of {row} and {column} is there twice")));
        }
        let full = self.full || all.windows(2).any(|two| two[0].0 != two[0].1 && pairs(two));
        let mut lower: Vec<(usize, usize, f64)> = Vec::with_capacity(all.len());
        for (row, column, value) in all {
            let (below, right) = (row.max(column), row.min(column));
            match lower.last() {
                Some(&(known, other, first))
                    if (known, other) == (below, right) && row != column =>
                {
                    if off(row, column, first, value) {
                        return Err(self.unsymmetric(row, column, [first, value]));
                    }
                }
                _ => lower.push((below, right, value)),
            }
        }
        if full && self.entries.len() + self.size != 2 * lower.len() {
            // Zeros are left out on both sides, or on none.
            let given: std::collections::HashSet<(usize, usize)> =
                self.entries.iter().map(|(row, column, _)| (*row, *column)).collect();
            let alone = self.entries.iter().find(|(row, column, value)| {
                !given.contains(&(*column, *row)) && off(*row, *column, *value, 0.0)
            });
            if let Some(&(row, column, value)) = alone {
                return Err(self.unsymmetric(row, column, [value, 0.0]));
            }
        }
        Ok(lower)
    }

    fn unsymmetric(&self, row: usize, column: usize, [one, other]: [f64; 2]) -> Wrong {
        let (row, column) = (self.name(row), self.name(column));
        Wrong::all(format!(
            "the matrix is not symmetric: {one:e} and {other:e} between {row} and {column}; that of an elastic body is, without friction, damping or follower loads"
        ))
    }
}

/// A matrix that can be one of stiffness or flexibility, in the unit of its file.
#[derive(Debug)]
pub(super) struct Parsed {
    written: Written,
    lower: Vec<(usize, usize, f64)>,
}

/// From the bytes of a file.
///
/// # Errors
/// If it has another format or holds no matrix of an elastic body.
pub(super) fn parse(bytes: &[u8]) -> Result<Arc<Parsed>, Wrong> {
    let written = read(&String::from_utf8_lossy(bytes))?;
    let lower = written.lower()?;
    Ok(Arc::new(Parsed { written: Written { entries: vec![], ..written }, lower }))
}

/// The same by the numbers of its nodes.
#[derive(Debug)]
pub(super) struct Matrix {
    parsed: Arc<Parsed>,
    holds: Holds,
    scale: f64,
    places: Option<Places>,
}

impl Matrix {
    /// In that unit (one of [`UNITS`]), its nodes at places that are known or by the numbers of a mesh.
    ///
    /// # Errors
    /// If the file says that it holds something else.
    pub fn new(
        parsed: Arc<Parsed>,
        (_, holds, scale): (&str, Holds, f64),
        places: Option<Places>,
    ) -> Result<Self, Wrong> {
        if parsed.written.stiffness && holds == Holds::Flexibility {
            let message = "the file says that it holds a stiffness, and `compliance_unit` is one of flexibility: give a unit like \"N/mm\"";
            return Err(Wrong::all(message));
        }
        Ok(Self { parsed, holds, scale, places })
    }

    /// At the nodes of a body that may touch in a zone.
    ///
    /// # Errors
    /// If nodes or directions of the zone are missing.
    pub fn at(&self, inside: &Inside, zone: &Zone) -> Result<ReducedMatrix, Wrong> {
        let Parsed { written, lower } = &*self.parsed;
        let numbers = match &self.places {
            Some(places) => places.numbers(inside, zone)?,
            None => inside.numbers().iter().map(|number| i64::try_from(*number).ok()).collect(),
        };
        let number = |node: usize| numbers.get(node).copied().flatten();
        let touching: BTreeSet<(i64, usize)> =
            inside.nodes_of(zone).filter_map(|node| Some((number(node)?, node))).collect();
        let size = written.size;
        let labels = match (&written.labels, &self.places) {
            (Some(labels), _) => labels.clone(),
            (None, Some(places)) => places.labels(size)?,
            (None, None) if size == 3 * touching.len() => {
                let nodes = touching.iter().map(|(number, _)| *number);
                nodes.flat_map(|node| [0, 1, 2].map(|along| (node, along))).collect()
            }
            (None, None) => {
                return Err(Wrong::all(format!(
                    "the matrix has {size} rows and says nothing of nodes; the zone has {} nodes, which take {}: three a node, by the numbers of the nodes, and no others; or give the `places` of its nodes, row by row",
                    touching.len(),
                    3 * touching.len()
                )));
            }
        };
        let mut rows: HashMap<i64, [Option<usize>; 3]> = HashMap::new();
        for (row, (node, along)) in labels.iter().enumerate() {
            if *along < 3 {
                rows.entry(*node).or_default()[*along] = Some(row);
            }
        }
        let missing: Vec<i64> = touching
            .iter()
            .map(|(number, _)| *number)
            .filter(|number| !rows.contains_key(number))
            .collect();
        if let Some(first) = missing.first() {
            let strange = rows.keys().filter(|node| !numbers.contains(&Some(**node))).count();
            let hint = match strange {
                0 => {
                    "retain all nodes of the contact, those in the middles of edges too".to_owned()
                }
                _ => format!(
                    "{strange} nodes of the matrix are not in the mesh: it takes the same numbers"
                ),
            };
            return Err(Wrong::all(format!(
                "{} of the {} nodes of the zone are not in the matrix, the first is node {first}; {hint}",
                missing.len(),
                touching.len()
            )));
        }
        for (number, _) in &touching {
            if let Some(along) = rows[number].iter().position(Option::is_none) {
                return Err(Wrong::all(format!(
                    "node {number} of the zone has no row along {}: retain all three directions",
                    ["x", "y", "z"][along]
                )));
            }
        }
        let known = numbers
            .iter()
            .enumerate()
            .filter_map(|(node, number)| Some((node, *rows.get(&(*number)?)?)));
        let entries = lower.iter().map(|(row, column, value)| (*row, *column, value * self.scale));
        Ok(ReducedMatrix {
            holds: self.holds,
            rows: known.collect(),
            entries: entries.collect(),
            rounding: 0.5 * 10f64.powi(1 - i32::try_from(written.digits).unwrap_or(i32::MAX)),
            labels,
        })
    }
}

/// What the text of a file holds.
fn read(text: &str) -> Result<Written, Wrong> {
    let has = |word: &str| {
        let starts = |line: &str| {
            line.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word))
        };
        text.lines().any(|line| starts(line.trim_start()))
    };
    if has("%%MatrixMarket") {
        market::read(text)
    } else if has("*USER ELEMENT") {
        user::read(text)
    } else if has("DMIG") {
        bulk::read(text)
    } else {
        lists::read(text)
    }
}

/// A number as Fortran writes it: with D for E, or with the sign of the exponent alone.
fn real(word: &str) -> Option<f64> {
    let word = word.trim().to_ascii_lowercase().replace('d', "e");
    let value: Option<f64> = word.parse().ok().or_else(|| {
        let sign = word.char_indices().skip(1).find(|(_, c)| matches!(c, '+' | '-'))?.0;
        format!("{}e{}", &word[..sign], &word[sign..]).parse().ok()
    });
    value.filter(|value| value.is_finite())
}

fn whole<T: std::str::FromStr>(word: &str, line: usize, what: &str) -> Result<T, Wrong> {
    let found = || Wrong::at(line, format!("expected {what}, found `{}`", cut(word)));
    word.trim().parse().map_err(|_| found())
}

fn cut(word: &str) -> String {
    word.trim().chars().take(40).collect()
}

/// The lines of a text that are not empty, counted from 1.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let all = text.lines().enumerate().map(|(index, line)| (index + 1, line));
    all.filter(|(_, line)| !line.trim().is_empty())
}
