//! What to expect of fretting and of pressing with friction.

use approx::assert_relative_eq;
use archard_case::{RunnableCase, Solves};

use crate::{file, reads_back, resolve};

/// A ball that frets on a flat.
pub const FRETTING: &str = r#"
[body.ball]
material = { young = "210 GPa", poisson = 0.3 }
profile.sphere = { radius = "10 mm" }
wear.archard = { coefficient = "0.5e-13 1/Pa" }
[body.flat]
material = { young = "210 GPa", poisson = 0.3 }
profile.flat = {}
[frame]
size = ["0.45 mm", "0.45 mm"]
elements = [32, 32]
[friction.coulomb]
coefficient = 0.6
[motion.fretting]
load = "50 N"
amplitude = ["1.023 um", "0 um"]
"#;

/// The fretting ball with these options: no warnings.
pub fn fretting(options: &[&str]) -> RunnableCase {
    let resolved = resolve(&options.iter().fold(file(FRETTING), |file, option| file.set(*option)));
    assert!(resolved.warnings.is_empty(), "{options:?}: {:?}", resolved.warnings);
    resolved
}

/// A path of three lines.
pub const PATH: &str = "motion={path={file=\"bad_cases/tables/path.csv\"}}";

/// Reference value: at this amplitude the stick zone is 0.6 of the contact, so that the force is that of
/// sliding less 0.6 cubed of it and the shift that of sliding less 0.6 squared of it.
#[test]
fn the_forecast_of_fretting_is_cattaneos_and_mindlins() {
    let forecast = fretting(&[]).forecast;
    let expected = forecast.estimate.fretting.unwrap();
    let contact_radius = forecast.estimate.contact.unwrap().semi_axes[0];
    assert_relative_eq!(expected.stick_radius, 0.6 * contact_radius, max_relative = 5e-4);
    assert_relative_eq!(expected.force, 30.0 * (1.0 - 0.216), max_relative = 5e-4);
    assert_relative_eq!(expected.contact.sliding_shift, 1.023e-6 / 0.64, max_relative = 5e-4);
    assert_eq!((expected.shift, expected.contact.sliding_force), (1.023e-6, 30.0));
    let by_force = ["motion.fretting.amplitude=", "motion.fretting.force_amplitude=[0 N, 23.52 N]"];
    let by_force = fretting(&by_force).forecast.estimate.fretting.unwrap();
    assert_relative_eq!(by_force.shift, 1.023e-6, max_relative = 5e-4);
    for other in [
        "motion.fretting.amplitude=[1 um, 1 um]",
        "motion.fretting.load_amplitude=10 N",
        "body.flat.material.young=70 GPa",
    ] {
        assert_eq!(fretting(&[other]).forecast.estimate.fretting, None, "{other}");
    }
}

#[test]
fn a_stress_that_swings_with_friction_reads_back() {
    let wanted = r#"output.stress.flat={ swinging={ xx="80 MPa", zx="-5 MPa" }, fatigue={ crossland=0.3 } }"#;
    let case = fretting(&[wanted]).case;
    reads_back(&case);
    assert_eq!(case.stresses[1].as_ref().unwrap().swinging, [80e6, 0.0, 0.0, 0.0, -5e6, 0.0]);
}

#[test]
fn damage_reads_back() {
    let wanted = r#"output.stress.flat={ fatigue={ dang_van=0.3 }, damage={ criterion="dang_van", strength="900 MPa", exponent=-0.1 } }"#;
    let case = fretting(&[wanted]).case;
    reads_back(&case);
    let damage = case.stresses[1].as_ref().unwrap().damage.as_ref().unwrap();
    assert_eq!(damage.criterion, "dang_van");
    assert_eq!((damage.endurance.strength, damage.endurance.exponent), (900e6, -0.1));
}

/// The loop of gross slip is that of full sliding, widened by the shift beyond it.
#[test]
fn the_forecast_of_gross_slip_has_no_stick_zone() {
    let expected = |shift: f64| {
        let option = format!("motion.fretting.amplitude=[{shift:e} m, 0 m]");
        fretting(&[&option]).forecast.estimate.fretting.unwrap()
    };
    let sliding = expected(1e-6).contact.sliding_shift;
    let (barely, far) = (expected(sliding), expected(sliding + 1e-6));
    assert_eq!((barely.stick_radius, far.stick_radius, far.wear), (0.0, 0.0, None));
    assert_eq!(far.force, 30.0);
    assert_relative_eq!(far.dissipated - barely.dissipated, 4.0 * 30.0 * 1e-6, max_relative = 1e-9);
}

