//! Cases of meshed bodies.

use approx::assert_relative_eq;
use archard::body::{Elasticity, Interpolation, Support};
use archard_case::{Finiteness, RunnableCase};

use crate::common::Rows;
use crate::{file, reads_back, resolve};

/// A rigid punch on a quarter of a block.
const PUNCH: &str = r#"
[body.punch]
rigid = true
profile.power = { coefficient = "0.005 1/m", exponent = 2 }
[body.block]
material = { young = "210 GPa", poisson = 0.3 }
supports = { bottom = "clamped" }
symmetry = ["x", "y"]
[body.block.mesh.box]
size = ["1 m", "1 m", "1 m"]
contact = { size = ["0.2 m", "0.2 m"], elements = [8, 8] }
[motion.indentation]
approach = "0.07 mm"
"#;

fn punch(options: &[&str]) -> RunnableCase {
    resolve(&options.iter().fold(file(PUNCH), |file, option| file.set(*option)))
}

/// A sphere of 50 mm whose lower half is clamped, on a rigid plane.
const SPHERE: &str = r#"
[body.ball]
material = { young = "210 GPa", poisson = 0.3 }
mesh.sphere = { radius = "50 mm", inner = "10 mm", contact = { size = ["2 mm", "2 mm"], elements = [8, 8] } }
supports = { inner = "clamped" }
symmetry = ["x", "y"]
[body.plane]
rigid = true
profile.flat = {}
[motion.indentation]
load = "1 kN"
"#;

#[test]
fn a_meshed_body_reads_as_it_is_written() {
    let case = punch(&[]).case;
    let finite = case.bodies[1].finite.as_ref().unwrap();
    assert_eq!(finite.supports, [("bottom".to_owned(), Support::Clamped)]);
    assert_eq!(finite.mirrored, [true, true]);
    assert_eq!(finite.interpolation, Interpolation::Discontinuous);
    assert_eq!(finite.elasticity, Elasticity::BoundaryElements);
    let supports = punch(&[
        "body.block.supports={bottom=roller, right={pressure=\"2 MPa\"}, \
         back={displacement=[\"free\", \"1 um\", \"free\"]}}",
        "body.block.boundary_elements={interpolation=\"continuous\", tolerance=1e-5}",
    ]);
    let finite = supports.case.bodies[1].finite.as_ref().unwrap();
    let back = Support::Displacement([None, Some(1e-6), None]);
    let expected = [("back", back), ("bottom", Support::Roller), ("right", Support::Pressure(2e6))];
    assert_eq!(finite.supports.len(), expected.len());
    for (name, support) in expected {
        assert!(finite.supports.contains(&(name.to_owned(), support)), "{:?}", finite.supports);
    }
    assert_eq!((finite.interpolation, finite.tolerance), (Interpolation::Continuous, 1e-5));
}

#[test]
fn meshed_cases_read_back_to_the_same_bits() {
    for options in [
        &[][..],
        &["body.block.supports={bottom={displacement=[\"0 m\", \"0 m\", \"-1.1 um\"]}}"],
        &["body.block.symmetry=[\"x\"]", "body.block.boundary_elements.interpolation=continuous"],
        &[
            "body.block.elasticity=half_space",
            "body.block.mesh.box.size=[\"9 m\", \"9 m\", \"9 m\"]",
        ],
        &["body.block.profile.sphere.radius=70 m"],
    ] {
        reads_back(&punch(options).case);
    }
    reads_back(&resolve(&file(SPHERE)).case);
    let point = r#"output.points.block.below=["0 mm", "1 mm", "-20 mm"]"#;
    let points = punch(&[point]).case.points;
    assert!(points[0].is_empty());
    assert_eq!((&points[1][0].name[..], points[1][0].place), ("below", [0.0, 1e-3, -0.02]));
    reads_back(&punch(&[point]).case);
}

/// What says how the block deforms.
fn way(options: &[&str]) -> Elasticity {
    let case = punch(options).case;
    reads_back(&case);
    case.bodies[1].finite.as_ref().unwrap().elasticity
}

