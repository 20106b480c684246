//! Tractions gathered in squares of elements: a sum over all of them at one place takes terms that grow as the logarithm of their number.
//!
//! Four squares make one twice as wide, up to one that holds all elements. What a force does at a place is smooth where that is far
//! away from the square that it acts on, so that it is interpolated there between Chebyshev's points: even tractions on elements are forces
//! at these (W. Fong & E. Darve, *J. Comput. Phys.* 228 (2009) 8712, whose expansions about places are left out).

use std::f64::consts::PI;
use std::ops::Range;

use rayon::prelude::*;

/// Elements along a side of the smallest squares. A choice of effort.
const SIDE: usize = 8;
/// Points along a side of a square.
const POINTS: usize = 8;
/// How far away the nearest of what decays is from the centre of a square, over the width of the square, at least where its points
/// stand for it.
const FAR: f64 = 2.0;
/// What is missed of a stress at most, relative to the largest traction: 1.3e-8 of that on a square [`FAR`] away, less by the eighth power of
/// the distance farther away, so that all squares of a size miss four times as much; of ten sizes at most, twice that.
pub(super) const MISSED: f64 = 1e-6;

/// Forces (N) along x, y and into the body at the points of a square, x running fastest.
type Forces = [[f64; 3]; POINTS * POINTS];

/// Squares of a size.
struct Level {
    counts: [usize; 2],
    /// None where there is no traction.
    forces: Vec<Option<Box<Forces>>>,
}

/// All tractions of a frame.
pub(super) struct Tree {
    elements: [usize; 2],
    /// The lowest corner of the frame (m).
    corner: [f64; 2],
    /// Half the width of the smallest squares (m).
    half: [f64; 2],
    /// The points of a square that reaches from -1 to 1.
    points: [f64; POINTS],
    /// From the smallest squares up to one that holds all.
    levels: Vec<Level>,
}

/// What has its share in a sum.
pub(super) enum Part<'a> {
    /// Forces at points.
    Square(Square<'a>),
    /// Elements, by their indices along x and y.
    Elements([Range<usize>; 2]),
}

/// A square far away.
pub(super) struct Square<'a> {
    centre: [f64; 2],
    half: [f64; 2],
    points: &'a [f64; POINTS],
    forces: &'a Forces,
}

impl Square<'_> {
    /// Its forces (N), each with the way from it to a place (m).
    pub fn each(&self, at: [f64; 2], mut see: impl FnMut([f64; 2], &[f64; 3])) {
        let from = |axis: usize, point: f64| at[axis] - self.centre[axis] - self.half[axis] * point;
        for (row, y) in self.forces.chunks(POINTS).zip(self.points) {
            let y = from(1, *y);
            row.iter().zip(self.points).for_each(|(force, x)| see([from(0, *x), y], force));
        }
    }
}

impl Tree {
    /// Of tractions (Pa) along x, y and into the body, on elements of that size (m) from a corner (m) on.
    pub fn of(
        tractions: &[Vec<f64>; 3],
        elements: [usize; 2],
        (spacing, corner): ([f64; 2], [f64; 2]),
    ) -> Self {
        let points: [f64; POINTS] =
            std::array::from_fn(|m| (PI * (m as f64 + 0.5) / POINTS as f64).cos());
        let area = spacing[0] * spacing[1];
        let shares: [_; SIDE] = std::array::from_fn(|index| mean(&points, index));
        let counts = elements.map(|count| count.div_ceil(SIDE));
        let smallest = |index: usize| {
            let ranges = range([index % counts[0], index / counts[0]], elements);
            let first = ranges.each_ref().map(|own| own.start);
            let value = |i: usize, j: usize| -> [f64; 3] {
                let [i, j] = [first[0] + i, first[1] + j];
                let inside = ranges[0].contains(&i) && ranges[1].contains(&j);
                let element = i + elements[0] * j;
                [0, 1, 2].map(|axis| if inside { area * tractions[axis][element] } else { 0.0 })
            };
            gathered(&shares, value)
        };
        let all = 0..counts[0] * counts[1];
        let mut level = Level { counts, forces: all.into_par_iter().map(smallest).collect() };
        let mut levels = vec![];
        // The points of both squares along a side, in one that holds them.
        let shares: [_; 2 * POINTS] = std::array::from_fn(|index| {
            let side = if index < POINTS { -1.0 } else { 1.0 };
            shares_at(&points, 0.5 * (side + points[index % POINTS]))
        });
        while level.counts != [1, 1] {
            let counts = level.counts.map(|count| count.div_ceil(2));
            let larger = |index: usize| {
                let first = [2 * (index % counts[0]), 2 * (index / counts[0])];
                let value = |i: usize, j: usize| -> [f64; 3] {
                    let own = [first[0] + i / POINTS, first[1] + j / POINTS];
                    let inside = (0..2).all(|axis| own[axis] < level.counts[axis]);
                    let square = own[0] + level.counts[0] * own[1];
                    let forces = if inside { level.forces[square].as_ref() } else { None };
                    forces.map_or([0.0; 3], |own| own[i % POINTS + POINTS * (j % POINTS)])
                };
                gathered(&shares, value)
            };
            let all = 0..counts[0] * counts[1];
            let forces = all.into_par_iter().map(larger).collect();
            levels.push(std::mem::replace(&mut level, Level { counts, forces }));
        }
        levels.push(level);
        let half = spacing.map(|spacing| 0.5 * spacing * SIDE as f64);
        Self { elements, corner, half, points, levels }
    }

