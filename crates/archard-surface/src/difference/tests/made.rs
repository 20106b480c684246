//! Scans made with a scar whose volume is known, of many kinds. A point has a length of one, heights have the unit of a texture of 0.2.

use std::f64::consts::{PI, TAU};

use super::super::Placement;
use super::super::blocks::smoothed;
use crate::map::HeightMap;

/// What scans are like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Plain,
    Lay,
    Worn10,
    Worn40,
    Worn60,
    OverEdge,
    Spikes,
    HeavyTails,
    Missing30,
    DarkWalls,
    Turned12,
    Walls,
    Steps,
    Bent,
    Alike,
    NoiseFree,
    Copies,
    Unworn,
    Elsewhere,
    ElsewhereByLay,
}

/// Kinds whose volume is found.
pub(super) const KINDS: [Kind; 17] = [
    Kind::Plain,
    Kind::Lay,
    Kind::Worn10,
    Kind::Worn40,
    Kind::Worn60,
    Kind::OverEdge,
    Kind::Spikes,
    Kind::HeavyTails,
    Kind::Missing30,
    Kind::DarkWalls,
    Kind::Turned12,
    Kind::Walls,
    Kind::Steps,
    Kind::Bent,
    Kind::Alike,
    Kind::NoiseFree,
    Kind::Copies,
];

/// Both scans, and what was worn off the later one.
pub(super) struct Scans {
    pub(super) before: HeightMap,
    pub(super) after: HeightMap,
    /// Depths at its points.
    pub(super) worn: Vec<f64>,
    /// The volume, of walls between points, too.
    pub(super) volume: f64,
    pub(super) depth: f64,
}

/// Points along each side.
pub(super) const SIDE: usize = 96;

pub(super) struct Random(fastrand::Rng);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(fastrand::Rng::with_seed(seed))
    }

    pub(super) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.f64()
    }

    pub(super) fn normal(&mut self) -> f64 {
        (-2.0 * (1.0 - self.0.f64()).ln()).sqrt() * (TAU * self.0.f64()).cos()
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.0.usize(..all.len())]
    }

    /// Noise of a standard deviation and a length (points).
    fn noise(&mut self, size: f64, length: f64, n: usize) -> Vec<f64> {
        let margin = (4.0 * length).ceil() as usize;
        let wide = n + 2 * margin;
        let white: Vec<f64> = (0..wide * wide).map(|_| size * self.normal()).collect();
        if length == 0.0 {
            return white;
        }
        let smooth = smoothed([wide; 2], &white, [length; 2]);
        let gain = (4.0 * PI).sqrt() * length;
        let inner = (0..n * n).map(|at| (at % n + margin) + wide * (at / n + margin));
        inner.map(|at| gain * smooth[at]).collect()
    }

    /// A texture of waves of 6 to 40 points, all directions or nearly along x.
    fn texture(&mut self, lay: bool) -> impl Fn([f64; 2]) -> f64 + use<> {
        let waves: Vec<[f64; 3]> = (0..60)
            .map(|_| {
                let k = TAU / self.within(6.0, 40.0);
                let angle = if lay { 0.12 * self.normal() } else { self.within(0.0, TAU) };
                [k * angle.cos(), k * angle.sin(), self.within(0.0, TAU)]
            })
            .collect();
        let size = 0.2 / 30f64.sqrt();
        move |[x, y]| size * waves.iter().map(|[k, l, p]| (k * x + l * y + p).cos()).sum::<f64>()
    }
}

