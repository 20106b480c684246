//! What to expect of rolling.

use approx::assert_relative_eq;
use archard_case::{RunnableCase, Solves};

use crate::{file, resolve};

/// The case of the paper's section 6.3.
pub const TWIN_DISCS: &str = r#"
[body.disc1]
material = { young = "208 GPa", poisson = 0.3 }
profile.disc = { radius = "32.5 mm", crown = "125 mm" }
wear.archard = { coefficient = "1.333333e-6 1/MPa" }
[body.disc2]
material = { young = "208 GPa", poisson = 0.3 }
profile.disc = { radius = "32.3 mm" }
wear.archard = { coefficient = "0.666667e-6 1/MPa" }
[frame]
size = ["0.52 mm", "6.4 mm"]
elements = [41, 81]
[friction.coulomb]
coefficient = 0.6
[motion.rolling]
load = "300 N"
creepage = 0.005
revolutions = 30000
step = 100
"#;

/// The twin discs with these options: no warnings.
fn twin_discs(options: &[&str]) -> RunnableCase {
    let resolved =
        resolve(&options.iter().fold(file(TWIN_DISCS), |file, option| file.set(*option)));
    assert!(resolved.warnings.is_empty(), "{options:?}: {:?}", resolved.warnings);
    resolved
}

/// Independent values: all slips from 0.802 % on; 26.2 % of the contact sticks by strip theory; a
/// half-space solution wears 26.13 um deep, to which the incremental model comes within 0.5 %, on a track
/// that is twice sqrt(2 R h) wide.
#[test]
fn the_forecast_of_twin_discs() {
    let forecast = twin_discs(&[]).forecast;
    let creep = forecast.estimate.rolled.unwrap();
    assert_relative_eq!(creep.saturation.unwrap().creepage, 0.802e-2, max_relative = 1e-3);
    assert_relative_eq!(creep.stick_share.unwrap(), 0.262, epsilon = 1e-3);
    let track = creep.track.unwrap();
    assert_relative_eq!(track.depth, 26.13e-6, max_relative = 5e-3);
    assert_relative_eq!(track.semi_axes[1], (0.25 * track.depth).sqrt(), max_relative = 1e-12);
    assert_eq!(track.semi_axes[0], 0.0);
    // What slips all over passes on the limit; a tenth of the revolutions at ten times the creepage wear
    // as much.
    let slipping =
        twin_discs(&["motion.rolling.creepage=-0.05", "motion.rolling.revolutions=3000"]);
    let slipping = slipping.forecast.estimate.rolled.unwrap();
    assert_eq!((slipping.stick_share, slipping.force), (Some(0.0), Some([-180.0, 0.0])));
    assert_relative_eq!(slipping.track.unwrap().depth, track.depth, max_relative = 1e-12);
    assert_eq!(forecast.solves, Solves::AtLeast(301));
}

/// Linear theory along all four directions: what creeps on, across and in spin follows the direction, and
/// of the axes of the contact only which one lies along it matters.
#[test]
fn the_forecast_turns_with_the_direction_of_rolling() {
    let force = |options: &[&str]| {
        let creep = ["motion.rolling.lateral_creepage=-0.001", "motion.rolling.spin=\"2 1/m\""];
        let still = ["motion.rolling.revolutions=0", "body.disc1.wear=", "body.disc2.wear="];
        twin_discs(&[&creep[..], &still, options].concat())
            .forecast
            .estimate
            .rolled
            .unwrap()
            .linear_force
            .unwrap()
    };
    let turned = [
        "body.disc1.profile={paraboloid={radius_x=125 mm, radius_y=16.199846 mm}}",
        "body.disc2.profile={flat={}}",
        "frame.size=[2 mm, 0.52 mm]",
    ];
    let forward = force(&[]);
    assert!(forward[0] > 0.0 && forward[1] != 0.0);
    assert_eq!(force(&["motion.rolling.direction=-x"]), forward);
    for direction in ["motion.rolling.direction=y", "motion.rolling.direction=-y"] {
        let force = force(&[&turned[..], &[direction]].concat());
        assert_relative_eq!(force[0], forward[0], max_relative = 1e-7);
        assert_relative_eq!(force[1], forward[1], max_relative = 1e-7);
    }
}

/// Bodies that touch along a line follow Carter: at half the saturation half of the contact sticks and
/// three quarters of the limit are reached.
#[test]
fn the_forecast_of_cylinders_is_carters() {
    let file = ["body.disc1.profile.disc.crown=", "motion.rolling.creepage=0.001"]
        .iter()
        .fold(file(TWIN_DISCS), |file, option| file.set(*option));
    let creep = resolve(&file).forecast.estimate.rolled.unwrap();
    let half = format!("motion.rolling.creepage={}", 0.5 * creep.saturation.unwrap().creepage);
    let creep = resolve(&file.set(half)).forecast.estimate.rolled.unwrap();
    assert_relative_eq!(creep.stick_share.unwrap(), 0.5, max_relative = 1e-12);
    assert_relative_eq!(creep.force.unwrap()[0], 0.75 * 180.0, max_relative = 1e-12);
    assert_eq!((creep.linear_force, creep.free_creepage, creep.track), (None, None, None));
}

/// Reference value, three digits: cylinders of 50 mm, 23 GPa and 82 GPa in shear, half width 0.1 mm.
#[test]
fn the_forecast_of_unlike_cylinders_has_their_free_rolling() {
    // Half width 0.1 mm: 2 p0 a / E* with p0 = E* a / (2 R), times the length of the frame.
    let modulus = 1.0 / ((1.0 - 0.31) / (2.0 * 23e9) + (1.0 - 0.28) / (2.0 * 82e9));
    let load = std::f64::consts::PI * modulus * 0.1e-3f64.powi(2) * 6.4e-3 / (4.0 * 25e-3);
    let options = [
        "body.disc1.material={young=60.26 GPa, poisson=0.31}".to_owned(),
        "body.disc2.material={young=209.92 GPa, poisson=0.28}".to_owned(),
        "body.disc1.profile.disc={radius=50 mm}".to_owned(),
        "body.disc2.profile.disc={radius=50 mm}".to_owned(),
        format!("motion.rolling.load={load} N"),
    ];
    let file = options.iter().fold(file(TWIN_DISCS), |file, option| file.set(option));
    let creep = resolve(&file).forecast.estimate.rolled.unwrap();
    assert_relative_eq!(creep.free_creepage.unwrap(), 5.26e-4, max_relative = 1e-3);
    assert_eq!((creep.stick_share, creep.linear_force, creep.force), (None, None, None));
}

/// Fixed steps of nothing that wears are known exactly, a sweep depends on its increments, and steps chosen
/// by error are fewer than in sliding.
#[test]
fn the_forecast_counts_the_solves_of_rolling() {
    let solves = |options: &[&str]| {
        resolve(&options.iter().fold(file(TWIN_DISCS), |file, option| file.set(*option)))
            .forecast
            .solves
    };
    let still = ["body.disc1.wear=", "body.disc2.wear="];
    let at_rest = [&still[..], &["motion.rolling.revolutions=0"]].concat();
    assert_eq!(solves(&at_rest), Solves::Exactly(1));
    let sweep = [&still[..], &["motion={creepage_sweep={load=300 N, creepage=0.01}}"]].concat();
    assert_eq!(solves(&sweep), Solves::Exactly(11));
    // Measured: 54.
    let by_error = ["motion.rolling.step=", "motion.rolling.tolerance=0.003"];
    assert_eq!(solves(&by_error), Solves::About(50));
}
