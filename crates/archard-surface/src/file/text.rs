//! Rows of numbers, as spreadsheets and instruments export matrices.

use super::{ReadError, Scale, matrix};
use crate::map::{HeightMap, count};

/// Words for points that were not measured.
const MISSING: [&str; 6] = ["nan", "bad", "***", "none", "null", "--"];

pub(super) fn read(bytes: &[u8], scale: Scale, most: usize) -> Result<HeightMap, ReadError> {
    let text: String = String::from_utf8(bytes.to_vec())
        .unwrap_or_else(|_| bytes.iter().map(|&byte| char::from(byte)).collect());
    let text = text.trim_start_matches('\u{feff}');
    let (mut heights, mut columns, mut rows) = (vec![], 0, 0);
    for (index, row) in text.lines().enumerate() {
        let row = row.trim_end_matches(['\r', ' ', '\t']);
        if row.trim().is_empty() || row.trim_start().starts_with('#') {
            continue;
        }
        let before = heights.len();
        for word in words(row) {
            heights.push(
                number(word)
                    .ok_or_else(|| ReadError::Number { line: index + 1, word: word.to_owned() })?,
            );
        }
        let found = heights.len() - before;
        if rows > 0 && found != columns {
            return Err(ReadError::Row { line: index + 1, found, needed: columns });
        }
        (columns, rows) = (found, rows + 1);
    }
    count([columns, rows], most)?;
    matrix([columns, rows], heights, scale)
}

/// The words of a row: between semicolons or tabs where there are any, or commas with no blank after some digits, or blanks.
fn words(row: &str) -> Vec<&str> {
    let split = |separator: char| {
        let row = row.strip_suffix(separator).unwrap_or(row);
        row.split(separator).map(str::trim).collect::<Vec<&str>>()
    };
    match row {
        _ if row.contains(';') => split(';'),
        _ if row.contains('\t') => split('\t'),
        // Commas without any blank part numbers; with blanks they may be decimal signs.
        _ if row.contains(',') && !row.trim().contains(' ') => split(','),
        _ if row.contains(", ") => split(','),
        _ => row.split_whitespace().collect(),
    }
}

/// A number, with a comma or a point for its fraction; not a number where it was not measured.
fn number(word: &str) -> Option<f64> {
    if word.is_empty() || MISSING.contains(&word.to_ascii_lowercase().as_str()) {
        return Some(f64::NAN);
    }
    let number = word.parse::<f64>().or_else(|_| word.replacen(',', ".", 1).parse::<f64>()).ok()?;
    number.is_finite().then_some(number)
}
