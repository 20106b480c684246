//! A ball that turns in its socket from station to station.
//!
//! In each station the contact is pressed under its load, and each pair slides as far and along the direction that the turn to the
//! next one moves the ball there. The body that the load is fixed in, and with it the frame, stay. What wears off the other one is
//! kept on Lambert's equal-area map of its own, about the place that is at the pole when all angles are zero.

use super::error::Error;
use super::position::{Position, Positions, Way};
use super::stations::APART;
use crate::frame::{ContactFrame, Wrap};
use crate::motion::{Control, Joint, Turn};
use crate::problem::{ContactProblem, ContactState, Grid};

type Matrix = [[f64; 3]; 3];

/// How a body lies under its frame while it turns from a station to the next.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Turned {
    wrap: Wrap,
    /// The first pair (m), pairs along x and y, and the distance (m) between them.
    first: [f64; 2],
    pairs: [usize; 2],
    spacing: [f64; 2],
    /// Matrices from its own axes to those of the other body, at an odd number of even parts of the way.
    parts: Vec<Matrix>,
}

impl Turned {
    fn new(frame: &ContactFrame, wrap: Wrap, turn: &Turn) -> Self {
        let spacing = frame.spacing();
        let far = turn.angle() * wrap.radius;
        let count = 1 + 2 * (0.5 * far / (APART * spacing[0].min(spacing[1]))).ceil() as usize;
        let part = |one: usize| turn.after((one as f64 + 0.5) / count as f64);
        Self {
            wrap,
            first: frame.place(0),
            pairs: frame.elements(),
            spacing,
            parts: (0..count).map(part).collect(),
        }
    }

    /// Where (elements from the first pair) the body lies under a pair, and the direction of the pair's first axis on its own map.
    fn place(&self, pair: usize, part: &Matrix) -> ([f64; 2], [f64; 2]) {
        let [columns, _] = self.pairs;
        let place = self.at([pair % columns, pair / columns].map(|index| index as f64));
        let back = |vector: [f64; 3]| {
            [0, 1, 2].map(|axis| (0..3).map(|one| part[one][axis] * vector[one]).sum::<f64>())
        };
        let [t1, _, out] = self.wrap.outwards(place);
        let own = self.wrap.place(back(out));
        let [one, two, _] = self.wrap.outwards(own);
        let first = back(t1);
        let axis = [one, two].map(|unit| (0..3).map(|i| unit[i] * first[i]).sum());
        (self.elements(own), axis)
    }

    /// A place (m) by elements from the first pair.
    fn at(&self, elements: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.first[axis] + self.spacing[axis] * elements[axis])
    }

    /// Elements from the first pair to a place (m).
    fn elements(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| (place[axis] - self.first[axis]) / self.spacing[axis])
    }

    /// What each element of the body gathers of two fields of the pairs, the mean over the way. Shared out by pairs in its place, fields
    /// would have ripples where both grids are turned against each other, since the shares do not add up to one at each element.
    pub fn gathered(&self, grid: Grid, fields: [&[f64]; 2]) -> Vec<[f64; 2]> {
        let ([columns, rows], before) = (grid.elements(), grid.before());
        let pairs = Grid::of_pairs(self.pairs);
        let weight = 1.0 / self.parts.len() as f64;
        let element = |index: usize| {
            let own = [index % columns, index / columns];
            let own = self.at([0, 1].map(|axis| own[axis] as f64 - before[axis] as f64));
            let out = self.wrap.outwards(own)[2];
            let mut sum = [0.0; 2];
            for part in &self.parts {
                let there = part.map(|row| (0..3).map(|i| row[i] * out[i]).sum::<f64>());
                if there[2] > 0.0 {
                    for (pair, share) in pairs.around(self.elements(self.wrap.place(there))) {
                        sum = [0, 1].map(|own| sum[own] + weight * share * fields[own][pair]);
                    }
                }
            }
            sum
        };
        (0..columns * rows).map(element).collect()
    }

    /// Two fields of the elements at the place under a pair in the middle of the turn, linear between them.
    pub fn under(&self, grid: Grid, pair: usize, of: impl Fn(usize) -> [f64; 2]) -> [f64; 2] {
        let (place, _) = self.place(pair, &self.parts[self.parts.len() / 2]);
        grid.around(place).into_iter().fold([0.0; 2], |[a, b], (element, share)| {
            let [one, two] = of(element);
            [a + share * one, b + share * two]
        })
    }

    /// The elements that a pair slides over, the share of the way over each, and the direction of the pair's first axis there.
    pub fn swept(&self, grid: Grid, pair: usize, mut each: impl FnMut(usize, f64, [f64; 2])) {
        let weight = 1.0 / self.parts.len() as f64;
        for part in &self.parts {
            let (place, axis) = self.place(pair, part);
            for (element, share) in grid.around(place) {
                each(element, weight * share, axis);
            }
        }
    }
}

