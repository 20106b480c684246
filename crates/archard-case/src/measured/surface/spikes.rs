//! Readings that failed: numbers in the place of lost readings, and spikes.

use archard_surface::HeightMap;

use super::Surface;

/// A height that is there so many times may stand for lost readings.
const SEVERAL: usize = 3;

impl Surface {
    /// Leaves out numbers that stand for lost readings, and spikes of a map; those of a profile are found where it is held against a computed
    /// one.
    pub(super) fn without_spikes(mut self) -> Self {
        self.leave_out_marks();
        let elements = [0, 1].map(|axis| self.places[axis].len());
        if self.axis.is_none()
            && let Ok(map) = HeightMap::new(elements, [1.0; 2], self.heights.clone())
            && let Ok((map, _)) = map.without_outliers()
        {
            self.heights = map.heights().to_vec();
        }
        self
    }

    /// Leaves out the number that an instrument writes for lost readings, as zero or -9999: the lowest or highest of all, there
    /// several times, and farther from all others than these are from each other.
    fn leave_out_marks(&mut self) {
        for sign in [1.0, -1.0] {
            let end = self.heights.iter().map(|z| sign * z).fold(f64::INFINITY, f64::min);
            let (mut least, mut most, mut count) = (f64::INFINITY, f64::NEG_INFINITY, 0);
            for z in self.heights.iter().map(|z| sign * z) {
                match z == end {
                    true => count += 1,
                    false => (least, most) = (least.min(z), most.max(z)),
                }
            }
            if count >= SEVERAL && most > least && least - end > most - least {
                let marks = self.heights.iter_mut().filter(|z| sign * **z == end);
                marks.for_each(|z| *z = f64::NAN);
            }
        }
    }
}
