//! Tables of measured readings, as spreadsheets and instruments write them.
//!
//! A [`Table`] is a header and rows of cells, separated by commas, semicolons or tabs. A header names a column and its unit:
//! `Distance [mm]`, `depth (um)`, `Tiefe / µm` or `volume_mm3`. Numbers may have a decimal comma. Values are asked for by
//! name and measure and given in SI; an empty cell is a reading that was not taken. What is wrong is told with line, column
//! and the header that would do.
//!
//! A [`Surface`](surface::Surface) is a table of heights, and a [`Scar`](surface::Scar) what is worn off it.

mod cells;
mod error;
mod heading;
pub mod plane;
pub mod surface;
mod text;

pub use error::Error;
use heading::Heading;
use text::{decoded, separator};

use archard::parameters::Quantity;
use archard::units::{Measure, Scale};

/// A measured table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    source: String,
    headings: Vec<Heading>,
    rows: Vec<Row>,
}

/// A row: the line it stands on, and its cells.
#[derive(Debug, Clone, PartialEq)]
struct Row {
    line: u64,
    cells: Vec<String>,
}

/// The lines of a text, counted on from record to record: the reader says where it went on, not where the record stands, which
/// empty lines and comments may be before.
struct Lines<'a> {
    text: &'a str,
    byte: usize,
    line: u64,
}

impl Lines<'_> {
    /// The line (from one on) of the record that is read from that byte on.
    fn at(&mut self, byte: usize) -> u64 {
        let passed = self.text.get(self.byte..byte).unwrap_or_default();
        self.line += passed.matches('\n').count() as u64;
        self.byte = byte.max(self.byte);
        let rest = self.text.get(self.byte..).unwrap_or_default();
        let passed_over = rest.lines().take_while(|line| line.is_empty() || line.starts_with('#'));
        self.line + passed_over.count() as u64
    }
}

impl Table {
    /// Reads a table. Its text is UTF-8, UTF-16 with a byte order mark, or Latin-1; lines that begin with `#`, and rows
    /// without any value, are passed over. `source` is what messages call it.
    ///
    /// # Errors
    /// If there is no header or no row below it, two columns have one name, or a row has not as many cells as the header.
    pub fn read(source: &str, bytes: &[u8]) -> Result<Self, Error> {
        let text = decoded(bytes).replace("\r\n", "\n").replace('\r', "\n");
        let (source, separator) = (source.to_owned(), separator(&text));
        let mut reader = csv::ReaderBuilder::new()
            .delimiter(separator)
            .trim(csv::Trim::All)
            .comment(Some(b'#'))
            .flexible(true)
            .from_reader(text.as_bytes());
        let unreadable = |cause| Error::Unreadable { table: source.clone(), cause };
        let titles = reader.headers().map_err(unreadable)?.clone();
        if titles.iter().all(str::is_empty) {
            return Err(Error::NoHeader { table: source });
        }
        let headings: Vec<Heading> = titles.iter().map(Heading::of).collect();
        let mut rows = vec![];
        let mut lines = Lines { text: &text, byte: 0, line: 1 };
        for record in reader.records() {
            let record = record.map_err(unreadable)?;
            let line = lines.at(record.position().map_or(0, csv::Position::byte) as usize);
            if record.iter().all(str::is_empty) {
                continue;
            }
            if record.len() != headings.len() {
                let (expected, found) = (headings.len(), record.len());
                return Err(Error::Ragged { table: source, line, expected, found });
            }
            rows.push(Row { line, cells: record.iter().map(str::to_owned).collect() });
        }
        if rows.is_empty() {
            return Err(Error::Empty { table: source });
        }
        let table = Self { source, headings, rows };
        table.told_apart()?;
        table.one_decimal_sign(separator)?;
        Ok(table)
    }

    /// The same with other names for some columns: each pair is a name and the title, or the name, of the column meant. A name
    /// may end in the unit of a column whose title has none: `depth_um`.
    ///
    /// # Errors
    /// If there is no column of such a title, it has another unit, or two columns have one name then.
    pub fn naming(mut self, names: &[(&str, &str)]) -> Result<Self, Error> {
        for (name, title) in names {
            let table = self.source.clone();
            let Some(index) = self.headings.iter().position(|heading| heading.is(title)) else {
                let (title, titles) = ((*title).to_owned(), self.titles());
                return Err(Error::NoTitle { table, title, titles });
            };
            let heading = &mut self.headings[index];
            if !heading.rename(name) {
                let (title, name) = (heading.title.clone(), (*name).to_owned());
                return Err(Error::OtherUnit { table, title, name });
            }
        }
        self.told_apart()?;
        Ok(self)
    }

