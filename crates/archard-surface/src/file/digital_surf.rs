//! `.sur` of Digital Surf: a head of 512 bytes, a comment, private bytes, and points of 16 or 32 bits, row by row.

use super::bytes::Bytes;
use super::{ReadError, Scale, unit};
use crate::map::{HeightMap, count};

/// How files begin.
pub(super) const MAGIC: &[u8] = b"DIGITAL SURF";
/// The kind of an object whose points are a surface.
const SURFACE: u16 = 2;

pub(super) fn read(all: &[u8], scale: Scale, most: usize) -> Result<HeightMap, ReadError> {
    let mut bytes = Bytes::new(all);
    bytes.skip(MAGIC.len())?;
    if bytes.u16()? != 0 {
        return Err(ReadError::Unsupported("a big-endian .sur".to_owned()));
    }
    let objects = bytes.u16()?;
    let _version = bytes.u16()?;
    let kind = bytes.u16()?;
    if kind != SURFACE || objects > 1 {
        return Err(ReadError::Unsupported(format!(
            "a .sur of kind {kind} with {objects} objects"
        )));
    }
    // Names of the object and the instrument, material, acquisition and range.
    bytes.skip(30 + 30 + 2 + 2 + 2)?;
    let marks = bytes.u16()? == 1;
    // Absolute, reserved.
    bytes.skip(2 + 8)?;
    let bits = bytes.u16()?;
    let least = bytes.i32()?;
    let _most = bytes.i32()?;
    let [nx, ny] = [bytes.i32()?, bytes.i32()?];
    let _count = bytes.i32()?;
    let spacing = [bytes.f32()?, bytes.f32()?, bytes.f32()?];
    // Names of the axes.
    bytes.skip(3 * 16)?;
    let units = [bytes.text(16)?, bytes.text(16)?, bytes.text(16)?];
    // Units of the axes as they are shown, and ratios to them; imprint.
    bytes.skip(3 * 16 + 3 * 4 + 2)?;
    let inversion = bytes.u16()?;
    // Levelling, reserved, date, duration, reserved.
    bytes.skip(2 + 12 + 14 + 4 + 10)?;
    let (comment, private) = (bytes.u16()?, bytes.u16()?);
    // Client, offsets (that of heights says nothing about their shape), reserved.
    bytes.skip(128 + 12 + 34)?;
    bytes.skip(usize::from(comment) + usize::from(private))?;
    let elements = [nx, ny].map(|count| usize::try_from(count).unwrap_or(0));
    let width = match bits {
        16 => 2,
        32 => 4,
        _ => return Err(ReadError::Unsupported(format!("a .sur of {bits} bits"))),
    };
    let data = bytes.take(count(elements, most)? * width)?;
    let [dx, dy, dz] = [
        unit(&units[0])? * spacing[0],
        unit(&units[1])? * spacing[1],
        unit(&units[2])? * spacing[2],
    ];
    let missing = marks.then(|| i64::from(least) - 2);
    let sign = if inversion == 0 { 1.0 } else { -1.0 };
    let height = |point: &[u8]| {
        let value = match *point {
            [a, b] => i64::from(i16::from_le_bytes([a, b])),
            [a, b, c, d] => i64::from(i32::from_le_bytes([a, b, c, d])),
            _ => return f64::NAN,
        };
        if Some(value) == missing { f64::NAN } else { sign * dz * value as f64 }
    };
    let mut heights: Vec<f64> = data.chunks_exact(width).map(height).collect();
    let wide = elements[0].max(1);
    match inversion {
        2 => heights.chunks_mut(wide).for_each(<[f64]>::reverse),
        3 => heights = heights.chunks(wide).rev().flatten().copied().collect(),
        _ => {}
    }
    Ok(HeightMap::new(elements, scale.pixel.unwrap_or([dx, dy]), heights)?)
}
