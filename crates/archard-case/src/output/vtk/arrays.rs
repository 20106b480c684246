//! What all files have in common: the elements that describe arrays, and the arrays, appended raw.
//!
//! An appended array is one block compressed by zlib behind four numbers: the number of blocks, the size of a block, the
//! size of the last block if it is a partial one, and the compressed size of the block.

use std::io::{self, Read, Write};
use std::str::FromStr;

use flate2::Compression;
use flate2::read::ZlibDecoder;
use flate2::write::ZlibEncoder;

use crate::output::Field;

/// What the opening says of appended arrays.
const COMPRESSED: &str = " header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"";
/// What stands between the description and the arrays.
const APPENDED: &str = "  <AppendedData encoding=\"raw\">\n   _";
/// How a file ends.
pub(super) const END: &str = "</VTKFile>\n";
/// How the element of an array begins.
const ARRAY: &str = "<DataArray ";
/// Bytes before an array's block: its number of blocks and three sizes.
const HEADER: usize = 32;

/// The opening of a file of that type.
pub(super) fn opening(kind: &str, more: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\"{more}>\n"
    )
}

/// What an array holds: VTK's type, and what its element says besides.
pub(super) type Kind = [&'static str; 2];
pub(super) const NUMBERS: Kind = ["Float64", ""];
pub(super) const SINGLE: Kind = ["Float32", ""];
pub(super) const VECTORS: Kind = ["Float64", " NumberOfComponents=\"3\""];
pub(super) const INTEGERS: Kind = ["Int64", ""];
pub(super) const BYTES: Kind = ["UInt8", ""];
/// Two answers that hold for the whole file.
pub(super) const FLAGS: Kind = ["Int64", " NumberOfTuples=\"2\""];

/// VTK's number for a cell of so many corners: a triangle, a quadrilateral, a polygon.
pub(super) fn cell(corners: usize) -> u8 {
    match corners {
        3 => 5,
        4 => 9,
        _ => 7,
    }
}

/// Arrays on their way into a file.
#[derive(Debug)]
pub(super) struct Writer {
    appended: Vec<u8>,
    /// The bytes of the array that is taken up.
    raw: Vec<u8>,
    /// Packs one array after another: to set up its tables takes longer than to pack a small one.
    encoder: ZlibEncoder<Vec<u8>>,
}

impl Default for Writer {
    fn default() -> Self {
        let encoder = ZlibEncoder::new(vec![], Compression::fast());
        Self { appended: vec![], raw: vec![], encoder }
    }
}

impl Writer {
    /// Takes an array up, value by value; the element that describes it.
    pub(super) fn add<const N: usize>(
        &mut self,
        [kind, shape]: Kind,
        name: &str,
        values: impl Iterator<Item = [u8; N]>,
    ) -> io::Result<String> {
        self.raw.clear();
        values.for_each(|value| self.raw.extend(value));
        self.encoder.write_all(&self.raw)?;
        let packed = self.encoder.reset(vec![])?;
        let (name, offset) = (escape(name), self.appended.len());
        for size in [1, self.raw.len(), 0, packed.len()] {
            self.appended.extend((size as u64).to_le_bytes());
        }
        self.appended.extend(packed);
        Ok(format!(
            "{ARRAY}type=\"{kind}\" Name=\"{name}\"{shape} format=\"appended\" offset=\"{offset}\"/>"
        ))
    }

    /// The element of all that is known of each cell.
    pub(super) fn cell_data<'a>(
        &mut self,
        fields: &[Field],
        vectors: impl IntoIterator<Item = (&'a str, &'a [[f64; 3]])>,
    ) -> io::Result<String> {
        self.data("CellData", fields, vectors)
    }

    /// The element of all that is known of each cell, or of each point; the first field is shown when the file is opened.
    pub(super) fn data<'a>(
        &mut self,
        of: &str,
        fields: &[Field],
        vectors: impl IntoIterator<Item = (&'a str, &'a [[f64; 3]])>,
    ) -> io::Result<String> {
        let first = fields.first().map_or_else(String::new, |field| escape(&field.name));
        let mut text = format!("      <{of} Scalars=\"{first}\">\n");
        for Field { name, values } in fields {
            let element =
                self.add(NUMBERS, name, values.iter().map(|value| value.to_le_bytes()))?;
            text += &format!("        {element}\n");
        }
        for (name, vectors) in vectors {
            let values = vectors.iter().flatten().map(|value| value.to_le_bytes());
            text += &format!("        {}\n", self.add(VECTORS, name, values)?);
        }
        Ok(text + &format!("      </{of}>\n"))
    }

    /// The file of that type with that description of the arrays.
    pub(super) fn file(self, kind: &str, description: &str) -> Vec<u8> {
        let mut bytes = opening(kind, COMPRESSED).into_bytes();
        bytes.extend_from_slice(description.as_bytes());
        bytes.extend_from_slice(APPENDED.as_bytes());
        bytes.extend_from_slice(&self.appended);
        bytes.extend_from_slice(b"\n  </AppendedData>\n");
        bytes.extend_from_slice(END.as_bytes());
        bytes
    }
}

