//! Friction that depends on the speed, the distance slid and the temperature.

use approx::assert_relative_eq;
use archard::friction::{Circumstance, Coulomb, Friction, Table};
use archard::simulation::Simulation;

use crate::common::{Rows, case, peak, states};

const STEEL: &str = "material = { young = \"210 GPa\", poisson = 0.3 }";

/// A ball of 20 mm on a flat under 50 N; the flat, with what is said of it, and a motion.
fn ball(flat: &str, motion: &str, options: &[&str]) -> Simulation {
    let text = format!(
        r#"
        [body.ball]
        {STEEL}
        profile.sphere = {{ radius = "20 mm" }}
        wear.energy = {{ coefficient = "1e-9 mm^3/J" }}
        [body.flat]
        {flat}
        profile.flat = {{}}
        [frame]
        size = ["0.8 mm", "0.8 mm"]
        elements = [32, 32]
        [friction.coulomb]
        coefficient = 0.3
        {motion}
        "#
    );
    case(&text, options)
}

const SLIDES: &str =
    "[motion.sliding]\nload = \"50 N\"\ndistance = \"1 m\"\nstep = \"100 mm\"\nspeed = \"2 m/s\"";
const ON_A_TRACK: &str = "[motion.sliding]\nload = \"50 N\"\ndistance = \"1 m\"\nstep = \"100 mm\"\nspeed = \"2 m/s\"\ntrack_radius = \"30 mm\"\npasses = \"flat\"";
const ROLLS: &str = "[motion.rolling]\nload = \"50 N\"\nrevolutions = 3\nstep = 1\ncreepage = 0.002\nspeed = \"2 m/s\"";
const FRETS: &str = "[motion.fretting]\nload = \"50 N\"\namplitude = [\"5 um\", \"1 um\"]\nincrements = 12\ncycles = 3";
const WARM: &str = "thermal = { conductivity = \"50 W/(m K)\", diffusivity = \"13 mm^2/s\", temperature = \"20 degC\" }";

fn table(over: Circumstance, places: [f64; 2], coefficients: [f64; 2]) -> Box<dyn Friction> {
    Box::new(Table::over(over, &places, &coefficients).unwrap())
}

/// The same with another law of friction.
fn with(mut simulation: Simulation, law: Box<dyn Friction>) -> Simulation {
    simulation.problem.friction = Some(law.into());
    simulation
}

/// Wherever a table holds the same coefficient everywhere it is Coulomb's law: worn depths and tractions, between like
/// bodies, unlike ones and ones that swing.
#[test]
fn a_constant_table_is_coulombs_law() {
    use Circumstance::{Distance, Speed, Temperature};
    let share = format!("{STEEL}\n{}", WARM.replace(" }", ", share = 0.5 }"));
    let cases: &[(&str, &str, &[Circumstance])] = &[
        (STEEL, SLIDES, &[Speed, Distance]),
        (&share, ON_A_TRACK, &[Speed, Distance, Temperature]),
        (STEEL, ROLLS, &[Speed, Distance]),
        ("rigid = true", ROLLS, &[Speed, Distance]),
        (STEEL, FRETS, &[Distance]),
        ("rigid = true", FRETS, &[Distance]),
    ];
    for &(flat, motion, over) in cases {
        let coulomb = states(&ball(flat, motion, &[])).unwrap();
        let (coulomb, ..) = coulomb.last().unwrap();
        for &over in over {
            let law = table(over, [1e-3, 1e3], [0.3, 0.3]);
            let found = states(&with(ball(flat, motion, &[]), law)).unwrap();
            let (found, ..) = found.last().unwrap();
            let deepest = peak(&coulomb.worn(0));
            for (found, expected) in found.worn(0).iter().zip(coulomb.worn(0).iter()) {
                assert_relative_eq!(found, expected, epsilon = 1e-9 * deepest);
            }
            let [found, expected] = [found, coulomb].map(|state| &state.tangential);
            assert_eq!(found.is_some(), expected.is_some());
            let (Some(found), Some(expected)) = (found, expected) else { continue };
            for (found, expected) in found.traction[0].iter().zip(&expected.traction[0]) {
                assert_relative_eq!(found, expected, epsilon = 1e-9 * 0.3e9);
            }
        }
    }
}

