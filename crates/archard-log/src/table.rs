//! A log as a table: its columns, whatever stands before, between and behind its rows.

use crate::error::Error;
use crate::number::{DAY, clock, decimal, number};
use crate::{text, unit};

/// A column: title, name without unit, unit, and a value a row (NaN where there is none).
#[derive(Debug, Clone)]
pub struct Column {
    /// As it stands in the log, with its unit.
    pub title: String,
    /// In small letters, without anything but letters and digits.
    pub name: String,
    /// The unit, if the log states one.
    pub unit: Option<String>,
    /// Its values as they stand there; times of day in seconds.
    pub values: Vec<f64>,
    /// Whether it holds times of day.
    pub is_clock: bool,
}

/// The columns, the line of each row, the line of the heading, and what is to be said of the reading.
#[derive(Debug, Clone)]
pub struct Table {
    /// What messages call the log.
    pub source: String,
    /// The columns that hold values.
    pub columns: Vec<Column>,
    /// The line (from 1) of each row.
    pub lines: Vec<usize>,
    /// The line of the names.
    pub heading: usize,
    /// What was passed over.
    pub said: Vec<String>,
}

fn is_value(cell: &str) -> bool {
    number(cell, '.').is_some() || number(cell, ',').is_some() || clock(cell).is_some()
}

fn cells(line: &str, separator: char) -> Vec<String> {
    if separator == ' ' {
        return line.split_whitespace().map(str::to_owned).collect();
    }
    let (mut found, mut quoted) = (vec![String::new()], false);
    for letter in line.chars() {
        match letter {
            '"' => quoted ^= true,
            _ if letter == separator && !quoted => found.push(String::new()),
            _ => found.last_mut().expect("one cell at least").push(letter),
        }
    }
    found.iter().map(|cell| cell.trim().to_owned()).collect()
}

/// Whether a line is a row: two values at least, and values in most of its cells.
fn is_row(cells: &[String]) -> bool {
    let filled = cells.iter().filter(|cell| !cell.is_empty()).count();
    let values = cells.iter().filter(|cell| is_value(cell)).count();
    values >= 2 && 2 * values > filled
}

/// The name and unit of `Load [N]`, `depth (um)`, `Wear / µm` or `wear_um`; the name is what stands behind the last point.
fn heading(title: &str) -> (String, Option<String>) {
    let (name, unit) = [('[', ']'), ('(', ')')]
        .into_iter()
        .find_map(|(open, close)| {
            let (name, rest) = title.trim().strip_suffix(close)?.rsplit_once(open)?;
            Some((name, Some(rest)))
        })
        .or_else(|| title.split_once(" / ").map(|(name, unit)| (name, Some(unit))))
        .or_else(|| {
            let (name, end) = title.rsplit_once('_')?;
            unit::known(end).filter(|_| !end.is_empty()).map(|_| (name, Some(end)))
        })
        .unwrap_or((title, None));
    (plain(name), unit.map(unit::plain))
}

/// A name with nothing but letters and digits, µ as mu; what stands before a point names the instrument.
pub fn plain(name: &str) -> String {
    let name = name.rsplit('.').next().unwrap_or(name).to_lowercase();
    let name = name.replace(['\u{b5}', '\u{3bc}'], "mu").replace('\u{df}', "ss");
    name.chars().filter(|letter| letter.is_alphanumeric()).collect()
}

