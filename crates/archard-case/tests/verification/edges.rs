//! The edge of the contact between elements, against closed forms on grids wherever they lie.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use archard::closed_form::Hertz;
use archard::simulation::Simulation;

use crate::common::{case, states};

/// Contact modulus (Pa) of two steels.
const MODULUS: f64 = 210e9 / (2.0 * 0.91);
/// Half width (m) of a line of contact.
const HALF_WIDTH: f64 = 0.2e-3;

const STEELS: &str = r#"
    body.pin.material = { young = "210 GPa", poisson = 0.3 }
    body.disc.material = { young = "210 GPa", poisson = 0.3 }
    body.disc.profile.flat = {}
"#;

/// Where a grid lies, in elements: spread evenly, along y otherwise than along x.
fn offsets(count: u32) -> impl Iterator<Item = [f64; 2]> {
    (0..count).map(|index| [0.618, 0.414].map(|share| (f64::from(index) * share + 0.1).fract()))
}

/// Bodies in a frame of elements of a size (m), moved by a part of an element.
fn on_grid(body: &str, (size, elements): ([f64; 2], [usize; 2]), offset: [f64; 2]) -> Simulation {
    let [x, y] = [0, 1].map(|axis| size[axis] * elements[axis] as f64);
    let [u, v] = [0, 1].map(|axis| size[axis] * offset[axis]);
    let frame = format!(
        "frame = {{ size = [\"{x} m\", \"{y} m\"], centre = [\"{u} m\", \"{v} m\"], elements = {elements:?} }}"
    );
    case(&format!("{STEELS}{body}\n{frame}"), &[])
}

/// The contact area (m^2) at the end of a run.
fn area(simulation: &Simulation) -> f64 {
    let (state, ..) = states(simulation).unwrap().pop().unwrap();
    state.contact_area(&simulation.problem)
}

/// Largest relative error of the areas in contact on grids that lie anywhere.
fn worst(count: u32, truth: f64, simulation: impl Fn([f64; 2]) -> Simulation) -> f64 {
    let error = |offset: [f64; 2]| (area(&simulation(offset)) / truth - 1.0).abs();
    offsets(count).map(error).fold(0.0, f64::max)
}

/// Spheres and ellipses, wherever the grid lies.
#[test]
fn areas_of_hertz_are_of_second_order() {
    let sphere = [1e-2, 5e-3, 1.5e-3, 6e-4].map(|bound| 0.5 * bound);
    let ellipse = [1e-2, 5e-3, 1.5e-3, 6e-4];
    for (radii, bounds) in [([50e-3, 50e-3], sphere), ([50e-3, 5e-3], ellipse)] {
        let hertz = Hertz::from_load(radii.map(f64::recip), MODULUS, 10.2).unwrap();
        let [a, b] = hertz.semi_axes;
        let body = format!(
            "body.pin.profile.paraboloid = {{ radius_x = \"{} m\", radius_y = \"{} m\" }}\n\
             motion.indentation.load = \"10.2 N\"",
            radii[0], radii[1]
        );
        for (across, bound) in [12.0, 16.0, 24.0, 40.0].into_iter().zip(bounds) {
            let element = 2.0 * a.min(b) / across;
            let elements = [a, b].map(|axis| (2.0 * axis / element) as usize + 7);
            let found =
                worst(8, PI * a * b, |offset| on_grid(&body, ([element; 2], elements), offset));
            assert!(found < bound, "{radii:?}, {across} across: {found}");
        }
    }
}

/// Elements half as long again along x.
#[test]
fn elements_may_be_longer_along_an_axis() {
    let hertz = Hertz::from_load([20.0; 2], MODULUS, 10.2).unwrap();
    let [a, b] = hertz.semi_axes;
    let body = "body.pin.profile.sphere.radius = \"50 mm\"\nmotion.indentation.load = \"10.2 N\"";
    let element = 2.0 * b / 24.0;
    let found =
        worst(8, PI * a * b, |offset| on_grid(body, ([1.5 * element, element], [22, 30]), offset));
    assert!(found < 1.5e-3, "{found}");
}

