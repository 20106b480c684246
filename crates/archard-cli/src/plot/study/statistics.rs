//! What a study says of its values: quantiles, means under a condition, and shares of the variance.

/// The value below which that share of all is, by linear interpolation between the sorted values.
pub(crate) fn quantile(sorted: &[f64], share: f64) -> f64 {
    let place = share * (sorted.len().max(1) - 1) as f64;
    let (low, high) = (place.floor() as usize, place.ceil() as usize);
    match (sorted.get(low), sorted.get(high)) {
        (Some(one), Some(other)) => one + (place - low as f64) * (other - one),
        _ => f64::NAN,
    }
}

/// Mean of some values.
pub(in crate::plot) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// What one parameter does to a result, all others taken together.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::plot) struct Effect {
    /// Mean of the parameter, and of the result, in each class.
    pub means: Vec<(f64, f64)>,
    /// Share of the variance of the result that lies between the classes; of sampled values less what chance puts there.
    pub share: f64,
}

/// The effect of a parameter over its levels, or of one that was sampled over that many equal parts of its sorted values.
pub(in crate::plot) fn effect(points: &[(f64, f64)], parts: Option<usize>) -> Effect {
    let mut sorted = points.to_vec();
    sorted.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut levels: Vec<&[(f64, f64)]> = sorted.chunk_by(|one, other| one.0 == other.0).collect();
    if let Some(parts) = parts {
        levels = sorted.chunks(sorted.len().div_ceil(parts).max(1)).collect();
    }
    let means: Vec<(f64, f64)> = levels.iter().map(|level| means(level)).collect();
    let (_, all) = self::means(&sorted);
    let square = |value: f64, from: f64| (value - from).powi(2);
    let total: f64 = sorted.iter().map(|point| square(point.1, all)).sum();
    let pairs = || levels.iter().zip(&means);
    let between: f64 =
        pairs().map(|(level, (_, mean))| level.len() as f64 * square(*mean, all)).sum();
    let spare = sorted.len().saturating_sub(levels.len());
    let chance = match (parts, spare) {
        (None, _) | (_, 0) => 0.0,
        _ => (levels.len() - 1) as f64 * (total - between) / spare as f64,
    };
    let share = if total > 0.0 { ((between - chance) / total).clamp(0.0, 1.0) } else { 0.0 };
    Effect { means, share }
}

fn means(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let sum = points.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0, sum.1 + point.1));
    (sum.0 / count, sum.1 / count)
}

/// The Sobol indices of one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::plot) struct Indices {
    /// Share of the variance by the parameter alone.
    pub first: f64,
    /// The same with all it does together with others.
    pub total: f64,
    /// Half the width of the 95 % interval of both.
    pub within: [f64; 2],
}

/// The Sobol indices of each parameter, from the results at a point A, its partner B, and A with each coordinate in turn
/// taken from B; blocks of one length.
///
/// Both by M. J. W. Jansen, *Comput. Phys. Commun.* 117 (1999) 35; intervals by resampling blocks.
pub(in crate::plot) fn indices(blocks: &[Vec<f64>]) -> Vec<Indices> {
    const RESAMPLES: usize = 500;
    let dimensions = blocks.first().map_or(0, |block| block.len().saturating_sub(2));
    let all: Vec<usize> = (0..blocks.len()).collect();
    let mut random = fastrand::Rng::with_seed(1);
    let known: Vec<Vec<[f64; 2]>> = (0..RESAMPLES)
        .map(|_| {
            let drawn: Vec<usize> = all.iter().map(|_| random.usize(..blocks.len())).collect();
            (0..dimensions).map(|axis| estimate(blocks, &drawn, axis)).collect()
        })
        .collect();
    let of = |axis: usize| {
        let [first, total] = estimate(blocks, &all, axis);
        let within = [0, 1].map(|order| {
            let mut values: Vec<f64> = known.iter().map(|sample| sample[axis][order]).collect();
            values.sort_by(f64::total_cmp);
            0.5 * (quantile(&values, 0.975) - quantile(&values, 0.025))
        });
        Indices { first, total, within }
    };
    (0..dimensions).map(of).collect()
}

