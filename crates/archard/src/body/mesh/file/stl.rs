//! STL, text or binary: triangles with their three corners each.

use super::error::{Fault, MeshFileError};
use super::source::Source;
use super::weld::Triangles;
use crate::body::mesh::Mesh;

/// Length of the head of a binary file (bytes).
const HEAD: usize = 80;
/// Length of a triangle in a binary file (bytes).
const TRIANGLE: usize = 50;

/// Whether the bytes may be STL.
pub(super) fn is_stl(bytes: &[u8]) -> bool {
    is_binary(bytes) || bytes.trim_ascii_start().starts_with(b"solid")
}

/// A binary file is as long as its number of triangles says, even where its head says `solid`.
fn is_binary(bytes: &[u8]) -> bool {
    let count = bytes.get(HEAD..HEAD + 4).and_then(|count| count.first_chunk::<4>());
    count.is_some_and(|count| {
        let length = u64::from(u32::from_le_bytes(*count)) * TRIANGLE as u64;
        length > 0 && length + HEAD as u64 + 4 == bytes.len() as u64
    })
}

/// The surface in the bytes of a file, corners at the same place made one vertex.
pub(super) fn parse(bytes: &[u8]) -> Result<Mesh, MeshFileError> {
    let mut source = Source::new(bytes);
    let mut triangles = Triangles::default();
    let mesh = if is_binary(bytes) {
        binary(&mut source, &mut triangles)?;
        triangles.weld(f64::from(f32::EPSILON))
    } else {
        text(&mut source, &mut triangles)?;
        triangles.weld(f64::EPSILON)
    };
    if mesh.faces.is_empty() {
        return Err(source.error(Fault::NoSurface));
    }
    Ok(mesh)
}

fn binary(source: &mut Source<'_>, triangles: &mut Triangles) -> Result<(), MeshFileError> {
    source.binary = true;
    source.take::<{ HEAD + 4 }>("the head")?;
    let surface = triangles.surface("");
    while !source.rest().is_empty() {
        source.take::<12>("a normal")?;
        let mut corners = [[0.0; 3]; 3];
        for value in corners.as_flattened_mut() {
            let number = f32::from_le_bytes(source.take("a coordinate")?);
            *value = source.finite(f64::from(number), "a coordinate")?;
        }
        source.take::<2>("the end of a triangle")?;
        triangles.push(surface, corners);
    }
    Ok(())
}

fn text(source: &mut Source<'_>, triangles: &mut Triangles) -> Result<(), MeshFileError> {
    while !source.rest().trim_ascii_start().is_empty() {
        expect(source, "solid")?;
        let name = source.line();
        let surface = triangles.surface(&name);
        loop {
            match source.word("`facet` or `endsolid`")? {
                "endsolid" => break,
                "facet" => triangles.push(surface, facet(source)?),
                other => {
                    let found = other.chars().take(40).collect();
                    let expected = "`facet` or `endsolid`";
                    return Err(source.error(Fault::Unexpected { expected, found }));
                }
            }
        }
        source.line();
    }
    Ok(())
}

/// The corners of a triangle, behind its first word.
fn facet(source: &mut Source<'_>) -> Result<[[f64; 3]; 3], MeshFileError> {
    expect(source, "normal")?;
    for _ in 0..3 {
        // Some programs write nan here; the corners say it all.
        source.word("a component of the normal")?;
    }
    expect(source, "outer")?;
    expect(source, "loop")?;
    let mut corners = [[0.0; 3]; 3];
    for corner in &mut corners {
        expect(source, "vertex")?;
        for value in corner {
            *value = source.double("a coordinate")?;
        }
    }
    expect(source, "endloop")?;
    expect(source, "endfacet")?;
    Ok(corners)
}

fn expect(source: &mut Source<'_>, word: &'static str) -> Result<(), MeshFileError> {
    let found = source.word(word)?;
    if found == word {
        return Ok(());
    }
    let found = found.chars().take(40).collect();
    Err(source.error(Fault::Unexpected { expected: word, found }))
}
