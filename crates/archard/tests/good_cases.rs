//! Right cases: what they mean, whatever way they are written.

mod good_cases {
    mod meshed;
}

use std::path::Path;

use approx::assert_relative_eq;
use archard::body::Material;
use archard::case::{Case, CaseFile, Resolved, Solves};
use archard::kinematics::{Control, Stepping};
use proptest::prelude::*;

/// The case of the paper's section 6.2, in the units of the paper.
const PIN_ON_DISC: &str = r#"
[body.pin]
material = { young = "210 GPa", poisson = 0.3 }
profile.sphere = { radius = "50 mm" }
wear.archard = { coefficient = "1.33e-13 1/Pa" }
[body.disc]
material = { young = "210 GPa", poisson = 0.3 }
profile.flat = {}
[frame]
size = ["1.2 mm", "1.2 mm"]
elements = [30, 30]
[motion.sliding]
load = "10.2 N"
distance = "500 mm"
step = "5 mm"
"#;

fn file(text: &str) -> CaseFile {
    CaseFile::from_text("case.toml", text, Path::new(env!("CARGO_MANIFEST_DIR")).join("tests"))
}

fn resolve(file: &CaseFile) -> Resolved {
    file.resolve().unwrap_or_else(|problems| {
        let lines: Vec<String> = problems.iter().map(|one| file.describe(one)).collect();
        panic!("{}", lines.join("\n"))
    })
}

fn case(text: &str) -> Case {
    resolve(&file(text)).case
}

/// The pin on the disc with these options.
fn with(options: &[&str]) -> Case {
    resolve(&options.iter().fold(file(PIN_ON_DISC), |file, option| file.set(*option))).case
}

#[test]
fn the_pin_on_disc_in_si() {
    let case = case(PIN_ON_DISC);
    assert_eq!(case.bodies.each_ref().map(|body| &body.name[..]), ["pin", "disc"]);
    assert_eq!(case.bodies[0].material, Some(Material { young: 210e9, poisson: 0.3 }));
    assert_eq!(case.frame.size, [1.2e-3; 2]);
    let simulation = case.build().unwrap();
    let schedule = &simulation.schedule;
    assert_eq!(schedule.control, Control::Load(10.2));
    assert_eq!(schedule.stepping, Stepping::Implicit(5e-3));
    assert_eq!(schedule.extent, 0.5);
    assert_eq!(schedule.outputs, [0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5]);
    assert_eq!(simulation.problem.frame.len(), 900);
    assert!(simulation.problem.bodies[0].wear.is_some());
    assert!(simulation.problem.bodies[1].wear.is_none());
}

#[test]
fn the_forecast_has_the_closed_forms() {
    let forecast = resolve(&file(PIN_ON_DISC)).forecast;
    let contact = forecast.contact.unwrap();
    // Independent values: the sphere of 50 mm under 10.2 N after Hertz, and eq. 55 at 500 mm.
    assert_relative_eq!(contact.semi_axes[0], 0.1491058e-3, max_relative = 1e-6);
    assert_relative_eq!(contact.peak_pressure, 219.0547e6, max_relative = 1e-6);
    assert_relative_eq!(contact.approach.unwrap(), 0.44465074e-6, max_relative = 1e-6);
    assert_relative_eq!(forecast.worn.unwrap().depth, 2.078040e-6, max_relative = 1e-6);
    assert_eq!(forecast.solves, Solves::Exactly(101));
}

/// The case of the paper's section 6.3.
const TWIN_DISCS: &str = r#"
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
fn twin_discs(options: &[&str]) -> Resolved {
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
    let creep = forecast.creep.unwrap();
    assert_relative_eq!(creep.saturation.unwrap(), 0.802e-2, max_relative = 1e-3);
    assert_relative_eq!(creep.stick_share.unwrap(), 0.262, epsilon = 1e-3);
    let track = creep.track.unwrap();
    assert_relative_eq!(track.depth, 26.13e-6, max_relative = 5e-3);
    assert_relative_eq!(track.semi_axes[1], (0.25 * track.depth).sqrt(), max_relative = 1e-12);
    assert_eq!(track.semi_axes[0], 0.0);
    // What slips all over passes on the limit; a tenth of the revolutions at ten times the creepage wear
    // as much.
    let slipping =
        twin_discs(&["motion.rolling.creepage=-0.05", "motion.rolling.revolutions=3000"]);
    let slipping = slipping.forecast.creep.unwrap();
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
            .creep
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
    let creep = resolve(&file).forecast.creep.unwrap();
    let half = format!("motion.rolling.creepage={}", 0.5 * creep.saturation.unwrap());
    let creep = resolve(&file.set(half)).forecast.creep.unwrap();
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
    let creep = resolve(&file).forecast.creep.unwrap();
    assert_relative_eq!(creep.free_creepage.unwrap(), 5.26e-4, max_relative = 1e-3);
    assert_eq!((creep.stick_share, creep.linear_force, creep.force), (None, None, None));
}

