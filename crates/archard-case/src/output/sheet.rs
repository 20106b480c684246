//! Places in a body with what is found there, and the cells between them.

use std::path::Path;

use super::{Error, Field, Place, vtk};
use archard::elastic::STRESSES;

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
    pub fn write(&self, place: &Place) -> Result<(), Error> {
        vtk::write(self, place)
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

#[cfg(test)]
mod tests {
    use super::Sheet;
    use crate::output::Field;

    /// What lies below lies above: vectors and shears along z change their sign, all else keeps its.
    #[test]
    fn turned_over_it_is_the_mirror_image() {
        let names =
            ["stress_xx_Pa", "stress_zz_Pa", "stress_xy_Pa", "stress_yz_Pa", "stress_zx_Pa"];
        let fields = [&names[..], &["displacement_x_m", "displacement_z_m"]].concat();
        let sheet = Sheet {
            points: vec![[1.0, 2.0, -3.0], [1.5, 2.0, -3.0], [1.0, 2.5, -2.0]],
            cells: vec![vec![0, 1, 2]],
            fields: fields.iter().map(|name| Field::new(*name, vec![7.0; 3])).collect(),
            vectors: vec![("displacement_m".into(), vec![[1.0, 2.0, 3.0]; 3])],
        };
        let turned = sheet.clone().turned_over();
        assert_eq!(turned.points[2], [1.0, 2.5, 2.0]);
        assert_eq!(turned.vectors[0].1[1], [1.0, 2.0, -3.0]);
        let signs = turned.fields.iter().map(|field| field.values[2] / 7.0).collect::<Vec<_>>();
        assert_eq!(signs, [1.0, 1.0, 1.0, -1.0, -1.0, 1.0, -1.0]);
        // Seen from outside, cells go around as they did.
        assert_eq!(turned.cells[0], [2, 1, 0]);
        assert_eq!(turned.turned_over(), sheet);
    }
}
