//! Contact of meshed bodies where half-spaces or each other say what has to come out.

use approx::assert_relative_eq;
use archard::compliance::Compliance;
use archard::frame::VectorField;
use archard::simulation::Simulation;
use archard::solve::SOLVERS;
use faer::{Mat, Side};

use crate::common::{case, states};

/// A rigid ball on a block held at its bottom, a quarter of it meshed; the contact has a radius of about 1 mm.
pub const BALL_ON_BLOCK: &str = r#"
[body.ball]
rigid = true
profile.sphere = { radius = "50 mm" }
[body.block]
material = { young = "210 GPa", poisson = 0.3 }
mesh.box = { size = ["10 mm", "10 mm", "10 mm"], contact = { face = "top", size = ["2.6 mm", "2.6 mm"], elements = [8, 8] } }
supports = { bottom = "clamped" }
symmetry = ["x", "y"]
[motion.indentation]
approach = "0.02 mm"
increments = 1
"#;

/// The load (N) at the end.
fn load(simulation: &Simulation) -> f64 {
    states(simulation).unwrap().last().unwrap().0.load
}

/// The nearer the sides and the bottom, the more they matter; far away, the block is a half-space.
#[test]
fn a_block_becomes_a_half_space_as_it_grows() {
    let half_space = load(&case(BALL_ON_BLOCK, &["body.block.elasticity=half_space"]));
    let more = [10, 20, 40].map(|side| {
        let size =
            format!("body.block.mesh.box.size=[\"{side} mm\", \"{side} mm\", \"{side} mm\"]");
        load(&case(BALL_ON_BLOCK, &[&size])) / half_space - 1.0
    });
    assert!(more[0] > 0.01 && more[2].abs() < 0.01, "{more:?}");
    for pair in more.windows(2) {
        assert!(pair[1].abs() < 0.65 * pair[0].abs(), "{more:?}");
    }
}

/// Blocks alike that are pressed on each other share the approach.
#[test]
fn two_blocks_share_what_one_takes_alone() {
    let alone = case(
        BALL_ON_BLOCK,
        &["body.ball.profile.sphere.radius=100 mm", "motion.indentation.approach=0.01 mm"],
    );
    let mesh = r#"body.ball.mesh.box={ size = ["10 mm", "10 mm", "10 mm"], contact = { face = "top", size = ["2.6 mm", "2.6 mm"], elements = [8, 8] } }"#;
    let both = case(
        BALL_ON_BLOCK,
        &[
            "body.ball.rigid=",
            "body.ball.material={ young = \"210 GPa\", poisson = 0.3 }",
            mesh,
            "body.ball.supports={ bottom = \"clamped\" }",
            "body.ball.symmetry=[\"x\", \"y\"]",
        ],
    );
    // A ball is no parabola: its gap is twice that of a ball of twice the radius to 1e-4.
    assert_relative_eq!(load(&both), load(&alone), max_relative = 1e-4);
}

/// The surface of a block is drawn in under a smooth pressure as a half-space is, and what its sides and bottom add
/// changes slowly: nothing of it alternates from pair to pair. Without second derivatives 1.0 % of it does.
#[test]
fn tangential_displacements_under_a_smooth_pressure_are_smooth() {
    let elements = "body.block.mesh.box.contact.elements=[16, 16]";
    let half_spaces = "body.block.elasticity=half_space";
    let [block, half_space] = [&[elements][..], &[elements, half_spaces]].map(|options| {
        let problem = case(BALL_ON_BLOCK, options).problem;
        let mut tractions = VectorField::zeros(problem.frame.len());
        for (pair, pressure) in tractions.n.iter_mut().enumerate() {
            let [x, y] = problem.frame.place(pair);
            *pressure = (1.0 - (x * x + y * y) / 1.44e-6).max(0.0).powi(2);
        }
        let places: Vec<[f64; 2]> =
            (0..problem.frame.len()).map(|pair| problem.frame.place(pair)).collect();
        (places, problem.compliance.apply(&tractions).t1)
    });
    let largest = half_space.1.iter().fold(0.0f64, |largest, u| largest.max(u.abs()));
    // Rows of pairs along x: the difference at each pair against the line through those beside it.
    let mut row: Vec<(f64, f64)> = vec![];
    let mut alternation = 0.0f64;
    let y = block.0.iter().map(|place| place[1]).fold(f64::INFINITY, f64::min);
    for (pair, place) in block.0.iter().enumerate() {
        if (place[1] - y).abs() < 1e-9 {
            row.push((place[0], block.1[pair] - half_space.1[pair]));
        }
    }
    row.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert_eq!(row.len(), 16);
    for three in row.windows(3) {
        let [(x0, u0), (x1, u1), (x2, u2)] = [three[0], three[1], three[2]];
        let line = u0 + (u2 - u0) * (x1 - x0) / (x2 - x0);
        alternation = alternation.max((u1 - line).abs() / largest);
    }
    assert!(alternation < 0.002, "{alternation}");
}

