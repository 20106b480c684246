//! Gmsh's `.msh`, versions 2.2 and 4.1, text and binary (Gmsh reference manual, "MSH file format").
//!
//! Text and binary differ only in how a number is written, so one reader serves both. No memory is
//! set aside for a count before as many things have been read.

mod elements;
mod version_2;
mod version_4;

use std::collections::HashMap;

use super::error::{Fault, MeshFileError, Place};
use super::solid::{self, Solid};
use super::source::Source;
use crate::body::mesh::{Corners, Face, Mesh};
use elements::{Kind, kind};

/// Gmsh's number of triangles of six nodes, the sides of tetrahedra of ten.
const SIX_NODES: u64 = 9;

/// What a file holds.
#[derive(Debug, Default)]
struct Contents {
    /// Places by their number.
    nodes: HashMap<u64, [f64; 3]>,
    /// Names of physical groups of surfaces, by their number.
    groups: HashMap<u64, String>,
    /// Physical groups of surfaces, by the surface's number.
    group_of: HashMap<u64, u64>,
    /// The surface elements.
    faces: Vec<Element>,
    /// The numbers of the nodes of tetrahedra: four corners, and of tetrahedra of ten the nodes on edges in the order of a volume.
    tetrahedra: Vec<Vec<u64>>,
    /// Whether there are volume elements of other kinds.
    others: bool,
    /// Where a triangle of six nodes stands.
    curved: Option<Place>,
}

/// A triangle or quadrilateral with the numbers of its corners.
#[derive(Debug)]
struct Element {
    corners: [u64; 4],
    /// How many of the corners count.
    count: usize,
    part: Part,
}

/// The part of the surface an element belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Part {
    /// A physical group.
    Group(u64),
    /// A surface of the geometry.
    Surface(u64),
}

/// The surface in the bytes of a file, and what is inside where it is in tetrahedra; vertices of no element are left out.
pub(super) fn parse(bytes: &[u8]) -> Result<Solid, MeshFileError> {
    let mut source = Source::new(bytes);
    source.behind("$MeshFormat")?;
    let version = source.word("the version")?.to_owned();
    let binary = source.int("whether the file is binary")? != 0;
    let size = source.int("the size of a number")?;
    source.line();
    let contents = match &*version {
        "2" | "2.1" | "2.2" => {
            begin(&mut source, binary, size)?;
            read(&mut source, version_2::section)?
        }
        "4.1" => {
            begin(&mut source, binary, size)?;
            read(&mut source, version_4::section)?
        }
        _ => return Err(source.error(Fault::Version { version })),
    };
    contents.solid(&source)
}

/// Reads the number a binary file begins with, which gives the order of bytes.
fn begin(source: &mut Source<'_>, binary: bool, size: i64) -> Result<(), MeshFileError> {
    source.binary = binary;
    if !binary {
        return Ok(());
    }
    match source.int("the number 1")? {
        1 => {}
        0x0100_0000 => source.swapped = true,
        _ => return Err(source.error(Fault::Binary)),
    }
    if size == 8 { Ok(()) } else { Err(source.error(Fault::Binary)) }
}

