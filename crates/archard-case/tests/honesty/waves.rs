//! Waves that repeat themselves, drawn at random, and what Westergaard says of those along one axis.

use std::f64::consts::PI;

use archard::body::{Material, contact_modulus};

use crate::contact::Truth;
use crate::random::Random;

/// A wavy body on a flat one of the same material.
pub struct Waves {
    material: Material,
    pub amplitude: f64,
    length: f64,
    /// Whether there are waves along y, too.
    across: bool,
    /// The mean pressure (Pa), and the largest one of waves along x.
    pub mean: f64,
    pub peak: f64,
    /// Share of the pressure that flattens the waves.
    share: f64,
}

impl Waves {
    /// Waves along x, or along both axes, under a load that does not flatten them.
    pub fn new(random: &mut Random, across: bool) -> Self {
        let material =
            Material { young: random.decade(2e9, 4e11), poisson: random.between(0.2, 0.45) };
        let modulus = contact_modulus([Some(&material); 2]);
        let length = random.decade(1e-4, 1e-2);
        let amplitude = length * random.decade(1e-4, 3e-3);
        let share = random.between(0.1, 0.8);
        let flattens = PI * modulus * amplitude / length;
        let (mean, peak) = (share * flattens, 2.0 * share.sqrt() * flattens);
        Self { material, amplitude, length, across, mean, peak, share }
    }

    /// The bodies and their frame; the wavy one wears and yields so.
    pub fn bodies(&self, law: &str, hardness: Option<f64>) -> String {
        let Self { material: Material { young, poisson, .. }, amplitude, length, across, .. } =
            self;
        let material = format!("material = {{ young = \"{young:e} Pa\", poisson = {poisson} }}\n");
        let waves = if *across { format!(", length_y = \"{length:e} m\"") } else { String::new() };
        let hardness = hardness.map_or(String::new(), |own| format!("hardness = \"{own:e} Pa\"\n"));
        let frame = match across {
            true => format!("size = [\"{length:e} m\", \"{length:e} m\"]\nelements = [48, 48]\n"),
            false => format!("plane_strain = true\nsize = \"{length:e} m\"\nelements = 128\n"),
        };
        format!(
            "[body.one]\n{material}profile.wave = {{ amplitude = \"{amplitude:e} m\", length_x = \"{length:e} m\"{waves} }}\n\
             {law}{hardness}\n[body.two]\n{material}profile.flat = {{}}\n\n[frame]\nperiodic = true\n{frame}\n"
        )
    }

    /// H. M. Westergaard, *J. Appl. Mech.* 6 (1939) A49: sin^2(pi a/length) is the share of the pressure that flattens the waves, a
    /// half of the width.
    pub fn truths(&self) -> Vec<(&'static str, Truth)> {
        let width = 2.0 * self.share.sqrt().asin() * self.length / PI;
        let truths = [
            ("peak_pressure_Pa", self.peak),
            ("centre_pressure_Pa", self.peak),
            // Of a line a metre long.
            ("contact_area_m2", width),
        ];
        let known = if self.across { 0 } else { truths.len() };
        truths[..known].iter().map(|(name, value)| (*name, Truth::Steady(*value))).collect()
    }
}
