//! The worn surface of a body, in its own coordinates.
//!
//! A surface that stays has an element under each pair of the frame. One that passes along an axis has one for all the pairs
//! of a row along it, since they wear equally. One that swings is longer than the frame, and is moved over it. One that repeats itself
//! is moved round.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::frame::Part;
use crate::numerics::vector;

/// What is worn off a body, one value an element of its surface, x running fastest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// Where its elements lie.
    pub grid: Grid,
    /// Depth worn off (m).
    pub depth: Vec<f64>,
    /// Distance (m) that its points slid under pressure; empty where nothing depends on it.
    pub slid: Vec<f64>,
    /// Depth (m) that it was pressed in for good; empty of a body that does not yield.
    pub imprint: Vec<f64>,
}

/// The elements of a surface, and which of them lies at a pair of the frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Pairs of the frame along x and y.
    frame: [usize; 2],
    /// How it lies along both axes.
    along: [Along; 2],
}

/// The elements of a surface along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
enum Along {
    /// One a pair.
    Stays,
    /// One for all pairs.
    Passes,
    /// One a pair, and so many more before the first and after the last.
    Swings([usize; 2]),
    /// One a pair, the last one next to the first.
    Recurs,
}

impl Grid {
    /// An element a pair of a frame of so many along x and y.
    pub fn of_pairs(frame: [usize; 2]) -> Self {
        Self { frame, along: [Along::Stays; 2] }
    }

    /// One element for all pairs of a row along an axis.
    pub fn passing(frame: [usize; 2], axis: usize) -> Self {
        Self::of_pairs(frame).lying(axis, Along::Passes)
    }

    /// As many more elements than pairs at both ends of an axis.
    pub fn swinging(frame: [usize; 2], axis: usize, margin: usize) -> Self {
        Self::of_pairs(frame).lying(axis, Along::Swings([margin; 2]))
    }

    /// So many more elements than pairs before the first and after the last one of each axis; as many as pairs where there are none.
    pub fn roaming(frame: [usize; 2], margins: [[usize; 2]; 2]) -> Self {
        let along =
            margins.map(|more| if more == [0; 2] { Along::Stays } else { Along::Swings(more) });
        Self { frame, along }
    }

    /// As many elements as pairs, which repeat themselves along an axis.
    pub fn recurring(frame: [usize; 2], axis: usize) -> Self {
        Self::of_pairs(frame).lying(axis, Along::Recurs)
    }

    fn lying(mut self, axis: usize, along: Along) -> Self {
        self.along[axis] = along;
        self
    }

    /// The axis along which it swings.
    pub fn swings(self) -> Option<usize> {
        (0..2).find(|&axis| matches!(self.along[axis], Along::Swings(_)))
    }

    /// The axis along which it passes.
    pub fn passes(self) -> Option<usize> {
        (0..2).find(|&axis| self.along[axis] == Along::Passes)
    }

    /// Its elements along x and y.
    pub fn elements(self) -> [usize; 2] {
        [0, 1].map(|axis| match self.along[axis] {
            Along::Stays | Along::Recurs => self.frame[axis],
            Along::Passes => 1,
            Along::Swings([before, after]) => self.frame[axis] + before + after,
        })
    }

    /// How many elements it has before the first pair of the frame along x and y, in the middle of a swing.
    pub fn before(self) -> [usize; 2] {
        self.along.map(|along| if let Along::Swings([before, _]) = along { before } else { 0 })
    }

    /// The element that lies at a pair of the frame when the surface is moved by so many elements along the axes on which it
    /// swings, not more than its margins, or repeats itself.
    pub fn at(self, pair: usize, offset: [isize; 2]) -> usize {
        let place = [pair % self.frame[0], pair / self.frame[0]];
        let [x, y] = [0, 1].map(|axis| match self.along[axis] {
            Along::Stays => place[axis],
            Along::Passes => 0,
            Along::Swings([before, _]) => {
                (place[axis] + before).saturating_add_signed(-offset[axis])
            }
            Along::Recurs => {
                (place[axis] as isize - offset[axis]).rem_euclid(self.frame[axis] as isize) as usize
            }
        });
        x + self.elements()[0] * y
    }

    /// The four elements around a place (elements along x and y from the first pair of the frame), and the share of each that makes it
    /// their mean; those at the rim stand for what lies beyond.
    pub fn around(self, place: [f64; 2]) -> [(usize, f64); 4] {
        let (elements, before) = (self.elements(), self.before());
        let along = [0, 1].map(|axis| {
            let last = elements[axis] as f64 - 1.0;
            let at = (place[axis] + before[axis] as f64).clamp(0.0, last);
            let low = at.floor();
            let high = (low + 1.0).min(last);
            [(low as usize, 1.0 - (at - low)), (high as usize, at - low)]
        });
        let [x, y] = along;
        [(0, 0), (1, 0), (0, 1), (1, 1)]
            .map(|(i, j)| (x[i].0 + elements[0] * y[j].0, x[i].1 * y[j].1))
    }

