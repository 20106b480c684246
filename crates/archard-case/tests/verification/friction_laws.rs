//! Friction laws that are not Coulomb's, against what they leave of Hertz's pressures.

use approx::assert_relative_eq;
use archard::closed_form::Hertz;
use archard::problem::ContactState;

use crate::common::{case, states};

const ROLLS: &str = "[motion.rolling]\nload = \"10 N\"\nrevolutions = 1\nstep = 1\ncreepage = 0.5";
const SHIFTS: &str =
    "[motion.fretting]\nload = \"10 N\"\namplitude = [\"5 um\", \"0 um\"]\nincrements = 12";
const STEEL: &str = "material = { young = \"210 GPa\", poisson = 0.3 }";

/// The largest force (N) that a ball of steel under 10 N bears along x in a motion, by a friction table; every traction is
/// within `limit` of its pressure (Pa).
fn most_force(flat: &str, motion: &str, friction: &str, limit: impl Fn(f64) -> f64) -> f64 {
    let text = format!(
        r#"
        [body.ball]
        {STEEL}
        profile.sphere = {{ radius = "50 mm" }}
        [body.flat]
        {flat}
        profile.flat = {{}}
        [friction.{friction}
        [frame]
        size = ["0.4 mm", "0.4 mm"]
        elements = [40, 40]
        {motion}
        "#
    );
    let simulation = case(&text, &[]);
    let all = states(&simulation).expect("it converges");
    let force = |state: &ContactState| {
        let tangential = state.tangential.as_ref().expect("friction");
        simulation.problem.frame.integrate(&tangential.traction[0]).abs()
    };
    for (state, ..) in &all {
        let Some(tangential) = &state.tangential else { continue };
        for (pair, &pressure) in state.pressure.iter().enumerate() {
            let [x, y] = [0, 1].map(|axis| tangential.traction[axis][pair]);
            assert!(x.hypot(y) <= limit(pressure) + 1e3, "{x:e} {y:e} under {pressure:e}");
        }
    }
    all.iter().map(|(state, ..)| force(state)).fold(0.0, f64::max)
}

/// Hertz's peak pressure (Pa) on a flat of steel, or a rigid one.
fn peak(flat: &str) -> f64 {
    let modulus = 210e9 / (1.0 - 0.09) / if flat == STEEL { 2.0 } else { 1.0 };
    Hertz::from_load([20.0; 2], modulus, 10.0).expect("a contact").peak_pressure
}

/// Where all slides, a sphere bears mu P (3 c - c^3) / 2 with c = tau_max / (mu p0): mu p where r^2 > a^2 (1 - c^2), and
/// tau_max within.
#[test]
fn a_sliding_sphere_bears_what_the_strength_leaves() {
    for (flat, motion) in [(STEEL, ROLLS), (STEEL, SHIFTS), ("rigid = true", SHIFTS)] {
        let strength = 0.3 * 0.5 * peak(flat);
        let friction = format!("tresca]\ncoefficient = 0.3\nshear_strength = \"{strength} Pa\"");
        let force = most_force(flat, motion, &friction, |p| (0.3 * p).min(strength));
        // Unlike bodies change the pressures a little.
        let within = if flat == STEEL { 0.01 } else { 0.03 };
        assert_relative_eq!(force, 0.3 * 10.0 * 0.6875, max_relative = within);
    }
}

/// With mu = mu0 (1 - p / (4 p0)) a sphere bears mu0 P (1 - 3/16): the square of Hertz's pressures integrates to 3/4 p0 P.
#[test]
fn a_sliding_sphere_bears_the_coefficients_of_a_table() {
    let folder = tempfile::tempdir().expect("a folder");
    for (flat, motion) in [(STEEL, ROLLS), (STEEL, SHIFTS), ("rigid = true", SHIFTS)] {
        let end = 2.0 * peak(flat);
        let file = folder.path().join("mu.csv");
        std::fs::write(&file, format!("pressure_Pa,coefficient\n0,0.3\n{end},0.15\n"))
            .expect("a file");
        let friction = format!("table]\nfile = '{}'", file.display());
        let limit = |p: f64| 0.3 * p * (1.0 - 0.5 * p / end);
        let force = most_force(flat, motion, &friction, limit);
        let within = if flat == STEEL { 0.01 } else { 0.03 };
        assert_relative_eq!(force, 0.3 * 10.0 * (1.0 - 3.0 / 16.0), max_relative = within);
    }
}
