//! Surfaces that move under the contact from station to station of a table, in two directions.
//!
//! A step of N cycles goes through the stations, each in the nearest whole elements: there the contact wears both surfaces by
//! what N cycles slide on half of the way from the station before and half of that to the next. What is worn is laid down all along
//! these halves, each place of them between the four elements around it: left at the station alone it would be a row of footprints.
//! Every other step goes through the stations the other way round, so that none is always the first.

use std::collections::BTreeMap;

use super::error::Error;
use super::position::{Position, Positions, Way};
use crate::motion::{Row, Table};
use crate::problem::{ContactProblem, ContactState, Grid};
use crate::wear::Input;

/// Elements from one place to the next, at most, at which wear is laid down on the way between stations: half of those that a place is
/// shared by along each axis.
pub(super) const APART: f64 = 0.5;

/// The sine of a turn of the way below which it is straight: the root of what rounding leaves.
const STRAIGHT: f64 = 1.5e-8;

/// The stations of a problem.
pub(super) struct Stations<'a> {
    problem: &'a ContactProblem,
    table: &'a Table,
}

impl<'a> Stations<'a> {
    /// Those of its table.
    pub fn of(problem: &'a ContactProblem, table: &'a Table) -> Self {
        Self { problem, table }
    }

    /// How far (elements) the surface of a body is moved at an offset (m), from where it lies at the station that is shown.
    fn moved(&self, body: usize, offset: [f64; 2]) -> [f64; 2] {
        let shown = self.table.rows()[self.table.shown()].offsets[body];
        let spacing = self.problem.frame.spacing();
        [0, 1].map(|axis| (shown[axis] - offset[axis]) / spacing[axis])
    }

    /// The positions at a station while a number of cycles go by; none where nothing slides. Where a law asks for the direction of slip and
    /// the way turns, either half of the way has a position of its own.
    fn positions(&self, row: usize, cycles: f64) -> Vec<Position> {
        let rows = self.table.rows();
        let count = rows.len();
        let [before, next] = [(row + count - 1) % count, (row + 1) % count];
        let slips = [before, row].map(|from| self.table.slip(from));
        let lengths = slips.map(|[x, y]| 0.5 * x.hypot(y));
        let times = [before, row].map(|from| 0.5 * rows[from].duration);
        let places = [0, 1]
            .map(|body| [before, row, next].map(|row| self.moved(body, rows[row].offsets[body])));
        let offsets = places.map(|[_, here, _]| here.map(|place| place.round() as isize));
        let [one, other] = slips;
        let turn = one[0] * other[1] - one[1] * other[0];
        let turns = turn.abs() > STRAIGHT * 4.0 * lengths[0] * lengths[1];
        let asks = [Input::Vectors, Input::CrossShear].map(|input| self.problem.asks(input));
        let halves: &[[f64; 2]] = match turns && asks != [false; 2] {
            true => &[[1.0, 0.0], [0.0, 1.0]],
            false => &[[1.0; 2]],
        };
        let of = |halves: &[f64; 2]| {
            let sum = |of: [f64; 2]| halves[0] * of[0] + halves[1] * of[1];
            let (length, time) = (sum(lengths), sum(times));
            if length == 0.0 {
                return None;
            }
            let shares = [0, 1].map(|half| halves[half] * lengths[half] / length);
            let way = [0, 1].map(|axis| sum([slips[0][axis], slips[1][axis]]));
            // Where the way turns round.
            let heading = if way == [0.0; 2] { slips[0] } else { way };
            Some(Position {
                ways: [0, 1].map(|body| spread(places, body, shares, offsets[body])),
                control: Some(rows[row].control),
                heading: Some((heading, length / time)),
                ..Position::at(offsets, cycles * length)
            })
        };
        halves.iter().filter_map(of).collect()
    }
}

/// Where (elements from an offset) a body is on half of the way from the place before (elements) and half of that to the next, and for
/// which share of the distance: shares of both halves.
fn spread(
    places: [[[f64; 2]; 3]; 2],
    body: usize,
    shares: [f64; 2],
    offset: [isize; 2],
) -> Vec<([isize; 2], f64)> {
    let between = |[from, to]: [[f64; 2]; 2], share: f64| {
        [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]))
    };
    // Places as close on both bodies.
    let longest = |from: usize| {
        let along = |body: [[f64; 2]; 3]| {
            (0..2).map(move |axis| (body[from + 1][axis] - body[from][axis]).abs())
        };
        places.into_iter().flat_map(along).fold(0.0, f64::max)
    };
    let mut laid = BTreeMap::<[isize; 2], f64>::new();
    let [before, here, next] = places[body];
    for (half, ends) in [[before, here], [here, next]].into_iter().enumerate() {
        let count = (0.5 * longest(half) / APART).ceil().max(1.0);
        for place in 0..count as usize {
            // The half that lies at the station.
            let part = 0.5 * (place as f64 + 0.5) / count;
            let place = between(ends, if half == 0 { 0.5 + part } else { part });
            let weight = shares[half] / count;
            for corner in [[0, 0], [1, 0], [0, 1], [1, 1]] {
                let element = [0, 1].map(|axis| place[axis].floor() as isize + corner[axis]);
                let near = |axis: usize| 1.0 - (place[axis] - element[axis] as f64).abs();
                let share = weight * near(0) * near(1);
                if share > 0.0 {
                    *laid.entry([0, 1].map(|axis| element[axis] - offset[axis])).or_default() +=
                        share;
                }
            }
        }
    }
    laid.into_iter().collect()
}

impl Positions for Stations<'_> {
    fn grids(&self) -> [Option<Grid>; 2] {
        let margins = |body: usize| {
            [0, 1].map(|axis| {
                let moved = |row: &Row| self.moved(body, row.offsets[body])[axis];
                let (least, most) = self
                    .table
                    .rows()
                    .iter()
                    .map(moved)
                    .fold((0.0_f64, 0.0_f64), |(least, most), moved| {
                        (least.min(moved), most.max(moved))
                    });
                [most.ceil() as usize, (-least).ceil() as usize]
            })
        };
        [0, 1].map(|body| {
            let moves = self.table.moves(body);
            moves.then(|| Grid::roaming(self.problem.frame.elements(), margins(body)))
        })
    }

    fn way(&self, _: &ContactState, forward: bool, advance: f64) -> Result<Way, Error> {
        let mut positions: Vec<Position> =
            (0..self.table.rows().len()).flat_map(|row| self.positions(row, advance)).collect();
        if !forward {
            positions.reverse();
        }
        Ok(positions.into())
    }

    fn opening(&self, _pair: usize, _position: &Position) -> f64 {
        0.0
    }
}
