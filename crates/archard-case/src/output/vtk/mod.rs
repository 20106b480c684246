//! VTK's XML files, written and read back: images, surfaces, and the collection that lists them.
//!
//! A file is a description in XML, and below it the arrays that the description names. `arrays` knows how both are laid
//! out, for writing and for reading; `image_data`, `unstructured_grid` and `collection` say what stands in each kind of
//! file. The layout is that of the VTK file formats guide (Kitware, "XML File Formats"). Only files of this program
//! are read.
//!
//! The crate `vtkio` (0.7.0-rc2) is no replacement: it keeps the grid of an image in single precision and writes arrays
//! as base64 text, which takes a third more room.

mod arrays;
mod collection;
mod image_data;
mod points;
mod rectilinear;
mod unstructured_grid;

use std::io;
use std::path::Path;

pub use collection::Collection;

use super::{Error, Place, Planes, WornSurface};
use crate::files::{self, Contents};

/// What is kept in a file of its own kind.
pub(super) trait Kept: Sized {
    /// The bytes of the file.
    fn encode(&self) -> io::Result<Vec<u8>>;

    /// What the bytes of a file hold, or what is wrong with them.
    fn decode(bytes: &[u8]) -> Result<Self, String>;
}

/// Writes a file.
pub(super) fn write(kept: &impl Kept, place: &Place) -> Result<(), Error> {
    let refused = |source| Error::Write { path: place.path().to_owned(), source };
    place.write(&kept.encode().map_err(refused)?)
}

/// Writes the file of a worn surface, which this program does not read.
pub(super) fn write_points(surface: &WornSurface, place: &Place) -> Result<(), Error> {
    let refused = |source| Error::Write { path: place.path().to_owned(), source };
    place.write(&points::encode(surface).map_err(refused)?)
}

/// Writes the file of stresses in planes, which this program does not read.
pub(super) fn write_planes(planes: &Planes, place: &Place) -> Result<(), Error> {
    let refused = |source| Error::Write { path: place.path().to_owned(), source };
    place.write(&rectilinear::encode(planes).map_err(refused)?)
}

/// What the bytes of a file that [`write`] wrote hold, or what is wrong with them.
pub(super) fn decode<T: Kept>(bytes: &[u8]) -> Result<T, String> {
    T::decode(bytes)
}

/// Reads a file that [`write`] wrote.
pub(super) fn read<T: Kept>(path: &Path) -> Result<T, Error> {
    let bytes = files::read(path, Contents::Numbers)
        .map_err(|source| Error::Read { path: path.to_owned(), source })?;
    T::decode(&bytes).map_err(|what| Error::NotAnImage { path: path.to_owned(), what })
}
