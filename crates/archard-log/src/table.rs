//! A log as a table: its columns, whatever stands before, between and behind its rows.

use std::ops::Range;

use crate::error::Error;
use crate::number::{DAY, clock, decimal, number};
use crate::rate::FEWEST;
use crate::{text, unit};

/// A column: title, name without unit, unit, and a value a row (NaN where none exists).
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
    /// The decimal sign of its numbers.
    pub decimal: char,
    /// Lines without readings, above the names and between or below the readings, as cells.
    pub asides: Vec<(usize, Vec<String>)>,
    /// What was passed over.
    pub said: Vec<String>,
}

fn is_value(cell: &str) -> bool {
    number(cell, '.').is_some() || number(cell, ',').is_some() || clock(cell).is_some()
}

fn cells(line: &str, separator: char) -> Vec<String> {
    if separator == ' ' {
        return between_blanks(line);
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

/// The separator that makes most lines rows; of those that make as many the last one here.
fn separator(lines: &[(usize, &str)]) -> char {
    // A thousand lines of a long log say it.
    let some = || lines.iter().step_by(lines.len() / 1000 + 1);
    let rows = |by: char| some().filter(|(_, line)| is_row(&cells(line, by))).count();
    [' ', '|', ',', ';', '\t'].into_iter().max_by_key(|by| rows(*by)).unwrap_or(',')
}

fn filled(cells: &[String]) -> usize {
    cells.iter().filter(|cell| !cell.is_empty()).count()
}

fn is_units(cells: &[String]) -> bool {
    cells.iter().all(|cell| unit::known(cell).is_some()) && filled(cells) > 0
}

/// The lines from the names of the longest table on to those of the next one.
///
/// # Errors
/// If another table could be meant as well.
fn longest(
    log: &str,
    split: &[(usize, Vec<String>)],
    is_a_row: &[bool],
) -> Result<Range<usize>, Error> {
    let begins = |at: &usize| {
        let cells = &split[*at].1;
        let below = (at + 1..split.len()).find(|next| !is_units(&split[*next].1));
        let Some(row) = below.filter(|row| is_a_row[*row]) else { return false };
        let names = filled(cells) >= 2 && 2 * filled(cells) >= filled(&split[row].1);
        names && !is_units(cells) && !cells.iter().any(|cell| is_value(cell))
    };
    let mut edges: Vec<usize> = (0..split.len()).filter(begins).collect();
    // Names that are repeated, as on each page of a print, begin no table.
    edges.dedup_by(|next, last| split[*next].1 == split[*last].1);
    edges.insert(0, 0);
    edges.push(split.len());
    let parts: Vec<Range<usize>> = edges.windows(2).map(|pair| pair[0]..pair[1]).collect();
    let rows = |part: &Range<usize>| is_a_row[part.clone()].iter().filter(|row| **row).count();
    let most = parts.iter().map(rows).max().unwrap_or_default();
    let own = parts.iter().position(|part| rows(part) == most).unwrap_or_default();
    // A head of a few numbers is no table of readings.
    let other = (0..parts.len()).find(|at| *at != own && rows(&parts[*at]) >= FEWEST.min(most));
    if let Some(other) = other {
        let (line, cells) = &split[parts[other.max(own)].start];
        let heading = cells.join(", ");
        return Err(Error::OtherTable { log: log.to_owned(), line: *line, heading });
    }
    Ok(parts[own].clone())
}

/// The cells of a line in columns of blanks: words that are no values stand two blanks apart, or one where brackets hold units.
fn between_blanks(line: &str) -> Vec<String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let wide: Vec<String> = line
        .split("  ")
        .map(|cell| cell.trim().to_owned())
        .filter(|cell| !cell.is_empty())
        .collect();
    if words.iter().all(|word| is_value(word)) || wide.len() < 2 {
        let mut cells: Vec<String> = vec![];
        for word in words {
            match cells.last_mut().filter(|_| word.starts_with(['(', '['])) {
                Some(name) => *name += &format!(" {word}"),
                None => cells.push(word.to_owned()),
            }
        }
        return cells;
    }
    wide
}

/// Whether a line is a row: two values at least, and values in most of its cells.
fn is_row(cells: &[String]) -> bool {
    let filled = filled(cells);
    let values = cells.iter().filter(|cell| is_value(cell)).count();
    values >= 2 && 2 * values > filled
}

/// The name and unit of `Load [N]`, `depth (um)`, `Wear / µm`, `wear_um`, `Load, N` or `Load N`; the name is what stands behind the
/// last point.
pub fn heading(title: &str) -> (String, Option<String>) {
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
        .or_else(|| {
            let (name, end) = title.trim().rsplit_once(' ')?;
            let is_name = name.contains(char::is_alphabetic);
            unit::stands_alone(end).filter(|_| is_name).map(|_| (name, Some(end)))
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
        // Some end the lines of a head with a carriage return alone.
        let text = text.replace("\r\n", "\n").replace('\r', "\n");
        let lines: Vec<(usize, &str)> = text
            .lines()
            .enumerate()
            .map(|(at, line)| (at + 1, line))
            .filter(|(_, line)| !line.trim().is_empty())
            .collect();
        let separator = separator(&lines);
        let split: Vec<(usize, Vec<String>)> =
            lines.iter().map(|(at, line)| (*at, cells(line, separator))).collect();
        let is_a_row: Vec<bool> = split.iter().map(|(_, cells)| is_row(cells)).collect();
        if !is_a_row.contains(&true) {
            return Err(Error::NoRows { log });
        }
        let own = longest(&log, &split, &is_a_row)?;
        let first = (own.start..own.end).find(|at| is_a_row[*at]).unwrap_or(own.start);
        let width = split[first].1.len();
        let wide = |cells: &[String]| 2 * cells.len() >= width && cells.len() >= 2;
        let words = |cells: &[String]| wide(cells) && filled(cells) >= 2;
        let names = |end: usize| (0..end).rev().find(|at| words(&split[*at].1) && !is_a_row[*at]);
        let (at, units) = match names(first) {
            Some(own) if is_units(&split[own].1) => (names(own), Some(own)),
            found => (found, None),
        };
        let Some(at) = at else { return Err(Error::NoHeading { log, line: split[first].0 }) };
        let titles = &split[at].1;
        // Cells beyond the names, or as many as blanks leave open, may be those of any column.
        let fits = |cells: &[String]| match separator {
            ' ' => cells.len() == titles.len(),
            _ => !cells.iter().skip(titles.len()).any(|cell| is_value(cell)),
        };
        if !fits(&split[first].1) {
            let (line, cells) = &split[first];
            let (names, values) = (titles.len(), cells.len());
            return Err(Error::Width { log, line: *line, values, names, heading: split[at].0 });
        }
        let cells = (first..own.end).filter(|row| is_a_row[*row]);
        let sign = decimal(cells.flat_map(|row| split[row].1.iter().map(|cell| &**cell)));
        let (mut kept, mut asides, mut others, mut repeated) = (vec![], vec![], vec![], 0);
        for (place, (line, cells)) in split.iter().enumerate() {
            if place == at || Some(place) == units {
                continue;
            }
            if own.contains(&place) && place >= first {
                if is_a_row[place] && wide(cells) && fits(cells) {
                    kept.push((*line, cells));
                    continue;
                }
                if cells == titles || is_units(cells) {
                    repeated += 1;
                    continue;
                }
            }
            if place > at {
                others.push(*line);
            }
            asides.push((*line, cells.clone()));
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
            let own = |cells: &'_ Vec<String>| cells.get(index).cloned().unwrap_or_default();
            let clocks: Vec<Option<(f64, bool)>> = kept
                .iter()
                .map(|(_, cells)| cells.get(index).and_then(|cell| clock(cell)))
                .collect();
            let is_clock = clocks.iter().any(Option::is_some);
            let values = match is_clock {
                true => past_midnight(&clocks),
                false => kept
                    .iter()
                    .map(|(_, cells)| number(&own(cells), sign).unwrap_or(f64::NAN))
                    .collect(),
            };
            let later = |(value, clock): (&f64, &Option<(f64, bool)>)| {
                clock.is_some_and(|(time, _)| time < *value)
            };
            if let Some(row) = values.iter().zip(&clocks).position(later) {
                said.push(format!("`{title}` passes midnight before line {}", kept[row].0));
            }
            if title.is_empty() || values.iter().all(|value: &f64| value.is_nan()) {
                continue;
            }
            let (name, unit) = heading(title);
            let below = units.and_then(|row| split[row].1.get(index)).map(|unit| unit::plain(unit));
            let unit = unit.or(below.filter(|unit| !unit.is_empty()));
            columns.push(Column { title: title.clone(), name, unit, values, is_clock });
        }
        let lines = kept.iter().map(|(line, _)| *line).collect();
        Ok(Self { source: log, columns, lines, heading: split[at].0, decimal: sign, asides, said })
    }

    /// Whether it is a height over a length and nothing else, by the names; a distance slid is in metres.
    pub fn is_profile(&self) -> bool {
        let names = ["profile", "profil", "height", "hoehe", "z"];
        let [one, other] = &self.columns[..] else { return false };
        let across = ["distance", "x", "y", "position", "length", "weg"];
        let is_slid =
            |own: &Column| own.unit.as_deref().is_some_and(|unit| ["m", "km"].contains(&unit));
        [one, other].iter().any(|own| own.name == "profile" || own.name == "profil")
            || across.contains(&&*one.name) && !is_slid(one) && names.contains(&&*other.name)
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
