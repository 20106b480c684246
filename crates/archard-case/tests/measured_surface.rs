//! Bodies with the surface of an instrument's file: pressed like the shape that it holds, printed, refused with a place.

mod common;

use std::fs;
use std::path::Path;

use archard_case::{CaseFile, Task};
use common::Rows;
use tempfile::tempdir;

const RADIUS: f64 = 50e-3;
/// Points along an axis and their distance (um).
const POINTS: usize = 61;
const PIXEL: f64 = 20.0;

/// A ball as a matrix of heights (um) in a text, tilted and with holes next to the contact if asked for.
fn ball(tilt: f64, holes: bool) -> String {
    let place = |at: usize| (at as f64 - 0.5 * (POINTS - 1) as f64) * PIXEL;
    let height = |x: usize, y: usize| {
        let square = place(x).powi(2) + place(y).powi(2);
        // Missing far from the middle, where nothing touches.
        if holes && x < 4 && y.is_multiple_of(7) {
            return "nan".to_owned();
        }
        format!("{:.9}", -square / (2e6 * RADIUS) + tilt * place(x))
    };
    let row = |y: usize| (0..POINTS).map(|x| height(x, y)).collect::<Vec<_>>().join(" ");
    (0..POINTS).map(row).collect::<Vec<_>>().join("\n")
}

fn case(profile: &str) -> String {
    format!(
        "frame.size = [\"0.6 mm\", \"0.6 mm\"]\nframe.elements = [30, 30]\n\
         body.flat.material = {{ young = \"210 GPa\", poisson = 0.3 }}\nbody.flat.profile.flat = {{}}\n\
         body.ball.material = {{ young = \"210 GPa\", poisson = 0.3 }}\n{profile}\n\
         motion.indentation = {{ load = \"10 N\", increments = 1 }}\n"
    )
}

fn resolved(folder: &Path, text: &str) -> Result<Box<archard_case::RunnableCase>, String> {
    let file = CaseFile::from_text("case.toml", text, folder);
    match file.task() {
        Ok(Task::Contact(resolved)) => Ok(resolved),
        Ok(_) => Err("another case".to_owned()),
        Err(problems) => {
            Err(problems.iter().map(|one| file.describe(one)).collect::<Vec<_>>().join("\n"))
        }
    }
}

fn peak(folder: &Path, profile: &str) -> f64 {
    let case = resolved(folder, &case(profile)).unwrap().case;
    let mut rows = Rows::default();
    case.build().unwrap().run(&mut [&mut rows]).unwrap();
    let last = rows.0.last().unwrap();
    last.iter().find(|(name, _)| name == "peak_pressure_Pa").unwrap().1
}

#[test]
fn a_measured_ball_is_pressed_like_a_ball() {
    let dir = tempdir().unwrap();
    let write = |name: &str, text: String| fs::write(dir.path().join(name), text).unwrap();
    write("ball.txt", ball(0.0, false));
    write("tilted.txt", ball(0.01, true));
    let file = |name: &str, more: &str| {
        format!(
            "body.ball.profile.surface = {{ file = \"{name}\", pixel = \"20 um\", unit = \"um\"{more} }}"
        )
    };
    let sphere = peak(dir.path(), "body.ball.profile.sphere.radius = \"50 mm\"");
    let measured = peak(dir.path(), &file("ball.txt", ""));
    assert!((measured / sphere - 1.0).abs() < 1e-3, "{measured} {sphere}");
    // A plane is taken off what was measured: the ball loses its tilt and keeps its curvature.
    let levelled = peak(dir.path(), &file("tilted.txt", ", level = \"plane\", holes = \"fill\""));
    assert!((levelled / sphere - 1.0).abs() < 5e-3, "{levelled} {sphere}");
    // A case prints with the whole name of the file, and reads back from anywhere.
    let first = resolved(dir.path(), &case(&file("ball.txt", ", flipped = true"))).unwrap().case;
    let again = resolved(Path::new(""), &first.to_string()).unwrap().case;
    assert!(first.to_string() == again.to_string());
}

