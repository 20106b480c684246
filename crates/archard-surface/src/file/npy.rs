//! `.npy` of NumPy: a matrix, whose rows run along x.
//!
//! A head names the kind of the numbers, their order and the shape as a Python dict with three keys that count. The packages
//! that read it bring a parser of Python with them; this needs none.

use super::bytes::Bytes;
use super::{ReadError, Scale, matrix};
use crate::map::{self, HeightMap};

/// How files begin.
pub(super) const MAGIC: &[u8] = b"\x93NUMPY";

pub(super) fn read(all: &[u8], scale: Scale, most: usize) -> Result<HeightMap, ReadError> {
    let mut bytes = Bytes::new(all);
    bytes.skip(MAGIC.len())?;
    let version = bytes.u8()?;
    bytes.skip(1)?;
    let length = match version {
        1 => usize::from(bytes.u16()?),
        2 | 3 => usize::try_from(bytes.i32()?).unwrap_or(usize::MAX),
        _ => return Err(ReadError::Unsupported(format!("version {version} of .npy"))),
    };
    let head = bytes.text(length)?;
    let missing = |key: &str| ReadError::Unsupported(format!("an .npy without `{key}`"));
    let kind = after(&head, "descr").and_then(quoted).ok_or_else(|| missing("descr"))?;
    let order = after(&head, "fortran_order").ok_or_else(|| missing("fortran_order"))?;
    let shape = after(&head, "shape").and_then(shape).ok_or_else(|| missing("shape"))?;
    let &[ny, nx] = &shape[..] else {
        return Err(ReadError::Unsupported(format!("an array of {} axes", shape.len())));
    };
    let count = map::count([nx, ny], most)?;
    let unknown = || ReadError::Unsupported(format!("an array of `{kind}`"));
    let (order_of_bytes, number) = kind.split_at_checked(1).ok_or_else(unknown)?;
    let (width, value) = number_of(number).ok_or_else(unknown)?;
    let big = match order_of_bytes {
        "<" | "|" => false,
        ">" => true,
        _ => return Err(unknown()),
    };
    let data = bytes.take(count * width)?;
    let values: Vec<f64> = data
        .chunks_exact(width)
        .map(|point| {
            // Little-endian, in the lowest of eight bytes.
            let mut word = [0; 8];
            word[..width].copy_from_slice(point);
            if big {
                word[..width].reverse();
            }
            value(word)
        })
        .collect();
    let values = match order.starts_with("True") {
        false => values,
        true => (0..count).map(|at| values[(at % nx) * ny + at / nx]).collect(),
    };
    matrix([nx, ny], values, scale)
}

/// What follows a key of the head.
fn after<'a>(head: &'a str, key: &str) -> Option<&'a str> {
    let (_, rest) = head.split_once(&format!("'{key}'"))?;
    rest.trim_start().strip_prefix(':').map(str::trim_start)
}

/// A text in quotes.
fn quoted(text: &str) -> Option<&str> {
    text.strip_prefix('\'')?.split_once('\'').map(|(text, _)| text)
}

/// The lengths of the axes.
fn shape(text: &str) -> Option<Vec<usize>> {
    let (inside, _) = text.strip_prefix('(')?.split_once(')')?;
    let axes = inside.split(',').map(str::trim).filter(|axis| !axis.is_empty());
    axes.map(|axis| axis.parse().ok()).collect()
}

/// How many bytes a kind of number has, and what they mean.
type Number = (usize, fn([u8; 8]) -> f64);

fn number_of(kind: &str) -> Option<Number> {
    macro_rules! of {
        ($type:ty) => {
            (size_of::<$type>(), |word: [u8; 8]| {
                let mut own = [0; size_of::<$type>()];
                own.copy_from_slice(&word[..size_of::<$type>()]);
                <$type>::from_le_bytes(own) as f64
            })
        };
    }
    Some(match kind {
        "f8" => of!(f64),
        "f4" => of!(f32),
        "i8" => of!(i64),
        "i4" => of!(i32),
        "i2" => of!(i16),
        "i1" => of!(i8),
        "u8" => of!(u64),
        "u4" => of!(u32),
        "u2" => of!(u16),
        "u1" => of!(u8),
        _ => return None,
    })
}
