//! VTK's XML unstructured grids: a polygon a pair, with fields and vectors.

use std::io;

use super::Kept;
use super::arrays::{BYTES, FLAGS, INTEGERS, Reader, VECTORS, Writer, cell, number};
use crate::output::Surface;

/// What VTK calls these files.
const KIND: &str = "UnstructuredGrid";

/// The arrays that are no fields.
const CORNERS: &str = "corners_m";
const CONNECTIVITY: &str = "connectivity";
const OFFSETS: &str = "offsets";
const TYPES: &str = "types";
const MIRRORED: &str = "mirrored";
const PLACE: &str = "place_m";

impl Kept for Surface {
    fn encode(&self) -> io::Result<Vec<u8>> {
        let Surface { places, outlines, mirrored, fields, vectors } = self;
        let count = outlines.iter().flatten().count();
        let ends = outlines.iter().scan(0i64, |end, outline| {
            *end += outline.len() as i64;
            Some(*end)
        });
        let mut arrays = Writer::default();
        let corners = outlines.iter().flatten().flatten().map(|value| value.to_le_bytes());
        let points = arrays.add(VECTORS, CORNERS, corners)?;
        let connectivity =
            arrays.add(INTEGERS, CONNECTIVITY, (0..count as i64).map(i64::to_le_bytes))?;
        let offsets = arrays.add(INTEGERS, OFFSETS, ends.map(i64::to_le_bytes))?;
        let types =
            arrays.add(BYTES, TYPES, outlines.iter().map(|outline| [cell(outline.len())]))?;
        let mirrored = mirrored.iter().map(|&mirrored| i64::from(mirrored).to_le_bytes());
        let mirrored = arrays.add(FLAGS, MIRRORED, mirrored)?;
        let vectors = vectors.iter().map(|(name, vectors)| (name.as_str(), vectors.as_slice()));
        let cells =
            arrays.cell_data(fields, [(PLACE, places.as_slice())].into_iter().chain(vectors))?;
        let description = format!(
            "  <{KIND}>\n    <FieldData>\n      {mirrored}\n    </FieldData>\n    \
             <Piece NumberOfPoints=\"{count}\" NumberOfCells=\"{}\">\n      \
             <Points>\n        {points}\n      </Points>\n      \
             <Cells>\n        {connectivity}\n        {offsets}\n        {types}\n      \
             </Cells>\n{cells}    </Piece>\n  </{KIND}>\n",
            outlines.len()
        );
        Ok(arrays.file(KIND, &description))
    }

    fn decode(bytes: &[u8]) -> Result<Self, String> {
        let file = Reader::of(bytes)?;
        let (points, cells) =
            (number(file.text, "NumberOfPoints")?, number(file.text, "NumberOfCells")?);
        let mut surface = Surface::default();
        let (mut corners, mut ends) = (vec![], vec![]);
        for array in file.arrays() {
            match array.name()?.as_str() {
                CORNERS => corners = array.vectors(points)?,
                CONNECTIVITY | TYPES => {}
                OFFSETS => ends = array.integers(cells)?,
                MIRRORED => {
                    let known = array.integers(2)?;
                    surface.mirrored = [known[0] != 0, known[1] != 0];
                }
                PLACE => surface.places = array.vectors(cells)?,
                name if array.has_vectors() => {
                    surface.vectors.push((name.to_owned(), array.vectors(cells)?));
                }
                _ => surface.fields.push(array.field(cells)?),
            }
        }
        let mut begin = 0;
        for end in ends {
            let end = usize::try_from(end).map_err(|_| "its cells are damaged")?;
            let outline = corners.get(begin..end).ok_or("its cells are damaged")?;
            surface.outlines.push(outline.to_vec());
            begin = end;
        }
        if surface.places.len() != cells || surface.outlines.len() != cells {
            return Err("its cells are damaged".to_owned());
        }
        Ok(surface)
    }
}

#[cfg(test)]
mod tests {
    use crate::output::vtk::Kept;
    use crate::output::{Field, Surface};

    /// A triangle, a quadrilateral and a pentagon.
    fn surface() -> Surface {
        let polygon = |corners: usize| -> Vec<[f64; 3]> {
            let angle = |i: usize| (i as f64 + 0.1 * corners as f64).sin_cos();
            (0..corners).map(|i| [angle(i).0, angle(i).1, 0.1 * corners as f64]).collect()
        };
        Surface {
            places: vec![[0.1, 0.2, 0.3], [1.0 / 3.0, 2.0, 0.0], [-1.0, 0.5, 1e-9]],
            outlines: [3, 4, 5].map(polygon).to_vec(),
            mirrored: [false, true],
            fields: vec![
                Field { name: "pressure_Pa".to_owned(), values: vec![1e8, 0.0, 2e8 / 3.0] },
                Field { name: "wear_\"a\" & <b>_m".to_owned(), values: vec![-1e-7, 0.0, 5e-324] },
            ],
            vectors: vec![("traction_Pa".to_owned(), vec![[1.0, -2.0, 3e7]; 3])],
        }
    }

    #[test]
    fn what_is_written_is_read() {
        assert_eq!(Surface::decode(&surface().encode().unwrap()).unwrap(), surface());
    }

    #[test]
    fn damage_is_noticed_wherever_the_file_ends() {
        let whole = surface().encode().unwrap();
        let tail = "\n  </AppendedData>\n</VTKFile>\n".len();
        for length in 0..whole.len() - tail {
            assert!(
                Surface::decode(&whole[..length]).is_err(),
                "{length} of {} bytes",
                whole.len()
            );
        }
    }
}
