//! Bodies drawn at random, how they wear, and what closed forms say of their contact.

use std::fmt::Write;

use archard::body::{Layer, Material, contact_modulus};
use archard::closed_form::hertz;

use crate::random::Random;

/// What a closed form says of a column.
#[derive(Clone, Copy)]
pub enum Truth {
    /// At all rows.
    Steady(f64),
    /// Over the progress.
    Rate(f64),
}

impl Truth {
    pub fn at(self, progress: f64) -> f64 {
        match self {
            Self::Steady(value) => value,
            Self::Rate(rate) => rate * progress,
        }
    }
}

/// The bodies of a case and what their contact is measured by, after Hertz or about so.
pub struct Contact {
    profile: String,
    materials: [Option<Material>; 2],
    /// A layer on the second.
    layer: Option<Layer>,
    /// Half of the extent along x (m), and radius there (m).
    pub half: f64,
    pub radius: f64,
    pub load: f64,
    peak: f64,
    /// That of a line is what its surfaces come closer by within the contact.
    pub approach: f64,
    pub area: f64,
    /// Length of a line (m).
    pub line: Option<f64>,
    /// Whether closed forms say the above.
    known: bool,
}

/// Either of two materials, or none, which is rigid.
fn materials(random: &mut Random, unlike: bool) -> [Option<Material>; 2] {
    let mut material =
        || Material { young: random.decade(2e9, 4e11), poisson: random.between(0.2, 0.45) };
    let [one, other] = [material(), material()];
    match unlike {
        false => [Some(one); 2],
        true if random.chance(0.3) => [None, Some(other)],
        true => [Some(one), Some(other)],
    }
}

/// The load (N) that makes a contact some thousandths of its radius wide, as long as half-spaces and parabolas hold.
fn small_load(random: &mut Random, modulus: f64, radius: f64) -> f64 {
    modulus * radius * radius * random.decade(1e-8, 1e-6)
}

/// A ball, or a surface of two radii.
fn rounded(random: &mut Random, materials: [Option<Material>; 2]) -> Contact {
    let modulus = contact_modulus(materials.each_ref().map(Option::as_ref));
    let radius = random.decade(1e-3, 0.1);
    let across = if random.chance(0.5) { radius } else { radius * random.decade(0.3, 3.0) };
    let profile = match across == radius {
        true => format!("profile.sphere = {{ radius = \"{radius:e} m\" }}"),
        false => format!(
            "profile.paraboloid = {{ radius_x = \"{radius:e} m\", radius_y = \"{across:e} m\" }}"
        ),
    };
    let load = small_load(random, modulus, radius);
    let hertz = hertz::Hertz::from_load([1.0 / radius, 1.0 / across], modulus, load);
    let hertz = hertz.expect("radii, modulus and load are positive");
    Contact {
        profile,
        materials,
        layer: None,
        half: hertz.semi_axes[0],
        radius,
        load,
        peak: hertz.peak_pressure,
        approach: hertz.approach,
        area: hertz.contact_area(),
        line: None,
        known: true,
    }
}

/// Cylinders that touch along a line.
fn cylinders(random: &mut Random, materials: [Option<Material>; 2]) -> Contact {
    let modulus = contact_modulus(materials.each_ref().map(Option::as_ref));
    let (radius, length) = (random.decade(1e-3, 0.1), random.decade(1e-3, 0.1));
    let load = modulus * radius * length * random.decade(3e-6, 1e-4);
    let line = hertz::Line::from_load(1.0 / radius, modulus, load / length);
    let line = line.expect("radius, modulus and load are positive");
    Contact {
        profile: format!("profile.cylinder = {{ radius = \"{radius:e} m\" }}"),
        materials,
        layer: None,
        half: line.half_width,
        radius,
        load,
        peak: line.peak_pressure,
        approach: line.half_width.powi(2) / radius,
        area: 2.0 * line.half_width * length,
        line: Some(length),
        known: true,
    }
}

/// A body of revolution whose recess is a power of the radius, a cone at times; it touches about as a ball does.
fn powered(random: &mut Random, materials: [Option<Material>; 2]) -> Contact {
    let ball = rounded(random, materials);
    let exponent = if random.chance(0.3) { 1.0 } else { 0.1 * random.between(13.0, 40.0).round() };
    let recess = ball.half * ball.half / (2.0 * ball.radius);
    let coefficient = recess / ball.half.powf(exponent);
    let unit = if exponent == 1.0 { String::new() } else { format!(" m^{:.1}", 1.0 - exponent) };
    let profile = format!(
        "profile.axisymmetric_power = {{ coefficient = \"{coefficient:e}{unit}\", exponent = {exponent:.1} }}"
    );
    Contact { profile, known: false, ..ball }
}

/// The same with a layer on the second body at times, where bodies are unlike: up to three times as thick as the contact is wide.
fn coated(random: &mut Random, contact: Contact) -> Contact {
    let [one, Some(below)] = contact.materials else { return contact };
    if one == Some(below) || random.chance(0.6) {
        return contact;
    }
    let young = below.young * random.decade(0.3, 3.0);
    let material = Material { young, poisson: random.between(0.2, 0.45) };
    let layer = Layer { material, thickness: 2.0 * contact.half * random.decade(0.03, 3.0) };
    Contact { layer: Some(layer), known: false, ..contact }
}

