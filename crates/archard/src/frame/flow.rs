//! How particles pass from pair to pair while the contact rolls.
//!
//! Where pairs form rows, a particle reaches each pair from the pair ahead. Scattered pairs have no pair ahead. What a
//! particle gains on the passage is then the [upwind](crate::numerics::upwind) derivative along its path times the mean
//! side of a pair. On a square grid both are the same.

use std::borrow::Cow;

use super::cloud::Cloud;
use super::line::{self, Line};
use super::{ContactFrame, Direction, Shape};
use crate::numerics::upwind::DegenerateCloud;

/// The pairs of a frame as particles pass them while the contact rolls in a direction.
#[derive(Debug, Clone, Copy)]
pub struct Flow<'a> {
    frame: &'a ContactFrame,
    direction: Direction,
    /// `None` where the pairs form rows.
    cloud: Option<&'a Cloud>,
}

impl ContactFrame {
    /// How particles pass the pairs while the contact rolls in a direction.
    ///
    /// # Errors
    /// If the pairs form no rows and are too few, or on one line across the direction.
    pub fn flow(&self, direction: Direction) -> Result<Flow<'_>, DegenerateCloud> {
        let cloud = match &self.shape {
            Shape::Described(described) if described.pairs.elements.is_none() => {
                let measure = self.measure();
                Some(described.clouds.along(direction, &described.pairs, measure)?)
            }
            _ => None,
        };
        Ok(Flow { frame: self, direction, cloud })
    }
}

impl<'a> Flow<'a> {
    /// The frame.
    pub fn frame(&self) -> &'a ContactFrame {
        self.frame
    }

    /// Where the contact rolls to.
    pub fn direction(&self) -> Direction {
        self.direction
    }

    /// How far the contact rolls in one passage, from one pair to the next on the average (m).
    pub fn advance(&self) -> f64 {
        let axis = self.direction.axis;
        match (&self.frame.shape, self.cloud) {
            (_, Some(cloud)) => cloud.side,
            (Shape::Uniform(grid), _) => grid.spacing()[axis],
            (Shape::Described(described), _) => {
                let images = if described.pairs.mirrored[axis] { 2 } else { 1 };
                described.size[axis] / (images * self.frame.elements()[axis]) as f64
            }
        }
    }

    /// How far it rolls in the passage to each pair (m), to the foremost as far as from them to the next; `None`
    /// where that is the same everywhere.
    pub fn advances(&self) -> Option<Vec<f64>> {
        if self.frame.is_uniform() || self.cloud.is_some() {
            return None;
        }
        let axis = self.direction.axis;
        let places: Vec<f64> =
            (0..self.frame.len()).map(|pair| self.frame.place(pair)[axis]).collect();
        let gained = self.direction.gained(&places, self.frame.elements());
        Some(gained.iter().map(|gained| gained.abs()).collect())
    }

    /// What particles gain of a vector field along t1 and t2 in the passage to each pair, one value a pair; at the
    /// foremost pairs, what they gain on the way to the next.
    pub fn gained(&self, field: [&[f64]; 2]) -> [Vec<f64>; 2] {
        [0, 1].map(|axis| match self.cloud {
            Some(cloud) => cloud.gained(field[axis], axis != self.direction.axis),
            None => self.direction.gained(field[axis], self.frame.elements()),
        })
    }

    /// The mean of a field over the passage to each pair, of what is at both of its ends; the field is zero ahead
    /// of the foremost pairs.
    pub fn on_the_way(&self, field: &[f64]) -> Vec<f64> {
        if let Some(cloud) = self.cloud {
            let upstream = cloud.upstream(field);
            return field.iter().zip(upstream).map(|(here, there)| 0.5 * (here + there)).collect();
        }
        let elements = self.frame.elements();
        let ahead = |pair| self.direction.ahead(pair, elements).map_or(0.0, |ahead| field[ahead]);
        (0..field.len()).map(|pair| 0.5 * (field[pair] + ahead(pair))).collect()
    }

    /// The lines of rolling, in the order of their places: rows, or strips as wide as a mean pair.
    pub fn lines(&self) -> Cow<'a, [Line]> {
        match self.cloud {
            Some(cloud) => Cow::Borrowed(&cloud.lines),
            None => Cow::Owned(line::rows(self.frame, self.direction)),
        }
    }

    /// A pair in the middle that particles reach from others.
    pub fn middle(&self) -> usize {
        if let Some(cloud) = self.cloud {
            return cloud.middle;
        }
        let (elements, axis) = (self.frame.elements(), self.direction.axis);
        let line = self.direction.lines(elements).nth(elements[1 - axis] / 2);
        line.and_then(|mut line| line.nth(elements[axis] / 2)).unwrap_or_default()
    }

    /// Whether the lines of rolling are rows, each with pairs of its own.
    pub fn has_rows(&self) -> bool {
        self.cloud.is_none()
    }
}
