//! The area of a region of a grid whose edge lies between the centres of pairs.

use std::f64::consts::PI;

use super::{ContactFrame, extent};

impl ContactFrame {
    /// Area (m^2) of the region of pairs of a uniform frame for which `holds`. Its edge crosses the line from the centre of a
    /// pair inside to that of its neighbour outside after a share `crossing(inside, outside)` of that line. A negative share
    /// takes away from the element inside. At the sides of the frame the region ends with its elements.
    ///
    /// Between the crossings the edge is an arc. A chord of length L cuts k L^3 / 12 off an arc of curvature k; all around a
    /// region curvatures add up to a turn, so that chords cut off a turn times the mean of L^2 along the edge over 12.
    pub fn area_up_to(
        &self,
        holds: impl Fn(usize) -> bool,
        crossing: impl Fn(usize, usize) -> f64,
    ) -> f64 {
        let elements = self.elements();
        let Some([columns, rows]) = extent(elements, &holds) else { return 0.0 };
        // Each cell lies between four pairs. Of those next to the sides of the frame half counts, and a pair outside the
        // frame is like its neighbour inside.
        let nearest = |axis: usize, cell: usize| cell.saturating_sub(1).min(elements[axis] - 1);
        let part =
            |axis: usize, cell: usize| if (1..elements[axis]).contains(&cell) { 1.0 } else { 0.5 };
        let mut sum = Cell::default();
        for row in rows.start..=rows.end {
            for column in columns.start..=columns.end {
                let pairs = CORNERS
                    .map(|[x, y]| nearest(0, column + x) + elements[0] * nearest(1, row + y));
                let cell = Cell::between(pairs, pairs.map(&holds), self.spacing(), &crossing);
                sum.add(&cell, part(0, column) * part(1, row));
            }
        }
        let arcs = if sum.length > 0.0 { sum.turn * sum.cubes / sum.length / 12.0 } else { 0.0 };
        sum.area + arcs
    }
}

/// The corners of a cell, counterclockwise.
const CORNERS: [[usize; 2]; 4] = [[0, 0], [1, 0], [1, 1], [0, 1]];

/// The part of a region between four pairs.
#[derive(Default)]
struct Cell {
    /// Its area (m^2).
    area: f64,
    /// By how much the edge turns there, whatever its shape: a quarter about one corner inside, and back about three.
    turn: f64,
    /// Length of the chords of the edge (m), and the sum of their cubes (m^3).
    length: f64,
    cubes: f64,
}

impl Cell {
    /// Between pairs, some of them inside.
    fn between(
        pairs: [usize; 4],
        inside: [bool; 4],
        spacing: [f64; 2],
        crossing: impl Fn(usize, usize) -> f64,
    ) -> Self {
        let count = inside.iter().filter(|&&inside| inside).count();
        if count % 4 == 0 {
            let area = count as f64 / 4.0 * spacing[0] * spacing[1];
            return Self { area, ..Self::default() };
        }
        let point = |corner: usize| [0, 1].map(|axis| CORNERS[corner][axis] as f64 * spacing[axis]);
        let crossed = |from: usize, to: usize| {
            let share = crossing(pairs[from], pairs[to]);
            [0, 1].map(|axis| point(from)[axis] + share * (point(to)[axis] - point(from)[axis]))
        };
        let [before, after] = [3, 1].map(|steps| move |corner: usize| (corner + steps) % 4);
        let mut cell = Self::default();
        if count == 2 && inside[0] == inside[2] {
            // Two regions, one at each of opposite corners.
            for corner in (0..4).filter(|&corner| inside[corner]) {
                let [from, to] =
                    [before(corner), after(corner)].map(|other| crossed(corner, other));
                cell.add(&Self::inside(&[from, point(corner), to], [to, from], 1), 1.0);
            }
            return cell;
        }
        let (mut outline, mut chord) = (vec![], [[0.0; 2]; 2]);
        for corner in 0..4 {
            if inside[corner] {
                outline.push(point(corner));
            }
            match [corner, after(corner)].map(|corner| inside[corner]) {
                [true, false] => {
                    chord[0] = crossed(corner, after(corner));
                    outline.push(chord[0]);
                }
                [false, true] => {
                    chord[1] = crossed(after(corner), corner);
                    outline.push(chord[1]);
                }
                _ => {}
            }
        }
        Self::inside(&outline, chord, count)
    }

