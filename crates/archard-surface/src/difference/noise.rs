//! How what did not wear differs between the scans: its covariance, and the variance of sums over it.
//!
//! Differences next to each other are correlated, and a sum over them is more uncertain than that of as many independent ones. The
//! covariance at each lag is the mean product of pairs that lie so far apart. Beyond some radius it is nothing but chance, and
//! left out: the least radius that is [`RADII`] times that of the disc over which a perfect correlation would have the same integral
//! (A. D. Sokal's window, in *Functional Integration*, Plenum 1997, 131, in two dimensions).

use std::f64::consts::PI;

use statrs::distribution::{ContinuousCDF, Normal};

use super::fourier::Fourier;

/// An exponential correlation keeps 1 - (1 + q) exp(-q) = 92 % of its integral within q = 3 sqrt 2 of its lengths.
const RADII: f64 = 3.0;
/// The noise of a map of differences.
pub(super) struct Noise {
    fourier: Fourier,
    elements: [usize; 2],
    /// Power at each wave (m^2), positive.
    spectrum: Vec<f64>,
    /// Variance of a point (m^2).
    pub(super) variance: f64,
    /// How many points count as one in a mean over many.
    pub(super) alike: f64,
    /// Degrees of freedom of the variance of sums.
    pub(super) freedom: f64,
    /// Whether it is correlated so far that nothing on the map says how far.
    pub(super) endless: bool,
}

impl Noise {
    /// The noise in residuals (m) that lost so many numbers to a fit, not a number where there are none; points are not known better than `floor`
    /// (m), each by itself.
    pub(super) fn of(elements: [usize; 2], residuals: &[f64], (lost, floor): (f64, f64)) -> Self {
        let fourier = Fourier::at_least(elements.map(|count| 2 * count));
        let own = |value: &f64| if value.is_nan() { 0.0 } else { *value };
        let values: Vec<f64> = residuals.iter().map(own).collect();
        let known: Vec<f64> = residuals.iter().map(|value| f64::from(!value.is_nan())).collect();
        let count: f64 = known.iter().sum();
        let with_itself = |values: &[f64]| {
            let power =
                fourier.of(elements, values).iter().map(|one| one.norm_sqr().into()).collect();
            fourier.back(power)
        };
        let (products, pairs) = (with_itself(&values), with_itself(&known));
        let covariance = |at: usize| {
            if pairs[at].re > 0.5 { products[at].re / pairs[at].re.round() } else { 0.0 }
        };
        let least = floor * floor;
        let variance = covariance(0).max(least).max(f64::MIN_POSITIVE);
        // Rings of lags, a point wide; so few that half of the noise is left at least.
        let most = (count / (2.0 * lost.max(1.0) * PI))
            .sqrt()
            .min(0.5 * elements[0].min(elements[1]) as f64);
        let mut rings = vec![(0.0, 0.0); most as usize + 1];
        let radius = |at: usize| {
            let [x, y] = fourier.lag(at);
            (x as f64).hypot(y as f64).round() as usize
        };
        for at in 0..products.len() {
            if let Some(ring) = rings.get_mut(radius(at)) {
                ring.0 += covariance(at);
                ring.1 += 1.0;
            }
        }
        let (mut alike, mut lags, mut last, mut endless) = (0.0, 0.0, 0, true);
        for (far, ring) in rings.iter().enumerate() {
            alike += ring.0;
            lags += ring.1;
            last = far;
            if far > 0 && far as f64 >= RADII * (alike / variance / PI).max(0.0).sqrt() {
                endless = false;
                break;
            }
        }
        // Each pair lost what the placement took away, as much at all lags.
        let kept = 1.0 / (1.0 - (lost * lags / count.max(1.0)).min(0.5));
        let mut window: Vec<f64> = (0..products.len())
            .map(|at| if radius(at) <= last { kept * covariance(at) } else { 0.0 })
            .collect();
        window[0] = window[0].max(least);
        let spectrum =
            fourier.of(fourier.size(), &window).iter().map(|one| one.re.max(0.0)).collect();
        let alike = (kept * alike / variance).max(1.0);
        let freedom = (count / lags - lost).max(1.0);
        Self { fourier, elements, spectrum, variance, alike, freedom, endless }
    }

    /// The variance of a sum over all points, each with its weight.
    pub(super) fn variance_of(&self, weights: &[f64]) -> f64 {
        let waves = self.fourier.of(self.elements, weights);
        let sum: f64 =
            waves.iter().zip(&self.spectrum).map(|(wave, power)| wave.norm_sqr() * power).sum();
        sum / waves.len() as f64
    }

