//! The least that the elements of a run err by. Grids that agree need not be right: they may see an edge alike, or none of them
//! a strip that sticks.

use std::f64::consts::PI;

use super::Kind;
use crate::simulation::history;

/// Of forces and creepages where bodies roll, relative, times the square of the number of elements along the frame: the edge
/// of slip falls anywhere within an element.
const OF_EDGES: f64 = 10.0;
/// Of pressures, likewise: both ends of a line of contact may fall into elements alike.
const OF_PRESSURES: f64 = 2.0;
/// Of depths and peak pressures, over the square of the elements across the contact: the middle of a Hertz contact falls
/// between two elements of a line of contact, and between four of others. A tenth more than that.
const OF_MIDDLES: [f64; 2] = [0.55, 1.1];
/// Of approaches, likewise: elements that the rim cuts count wholly or not at all. At Sneddon's tips it was up to 0.18.
const OF_APPROACHES: f64 = 0.25;
/// Of what wears by less than in proportion to the pressure where bodies roll and slip behind a strip that sticks, over the
/// elements along what slips: such laws wear most at the rim, within one element. What wears in proportion goes by the work
/// of friction, which no rim disturbs.
const OF_SLIP: f64 = 0.3;
/// The least of these elements: grids that see none slip may miss that much.
const SLIPPING: f64 = 0.5;
/// Of counted areas, relative to the contact's, over the elements across it. At both ends of a line of contact the rim falls
/// anywhere within an element, half of which counts wrongly at most; all around others a sixth of an element counts too much on
/// average. Half as much again as that.
const OF_RIMS: [f64; 2] = [1.5, 1.0];
/// How much more that is for areas that stick: where nothing seems to, a strip may be narrower than the elements.
const OF_STICK: f64 = 2.0;

/// Least errors of a run, relative.
#[derive(Debug, Clone)]
pub(super) struct LeastError {
    /// Of forces and creepages.
    edges: f64,
    pressures: f64,
    /// Whether what wears goes by the rim of what slips.
    by_rim: bool,
    line: bool,
    /// From where on elements have which area (m^2), of places in the motion's unit.
    areas: Vec<[f64; 2]>,
}

impl LeastError {
    /// With so many elements along the frame; whether the edge of `slip` shows as it does where bodies roll.
    pub fn new(elements: f64, slip: bool, kind: &Kind) -> Self {
        let &Kind { line, sublinear, .. } = kind;
        Self {
            edges: if slip { OF_EDGES / (elements * elements) } else { 0.0 },
            pressures: OF_PRESSURES / (elements * elements),
            by_rim: slip && sublinear,
            line,
            areas: kind.areas.clone(),
        }
    }

    /// The least error of a value in a column (in its unit) at some progress, where the bodies touch, and stick, on these areas
    /// (m^2).
    pub fn of(
        &self,
        column: &str,
        (progress, value): (f64, f64),
        [contact, stick]: [f64; 2],
    ) -> f64 {
        let across = self.across(contact, progress);
        let of_rims = OF_RIMS[usize::from(!self.line)] / across;
        let of_middle = OF_MIDDLES[usize::from(!self.line)] / across.powi(2);
        let of_slip = self.of_slip([contact, stick], across);
        match column {
            _ if contact == 0.0 => 0.0,
            history::CONTACT_AREA => of_rims * contact,
            history::APPROACH => OF_APPROACHES / across.powi(2) * value.abs(),
            history::STICK_AREA => OF_STICK * of_rims * contact,
            history::PEAK_PRESSURE => self.pressures.max(of_middle) * value.abs(),
            history::CENTRE_PRESSURE => self.pressures * value.abs(),
            _ if history::CREEPAGE.contains(&column) || is_tangential(column) => {
                self.edges * value.abs()
            }
            _ if history::is_depth(column) => of_middle.max(of_slip) * value.abs(),
            _ if history::is_worn(column) => of_slip * value.abs(),
            _ => 0.0,
        }
    }

