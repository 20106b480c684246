//! The right side of the Manchester benchmark against the field's reference program, at eight shifts of the wheelset, if
//! `ARCHARD_WHEEL_RAIL` names the folder with its profiles and results.

mod common;

use archard_rail::creepage::Creepage;
use archard_rail::search::{JOIN, Search};
use archard_rail::setup::Setup;
use common::Row;

/// The distance of a value from the reference, held against what is allowed.
struct Difference {
    name: &'static str,
    off: f64,
    most: f64,
}

/// A difference of at most one in a thousand, or one in the last of four digits.
fn relative(name: &'static str, value: f64, reference: f64) -> Difference {
    let last =
        if reference == 0.0 { 1e-9 } else { 10f64.powf(reference.abs().log10().floor() - 3.0) };
    Difference { name, off: value - reference, most: (reference.abs() * 1e-3).max(last) }
}

/// What is allowed is one digit of the table (0.0001 mm) for the onset, and 0.002 mm for the places: at the shift 0 the patch is
/// 18 mm wide, and its middle 0.001 mm off.
fn differences(setup: &Setup, row: &Row) -> Vec<Difference> {
    let search = Search::new(setup, row.attitude()).unwrap();
    let onset = search.onset().unwrap().height * 1e3;
    let patches = search.patches(row.get("Z_WS") * 1e-3, JOIN).unwrap();
    let [patch] = &patches[..] else { panic!("{} patches", patches.len()) };
    let creepage = Creepage::new(&search, patch, &row.velocity(), row.get("APPROACH") * 1e-3);
    let length = |name, value: f64, column: &str, most| Difference {
        name,
        off: value - row.get(column),
        most,
    };
    let point = patch.reference * 1e3;
    let wheel = search.in_wheel(patch.reference, patch.height) * 1e3;
    let rail = setup.placing().in_rail(patch.reference) * 1e3;
    vec![
        length("onset", onset, "Z_ONSET", 1e-4),
        length("x", point.x, "XCP(TR)", 2e-3),
        length("y", point.y, "YCP(TR)", 2e-3),
        length("z", point.z, "ZCP(TR)", 2e-3),
        length("y on rail", rail.y, "YCP(R)", 2e-3),
        length("z on rail", rail.z, "ZCP(R)", 2e-3),
        length("x on wheel", wheel.x, "XCP(W)", 2e-3),
        length("y on wheel", wheel.y, "YCP(W)", 2e-3),
        length("z on wheel", wheel.z, "ZCP(W)", 2e-3),
        length("angle", patch.angle, "DELTCP(TR)", 1e-4),
        relative("xi", creepage.longitudinal, row.get("CKSI")),
        relative("eta", creepage.lateral, row.get("CETA")),
        relative("phi", creepage.spin * 1e-3, row.get("CPHI")),
        relative("speed", creepage.speed * 1e3, row.get("VELOC")),
    ]
}

#[test]
fn eight_shifts_agree() {
    let Some(folder) = common::folder() else { return };
    let setup = common::setup(&folder);
    let rows = common::rows(&folder);
    assert_eq!(rows.len(), 8);
    let mut wrong = vec![];
    for row in &rows {
        eprint!("y = {} mm:", row.get("Y_WS"));
        for Difference { name, off, most } in differences(&setup, row) {
            eprint!(" {name} {off:+.2e};");
            if off.is_nan() || off.abs() > most {
                wrong.push(format!("y = {}: {name} off by {off:.3e}", row.get("Y_WS")));
            }
        }
        eprintln!();
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