/// A file as it is read: its description and its arrays.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reader<'a> {
    /// The description.
    pub(super) text: &'a str,
    appended: &'a [u8],
}

impl<'a> Reader<'a> {
    /// The parts of a file.
    pub(super) fn of(bytes: &'a [u8]) -> Result<Self, String> {
        let split = bytes
            .windows(APPENDED.len())
            .position(|window| window == APPENDED.as_bytes())
            .ok_or("it has no raw appended data")?;
        let text = str::from_utf8(&bytes[..split]).map_err(|_| "its description is not text")?;
        Ok(Self { text, appended: &bytes[split + APPENDED.len()..] })
    }

    /// The arrays, in the order of their elements.
    pub(super) fn arrays(self) -> impl Iterator<Item = Array<'a>> {
        let appended = self.appended;
        elements(self.text, ARRAY).map(move |element| Array { element, appended })
    }
}

/// An array of a file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Array<'a> {
    element: &'a str,
    appended: &'a [u8],
}

impl Array<'_> {
    /// Its name.
    pub(super) fn name(self) -> Result<String, String> {
        attribute(self.element, "Name").map(unescape)
    }

    /// Whether it holds vectors.
    pub(super) fn has_vectors(self) -> bool {
        self.element.contains(VECTORS[1])
    }

    /// Its numbers, that many, as a field.
    pub(super) fn field(self, count: usize) -> Result<Field, String> {
        let values = self.words(count)?.into_iter().map(f64::from_le_bytes).collect();
        Ok(Field { name: self.name()?, values })
    }

    /// Its vectors, that many.
    pub(super) fn vectors(self, count: usize) -> Result<Vec<[f64; 3]>, String> {
        let words = self.words(count.saturating_mul(3))?;
        let (vectors, _) = words.as_chunks::<3>();
        Ok(vectors.iter().map(|vector| vector.map(f64::from_le_bytes)).collect())
    }

    /// Its whole numbers, that many.
    pub(super) fn integers(self, count: usize) -> Result<Vec<i64>, String> {
        Ok(self.words(count)?.into_iter().map(i64::from_le_bytes).collect())
    }

    /// Its words of eight bytes, that many.
    fn words(self, count: usize) -> Result<Vec<[u8; 8]>, String> {
        let damaged = || match self.name() {
            Ok(name) => format!("the array `{name}` is damaged"),
            Err(error) => error,
        };
        let offset = *numbers::<usize>(self.element, "offset")?.first().ok_or_else(damaged)?;
        let block = offset.checked_add(HEADER).and_then(|start| self.appended.get(start..));
        let mut raw = Vec::new();
        // What is packed may be a thousand times as large as the file: no more is read than shows that it does not fit.
        let most = (count as u64).saturating_mul(8).saturating_add(1);
        let packed = ZlibDecoder::new(block.ok_or_else(damaged)?);
        packed.take(most).read_to_end(&mut raw).map_err(|_| damaged())?;
        let (chunks, []) = raw.as_chunks::<8>() else { return Err(damaged()) };
        if chunks.len() == count { Ok(chunks.to_vec()) } else { Err(damaged()) }
    }
}

/// The attributes of the elements without content that begin in that way.
pub(super) fn elements<'a>(text: &'a str, begin: &'a str) -> impl Iterator<Item = &'a str> {
    text.split(begin).skip(1).filter_map(|rest| rest.split("/>").next())
}

/// The first value of that attribute.
pub(super) fn attribute<'a>(text: &'a str, name: &str) -> Result<&'a str, String> {
    let start = format!("{name}=\"");
    text.split_once(&start)
        .and_then(|(_, rest)| rest.split_once('"'))
        .map(|(value, _)| value)
        .ok_or_else(|| format!("`{name}` is missing"))
}

/// The numbers of that attribute.
pub(super) fn numbers<T: FromStr>(text: &str, name: &str) -> Result<Vec<T>, String> {
    attribute(text, name)?
        .split_whitespace()
        .map(|word| word.parse().map_err(|_| format!("`{name}` is not a list of numbers")))
        .collect()
}

/// The one number of that attribute.
pub(super) fn number<T: FromStr + Copy>(text: &str, name: &str) -> Result<T, String> {
    numbers(text, name)?.first().copied().ok_or_else(|| format!("`{name}` is missing"))
}

/// What XML takes for special characters in an attribute.
const ESCAPES: [(&str, &str); 4] = [("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("\"", "&quot;")];

/// Text as it may stand in an attribute.
pub(super) fn escape(text: &str) -> String {
    ESCAPES.iter().fold(text.to_owned(), |text, (plain, escaped)| text.replace(plain, escaped))
}

/// The text that [`escape`] was given.
pub(super) fn unescape(text: &str) -> String {
    ESCAPES
        .iter()
        .rev()
        .fold(text.to_owned(), |text, (plain, escaped)| text.replace(escaped, plain))
}