/// First-order and total index of an axis from some of the blocks.
fn estimate(blocks: &[Vec<f64>], drawn: &[usize], axis: usize) -> [f64; 2] {
    let of = |index: &usize| &blocks[*index];
    let both: Vec<f64> = drawn.iter().flat_map(|index| of(index)[..2].iter().copied()).collect();
    let centre = mean(&both);
    let variance = mean(&both.iter().map(|value| (value - centre).powi(2)).collect::<Vec<_>>());
    let over = |value: fn(f64, f64, f64) -> f64| {
        let values: Vec<f64> = drawn
            .iter()
            .map(|index| {
                let block = of(index);
                value(block[0], block[1], block[2 + axis])
            })
            .collect();
        mean(&values)
    };
    let first = variance - 0.5 * over(|_, b, mixed| (b - mixed).powi(2));
    let total = 0.5 * over(|a, _, mixed| (a - mixed).powi(2));
    [first / variance, total / variance]
}

#[cfg(test)]
mod tests {
    use super::{effect, indices, quantile};
    use crate::arguments::Layout;
    use crate::sweep::points;

    #[test]
    fn quantiles_lie_between_values() {
        let values = [1.0, 2.0, 4.0, 8.0, 16.0];
        assert_eq!([0.0, 0.5, 1.0].map(|share| quantile(&values, share)), [1.0, 4.0, 16.0]);
        assert_eq!(quantile(&values, 0.375), 3.0);
        assert!(quantile(&[], 0.5).is_nan());
    }

    /// Of y = 3 a + b over levels of equal variance a has nine tenths; a value that does nothing has no share but by chance.
    #[test]
    fn shares_of_a_sum() {
        let rows: Vec<[f64; 3]> = (0..100)
            .map(|i| {
                let (a, b) = (f64::from(i / 10), f64::from(i % 10));
                [a, b, 3.0 * a + b]
            })
            .collect();
        let of = |axis: usize| {
            let points: Vec<(f64, f64)> = rows.iter().map(|row| (row[axis], row[2])).collect();
            effect(&points, None)
        };
        let (a, b) = (of(0), of(1));
        assert_eq!(a.means[2], (2.0, 10.5));
        assert!((a.share - 0.9).abs() < 1e-12 && (b.share - 0.1).abs() < 1e-12, "{a:?} {b:?}");
        let mut random = fastrand::Rng::with_seed(1);
        let noise: Vec<(f64, f64)> = (0..1000).map(|_| (random.f64(), random.f64())).collect();
        assert!(effect(&noise, Some(10)).share < 0.01);
        let line: Vec<(f64, f64)> = noise.iter().map(|point| (point.0, point.0)).collect();
        assert!(effect(&line, Some(10)).share > 0.98);
    }

    /// I. Ishigami and T. Homma (1990): sin x + 7 sin^2 y + 0.1 z^4 sin x over (-pi, pi), whose indices are known:
    /// 0.3139, 0.4424, 0 and 0.5576, 0.4424, 0.2437.
    #[test]
    fn indices_of_ishigamis_function() {
        let function = |point: &Vec<f64>| {
            let [x, y, z] = [0, 1, 2].map(|axis| std::f64::consts::PI * (2.0 * point[axis] - 1.0));
            x.sin() + 7.0 * y.sin().powi(2) + 0.1 * z.powi(4) * x.sin()
        };
        let points = points::points(Layout::Saltelli, (4096, 3), 1);
        let results: Vec<f64> = points.iter().map(function).collect();
        let blocks: Vec<Vec<f64>> = results.chunks(5).map(<[f64]>::to_vec).collect();
        let known = indices(&blocks);
        for (axis, (first, total)) in
            [(0.3139, 0.5576), (0.4424, 0.4424), (0.0, 0.2437)].into_iter().enumerate()
        {
            let found = known[axis];
            assert!((found.first - first).abs() < 0.01, "{axis}: {found:?}");
            assert!((found.total - total).abs() < 0.01, "{axis}: {found:?}");
            assert!((found.first - first).abs() < found.within[0], "{axis}: {found:?}");
            assert!((found.total - total).abs() < found.within[1], "{axis}: {found:?}");
        }
    }
}
