//! Columns out of a table whose header names them with their units: a [`measured::Table`](crate::measured::Table).

use std::io;
use std::path::{Path, PathBuf};

use super::quantity::measure;
use crate::files::{self, Contents};
use crate::measured::{self, Table};
use archard::parameters::{Column, Quantity, Values};
use archard::units::Measure;

/// Why a file of columns cannot be read.
#[derive(Debug, thiserror::Error)]
pub(super) enum Error {
    #[error("cannot read {}: {cause}", .file.display())]
    Unreadable { file: PathBuf, cause: io::Error },
    #[error(transparent)]
    Table(#[from] measured::Error),
}

/// Named columns (SI).
type Columns = Vec<(String, Vec<f64>)>;

/// Reads the columns of a file (SI): those of known names as what they are, others as lengths.
pub(super) fn read(path: &Path, known: &[(&str, Quantity)]) -> Result<Columns, Error> {
    let table = table(path)?;
    let column = |name: &str| {
        let quantity = quantity(name, known);
        let measure = measure(quantity, &Values::default()).unwrap_or(Measure::NUMBER);
        let values = table.all_numbers(name, &measure)?;
        table.hold(name, &values, quantity)?;
        Ok((name.to_owned(), values))
    };
    table.names().map(column).collect()
}

/// Reads the columns of a file (SI), whatever their units measure.
pub(super) fn read_any(path: &Path) -> Result<Vec<Column>, Error> {
    let table = table(path)?;
    let columns = table.columns()?.into_iter();
    Ok(columns.map(|(name, unit, values)| Column { name, unit, values }).collect())
}

fn table(path: &Path) -> Result<Table, Error> {
    let unreadable = |cause| Error::Unreadable { file: path.to_owned(), cause };
    let bytes = files::read(path, Contents::Text).map_err(unreadable)?;
    Ok(Table::read(&path.display().to_string(), &bytes)?)
}

/// What a column of that name holds.
fn quantity(name: &str, known: &[(&str, Quantity)]) -> Quantity {
    known
        .iter()
        .find(|(known, _)| *known == name)
        .map_or(Quantity::Length, |(_, quantity)| *quantity)
}

#[cfg(test)]
mod tests {
    use super::read;
    use archard::parameters::Quantity;

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

    /// What spreadsheets write where commas are decimal signs, and in the encodings they write it in.
    #[test]
    fn tables_of_spreadsheets_are_read() {
        let expected = vec![("x".to_owned(), vec![0.45e-3]), ("z".to_owned(), vec![-1.2e-6])];
        for separator in [";", "\t"] {
            let text = format!("x [mm]{separator}z / \u{b5}m\r\n0,45{separator}-1,2\r\n");
            assert_eq!(read_text(&text).as_ref(), Ok(&expected));
        }
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("latin.csv");
        std::fs::write(&path, b"x [mm];z [\xb5m]\n0,45;-1,2\n").unwrap();
        assert_eq!(read(&path, &[]).unwrap(), expected);
        let pressure = [("p", Quantity::Pressure)];
        std::fs::write(&path, b"p [MPa];k [mm\xb3/(N m)]\n1,5;2e-5\n").unwrap();
        let columns = super::read_any(&path).unwrap();
        assert_eq!(columns.iter().map(|own| own.values[0]).collect::<Vec<_>>(), [1.5e6, 2e-14]);
        std::fs::write(&path, b"p [MPa];z [mm]\n1,5;2\n").unwrap();
        let both = vec![("p".to_owned(), vec![1.5e6]), ("z".to_owned(), vec![2e-3])];
        assert_eq!(read(&path, &pressure).unwrap(), both);
    }

    #[test]
    fn errors_name_the_line_and_the_column() {
        let error = |text| read_text(text).unwrap_err();
        assert_eq!(
            error("x_mm,z_um\n0,1\n1,nan\n"),
            "pin.csv, line 3: `nan` in the column `z_um` is not a finite number; leave the cell empty where nothing was measured"
        );
        assert!(error("x_mm,z_um\n0\n").starts_with("pin.csv, line 2: expected 2 cells, found 1"));
        assert_eq!(
            error("x,z_um\n0,1\n"),
            "pin.csv: the column `x` has no unit: title it like `x [mm]`"
        );
        assert_eq!(
            error("x_mm,z_um\n0,1\n1,\n"),
            "pin.csv, line 3: the column `z` needs a value in every row"
        );
        assert!(error("x_mm,z_N\n0,1\n").contains("expected a length"));
        assert_eq!(
            error("x_mm,z_m\n0,1\n1,1e300\n"),
            "pin.csv, line 3: 1e300 in the column `z` (SI) is too large to compute with"
        );
        assert_eq!(error("x_mm,z_um\n"), "pin.csv: there is nothing below the header");
        assert!(error("x_mm,x_um\n0,1\n").contains("`x_mm` and `x_um` have one name"));
    }
}