/// A flat zone away from edges has an image field where that takes less than a mesh and alone bears load, whatever is sought inside.
#[test]
fn flat_zones_have_image_fields_where_these_do() {
    const FINE: &str = "body.block.mesh.box.contact.elements=[20, 20]";
    assert_eq!(way(&[]), Elasticity::BoundaryElements, "few elements");
    assert_eq!(way(&[FINE]), Elasticity::Image);
    let told = |options: &[&str]| punch(options).forecast.to_string();
    assert!(
        told(&[FINE]).contains("half-space and image field for `block`: it touches with a flat")
    );
    for option in [
        "body.block.supports={bottom=clamped, right={pressure=1 MPa}}",
        "body.block.supports={top=clamped}",
        "body.block.mesh.box.contact.size=[\"0.96 m\", \"0.2 m\"]",
        "body.block.elasticity=boundary_elements",
    ] {
        assert_eq!(way(&[FINE, option]), Elasticity::BoundaryElements, "{option}");
    }
    let inside = "output.points.block.below=[\"0 mm\", \"1 mm\", \"-20 mm\"]";
    assert_eq!(way(&[FINE, inside]), Elasticity::Image);
    // The frame is that of the zone, and grows; or one of its own.
    let case = punch(&[FINE]).case;
    assert_eq!((case.frame.size, case.frame.elements), ([0.2; 2], [40; 2]));
    assert!(case.build().unwrap().problem.frame.is_uniform());
    let framed =
        ["body.block.mesh.box.contact=", "frame.size=[0.3 m, 0.2 m]", "frame.element=5 mm"];
    assert_eq!(way(&framed), Elasticity::Image);
    assert_eq!(punch(&framed).case.frame.elements, [60, 40]);
    assert_eq!(way(&[framed[0], "accuracy=0.05"]), Elasticity::Image);
}

/// A quarter of the block has 4 x 4 elements in the zone, four nodes each; three unknowns a node.
#[test]
fn the_forecast_counts_pairs_and_unknowns() {
    let forecast = punch(&[]).forecast;
    assert_eq!(forecast.pairs, 4 * 4 * 4);
    let [(body, unknowns)] = &forecast.unknowns[..] else { panic!("{:?}", forecast.unknowns) };
    assert_eq!(body, "block");
    let simulation = punch(&[]).case.build().unwrap();
    assert_eq!(simulation.problem.frame.len(), forecast.pairs);
    let finite = simulation.problem.bodies[1].finite.as_ref().unwrap();
    let faces = finite.meshed.mesh.faces.len();
    assert_eq!(*unknowns, 12 * faces);
    let matrix = 8.0 * (*unknowns as f64).powi(2);
    assert!(forecast.memory > matrix && forecast.memory < 2.0 * matrix + 1e7, "{forecast:?}");
    let shown = forecast.to_string();
    assert!(shown.contains(&format!("unknowns          {unknowns} of `block`")), "{shown}");
    assert!(shown.contains("pairs             64\n"), "{shown}");
    // A half-space has none.
    let half_space = punch(&["body.block.elasticity=half_space"]).forecast;
    assert_eq!((half_space.pairs, half_space.unknowns), (64, vec![]));
    assert!(half_space.memory < forecast.memory);
}

/// Hertz: 1.802e6 N on a half-space, a = sqrt(R d) with R = 100 m.
#[test]
fn the_forecast_of_a_meshed_body_is_that_of_a_half_space() {
    let resolved = punch(&[]);
    assert!(resolved.warnings.is_empty(), "{:?}", resolved.warnings);
    let contact = resolved.forecast.estimate.contact.unwrap();
    assert_relative_eq!(contact.load, 1.802037e6, max_relative = 1e-6);
    assert_relative_eq!(contact.semi_axes[0], f64::sqrt(100.0 * 7e-5), max_relative = 1e-9);
    let sphere = resolve(&file(SPHERE));
    assert!(sphere.warnings.is_empty(), "{:?}", sphere.warnings);
    let contact = sphere.forecast.estimate.contact.unwrap();
    let modulus = 210e9 / 0.91;
    let radius = f64::cbrt(0.75 * 1e3 * 0.05 / modulus);
    assert_relative_eq!(contact.semi_axes[0], radius, max_relative = 1e-9);
}

/// The sides of the block, 0.5 m from a contact of 0.0837 m, matter more than its bottom in what a half-space is
/// displaced there: 0.42 a / r, and somewhat more further down, against 0.73 a / r at twice the distance.
#[test]
fn the_forecast_says_where_a_body_ends() {
    let found = punch(&[]).forecast.finiteness;
    let [Finiteness { body, distance, approach, half_space, .. }] = &found[..] else {
        panic!("{found:?}")
    };
    assert_eq!((&body[..], *half_space), ("block", false));
    assert_relative_eq!(*distance, 0.5, max_relative = 1e-9);
    let expected = 4.0 / (3.0 * std::f64::consts::PI) * f64::sqrt(100.0 * 7e-5) / 0.5;
    assert!((expected..1.05 * expected).contains(approach), "{approach} {expected}");
    // A plate of a quarter of the thickness ends at its bottom.
    let plate = punch(&["body.block.mesh.box.size=[\"1 m\", \"1 m\", \"0.25 m\"]"]);
    assert_relative_eq!(plate.forecast.finiteness[0].distance, 0.25, max_relative = 1e-9);
}