    /// All that has its share in a sum at a place along x and y (m), where what decays is at least `near` (m) away from the elements.
    pub fn parts(&self, at: [f64; 2], near: f64, see: &mut impl FnMut(Part<'_>)) {
        self.part((self.levels.len() - 1, [0, 0]), (at, near), see);
    }

    fn part(
        &self,
        (level, index): (usize, [usize; 2]),
        (at, near): ([f64; 2], f64),
        see: &mut impl FnMut(Part<'_>),
    ) {
        let own = &self.levels[level];
        let Some(forces) = &own.forces[index[0] + own.counts[0] * index[1]] else { return };
        let half = self.half.map(|half| half * (1u64 << level) as f64);
        let centre =
            [0, 1].map(|axis| self.corner[axis] + half[axis] * (2 * index[axis] + 1) as f64);
        let [x, y] = [0, 1].map(|axis| at[axis] - centre[axis]);
        let width = 2.0 * half[0].max(half[1]);
        if x * x + y * y + near * near >= (FAR * width).powi(2) {
            see(Part::Square(Square { centre, half, points: &self.points, forces }));
        } else if level == 0 {
            see(Part::Elements(range(index, self.elements)));
        } else {
            let counts = self.levels[level - 1].counts;
            for j in 2 * index[1]..(2 * index[1] + 2).min(counts[1]) {
                for i in 2 * index[0]..(2 * index[0] + 2).min(counts[0]) {
                    self.part((level - 1, [i, j]), (at, near), see);
                }
            }
        }
    }
}

/// The elements of one of the smallest squares.
fn range(index: [usize; 2], elements: [usize; 2]) -> [Range<usize>; 2] {
    [0, 1].map(|axis| SIDE * index[axis]..(SIDE * (index[axis] + 1)).min(elements[axis]))
}

/// Forces at points, from values on a grid whose rows and columns have these shares in each; `None` of values that are all zero.
fn gathered<const N: usize>(
    shares: &[[f64; POINTS]; N],
    value: impl Fn(usize, usize) -> [f64; 3],
) -> Option<Box<Forces>> {
    let mut forces: Option<Box<Forces>> = None;
    for (j, across) in shares.iter().enumerate() {
        let mut row: Option<[[f64; 3]; POINTS]> = None;
        for (i, along) in shares.iter().enumerate() {
            let value = value(i, j);
            if value == [0.0; 3] {
                continue;
            }
            for (sum, share) in row.get_or_insert_default().iter_mut().zip(along) {
                (0..3).for_each(|axis| sum[axis] += share * value[axis]);
            }
        }
        let Some(row) = row else { continue };
        let forces = forces.get_or_insert_with(|| Box::new([[0.0; 3]; POINTS * POINTS]));
        for (sums, share) in forces.chunks_mut(POINTS).zip(across) {
            for (sum, value) in sums.iter_mut().zip(row) {
                (0..3).for_each(|axis| sum[axis] += share * value[axis]);
            }
        }
    }
    forces
}

/// The sum of Chebyshev's polynomials that is one at a point and zero at the others, from the polynomials' own values somewhere.
fn interpolated(points: &[f64; POINTS], polynomials: &[f64; POINTS]) -> [f64; POINTS] {
    points.map(|point| {
        let terms = polynomials.iter().enumerate().skip(1);
        let terms = terms.map(|(order, value)| 2.0 * (order as f64 * point.acos()).cos() * value);
        (polynomials[0] + terms.sum::<f64>()) / POINTS as f64
    })
}

/// The shares of the points in a force somewhere between -1 and 1.
fn shares_at(points: &[f64; POINTS], at: f64) -> [f64; POINTS] {
    interpolated(points, &std::array::from_fn(|order| (order as f64 * at.acos()).cos()))
}

/// The same in a force spread over one of the elements along the side of a smallest square.
fn mean(points: &[f64; POINTS], element: usize) -> [f64; POINTS] {
    let width = 2.0 / SIDE as f64;
    let ends = [0, 1].map(|end| width * (element + end) as f64 - 1.0);
    let polynomials = std::array::from_fn(|order| {
        let n = order as f64;
        let integral = |x: f64| {
            let next = |order: f64| (order * x.clamp(-1.0, 1.0).acos()).cos() / (2.0 * order);
            match order {
                0 => x,
                1 => 0.5 * x * x,
                _ => next(n + 1.0) - next(n - 1.0),
            }
        };
        (integral(ends[1]) - integral(ends[0])) / width
    });
    interpolated(points, &polynomials)
}
