//! Flash temperatures of bands of heat that move fast over a half-space.
//!
//! Where a surface passes through the contact faster than heat spreads ahead of it, heat flows into depth alone, and
//! at a distance x behind the leading edge the surface is warmer than the body by
//!
//! dT(x) = 1 / (e sqrt(pi V)) times the integral of q(x') / sqrt(x - x') over x' from 0 to x,
//!
//! with V the speed of passage, q the heat that flows into the surface and e = k / sqrt(chi) its effusivity. J. C. Jaeger,
//! *J. Proc. R. Soc. N. S. W.* 76 (1942) 203; H. Blok, *Proc. Inst. Mech. Eng. Gen. Disc. Lubr.* 2 (1937) 222.
//!
//! Limits: Peclet numbers above [`FAST`].

use std::f64::consts::{FRAC_2_PI, PI};

use crate::numerics::quadrature::gauss_legendre;

/// Peclet number from which heat is taken to flow into depth alone. Below a uniform band the largest rise is 4 % too high
/// there and the mean 3 % too low; 8 and 5 % at a Peclet number of 2, 14 and 6 % at 1, 41 % at 0.2 (Jaeger's integral by
/// quadrature).
pub const FAST: f64 = 5.0;

/// Peclet number V a / (2 chi) of a contact with half length a (m), passed at a speed V (m/s) by a body of diffusivity chi
/// (m^2/s).
pub fn peclet(speed: f64, half_length: f64, diffusivity: f64) -> f64 {
    0.5 * speed * half_length / diffusivity
}

/// Largest and mean rise (K) below a uniform band of heat (W/m^2) with half length a (m), for a body of effusivity e
/// (J/(m^2 K s^(1/2))) at a speed V (m/s): 1.596 and 1.064 times q sqrt(a) / (e sqrt(V)).
pub fn uniform_band(heat: f64, half_length: f64, effusivity: f64, speed: f64) -> [f64; 2] {
    let largest = 2.0 * FRAC_2_PI.sqrt() * heat * (half_length / speed).sqrt() / effusivity;
    [largest, 2.0 / 3.0 * largest]
}

/// Largest and mean rise below heat q0 sqrt(1 - s^2) (1 + c s), s from -1 at the leading edge to 1, relative to
/// q0 sqrt(a) / (e sqrt(V)).
///
/// With c = 0 these are Hertz's pressures at one speed of slip, and the largest is Blok's 1.11, relative to the mean heat
/// and the whole length. With c up to one it is a line of contact that rolls and slips all over, c the creepage at which it
/// begins to over the one it has: the surfaces are strained by their own tractions.
pub fn semi_ellipse(c: f64) -> [f64; 2] {
    let below = |x: f64| below_a_semi_ellipse(c, x);
    // By golden section: the rise has one maximum.
    let (mut low, mut high) = (-1.0, 1.0);
    for _ in 0..40 {
        let [one, two] = [0.382, 0.618].map(|share| low + share * (high - low));
        if below(one) < below(two) { low = one } else { high = two }
    }
    let mean = 32f64.sqrt() / PI.sqrt() * (4.0 / 15.0 - 4.0 / 105.0 * c);
    [below(0.5 * (low + high)), mean]
}

/// The same of an ellipse of contact, whose rows are such lines with a and c in proportion to their lengths: mean over all of
/// them, each by its length.
pub fn semi_ellipsoid(c: f64) -> [f64; 2] {
    // 2 Gamma(9/4) / (sqrt(pi) Gamma(11/4)), and one half more in each argument.
    const MEANS: [f64; 2] = [0.794_882_706_356, 0.711_909_112_602];
    let [largest, _] = semi_ellipse(c);
    let mean = 32f64.sqrt() / PI.sqrt() * (4.0 / 15.0 * MEANS[0] - 4.0 / 105.0 * MEANS[1] * c);
    [largest, mean]
}

