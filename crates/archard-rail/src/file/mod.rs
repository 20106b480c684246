//! Files of profiles: SIMPACK `.prr` and `.prw`, MiniProf `.ban` and `.whl`, and two columns.
//!
//! A reader takes the bytes of a file and gives a [`Document`]; a writer gives the text of a file. None of them touches
//! the disk. Values that a file needs and does not hold are in its [`Format`].

mod columns;
mod error;
mod lines;
mod miniprof;
mod simpack;

pub use error::{Cause, ReadError};

use crate::oddity::Finding;
use crate::profile::{MOST_POINTS, Part, Profile};

/// Most bytes of a file of a profile.
pub const MOST_BYTES: usize = 16 << 20;

/// How a file of a profile is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Format {
    /// SIMPACK: keys with values, then points. Y to the field side, z downwards unless its keys mirror them.
    Simpack(Part),
    /// MiniProf: millimetres, Y upwards, the order of the points either way.
    MiniProf {
        /// Which part was measured.
        part: Part,
        /// Whether X points to the middle of the track. The file does not tell, and the extension neither: it depends on
        /// the rail and on how the instrument was put on. [`Oddity::Flange`](crate::oddity::Oddity) warns of a wheel.
        mirrored: bool,
        /// How a file is written; a reader finds out by itself.
        flavour: Flavour,
    },
    /// Two columns, y and z.
    Columns {
        /// Which part it is.
        part: Part,
        /// Length (m) of the unit.
        unit: f64,
        /// Whether the second column points upwards.
        upwards: bool,
        /// Whether the first column points to the middle of the track.
        mirrored: bool,
        /// Whether a comma stands between the columns when it is written; a reader takes any separator.
        comma: bool,
    },
}

/// The two ways in which MiniProf writes the head of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flavour {
    /// Lines of `Key=Value`.
    Keys,
    /// A line with `#`, then lines of any text.
    Free,
}

impl Format {
    /// The format that an extension such as `prr` stands for; `None` if it is not known.
    ///
    /// The part counts only where the extension does not tell it; columns are in that unit (m).
    pub fn of_extension(extension: &str, part: Part, unit: f64) -> Option<Self> {
        let miniprof = |part| Self::MiniProf { part, mirrored: false, flavour: Flavour::Keys };
        let columns = |comma| Self::Columns { part, unit, upwards: false, mirrored: false, comma };
        Some(match extension.trim_start_matches('.').to_ascii_lowercase().as_str() {
            "prr" => Self::Simpack(Part::Rail),
            "prw" => Self::Simpack(Part::Wheel),
            "ban" => miniprof(Part::Rail),
            "whl" => miniprof(Part::Wheel),
            "csv" => columns(true),
            "txt" | "dat" => columns(false),
            _ => return None,
        })
    }

    /// Which part the file is of.
    pub fn part(&self) -> Part {
        match *self {
            Self::Simpack(part) | Self::MiniProf { part, .. } | Self::Columns { part, .. } => part,
        }
    }
}

/// What a file holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    /// The points, in metres, y to the field side, z downwards.
    pub profile: Profile,
    /// The line of each point, numbered from 1.
    pub lines: Vec<usize>,
    /// What looks wrong, with the lines.
    pub findings: Vec<Finding>,
}

/// Points as a reader collects them.
#[derive(Default)]
struct Points {
    values: Vec<[f64; 2]>,
    lines: Vec<usize>,
    findings: Vec<Finding>,
}

impl Points {
    fn push(&mut self, line: usize, point: [f64; 2]) -> Result<(), ReadError> {
        if self.values.len() == MOST_POINTS {
            return Err(ReadError { line, cause: Cause::TooMany });
        }
        self.values.push(point);
        self.lines.push(line);
        Ok(())
    }

    fn odd(&mut self, line: usize, oddity: crate::oddity::Oddity) {
        self.findings.push(Finding { point: None, line: Some(line), oddity });
    }

    fn map(&mut self, map: impl Fn([f64; 2]) -> [f64; 2]) {
        self.values.iter_mut().for_each(|point| *point = map(*point));
    }

    fn reverse(&mut self) {
        self.values.reverse();
        self.lines.reverse();
    }

    fn finish(self, part: Part, last: usize) -> Result<Document, ReadError> {
        let Self { values, lines, mut findings } = self;
        let at = values.iter().position(|point| !point.iter().all(|value| value.abs() < 1e3));
        if let Some(at) = at {
            return Err(ReadError { line: lines[at], cause: Cause::Far });
        }
        let found = values.len();
        let profile = Profile::new(values)
            .map_err(|_| ReadError { line: last, cause: Cause::TooFew { found } })?;
        for mut finding in profile.oddities(part) {
            finding.line = finding.point.and_then(|point| lines.get(point - 1).copied());
            findings.push(finding);
        }
        Ok(Document { profile, lines, findings })
    }
}

/// The profile in those bytes of a file.
///
/// # Errors
/// With its line, anything that cannot be read.
pub fn read(bytes: &[u8], format: Format) -> Result<Document, ReadError> {
    if bytes.len() > MOST_BYTES {
        return Err(ReadError { line: 1, cause: Cause::TooLong });
    }
    let text = lines::decode(bytes);
    match format {
        Format::Simpack(part) => simpack::read(&text, part),
        Format::MiniProf { part, mirrored, .. } => miniprof::read(&text, part, mirrored),
        Format::Columns { .. } => columns::read(&text, format),
    }
}

/// The text of a file of that format with that profile.
///
/// Numbers are written with as many digits as make them read the same again.
pub fn write(profile: &Profile, format: Format) -> String {
    match format {
        Format::Simpack(part) => simpack::write(profile, part),
        Format::MiniProf { part, mirrored, flavour } => {
            miniprof::write(profile, part, mirrored, flavour)
        }
        Format::Columns { .. } => columns::write(profile, format),
    }
}

#[cfg(test)]
mod tests;
