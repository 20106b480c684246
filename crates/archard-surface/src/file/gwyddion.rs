//! `.gwy` of Gwyddion: a tree of named values, where `/0/data` is a field of heights and `/0/mask` covers points of it.
//!
//! An object is its name, the size of what it holds, and components: a name, a letter for the type, and the value
//! (Gwyddion user guide, "Format of Gwyddion Files"). Components are passed one by one and only the wanted ones are looked
//! into, so that nesting costs neither stack nor memory.

use super::bytes::Bytes;
use super::{ReadError, Scale, unit};
use crate::map::{HeightMap, count};

/// How files begin.
pub(super) const MAGIC: &[u8] = b"GWYP";

pub(super) fn read(all: &[u8], scale: Scale, most: usize) -> Result<HeightMap, ReadError> {
    let mut bytes = Bytes::new(all);
    bytes.skip(MAGIC.len())?;
    let (_, inside) = object(&mut bytes)?;
    let (mut fields, mut masks, mut titles) = (vec![], vec![], vec![]);
    each(inside, |name, value| {
        let Some((number, part)) = channel(name) else { return Ok(()) };
        match (part, value) {
            ("data", Value::Object(b"GwyDataField", inside)) => {
                fields.push((number, Field::of(inside)?));
            }
            ("mask", Value::Object(b"GwyDataField", inside)) => {
                masks.push((number, Field::of(inside)?));
            }
            ("data/title", Value::Text(title)) => titles.push((number, title)),
            _ => {}
        }
        Ok(())
    })?;
    fields.sort_by_key(|(number, _)| *number);
    let found = fields.iter().find_map(|(number, field)| Some((*number, field.units()?, *field)));
    let Some((number, [across, upwards], field)) = found else {
        let title = |wanted: usize| {
            let found = titles.iter().find(|(number, _)| *number == wanted);
            found.map_or("", |(_, title)| title)
        };
        let channels = fields
            .iter()
            .map(|(number, field)| format!("`{}` in `{}`", title(*number), field.unit_z));
        return Err(ReadError::Unsupported(format!(
            "a Gwyddion file without heights in a unit of length (its channels: {})",
            channels.collect::<Vec<_>>().join(", ")
        )));
    };
    let count = count(field.elements, most)?;
    field.holds(count)?;
    let mut heights: Vec<f64> = field.values().map(|value| upwards * value).collect();
    if let Some((_, mask)) = masks.iter().find(|(own, _)| *own == number) {
        mask.holds(count)?;
        // Masks are 0 and 1.
        let covered = heights.iter_mut().zip(mask.values()).filter(|(_, mask)| *mask > 0.5);
        covered.for_each(|(height, _)| *height = f64::NAN);
    }
    // Gwyddion takes sizes by their amount.
    let pixel = [0, 1].map(|axis| across * field.size[axis].abs() / field.elements[axis] as f64);
    Ok(HeightMap::new(field.elements, scale.pixel.unwrap_or(pixel), heights)?)
}

/// The number of the channel that a name such as `/0/data` is of, and the rest of it.
fn channel(name: &[u8]) -> Option<(usize, &str)> {
    let (number, part) = std::str::from_utf8(name).ok()?.strip_prefix('/')?.split_once('/')?;
    Some((number.parse().ok()?, part))
}

/// A matrix of numbers, not yet taken over.
#[derive(Debug, Clone, Copy, Default)]
struct Field<'a> {
    elements: [usize; 2],
    size: [f64; 2],
    unit_xy: &'a str,
    unit_z: &'a str,
    data: &'a [u8],
}

impl<'a> Field<'a> {
    fn of(inside: &'a [u8]) -> Result<Self, ReadError> {
        let mut field = Field::default();
        each(inside, |name, value| {
            match (name, value) {
                (b"xres", Value::Whole(count)) => field.elements[0] = count,
                (b"yres", Value::Whole(count)) => field.elements[1] = count,
                (b"xreal", Value::Number(size)) => field.size[0] = size,
                (b"yreal", Value::Number(size)) => field.size[1] = size,
                (b"data", Value::Numbers(data)) => field.data = data,
                (b"si_unit_xy", Value::Object(_, inside)) => field.unit_xy = unit_text(inside)?,
                (b"si_unit_z", Value::Object(_, inside)) => field.unit_z = unit_text(inside)?,
                _ => {}
            }
            Ok(())
        })?;
        Ok(field)
    }

