//! Columns out of a CSV file whose header names them with their units.

use std::io::Cursor;
use std::path::{Path, PathBuf};

use super::quantity::measure;
use crate::files::{self, Contents};
use crate::parameters::{Column, Quantity, Values};
use crate::units::{self, Measure, Scale};

/// Why a file of columns cannot be read.
#[derive(Debug, thiserror::Error)]
pub(super) enum Error {
    #[error("cannot read {}: {cause}", .file.display())]
    Unreadable { file: PathBuf, cause: csv::Error },
    #[error("{}: the column `{column}` has no unit: name it like `x_mm` or `x (mm)`", .file.display())]
    NoUnit { file: PathBuf, column: String },
    #[error("{}: the column `{column}`: {cause}", .file.display())]
    WrongUnit { file: PathBuf, column: String, cause: Box<units::Error> },
    #[error("{}: the column `{column}` is there twice", .file.display())]
    Twice { file: PathBuf, column: String },
    #[error(
        "{}, line {line}: expected {expected} values, found {found}",
        .file.display()
    )]
    Ragged { file: PathBuf, line: u64, expected: usize, found: usize },
    #[error("{}, line {line}: `{text}` in the column `{column}` is not a finite number", .file.display())]
    NotANumber { file: PathBuf, line: u64, column: String, text: String },
    #[error("{}, line {line}: {value:e} in the column `{column}` (SI) is too large to compute with", .file.display())]
    TooLarge { file: PathBuf, line: u64, column: String, value: f64 },
    #[error("{}: there is nothing below the header", .file.display())]
    Empty { file: PathBuf },
}

/// Named columns (SI).
type Columns = Vec<(String, Vec<f64>)>;

/// Reads the columns of a file (SI): those of known names as what they are, others as lengths.
pub(super) fn read(path: &Path, known: &[(&str, Quantity)]) -> Result<Columns, Error> {
    let (reader, titles) = begin(path)?;
    let headings = titles.iter().map(|title| heading(title, path, known));
    rows((path, reader), headings.collect::<Result<_, _>>()?, &|name| quantity(name, known))
}

/// A reader of the bytes of a table.
type Reader = csv::Reader<Cursor<Vec<u8>>>;

/// A reader of a table, at its first row, and the titles of the columns.
fn begin(path: &Path) -> Result<(Reader, csv::StringRecord), Error> {
    let unreadable = |cause| Error::Unreadable { file: path.to_owned(), cause };
    let bytes = files::read(path, Contents::Text).map_err(|cause| unreadable(cause.into()))?;
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .flexible(true)
        .from_reader(Cursor::new(bytes));
    let titles = reader.headers().map_err(unreadable)?.clone();
    Ok((reader, titles))
}

/// The numbers below headings, each a name and its unit; what a column of a name holds bounds its size.
fn rows(
    (path, mut reader): (&Path, Reader),
    headings: Vec<(String, Scale)>,
    quantity: &dyn Fn(&str) -> Quantity,
) -> Result<Columns, Error> {
    let file = || path.to_owned();
    let (mut columns, mut scales): (Columns, Vec<Scale>) = (vec![], vec![]);
    for (name, scale) in headings {
        if columns.iter().any(|(known, _)| *known == name) {
            return Err(Error::Twice { file: file(), column: name });
        }
        columns.push((name, vec![]));
        scales.push(scale);
    }
    let unreadable = |cause| Error::Unreadable { file: file(), cause };
    for record in reader.records() {
        let record = record.map_err(unreadable)?;
        let line = record.position().map_or(0, csv::Position::line);
        if record.len() != columns.len() {
            let (expected, found) = (columns.len(), record.len());
            return Err(Error::Ragged { file: file(), line, expected, found });
        }
        for ((text, scale), (name, values)) in record.iter().zip(&scales).zip(&mut columns) {
            let value = scale.apply(text).ok_or_else(|| Error::NotANumber {
                file: file(),
                line,
                column: name.clone(),
                text: text.to_owned(),
            })?;
            if value.abs() > quantity(name).range()[1] {
                return Err(Error::TooLarge { file: file(), line, column: name.clone(), value });
            }
            values.push(value);
        }
    }
    match columns.first() {
        Some((_, values)) if !values.is_empty() => Ok(columns),
        _ => Err(Error::Empty { file: file() }),
    }
}

/// Reads the columns of a file (SI), whatever their units measure.
pub(super) fn read_any(path: &Path) -> Result<Vec<Column>, Error> {
    let (reader, titles) = begin(path)?;
    let headings: Vec<(String, Scale, String)> =
        titles.iter().map(|title| any_heading(title, path)).collect::<Result<_, _>>()?;
    let scales = headings.iter().map(|(name, scale, _)| (name.clone(), scale.clone())).collect();
    let columns = rows((path, reader), scales, &|_| Quantity::Number)?;
    let units = headings.into_iter().map(|(_, _, unit)| unit);
    let column = |((name, values), unit)| Column { name, unit, values };
    Ok(columns.into_iter().zip(units).map(column).collect())
}

