//! Raw readings of a profile brought level: a line fitted beside the scar, and a shift along it.

/// How raw readings lie against the shape that the body had.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Level {
    /// Height (m) of the fitted line at the origin of the readings.
    pub(super) offset: f64,
    /// Its slope.
    pub(super) tilt: f64,
    /// Where the origin of the run is among the readings (m).
    pub(super) shift: f64,
    /// Readings that the line was fitted to.
    pub(super) used: usize,
    /// Their scatter about it (m).
    pub(super) scatter: f64,
}

/// Readings: place and height (m).
pub(super) type Reading = (f64, f64);

/// Deviations, in standard deviations by the median, beyond which a reading is debris.
const DEBRIS: f64 = 3.5;
/// The median of deviations over the standard deviation of normal ones.
const MEDIAN: f64 = 0.6745;
/// Fewest readings that tell a line.
pub(super) const FEWEST: usize = 6;
/// Rounds in which debris is left out.
const ROUNDS: usize = 8;

impl Level {
    /// The line through readings less the nominal height at them, at a shift; `None` if fewer than [`FEWEST`] lie outside
    /// the scar.
    pub(super) fn fitted(
        readings: &[Reading],
        shift: f64,
        nominal: impl Fn(f64) -> f64,
        scar: [f64; 2],
    ) -> Option<Self> {
        let outside = |place: f64| place < scar[0] || place > scar[1];
        let mut rest: Vec<Reading> = readings
            .iter()
            .map(|(place, height)| (*place, height - nominal(place - shift)))
            .filter(|(place, _)| outside(place - shift))
            .collect();
        let mut found = None;
        for _ in 0..ROUNDS {
            let (offset, tilt) = line(&rest)?;
            let off = |reading: &Reading| reading.1 - offset - tilt * reading.0;
            let mut sizes: Vec<f64> = rest.iter().map(|reading| off(reading).abs()).collect();
            sizes.sort_by(f64::total_cmp);
            let deviation = sizes[sizes.len() / 2] / MEDIAN;
            let square: f64 = rest.iter().map(|reading| off(reading).powi(2)).sum();
            let scatter = (square / rest.len() as f64).sqrt();
            found = Some(Self { offset, tilt, shift, used: rest.len(), scatter });
            let before = rest.len();
            rest.retain(|reading| off(reading).abs() <= DEBRIS * deviation.max(f64::MIN_POSITIVE));
            if rest.len() == before || rest.len() < FEWEST {
                break;
            }
        }
        found
    }

    /// The readings in the place and height of the run.
    pub(super) fn applied(&self, readings: &[Reading]) -> Vec<Reading> {
        let level = |(place, height): &Reading| {
            (place - self.shift, height - self.offset - self.tilt * place)
        };
        readings.iter().map(level).collect()
    }
}

/// The line of least squares; `None` if there are too few points.
fn line(points: &[Reading]) -> Option<(f64, f64)> {
    if points.len() < FEWEST {
        return None;
    }
    let count = points.len() as f64;
    let [x, y] = [
        points.iter().map(|p| p.0).sum::<f64>() / count,
        points.iter().map(|p| p.1).sum::<f64>() / count,
    ];
    let square: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    let mixed: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let tilt = if square > 0.0 { mixed / square } else { 0.0 };
    Some((y - tilt * x, tilt))
}

/// The place at which a cost is least: the best of many places, and what a golden section finds around it.
pub(super) fn least([low, high]: [f64; 2], cost: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    const PLACES: usize = 400;
    const ROUNDS: usize = 60;
    let step = (high - low) / PLACES as f64;
    let places = (0..=PLACES).map(|i| low + step * i as f64);
    let known = places.filter_map(|place| Some((place, cost(place)?)));
    let (best, _) = known.min_by(|one, other| one.1.total_cmp(&other.1))?;
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut from, mut to) = (best - step, best + step);
    for _ in 0..ROUNDS {
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
            (level.tilt - 3e-3).abs() < 1e-9 && (level.offset - 1e-5).abs() < 1e-12,
            "{level:?}"
        );
        assert!(Level::fitted(&readings[..3], 0.0, |_| 0.0, [1.0, 2.0]).is_none());
    }
}
