//! What pairs do about an iterate, and which part of their tangential tractions is unknown then.

use serde::{Deserialize, Serialize};

use crate::compliance::PairStatus;
use crate::friction::Beyond;
use crate::numerics::vector::sweep;

/// Pairs that are open, stick or slip. Vectors on them hold all values along t1, then all along t2, then others.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(in crate::solve) struct StickSlip {
    pub status: Vec<PairStatus>,
    /// Ones where pairs stick, zeros elsewhere.
    sticking: Vec<f64>,
    /// Components of the unit vectors along the augmented tractions of slipping pairs; zeros elsewhere.
    pub along: [Vec<f64>; 2],
}

impl StickSlip {
    /// Pairs that are all open.
    pub fn open(pairs: usize) -> Self {
        let zeros = || vec![0.0; pairs];
        let status = vec![PairStatus::Open; pairs];
        Self { status, sticking: zeros(), along: [zeros(), zeros()] }
    }

    pub fn len(&self) -> usize {
        self.status.len()
    }

    /// Lets a pair stick.
    pub fn stick(&mut self, pair: usize) {
        self.status[pair] = PairStatus::Stick;
        self.sticking[pair] = 1.0;
    }

    /// Lets a pair slip whose augmented traction is beyond its limit; `diagonal` (m/Pa) is what its row has besides the
    /// map.
    pub fn slip(&mut self, pair: usize, beyond: &Beyond, diagonal: f64) {
        self.status[pair] = PairStatus::Slip { diagonal };
        [self.along[0][pair], self.along[1][pair]] = beyond.normal;
    }

    /// Unit vector along the augmented traction of a slipping pair.
    pub fn along(&self, pair: usize) -> [f64; 2] {
        [self.along[0][pair], self.along[1][pair]]
    }

    /// Keeps the tangential part of a vector along what is unknown: all of it where pairs stick, that across the
    /// augmented traction where they slip, none where they are open.
    pub fn keep_unknown(&self, vector: &mut [f64]) {
        let (one, rest) = vector.split_at_mut(self.len());
        let [] = sweep(
            [one, &mut rest[..self.len()]],
            [&self.along[0], &self.along[1], &self.sticking],
            |[x, y], [u, v, stick]| {
                let across = u * y - v * x;
                ([stick * x - v * across, stick * y + u * across], [])
            },
        );
    }
}

#[cfg(test)]
mod tests {
    use super::{Beyond, StickSlip};

    /// An open pair, one that sticks and one that slips along (0.6, 0.8), across which (10, 5) has (-0.8, 0.6) times -5.
    #[test]
    fn what_is_unknown_is_what_sticks_and_what_is_across() {
        let mut pairs = StickSlip::open(3);
        pairs.stick(1);
        pairs.slip(2, &Beyond::of([3.0, 4.0], 1.0).expect("a point beyond the disc"), 2.0);
        let mut vector = [7.0, 8.0, 10.0, 7.0, 9.0, 5.0, 1.0];
        pairs.keep_unknown(&mut vector);
        let expected = [0.0, 8.0, 4.0, 0.0, 9.0, -3.0, 1.0];
        assert!(vector.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{vector:?}");
    }
}
