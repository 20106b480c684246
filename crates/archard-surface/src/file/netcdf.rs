//! `.nc`: NetCDF 3 of versions 1 and 2 (Unidata, "NetCDF Classic and 64-bit Offset Format Specifications"), big endian, as
//! SurfaceTopography lays a surface out.
//!
//! The variable `heights` has the dimensions `x` and `y`, places along y first; `x` and `y` have the attributes `length`, the size
//! of the map, and `unit`. Where a point was not measured, heights are their `_FillValue`, or a variable `mask` is not zero. NetCDF 4
//! is HDF5 and not read.

use super::bytes::Bytes;
use super::{ReadError, Scale, unit};
use crate::map::{HeightMap, count};

/// How these files begin, before the version.
pub(super) const MAGIC: &[u8] = b"CDF";

struct Variable {
    name: String,
    /// Which of the file's.
    dimensions: Vec<usize>,
    attributes: Attributes,
    /// The type of its numbers, and the byte that they begin at.
    kind: usize,
    begin: usize,
}

/// The first numbers of attributes by name, and the text of that named `unit`.
type Attributes = (Vec<(String, f64)>, Option<String>);

impl Variable {
    fn number(&self, name: &str) -> Option<f64> {
        self.attributes.0.iter().find(|(own, _)| own == name).map(|(_, number)| *number)
    }

    fn unit(&self) -> Option<&str> {
        self.attributes.1.as_deref()
    }
}

pub(super) fn read(all: &[u8], scale: Scale, most: usize) -> Result<HeightMap, ReadError> {
    let (dimensions, variables) = head(all)?;
    let find = |name: &str| variables.iter().find(|own| own.name == name);
    let unread = |what: &str| ReadError::Unsupported(format!("a NetCDF file {what}"));
    let heights = find("heights").ok_or_else(|| unread("without a variable `heights`"))?;
    let [x, y] = heights.dimensions[..] else {
        return Err(unread("whose `heights` are no map over `x` and `y`"));
    };
    let named = [x, y].map(|which| dimensions.get(which).map(|(name, _)| &**name));
    if named != [Some("x"), Some("y")] {
        return Err(unread("whose `heights` are no map over `x` and `y`"));
    }
    let elements = [x, y].map(|which| dimensions[which].1);
    let points = count(elements, most)?;
    let along = [find("x"), find("y")];
    let units = [along[0], along[1], Some(heights)].map(|own| own.and_then(Variable::unit));
    // One unit serves for all, as SurfaceTopography has it.
    let own = units.into_iter().flatten().next().ok_or_else(|| unread("that tells no unit"))?;
    let of_heights = unit(units[2].unwrap_or(own))?;
    let size = |axis: usize| {
        let length = along[axis].and_then(|own| own.number("length"));
        length.map(|length| length / elements[axis] as f64)
    };
    let pixel = match (scale.pixel, [size(0), size(1)]) {
        (Some(pixel), _) => pixel,
        (None, [Some(x), Some(y)]) => {
            let [of_x, of_y] = [unit(units[0].unwrap_or(own))?, unit(units[1].unwrap_or(own))?];
            [x * of_x, y * of_y]
        }
        _ => return Err(ReadError::Scale("the size of a pixel, `pixel`")),
    };
    let values = values(all, heights, points)?;
    let mask = match find("mask") {
        Some(mask) if mask.dimensions == heights.dimensions => self::values(all, mask, points)?,
        _ => vec![0.0; points],
    };
    let fill = heights.number("_FillValue");
    // From places along y first to those along x first.
    let place = |at: usize| at % elements[0] * elements[1] + at / elements[0];
    let height = |at: usize| match values[place(at)] {
        value if mask[place(at)] == 0.0 && Some(value) != fill => value * of_heights,
        _ => f64::NAN,
    };
    Ok(HeightMap::new(elements, pixel, (0..points).map(height).collect())?)
}

/// Dimensions by name and length, and variables.
type Head = (Vec<(String, usize)>, Vec<Variable>);

