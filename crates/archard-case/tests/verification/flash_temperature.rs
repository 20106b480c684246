//! Flash temperatures of bodies that slide on a track and that roll, against closed forms; laws that go by them.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use archard::body::profile::{Flat, Sphere};
use archard::body::{Body, Material, Thermal};
use archard::closed_form::flash_temperature::semi_ellipsoid;
use archard::frame::Direction;
use archard::friction::Coulomb;
use archard::motion::{Control, Drive, Rolling, Sliding, Stepping, Track};
use archard::simulation::refusal::Part;
use archard::simulation::{Error, Refusals, Simulation};
use archard::wear::{Archard, Expression, Over, Per, Table, WearLaw};

use crate::common::{Rows, case, peak, states};

/// Effusivity of steel, 50 W/(m K) and 13 mm^2/s.
fn effusivity() -> f64 {
    50.0 / 13e-6f64.sqrt()
}

fn steel() -> Thermal {
    Thermal::new(50.0, 13e-6).unwrap().at(293.15).unwrap()
}

/// A ball of 20 mm under 50 N and a flat; body 1 or body 2 is the ball.
fn ball_and_flat(ball: usize, thermal: [Option<Thermal>; 2]) -> [Body; 2] {
    let material = Material::new(210e9, 0.3).unwrap();
    [0, 1].map(|body| {
        let one = if body == ball {
            Body::new("ball", Sphere::new(0.02).unwrap())
        } else {
            Body::new("flat", Flat)
        };
        let one = one.material(material);
        match thermal[body] {
            Some(thermal) => one.thermal(thermal),
            None => one,
        }
    })
}

/// Hertz: radius (m) and largest pressure (Pa) of that ball.
fn hertz() -> (f64, f64) {
    let modulus = 0.5 * 210e9 / (1.0 - 0.09);
    let radius = f64::cbrt(0.75 * 50.0 * 0.02 / modulus);
    (radius, 1.5 * 50.0 / (PI * radius * radius))
}

/// The flat passes below the ball: 1.235 and 0.676 mu p0 v sqrt(a) / (e sqrt(v)), hottest behind the middle the way it
/// moves; along both axes, and whichever body it is.
#[test]
fn a_track_is_as_warm_as_below_hertz_pressures() {
    let (radius, pressure) = hertz();
    let speed = 5.0;
    let scale = 0.3 * pressure * speed * radius.sqrt() / (effusivity() * speed.sqrt());
    for (ball, axis) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let flat = 1 - ball;
        let mut thermal = [None, None];
        thermal[flat] = Some(steel().with_share(1.0).unwrap());
        let sliding = Sliding::new()
            .along(Direction { axis, reversed: false })
            .on(Track::around(flat, 0.03).unwrap())
            .at_speed(speed);
        let planned = sliding.over(1e-3, Control::Load(50.0), Stepping::Implicit(1e-3)).unwrap();
        let simulation = Simulation::builder(ball_and_flat(ball, thermal), planned)
            .frame([0.8e-3; 2], [80; 2])
            .friction(Coulomb::new(0.3).unwrap())
            .build()
            .unwrap();
        let mut rows = Rows::default();
        simulation.run(&mut [&mut rows]).unwrap();
        let [largest, mean] = semi_ellipsoid(0.0).map(|factor| factor * scale);
        // 37 elements across the contact, which counts as whole elements.
        let found = rows.last("flash_temperature_K");
        assert_relative_eq!(found, largest, max_relative = 5e-3);
        assert_relative_eq!(rows.last("mean_flash_temperature_K"), mean, max_relative = 0.015);
        let state = states(&simulation).unwrap().pop().unwrap().0;
        let flash = simulation.problem.flash(&state).unwrap();
        let hottest = (0..flash.rise.len()).find(|&pair| flash.rise[pair] == found).unwrap();
        // Body 2 slides along the axis over body 1.
        let way = if flat == 1 { 1.0 } else { -1.0 };
        let place = way * simulation.problem.frame.place(hottest)[axis] / radius;
        assert!((place - 0.652).abs() < 0.06, "{place}");
        let peclet = 5.0 * radius / 26e-6;
        assert_relative_eq!(flash.peclet.unwrap(), peclet, max_relative = 0.02);
    }
}

