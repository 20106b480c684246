//! Made rough surfaces.

use std::f64::consts::TAU;

use archard::body::Material;
use archard::body::profile::Flat;
use archard::compliance::{Compliance, HalfSpace, Periodic};
use archard::frame::{ContactFrame, Measure};
use archard::motion::Control;
use archard::solve::Step;

/// Side of the frame (m), rms slope, and what the flat is made of; the surface is rigid.
const SIDE: f64 = 1e-3;
const SLOPE: f64 = 0.1;
const STEEL: Material = Material { young: 210e9, poisson: 0.3 };

/// A self-affine surface on a flat, alone or repeating itself.
pub struct OnAFlat {
    frame: ContactFrame,
    gap: Vec<f64>,
    addition: Vec<f64>,
    compliance: Box<dyn Compliance>,
    repeats: bool,
}

impl OnAFlat {
    /// One of `n` by `n` elements.
    pub fn new(n: usize, repeats: bool) -> Self {
        let heights = self_affine(n, SIDE / n as f64, SLOPE, 1);
        let highest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let gap: Vec<f64> = heights.into_iter().map(|height| highest - height).collect();
        let frame = ContactFrame::uniform([SIDE; 2], [n; 2], [&Flat, &Flat]).expect("a frame");
        let bodies = [None, Some(&STEEL)];
        let compliance: Box<dyn Compliance> = if repeats {
            Box::new(Periodic::new(bodies, [&[], &[]], [0.0, SIDE], &frame))
        } else {
            Box::new(HalfSpace::new(bodies, &frame))
        };
        Self { frame, addition: vec![0.0; gap.len()], gap, compliance, repeats }
    }

    /// Pressed by a mean pressure over E* and rms slope.
    pub fn pressed(&self, pressure: f64) -> Step<'_> {
        let modulus = STEEL.young / (1.0 - STEEL.poisson * STEEL.poisson);
        Step {
            compliance: &*self.compliance,
            gap: &self.gap,
            addition: &self.addition,
            elements: self.frame.elements(),
            measure: Measure { closed: self.repeats, ..self.frame.measure() },
            control: Control::Load(pressure * modulus * SLOPE * SIDE * SIDE),
            hardness: f64::INFINITY,
        }
    }
}

/// Hurst exponent of the surfaces.
const HURST: f64 = 0.8;

/// Heights (m) of a self-affine surface of `n` by `n` points `spacing` (m) apart, with the root mean square slope `slope`:
/// waves from the longest that fits down to one of eight points, amplitudes as k^-(1 + H), phases at random.
///
/// T. D. B. Jacobs, T. Junge and L. Pastewka, *Surf. Topogr.: Metrol. Prop.* 5 (2017) 013001.
pub fn self_affine(n: usize, spacing: f64, slope: f64, seed: u64) -> Vec<f64> {
    let most = (n / 8) as i64;
    let mut random = SplitMix(seed);
    // Waves of one half of the plane: along x from zero, along y in both directions.
    let mut waves = vec![];
    for i in 0..=most {
        for j in -most..=most {
            let phase = TAU * random.next();
            let square = (i * i + j * j) as f64;
            let twice = i == 0 && j <= 0;
            if !twice && square <= (most * most) as f64 {
                waves.push(([i, j], square.powf(-0.5 * (1.0 + HURST)), phase));
            }
        }
    }
    // Mean square of the slope of waves a cos(k x).
    let wave_number = |[i, j]: [i64; 2]| TAU * (i as f64).hypot(j as f64) / (n as f64 * spacing);
    let squares = waves.iter().map(|(wave, a, _)| 0.5 * (a * wave_number(*wave)).powi(2));
    let scale = slope / squares.sum::<f64>().sqrt();
    let turn = |steps: i64| {
        let angle = TAU * steps.rem_euclid(n as i64) as f64 / n as f64;
        [angle.cos(), angle.sin()]
    };
    let turns: Vec<[f64; 2]> = (0..n as i64).map(turn).collect();
    let mut heights = vec![0.0; n * n];
    for along in waves.chunk_by(|one, other| one.0[0] == other.0[0]) {
        let i = along[0].0[0];
        for (y, row) in heights.chunks_mut(n).enumerate() {
            let mut sum = [0.0; 2];
            for ([_, j], amplitude, phase) in along {
                let [c, s] = turns[(j * y as i64).rem_euclid(n as i64) as usize];
                let (sin, cos) = phase.sin_cos();
                sum[0] += scale * amplitude * (c * cos - s * sin);
                sum[1] += scale * amplitude * (s * cos + c * sin);
            }
            for (x, height) in row.iter_mut().enumerate() {
                let [c, s] = turns[(i * x as i64) as usize % n];
                *height += c * sum[0] - s * sum[1];
            }
        }
    }
    heights
}

/// Numbers between 0 and 1: G. Steele, D. Lea and C. Flood, *OOPSLA* (2014) 453.
struct SplitMix(u64);

impl SplitMix {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}
