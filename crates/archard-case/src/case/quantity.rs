//! Reads one value as the quantity its declaration asks for.

use std::ffi::OsStr;
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::columns;
use super::reader::Line;
use super::tree::{Item, Node};
use crate::files::{self, Contents};
use archard::parameters::{Columns, Parameter, Quantity, Value, Values};
use archard::units::{self, Measure};
use archard_surface::file::Format;

/// Why a value cannot be read.
pub(super) struct Wrong {
    pub message: String,
    pub help: Option<String>,
    /// The bytes of the text that it is about; `None` for all of it.
    pub within: Option<Box<Range<usize>>>,
}

impl From<String> for Wrong {
    fn from(message: String) -> Self {
        Self { message, help: None, within: None }
    }
}

/// Where a value stands.
#[derive(Debug, Clone, Copy)]
pub(super) struct Surroundings<'a> {
    /// Where relative file names begin.
    pub folder: &'a Path,
    /// The line of contact, if the case has one.
    pub line: Option<Line>,
    /// The area (m^2) that repeats itself; loads are mean pressures on it, too.
    pub cell: Option<f64>,
}

/// The value in SI and, for a table, the file it came from. `before` holds the values already read.
pub(super) fn read(
    node: &Node,
    parameter: &Parameter,
    before: &Values,
    surroundings: &Surroundings<'_>,
) -> Result<(Value, Option<PathBuf>), Wrong> {
    match parameter.quantity {
        // The reader of tables knows the bodies.
        Quantity::Body => text(node).map(|text| (Value::Word(text), None)),
        Quantity::Number => {
            let (_, value, _) = number(node)?;
            bounded(value, parameter)
        }
        Quantity::Count => {
            let (text, value, whole) = number(node)?;
            if !whole || value < 0.0 {
                return Err(format!("expected a whole number, found {text}").into());
            }
            bounded(value, parameter)
        }
        Quantity::Truth => match node.item {
            Item::Boolean(said) => Ok((Value::Truth(said), None)),
            ref other => Err(format!("expected true or false, found {}", other.kind()).into()),
        },
        Quantity::Word(words) => word(node, words).map(|word| (Value::Word(word), None)),
        Quantity::Table(columns) => {
            let loads = columns.iter().any(|(_, quantity)| *quantity == Quantity::Force);
            if loads && surroundings.line.is_some_and(|line| line.length.is_none()) {
                return Err(
                    "the forces in a file are in N: give the line of contact a `frame.length`"
                        .to_owned()
                        .into(),
                );
            }
            table(node, surroundings.folder, columns)
        }
        Quantity::File => file(node, surroundings.folder),
        // The reader of tables has gone into one.
        Quantity::Text | Quantity::TextOr(_) => text(node).map(|text| (Value::Word(text), None)),
        Quantity::Formula => match &node.item {
            Item::Text(text) => formula(text, surroundings.folder).map(|value| (value, None)),
            other => Err(format!("expected a formula in quotes, found {}", other.kind()).into()),
        },
        Quantity::Pair(quantity) => {
            let along = "two values, along x and y";
            let parameter = Parameter { quantity: *quantity, ..*parameter };
            Ok((Value::Pair(several(node, &parameter, along, surroundings)?), None))
        }
        Quantity::Triple(quantity) => {
            let along = "three values, along x, y and z";
            let parameter = Parameter { quantity: *quantity, ..*parameter };
            Ok((Value::Triple(several(node, &parameter, along, surroundings)?), None))
        }
        Quantity::OneOrThree(quantity) => {
            let quantity = match node.item {
                Item::Array(_) => Quantity::Triple(quantity),
                _ => *quantity,
            };
            read(node, &Parameter { quantity, ..*parameter }, before, surroundings)
        }
        // The reader of tables has gone into them.
        Quantity::Section(_) | Quantity::Constants => {
            Err(format!("expected a table, found {}", node.item.kind()).into())
        }
        quantity => {
            let measure = measure(quantity, before).ok_or_else(|| {
                Wrong::from(
                    "its unit depends on the exponent, which has to be set first".to_owned(),
                )
            })?;
            // A factor whose exponent has left no unit.
            let plain = if measure == Measure::NUMBER { plain(node) } else { None };
            let cell = surroundings.cell.filter(|_| quantity == Quantity::Force);
            let mean =
                cell.and_then(|cell| Some(cell * dimensional(node, &Measure::PRESSURE).ok()?));
            let value = match (plain.or(mean), quantity, surroundings.line) {
                (Some(value), ..) => value,
                (None, Quantity::Force, Some(line)) => on_a_line(node, line)?,
                (None, Quantity::Force, None) => off_a_line(node)?,
                _ => dimensional(node, &measure)?,
            };
            bounded(value, parameter)
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
        Quantity::Angle => Some(Measure::ANGLE),
        Quantity::Time => Some(Measure::TIME),
        Quantity::Speed => Some(Measure::SPEED),
        Quantity::Frequency => Some(Measure::FREQUENCY),
        Quantity::Temperature => Some(Measure::TEMPERATURE),
        Quantity::WearCoefficient => Some(Measure::WEAR_COEFFICIENT),
        Quantity::Measured { name, unit } => Measure::in_si(name, unit),
        Quantity::PowerFactor { exponent } => values.number(exponent).map(|exponent| {
            if exponent == 1.0 { Measure::NUMBER } else { Measure::length_to_the(1.0 - exponent) }
        }),
        Quantity::Pair(quantity) | Quantity::Triple(quantity) | Quantity::OneOrThree(quantity) => {
            measure(*quantity, values)
        }
        Quantity::Number
        | Quantity::Count
        | Quantity::Body
        | Quantity::Text
        | Quantity::TextOr(_)
        | Quantity::Truth
        | Quantity::Formula
        | Quantity::Constants
        | Quantity::Word(_)
        | Quantity::Table(_)
        | Quantity::File
        | Quantity::Section(_) => None,
    }
}

/// A force (N) on a line of contact, given per length or shared over the length that is given.
fn on_a_line(node: &Node, line: Line) -> Result<f64, Wrong> {
    if let Ok(load) = dimensional(node, &Measure::LOAD_PER_LENGTH) {
        return Ok(load * line.length());
    }
    match (line.length, dimensional(node, &Measure::FORCE)) {
        (Some(_), force) => force,
        (None, Ok(_)) => Err(Wrong {
            message: "a line of contact has loads per length, like \"18.5 N/mm\"".to_owned(),
            help: Some("or give `frame.length`, which loads in N are shared over".to_owned()),
            within: None,
        }),
        (None, Err(_)) => dimensional(node, &Measure::LOAD_PER_LENGTH),
    }
}

/// A force (N) on a frame that is no line of contact.
fn off_a_line(node: &Node) -> Result<f64, Wrong> {
    let force = dimensional(node, &Measure::FORCE);
    if force.is_err() && dimensional(node, &Measure::LOAD_PER_LENGTH).is_ok() {
        return Err(Wrong {
            message: "a load per length is one of a line of contact; here loads are in N"
                .to_owned(),
            help: Some("`frame.plane_strain = true` makes the frame a line of contact".to_owned()),
            within: None,
        });
    }
    force
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
        within: None,
    })
}

