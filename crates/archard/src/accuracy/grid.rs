//! The grids that are tried for an accuracy: coarser ones and finer ones.

use super::increments;
use crate::body::Body;
use crate::numerics::counted;
use crate::simulation::Simulation;

/// Elements along an axis, at most: so many by so many take some 4 GB.
pub const MOST: usize = 1 << 12;

/// How finely a run is divided.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Elements along x and y; the strips of a line of contact along y.
    pub elements: [usize; 2],
    /// Whether finer elements may be taken; their error is stated where not.
    pub refines: bool,
    /// Tolerance of the steps; `None` where elements do not go with it.
    pub tolerance: Option<f64>,
    /// Whether it becomes smaller with finer elements.
    pub tightens: bool,
    /// Increments of a cycle in which bodies rub; `None` where they rub in none.
    pub increments: Option<usize>,
    /// Whether they become more with finer elements.
    pub divides: bool,
    /// By how much the frame is moved along x and y (m).
    pub moved: [f64; 2],
    /// How many times coarser it is than the grid of the run itself, which is 1.
    pub ratio: f64,
}

impl Grid {
    /// The grid of a run, which becomes finer as a whole until the error is as asked.
    pub fn new(elements: [usize; 2]) -> Self {
        Self {
            elements,
            refines: true,
            tolerance: None,
            tightens: true,
            increments: None,
            divides: true,
            moved: [0.0; 2],
            ratio: 1.0,
        }
    }

    /// The outputs that a run on it has of all: steps that end at outputs become no longer unless outputs become fewer.
    pub fn outputs(&self, all: &[f64]) -> Vec<f64> {
        let mut fewer: Vec<_> =
            all.iter().rev().step_by(self.ratio.ceil() as usize).copied().collect();
        fewer.reverse();
        fewer
    }

    /// The one so many times coarser in the same frame, moved by half an element along the motion and across. One element more or
    /// less does that, and the centre of the frame, where values are read, stays.
    pub(super) fn coarser(&self, own: &Simulation, ratio: f64, moved: [bool; 2]) -> Self {
        let mut grid = Self { ratio, ..self.clone() };
        let frame = &own.problem.frame;
        let rectangle = frame.rectangle();
        // Frames that become wider or repeat themselves have an even number of elements: they are moved as a whole.
        let widens = own.wider.is_some() || frame.measure().closed;
        let known = Body::known(&own.problem.bodies);
        for axis in 0..axes(own) {
            let elements = self.elements[axis];
            let moved = [moved, [moved[1], moved[0]]][own.problem.motion.direction.axis];
            let other = usize::from(moved[axis] && !widens);
            grid.elements[axis] = nearest(elements as f64 / ratio, elements + other);
            // As far as the surfaces are known: measured ones end with their readings.
            let last = rectangle.centre[axis] + 0.5 * rectangle.size[axis];
            if widens && moved[axis] && last <= known[axis][1] {
                grid.moved[axis] += 0.5 * (rectangle.size[axis] / grid.elements[axis] as f64);
            }
        }
        grid.tolerance = self.tolerance.map(|tolerance| tolerance * ratio * ratio);
        grid.increments = self.increments.map(|count| increments::fewer(count, ratio));
        grid
    }

    /// The one so many times finer in all that may be, its tolerance smaller by that power of it, the order of the error; `None`
    /// where so many elements are not allowed.
    pub fn finer(&self, finer: f64, order: f64) -> Option<Self> {
        let mut grid = self.clone();
        if self.refines {
            let refined = |n: usize| if n == 1 { 1 } else { counted(finer * n as f64, n) };
            grid.elements = self.elements.map(refined);
            if grid.elements.iter().any(|&n| n > MOST) {
                return None;
            }
        }
        if self.divides {
            grid.increments = self.increments.map(|count| increments::more(count, finer));
        }
        if self.tightens {
            grid.tolerance = self.tolerance.map(|tolerance| tolerance / finer.powf(order));
        }
        Some(grid)
    }

    /// How many times coarser its elements are than those of another grid.
    pub(super) fn beside(&self, own: &Self, axes: usize) -> f64 {
        let shares = [0, 1].map(|axis| own.elements[axis] as f64 / self.elements[axis] as f64);
        (shares[0] * shares[1]).powf(1.0 / axes as f64)
    }
}

/// Axes along which a frame is divided.
pub(super) fn axes(own: &Simulation) -> usize {
    let frame = &own.problem.frame;
    if frame.is_line() && frame.elements()[1] == 1 { 1 } else { 2 }
}

/// The number of elements next to some number that is even or odd as another is.
fn nearest(wanted: f64, as_another: usize) -> usize {
    let odd = as_another % 2;
    odd + 2 * ((0.5 * (wanted - odd as f64)).round() as usize).max(1)
}