/// alpha mu(v) F s, with mu between two points of a table.
#[test]
fn sliding_goes_by_its_speed() {
    for motion in [SLIDES, ON_A_TRACK] {
        let law = table(Circumstance::Speed, [1.0, 5.0], [0.5, 0.1]);
        let mut rows = Rows::default();
        with(ball(STEEL, motion, &[]), law).run(&mut [&mut rows]).unwrap();
        assert_relative_eq!(
            rows.last("worn_volume_ball_m3"),
            1e-18 * 0.4 * 50.0,
            max_relative = 1e-9
        );
    }
}

/// alpha F times the integral of mu over the distance, which falls from 0.5 to 0.2 over two thirds of the way: whatever the
/// steps, on the spot and on a track, of steps by their error too.
#[test]
fn friction_runs_in() {
    let integral = 0.5 * (0.5 + 0.2) * 0.7 + 0.2 * 0.3;
    for motion in [SLIDES, ON_A_TRACK] {
        for options in [
            &[][..],
            &["motion.sliding.step=50 mm"],
            &["motion.sliding.step=", "motion.sliding.tolerance=0.001"],
        ] {
            let law = table(Circumstance::Distance, [0.0, 0.7], [0.5, 0.2]);
            let mut rows = Rows::default();
            with(ball(STEEL, motion, options), law).run(&mut [&mut rows]).unwrap();
            // The bound of the table lies within a step; the scar hardly grows.
            assert_relative_eq!(
                rows.last("worn_volume_ball_m3"),
                1e-18 * 50.0 * integral,
                max_relative = 2e-3
            );
        }
    }
}

/// The share of the distance is that of the pin, whichever body wears.
#[test]
fn the_longer_distance_counts() {
    let text = ["body.ball.wear=", "body.flat.wear.energy.coefficient=1e-9 mm^3/J"];
    let law = || table(Circumstance::Distance, [0.0, 1.0], [0.5, 0.2]);
    let mut rows = Rows::default();
    with(ball(STEEL, ON_A_TRACK, &text), law()).run(&mut [&mut rows]).unwrap();
    assert_relative_eq!(rows.last("worn_volume_flat_m3"), 1e-18 * 50.0 * 0.35, max_relative = 1e-6);
}

/// Cylinders of 20 mm on a line of 10 mm under 5 kN; the flat passes at 5 m/s.
const LINE: &str = r#"
    [body.one]
    material = { young = "210 GPa", poisson = 0.3 }
    profile.cylinder = { radius = "20 mm" }
    [body.two]
    material = { young = "210 GPa", poisson = 0.3 }
    profile.cylinder = { radius = "20 mm" }
    thermal = { conductivity = "50 W/(m K)", diffusivity = "13 mm^2/s", temperature = "20 degC", share = 1 }
    [frame]
    plane_strain = true
    length = "10 mm"
    size = "0.6 mm"
    elements = 300
    [friction.coulomb]
    coefficient = 0.3
    [motion.sliding]
    load = "5 kN"
    distance = "1 mm"
    step = "1 mm"
    speed = "5 m/s"
    track_radius = "30 mm"
    passes = "two"
"#;

/// Hertz's pressure on that line, at x of its half length, and both: (Pa, m).
fn hertz() -> (impl Fn(f64) -> f64, f64) {
    let modulus = 0.5 * 210e9 / (1.0 - 0.09);
    let half = (4.0 * 5e5 * 0.01 / (std::f64::consts::PI * modulus)).sqrt();
    let most = 2.0 * 5e5 / (std::f64::consts::PI * half);
    (move |x: f64| most * (1.0 - (x / half).powi(2)).max(0.0).sqrt(), half)
}

