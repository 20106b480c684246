mod faces;
mod outside;
mod solids;
mod zone;

use approx::assert_relative_eq;
use proptest::prelude::*;

use super::{FEATURE_ANGLE, Fault, Inside, Place, Solid, parse};
use crate::body::mesh::{ContactMesh, Corners, MESHES, Mesh, MeshError, SupportedSurfaces};
use crate::parameters::{Invalid, Value, Values};

macro_rules! files {
    ($($name:literal),*) => {
        [$(($name, include_bytes!(concat!("../../../../tests/meshes/", $name)).as_slice())),*]
    };
}

const FILES: [(&str, &[u8]); 8] = files![
    "block_2.2_text.msh",
    "block_2.2_binary.msh",
    "block_4.1_text.msh",
    "block_4.1_binary.msh",
    "block_text.stl",
    "block_binary.stl",
    "volume_4.1_text.msh",
    "second_order.msh"
];

fn bytes(name: &str) -> Vec<u8> {
    FILES.iter().find(|file| file.0 == name).unwrap().1.to_vec()
}

fn quads(mesh: &Mesh) -> usize {
    mesh.faces.iter().filter(|face| matches!(face.corners, Corners::Quad(_))).count()
}

const GMSH: [&str; 4] =
    ["block_2.2_text.msh", "block_2.2_binary.msh", "block_4.1_text.msh", "block_4.1_binary.msh"];

/// The block of `block.geo`: 40 by 30 by 20, four quadrilaterals on top.
#[track_caller]
fn is_the_block(mesh: &Mesh, name: &str) {
    assert_eq!(mesh.check([false; 2]), [], "{name}");
    assert_relative_eq!(mesh.volume([false; 2]), 24_000.0, max_relative = 1e-6);
    assert_relative_eq!(mesh.area(), 5_200.0, max_relative = 1e-6);
}

#[test]
fn all_four_kinds_of_gmsh_files_hold_the_same() {
    let first = parse(&bytes(GMSH[0])).unwrap().mesh;
    for name in GMSH {
        let mesh = parse(&bytes(name)).unwrap().mesh;
        is_the_block(&mesh, name);
        assert_eq!((mesh.faces.len(), quads(&mesh)), (first.faces.len(), 4), "{name}");
        let mut surfaces = mesh.surfaces.clone();
        surfaces.sort();
        assert_eq!(surfaces, ["bottom side", "sides", "top"], "{name}");
        let zone = mesh.zone("top").unwrap();
        assert_eq!((zone.faces.len(), zone.grid), (4, None));
        assert!(zone.faces.iter().all(|&face| mesh.area_vector(face)[2] > 299.0));
    }
}

/// Pyramids between quadrilaterals and tetrahedra are no body for finite elements; the surface is read all the same.
#[test]
fn volumes_of_other_elements_are_left_out() {
    let Solid { mesh, inside } = parse(&bytes("volume_4.1_text.msh")).unwrap();
    is_the_block(&mesh, "volume");
    assert!(inside.is_none());
}