/// The steps of a preparation and what is left, of a ball of known tilt with a wave of known cutoff and one spike.
#[test]
fn preparations_are_done_in_order_and_said() {
    let dir = tempdir().unwrap();
    let mut rows: Vec<Vec<String>> =
        ball(0.01, true).lines().map(|row| row.split(' ').map(str::to_owned).collect()).collect();
    // Noise of 1 nm, by which a spike of 3 um stands out: a sequence of van der Corput along each axis.
    for (y, row) in rows.iter_mut().enumerate() {
        for (x, height) in row.iter_mut().enumerate() {
            let noise = (x as f64 * 0.618 + y as f64 * 0.7549).fract() - 0.5;
            let spike = if [x, y] == [20, 33] { 3.0 } else { 0.0 };
            *height = format!("{:.9}", height.parse::<f64>().unwrap() + 0.001 * noise + spike);
        }
    }
    let text: Vec<String> = rows.iter().map(|row| row.join(" ")).collect();
    fs::write(dir.path().join("ball.txt"), text.join("\n")).unwrap();
    let prepared = |keys: &str| {
        let text = format!(
            "profile.surface = {{ file = \"ball.txt\", unit = \"um\", pixel = \"20 um\", {keys} }}"
        );
        let file = CaseFile::from_text("case.toml", text, dir.path());
        file.prepared_surface().map_err(|problems| file.describe(&problems[0]))
    };
    let all = prepared(
        "holes = \"fill\", spacing = \"40 um\", rough = \"1 mm\", smooth = \"50 um\", form = \"sphere\", outliers = \"remove\", \
         inverted = false",
    )
    .unwrap();
    let keys: Vec<&str> = all.steps.iter().map(|step| step.key).collect();
    assert_eq!(keys, ["outliers", "form", "smooth", "rough", "spacing", "holes"]);
    assert_eq!((all.map.elements(), all.map.pixel(), all.map.missing()), ([30, 30], [40e-6; 2], 0));
    let said = |index: usize| all.steps[index].said.as_str();
    assert!(said(0).starts_with("1 points off"), "{}", said(0));
    // A ball of 50 mm as the paraboloid that the file holds, tilted by 1e-2: R (1 + slope^2)^(3/2).
    assert!(said(1).starts_with("convex sphere off, radius 50.0"), "{}", said(1));
    assert!(said(2).starts_with("waves shorter than 50.00 um off"), "{}", said(2));
    assert!(said(4).contains("of that slope"), "{}", said(4));
    assert!(said(5).ends_with("points filled"), "{}", said(5));
    // Nothing is left but noise.
    assert!(all.map.heights().iter().all(|height| height.abs() < 2e-9));
    let tilt = prepared("level = \"plane\"").unwrap();
    // 10 mrad; the holes on one side of the ball leave a plane a hundredth less.
    let words = tilt.steps[0].said.split("tilt ").nth(1).unwrap();
    let slope: f64 = words.split(' ').next().unwrap().parse().unwrap();
    assert!((slope - 10.0).abs() < 0.2, "{:?}", tilt.steps);
    for (keys, place, words) in [
        ("form = \"sphere\", level = \"plane\"", "profile.surface.level", "leave `level` out"),
        ("radius = \"5 mm\"", "profile.surface.radius", "give `form"),
        ("form = \"sphere\", radius = \"0.5 mm\"", "profile.surface.radius", "too small"),
        ("smooth = \"80 um\", rough = \"80 um\"", "profile.surface.smooth", "longer `rough`"),
        ("smooth = \"30 um\"", "profile.surface.smooth", "shorter than two pixels"),
        ("rough = \"5 mm\"", "profile.surface.rough", "longer than the shorter side"),
        ("spacing = \"10 um\"", "profile.surface.spacing", "closer than those of the map"),
        ("level = \"sextic\"", "profile.surface.level", "quintic"),
    ] {
        let said = prepared(keys).err().unwrap_or_else(|| panic!("{keys} passes"));
        assert!(said.contains(place) && said.contains(words), "{keys}: {said}");
    }
}

#[test]
fn wrong_files_are_refused_in_words() {
    let dir = tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(dir.path().join(name), text).unwrap();
    write("ball.txt", &ball(0.0, true));
    write("row.txt", "1 2 3\n");
    write("wrong.txt", "1 2\n3 x\n");
    write("scan.sur", "no surface at all");
    write("scan.xyz", "1 2\n3 4\n");
    // A surface of 5 x 4 points in pixels of 2 x 3 um, one of them not measured.
    let files = Path::new(env!("CARGO_MANIFEST_DIR")).join("../archard-surface/tests/files");
    for (from, to) in
        [("x3pio.x3p", "scan.x3p"), ("gwyfile.gwy", "scan.gwy"), ("gwyfile.gwy", "scan.sdf")]
    {
        fs::copy(files.join(from), dir.path().join(to)).unwrap();
    }
    for (keys, expected) in [
        ("file = \"ball.txt\", pixel = \"20 um\"", "give it"),
        ("file = \"ball.txt\", unit = \"um\"", "`pixel`"),
        ("file = \"ball.txt\", unit = \"um\", pixel_y = \"2 um\"", "`pixel`"),
        (
            "file = \"ball.txt\", unit = \"um\", pixel = \"20 um\"",
            "36 of 3721 points have no height",
        ),
        ("file = \"ball.txt\", unit = \"cm\", pixel = \"20 um\"", "unit"),
        ("file = \"row.txt\", unit = \"um\", pixel = \"20 um\"", "3 x 1 points"),
        ("file = \"wrong.txt\", unit = \"um\", pixel = \"20 um\"", "line 2: `x`"),
        ("file = \"scan.sur\"", "is no Digital Surf"),
        ("file = \"scan.xyz\"", "no known ending"),
        ("file = \"scan.x3p\"", "1 of 20 points have no height"),
        ("file = \"scan.gwy\"", "1 of 20 points have no height"),
        ("file = \"scan.sdf\"", "it is Gwyddion (.gwy)"),
        ("file = \"scan.gwy\", unit = \"um\"", "leave `unit` out"),
        // Slopes of the ball, 0.01, become 1e4 and 10; pixels of a picometre do the same.
        ("file = \"ball.txt\", unit = \"m\", pixel = \"20 um\"", "`unit = \"um\"`?"),
        ("file = \"ball.txt\", unit = \"um\", pixel = \"2 pm\"", "larger, would be plausible"),
        ("file = \"scan.x3p\", pixel = \"2 pm\"", "larger, would be plausible"),
        ("file = \"none.sur\"", "none.sur"),
        ("pixel = \"20 um\"", "`body.ball.profile.surface.file`"),
    ] {
        let said =
            resolved(dir.path(), &case(&format!("body.ball.profile.surface = {{ {keys} }}")));
        let said = said.err().unwrap_or_else(|| panic!("{keys} passes"));
        assert!(said.contains(expected), "{keys}: {said}");
    }
}
