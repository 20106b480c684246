//! Listed wear laws through whole runs: depths that wear hardly changes the contact by, against what a law says of its
//! pressures and slips.

use approx::assert_relative_eq;
use archard::simulation::Simulation;

use crate::common::{Rows, case, peak, states};

pub(super) const BODIES: &str = r#"
    [body.ball]
    material = { young = "210 GPa", poisson = 0.3 }
    profile.sphere = { radius = "50 mm" }
    [body.flat]
    material = { young = "210 GPa", poisson = 0.3 }
    profile.flat = {}
    [frame]
    size = ["0.6 mm", "0.6 mm"]
    elements = [20, 20]
    [friction.coulomb]
    coefficient = 0.3
"#;
const SLIDES: &str = "[motion.sliding]\nload = \"10 N\"\ndistance = \"30 mm\"\nstep = \"10 mm\"\nsurfaces = \"stay\"\nspeed = \"0.2 m/s\"";
const TRACK: &str = "[motion.sliding]\nload = \"10 N\"\ntrack = \"3 mm\"\ndistance = \"30 mm\"\nstep = \"1.5 mm\"\npasses = \"flat\"";
pub(super) const ROLLS: &str =
    "[motion.rolling]\nload = \"10 N\"\ncreepage = 1\nrevolutions = 30\nstep = 5";
const FRETS: &str = "[motion.fretting]\nload = \"10 N\"\namplitude = [\"8 um\", \"0 um\"]\ncycles = 4\nincrements = 80";

/// A case whose ball, or flat, wears by that law.
fn worn_by(law: &str, body: &str, motion: &str) -> Simulation {
    let bodies = BODIES.replace(&format!("[body.{body}]"), &format!("[body.{body}]\nwear.{law}"));
    case(&format!("{bodies}{motion}"), &[])
}

/// Pressures at the end (Pa) and depths worn off both bodies (m).
pub(super) fn run(law: &str, body: &str, motion: &str) -> (Vec<f64>, [Vec<f64>; 2]) {
    let mut states = states(&worn_by(law, body, motion)).expect("it converges");
    let state = states.pop().expect("a state").0;
    let worn = [0, 1].map(|body| state.worn(body).into_owned());
    (state.pressure, worn)
}

/// Both depths agree, relative to the deepest.
pub(super) fn agree(one: &[f64], other: &[f64], within: f64) {
    let most = peak(one);
    assert!(most > 0.0);
    for (one, other) in one.iter().zip(other) {
        assert!((one - other).abs() <= within * most, "{one:e} {other:e} of {most:e}");
    }
}

/// alpha mu p s: Archard's law with k = alpha mu where all slides, by tracks, wheels and a pin as well.
#[test]
fn by_work_is_archards_where_all_slides() {
    for (body, motion) in [("ball", SLIDES), ("flat", TRACK), ("flat", ROLLS), ("ball", FRETS)] {
        let (_, archard) = run("archard.coefficient = \"3e-20 1/Pa\"", body, motion);
        let (_, energy) = run("energy.coefficient = \"1e-10 mm^3/J\"", body, motion);
        let body = usize::from(body == "flat");
        // Where fretting turns round, the mean traction of an increment is less than the limit.
        agree(&archard[body], &energy[body], if motion == FRETS { 0.01 } else { 1e-9 });
    }
}

/// In the first cycle of fretting all tractions are those of unworn bodies: the threshold takes alpha W0 off each depth.
#[test]
fn a_threshold_of_work_is_taken_off_each_cycle() {
    let motion = FRETS.replace("8 um", "0.3 um").replace("cycles = 4", "cycles = 1");
    let law = |threshold: f64| {
        format!("energy = {{ coefficient = \"1e-10 mm^3/J\", threshold = \"{threshold} J/m^2\" }}")
    };
    let [all, beyond] = [0.0, 10.0].map(|threshold| run(&law(threshold), "ball", &motion).1);
    let most = peak(&all[0]);
    assert!(most > 2.0 * 10.0 * 1e-19, "{most:e}");
    let expected: Vec<f64> = all[0].iter().map(|all| (all - 10.0 * 1e-19).max(0.0)).collect();
    agree(&expected, &beyond[0], 1e-6);
}