    /// What is smoothed by a Gaussian of that deviation (points along x and y).
    pub(super) fn smoothed(&self, deviation: [f64; 2]) -> Smooth {
        let size = self.fourier.size();
        let wave = |axis: usize, index: usize| {
            2.0 * PI * index.min(size[axis] - index) as f64 / size[axis] as f64
        };
        let (mut sum, mut squares) = (0.0, [0.0; 2]);
        for (at, power) in self.spectrum.iter().enumerate() {
            let waves = [wave(0, at % size[0]), wave(1, at / size[0])];
            let far = (waves[0] * deviation[0]).powi(2) + (waves[1] * deviation[1]).powi(2);
            let power = power * (-far).exp();
            sum += power;
            (0..2).for_each(|axis| squares[axis] += power * waves[axis].powi(2));
        }
        let deviation = (sum / self.spectrum.len() as f64).sqrt();
        Smooth {
            deviation,
            slopes: squares.map(|square| (square / sum.max(f64::MIN_POSITIVE)).sqrt()),
        }
    }
}

/// Smoothed noise.
#[derive(Debug, Clone, Copy)]
pub(super) struct Smooth {
    /// Its standard deviation (m).
    pub(super) deviation: f64,
    /// Standard deviation of its slopes along x and y, over its own (1/point).
    slopes: [f64; 2],
}

impl Smooth {
    /// How many of its hills rise above so many standard deviations, in the mean, on a rectangle of so many points: the expected Euler characteristic
    /// (R. J. Adler, *The Geometry of Random Fields*, Wiley 1981; K. J. Worsley and others, *J. Cerebral Blood Flow
    /// and Metabolism* 12 (1992) 900).
    pub(super) fn hills(&self, height: f64, points: [usize; 2]) -> f64 {
        let sides = [0, 1].map(|axis| self.slopes[axis] * points[axis] as f64);
        let over = (-0.5 * height * height).exp();
        let area = sides[0] * sides[1] * height * over / (2.0 * PI).powf(1.5);
        area + (sides[0] + sides[1]) * over / (2.0 * PI) + 1.0 - Normal::standard().cdf(height)
    }

    /// The height, in standard deviations, that so many hills rise above in the mean; fewer than one.
    pub(super) fn height_of(&self, hills: f64, points: [usize; 2]) -> f64 {
        // From one standard deviation on hills become fewer; no double precision knows more than 38.
        let (mut low, mut high) = (1.0, 38.0);
        while high - low > 1e-6 {
            let middle = 0.5 * (low + high);
            if self.hills(middle, points) > hills { low = middle } else { high = middle }
        }
        high
    }
}

#[cfg(test)]
mod tests {
    use super::super::blocks::smoothed;
    use super::Noise;

    fn normal(random: &mut fastrand::Rng) -> f64 {
        (0..12).map(|_| random.f64()).sum::<f64>() - 6.0
    }

    /// White noise: a sum over n points has n times the variance. Smoothed by a Gaussian of deviation d its own is 1/(4 pi d^2) of it, and of
    /// means over many points 4 pi d^2 count as one.
    #[test]
    fn sums_have_the_variance_of_their_noise() {
        let mut random = fastrand::Rng::with_seed(1);
        let white: Vec<f64> = (0..120 * 120).map(|_| normal(&mut random)).collect();
        let noise = Noise::of([120; 2], &white, (6.0, 0.0));
        let square = |at: usize| f64::from(at % 120 < 40 && at / 120 < 40);
        let weights: Vec<f64> = (0..120 * 120).map(square).collect();
        let ratio = noise.variance_of(&weights) / 1600.0;
        assert!((ratio - 1.0).abs() < 0.25 && noise.alike < 1.25, "{ratio} {}", noise.alike);
        let expected = 1.0 / (4.0 * std::f64::consts::PI * 4.0f64).sqrt();
        assert!((noise.smoothed([2.0; 2]).deviation / expected - 1.0).abs() < 0.2);
        let smooth = smoothed([120; 2], &white, [2.0; 2]);
        let noise = Noise::of([120; 2], &smooth, (6.0, 0.0));
        assert!((noise.alike / 50.3 - 1.0).abs() < 0.3, "{}", noise.alike);
        let ratio = noise.variance_of(&weights) / 1600.0;
        assert!((ratio - 1.0).abs() < 0.4, "{ratio}");
    }

    /// Of 200 maps of smoothed white noise as many have a summit above the height as hills are expected there.
    #[test]
    fn summits_are_as_many_as_expected() {
        let (n, deviation) = (48, [1.5; 2]);
        let mut random = fastrand::Rng::with_seed(3);
        let (mut above, mut expected) = (0.0, 0.0);
        for _ in 0..200 {
            let white: Vec<f64> = (0..n * n).map(|_| normal(&mut random)).collect();
            let smooth = Noise::of([n; 2], &white, (6.0, 0.0)).smoothed(deviation);
            let inner = smoothed([n; 2], &white, deviation);
            let far = |at: usize| (6..n - 6).contains(&(at % n)) && (6..n - 6).contains(&(at / n));
            let height = smooth.height_of(0.1, [n - 12; 2]);
            let one = 1.0 / (4.0 * std::f64::consts::PI).sqrt() / 1.5;
            above += f64::from((0..n * n).filter(|&at| far(at)).any(|at| inner[at] > height * one));
            expected += 0.1;
        }
        // Of a Poisson distribution: 20 and 3 standard deviations of 4.5.
        assert!((above - expected).abs() < 13.5_f64, "{above} {expected}");
    }
}
