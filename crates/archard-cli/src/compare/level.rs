//! Raw readings of a profile brought level: a line fitted beside the scar, and a shift along it.

use archard::numerics::SAME;
use archard_case::measured::plane::{Height, Plane};

/// How raw readings lie against the shape that the body had.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Level {
    /// The line, along the first axis of a plane.
    pub(super) plane: Plane,
    /// Where the origin of the run is among the readings (m).
    pub(super) shift: f64,
}

/// Readings: place and height (m).
pub(super) type Reading = (f64, f64);

impl Level {
    /// The line through readings less the nominal height at them, at a shift; `None` if too few lie outside the scar.
    pub(super) fn fitted(
        readings: &[Reading],
        shift: f64,
        nominal: impl Fn(f64) -> f64,
        scar: [f64; 2],
    ) -> Option<Self> {
        let outside = |place: f64| place < scar[0] || place > scar[1];
        let rest: Vec<Height> = readings
            .iter()
            .filter(|(place, _)| outside(place - shift))
            .map(|(place, height)| [*place, 0.0, height - nominal(place - shift)])
            .collect();
        Some(Self { plane: Plane::through(&rest)?, shift })
    }

    /// The readings in the place and height of the run.
    pub(super) fn applied(&self, readings: &[Reading]) -> Vec<Reading> {
        let level = |(place, height): &Reading| {
            (place - self.shift, self.plane.above(&[*place, 0.0, *height]))
        };
        readings.iter().map(level).collect()
    }
}

/// The place at which a cost is least: the best of many places, and what a golden section finds around it.
pub(super) fn least([low, high]: [f64; 2], cost: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    const PLACES: usize = 400;
    let step = (high - low) / PLACES as f64;
    let places = (0..=PLACES).map(|i| low + step * i as f64);
    let known = places.filter_map(|place| Some((place, cost(place)?)));
    let (best, _) = known.min_by(|one, other| one.1.total_cmp(&other.1))?;
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut from, mut to) = (best - step, best + step);
    while to - from > SAME * (high - low) {
        let [one, other] = [to - golden * (to - from), from + golden * (to - from)];
        let [a, b] = [one, other].map(|place| cost(place).unwrap_or(f64::INFINITY));
        if a <= b { to = other } else { from = one }
    }
    Some(0.5 * (from + to))
}

#[cfg(test)]
mod tests {
    use super::{Level, least};

    /// A groove of 2 um in a tilted plane with a speck of debris: the plane is found, and the shift by the groove.
    #[test]
    fn a_tilted_plane_is_levelled() {
        let groove = |x: f64| -2e-6 * (1.0 - (x / 0.3e-3).powi(2)).max(0.0);
        let readings: Vec<(f64, f64)> = (0..400)
            .map(|i| {
                let x = 5e-6 * f64::from(i);
                let debris = if (30..34).contains(&i) { 5e-6 } else { 0.0 };
                (x, 1e-5 + 3e-3 * x + groove(x - 1.1e-3) + debris)
            })
            .collect();
        let scar = [-0.35e-3, 0.35e-3];
        let cost = |shift: f64| {
            let level = Level::fitted(&readings, shift, |_| 0.0, scar)?;
            let levelled = level.applied(&readings);
            Some(levelled.iter().map(|(x, z)| (z - groove(*x)).abs()).sum())
        };
        let shift = least([0.4e-3, 1.6e-3], cost).unwrap();
        assert!((shift - 1.1e-3).abs() < 1e-7, "{shift}");
        let level = Level::fitted(&readings, shift, |_| 0.0, scar).unwrap();
        assert!(
            (level.plane.tilt[0] - 3e-3).abs() < 1e-9 && (level.plane.offset - 1e-5).abs() < 1e-12,
            "{level:?}"
        );
        assert!(Level::fitted(&readings[..3], 0.0, |_| 0.0, [1.0, 2.0]).is_none());
    }
}
