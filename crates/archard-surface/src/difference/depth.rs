//! The greatest depth.
//!
//! The maximum of a polynomial of the fourth degree that is fitted around the deepest place: one of the second leaves the fourth powers of a
//! bowl. Noise alone has a maximum, too. Where noise may have set more of the bottom apart than the polynomial covers, nothing gives
//! whether it is flat, at its mean, or round, at that maximum: the depth lies between.

use crate::fit::Normal;

/// Share of the radius of a circle as large as what is worn within which the polynomial is fitted: a quarter leaves the rim of a bowl out.
const WITHIN: f64 = 0.25;
/// Points of the radius at least.
const LEAST: f64 = 4.0;
/// Places that are tried either way, up to half of the radius, and again between the best and its neighbours.
const PLACES: i32 = 20;
/// How often: the maximum is known to the square of the last step, (1/20)^8 of the radius.
const AGAIN: usize = 4;

/// The maximum of a polynomial.
pub(super) struct Deepest {
    /// Its value (m).
    pub(super) depth: f64,
    /// Its place (m).
    pub(super) place: [f64; 2],
    /// Points and their weights in it.
    pub(super) weights: Vec<(usize, f64)>,
    /// Standard deviation (m) of the points about it.
    pub(super) scatter: f64,
    /// Whether it is of the fourth degree; of fewer points it is of the second, or their mean.
    pub(super) whole: bool,
}

/// The radius (m) of the polynomial in worn regions of that area (m^2) on pixels of that size (m).
pub(super) fn radius(area: f64, pixel: f64) -> f64 {
    (WITHIN * (area / std::f64::consts::PI).sqrt()).max(LEAST * pixel)
}

/// Of points with their places (m) and depths (m) within a radius (m) of a middle (m); `None` of too few.
pub(super) fn found(
    points: &[(usize, [f64; 2], f64)],
    middle: [f64; 2],
    radius: f64,
) -> Option<Deepest> {
    // Twice as many points as factors.
    let degree = [4, 2, 0].into_iter().find(|degree| {
        let factors = (degree + 1) * (degree + 2) / 2;
        points.len() >= 2 * factors
    })?;
    let terms = |[x, y]: [f64; 2]| -> Vec<f64> {
        let powers = (0..=degree).flat_map(|all| (0..=all).map(move |j| [all - j, j]));
        powers.map(|[i, j]| x.powi(i as i32) * y.powi(j as i32)).collect()
    };
    let inner = |place: [f64; 2]| [0, 1].map(|axis| (place[axis] - middle[axis]) / radius);
    let all: Vec<Vec<f64>> = points.iter().map(|(_, place, _)| terms(inner(*place))).collect();
    let mut normal = Normal::new(all[0].len());
    all.iter().zip(points).for_each(|(own, point)| normal.add(own, point.2));
    let factors = normal.solved();
    let value =
        |own: &[f64]| own.iter().zip(&factors).map(|(one, factor)| one * factor).sum::<f64>();
    let mut best = [0.0; 2];
    let mut step = 0.5 / f64::from(PLACES);
    for _ in 0..AGAIN {
        let steps = (-PLACES..=PLACES).flat_map(|i| (-PLACES..=PLACES).map(move |j| [i, j]));
        let places = steps
            .map(|own| [0, 1].map(|axis| best[axis] + step * f64::from(own[axis])))
            .filter(|place| place.iter().all(|own| own.abs() <= 0.5));
        best = places.max_by(|one, other| value(&terms(*one)).total_cmp(&value(&terms(*other))))?;
        step /= f64::from(PLACES);
    }
    // The value is linear in the depths: its weights solve the same equations with its terms.
    let by = normal.solved_for(&terms(best));
    let weight = |(own, point): (&Vec<f64>, &(usize, [f64; 2], f64))| {
        (point.0, own.iter().zip(&by).map(|(one, other)| one * other).sum())
    };
    let squares = all.iter().zip(points).map(|(own, point)| (point.2 - value(own)).powi(2));
    Some(Deepest {
        whole: degree == 4,
        depth: value(&terms(best)),
        place: [0, 1].map(|axis| middle[axis] + radius * best[axis]),
        weights: all.iter().zip(points).map(weight).collect(),
        scatter: (squares.sum::<f64>() / (points.len() - factors.len()).max(1) as f64).sqrt(),
    })
}

#[cfg(test)]
mod tests {
    use super::found;

    /// A polynomial of the fourth degree has its maximum where it is, and as the sum over points.
    #[test]
    fn a_quartic_has_its_maximum() {
        let depth =
            |x: f64, y: f64| 3.0 - (x - 0.5).powi(2) - 0.5 * y * y - 0.02 * (x - 0.5).powi(4);
        let points: Vec<(usize, [f64; 2], f64)> = (0..441)
            .map(|at| (at, [(at % 21) as f64 * 0.4 - 4.0, (at / 21) as f64 * 0.4 - 4.0]))
            .map(|(at, [x, y])| (at, [x, y], depth(x, y)))
            .collect();
        let deepest = found(&points, [0.1, -0.2], 4.0).unwrap();
        assert!((deepest.depth - 3.0).abs() < 5e-3 && deepest.scatter < 1e-6, "{}", deepest.depth);
        assert!((deepest.place[0] - 0.5).abs() < 0.1 && deepest.place[1].abs() < 0.1);
        let sum: f64 = deepest.weights.iter().map(|(at, weight)| weight * points[*at].2).sum();
        assert!((sum - deepest.depth).abs() < 1e-6);
    }
}
