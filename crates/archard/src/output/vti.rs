//! VTK's XML image data: raw appended arrays, each one block compressed by zlib.
//!
//! The layout is that of the VTK file formats guide (Kitware, "XML File Formats"): an array is its
//! number of blocks, the size of a block, the size of the last block if it is a partial one, the
//! compressed size of each block, and the blocks.

use std::fmt::Write as _;
use std::io::{self, Read, Write};

use flate2::Compression;
use flate2::read::ZlibDecoder;
use flate2::write::ZlibEncoder;

use super::{Field, Image};

/// What stands between the description and the arrays.
const APPENDED: &str = "  <AppendedData encoding=\"raw\">\n   _";
/// Bytes before an array's block: its number of blocks and three sizes.
const HEADER: usize = 32;

/// The bytes of a `.vti` file.
pub(super) fn encode(image: &Image) -> io::Result<Vec<u8>> {
    let arrays: Vec<Vec<u8>> =
        image.fields.iter().map(|field| encode_array(&field.values)).collect::<io::Result<_>>()?;
    let mut bytes = describe(image, &arrays).into_bytes();
    bytes.extend_from_slice(APPENDED.as_bytes());
    arrays.iter().for_each(|array| bytes.extend_from_slice(array));
    bytes.extend_from_slice(b"\n  </AppendedData>\n</VTKFile>\n");
    Ok(bytes)
}

/// The description of the image and of where its arrays are.
fn describe(image: &Image, arrays: &[Vec<u8>]) -> String {
    let Image { origin: [x, y], spacing: [dx, dy], elements: [nx, ny], .. } = image;
    let extent = format!("0 {nx} 0 {ny} 0 0");
    let mut text = format!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  \
         <ImageData WholeExtent=\"{extent}\" Origin=\"{x:?} {y:?} 0\" \
         Spacing=\"{dx:?} {dy:?} 1\">\n    <Piece Extent=\"{extent}\">\n      \
         <CellData Scalars=\"{}\">\n",
        image.fields.first().map_or_else(String::new, |field| escape(&field.name))
    );
    let mut offset = 0;
    for (field, array) in image.fields.iter().zip(arrays) {
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "        <DataArray type=\"Float64\" Name=\"{}\" format=\"appended\" offset=\"{offset}\"/>",
            escape(&field.name)
        );
        offset += array.len();
    }
    text + "      </CellData>\n    </Piece>\n  </ImageData>\n"
}

/// An array as one compressed block behind its header.
fn encode_array(values: &[f64]) -> io::Result<Vec<u8>> {
    let raw: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    let mut encoder = ZlibEncoder::new(vec![0; HEADER], Compression::fast());
    encoder.write_all(&raw)?;
    let mut array = encoder.finish()?;
    let sizes = [1, raw.len(), 0, array.len() - HEADER];
    for (place, size) in array.chunks_exact_mut(8).zip(sizes) {
        place.copy_from_slice(&(size as u64).to_le_bytes());
    }
    Ok(array)
}

/// The image in the bytes of a file that [`encode`] made, or what is wrong with them.
pub(super) fn decode(bytes: &[u8]) -> Result<Image, String> {
    let split = bytes
        .windows(APPENDED.len())
        .position(|window| window == APPENDED.as_bytes())
        .ok_or("it has no raw appended data")?;
    let text = str::from_utf8(&bytes[..split]).map_err(|_| "its description is not text")?;
    let appended = &bytes[split + APPENDED.len()..];

    let extent = numbers::<usize>(text, "WholeExtent")?;
    let (origin, spacing) = (numbers::<f64>(text, "Origin")?, numbers::<f64>(text, "Spacing")?);
    let (&[_, nx, _, ny, ..], &[x, y, ..], &[dx, dy, ..]) = (&*extent, &*origin, &*spacing) else {
        return Err("its grid is not described".to_owned());
    };
    let fields = text
        .split("<DataArray ")
        .skip(1)
        .map(|tag| decode_field(tag, appended, nx.saturating_mul(ny)))
        .collect::<Result<_, String>>()?;
    Ok(Image { origin: [x, y], spacing: [dx, dy], elements: [nx, ny], fields })
}

/// The field described by a tag.
fn decode_field(tag: &str, appended: &[u8], count: usize) -> Result<Field, String> {
    let name = unescape(attribute(tag, "Name")?);
    let damaged = || format!("the array `{name}` is damaged");
    let offset = *numbers::<usize>(tag, "offset")?.first().ok_or_else(damaged)?;
    let block = offset.checked_add(HEADER).and_then(|start| appended.get(start..));
    let mut raw = Vec::new();
    ZlibDecoder::new(block.ok_or_else(damaged)?).read_to_end(&mut raw).map_err(|_| damaged())?;
    let (chunks, []) = raw.as_chunks::<8>() else { return Err(damaged()) };
    if chunks.len() != count {
        return Err(damaged());
    }
    Ok(Field { values: chunks.iter().map(|&chunk| f64::from_le_bytes(chunk)).collect(), name })
}

/// The first value of that attribute.
fn attribute<'a>(text: &'a str, name: &str) -> Result<&'a str, String> {
    let start = format!("{name}=\"");
    text.split_once(&start)
        .and_then(|(_, rest)| rest.split_once('"'))
        .map(|(value, _)| value)
        .ok_or_else(|| format!("`{name}` is missing"))
}

/// The numbers of that attribute.
fn numbers<T: std::str::FromStr>(text: &str, name: &str) -> Result<Vec<T>, String> {
    attribute(text, name)?
        .split_whitespace()
        .map(|word| word.parse().map_err(|_| format!("`{name}` is not a list of numbers")))
        .collect()
}

/// What XML takes for special characters in an attribute.
const ESCAPES: [(&str, &str); 4] = [("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("\"", "&quot;")];

/// Text as it may stand in an attribute.
fn escape(text: &str) -> String {
    ESCAPES.iter().fold(text.to_owned(), |text, (plain, escaped)| text.replace(plain, escaped))
}

/// The text that [`escape`] was given.
fn unescape(text: &str) -> String {
    ESCAPES
        .iter()
        .rev()
        .fold(text.to_owned(), |text, (plain, escaped)| text.replace(escaped, plain))
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

    #[test]
    fn a_foreign_file_is_refused() {
        let error = decode(b"<VTKFile type=\"PolyData\">").unwrap_err();
        assert_eq!(error, "it has no raw appended data");
    }
}
