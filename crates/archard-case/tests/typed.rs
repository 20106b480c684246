//! A simulation put together from types is that of the case file that says the same.

mod common;

use archard::body::profile::{AxisymmetricPower, Cylinder, Disc, Flat, FlatEnd, Paraboloid};
use archard::body::profile::{Power, Sphere, Table};
use archard::body::{Body, Material};
use archard::frame::Direction;
use archard::friction::{Coulomb, Orthotropic};
use archard::motion::{Control, Cycles, Drive, Fretting, Indentation, Path, Planned};
use archard::motion::{Rolling, Sliding, Station, Stepping, Track};
use archard::simulation::Simulation;
use archard::solve::Settings;
use archard::wear::Archard;
use archard_case::CaseFile;
use common::{Rows, STEEL, case};

const PIN_ON_DISC: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/framed/pin_on_disc");

fn rows(simulation: &Simulation) -> Vec<(String, u64)> {
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).expect("a run to its end");
    let values = rows.0.into_iter().flatten();
    values.map(|(column, value)| (column, value.to_bits())).collect()
}

#[test]
fn a_typed_pin_on_disc_has_the_bits_of_the_case_file() {
    let resolved = CaseFile::read(PIN_ON_DISC.as_ref()).unwrap().resolve().expect("a sound case");
    let written = resolved.case.build().unwrap();
    let pin = Body::new("pin", Sphere::new(50e-3).unwrap());
    let pin = pin.material(STEEL).wear(Archard::new(1.33e-13).unwrap());
    let disc = Body::new("disc", Flat).material(STEEL);
    let sliding = Sliding::new().over(0.5, Control::Load(10.2), Stepping::Implicit(5e-3)).unwrap();
    let builder = Simulation::builder([pin, disc], sliding).frame([1.2e-3; 2], [30; 2]);
    let typed = builder.outputs((1..=10).map(|i| 0.05 * f64::from(i))).build().unwrap();
    assert_eq!(rows(&typed), rows(&written));
}

