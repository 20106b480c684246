//! The plane that the densest part of a surface has between two scans.
//!
//! Planes through the medians of three patches are tried at random (M. A. Fischler and R. C. Bolles, *Comm. ACM* 24 (1981) 381). The best has the
//! greatest sum of exp(-e^2/2 s^2) over all patches, of their distances e from it and the scatter s within patches. It is that of most
//! patches which agree, be they fewer than half: what is worn lies on no plane to within the scatter.

use crate::fit::Normal;
use crate::outliers::median;

/// Patches along each axis: of 14 x 14 a tenth has enough for three numbers.
const PATCHES: usize = 14;
/// Points along a side of a patch at least: twice as many as its plane has numbers.
const SIDE: usize = 4;
/// Planes that are tried: where a seventh of the patches did not wear, eight lie on it.
const TRIED: usize = 3000;
/// Share of the fullest patch's points that another has at least.
const MEASURED: f64 = 0.3;
/// Fewest patches.
pub(super) const FEWEST: usize = 6;

/// A plane and the scatter within patches.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane {
    /// Offset (m).
    pub(super) offset: f64,
    /// Tilts along x and y.
    pub(super) tilt: [f64; 2],
    /// Scatter (m).
    pub(super) scatter: f64,
}

/// The plane of changes (m) at places (m) in a rectangle from the first to the second corner; `None` of too few. Heights are not known better
/// than `floor` (m).
pub(super) fn densest(
    changes: &[([f64; 2], f64)],
    corners: [[f64; 2]; 2],
    floor: f64,
) -> Option<Plane> {
    let side = ((changes.len() as f64).sqrt() as usize / SIDE).clamp(3, PATCHES);
    let mut patches = vec![vec![]; side * side];
    for (place, change) in changes {
        let index = [0, 1].map(|axis| {
            let along = (place[axis] - corners[0][axis]) / (corners[1][axis] - corners[0][axis]);
            ((side as f64 * along).max(0.0) as usize).min(side - 1)
        });
        patches[index[0] + side * index[1]].push((*place, *change));
    }
    let least = MEASURED * patches.iter().map(Vec::len).max()? as f64;
    let full = patches.iter().filter(|points| points.len() > SIDE && points.len() as f64 >= least);
    let (points, mut scatters): (Vec<[f64; 3]>, Vec<f64>) =
        full.filter_map(|one| summary(one.as_slice())).unzip();
    if points.len() < FEWEST {
        return None;
    }
    let scatter = median(&mut scatters)?.max(floor);
    let mut random = Random(1);
    let mut best = (f64::NEG_INFINITY, None);
    for _ in 0..TRIED {
        let [a, b, c] = [(); 3].map(|()| &points[random.below(points.len())]);
        let Some((offset, tilt)) = through(a, b, c) else { continue };
        let near = |[x, y, change]: &[f64; 3]| {
            let far = (change - offset - tilt[0] * x - tilt[1] * y) / scatter;
            (-0.5 * far * far).exp()
        };
        let sum: f64 = points.iter().map(near).sum();
        if sum > best.0 {
            best = (sum, Some(Plane { offset, tilt, scatter }));
        }
    }
    best.1
}

/// Middle and median of a patch, and the scatter about its own plane.
fn summary(points: &[([f64; 2], f64)]) -> Option<([f64; 3], f64)> {
    let count = points.len() as f64;
    let [x, y] = [0, 1].map(|axis| points.iter().map(|one| one.0[axis]).sum::<f64>() / count);
    let median = median(&mut points.iter().map(|one| one.1).collect::<Vec<f64>>())?;
    let mut normal = Normal::new(3);
    let terms = |place: &[f64; 2]| [1.0, place[0] - x, place[1] - y];
    points.iter().for_each(|(place, change)| normal.add(&terms(place), change - median));
    let plane = normal.solved();
    let rest = |(place, change): &([f64; 2], f64)| {
        let own: f64 = terms(place).iter().zip(&plane).map(|(term, factor)| term * factor).sum();
        (change - median - own).powi(2)
    };
    let square = points.iter().map(rest).sum::<f64>() / (count - 3.0).max(1.0);
    Some(([x, y, median], square.sqrt()))
}

/// D. E. Knuth's linear congruential numbers (MMIX).
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % count
    }
}

/// The plane through three points; `None` if they lie on a line, or nearly.
fn through(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> Option<(f64, [f64; 2])> {
    let [u, v] = [b, c].map(|own| [own[0] - a[0], own[1] - a[1], own[2] - a[2]]);
    let area = u[0] * v[1] - u[1] * v[0];
    let sides = u[0].hypot(u[1]) * v[0].hypot(v[1]);
    // An angle of less than 0.1 rad between the sides makes the tilt ten times as uncertain as the points.
    if area.abs() <= 0.1 * sides {
        return None;
    }
    let tilt = [(u[2] * v[1] - u[1] * v[2]) / area, (u[0] * v[2] - u[2] * v[0]) / area];
    Some((a[2] - tilt[0] * a[0] - tilt[1] * a[1], tilt))
}

#[cfg(test)]
mod tests {
    use super::densest;

    /// A plane with 45 % or 75 % lower, all in one part, is found as it is.
    #[test]
    fn what_is_worn_does_not_tilt_the_plane() {
        for end in [36.0, 60.0] {
            let change = |at: usize| {
                let place = [(at % 80) as f64, (at / 80) as f64];
                let bowl = 1.0 - ((place[0] - 0.5 * end) / (0.5 * end)).powi(2);
                let rough = 0.1 * ((7 * at) as f64).sin();
                (place, 2.0 + 0.1 * place[0] - 0.3 * place[1] + rough - 50.0 * bowl.max(0.0))
            };
            let changes: Vec<([f64; 2], f64)> = (0..6400).map(change).collect();
            let plane = densest(&changes, [[0.0; 2], [79.0; 2]], 1e-9).unwrap();
            assert!(
                (plane.offset - 2.0).abs() < 0.5 && (plane.tilt[0] - 0.1).abs() < 0.01,
                "{plane:?}"
            );
            assert!((plane.tilt[1] + 0.3).abs() < 0.01, "{plane:?}");
        }
    }
}
