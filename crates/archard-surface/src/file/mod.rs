//! Files of instruments and programs.
//!
//! - `.sur` of Digital Surf (little endian, 16 or 32 bits);
//! - `.sdf` of ISO 25178-71, binary and text;
//! - `.x3p` of ISO 25178-72, with all types of numbers and the marks of points that were not measured;
//! - `.gwy` of Gwyddion: the first channel of heights, without what its mask covers;
//! - `.nc` of SurfaceTopography, NetCDF 3;
//! - `.npy` of NumPy, a matrix of numbers;
//! - text and CSV, a row of heights for each row of points, with commas, semicolons, tabs or blanks between.
//!
//! Of the last two nothing gives the size of a pixel and the unit of heights: [`Scale`] does.
//!
//! Rows run along x, and the first row has the lowest y, in every format: so ISO 25178-72 defines it, and so SurfaceTopography
//! and surfalize read the others. Gwyddion and MountainsMap draw the first row at the top, where a picture with y upwards has
//! the highest y; [`HeightMap::flipped`] sets a map as they draw it.

mod bytes;
mod digital_surf;
mod gwyddion;
mod known;
mod netcdf;
mod npy;
mod sdf;
mod text;
mod x3p;

#[cfg(test)]
mod tests;

use crate::map::{HeightMap, MOST, NoMap};

/// A format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Digital Surf.
    DigitalSurf,
    /// ISO 25178-71.
    Sdf,
    /// ISO 25178-72.
    X3p,
    /// Gwyddion.
    Gwyddion,
    /// NetCDF 3.
    NetCdf,
    /// NumPy.
    Npy,
    /// Rows of numbers.
    Text,
}

impl Format {
    /// The format of an extension such as `sur`; `None` if it is not known.
    pub fn of_extension(extension: &str) -> Option<Self> {
        Some(match extension.trim_start_matches('.').to_ascii_lowercase().as_str() {
            "sur" => Self::DigitalSurf,
            "sdf" => Self::Sdf,
            "x3p" => Self::X3p,
            "gwy" => Self::Gwyddion,
            "nc" => Self::NetCdf,
            "npy" => Self::Npy,
            "csv" | "txt" | "asc" | "dat" => Self::Text,
            _ => return None,
        })
    }

    /// The format of a file by its first bytes; `None` of text, and of what is not read.
    pub fn of_bytes(bytes: &[u8]) -> Option<Self> {
        known::of(bytes)?.format
    }

    /// What it is called, with its ending.
    pub fn name(self) -> &'static str {
        match self {
            Self::DigitalSurf => "Digital Surf (.sur)",
            Self::Sdf => "SDF (.sdf)",
            Self::X3p => "X3P (.x3p)",
            Self::Gwyddion => "Gwyddion (.gwy)",
            Self::NetCdf => "NetCDF (.nc)",
            Self::Npy => "NumPy (.npy)",
            Self::Text => "text",
        }
    }

    /// Whether a file says how large its pixels are, and in which unit its heights.
    pub fn tells_its_scale(self) -> bool {
        !matches!(self, Self::Npy | Self::Text)
    }
}

/// What a file does not say, or says wrongly.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Scale {
    /// Size (m) of a pixel along x and y, in the place of what the file has.
    pub pixel: Option<[f64; 2]>,
    /// Unit (m) of the numbers of a matrix; of a file that gives its own a factor on its heights is refused.
    pub unit: Option<f64>,
}

/// Why a file cannot be read.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ReadError {
    /// The file is of another format than its ending says.
    #[error("is no {wanted} file: {found}")]
    Format {
        /// What it should be.
        wanted: &'static str,
        /// What it is, or how it begins.
        found: String,
    },
    /// The file was changed after it was written, or its parts do not fit each other.
    #[error("is damaged: {0}")]
    Damaged(String),
    /// The file ends too early.
    #[error("ends after {found} bytes, and {needed} are needed: it was cut off")]
    Short {
        /// Bytes that there are.
        found: usize,
        /// Bytes that there should be.
        needed: usize,
    },
    /// Something that is not read.
    #[error("{0} is not read: save it another way")]
    Unsupported(String),
    /// A unit that is not known.
    #[error("`{0}` is no unit of length")]
    Unit(String),
    /// A number that cannot be read.
    #[error("line {line}: `{word}` is no number")]
    Number {
        /// The line, from 1.
        line: usize,
        /// What stands there.
        word: String,
    },
    /// Rows of different lengths.
    #[error("line {line}: {found} numbers, and the rows before have {needed}")]
    Row {
        /// The line, from 1.
        line: usize,
        /// Numbers in it.
        found: usize,
        /// Numbers in the rows before.
        needed: usize,
    },
    /// The size of pixels or the unit of heights is not known.
    #[error("nothing in the file tells {0}: give it")]
    Scale(&'static str),
    /// The file gives its unit by itself.
    #[error("the file tells the unit of its heights itself: leave `unit` out")]
    Told,
    /// The heights make no map.
    #[error(transparent)]
    Map(#[from] NoMap),
}

/// The heights in those bytes of a file.
///
/// # Errors
/// If they are not of that format, cut off or damaged, or their scale is not known.
pub fn read(bytes: &[u8], format: Format, scale: Scale) -> Result<HeightMap, ReadError> {
    read_up_to(bytes, format, scale, MOST)
}

/// The same of so many points at most, for whom memory is short: a packed file of a few kilobytes may hold millions.
///
/// # Errors
/// As [`read`], and if there are more points, before memory is taken for them.
pub fn read_up_to(
    bytes: &[u8],
    format: Format,
    scale: Scale,
    most: usize,
) -> Result<HeightMap, ReadError> {
    if format.tells_its_scale() && scale.unit.is_some() {
        return Err(ReadError::Told);
    }
    known::expect(bytes, format)?;
    let most = most.min(MOST);
    match format {
        Format::DigitalSurf => digital_surf::read(bytes, scale, most),
        Format::Sdf => sdf::read(bytes, scale, most),
        Format::X3p => x3p::read(bytes, scale, most),
        Format::Gwyddion => gwyddion::read(bytes, scale, most),
        Format::NetCdf => netcdf::read(bytes, scale, most),
        Format::Npy => npy::read(bytes, scale, most),
        Format::Text => text::read(bytes, scale, most),
    }
}

/// The map of a matrix in the unit of the scale.
fn matrix(elements: [usize; 2], values: Vec<f64>, scale: Scale) -> Result<HeightMap, ReadError> {
    let pixel = scale.pixel.ok_or(ReadError::Scale("the size of a pixel, `pixel`"))?;
    let unit = scale.unit.ok_or(ReadError::Scale("the unit of its heights, `unit`"))?;
    let heights = values.into_iter().map(|value| value * unit).collect();
    Ok(HeightMap::new(elements, pixel, heights)?)
}

/// A unit of length (m) as instruments write it.
///
/// # Errors
/// If it cannot be one.
pub fn unit(text: &str) -> Result<f64, ReadError> {
    let word = text.trim_matches(|letter: char| letter.is_whitespace() || letter == '\0');
    Ok(match word {
        "m" => 1.0,
        "mm" => 1e-3,
        "\u{b5}m" | "\u{3bc}m" | "um" | "\u{e6}m" => 1e-6,
        "nm" => 1e-9,
        "\u{c5}" | "A" => 1e-10,
        "pm" => 1e-12,
        "in" | "inch" => 25.4e-3,
        other => return Err(ReadError::Unit(other.to_owned())),
    })
}
