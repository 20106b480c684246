//! A CSV file that grows row by row.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::{Error, Place, limit};

/// A CSV file. Every `flush` hands its rows to the system in one piece; where that fails, the file is cut back to the
/// rows it had.
#[derive(Debug)]
pub(super) struct Table {
    path: PathBuf,
    file: File,
    /// Rows that are not in the file yet.
    rows: csv::Writer<Vec<u8>>,
    /// Length of the file (bytes).
    length: u64,
    headed: bool,
}

/// What a table was, to go on with it.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(super) struct Kept {
    length: u64,
    headed: bool,
}

impl Kept {
    /// Says whether a file still has the rows that it had.
    ///
    /// # Errors
    /// If it is not there, or shorter.
    pub(super) fn find(self, path: &Path) -> Result<(), Error> {
        let found = fs::symlink_metadata(path).and_then(|known| {
            if known.is_file() && known.len() >= self.length {
                return Ok(());
            }
            Err(io::Error::other("it is shorter than it was, or no file; start the run anew"))
        });
        found.map_err(|source| Error::Read { path: path.to_owned(), source })
    }
}

impl Table {
    /// What is in the file now, brought to the disk.
    pub(super) fn keep(&self) -> Result<Kept, Error> {
        self.sync()?;
        Ok(Kept { length: self.length, headed: self.headed })
    }

    /// A table as it was kept, once it [was found](Kept::find); rows that were added since are cut off.
    pub(super) fn resume(place: Place, Kept { length, headed }: Kept) -> Result<Self, Error> {
        let path = place.into_path();
        let opened = OpenOptions::new().append(true).open(&path).and_then(|file| {
            file.set_len(length)?;
            Ok(file)
        });
        match opened {
            Ok(file) => Ok(Self { path, file, rows: no_rows(), length, headed }),
            Err(source) => Err(Error::Write { path, source }),
        }
    }

    /// An empty table where no file is; the first row gives it its header.
    pub(super) fn create(place: Place) -> Result<Self, Error> {
        let path = place.into_path();
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => Ok(Self { path, file, rows: no_rows(), length: 0, headed: false }),
            Err(source) => Err(Error::Write { path, source }),
        }
    }

    /// Adds a row of cells, each under its column's name.
    pub(super) fn row(&mut self, cells: &[(&str, String)]) -> Result<(), Error> {
        if !self.headed {
            let header = self.rows.write_record(cells.iter().map(|cell| cell.0));
            header.map_err(|error| refused(&self.path, error))?;
            self.headed = true;
        }
        let record = self.rows.write_record(cells.iter().map(|cell| &cell.1));
        record.map_err(|error| refused(&self.path, error))
    }

    /// Hands all rows to the system.
    pub(super) fn flush(&mut self) -> Result<(), Error> {
        self.append().map_err(|source| Error::Write { path: self.path.clone(), source })
    }

    fn append(&mut self) -> io::Result<()> {
        let rows = std::mem::replace(&mut self.rows, no_rows());
        let bytes = rows.into_inner().map_err(|error| io::Error::other(error.to_string()))?;
        let length = self.length + bytes.len() as u64;
        limit::admit(length)?;
        if let Err(error) = self.file.write_all(&bytes) {
            // Half a row may be there. A failure to cut it off adds nothing to the one that is told.
            let _ = self.file.set_len(self.length);
            return Err(error);
        }
        self.length = length;
        Ok(())
    }

    /// Brings the file to the disk, and says whether it still is where it was made.
    pub(super) fn sync(&self) -> Result<(), Error> {
        let refused = |source| Error::Write { path: self.path.clone(), source };
        self.file.sync_all().map_err(refused)?;
        self.find()
    }

    /// Says whether the file still is where it was made: rows of one that was removed are lost without an error.
    pub(super) fn find(&self) -> Result<(), Error> {
        match self.path.try_exists() {
            Ok(false) => Err(Error::Removed { path: self.path.clone() }),
            Ok(true) | Err(_) => Ok(()),
        }
    }
}

/// A place for rows.
fn no_rows() -> csv::Writer<Vec<u8>> {
    csv::Writer::from_writer(Vec::new())
}

/// The error of a row that could not be written.
fn refused(path: &Path, error: csv::Error) -> Error {
    Error::Write { path: path.to_owned(), source: io::Error::from(error) }
}

/// A number with all its digits; empty where none exists.
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
    use std::fs::{self, File};

    use super::{Table, number};
    use crate::output::{Error, Place};

    #[test]
    fn numbers_keep_every_digit() {
        for value in [0.1 + 0.2, 1.33e-13, 2.190547e8, -5e-324, 1e300, 12.0] {
            assert_eq!(number(value).parse::<f64>().unwrap(), value);
        }
        assert_eq!(number(f64::NAN), "");
        assert_eq!(number(12.0), "12");
        assert_eq!(number(1.5e-7), "1.5e-7");
    }

    #[test]
    fn a_table_that_was_removed_says_so() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("history.csv");
        let mut table = Table::create(Place::known(path.clone())).unwrap();
        table.row(&[("load_N", "1".to_owned())]).unwrap();
        table.flush().unwrap();
        table.find().unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "load_N\n1\n");
        fs::remove_file(&path).unwrap();
        assert!(matches!(table.find(), Err(Error::Removed { .. })));
        assert!(matches!(table.sync(), Err(Error::Removed { .. })));
    }

    /// A row that cannot be written is no part of the file and does not turn up later.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let mut table = Table::create(Place::known(folder.path().join("history.csv"))).unwrap();
        table.row(&[("load_N", "1".to_owned())]).unwrap();
        table.flush().unwrap();
        let file = std::mem::replace(&mut table.file, File::create("/dev/full").unwrap());
        table.row(&[("load_N", "2".to_owned())]).unwrap();
        let error = table.flush().unwrap_err();
        assert!(error.to_string().contains("history.csv"), "{error}");
        table.file = file;
        table.row(&[("load_N", "3".to_owned())]).unwrap();
        table.flush().unwrap();
        let text = fs::read_to_string(folder.path().join("history.csv")).unwrap();
        assert_eq!(text, "load_N\n1\n3\n");
    }
}
