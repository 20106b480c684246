//! Bodies as CAD programs write them: an STL of one solid, told apart by its edges, the contact by a place.

use std::fmt::Write;
use std::path::Path;

use approx::assert_relative_eq;
use archard_case::{CaseFile, Problem, Severity};

use crate::common::Rows;

/// A pin of 5 mm radius and 8 mm length about z with a spherical end of 20 mm radius at z = 0 below, in mm, turned inside
/// out if asked for.
fn pin(inside_out: bool) -> String {
    let end = |step: usize| {
        let angle = f64::asin(5.0 / 20.0) * step as f64 / 6.0;
        [20.0 * angle.sin(), 20.0 - 20.0 * angle.cos()]
    };
    let mut profile: Vec<[f64; 2]> = (0..=6).map(end).collect();
    profile.extend([[5.0, 8.0], [0.0, 8.0]]);
    let strips = 24;
    let at = |[radius, height]: [f64; 2], strip: usize| {
        let angle = std::f64::consts::TAU * (strip % strips) as f64 / strips as f64;
        [radius * angle.cos(), radius * angle.sin(), height]
    };
    let mut text = "solid pin\n".to_owned();
    for ends in profile.windows(2) {
        for strip in 0..strips {
            let [a, b] = [at(ends[0], strip), at(ends[0], strip + 1)];
            let [c, d] = [at(ends[1], strip + 1), at(ends[1], strip)];
            for [mut one, mut other, last] in [[a, b, c], [a, c, d]] {
                if one == other || other == last || last == one {
                    continue;
                }
                if inside_out {
                    std::mem::swap(&mut one, &mut other);
                }
                text += "facet normal 0 0 0\nouter loop\n";
                for [x, y, z] in [one, other, last] {
                    writeln!(text, "vertex {x:e} {y:e} {z:e}").unwrap();
                }
                text += "endloop\nendfacet\n";
            }
        }
    }
    text + "endsolid\n"
}

/// The pin pressed on a rigid plane below it.
fn case(contact: &str) -> String {
    format!(
        r#"
[body.plane]
rigid = true
profile.flat = {{}}
[body.pin]
material = {{ young = "210 GPa", poisson = 0.3 }}
mesh.file = {{ path = "pin.stl", unit = "mm", contact = {contact} }}
supports = {{ face_3 = "clamped" }}
boundary_elements = {{ interpolation = "continuous", tolerance = 1e-4 }}
[motion.indentation]
load = "100 N"
increments = 1
"#
    )
}

const NEAR: &str = r#"{ near = ["0 mm", "0 mm", "0 mm"], size = "1.4 mm", elements = 14 }"#;

fn read(contact: &str, inside_out: bool) -> (tempfile::TempDir, CaseFile) {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("pin.stl"), pin(inside_out)).unwrap();
    let file = CaseFile::from_text("case.toml", case(contact), Path::new(dir.path()));
    (dir, file)
}

/// Hertz: a = (3 F R / 4 E*)^(1/3) and p0 = 3 F / 2 pi a^2. Facets of the file turn by some degrees; a zone of facets would
/// press on a corner.
#[test]
#[ignore = "long: in .ci/long"]
fn a_pin_from_a_file_is_pressed_as_hertz_says() {
    let modulus = 210e9 / (1.0 - 0.09);
    let radius = f64::cbrt(0.75 * 100.0 * 0.02 / modulus);
    let peak = 1.5 * 100.0 / (std::f64::consts::PI * radius * radius);
    for inside_out in [false, true] {
        let (_dir, file) = read(NEAR, inside_out);
        let resolved = crate::resolve(&file);
        assert!(resolved.warnings.is_empty(), "{:?}", resolved.warnings);
        let contact = resolved.forecast.estimate.contact.expect("a round zone");
        assert_relative_eq!(contact.semi_axes[0], radius, max_relative = 0.02);
        let said = resolved.forecast.to_string();
        assert!(said.contains("on `face_1`, 10 x 10 x 0.64 mm around (0, 0, 0.32) mm"), "{said}");
        let mut rows = Rows::default();
        resolved.case.build().unwrap().run(&mut [&mut rows]).unwrap();
        // The area is that of whole pairs.
        assert_relative_eq!(rows.last("peak_pressure_Pa"), peak, max_relative = 0.04);
        let area = std::f64::consts::PI * radius * radius;
        assert_relative_eq!(rows.last("contact_area_m2"), area, max_relative = 0.12);
        // The resolved case finds the file from anywhere.
        let text = resolved.case.to_string();
        let again = CaseFile::from_text("case.toml", &*text, "/nowhere");
        assert_eq!(crate::resolve(&again).case.to_string(), text);
    }
}

fn problems(contact: &str) -> Vec<Problem> {
    match read(contact, false).1.task() {
        Ok(task) => task.warnings().to_vec(),
        Err(problems) => problems,
    }
}

#[track_caller]
fn said(contact: &str, severity: Severity, key: &str, message: &str) {
    let found = problems(contact);
    let [problem] = &found[..] else { panic!("{found:?}") };
    assert_eq!((problem.severity, &*problem.key.to_string()), (severity, key), "{problem:?}");
    let help = problem.help.clone().unwrap_or_default();
    assert!(format!("{}\n{help}", problem.message).contains(message), "{problem:?}");
}

#[test]
fn zones_that_do_not_serve_are_said() {
    let zone = |size: &str, elements: usize| {
        format!(r#"{{ near = ["0 mm", "0 mm", "0 mm"], size = "{size}", elements = {elements} }}"#)
    };
    let key = |name: &str| format!("body.pin.mesh.file.contact{name}");
    said(&zone("1.4 mm", 5), Severity::Warning, &key(".elements"), "pairs lie across the contact");
    said(&zone("0.3 mm", 12), Severity::Error, &key(".size"), "is smaller than the contact");
    said(
        &zone("1.4 m", 9999999),
        Severity::Error,
        &key(".elements"),
        "take fewer, or a smaller box",
    );
    let far = r#"{ near = ["0 m", "0 m", "1 m"], size = "2 mm" }"#;
    said(far, Severity::Error, &key(".near"), "the body reaches from");
    said(r#"{ size = "2 mm" }"#, Severity::Error, &key(".near"), "is missing");
    said(r#""face_9""#, Severity::Error, &key(""), "it has `face_1`, `face_2`, `face_3`");
}