    /// Units (m) along the surface and of values, if both are of length.
    fn units(&self) -> Option<[f64; 2]> {
        Some([unit(self.unit_xy).ok()?, unit(self.unit_z).ok()?])
    }

    /// Refuses another number of values.
    fn holds(&self, count: usize) -> Result<(), ReadError> {
        let found = self.data.len() / size_of::<f64>();
        if found == count {
            return Ok(());
        }
        let [nx, ny] = self.elements;
        Err(ReadError::Damaged(format!("{found} values in a field of {nx} x {ny}")))
    }

    fn values(&self) -> impl Iterator<Item = f64> {
        self.data.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes))
    }
}

/// The text of a unit.
fn unit_text(inside: &[u8]) -> Result<&str, ReadError> {
    let mut text = "";
    each(inside, |name, value| {
        if let (b"unitstr", Value::Text(found)) = (name, value) {
            text = found;
        }
        Ok(())
    })?;
    Ok(text)
}

/// The value of a component.
#[derive(Debug, Clone, Copy)]
enum Value<'a> {
    Whole(usize),
    Number(f64),
    Text(&'a str),
    Numbers(&'a [u8]),
    /// Its name and components.
    Object(&'a [u8], &'a [u8]),
    /// One that says nothing about heights.
    Other,
}

/// The name of an object and its components.
fn object<'a>(bytes: &mut Bytes<'a>) -> Result<(&'a [u8], &'a [u8]), ReadError> {
    let name = bytes.zero_ended()?;
    let size = bytes.u32()?;
    Ok((name, bytes.take(size)?))
}

/// Shows each component: its name and value.
fn each<'a>(
    inside: &'a [u8],
    mut show: impl FnMut(&'a [u8], Value<'a>) -> Result<(), ReadError>,
) -> Result<(), ReadError> {
    let mut bytes = Bytes::new(inside);
    while !bytes.rest().is_empty() {
        let name = bytes.zero_ended()?;
        let value = value(&mut bytes)?;
        show(name, value)?;
    }
    Ok(())
}

/// The value that follows with its type.
fn value<'a>(bytes: &mut Bytes<'a>) -> Result<Value<'a>, ReadError> {
    let kind = bytes.u8()?;
    let several = |bytes: &mut Bytes<'a>, width: usize| {
        let count = bytes.u32()?;
        bytes.take(count.saturating_mul(width))
    };
    Ok(match kind {
        b'b' | b'c' => bytes.skip(1).map(|()| Value::Other)?,
        b'i' => Value::Whole(usize::try_from(bytes.i32()?).unwrap_or(0)),
        b'q' => bytes.skip(8).map(|()| Value::Other)?,
        b'd' => Value::Number(bytes.f64()?),
        b's' => Value::Text(std::str::from_utf8(bytes.zero_ended()?).unwrap_or_default()),
        b'o' => object(bytes).map(|(name, inside)| Value::Object(name, inside))?,
        b'C' => several(bytes, 1).map(|_| Value::Other)?,
        b'I' => several(bytes, 4).map(|_| Value::Other)?,
        b'Q' => several(bytes, 8).map(|_| Value::Other)?,
        b'D' => Value::Numbers(several(bytes, 8)?),
        b'S' => {
            let count = bytes.u32()?;
            (0..count).try_for_each(|_| bytes.zero_ended().map(|_| ()))?;
            Value::Other
        }
        b'O' => {
            let count = bytes.u32()?;
            (0..count).try_for_each(|_| object(bytes).map(|_| ()))?;
            Value::Other
        }
        other => {
            let kind = char::from(other).escape_default();
            return Err(ReadError::Damaged(format!("a value of type `{kind}`")));
        }
    })
}
