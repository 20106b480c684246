//! The layers of a body, and what is below them: what each bears beyond a half-space of its material.
//!
//! A piece of a stack bears two [waves](super::super::stack) for each wave of tractions: one down from its upper face, one up from its
//! lower one. Their tractions on these faces, those of the half-space left out, are written as sums of exponentials of the wave number,
//! `a exp(-k d)`: images at distances d behind the face, each with the field of a half-space whose surface is that face. So at every
//! depth of the piece the stresses and displacements are those of an elastic body of its material, however few images there are.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::super::images::{COUNT, DEPTHS, SAMPLES, WAVES, fit, geometric};
use super::super::stack::{Stack, Tractions};
use super::far::Far;
use crate::body::{Layer, Material};

/// The distance of the first image over that by which the tractions decay: less, for what decays as a polynomial times it. A choice that
/// misses moduli of ratios up to 50 by 1e-5 at most.
const FIRST: f64 = 0.5;
/// By how much a stress may be missed, relative to what its tractions are: (1 + q) exp(-q) and the like are less than one, and three
/// such terms make a component.
const TERMS: f64 = 3.0;
/// The wave number that stands for the longest waves, over the least that is fitted: it differs from them by rounding.
const LONGEST: f64 = 1e-6;
/// Depths whose kernels are kept. A choice of memory.
const KEPT: usize = 256;

/// Unit tractions on a surface.
const HALF_SPACE: Tractions = [0.0, -1.0, 1.0, 0.0, -1.0];

/// A traction behind a face of a piece.
#[derive(Debug, Clone, Copy)]
struct Image {
    /// How far behind (m).
    behind: f64,
    tractions: Tractions,
}

/// What the images of a piece are seen as at a depth: a term of the stresses and displacements of a wave of tractions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seen {
    /// How far away it is (m), by which it decays.
    pub distance: f64,
    /// How far away the face is (m), which multiplies the second of each.
    pub from: f64,
    /// Components from pressure: zz, ss, nn, sz; from a traction along the wave: the same; from one across it: nz, sn. Then the same
    /// times the wave number.
    pub stress: [[f64; 10]; 2],
    /// Displacements times twice the shear modulus and the wave number: from pressure along the wave and into the body, from a
    /// traction along it the same, from one across it. Then the same times the wave number.
    pub moved: [[f64; 5]; 2],
}

/// The images of a piece behind its two faces, and by how much they miss its stresses, relative to the tractions.
#[derive(Debug)]
struct Images {
    faces: [Vec<Image>; 2],
    missed: f64,
}

/// Layers from the surface down, and what is below them.
pub(super) struct Layers {
    layers: Vec<Layer>,
    base: Option<Material>,
    images: Vec<OnceLock<Images>>,
    far: Mutex<HashMap<(usize, u64), Arc<Far>>>,
}

impl Layers {
    pub fn new(layers: &[Layer], base: Option<Material>) -> Self {
        let pieces = layers.len() + usize::from(base.is_some());
        let images = (0..pieces).map(|_| OnceLock::new()).collect();
        Self { layers: layers.to_vec(), base, images, far: Mutex::default() }
    }

    /// How many pieces there are: layers, and what is below them unless that is rigid.
    pub fn count(&self) -> usize {
        self.images.len()
    }

    /// The piece with that index.
    pub fn material(&self, piece: usize) -> Material {
        let uppermost = self.layers[0].material;
        self.layers.get(piece).map(|layer| layer.material).or(self.base).unwrap_or(uppermost)
    }

    /// What is below all layers, unless it is rigid.
    pub fn base(&self) -> Option<Material> {
        self.base
    }

    /// How deep (m) a piece begins and ends.
    pub fn faces(&self, piece: usize) -> [f64; 2] {
        let above = self.layers[..piece].iter();
        let top = above.fold(0.0, |top, layer| top + layer.thickness);
        let end = self.layers.get(piece).map_or(f64::INFINITY, |layer| top + layer.thickness);
        [top, end]
    }

    /// The piece at a depth (m): on an interface the one above.
    pub fn at(&self, depth: f64) -> usize {
        let found = (0..self.count()).find(|&piece| depth <= self.faces(piece)[1]);
        found.unwrap_or(self.count() - 1)
    }

    /// By how much its images miss the stresses in a piece, relative to the tractions.
    pub fn missed(&self, piece: usize) -> f64 {
        self.images(piece).missed
    }

    fn images(&self, piece: usize) -> &Images {
        self.images[piece].get_or_init(|| self.fitted(piece))
    }

    fn fitted(&self, piece: usize) -> Images {
        let stack = Stack { layers: &self.layers, base: self.base.as_ref(), hollow: None };
        let [top, end] = self.faces(piece);
        let half_space = |k: f64| -> Tractions {
            let q = k * top;
            [q, -(1.0 + q), 1.0 - q, q, -1.0].map(|value| value * (-q).exp())
        };
        let rest = |k: f64| {
            let [mut down, up] = stack.waves(piece, k);
            down.iter_mut().zip(half_space(k)).for_each(|(own, less)| *own -= less);
            [down, up]
        };
        let last = DEPTHS[1] * stack.reach();
        let face = |side: usize, decay: f64| {
            let first = FIRST * decay;
            let behind = geometric(first, last.max(COUNT as f64 * first), COUNT);
            let waves = [WAVES[0] / behind[COUNT - 1], WAVES[1] / decay];
            let longest = rest(LONGEST * waves[0])[side];
            let waves = geometric(waves[0], waves[1], SAMPLES * COUNT);
            let wanted: Vec<Tractions> = waves.iter().map(|&k| rest(k)[side]).collect();
            let fitted = fit((&behind, stack.reach()), &waves, (&wanted, Some(longest)));
            let (weights, missed) = fitted.unwrap_or((vec![], f64::INFINITY));
            let image =
                |(behind, tractions): (&f64, Tractions)| Image { behind: *behind, tractions };
            (behind.iter().zip(weights).map(image).collect(), missed)
        };
        // What comes down from the surface itself has been up from the interface before.
        let (down, one) = face(0, if piece == 0 { 2.0 * end } else { top });
        let (up, other) = if end.is_finite() { face(1, end) } else { (vec![], 0.0) };
        Images { faces: [down, up], missed: TERMS * (one + other) }
    }

