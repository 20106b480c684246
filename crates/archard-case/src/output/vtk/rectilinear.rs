//! VTK's XML rectilinear grids with point data.

use std::io;

use super::arrays::{NUMBERS, SINGLE, Writer};
use crate::output::planes::{NAMES, Planes};

/// What VTK calls these files.
const KIND: &str = "RectilinearGrid";

/// The bytes of the file of stresses.
pub(super) fn encode(planes: &Planes) -> io::Result<Vec<u8>> {
    let mut arrays = Writer::default();
    let mut data = String::new();
    for (name, values) in NAMES.iter().zip(&planes.fields) {
        let element = arrays.add(SINGLE, name, values.iter().map(|value| value.to_le_bytes()))?;
        data += &format!("        {element}\n");
    }
    let mut coordinates = String::new();
    for (name, places) in ["x_m", "y_m", "z_m"].iter().zip(&planes.axes) {
        let element = arrays.add(NUMBERS, name, places.iter().map(|value| value.to_le_bytes()))?;
        coordinates += &format!("        {element}\n");
    }
    let ends = planes.axes.each_ref().map(|places| places.len().saturating_sub(1));
    let [x, y, z] = ends;
    let extent = format!("0 {x} 0 {y} 0 {z}");
    let first = NAMES[6];
    let description = format!(
        "  <{KIND} WholeExtent=\"{extent}\">\n    <Piece Extent=\"{extent}\">\n      \
         <PointData Scalars=\"{first}\">\n{data}      </PointData>\n      \
         <Coordinates>\n{coordinates}      </Coordinates>\n    </Piece>\n  </{KIND}>\n"
    );
    Ok(arrays.file(KIND, &description))
}