/// Fixed steps of nothing that wears are known exactly, a sweep goes by its increments, and steps chosen
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
    // Measured: 59 with ten outputs.
    let by_error = ["motion.rolling.step=", "motion.rolling.tolerance=0.003"];
    assert_eq!(solves(&by_error), Solves::About(58));
}

/// A ball that frets on a flat.
const FRETTING: &str = r#"
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
fn fretting(options: &[&str]) -> Resolved {
    let resolved = resolve(&options.iter().fold(file(FRETTING), |file, option| file.set(*option)));
    assert!(resolved.warnings.is_empty(), "{options:?}: {:?}", resolved.warnings);
    resolved
}

/// A path of three lines.
const PATH: &str = "motion={path={file=\"bad_cases/tables/path.csv\"}}";

/// Reference value: at this amplitude the stick zone is 0.6 of the contact, so that the force is that of
/// sliding less 0.6 cubed of it and the shift that of sliding less 0.6 squared of it.
#[test]
fn the_forecast_of_fretting_is_cattaneos_and_mindlins() {
    let forecast = fretting(&[]).forecast;
    let expected = forecast.fretting.unwrap();
    let contact_radius = forecast.contact.unwrap().semi_axes[0];
    assert_relative_eq!(expected.stick_radius, 0.6 * contact_radius, max_relative = 5e-4);
    assert_relative_eq!(expected.force, 30.0 * (1.0 - 0.216), max_relative = 5e-4);
    assert_relative_eq!(expected.sliding_shift, 1.023e-6 / 0.64, max_relative = 5e-4);
    assert_eq!((expected.shift, expected.sliding_force), (1.023e-6, 30.0));
    let by_force = ["motion.fretting.amplitude=", "motion.fretting.force_amplitude=[0 N, 23.52 N]"];
    let by_force = fretting(&by_force).forecast.fretting.unwrap();
    assert_relative_eq!(by_force.shift, 1.023e-6, max_relative = 5e-4);
    for other in [
        "motion.fretting.amplitude=[1 um, 1 um]",
        "motion.fretting.load_amplitude=10 N",
        "body.flat.material.young=70 GPa",
    ] {
        assert_eq!(fretting(&[other]).forecast.fretting, None, "{other}");
    }
}

/// The loop of gross slip is that of full sliding, widened by the shift beyond it.
#[test]
fn the_forecast_of_gross_slip_has_no_stick_zone() {
    let expected = |shift: f64| {
        let option = format!("motion.fretting.amplitude=[{shift:e} m, 0 m]");
        fretting(&[&option]).forecast.fretting.unwrap()
    };
    let sliding = expected(1e-6).sliding_shift;
    let (barely, far) = (expected(sliding), expected(sliding + 1e-6));
    assert_eq!((barely.stick_radius, far.stick_radius, far.wear), (0.0, 0.0, None));
    assert_eq!(far.force, 30.0);
    assert_relative_eq!(far.dissipated - barely.dissipated, 4.0 * 30.0 * 1e-6, max_relative = 1e-9);
}

/// Archard's volume is k W / mu for the energy W that friction dissipates.
#[test]
fn the_forecast_of_fretting_wear_goes_by_energy() {
    let expected = fretting(&["motion.fretting.cycles=7"]).forecast.fretting.unwrap();
    let wear = expected.wear.unwrap();
    let volume = 7.0 * 0.5e-13 * expected.dissipated / 0.6;
    assert_relative_eq!(wear.steady_volume, volume, max_relative = 1e-12);
    assert!(wear.final_radius > expected.stick_radius && wear.final_volume > volume);
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
    assert_relative_eq!(forecast.stick_ratio.unwrap(), 0.8, max_relative = 1e-3);
    assert_eq!(forecast.fretting, None);
}

