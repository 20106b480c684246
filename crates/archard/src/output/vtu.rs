//! VTK's XML unstructured grids: a polygon a pair.

use std::fmt::Write as _;
use std::io;

use super::appended::{self, Arrays, attribute, escape, numbers, unescape};
use super::{Field, Surface};

/// VTK's numbers for cells of three, four and more corners.
const TRIANGLE: u8 = 5;
const QUADRILATERAL: u8 = 9;
const POLYGON: u8 = 7;

/// The bytes of a `.vtu` file.
pub(super) fn encode(surface: &Surface) -> io::Result<Vec<u8>> {
    let outlines = &surface.outlines;
    let corners = || outlines.iter().flatten();
    let count = corners().count();
    let ends = outlines.iter().scan(0i64, |end, outline| {
        *end += outline.len() as i64;
        Some(*end)
    });
    let kind = |outline: &Vec<[f64; 3]>| match outline.len() {
        3 => TRIANGLE,
        4 => QUADRILATERAL,
        _ => POLYGON,
    };
    let mut arrays = Arrays::default();
    let points = arrays.add(corners().flatten().map(|value| value.to_le_bytes()))?;
    let connectivity = arrays.add((0..count as i64).map(i64::to_le_bytes))?;
    let offsets = arrays.add(ends.map(i64::to_le_bytes))?;
    let types = arrays.add(outlines.iter().map(|outline| [kind(outline)]))?;
    let mirrored =
        arrays.add(surface.mirrored.iter().map(|&mirrored| i64::from(mirrored).to_le_bytes()))?;
    let mut text = appended::opening("UnstructuredGrid");
    // Writing to a String cannot fail.
    let _ = write!(
        text,
        "  <UnstructuredGrid>\n    <FieldData>\n      \
         <DataArray type=\"Int64\" Name=\"mirrored\" NumberOfTuples=\"2\" {mirrored}/>\n    \
         </FieldData>\n    <Piece NumberOfPoints=\"{count}\" NumberOfCells=\"{}\">\n      \
         <Points>\n        <DataArray type=\"Float64\" Name=\"corners_m\" \
         NumberOfComponents=\"3\" {points}/>\n      </Points>\n      <Cells>\n        \
         <DataArray type=\"Int64\" Name=\"connectivity\" {connectivity}/>\n        \
         <DataArray type=\"Int64\" Name=\"offsets\" {offsets}/>\n        \
         <DataArray type=\"UInt8\" Name=\"types\" {types}/>\n      </Cells>\n      \
         <CellData Scalars=\"{}\">\n",
        outlines.len(),
        surface.fields.first().map_or_else(String::new, |field| escape(&field.name))
    );
    for Field { name, values } in &surface.fields {
        let at = arrays.add(values.iter().map(|value| value.to_le_bytes()))?;
        let name = escape(name);
        let _ = writeln!(text, "        <DataArray type=\"Float64\" Name=\"{name}\" {at}/>");
    }
    let places = ("place_m".to_owned(), surface.places.clone());
    for (name, vectors) in [&places].into_iter().chain(&surface.vectors) {
        let at = arrays.add(vectors.iter().flatten().map(|value| value.to_le_bytes()))?;
        let name = escape(name);
        let _ = writeln!(
            text,
            "        <DataArray type=\"Float64\" Name=\"{name}\" NumberOfComponents=\"3\" {at}/>"
        );
    }
    text += "      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n";
    Ok(arrays.below(text))
}

/// The surface in the bytes of a file that [`encode`] made, or what is wrong with them.
pub(super) fn decode(bytes: &[u8]) -> Result<Surface, String> {
    let (text, appended) = appended::split(bytes)?;
    let one = |name: &str| -> Result<usize, String> {
        numbers(text, name)?.first().copied().ok_or_else(|| format!("`{name}` is missing"))
    };
    let (points, cells) = (one("NumberOfPoints")?, one("NumberOfCells")?);
    let mut surface = Surface::default();
    let (mut corners, mut ends) = (vec![], vec![]);
    for tag in text.split("<DataArray ").skip(1) {
        let vector = tag.split("/>").next().is_some_and(|tag| tag.contains("NumberOfComponents"));
        let vectors = |count: usize| -> Result<Vec<[f64; 3]>, String> {
            let words = appended::words(tag, appended, count.saturating_mul(3))?;
            let (vectors, _) = words.as_chunks::<3>();
            Ok(vectors.iter().map(|vector| vector.map(f64::from_le_bytes)).collect())
        };
        let integers = |count: usize| -> Result<Vec<i64>, String> {
            let words = appended::words(tag, appended, count)?;
            Ok(words.into_iter().map(i64::from_le_bytes).collect())
        };
        match unescape(attribute(tag, "Name")?).as_str() {
            "corners_m" => corners = vectors(points)?,
            "connectivity" | "types" => {}
            "offsets" => ends = integers(cells)?,
            "mirrored" => {
                let known = integers(2)?;
                surface.mirrored = [known[0] != 0, known[1] != 0];
            }
            "place_m" => surface.places = vectors(cells)?,
            name if vector => surface.vectors.push((name.to_owned(), vectors(cells)?)),
            name => {
                let words = appended::words(tag, appended, cells)?;
                let values = words.into_iter().map(f64::from_le_bytes).collect();
                surface.fields.push(Field { name: name.to_owned(), values });
            }
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

#[cfg(test)]
mod tests {
    use super::{decode, encode};
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
        assert_eq!(decode(&encode(&surface()).unwrap()).unwrap(), surface());
    }

    #[test]
    fn damage_is_noticed_wherever_the_file_ends() {
        let whole = encode(&surface()).unwrap();
        let tail = "\n  </AppendedData>\n</VTKFile>\n".len();
        for length in 0..whole.len() - tail {
            assert!(decode(&whole[..length]).is_err(), "{length} of {} bytes", whole.len());
        }
    }
}