fn head(all: &[u8]) -> Result<Head, ReadError> {
    let mut bytes = Bytes::new(all);
    bytes.skip(MAGIC.len())?;
    let wide = match bytes.u8()? {
        1 => false,
        2 => true,
        version => return Err(ReadError::Unsupported(format!("NetCDF of version {version}"))),
    };
    // Records: a surface has no such thing.
    number(&mut bytes)?;
    let mut dimensions = vec![];
    for _ in 0..list(&mut bytes, 10)? {
        dimensions.push((name(&mut bytes)?, number(&mut bytes)?));
    }
    attributes(&mut bytes)?;
    let mut variables = vec![];
    for _ in 0..list(&mut bytes, 11)? {
        let name = name(&mut bytes)?;
        let mut own = vec![];
        for _ in 0..number(&mut bytes)? {
            own.push(number(&mut bytes)?);
        }
        let attributes = attributes(&mut bytes)?;
        let kind = number(&mut bytes)?;
        // Its size follows from dimensions and kind.
        number(&mut bytes)?;
        let high = if wide { number(&mut bytes)? } else { 0 };
        let begin = (high << 32) | number(&mut bytes)?;
        variables.push(Variable { name, dimensions: own, attributes, kind, begin });
    }
    Ok((dimensions, variables))
}

fn attributes(bytes: &mut Bytes<'_>) -> Result<Attributes, ReadError> {
    let (mut numbers, mut unit) = (vec![], None);
    for _ in 0..list(bytes, 12)? {
        let name = name(bytes)?;
        let (kind, count) = (number(bytes)?, number(bytes)?);
        let length = count.saturating_mul(width(kind)?);
        if kind == CHAR {
            let text = bytes.text(length)?;
            unit = unit.or_else(|| (name == "unit").then_some(text));
        } else {
            numbers.extend(numbers_of(bytes.take(length)?, kind).next().map(|first| (name, first)));
        }
        bytes.skip(length.wrapping_neg() % 4)?;
    }
    Ok((numbers, unit))
}

/// The values of a variable of so many points.
fn values(all: &[u8], own: &Variable, points: usize) -> Result<Vec<f64>, ReadError> {
    let needed = own.begin.saturating_add(points * width(own.kind)?);
    let found = all.len();
    let short = ReadError::Short { found, needed };
    Ok(numbers_of(all.get(own.begin..needed).ok_or(short)?, own.kind).collect())
}

/// The length of a list of that tag.
fn list(bytes: &mut Bytes<'_>, tag: usize) -> Result<usize, ReadError> {
    match (number(bytes)?, number(bytes)?) {
        (0, 0) => Ok(0),
        (found, length) if found == tag => Ok(length),
        _ => Err(ReadError::Damaged("its head has no list where one begins".to_owned())),
    }
}

fn name(bytes: &mut Bytes<'_>) -> Result<String, ReadError> {
    let length = number(bytes)?;
    let name = bytes.text(length)?;
    bytes.skip(length.wrapping_neg() % 4)?;
    Ok(name)
}

fn number(bytes: &mut Bytes<'_>) -> Result<usize, ReadError> {
    let four = bytes.take(4)?;
    Ok(four.iter().fold(0, |number, byte| number << 8 | usize::from(*byte)))
}

/// The type of texts.
const CHAR: usize = 2;

/// Bytes of a number of a type.
fn width(kind: usize) -> Result<usize, ReadError> {
    match kind {
        1 | CHAR => Ok(1),
        3 => Ok(2),
        4 | 5 => Ok(4),
        6 => Ok(8),
        _ => Err(ReadError::Damaged(format!("numbers of the type {kind}, which is not known"))),
    }
}

/// The numbers of a type in bytes: whole ones of 1, 2 and 4 bytes, and floating ones of 4 and 8.
fn numbers_of(bytes: &[u8], kind: usize) -> impl Iterator<Item = f64> {
    bytes.chunks_exact(width(kind).unwrap_or(1)).map(move |own| match (kind, own) {
        (5, &[a, b, c, d]) => f64::from(f32::from_be_bytes([a, b, c, d])),
        (4, &[a, b, c, d]) => f64::from(i32::from_be_bytes([a, b, c, d])),
        (3, &[a, b]) => f64::from(i16::from_be_bytes([a, b])),
        (1, &[a]) => f64::from(i8::from_be_bytes([a])),
        (_, own) => own.try_into().map_or(f64::NAN, f64::from_be_bytes),
    })
}
