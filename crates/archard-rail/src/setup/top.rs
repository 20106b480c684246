//! The rail as it is seen from above.

use crate::curve::Curve;
use crate::sorted::Sorted;

/// The stretch of the rail that can be seen from above.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Top {
    /// Lengths (m) along the curve, rising, at which y rises too.
    places: Vec<f64>,
    /// y (m) there.
    across: Sorted,
}

impl Top {
    pub fn new(rail: &Curve) -> Self {
        let places = rail.samples(1e-4);
        let points: Vec<[f64; 2]> = places.iter().map(|&along| rail.point(along)).collect();
        let highest = (0..points.len()).min_by(|&a, &b| points[a][1].total_cmp(&points[b][1]));
        let highest = highest.unwrap_or(0);
        let rises = |at: usize| points[at + 1][0] > points[at][0];
        let first = (0..highest).rev().find(|&at| !rises(at)).map_or(0, |at| at + 1);
        let last = (highest..points.len() - 1).find(|&at| !rises(at)).unwrap_or(points.len() - 1);
        let across = Sorted::new(points[first..=last].iter().map(|point| point[0]).collect());
        Self { places: places[first..=last].to_vec(), across }
    }

    /// Where the rail has that y (m along its curve), if it reaches there.
    pub fn below(&self, rail: &Curve, y: f64) -> Option<f64> {
        let after = self.across.up_to(y);
        // The places hold all nodes: between two of them lies one piece.
        (after > 0 && after < self.places.len())
            .then(|| rail.meets([self.places[after - 1], self.places[after]], [1.0, 0.0], y))
    }
}