/// Cylinders of 20 mm on a line of 10 mm under 5 kN.
const ROLLERS: &str = r#"
    [body.one]
    material = { young = "210 GPa", poisson = 0.3 }
    profile.cylinder = { radius = "20 mm" }
    thermal = { conductivity = "50 W/(m K)", diffusivity = "13 mm^2/s" }
    [body.two]
    material = { young = "210 GPa", poisson = 0.3 }
    profile.cylinder = { radius = "20 mm" }
    thermal = { conductivity = "50 W/(m K)", diffusivity = "13 mm^2/s" }
    [frame]
    plane_strain = true
    length = "10 mm"
    size = "0.6 mm"
    elements = 300
    [friction.coulomb]
    coefficient = 0.3
    [motion.rolling]
    load = "5 kN"
    creepage = 0.02
    speed = "5 m/s"
    revolutions = 0
"#;

/// Rollers that slip all over: the heat is mu p V (xi - (mu / R) x), since their tractions strain the surfaces by
/// (mu / R) x; its integral along the contact by thin bands, shared by halves.
#[test]
fn rollers_are_as_warm_as_the_integral_of_their_heat() {
    let modulus = 0.5 * 210e9 / (1.0 - 0.09);
    let radius = 0.01;
    let half = (4.0 * 5e5 * radius / (PI * modulus)).sqrt();
    let pressure = 2.0 * 5e5 / (PI * half);
    let heat = |x: f64| {
        let p = pressure * (1.0 - (x / half).powi(2)).max(0.0).sqrt();
        0.3 * p * 5.0 * (0.02 - 0.3 / radius * x)
    };
    // Behind the leading edge at x = a.
    let bands = 4000;
    let edge = |i: i32| half - 2.0 * half * f64::from(i) / f64::from(bands);
    let speeds = [1.01f64, 0.99].map(|one| (5.0 * one).sqrt());
    let rise = |x: f64| {
        let band = |i: i32| {
            let (front, back) = (edge(i), edge(i + 1).max(x));
            if front <= x {
                0.0
            } else {
                2.0 * heat(0.5 * (front + back)) * ((front - x).sqrt() - (back - x).sqrt())
            }
        };
        (0..bands).map(band).sum::<f64>() / PI.sqrt() / (effusivity() * (speeds[0] + speeds[1]))
    };
    let places = || (0..400).map(|i| half * ((f64::from(i) + 0.5) / 200.0 - 1.0));
    let rises: Vec<f64> = places().map(rise).collect();
    for reversed in ["x", "-x"] {
        let mut rows = Rows::default();
        let simulation = case(ROLLERS, &[&format!("motion.rolling.direction={reversed}")]);
        simulation.run(&mut [&mut rows]).unwrap();
        let found = rows.last("flash_temperature_K");
        assert_relative_eq!(found, peak(&rises), max_relative = 3e-3);
        let mean = rises.iter().sum::<f64>() / 400.0;
        assert_relative_eq!(rows.last("mean_flash_temperature_K"), mean, max_relative = 5e-3);
        let state = states(&simulation).unwrap().pop().unwrap().0;
        let flash = simulation.problem.flash(&state).unwrap();
        for (pair, found) in flash.rise.iter().enumerate() {
            let x = simulation.problem.frame.place(pair)[0];
            let x = if reversed == "x" { x } else { -x };
            if x.abs() < 0.95 * half {
                assert_relative_eq!(*found, rise(x), epsilon = 5e-3 * peak(&rises));
            }
        }
    }
}

