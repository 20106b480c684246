//! The part of a field that a map shows, in as many cells as can be told apart.

use std::ops::Range;

use super::CELLS;
use archard_case::output::Image;

/// Means of a field over groups of elements.
#[derive(Debug, PartialEq)]
pub(crate) struct Cells {
    /// Lowest and highest place (m) along x and along y.
    pub(crate) edges: [[f64; 2]; 2],
    /// A row along x after the other, from the lowest y.
    pub(crate) rows: Vec<Vec<f64>>,
}

impl Cells {
    /// The elements whose centres lie within the windows (m) along each axis.
    pub(crate) fn of(image: &Image, values: &[f64], windows: [[f64; 2]; 2]) -> Self {
        let [columns, rows] = [0, 1].map(|axis| groups(image, axis, windows[axis]));
        let mean = |xs: &Range<usize>, ys: &Range<usize>| {
            let row = |y: usize| values[y * image.elements[0]..][xs.clone()].iter().sum::<f64>();
            ys.clone().map(row).sum::<f64>() / (xs.len() * ys.len()) as f64
        };
        let edges = [(0, &columns), (1, &rows)].map(|(axis, groups)| {
            let edge = |index: usize| image.origin[axis] + index as f64 * image.spacing[axis];
            let ends = [groups.first().map(|g| g.start), groups.last().map(|g| g.end)];
            ends.map(|end| edge(end.unwrap_or_default()))
        });
        let rows = rows.iter().map(|ys| columns.iter().map(|xs| mean(xs, ys)).collect()).collect();
        Self { edges, rows }
    }
}

/// The elements within the window along an axis, in groups of equal size; what is left over at the
/// end is not shown.
fn groups(image: &Image, axis: usize, [low, high]: [f64; 2]) -> Vec<Range<usize>> {
    let spare = 1e-9 * (high - low);
    let within = |i: &usize| (low - spare..=high + spare).contains(&image.centre(axis, *i));
    let shown: Vec<usize> = (0..image.elements[axis]).filter(within).collect();
    let size = shown.len().div_ceil(CELLS).max(1);
    shown.chunks_exact(size).map(|group| group[0]..group[0] + size).collect()
}

#[cfg(test)]
mod tests {
    use archard_case::output::Image;

    use super::Cells;

    /// A long frame of 400 by 3 elements of 1 m, each with its own number.
    fn image() -> (Image, Vec<f64>) {
        let image = Image {
            origin: [-200.0, -1.5],
            spacing: [1.0; 2],
            elements: [400, 3],
            fields: Vec::new(),
        };
        (image, (0..1200).map(f64::from).collect())
    }

    #[test]
    fn many_elements_share_a_cell_along_their_axis_only() {
        let (image, values) = image();
        let cells = Cells::of(&image, &values, [[-1e3, 1e3]; 2]);
        assert_eq!(cells.rows.len(), 3);
        assert_eq!(cells.rows[0].len(), 133);
        assert_eq!(cells.rows[0][1], 4.0);
        assert_eq!(cells.rows[2][0], 801.0);
        assert_eq!(cells.edges, [[-200.0, 199.0], [-1.5, 1.5]]);
    }

    #[test]
    fn a_window_cuts_both_sides() {
        let (image, values) = image();
        let cells = Cells::of(&image, &values, [[-1.5, 1.5], [-0.5, 0.5]]);
        assert_eq!(cells.rows, vec![vec![598.0, 599.0, 600.0, 601.0]]);
        assert_eq!(cells.edges, [[-2.0, 2.0], [-0.5, 0.5]]);
    }
}
