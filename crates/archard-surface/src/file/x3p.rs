//! `.x3p` of ISO 25178-72: a zip archive whose `main.xml` describes the axes, and binary points next to it, those along x first.
//!
//! Heights are value times increment plus offset of the axis CZ, in metres. Of points that were not measured floating-point
//! values are not a number; a file of bits, the lowest first, may mark them too. Sizes are compared before anything is
//! unpacked, so that a small archive takes no more memory than its surface has points.

use std::io::{Cursor, Read};

use md5::{Digest, Md5};
use roxmltree::{Document, Node};
use zip::ZipArchive;

use super::{ReadError, Scale};
use crate::map::{HeightMap, count};

/// How zip archives begin.
pub(super) const MAGIC: &[u8] = b"PK\x03\x04";
const HEAD: &str = "main.xml";
const SUM_OF_HEAD: &str = "md5checksum.hex";
/// Most bytes of the head and of its checksum: heads have a few kilobytes, and a comment.
const MOST_OF_HEAD: usize = 1 << 20;
/// Most attributes of the head; only the namespace is needed. The parser compares each with those before it, and
/// namespaces with all around them: the time grows with the third power, and is .2 s for so many.
const MOST_ATTRIBUTES: usize = 1000;

type Archive<'a> = ZipArchive<Cursor<&'a [u8]>>;

/// Whether an archive has the head of a surface.
pub(super) fn has_a_head(all: &[u8]) -> bool {
    archive(all).is_ok_and(|archive| archive.index_for_name(HEAD).is_some())
}

pub(super) fn read(all: &[u8], scale: Scale, most: usize) -> Result<HeightMap, ReadError> {
    let mut archive = archive(all)?;
    let bytes = unpacked(&mut archive, HEAD, MOST_OF_HEAD)?;
    if archive.index_for_name(SUM_OF_HEAD).is_some() {
        let sum = unpacked(&mut archive, SUM_OF_HEAD, MOST_OF_HEAD)?;
        // As `md5sum` writes it. SurfaceTopography names the points here, whose sum the head has too.
        let sum = String::from_utf8_lossy(&sum);
        let mut words = sum.split_whitespace();
        let (sum, of) = (words.next(), words.next().unwrap_or(HEAD));
        checked(HEAD, &bytes, sum.filter(|_| of.trim_start_matches('*') == HEAD))?;
    }
    let text = std::str::from_utf8(&bytes)
        .map_err(|_| ReadError::Damaged(format!("{HEAD} is no UTF-8")))?
        .trim_start_matches('\u{feff}');
    let quoted = |rest: &&str| rest.trim_start().starts_with(['"', '\'']);
    if text.split('=').skip(1).filter(quoted).count() > MOST_ATTRIBUTES {
        let message = format!("{HEAD} has more than {MOST_ATTRIBUTES} attributes");
        return Err(ReadError::Damaged(message));
    }
    let document = Document::parse(text)
        .map_err(|error| ReadError::Damaged(format!("{HEAD} is no XML: {error}")))?;
    let head = Head::of(document.root_element())?;
    let count = count(head.elements, most)?;
    let (width, value) = head.number;
    let points = exactly(&mut archive, head.points, count * width)?;
    checked(head.points, &points, head.sum_of_points)?;
    let [step, offset] = head.heights;
    let height = |point: &[u8]| step * value(point) + offset;
    let mut heights: Vec<f64> = points.chunks_exact(width).map(height).collect();
    drop(points);
    if let Some(marks) = head.valid {
        let bits = exactly(&mut archive, marks, count.div_ceil(8))?;
        checked(marks, &bits, head.sum_of_valid)?;
        for (at, height) in heights.iter_mut().enumerate() {
            if bits[at / 8] >> (at % 8) & 1 == 0 {
                *height = f64::NAN;
            }
        }
    }
    Ok(HeightMap::new(head.elements, scale.pixel.unwrap_or(head.pixel), heights)?)
}

/// What `main.xml` gives.
struct Head<'a> {
    elements: [usize; 2],
    pixel: [f64; 2],
    /// Increment and offset (m).
    heights: [f64; 2],
    number: Number,
    /// The file of the points.
    points: &'a str,
    sum_of_points: Option<&'a str>,
    /// The file of bits for points that were measured.
    valid: Option<&'a str>,
    sum_of_valid: Option<&'a str>,
}

