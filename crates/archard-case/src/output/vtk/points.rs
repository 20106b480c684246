//! VTK's XML unstructured grids with point data: cells that share their points.

use std::io;

use super::Kept;
use super::arrays::{BYTES, INTEGERS, Reader, VECTORS, Writer, cell, number};
use crate::output::{Field, Sheet, WornSurface};

/// What VTK calls these files.
const KIND: &str = "UnstructuredGrid";

/// The arrays that are no fields.
const MILLIMETRES: &str = "points_mm";
const METRES: &str = "points_m";
const CONNECTIVITY: &str = "connectivity";
const OFFSETS: &str = "offsets";
const TYPES: &str = "types";

/// The bytes of the file of a surface.
pub(super) fn encode(surface: &WornSurface) -> io::Result<Vec<u8>> {
    let WornSurface { points, cells, fields, vectors } = surface;
    grid((MILLIMETRES, points), cells, fields, vectors)
}

type Vectors = (String, Vec<[f64; 3]>);

fn grid(
    (label, points): (&str, &[[f64; 3]]),
    cells: &[Vec<usize>],
    fields: &[Field],
    vectors: &[Vectors],
) -> io::Result<Vec<u8>> {
    let ends = cells.iter().scan(0i64, |end, cell| {
        *end += cell.len() as i64;
        Some(*end)
    });
    let mut arrays = Writer::default();
    let places = points.iter().flatten().map(|value| value.to_le_bytes());
    let places = arrays.add(VECTORS, label, places)?;
    let corners = cells.iter().flatten().map(|&corner| (corner as i64).to_le_bytes());
    let connectivity = arrays.add(INTEGERS, CONNECTIVITY, corners)?;
    let offsets = arrays.add(INTEGERS, OFFSETS, ends.map(i64::to_le_bytes))?;
    let types = arrays.add(BYTES, TYPES, cells.iter().map(|corners| [cell(corners.len())]))?;
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

impl Kept for Sheet {
    fn encode(&self) -> io::Result<Vec<u8>> {
        grid((METRES, &self.points), &self.cells, &self.fields, &self.vectors)
    }

    fn decode(bytes: &[u8]) -> Result<Self, String> {
        let damaged = || "its cells are damaged".to_owned();
        let file = Reader::of(bytes)?;
        let points: usize = number(file.text, "NumberOfPoints")?;
        let cells: usize = number(file.text, "NumberOfCells")?;
        let mut sheet = Sheet::default();
        let (mut connectivity, mut ends) = (None, vec![]);
        for array in file.arrays() {
            match array.name()?.as_str() {
                METRES => sheet.points = array.vectors(points)?,
                CONNECTIVITY => connectivity = Some(array),
                TYPES => {}
                OFFSETS => ends = array.integers(cells)?,
                name if array.has_vectors() => {
                    sheet.vectors.push((name.to_owned(), array.vectors(points)?));
                }
                _ => sheet.fields.push(array.field(points)?),
            }
        }
        let index = |value: i64| usize::try_from(value).map_err(|_| damaged());
        let count = ends.last().map_or(Ok(0), |end| index(*end))?;
        let corners = connectivity.ok_or_else(damaged)?.integers(count)?;
        let mut begin = 0;
        for end in ends {
            let end = index(end)?;
            let cell = corners.get(begin..end).ok_or_else(damaged)?;
            let cell: Vec<usize> = cell.iter().map(|&one| index(one)).collect::<Result<_, _>>()?;
            if cell.iter().any(|corner| *corner >= points) {
                return Err(damaged());
            }
            sheet.cells.push(cell);
            begin = end;
        }
        if sheet.points.len() == points { Ok(sheet) } else { Err(damaged()) }
    }
}

#[cfg(test)]
mod tests {
    use crate::output::vtk::Kept;
    use crate::output::{Field, Sheet};

    #[test]
    fn what_is_written_is_read_and_damage_noticed() {
        let sheet = Sheet {
            points: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.1], [0.0, 1.0, -1e-9]],
            cells: vec![vec![0, 1, 2, 3], vec![0, 1, 2]],
            fields: vec![Field {
                name: "von_mises_Pa".to_owned(),
                values: vec![1e8, 0.0, -2.0, 5e-324],
            }],
            vectors: vec![("displacement_m".to_owned(), vec![[1.0, -2.0, 3e-7]; 4])],
        };
        let whole = sheet.encode().unwrap();
        assert_eq!(Sheet::decode(&whole).unwrap(), sheet);
        let tail = "\n  </AppendedData>\n</VTKFile>\n".len();
        for length in 0..whole.len() - tail {
            assert!(Sheet::decode(&whole[..length]).is_err(), "{length} of {} bytes", whole.len());
        }
    }
}