/// Under Hertz's pressures p0 (1 - r^2)^(1/2) the volume of k p0 (p / p0)^m s is 2 pi a^2 k p0 s / (m + 2). At m = 0.7 the
/// depth of the last pairs of the contact depends on where the grid cuts its edge.
#[test]
fn powers_of_hertz_have_volumes_in_closed_form() {
    // E* = 115.385 GPa, R = 50 mm, P = 10 N.
    let modulus: f64 = 0.5 * 210e9 / (1.0 - 0.09);
    let radius = (0.75 * 10.0 * 0.05 / modulus).cbrt();
    let peak = 1.5 * 10.0 / (std::f64::consts::PI * radius * radius);
    for (exponent, within) in [(0.7, 0.01), (1.0, 1e-6), (1.6, 0.01), (3.0, 0.02)] {
        let law = format!(
            "power = {{ coefficient = \"1e-20 1/Pa\", pressure_exponent = {exponent}, reference_pressure = \"{peak} Pa\", speed_exponent = 0.5, reference_speed = \"0.8 m/s\" }}"
        );
        let mut rows = Rows::default();
        worn_by(&law, "ball", SLIDES).run(&mut [&mut rows]).expect("it converges");
        let area = 2.0 * std::f64::consts::PI * radius * radius;
        // A quarter of the reference speed: half of k.
        let volume = 0.5 * area * 1e-20 * peak * 0.03 / (exponent + 2.0);
        let found = rows.last("worn_volume_ball_m3");
        assert_relative_eq!(found / volume, 1.0, max_relative = within);
    }
}

/// Where bodies wear in earnest, the implicit step meets the law at the pressures of its end, m below and above one.
#[test]
fn implicit_steps_of_powers_obey_the_law() {
    for exponent in [0.6, 0.9, 1.4, 2.5] {
        let law = format!(
            "power = {{ coefficient = \"1e-13 1/Pa\", pressure_exponent = {exponent}, reference_pressure = \"100 MPa\" }}"
        );
        let motion =
            SLIDES.replace("30 mm", "60 mm").replace("step = \"10 mm\"", "step = \"20 mm\"");
        let states = states(&worn_by(&law, "ball", &motion)).expect("it converges");
        for pair in states.windows(2) {
            let (before, after) = (&pair[0].0, &pair[1].0);
            let worn: Vec<f64> =
                after.worn(0).iter().zip(&*before.worn(0)).map(|(a, b)| a - b).collect();
            let law = |p: &f64| 1e-13 * 1e8 * (p / 1e8).powf(exponent) * 0.02;
            let linear = exponent < 1.0;
            let expected: Vec<f64> = after
                .pressure
                .iter()
                .zip(&worn)
                .map(|(p, worn)| if linear && *p < 1e5 { *worn } else { law(p) })
                .collect();
            agree(&expected, &worn, 1e-8);
        }
    }
}

/// k (p - pc) s beyond the threshold.
#[test]
fn pressures_below_a_threshold_do_not_wear() {
    let law = "threshold = { coefficient = \"1e-20 1/Pa\", threshold = \"80 MPa\" }";
    let (pressure, worn) = run(law, "ball", SLIDES);
    let expected: Vec<f64> = pressure.iter().map(|p| 1e-20 * (p - 80e6).max(0.0) * 0.03).collect();
    agree(&expected, &worn[0], 1e-6);
    assert!(pressure.iter().any(|&p| p > 0.0 && p < 80e6));
}

