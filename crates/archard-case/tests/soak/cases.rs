//! Cases drawn at random about Hertz's contact, so that what they ask for is neither nothing nor impossible.

use std::fmt::Write;
use std::path::Path;

use archard::closed_form::Hertz;

use crate::random::Random;

/// What the parts of a case are measured by.
struct Scales {
    /// Semi-axes of Hertz's contact (m); that along y of a line contact is half its length.
    semi_axes: [f64; 2],
    /// Load (N), peak pressure (Pa) and approach (m).
    load: f64,
    peak: f64,
    approach: f64,
    /// Radius along x (m).
    radius: f64,
    friction: f64,
}

/// The text of the case of a seed; a table that it names is written in the folder.
pub fn random_case(seed: u64, folder: &Path) -> String {
    let random = &mut Random::new(seed);
    let mut text = String::new();
    let (materials, modulus) = materials(random);
    let (profile, scales) = contact(random, modulus);
    let line = profile.contains("cylinder");
    let motion = random.one(&["sliding", "indentation", "fretting", "path", "rolling", "sweep"]);
    let wears = motion != "sweep" && random.chance(0.8);
    let depth = scales.approach * random.decade(0.003, 10.0);
    let shared = random.share();
    for (body, material) in materials.iter().enumerate() {
        let name = ["upper", "lower"][body];
        let profile = if body == 0 { &profile } else { "profile.flat = {}" };
        // Rigid bodies wear too.
        let part = [shared, 1.0 - shared][body];
        let coefficient = part * depth / (scales.peak * rubbed(motion, &scales));
        let worn = match wears && (body == 0 || random.chance(0.5)) {
            true => format!("wear.archard = {{ coefficient = \"{coefficient:e} 1/Pa\" }}\n"),
            false => String::new(),
        };
        let _ = writeln!(text, "[body.{name}]\n{material}\n{profile}\n{worn}");
    }
    text += &frame(random, &scales, line);
    let slips_everywhere = motion == "sliding" || motion == "indentation" && random.chance(0.5);
    if !slips_everywhere {
        let _ = writeln!(text, "[friction.coulomb]\ncoefficient = {}\n", scales.friction);
    }
    text += &match motion {
        "sliding" => sliding(random, &scales),
        "indentation" => indentation(random, &scales),
        "fretting" => fretting(random, &scales),
        "path" => path(random, &scales, &folder.join(format!("path_{seed}.csv"))),
        _ => rolling(random, &scales, motion == "sweep", wears),
    };
    text
}

/// Like, unlike, rigid on elastic, or incompressible, with the contact modulus E* (Pa).
fn materials(random: &mut Random) -> ([String; 2], f64) {
    let mut elastic = |poisson: Option<f64>| {
        let young = random.decade(1e6, 5e11);
        (young, poisson.unwrap_or_else(|| random.between(0.0, 0.49)))
    };
    let compliance = |(young, poisson): (f64, f64)| (1.0 - poisson * poisson) / young;
    let text = |(young, poisson): (f64, f64)| {
        format!("material = {{ young = \"{young:e} Pa\", poisson = {poisson} }}")
    };
    let first = elastic(None);
    let second = elastic(None);
    let soft = elastic(Some(0.5));
    let near = (first.0 * 3.0, second.1);
    match random.below(6) {
        0 | 1 => ([text(first), text(first)], 0.5 / compliance(first)),
        2 => ([text(first), text(near)], 1.0 / (compliance(first) + compliance(near))),
        3 => ([text(first), text(second)], 1.0 / (compliance(first) + compliance(second))),
        4 => (["rigid = true".to_owned(), text(first)], 1.0 / compliance(first)),
        _ => (["rigid = true".to_owned(), text(soft)], 1.0 / compliance(soft)),
    }
}