impl<'a> Head<'a> {
    fn of(root: Node<'a, 'a>) -> Result<Self, ReadError> {
        let kind = needed(root, "Record1/FeatureType")?;
        if kind != "SUR" {
            return Err(ReadError::Unsupported(format!(
                "an .x3p of {kind}, not of a surface (SUR)"
            )));
        }
        for axis in ["CX", "CY"] {
            if needed(root, &format!("Record1/Axes/{axis}/AxisType"))? != "I" {
                let message = format!("an .x3p whose axis {axis} lists places");
                return Err(ReadError::Unsupported(message));
            }
        }
        let size = "Record3/MatrixDimension/Size";
        if text(root, &format!("{size}Z")).is_some_and(|layers| layers != "1") {
            return Err(ReadError::Unsupported("an .x3p of several layers".to_owned()));
        }
        if at(root, "Record3/DataList").is_some() {
            return Err(ReadError::Unsupported(format!("an .x3p with its points in {HEAD}")));
        }
        let kind = needed(root, "Record1/Axes/CZ/DataType")?;
        let unknown = || ReadError::Unsupported(format!("an .x3p of data type `{kind}`"));
        let file = |path: &str| text(root, path).map(|name| name.trim_start_matches(['.', '/']));
        let link = "Record3/DataLink";
        let missing = || ReadError::Damaged(format!("{HEAD} has no {link}/PointDataLink"));
        Ok(Self {
            elements: [whole(root, &format!("{size}X"))?, whole(root, &format!("{size}Y"))?],
            pixel: [
                number(root, "Record1/Axes/CX/Increment", None)?,
                number(root, "Record1/Axes/CY/Increment", None)?,
            ],
            heights: [
                number(root, "Record1/Axes/CZ/Increment", Some(1.0))?,
                number(root, "Record1/Axes/CZ/Offset", Some(0.0))?,
            ],
            number: number_of(kind).ok_or_else(unknown)?,
            points: file(&format!("{link}/PointDataLink")).ok_or_else(missing)?,
            sum_of_points: text(root, &format!("{link}/MD5ChecksumPointData")),
            valid: file(&format!("{link}/ValidPointsLink")),
            sum_of_valid: text(root, &format!("{link}/MD5ChecksumValidPoints")),
        })
    }
}

/// How many bytes a value has, and which number they are.
type Number = (usize, fn(&[u8]) -> f64);

fn number_of(kind: &str) -> Option<Number> {
    macro_rules! of {
        ($type:ty) => {
            (size_of::<$type>(), |point: &[u8]| {
                point.try_into().map_or(f64::NAN, |own| f64::from(<$type>::from_le_bytes(own)))
            })
        };
    }
    Some(match kind {
        "I" => of!(i16),
        "L" => of!(i32),
        "F" => of!(f32),
        "D" => of!(f64),
        _ => return None,
    })
}

/// The element at the end of a path of names.
fn at<'a>(root: Node<'a, 'a>, path: &str) -> Option<Node<'a, 'a>> {
    let child = |node: Node<'a, 'a>, name: &str| {
        node.children().find(|child| child.is_element() && child.tag_name().name() == name)
    };
    path.split('/').try_fold(root, child)
}

/// The text of an element, if it has any.
fn text<'a>(root: Node<'a, 'a>, path: &str) -> Option<&'a str> {
    at(root, path)?.text().map(str::trim).filter(|text| !text.is_empty())
}

fn needed<'a>(root: Node<'a, 'a>, path: &str) -> Result<&'a str, ReadError> {
    text(root, path).ok_or_else(|| ReadError::Damaged(format!("{HEAD} has no {path}")))
}

fn whole(root: Node, path: &str) -> Result<usize, ReadError> {
    let word = needed(root, path)?;
    let wrong = || ReadError::Damaged(format!("{HEAD}: {path} is `{word}`"));
    word.parse().map_err(|_| wrong())
}

fn number(root: Node, path: &str, otherwise: Option<f64>) -> Result<f64, ReadError> {
    let word = match (text(root, path), otherwise) {
        (None, Some(value)) => return Ok(value),
        _ => needed(root, path)?,
    };
    let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
    number.ok_or_else(|| ReadError::Damaged(format!("{HEAD}: {path} is `{word}`")))
}

fn archive(all: &[u8]) -> Result<Archive<'_>, ReadError> {
    ZipArchive::new(Cursor::new(all))
        .map_err(|error| ReadError::Damaged(format!("no zip archive: {error}")))
}

/// A file of the archive of at most so many bytes.
fn unpacked(archive: &mut Archive, name: &str, most: usize) -> Result<Vec<u8>, ReadError> {
    let damaged = |error: &dyn std::fmt::Display| ReadError::Damaged(format!("{name}: {error}"));
    let file = archive.by_name(name).map_err(|error| damaged(&error))?;
    if file.size() > most as u64 {
        let size = file.size();
        return Err(damaged(&format!("{size} bytes, where at most {most} have a place")));
    }
    let mut bytes = vec![];
    // What it says of its size may be wrong.
    let read = file.take(most as u64 + 1).read_to_end(&mut bytes);
    read.map_err(|error| damaged(&error))?;
    if bytes.len() > most {
        return Err(damaged(&format!("more than {most} bytes")));
    }
    Ok(bytes)
}

/// A file of the archive of that many bytes.
fn exactly(archive: &mut Archive, name: &str, size: usize) -> Result<Vec<u8>, ReadError> {
    let bytes = unpacked(archive, name, size)?;
    if bytes.len() < size {
        let found = bytes.len();
        let message = format!("{name} has {found} bytes, and its points need {size}");
        return Err(ReadError::Damaged(message));
    }
    Ok(bytes)
}

/// Compares a file with its checksum, where there is one.
fn checked(name: &str, bytes: &[u8], sum: Option<&str>) -> Result<(), ReadError> {
    let own = || Md5::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect::<String>();
    match sum {
        Some(sum) if !sum.eq_ignore_ascii_case(&own()) => {
            Err(ReadError::Damaged(format!("the checksum of {name} is another")))
        }
        _ => Ok(()),
    }
}
