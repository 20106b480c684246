//! Functions that are linear between places of a contact, and their transforms.

use std::f64::consts::{FRAC_2_PI, PI};

use super::elliptic;

/// Stick ratios that the places resolve.
pub(super) const STICK_RATIOS: std::ops::RangeInclusive<f64> = 1e-4..=0.99;

/// The places on which P and Q live, and what takes one to the other.
pub(super) struct Stretches {
    pub(super) places: Vec<f64>,
    /// The place that is the edge of the stick zone.
    pub(super) border: usize,
    /// H of an even function at the places by its slopes on the stretches.
    pub(super) of_even: Vec<Vec<f64>>,
    /// H of an odd function.
    pub(super) of_odd: Vec<Vec<f64>>,
    /// R from the border on, 0 inside.
    pub(super) of_slip: Vec<Vec<f64>>,
}

impl Stretches {
    /// So many stretches, half of them in a stick zone of that share; `None` outside the ratios that
    /// they resolve.
    pub(super) fn new(count: usize, stick_ratio: f64) -> Option<Self> {
        if !STICK_RATIOS.contains(&stick_ratio) {
            return None;
        }
        let border = count / 2;
        let share = |at: usize| at as f64 / border as f64;
        let inside = (0..border).map(|at| stick_ratio * (1.0 - (1.0 - share(at)).powi(2)));
        // Logarithmic, for small stick zones, and dense at both ends.
        let outside = (0..=border).map(|at| {
            let x = share(at);
            stick_ratio.powf(1.0 - x * x * (3.0 - 2.0 * x))
        });
        let places: Vec<f64> = inside.chain(outside).collect();
        let table = |element: &dyn Fn(f64, [f64; 2]) -> f64| -> Vec<Vec<f64>> {
            let row = |t: f64| places.windows(2).map(|s| element(t, [s[0], s[1]])).collect();
            places.iter().map(|&t| row(t)).collect()
        };
        let own = |t: f64, s: [f64; 2]| integrated_log(t - s[0]) - integrated_log(t - s[1]);
        let image = |t: f64, s: [f64; 2]| integrated_log(t + s[1]) - integrated_log(t + s[0]);
        let of_even = table(&|t, s| (own(t, s) - image(t, s)) / PI);
        let of_odd = table(&|t, s| (own(t, s) + image(t, s)) / PI);
        let of_slip = table(&|t, s| if t < stick_ratio || s[0] < t { 0.0 } else { slip(t, s) });
        Some(Self { border, of_even, of_odd, of_slip, places })
    }

    /// A function's image by one of the tables.
    pub(super) fn image(&self, table: &[Vec<f64>], values: &[f64]) -> Vec<f64> {
        let slopes: Vec<f64> = slopes(&self.places, values).collect();
        let product = |row: &Vec<f64>| row.iter().zip(&slopes).map(|(a, b)| a * b).sum();
        table.iter().map(product).collect()
    }
}

/// x ln|x|, whose differences integrate the logarithm; what is linear cancels in functions that are 0
/// at 1.
fn integrated_log(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x * x.abs().ln() }
}

/// -(2/pi) int (t/s) K(sqrt(1 - (t/s)^2)) ds over a stretch beyond t, by Gauss's two points.
fn slip(t: f64, [start, end]: [f64; 2]) -> f64 {
    let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
    let part = |s: f64| t / s * elliptic(t / s);
    let offset = half / 3.0_f64.sqrt();
    -FRAC_2_PI * half * (part(middle - offset) + part(middle + offset))
}

/// A function that is linear between places, by its slopes.
pub(super) fn slopes(places: &[f64], values: &[f64]) -> impl Iterator<Item = f64> {
    let stretches = places.windows(2).zip(values.windows(2));
    stretches.map(|(t, value)| (value[1] - value[0]) / (t[1] - t[0]))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use super::Stretches;

    /// Closed forms: with L = ln[(1 + t)/(1 - t)], H[1 - t^2] = [2 t + (1 - t^2) L]/pi and
    /// H[t (1 - t^2)] = [2 (t^2 - 2/3) + t (1 - t^2) L]/pi; R[1 - t^2] falls over t^2 as
    /// -(4/pi) K(sqrt(1 - t^2))/t^2.
    #[test]
    fn transforms_of_polynomials() {
        let stretches = Stretches::new(240, 0.6).unwrap();
        let places = &stretches.places;
        let even: Vec<f64> = places.iter().map(|t| 1.0 - t * t).collect();
        let odd: Vec<f64> = places.iter().map(|t| t * (1.0 - t * t)).collect();
        let of_even = stretches.image(&stretches.of_even, &even);
        let of_odd = stretches.image(&stretches.of_odd, &odd);
        for at in [1, 30, 119, 120, 121, 180, 238] {
            let t = places[at];
            let bulge = (1.0 - t * t) * ((1.0 + t) / (1.0 - t)).ln();
            assert_relative_eq!(of_even[at], (2.0 * t + bulge) / PI, epsilon = 1e-4);
            let expected = (2.0 * (t * t - 2.0 / 3.0) + t * bulge) / PI;
            assert_relative_eq!(of_odd[at], expected, epsilon = 1e-4);
        }
        let of_slip = stretches.image(&stretches.of_slip, &even);
        assert_eq!((of_slip[119], of_slip[240]), (0.0, 0.0));
        for at in [140, 180, 220] {
            let over_square = |at: usize| of_slip[at] / places[at].powi(2);
            let rise = over_square(at + 1) - over_square(at - 1);
            let t = places[at];
            let slope = -4.0 / PI * super::elliptic(t) / (t * t);
            let width = places[at + 1] - places[at - 1];
            assert_relative_eq!(rise / width, slope, max_relative = 1e-3);
        }
    }

    #[test]
    fn stretches_meet_at_the_border_and_end_at_the_edge() {
        for stick_ratio in [1e-4, 0.3, 0.99] {
            let stretches = Stretches::new(60, stick_ratio).unwrap();
            let places = &stretches.places;
            assert_eq!((places.len(), places[0], places[60]), (61, 0.0, 1.0));
            assert_eq!(places[stretches.border], stick_ratio);
            assert!(places.windows(2).all(|ends| ends[0] < ends[1]));
        }
        assert!(Stretches::new(60, 0.0).is_none() && Stretches::new(60, 1.0).is_none());
    }
}