/// A cylinder in plane strain that touches over `across` elements: its frame, moved by a part of an element.
fn line(across: usize, offset: f64) -> Simulation {
    let element = 2.0 * HALF_WIDTH / across as f64;
    let load = PI * HALF_WIDTH * HALF_WIDTH * MODULUS / (4.0 * 50e-3);
    let body = "body.pin.profile.cylinder = { radius = \"50 mm\", axis = \"y\" }";
    let elements = across + 7;
    let frame = format!(
        "motion.indentation.load = \"{load} N/m\"\nframe = {{ plane_strain = true, size = \"{} m\", \
         centre = \"{} m\", elements = {elements} }}",
        element * elements as f64,
        element * offset
    );
    case(&format!("{STEELS}{body}\n{frame}"), &["solver.conjugate_gradient.tolerance=1e-12"])
}

/// Ends of lines, wherever the grid lies.
#[test]
fn widths_of_lines_are_of_second_order() {
    for (across, bound) in [(16, 1e-3), (40, 2e-4)] {
        let found = worst(8, 2.0 * HALF_WIDTH, |[offset, _]| line(across, offset));
        assert!(found < bound, "{across} across: {found}");
    }
}

/// Where an edge is straight and the contact far larger than its elements, the pressure of its last pair and the gap of the next
/// one follow from where it lies between them, linearly: the constants of `problem/edge.rs`.
#[test]
fn pressures_and_gaps_at_an_edge_say_where_it_lies() {
    let across = 800;
    let element = 2.0 * HALF_WIDTH / across as f64;
    // Pressures near the edge are this times the root of the distance from it.
    let peak = MODULUS * HALF_WIDTH / (2.0 * 50e-3);
    let steepness = peak * (2.0 * element / HALF_WIDTH).sqrt();
    let near = |offset: f64| {
        let simulation = line(across, offset);
        let (state, ..) = states(&simulation).unwrap().pop().unwrap();
        let gap = state.gap_of(&simulation.problem);
        let last = state.pressure.iter().rposition(|pressure| *pressure > 0.0).unwrap();
        let beyond = (HALF_WIDTH - simulation.problem.frame.place(last)[0]) / element;
        [beyond, state.pressure[last] / steepness, gap[last + 1] * MODULUS / (steepness * element)]
    };
    for offset in [0.0, 0.2, 0.4, 0.6, 0.8] {
        let [beyond, pressure, gap] = near(offset);
        assert!((-0.18..0.83).contains(&beyond), "{beyond}");
        assert_relative_eq!(pressure, 0.9542 * (beyond + 0.1747), epsilon = 2e-3);
        assert_relative_eq!(gap, 1.646 * (1.0 - 0.1747 - beyond), epsilon = 4e-3);
    }
}

/// Contacts that wear, 7 and 20 elements across, against eight and six times as many.
#[test]
fn edges_that_wear_grow_by_their_own_power() {
    for (distance, elements, bound) in [(5, 24, 2e-2), (200, 32, 8e-3)] {
        let body = format!(
            "body.pin.profile.sphere.radius = \"50 mm\"\nbody.pin.wear.archard.coefficient = \"1.33e-13 1/Pa\"\n\
             motion.sliding = {{ load = \"10.2 N\", distance = \"{distance} mm\", tolerance = 1e-4 }}"
        );
        let worn = |elements: usize, offset| {
            on_grid(&body, ([1.2e-3 / elements as f64; 2], [elements; 2]), offset)
        };
        let truth = area(&worn(192, [0.0; 2]));
        let found = worst(4, truth, |offset| worn(elements, offset));
        assert!(found < bound, "{distance} mm: {found}");
    }
}