/// One solve an increment, those of the first loading included; those that jumps compute by their length.
#[test]
fn the_forecast_counts_cycles_and_their_solves() {
    let counted = |options: &[&str]| {
        let forecast = fretting(options).forecast;
        (forecast.cycles.unwrap().computed, forecast.solves)
    };
    assert_eq!(counted(&[]), (Solves::Exactly(1), Solves::Exactly(40)));
    let ten = ["motion.fretting.cycles=10", "motion.fretting.increments=8"];
    assert_eq!(counted(&ten), (Solves::Exactly(10), Solves::Exactly(88)));
    // Measured with ten outputs: 620 solves in 21 cycles.
    let many = ["motion.fretting.cycles=200000", "motion.fretting.jump=10000"];
    assert_eq!(counted(&many), (Solves::Exactly(21), Solves::AtLeast(600)));
    // Measured with ten outputs: 33 cycles.
    let by_error = ["motion.fretting.cycles=200000", "motion.fretting.tolerance=0.01"];
    assert_eq!(counted(&by_error).0, Solves::About(32));
    // Lines without load are not solved.
    assert_eq!(counted(&[PATH]), (Solves::Exactly(1), Solves::Exactly(22)));
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

#[test]
fn the_body_written_first_is_body_one() {
    let (pin, rest) = PIN_ON_DISC.split_at(PIN_ON_DISC.find("[body.disc]").unwrap());
    let (disc, rest) = rest.split_at(rest.find("[frame]").unwrap());
    let names = case(&[rest, disc, pin].concat()).bodies.map(|body| body.name);
    assert_eq!(names, ["disc", "pin"]);
}

#[test]
fn units_change_no_bit() {
    let other = PIN_ON_DISC
        .replace("210 GPa", "2.1e5 N/mm^2")
        .replace("50 mm", "0.05m")
        .replace("1.33e-13 1/Pa", "1.33e-4 mm3/(N m)")
        .replace("\"1.2 mm\"", "\"1200 \u{b5}m\"")
        .replace("10.2 N", "0.0102 kN")
        .replace("500 mm", "0.5 m")
        .replace("5 mm", "5e3 um");
    assert_eq!(case(&other), case(PIN_ON_DISC));
}

#[test]
fn an_option_works_with_and_without_quotes() {
    let step = |option| match with(&[option]).build().unwrap().schedule.stepping {
        Stepping::Implicit(step) => step,
        other => panic!("{other:?}"),
    };
    for option in [
        "motion.sliding.step=\"10 mm\"",
        "motion.sliding.step='10 mm'",
        "motion.sliding.step=10 mm",
        "motion.sliding.step = 10mm ",
        "motion.\"sliding\".step=10 mm",
    ] {
        assert_eq!(step(option), 0.01, "{option}");
    }
}

#[test]
fn options_set_numbers_lists_and_tables() {
    assert_eq!(with(&["frame.elements=[60, 50]"]).frame.elements, [60, 50]);
    for size in ["frame.size=[\"2 mm\", \"1.5 mm\"]", "frame.size=[2 mm, 1.5 mm]"] {
        assert_eq!(with(&[size]).frame.size, [2e-3, 1.5e-3], "{size}");
    }
    for material in [
        "body.pin.material={young=\"70 GPa\", poisson=0.33}",
        "body.pin.material={young=70 GPa, poisson=0.33}",
    ] {
        let expected = Some(Material { young: 70e9, poisson: 0.33 });
        assert_eq!(with(&[material]).bodies[0].material, expected, "{material}");
    }
    assert_eq!(with(&["title=Wear of a pin"]).title.as_deref(), Some("Wear of a pin"));
    assert_eq!(with(&["body.disc.rigid=true", "body.disc.material="]).bodies[1].material, None);
}

#[test]
fn options_replace_and_remove() {
    let tolerance = Stepping::Tolerance(1e-3);
    for options in [
        &["motion.sliding.step=", "motion.sliding.tolerance=1e-3"][..],
        &["motion.sliding.tolerance=1e-3", "motion.sliding.step="],
        &["motion.sliding={load=\"10.2 N\", distance=\"500 mm\", tolerance=1e-3}"],
        &["motion={sliding={load=10.2 N, distance=500 mm, tolerance=1e-3}}"],
    ] {
        assert_eq!(with(options).build().unwrap().schedule.stepping, tolerance, "{options:?}");
    }
    let case = with(&["body.disc.profile={cylinder={radius=20 mm}}"]);
    assert_eq!(case.bodies[1].profile.choice.name, "cylinder");
    assert_eq!(
        with(&["motion.sliding.step=1 mm", "motion.sliding.step=2 mm"]),
        with(&["motion.sliding.step=2 mm"])
    );
}

#[test]
fn outputs_always_include_the_end() {
    let outputs = |option| with(&[option]).build().unwrap().schedule.outputs;
    assert_eq!(outputs("output.every=200 mm"), [0.2, 0.4, 0.5]);
    assert_eq!(outputs("output.at=[\"100 mm\", \"5 mm\"]"), [0.005, 0.1, 0.5]);
    assert_eq!(outputs("output.at=[500 mm]"), [0.5]);
}

#[test]
fn an_indentation_needs_no_wear_and_no_unit_for_outputs() {
    let resolved = resolve(
        &file(PIN_ON_DISC)
            .set("body.pin.wear=")
            .set("frame.elements=[60, 60]")
            .set("motion={indentation={approach=0.4 um, increments=4}}")
            .set("output.every=0.5"),
    );
    assert!(resolved.warnings.is_empty(), "{:?}", resolved.warnings);
    assert_eq!(resolved.forecast.solves, Solves::Exactly(4));
    assert_eq!(resolved.case.build().unwrap().schedule.outputs, [0.5, 1.0]);
}

#[test]
fn a_resolved_case_reads_back_to_the_same_bits() {
    let table = "body.pin.profile={table={file=\"bad_cases/tables/hollow.csv\"}}";
    for options in [
        &[][..],
        &["title=A \"quoted\" pin \\ disc"],
        &["body.pin.profile={power={coefficient=3e7 1/m^2.5, exponent=3.5}}"],
        &["body.pin.profile={paraboloid={radius_x=31.7 mm, radius_y=80 mm}}"],
        &["body.disc.profile={disc={radius=32.5 mm, crown=125 mm}}"],
        &["body.disc.rigid=true", "body.disc.material="],
        &["body.pin.wear={archard={k_ad=1.1e-4, hardness=2.7 GPa}}"],
        &["motion.sliding.step=", "motion.sliding.tolerance=1e-3", "output.at=[1 mm, 33.3 mm]"],
        &["motion.sliding.scheme=explicit", "motion.sliding.step=1 mm", "output.every=7 mm"],
        &["solver.uzawa={tolerance=1e-6, max_iterations=5000}"],
        &["motion={indentation={load=10.2 N, increments=3}}", "output.every=0.3"],
        &[table, "frame.size=[0.2 mm, 0.2 mm]"],
    ] {
        reads_back(&with(options));
    }
    for options in [
        &[][..],
        &["motion.rolling.revolutions=0", "motion.rolling.step="],
        &["motion.rolling.direction=-x", "motion.rolling.spin=-0.3 1/mm", "output.at=[1, 100]"],
        &["motion.rolling.creepage=", "motion.rolling.force=-90 N", "motion.rolling.radius=worn"],
        &["motion={creepage_sweep={approach=4 um, lateral_force=3 N, increments=7}}"],
        &["friction_solver.uzawa={tolerance=1e-4}", "friction="],
        &["friction_solver.projection_contraction={max_iterations=99}"],
    ] {
        let file = options.iter().fold(file(TWIN_DISCS), |file, option| file.set(*option));
        reads_back(&resolve(&file).case);
    }
    for options in [
        &[][..],
        &["motion.fretting.amplitude=[1.1 um, 0.3 um]", "motion.fretting.phase=33.3 deg"],
        &[
            "motion.fretting.amplitude=",
            "motion.fretting.force_amplitude=[7.7 N, 0.0011 kN]",
            "motion.fretting.load_amplitude=3.3 N",
            "motion.fretting.load_phase=-0.7 rad",
        ],
        &["motion.fretting.cycles=1000", "motion.fretting.jump=30", "output.at=[1, 500]"],
        &["motion.fretting.cycles=1000", "motion.fretting.tolerance=0.03", "output.every=100"],
        &["motion={fretting={approach=2.2 um, amplitude=[0 um, 1 um], increments=8}}"],
        &["body.flat.material.poisson=0.1", "motion={indentation={load=50 N, increments=3}}"],
        &[
            "body.flat.material.poisson=0.1",
            "motion={indentation={approach=2 um, cycles=90, release=rubbing, jump=3}}",
        ],
        &[PATH],
        &[PATH, "motion.path.cycles=30", "motion.path.increments=3", "motion.path.jump=4"],
    ] {
        reads_back(&fretting(options).case);
    }
}

/// Asserts that a case is the same once it was printed and read, wherever it lies.
fn reads_back(case: &Case) {
    let text = case.to_string();
    let again = CaseFile::from_text("case.toml", &*text, "/nowhere");
    assert_eq!(resolve(&again).case, *case, "{text}");
    assert_eq!(resolve(&again).case.to_string(), text);
}

proptest! {
    #[test]
    fn any_numbers_read_back_to_the_same_bits(
        young in 1e9..1e13f64,
        poisson in -0.99..0.49f64,
        radius in 1e-2..1.0f64,
        coefficient in 1e-20..1e-10f64,
        load in 1e-3..1.0f64,
    ) {
        let case = with(&[
            &format!("body.pin.material={{young={young:e} Pa, poisson={poisson:e}}}"),
            &format!("body.pin.profile.sphere.radius={radius} m"),
            &format!("body.pin.wear.archard.coefficient={coefficient:e} 1/Pa"),
            &format!("motion.sliding.load={load:e} N"),
        ]);
        let again = CaseFile::from_text("case.toml", case.to_string(), "");
        prop_assert_eq!(resolve(&again).case, case);
    }
}
