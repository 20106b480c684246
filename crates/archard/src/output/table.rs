//! A CSV file that grows row by row.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use super::Error;

/// A CSV file, on the disk up to its last finished row after every `flush`.
#[derive(Debug)]
pub(super) struct Table {
    path: PathBuf,
    writer: csv::Writer<File>,
    headed: bool,
}

impl Table {
    /// An empty table; the first row gives it its header.
    pub(super) fn create(path: PathBuf) -> Result<Self, Error> {
        match File::create(&path) {
            Ok(file) => Ok(Self { path, writer: csv::Writer::from_writer(file), headed: false }),
            Err(source) => Err(Error::Write { path, source }),
        }
    }

    /// Adds a row of cells, each under its column's name.
    pub(super) fn row(&mut self, cells: &[(&str, String)]) -> Result<(), Error> {
        if !self.headed {
            let header = self.writer.write_record(cells.iter().map(|cell| cell.0));
            header.map_err(|error| refused(&self.path, error))?;
            self.headed = true;
        }
        let record = self.writer.write_record(cells.iter().map(|cell| &cell.1));
        record.map_err(|error| refused(&self.path, error))
    }

    /// Brings all rows to the disk.
    pub(super) fn flush(&mut self) -> Result<(), Error> {
        self.writer.flush().map_err(|source| Error::Write { path: self.path.clone(), source })
    }
}

/// The error of a row that could not be written.
fn refused(path: &Path, error: csv::Error) -> Error {
    Error::Write { path: path.to_owned(), source: io::Error::from(error) }
}

/// A number with all its digits; empty where there is none.
pub(super) fn number(value: f64) -> String {
    if value.is_nan() {
        String::new()
    } else if value == value.trunc() && value.abs() < 1e15 {
        format!("{value}")
    } else {
        format!("{value:?}")
    }
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_keep_every_digit() {
        for value in [0.1 + 0.2, 1.33e-13, 2.190547e8, -5e-324, 1e300, 12.0] {
            assert_eq!(number(value).parse::<f64>().unwrap(), value);
        }
        assert_eq!(number(f64::NAN), "");
        assert_eq!(number(12.0), "12");
        assert_eq!(number(1.5e-7), "1.5e-7");
    }
}