/// As a half-space the pairs are the same and the load is Hertz's, within what 16 pairs give.
#[test]
fn a_half_space_takes_the_place_of_the_block() {
    let simulation = |options: &[&str]| punch(options).case.build().unwrap().problem;
    let half_space = simulation(&["body.block.elasticity=half_space", "body.block.supports="]);
    let block = simulation(&[]);
    assert_eq!(half_space.frame.gap(), block.frame.gap());
    let pressure = vec![1.0; half_space.frame.len()];
    let approach = |problem: &archard::problem::ContactProblem| {
        let mut displacement = vec![0.0; pressure.len()];
        problem.compliance.apply_normal(&pressure, &mut displacement);
        displacement.iter().sum::<f64>() / displacement.len() as f64
    };
    // Under a uniform pressure p on a square of side b the mean displacement is (Love)
    // [4 asinh(1) - 4/3 (sqrt(2) - 1)] p b / (pi E*), and the block gives way by a little less.
    let factor = 4.0 * f64::asinh(1.0) - 4.0 / 3.0 * (f64::sqrt(2.0) - 1.0);
    let love = factor / std::f64::consts::PI * 0.2 / (210e9 / 0.91);
    assert_relative_eq!(approach(&half_space), love, max_relative = 3e-3);
    let stiffer = approach(&block) / approach(&half_space);
    assert!(stiffer > 0.97 && stiffer < 1.0, "{stiffer}");
}

/// The coarse estimate against full computations of a rigid sphere on 12 x 12 elements without friction, at the
/// same approach d: a cube of 1 m takes 1.5 % more load than one of 20 m, a plate of 0.25 m 41 % more and a column
/// of 0.5 x 0.5 x 2 m 50 % less. With F = k (d + c F)^(3/2) these are shares c F / d of 1.0, 18 and -72 %.
#[test]
fn what_a_half_space_would_change_is_estimated() {
    let share = |size: &str| {
        let found = punch(&[&format!("body.block.mesh.box.size={size}")]).case.beside_half_spaces();
        let [found] = &found[..] else { panic!("{found:?}") };
        found.share
    };
    let cube = share("[\"1 m\", \"1 m\", \"1 m\"]");
    assert!((0.008..0.014).contains(&cube), "{cube}");
    let plate = share("[\"1 m\", \"1 m\", \"0.25 m\"]");
    assert!((0.15..0.21).contains(&plate), "{plate}");
    let column = share("[\"0.5 m\", \"0.5 m\", \"2 m\"]");
    assert!((-0.8..-0.62).contains(&column), "{column}");
}

/// A ball that rolls on a rail meshed by Gmsh, in triangles, and wears it.
const RAIL: &str = r#"
[body.rail]
material = { young = "210 GPa", poisson = 0.3 }
mesh.file = { path = "../../archard/tests/meshes/rail.msh", contact = "zone", unit = "mm" }
supports = { bottom = "clamped" }
boundary_elements = { interpolation = "continuous", tolerance = 1e-4 }
wear.archard = { coefficient = "1e-12 1/Pa" }
[body.ball]
material = { young = "210 GPa", poisson = 0.3 }
profile.sphere = { radius = "20 mm" }
[friction.coulomb]
coefficient = 0.3
[motion.rolling]
load = "61.538 N"
creepage = 0.00114285
revolutions = 100
step = 50
"#;

/// Kalker's force at 0.2 mu F / (G a^2), 0.664 mu F, which 8 elements over the width of the contact exceed by
/// several percent; and the section that the creepage wears at it, between a triangle and a rectangle over the width
/// of the contact.
#[test]
fn a_ball_rolls_on_a_mesh_of_triangles() {
    let resolved = resolve(&file(RAIL));
    assert!(resolved.warnings.is_empty(), "{:?}", resolved.warnings);
    let mut rows = Rows::default();
    resolved.case.build().unwrap().run(&mut [&mut rows]).unwrap();
    let force = rows.column("force_x_N");
    assert_relative_eq!(force[0], 0.664 * 0.3 * 61.538, max_relative = 0.05);
    let worn = 1e-12 / 0.3 * 0.00114285 * 50.0 * (force[1] + force[2]);
    // The pressures stretch the rail and the ball by different amounts, as both are not half-spaces: 1.2 %.
    assert_relative_eq!(rows.last("worn_section_rail_m2"), worn, max_relative = 0.02);
    let track = rows.last("wear_depth_m") * 0.4e-3;
    assert!((0.5..1.0).contains(&(worn / track)), "{}", worn / track);
}
