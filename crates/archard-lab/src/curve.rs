//! A quantity over how far a run went, between its steps.

use super::Expectation;

/// Half the width, in logarithms, of what a step-shaped curve is smoothed over, and the least number of points.
const WINDOW: f64 = 0.35;
const FEWEST: usize = 9;

/// Logarithms of a quantity over logarithms of the progress: piecewise cubic, and as monotone as its points (Fritsch & Carlson,
/// SIAM J. Numer. Anal. 17 (1980) 238; slopes of Fritsch & Butland).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curve {
    places: Vec<f64>,
    values: Vec<f64>,
    slopes: Vec<f64>,
}

impl Curve {
    /// Through points of progress and value, without those that have one not positive; `None` of fewer than two.
    /// `stepped` curves grow element by element and are smoothed.
    pub fn through(points: impl Iterator<Item = [f64; 2]>, stepped: bool) -> Option<Self> {
        let mut points: Vec<[f64; 2]> = points
            .filter(|point| point.iter().all(|x| *x > 0.0))
            .map(|point| point.map(f64::ln))
            .collect();
        points.dedup_by(|next, last| next[0] - last[0] < 1e-12);
        if points.len() < 2 {
            return None;
        }
        let places: Vec<f64> = points.iter().map(|point| point[0]).collect();
        let values: Vec<f64> = match stepped {
            true => places.iter().map(|place| smooth(&points, *place)).collect(),
            false => points.iter().map(|point| point[1]).collect(),
        };
        let slopes = slopes(&places, &values);
        Some(Self { places, values, slopes })
    }

    /// At a progress, with the derivative of the logarithm; beyond the ends by the slopes there.
    pub fn at(&self, progress: f64) -> Expectation {
        let x = progress.ln();
        let last = self.places.len() - 1;
        let end = |i: usize| Expectation {
            log: self.values[i] + self.slopes[i] * (x - self.places[i]),
            slope: self.slopes[i],
        };
        if x <= self.places[0] {
            return end(0);
        }
        if x >= self.places[last] {
            return end(last);
        }
        let i = self.places.partition_point(|place| *place <= x) - 1;
        let length = self.places[i + 1] - self.places[i];
        let t = (x - self.places[i]) / length;
        let [a, b] = [self.values[i], self.values[i + 1]];
        let [m, n] = [self.slopes[i] * length, self.slopes[i + 1] * length];
        let (t2, t3) = (t * t, t * t * t);
        let log = (2.0 * t3 - 3.0 * t2 + 1.0) * a
            + (t3 - 2.0 * t2 + t) * m
            + (3.0 * t2 - 2.0 * t3) * b
            + (t3 - t2) * n;
        let slope =
            (6.0 * (t2 - t) * (a - b) + (3.0 * t2 - 4.0 * t + 1.0) * m + (3.0 * t2 - 2.0 * t) * n)
                / length;
        Expectation { log, slope }
    }
}

/// Slopes at the points.
fn slopes(places: &[f64], values: &[f64]) -> Vec<f64> {
    let secant = |i: usize| (values[i + 1] - values[i]) / (places[i + 1] - places[i]);
    let last = places.len() - 1;
    let inner = |i: usize| {
        let [one, other] = [secant(i - 1), secant(i)];
        if one * other <= 0.0 {
            return 0.0;
        }
        let [before, after] = [places[i] - places[i - 1], places[i + 1] - places[i]];
        let [v, w] = [2.0 * after + before, after + 2.0 * before];
        (v + w) / (v / one + w / other)
    };
    (0..=last)
        .map(|i| match i {
            0 => secant(0),
            i if i == last => secant(last - 1),
            i => inner(i),
        })
        .collect()
}

/// The parabola that fits the points around a place best, there.
fn smooth(points: &[[f64; 2]], place: f64) -> f64 {
    let mut near: Vec<[f64; 2]> = points.iter().map(|[x, y]| [x - place, *y]).collect();
    near.sort_by(|one, other| one[0].abs().total_cmp(&other[0].abs()));
    let within = near.iter().filter(|point| point[0].abs() <= WINDOW).count();
    near.truncate(within.max(FEWEST));
    let reach = near.last().map_or(1.0, |point| point[0].abs()).max(1e-9) * 1.001;
    // Normal equations of 1, x, x^2, weighted to nothing at the ends of the window.
    let mut equations = [[0.0; 4]; 3];
    for [x, y] in &near {
        let t = x / reach;
        let weight = (1.0 - t.abs().powi(3)).powi(3);
        let powers = [1.0, t, t * t];
        for (row, power) in equations.iter_mut().zip(powers) {
            for (cell, other) in row.iter_mut().zip([1.0, t, t * t, *y]) {
                *cell += weight * power * other;
            }
        }
    }
    first_unknown(equations).unwrap_or_else(|| near[0][1])
}

/// The first unknown of three linear equations; `None` where they are singular.
fn first_unknown([a, b, c]: [[f64; 4]; 3]) -> Option<f64> {
    let minor = |column: usize| {
        a[column] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[column] * c[2] - b[2] * c[column])
            + a[2] * (b[column] * c[1] - b[1] * c[column])
    };
    let whole = minor(0);
    let size = (a[0] * b[1] * c[2]).abs();
    (whole.abs() > 1e-12 * size).then(|| minor(3) / whole)
}

#[cfg(test)]
mod tests {
    use super::Curve;

    /// Power laws are straight lines, beyond the points too; curves are followed to the fourth order.
    #[test]
    fn powers_are_exact_and_bends_are_followed() {
        let power = |x: f64| [x, 3.0 * x.powf(0.4)];
        let curve = Curve::through([1.0, 2.0, 7.0, 10.0].into_iter().map(power), false).unwrap();
        for x in [0.1_f64, 1.5, 6.0, 40.0] {
            let found = curve.at(x);
            assert!((found.log - (3.0 * x.powf(0.4)).ln()).abs() < 1e-12);
            assert!((found.slope - 0.4).abs() < 1e-12);
        }
        let bent = |x: f64| (1.0 + x).powf(0.25);
        let points = (1..=100).map(|i| 0.1 * f64::from(i));
        let curve = Curve::through(points.map(|x| [x, bent(x)]), false).unwrap();
        for x in [0.55, 1.23, 4.56, 9.99] {
            assert!((curve.at(x).log - bent(x).ln()).abs() < 2e-5, "{x}");
        }
        assert_eq!(Curve::through([[0.0, 0.0], [1.0, 1.0]].into_iter(), false), None);
    }

    /// A width that grows by whole elements of 2 % of it is found to 0.5 %, its slope to 10 %.
    #[test]
    fn steps_are_smoothed() {
        let width = |x: f64| x.powf(0.25);
        let stepped = |x: f64| (width(x) / 0.02).round() * 0.02;
        let points = (1..=400).map(|i| 0.01 * f64::from(i));
        let curve = Curve::through(points.map(|x| [x, stepped(x)]), true).unwrap();
        for x in [0.3_f64, 0.777, 1.3, 2.9] {
            let found = curve.at(x);
            assert!((found.log - width(x).ln()).abs() < 5e-3, "{x} {found:?}");
            assert!((found.slope - 0.25).abs() < 0.025, "{x} {found:?}");
        }
    }
}
