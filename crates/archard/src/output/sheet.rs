//! Places in a body with what is found there, and the cells between them.

use std::path::Path;

use super::{Error, Field, vtk};

/// Places that share cells, in SI, as kept in a `.vtu` file (VTK's XML unstructured grids with point data).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sheet {
    /// Places (m).
    pub points: Vec<[f64; 3]>,
    /// The places of each cell, around it.
    pub cells: Vec<Vec<usize>>,
    /// Fields, one value a place.
    pub fields: Vec<Field>,
    /// Vectors by their names, one a place.
    pub vectors: Vec<(String, Vec<[f64; 3]>)>,
}

impl Sheet {
    /// Writes a `.vtu` file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        vtk::write(self, path)
    }

    /// Reads a `.vtu` file that [`Sheet::write`] wrote; it does not read those of other programs.
    ///
    /// # Errors
    /// If the file cannot be read, is damaged or is written in another way.
    pub fn read(path: &Path) -> Result<Self, Error> {
        vtk::read(path)
    }
}
