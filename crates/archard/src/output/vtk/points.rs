//! VTK's XML unstructured grids with point data: cells that share their points.

use std::io;

use super::arrays::{BYTES, INTEGERS, VECTORS, Writer, cell};
use crate::output::WornSurface;

/// What VTK calls these files.
const KIND: &str = "UnstructuredGrid";

/// The bytes of the file of a surface.
pub(super) fn encode(surface: &WornSurface) -> io::Result<Vec<u8>> {
    let WornSurface { points, cells, fields, vectors } = surface;
    let ends = cells.iter().scan(0i64, |end, cell| {
        *end += cell.len() as i64;
        Some(*end)
    });
    let mut arrays = Writer::default();
    let places = points.iter().flatten().map(|value| value.to_le_bytes());
    let places = arrays.add(VECTORS, "points_mm", places)?;
    let corners = cells.iter().flatten().map(|&corner| (corner as i64).to_le_bytes());
    let connectivity = arrays.add(INTEGERS, "connectivity", corners)?;
    let offsets = arrays.add(INTEGERS, "offsets", ends.map(i64::to_le_bytes))?;
    let types = arrays.add(BYTES, "types", cells.iter().map(|corners| [cell(corners.len())]))?;
    let vectors = vectors.iter().map(|(name, vectors)| (name.as_str(), vectors.as_slice()));
    let data = arrays.data("PointData", fields, vectors)?;
    let description = format!(
        "  <{KIND}>\n    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n      \
         <Points>\n        {places}\n      </Points>\n      \
         <Cells>\n        {connectivity}\n        {offsets}\n        {types}\n      \
         </Cells>\n{data}    </Piece>\n  </{KIND}>\n",
        points.len(),
        cells.len()
    );
    Ok(arrays.file(KIND, &description))
}
