//! Equivalent conicity (UIC 519, EN 15302): the cone that makes a free wheelset weave at the same wavelength.
//!
//! A wheelset that rolls freely and without slip steers itself back with the difference of its rolling radii: with the
//! distance x along the track, y'' = -dr(y)/(e r), e the distance of the contacts and r the nominal radius. Its energy
//! y'^2/2 + U(y) is kept, U the integral of dr/(e r), so that a period between the turning points a and b is twice the integral of
//! dy/sqrt(2 (U(a) - U(y))). Cones of angle c have dr = 2 c y, and the wavelength L with c = 2 pi^2 e r/L^2.

use std::f64::consts::{FRAC_PI_2, PI};

use rayon::prelude::*;

use crate::roots;
use crate::search::Search;
use crate::setup::{Attitude, Setup, Side};
use archard::parameters::Invalid;

/// Distance (m) between the shifts at which rolling radii are found. Between them their difference is taken for
/// straight. A choice of cost.
const STEP: f64 = 1e-4;
/// Points of the midpoint rule over a quarter of the period, which is smooth in the angle it is taken over.
const POINTS: usize = 2000;

/// Rolling radius (m) of the right wheel less that of the left one.
///
/// # Errors
/// If a wheel is nowhere over its rail.
pub fn rolling_radius_difference(
    [right, left]: [&Setup; 2],
    shift: f64,
    yaw: f64,
    roll: Option<f64>,
) -> Result<f64, Invalid> {
    let roll = roll.map_or_else(|| right.roll(left, shift, yaw), Ok)?;
    let radius = |setup: &Setup, side: Side| {
        let attitude = side.attitude(Attitude { shift, roll, yaw });
        let onset = Search::first_touch(setup, attitude)?;
        let onset = onset.ok_or_else(|| Invalid::new("shift", "a wheel is not over its rail"))?;
        Ok::<f64, Invalid>(
            setup.wheelset().nominal_radius + setup.wheel().point(onset.at.on_wheel)[1],
        )
    };
    Ok(radius(right, Side::Right)? - radius(left, Side::Left)?)
}

/// The equivalent conicity for an amplitude (m) of the lateral motion.
///
/// # Errors
/// If the amplitude is not greater than zero, a wheel is nowhere over its rail, or the wheelset does not steer itself back.
pub fn equivalent_conicity(setups: [&Setup; 2], amplitude: f64) -> Result<f64, Invalid> {
    let amplitude = crate::bounds::positive("amplitude", amplitude)?;
    // Twice the amplitude to each side, since profiles that differ weave about another middle.
    let count = (2.0 * amplitude / STEP).ceil() as i32;
    let shifts: Vec<f64> = (-count..=count).map(|at| f64::from(at) * STEP).collect();
    let differences = shifts
        .par_iter()
        .map(|&shift| rolling_radius_difference(setups, shift, 0.0, None))
        .collect::<Result<Vec<_>, _>>()?;
    let half_period =
        Weaving::new(&shifts, &differences).half_period(amplitude).ok_or_else(|| {
            Invalid::new("amplitude", "the wheelset does not steer itself back at this amplitude")
        })?;
    // In units of sqrt(e r).
    Ok(2.0 * PI * PI / (2.0 * half_period).powi(2))
}

/// The motion with dr given by points, straight between them.
struct Weaving<'a> {
    shifts: &'a [f64],
    differences: &'a [f64],
    /// The integral of dr from the first shift (m^2).
    potential: Vec<f64>,
}

impl<'a> Weaving<'a> {
    fn new(shifts: &'a [f64], differences: &'a [f64]) -> Self {
        let mut potential = vec![0.0];
        for at in 1..shifts.len() {
            let width = shifts[at] - shifts[at - 1];
            let mean = 0.5 * (differences[at] + differences[at - 1]);
            potential.push(potential[at - 1] + width * mean);
        }
        Self { shifts, differences, potential }
    }

    /// The integral of dr (m^2) up to a shift (m).
    fn at(&self, shift: f64) -> f64 {
        let after =
            self.shifts.partition_point(|&one| one <= shift).clamp(1, self.shifts.len() - 1);
        let (from, d) = (after - 1, shift - self.shifts[after - 1]);
        let width = self.shifts[after] - self.shifts[from];
        let slope = (self.differences[after] - self.differences[from]) / width;
        self.potential[from] + d * (self.differences[from] + 0.5 * d * slope)
    }

    /// The integral of dy/sqrt(2 (U(a) - U(y))) between turning points a and b that are twice the amplitude apart, in units of
    /// sqrt(e r).
    fn half_period(&self, amplitude: f64) -> Option<f64> {
        let excess = |middle: f64| self.at(middle + amplitude) - self.at(middle - amplitude);
        if excess(-amplitude) > 0.0 || excess(amplitude) < 0.0 {
            return None;
        }
        let middle = roots::zero(-amplitude, amplitude, |middle| {
            // Scaled to one, since the search ends at values below rounding.
            excess(middle) / (amplitude * amplitude)
        });
        let top = 0.5 * (self.at(middle + amplitude) + self.at(middle - amplitude));
        let mut sum = 0.0;
        for at in 0..2 * POINTS {
            let angle = -FRAC_PI_2 + PI * (at as f64 + 0.5) / (2 * POINTS) as f64;
            let left = top - self.at(middle + amplitude * angle.sin());
            if left <= 0.0 {
                return None;
            }
            sum += amplitude * angle.cos() / (2.0 * left).sqrt();
        }
        Some(sum * PI / (2 * POINTS) as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::Weaving;
    use std::f64::consts::PI;

    /// Cones have their own conicity; a cubic spring weaves at the wavelength that its elliptic integral gives.
    #[test]
    fn cones_and_a_cubic_have_their_wavelengths() {
        let shifts: Vec<f64> = (-60..=60).map(|at| f64::from(at) * 1e-4).collect();
        let cone: Vec<f64> = shifts.iter().map(|y| 2.0 * 0.05 * y).collect();
        let half = Weaving::new(&shifts, &cone).half_period(3e-3).unwrap();
        assert!((2.0 * PI * PI / (2.0 * half).powi(2) / 0.05 - 1.0).abs() < 1e-6);
        let cubic: Vec<f64> = shifts.iter().map(|y| y.powi(3)).collect();
        let half = Weaving::new(&shifts, &cubic).half_period(3e-3).unwrap();
        // A period of y'' = -y^3 is 7.416298709 over the amplitude.
        assert!((2.0 * half * 3e-3 / 7.416_298_709 - 1.0).abs() < 1e-3, "{half}");
    }
}