/// Where all sticks nothing is warmed; where part of it does, the heat of the slip is the power of the creepage: far behind
/// the contact the rise is that of a line of it.
#[test]
fn the_heat_is_the_power_of_the_creepage() {
    let wide = ["frame.size=6 mm", "frame.elements=1000", "motion.rolling.creepage=0.003"];
    let simulation = case(ROLLERS, &wide);
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).unwrap();
    assert!(rows.last("stick_area_m2") > 1e-6);
    let power = 5.0 * rows.last("frictional_power_per_speed_N") / 0.01;
    let state = states(&simulation).unwrap().pop().unwrap().0;
    let flash = simulation.problem.flash(&state).unwrap();
    let place = simulation.problem.frame.place(0)[0];
    // The middle of the heat lies behind that of the contact, by about half of its half length.
    let far = |behind: f64| power / (2.0 * effusivity() * (PI * 5.0 * behind).sqrt());
    let expected = far(-place - 0.12e-3);
    assert_relative_eq!(flash.rise[0], expected, max_relative = 0.01);
    let rolls_free = case(ROLLERS, &["motion.rolling.creepage=0"]);
    let mut rows = Rows::default();
    rolls_free.run(&mut [&mut rows]).unwrap();
    assert!(rows.last("flash_temperature_K") < 1e-6);
}

/// k = k0 (1 + b (T - T0)) up to 900 K, as a table and as a formula.
fn laws() -> [Box<dyn WearLaw>; 2] {
    let formula = "k*(1 + b*(min(temperature, t1) - t0))*p*s";
    let constants = [("k", "1e-20 1/Pa"), ("b", "0.002 1/K"), ("t0", "290 K"), ("t1", "900 K")];
    let table = Table::new(Over::Temperature, &[290.0, 900.0], &[1e-20, 2.22e-20]).unwrap();
    [Box::new(table), Box::new(Expression::new(formula, &constants, Per::Increment).unwrap())]
}

/// Worn depths of body 1 and body 2 (m), and the simulation with its last state.
fn worn(motion: &str, law: Option<Box<dyn WearLaw>>) -> ([Vec<f64>; 2], Simulation) {
    let thermal = match motion {
        "rolls" => [Some(steel()), Some(steel())],
        _ => [None, Some(steel().with_share(0.7).unwrap())],
    };
    let worn = usize::from(motion != "stays");
    let mut bodies = ball_and_flat(0, thermal);
    bodies[worn].wear = Some(law.unwrap_or_else(|| Box::new(Archard::new(1e-20).unwrap())).into());
    let planned = match motion {
        "rolls" => Rolling::along(Direction::X).longitudinal(Drive::Slip(1.0)).at_speed(5.0).over(
            30.0,
            Control::Load(50.0),
            Stepping::Implicit(10.0),
        ),
        _ => Sliding::new().on(Track::around(1, 0.03).unwrap()).at_speed(5.0).over(
            3.0,
            Control::Load(50.0),
            Stepping::Implicit(1.0),
        ),
    };
    let simulation = Simulation::builder(bodies, planned.unwrap())
        .frame([0.6e-3; 2], [24; 2])
        .friction(Coulomb::new(0.3).unwrap())
        .build()
        .unwrap();
    let state = states(&simulation).unwrap().pop().unwrap().0;
    ([0, 1].map(|body| state.worn(body).into_owned()), simulation)
}

