//! A rectangle of a frame's elements, to solve on where the rest is far from the contact.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::Rectangle;
use crate::numerics::convolution::even_smooth;

/// Share of the elements above which a part of them is not worth while. A choice of cost: what is next to a part is known to be
/// open, whatever its size.
const WHOLE: f64 = 0.75;

/// Columns and rows of elements.
pub type Extent = [Range<usize>; 2];

/// The smallest extent that holds the pairs of a grid of so many elements for which something holds; `None` without any.
pub fn extent(elements: [usize; 2], holds: impl Fn(usize) -> bool) -> Option<Extent> {
    let [nx, ny] = elements;
    let (mut columns, mut rows) = (nx..0, ny..0);
    for row in 0..ny {
        let here = |column: &usize| holds(column + nx * row);
        let Some(first) = (0..nx).find(here) else { continue };
        // Columns between those that are known need no look.
        let last = (columns.end.max(first + 1)..nx).rfind(here);
        columns = columns.start.min(first)..columns.end.max(last.unwrap_or(first) + 1);
        rows = rows.start.min(row)..row + 1;
    }
    (!rows.is_empty()).then_some([columns, rows])
}

/// A rectangle of elements of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Part {
    frame: [usize; 2],
    first: [usize; 2],
    size: [usize; 2],
}

impl Part {
    /// No element of a grid of so many.
    pub fn none(elements: [usize; 2]) -> Self {
        Self { frame: elements, first: [0; 2], size: [0; 2] }
    }

    /// The rectangle around an extent with so many elements more at each side, of a size that transforms well; `None` if
    /// it is nearly the whole grid.
    pub fn around(elements: [usize; 2], extent: &Extent, margin: [usize; 2]) -> Option<Self> {
        let wide = [0, 1].map(|axis| extent[axis].len().min(elements[axis]));
        let size = [0, 1].map(|axis| roomy(wide[axis] + 2 * margin[axis]).min(elements[axis]));
        let first = [0, 1].map(|axis| {
            let spare = size[axis] - wide[axis];
            extent[axis].start.saturating_sub(spare / 2).min(elements[axis] - size[axis])
        });
        let part = Self { frame: elements, first, size };
        part.is_worth(elements).then_some(part)
    }

    /// Whether it is much smaller than so many elements.
    pub fn is_worth(&self, [nx, ny]: [usize; 2]) -> bool {
        ((self.size[0] * self.size[1]) as f64) < WHOLE * (nx * ny) as f64
    }

    /// What it covers of a rectangle that the whole grid covers.
    pub fn rectangle(&self, whole: Rectangle) -> Rectangle {
        let spacing = [0, 1].map(|axis| whole.size[axis] / self.frame[axis] as f64);
        let middle = |axis: usize| {
            let steps = 2 * self.first[axis] + self.size[axis];
            whole.centre[axis] + 0.5 * spacing[axis] * (steps as f64 - self.frame[axis] as f64)
        };
        Rectangle {
            centre: [0, 1].map(middle),
            size: [0, 1].map(|axis| spacing[axis] * self.size[axis] as f64),
        }
    }

    /// The whole grid: it covers a rectangle of this.
    pub fn whole(&self, own: Rectangle) -> Rectangle {
        let spacing = [0, 1].map(|axis| own.size[axis] / self.size[axis] as f64);
        let middle = |axis: usize| {
            let steps = 2.0 * self.first[axis] as f64 + self.size[axis] as f64;
            own.centre[axis] - 0.5 * spacing[axis] * (steps - self.frame[axis] as f64)
        };
        Rectangle {
            centre: [0, 1].map(middle),
            size: [0, 1].map(|axis| spacing[axis] * self.frame[axis] as f64),
        }
    }

    /// A grid of so many elements as a rectangle of a larger one: that much larger at the lower and at the upper sides.
    pub fn inside(elements: [usize; 2], more: [[usize; 2]; 2]) -> Self {
        let frame = [0, 1].map(|axis| more[axis][0] + elements[axis] + more[axis][1]);
        Self { frame, first: more.map(|[below, _]| below), size: elements }
    }

    /// What two grids of so many elements share, as a part of each; the first begins at an element of the second.
    pub fn shared([own, other]: [[usize; 2]; 2], first: [isize; 2]) -> [Self; 2] {
        let begin = [first.map(|at| -at), first].map(|at| at.map(|at| at.max(0) as usize));
        let left = |count: usize, begin: usize| count.saturating_sub(begin);
        let [one, two] = begin;
        let size = [0, 1].map(|axis| left(own[axis], one[axis]).min(left(other[axis], two[axis])));
        [Self { frame: own, first: one, size }, Self { frame: other, first: two, size }]
    }

    /// Number of elements of the whole grid along x and y.
    pub fn frame(&self) -> [usize; 2] {
        self.frame
    }

    /// Number of elements along x and y.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Its columns and rows.
    pub fn extent(&self) -> Extent {
        [0, 1].map(|axis| self.first[axis]..self.first[axis] + self.size[axis])
    }

    /// Whether it holds an extent.
    pub fn holds(&self, extent: &Extent) -> bool {
        let own = self.extent();
        (0..2)
            .all(|axis| own[axis].start <= extent[axis].start && extent[axis].end <= own[axis].end)
    }