/// Motions as written and as typed.
#[test]
fn typed_motions_are_those_of_case_files() {
    let load = Control::Load(10.0);
    let motions: [(&str, Planned); 7] = [
        (
            "indentation = { load = \"10 N\", increments = 4, cycles = 9, jump = 3, release = \"rubbing\" }",
            Indentation::new(4)
                .cycles(Cycles::new(9).jump(3))
                .rubbing_on_release()
                .under(load)
                .unwrap(),
        ),
        (
            "fretting = { load = \"10 N\", amplitude = [\"1 um\", \"2 um\"], phase = \"0.5 rad\", load_amplitude = \"3 N\", load_phase = \"1 rad\", increments = 8, cycles = 5, tolerance = 0.01 }",
            Fretting::shifted([1e-6, 2e-6])
                .phase(0.5)
                .varying_load(3.0, 1.0)
                .increments(8)
                .cycles(Cycles::new(5).tolerance(0.01))
                .under(load)
                .unwrap(),
        ),
        (
            "fretting = { approach = \"1 um\", force_amplitude = [\"1 N\", \"0 N\"] }",
            Fretting::pushed([1.0, 0.0]).under(Control::Approach(1e-6)).unwrap(),
        ),
        (
            "sliding = { load = \"10 N\", distance = \"1 m\", step = \"0.25 m\", scheme = \"explicit\" }",
            Sliding::new().over(1.0, load, Stepping::Explicit(0.25)).unwrap(),
        ),
        (
            "sliding = { load = \"10 N\", distance = \"1 m\", stroke = \"5 mm\", passes = \"two\", direction = \"y\", speed = \"0.1 m/s\", tolerance = 0.1 }",
            Sliding::new()
                .along(Direction::Y)
                .on(Track::to_and_fro(1, 5e-3).unwrap())
                .at_speed(0.1)
                .over(1.0, load, Stepping::Tolerance(0.1))
                .unwrap(),
        ),
        (
            "rolling = { load = \"10 N\", creepage = 0.01, lateral_force = \"1 N\", spin = \"2 1/m\", direction = \"-y\", revolutions = 100, tolerance = 0.1, radius = \"worn\" }",
            Rolling::along(Direction::Y.back())
                .longitudinal(Drive::Slip(0.01))
                .lateral(Drive::Force(1.0))
                .spin(2.0)
                .with_worn_radius()
                .over(100.0, load, Stepping::Tolerance(0.1))
                .unwrap(),
        ),
        (
            "creepage_sweep = { load = \"10 N\", force = \"2 N\", increments = 5 }",
            Rolling::along(Direction::X).longitudinal(Drive::Force(2.0)).swept(5, load).unwrap(),
        ),
    ];
    for (written, (motion, mut schedule)) in motions {
        let text = format!(
            "body.one = {{ material = {{ young = \"210 GPa\", poisson = 0.3 }}, profile.sphere.radius = \"50 mm\" }}
             body.two = {{ rigid = true, profile.flat = {{}} }}
             frame = {{ size = [\"1 mm\", \"1 mm\"], elements = [4, 4] }}
             friction.coulomb.coefficient = 0.5
             motion.{written}"
        );
        let simulation = case(&text, &[]);
        assert_eq!(motion, simulation.problem.motion, "{written}");
        schedule.outputs.clone_from(&simulation.schedule.outputs);
        assert_eq!(schedule, simulation.schedule, "{written}");
    }
}

#[test]
fn a_path_holds_the_bodies_in_between() {
    let station = |load, shift| {
        Station::pressed(Control::Load(load)).guided([Drive::Slip(shift), Drive::Force(0.0)])
    };
    let path = Path::new(&[(0.0, station(0.0, 0.0)), (2.0, station(4.0, 1e-6))]).unwrap();
    let (motion, schedule) = path.increments(2).cycles(Cycles::new(3)).plan().unwrap();
    assert_eq!(motion.increments().unwrap().cycle, [station(2.0, 0.5e-6), station(4.0, 1e-6)]);
    assert_eq!((schedule.extent, schedule.control), (6.0, Control::Load(4.0)));
    let mixed = [(0.0, station(0.0, 0.0)), (1.0, Station::pressed(Control::Approach(1e-6)))];
    assert!(Path::new(&mixed).unwrap_err().message.contains("the same"));
}

#[test]
fn parts_that_are_none_are_named() {
    let named = |error: Option<archard::parameters::Invalid>, parameter: &str| {
        assert_eq!(error.expect(parameter).parameter, parameter);
    };
    // A hollow has a negative radius.
    for radius in [0.0, f64::NAN, f64::INFINITY, 1e-20] {
        named(Sphere::new(radius).err(), "radius");
        named(Cylinder::along_x(radius).err(), "radius");
        named(Cylinder::along_y(radius).err(), "radius");
        named(FlatEnd::new(radius).err(), "radius");
        named(FlatEnd::new(-1.0).err(), "radius");
        named(Disc::new(radius).err(), "radius");
        named(Disc::crowned(1.0, radius).err(), "crown");
    }
    named(Paraboloid::new([1.0, 0.0]).err(), "radius_y");
    named(Power::new(0.0, 2.0).err(), "coefficient");
    named(AxisymmetricPower::new(1.0, -1.0).err(), "exponent");
    named(Table::new(&[0.0, 1.0], &[0.0], &[0.0; 2]).err(), "file");
    named(Table::new(&[0.0, 1.0], &[0.0; 2], &[0.0, f64::NAN]).err(), "file");
    named(Material::new(-1.0, 0.3).err(), "young");
    named(Material::new(1.0, 0.6).err(), "poisson");
    named(Archard::new(-1.0).err(), "coefficient");
    named(Archard::with_hardness(1e-4, 0.0).err(), "hardness");
    named(Coulomb::new(f64::NAN).err(), "coefficient");
    named(Orthotropic::new([0.1, 0.0], 0.0).err(), "coefficients");
    named(Orthotropic::new([0.1, 20.0], 0.0).err(), "coefficients");
    named(Orthotropic::new([0.1, 0.2], f64::NAN).err(), "angle");
    named(Track::around(0, 0.0).err(), "track_radius");
    named(Track::to_and_fro(2, 1.0).err(), "passes");
    named(Settings::new(2.0, 1).err(), "tolerance");
    named(Settings::new(0.1, 0).err(), "max_iterations");
    let (load, step) = (Control::Load(1.0), Stepping::Implicit(0.1));
    named(Sliding::new().over(0.0, load, step).err(), "distance");
    named(Sliding::new().over(1.0, Control::Approach(-1.0), step).err(), "approach");
    named(Sliding::new().over(0.01, load, step).err(), "step");
    named(Sliding::new().over(1.0, load, Stepping::Jumps(2)).err(), "step");
    let rolling = Rolling::along(Direction::X);
    named(rolling.over(1.0, load, Stepping::Explicit(0.1)).err(), "step");
    named(rolling.spin(f64::NAN).swept(1, load).err(), "spin");
    named(rolling.swept(0, load).err(), "increments");
    named(Indentation::new(0).under(load).err(), "increments");
    named(Indentation::new(1).cycles(Cycles::new(2).jump(0)).under(load).err(), "jump");
    named(Fretting::shifted([f64::NAN, 0.0]).under(load).err(), "amplitude");
    named(
        Fretting::pushed([1.0, 0.0]).varying_load(f64::NAN, 0.0).under(load).err(),
        "load_amplitude",
    );
}

#[test]
fn bodies_that_do_not_fit_are_named() {
    let sphere = |name: &str| Body::new(name, Sphere::new(50e-3).unwrap());
    let steel = |name: &str| sphere(name).material(STEEL);
    let sliding = || Sliding::new().over(1.0, Control::Load(1.0), Stepping::Implicit(0.1)).unwrap();
    let size = [1e-3; 2];
    let error = |bodies: [Body; 2], size: Option<[f64; 2]>| {
        let builder = Simulation::builder(bodies, sliding());
        let builder = size.iter().fold(builder, |builder, &size| builder.frame(size, [8; 2]));
        builder.build().expect_err("parts that do not fit").to_string()
    };
    let says = |message: String, part: &str| assert!(message.contains(part), "{message}");
    says(error([steel("one"), steel("two")], None), "`frame`: ");
    says(error([steel("one"), steel("one")], Some(size)), "same name");
    says(error([steel("one"), steel("a b")], Some(size)), "`a b`");
    says(error([sphere("one"), sphere("two")], Some(size)), "both bodies are rigid");
    says(error([steel("one"), steel("two")], Some([0.0; 2])), "`size`: must be greater than zero");
    says(error([steel("one"), steel("two")], Some([1.0; 2])), "does not reach");
}
