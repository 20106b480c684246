//! A ball that turns in its socket from station to station, whose wear belongs to the socket.
//!
//! In each station the contact is pressed under its load, and each pair slides as far and along the direction that the turn to the
//! next one moves the ball there. The pole of the socket, and with it the frame, stay.

use super::error::Error;
use super::position::{Position, Positions, Way};
use crate::frame::Wrap;
use crate::motion::{Control, Joint, Turn};
use crate::problem::{ContactProblem, ContactState, Grid};

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
        Position {
            mean: None,
            slips: headings.iter().map(|[x, y]| far * x.hypot(*y)).collect(),
            headings,
            control: Some(Control::Load(turn.load)),
            ..Position::at([[0; 2]; 2], 0.0)
        }
    }
}

impl Positions for Turning<'_> {
    fn grids(&self) -> [Option<Grid>; 2] {
        [None, None]
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
