//! A flat round punch that slides and wears under a constant load: how its pressure evens out.
//!
//! L. A. Galin, *J. Appl. Math. Mech.* 40 (1976) 981; I. G. Goryacheva, *Contact Mechanics in
//! Tribology* (1998). A rigid punch of radius a on a half-space of modulus E*, worn at the
//! rate k p V, starts with the pressure p_m / (2 sqrt(1 - (r/a)^2)), p_m = F/(pi a^2), and ends with
//! p_m everywhere. With the time T = k V E* t / a,
//!
//! ```text
//! p(r, T) = p_m [1 + sum c_n f_n(r/a) exp(-m_n T)],
//! u[f_n] = constant + (a/E*) f_n / m_n,  mean of f_n = 0,
//! ```
//!
//! u being the displacement of the half-space. Zernike's polynomials Z_m(x) = sqrt(2m+1) P_m(2 x^2 - 1)
//! are orthonormal over the disc. The transform of each is a Bessel function, of J_(2m+1)(k)/k, and that
//! of the half-space 2/k, so that by the integral of Weber and Schafheitlin the half-space between
//! two of them is
//!
//! ```text
//! U_mn = (16/pi) sqrt((2m+1)(2n+1)) / [(1 - 4 (m-n)^2) (2m+2n+1) (2m+2n+3)].
//! ```
//!
//! Without its first row and column, which belong to the mean, its eigenvalues are 1/m_n.

use faer::{Mat, Side};

/// The modes in which the pressure of the punch decays.
#[derive(Debug, Clone, PartialEq)]
pub struct Modes {
    /// Decay rates m_n over the time k V E* t / a, slowest first.
    decay_rates: Vec<f64>,
    /// The modes by their polynomials, from the second one on.
    shapes: Vec<Vec<f64>>,
}

/// The first decay rates, slowest first: 2.0606, 3.6710, 5.2585 and on in steps close to pi/2.
///
/// `None` if the eigenvalues cannot be found, which no number of them is known to cause.
pub fn decay_rates(count: usize) -> Option<Vec<f64>> {
    Modes::new(count).map(|modes| modes.decay_rates)
}

impl Modes {
    /// That many modes, slowest first, their rates good for eight digits.
    ///
    /// `None` if the eigenvalues cannot be found, which no number of them is known to cause.
    pub fn new(count: usize) -> Option<Self> {
        Self::of_polynomials(count, 3 * count + 20)
    }

    /// That many modes out of so many polynomials.
    fn of_polynomials(count: usize, size: usize) -> Option<Self> {
        let half_space = Mat::from_fn(size, size, |row, column| element(row + 1, column + 1));
        let eigen = half_space.self_adjoint_eigen(Side::Lower).ok()?;
        let (values, vectors) = (eigen.S().column_vector(), eigen.U());
        // The slowest mode has the largest eigenvalue, which comes last.
        let mut modes = Self { decay_rates: Vec::new(), shapes: Vec::new() };
        for column in (0..size).rev().take(count) {
            let coefficients: Vec<f64> = (0..size).map(|row| vectors[(row, column)]).collect();
            let sign =
                polynomials(0.0).zip(&coefficients).map(|(z, c)| z * c).sum::<f64>().signum();
            modes.decay_rates.push(1.0 / values[column]);
            modes.shapes.push(coefficients.iter().map(|c| sign * c).collect());
        }
        Some(modes)
    }

    /// Decay rates over the time k V E* t / a, slowest first.
    pub fn decay_rates(&self) -> &[f64] {
        &self.decay_rates
    }

    /// A mode, the slowest being number 0, at a distance over the radius of the punch.
    ///
    /// Positive in the centre, with a mean of 0 and a mean square of 1 over the punch; `None` beyond
    /// the last mode or the edge.
    pub fn shape(&self, mode: usize, place: f64) -> Option<f64> {
        let coefficients = self.shapes.get(mode)?;
        (0.0..=1.0).contains(&place).then(|| sum(coefficients, place))
    }

