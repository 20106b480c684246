//! Reads one value as the quantity its declaration asks for.

use std::path::{Path, PathBuf};

use super::columns;
use super::tree::{Item, Node};
use crate::parameters::{Bound, Parameter, Quantity, Value, Values};
use crate::units::{self, Measure};

/// Why a value cannot be read.
pub(super) struct Wrong {
    pub message: String,
    pub help: Option<String>,
}

impl From<String> for Wrong {
    fn from(message: String) -> Self {
        Self { message, help: None }
    }
}

/// The value in SI and, for a table, the file it came from. `before` holds the values already read.
pub(super) fn read(
    node: &Node,
    parameter: &Parameter,
    before: &Values,
    folder: &Path,
) -> Result<(Value, Option<PathBuf>), Wrong> {
    match parameter.quantity {
        Quantity::Number => {
            let (_, value, _) = number(node)?;
            bounded(value, parameter.bound)
        }
        Quantity::Count => {
            let (text, value, whole) = number(node)?;
            if !whole || !(0.0..=9e15).contains(&value) {
                return Err(format!("expected a whole number, found {text}").into());
            }
            bounded(value, parameter.bound)
        }
        Quantity::Word(words) => word(node, words).map(|word| (Value::Word(word), None)),
        Quantity::Table => table(node, folder),
        quantity => {
            let measure = measure(quantity, before).ok_or_else(|| {
                Wrong::from(
                    "its unit depends on the exponent, which has to be set first".to_owned(),
                )
            })?;
            bounded(dimensional(node, &measure)?, parameter.bound)
        }
    }
}

/// What a quantity with a unit is called and measured in; `None` if that follows from another
/// parameter that is not known.
pub(super) fn measure(quantity: Quantity, values: &Values) -> Option<Measure> {
    match quantity {
        Quantity::Length => Some(Measure::LENGTH),
        Quantity::Force => Some(Measure::FORCE),
        Quantity::Pressure => Some(Measure::PRESSURE),
        Quantity::Curvature => Some(Measure::length_to_the(-1.0)),
        Quantity::WearCoefficient => Some(Measure::WEAR_COEFFICIENT),
        Quantity::PowerFactor { exponent } => {
            values.number(exponent).map(|exponent| Measure::length_to_the(1.0 - exponent))
        }
        Quantity::Number | Quantity::Count | Quantity::Word(_) | Quantity::Table => None,
    }
}

/// A text with its unit.
fn dimensional(node: &Node, measure: &Measure) -> Result<f64, Wrong> {
    let (text, quoted) = match &node.item {
        Item::Text(text) => (text, true),
        Item::Number { text, .. } => (text, false),
        other => {
            let (name, example) = (&measure.name, &measure.example);
            return Err(format!(
                "expected {name} (for example \"{example}\"), found {}",
                other.kind()
            )
            .into());
        }
    };
    units::read(text, measure).map_err(|error| Wrong {
        help: (!quoted && matches!(error, units::Error::NoUnit { .. }))
            .then(|| "a value with a dimension is written with its unit, in quotes".to_owned()),
        message: error.to_string(),
    })
}

/// A number without unit: its text, its value, and whether it is written as a whole number.
fn number(node: &Node) -> Result<(&str, f64, bool), Wrong> {
    match &node.item {
        Item::Number { text, value, whole } => Ok((text, *value, *whole)),
        Item::Text(text) => {
            Err(format!("expected a number without unit or quotes, found \"{text}\"").into())
        }
        other => Err(format!("expected a number, found {}", other.kind()).into()),
    }
}

fn bounded(value: f64, bound: Bound) -> Result<(Value, Option<PathBuf>), Wrong> {
    if !value.is_finite() {
        return Err(format!("must be a finite number, not {value}").into());
    }
    if !bound.admits(value) {
        return Err(format!("must be {bound}").into());
    }
    Ok((Value::Number(value), None))
}

fn word(node: &Node, words: &[&str]) -> Result<String, Wrong> {
    let list = || words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(" or ");
    match &node.item {
        Item::Text(text) if words.contains(&text.as_str()) => Ok(text.clone()),
        Item::Text(text) => Err(format!("expected {}, found \"{text}\"", list()).into()),
        other => Err(format!("expected {}, found {}", list(), other.kind()).into()),
    }
}

/// The columns of the file a node names.
fn table(node: &Node, folder: &Path) -> Result<(Value, Option<PathBuf>), Wrong> {
    let Item::Text(name) = &node.item else {
        return Err(format!("expected the name of a CSV file, found {}", node.item.kind()).into());
    };
    let path = folder.join(name);
    let columns = columns::read(&path).map_err(|error| Wrong {
        help: (!path.exists()).then(|| {
            "a file is looked for from the folder of the case on, in options too".to_owned()
        }),
        message: error.to_string(),
    })?;
    // A resolved case is stored elsewhere and must still find the file.
    let path = std::path::absolute(&path).unwrap_or(path);
    Ok((Value::Table(columns), Some(path)))
}
