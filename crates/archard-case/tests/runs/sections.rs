//! Sections of results go through the contact, wherever it lies.

use std::collections::BTreeMap;

use approx::assert_relative_eq;
use archard::body::profile::{Flat, Profile};
use archard::body::{Body, Material};
use archard::motion::{Control, Sliding, Stepping};
use archard::simulation::Simulation;
use archard::wear::Archard;
use archard_case::output::{ResultFolder, Totals};

/// A paraboloid of 50 mm with its apex next to the centre.
#[derive(Debug)]
struct Beside([f64; 2]);

impl Profile for Beside {
    fn recess(&self, x: f64, y: f64) -> f64 {
        ((x - self.0[0]).powi(2) + (y - self.0[1]).powi(2)) / (2.0 * 50e-3)
    }
}

/// Side (m) of an element.
const ELEMENT: f64 = 1.2e-3 / 41.0;

/// Pressure and depth along each axis at the end, by the number of the element from the apex.
fn sections(apex: [f64; 2]) -> BTreeMap<(String, i64), [f64; 2]> {
    let steel = Material::new(210e9, 0.3).unwrap();
    let pin = Body::new("pin", Beside(apex)).material(steel).wear(Archard::new(1.33e-13).unwrap());
    let disc = Body::new("disc", Flat).material(steel);
    let sliding = Sliding::new().over(0.05, Control::Load(10.2), Stepping::Implicit(5e-3)).unwrap();
    let simulation = Simulation::builder([pin, disc], sliding).frame([1.2e-3; 2], [41; 2]);
    let folder = tempfile::tempdir().unwrap();
    let mut results = ResultFolder::create(folder.path(), "").unwrap();
    simulation.build().unwrap().run(&mut [&mut results]).unwrap();
    results.finish(&Totals::default()).unwrap();
    let mut table = csv::Reader::from_path(folder.path().join("profiles.csv")).unwrap();
    let header = table.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|known| known == name).unwrap();
    let [axis, place] = ["axis", "coordinate_m"].map(column);
    let fields = ["pressure_Pa", "wear_pin_m"].map(column);
    let mut sections = BTreeMap::new();
    for row in table.records().map(Result::unwrap) {
        let number = |cell: usize| row[cell].parse::<f64>().unwrap();
        let from = number(place) - apex[usize::from(&row[axis] == "y")];
        let element = (from / ELEMENT).round() as i64;
        // Later outputs replace earlier ones.
        sections.insert((row[axis].to_owned(), element), fields.map(number));
    }
    sections
}

/// A half-space is the same everywhere: the sections of a contact next to the middle are those of one in the middle.
#[test]
fn a_contact_beside_the_middle_is_cut_through_its_middle() {
    let middle = sections([0.0; 2]);
    let beside = sections([6.0 * ELEMENT, -4.0 * ELEMENT]);
    let [peak, depth] = middle[&("x".to_owned(), 0)];
    for axis in ["x", "y"] {
        for element in -12..=12 {
            let key = (axis.to_owned(), element);
            let ([pressure, worn], [pressed, scar]) = (beside[&key], middle[&key]);
            assert_relative_eq!(pressure, pressed, epsilon = 1e-6 * peak);
            assert_relative_eq!(worn, scar, epsilon = 1e-6 * depth);
        }
    }
    assert!(peak > 0.0 && depth > 0.0);
}
