//! The text of a log: gzip or not, UTF-8, UTF-16 or Latin-1.

use std::io::Read;

use flate2::read::MultiGzDecoder;

/// Largest text of a compressed log (bytes): a day at ten thousand readings a second would fill it; a bomb ends here.
const LARGEST: u64 = 1 << 31;

/// The text of a file.
///
/// # Errors
/// What the decompressor says, if the file is gzip and damaged.
pub fn text(bytes: &[u8]) -> Result<String, String> {
    if bytes.starts_with(&[0x1f, 0x8b]) {
        let mut plain = vec![];
        let mut reader = MultiGzDecoder::new(bytes).take(LARGEST);
        reader.read_to_end(&mut plain).map_err(|error| error.to_string())?;
        return Ok(decoded(&plain));
    }
    Ok(decoded(bytes))
}

/// UTF-16 is known by its byte order mark, or by zeros in every other byte.
fn decoded(bytes: &[u8]) -> String {
    let units = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]])).collect();
        String::from_utf16_lossy(&units)
    };
    match bytes {
        [0xff, 0xfe, rest @ ..] => units(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => units(rest, u16::from_be_bytes),
        [0xef, 0xbb, 0xbf, rest @ ..] => decoded(rest),
        [first, 0, second, 0, ..] if *first != 0 && *second != 0 => {
            units(bytes, u16::from_le_bytes)
        }
        _ => match std::str::from_utf8(bytes) {
            Ok(text) => text.to_owned(),
            Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
        },
    }
}