    /// Inside an outline with so many corners of the cell and this chord.
    fn inside(outline: &[[f64; 2]], [from, to]: [[f64; 2]; 2], corners: usize) -> Self {
        let length = f64::hypot(to[0] - from[0], to[1] - from[1]);
        let turn = 0.5 * PI * (2.0 - corners as f64);
        Self { area: polygon(outline), turn, length, cubes: length.powi(3) }
    }

    /// Adds so much of another.
    fn add(&mut self, other: &Self, share: f64) {
        self.area += share * other.area;
        self.turn += share * other.turn;
        self.length += share * other.length;
        self.cubes += share * other.cubes;
    }
}

/// Area inside a polygon, positive if it goes round counterclockwise.
fn polygon(points: &[[f64; 2]]) -> f64 {
    let next = points.iter().cycle().skip(1);
    let sides = points.iter().zip(next);
    0.5 * sides.map(|([x, y], [next_x, next_y])| x * next_y - next_x * y).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use crate::body::profile::Flat;
    use crate::frame::{ContactFrame, Rectangle};

    /// A region up to a straight edge, and the one beyond it, fill the frame; so do a pair by itself and all others.
    #[test]
    fn what_is_not_inside_is_outside() {
        let frame = ContactFrame::uniform([2.0, 1.0], [20, 10], [&Flat, &Flat]).unwrap();
        let both = |level: &dyn Fn(usize) -> f64| {
            let along = |one: usize, other: usize| level(one) / (level(one) - level(other));
            [1.0, -1.0].map(|sign| frame.area_up_to(|pair| sign * level(pair) > 0.0, along))
        };
        for [a, b, c] in [[1.0, 0.0, 0.33], [0.0, 1.0, -0.47], [0.8, 0.6, 0.1], [-0.3, 1.0, 9.0]] {
            let [above, below] = both(&|pair| {
                let [x, y] = frame.place(pair);
                a * x + b * y - c
            });
            assert_relative_eq!(above + below, 2.0, max_relative = 1e-12);
            if b == 0.0 {
                assert_relative_eq!(above, 1.0 - c, max_relative = 1e-12);
            }
        }
        let [one, others] = both(&|pair| if pair == 27 { 1.0 } else { -1.0 });
        // Four chords of half a diagonal, as arcs.
        assert_relative_eq!(one, (0.5 + PI / 12.0) * frame.element_area(), max_relative = 1e-12);
        assert_relative_eq!(one + others, 2.0, max_relative = 1e-12);
    }

    /// Two pairs that meet at a corner are two regions.
    #[test]
    fn regions_may_meet_at_a_corner() {
        let frame = ContactFrame::uniform([6.0, 6.0], [6, 6], [&Flat, &Flat]).unwrap();
        let area = frame.area_up_to(|pair| [14, 21].contains(&pair), |_, _| 0.25);
        // Two squares with half diagonals of 1/4, and what arcs over their sides add.
        assert_relative_eq!(area, 2.0 * (0.125 + PI / 48.0), max_relative = 1e-12);
    }

    /// On a line of contact the ends are where they cross.
    #[test]
    fn a_line_ends_where_it_is_crossed() {
        let frame = ContactFrame::line([1.0, 0.3], [10, 1], [&Flat, &Flat]).unwrap();
        let width = frame.area_up_to(|pair| (3..6).contains(&pair), |_, to| 0.1 * to as f64);
        assert_relative_eq!(width, 0.3 * 0.1 * (2.0 + 0.2 + 0.6), max_relative = 1e-12);
    }

    /// Circles between elements: second order, whatever the offset.
    #[test]
    fn circles_are_found_between_elements() {
        for offset in [[0.0, 0.0], [0.031, -0.017], [0.05, 0.05]] {
            let rectangle = Rectangle { centre: offset, size: [3.0; 2] };
            let frame = ContactFrame::uniform(rectangle, [30, 30], [&Flat, &Flat]).unwrap();
            let radius = |pair: usize| {
                let [x, y] = frame.place(pair);
                x.hypot(y)
            };
            let along =
                |one: usize, other: usize| (1.0 - radius(one)) / (radius(other) - radius(one));
            let area = frame.area_up_to(|pair| radius(pair) < 1.0, along);
            assert_relative_eq!(area, PI, max_relative = 6e-4);
        }
    }
}