    /// That of pressures and depths at a tip that lies anywhere among the elements and makes errors of that order, relative to what
    /// is found: the middle of the nearest is up to 0.7 elements away. The share missed of Sneddon's pressures is 0.9, 0.7 and 0.4
    /// times that assumed, where the order is 0.2, 0.5 and 0.8.
    pub fn of_tip(&self, order: f64, progress: f64, contact: f64) -> f64 {
        let missed = self.across(contact, progress).powf(-order);
        if missed < 0.5 { missed / (1.0 - missed) } else { 1.0 }
    }

    /// Elements across a contact of that area (m^2) at some progress, one at least.
    fn across(&self, contact: f64, progress: f64) -> f64 {
        let reached = self.areas.iter().rev().find(|[from, _]| *from <= progress);
        let touching = reached.or(self.areas.first()).map_or(1.0, |[_, area]| contact / area);
        let across = if self.line { touching } else { (4.0 / PI * touching).sqrt() };
        across.max(1.0)
    }

    /// The relative one of what wears, by how narrow the strip is that slips.
    fn of_slip(&self, [contact, stick]: [f64; 2], across: f64) -> f64 {
        if !self.by_rim || stick == 0.0 {
            return 0.0;
        }
        OF_SLIP / ((1.0 - stick / contact) * across).max(SLIPPING)
    }
}

/// Whether a column is of a force that friction bears.
pub(super) fn is_tangential(column: &str) -> bool {
    history::FORCE.contains(&column) || column == history::FRICTIONAL_POWER
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::super::Kind;
    use super::LeastError;

    #[test]
    fn what_sees_edges_has_a_least_error() {
        let kind = |line: bool, area: f64| Kind {
            order: 2.0,
            tip: None,
            areas: vec![[0.0, area], [100.0, 4.0 * area]],
            slips_partly: true,
            sublinear: true,
            line,
            period: None,
        };
        let line = LeastError::new(100.0, true, &kind(true, 1e-7));
        let other = LeastError::new(100.0, false, &kind(false, 1e-8));
        for (column, value, expected) in [
            ("force_x_N", -20.0, [0.02, 0.0]),
            ("creepage", 1e-3, [1e-6, 0.0]),
            ("centre_pressure_Pa", 1e9, [2e5, 2e5]),
            ("contact_area_m2", 1e-6, [1.5e-7, 1e-6 / (400.0 / PI).sqrt()]),
            ("stick_area_m2", 0.0, [3e-7, 2e-6 / (400.0 / PI).sqrt()]),
            ("wear_depth_m", 1e-6, [6e-8, 1.1e-6 / (400.0 / PI)]),
            ("worn_section_pin_m2", 1e-6, [6e-8, 0.0]),
            ("approach_m", 1e-6, [2.5e-9, 0.25e-6 / (400.0 / PI)]),
            ("load_N", 1e-6, [0.0, 0.0]),
        ] {
            // Five of ten elements slip; of the other contact, a hundred touch.
            let found = [&line, &other].map(|least| least.of(column, (99.0, value), [1e-6, 5e-7]));
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() <= 1e-12 * expected, "{column}: {found}");
            }
        }
        // What a tip is missed by follows from the 11.3 elements across; half of it, or more, is all of what is found.
        for (order, expected) in [(0.5, 1.0 / (10.0 * (4.0 / PI).sqrt()).sqrt()), (0.05, 0.5)] {
            let found = other.of_tip(order, 0.0, 1e-6);
            assert!((found - expected / (1.0 - expected)).abs() < 1e-12, "{order}: {found}");
        }
        // Elements are as large as they have become, and what does not touch errs by nothing.
        let of = |progress, areas| other.of("wear_depth_m", (progress, 1e-6), areas);
        assert!((of(100.0, [1e-6, 0.0]) / of(99.0, [1e-6, 0.0]) - 4.0).abs() < 1e-12);
        assert_eq!(of(99.0, [0.0, 0.0]), 0.0);
    }
}
