//! How well a curvature is known when neighbouring residuals go together: a jackknife that leaves out blocks of the map.

use super::Fit;
use crate::fit::Normal;

/// Blocks along an axis. 64 in all tell a standard deviation to a tenth of itself, 1/sqrt(2 x 64).
const BLOCKS: usize = 8;

/// The standard deviation (1/m) of the curvature; zero where it is given, not a number of fewer than two blocks.
pub(super) fn deviation(fit: &Fit<'_>) -> f64 {
    if fit.shape.given.is_some() {
        return 0.0;
    }
    let size = fit.map.size();
    let block = |place: [f64; 2]| {
        let along = |axis: usize| {
            let share = place[axis] / size[axis] + 0.5;
            ((share * BLOCKS as f64) as usize).min(BLOCKS - 1)
        };
        along(0) + BLOCKS * along(1)
    };
    let unknowns = fit.shape.count();
    let mut all = [Normal::new(unknowns)];
    fit.linear(&mut all, |_| 0);
    let mut parts = vec![Normal::new(unknowns); BLOCKS * BLOCKS];
    fit.linear(&mut parts, block);
    let measured = parts.iter().filter(|part| part.holds_points());
    let curvature = |part: &Normal| {
        let step = all[0].without(part).solved();
        fit.shape.curvature(&fit.shape.moved(&fit.unknowns, &step, 1.0))
    };
    let without: Vec<f64> = measured.map(curvature).collect();
    let count = without.len() as f64;
    let mean = without.iter().sum::<f64>() / count;
    let squares: f64 = without.iter().map(|one| (one - mean).powi(2)).sum();
    if count < 2.0 { f64::NAN } else { ((count - 1.0) / count * squares).sqrt() }
}