/// The name and the unit of a column titled `p_MPa`, `p (MPa)` or `p [MPa]`; without a unit it is a pure number.
fn any_heading(title: &str, path: &Path) -> Result<(String, Scale, String), Error> {
    let title = title.trim_start_matches('\u{feff}').trim();
    let at = title.find(['(', '[']).or_else(|| title.rfind('_')).unwrap_or(title.len());
    let unit = title[at..].trim_start_matches(['_', '(', '[']).trim_end_matches(']');
    let unit =
        if title[at..].starts_with('(') { unit.strip_suffix(')').unwrap_or(unit) } else { unit };
    let unit = if unit.is_empty() { "1" } else { unit };
    let (scale, _) = Scale::read_any(unit).map_err(|cause| Error::WrongUnit {
        file: path.to_owned(),
        column: title.to_owned(),
        cause: Box::new(cause),
    })?;
    Ok((title[..at].trim().to_lowercase(), scale, unit.to_owned()))
}

/// What a column of that name holds.
fn quantity(name: &str, known: &[(&str, Quantity)]) -> Quantity {
    known
        .iter()
        .find(|(known, _)| *known == name)
        .map_or(Quantity::Length, |(_, quantity)| *quantity)
}

/// The name and the unit of a column titled `x_mm`, `x (mm)` or `x [mm]`; one without a dimension needs
/// no unit.
fn heading(title: &str, path: &Path, known: &[(&str, Quantity)]) -> Result<(String, Scale), Error> {
    let title = title.trim_start_matches('\u{feff}').trim();
    let lower = title.to_lowercase();
    let named = known.iter().filter(|(name, _)| lower.starts_with(name));
    let named = named.max_by_key(|(name, _)| name.len());
    let split = match named {
        Some((name, _)) => Some((&title[..name.len()], title[name.len()..].trim())),
        None => title
            .find(['(', '['])
            .or_else(|| title.find('_'))
            .map(|at| (&title[..at], &title[at..])),
    };
    let measure = match named {
        Some((_, quantity)) => measure(*quantity, &Values::default()).unwrap_or(Measure::NUMBER),
        None => Measure::LENGTH,
    };
    let (name, unit) = split.unwrap_or((title, ""));
    let unit = match unit.strip_prefix(['(', '[']) {
        Some(unit) => unit.strip_suffix([')', ']']).unwrap_or(unit),
        None => unit.strip_prefix('_').unwrap_or(unit),
    };
    if unit.is_empty() && measure != Measure::NUMBER {
        return Err(Error::NoUnit { file: path.to_owned(), column: title.to_owned() });
    }
    let unit = if unit.is_empty() { "1" } else { unit };
    let scale = Scale::read(unit, &measure).map_err(|cause| Error::WrongUnit {
        file: path.to_owned(),
        column: title.to_owned(),
        cause: Box::new(cause),
    })?;
    Ok((name.trim().to_lowercase(), scale))
}

#[cfg(test)]
mod tests {
    use super::read;

    /// What reading a file of that text gives, the folder cut from the message.
    fn read_text(text: &str) -> Result<Vec<(String, Vec<f64>)>, String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("pin.csv");
        std::fs::write(&path, text).unwrap();
        let prefix = format!("{}/", folder.path().display());
        read(&path, &[]).map_err(|error| error.to_string().replace(&prefix, ""))
    }

    #[test]
    fn headers_carry_units_in_three_notations() {
        let expected = vec![("x".to_owned(), vec![0.45e-3]), ("z".to_owned(), vec![-1.2e-6])];
        for header in ["x_mm,z_um", "x (mm), z [um]", "\u{feff}X_mm,z (\u{b5}m)"] {
            let text = format!("{header}\n# measured\n0.45, -1.2\n");
            assert_eq!(read_text(&text).as_ref(), Ok(&expected), "{header}");
        }
    }

    #[test]
    fn errors_name_the_line_and_the_column() {
        let error = |text| read_text(text).unwrap_err();
        assert_eq!(
            error("x_mm,z_um\n0,1\n1,nan\n"),
            "pin.csv, line 3: `nan` in the column `z` is not a finite number"
        );
        assert_eq!(error("x_mm,z_um\n0\n"), "pin.csv, line 2: expected 2 values, found 1");
        assert_eq!(
            error("x,z_um\n0,1\n"),
            "pin.csv: the column `x` has no unit: name it like `x_mm` or `x (mm)`"
        );
        assert!(error("x_mm,z_N\n0,1\n").contains("expected a length"));
        assert_eq!(
            error("x_mm,z_m\n0,1\n1,1e300\n"),
            "pin.csv, line 3: 1e300 in the column `z` (SI) is too large to compute with"
        );
        assert_eq!(error("x_mm,z_um\n"), "pin.csv: there is nothing below the header");
        assert_eq!(error("x_mm,x_um\n0,1\n"), "pin.csv: the column `x` is there twice");
    }
}
