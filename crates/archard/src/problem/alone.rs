//! How far the pressures of single pairs stand off those around them, on meshes.

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;

use super::ContactProblem;

/// Pairs in the two rings about one on a regular mesh of triangles: three times as many as a polynomial of second degree has terms.
const RINGS: usize = 18;

impl ContactProblem {
    /// The largest difference of the pressure of a pair and of the polynomial of second degree closest to those of the pairs around it,
    /// where all these bear some, relative to the largest pressure; `None` where no pair has so many around it, and without pressures.
    ///
    /// Pressures follow the displacements that elements find: what these leave out shows in pressures that alternate, what is left out
    /// at the edge of a contact of few elements in waves from there. Either is a part of the error that no error of displacements has.
    #[must_use]
    pub fn alone(&self, pressure: &[f64]) -> Option<f64> {
        let peak = pressure.iter().copied().fold(0.0, f64::max);
        let place = |pair: usize| {
            let [x, y] = self.frame.place(pair);
            [x, y, self.frame.height(pair)]
        };
        let places: Vec<[f64; 3]> = (0..self.frame.len()).map(place).collect();
        let off = |pair: usize| self.off_its_neighbours(pair, &places, pressure);
        let bearing = (0..pressure.len()).filter(|&pair| pressure[pair] > 0.0);
        Some(bearing.filter_map(off).reduce(f64::max)? / peak)
    }

    fn off_its_neighbours(
        &self,
        pair: usize,
        places: &[[f64; 3]],
        pressure: &[f64],
    ) -> Option<f64> {
        let away = |other: usize| [0, 1, 2].map(|axis| places[other][axis] - places[pair][axis]);
        let square = |away: [f64; 3]| away.iter().map(|one| one * one).sum::<f64>();
        let mut others: Vec<(f64, usize)> = (0..places.len())
            .filter(|&other| other != pair)
            .map(|other| (square(away(other)), other))
            .collect();
        if others.len() < RINGS {
            return None;
        }
        others.select_nth_unstable_by(RINGS - 1, |one, other| one.0.total_cmp(&other.0));
        others.truncate(RINGS);
        if others.iter().any(|(_, other)| pressure[*other] <= 0.0) {
            return None;
        }
        let reach = others.iter().map(|(square, _)| *square).fold(0.0, f64::max).sqrt();
        let terms = |other: usize| {
            let [x, y, _] = self.frame.resolve(pair, away(other)).map(|one| one / reach);
            [1.0, x, y, x * x, x * y, y * y]
        };
        let rows: Vec<[f64; 6]> = others.iter().map(|(_, other)| terms(*other)).collect();
        let matrix = Mat::from_fn(RINGS, 6, |row, term| rows[row][term]);
        let values = Mat::from_fn(RINGS, 1, |row, _| pressure[others[row].1]);
        let here = matrix.qr().solve_lstsq(&values)[(0, 0)];
        here.is_finite().then(|| (pressure[pair] - here).abs())
    }
}
