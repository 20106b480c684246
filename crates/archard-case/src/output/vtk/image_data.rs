//! VTK's XML image data: fields on a uniform grid.

use std::io;

use super::Kept;
use super::arrays::{Array, Reader, Writer, numbers};
use crate::output::Image;

/// What VTK calls these files.
const KIND: &str = "ImageData";

impl Kept for Image {
    fn encode(&self) -> io::Result<Vec<u8>> {
        let Image { origin: [x, y], spacing: [dx, dy], elements: [nx, ny], fields } = self;
        let extent = format!("0 {nx} 0 {ny} 0 0");
        let mut arrays = Writer::default();
        let cells = arrays.cell_data(fields, [])?;
        let description = format!(
            "  <{KIND} WholeExtent=\"{extent}\" Origin=\"{x:?} {y:?} 0\" \
             Spacing=\"{dx:?} {dy:?} 1\">\n    <Piece Extent=\"{extent}\">\n{cells}    \
             </Piece>\n  </{KIND}>\n"
        );
        Ok(arrays.file(KIND, &description))
    }

    fn decode(bytes: &[u8]) -> Result<Self, String> {
        let file = Reader::of(bytes)?;
        let extent = numbers::<usize>(file.text, "WholeExtent")?;
        let origin = numbers::<f64>(file.text, "Origin")?;
        let spacing = numbers::<f64>(file.text, "Spacing")?;
        let (&[_, nx, _, ny, ..], &[x, y, ..], &[dx, dy, ..]) = (&*extent, &*origin, &*spacing)
        else {
            return Err("its grid is not described".to_owned());
        };
        if nx.checked_mul(ny).is_none_or(|elements| elements == 0) {
            return Err("its grid has no elements".to_owned());
        }
        let field = |array: Array<'_>| array.field(nx * ny);
        let fields = file.arrays().map(field).collect::<Result<_, String>>()?;
        Ok(Image { origin: [x, y], spacing: [dx, dy], elements: [nx, ny], fields })
    }
}

#[cfg(test)]
mod tests {
    use crate::output::vtk::Kept;
    use crate::output::{Field, Image};

    /// Two fields of odd values on a grid of 3 by 2.
    fn image() -> Image {
        let field = |name: &str, first: f64| Field {
            name: name.to_owned(),
            values: (0..6).map(|i| first * f64::from(i).exp()).collect(),
        };
        Image {
            origin: [-0.15, -0.1],
            spacing: [0.1, 0.1],
            elements: [3, 2],
            fields: vec![field("pressure_Pa", 1e8 / 3.0), field("wear_\"a\" & <b>_m", -1e-7)],
        }
    }

    #[test]
    fn what_is_written_is_read() {
        assert_eq!(Image::decode(&image().encode().unwrap()).unwrap(), image());
    }

    #[test]
    fn damage_is_noticed_wherever_the_file_ends() {
        let whole = image().encode().unwrap();
        let tail = "\n  </AppendedData>\n</VTKFile>\n".len();
        for length in 0..whole.len() - tail {
            assert!(Image::decode(&whole[..length]).is_err(), "{length} of {} bytes", whole.len());
        }
    }

    /// A picture goes through the elements along each axis, however many are said to be there.
    #[test]
    fn a_grid_without_elements_is_refused() {
        let none = Image { elements: [usize::MAX, 0], fields: vec![], ..image() };
        assert_eq!(Image::decode(&none.encode().unwrap()).unwrap_err(), "its grid has no elements");
    }

    /// A thousand bytes of zeros, packed in a few, where six numbers should be.
    #[test]
    fn more_than_fits_is_refused() {
        let field = Field { name: "pressure_Pa".to_owned(), values: vec![0.0; 1000] };
        let more = Image { fields: vec![field], ..image() };
        let error = Image::decode(&more.encode().unwrap()).unwrap_err();
        assert_eq!(error, "the array `pressure_Pa` is damaged");
    }

    #[test]
    fn a_foreign_file_is_refused() {
        let error = Image::decode(b"<VTKFile type=\"PolyData\">").unwrap_err();
        assert_eq!(error, "it has no raw appended data");
    }
}
