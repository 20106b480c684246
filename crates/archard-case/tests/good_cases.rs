//! Right cases: what they mean, whatever way they are written.

mod common;
mod framed;

mod good_cases {
    mod curvatures;
    mod estimate;
    mod expression;
    mod extremes;
    mod files;
    pub mod fretting;
    mod laws;
    mod materials;
    mod meshed;
    pub mod rolling;
    mod stress;
}

use std::path::Path;

use approx::assert_relative_eq;
use archard::body::Material;
use archard::motion::{Control, Stepping};
use archard_case::{Case, CaseFile, Output, RunnableCase, Solves};
use proptest::prelude::*;

use good_cases::fretting::{self, PATH, fretting};
use good_cases::rolling::TWIN_DISCS;

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

fn resolve(file: &CaseFile) -> RunnableCase {
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

/// How the first body deforms.
fn elasticity(case: &Case) -> Option<Material> {
    case.bodies[0].material.as_ref().map(|material| material.elastic)
}

/// Bodies that keep their volume are those of Hertz; the cube without them is refused.
#[test]
fn incompressible_half_spaces_are_taken() {
    let half = "material={young=\"100 GPa\",poisson=0.5}";
    let case = with(&[&format!("body.pin.{half}"), "body.pin.wear="]);
    assert_eq!(elasticity(&case), Some(Material { young: 1e11, poisson: 0.5 }));
    case.build().unwrap();
}

/// A shorter motion leaves out the outputs beyond its end.
#[test]
fn outputs_beyond_the_end_are_left_out() {
    let options = ["output.at=[10 mm, 20 mm, 400 mm]", "motion.sliding.distance=100 mm"];
    let file = options.iter().fold(file(PIN_ON_DISC), |file, option| file.set(*option));
    let resolved = resolve(&file);
    assert_eq!(resolved.case.output, Output::At(vec![0.01, 0.02]));
    let said = |text| resolved.warnings.iter().any(|one| one.message.contains(text));
    assert!(said("lies beyond the end of the motion"), "{:?}", resolved.warnings);
}

/// A slope has no unit.
#[test]
fn cones_read_back_to_the_same_bits() {
    reads_back(&with(&[
        "body.pin.profile={axisymmetric_power={coefficient=0.02,exponent=1}}",
        "frame.size=[\"0.3 mm\",\"0.3 mm\"]",
    ]));
}

/// The size of elements is enough: the frame lies around the contact. Where its size is given too, no element is larger.
#[test]
fn elements_are_told_by_their_size() {
    let none = ["frame.size=", "frame.elements="];
    let with = |more: &[&str]| with(&[&none[..], more].concat()).frame;
    let one = with(&["frame.element=20 um"]);
    assert!(one.size[0] > 0.9e-3, "{one:?}");
    assert!(one.spacing().iter().all(|&size| size <= 20e-6 && size > 19e-6), "{one:?}");
    let two =
        with(&["frame.element=[\"20 um\", \"40 um\"]", "frame.size=[\"1.2 mm\", \"1.2 mm\"]"]);
    assert_eq!((two.size, two.elements), ([1.2e-3; 2], [60, 30]));
    let odd = with(&["frame.element=\"35 um\"", "frame.size=[\"1.2 mm\", \"1.2 mm\"]"]);
    assert_eq!(odd.elements, [35, 35]);
    let line = [
        "frame.element=2 um",
        "frame.plane_strain=true",
        "body.pin.profile={cylinder={radius=\"50 mm\",axis=\"y\"}}",
        "motion.sliding.load=100 N/mm",
    ];
    let line = with(&line);
    assert!(line.line && line.size[0] > 0.0 && line.spacing()[0] <= 2e-6, "{line:?}");
}

#[test]
fn the_pin_on_disc_in_si() {
    let case = case(PIN_ON_DISC);
    assert_eq!(case.bodies.each_ref().map(|body| &body.name[..]), ["pin", "disc"]);
    assert_eq!(elasticity(&case), Some(Material { young: 210e9, poisson: 0.3 }));
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
    let contact = forecast.estimate.contact.unwrap();
    // Independent values: the sphere of 50 mm under 10.2 N after Hertz, and eq. 55 at 500 mm.
    assert_relative_eq!(contact.semi_axes[0], 0.1491058e-3, max_relative = 1e-6);
    assert_relative_eq!(contact.peak_pressure, 219.0547e6, max_relative = 1e-6);
    assert_relative_eq!(contact.approach.unwrap(), 0.44465074e-6, max_relative = 1e-6);
    assert_relative_eq!(forecast.estimate.cap.unwrap().depth, 2.078040e-6, max_relative = 1e-6);
    assert_eq!(forecast.solves, Solves::Exactly(101));
}

/// A ball of bearing steel of 746 HV yields from 1.6128 times its yield stress on, .4809 of the radius deep that the contact has then
/// (Johnson, *Contact Mechanics*, section 4.1); of the disc no hardness is known. A line of contact is in plane strain: 1.7937, and
/// .7043. A hardness that is given counts before that of the material.
#[test]
fn first_yield_of_what_has_a_hardness_is_foreseen() {
    let of = |options: &[&str], hardness: f64, factor: f64, deep: f64| {
        let strength = hardness / 2.8;
        let file = file(PIN_ON_DISC).set("body.pin.material=\"100Cr6\"");
        let file = options.iter().fold(file, |file, option| file.set(*option));
        let forecast = resolve(&file).forecast;
        let [found] = &forecast.yieldings[..] else { panic!("{:?}", forecast.yieldings) };
        assert_eq!(found.body, "pin");
        assert_relative_eq!(found.peak_pressure, factor * strength, max_relative = 1e-4);
        let contact = forecast.estimate.contact.unwrap();
        let radius = contact.semi_axes[0] * found.peak_pressure / contact.peak_pressure;
        assert_relative_eq!(found.depth, deep * radius, max_relative = 1e-3);
        assert!(found.to_string().contains("without friction"), "{found}");
    };
    let hard = 746.0 * 9.806_65e6;
    of(&[], hard, 1.61280, 0.48086);
    of(&["body.pin.wear.archard.hardness=\"3 GPa\""], 3e9, 1.61280, 0.48086);
    let line = [
        "frame.size=",
        "frame.elements=",
        "frame.element=2 um",
        "frame.plane_strain=true",
        "body.pin.profile={cylinder={radius=\"50 mm\",axis=\"y\"}}",
        "motion.sliding.load=100 N/mm",
    ];
    of(&line, hard, 1.79367, 0.70429);
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
        assert_eq!(elasticity(&with(&[material])), expected, "{material}");
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
        &["body.pin.density=7.85 g/cm^3"],
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

/// Elements that are too large for the texture of a surface are told, with what they miss of its slope; those of the shortest wave,
/// and those of a smooth surface, are not.
#[test]
fn elements_that_miss_texture_are_told() {
    let warnings = |set: &[&str]| {
        let file = include_str!("../../../cases/rough_on_flat/case.toml");
        let file =
            set.iter().fold(CaseFile::from_text("case", file, "."), |file, one| file.set(*one));
        let warnings = resolve(&file).warnings;
        warnings.iter().filter(|one| one.message.contains("finer texture")).count()
    };
    assert_eq!(warnings(&[]), 0);
    let coarse = ["frame.size=[0.512 mm, 0.512 mm]", "frame.elements=[64, 64]"];
    assert_eq!(warnings(&coarse), 2);
    let smooth = "body.ground.profile.self_affine.short=0.12 mm";
    assert_eq!(warnings(&[coarse[0], coarse[1], smooth]), 0);
}
