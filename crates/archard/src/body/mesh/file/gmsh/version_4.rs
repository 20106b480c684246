//! The sections of version 4.1.

use super::{Contents, Part, usable};
use crate::body::mesh::file::error::MeshFileError;
use crate::body::mesh::file::source::Source;

/// Reads a section behind its heading, if it is one that matters.
pub(super) fn section(
    heading: &str,
    source: &mut Source<'_>,
    contents: &mut Contents,
) -> Result<(), MeshFileError> {
    match heading {
        "$Entities" => entities(source, contents),
        "$Nodes" => nodes(source, contents),
        "$Elements" => elements(source, contents),
        _ => Ok(()),
    }
}

/// Points, curves, surfaces and volumes of the geometry; the physical groups of surfaces matter.
fn entities(source: &mut Source<'_>, contents: &mut Contents) -> Result<(), MeshFileError> {
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = source.size("the number of entities")?;
    }
    for (dimension, count) in counts.into_iter().enumerate().take(3) {
        for _ in 0..count {
            let tag = source.int("the number of an entity")?.unsigned_abs();
            for _ in 0..if dimension == 0 { 3 } else { 6 } {
                source.double("a corner of the box around an entity")?;
            }
            let groups = source.size("the number of physical groups")?;
            for place in 0..groups {
                let group = source.int("a physical group")?.unsigned_abs();
                if dimension == 2 && place == 0 {
                    contents.group_of.insert(tag, group);
                }
            }
            if dimension > 0 {
                for _ in 0..source.size("the number of bounding entities")? {
                    source.int("a bounding entity")?;
                }
            }
        }
    }
    Ok(())
}

fn nodes(source: &mut Source<'_>, contents: &mut Contents) -> Result<(), MeshFileError> {
    let blocks = source.size("the number of blocks")?;
    for _ in 0..3 {
        source.size("the numbers of vertices")?;
    }
    for _ in 0..blocks {
        let dimension = source.index("the dimension of an entity")?;
        source.int("the number of an entity")?;
        let parametric = source.int("whether vertices have parameters")? != 0;
        let count = source.size("the number of vertices")?;
        let mut tags = vec![];
        for _ in 0..count {
            tags.push(source.size("the number of a vertex")?);
        }
        let parameters = if parametric { dimension.min(3) } else { 0 };
        for tag in tags {
            let mut place = [0.0; 3];
            for value in &mut place {
                *value = source.double("a coordinate")?;
            }
            for _ in 0..parameters {
                source.double("a parameter of a vertex")?;
            }
            contents.node(tag, place, source)?;
        }
    }
    Ok(())
}

fn elements(source: &mut Source<'_>, contents: &mut Contents) -> Result<(), MeshFileError> {
    let blocks = source.size("the number of blocks")?;
    for _ in 0..3 {
        source.size("the numbers of elements")?;
    }
    for _ in 0..blocks {
        source.int("the dimension of an entity")?;
        let surface = source.int("the number of an entity")?.unsigned_abs();
        let number = source.index("the kind of elements")?;
        let kind = usable(number, source, contents)?;
        for _ in 0..source.size("the number of elements")? {
            source.size("the number of an element")?;
            let part = Part::Surface(surface);
            contents.element(&kind, part, || source.size("the corner of an element"))?;
        }
    }
    Ok(())
}