/// Two tetrahedra, the second turned over, on each other's side: one body of six sides, written with names in three ways.
#[test]
fn inputs_of_calculix_name_sides_by_surfaces_sets_and_nodes() {
    let nodes = "*Heading\n a body\n*NODE, NSET=all\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1., 0\n4, 0, 0, 1D0\n5, 0, 0, -1\n";
    let elements = "*ELEMENT, TYPE=C3D4, ELSET=body\n1, 1, 2, 3, 4\n2, 1, 2, 3,\n5\n";
    let names = "*ELEMENT, type=S3, elset=shell\n7, 1, 3, 4\n*NSET, NSET=below\n1, 2, 5\n\
                 *ELSET, ELSET=one, GENERATE\n1, 1, 1\n*SURFACE, NAME=slope, TYPE=ELEMENT\none, S3\n2, S3\n** no more\n";
    let Solid { mesh, inside } = parse(format!("{nodes}{elements}{names}").as_bytes()).unwrap();
    let (volume, _) = inside.unwrap();
    assert_eq!((volume.elements.len(), volume.faces.len(), volume.nodes.len()), (2, 6, 5 + 9));
    assert!((mesh.volume([false; 2]) - 1.0 / 3.0).abs() < 1e-12, "all sides look outwards");
    let count = |name: &str| {
        let surface = mesh.surfaces.iter().position(|known| known == name).unwrap();
        mesh.faces.iter().filter(|face| face.surface == surface).count()
    };
    assert_eq!(["slope", "shell", "below"].map(count), [2, 1, 1]);
    let refused = |text: &str, said: &str| {
        let error = parse(text.as_bytes()).unwrap_err().to_string();
        assert!(error.contains(said), "{error}");
    };
    refused(&format!("{nodes}{elements}9, 1, 2, 3, 77\n"), "vertex 77");
    refused(&format!("{nodes}*ELEMENT, TYPE=C3D8\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"), "C3D10");
    refused(
        &format!("{nodes}{elements}*NSET, NSET=x\nnobody\n"),
        "line 14: expected a number or the name",
    );
    // What makes or moves nodes is not done, and what stands for a shell of quadrilaterals names nothing.
    refused(
        &format!("{nodes}*NGEN\n1, 5\n{elements}"),
        "all nodes and elements, each in its place",
    );
    refused(&nodes.replace("NSET=all", "SYSTEM=C"), "line 3: expected all nodes and elements");
    refused(
        &format!("{nodes}{elements}*INSTANCE, NAME=a\n1., 0., 0.\n"),
        "a part that is not moved",
    );
    refused(&format!("{nodes}{elements}{nodes}"), "each node once, found `node 1 again`");
    let shells = "*ELEMENT, TYPE=S4,\nELSET=quads\n9, 1, 2, 3, 4\n";
    assert!(parse(format!("{nodes}{elements}{shells}").as_bytes()).is_ok());
    // A range beyond all numbers takes no memory.
    let range = "*NSET, NSET=x, GENERATE\n1, 18446744073709551615, 1\n";
    assert!(parse(format!("{nodes}{elements}{range}").as_bytes()).is_ok());
    refused("*NODE\n1, 0, x, 0\n", "line 2: expected a coordinate, found `x`");
}

#[test]
fn surfaces_without_group_are_named_by_their_number() {
    let text = String::from_utf8(bytes(GMSH[2])).unwrap();
    // Surfaces of the geometry carry `1 GROUP` before their bounding curves.
    let start = text.find("$Entities").unwrap();
    let lines: Vec<String> = text[start..]
        .lines()
        .enumerate()
        .map(|(row, line)| match row {
            22..28 => {
                let words: Vec<&str> = line.split_whitespace().collect();
                [&words[..7], &["0"], &words[9..]].concat().join(" ")
            }
            _ => line.to_owned(),
        })
        .collect();
    let text = text[..start].to_owned() + &lines.join("\n");
    let mut surfaces = parse(text.as_bytes()).unwrap().mesh.surfaces;
    surfaces.sort();
    let names: Vec<String> = (1..=6).map(|tag| format!("surface {tag}")).collect();
    assert_eq!(surfaces, names);
}

#[test]
fn stl_is_welded_and_named_by_its_solids() {
    let text = parse(&bytes("block_text.stl")).unwrap().mesh;
    let binary = parse(&bytes("block_binary.stl")).unwrap().mesh;
    for (mesh, name) in [(&text, "text"), (&binary, "binary")] {
        is_the_block(mesh, name);
        assert_eq!(quads(mesh), 0);
        // A closed surface of triangles without holes (Euler).
        assert_eq!(mesh.vertices.len(), mesh.faces.len() / 2 + 2);
    }
    assert_eq!(text.surfaces, ["top", "bottom side", "sides"]);
    assert_eq!(binary.surfaces, ["surface"]);
}

#[test]
fn unlike_bytes_are_swapped() {
    let message = |mut bytes: Vec<u8>| {
        let one = bytes.windows(4).position(|four| four == [1, 0, 0, 0]).unwrap();
        bytes[one..one + 4].reverse();
        parse(&bytes).unwrap_err().to_string()
    };
    // The rest is not swapped and hence wrong.
    assert!(message(bytes(GMSH[1])).starts_with("byte "));
    assert!(message(bytes(GMSH[3])).starts_with("byte "));
}

#[track_caller]
fn refused(text: &str, line: usize, said: &str) {
    let error = parse(text.as_bytes()).unwrap_err();
    assert_eq!(error.place, Place::Line(line), "{error}");
    assert!(error.to_string().contains(said), "{error}");
}