    /// The same with the rows, counted from zero, that are kept; lines stay those of the file.
    #[must_use]
    pub fn only(&self, keep: impl Fn(usize) -> bool) -> Self {
        let rows = self.rows.iter().enumerate().filter(|(row, _)| keep(*row));
        Self { rows: rows.map(|(_, row)| row.clone()).collect(), ..self.clone() }
    }

    /// What messages call the table.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is no row; no table that was read is without.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The line each row stands on.
    pub fn lines(&self) -> Vec<u64> {
        self.rows.iter().map(|row| row.line).collect()
    }

    /// The names of all columns.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.headings.iter().map(|heading| heading.name.as_str())
    }

    /// Whether a column has that title or name.
    pub fn has(&self, title: &str) -> bool {
        self.headings.iter().any(|heading| heading.is(title))
    }

    /// The titles of the columns of other names, which whoever asks for these names leaves out.
    pub fn others(&self, names: &[&str]) -> Vec<&str> {
        let other = |heading: &&Heading| !names.contains(&heading.name.as_str());
        self.headings.iter().filter(other).map(|heading| heading.title.as_str()).collect()
    }

    /// The texts in a column; `None` where none exists of that name.
    pub fn texts(&self, name: &str) -> Option<Vec<&str>> {
        let column = self.column(name)?;
        Some(self.rows.iter().map(|row| row.cells[column].as_str()).collect())
    }

    /// The values in a column (SI), of empty cells `None`; `None` where there is no column of that name.
    ///
    /// # Errors
    /// If the column has no unit, or one of another measure, or a cell is not a finite number.
    pub fn numbers(
        &self,
        name: &str,
        measure: &Measure,
    ) -> Result<Option<Vec<Option<f64>>>, Error> {
        let Some(column) = self.column(name) else { return Ok(None) };
        self.values(column, &self.scale(&self.headings[column], measure)?).map(Some)
    }

    /// The values in a column that are written in a unit.
    fn values(&self, column: usize, scale: &Scale) -> Result<Vec<Option<f64>>, Error> {
        let heading = &self.headings[column];
        let value = |row: &Row| match row.cells[column].as_str() {
            "" => Ok(None),
            text => match cells::value(text, scale) {
                None => Err(Error::NotANumber {
                    table: self.source.clone(),
                    line: row.line,
                    column: heading.title.clone(),
                    text: text.to_owned(),
                }),
                Some(value) => self.bounded(row.line, &heading.name, value, Quantity::Number),
            },
        };
        self.rows.iter().map(value).collect()
    }

    /// A value (SI) that is no larger than what a column holds may be.
    fn bounded(
        &self,
        line: u64,
        column: &str,
        value: f64,
        quantity: Quantity,
    ) -> Result<Option<f64>, Error> {
        if value.abs() <= quantity.range()[1] {
            return Ok(Some(value));
        }
        let (table, column) = (self.source.clone(), column.to_owned());
        Err(Error::TooLarge { table, line, column, value })
    }

    /// Refuses values (SI) of a column with one larger than what it holds may be.
    ///
    /// # Errors
    /// With the line of the first.
    pub fn hold(&self, column: &str, values: &[f64], quantity: Quantity) -> Result<(), Error> {
        let mut rows = self.rows.iter().zip(values);
        rows.try_for_each(|(row, value)| {
            self.bounded(row.line, column, *value, quantity).map(|_| ())
        })
    }

    /// Refuses a reading of what was worn off, taken in a row after so much of a motion: both are named, and SI.
    ///
    /// # Errors
    /// If one of them is negative, or nothing was worn off after some wear.
    pub fn worn(
        &self,
        row: usize,
        (progress, far): (&str, f64),
        (name, value): (&str, f64),
    ) -> Result<(), Error> {
        let why = if far < 0.0 {
            format!("`{progress}` is negative")
        } else if value < 0.0 {
            format!("`{name}` is negative: give what was worn off as a positive number")
        } else if far > 0.0 && value == 0.0 {
            format!(
                "`{name}` is zero after some wear: leave the cell empty if it was too little to measure"
            )
        } else {
            return Ok(());
        };
        Err(Error::Reading { table: self.source.clone(), line: self.rows[row].line, why })
    }

    /// The values in a column that has to be there, in every row (SI).
    ///
    /// # Errors
    /// As [`numbers`](Self::numbers); if there is no such column, or an empty cell in it.
    pub fn all_numbers(&self, name: &str, measure: &Measure) -> Result<Vec<f64>, Error> {
        let values = self.numbers(name, measure)?.ok_or_else(|| Error::NoColumn {
            table: self.source.clone(),
            wanted: heading::like(name, measure),
            name: name.to_owned(),
            titles: self.titles(),
        })?;
        self.without_gaps(name, values)
    }

    /// Every column: its name, its unit, whatever it measures, and the values in it, in every row (SI). Without a unit they are
    /// pure numbers; what stands behind `_` is a unit.
    ///
    /// # Errors
    /// If a unit cannot be one, a cell is empty or not a finite number.
    pub fn columns(&self) -> Result<Vec<(String, String, Vec<f64>)>, Error> {
        let column = |(index, heading): (usize, &Heading)| {
            // What stands behind `_` and is no unit may be one that is written wrong.
            let behind = || heading.title.rsplit_once('_').map(|(_, unit)| unit.to_owned());
            let unit = heading.unit.clone().or_else(behind).unwrap_or_else(|| "1".to_owned());
            let scale = Scale::read_any(&unit).map_err(|cause| Error::WrongUnit {
                table: self.source.clone(),
                column: heading.title.clone(),
                cause: Box::new(cause),
                like: format!("{} [MPa]", heading.name),
            });
            let values = self.values(index, &scale?.0)?;
            let values = self.without_gaps(&heading.name, values)?;
            Ok((heading.name.clone(), unit, values))
        };
        self.headings.iter().enumerate().map(column).collect()
    }

    /// Values where there is one in every row.
    fn without_gaps(&self, name: &str, values: Vec<Option<f64>>) -> Result<Vec<f64>, Error> {
        let there = |(row, value): (&Row, Option<f64>)| {
            value.ok_or_else(|| Error::NoValue {
                table: self.source.clone(),
                line: row.line,
                column: name.to_owned(),
            })
        };
        self.rows.iter().zip(values).map(there).collect()
    }

    /// The titles, as messages list them.
    pub fn titles(&self) -> String {
        let titles = self.headings.iter().map(|heading| format!("`{}`", heading.title));
        titles.collect::<Vec<_>>().join(", ")
    }

    fn column(&self, name: &str) -> Option<usize> {
        self.headings.iter().position(|heading| heading.name == name)
    }

    /// The unit of a column that holds a measure.
    fn scale(&self, heading: &Heading, measure: &Measure) -> Result<Scale, Error> {
        let unit = match &heading.unit {
            Some(unit) => unit,
            None if *measure == Measure::NUMBER => "1",
            None => {
                return Err(Error::NoUnit {
                    table: self.source.clone(),
                    column: heading.title.clone(),
                    like: heading::like(&heading.name, measure),
                });
            }
        };
        Scale::read(unit, measure).map_err(|cause| Error::WrongUnit {
            table: self.source.clone(),
            column: heading.title.clone(),
            cause: Box::new(cause),
            like: heading::like(&heading.name, measure),
        })
    }

    /// No two columns of one name.
    fn told_apart(&self) -> Result<(), Error> {
        for (index, heading) in self.headings.iter().enumerate() {
            let alike = |other: &&Heading| other.name == heading.name && !heading.name.is_empty();
            if let Some(other) = self.headings[..index].iter().find(alike) {
                return Err(Error::Twice {
                    table: self.source.clone(),
                    one: other.title.clone(),
                    other: heading.title.clone(),
                });
            }
        }
        Ok(())
    }

    /// Numbers with a comma and numbers with a point are not of one table, and commas may be separators of thousands: either
    /// way some would be read wrong.
    fn one_decimal_sign(&self, separator: u8) -> Result<(), Error> {
        let all = || {
            let cells = |row: &'_ Row| {
                row.cells.iter().map(|cell| (row.line, cell.clone())).collect::<Vec<_>>()
            };
            self.rows.iter().flat_map(cells)
        };
        let mut commas = all().filter(|(_, cell)| cells::has(cell, ','));
        let Some((line, one)) = commas.next() else { return Ok(()) };
        let table = self.source.clone();
        if let Some((other_line, other)) = all().find(|(_, cell)| cells::has(cell, '.')) {
            return Err(Error::TwoDecimalSigns { table, line, one, other_line, other });
        }
        let thousands = |(_, cell): (u64, String)| cells::may_be_thousands(&cell);
        if separator != b';' && cells::may_be_thousands(&one) && commas.all(thousands) {
            return Err(Error::Thousands { table, line, text: one });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
