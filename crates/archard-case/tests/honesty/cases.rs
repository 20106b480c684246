//! Cases drawn at random, each with nothing but an accuracy, and what closed forms say of them.

use std::fmt::Write;

use archard::closed_form::carter;

use crate::contact::{Contact, Truth, any, law, layered, smooth};
use crate::random::Random;
use crate::waves::Waves;

/// The motions that cases are drawn of; case `i` has motion `i` of them, again and again.
pub const MOTIONS: [Draw; 19] = [
    ("indentation", indentation),
    ("indentation with friction", indentation_with_friction),
    ("sliding under a load", sliding_under_a_load),
    ("sliding at an approach", sliding_at_an_approach),
    ("track", track),
    ("rolling by creepage", rolling_by_creepage),
    ("rolling by spin", rolling_by_spin),
    ("rolling by force", rolling_by_force),
    ("rolling with wear", rolling_with_wear),
    ("rolling of lines", rolling_of_lines),
    ("fretting", fretting),
    ("fretting of lines", fretting_of_lines),
    ("fretting with wear", fretting_with_wear),
    ("gross slip", gross_slip),
    ("layered rolling", layered_rolling),
    ("layered rolling with wear", layered_rolling_with_wear),
    ("waves", pressed_waves),
    ("waves that wear", worn_waves),
    ("yielding", yielding),
];

