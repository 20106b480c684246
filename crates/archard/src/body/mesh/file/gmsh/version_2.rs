//! The sections of version 2.2.

use super::{Contents, Part, usable};
use crate::body::mesh::file::error::{Fault, MeshFileError};
use crate::body::mesh::file::source::Source;

/// Reads a section behind its heading, if it is one that matters.
pub(super) fn section(
    heading: &str,
    source: &mut Source<'_>,
    contents: &mut Contents,
) -> Result<(), MeshFileError> {
    match heading {
        "$Nodes" => nodes(source, contents),
        "$Elements" => elements(source, contents),
        _ => Ok(()),
    }
}

fn nodes(source: &mut Source<'_>, contents: &mut Contents) -> Result<(), MeshFileError> {
    let count: u64 = source.parse("the number of vertices")?;
    source.line();
    for _ in 0..count {
        let tag = source.index("the number of a vertex")?;
        let mut place = [0.0; 3];
        for value in &mut place {
            *value = source.double("a coordinate")?;
        }
        contents.node(tag, place, source)?;
    }
    Ok(())
}

/// Elements have tags: the first is the physical group and the second the surface. A binary
/// file has heads before some elements of one kind, a text a head before each.
fn elements(source: &mut Source<'_>, contents: &mut Contents) -> Result<(), MeshFileError> {
    let count: u64 = source.parse("the number of elements")?;
    source.line();
    let mut read = 0;
    while read < count {
        if !source.binary {
            source.size("the number of an element")?;
        }
        let number = source.index("the kind of an element")?;
        let kind = usable(number, source, contents)?;
        let alike =
            if source.binary { source.index("the number of elements of a kind")? } else { 1 };
        if alike == 0 {
            let expected = "the number of elements of a kind";
            return Err(source.error(Fault::Unexpected { expected, found: "0".to_owned() }));
        }
        let tags = source.index("the number of tags")?;
        for _ in 0..alike {
            if source.binary {
                source.int("the number of an element")?;
            }
            let part = part(source, tags)?;
            contents.element(&kind, part, || source.index("the corner of an element"))?;
        }
        read += alike;
    }
    Ok(())
}

fn part(source: &mut Source<'_>, tags: u64) -> Result<Part, MeshFileError> {
    let (mut group, mut surface) = (0, 0);
    for place in 0..tags {
        let tag = source.int("the tag of an element")?.unsigned_abs();
        match place {
            0 => group = tag,
            1 => surface = tag,
            _ => {}
        }
    }
    Ok(if group == 0 { Part::Surface(surface) } else { Part::Group(group) })
}
