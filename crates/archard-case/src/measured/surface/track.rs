//! How a track lies in its map.

use super::Surface;
use super::integral::Integral;
use crate::measured::plane::BEYOND_CHANCE;

impl Surface {
    /// The tangent of the angle between a track and the axis that it runs along, by the line through the middles of what is
    /// worn off place by place, and its standard uncertainty; zero where noise (m) may make it.
    pub(super) fn askew(
        &self,
        (integral, depths): (&Integral, &[f64]),
        (along, middle): (usize, [f64; 2]),
        noise: f64,
    ) -> [f64; 2] {
        // Sums over the cells at each place along it: of depths and their moments, and of the squares that noise adds by.
        let mut sums = vec![[0.0; 5]; self.places[along].len()];
        let columns = self.places[0].len();
        for &(cell, share) in &integral.shares {
            let index = [cell % columns, cell / columns][along];
            let across = self.at(cell)[1 - along] - middle[1 - along];
            let own = [
                share * depths[cell],
                share * depths[cell] * across,
                share * share,
                share * share * across,
                share * share * across * across,
            ];
            sums[index].iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        }
        let points: Vec<[f64; 3]> = (sums.iter().zip(&self.places[along]))
            .filter(|([depth, ..], _)| *depth > 0.0)
            .map(|([depth, moment, one, first, second], place)| {
                let own = moment / depth;
                let spread = second - 2.0 * own * first + own * own * one;
                [*place, own, spread * (noise / depth).powi(2)]
            })
            .collect();
        let mean = points.iter().map(|point| point[0]).sum::<f64>() / points.len() as f64;
        let sum = |of: &dyn Fn(&[f64; 3]) -> f64| points.iter().map(of).sum::<f64>();
        let square = sum(&|point| (point[0] - mean).powi(2));
        let slope = sum(&|point| (point[0] - mean) * point[1]) / square;
        let deviation = sum(&|point| (point[0] - mean).powi(2) * point[2]).sqrt() / square;
        [if slope.abs() > BEYOND_CHANCE * deviation { slope } else { 0.0 }, deviation]
    }
}