/// A sphere, paraboloid or cylinder under some load.
fn contact(random: &mut Random, modulus: f64) -> (String, Scales) {
    let radius = random.decade(1e-4, 1.0);
    let friction = random.decade(0.01, 1.0);
    // Contacts from a hundredth to a tenth of the radius.
    let load = modulus * radius * radius * random.decade(1e-6, 1e-3);
    let other = match random.below(4) {
        0 => radius * random.decade(0.01, 100.0),
        1 => f64::INFINITY,
        _ => radius,
    };
    if other.is_infinite() {
        let length = radius * random.decade(0.1, 100.0);
        let half = (4.0 * load * radius / (std::f64::consts::PI * modulus * length)).sqrt();
        let half = half.min(0.3 * radius);
        let load = half * half * std::f64::consts::PI * modulus * length / (4.0 * radius);
        let peak = 2.0 * load / (std::f64::consts::PI * half * length);
        let scales = Scales {
            semi_axes: [half, 0.5 * length],
            load,
            peak,
            approach: half * half / radius,
            radius,
            friction,
        };
        return (format!("profile.cylinder = {{ radius = \"{radius:e} m\" }}"), scales);
    }
    let hertz = Hertz::from_load([1.0 / radius, 1.0 / other], modulus, load)
        .expect("curvatures, modulus and load are positive");
    let scales = Scales {
        semi_axes: hertz.semi_axes,
        load,
        peak: hertz.peak_pressure,
        approach: hertz.approach,
        radius,
        friction,
    };
    let profile = format!(
        "profile.paraboloid = {{ radius_x = \"{radius:e} m\", radius_y = \"{other:e} m\" }}"
    );
    (profile, scales)
}

/// A frame of 1 to 40 elements along each axis, 0.5 to 30 of them across the contact; a contact of a line is one row or
/// ends with the frame.
fn frame(random: &mut Random, scales: &Scales, line: bool) -> String {
    let (mut size, mut elements) = ([0.0; 2], [0; 2]);
    for axis in 0..2 {
        let across = 2.0 * scales.semi_axes[axis];
        let number = random.decade(0.5, 30.0);
        let beside = random.between(1.1, 3.5);
        let count = (number * beside).round().clamp(2.0, 40.0) as usize;
        (size[axis], elements[axis]) = (count as f64 * across / number, count);
        if line && axis == 1 {
            elements[1] = if random.chance(0.7) { 1 } else { 1 + random.below(9) };
            size[1] = across;
        }
    }
    let [x, y] = size;
    format!("[frame]\nsize = [\"{x:e} m\", \"{y:e} m\"]\nelements = {elements:?}\n\n")
}

/// What a pair rubs, roughly, in all the motion (m).
fn rubbed(motion: &str, scales: &Scales) -> f64 {
    match motion {
        "sliding" => 1.0,
        "rolling" => 100.0 * scales.semi_axes[0] * creepage(scales),
        _ => 10.0 * scales.friction * scales.approach,
    }
}

/// The creepage at which a contact begins to slip all over, roughly.
fn creepage(scales: &Scales) -> f64 {
    scales.friction * scales.semi_axes[0] / scales.radius
}

/// The load, or the approach.
fn control(random: &mut Random, scales: &Scales) -> String {
    match random.chance(0.75) {
        true => format!("load = \"{:e} N\"\n", scales.load),
        false => format!("approach = \"{:e} m\"\n", scales.approach),
    }
}

fn sliding(random: &mut Random, scales: &Scales) -> String {
    let mut text = "[motion.sliding]\ndistance = \"1 m\"\n".to_owned() + &control(random, scales);
    let step = 1.0 / random.between(1.0, 20.0);
    text += &match random.below(3) {
        0 => format!("step = \"{step:e} m\"\n"),
        1 => format!("step = \"{step:e} m\"\nscheme = \"explicit\"\n"),
        _ => format!("tolerance = {:e}\n", random.decade(1e-3, 0.1)),
    };
    text
}

/// Cycles, and jumps over them.
fn cycles(random: &mut Random) -> String {
    match random.below(4) {
        0 => format!("cycles = {}\n", 1 + random.below(4)),
        1 => format!("cycles = {}\njump = {}\n", 10 + random.below(40), 2 + random.below(8)),
        2 => {
            let tolerance = random.decade(0.01, 0.2);
            format!("cycles = {}\ntolerance = {tolerance:e}\n", 10 + random.below(40))
        }
        _ => String::new(),
    }
}

