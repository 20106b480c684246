//! Integrals over a part of a measured surface, by the trapezoidal rule from reading to reading.

use super::{NoScar, Surface};

/// Most of a scar that may be without readings.
const GAPS: f64 = 0.2;

impl Surface {
    /// The share of each reading in an integral over a zone, by the trapezoidal rule from one reading to the next along each
    /// axis, and the number of gaps.
    pub(super) fn weights(
        &self,
        depths: &[f64],
        zone: [[f64; 2]; 2],
    ) -> Result<(Vec<(usize, f64)>, usize), NoScar> {
        let columns = self.places[0].len();
        let inside = [0, 1].map(|axis| {
            let [low, high] = zone[axis];
            let places = self.places[axis].iter().enumerate();
            let inside = places.filter(|(_, place)| (low..=high).contains(*place));
            inside.map(|(index, _)| index).collect::<Vec<usize>>()
        });
        let line = |axis: usize| self.axis.is_some_and(|own| own != axis);
        let (mut rows, mut gaps) = (vec![], 0);
        for &row in &inside[1] {
            let known: Vec<usize> = (inside[0].iter().copied())
                .filter(|column| depths[row * columns + column].is_finite())
                .collect();
            gaps += inside[0].len() - known.len();
            let places: Vec<f64> = known.iter().map(|&column| self.places[0][column]).collect();
            if !places.is_empty() && (line(0) || places.len() > 1) {
                rows.push((row, known, shares(&places, line(0))));
            }
        }
        let places: Vec<f64> = rows.iter().map(|(row, ..)| self.places[1][*row]).collect();
        let across = shares(&places, line(1));
        let all = inside[0].len() * inside[1].len();
        // A profile has no place where it has no reading: a gap is a long step there.
        let step = (0..2)
            .filter(|&axis| !line(axis))
            .map(|axis| {
                let places = inside[axis].iter().map(|&index| self.places[axis][index]);
                let places: Vec<f64> = places.collect();
                let widest = places.windows(2).map(|ends| ends[1] - ends[0]).fold(0.0, f64::max);
                widest / (zone[axis][1] - zone[axis][0])
            })
            .fold(0.0, f64::max);
        let share = (gaps as f64 / all.max(1) as f64).max(step);
        if share > GAPS || rows.is_empty() {
            return Err(NoScar::Gaps { share });
        }
        let cells = rows.iter().zip(&across).flat_map(|((row, known, shares), across)| {
            known
                .iter()
                .zip(shares)
                .map(move |(column, own)| (row * columns + column, own * across))
        });
        Ok((cells.collect(), gaps))
    }
}

/// The lengths that places stand for in the trapezoidal rule; one for the only place across a profile.
fn shares(places: &[f64], line: bool) -> Vec<f64> {
    let last = places.len().saturating_sub(1);
    let share =
        |index: usize| 0.5 * (places[(index + 1).min(last)] - places[index.saturating_sub(1)]);
    (0..places.len()).map(|index| if line { 1.0 } else { share(index) }).collect()
}
