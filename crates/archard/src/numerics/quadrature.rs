//! Gauss-Legendre quadrature.

use std::f64::consts::PI;

/// Nodes in (-1, 1) and weights of the rule of that many points, exact for polynomials of degree
/// 2 n - 1: roots of the Legendre polynomial by Newton's method (M. Abramowitz and I. A. Stegun,
/// *Handbook of Mathematical Functions*, 25.4.29).
pub fn gauss_legendre(points: usize) -> Vec<(f64, f64)> {
    let n = points as f64;
    (0..points)
        .map(|index| {
            let mut x = -((index as f64 + 0.75) / (n + 0.5) * PI).cos();
            for _ in 0..100 {
                let (value, slope) = legendre(points, x);
                let step = value / slope;
                x -= step;
                if step.abs() < 1e-15 {
                    break;
                }
            }
            let (_, slope) = legendre(points, x);
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

/// The Legendre polynomials of the first degrees.
pub fn legendre_polynomials(count: usize, x: f64) -> Vec<f64> {
    let mut values = vec![1.0, x];
    for k in 1..count {
        let n = k as f64;
        values.push(((2.0 * n + 1.0) * x * values[k] - n * values[k - 1]) / (n + 1.0));
    }
    values.truncate(count);
    values
}

/// The Legendre polynomial of that degree and its derivative, away from the ends.
fn legendre(degree: usize, x: f64) -> (f64, f64) {
    let (mut last, mut value) = (0.0, 1.0);
    for k in 0..degree {
        let k = k as f64;
        (last, value) = (value, ((2.0 * k + 1.0) * x * value - k * last) / (k + 1.0));
    }
    (value, degree as f64 * (last - x * value) / (1.0 - x * x))
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::gauss_legendre;

    #[test]
    fn polynomials_are_integrated_exactly() {
        for points in 1..=20usize {
            for degree in 0..2 * points {
                let sum: f64 = gauss_legendre(points)
                    .iter()
                    .map(|(x, weight)| weight * x.powi(degree as i32))
                    .sum();
                let exact = if degree % 2 == 0 { 2.0 / (degree as f64 + 1.0) } else { 0.0 };
                assert_relative_eq!(sum, exact, epsilon = 1e-14);
            }
        }
    }
}
