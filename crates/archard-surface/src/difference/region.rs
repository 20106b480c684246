//! Where the surface changed: what stands out of the noise, and what belongs to it.
//!
//! Changes are smoothed by Gaussians, each twice as wide as the one before. Spots beyond a threshold are seeds. The
//! threshold is that which the noise of an unworn map passes anywhere once in a hundred maps. What a width finds is left out of the next.
//!
//! A seed takes what it encloses, and grows by rings of two points until the mean change of a ring is no more than chance would have it
//! once in twenty times; that ring and the next such one still belong to it. The edge is so found by means over rings, not point by point, and
//! the sum over a region is not of the positive parts of its noise.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::PI;

use statrs::distribution::{ContinuousCDF, Normal};

use super::noise::Noise;
use crate::filter::gaussian;

/// How often an unworn map has a region by chance.
pub(super) const FALSE_ALARM: f64 = 0.01;
/// How often a ring of unworn points belongs to a region by chance.
const RING: f64 = 0.05;
/// Points across a ring: its edge lies within them.
const ACROSS: f64 = 2.0;
/// Rings as chance has them that belong to a region: the tail of a scar lies below the noise of one ring, and goes on in the next.
const CALM: usize = 2;
/// Points of a region that stand out by themselves, at least; fewer are spikes that were missed.
const FEWEST: usize = 4;
/// Standard deviations from which on a point stands out by itself: 95 % of the others lie within.
pub(super) const CLEAR: f64 = 2.0;
/// Standard deviation (points) of the narrowest Gaussian: the neighbours of a point count as much as it does.
pub(super) const NARROWEST: f64 = 1.5;

/// A region that changed.
#[derive(Debug, Clone)]
pub(super) struct Region {
    /// Whether it is worn, not piled up.
    pub(super) worn: bool,
    /// Points that stand out.
    pub(super) seeds: Vec<usize>,
    /// Its points, measured or not, ring by ring, and those of one ring more.
    points: Vec<usize>,
    /// How many of them are its own.
    end: usize,
}

impl Region {
    /// A worn region of those points, without rings.
    pub(super) fn whole(points: impl Iterator<Item = usize>) -> Self {
        let points: Vec<usize> = points.collect();
        Self { worn: true, seeds: points.clone(), end: points.len(), points }
    }

    /// All its points.
    pub(super) fn points(&self) -> &[usize] {
        &self.points[..self.end]
    }

    /// Those of one ring more.
    pub(super) fn around(&self) -> &[usize] {
        &self.points[self.end..]
    }
}

/// A grid of changes (m), not a number where they are not known.
pub(super) struct Changes<'a> {
    pub(super) elements: [usize; 2],
    pub(super) pixel: [f64; 2],
    pub(super) values: &'a [f64],
    /// Standard deviation (m) of a point that did not change.
    pub(super) scatter: f64,
    /// Where regions may be; everywhere if not given.
    pub(super) within: Option<&'a [bool]>,
}

/// The quantile of the normal distribution that is exceeded so often.
pub(super) fn exceeded(probability: f64) -> f64 {
    Normal::standard().inverse_cdf(1.0 - probability)
}