fn indentation(random: &mut Random, scales: &Scales) -> String {
    let mut text = "[motion.indentation]\n".to_owned() + &control(random, scales);
    let _ = writeln!(text, "increments = {}", 1 + random.below(6));
    if random.chance(0.3) {
        text += "release = \"rubbing\"\n";
    }
    if random.chance(0.2) {
        text += "rubbing = \"end\"\n";
    }
    text + &cycles(random)
}

fn fretting(random: &mut Random, scales: &Scales) -> String {
    let mut text = "[motion.fretting]\n".to_owned() + &control(random, scales);
    let by_force = text.contains("load") && random.chance(0.3);
    let (name, unit, size) = match by_force {
        true => ("force_amplitude", "N", scales.friction * scales.load * random.decade(0.05, 0.95)),
        false => ("amplitude", "m", scales.friction * scales.approach * random.decade(0.1, 10.0)),
    };
    let turn = if random.chance(0.7) { 0.0 } else { random.between(0.0, 1.5) };
    let [x, y] = [size * f64::cos(turn), size * f64::sin(turn)];
    let _ = writeln!(text, "{name} = [\"{x:e} {unit}\", \"{y:e} {unit}\"]");
    if random.chance(0.2) {
        let _ = writeln!(text, "phase = \"{:e} rad\"", random.between(0.0, 3.0));
    }
    if text.contains("load") && !by_force && random.chance(0.2) {
        let amplitude = random.between(0.05, 0.9) * scales.load;
        let _ = writeln!(text, "load_amplitude = \"{amplitude:e} N\"\nload_phase = \"1 rad\"");
    }
    let _ = writeln!(text, "increments = {}", 4 * (1 + random.below(3)));
    text + &cycles(random)
}

fn path(random: &mut Random, scales: &Scales, file: &Path) -> String {
    let mut table = "time_s,load_N,shift_x_um,shift_y_um\n".to_owned();
    let shift = 1e6 * scales.friction * scales.approach;
    for line in 0..3 + random.below(3) {
        let load = scales.load * if random.chance(0.15) { 0.0 } else { random.decade(0.01, 1.0) };
        let [x, y] = [random.between(-2.0, 2.0) * shift, random.between(-1.0, 1.0) * shift];
        let _ = writeln!(table, "{line},{load:e},{x:e},{y:e}");
    }
    std::fs::write(file, table).expect("a folder that can be written");
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let increments = 1 + random.below(4);
    format!("[motion.path]\nfile = \"{name}\"\nincrements = {increments}\n")
        + if random.chance(0.3) { "cycles = 3\n" } else { "" }
}

fn rolling(random: &mut Random, scales: &Scales, swept: bool, wears: bool) -> String {
    let name = if swept { "creepage_sweep" } else { "rolling" };
    let mut text = format!("[motion.{name}]\n") + &control(random, scales);
    let sign = if random.chance(0.5) { 1.0 } else { -1.0 };
    match text.contains("load") && random.chance(0.3) {
        true => {
            let force = sign * scales.friction * scales.load * random.decade(0.01, 0.9);
            let _ = writeln!(text, "force = \"{force:e} N\"");
        }
        false => {
            let creepage = sign * creepage(scales) * random.decade(0.01, 30.0);
            let _ = writeln!(text, "creepage = {creepage:e}");
        }
    }
    if random.chance(0.25) {
        let lateral = creepage(scales) * random.between(-2.0, 2.0);
        let _ = writeln!(text, "lateral_creepage = {lateral:e}");
    }
    if random.chance(0.25) {
        let spin = scales.friction / scales.radius * random.between(-2.0, 2.0);
        let _ = writeln!(text, "spin = \"{spin:e} 1/m\"");
    }
    let _ = writeln!(text, "direction = \"{}\"", random.one(&["x", "x", "-x", "y", "-y"]));
    if swept {
        let _ = writeln!(text, "increments = {}", 1 + random.below(5));
        return text;
    }
    let steps = random.between(1.0, 6.0);
    text += &match (wears, random.below(5)) {
        (false, _) | (_, 0) => "revolutions = 0\n".to_owned(),
        (_, 1 | 2) => format!("revolutions = 100\nstep = {:e}\n", 100.0 / steps),
        _ => format!("revolutions = 100\ntolerance = {:e}\n", random.decade(3e-3, 0.1)),
    };
    if random.chance(0.2) {
        text += "radius = \"worn\"\n";
    }
    text
}
