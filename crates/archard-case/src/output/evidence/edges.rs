//! A contact that is pressed against the edge of its frame: it would go on beyond.

use serde::{Deserialize, Serialize};

use archard::frame::ContactFrame;
use archard::numerics::WRITTEN;
use archard::problem::ContactProblem;

/// What the pairs at the edge bear.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Edges {
    /// Their share of the load.
    pub share: f64,
    /// Those of them under pressure.
    pub pairs: usize,
}

/// The same between the pairs of meshes, relative to the range of their gaps.
const EVEN_ON_MESHES: f64 = 1e-3;

/// The pairs at the edge of a frame; none where the surfaces end with it.
pub(super) fn border(problem: &ContactProblem) -> Vec<usize> {
    let frame = &problem.frame;
    if frame.measure().closed {
        return vec![];
    }
    if !frame.is_uniform() {
        return at_the_border(frame);
    }
    let watched = [0, 1].map(|axis| !problem.is_even(axis));
    (0..frame.len()).filter(|&pair| on_the_rim(frame, pair, watched)).collect()
}

/// What the pairs at the edge bear; `None` without any pressure.
pub(super) fn of(frame: &ContactFrame, border: &[usize], pressure: &[f64]) -> Option<Edges> {
    let measure = frame.measure();
    let load = measure.load(pressure);
    if load <= 0.0 {
        return None;
    }
    let mut bears = vec![0.0; pressure.len()];
    border.iter().for_each(|&pair| bears[pair] = pressure[pair]);
    let pairs = border.iter().filter(|&&pair| pressure[pair] > 0.0).count();
    Some(Edges { share: measure.load(&bears) / load, pairs })
}

fn on_the_rim(frame: &ContactFrame, pair: usize, watched: [bool; 2]) -> bool {
    let elements = frame.elements();
    let index = [pair % elements[0], pair / elements[0]];
    (0..2).any(|axis| watched[axis] && (index[axis] == 0 || index[axis] + 1 == elements[axis]))
}

/// The pairs whose elements reach the box around all of them, planes of symmetry left out, and sides towards which the
/// gaps do not change: there a line contact ends with its bodies.
fn at_the_border(frame: &ContactFrame) -> Vec<usize> {
    let corners: Vec<Vec<[f64; 3]>> = (0..frame.len()).map(|pair| frame.outline(pair)).collect();
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for corner in corners.iter().flatten() {
        for axis in 0..2 {
            (low[axis], high[axis]) = (low[axis].min(corner[axis]), high[axis].max(corner[axis]));
        }
    }
    let mirrored = frame.mirrored();
    let reaches = |pair: usize, axis: usize| {
        let near = WRITTEN * (high[axis] - low[axis]);
        let at = |value: f64, edge: f64| {
            (value - edge).abs() <= near && !(mirrored[axis] && edge.abs() <= near)
        };
        corners[pair]
            .iter()
            .any(|corner| at(corner[axis], low[axis]) || at(corner[axis], high[axis]))
    };
    let middle =
        [0, 1].map(|axis| if mirrored[axis] { 0.0 } else { 0.5 * (low[axis] + high[axis]) });
    let sides = [0, 1].map(|axis| {
        let border: Vec<usize> = (0..frame.len()).filter(|&pair| reaches(pair, axis)).collect();
        if ends_evenly(frame, &border, (axis, middle[axis])) { vec![] } else { border }
    });
    let mut border = sides.concat();
    border.sort_unstable();
    border.dedup();
    border
}

/// Whether pairs at the border have the gaps of those in the middle along an axis.
fn ends_evenly(frame: &ContactFrame, border: &[usize], (axis, middle): (usize, f64)) -> bool {
    let gap = frame.gap();
    let (least, most) = gap.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), gap| {
        (low.min(*gap), high.max(*gap))
    });
    border.iter().all(|&pair| {
        let mut place = frame.place(pair);
        place[axis] = middle;
        let distance = |other: usize| {
            let [x, y] = frame.place(other);
            (x - place[0]).hypot(y - place[1])
        };
        let nearest = (0..frame.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        // Rows without any between them tell nothing.
        nearest
            .filter(|&other| other != pair)
            .is_some_and(|other| (gap[pair] - gap[other]).abs() <= EVEN_ON_MESHES * (most - least))
    })
}
