//! The stresses in a half-space, plane after plane.

use super::{Error, Place, vtk};
use archard::compliance::half_space::inside::Below;
use archard::stress::{tension, von_mises};

/// Names of the fields: components, and two measures.
pub(super) const NAMES: [&str; 8] = [
    "stress_xx_Pa",
    "stress_yy_Pa",
    "stress_zz_Pa",
    "stress_xy_Pa",
    "stress_zx_Pa",
    "stress_yz_Pa",
    "von_mises_Pa",
    "tension_Pa",
];

/// Stresses on a grid whose planes lie at any depths, as kept in a `.vtr` file (VTK's XML rectilinear grids with point data), in
/// single precision.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Planes {
    /// Places along x, y and z (m), of the body where it lies in contact.
    pub(super) axes: [Vec<f64>; 3],
    /// Fields in the order of [`NAMES`] (Pa), x running fastest, then y, the uppermost plane first.
    pub(super) fields: [Vec<f32>; 8],
    /// Whether z points into the body, as in body 2.
    turned: bool,
}

impl Planes {
    /// Without planes yet, at the centres of the elements.
    pub(super) fn below(below: &Below, turned: bool) -> Self {
        let [nx, ny] = below.elements();
        let x = (0..nx).map(|index| below.place(index)[0]).collect();
        let y = (0..ny).map(|index| below.place(nx * index)[1]).collect();
        Self { axes: [x, y, vec![]], turned, ..Self::default() }
    }

    /// Adds a plane so deep (m), in the axes of the body by itself.
    pub(super) fn add(&mut self, depth: f64, plane: &[Vec<f64>; 6]) {
        let sign = if self.turned { -1.0 } else { 1.0 };
        self.axes[2].push(-sign * depth);
        for element in 0..plane[0].len() {
            let mut own = plane.each_ref().map(|field| field[element]);
            own[4..].iter_mut().for_each(|shear| *shear *= sign);
            let values = own.into_iter().chain([von_mises(&own), tension(&own)]);
            for (field, value) in self.fields.iter_mut().zip(values) {
                field.push(value as f32);
            }
        }
    }

    /// Writes a `.vtr` file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub(super) fn write(&self, place: &Place) -> Result<(), Error> {
        vtk::write_planes(self, place)
    }
}