/// Archard's volume is k W / mu for the energy W that friction dissipates.
#[test]
fn the_forecast_of_fretting_wear_goes_by_energy() {
    let expected = fretting(&["motion.fretting.cycles=7"]).forecast.estimate.fretting.unwrap();
    let wear = expected.wear.unwrap();
    let volume = 7.0 * 0.5e-13 * expected.dissipated / 0.6;
    assert_relative_eq!(wear.steady_volume, volume, max_relative = 1e-12);
    assert!(wear.end.scar_radius > expected.stick_radius && wear.end.volume() > volume);
}

/// Reference value: 0.8 of the contact sticks at 0.23801 under a rigid sphere, Poisson ratio 0.3.
#[test]
fn the_forecast_of_pressing_with_friction_is_spences() {
    let options = [
        "body.ball={rigid=true, profile={sphere={radius=10 mm}}}",
        "friction.coulomb.coefficient=0.23801",
        "motion={indentation={load=50 N, increments=40}}",
    ];
    let forecast = fretting(&options).forecast;
    assert_relative_eq!(forecast.estimate.pressed.unwrap().stick_ratio, 0.8, max_relative = 1e-3);
    assert_eq!(forecast.estimate.fretting, None);
}

/// One solve an increment and one for the first loading of like bodies; those that jumps compute by their length.
#[test]
fn the_forecast_counts_cycles_and_their_solves() {
    let counted = |options: &[&str]| {
        let forecast = fretting(options).forecast;
        (forecast.cycles.unwrap().computed, forecast.solves)
    };
    assert_eq!(counted(&[]), (Solves::Exactly(1), Solves::Exactly(21)));
    let ten = ["motion.fretting.cycles=10", "motion.fretting.increments=8"];
    assert_eq!(counted(&ten), (Solves::Exactly(10), Solves::Exactly(81)));
    // Measured with ten outputs: 612 solves in 21 cycles.
    let many = ["motion.fretting.cycles=200000", "motion.fretting.jump=10000"];
    assert_eq!(counted(&many), (Solves::Exactly(21), Solves::AtLeast(581)));
    // Measured with ten outputs: 33 cycles.
    let by_error = ["motion.fretting.cycles=200000", "motion.fretting.tolerance=0.01"];
    assert_eq!(counted(&by_error).0, Solves::About(32));
    // Where every cycle is computed there is nothing to jump over, whatever the tolerance.
    let all = [ten[0], ten[1], "motion.fretting.tolerance=0.01"];
    let forecast = resolve(&all.iter().fold(file(FRETTING), |file, key| file.set(*key))).forecast;
    assert_eq!(forecast.cycles.unwrap().computed, Solves::About(10));
    assert_eq!(forecast.solves, Solves::About(81));
    // Lines without load are not solved.
    assert_eq!(counted(&[PATH]), (Solves::Exactly(1), Solves::Exactly(3)));
}

#[test]
fn cycles_are_put_out_at_their_ends() {
    let outputs = |options: &[&str]| fretting(options).case.build().unwrap().schedule.outputs;
    let cycles = |count: usize| outputs(&[&format!("motion.fretting.cycles={count}")]);
    assert_eq!(cycles(1), [1.0]);
    assert_eq!(cycles(2), [1.0, 2.0]);
    assert_eq!(cycles(25), [3.0, 6.0, 9.0, 12.0, 15.0, 18.0, 21.0, 24.0, 25.0]);
    assert_eq!(cycles(30), [3.0, 6.0, 9.0, 12.0, 15.0, 18.0, 21.0, 24.0, 27.0, 30.0]);
    assert_eq!(outputs(&["output.every=0.5"]), [0.5, 1.0]);
    assert_eq!(outputs(&[PATH])[..2], [0.2, 0.4]);
    assert_eq!(outputs(&[PATH, "motion.path.cycles=3"]), [2.0, 4.0, 6.0]);
    assert_eq!(outputs(&[PATH, "output.at=[500 ms]"]), [0.5, 2.0]);
}
