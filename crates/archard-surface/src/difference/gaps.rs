//! Points that were not measured, where the surface changed.
//!
//! They are filled by a thin plate, the surface with the least sum of squared second differences, which goes on in slope and in bend (G. Wahba,
//! *Spline Models for Observational Data*, SIAM 1990), and by a membrane, of first differences, which goes on in height alone. The truth lies
//! between both, or about as far beyond. Both are linear in the points around: a sum over them has weights of these, and their noise.

use crate::map::HeightMap;

/// The slot of a point that is not sought.
const NONE: usize = usize::MAX;
/// Rest of the residual at which a surface is found, relative to the first.
const FOUND: f64 = 1e-8;
/// Side (points) of a square without any point from which on a gap is wide: a wall would be seen by none of its neighbours.
const WIDE: usize = 3;
/// How far (points) around wide gaps heights are looked for, at most. A choice of cost.
const FAR: usize = 20;

/// Surfaces that go on over points that were not measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Surface {
    Plate,
    Membrane,
}

/// A row of differences: points with their factors.
type Row = Vec<(usize, f64)>;

/// A surface over points of a map.
pub(super) struct Gaps {
    /// Points without a height that are sought.
    pub(super) points: Vec<usize>,
    /// Which of them a point is.
    slot: Vec<usize>,
    rows: Vec<Row>,
}

impl Gaps {
    /// Over points without a height of a map, those that `wanted` has.
    pub(super) fn of(map: &HeightMap, wanted: &[bool], surface: Surface) -> Self {
        let points: Vec<usize> =
            (0..wanted.len()).filter(|&at| wanted[at] && map.heights()[at].is_nan()).collect();
        let mut slot = vec![NONE; wanted.len()];
        points.iter().enumerate().for_each(|(own, &at)| slot[at] = own);
        let known = |at: usize| slot[at] != NONE || !map.heights()[at].is_nan();
        let [nx, ny] = map.elements();
        let [x, y] = map.pixel().map(|own| map.pixel()[0] / own);
        let root = 2f64.sqrt() * x * y;
        let stencils: Vec<Vec<([usize; 2], f64)>> = match surface {
            Surface::Plate => vec![
                vec![([0, 0], x * x), ([1, 0], -2.0 * x * x), ([2, 0], x * x)],
                vec![([0, 0], y * y), ([0, 1], -2.0 * y * y), ([0, 2], y * y)],
                vec![([0, 0], root), ([1, 0], -root), ([0, 1], -root), ([1, 1], root)],
            ],
            Surface::Membrane => {
                vec![vec![([0, 0], -x), ([1, 0], x)], vec![([0, 0], -y), ([0, 1], y)]]
            }
        };
        let mut rows = vec![];
        for corner in 0..wanted.len() {
            let (left, low) = (corner % nx, corner / nx);
            for stencil in &stencils {
                let inside = stencil.iter().all(|([i, j], _)| left + i < nx && low + j < ny);
                let row = || stencil.iter().map(|([i, j], by)| (corner + i + nx * j, *by));
                if inside && row().any(|(at, _)| slot[at] != NONE) && row().all(|(at, _)| known(at))
                {
                    rows.push(row().collect());
                }
            }
        }
        Self { points, slot, rows }
    }

    /// Differences of unknowns, and their sums back.
    fn applied(&self, unknowns: &[f64]) -> Vec<f64> {
        let own = |(at, by): &(usize, f64)| {
            if self.slot[*at] == NONE { 0.0 } else { by * unknowns[self.slot[*at]] }
        };
        let differences: Vec<f64> = self.rows.iter().map(|row| row.iter().map(own).sum()).collect();
        self.back(&differences)
    }