/// After 30 mm k1 s + (k0 - k1) s0 (1 - exp(-s / s0)), in one step or many, and by a table that follows k(s).
#[test]
fn coefficients_run_in_with_the_distance() {
    let (pressure, ..) = run("archard.coefficient = \"1e-20 1/Pa\"", "ball", SLIDES);
    let coefficient = 1e-20 * 0.03 + 4e-20 * 0.01 * (1.0 - (-3.0f64).exp());
    let expected: Vec<f64> = pressure.iter().map(|p| coefficient * p).collect();
    let law = "running_in = { initial_coefficient = \"5e-20 1/Pa\", final_coefficient = \"1e-20 1/Pa\", running_in_distance = \"10 mm\" }";
    for step in ["10 mm", "30 mm", "1 mm"] {
        let motion = SLIDES.replace("step = \"10 mm\"", &format!("step = \"{step}\""));
        agree(&expected, &run(law, "ball", &motion).1[0], 1e-6);
    }
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("k.csv");
    let k = |s: f64| 1e-20 + 4e-20 * (-s / 10.0).exp();
    let lines = (0..=120).map(|i| 0.25 * f64::from(i)).map(|s| format!("{s},{:e}\n", k(s)));
    let text = format!("distance_mm,coefficient_1/Pa\n{}", lines.collect::<String>());
    std::fs::write(&file, text).expect("a file");
    let law = format!("table.file = '{}'", file.display());
    // Straight lines over 0.25 mm: (0.25 / 10)^2 / 12.
    agree(&expected, &run(&law, "ball", SLIDES).1[0], 1e-4);
}

/// In rolling and on a track the distance is that of the points: where all slips, Archard's depth with the k of the middle
/// of what they slide, to the second order of the passages.
#[test]
fn points_that_pass_run_in_by_their_own_distance() {
    for (body, motion) in [("flat", TRACK), ("flat", ROLLS)] {
        let (_, plain) = run("archard.coefficient = \"1e-20 1/Pa\"", body, motion);
        let law = "running_in = { initial_coefficient = \"1e-20 1/Pa\", final_coefficient = \"0 1/Pa\", running_in_distance = \"10 m\" }";
        let (_, run_in) = run(law, body, motion);
        // A line of the contact is 0.27 mm long, so that all 30 turns slide 9 mm, or 10 turns 3 mm: k falls by half of that.
        let (most, less) = (peak(&plain[1]), peak(&run_in[1]));
        let fallen = 1.0 - less / most;
        let passages = if motion == TRACK { 10.0 } else { 30.0 };
        assert!(fallen > 0.5 * passages * 0.2e-3 / 10.0, "{fallen:e}");
        assert!(fallen < 0.5 * passages * 0.36e-3 / 10.0, "{fallen:e}");
    }
}

/// The depth of laws that are not straight does not depend on how a motion is divided into steps: bodies that slide, a track,
/// wheels, and fretting with jumps over cycles.
#[test]
fn depths_do_not_depend_on_the_division() {
    const LAWS: [&str; 6] = [
        "power = { coefficient = \"1e-20 1/Pa\", pressure_exponent = 1.6, reference_pressure = \"100 MPa\" }",
        "threshold = { coefficient = \"1e-20 1/Pa\", threshold = \"80 MPa\" }",
        "running_in = { initial_coefficient = \"5e-20 1/Pa\", final_coefficient = \"1e-20 1/Pa\", running_in_distance = \"10 mm\" }",
        "energy = { coefficient = \"1e-11 mm^3/J\" }",
        "orthotropic = { coefficients = [\"4e-20 1/Pa\", \"1e-20 1/Pa\"], angle = \"30 deg\" }",
        "expression = { depth = \"k*work*(1 + (p/p0)^2)\", k = \"1e-20 1/Pa\", p0 = \"50 MPa\" }",
    ];
    // What takes a whole cycle; what slides on the same spot has none.
    const OF_CYCLES: [&str; 2] = [
        "energy = { coefficient = \"1e-11 mm^3/J\", threshold = \"1 J/m^2\" }",
        "cross_shear = { unidirectional_coefficient = \"1e-20 1/Pa\", multidirectional_coefficient = \"5e-20 1/Pa\" }",
    ];
    let frets = FRETS.replace("cycles = 4", "cycles = 40").replace("80", "20");
    let divided = [
        ("ball", SLIDES.to_owned(), SLIDES.replace("10 mm", "3 mm"), 1e-6),
        // What runs in does so by the middle of the passages of a step.
        ("flat", TRACK.to_owned(), TRACK.replace("1.5 mm", "0.5 mm"), 2e-5),
        ("flat", ROLLS.to_owned(), ROLLS.replace("step = 5", "step = 1"), 1e-3),
        // Cycles that are jumped over wear as the one before them does, though it ran in less.
        ("ball", frets.clone(), frets + "\njump = 8", 5e-3),
    ];
    for (body, whole, parts, within) in divided {
        let cycles = OF_CYCLES.iter().filter(|_| whole != SLIDES);
        for law in LAWS.iter().chain(cycles) {
            let worn = [&whole, &parts].map(|motion| run(law, body, motion).1);
            let body = usize::from(body == "flat");
            let most = peak(&worn[0][body]);
            let off = worn[0][body].iter().zip(&worn[1][body]).map(|(one, other)| one - other);
            let off = off.fold(0.0, |off: f64, one| off.max(one.abs())) / most;
            assert!(most > 0.0 && off <= within, "{off:e} under {law} in {parts}");
        }
    }
}

