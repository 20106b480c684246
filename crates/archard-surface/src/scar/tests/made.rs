//! Profiles of a ring's scar in a block, made with a section that is known, of many kinds.

use faer::{Mat, Side};
use fastrand::Rng;

use super::super::Shape;

/// What profiles are like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Plain,
    Debris,
    Spikes,
    Rough,
    OneSide,
    Cylinder,
    NoFlat,
    Coarse,
}

/// All kinds whose level is told.
pub(super) const KINDS: [Kind; 6] =
    [Kind::Plain, Kind::Debris, Kind::Spikes, Kind::Rough, Kind::Cylinder, Kind::Coarse];

const RADIUS: f64 = 20e-3;
/// The section of the computed shape (m^2).
pub(super) const SECTION: f64 = 0.078e-6;
/// The radius of the cylinder that is worn (m).
const BODY: f64 = 60e-3;
const READINGS: usize = 400;
/// Of a coarse profile one reading in so many is there.
const APART: usize = 13;

/// A profile and what is true of it.
pub(super) struct Made {
    pub readings: Vec<[f64; 2]>,
    pub kind: Kind,
    pub shift: f64,
    pub grown: f64,
    pub section: f64,
}

fn chord(section: f64) -> f64 {
    (12.0 * RADIUS * section).cbrt()
}

/// What a ring has worn off a block.
pub(super) fn ring(x: f64, section: f64) -> f64 {
    let chord = chord(section);
    ((0.25 * chord * chord - x * x) / (2.0 * RADIUS)).max(0.0)
}

/// The shape that a run of the ring would show.
pub(super) fn computed() -> Shape {
    let places: Vec<f64> = (-300..=300).map(|i| 6e-6 * f64::from(i)).collect();
    let worn = places.iter().map(|x| ring(*x, SECTION)).collect();
    Shape::new(places, worn, 2.0 / 3.0).unwrap()
}

/// The height of the unworn body.
pub(super) fn nominal(kind: Kind) -> impl Fn(f64) -> f64 {
    move |x: f64| if kind == Kind::Cylinder { -x * x / (2.0 * BODY) } else { 0.0 }
}

fn normal(random: &mut Rng) -> f64 {
    (-2.0 * (1.0 - random.f64()).ln()).sqrt() * (std::f64::consts::TAU * random.f64()).cos()
}

fn one_of(random: &mut Rng, all: &[f64]) -> f64 {
    all[random.usize(0..all.len())]
}

/// Waves of a length, with a deviation of one.
fn waves(places: &[f64], length: f64, random: &mut Rng) -> Vec<f64> {
    let size = places.len();
    let matrix = Mat::from_fn(size, size, |i, j| {
        let far = (places[i] - places[j]) / length;
        (-0.5 * far * far).exp() + if i == j { 1e-8 } else { 0.0 }
    });
    let root = matrix.llt(Side::Lower).unwrap();
    let white: Vec<f64> = (0..size).map(|_| normal(random)).collect();
    (0..size).map(|i| (0..=i).map(|j| root.L()[(i, j)] * white[j]).sum()).collect()
}

/// A profile of a kind and a seed.
pub(super) fn made(kind: Kind, seed: u64) -> Made {
    let mut random = Rng::with_seed(1000 * kind as u64 + seed);
    let grown = (0.15 * normal(&mut random)).exp();
    let width = chord(SECTION * grown);
    let shift = 0.6e-3 * (random.f64() - 0.5);
    let share = match kind {
        Kind::NoFlat => 0.02,
        Kind::OneSide => 0.4,
        Kind::Coarse => one_of(&mut random, &[0.6, 1.0, 1.4]),
        _ => one_of(&mut random, &[0.1, 0.25, 0.6]),
    };
    let low = shift - 0.5 * width - share * width;
    let high = shift + 0.5 * width + if kind == Kind::OneSide { 0.03 } else { share } * width;
    let step = (high - low) / (READINGS - 1) as f64;
    let places: Vec<f64> = (0..READINGS).map(|i| low + step * i as f64).collect();
    let length = (0.04 + 0.08 * random.f64()) * width;
    // A form that changes between two readings is known to nobody.
    let length = if kind == Kind::Coarse { length.max(1.5 * APART as f64 * step) } else { length };
    let misfit = waves(&places, length, &mut random);
    let texture = waves(&places, 30e-6, &mut random);
    let rough =
        one_of(&mut random, &[0.1e-6, 0.3e-6]) * if kind == Kind::Rough { 5.0 } else { 1.0 };
    let noise = one_of(&mut random, &[0.05e-6, 0.3e-6]);
    let [offset, tilt] = [5e-6 * normal(&mut random), 3e-3 * normal(&mut random)];
    let nominal = nominal(kind);
    let mut section = 0.0;
    let mut readings = vec![];
    for (at, place) in places.iter().enumerate() {
        let x = place - shift;
        let worn = ring(x, SECTION * grown) * (1.0 + 0.04 * misfit[at]);
        section += worn * step;
        let hill = |middle: f64, height: f64| height * (-((x - middle) / 30e-6).powi(2)).exp();
        let debris = match kind {
            Kind::Debris => hill(-0.5 * width - 50e-6, 3e-6) + hill(0.5 * width + 40e-6, 1.5e-6),
            _ => 0.0,
        };
        let own = rough * texture[at] + noise * normal(&mut random) + debris;
        readings.push([*place, nominal(x) - worn + offset + tilt * place + own]);
    }
    if kind == Kind::Spikes {
        for _ in 0..random.usize(2..25) {
            let spike = one_of(&mut random, &[-30e-6, 10e-6, 50e-6, 200e-6]);
            readings[random.usize(0..READINGS)][1] += spike;
        }
    }
    if kind == Kind::Coarse {
        readings = readings.into_iter().step_by(APART).collect();
    }
    Made { readings, kind, shift, grown, section }
}
