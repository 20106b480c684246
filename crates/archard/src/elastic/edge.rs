//! The stress at the edge of a contact, on the surface.
//!
//! Where tractions fall to zero with the root of the distance from an edge, the stresses along the surface are largest right at it,
//! and beyond they change by A + B d^(1/2) + C d with the distance d. Elements blur the edge: what they have there is off by the root
//! of their size, but at the centres of open elements it is not. The edge lies where a parabola through the squares of the pressures
//! has its root, the last pressed element left out; A follows by least squares. The same from points farther away, and with a
//! further term, says how far off it may be.

use std::collections::BTreeSet;

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use rayon::prelude::*;

use crate::compliance::half_space::inside::Below;
use crate::stress::{Components, MEASURES, Measure};

/// Open elements that a limit is fitted to: one more than there are terms.
const FITTED: usize = 4;
/// Open elements beyond the edge that are looked at: the fit is made once more an element farther away.
const OPEN: usize = FITTED + 1;

/// Edges that are looked at for each measure, those where it is largest: among them are some along which elements do not stand out,
/// where the limit is surer. A choice of effort.
const EDGES: usize = 32;

/// How far along an edge rows are looked at on both sides, over the width of an element across it. A choice: elements stand out from an
/// edge that is nearly along them in long steps, and nearer rows show a part of these.
const ROWS: f64 = 2.0;

/// The stress at an edge, with all that says how far off it may be.
pub(super) struct AtEdge {
    /// In three ways, the first of them the best.
    stress: [Components; 3],
    /// In rows on both sides, the best way: elements stand out from an edge that is aslant, and do so otherwise there.
    rows: Vec<Components>,
    /// Where the edge is (m).
    pub place: [f64; 2],
    /// The axis across it.
    axis: usize,
}

impl AtEdge {
    /// The value of a measure there, and how far off it may be.
    pub fn measure(&self, of: impl Fn(Components) -> f64) -> [f64; 2] {
        let [value, farther, further] = self.stress.map(&of);
        let rows = self.rows.iter().map(|own| (of(*own) - value).abs()).fold(0.0, f64::max);
        [value, (value - farther).abs() + (value - further).abs() + rows]
    }
}

/// The edges of the largest measures, by the stresses in a plane an element deep and those on the surface. None where tractions repeat themselves: their waves end
/// at no edge, so that nothing can be extrapolated to one.
pub(super) fn edges(below: &Below, plane: &[Vec<f64>; 6], face: &[Vec<f64>; 6]) -> Vec<AtEdge> {
    if below.repeats() {
        return vec![];
    }
    let [nx, ny] = below.elements();
    let pressed = |element: usize| below.pressure()[element] > 0.0;
    let rim = |element: &usize| {
        let [i, j] = [element % nx, element / nx];
        let next = [
            (i > 0).then(|| element - 1),
            (i + 1 < nx).then(|| element + 1),
            (j > 0).then(|| element - nx),
            (j + 1 < ny).then(|| element + nx),
        ];
        !pressed(*element) && next.into_iter().flatten().any(pressed)
    };
    let rim: Vec<usize> = (0..nx * ny).filter(rim).collect();
    let largest = |(_, measure): &Measure| {
        let value = |element: usize| measure(&plane.each_ref().map(|field| field[element]));
        let own = rim.iter().map(|&element| (element, value(element)));
        // Where stresses are not known there is no number.
        let mut own: Vec<(usize, f64)> = own.filter(|(_, value)| !value.is_nan()).collect();
        own.sort_by(|a, b| b.1.total_cmp(&a.1));
        own.into_iter().take(EDGES).map(|(element, _)| element)
    };
    let chosen: BTreeSet<usize> = MEASURES.iter().flat_map(largest).collect();
    let edge = |element: usize| {
        let mut edge = at_edge(below, element, face)?;
        if below.is_line() {
            return Some(edge);
        }
        let (axis, spacing) = (1 - edge.axis, below.spacing());
        let wide = (ROWS * spacing[edge.axis] / spacing[axis]).round().max(1.0) as usize;
        let (index, step) = ([element % nx, element / nx][axis], [1, nx][axis]);
        let low = (1..=wide.min(index)).map(|row| element - row * step);
        let high = (1..=wide.min([nx, ny][axis] - 1 - index)).map(|row| element + row * step);
        let rows = low.chain(high);
        edge.rows = rows.filter_map(|next| Some(at_edge(below, next, face)?.stress[0])).collect();
        (!edge.rows.is_empty()).then_some(edge)
    };
    chosen.into_par_iter().filter_map(edge).collect()
}

