//! Where one part of a map ends and another begins.

use archard::numerics::SAME;
use std::collections::BTreeMap;

/// A line from one place to another, along an edge of cells.
pub(crate) type Line = [(f64, f64); 2];

/// The edges of the cells whose values are above a half towards those whose values are not, in runs as long
/// as they are straight; `edges` are the lowest and highest place along x and along y.
pub(crate) fn around(rows: &[Vec<f64>], edges: [[f64; 2]; 2]) -> Vec<Line> {
    let counts = [rows.first().map_or(0, Vec::len), rows.len()];
    let place = |axis: usize, index: usize| {
        let [low, high] = edges[axis];
        low + (high - low) * index as f64 / counts[axis].max(1) as f64
    };
    let inside = |x: Option<usize>, y: Option<usize>| {
        let row = y.and_then(|y| rows.get(y));
        row.zip(x).and_then(|(row, x)| row.get(x)).is_some_and(|value| *value > 0.5)
    };
    let mut lines = Vec::new();
    for y in 0..=counts[1] {
        let edge = |x: usize| inside(Some(x), Some(y)) != inside(Some(x), y.checked_sub(1));
        let at = |x: usize| (place(0, x), place(1, y));
        lines.extend(runs(counts[0], edge).map(|[from, to]| [at(from), at(to)]));
    }
    for x in 0..=counts[0] {
        let edge = |y: usize| inside(Some(x), Some(y)) != inside(x.checked_sub(1), Some(y));
        let at = |y: usize| (place(0, x), place(1, y));
        lines.extend(runs(counts[1], edge).map(|[from, to]| [at(from), at(to)]));
    }
    lines
}

/// The edges of elements whose values are above a half towards nothing or elements whose values are not.
pub(crate) fn of_parts(parts: &[(Vec<[f64; 2]>, f64)]) -> Vec<Line> {
    let inside = || parts.iter().filter(|(_, value)| *value > 0.5);
    let farthest = parts.iter().flat_map(|(corners, _)| corners).flatten();
    let size = SAME * farthest.fold(0.0_f64, |most, place| most.max(place.abs()));
    let key = |corner: &[f64; 2]| corner.map(|place| (place / size).round() as i64);
    let mut edges: BTreeMap<[[i64; 2]; 2], Vec<Line>> = BTreeMap::new();
    for (corners, _) in inside() {
        for (one, other) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let mut ends = [key(one), key(other)];
            ends.sort_unstable();
            edges.entry(ends).or_default().push([(one[0], one[1]), (other[0], other[1])]);
        }
    }
    edges.into_values().filter(|lines| lines.len() == 1).flatten().collect()
}

/// Beginnings and ends of the runs below `count` for which something holds.
fn runs(count: usize, holds: impl Fn(usize) -> bool) -> impl Iterator<Item = [usize; 2]> {
    let ends: Vec<usize> =
        (0..=count).filter(|&i| (i > 0 && holds(i - 1)) != (i < count && holds(i))).collect();
    ends.chunks_exact(2).map(|ends| [ends[0], ends[1]]).collect::<Vec<_>>().into_iter()
}

#[cfg(test)]
mod tests {
    use super::{around, of_parts};

    #[test]
    fn elements_that_touch_have_one_outline() {
        let triangle = |corners: [[f64; 2]; 3], value: f64| (corners.to_vec(), value);
        let parts = [
            triangle([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]], 1.0),
            triangle([[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]], 1.0),
            triangle([[1.0, 0.0], [2.0, 0.0], [1.0, 1.0]], 0.0),
        ];
        let lines = of_parts(&parts);
        assert_eq!(lines.len(), 4);
        assert!(lines.contains(&[(1.0, 0.0), (1.0, 1.0)]), "{lines:?}");
    }

    #[test]
    fn a_block_of_cells_has_four_sides() {
        let rows = vec![vec![0.0, 1.0, 1.0], vec![0.0, 1.0, 1.0], vec![0.0; 3]];
        let lines = around(&rows, [[0.0, 3.0], [10.0, 13.0]]);
        let sides = [
            [(1.0, 10.0), (3.0, 10.0)],
            [(1.0, 12.0), (3.0, 12.0)],
            [(1.0, 10.0), (1.0, 12.0)],
            [(3.0, 10.0), (3.0, 12.0)],
        ];
        assert_eq!(lines, sides);
    }
}