/// Slip along x wears by p sqrt((i1 cos)^2 + (i2 sin)^2) with axes at 30 degrees, slip along y the other way round; equal
/// coefficients are Archard's, however the slip turns.
#[test]
fn two_axes_wear_by_the_direction_of_the_slip() {
    let circle = "[motion.fretting]\nload = \"10 N\"\namplitude = [\"8 um\", \"8 um\"]\nphase = \"90 deg\"\ncycles = 2";
    let across = SLIDES.replace("surfaces", "direction = \"y\"\nsurfaces");
    let axes =
        "orthotropic = { coefficients = [\"4e-20 1/Pa\", \"1e-20 1/Pa\"], angle = \"30 deg\" }";
    for (body, motion, share) in [
        ("ball", SLIDES, 49f64.sqrt() / 2.0),
        ("flat", TRACK, 49f64.sqrt() / 2.0),
        ("flat", ROLLS, 49f64.sqrt() / 2.0),
        ("ball", &across, 19f64.sqrt() / 2.0),
    ] {
        let (_, archard) = run("archard.coefficient = \"1e-20 1/Pa\"", body, motion);
        let (_, found) = run(axes, body, motion);
        let body = usize::from(body == "flat");
        let expected: Vec<f64> = archard[body].iter().map(|depth| share * depth).collect();
        // Tractions turn the slip of wheels a little off their direction.
        agree(&expected, &found[body], if motion == ROLLS { 1e-3 } else { 2e-6 });
    }
    for motion in [ROLLS, circle] {
        let equal = "orthotropic = { coefficients = [\"1e-20 1/Pa\", \"1e-20 1/Pa\"] }";
        let (_, archard) = run("archard.coefficient = \"1e-20 1/Pa\"", "ball", motion);
        let (_, found) = run(equal, "ball", motion);
        assert_eq!(archard[0], found[0]);
    }
}