/// T = T0 + integral of mu(T) p v / (e sqrt(pi v d)) over the distances d from the front, marched through thin bands, each of
/// which warms itself: highest temperature (K) and sum of mu p dx (N/m).
fn marched(mu: impl Fn(f64) -> f64) -> (f64, f64) {
    let (pressure, half) = hertz();
    let bands = 1500;
    let width = 2.0 * half / f64::from(bands);
    let scale = 5.0 / (50.0 / 13e-6f64.sqrt() * (std::f64::consts::PI * 5.0).sqrt());
    let (mut friction, mut hottest): (Vec<f64>, f64) = (vec![], 0.0);
    for here in 0..bands {
        let x = half - width * (f64::from(here) + 0.5);
        let from = |front: f64| 2.0 * (front * width).sqrt();
        let before: f64 = friction
            .iter()
            .rev()
            .enumerate()
            .map(|(behind, friction)| {
                friction * (from(behind as f64 + 1.5) - from(behind as f64 + 0.5))
            })
            .sum();
        let mut temperature = 293.15;
        for _ in 0..100 {
            let own = mu(temperature) * pressure(x);
            temperature = 293.15 + scale * (before + own * from(0.5));
        }
        friction.push(mu(temperature) * pressure(x));
        hottest = hottest.max(temperature);
    }
    (hottest, width * friction.iter().sum::<f64>())
}

/// Heat and friction are found together: a coefficient that falls, or grows, with the temperature that it makes.
#[test]
fn hot_friction_is_that_of_its_own_heat() {
    let mut differ = vec![];
    for [cold, hot] in [[0.3, 0.1], [0.1, 0.3]] {
        let mu = move |temperature: f64| {
            cold + (hot - cold) * ((temperature - 293.15) / 600.0).clamp(0.0, 1.0)
        };
        let law = table(Circumstance::Temperature, [293.15, 893.15], [cold, hot]);
        let mut simulation = case(LINE, &["body.one.wear.energy.coefficient=1e-12 mm^3/J"]);
        simulation.problem.friction = Some(law.into());
        let mut rows = Rows::default();
        simulation.run(&mut [&mut rows]).unwrap();
        let (hottest, friction) = marched(mu);
        assert_relative_eq!(
            rows.last("flash_temperature_K"),
            hottest - 293.15,
            max_relative = 3e-3
        );
        // Worn over a millimetre: alpha times the force on 10 mm.
        let work = rows.last("worn_volume_one_m3") / 1e-21 / 1e-3;
        assert_relative_eq!(work, 0.01 * friction, max_relative = 3e-3);
        differ.push((hottest - 293.15, work / (cold * 5e3)));
    }
    // It matters, one way and the other.
    assert!(differ[0].1 < 0.8 && differ[1].1 > 1.2, "{differ:?}");
}

/// Rolling at full slip bears mu(V xi) F; at partial slip the force that a creepage makes, prescribed, makes the creepage.
#[test]
fn rolling_goes_by_the_creepage() {
    let law = || table(Circumstance::Speed, [0.0, 0.1], [0.4, 0.1]);
    let run = |options: &[&str]| {
        let mut rows = Rows::default();
        with(ball(STEEL, ROLLS, options), law()).run(&mut [&mut rows]).unwrap();
        rows
    };
    for creepage in [0.02, 0.04] {
        let given = format!("motion.rolling.creepage={creepage}");
        let rows = run(&[&given, "body.ball.wear="]);
        let coefficient = 0.4 - 3.0 * 2.0 * creepage;
        assert_relative_eq!(rows.last("force_x_N"), 50.0 * coefficient, max_relative = 1e-3);
        assert_eq!(rows.last("stick_area_m2"), 0.0);
    }
    let creepage = ["motion.rolling.creepage=0.0007", "body.ball.wear="];
    let found = run(&creepage);
    assert!(found.last("stick_area_m2") > 0.0);
    let force = format!("motion.rolling.force={} N", found.last("force_x_N"));
    let back = run(&["motion.rolling.creepage=", &force, "body.ball.wear="]);
    assert_relative_eq!(back.last("creepage"), 0.0007, max_relative = 1e-4);
}