#[test]
fn errors_name_the_line_and_what_to_do() {
    refused("nothing", 1, "neither a Gmsh mesh nor STL");
    refused("$MeshFormat\n4 0 8\n$EndMeshFormat\n", 3, "save it as 2.2 or 4.1");
    let head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    refused(head, 4, "mesh the surface");
    let nodes = format!("{head}$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 x\n$EndNodes\n");
    refused(&nodes, 8, "expected a coordinate, found `x`");
    let nodes = nodes.replace('x', "0");
    refused(
        &format!("{nodes}$Elements\n1\n1 9 2 1 1 1 2 3 1 2 3\n$EndElements\n"),
        12,
        "Mesh.ElementOrder = 1",
    );
    refused(&format!("{nodes}$Elements\n1\n1 99 2 1 1 1 2 3\n"), 12, "unknown kind 99");
    refused(&format!("{nodes}$Elements\n5\n1 2 2 1 1 1 2 3\n"), 13, "the file ends where");
    refused(&format!("{nodes}$Elements\n1\n1 2 2 1 1 1 2 4\n$EndElements"), 13, "the vertex 4");
    refused(&format!("{head}$Nodes\n2\n1 0 0 0\n1 1 0 0\n"), 7, "vertex 1 is there twice");
    refused("solid a\nfacet normal 0 0 1\nouter lop\n", 3, "expected loop, found `lop`");
    refused("solid a\nendsolid a\n", 3, "no triangles");
    assert!(matches!(
        parse(&bytes("second_order.msh")).unwrap_err().fault,
        Fault::HigherOrder { kind: 9 | 10 | 16 }
    ));
}

#[test]
fn counts_set_no_memory_aside() {
    let head = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    let huge = "18446744073709551615";
    for section in ["Nodes", "Elements"] {
        let text = format!("{head}${section}\n{huge} {huge} {huge} {huge}\n2 1 0 {huge}\n1 2 3");
        assert!(parse(text.as_bytes()).is_err());
        let text = format!("{head}${section}\n1 1 1 1\n2 1 2 {huge}\n1 1 2 3");
        assert!(parse(text.as_bytes()).is_err());
    }
    let mut stl = vec![0; 84];
    stl[80..].fill(0xff);
    assert!(parse(&stl).is_err());
}

proptest! {
    /// Broken files are refused or read, never more.
    #[test]
    fn broken_files_do_no_harm(
        file in 0..6_usize,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..8),
        cut in any::<prop::sample::Index>(),
        whole in any::<bool>(),
    ) {
        let name = [&GMSH[..], &["block_text.stl", "block_binary.stl"]].concat()[file];
        let mut bytes = bytes(name);
        for (place, byte) in changes {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        if !whole {
            bytes.truncate(cut.index(bytes.len()));
        }
        if let Ok(Solid { mesh, inside }) = parse(&bytes) {
            mesh.check([true, false]);
            inside.map(|inside| Inside::new(inside, 1.0, None, FEATURE_ANGLE).fault());
        }
    }
}

fn build(contact: Option<&str>, unit: Option<&str>) -> Result<ContactMesh, Invalid> {
    let choice = MESHES.iter().find(|choice| choice.name == "file").unwrap();
    let mut values = Values::default();
    let name = GMSH[2].to_owned();
    values.insert("path", Value::File { bytes: bytes(&name).into(), name });
    if let Some(contact) = contact {
        values.insert("contact", Value::Word(contact.to_owned()));
    }
    if let Some(unit) = unit {
        values.insert("unit", Value::Word(unit.to_owned()));
    }
    Ok((choice.build)(&values)?.mesh([false; 2], &SupportedSurfaces::default())?)
}

#[test]
fn files_are_scaled_and_placed() {
    let meshed = build(Some("top"), Some("mm")).unwrap();
    assert!(meshed.placed && meshed.zone.faces.len() == 4);
    assert_relative_eq!(meshed.mesh.volume([false; 2]), 24e-6, max_relative = 1e-6);
    let meshed = build(None, None).unwrap();
    assert!(meshed.zone.faces.is_empty());
    assert_relative_eq!(meshed.mesh.volume([false; 2]), 24e3, max_relative = 1e-6);
}

#[test]
fn a_surface_that_is_not_there_is_said_with_those_that_are() {
    let error = build(Some("up"), None).unwrap_err();
    assert_eq!(error.parameter, "contact");
    assert!(error.message.contains("no surface `up`; it has `"), "{}", error.message);
    assert!(error.message.contains("`bottom side`"), "{}", error.message);
    let mesh = parse(&bytes(GMSH[0])).unwrap().mesh;
    assert!(matches!(mesh.zone(""), Err(MeshError::NoSurface { .. })));
}