/// A body that is led round an ellipse with half axes a and b wears by the share of its slip across the longer one: the
/// integral of (b sin)^2 over that of a length, both along the ellipse. Along a line that share is zero.
#[test]
fn slip_that_crosses_itself_wears_by_both_coefficients() {
    let law = "cross_shear = { unidirectional_coefficient = \"1e-20 1/Pa\", multidirectional_coefficient = \"5e-20 1/Pa\" }";
    let archard = "archard.coefficient = \"1e-20 1/Pa\"";
    // The bodies push each other a little sideways where they slip.
    agree(&run(archard, "ball", FRETS).1[0], &run(law, "ball", FRETS).1[0], 1e-3);
    for half in [8.0_f64, 2.0] {
        let last = |law: &str| {
            let motion = |cycles: usize| {
                format!(
                    "[motion.fretting]\nload = \"10 N\"\namplitude = [\"8 um\", \"{half} um\"]\nphase = \"90 deg\"\nincrements = 60\ncycles = {cycles}"
                )
            };
            let [before, after] = [2, 3].map(|cycles| run(law, "ball", &motion(cycles)).1);
            let cycle = after[0].iter().zip(&before[0]).map(|(after, before)| after - before);
            cycle.collect::<Vec<f64>>()
        };
        let parts = (0..10_000).map(|part| (f64::from(part) + 0.5) * 1e-4 * std::f64::consts::TAU);
        let (across, all) = parts.fold((0.0, 0.0), |(across, all), turn| {
            let [x, y] = [8.0 * turn.cos(), half * turn.sin()];
            (across + y * y / x.hypot(y), all + x.hypot(y))
        });
        let expected = 1.0 + 4.0 * 2.0 * across / all;
        let expected: Vec<f64> = last(archard).iter().map(|depth| expected * depth).collect();
        // The bodies follow elastically by 0.16 um, and 60 chords are not an ellipse.
        agree(&expected, &last(law), 0.02);
    }
}

/// Formulas of listed laws through whole runs, in implicit steps and by error, on all motions: the same bits where the
/// operations are the same.
#[test]
fn formulas_run_as_the_listed_laws_do() {
    let by_error = SLIDES.replace("step = \"10 mm\"", "tolerance = 1e-3");
    let archard = "archard.coefficient = \"1e-13 1/Pa\"";
    let formula = "expression = { depth = \"k*p*s\", k = \"1e-13 1/Pa\" }";
    let motions = [("ball", SLIDES), ("ball", &*by_error), ("flat", TRACK), ("flat", ROLLS)];
    for (body, motion) in motions.into_iter().chain([("ball", FRETS)]) {
        assert_eq!(run(archard, body, motion), run(formula, body, motion), "{motion}");
    }
    let threshold = "threshold = { coefficient = \"1e-13 1/Pa\", threshold = \"80 MPa\" }";
    let formula =
        "expression = { depth = \"k*max(p - p0, 0)*s\", k = \"1e-13 1/Pa\", p0 = \"80 MPa\" }";
    for motion in [SLIDES, &by_error] {
        assert_eq!(run(threshold, "ball", motion), run(formula, "ball", motion), "{motion}");
    }
    let running_in = "running_in = { initial_coefficient = \"5e-13 1/Pa\", final_coefficient = \"1e-13 1/Pa\", running_in_distance = \"10 mm\" }";
    let formula = "expression = { depth = \"p*(k1*s + (k0 - k1)*s0*(1 - exp(-s/s0))*exp(-distance/s0))\", k0 = \"5e-13 1/Pa\", k1 = \"1e-13 1/Pa\", s0 = \"10 mm\" }";
    for (body, motion) in [("ball", SLIDES), ("ball", &*by_error), ("flat", TRACK)] {
        let (listed, written) = (run(running_in, body, motion), run(formula, body, motion));
        let body = usize::from(body == "flat");
        agree(&listed.1[body], &written.1[body], 1e-9);
    }
}

/// A formula of the work beyond a threshold of each cycle is the listed law.
#[test]
fn a_formula_may_take_a_whole_cycle() {
    let motion = FRETS.replace("8 um", "0.3 um");
    let energy = "energy = { coefficient = \"1e-10 mm^3/J\", threshold = \"10 J/m^2\" }";
    let formula = "expression = { depth = \"alpha*max(work - w0, 0)\", alpha = \"1e-10 mm^3/J\", w0 = \"10 J/m^2\", per = \"cycle\" }";
    assert_eq!(run(energy, "ball", &motion), run(formula, "ball", &motion));
    let circle = "[motion.fretting]\nload = \"10 N\"\namplitude = [\"8 um\", \"4 um\"]\nphase = \"90 deg\"\ncycles = 2";
    let listed = "cross_shear = { unidirectional_coefficient = \"1e-20 1/Pa\", multidirectional_coefficient = \"5e-20 1/Pa\" }";
    let crossing = "expression = { depth = \"(k0 + (k1 - k0)*(2*cs))*s*p\", k0 = \"1e-20 1/Pa\", k1 = \"5e-20 1/Pa\", per = \"cycle\" }";
    let [one, other] = [listed, crossing].map(|law| run(law, "ball", circle).1);
    agree(&one[0], &other[0], 1e-12);
    let formula = formula.replace("work", "mu*p*s");
    let [one, other] = [energy, &*formula].map(|law| run(law, "ball", &motion).1);
    agree(&one[0], &other[0], 1e-9);
}