/// The turns of a problem.
pub(super) struct Turning<'a> {
    problem: &'a ContactProblem,
    joint: &'a Joint,
    wrap: Wrap,
}

impl<'a> Turning<'a> {
    /// Those of its joint; `None` where the frame is not drawn on a ball.
    pub fn of(problem: &'a ContactProblem, joint: &'a Joint) -> Option<Self> {
        Some(Self { problem, joint, wrap: problem.frame.wrap()? })
    }

    /// The body that turns, where it wears.
    fn wears_turned(&self) -> Option<usize> {
        let body = self.joint.turning(self.wrap.hollow);
        self.problem.bodies[body].wear.as_ref().map(|_| body)
    }

    /// The position of a turn while a number of cycles go by.
    fn position(&self, turn: &Turn, cycles: f64) -> Position {
        let frame = &self.problem.frame;
        let slips = (0..frame.len()).map(|pair| {
            let [t1, t2, out] = self.wrap.outwards(frame.place(pair));
            let slip = turn.slip(out);
            let along = |unit: [f64; 3]| (0..3).map(|axis| unit[axis] * slip[axis]).sum::<f64>();
            [along(t1), along(t2)]
        });
        let headings: Vec<[f64; 2]> = slips.collect();
        let far = cycles * self.wrap.radius;
        let wears = self.wears_turned();
        let turned = |body| (wears == Some(body)).then(|| Turned::new(frame, self.wrap, turn));
        Position {
            mean: None,
            turned: [0, 1].map(turned),
            slips: headings.iter().map(|[x, y]| far * x.hypot(*y)).collect(),
            headings,
            control: Some(Control::Load(turn.load)),
            ..Position::at([[0; 2]; 2], 0.0)
        }
    }
}

impl Positions for Turning<'_> {
    /// The grid of the body that turns spans all of its places that may touch.
    fn grids(&self) -> [Option<Grid>; 2] {
        let frame = &self.problem.frame;
        let turned = self.wears_turned().map(|body| {
            let touches = |&pair: &usize| self.wrap.closing(frame.place(pair)) > 0.0;
            let mut reach = [[0.0_f64; 2]; 2];
            for turn in self.joint.turns() {
                let turned = Turned::new(frame, self.wrap, turn);
                for pair in (0..frame.len()).filter(touches) {
                    let (place, _) = turned.place(pair, &turn.from);
                    for axis in 0..2 {
                        let last = frame.elements()[axis] as f64 - 1.0;
                        let [before, after] = &mut reach[axis];
                        *before = before.max(-place[axis]);
                        *after = after.max(place[axis] - last);
                    }
                }
            }
            let margins = reach.map(|ends| ends.map(|end| end.ceil() as usize));
            (body, Grid::roaming(frame.elements(), margins))
        });
        [0, 1].map(|body| turned.filter(|(own, _)| *own == body).map(|(_, grid)| grid))
    }

    fn way(&self, _: &ContactState, forward: bool, advance: f64) -> Result<Way, Error> {
        let turns = self.joint.turns().iter();
        let mut positions: Vec<Position> = turns.map(|turn| self.position(turn, advance)).collect();
        if !forward {
            positions.reverse();
        }
        Ok(positions.into())
    }

    fn opening(&self, _pair: usize, _position: &Position) -> f64 {
        0.0
    }
}