/// A motion and what draws a case of it.
type Draw = (&'static str, fn(&mut Random) -> Case);

/// A case.
pub struct Case {
    pub text: String,
    pub truths: Vec<(&'static str, Truth)>,
}

/// What most cases are asked for: they are held against runs that take minutes on areas if it is less.
const ACCURACY: &str = "accuracy = 0.05\n";

/// Less at times, where that is cheap.
fn accuracy(random: &mut Random, cheap: bool) -> &'static str {
    if cheap && random.chance(0.4) { "accuracy = 0.01\n" } else { ACCURACY }
}

/// Outputs at these parts of the motion: the errors of early and of late rows differ.
fn outputs(extent: f64) -> String {
    let places = [0.05, 0.2, 0.5, 1.0].map(|part| format!("{:e}", part * extent));
    format!("[output]\nat = [{}]\n", places.join(", "))
}

fn friction(random: &mut Random) -> (String, f64) {
    let coefficient = random.decade(0.05, 0.8);
    (format!("[friction.coulomb]\ncoefficient = {coefficient}\n\n"), coefficient)
}

fn indentation(random: &mut Random) -> Case {
    let contact = any(random, 0.5);
    let control = match random.chance(0.6) || contact.line.is_some() {
        true => format!("load = \"{:e} N\"\n", contact.load),
        false => format!("approach = \"{:e} m\"\n", contact.approach),
    };
    let bodies = contact.bodies([""; 2]);
    let text = format!("{}{bodies}[motion.indentation]\n{control}", accuracy(random, true));
    Case { text, truths: contact.truths() }
}

fn indentation_with_friction(random: &mut Random) -> Case {
    let line = random.chance(0.7);
    let contact = smooth(random, 1.0, line);
    let (friction, _) = friction(random);
    let motion = format!("[motion.indentation]\nload = \"{:e} N\"\n", contact.load);
    let text = ACCURACY.to_owned() + &contact.bodies([""; 2]) + &friction + &motion;
    Case { text, truths: vec![] }
}

/// A distance (m), long against what is elastic.
const DISTANCE: f64 = 1.0;

/// A pin: its depth, from less than the approach on.
fn pin(random: &mut Random, contact: &Contact, control: &str) -> Case {
    let depth = contact.approach * random.decade(0.2, 20.0);
    let (law, coefficient) = law(random, contact, depth, DISTANCE);
    let body = random.below(2);
    let laws = if body == 0 { [law.as_str(), ""] } else { ["", law.as_str()] };
    let column = ["worn_volume_one_m3", "worn_volume_two_m3"][body];
    let volume = |k: f64| (column, Truth::Rate(k * contact.load));
    let truths = coefficient.filter(|_| control.starts_with("load")).map(volume);
    let motion = format!("[motion.sliding]\n{control}distance = \"{DISTANCE} m\"\n\n");
    let outputs = "[output]\nat = [\"0.05 m\", \"0.2 m\", \"0.5 m\", \"1 m\"]\n";
    let asked = accuracy(random, contact.line.is_some());
    let text = asked.to_owned() + &contact.bodies(laws) + &motion + outputs;
    Case { text, truths: truths.into_iter().collect() }
}

fn sliding_under_a_load(random: &mut Random) -> Case {
    let contact = any(random, 0.3);
    let control = format!("load = \"{:e} N\"\n", contact.load);
    pin(random, &contact, &control)
}

fn sliding_at_an_approach(random: &mut Random) -> Case {
    let contact = smooth(random, 0.3, false);
    let control = format!("approach = \"{:e} m\"\n", contact.approach);
    pin(random, &contact, &control)
}

fn track(random: &mut Random) -> Case {
    let contact = smooth(random, 0.3, false);
    let turns = random.decade(30.0, 3000.0);
    let length = contact.radius * random.between(5.0, 20.0);
    let strokes = random.chance(0.3);
    let distance = turns * length * if strokes { 2.0 } else { 1.0 };
    let depth = contact.approach * random.decade(0.2, 10.0);
    // A point of the track is rubbed while the contact is above it.
    let slips = [distance, distance / length * 2.0 * contact.half];
    let depths = [depth, depth * random.decade(0.1, 2.0)];
    let [one, two] = [0, 1].map(|body| law(random, &contact, depths[body], slips[body]));
    let worn = [random.chance(0.8), random.chance(0.8)];
    let laws = match worn {
        [true, false] => [one.0.as_str(), ""],
        [false, true] => ["", two.0.as_str()],
        _ => [one.0.as_str(), two.0.as_str()],
    };
    let columns = [("worn_volume_one_m3", one.1), ("worn_volume_two_m3", two.1)];
    let worn = columns.into_iter().zip(laws).filter(|(_, law)| !law.is_empty());
    let volume =
        |((column, k), _): ((_, Option<f64>), _)| Some((column, Truth::Rate(k? * contact.load)));
    let motion = format!(
        "[motion.sliding]\nload = \"{:e} N\"\n{} = \"{length:e} m\"\npasses = \"two\"\ndistance = \"{distance:e} m\"\n\n",
        contact.load,
        if strokes { "stroke" } else { "track" },
    );
    let places = [0.1, 0.3, 1.0].map(|part| format!("\"{:e} m\"", part * distance));
    let outputs = format!("[output]\nat = [{}]\n", places.join(", "));
    let text = ACCURACY.to_owned() + &contact.bodies(laws) + &motion + &outputs;
    Case { text, truths: worn.filter_map(volume).collect() }
}

/// Steady rolling of bodies that do not wear, driven so.
fn steady(random: &mut Random, contact: &Contact, (friction, driven): (&str, &str)) -> Case {
    let load = contact.load;
    let motion = format!("[motion.rolling]\nload = \"{load:e} N\"\n{driven}revolutions = 0\n");
    let asked = accuracy(random, contact.line.is_some());
    let text = asked.to_owned() + &contact.bodies([""; 2]) + friction + &motion;
    Case { text, truths: if contact.alike() { contact.truths() } else { vec![] } }
}

/// The creepage from which on all slips, about.
fn saturation(contact: &Contact, friction: f64) -> f64 {
    carter::saturation_creepage(friction, contact.half, contact.radius)
}

fn rolling_by_creepage(random: &mut Random) -> Case {
    let contact = smooth(random, 0.4, false);
    let (law, friction) = friction(random);
    let saturation = saturation(&contact, friction);
    let mut driven = format!("creepage = {:e}\n", saturation * random.decade(0.1, 3.0));
    if random.chance(0.5) {
        let _ = writeln!(driven, "lateral_creepage = {:e}", saturation * random.between(-1.5, 1.5));
    }
    steady(random, &contact, (&law, &driven))
}

fn rolling_by_spin(random: &mut Random) -> Case {
    let contact = smooth(random, 0.4, false);
    let (law, friction) = friction(random);
    let spin = friction / contact.radius * random.between(0.1, 2.0);
    let mut driven = format!("spin = \"{spin:e} 1/m\"\n");
    if random.chance(0.5) {
        let creepage = saturation(&contact, friction) * random.between(-1.5, 1.5);
        let _ = writeln!(driven, "creepage = {creepage:e}");
    }
    steady(random, &contact, (&law, &driven))
}

fn rolling_by_force(random: &mut Random) -> Case {
    let line = random.chance(0.5);
    let contact = smooth(random, 0.4, line);
    let (law, friction) = friction(random);
    let force = friction * contact.load * random.between(0.05, 0.9);
    steady(random, &contact, (&law, &format!("force = \"{force:e} N\"\n")))
}

fn rolling_with_wear(random: &mut Random) -> Case {
    const REVOLUTIONS: f64 = 1000.0;
    // Unlike bodies that touch on areas take minutes.
    let line = random.chance(0.5);
    let contact = smooth(random, if line { 0.6 } else { 0.0 }, line);
    let (friction, coefficient) = friction(random);
    let creepage = saturation(&contact, coefficient) * random.decade(0.3, 5.0);
    let depth = contact.approach * random.decade(0.1, 5.0);
    let slip = REVOLUTIONS * 2.0 * contact.half * creepage;
    let [one, two] = [0, 1].map(|_| law(random, &contact, depth, slip).0);
    let laws = if random.chance(0.5) { [one.as_str(), ""] } else { [one.as_str(), two.as_str()] };
    let motion = format!(
        "[motion.rolling]\nload = \"{:e} N\"\ncreepage = {creepage:e}\nrevolutions = {REVOLUTIONS}\n\n",
        contact.load
    );
    let bodies = accuracy(random, line).to_owned() + &contact.bodies(laws);
    let text = bodies + &friction + &motion + &outputs(REVOLUTIONS);
    Case { text, truths: vec![] }
}

/// Carter's cylinders, or unlike ones.
fn rolling_of_lines(random: &mut Random) -> Case {
    let contact = smooth(random, 0.4, true);
    let (law, friction) = friction(random);
    let relative = random.decade(0.05, 2.0);
    let creepage = relative * saturation(&contact, friction);
    let mut case = steady(random, &contact, (&law, &format!("creepage = {creepage:e}\n")));
    if contact.alike() {
        let force = friction * contact.load * carter::relative_force(relative);
        let sticks = contact.area * (1.0 - relative).max(0.0);
        let truths = [("force_x_N", force), ("stick_area_m2", sticks)];
        case.truths.extend(truths.map(|(column, value)| (column, Truth::Steady(value))));
    }
    case
}

/// A layer on one of two bodies that are of one kind below it, lines as a rule.
fn layered_rolling(random: &mut Random) -> Case {
    let line = random.chance(0.7);
    let contact = layered(random, line);
    let (law, friction) = friction(random);
    let driven = match random.chance(0.5) {
        true => {
            format!("creepage = {:e}\n", saturation(&contact, friction) * random.decade(0.1, 2.0))
        }
        false => {
            format!("force = \"{:e} N\"\n", friction * contact.load * random.between(0.05, 0.9))
        }
    };
    steady(random, &contact, (&law, &driven))
}

/// The same of lines that wear, by no more than half of the layer.
fn layered_rolling_with_wear(random: &mut Random) -> Case {
    const REVOLUTIONS: f64 = 1000.0;
    let contact = layered(random, true);
    let (friction, coefficient) = friction(random);
    let creepage = saturation(&contact, coefficient) * random.decade(0.3, 5.0);
    let depth = contact.approach.min(contact.thickness()) * random.decade(0.05, 0.5);
    let (law, _) = law(random, &contact, depth, REVOLUTIONS * 2.0 * contact.half * creepage);
    let motion = format!(
        "[motion.rolling]\nload = \"{:e} N\"\ncreepage = {creepage:e}\nrevolutions = {REVOLUTIONS}\n\n",
        contact.load
    );
    let bodies = ACCURACY.to_owned() + &contact.bodies([&law, ""]);
    Case { text: bodies + &friction + &motion + &outputs(REVOLUTIONS), truths: vec![] }
}

/// Waves that repeat themselves, pressed together; they yield at times.
fn pressed_waves(random: &mut Random) -> Case {
    let across = random.chance(0.4);
    let waves = Waves::new(random, across);
    let hardness = random.chance(0.4).then(|| waves.peak * random.between(0.4, 0.95));
    let motion = format!("[motion.indentation]\nload = \"{:e} Pa\"\nincrements = 4\n", waves.mean);
    let text = ACCURACY.to_owned() + &waves.bodies("", hardness) + &motion;
    Case { text, truths: if hardness.is_some() { vec![] } else { waves.truths() } }
}

/// Waves whose crests wear by less than their height.
fn worn_waves(random: &mut Random) -> Case {
    let waves = Waves::new(random, false);
    let depth = waves.amplitude * random.decade(0.05, 1.0);
    let coefficient = depth / (waves.mean * DISTANCE);
    let law = format!("wear.archard.coefficient = \"{coefficient:e} 1/Pa\"\n");
    let motion = format!(
        "[motion.sliding]\nload = \"{:e} Pa\"\ndistance = \"{DISTANCE} m\"\n\n",
        waves.mean
    );
    let outputs = "[output]\nat = [\"0.05 m\", \"0.2 m\", \"0.5 m\", \"1 m\"]\n";
    let text = ACCURACY.to_owned() + &waves.bodies(&law, None) + &motion + outputs;
    Case { text, truths: vec![] }
}

/// Bodies, the softer yielding below the pressure that elastic ones have.
fn yielding(random: &mut Random) -> Case {
    let contact = smooth(random, 0.0, false);
    let hardness = contact.peak() * random.between(0.3, 0.95);
    let hardness = format!("hardness = \"{hardness:e} Pa\"\n");
    let bodies = contact.bodies(["", &hardness]);
    let motion = format!("[motion.indentation]\nload = \"{:e} N\"\nincrements = 4\n", contact.load);
    Case { text: ACCURACY.to_owned() + &bodies + &motion, truths: vec![] }
}

/// The shift (m) at which all slips, about: cylinders are held at the depth of their radius.
fn elastic(contact: &Contact, friction: f64) -> f64 {
    let logarithm = (2.0 * contact.radius / contact.half).ln();
    friction * contact.approach * if contact.line.is_some() { 0.5 * logarithm } else { 1.2 }
}

/// What leaves a part of a contact sticking: a force or a shift.
fn partly(random: &mut Random, contact: &Contact, friction: f64) -> String {
    let share = random.between(0.2, 0.9);
    if random.chance(0.3) {
        let force = share * friction * contact.load;
        return format!("force_amplitude = [\"{force:e} N\", \"0 N\"]\n");
    }
    let amplitude = share * elastic(contact, friction);
    format!("amplitude = [\"{amplitude:e} m\", \"0 m\"]\n")
}

/// Cycles that are driven so, of bodies that wear by these laws.
fn swung(contact: &Contact, laws: [&str; 2], friction: &str, driven: &str) -> String {
    let load = contact.load;
    let motion = format!("[motion.fretting]\nload = \"{load:e} N\"\n{driven}");
    ACCURACY.to_owned() + &contact.bodies(laws) + friction + &motion
}

/// Areas take many elements: few cycles, bodies of one kind.
fn fretting(random: &mut Random) -> Case {
    let contact = smooth(random, 0.0, false);
    let (friction, coefficient) = friction(random);
    let driven = partly(random, &contact, coefficient);
    let text = swung(&contact, [""; 2], &friction, &driven) + "cycles = 1\n";
    Case { text, truths: contact.truths() }
}

fn fretting_of_lines(random: &mut Random) -> Case {
    let contact = smooth(random, 0.4, true);
    let (friction, coefficient) = friction(random);
    let driven = partly(random, &contact, coefficient);
    let text = swung(&contact, [""; 2], &friction, &driven) + "cycles = 2\n";
    Case { text, truths: if contact.alike() { contact.truths() } else { vec![] } }
}

/// Cycles that wear, so many that most are jumped over. Of lines, like bodies where a part sticks: others take minutes.
const CYCLES: f64 = 1000.0;

fn fretting_with_wear(random: &mut Random) -> Case {
    let contact = smooth(random, 0.0, true);
    let (friction, coefficient) = friction(random);
    let driven = partly(random, &contact, coefficient);
    let depth = contact.approach * random.decade(0.05, 1.0);
    // What the rim slips in a cycle, about.
    let (law, _) = law(random, &contact, depth, CYCLES * coefficient * contact.approach);
    worn(&contact, (&law, &friction, &driven))
}

fn gross_slip(random: &mut Random) -> Case {
    let contact = smooth(random, 0.2, true);
    let (friction, coefficient) = friction(random);
    let amplitude = elastic(&contact, coefficient) * random.decade(4.0, 30.0);
    let depth = contact.approach * random.decade(0.2, 5.0);
    let (law, _) = law(random, &contact, depth, 4.0 * amplitude * CYCLES);
    let driven = format!("amplitude = [\"{amplitude:e} m\", \"0 m\"]\n");
    worn(&contact, (&law, &friction, &driven))
}

fn worn(contact: &Contact, (law, friction, driven): (&str, &str, &str)) -> Case {
    let text = swung(contact, [law, ""], friction, driven);
    let text = text + &format!("cycles = {CYCLES}\n\n") + &outputs(CYCLES);
    Case { text, truths: vec![] }
}