/// A number without unit, in quotes or without.
fn plain(node: &Node) -> Option<f64> {
    match &node.item {
        Item::Number { value, .. } => Some(*value),
        Item::Text(text) => text.trim().parse().ok(),
        _ => None,
    }
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

fn bounded(value: f64, parameter: &Parameter) -> Result<(Value, Option<PathBuf>), Wrong> {
    let value = parameter.admit(value).map_err(|invalid| invalid.message)?;
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

/// Some values of one quantity in a list.
fn several<const N: usize>(
    node: &Node,
    parameter: &Parameter,
    along: &str,
    surroundings: &Surroundings<'_>,
) -> Result<[f64; N], Wrong> {
    let expected = || {
        let example = measure(parameter.quantity, &Values::default())
            .map_or("1".to_owned(), |measure| format!("\"{}\"", measure.example));
        format!("expected {along}, like [{}]", [&*example; N].join(", "))
    };
    let nodes = match &node.item {
        Item::Array(nodes) if nodes.len() == N => nodes,
        Item::Array(nodes) => return Err(format!("{}, found {}", expected(), nodes.len()).into()),
        other => return Err(format!("{}, found {}", expected(), other.kind()).into()),
    };
    let mut values = [0.0; N];
    for (value, node) in values.iter_mut().zip(nodes) {
        if let (Value::Number(number), _) = read(node, parameter, &Values::default(), surroundings)?
        {
            *value = number;
        }
    }
    Ok(values)
}

/// A name.
fn text(node: &Node) -> Result<String, Wrong> {
    match &node.item {
        Item::Text(text) if !text.is_empty() => Ok(text.clone()),
        Item::Text(_) => Err("expected a name, found nothing between the quotes".to_owned().into()),
        other => Err(format!("expected a name in quotes, found {}", other.kind()).into()),
    }
}

/// A number, or text with a unit, as text; equal numbers give the same text however they are written.
pub(super) fn constant(node: &Node) -> Result<String, Wrong> {
    let value = plain(node).filter(|value| value.is_finite());
    match (value, &node.item) {
        (Some(value), _) => Ok(format!("{value:e}")),
        (None, Item::Number { text, .. }) => {
            Err(format!("must be a finite number, not {text}").into())
        }
        (None, Item::Text(text)) => Ok(text.clone()),
        (None, other) => {
            Err(format!("expected a number, or text with a unit, found {}", other.kind()).into())
        }
    }
}

/// What messages say besides a file that is not there.
fn help(path: &Path) -> Option<String> {
    let help = "a file is looked for from the folder of the case on, in options too";
    (!path.exists()).then(|| help.to_owned())
}

/// The bytes of the file a node names.
fn file(node: &Node, folder: &Path) -> Result<(Value, Option<PathBuf>), Wrong> {
    let Item::Text(name) = &node.item else {
        return Err(format!("expected the name of a file, found {}", node.item.kind()).into());
    };
    let path = folder.join(name);
    // Surfaces in bytes take little more than their file; they are the largest of all.
    let extension = path.extension().and_then(OsStr::to_str).unwrap_or_default();
    let contents = match Format::of_extension(extension) {
        None | Some(Format::Text | Format::Sdf) => Contents::Text,
        Some(_) => Contents::Numbers,
    };
    let bytes = files::read(&path, contents).map_err(|cause| Wrong {
        help: help(&path),
        message: format!("cannot read {}: {cause}", path.display()),
        within: None,
    })?;
    // A resolved case is stored elsewhere and must still find the file.
    let path = std::path::absolute(&path).unwrap_or(path);
    Ok((Value::File { name: name.clone(), bytes: bytes.into() }, Some(path)))
}

/// A formula with the columns of the files that it names in quotes.
fn formula(text: &str, folder: &Path) -> Result<Value, Wrong> {
    let mut files: Vec<Columns> = vec![];
    let mut rest = 0;
    while let Some(open) = text[rest..].find(['"', '\'']).map(|at| rest + at) {
        let quote = if text[open..].starts_with('"') { '"' } else { '\'' };
        // What is not closed the reader of formulas says.
        let Some(length) = text[open + 1..].find(quote) else { break };
        let name = &text[open + 1..open + 1 + length];
        rest = open + length + 2;
        if files.iter().any(|known| known.file == name) {
            continue;
        }
        let path = folder.join(name);
        let columns = columns::read_any(&path).map_err(|error| Wrong {
            help: help(&path),
            message: error.to_string(),
            within: Some(Box::new(open..rest)),
        })?;
        let path = std::path::absolute(&path).unwrap_or(path).display().to_string();
        files.push(Columns { file: name.to_owned(), path, columns });
    }
    Ok(Value::Formula { text: text.to_owned(), files })
}

/// The columns of the file a node names.
fn table(
    node: &Node,
    folder: &Path,
    known: &[(&str, Quantity)],
) -> Result<(Value, Option<PathBuf>), Wrong> {
    let Item::Text(name) = &node.item else {
        return Err(format!("expected the name of a CSV file, found {}", node.item.kind()).into());
    };
    let path = folder.join(name);
    let columns = columns::read(&path, known).map_err(|error| Wrong {
        help: help(&path),
        message: error.to_string(),
        within: None,
    })?;
    // A resolved case is stored elsewhere and must still find the file.
    let path = std::path::absolute(&path).unwrap_or(path);
    Ok((Value::Table(columns), Some(path)))
}

#[cfg(test)]
mod tests {
    use super::measure;
    use crate::case::surface::profiles;
    use archard::body::Thermal;
    use archard::body::mesh::MESHES;
    use archard::friction::FRICTION;
    use archard::motion::MOTIONS;
    use archard::parameters::{Choice, Parameter, Quantity, Values};
    use archard::solve::SOLVERS;
    use archard::solve::tangential::FRICTION_SOLVERS;
    use archard::wear::WEAR_LAWS;

    fn declared<T>(choices: &'static [Choice<T>]) -> impl Iterator<Item = Parameter> {
        choices.iter().flat_map(|choice| choice.parameters).copied()
    }

    /// The unit that a parameter brings along is one.
    #[test]
    fn units_of_parameters_can_be_read() {
        let parameters = declared(profiles())
            .chain(declared(MESHES))
            .chain(declared(WEAR_LAWS))
            .chain(declared(FRICTION))
            .chain(declared(MOTIONS))
            .chain(declared(SOLVERS))
            .chain(declared(FRICTION_SOLVERS));
        let example = Parameter::required(
            "threshold",
            Quantity::Measured { name: "a work per area", unit: "J/m^2" },
            "an example",
        );
        let thermal = Thermal::PARAMETERS.iter().copied();
        for parameter in parameters.chain([example]).chain(thermal) {
            if let Quantity::Measured { .. } = parameter.quantity {
                let known = measure(parameter.quantity, &Values::default());
                assert!(known.is_some(), "{parameter:?}");
            }
        }
    }
}
