//! Whether heights and pixels are of one surface, or one of their units is wrong.
//!
//! A unit that is wrong is wrong by a factor of a thousand at least. Surfaces that were measured have slopes of 0.001 to 1, so
//! that such a factor shows in the slopes between neighbours.

use crate::map::HeightMap;

/// Slope from which on it is not that of a surface: 84 degrees. A dry lens of the largest aperture, 0.95, sees reflecting slopes
/// up to 3.0 (72 degrees), and a stylus of 60 degrees feels 1.7.
const STEEP: f64 = 10.0;
/// Slope that surfaces seldom have: 45 degrees.
const USUAL: f64 = 1.0;
/// Height (m) of an atom.
const ATOM: f64 = 1e-10;

/// Why heights and pixels cannot be of one surface.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Implausible {
    /// Heights are too large, or pixels too small.
    #[error(
        "half of the neighbouring points differ by more than {STEEP} pixels in height, slopes beyond 84 degrees: heights {:.0} times smaller, or pixels as much larger, would be plausible",
        1.0 / .factor
    )]
    Steep {
        /// What makes the heights plausible: 1e-3, 1e-6 or 1e-9.
        factor: f64,
    },
    /// Heights are too small.
    #[error("all heights lie within {:e} m, less than an atom: their unit is too small", .range)]
    Flat {
        /// From the lowest to the highest point (m).
        range: f64,
    },
}

impl HeightMap {
    /// Looks whether the unit of heights or pixels is wrong. Single points may be as they like: half of all have to agree.
    ///
    /// # Errors
    /// If it is.
    pub fn plausible(&self) -> Result<(), Implausible> {
        let finite = self.heights().iter().filter(|height| height.is_finite());
        let bounds = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = finite.fold(bounds, |(low, high), &z| (z.min(low), z.max(high)));
        let range = high - low;
        if range > 0.0 && range < ATOM {
            return Err(Implausible::Flat { range });
        }
        if !self.half_exceed(STEEP) {
            return Ok(());
        }
        let smaller = [1e-3, 1e-6].into_iter().find(|factor| !self.half_exceed(USUAL / factor));
        Err(Implausible::Steep { factor: smaller.unwrap_or(1e-9) })
    }

    /// Whether more than half of the slopes between neighbours exceed that.
    fn half_exceed(&self, slope: f64) -> bool {
        let [nx, ny] = self.elements();
        let [dx, dy] = self.pixel();
        let (mut steep, mut all) = (0_usize, 0_usize);
        let mut count = |rise: f64, pixel: f64| {
            all += usize::from(rise.is_finite());
            steep += usize::from(rise.abs() > slope * pixel);
        };
        for y in 0..ny {
            for x in 0..nx {
                if x + 1 < nx {
                    count(self.at(x + 1, y) - self.at(x, y), dx);
                }
                if y + 1 < ny {
                    count(self.at(x, y + 1) - self.at(x, y), dy);
                }
            }
        }
        2 * steep > all
    }
}

#[cfg(test)]
mod tests {
    use super::{HeightMap, Implausible};

    /// A tilted plane whose slope is that along x.
    fn plane(slope: f64) -> HeightMap {
        let heights = (0..12).map(|at| slope * 2e-6 * f64::from(at % 4)).collect();
        HeightMap::new([4, 3], [2e-6, 3e-6], heights).unwrap()
    }

    #[test]
    fn the_factor_makes_slopes_usual() {
        // Neighbours along y are level: of 17 pairs 9 lie along x.
        assert_eq!(plane(9.9).plausible(), Ok(()));
        assert_eq!(plane(-10.1).plausible(), Err(Implausible::Steep { factor: 1e-3 }));
        assert_eq!(plane(990.0).plausible(), Err(Implausible::Steep { factor: 1e-3 }));
        assert_eq!(plane(1010.0).plausible(), Err(Implausible::Steep { factor: 1e-6 }));
        assert_eq!(plane(2e6).plausible(), Err(Implausible::Steep { factor: 1e-9 }));
        assert_eq!(plane(0.0).plausible(), Ok(()));
        let range = plane(1e-5).heights()[3];
        assert_eq!(plane(1e-5).plausible(), Err(Implausible::Flat { range }));
    }

    /// A few spikes, as optical instruments have them at edges, say nothing about the unit.
    #[test]
    fn spikes_are_left_alone() {
        let mut heights = plane(0.1).heights().to_vec();
        heights[5] = 1e-2;
        let map = HeightMap::new([4, 3], [2e-6, 3e-6], heights).unwrap();
        assert_eq!(map.plausible(), Ok(()));
    }
}
