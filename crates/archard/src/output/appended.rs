//! Arrays appended to VTK's XML files: raw, each one block compressed by zlib.
//!
//! The layout is that of the VTK file formats guide (Kitware, "XML File Formats"): an array is its
//! number of blocks, the size of a block, the size of the last block if it is a partial one, the
//! compressed size of each block, and the blocks.

use std::io::{self, Read, Write};
use std::str::FromStr;

use flate2::Compression;
use flate2::read::ZlibDecoder;
use flate2::write::ZlibEncoder;

/// What stands between the description and the arrays.
const APPENDED: &str = "  <AppendedData encoding=\"raw\">\n   _";
/// Bytes before an array's block: its number of blocks and three sizes.
const HEADER: usize = 32;

/// The opening of a file of that type.
pub(super) fn opening(kind: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
    )
}

/// Arrays on their way into a file.
#[derive(Debug, Default)]
pub(super) struct Arrays {
    bytes: Vec<u8>,
}

impl Arrays {
    /// Takes an array up; the attribute that says where it is.
    pub(super) fn add<const N: usize>(
        &mut self,
        values: impl Iterator<Item = [u8; N]>,
    ) -> io::Result<String> {
        let raw: Vec<u8> = values.flatten().collect();
        let mut encoder = ZlibEncoder::new(vec![0; HEADER], Compression::fast());
        encoder.write_all(&raw)?;
        let mut array = encoder.finish()?;
        let sizes = [1, raw.len(), 0, array.len() - HEADER];
        for (place, size) in array.chunks_exact_mut(8).zip(sizes) {
            place.copy_from_slice(&(size as u64).to_le_bytes());
        }
        let attribute = format!("format=\"appended\" offset=\"{}\"", self.bytes.len());
        self.bytes.append(&mut array);
        Ok(attribute)
    }

    /// The file that begins with a description.
    pub(super) fn below(self, description: String) -> Vec<u8> {
        let mut bytes = description.into_bytes();
        bytes.extend_from_slice(APPENDED.as_bytes());
        bytes.extend_from_slice(&self.bytes);
        bytes.extend_from_slice(b"\n  </AppendedData>\n</VTKFile>\n");
        bytes
    }
}

/// A file's description and its arrays.
pub(super) fn split(bytes: &[u8]) -> Result<(&str, &[u8]), String> {
    let split = bytes
        .windows(APPENDED.len())
        .position(|window| window == APPENDED.as_bytes())
        .ok_or("it has no raw appended data")?;
    let text = str::from_utf8(&bytes[..split]).map_err(|_| "its description is not text")?;
    Ok((text, &bytes[split + APPENDED.len()..]))
}

/// The words of eight bytes of the array described by a tag; `count` of them.
pub(super) fn words(tag: &str, appended: &[u8], count: usize) -> Result<Vec<[u8; 8]>, String> {
    let damaged = || match attribute(tag, "Name") {
        Ok(name) => format!("the array `{}` is damaged", unescape(name)),
        Err(error) => error,
    };
    let offset = *numbers::<usize>(tag, "offset")?.first().ok_or_else(damaged)?;
    let block = offset.checked_add(HEADER).and_then(|start| appended.get(start..));
    let mut raw = Vec::new();
    // What is packed may be a thousand times as large as the file: no more is read than shows that it does not fit.
    let most = (count as u64).saturating_mul(8).saturating_add(1);
    let packed = ZlibDecoder::new(block.ok_or_else(damaged)?);
    packed.take(most).read_to_end(&mut raw).map_err(|_| damaged())?;
    let (chunks, []) = raw.as_chunks::<8>() else { return Err(damaged()) };
    if chunks.len() == count { Ok(chunks.to_vec()) } else { Err(damaged()) }
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
