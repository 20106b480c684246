//! VTK's XML image data.

use std::fmt::Write as _;
use std::io;

use super::appended::{self, Arrays, attribute, escape, numbers, unescape};
use super::{Field, Image};

/// The bytes of a `.vti` file.
pub(super) fn encode(image: &Image) -> io::Result<Vec<u8>> {
    let Image { origin: [x, y], spacing: [dx, dy], elements: [nx, ny], .. } = image;
    let extent = format!("0 {nx} 0 {ny} 0 0");
    let mut text = appended::opening("ImageData");
    // Writing to a String cannot fail.
    let _ = write!(
        text,
        "  <ImageData WholeExtent=\"{extent}\" Origin=\"{x:?} {y:?} 0\" \
         Spacing=\"{dx:?} {dy:?} 1\">\n    <Piece Extent=\"{extent}\">\n      \
         <CellData Scalars=\"{}\">\n",
        image.fields.first().map_or_else(String::new, |field| escape(&field.name))
    );
    let mut arrays = Arrays::default();
    for Field { name, values } in &image.fields {
        let at = arrays.add(values.iter().map(|value| value.to_le_bytes()))?;
        let name = escape(name);
        let _ = writeln!(text, "        <DataArray type=\"Float64\" Name=\"{name}\" {at}/>");
    }
    text += "      </CellData>\n    </Piece>\n  </ImageData>\n";
    Ok(arrays.below(text))
}

/// The image in the bytes of a file that [`encode`] made, or what is wrong with them.
pub(super) fn decode(bytes: &[u8]) -> Result<Image, String> {
    let (text, appended) = appended::split(bytes)?;
    let extent = numbers::<usize>(text, "WholeExtent")?;
    let (origin, spacing) = (numbers::<f64>(text, "Origin")?, numbers::<f64>(text, "Spacing")?);
    let (&[_, nx, _, ny, ..], &[x, y, ..], &[dx, dy, ..]) = (&*extent, &*origin, &*spacing) else {
        return Err("its grid is not described".to_owned());
    };
    if nx.checked_mul(ny).is_none_or(|elements| elements == 0) {
        return Err("its grid has no elements".to_owned());
    }
    let field = |tag: &str| {
        let words = appended::words(tag, appended, nx.saturating_mul(ny))?;
        let values = words.into_iter().map(f64::from_le_bytes).collect();
        Ok(Field { name: unescape(attribute(tag, "Name")?), values })
    };
    let fields = text.split("<DataArray ").skip(1).map(field).collect::<Result<_, String>>()?;
    Ok(Image { origin: [x, y], spacing: [dx, dy], elements: [nx, ny], fields })
}

#[cfg(test)]
mod tests {
    use super::{decode, encode};
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
        assert_eq!(decode(&encode(&image()).unwrap()).unwrap(), image());
    }

    #[test]
    fn damage_is_noticed_wherever_the_file_ends() {
        let whole = encode(&image()).unwrap();
        let tail = "\n  </AppendedData>\n</VTKFile>\n".len();
        for length in 0..whole.len() - tail {
            assert!(decode(&whole[..length]).is_err(), "{length} of {} bytes", whole.len());
        }
    }

    /// A picture goes through the elements along each axis, however many are said to be there.
    #[test]
    fn a_grid_without_elements_is_refused() {
        let none = Image { elements: [usize::MAX, 0], fields: vec![], ..image() };
        assert_eq!(decode(&encode(&none).unwrap()).unwrap_err(), "its grid has no elements");
    }

    /// A thousand bytes of zeros, packed in a few, where six numbers should be.
    #[test]
    fn more_than_fits_is_refused() {
        let field = Field { name: "pressure_Pa".to_owned(), values: vec![0.0; 1000] };
        let more = Image { fields: vec![field], ..image() };
        let error = decode(&encode(&more).unwrap()).unwrap_err();
        assert_eq!(error, "the array `pressure_Pa` is damaged");
    }

    #[test]
    fn a_foreign_file_is_refused() {
        let error = decode(b"<VTKFile type=\"PolyData\">").unwrap_err();
        assert_eq!(error, "it has no raw appended data");
    }
}