    /// Where its first element lies on the same surface over another frame, in which its own frame begins at a pair.
    fn first_in(self, other: Self, first: [isize; 2]) -> [isize; 2] {
        [0, 1].map(|axis| match (self.along[axis], other.along[axis]) {
            (Along::Passes, Along::Passes) => 0,
            (Along::Swings([own, _]), Along::Swings([other, _])) => {
                first[axis] + other as isize - own as isize
            }
            _ => first[axis],
        })
    }
}

impl Surface {
    /// An unworn one; whether the distance that its points slide is counted, and whether it yields.
    pub fn unworn(grid: Grid, counts: bool, yields: bool) -> Self {
        let [nx, ny] = grid.elements();
        let none = vec![0.0; nx * ny];
        let field = |there: bool| if there { none.clone() } else { vec![] };
        Self { grid, slid: field(counts), imprint: field(yields), depth: none }
    }

    /// One with an element a pair, worn by those depths (m).
    pub fn of_pairs(frame: [usize; 2], depth: Vec<f64>) -> Self {
        Self { grid: Grid::of_pairs(frame), depth, slid: vec![], imprint: vec![] }
    }

    /// Depth worn off (m) at each pair of the frame, in the middle of a swing.
    pub fn worn(&self) -> Cow<'_, [f64]> {
        self.in_frame(&self.depth)
    }

    /// Depth (m) at each pair by which it lies below its unworn shape: worn off and pressed in.
    pub fn lowered(&self) -> Cow<'_, [f64]> {
        if self.imprint.is_empty() {
            return self.worn();
        }
        Cow::Owned(
            self.in_frame(&vector::map([&self.depth, &self.imprint], |[a, b]| a + b)).into_owned(),
        )
    }

    /// Distance slid (m) there; empty where it is not counted.
    pub fn distance(&self) -> Cow<'_, [f64]> {
        self.in_frame(&self.slid)
    }

    fn in_frame<'a>(&self, field: &'a [f64]) -> Cow<'a, [f64]> {
        let Grid { frame: [nx, ny], along } = self.grid;
        match along {
            _ if field.is_empty() => Cow::Borrowed(field),
            [Along::Stays, Along::Stays] => Cow::Borrowed(field),
            [Along::Passes, _] => {
                field.iter().flat_map(|value| std::iter::repeat_n(*value, nx)).collect()
            }
            [_, Along::Passes] => Cow::Owned(field.repeat(ny)),
            _ => (0..nx * ny).map(|pair| field[self.grid.at(pair, [0; 2])]).collect(),
        }
    }

    /// How far (m) the point at an element slid and how deep (m) it wore so far.
    pub fn before(&self, element: usize) -> [f64; 2] {
        [&self.slid, &self.depth].map(|field| field.get(element).copied().unwrap_or_default())
    }

    /// Wears the surface, moved by so many elements, by a share of depths (m) at the pairs of the frame and distances (m) slid
    /// there.
    pub fn wear(&mut self, (depths, slip): (&[f64], &[f64]), offset: [isize; 2], share: f64) {
        let grid = self.grid;
        let lay = |field: &mut Vec<f64>, values: &[f64]| {
            if grid.along == [Along::Stays; 2] {
                return vector::update(field, [values], |worn, [value]| worn + share * value);
            }
            for (pair, value) in values.iter().enumerate().filter(|(_, value)| **value != 0.0) {
                field[grid.at(pair, offset)] += share * value;
            }
        };
        lay(&mut self.depth, depths);
        if !self.slid.is_empty() {
            lay(&mut self.slid, slip);
        }
    }

    /// Wears an element by a depth (m), and counts a distance (m) that the point there slid.
    pub fn wear_element(&mut self, element: usize, [depth, slip]: [f64; 2]) {
        self.depth[element] += depth;
        if let Some(slid) = self.slid.get_mut(element) {
            *slid += slip;
        }
    }

    /// The sum of a field of the frame over the pairs at each element, in the middle of a swing.
    pub fn gathered(&self, field: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.depth.len()];
        field
            .iter()
            .enumerate()
            .for_each(|(pair, value)| sums[self.grid.at(pair, [0; 2])] += value);
        sums
    }

    /// The same with its fields changed.
    #[must_use]
    pub fn map(&self, grid: Grid, change: impl Fn(&[f64]) -> Vec<f64>) -> Self {
        let field = |field: &[f64]| if field.is_empty() { vec![] } else { change(field) };
        let [depth, slid, imprint] = [&self.depth, &self.slid, &self.imprint].map(|one| field(one));
        Self { grid, depth, slid, imprint }
    }

    /// The same over another frame, in which its own begins at a pair; unworn beyond its elements.
    #[must_use]
    pub fn moved(&self, first: [isize; 2], grid: Grid) -> Self {
        let elements = [self.grid, grid].map(Grid::elements);
        let [own, there] = Part::shared(elements, self.grid.first_in(grid, first));
        self.map(grid, |field| there.put(&own.cut(field)))
    }

    /// Mean and largest depth (m) of each row of elements across an axis, from end to end.
    pub fn along(&self, axis: usize) -> Vec<[f64; 2]> {
        let elements = self.grid.elements();
        let across = elements[1 - axis];
        let depth = |along: usize, other: usize| match axis {
            0 => self.depth[along + elements[0] * other],
            _ => self.depth[other + elements[0] * along],
        };
        let row = |along: usize| {
            let depths = (0..across).map(|other| depth(along, other));
            [depths.clone().sum::<f64>() / across as f64, depths.fold(0.0, f64::max)]
        };
        (0..elements[axis]).map(row).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Grid, Surface};

    #[test]
    fn a_pair_meets_what_was_moved_to_it() {
        let grid = Grid::swinging([4, 2], 0, 3);
        assert_eq!(grid.elements(), [10, 2]);
        let at = |pair, offset| grid.at(pair, [offset, 0]);
        assert_eq!([at(0, 0), at(0, 3), at(7, -3)], [3, 0, 19]);
        let along_y = Grid::swinging([4, 2], 1, 3);
        assert_eq!(along_y.elements(), [4, 8]);
        let at = |pair, offset| along_y.at(pair, [0, offset]);
        assert_eq!([at(0, 0), at(0, 3), at(7, -3)], [12, 0, 31]);
        let mut surface = Surface::unworn(grid, false, false);
        surface.depth[13] = 2.0;
        assert_eq!(surface.worn()[..], [0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0]);
        assert_eq!(surface.along(0)[3], [1.0, 2.0]);
    }

    /// A place between elements belongs to all of them, to its distances.
    #[test]
    fn a_place_belongs_to_those_around_it() {
        let grid = Grid::roaming([4, 2], [[3, 3], [1, 1]]);
        let mean = |place: [f64; 2], axis: usize| {
            let at = |element: usize| [element % 10, element / 10][axis] as f64;
            grid.around(place).iter().map(|(element, share)| share * at(*element)).sum::<f64>()
        };
        for place in [[0.0, 0.0], [1.25, -0.5], [-2.75, 1.875], [6.0, 2.0]] {
            assert_eq!([0, 1].map(|axis| mean(place, axis)), [place[0] + 3.0, place[1] + 1.0]);
        }
        assert_eq!([0, 1].map(|axis| mean([-9.0, 9.0], axis)), [0.0, 3.0]);
    }

    #[test]
    fn what_repeats_itself_comes_round() {
        let grid = Grid::recurring([4, 2], 0);
        assert_eq!(grid.elements(), [4, 2]);
        assert_eq!([0, 1, -1, 4, -9].map(|offset| grid.at(0, [offset, 0])), [0, 3, 1, 0, 1]);
        assert_eq!(grid.at(6, [3, 0]), 7);
        let mut surface = Surface::unworn(grid, true, false);
        let depths: Vec<f64> = (1..9).map(f64::from).collect();
        (0..4).for_each(|offset| surface.wear((&depths, &depths), [offset, 0], 0.25));
        assert_eq!(surface.depth, [2.5, 2.5, 2.5, 2.5, 6.5, 6.5, 6.5, 6.5]);
        assert_eq!(surface.slid, surface.depth);
    }

    #[test]
    fn all_pairs_of_a_row_meet_what_passes() {
        let mut surface = Surface::unworn(Grid::passing([3, 2], 0), true, false);
        surface.depth = vec![1.0, 2.0];
        assert_eq!(surface.worn()[..], [1.0, 1.0, 1.0, 2.0, 2.0, 2.0]);
        let larger = surface.moved([4, 1], Grid::passing([9, 4], 0));
        assert_eq!(larger.depth, [0.0, 1.0, 2.0, 0.0]);
        assert_eq!(larger.slid, [0.0; 4]);
    }

    /// Wear that is laid down at an offset is met there again, and a larger frame meets it where the smaller one did.
    #[test]
    fn what_is_worn_stays_where_it_was_worn() {
        let mut surface = Surface::unworn(Grid::swinging([4, 2], 0, 3), false, false);
        let depths: Vec<f64> = (1..9).map(f64::from).collect();
        surface.wear((&depths, &[]), [2, 0], 0.5);
        for (pair, depth) in depths.iter().enumerate() {
            assert_eq!(surface.depth[surface.grid.at(pair, [2, 0])], 0.5 * depth);
        }
        let larger = surface.moved([1, 1], Grid::swinging([6, 4], 0, 5));
        let pair = |x: usize, y: usize| [x + 4 * y, x + 1 + 6 * (y + 1)];
        for place in 0..8 {
            let [small, large] = pair(place % 4, place / 4);
            assert_eq!(surface.worn()[small], larger.worn()[large]);
        }
        assert_eq!(surface.depth.iter().sum::<f64>(), larger.depth.iter().sum::<f64>());
    }
}
