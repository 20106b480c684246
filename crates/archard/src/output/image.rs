//! All fields of one output on their grid.

use std::path::Path;

use super::{Error, Field, Surface, fields, vtk};
use crate::problem::{ContactProblem, ContactState};

/// Fields on a uniform grid of elements, as kept in a `.vti` file (VTK's XML image data).
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    /// The lowest corner along x and y (m).
    pub origin: [f64; 2],
    /// Size of an element along x and y (m).
    pub spacing: [f64; 2],
    /// Number of elements along x and y.
    pub elements: [usize; 2],
    /// The fields, one value an element, x running fastest.
    pub fields: Vec<Field>,
}

impl Image {
    /// The image of a state on a uniform frame; see [`fields()`] for what is on it.
    pub fn of(problem: &ContactProblem, state: &ContactState) -> Self {
        Self {
            origin: problem.frame.rectangle().corner(),
            spacing: problem.frame.spacing(),
            elements: problem.frame.elements(),
            fields: fields(problem, state),
        }
    }

    /// The values of the field of that name, if there is one.
    pub fn field(&self, name: &str) -> Option<&[f64]> {
        let field = self.fields.iter().find(|field| field.name == name)?;
        Some(&field.values)
    }

    /// Centre (m) of the element of that index along an axis (0: x, 1: y).
    pub fn centre(&self, axis: usize, index: usize) -> f64 {
        self.origin[axis] + (index as f64 + 0.5) * self.spacing[axis]
    }

    /// Writes a `.vti` file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        vtk::write(self, path)
    }

    /// Reads a `.vti` file that [`Image::write`] wrote; it does not read those of other programs.
    ///
    /// # Errors
    /// If the file cannot be read, is damaged or is written in another way.
    pub fn read(path: &Path) -> Result<Self, Error> {
        vtk::read(path)
    }

    /// The image in the bytes of a `.vti` file that [`Image::write`] wrote.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, String> {
        vtk::decode(bytes)
    }

    /// Reads an output of either kind: a `.vti` file, or a `.vtu` file as its surface looks along z.
    ///
    /// # Errors
    /// As [`Image::read`] and [`Surface::read`].
    pub fn of_output(path: &Path) -> Result<Self, Error> {
        let surface = path.extension().is_some_and(|extension| extension == "vtu");
        if surface { Ok(Surface::read(path)?.image()) } else { Self::read(path) }
    }
}