    fn back(&self, differences: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.points.len()];
        for (row, difference) in self.rows.iter().zip(differences) {
            for (at, by) in row.iter().filter(|(at, _)| self.slot[*at] != NONE) {
                sums[self.slot[*at]] += by * difference;
            }
        }
        sums
    }

    /// Conjugate gradients, with the diagonal as their measure.
    fn solved(&self, right: Vec<f64>) -> Vec<f64> {
        let mut diagonal = vec![0.0; right.len()];
        for (at, by) in self.rows.iter().flatten().filter(|(at, _)| self.slot[*at] != NONE) {
            diagonal[self.slot[*at]] += by * by;
        }
        let measured = |rest: &[f64]| -> Vec<f64> {
            let own = |(one, by): (&f64, &f64)| if *by > 0.0 { one / by } else { 0.0 };
            rest.iter().zip(&diagonal).map(own).collect()
        };
        let dot = |one: &[f64], other: &[f64]| -> f64 {
            one.iter().zip(other).map(|(one, other)| one * other).sum()
        };
        let mut found = vec![0.0; right.len()];
        let mut rest = right;
        let mut near = measured(&rest);
        let mut way = near.clone();
        let mut size = dot(&rest, &near);
        let aim = FOUND * FOUND * size;
        for _ in 0..4 * rest.len() {
            if size <= aim {
                break;
            }
            let image = self.applied(&way);
            let length = size / dot(&way, &image);
            found.iter_mut().zip(&way).for_each(|(one, way)| *one += length * way);
            rest.iter_mut().zip(&image).for_each(|(one, image)| *one -= length * image);
            near = measured(&rest);
            let next = dot(&rest, &near);
            way.iter_mut().zip(&near).for_each(|(one, near)| *one = near + next / size * *one);
            size = next;
        }
        found
    }

    /// The map with the heights of the surface in its gaps.
    pub(super) fn filled(&self, map: &HeightMap) -> HeightMap {
        let known = |(at, by): &(usize, f64)| {
            if self.slot[*at] == NONE { -by * map.heights()[*at] } else { 0.0 }
        };
        let differences: Vec<f64> =
            self.rows.iter().map(|row| row.iter().map(known).sum()).collect();
        let found = self.solved(self.back(&differences));
        let mut heights = map.heights().to_vec();
        self.points.iter().zip(found).for_each(|(&at, height)| heights[at] = height);
        map.of_heights(heights)
    }

    /// The weights of points around in a sum over the gaps: each point has its own.
    pub(super) fn weights(&self, own: &[f64]) -> Vec<f64> {
        let factors = self.solved(self.points.iter().map(|&at| own[at]).collect());
        let mut weights = vec![0.0; self.slot.len()];
        for row in &self.rows {
            let inner = |(at, by): &(usize, f64)| {
                if self.slot[*at] == NONE { 0.0 } else { by * factors[self.slot[*at]] }
            };
            let sum: f64 = row.iter().map(inner).sum();
            for (at, by) in row.iter().filter(|(at, _)| self.slot[*at] == NONE) {
                weights[*at] -= by * sum;
            }
        }
        weights
    }

    /// Half of the range of the heights (m) around each point in a gap that is wide; nothing where it is not.
    pub(super) fn ranges(&self, map: &HeightMap) -> Vec<(usize, f64)> {
        let [nx, ny] = map.elements();
        let missing = |x: usize, y: usize| self.slot[x + nx * y] != NONE;
        let mut wide = vec![false; nx * ny];
        for y in 0..(ny + 1).saturating_sub(WIDE) {
            for x in 0..(nx + 1).saturating_sub(WIDE) {
                let cells = || (0..WIDE * WIDE).map(|cell| (x + cell % WIDE, y + cell / WIDE));
                if cells().all(|(x, y)| missing(x, y)) {
                    cells().for_each(|(x, y)| wide[x + nx * y] = true);
                }
            }
        }
        let around = |at: usize, far: usize| {
            let (x, y) = (at % nx, at / nx);
            let rows = y.saturating_sub(far)..(y + far + 1).min(ny);
            rows.flat_map(move |y| {
                (x.saturating_sub(far)..(x + far + 1).min(nx)).map(move |x| x + nx * y)
            })
        };
        let measured = |at: &usize| !map.heights()[*at].is_nan();
        let half = |at: usize| (1..FAR).find(|&far| around(at, far).any(|at| measured(&at)));
        let gaps: Vec<usize> = self.points.iter().copied().filter(|&at| wide[at]).collect();
        // From the middle of the widest gap both of its sides are seen.
        let far = gaps.iter().map(|&at| half(at).unwrap_or(FAR)).max().unwrap_or(0);
        let range = |at: usize| {
            let heights =
                around(at, (far + 1).min(FAR)).filter(measured).map(|at| map.heights()[at]);
            let ends = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], own| {
                [low.min(own), high.max(own)]
            });
            (at, 0.5 * (ends[1] - ends[0]).max(0.0))
        };
        gaps.into_iter().map(range).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Gaps, Surface};
    use crate::map::HeightMap;

    fn map(height: impl Fn(f64, f64) -> f64, missing: impl Fn(usize, usize) -> bool) -> HeightMap {
        let own = |at: usize| {
            let (x, y) = (at % 24, at / 24);
            if missing(x, y) { f64::NAN } else { height(x as f64, y as f64) }
        };
        HeightMap::new([24, 20], [1.0, 2.0], (0..480).map(own).collect()).unwrap()
    }

    /// A plane has no second differences: the plate goes on with it, also at the rim. A membrane is level there.
    #[test]
    fn plates_go_on_with_planes() {
        let plane = |x: f64, y: f64| 3.0 + 0.5 * x - 0.7 * y;
        let holed =
            map(plane, |x, y| (x < 4 && y < 6) || ((9..15).contains(&x) && (7..13).contains(&y)));
        let whole = map(plane, |_, _| false);
        let filled = Gaps::of(&holed, &[true; 480], Surface::Plate).filled(&holed);
        for (one, other) in filled.heights().iter().zip(whole.heights()) {
            assert!((one - other).abs() < 1e-5, "{one} {other}");
        }
        let filled = Gaps::of(&holed, &[true; 480], Surface::Membrane).filled(&holed);
        assert!((filled.at(12, 10) - whole.at(12, 10)).abs() < 1e-6);
        assert!((filled.at(0, 0) - whole.at(0, 0)).abs() > 0.5);
    }

    /// The sum over gaps is the sum over the points around with their weights.
    #[test]
    fn weights_are_those_of_the_sum() {
        let rough = |x: f64, y: f64| (1.3 * x + 0.2 * y * y).sin();
        let holed = map(rough, |x, y| (x * 7 + y * 5) % 9 < 3 || (5..11).contains(&x) && y > 14);
        for surface in [Surface::Plate, Surface::Membrane] {
            let gaps = Gaps::of(&holed, &[true; 480], surface);
            let own: Vec<f64> = (0..480).map(|at| f64::from(at % 24 < 12)).collect();
            let filled = gaps.filled(&holed);
            let sum: f64 = gaps.points.iter().map(|&at| own[at] * filled.heights()[at]).sum();
            let weights = gaps.weights(&own);
            let known = weights.iter().zip(holed.heights()).filter(|(weight, _)| **weight != 0.0);
            let other: f64 = known.map(|(weight, height)| weight * height).sum();
            assert!((sum - other).abs() < 1e-5, "{sum} {other}");
        }
    }

    /// Only gaps of three points both ways are wide, and the wall around one is seen.
    #[test]
    fn walls_may_lie_in_wide_gaps() {
        let wall = |x: f64, _| if x < 12.0 { 0.0 } else { -4.0 };
        let holed =
            map(wall, |x, y| (10..14).contains(&x) && (5..12).contains(&y) || (x, y) == (20, 3));
        let gaps = Gaps::of(&holed, &[true; 480], Surface::Plate);
        let ranges = gaps.ranges(&holed);
        assert_eq!(ranges.len(), 28);
        let seen = ranges.iter().filter(|(_, half)| (half - 2.0).abs() < 1e-12).count();
        assert!(seen >= 24, "{ranges:?}");
    }
}