impl Table {
    /// Reads the bytes of a file.
    ///
    /// # Errors
    /// If it is damaged, has no rows or no names of its columns, or holds two tables.
    pub fn read(source: &str, bytes: &[u8]) -> Result<Self, Error> {
        let log = source.to_owned();
        let text = text::text(bytes).map_err(|why| Error::Damaged { log: log.clone(), why })?;
        let lines: Vec<(usize, &str)> = text
            .lines()
            .enumerate()
            .map(|(at, line)| (at + 1, line.trim_end_matches('\r')))
            .filter(|(_, line)| !line.trim().is_empty())
            .collect();
        let rows = |by: char| lines.iter().filter(|(_, line)| is_row(&cells(line, by))).count();
        // The first of the best: `max_by_key` takes the last.
        let separator = [' ', '|', ',', ';', '\t'].into_iter().max_by_key(|by| rows(*by));
        let separator = separator.unwrap_or(',');
        let split: Vec<(usize, Vec<String>)> =
            lines.iter().map(|(at, line)| (*at, cells(line, separator))).collect();
        let first = split.iter().position(|(_, cells)| is_row(cells));
        let Some(first) = first else { return Err(Error::NoRows { log }) };
        let width = split[first].1.len();
        let wide = |cells: &[String]| 2 * cells.len() >= width && cells.len() >= 2;
        let words = |cells: &[String]| {
            wide(cells) && cells.iter().filter(|cell| !cell.is_empty()).count() >= 2
        };
        let is_units = |cells: &[String]| {
            cells.iter().all(|cell| unit::known(cell).is_some())
                && cells.iter().any(|c| !c.is_empty())
        };
        let names = |end: usize| split[..end].iter().rposition(|(_, cells)| words(cells));
        let at = names(first);
        let (at, units) = match at {
            Some(own) if is_units(&split[own].1) => (names(own), Some(own)),
            found => (found, None),
        };
        let Some(at) = at else { return Err(Error::NoHeading { log, line: split[first].0 }) };
        let titles = &split[at].1;
        let sign = decimal(split[first..].iter().flat_map(|(_, cells)| cells.iter().map(|c| &**c)));
        let (mut kept, mut others, mut repeated) = (vec![], vec![], 0);
        for (place, (line, cells)) in split.iter().enumerate().skip(first) {
            if is_row(cells) && wide(cells) {
                kept.push((*line, cells));
            } else if cells == titles || is_units(cells) {
                repeated += 1;
            } else if words(cells) && split.get(place + 1).is_some_and(|next| is_row(&next.1)) {
                return Err(Error::OtherTable { log, line: *line, heading: cells.join(", ") });
            } else {
                others.push(*line);
            }
        }
        let mut said = vec![];
        if repeated > 0 {
            said.push(format!("repeated headings passed over: {repeated}"));
        }
        if let Some(line) = others.first() {
            said.push(format!(
                "lines without readings passed over: {}, first line {line}",
                others.len()
            ));
        }
        let mut columns = vec![];
        for (index, title) in titles.iter().enumerate() {
            let own = |cells: &[String]| cells.get(index).cloned().unwrap_or_default();
            let clocks: Vec<Option<(f64, bool)>> =
                kept.iter().map(|(_, cells)| clock(&own(cells))).collect();
            let is_clock = clocks.iter().any(Option::is_some);
            let values = match is_clock {
                true => past_midnight(&clocks),
                false => kept
                    .iter()
                    .map(|(_, cells)| number(&own(cells), sign).unwrap_or(f64::NAN))
                    .collect(),
            };
            if title.is_empty() || values.iter().all(|value: &f64| value.is_nan()) {
                continue;
            }
            let (name, unit) = heading(title);
            let below = units.and_then(|row| split[row].1.get(index)).map(|unit| unit::plain(unit));
            let unit = unit.or(below.filter(|unit| !unit.is_empty()));
            columns.push(Column { title: title.clone(), name, unit, values, is_clock });
        }
        let lines = kept.iter().map(|(line, _)| *line).collect();
        Ok(Self { source: log, columns, lines, heading: split[at].0, said })
    }

    /// The titles, for messages.
    pub fn titles(&self) -> String {
        let titles: Vec<String> =
            self.columns.iter().map(|column| format!("`{}`", column.title)).collect();
        titles.join(", ")
    }
}

/// Times of day go on past midnight; a jump back by less than half a day stays one.
fn past_midnight(clocks: &[Option<(f64, bool)>]) -> Vec<f64> {
    let (mut days, mut last) = (0.0, f64::NEG_INFINITY);
    let mut put = |(time, dated): (f64, bool)| {
        if !dated && time + days < last - 0.5 * DAY {
            days += DAY;
        }
        last = time + days;
        last
    };
    clocks.iter().map(|clock| clock.map_or(f64::NAN, &mut put)).collect()
}
