//! Surfaces that repeat themselves with the frame and slide past each other for ever.
//!
//! A step goes through all positions of a period, an element apart, and slides the same distance in each: what a point of one surface
//! goes through in a period it meets at all points of the other on its line.

use super::error::Error;
use super::position::{Position, Positions, Way};
use crate::problem::{ContactProblem, ContactState, Grid};

/// A surface that is moved round past another.
pub(super) struct Recurring<'a> {
    problem: &'a ContactProblem,
    moves: usize,
    /// The elements of the one that is moved.
    grid: Grid,
}

impl<'a> Recurring<'a> {
    /// Of a problem, the body that is moved.
    pub fn of(problem: &'a ContactProblem, moves: usize) -> Self {
        let grid = Grid::recurring(problem.frame.elements(), problem.motion.direction.axis);
        Self { problem, moves, grid }
    }
}

impl Positions for Recurring<'_> {
    fn grids(&self) -> [Option<Grid>; 2] {
        [0, 1].map(|body| (body == self.moves).then_some(self.grid))
    }

    fn way(&self, _: &ContactState, _forward: bool, advance: f64) -> Result<Way, Error> {
        let axis = self.problem.motion.direction.axis;
        let count = self.problem.frame.elements()[axis];
        let distance = self.problem.motion.slip(advance) / count as f64;
        let position = |offset: usize| {
            let mut offsets = [[0; 2]; 2];
            offsets[self.moves][axis] = offset as isize;
            Position::at(offsets, distance)
        };
        // The last one is where the next step begins.
        Ok((1..=count).map(position).collect::<Vec<_>>().into())
    }

    fn opening(&self, pair: usize, position: &Position) -> f64 {
        let (frame, profile) = (&self.problem.frame, &self.problem.bodies[self.moves].profile);
        let place = frame.place(pair);
        let moved = frame.place(self.grid.at(pair, position.offsets[self.moves]));
        profile.recess(moved[0], moved[1]) - profile.recess(place[0], place[1])
    }

    fn bodies(&self) -> [usize; 2] {
        [1 - self.moves, self.moves]
    }
}
