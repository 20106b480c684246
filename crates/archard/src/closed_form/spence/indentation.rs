//! The exact answer, in which tractions change the pressures.
//!
//! Pressure p and outward traction q on a disc of radius 1 are written by two functions of t,
//!
//! ```text
//! p(r) = -int_r^1 P'(t) dt / sqrt(t^2 - r^2),  q(r) = -int_r^1 Q'(t) t dt / (r sqrt(t^2 - r^2)),
//! ```
//!
//! P even and Q odd, both 0 at 1. The displacements D - r^n into the bodies and, in the stick zone,
//! inwards by some multiple of r^n (a particle once stuck stays where it is while the contact grows)
//! turn by Abel's integrals into
//!
//! ```text
//! P + beta H[Q] = D - t^n,  0 < t < 1,  H[f](t) = (1/pi) int_-1^1 f(s) ds / (t - s),
//! Q - beta H[P] = -B t^n,   0 < t < c,
//! Q = mu R[P],  c < t < 1,  R[P](t) = -(2/pi) int_t^1 (t/s) K(sqrt(1 - (t/s)^2)) P'(s) ds,
//! ```
//!
//! and from c on q = mu p. Q and Q' are continuous at c: a bend, which a stick zone that shrinks
//! has there, would take slip back in one that grows. That gives mu and B for a given c. Pressures and tractions are found in
//! turn, P and Q linear between places that are dense at c and at the edge, the finite Hilbert
//! transforms H exact for that.

#[cfg(test)]
mod tests;

use super::stretches::{STICK_RATIOS, Stretches, slopes};
use super::{uncoupled_friction, uncoupled_stick_ratio};

/// Stretches between places, half of them in the stick zone.
const STRETCHES: usize = 240;

/// A punch of a profile r^n pressed on a body without being turned back.
///
/// Friction is good for 2e-4 at stick ratios from 0.05 to 0.95, the load for 5e-5.
#[derive(Debug, Clone, PartialEq)]
pub struct Indentation {
    /// Radius of the stick zone over that of the contact.
    pub stick_ratio: f64,
    /// Friction coefficient.
    pub friction: f64,
    /// Load over that without friction at the same contact radius.
    pub relative_load: f64,
    /// Approach of the bodies over that without friction at the same contact radius.
    pub relative_approach: f64,
    places: Vec<f64>,
    normal: Vec<f64>,
    tangential: Vec<f64>,
    /// Mean of the pressure without friction, in the units of `normal`.
    mean: f64,
}

impl Indentation {
    /// The state with a stick zone of that share of the contact radius, and the friction coefficient
    /// that makes it, under a profile r^n (n = 2 is a sphere, 1 a cone) between bodies of that
    /// coupling ([`super::coupling`]), whose sign does not matter.
    ///
    /// `None` unless the exponent is positive and finite, the coupling between 0 and 1 and the ratio
    /// between 1e-4 and 0.99, and where pressures and tractions do not come to agree: near all stick
    /// with couplings beyond 1/2, those of negative Poisson ratios.
    pub fn at_stick_ratio(exponent: f64, coupling: f64, stick_ratio: f64) -> Option<Self> {
        let coupling = coupling.abs();
        if !(exponent > 0.0 && exponent.is_finite() && coupling > 0.0 && coupling < 1.0) {
            return None;
        }
        Self::on(&Stretches::new(STRETCHES, stick_ratio)?, exponent, coupling)
    }

    /// The state at a friction coefficient.
    ///
    /// `None` where [`Self::at_stick_ratio`] is, the ratio being the one that belongs to the friction.
    pub fn at_friction(exponent: f64, coupling: f64, friction: f64) -> Option<Self> {
        if !(friction > 0.0 && friction.is_finite()) {
            return None;
        }
        // The friction that makes the same stick zone without coupling is nearly a fixed share of it:
        // a secant search from there and from none.
        let state = |uncoupled: f64| {
            let ratio = uncoupled_stick_ratio(uncoupled, coupling);
            Self::at_stick_ratio(exponent, coupling, ratio)
        };
        let most = uncoupled_friction(*STICK_RATIOS.end(), coupling);
        let (mut before, mut guess) = ((0.0, 0.0), friction.min(most));
        for _ in 0..30 {
            let found = state(guess)?;
            let error = found.friction - friction;
            if error.abs() <= 1e-9 * friction {
                return Some(found);
            }
            let slope = (found.friction - before.1) / (guess - before.0);
            before = (guess, found.friction);
            guess -= error / slope;
        }
        None
    }