/// What rolls at full slip is as hot as its friction makes it, and bears what that leaves; the heat of one run says what the
/// coefficient of the pairs was.
#[test]
fn rolling_friction_is_that_of_its_own_heat() {
    let warm = format!("{STEEL}\n{WARM}");
    let thermal = ["conductivity=50 W/(m K)", "diffusivity=13 mm^2/s", "temperature=20 degC"]
        .map(|one| format!("body.ball.thermal.{one}"));
    let mut options: Vec<&str> = thermal.iter().map(String::as_str).collect();
    options.extend(["body.ball.wear=", "motion.rolling.creepage=0.5"]);
    let law = table(Circumstance::Temperature, [293.15, 893.15], [0.4, 0.1]);
    let simulation = with(ball(&warm, ROLLS, &options), law);
    let states = states(&simulation).unwrap();
    let (state, ..) = states.last().unwrap();
    let problem = &simulation.problem;
    let flash = problem.flash(state).unwrap();
    assert!(peak(&flash.rise) > 100.0);
    let tangential = state.tangential.as_ref().unwrap();
    let most = peak(&state.pressure);
    for (pair, pressure) in state.pressure.iter().enumerate() {
        let [x, y] = [0, 1].map(|axis| tangential.traction[axis][pair]);
        let mu = 0.4 - 0.3 * (flash.rise[pair] / 600.0).min(1.0);
        assert_relative_eq!(x.hypot(y), mu * pressure, epsilon = 1e-5 * most);
    }
}

/// In gross slip the tractions are those of the distance that each pair has slid so far, of like bodies and unlike ones.
#[test]
fn fretting_runs_in() {
    for flat in [STEEL, "rigid = true"] {
        let law = table(Circumstance::Distance, [0.0, 20e-6], [0.4, 0.2]);
        let simulation = with(ball(flat, FRETS, &[]), law);
        let states = states(&simulation).unwrap();
        let mut forces = vec![];
        for two in states.windows(2) {
            let [(before, ..), (state, ..)] = two else { continue };
            let tangential = state.tangential.as_ref().unwrap();
            let most = peak(&state.pressure);
            let mut slips = 0;
            for (pair, pressure) in state.pressure.iter().enumerate() {
                let [x, y] = [0, 1].map(|axis| tangential.traction[axis][pair]);
                let slid = before.surfaces[0].slid[pair].max(before.surfaces[1].slid[pair]);
                let limit = (0.4 - 0.2 * (slid / 20e-6).min(1.0)) * pressure;
                assert!(x.hypot(y) <= limit + 1e-4 * most, "{} {limit}", x.hypot(y));
                slips += usize::from(limit > 0.0 && x.hypot(y) > 0.9999 * limit);
            }
            if slips == state.pairs_in_contact() {
                forces.push(simulation.problem.frame.integrate(&tangential.traction[0]).abs());
            }
        }
        // 50 N times 0.4 at first, 0.2 at last; the amplitude is inclined.
        assert!(forces.len() > 6, "{}", forces.len());
        assert!(forces[0] > 17.0 && forces[forces.len() - 1] < 10.5, "{forces:?}");
    }
}

/// Surfaces that swing dissipate mu(s) F times their way.
#[test]
fn swings_run_in() {
    let text = include_str!("../framed/mccoll_fretting/case.toml");
    let mut simulation = case(text, &["motion.fretting.cycles=2000", "output={}"]);
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).unwrap();
    let (whole, cycles) = (rows.column("dissipated_J"), rows.column("cycle"));
    simulation.problem.friction =
        Some(table(Circumstance::Distance, [0.0, 0.05], [0.9, 0.5]).into());
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).unwrap();
    let last = rows.column("cycle").len() - 1;
    assert_eq!(cycles.last(), rows.column("cycle").last());
    // 2000 cycles of 0.1 mm, less what is elastic.
    let ratio = rows.column("dissipated_J")[last] / whole.last().unwrap();
    assert_relative_eq!(ratio, 0.5 / 0.9, max_relative = 0.03);
}

/// What a law lacks is said where it stands, and by the engine.
#[test]
fn laws_ask_for_what_they_go_by() {
    let built = |over| Table::over(over, &[0.0, 1.0], &[0.3, 0.2]).unwrap();
    let still = |over| {
        let motion = SLIDES.replace("speed", "# speed");
        let simulation = with(ball(STEEL, &motion, &[]), Box::new(built(over)));
        simulation.run(&mut []).map_err(|error| error.to_string())
    };
    assert!(still(Circumstance::Distance).is_ok());
    assert!(still(Circumstance::Speed).unwrap_err().contains("depends on the sliding speed"));
    assert!(still(Circumstance::Temperature).unwrap_err().contains("depends on the temperature"));
    assert!(Coulomb::new(0.3).unwrap().inputs().is_empty());
}