/// Collocation is symmetric to the order of the elements only; every solver finds the same contact all the same.
#[test]
fn solvers_agree_on_a_meshed_block() {
    let loads = SOLVERS.iter().map(|choice| {
        let solver = format!("solver.{}.tolerance=1e-8", choice.name);
        load(&case(BALL_ON_BLOCK, &[&solver]))
    });
    let loads: Vec<f64> = loads.collect();
    for other in &loads[1..] {
        assert_relative_eq!(*other, loads[0], max_relative = 1e-6);
    }
}

/// Friction from pair to pair, from one increment to the next by approach or by load, ends where Newton's steps do:
/// with the same slip, stick in the middle and friction at its limit around it.
#[test]
fn sweeps_find_the_friction_of_newtons_steps() {
    for control in ["motion.indentation.approach=0.02 mm", "motion={indentation={load=800 N}}"] {
        let found = ["newton", "gauss_seidel"].map(|solver| {
            let solver = format!("friction_solver.{solver}.tolerance=1e-8");
            let options = [
                "friction.coulomb.coefficient=0.1",
                control,
                "motion.indentation.increments=4",
                &solver,
            ];
            let (state, effort, _) = states(&case(BALL_ON_BLOCK, &options)).unwrap().pop().unwrap();
            let [one, two] = state.tangential.unwrap().traction;
            (state.pressure, [one, two], effort)
        });
        let [(pressure, [one, two], newton), (other_pressure, [other_one, other_two], sweeps)] =
            found;
        let scale = pressure.iter().copied().fold(0.0, f64::max);
        let pairs = [(&pressure, &other_pressure), (&one, &other_one), (&two, &other_two)];
        for (these, those) in pairs {
            for (this, that) in these.iter().zip(those) {
                assert_relative_eq!(this, that, epsilon = 1e-6 * scale);
            }
        }
        let borne: Vec<f64> = (0..one.len()).map(|pair| one[pair].hypot(two[pair])).collect();
        let slips = |pair: &usize| borne[*pair] > 0.0999 * pressure[*pair];
        let touching = (0..borne.len()).filter(|&pair| pressure[pair] > 0.0);
        let slipping = touching.clone().filter(slips).count();
        assert!(0 < slipping && slipping < touching.count(), "{slipping} pairs slip");
        // As many sweeps as are allowed would mean that Newton's steps came to their help.
        assert!(sweeps.iterations > 3 * newton.iterations, "{sweeps:?} {newton:?}");
        assert!(sweeps.iterations < 5_000, "{sweeps:?}");
    }
}

/// Tractions do work on the displacements they make, and nearly the same on those of each other.
#[test]
fn condensed_bodies_are_positive_definite_and_nearly_symmetric() {
    for (interpolation, most) in [("discontinuous", 0.03), ("continuous", 0.03)] {
        let option = format!("body.block.boundary_elements.interpolation={interpolation}");
        let finer = "body.block.mesh.box.contact.elements=[12, 12]";
        let problem = case(BALL_ON_BLOCK, &[&option, finer]).problem;
        let pairs = problem.frame.len();
        let work = Mat::from_fn(3 * pairs, 3 * pairs, {
            let columns: Vec<Vec<f64>> =
                (0..3 * pairs).map(|column| image(&*problem.compliance, pairs, column)).collect();
            let frame = &problem.frame;
            move |row, column| frame.area(row % pairs) * columns[column][row]
        });
        let even = Mat::from_fn(3 * pairs, 3 * pairs, |row, column| {
            0.5 * (work[(row, column)] + work[(column, row)])
        });
        let asymmetry = (&work - &even).norm_l2() / even.norm_l2();
        assert!(asymmetry < most, "{interpolation}: {asymmetry}");
        let values = even.self_adjoint_eigenvalues(Side::Lower).unwrap();
        let largest = values[values.len() - 1];
        // Nodes on planes of symmetry do not move across them.
        let negative = values.iter().filter(|&&value| value < -1e-9 * largest).count();
        assert_eq!(negative, 0, "{interpolation}: {:?}", &values[..3]);
        if interpolation == "discontinuous" {
            assert!(values[0] > 1e-3 * largest, "{:e} of {largest:e}", values[0]);
        }
    }
}

/// Displacements along t1, t2 and n of all pairs under one unit traction.
fn image(compliance: &dyn Compliance, pairs: usize, column: usize) -> Vec<f64> {
    let mut unit = VectorField::zeros(pairs);
    let VectorField { t1, t2, n } = &mut unit;
    [t1, t2, n][column / pairs][column % pairs] = 1.0;
    compliance.apply(&unit).components().concat()
}
