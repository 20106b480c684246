//! `.sdf` of ISO 25178-71: a head, then points, in bytes or in text.

use super::bytes::Bytes;
use super::{ReadError, Scale};
use crate::map::{HeightMap, count};

/// What heads of every version begin with, after a letter for bytes or text.
const MAGICS: [&[u8]; 3] = [b"ISO-1.0", b"BCR-1.0", b"ISO-2.0"];

/// Whether a file begins as one.
pub(super) fn begins(all: &[u8]) -> bool {
    let known = all.get(1..8).is_some_and(|magic| MAGICS.contains(&magic));
    known && matches!(all.first(), Some(b'a' | b'b'))
}

pub(super) fn read(all: &[u8], scale: Scale, most: usize) -> Result<HeightMap, ReadError> {
    if all.starts_with(b"b") { binary(all, scale, most) } else { ascii(all, scale, most) }
}

fn binary(all: &[u8], scale: Scale, most: usize) -> Result<HeightMap, ReadError> {
    let mut bytes = Bytes::new(all);
    // Magic, manufacturer, dates of creation and change.
    bytes.skip(8 + 10 + 12 + 12)?;
    let elements = [bytes.u16()?, bytes.u16()?].map(usize::from);
    let [dx, dy, dz] = [bytes.f64()?, bytes.f64()?, bytes.f64()?];
    let _resolution = bytes.f64()?;
    if bytes.u8()? != 0 {
        return Err(ReadError::Unsupported("a packed .sdf".to_owned()));
    }
    let kind = bytes.u8()?;
    let _check = bytes.u8()?;
    let width = match kind {
        1 | 5 => 2,
        2 | 3 | 6 => 4,
        7 => 8,
        _ => return Err(ReadError::Unsupported(format!("an .sdf of data type {kind}"))),
    };
    let data = bytes.take(count(elements, most)? * width)?;
    let value = |point: &[u8]| match (kind, point) {
        (1, &[a, b]) => missing(u16::from_le_bytes([a, b]), u16::MAX),
        (5, &[a, b]) => missing(i16::from_le_bytes([a, b]), i16::MIN),
        (2, &[a, b, c, d]) => missing(u32::from_le_bytes([a, b, c, d]), u32::MAX),
        (6, &[a, b, c, d]) => missing(i32::from_le_bytes([a, b, c, d]), i32::MIN),
        // The lowest number marks points here too, or they are not a number.
        (3, &[a, b, c, d]) => missing(f32::from_le_bytes([a, b, c, d]), f32::MIN),
        (7, &[a, b, c, d, e, f, g, h]) => {
            missing(f64::from_le_bytes([a, b, c, d, e, f, g, h]), f64::MIN)
        }
        _ => f64::NAN,
    };
    let heights = data.chunks_exact(width).map(|point| dz * value(point)).collect();
    Ok(HeightMap::new(elements, scale.pixel.unwrap_or([dx, dy]), heights)?)
}

/// A value, unless it is the one that marks points that were not measured.
fn missing<T: Copy + PartialEq + Into<f64>>(value: T, mark: T) -> f64 {
    if value == mark { f64::NAN } else { value.into() }
}

fn ascii(all: &[u8], scale: Scale, most: usize) -> Result<HeightMap, ReadError> {
    let text: String = all.iter().map(|&byte| char::from(byte)).collect();
    let mut keys = [None; 5];
    let names = ["numpoints", "numprofiles", "xscale", "yscale", "zscale"];
    let mut heights = vec![];
    let mut in_head = true;
    for (index, line) in text.lines().enumerate().skip(1) {
        let number = |word: &str| {
            let wrong = || ReadError::Number { line: index + 1, word: word.to_owned() };
            word.parse::<f64>().map_err(|_| wrong())
        };
        let line = line.trim();
        if line.starts_with('*') {
            if !in_head {
                break;
            }
            in_head = false;
        } else if !in_head {
            for word in line.split_whitespace() {
                let bad = word.eq_ignore_ascii_case("bad");
                heights.push(if bad { f64::NAN } else { number(word)? });
            }
        } else if let Some((key, value)) = line.split_once('=') {
            let key = key.trim().to_ascii_lowercase();
            if let Some(at) = names.iter().position(|name| *name == key) {
                keys[at] = Some(number(value.trim())?);
            }
        }
    }
    let [Some(nx), Some(ny), Some(dx), Some(dy), Some(dz)] = keys else {
        let short = "an .sdf without NumPoints, NumProfiles, Xscale, Yscale and Zscale";
        return Err(ReadError::Unsupported(short.to_owned()));
    };
    heights.iter_mut().for_each(|height| *height *= dz);
    let elements = [nx as usize, ny as usize];
    count(elements, most)?;
    Ok(HeightMap::new(elements, scale.pixel.unwrap_or([dx, dy]), heights)?)
}