/// The pin, the disc and a roller wear by k at the temperature of the surfaces; on a disc and in rolling summed along the
/// line, where Archard's law sums p s.
#[test]
fn wear_goes_by_the_temperature() {
    for motion in ["stays", "passes", "rolls"] {
        let body = usize::from(motion != "stays");
        let (archard, simulation) = worn(motion, None);
        let [table, formula] = laws().map(|law| worn(motion, Some(law)).0);
        let state = states(&simulation).unwrap().pop().unwrap().0;
        let problem = &simulation.problem;
        let flash = problem.flash(&state).unwrap();
        assert!(peak(&flash.rise) > 200.0, "{}", peak(&flash.rise));
        let k = |rise: f64| 1.0 + 0.002 * ((293.15 + rise).min(900.0) - 290.0);
        let flow = problem.frame.flow(Direction::X).unwrap();
        let expected: Vec<f64> = if body == 0 {
            archard[0].iter().zip(&flash.rise).map(|(depth, rise)| k(*rise) * depth).collect()
        } else {
            let rolls = motion == "rolls";
            let on_the_way =
                |field: &[f64]| if rolls { flow.on_the_way(field) } else { field.to_vec() };
            let (pressure, rise) = (on_the_way(&state.pressure), on_the_way(&flash.rise));
            let slip =
                |pair: usize| state.tangential.as_ref().map_or(1.0, |own| own.slip[0][pair].abs());
            let mut expected = vec![0.0; pressure.len()];
            for line in flow.lines().iter() {
                let pairs = || line.passages.iter().map(|one| one.pair);
                let all: f64 = pairs().map(|pair| pressure[pair] * slip(pair)).sum();
                let warm: f64 =
                    pairs().map(|pair| k(rise[pair]) * pressure[pair] * slip(pair)).sum();
                for pair in pairs().filter(|_| all > 0.0) {
                    expected[pair] = archard[1][pair] * warm / all;
                }
            }
            expected
        };
        let most = peak(&expected);
        // Spheres that roll have lateral slip, too, which turns their friction a little.
        // What slides wears 2e-5 of its approach, which changes the pressures by as much.
        let within = if motion == "rolls" { 1e-3 } else { 1e-4 };
        for pair in 0..expected.len() {
            assert_relative_eq!(table[body][pair], expected[pair], epsilon = within * most);
            assert_relative_eq!(formula[body][pair], expected[pair], epsilon = within * most);
        }
    }
}

/// In rolling at a known speed laws may go by the speed of slip: V times the creepage.
#[test]
fn rolling_tells_the_speed_of_slip() {
    let [one, other] = [0.5, 5.0].map(|v0| {
        let constants = [("k", "1e-20 1/Pa"), ("v0", &*format!("{v0} m/s"))];
        let law = Expression::new("k*p*s*(v/v0)", &constants, Per::Increment).unwrap();
        worn("rolls", Some(Box::new(law))).0
    });
    let (archard, _) = worn("rolls", None);
    for pair in 0..archard[1].len() {
        // A creepage of one at 5 m/s, less what is elastic.
        let most = peak(&archard[1]);
        assert_relative_eq!(other[1][pair], archard[1][pair], epsilon = 0.02 * most);
        assert_relative_eq!(one[1][pair], 10.0 * other[1][pair], epsilon = 1e-5 * most);
    }
}

/// A law that depends on the temperature stops where it is not known: by the engine, too, which `check` does not ask.
#[test]
fn laws_stop_where_the_temperature_is_not_known() {
    let built = |thermal: Option<Thermal>, speed: f64, friction: bool| {
        let [table, _] = laws();
        let mut bodies = ball_and_flat(0, [None, thermal]);
        bodies[0].wear = Some(table.into());
        let sliding = Sliding::new().on(Track::around(1, 0.03).unwrap()).at_speed(speed);
        let planned = sliding.over(3.0, Control::Load(50.0), Stepping::Implicit(1.0)).unwrap();
        let builder = Simulation::builder(bodies, planned).frame([0.6e-3; 2], [12; 2]);
        let builder = if friction { builder.friction(Coulomb::new(0.3).unwrap()) } else { builder };
        builder.build()
    };
    let refused = |thermal, friction| {
        let Refusals(all) = built(thermal, 5.0, friction).unwrap_err();
        all.into_iter().map(|one| one.part).collect::<Vec<_>>()
    };
    let warm = Some(steel().with_share(0.7).unwrap());
    let cold = Some(Thermal::new(50.0, 13e-6).unwrap().with_share(0.7).unwrap());
    assert_eq!(refused(None, true), [Part::Wear("ball".into())]);
    assert_eq!(refused(cold, true), [Part::Wear("ball".into())]);
    assert_eq!(refused(warm, false), [Part::Wear("ball".into())]);
    // V a / (2 chi) of a = 0.187 mm.
    let slow = built(warm, 0.5, true).unwrap().run(&mut []).unwrap_err();
    let Error::TooSlow { peclet, .. } = slow else { panic!("too slow") };
    assert_relative_eq!(peclet, 0.5 * 0.187e-3 / 26e-6, max_relative = 0.1);
}