/// Each pair wears by the coefficient of its region: over the edge at 100 MPa ten times more, and above 0.2 m/s twice as much;
/// a law strong enough to flatten the contact is met by the implicit step on both sides of the edge.
#[test]
fn maps_wear_by_regions() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("map.csv");
    let regions = "pressure,speed_m/s,coefficient\n0,0,1\n0.5,0,10\n0,0.2,2\n0.5,0.2,20\n";
    std::fs::write(&file, regions).expect("a file");
    for (speed, faster) in [("0.1 m/s", 1.0), ("0.3 m/s", 2.0)] {
        // A coefficient of the order of one that hardly wears: the hardness is in the file's scale alone.
        let law = format!("map = {{ hardness = \"200 MPa\", file = '{}' }}", file.display());
        let motion = SLIDES
            .replace("0.2 m/s", speed)
            .replace("30 mm", "3e-9 mm")
            .replace("10 mm", "1e-9 mm");
        let (pressure, worn) = run(&law, "ball", &motion);
        let expected = |p: &f64| if *p < 99e6 { 1.0 } else { 10.0 } * faster * p / 2e8 * 3e-12;
        let clear = |p: &&f64| (**p - 1e8).abs() > 1e6;
        let most = peak(&worn[0]);
        for (p, worn) in pressure.iter().zip(&worn[0]).filter(|(p, _)| clear(p)) {
            assert!((worn - expected(p)).abs() < 1e-4 * most, "{worn:e} under {p:e}");
        }
        assert!(
            pressure.iter().any(|&p| p > 1.1e8) && pressure.iter().any(|&p| p > 0.0 && p < 0.9e8)
        );
    }
    std::fs::write(&file, regions.replace("1\n", "1e-5\n").replace("10\n", "1e-4\n"))
        .expect("a file");
    let law = format!("map = {{ hardness = \"200 MPa\", file = '{}' }}", file.display());
    let motion = SLIDES.replace("0.2 m/s", "0.1 m/s");
    let (pressure, worn) = run(&law, "ball", &motion);
    assert!(peak(&worn[0]) > 1e-7 && peak(&pressure) < 1.5e8, "{:e}", peak(&worn[0]));
    // A long step over an edge with a hundred times the wear behind it: between k p s / H on its two sides.
    let steep = "pressure,speed_m/s,coefficient\n0,0,3e-5\n0.5,0,3e-3\n";
    std::fs::write(&file, steep).expect("a file");
    let motion = motion.replace("30 mm", "5 mm").replace("10 mm", "5 mm");
    let (pressure, worn) = run(&law, "ball", &motion);
    let depth = |k: f64, p: f64| k * p / 2e8 * 5e-3;
    let mut held = 0;
    for (&p, &worn) in pressure.iter().zip(&worn[0]) {
        let (mild, severe) = (depth(3e-5, p), depth(3e-3, p));
        if (p - 1e8).abs() < 1e6 {
            held += 1;
            assert!(worn >= mild && worn <= severe, "{worn:e} under {p:e}");
        } else {
            let expected = if p < 1e8 { mild } else { severe };
            assert_relative_eq!(1e6 * worn, 1e6 * expected, max_relative = 1e-6);
        }
    }
    assert!(held > 10, "{held}");
}
