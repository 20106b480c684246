//! The bytes of a mesh file, read as words of a text or as binary numbers.

use super::error::{Fault, MeshFileError, Place};

/// A place in the bytes of a file, moving on.
#[derive(Debug, Clone)]
pub(super) struct Source<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Whether numbers are binary.
    pub binary: bool,
    /// Whether binary numbers begin with their highest byte.
    pub swapped: bool,
}

impl<'a> Source<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0, binary: false, swapped: false }
    }

    /// An error here.
    pub fn error(&self, fault: Fault) -> MeshFileError {
        let place = if self.binary {
            Place::Byte(self.at)
        } else {
            let before = &self.bytes[..self.at];
            Place::Line(1 + before.iter().filter(|&&byte| byte == b'\n').count())
        };
        MeshFileError { place, fault }
    }

    /// What is left.
    pub fn rest(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// The next word of a text.
    pub fn word(&mut self, expected: &'static str) -> Result<&'a str, MeshFileError> {
        self.skip(|byte| byte.is_ascii_whitespace());
        let start = self.at;
        let rest = self.rest();
        if rest.is_empty() {
            return Err(self.error(Fault::Ends { expected }));
        }
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        self.at += length;
        std::str::from_utf8(&rest[..length]).map_err(|_| {
            let found = String::from_utf8_lossy(&rest[..length.min(40)]).into_owned();
            let here = Self { at: start, ..self.clone() };
            here.error(Fault::Unexpected { expected, found })
        })
    }

    /// The next word of a text as a number.
    pub fn parse<T: std::str::FromStr>(
        &mut self,
        expected: &'static str,
    ) -> Result<T, MeshFileError> {
        let word = self.word(expected)?;
        word.parse().map_err(|_| {
            let found = word.chars().take(40).collect();
            self.error(Fault::Unexpected { expected, found })
        })
    }

    /// The rest of the line, with its end.
    pub fn line(&mut self) -> String {
        let rest = self.rest();
        let length = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
        self.at += (length + 1).min(rest.len());
        String::from_utf8_lossy(&rest[..length]).trim().to_owned()
    }

    /// A text in quotes.
    pub fn quoted(&mut self, expected: &'static str) -> Result<String, MeshFileError> {
        self.skip(|byte| byte.is_ascii_whitespace());
        let line = self.line();
        match line.strip_prefix('"').and_then(|text| text.strip_suffix('"')) {
            Some(text) => Ok(text.to_owned()),
            None => {
                let found = line.chars().take(40).collect();
                Err(self.error(Fault::Unexpected { expected, found }))
            }
        }
    }

    fn skip(&mut self, such: impl Fn(u8) -> bool) {
        let rest = self.rest();
        self.at += rest.iter().position(|&byte| !such(byte)).unwrap_or(rest.len());
    }

    /// Moves behind the next place where that text stands.
    pub fn behind(&mut self, text: &'static str) -> Result<(), MeshFileError> {
        let found = self.rest().windows(text.len()).position(|window| window == text.as_bytes());
        match found {
            Some(found) => {
                self.at += found + text.len();
                Ok(())
            }
            None => Err(self.error(Fault::Ends { expected: text })),
        }
    }

    /// The next bytes.
    pub fn take<const N: usize>(
        &mut self,
        expected: &'static str,
    ) -> Result<[u8; N], MeshFileError> {
        match self.rest().first_chunk::<N>() {
            Some(bytes) => {
                self.at += N;
                Ok(*bytes)
            }
            None => Err(self.error(Fault::Ends { expected })),
        }
    }

    fn number<const N: usize>(&mut self, expected: &'static str) -> Result<[u8; N], MeshFileError> {
        let mut bytes = self.take::<N>(expected)?;
        if self.swapped {
            bytes.reverse();
        }
        Ok(bytes)
    }

    /// A whole number, of 4 bytes where numbers are binary.
    pub fn int(&mut self, expected: &'static str) -> Result<i64, MeshFileError> {
        if self.binary {
            Ok(i64::from(i32::from_le_bytes(self.number(expected)?)))
        } else {
            self.parse(expected)
        }
    }

    /// A whole number that is zero or greater, of 4 bytes where numbers are binary.
    pub fn index(&mut self, expected: &'static str) -> Result<u64, MeshFileError> {
        let number = self.int(expected)?;
        u64::try_from(number)
            .map_err(|_| self.error(Fault::Unexpected { expected, found: number.to_string() }))
    }

    /// A count or tag, of 8 bytes where numbers are binary.
    pub fn size(&mut self, expected: &'static str) -> Result<u64, MeshFileError> {
        if self.binary {
            Ok(u64::from_le_bytes(self.number(expected)?))
        } else {
            self.parse(expected)
        }
    }

    /// A number, finite.
    pub fn double(&mut self, expected: &'static str) -> Result<f64, MeshFileError> {
        let number = if self.binary {
            f64::from_le_bytes(self.number(expected)?)
        } else {
            self.parse(expected)?
        };
        self.finite(number, expected)
    }

    /// That number, or an error if it is not finite.
    pub fn finite(&self, number: f64, expected: &'static str) -> Result<f64, MeshFileError> {
        if number.is_finite() {
            return Ok(number);
        }
        Err(self.error(Fault::Unexpected { expected, found: number.to_string() }))
    }
}