/// The scans of a kind and a seed, of so many points along each side.
pub(super) fn made(kind: Kind, seed: u64, n: usize) -> Scans {
    use Kind::*;
    let mut random = Random::new(1000 * seed + kind as u64);
    let side = n as f64;
    let lay = match kind {
        Lay | ElsewhereByLay => true,
        Plain | Elsewhere => false,
        _ => random.within(0.0, 1.0) < 0.3,
    };
    let share = match kind {
        Worn10 => Some(0.1),
        Worn40 => Some(0.4),
        Worn60 => Some(0.6),
        _ => None,
    };
    let copied = kind == Copies;
    let noise = if share > Some(0.2) { 0.01 } else { random.of(&[0.01, 0.02, 0.05]) };
    let ground = random.texture(lay);
    let elsewhere = random.texture(lay);
    let turn =
        if kind == Turned12 { random.of(&[-0.21, 0.21]) } else { random.within(-0.05, 0.05) };
    let placement = match copied {
        true => Placement::default(),
        false => Placement {
            shift: [random.within(-6.0, 6.0), random.within(-6.0, 6.0)],
            turn,
            offset: 0.5 * random.normal(),
            tilt: [0.01 * random.normal(), 0.01 * random.normal()],
            form: match kind {
                Bent => {
                    [random.of(&[-1.0, 1.0]) * random.within(0.4, 1.6) / (side * side), 0.0, 0.0]
                }
                _ => [0.0; 3],
            },
        },
    };
    let area = side * side * share.unwrap_or_else(|| random.within(0.06, 0.2));
    let aspect = if share.is_some() { random.within(0.7, 1.4) } else { random.within(0.5, 2.0) };
    let half = [(area * aspect / PI).sqrt(), (area / aspect / PI).sqrt()];
    let off = if share.is_some() { 2.0 } else { 0.1 * side };
    let mut middle = [random.within(-off, off), random.within(-off, off)];
    if kind == OverEdge {
        middle[0] = 0.5 * side - 0.3 * half[0];
    }
    let depth = random.within(1.0, 4.0);
    let scar = |[x, y]: [f64; 2]| {
        let [u, v] = [(x - middle[0]) / half[0], (y - middle[1]) / half[1]];
        let far = u.hypot(v);
        match kind {
            Unworn => 0.0,
            DarkWalls => depth * ((1.05 - far) / 0.12).clamp(0.0, 1.0),
            Walls if u.abs().max(v.abs()) < 0.89 => depth,
            Walls => 0.0,
            _ => depth * (1.0 - far * far).max(0.0),
        }
    };
    let blank = HeightMap::new([n; 2], [1.0; 2], vec![0.0; n * n]).unwrap();
    let place = |at: usize| [blank.place(0, at % n), blank.place(1, at / n)];
    let later = |at: usize| {
        let earlier = placement.on_the_earlier(place(at));
        let own = if matches!(kind, Elsewhere | ElsewhereByLay) {
            elsewhere(earlier)
        } else {
            ground(earlier)
        };
        own - scar(place(at)) + placement.level(place(at))
    };
    let worn: Vec<f64> = (0..n * n).map(|at| scar(place(at))).collect();
    let volume = match kind {
        Walls => depth * 4.0 * 0.89 * 0.89 * half[0] * half[1],
        _ => worn.iter().sum(),
    };
    let mut maps = [
        (0..n * n).map(|at| ground(place(at))).collect::<Vec<f64>>(),
        (0..n * n).map(later).collect(),
    ];
    for map in &mut maps {
        let own = match kind {
            NoiseFree | Copies => vec![0.0; n * n],
            Alike => random.noise(noise, 2.0, n),
            _ => random.noise(noise, 0.0, n),
        };
        for (height, own) in map.iter_mut().zip(own) {
            // Student's t of three degrees of freedom: normal over the root of a mean of three squares.
            let squares =
                |random: &mut Random| (0..3).map(|_| random.normal().powi(2)).sum::<f64>();
            *height +=
                if kind == HeavyTails { own / (squares(&mut random) / 3.0).sqrt() } else { own };
        }
        if kind == Spikes {
            for _ in 0..random.within(1.0, 30.0) as usize {
                let at = random.within(0.0, side * side) as usize;
                map[at] += random.of(&[-1.0, 1.0]) * random.of(&[5.0, 20.0, 100.0, 1e6]);
            }
        }
        if kind == Steps {
            map.iter_mut().for_each(|height| *height = (*height / 0.05).round() * 0.05);
        }
    }
    for (at, height) in maps[1].iter_mut().enumerate() {
        let [u, v] = [0, 1].map(|axis| (place(at)[axis] - middle[axis]) / half[axis]);
        let lost = match kind {
            Missing30 => 0.3,
            DarkWalls if (0.9..1.08).contains(&u.hypot(v)) => 0.9,
            _ => 0.0,
        };
        if lost > 0.0 && random.within(0.0, 1.0) < lost {
            *height = f64::NAN;
        }
    }
    let [before, after] = maps.map(|map| blank.of_heights(map));
    Scans { before, after, worn, volume, depth }
}