/// Any of these.
pub fn any(random: &mut Random, unlike: f64) -> Contact {
    let unlike = random.chance(unlike);
    let materials = materials(random, unlike);
    let contact = match random.below(5) {
        0 | 1 => cylinders(random, materials),
        2 => powered(random, materials),
        _ => rounded(random, materials),
    };
    coated(random, contact)
}

/// Bodies of that likeness that touch along a line or not.
pub fn smooth(random: &mut Random, unlike: f64, line: bool) -> Contact {
    let unlike = random.chance(unlike);
    let materials = materials(random, unlike);
    let contact = if line { cylinders(random, materials) } else { rounded(random, materials) };
    coated(random, contact)
}

/// Bodies that are of one kind below a layer on the second, nearly incompressible at times.
pub fn layered(random: &mut Random, line: bool) -> Contact {
    let contact = smooth(random, 0.0, line);
    let Some(below) = contact.materials[1] else { return contact };
    let young = below.young * random.decade(0.3, 3.0);
    let material = Material { young, poisson: random.between(0.2, 0.48) };
    let layer = Layer { material, thickness: 2.0 * contact.half * random.decade(0.03, 3.0) };
    Contact { layer: Some(layer), known: false, ..contact }
}

impl Contact {
    /// The largest pressure (Pa) of elastic bodies without layers.
    pub fn peak(&self) -> f64 {
        self.peak
    }

    /// That of the layer (m); endless without one.
    pub fn thickness(&self) -> f64 {
        self.layer.map_or(f64::INFINITY, |layer| layer.thickness)
    }

    pub fn alike(&self) -> bool {
        self.materials[0] == self.materials[1]
    }

    /// The bodies, which wear by these laws.
    pub fn bodies(&self, laws: [&str; 2]) -> String {
        let mut text = String::new();
        for body in 0..2 {
            let material = match self.materials[body] {
                None => "rigid = true".to_owned(),
                Some(Material { young, poisson, .. }) => {
                    format!("material = {{ young = \"{young:e} Pa\", poisson = {poisson} }}")
                }
            };
            let layer = self.layer.filter(|_| body == 1).map_or(String::new(), |Layer { material, thickness }| {
                let Material { young, poisson, .. } = material;
                format!("layers = [{{ thickness = \"{thickness:e} m\", young = \"{young:e} Pa\", poisson = {poisson} }}]\n")
            });
            let (name, law) = (["one", "two"][body], laws[body]);
            let profile = [self.profile.as_str(), "profile.flat = {}"][body];
            let _ = writeln!(text, "[body.{name}]\n{layer}{material}\n{profile}\n{law}");
        }
        if let Some(length) = self.line {
            let _ = writeln!(text, "[frame]\nlength = \"{length:e} m\"\n");
        }
        text
    }

    /// Load, area, pressures and approach of bodies that do not wear, where friction changes none of them.
    pub fn truths(&self) -> Vec<(&'static str, Truth)> {
        let steady = |(column, value)| (column, Truth::Steady(value));
        let pressures = [
            ("load_N", self.load),
            ("contact_area_m2", self.area),
            ("peak_pressure_Pa", self.peak),
            ("centre_pressure_Pa", self.peak),
            ("approach_m", self.approach),
        ];
        let count = if self.line.is_some() { 4 } else { 5 };
        pressures[..if self.known { count } else { 0 }].iter().copied().map(steady).collect()
    }
}

/// A law that wears so deep (m) over so much slip (m), about, and its coefficient where it is Archard's.
pub fn law(random: &mut Random, contact: &Contact, depth: f64, slip: f64) -> (String, Option<f64>) {
    let coefficient = depth / (contact.peak * slip);
    let text = |fields: String| format!("wear.{fields}\n");
    let k = format!("\"{coefficient:e} 1/Pa\"");
    match random.below(6) {
        0 => {
            let (exponent, peak) = (random.between(0.5, 2.0), contact.peak);
            let rest =
                format!("pressure_exponent = {exponent}, reference_pressure = \"{peak:e} Pa\"");
            (text(format!("power = {{ coefficient = {k}, {rest} }}")), None)
        }
        1 => {
            let threshold = contact.peak * random.between(0.05, 0.5);
            let rest = format!("threshold = \"{threshold:e} Pa\"");
            (text(format!("threshold = {{ coefficient = {k}, {rest} }}")), None)
        }
        2 => {
            let distance = slip * random.between(0.1, 0.5);
            let rest = format!("running_in_distance = \"{distance:e} m\"");
            let initial = format!("\"{:e} 1/Pa\"", coefficient * random.between(2.0, 5.0));
            let both = format!("initial_coefficient = {initial}, final_coefficient = {k}");
            (text(format!("running_in = {{ {both}, {rest} }}")), None)
        }
        _ => (text(format!("archard = {{ coefficient = {k} }}")), Some(coefficient)),
    }
}