impl Changes<'_> {
    /// The regions, and the mean depth (m) and width (m) of a spot that would just stand out by the widest Gaussian.
    pub(super) fn regions(&self, noise: &Noise) -> (Vec<Region>, [f64; 2]) {
        let pixel = self.pixel[0].max(self.pixel[1]);
        let side = [0, 1].map(|axis| self.pixel[axis] * self.elements[axis] as f64);
        let widest = side[0].min(side[1]) / 8.0;
        let narrowest = NARROWEST * pixel;
        let widths: Vec<f64> = (0..)
            .map(|power| narrowest * f64::from(1_u32 << power))
            .take_while(|width| *width <= widest.max(narrowest))
            .collect();
        let (mut regions, mut least) = (vec![], [f64::INFINITY; 2]);
        let mut values = self.values.to_vec();
        for width in &widths {
            let deviation = self.pixel.map(|pixel| width / pixel);
            let smooth = noise.smoothed(deviation);
            // Both hills and pits.
            let hills = 0.5 * FALSE_ALARM / widths.len() as f64;
            let threshold = smooth.height_of(hills, self.elements) * smooth.deviation;
            least = [threshold, (4.0 * PI).sqrt() * width];
            let stands_out = |(at, (mean, share)): (usize, (f64, f64))| {
                let within = self.within.is_none_or(|within| within[at]);
                let out = within && mean.abs() * share.sqrt() > threshold;
                if out { mean.signum() as i8 } else { 0 }
            };
            let smooth = gaussian(self.elements, &values, deviation);
            let signs: Vec<i8> = smooth.into_iter().enumerate().map(stands_out).collect();
            let found = self.grown(self.components(&signs, &values), (&values, noise));
            for region in &found {
                region.points().iter().for_each(|&at| values[at] = f64::NAN);
            }
            regions.extend(found);
        }
        (regions, least)
    }

    /// Neighbours of a point, with their distance (m).
    fn neighbours(&self, at: usize) -> impl Iterator<Item = (usize, f64)> + use<> {
        let ([nx, ny], [dx, dy]) = (self.elements, self.pixel);
        let (x, y) = ((at % nx) as isize, (at / nx) as isize);
        let steps =
            (-1..=1).flat_map(|j| (-1..=1).map(move |i| (i, j))).filter(|step| *step != (0, 0));
        steps.filter_map(move |(i, j)| {
            let (x, y) = (x + i, y + j);
            let inside = (0..nx as isize).contains(&x) && (0..ny as isize).contains(&y);
            let far = (i as f64 * dx).hypot(j as f64 * dy);
            inside.then(|| (x as usize + nx * y as usize, far))
        })
    }

    /// Connected points of one sign, enough of them standing out, with what they enclose that has no other sign and no region.
    fn components(&self, signs: &[i8], values: &[f64]) -> Vec<(bool, Vec<usize>)> {
        let mut seen = vec![false; signs.len()];
        let mut found = vec![];
        for start in 0..signs.len() {
            if signs[start] == 0 || seen[start] {
                continue;
            }
            seen[start] = true;
            let mut points = vec![start];
            let mut next = 0;
            while next < points.len() {
                for (at, _) in self.neighbours(points[next]) {
                    if signs[at] == signs[start] && !seen[at] {
                        seen[at] = true;
                        points.push(at);
                    }
                }
                next += 1;
            }
            let clear = |at: &&usize| self.values[**at].abs() > CLEAR * self.scatter;
            if points.iter().filter(clear).count() >= FEWEST {
                let free = |at: &usize| {
                    let taken = values[*at].is_nan() && !self.values[*at].is_nan();
                    signs[*at] == 0 && !taken && self.within.is_none_or(|within| within[*at])
                };
                let enclosed = self.enclosed(&points);
                points.extend(enclosed.into_iter().filter(free));
                found.push((signs[start] < 0, points));
            }
        }
        found
    }

    /// Points that others enclose: no way along rows and columns leads from them to the rim of the map.
    fn enclosed(&self, points: &[usize]) -> Vec<usize> {
        let nx = self.elements[0];
        let ends = points.iter().fold([[usize::MAX, 0]; 2], |[x, y], at| {
            let (i, j) = (at % nx, at / nx);
            [[x[0].min(i), x[1].max(i)], [y[0].min(j), y[1].max(j)]]
        });
        // A frame of one point around all.
        let size = ends.map(|[low, high]| high - low + 3);
        let mut seen = vec![false; size[0] * size[1]];
        let (left, low) = (ends[0][0], ends[1][0]);
        points
            .iter()
            .for_each(|at| seen[at % nx - left + 1 + size[0] * (at / nx - low + 1)] = true);
        let mut open = vec![0];
        seen[0] = true;
        while let Some(at) = open.pop() {
            let (x, y) = (at % size[0], at / size[0]);
            let near = [
                (x > 0).then(|| at - 1),
                (x + 1 < size[0]).then(|| at + 1),
                (y > 0).then(|| at - size[0]),
                (y + 1 < size[1]).then(|| at + size[0]),
            ];
            for next in near.into_iter().flatten() {
                if !seen[next] {
                    seen[next] = true;
                    open.push(next);
                }
            }
        }
        let inner = (0..seen.len()).filter(|&at| !seen[at]);
        inner.map(|at| at % size[0] + left - 1 + nx * (at / size[0] + low - 1)).collect()
    }

    /// Regions around seeds; points that belong to others already have no value.
    fn grown(
        &self,
        seeds: Vec<(bool, Vec<usize>)>,
        (values, noise): (&[f64], &Noise),
    ) -> Vec<Region> {
        let width = ACROSS * self.pixel[0].max(self.pixel[1]);
        let nearest = self.nearest(&seeds, values);
        // Points of each seed by their ring, the first within the seed.
        let mut rings: Vec<Vec<Vec<usize>>> = vec![vec![]; seeds.len()];
        for (at, (far, owner)) in nearest.iter().enumerate() {
            let Some(own) = owner.and_then(|owner| rings.get_mut(owner)) else { continue };
            let ring = (far / width - 1e-9).ceil().max(0.0) as usize;
            if own.len() <= ring {
                own.resize(ring + 1, vec![]);
            }
            own[ring].push(at);
        }
        let chance = exceeded(RING) * (noise.variance * noise.alike).sqrt();
        let grow = |((worn, seeds), rings): ((bool, Vec<usize>), Vec<Vec<usize>>)| {
            let belongs = |ring: &Vec<usize>| {
                let known = ring.iter().map(|&at| values[at]).filter(|value| !value.is_nan());
                let (sum, count) =
                    known.fold((0.0, 0.0_f64), |(sum, n), value| (sum + value, n + 1.0));
                let sum = if worn { -sum } else { sum };
                count > 0.0 && sum > chance * count.sqrt()
            };
            let mut calm = 0;
            let own = rings.iter().skip(1).take_while(|ring| {
                let more = calm < CALM;
                calm += usize::from(!belongs(ring));
                more
            });
            let last = 1 + own.count();
            let end = rings.iter().take(last).map(Vec::len).sum();
            let points = rings.iter().take(last + 1).flatten().copied().collect();
            Region { worn, seeds, points, end }
        };
        seeds.into_iter().zip(rings).map(grow).collect()
    }

    /// The distance (m) of each point from the nearest seed, and which it is; only through points that belong to none.
    fn nearest(&self, seeds: &[(bool, Vec<usize>)], values: &[f64]) -> Vec<(f64, Option<usize>)> {
        let mut found = vec![(f64::INFINITY, None); values.len()];
        let mut queue = BinaryHeap::new();
        // Distances are positive: their bits rise as they do.
        let reach = |found: &mut Vec<(f64, Option<usize>)>, at: usize, far: f64, owner| {
            if far < found[at].0 {
                found[at] = (far, Some(owner));
                return Some(Reverse((far.to_bits(), at)));
            }
            None
        };
        for (owner, (_, points)) in seeds.iter().enumerate() {
            queue.extend(points.iter().filter_map(|&at| reach(&mut found, at, 0.0, owner)));
        }
        while let Some(Reverse((bits, from))) = queue.pop() {
            let (far, Some(owner)) = found[from] else { continue };
            if far.to_bits() != bits {
                continue;
            }
            for (at, step) in self.neighbours(from) {
                let taken = values[at].is_nan() && !self.values[at].is_nan();
                let within = self.within.is_none_or(|within| within[at]);
                if within && !taken {
                    queue.extend(reach(&mut found, at, far + step, owner));
                }
            }
        }
        found
    }
}
