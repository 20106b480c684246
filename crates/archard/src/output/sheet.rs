//! Places in a body with what is found there, and the cells between them.

use std::path::Path;

use super::{Error, Field, vtk};
use crate::elastic::STRESSES;

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

    /// Turned over, as body 2 is above the plane of contact: z changes its sign.
    #[must_use]
    pub(super) fn turned_over(mut self) -> Self {
        self.points.iter_mut().for_each(|place| place[2] = -place[2]);
        self.cells.iter_mut().for_each(|cell| cell.reverse());
        turn_over(&mut self.fields, &mut self.vectors);
        self
    }

    /// Reads a `.vtu` file that [`Sheet::write`] wrote; it does not read those of other programs.
    ///
    /// # Errors
    /// If the file cannot be read, is damaged or is written in another way.
    pub fn read(path: &Path) -> Result<Self, Error> {
        vtk::read(path)
    }
}

/// Turns components over along z.
pub(super) fn turn_over(fields: &mut [Field], vectors: &mut [(String, Vec<[f64; 3]>)]) {
    let shears = STRESSES.iter().filter(|(_, [i, j])| (*i == 2) != (*j == 2));
    let shears = shears.map(|(name, _)| format!("stress_{name}_Pa"));
    let odd: Vec<String> = shears.chain(["displacement_z_m".to_owned()]).collect();
    for field in fields.iter_mut().filter(|field| odd.contains(&field.name)) {
        field.values.iter_mut().for_each(|value| *value = -*value);
    }
    let vectors = vectors.iter_mut().flat_map(|(_, vectors)| vectors);
    vectors.for_each(|vector| vector[2] = -vector[2]);
}
