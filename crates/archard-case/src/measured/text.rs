//! The text of a table, whatever spreadsheet wrote it.

use std::borrow::Cow;

/// The text of bytes: UTF-8, UTF-16 where a byte order mark says so, or else Latin-1.
pub(super) fn decoded(bytes: &[u8]) -> Cow<'_, str> {
    let units = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]])).collect();
        Cow::Owned(String::from_utf16_lossy(&units))
    };
    match bytes {
        [0xff, 0xfe, text @ ..] => units(text, u16::from_le_bytes),
        [0xfe, 0xff, text @ ..] => units(text, u16::from_be_bytes),
        [0xef, 0xbb, 0xbf, text @ ..] => decoded(text),
        _ => match std::str::from_utf8(bytes) {
            Ok(text) => Cow::Borrowed(text),
            Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
        },
    }
}

/// What separates the cells: a tab or semicolon where the header has one, else a comma.
pub(super) fn separator(text: &str) -> u8 {
    let mut lines = text.lines().map(str::trim_start);
    let header = lines.find(|line| !line.is_empty() && !line.starts_with('#')).unwrap_or_default();
    let mut quoted = false;
    let outside: String = header
        .chars()
        .filter(|letter| {
            quoted ^= *letter == '"';
            !quoted
        })
        .collect();
    [b'\t', b';'].into_iter().find(|byte| outside.contains(char::from(*byte))).unwrap_or(b',')
}