/// Rise at x below that heat, after s = x - (1 + x) sin^2 t, which leaves no root of the distance.
fn below_a_semi_ellipse(c: f64, x: f64) -> f64 {
    let whole = (x + 1.0).sqrt();
    let part = |(node, weight): (f64, f64)| {
        let t = 0.25 * PI * (1.0 + node);
        let s = x - (whole * t.sin()).powi(2);
        weight * (1.0 - s * s).max(0.0).sqrt() * (1.0 + c * s) * whole * t.cos()
    };
    0.5 * PI.sqrt() * gauss_legendre(60).into_iter().map(part).sum::<f64>()
}

/// The integral of (x - x')^(-1/2) over x' from the first to the last place (m) of a stretch, as far as they lie before x
/// (m), over sqrt(pi) (m^(1/2)): the rise behind a stretch of uniform heat relative to q / (e sqrt(V)).
pub fn behind([first, last]: [f64; 2], x: f64) -> f64 {
    let root = |place: f64| (x - place).max(0.0).sqrt();
    2.0 / PI.sqrt() * (root(first) - root(last))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use super::{behind, semi_ellipse, semi_ellipsoid, uniform_band};

    /// 1.596 and 1.064 q sqrt(a chi / V) / k, as published.
    #[test]
    fn a_uniform_band_is_as_published() {
        let [largest, mean] = uniform_band(1.0, 1.0, 1.0, 1.0);
        assert_relative_eq!(largest, 1.596, epsilon = 5e-4);
        assert_relative_eq!(mean, 1.064, epsilon = 5e-4);
        assert_relative_eq!(behind([-1.0, 1.0], 1.0), largest, max_relative = 1e-15);
        let mean: f64 =
            (0..100_000).map(|i| behind([-1.0, 1.0], -1.0 + 2e-5 * (f64::from(i) + 0.5))).sum();
        assert_relative_eq!(1e-5 * mean, 1.064, epsilon = 5e-4);
    }

    /// Rise below sqrt(1 - s^2) (1 + c s) as a sum of thin bands, which the formulas do not use.
    fn by_bands(c: f64, x: f64) -> f64 {
        let bands = 20_000;
        let edge = |i: i32| -1.0 + 2.0 * f64::from(i) / f64::from(bands);
        let band = |i: i32| {
            let (first, last) = (edge(i), edge(i + 1));
            let s = 0.5 * (first + last);
            (1.0 - s * s).sqrt() * (1.0 + c * s) * behind([first, last], x)
        };
        (0..bands).map(band).sum()
    }

    #[test]
    #[ignore = "long: in .ci/long"]
    fn semi_ellipses_are_sums_of_bands() {
        for c in [0.0, 0.4, 1.0] {
            let rises: Vec<f64> =
                (0..200).map(|i| by_bands(c, -1.0 + (f64::from(i) + 0.5) / 100.0)).collect();
            let [largest, mean] = semi_ellipse(c);
            assert_relative_eq!(rises.iter().sum::<f64>() / 200.0, mean, max_relative = 1e-4);
            let highest = rises.iter().copied().fold(0.0, f64::max);
            assert_relative_eq!(highest, largest, max_relative = 1e-4);
            // Rows of an ellipse: the rise goes with p0 sqrt(a), they count by their length.
            let rows = || (0..400).map(|i| (1.0 - ((f64::from(i) + 0.5) / 400.0).powi(2)).sqrt());
            let row = |half: f64| half.powf(1.5) * semi_ellipse(c * half)[1];
            let sum: f64 = rows().map(|half| half * row(half)).sum();
            let [_, mean] = semi_ellipsoid(c);
            assert_relative_eq!(sum / rows().sum::<f64>(), mean, max_relative = 1e-4);
        }
    }

    /// Blok's 1.11: 1.2346 relative to the heat in the middle and the half length.
    #[test]
    fn the_largest_below_hertz_pressures_is_bloks() {
        let relative_to_mean = semi_ellipse(0.0)[0] * 8f64.sqrt() / PI;
        assert_relative_eq!(relative_to_mean, 1.11, epsilon = 5e-3);
    }
}
