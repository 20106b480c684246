//! Pictures of runs on pairs that are no uniform grid.

use std::path::Path;

use archard::frame::{ContactFrame, Pairs};
use archard::problem::ContactState;
use archard_case::output::Surface;
use tempfile::tempdir;

use super::{drawn, problem, state, write};

/// Elements of a quarter along a side of 0.6 mm, narrow ones first.
const SIDE: usize = 20;

/// A quarter of the frame of the sphere: rectangles, or each cut into two triangles.
fn quarter(triangles: bool) -> ContactFrame {
    let edge = |index: usize| 0.6e-3 * (index as f64 / SIDE as f64).powf(1.3);
    let mut pairs = Pairs { mirrored: [true; 2], ..Pairs::default() };
    for cell in 0..SIDE * SIDE {
        let ([x0, x1], [y0, y1]) =
            ([cell % SIDE, cell % SIDE + 1].map(edge), [cell / SIDE, cell / SIDE + 1].map(edge));
        let corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(|[x, y]| [x, y, 0.0]);
        let parts: &[&[usize]] =
            if triangles { &[&[0, 1, 2], &[0, 2, 3]] } else { &[&[0, 1, 2, 3]] };
        for part in parts {
            let outline: Vec<[f64; 3]> = part.iter().map(|&corner| corners[corner]).collect();
            let middle = [0, 1, 2].map(|axis| {
                outline.iter().map(|corner| corner[axis]).sum::<f64>() / outline.len() as f64
            });
            pairs.areas.push(4.0 * (x1 - x0) * (y1 - y0) / parts.len() as f64);
            pairs.gap.push((middle[0].powi(2) + middle[1].powi(2)) / 0.1);
            pairs.places.push(middle);
            pairs.outlines.push(outline);
        }
    }
    pairs.elements = (!triangles).then_some([SIDE; 2]);
    ContactFrame::described(pairs).unwrap()
}

fn slide(dir: &Path, triangles: bool) {
    let numbers = [("load", 10.2), ("distance", 0.5), ("step", 5e-3)];
    let mut problem = problem([1.33e-13, 0.0], "sliding", &numbers);
    problem.frame = quarter(triangles);
    let places = (0..=10).map(|step| 0.05 * f64::from(step));
    let of = |s: f64| state(&problem, 10.2, 10.2 * 1.33e-13 * s, [1.0, 0.0]);
    let states: Vec<_> = places.map(|s| ContactState { progress: s, ..of(s) }).collect();
    write(dir, "", &problem, &states, true);
}

/// All pictures are there, and the map shows all four quarters.
#[test]
#[ignore = "long: in .ci/long"]
fn quarters_are_drawn_whole() {
    for triangles in [false, true] {
        let dir = tempdir().unwrap();
        slide(dir.path(), triangles);
        assert_eq!(drawn(dir.path()).len(), 8);
        let image = Surface::read(&dir.path().join("fields/0005.vtu")).unwrap().image();
        let load: f64 = image.field("pressure_Pa").unwrap().iter().sum::<f64>()
            * image.spacing.iter().product::<f64>();
        // Elements that show the edge of the contact are counted in full.
        assert!((load / 10.2 - 1.0).abs() < 0.02, "{load}");
    }
}
