//! Text, lines and numbers of a file.

use std::borrow::Cow;

use super::{Cause, ReadError};

/// The text of the bytes: UTF-8 if they are, Latin-1 if not, without a byte-order mark.
pub(super) fn decode(bytes: &[u8]) -> Cow<'_, str> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().map(|&byte| char::from(byte)).collect()),
    }
}

/// The lines with their numbers from 1, trimmed.
pub(super) fn numbered(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines().enumerate().map(|(at, line)| (at + 1, line.trim()))
}

/// How many lines there are, 1 or more.
pub(super) fn count(text: &str) -> usize {
    text.lines().count().max(1)
}

/// The finite number that the word is.
pub(super) fn number(line: usize, word: &str) -> Result<f64, ReadError> {
    let value: Option<f64> = word.parse().ok();
    value.filter(|value| value.is_finite()).ok_or_else(|| {
        let word = word.chars().take(40).collect();
        ReadError { line, cause: Cause::Number { word } }
    })
}

/// The first two numbers of a row.
pub(super) fn pair<'a>(
    line: usize,
    mut words: impl Iterator<Item = &'a str>,
) -> Result<[f64; 2], ReadError> {
    match (words.next(), words.next()) {
        (Some(first), Some(second)) => Ok([number(line, first)?, number(line, second)?]),
        (first, _) => {
            let cause = Cause::Columns { found: usize::from(first.is_some()), needed: 2 };
            Err(ReadError { line, cause })
        }
    }
}