/// Reads the sections one after the other.
fn read(
    source: &mut Source<'_>,
    section: fn(&str, &mut Source<'_>, &mut Contents) -> Result<(), MeshFileError>,
) -> Result<Contents, MeshFileError> {
    let mut contents = Contents::default();
    source.behind("$EndMeshFormat")?;
    source.line();
    while !source.rest().trim_ascii().is_empty() {
        let heading = source.word("a section")?;
        if !heading.starts_with('$') {
            let found = heading.chars().take(40).collect();
            let expected = "the heading of a section";
            return Err(source.error(Fault::Unexpected { expected, found }));
        }
        source.line();
        match heading {
            "$PhysicalNames" => names(source, &mut contents)?,
            _ => section(heading, source, &mut contents)?,
        }
        source.behind("$End")?;
        source.line();
    }
    Ok(contents)
}

/// The names of physical groups, a text even in binary files.
fn names(source: &mut Source<'_>, contents: &mut Contents) -> Result<(), MeshFileError> {
    let count: u64 = source.parse("the number of physical groups")?;
    for _ in 0..count {
        let dimension: u64 = source.parse("the dimension of a physical group")?;
        let tag: u64 = source.parse("the number of a physical group")?;
        let name = source.quoted("the name of a physical group in quotes")?;
        if dimension == 2 {
            contents.groups.insert(tag, name);
        }
    }
    Ok(())
}

impl Contents {
    /// Adds a node.
    fn node(
        &mut self,
        tag: u64,
        place: [f64; 3],
        source: &Source<'_>,
    ) -> Result<(), MeshFileError> {
        match self.nodes.insert(tag, place) {
            None => Ok(()),
            Some(_) => Err(source.error(Fault::VertexTwice { vertex: tag })),
        }
    }

    /// The surface, and what is inside where it is in tetrahedra alone.
    fn solid(self, source: &Source<'_>) -> Result<Solid, MeshFileError> {
        if self.tetrahedra.is_empty() || self.others {
            if let Some(place) = self.curved {
                return Err(MeshFileError { place, fault: Fault::HigherOrder { kind: SIX_NODES } });
            }
            let mesh = self.mesh(source)?;
            return Ok(Solid { mesh, inside: None });
        }
        let named = self.faces.iter().filter(|element| element.count == 3).map(|element| {
            let [a, b, c, _] = element.corners;
            ([a, b, c], self.name(self.part(element)))
        });
        let place = |tag: u64| self.nodes.get(&tag).copied();
        let inside = solid::inside(&self.tetrahedra, place, named.collect());
        let inside = inside.map_err(|vertex| source.error(Fault::NoVertex { vertex }))?;
        let mesh = match self.faces.is_empty() {
            true => inside.1.clone(),
            false => self.mesh(source)?,
        };
        Ok(Solid { mesh, inside: Some(inside) })
    }

    /// The part of the surface that an element belongs to.
    fn part(&self, element: &Element) -> Part {
        match element.part {
            Part::Surface(tag) => {
                self.group_of.get(&tag).map_or(element.part, |group| Part::Group(*group))
            }
            group => group,
        }
    }

    /// The mesh, its vertices in the order in which elements name them.
    fn mesh(&self, source: &Source<'_>) -> Result<Mesh, MeshFileError> {
        if self.faces.is_empty() {
            return Err(source.error(Fault::NoSurface));
        }
        let mut mesh = Mesh::default();
        let (mut vertices, mut parts) = (HashMap::new(), HashMap::new());
        for element in &self.faces {
            let part = self.part(element);
            let surface = *parts.entry(part).or_insert_with(|| {
                mesh.surfaces.push(self.name(part));
                mesh.surfaces.len() - 1
            });
            let mut corners = [0; 4];
            for (corner, tag) in corners.iter_mut().zip(&element.corners[..element.count]) {
                let place = self
                    .nodes
                    .get(tag)
                    .ok_or_else(|| source.error(Fault::NoVertex { vertex: *tag }))?;
                *corner = *vertices.entry(*tag).or_insert_with(|| {
                    mesh.vertices.push(*place);
                    mesh.vertices.len() - 1
                });
            }
            let [a, b, c, _] = corners;
            let corners = match element.count {
                3 => Corners::Triangle([a, b, c]),
                _ => Corners::Quad(corners),
            };
            mesh.faces.push(Face { corners, surface });
        }
        Ok(mesh)
    }

    fn name(&self, part: Part) -> String {
        match part {
            Part::Group(tag) => {
                self.groups.get(&tag).cloned().unwrap_or_else(|| format!("surface {tag}"))
            }
            Part::Surface(tag) => format!("surface {tag}"),
        }
    }

    /// Reads the nodes of an element of that kind and keeps it if it is one of a surface or a tetrahedron.
    fn element(
        &mut self,
        kind: &Kind,
        part: Part,
        mut node: impl FnMut() -> Result<u64, MeshFileError>,
    ) -> Result<(), MeshFileError> {
        let nodes = (0..kind.nodes).map(|_| node()).collect::<Result<Vec<u64>, _>>()?;
        match (kind.dimension, nodes.as_slice()) {
            (2, nodes) => {
                let count = if nodes.len() == 6 { 3 } else { nodes.len().min(4) };
                let mut corners = [0; 4];
                corners[..count].copy_from_slice(&nodes[..count]);
                self.faces.push(Element { corners, count, part });
            }
            (3, &[a, b, c, d]) => self.tetrahedra.push(vec![a, b, c, d]),
            (3, &[a, b, c, d, ab, bc, ca, ad, cd, bd]) => {
                self.tetrahedra.push(vec![a, b, c, d, ab, bc, ca, ad, bd, cd]);
            }
            (3, _) => self.others = true,
            _ => {}
        }
        Ok(())
    }
}

/// The kind of that number, or an error if its elements cannot be used.
fn usable(
    number: u64,
    source: &Source<'_>,
    contents: &mut Contents,
) -> Result<Kind, MeshFileError> {
    let Some(kind) = kind(number) else {
        return Err(source.error(Fault::UnknownKind { kind: number }));
    };
    if number == SIX_NODES {
        contents.curved.get_or_insert(source.error(Fault::HigherOrder { kind: number }).place);
    } else if kind.dimension == 2 && !matches!(number, 2 | 3) {
        return Err(source.error(Fault::HigherOrder { kind: number }));
    }
    Ok(kind)
}