    /// Pressure over its mean F/(pi a^2) at a distance over the radius, at a time k V E* t / a.
    ///
    /// The modes left out have decayed once the time is several times the inverse of the last rate.
    /// 0 outside the punch.
    pub fn relative_pressure(&self, place: f64, time: f64) -> f64 {
        self.superposed(place, 1.0, |rate| (-rate * time).exp())
    }

    /// Wear depth over p_m a / E* at a distance over the radius, at a time k V E* t / a: the integral
    /// of the relative pressure over that time.
    ///
    /// 0 outside the punch.
    pub fn relative_depth(&self, place: f64, time: f64) -> f64 {
        self.superposed(place, time, |rate| -(-rate * time).exp_m1() / rate)
    }

    /// An even part and the modes with their shares of the first pressure, each with a factor by its
    /// rate.
    fn superposed(&self, place: f64, even: f64, factor: impl Fn(f64) -> f64) -> f64 {
        if !(0.0..=1.0).contains(&place) {
            return 0.0;
        }
        let modes = self.shapes.iter().zip(&self.decay_rates);
        modes.fold(even, |total, (coefficients, &rate)| {
            total + share_at_start(coefficients) * factor(rate) * sum(coefficients, place)
        })
    }
}

/// U_mn.
fn element(m: usize, n: usize) -> f64 {
    let [m, n] = [m as f64, n as f64];
    let sum = 2.0 * (m + n);
    let distance = 2.0 * (m - n);
    16.0 / std::f64::consts::PI * ((2.0 * m + 1.0) * (2.0 * n + 1.0)).sqrt()
        / ((1.0 - distance * distance) * (sum + 1.0) * (sum + 3.0))
}

/// The part a mode has in 1/(2 sqrt(1 - x^2)): that of Z_m is 1/sqrt(2m+1).
fn share_at_start(coefficients: &[f64]) -> f64 {
    let parts = coefficients.iter().enumerate();
    parts.map(|(at, coefficient)| coefficient / ((2 * at + 3) as f64).sqrt()).sum()
}

/// A sum of polynomials from the second one on.
fn sum(coefficients: &[f64], place: f64) -> f64 {
    polynomials(place)
        .zip(coefficients)
        .map(|(polynomial, coefficient)| polynomial * coefficient)
        .sum()
}

