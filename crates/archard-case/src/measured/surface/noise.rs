//! How far the roughness of a surface repeats itself from one reading to the next.

use archard::numerics::SAME;

/// Agreement below which two readings have nothing to do with each other.
const NONE: f64 = 0.05;

/// In how many readings there is one that is independent: of values on a grid with so many columns, those that are not
/// numbers left out. The variance of their mean is so many times that of independent ones.
pub(super) fn repeats(values: &[f64], columns: usize) -> f64 {
    let rows = values.len() / columns.max(1);
    let row = |row: usize| -> Vec<f64> { known((0..columns).map(|i| values[row * columns + i])) };
    let column = |column: usize| known((0..rows).map(|i| values[i * columns + column]));
    let along = along(&(0..rows).map(row).collect::<Vec<_>>());
    along * self::along(&(0..columns).map(column).collect::<Vec<_>>())
}

/// The step (m) that heights are rounded to: the least difference between them that is not rounding itself; none where all
/// are equal.
pub(super) fn step(heights: &[f64]) -> f64 {
    let mut known = known(heights.iter().copied());
    known.sort_by(f64::total_cmp);
    let range = known.last().zip(known.first()).map_or(0.0, |(high, low)| high - low);
    let steps = known.windows(2).map(|pair| pair[1] - pair[0]);
    let least = steps.filter(|step| *step > SAME * range).fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.0 }
}

fn known(values: impl Iterator<Item = f64>) -> Vec<f64> {
    values.filter(|value| value.is_finite()).collect()
}

/// One and twice the sum of the autocorrelations along lines, as far as they count.
fn along(lines: &[Vec<f64>]) -> f64 {
    let longest = lines.iter().map(Vec::len).max().unwrap_or_default();
    let agreement = |lag: usize| {
        let (mut product, mut square, mut count) = (0.0, 0.0, 0.0);
        for line in lines.iter().filter(|line| line.len() > lag) {
            let pairs = line.iter().zip(&line[lag..]);
            product += pairs.map(|(one, other)| one * other).sum::<f64>();
            square += line.iter().map(|value| value * value).sum::<f64>()
                * (line.len() - lag) as f64
                / line.len() as f64;
            count += (line.len() - lag) as f64;
        }
        let chance = 2.0 / f64::max(count, 1.0).sqrt();
        let agreement = if square > 0.0 { product / square } else { 0.0 };
        (agreement > chance.max(NONE)).then_some(agreement)
    };
    let agreements = (1..longest / 3).map_while(agreement);
    1.0 + 2.0 * agreements.sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::repeats;

    /// Values each repeated n times have one in n that is independent.
    #[test]
    fn what_is_repeated_counts_once() {
        let mut random = fastrand::Rng::with_seed(3);
        for n in [1, 4, 10] {
            let values: Vec<f64> =
                (0..4000 / n).flat_map(|_| std::iter::repeat_n(random.f64() - 0.5, n)).collect();
            let found = repeats(&values, values.len()) / n as f64;
            // One estimate of 400 to 4000 values; the tail below the noise is left out.
            assert!((0.8..1.25).contains(&found), "{n}: {found}");
            let other = repeats(&values, 1) / n as f64;
            assert!((found - other).abs() < 1e-12);
        }
    }
}