    /// Pressure over the mean one without friction at the same contact radius, at a distance over the
    /// contact radius.
    pub fn relative_pressure(&self, place: f64) -> f64 {
        // P linear in t^2 rather than t: so it is without friction under a sphere, and it spares the
        // centre a logarithm.
        let parts = self.roots(place).zip(self.places.windows(2)).zip(self.normal.windows(2));
        let sum: f64 = parts
            .map(|((roots, t), value)| {
                (value[0] - value[1]) / (t[1] * t[1] - t[0] * t[0]) * (roots[1] - roots[0])
            })
            .sum();
        2.0 * sum / self.mean
    }

    /// Traction that draws the more compliant surface outwards, over the mean pressure without
    /// friction at the same contact radius, at a distance over the contact radius.
    pub fn relative_traction(&self, place: f64) -> f64 {
        if place == 0.0 {
            return 0.0;
        }
        let parts = self.roots(place).zip(slopes(&self.places, &self.tangential));
        let sum: f64 = parts.map(|(roots, slope)| -slope * (roots[1] - roots[0])).sum();
        sum / (place * self.mean)
    }

    /// sqrt(t^2 - r^2) at both ends of every stretch, 0 inside a distance.
    fn roots(&self, place: f64) -> impl Iterator<Item = [f64; 2]> {
        let root = move |t: f64| ((t - place) * (t + place)).max(0.0).sqrt();
        self.places.windows(2).map(move |ends| [root(ends[0]), root(ends[1])])
    }

    /// The state on some stretches, by pressures and tractions in turn.
    fn on(stretches: &Stretches, exponent: f64, coupling: f64) -> Option<Self> {
        let places = &stretches.places;
        let powers: Vec<f64> = places.iter().map(|t| t.powf(exponent)).collect();
        let mut state = Self {
            stick_ratio: places[stretches.border],
            friction: 0.0,
            relative_load: 1.0,
            relative_approach: 1.0,
            places: places.clone(),
            normal: powers.iter().map(|power| 1.0 - power).collect(),
            tangential: vec![0.0; places.len()],
            mean: 2.0 * exponent / (exponent + 1.0),
        };
        for _ in 0..200 {
            let before = state.friction;
            state.find_tractions(stretches, &powers, coupling);
            state.find_pressures(stretches, &powers, coupling);
            if (state.friction - before).abs() <= 1e-10 * state.friction {
                state.relative_load = state.load() / (0.5 * state.mean);
                return Some(state);
            }
        }
        None
    }

    /// Q and mu that belong to P.
    fn find_tractions(&mut self, stretches: &Stretches, powers: &[f64], coupling: f64) {
        let mut stuck = stretches.image(&stretches.of_even, &self.normal);
        stuck.iter_mut().for_each(|value| *value *= coupling);
        let slipping = stretches.image(&stretches.of_slip, &self.normal);
        // Over t^n, the unknown multiple of t^n does not show in the slopes.
        let border = stretches.border;
        let slope = |values: &[f64], ends: [usize; 3]| {
            slope_at_first(ends.map(|at| (self.places[at], values[at] / powers[at])))
        };
        let drawn = slope(&stuck, [border, border - 1, border - 2]);
        self.friction = drawn / slope(&slipping, [border, border + 1, border + 2]);
        let rest = (stuck[border] - self.friction * slipping[border]) / powers[border];
        for at in 0..self.places.len() {
            self.tangential[at] = if at < border {
                stuck[at] - rest * powers[at]
            } else {
                self.friction * slipping[at]
            };
        }
    }

    /// P and D that belong to Q.
    fn find_pressures(&mut self, stretches: &Stretches, powers: &[f64], coupling: f64) {
        let drawn = stretches.image(&stretches.of_odd, &self.tangential);
        let edge = drawn[drawn.len() - 1];
        for ((normal, power), drawn) in self.normal.iter_mut().zip(powers).zip(drawn) {
            // Half of the change: the whole one would swing up where friction is high.
            *normal = 0.5 * (*normal + 1.0 - power - coupling * (drawn - edge));
        }
        self.relative_approach = 1.0 + coupling * edge;
    }

    /// The integral of P, to which the load is proportional.
    fn load(&self) -> f64 {
        let trapezia = self.places.windows(2).zip(self.normal.windows(2));
        trapezia.map(|(t, value)| 0.5 * (value[0] + value[1]) * (t[1] - t[0])).sum()
    }
}

/// The slope at the first of three points of the parabola through them.
fn slope_at_first([(x0, f0), (x1, f1), (x2, f2)]: [(f64, f64); 3]) -> f64 {
    let (first, second) = ((f1 - f0) / (x1 - x0), (f2 - f0) / (x2 - x0));
    first + (first - second) * (x1 - x0) / (x2 - x1)
}