    /// A rectangle of the frame as one of a part that holds it; `None` of one that does not.
    pub fn seen_from(&self, outer: &Self) -> Option<Self> {
        let first = |axis: usize| self.first[axis] - outer.first[axis];
        outer.holds(&self.extent()).then(|| Self {
            frame: outer.size,
            first: [0, 1].map(first),
            size: self.size,
        })
    }

    /// A rectangle of a part as one of the frame.
    #[must_use]
    pub fn lying_in(&self, outer: &Self) -> Self {
        let first = [0, 1].map(|axis| outer.first[axis] + self.first[axis]);
        Self { frame: outer.frame, first, size: self.size }
    }

    /// The number in the rectangle of a pair of the frame; `None` next to it.
    pub fn place(&self, pair: usize) -> Option<usize> {
        let [x, y] = [pair % self.frame[0], pair / self.frame[0]];
        let [columns, rows] = self.extent();
        (columns.contains(&x) && rows.contains(&y))
            .then(|| x - self.first[0] + self.size[0] * (y - self.first[1]))
    }

    /// The rectangle's values of a field.
    pub fn cut<T: Clone>(&self, field: &[T]) -> Vec<T> {
        self.rows().flat_map(|row| &field[row]).cloned().collect()
    }

    /// The field of the frame with these values in the rectangle.
    pub fn pasted<T: Clone>(&self, values: &[T], mut field: Vec<T>) -> Vec<T> {
        for (row, values) in self.rows().zip(values.chunks(self.size[0].max(1))) {
            field[row].clone_from_slice(values);
        }
        field
    }

    /// The field of the frame with these values, zero next to them.
    pub fn put(&self, values: &[f64]) -> Vec<f64> {
        self.pasted(values, vec![0.0; self.frame[0] * self.frame[1]])
    }

    /// The pairs of its rows.
    fn rows(&self) -> impl Iterator<Item = Range<usize>> {
        let Self { frame, first, size } = *self;
        (0..size[1]).map(move |row| {
            let start = first[0] + frame[0] * (first[1] + row);
            start..start + size[0]
        })
    }
}

/// The next number at least `n` whose double transforms well; few sizes are met while a contact grows.
fn roomy(n: usize) -> usize {
    even_smooth(2 * n) / 2
}

#[cfg(test)]
mod tests {
    use super::{Part, Rectangle, extent};

    #[test]
    fn a_part_is_cut_out_and_put_back() {
        let part = Part { frame: [5, 4], first: [1, 2], size: [3, 2] };
        let field: Vec<f64> = (0..20).map(f64::from).collect();
        let cut = part.cut(&field);
        assert_eq!(cut, [11.0, 12.0, 13.0, 16.0, 17.0, 18.0]);
        let put = part.put(&cut);
        assert_eq!(put.iter().sum::<f64>(), cut.iter().sum::<f64>());
        assert_eq!(part.cut(&put), cut);
        for (pair, value) in field.iter().enumerate() {
            let found = part.place(pair).map(|place| cut[place]);
            assert_eq!(found, cut.contains(value).then_some(*value));
        }
    }

    /// Parts of parts are parts of the frame, and cover what they did.
    #[test]
    fn parts_lie_in_parts() {
        let outer = Part { frame: [12, 9], first: [3, 2], size: [6, 5] };
        let inner = Part { frame: [6, 5], first: [1, 2], size: [4, 2] };
        let whole = inner.lying_in(&outer);
        assert_eq!(whole.extent(), [4..8, 4..6]);
        assert_eq!(whole.seen_from(&outer), Some(inner));
        assert_eq!(outer.seen_from(&whole), None);
        let field: Vec<f64> = (0..108).map(f64::from).collect();
        assert_eq!(whole.cut(&field), inner.cut(&outer.cut(&field)));
        let frame = Rectangle { centre: [1.0, -2.0], size: [24.0, 9.0] };
        let within = whole.rectangle(frame);
        assert_eq!(within, inner.rectangle(outer.rectangle(frame)));
        assert_eq!((within.corner(), within.size), ([-3.0, -2.5], [8.0, 2.0]));
    }

    #[test]
    fn an_extent_holds_every_pair_that_is_meant() {
        for pairs in [vec![7], vec![3, 8], vec![13, 6, 11], vec![0, 19], vec![4, 15, 12]] {
            let [columns, rows] = extent([5, 4], |pair| pairs.contains(&pair)).unwrap();
            let (x, y) = (pairs.iter().map(|pair| pair % 5), pairs.iter().map(|pair| pair / 5));
            assert_eq!(columns, x.clone().min().unwrap()..x.max().unwrap() + 1, "{pairs:?}");
            assert_eq!(rows, y.clone().min().unwrap()..y.max().unwrap() + 1, "{pairs:?}");
        }
        assert_eq!(extent([5, 4], |_| false), None);
    }

    /// It lies within the frame, holds what it is around with the margin where the frame has room, and is not nearly all.
    #[test]
    fn a_part_lies_around_an_extent() {
        for low in 0..50 {
            let part = Part::around([64, 48], &[low..low + 9, 40..46], [2, 3]).unwrap();
            let [columns, rows] = part.extent();
            assert!(columns.end <= 64 && rows.end <= 48, "{part:?}");
            assert!(part.holds(&[low.saturating_sub(2)..low + 11, 37..48]), "{part:?}");
            assert!(!part.holds(&[low..low + 9, 20..46]));
        }
        assert_eq!(Part::around([64, 48], &[3..60, 4..44], [0; 2]), None);
    }
}
