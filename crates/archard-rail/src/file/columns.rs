//! Two columns of numbers.
//!
//! The columns are parted by semicolons, tabs, commas or spaces. A comma within a number stands for a point if
//! semicolons or tabs part the columns. Lines that begin with `#`, `!`, `%`, `"` or `//` are comments, and the first other
//! line may name the columns.

use std::fmt::Write;

use super::{Cause, Document, Format, Points, ReadError, lines};
use crate::profile::Profile;

/// What turns the columns into metres, y to the field side and z downwards.
fn factors(format: Format) -> [f64; 2] {
    match format {
        Format::Columns { unit, upwards, mirrored, .. } => {
            [mirrored, upwards].map(|turned| if turned { -unit } else { unit })
        }
        _ => [1.0; 2],
    }
}

pub(super) fn read(text: &str, format: Format) -> Result<Document, ReadError> {
    let factors = factors(format);
    if !factors.iter().all(|factor| factor.is_finite() && *factor != 0.0) {
        return Err(ReadError { line: 1, cause: Cause::Unit });
    }
    let mut points = Points::default();
    let mut first = true;
    for (line, row) in lines::numbered(text) {
        if row.is_empty() || ["#", "!", "%", "\"", "//"].iter().any(|mark| row.starts_with(mark)) {
            continue;
        }
        let named = std::mem::replace(&mut first, false) && row.starts_with(char::is_alphabetic);
        if !named {
            points.push(line, values(line, row)?)?;
        }
    }
    points.map(|[y, z]| [y * factors[0], z * factors[1]]);
    points.finish(format.part(), lines::count(text))
}

fn values(line: usize, row: &str) -> Result<[f64; 2], ReadError> {
    let parted = row.find([';', '\t']).is_some();
    let row = if parted { row.replace(',', ".") } else { row.replace(',', " ") };
    let words: Vec<&str> =
        row.split([';', '\t', ' ']).map(str::trim).filter(|word| !word.is_empty()).collect();
    if words.len() != 2 {
        return Err(ReadError { line, cause: Cause::Columns { found: words.len(), needed: 2 } });
    }
    lines::pair(line, words.into_iter())
}

pub(super) fn write(profile: &Profile, format: Format) -> String {
    let factors = factors(format);
    let comma = matches!(format, Format::Columns { comma: true, .. });
    let (mut text, between) = if comma { ("y,z\n".to_owned(), ',') } else { (String::new(), ' ') };
    for [y, z] in &profile.points {
        let _ = writeln!(text, "{:e}{between}{:e}", y / factors[0], z / factors[1]);
    }
    text
}
