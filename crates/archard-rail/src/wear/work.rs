//! Where on a wheel friction works at an operating point.

use super::{Journey, OperatingPoint};
use crate::contact::{Bodies, ContactError, Loaded, Pressed, Resolution};
use crate::setup::{Setup, Side};

/// Elements that this is found on: the fewest of a [`Resolution`](crate::contact::Resolution).
const ELEMENTS: usize = 16;
/// Distance (m) between places where nothing is smoothed: half of the usual wavelength.
const APART: f64 = 1e-3;

impl Journey {
    /// The work of friction (N, on each metre that the wheelset goes) over the width of the wheel, side by side of those that are
    /// followed, in places half a wavelength of the smoothing apart. It says how points of a route differ, on few elements.
    ///
    /// # Errors
    /// As [`contact`](crate::contact::contact()).
    pub fn work(&self, point: &OperatingPoint) -> Result<Vec<f64>, ContactError> {
        let setups = vec![self.setup.clone(); self.sides.len()];
        let both = Side::both(&self.sides, &setups);
        let bodies = Bodies { wear: [None, None], ..point.between(&self.bodies) };
        let resolution = Resolution { elements: ELEMENTS, ..self.resolution };
        let operation = point.operation(both, &bodies, &resolution)?;
        let wheel = self.setup.wheel();
        let y = wheel.nodes().iter().map(|&along| wheel.point(along)[0]);
        let least = y.clone().fold(f64::INFINITY, f64::min);
        let width = y.fold(f64::NEG_INFINITY, f64::max) - least;
        let apart = if self.smoothing > 0.0 { 0.5 * self.smoothing } else { APART };
        let places = (width / apart).ceil() as usize + 2;
        let of_side = |(side, setup): (&Side, &Setup)| {
            let own = operation.of_side(*side);
            let loaded = Loaded::new(setup, &bodies, &own, &resolution)?;
            let (_, patches) = loaded.on(ELEMENTS, loaded.guess())?;
            let mut work = vec![0.0; places];
            for patch in patches.iter().filter(|patch| patch.normal > 0.0) {
                let middle = loaded.tell(patch).y_wheel;
                let rolled = patch.creepage.speed / point.velocity.forward;
                for (s, row) in rows(patch) {
                    let at = (middle + s * patch.patch.angle.cos() - least) / apart;
                    let at = at.clamp(0.0, (places - 2) as f64);
                    let (place, share) = (at as usize, at.fract());
                    work[place] += (1.0 - share) * row * rolled;
                    work[place + 1] += share * row * rolled;
                }
            }
            Ok::<_, ContactError>(work)
        };
        let sides = self.sides.iter().zip(&setups).map(of_side);
        Ok(sides.collect::<Result<Vec<_>, _>>()?.concat())
    }
}

/// Rows of a patch: s (m) from the reference point, and what friction works in it (N) on a metre of rolling.
fn rows(patch: &Pressed) -> impl Iterator<Item = (f64, f64)> {
    let map = &patch.map;
    let [along, across] = map.elements;
    let area = map.spacing[0] * map.spacing[1];
    (0..across).map(move |row| {
        let works = |pair: usize| {
            let of = |axis: usize| map.traction[axis][pair] * map.slip[axis][pair];
            (of(0) + of(1)).abs()
        };
        let s = map.origin[1] + (row as f64 + 0.5) * map.spacing[1];
        (s, area * (row * along..(row + 1) * along).map(works).sum::<f64>())
    })
}
