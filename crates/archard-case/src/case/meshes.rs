//! Meshes as cases write them: read, refused where they are wrong, printed.

use std::fmt::{self, Display, Formatter};
use std::path::Path;

use toml::de::DeTable;

use super::chosen::ChosenPart;
use super::key::Key;
use super::print::print_chosen;
use super::problem::{Problem, Source};
use super::reader::{Reader, Section};
use super::tree::{Origin, Table};
use archard::body::mesh::{ContactMesh, MESHES, Shape, SupportedSurfaces};

type Mesh = ChosenPart<Box<dyn Shape>>;

struct Printed<'a>(&'a Mesh);

impl Display for Printed<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        print_chosen(f, "mesh", self.0)
    }
}

fn folder() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../archard/tests/meshes")
}

/// What reading and meshing a text gives, under quarter symmetry, or the problems with the text they
/// point at.
fn read(text: &str) -> Result<(Mesh, ContactMesh), Vec<(Problem, String)>> {
    let parsed = DeTable::parse(text).unwrap();
    let origin = Origin { source: Source::File, start: 0, fixed: None };
    let table = Table::from_toml(parsed.get_ref(), &origin);
    let folder = folder();
    let mut reader = Reader {
        folder: &folder,
        problems: vec![],
        bodies: vec![],
        line: None,
        cell: None,
        framed: false,
    };
    let root = Section { key: Key::default(), table: &table };
    let read = reader.table(&root, "mesh", "a mesh").and_then(|section| {
        let (chosen, shape) = reader.choice(&section, "mesh", MESHES)?;
        match shape.mesh([true, true], &SupportedSurfaces::default()) {
            Ok(meshed) => Some((chosen, meshed)),
            Err(error) => {
                let inside = reader.table(&section, chosen.choice.name, "")?;
                reader.invalid(&inside, error.into());
                None
            }
        }
    });
    let located = |problem: Problem| {
        let at = table.locate(&problem.key, problem.target).map(|at| text[at.span].to_owned());
        (problem, at.unwrap_or_default())
    };
    match read {
        Some(read) if reader.problems.is_empty() => Ok(read),
        _ => Err(reader.problems.into_iter().map(located).collect()),
    }
}

/// Reads what a text prints as once more: the same values, the same mesh.
#[track_caller]
fn prints_back(text: &str) -> (Mesh, ContactMesh) {
    let (chosen, meshed) = read(text).unwrap();
    let printed = Printed(&chosen).to_string();
    let (again, meshed_again) = read(&printed).unwrap();
    assert_eq!(Printed(&again).to_string(), printed);
    assert!(meshed_again == meshed, "{printed}");
    (chosen, meshed)
}

#[test]
fn a_box_reads_and_prints() {
    let (chosen, meshed) = prints_back(
        r#"
        [mesh.box]
        size = ["1 m", "100 cm", "1000 mm"]
        contact = { face = "top", size = ["0.2 m", "200 mm"], elements = [20, 20] }
        "#,
    );
    assert_eq!(meshed.zone.grid, Some([10, 10]));
    let expected = r#"mesh.box.size = ["1 m", "1 m", "1 m"]
mesh.box.contact.face = "top"
mesh.box.contact.size = ["0.2 m", "0.2 m"]
mesh.box.contact.elements = [20, 20]
"#;
    assert_eq!(Printed(&chosen).to_string(), expected);
}

#[test]
fn the_other_meshes_read_and_print() {
    for text in [
        r#"mesh.box = { size = ["1 m", "1 m", "1 m"], divisions = 4 }"#,
        r#"mesh.box = { size = ["1 m", "1 m", "1 m"], divisions = [4, 2, 3] }"#,
        r#"mesh.box = { size = ["1 m", "1 m", "1 m"] }"#,
        r#"mesh.cylinder = { radius = "50 mm", length = "20 mm" }"#,
        r#"mesh.sphere = { radius = "50 mm", contact = { size = ["4 mm", "2 mm"], elements = [8, 4], growth = 1.5 } }"#,
        r#"mesh.sphere = { radius = "50 mm", inner = "30 mm", divisions = 4 }"#,
        r#"mesh.cylinder = { radius = "50 mm", length = "20 mm", bore = "10 mm", contact = { face = "side", size = ["4 mm", "2 mm"], elements = [8, 4] } }"#,
        r#"mesh.cylinder = { radius = "50 mm", length = "20 mm", contact = { face = "top", size = ["4 mm", "2 mm"], elements = [8, 4] } }"#,
        r#"mesh.file = { path = "block_4.1_binary.msh", contact = "top", unit = "mm" }"#,
        r#"mesh.file = { path = "block_text.stl" }"#,
    ] {
        prints_back(text);
    }
}

/// The only problem of a text: where it points, its key and a part of what it says.
#[track_caller]
fn refused(text: &str, at: &str, key: &str, said: &str) {
    let problems = read(text).unwrap_err();
    let [(problem, found)] = &problems[..] else { panic!("{problems:?}") };
    assert_eq!((found.as_str(), problem.key.to_string().as_str()), (at, key), "{problem:?}");
    let help = problem.help.clone().unwrap_or_default();
    assert!(format!("{}\n{help}", problem.message).contains(said), "{problem:?}");
}

