//! The least that the elements of a run err by. Grids that agree need not be right: they may see an edge alike, or none of them
//! a strip that sticks.

use crate::simulation::history;

/// Of forces and creepages where bodies roll, relative, times the square of the number of elements along the frame: the edge
/// of slip falls anywhere within an element.
const OF_EDGES: f64 = 10.0;
/// Of pressures, likewise: both ends of a line of contact may fall into elements alike.
const OF_PRESSURES: f64 = 2.0;
/// Of counted areas, relative to the contact's and to a power of that number: a rim falls anywhere within an element, at both
/// ends of a line of contact and all around others.
const OF_RIMS: [(f64, f64); 2] = [(2.0, 1.0), (2.0, 1.5)];
/// How much more that is for areas that stick: where nothing seems to, a strip may be narrower than the elements.
const OF_STICK: f64 = 2.0;

/// Least errors of a run, relative.
#[derive(Debug, Clone, Copy)]
pub(super) struct LeastError {
    /// Of forces and creepages.
    edges: f64,
    pressures: f64,
    /// Of areas, relative to the contact's.
    rims: f64,
}

impl LeastError {
    /// With so many elements along the frame; whether the edge of `slip` shows as it does where bodies roll; whether they touch
    /// along a `line`.
    pub fn new(elements: f64, slip: bool, line: bool) -> Self {
        let (times, power) = OF_RIMS[usize::from(!line)];
        Self {
            edges: if slip { OF_EDGES / (elements * elements) } else { 0.0 },
            pressures: OF_PRESSURES / (elements * elements),
            rims: times * elements.powf(-power),
        }
    }

    /// The least error of a value in a column (in its unit), where the bodies touch on that area (m^2).
    pub fn of(self, column: &str, value: f64, contact: f64) -> f64 {
        match column {
            history::CONTACT_AREA => self.rims * contact,
            history::STICK_AREA => OF_STICK * self.rims * contact,
            history::PEAK_PRESSURE | history::CENTRE_PRESSURE => self.pressures * value.abs(),
            _ if history::CREEPAGE.contains(&column) || is_tangential(column) => {
                self.edges * value.abs()
            }
            _ => 0.0,
        }
    }
}

/// Whether a column is of a force that friction bears.
pub(super) fn is_tangential(column: &str) -> bool {
    history::FORCE.contains(&column) || column == history::FRICTIONAL_POWER
}

#[cfg(test)]
mod tests {
    use super::LeastError;

    #[test]
    fn what_sees_edges_has_a_least_error() {
        let line = LeastError::new(100.0, true, true);
        let other = LeastError::new(100.0, false, false);
        for (column, value, expected) in [
            ("force_x_N", -20.0, [0.02, 0.0]),
            ("creepage", 1e-3, [1e-6, 0.0]),
            ("centre_pressure_Pa", 1e9, [2e5, 2e5]),
            ("contact_area_m2", 1e-6, [2e-8, 2e-9]),
            ("stick_area_m2", 0.0, [4e-8, 4e-9]),
            ("wear_depth_m", 1e-6, [0.0, 0.0]),
        ] {
            let found = [line, other].map(|least| least.of(column, value, 1e-6));
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() <= 1e-12 * expected, "{column}: {found}");
            }
        }
    }
}
