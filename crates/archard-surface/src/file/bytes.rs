//! Little-endian numbers out of bytes, in order.

use super::ReadError;

/// Bytes that are read from the start on.
pub(super) struct Bytes<'a> {
    all: &'a [u8],
    at: usize,
}

impl<'a> Bytes<'a> {
    pub fn new(all: &'a [u8]) -> Self {
        Self { all, at: 0 }
    }

    /// The next so many bytes.
    pub fn take(&mut self, count: usize) -> Result<&'a [u8], ReadError> {
        let end = self.at.saturating_add(count);
        let short = ReadError::Short { found: self.all.len(), needed: end };
        let taken = self.all.get(self.at..end).ok_or(short)?;
        self.at = end;
        Ok(taken)
    }

    pub fn skip(&mut self, count: usize) -> Result<(), ReadError> {
        self.take(count).map(|_| ())
    }

    /// The bytes up to the next zero, which is left out.
    pub fn zero_ended(&mut self) -> Result<&'a [u8], ReadError> {
        let rest = self.rest();
        let length = rest.iter().position(|&byte| byte == 0);
        let found = self.all.len();
        let taken = self.take(length.ok_or(ReadError::Short { found, needed: found + 1 })?)?;
        self.skip(1)?;
        Ok(taken)
    }

    /// What was not read yet.
    pub fn rest(&self) -> &'a [u8] {
        self.all.get(self.at..).unwrap_or_default()
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], ReadError> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N)?);
        Ok(array)
    }

    pub fn u8(&mut self) -> Result<u8, ReadError> {
        Ok(u8::from_le_bytes(self.array()?))
    }

    pub fn u16(&mut self) -> Result<u16, ReadError> {
        Ok(u16::from_le_bytes(self.array()?))
    }

    pub fn u32(&mut self) -> Result<usize, ReadError> {
        Ok(u32::from_le_bytes(self.array()?) as usize)
    }

    pub fn i32(&mut self) -> Result<i32, ReadError> {
        Ok(i32::from_le_bytes(self.array()?))
    }

    pub fn f32(&mut self) -> Result<f64, ReadError> {
        Ok(f64::from(f32::from_le_bytes(self.array()?)))
    }

    pub fn f64(&mut self) -> Result<f64, ReadError> {
        Ok(f64::from_le_bytes(self.array()?))
    }

    /// A text of so many bytes: UTF-8, or else each a letter of Latin-1.
    pub fn text(&mut self, count: usize) -> Result<String, ReadError> {
        let bytes = self.take(count)?;
        let latin = || bytes.iter().map(|&byte| char::from(byte)).collect();
        Ok(std::str::from_utf8(bytes).map_or_else(|_| latin(), str::to_owned))
    }
}

/// How a file begins, to be shown.
pub(super) fn beginning(bytes: &[u8]) -> String {
    let first = &bytes[..bytes.len().min(12)];
    format!("`{}`", first.escape_ascii())
}
