//! Positions of the surfaces on each other within a step, and how far pairs slide in each.
//!
//! Surfaces that stay or pass are seen in one position. Those that [swing](super::swing), that [repeat](super::recurring)
//! themselves and slide past each other, that follow a [table](super::stations), or [turn](super::turning) in each other
//! are seen in one after the other: in each the contact wears both surfaces implicitly, and the depths are laid down where the points
//! of each surface are.

use super::error::Error;
use super::turning::Turned;
use crate::motion::{Control, Lever};
use crate::numerics::vector::Values;
use crate::problem::{ContactProblem, ContactState, Grid, Surface};

/// A position of the surfaces, and how far pairs slide there in a step.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Position {
    /// By how many elements along x and y body 1 and body 2 are moved.
    pub offsets: [[isize; 2]; 2],
    /// Distance (m), the mean over the load; where it is not known that of the pressures.
    pub mean: Option<f64>,
    /// Distance (m) of each pair; the mean for all if empty.
    pub slips: Vec<f64>,
    /// Where (elements from the offset) the surface of each body is meanwhile, and for which share of the distance.
    pub ways: [Vec<([isize; 2], f64)>; 2],
    /// How each body is turned; its places under the frame then follow from this and not from an offset.
    pub turned: [Option<Turned>; 2],
    /// What is prescribed there; where there is nothing, what the step prescribes.
    pub control: Option<Control>,
    /// Along which direction body 2 slides over body 1, and how fast (m/s); as the motion says where there is nothing.
    pub heading: Option<([f64; 2], f64)>,
    /// The same of each pair along its t1 and t2, of any length; none where one holds for all.
    pub headings: Vec<[f64; 2]>,
}

impl Position {
    /// Bodies moved by so many elements, all pairs sliding that far (m).
    pub fn at(offsets: [[isize; 2]; 2], distance: f64) -> Self {
        let ways = || vec![([0; 2], 1.0)];
        Self {
            offsets,
            mean: Some(distance),
            slips: vec![],
            ways: [ways(), ways()],
            turned: [None, None],
            control: None,
            heading: None,
            headings: vec![],
        }
    }

    /// That of surfaces that stay, whose pairs slide that far (m) at a unit lever.
    pub fn middle(problem: &ContactProblem, slip: f64) -> Self {
        let middle = Self::at([[0; 2]; 2], slip);
        if problem.motion.lever_arm() != Some(Lever::Radius) {
            return middle;
        }
        let slip = |pair| slip * problem.motion.lever(problem.frame.place(pair));
        Self { mean: None, slips: (0..problem.frame.len()).map(slip).collect(), ..middle }
    }

    /// How far (m) a body slid and how deep (m) it wore so far under a pair, half-way.
    pub fn before(&self, (body, surface): (usize, &Surface), pair: usize) -> [f64; 2] {
        match &self.turned[body] {
            None => surface.before(surface.grid.at(pair, self.offsets[body])),
            Some(turned) => turned.under(surface.grid, pair, |element| surface.before(element)),
        }
    }

    /// The elements of a body that a pair slides over, the share of the way over each of them, and the direction (cosine and sine) of
    /// the pair's first axis on the body, where that is turned.
    pub fn swept(
        &self,
        (body, grid): (usize, Grid),
        pair: usize,
        mut each: impl FnMut(usize, f64, Option<[f64; 2]>),
    ) {
        if let Some(turned) = &self.turned[body] {
            return turned
                .swept(grid, pair, |element, share, axis| each(element, share, Some(axis)));
        }
        let [x, y] = self.offsets[body];
        for ([along, across], share) in &self.ways[body] {
            each(grid.at(pair, [x + along, y + across]), *share, None);
        }
    }

    /// Distance (m) that pairs slide.
    pub fn slips(&self) -> Values<'_> {
        match self.mean {
            Some(mean) if self.slips.is_empty() => Values::All(mean),
            _ => Values::Each(&self.slips),
        }
    }

    /// Their mean, weighted by the pressures (Pa).
    pub fn distance(&self, pressure: &[f64]) -> f64 {
        self.mean.unwrap_or_else(|| mean(&self.slips, pressure))
    }
}

/// What surfaces go through in a step.
pub(super) struct Way {
    pub positions: Vec<Position>,
    /// How far pairs of surfaces that swing slide to both sides (m), the mean over the load.
    pub reach: f64,
}

impl From<Vec<Position>> for Way {
    fn from(positions: Vec<Position>) -> Self {
        Self { positions, reach: 0.0 }
    }
}

/// The mean of a field, weighted by the pressures (Pa).
pub(super) fn mean(field: &[f64], pressure: &[f64]) -> f64 {
    let load: f64 = pressure.iter().sum();
    let sum: f64 = field.iter().zip(pressure).map(|(value, pressure)| value * pressure).sum();
    if load > 0.0 { sum / load } else { 0.0 }
}

/// Surfaces that a step sees in one position after the other.
pub(super) trait Positions {
    /// The elements of body 1 and body 2, where they are not one a pair.
    fn grids(&self) -> [Option<Grid>; 2];

    /// What a step of that advance (the motion's unit) goes through from a state on, forward or back.
    ///
    /// # Errors
    /// If elasticity takes up the motion.
    fn way(&self, state: &ContactState, forward: bool, advance: f64) -> Result<Way, Error>;

    /// By how much (m) a pair is opened as unworn bodies are moved; not finite where one ends.
    fn opening(&self, pair: usize, position: &Position) -> f64;

    /// The body that keeps its place, and the one that is moved over it.
    fn bodies(&self) -> [usize; 2] {
        [0, 1]
    }

    /// Whether the contact has come to an end of a frame that it may not reach.
    fn reaches_an_end(&self, _pressure: &[f64]) -> bool {
        false
    }

    /// Energy (J) that a cycle dissipates, by the contact that is shown.
    fn dissipated(&self, _state: &ContactState, _way: &Way) -> f64 {
        0.0
    }
}

/// Gap (m) of the worn, undeformed surfaces at zero approach in a position; `None` where one of them does not reach over the frame.
pub(super) fn gap(
    positions: &dyn Positions,
    (problem, state): (&ContactProblem, &ContactState),
    position: &Position,
) -> Option<Vec<f64>> {
    let frame = &problem.frame;
    let bodies = positions.bodies();
    let at = |pair: usize| {
        let [stays, moves] =
            bodies.map(|body| position.before((body, &state.surfaces[body]), pair)[1]);
        let gap = frame.gap()[pair] + positions.opening(pair, position) + stays + moves;
        gap.is_finite().then_some(gap)
    };
    (0..frame.len()).map(at).collect()
}