/// At the edge next to an element; `None` where pressures do not fall to zero as they do at a smooth edge.
fn at_edge(below: &Below, element: usize, face: &[Vec<f64>; 6]) -> Option<AtEdge> {
    let line = Line::outward(below, element)?;
    // Squares of pressures behind the last pressed element, and how far inside of the first of these the edge lies, in elements.
    let [near, next, far] = [1, 2, 3].map(|inward| line.pressure(-inward).powi(2));
    if !(near > 0.0 && next > near && far > 0.0) {
        return None;
    }
    let (slope, bend) = (2.0 * next - 1.5 * near - 0.5 * far, 0.5 * (near + far) - next);
    let root = (slope * slope - 4.0 * bend * near).max(0.0).sqrt();
    let edge = -2.0 * near / (slope + root);
    if !(-2.0 < edge && edge < 0.0) {
        return None;
    }
    let open: Vec<([f64; 2], f64)> = (1..=OPEN as isize)
        .map(|outward| (line.place(outward as f64), edge + 1.0 + outward as f64))
        .collect();
    if (1..=OPEN as isize).any(|outward| line.pressure(outward) > 0.0) {
        return None;
    }
    // Below the centre of an open element the plane has no more than even elements make.
    let stress = |outward: isize| match line.element(outward) {
        Some(element) => face.each_ref().map(|field| field[element]),
        None => below.even(line.place(outward as f64), 0.0),
    };
    let stresses: Vec<Components> = (1..=OPEN as isize).map(stress).collect();
    let limit = |from: usize, powers: &[f64]| -> Components {
        let (distances, found) = (&open[from..from + FITTED], &stresses[from..from + FITTED]);
        let terms = Mat::from_fn(FITTED, powers.len(), |i, j| distances[i].1.powf(powers[j]));
        let values = Mat::from_fn(FITTED, 6, |i, component| found[i][component]);
        let solved = terms.qr().solve_lstsq(&values);
        std::array::from_fn(|component| solved[(0, component)])
    };
    let stress =
        [limit(0, &[0.0, 0.5, 1.0]), limit(1, &[0.0, 0.5, 1.0]), limit(1, &[0.0, 0.5, 1.0, 1.5])];
    Some(AtEdge { stress, rows: vec![], place: line.place(-1.0 - edge), axis: line.axis })
}

/// Elements in a row, from the last pressed one outward.
struct Line<'a> {
    below: &'a Below,
    last: usize,
    axis: usize,
    /// 1 or -1.
    side: isize,
}

impl<'a> Line<'a> {
    /// Across the edge next to an element: along the axis that pressures change by most.
    fn outward(below: &'a Below, element: usize) -> Option<Self> {
        let [nx, ny] = below.elements();
        let at = |i: isize, j: isize| {
            let inside = (0..nx as isize).contains(&i) && (0..ny as isize).contains(&j);
            if inside { below.pressure()[(i + nx as isize * j) as usize] } else { 0.0 }
        };
        let [i, j] = [(element % nx) as isize, (element / nx) as isize];
        let mut pull = [0.0; 2];
        for (dx, dy) in (-2..=2).flat_map(|dx| (-2..=2).map(move |dy| (dx, dy))) {
            let pressure = at(i + dx, j + dy);
            pull[0] += dx as f64 * pressure;
            pull[1] += dy as f64 * pressure;
        }
        let axis = usize::from(pull[1].abs() > pull[0].abs());
        if pull[axis] == 0.0 {
            return None;
        }
        let side = if pull[axis] > 0.0 { -1 } else { 1 };
        let mut line = Self { below, last: element, axis, side };
        // To the last pressed one: inward from an open element, outward from a pressed one.
        let pressed = line.pressure(0) > 0.0;
        let steps = (1..=3).find(|&step| {
            let (inner, outer) = if pressed { (step - 1, step) } else { (-step, 1 - step) };
            line.pressure(inner) > 0.0 && line.pressure(outer) == 0.0
        })?;
        let moved = if pressed { steps - 1 } else { -steps };
        line.last = line.element(moved)?;
        Some(line)
    }

    fn element(&self, outward: isize) -> Option<usize> {
        let elements = self.below.elements();
        let index = [self.last % elements[0], self.last / elements[0]];
        let moved = index[self.axis] as isize + self.side * outward;
        let there = (0..elements[self.axis] as isize).contains(&moved);
        there.then(|| {
            let other = index[1 - self.axis];
            if self.axis == 0 {
                moved as usize + elements[0] * other
            } else {
                other + elements[0] * moved as usize
            }
        })
    }

    fn pressure(&self, outward: isize) -> f64 {
        self.element(outward).map_or(0.0, |element| self.below.pressure()[element])
    }

    /// The place so many elements outward of the last pressed one.
    fn place(&self, outward: f64) -> [f64; 2] {
        let mut place = self.below.place(self.last);
        place[self.axis] += self.side as f64 * outward * self.below.spacing()[self.axis];
        place
    }
}
