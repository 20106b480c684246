//! Measured surfaces: heights on a grid, read from the files of instruments, and what standards tell of them.
//!
//! [`file::read`] takes the bytes of a file and gives a [`HeightMap`]; [`Texture`] has its parameters after ISO 25178-2, [`Spectrum`] the
//! wavelengths it is made of. Maps are levelled ([`Polynomial`]), lose their nominal shape ([`Nominal`]), their outliers, their short or long
//! waves, and are put onto other points by the functions of [`HeightMap`]. Everything is in SI units.
//!
//! ```
//! use archard_surface::file::{Format, Scale, read};
//! use archard_surface::Texture;
//!
//! let text = b"0 1 0 1\n1 0 1 0\n0 1 0 1\n";
//! let scale = Scale { pixel: Some([2e-6; 2]), unit: Some(1e-6) };
//! let map = read(text, Format::Text, scale)?;
//! assert_eq!(map.elements(), [4, 3]);
//! assert!((Texture::of(&map).mean_deviation - 0.5e-6).abs() < 1e-20);
//! # Ok::<(), archard_surface::file::ReadError>(())
//! ```

#![warn(missing_docs)]

pub mod difference;
pub mod file;
mod filter;
mod fit;
mod form;
mod level;
mod map;
mod means;
mod outliers;
mod plausible;
mod prepare;
pub mod scar;
mod spectrum;
mod texture;

#[cfg(test)]
mod tests;

pub use filter::NoFilter;
pub use form::{Form, NoForm, Nominal};
pub use level::{Level, Polynomial};
pub use map::{HeightMap, MOST, NoMap};
pub use means::NoMeans;
pub use outliers::Outliers;
pub use plausible::Implausible;
pub use spectrum::{LostDetail, Mode, Spectrum, Window};
pub use texture::Texture;