    /// What the images of a piece are at a depth (m).
    pub fn seen(&self, piece: usize, depth: f64) -> Vec<Seen> {
        let [top, end] = self.faces(piece);
        let poisson = self.material(piece).poisson;
        let [down, up] = &self.images(piece).faces;
        let down = down.iter().map(|image| image.seen(1.0, depth - top, poisson));
        down.chain(up.iter().map(|image| image.seen(-1.0, end - depth, poisson))).collect()
    }

    /// The components of a wave of tractions of that number (1/m) at a depth (m), and its displacements times twice the shear modulus
    /// (m), in the order of those of [`Seen`].
    pub fn wave(&self, piece: usize, depth: f64, k: f64) -> ([f64; 10], [f64; 5]) {
        let stack = Stack { layers: &self.layers, base: self.base.as_ref(), hollow: None };
        let ([top, end], poisson) = (self.faces(piece), self.material(piece).poisson);
        let mut sum = ([0.0; 10], [0.0; 5]);
        let [down, up] = stack.waves(piece, k);
        for (tractions, side, from) in [(down, 1.0, depth - top), (up, -1.0, end - depth)] {
            if from.is_finite() {
                let (stress, moved) =
                    Image { behind: 0.0, tractions }.seen(side, from, poisson).wave(k);
                sum.0.iter_mut().zip(stress).for_each(|(sum, own)| *sum += own);
                sum.1.iter_mut().zip(moved).for_each(|(sum, own)| *sum += own);
            }
        }
        sum
    }

    /// What elements that are not close by do at a depth (m).
    pub fn far(&self, piece: usize, depth: f64) -> Arc<Far> {
        let key = (piece, depth.to_bits());
        let kept = || self.far.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = kept().get(&key) {
            return known.clone();
        }
        let made = Arc::new(Far::of(self.seen(piece, depth)));
        let mut kept = kept();
        if kept.len() >= KEPT {
            kept.clear();
        }
        kept.insert(key, made.clone());
        made
    }
}

impl Seen {
    /// The components of a wave of that number (1/m), and its displacements times twice the shear modulus (m).
    pub fn wave(&self, k: f64) -> ([f64; 10], [f64; 5]) {
        let (decay, q) = ((-k * self.distance).exp(), k * self.from);
        let stress = std::array::from_fn(|i| decay * (self.stress[0][i] + q * self.stress[1][i]));
        let moved = |i: usize| decay * (self.moved[0][i] / k + self.from * self.moved[1][i]);
        (stress, std::array::from_fn(moved))
    }
}

/// What a half-space is at a depth (m): the tractions themselves.
pub(super) fn half_space(depth: f64, poisson: f64) -> Seen {
    Image { behind: 0.0, tractions: HALF_SPACE }.seen(1.0, depth, poisson)
}

impl Image {
    /// What it is so far (m) from its face: with N and S its tractions on the face, S reversed where it goes up, q = k z and E = exp(-q)
    ///
    /// ```text
    /// zz = N (1 + q) + S q    sz = -N q + S (1 - q)    ss = N (1 - q) + S (2 - q)    nn = 2 nu (N + S)
    /// 2 G k u_s = q (N + S) - 2 (1 - nu) S - (1 - 2 nu) N    2 G k u_z = -q (N + S) - (1 - 2 nu) S - 2 (1 - nu) N
    /// ```
    ///
    /// times E, where what is odd in z has the sign of the direction.
    fn seen(&self, side: f64, from: f64, poisson: f64) -> Seen {
        let [shear, normal, sheared, pulled, across] = self.tractions;
        let (far, near) = (1.0 - 2.0 * poisson, 2.0 - 2.0 * poisson);
        let of = |shear: f64, normal: f64| {
            let s = side * shear;
            let both = normal + s;
            let stress = [
                [normal, normal + 2.0 * s, 2.0 * poisson * both, shear],
                [both, -both, 0.0, -side * both],
            ];
            let moved = [
                [-(near * s + far * normal), -side * (far * s + near * normal)],
                [both, -side * both],
            ];
            (stress, moved)
        };
        let (one, moved) = of(shear, normal);
        let (other, pushed) = of(sheared, pulled);
        let sides = [across, -side * across];
        let joined = |power: usize, sides: [f64; 2], moved_across: f64| {
            let ([a, b, c, d], [e, f, g, h]) = (one[power], other[power]);
            // A traction along the wave is of the other phase: i S is its sz, and i times i is -1.
            let stress = [a, b, c, d, e, f, g, -h, sides[0], sides[1]];
            let ([u, w], [v, x]) = (moved[power], pushed[power]);
            (stress, [u, w, -v, x, moved_across])
        };
        let (stress, moved) = joined(0, sides, 2.0 * sides[1]);
        let (times, moving) = joined(1, [0.0; 2], 0.0);
        let distance = self.behind + from;
        Seen { distance, from, stress: [stress, times], moved: [moved, moving] }
    }
}