#[test]
fn mistakes_are_said_where_they_stand_inside_the_table() {
    let cuboid = |contact: &str| {
        format!(r#"mesh.box = {{ size = ["1 m", "1 m", "1 m"], contact = {{ {contact} }} }}"#)
    };
    let size = r#"size = ["0.2 m", "0.2 m"]"#;
    let inside = |contact: &str, at: &str, key: &str, said: &str| {
        refused(&cuboid(contact), at, &format!("mesh.box.contact{key}"), said);
    };
    inside(
        &format!("{size}, elements = [20, 7]"),
        "[20, 7]",
        ".elements",
        "7 elements along y: the plane of symmetry y = 0 halves them",
    );
    inside(&format!("{size}, elements = [20, 7.5]"), "[20, 7.5]", ".elements", "whole number");
    inside(&format!("{size}, elements = [2, 0]"), "[2, 0]", ".elements", "greater than zero");
    inside(
        &format!("{size}, elements = [20000, 20000]"),
        "[20000, 20000]",
        ".elements",
        "more than 1000000 elements",
    );
    inside(size, "contact", ".elements", "is missing: numbers of elements");
    inside(
        r#"size = ["2 m", "0.2 m"], elements = [2, 2]"#,
        r#"["2 m", "0.2 m"]"#,
        ".size",
        "the body has room for 1 m",
    );
    inside(
        &format!(r#"{size}, elements = [2, 2], face = "side""#),
        r#""side""#,
        ".face",
        "expected \"top\"",
    );
    inside(&format!("{size}, elements = [2, 2], growht = 2.0"), "growht", ".growht", "`growth`?");
    inside(&format!("{size}, elements = [2, 2], growth = 1.0"), "1.0", ".growth", "between 1.05");
}

#[test]
fn mistakes_of_the_body_are_said() {
    refused(
        r#"mesh.box = { size = ["1 m", "1 m"], divisions = 2 }"#,
        r#"["1 m", "1 m"]"#,
        "mesh.box.size",
        "expected three values, along x, y and z",
    );
    refused(
        r#"mesh.box = { size = ["1 m", "1 m", "1 m"], divisions = [2, 2] }"#,
        "[2, 2]",
        "mesh.box.divisions",
        "expected three values, along x, y and z",
    );
    refused(
        r#"mesh.box = { size = ["1 m", "1 m", "1 m"], divisions = [2, 2, 401] }"#,
        "[2, 2, 401]",
        "mesh.box.divisions",
        "400 at most",
    );
    refused(
        r#"mesh.box = { size = ["1 m", "1 m", "1 m"], contact = 3 }"#,
        "3",
        "mesh.box.contact",
        "expected a table",
    );
    refused(
        r#"mesh.sphere = { radius = "1 m", inner = "1 m", divisions = 4 }"#,
        "\"1 m\"",
        "mesh.sphere.inner",
        "less than the radius",
    );
    refused(
        r#"mesh.sphere = { radius = "1 m", divisions = 3 }"#,
        "3",
        "mesh.sphere.divisions",
        "even",
    );
    let contact = r#"contact = { face = "top", size = ["1 mm", "1 mm"], elements = [2, 2] }"#;
    refused(
        &format!(
            r#"mesh.cylinder = {{ radius = "9 mm", length = "9 mm", bore = "1 mm", {contact} }}"#
        ),
        "\"top\"",
        "mesh.cylinder.contact.face",
        "no material in the middle",
    );
    refused(
        &format!(r#"mesh.cylinder = {{ radius = "0.7 mm", length = "9 mm", {contact} }}"#),
        r#"["1 mm", "1 mm"]"#,
        "mesh.cylinder.contact.size",
        "too close to the edge",
    );
}

#[test]
fn mistakes_of_files_are_said() {
    let file = |rest: &str| format!("mesh.file = {{ {rest} }}");
    refused(&file("path = 3"), "3", "mesh.file.path", "expected the name of a file");
    refused(&file(r#"path = "no.msh""#), "\"no.msh\"", "mesh.file.path", "folder of the case");
    refused(&file(r#"path = "make""#), "\"make\"", "mesh.file.path", "make, line 1: is neither");
    refused(
        &file(r#"path = "second_order.msh""#),
        "\"second_order.msh\"",
        "mesh.file.path",
        "Mesh.ElementOrder = 1",
    );
    let block = r#"path = "block_2.2_text.msh""#;
    refused(
        &file(&format!(r#"{block}, contact = "up""#)),
        "\"up\"",
        "mesh.file.contact",
        "no surface `up`; it has `",
    );
    refused(&file(&format!("{block}, contact = 3")), "3", "mesh.file.contact", "a name in quotes");
    refused(&file(&format!(r#"{block}, unit = "ft""#)), "\"ft\"", "mesh.file.unit", "\"mm\"");
}