/// Z_1, Z_2, ... at a place.
fn polynomials(place: f64) -> impl Iterator<Item = f64> {
    let x = 2.0 * place * place - 1.0;
    let mut degree = 1.0;
    let mut pair = [1.0, x];
    std::iter::from_fn(move || {
        let [before, legendre] = pair;
        let norm = (2.0 * degree + 1.0_f64).sqrt();
        let next = ((2.0 * degree + 1.0) * x * legendre - degree * before) / (degree + 1.0);
        pair = [legendre, next];
        degree += 1.0;
        Some(norm * legendre)
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use approx::assert_relative_eq;

    use super::{Modes, decay_rates};

    /// Reference values.
    #[test]
    fn the_three_slowest_modes() {
        let rates = decay_rates(3).unwrap();
        for (found, given) in rates.into_iter().zip([2.0606, 3.6710, 5.2585]) {
            assert_relative_eq!(found, given, epsilon = 5.1e-5);
        }
    }

    /// As those of any part of a complete set of functions do.
    #[test]
    fn rates_converge_from_above() {
        for count in [1, 3, 10, 30] {
            let rates = Modes::new(count).unwrap().decay_rates;
            let finer = Modes::of_polynomials(count, 3 * (3 * count + 20)).unwrap().decay_rates;
            assert_eq!(rates.len(), count);
            for (rate, finer) in rates.iter().zip(&finer) {
                let excess = rate / finer - 1.0;
                assert!((-1e-12..2e-9).contains(&excess), "{rate} for {finer}");
            }
        }
    }

    /// The displacement under a mode by its definition, u = (1/pi) times the integral of the pressure
    /// over the directions from the place and the distances along them.
    fn displacement(modes: &Modes, mode: usize, place: f64) -> f64 {
        let (directions, steps) = (400, 400);
        let mut sum = 0.0;
        for i in 0..directions {
            let (sine, cosine) = (PI * (f64::from(i) + 0.5) / f64::from(directions)).sin_cos();
            let length = (1.0 - (place * sine).powi(2)).sqrt() - place * cosine;
            for j in 0..steps {
                let along = length * (f64::from(j) + 0.5) / f64::from(steps);
                let distance = (place + along * cosine).hypot(along * sine).min(1.0);
                sum += length * modes.shape(mode, distance).unwrap();
            }
        }
        2.0 * sum / f64::from(directions * steps)
    }

    #[test]
    fn displacements_of_a_mode_are_even_but_for_the_mode() {
        let modes = Modes::new(4).unwrap();
        for (mode, rate) in modes.decay_rates().iter().enumerate() {
            let rest = |place: f64| {
                displacement(&modes, mode, place) - modes.shape(mode, place).unwrap() / rate
            };
            let middle = rest(0.0);
            for place in [0.2, 0.5, 0.8, 0.95] {
                assert_relative_eq!(rest(place), middle, epsilon = 2e-4);
            }
        }
    }

    /// Mean over the disc, with r = sin t.
    fn mean(function: impl Fn(f64) -> f64) -> f64 {
        let count = 20_000;
        let step = FRAC_PI_2 / f64::from(count);
        let parts = (0..count).map(|i| {
            let (sine, cosine) = ((f64::from(i) + 0.5) * step).sin_cos();
            2.0 * step * sine * cosine * function(sine)
        });
        parts.sum()
    }

    #[test]
    fn shapes_have_no_mean_and_a_unit_square() {
        let modes = Modes::new(5).unwrap();
        for mode in 0..5 {
            let shape = |place: f64| modes.shape(mode, place).unwrap();
            assert!(shape(0.0) > 0.0);
            assert!(mean(shape).abs() < 1e-6);
            assert_relative_eq!(mean(|place| shape(place).powi(2)), 1.0, max_relative = 1e-5);
        }
        assert_eq!(modes.shape(5, 0.5), None);
        assert_eq!(modes.shape(0, 1.01), None);
    }

    /// The pressure 1/(2 sqrt(1 - x^2)) makes the displacement even; its mean with 1 - x^2 is 1/3, to
    /// which n modes come with an error that falls as 1/n. The share of a mode is its mean with that
    /// pressure.
    #[test]
    fn pressures_start_as_those_of_a_new_punch() {
        for count in [10, 40] {
            let modes = Modes::new(count).unwrap();
            let found = mean(|x| (1.0 - x * x) * modes.relative_pressure(x, 0.0));
            assert_relative_eq!(found, 1.0 / 3.0, max_relative = 0.4 / count as f64);
        }

        let modes = Modes::new(5).unwrap();
        let share = mean(|x| modes.shape(0, x).unwrap() / (2.0 * (1.0 - x * x).sqrt()));
        let (time, rate) = (6.0, modes.decay_rates()[0]);
        let left = share * (-rate * time).exp();
        for place in [0.0, 0.4, 0.9] {
            let expected = left * modes.shape(0, place).unwrap();
            let found = modes.relative_pressure(place, time) - 1.0;
            assert_relative_eq!(found, expected, max_relative = 2e-4);
        }
    }

    /// In the end the depth grows as the time; at any time it grows as the pressure, and on average as
    /// the load.
    #[test]
    fn wear_follows_the_pressure() {
        let modes = Modes::new(10).unwrap();
        assert_relative_eq!(modes.relative_pressure(0.9, 20.0), 1.0, max_relative = 1e-12);
        let worn = modes.relative_depth(0.4, 21.0) - modes.relative_depth(0.4, 20.0);
        assert_relative_eq!(worn, 1.0, max_relative = 1e-12);
        assert_relative_eq!(mean(|x| modes.relative_depth(x, 0.7)), 0.7, max_relative = 1e-6);
        let (early, late) = (modes.relative_depth(0.4, 0.9), modes.relative_depth(0.4, 0.9002));
        let rate = (late - early) / 2e-4;
        assert_relative_eq!(rate, modes.relative_pressure(0.4, 0.9001), max_relative = 1e-7);
        let outside = (modes.relative_pressure(1.2, 0.5), modes.relative_depth(1.2, 0.5));
        assert_eq!(outside, (0.0, 0.0));
    }
}
