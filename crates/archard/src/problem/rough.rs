//! What is told of rough surfaces in contact: their spots, the gap between them, and their texture as they wear.

use std::sync::OnceLock;

use super::{ContactProblem, ContactState};
use crate::body::Body;

/// The recess (m) of both bodies at the pairs, before they wear; measured shapes take long to evaluate.
#[derive(Debug, Default)]
pub struct UnwornRecess(OnceLock<[Vec<f64>; 2]>);

/// Weights of the differences of the first, second and third neighbours for a slope, over 60 spacings (ISO 25178-2).
const SLOPE: [f64; 3] = [45.0, -9.0, 1.0];

/// Regions in contact.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Spots {
    /// How many there are.
    pub count: usize,
    /// Area (m^2) of the largest: of its elements.
    pub largest: f64,
}

impl ContactProblem {
    /// Whether surfaces are rough all over: they repeat themselves with the frame, or one was measured on a grid.
    pub fn is_rough(&self) -> bool {
        let measured = || {
            let places = self.bodies.iter().map(|body| body.profile.places());
            places.into_iter().any(|axes| axes.iter().all(|places| !places.is_empty()))
        };
        let closed = || self.frame.measure().closed;
        self.frame.is_uniform() && !self.frame.is_line() && (closed() || measured())
    }

    /// Heights (m) of a body as it is worn, positive towards the other one, one value a pair.
    pub fn heights(&self, state: &ContactState, body: usize) -> Vec<f64> {
        let unworn = &self.unworn.0.get_or_init(|| {
            let places = || (0..state.pressure.len()).map(|pair| self.frame.place(pair));
            let recess = |body: &Body| places().map(|[x, y]| body.profile.recess(x, y)).collect();
            self.bodies.each_ref().map(recess)
        })[body];
        // The zero turns -0, which would be shown, into 0.
        let lowered = state.lowered(body);
        unworn.iter().zip(&*lowered).map(|(recess, lowered)| 0.0 - (recess + lowered)).collect()
    }

    /// Root mean square (m) and skewness of a body's heights as it is worn, from their mean: Sq and Ssk of ISO 25178-2. A plane has
    /// no skewness.
    pub fn spread(&self, state: &ContactState, body: usize) -> [f64; 2] {
        let heights = self.heights(state, body);
        let mean = |power: i32, from: f64| {
            heights.iter().map(|height| (height - from).powi(power)).sum::<f64>()
                / heights.len() as f64
        };
        let middle = mean(1, 0.0);
        let rms = mean(2, middle).sqrt();
        [rms, if rms > 0.0 { mean(3, middle) / rms.powi(3) } else { 0.0 }]
    }

    /// Root mean square of the gradient of a body as it is worn, on a uniform frame: Sdq of ISO 25178-2, which takes three
    /// neighbours on either side. Pairs without them do not count; `None` if none has them.
    pub fn rms_gradient(&self, state: &ContactState, body: usize) -> Option<f64> {
        let ([nx, ny], closed) = (self.frame.elements(), self.frame.measure().closed);
        let heights = self.heights(state, body);
        let beside = SLOPE.len();
        let inside =
            |count: usize| if closed { 0..count } else { beside..count.max(2 * beside) - beside };
        let slope = |axis: usize, place: [usize; 2]| {
            let at = |offset: usize, ahead: bool| {
                let mut place = place;
                let count = [nx, ny][axis];
                place[axis] = (place[axis] + if ahead { offset } else { count - offset }) % count;
                heights[place[0] + nx * place[1]]
            };
            let terms = SLOPE.iter().zip(1..);
            let sum: f64 =
                terms.map(|(weight, offset)| weight * (at(offset, true) - at(offset, false))).sum();
            sum / (60.0 * self.frame.spacing()[axis])
        };
        let (mut sum, mut count) = (0.0, 0.0);
        for y in inside(ny) {
            for x in inside(nx) {
                sum += slope(0, [x, y]).powi(2) + slope(1, [x, y]).powi(2);
                count += 1.0;
            }
        }
        (count > 0.0 && nx.min(ny) > 2 * beside).then(|| (sum / count).sqrt())
    }
}

impl ContactState {
    /// The regions in contact on a uniform frame: elements under pressure that share a side, across the sides of surfaces that
    /// repeat themselves too.
    pub fn spots(&self, problem: &ContactProblem) -> Spots {
        let frame = &problem.frame;
        let ([nx, ny], closed) = (frame.elements(), frame.measure().closed);
        let mut open: Vec<bool> = self.pressure.iter().map(|pressure| *pressure > 0.0).collect();
        let (mut count, mut largest) = (0, 0);
        let mut found = vec![];
        for first in 0..open.len() {
            if !std::mem::take(&mut open[first]) {
                continue;
            }
            count += 1;
            found.push(first);
            let mut size = 0;
            while let Some(pair) = found.pop() {
                size += 1;
                let [x, y] = [pair % nx, pair / nx];
                let beside = |at: usize, many: usize| {
                    let before = if at > 0 { Some(at - 1) } else { closed.then_some(many - 1) };
                    let after = if at + 1 < many { Some(at + 1) } else { closed.then_some(0) };
                    [before, after].into_iter().flatten()
                };
                let along_x = beside(x, nx).map(|x| x + nx * y);
                let along_y = beside(y, ny).map(|y| x + nx * y);
                found.extend(along_x.chain(along_y).filter(|&at| std::mem::take(&mut open[at])));
            }
            largest = largest.max(size);
        }
        Spots { count, largest: largest as f64 * frame.measure().area }
    }

    /// Mean gap (m) between the surfaces over the frame.
    pub fn mean_gap(&self, problem: &ContactProblem) -> f64 {
        let gap = self.gap_of(problem);
        gap.iter().map(|gap| gap.max(0.0)).sum::<f64>() / gap.len() as f64
    }
}
