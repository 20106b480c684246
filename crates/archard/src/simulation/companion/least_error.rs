//! The least that the elements of a run err by. Grids that agree need not be right: they may see an edge alike, or none of them
//! a strip that sticks.

use std::f64::consts::PI;

use super::Kind;
use crate::simulation::history;

// With n elements along the frame, relative:

/// Of forces and creepages where bodies roll, times n^2: the edge of slip falls anywhere within an element.
const OF_EDGES: f64 = 10.0;
/// Of pressures, times n^2: both ends of a line of contact may fall into elements alike.
const OF_PRESSURES: f64 = 2.0;

// With m elements across the contact, relative; pairs are of a line of contact and of others:

/// Of peak pressures, times m^2, and of depths, times the power of the pressure by which a law wears: the middle of a Hertz contact
/// falls between two elements of a line of contact, and between four of others. A tenth more than that.
const OF_MIDDLES: [f64; 2] = [0.6, 1.1];
/// Of depths of surfaces that pass through the contact, times m^2: their rows take up the errors of all elements along them. None
/// were found on lines of contact.
const OF_ROWS: [f64; 2] = [0.0, 2.3];
/// Of approaches, times m^2: elements that the rim cuts count wholly or not at all. At Sneddon's tips it was up to 0.18.
const OF_APPROACHES: f64 = 0.25;
/// Of what wears out of proportion to the pressure, times m^(3/2) and over the power of the pressure, or its inverse where that is
/// larger: it goes by how the pressure falls to the rim. Of volumes, and of depths of surfaces that pass. No more was found of laws
/// with powers from 0.3 to 2 and thresholds up to 0.8 of the peak pressure.
const OF_FALL: f64 = 0.75;
/// The largest power, or inverse, that counts there: a law that wears the same under all pressures has a power of zero.
const BENT: f64 = 5.0;
/// Rounding of powers.
const ROUNDING: f64 = 1e-6;
/// Of counted areas, times m. At both ends of a line of contact the rim falls anywhere within an element, half of which counts
/// wrongly at most; all around others a sixth of an element counts too much on average. Half as much again as that.
const OF_RIMS: [f64; 2] = [1.5, 1.0];
/// How much more that is for areas that stick: where nothing seems to, a strip may be narrower than the elements.
const OF_STICK: f64 = 2.0;

/// The least component of a force, relative to all of it, that its error is relative to.
const ASIDE: f64 = 0.01;
/// A component of a force, or a moment, relative to all there may be, that is none.
const NOTHING: f64 = 1e-6;
/// Of moments of friction where bodies roll, times m^2, beside what forces err by. No more was found on 14 grids each of ten
/// states of creepage and spin.
const OF_MOMENTS: f64 = 10.0;
/// The arm of a force whose moment, or that found where it is more, errors of moments are relative to: over the radius of a disc of
/// the contact's area. None is taken on lines of contact.
const ARM: f64 = 0.25;

// Between unlike bodies that roll, over what pressures bring about there, [`Kind::coupled`]:

/// Of forces, relative to the load, times m^(3/2): strips that stick and slip follow each other, and their edges move by an element
/// together. As large as the largest found on lines of contact of 8 pairs of materials and 26 grids, and on others of 5 and 11.
const OF_UNLIKE: [f64; 2] = [17.0, 7.0];
/// Of forces on lines of contact, relative to the load, times m, where that is more: it is from 72 elements on.
const OF_MANY: f64 = 2.0;
/// The force, relative to the load, below which what follows from it is not told by its size.
const LEAST_FORCE: f64 = 1e-3;
/// Of peak pressures, relative, times m^(1/2): where slip begins pressures have a cusp, which elements cut off. Up to a fifth less
/// was found.
const OF_CUSPS: f64 = 0.6;
/// Coupling from which on they hardly converge.
const HAS_CUSPS: f64 = 0.01;

// Where bodies roll, with j elements along what slips, relative:

/// Of depths where they touch on an area, times j m^(1/2): where it wears most, few elements slip. No more was found on 13 grids
/// each of like bodies, with creepages of 5 to 60 % of those from which on all slips, lateral ones, and spin.
const OF_STRIPS: f64 = 1.0;
/// Of what wears by less than in proportion to the pressure behind a strip that sticks, times j: such laws wear most at the rim,
/// within one element. What wears in proportion goes by the work of friction, which no rim disturbs.
const OF_SLIP: f64 = 0.3;
/// The least j: grids that see none slip may miss that much.
const SLIPPING: f64 = 0.5;

/// How bodies touch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touch {
    /// The areas (m^2) on which they do, and stick.
    pub contact: f64,
    pub stick: f64,
    /// The load (N) and the tangential force (N).
    pub load: f64,
    pub force: f64,
}

/// Least errors of a run, relative.
#[derive(Debug, Clone)]
pub(super) struct LeastError {
    /// Of forces, of creepages and of what wears by the work of both.
    edges: f64,
    /// What pressures bring about between unlike bodies that roll, relative to the load.
    coupled: f64,
    pressures: f64,
    /// Whether what wears goes by the rim of what slips, and depths by how few elements do.
    by_rim: bool,
    strips: bool,
    /// Of moments, times m^2.
    moments: f64,
    /// The pressure, relative to the peak, up to which friction grows from the edge on.
    grows: f64,
    /// The largest power of the pressure by which a body wears, and the furthest from one.
    steepness: f64,
    bent: f64,
    /// Whether surfaces pass.
    passes: bool,
    line: bool,
    /// From where on elements have which area (m^2), of places in the motion's unit.
    areas: Vec<[f64; 2]>,
}

impl LeastError {
    /// With so many elements along the frame; whether the edge of `slip` shows as it does where bodies roll.
    pub fn new(elements: f64, slip: bool, kind: &Kind) -> Self {
        let &Kind { line, steepness: [least, most], coupled, passes, grows, .. } = kind;
        let bent = most.max(1.0 / least).min(BENT);
        Self {
            edges: if slip { OF_EDGES / (elements * elements) } else { 0.0 },
            coupled: if slip { coupled } else { 0.0 },
            pressures: OF_PRESSURES / (elements * elements),
            by_rim: slip && least < 1.0 - ROUNDING,
            strips: slip && !line,
            moments: if slip { OF_MOMENTS } else { 0.0 },
            grows: if slip { grows } else { f64::INFINITY },
            steepness: most,
            bent: if bent > 1.0 + ROUNDING { bent } else { 0.0 },
            passes,
            line,
            areas: kind.areas.clone(),
        }
    }

    /// The least error of a value in a column (in its unit) at some progress, where the bodies touch in that way.
    pub fn of(&self, column: &str, (progress, value): (f64, f64), touch: Touch) -> f64 {
        let Touch { contact, stick, load, force } = touch;
        let across = self.across(contact, progress);
        let shaped = |[line, other]: [f64; 2]| if self.line { line } else { other };
        let of_many = shaped([OF_MANY, 0.0]) / across;
        let unlike = (shaped(OF_UNLIKE) / across.powf(1.5)).max(of_many);
        let of_force = self.coupled * unlike * load / (LEAST_FORCE * load).max(force);
        let of_rims = shaped(OF_RIMS) / across;
        // The first element lies under that share of the peak pressure at most.
        let of_limit = if 2.0 / across.sqrt() > self.grows { of_rims } else { 0.0 };
        let of_work = self.edges.max(of_force).max(of_limit);
        let of_moment = self.moments / across.powi(2);
        let arm = shaped([0.0, ARM]) * (contact / PI).sqrt();
        // What vanishes by symmetry errs by nothing.
        let size = value.abs();
        let beside = |share: f64, whole: f64| {
            if size > NOTHING * whole { size.max(share * whole) } else { size }
        };
        let of_cusp = OF_CUSPS * self.coupled / across.sqrt();
        let of_middle = shaped(OF_MIDDLES) / across.powi(2);
        let of_rows = shaped(OF_ROWS) / across.powi(2);
        let of_fall = OF_FALL * self.bent / across.powf(1.5);
        let slipping = ((1.0 - stick / contact) * across).max(SLIPPING);
        let of_slip = if self.by_rim && stick > 0.0 { OF_SLIP / slipping } else { 0.0 };
        let of_volume = of_slip.max(of_work).max(of_fall);
        let of_strips = if self.strips { OF_STRIPS / slipping / across.sqrt() } else { 0.0 };
        let of_passing = if self.passes { of_rows.max(of_strips).max(of_volume) } else { 0.0 };
        match column {
            _ if contact == 0.0 => 0.0,
            history::CONTACT_AREA => of_rims * contact,
            history::APPROACH => OF_APPROACHES / across.powi(2) * size,
            history::STICK_AREA => OF_STICK * of_rims * contact,
            history::PEAK_PRESSURE => self.pressures.max(of_middle).max(of_cusp) * size,
            history::CENTRE_PRESSURE => self.pressures * size,
            history::MOMENT => of_work * size + of_moment * beside(1.0, arm * force),
            _ if history::FORCE.contains(&column) => of_work * beside(ASIDE, force),
            _ if history::CREEPAGE.contains(&column) || is_tangential(column) => of_work * size,
            _ if history::is_depth(column) => (self.steepness * of_middle).max(of_passing) * size,
            _ if history::is_worn(column) => of_volume * size,
            _ => 0.0,
        }
    }

    /// Whether peak pressures hardly converge.
    pub fn has_cusps(&self) -> bool {
        self.coupled > HAS_CUSPS
    }

    /// That of pressures and depths at a tip that lies anywhere among the elements and makes errors of that order, relative to what
    /// is found: the middle of the nearest is up to 0.7 elements away. The share missed of Sneddon's pressures is 0.9, 0.7 and 0.4
    /// times that assumed, where the order is 0.2, 0.5 and 0.8.
    pub fn of_tip(&self, order: f64, progress: f64, contact: f64) -> f64 {
        let missed = self.across(contact, progress).powf(-order);
        if missed < 0.5 { missed / (1.0 - missed) } else { 1.0 }
    }

    /// Elements across a contact of that area (m^2) at some progress, one at least. The area was counted on half as many, whose rim
    /// adds up to one of these.
    fn across(&self, contact: f64, progress: f64) -> f64 {
        let reached = self.areas.iter().rev().find(|[from, _]| *from <= progress);
        let touching = reached.or(self.areas.first()).map_or(1.0, |[_, area]| contact / area);
        let across = if self.line { touching } else { (4.0 / PI * touching).sqrt() };
        (across - 1.0).max(1.0)
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
    use super::{LeastError, Touch};

    const KIND: Kind = Kind {
        order: 2.0,
        tip: None,
        areas: vec![],
        slips_partly: true,
        steepness: [0.8, 2.0],
        coupled: 0.0,
        grows: f64::INFINITY,
        passes: true,
        line: true,
        period: None,
    };

    fn areas(area: f64) -> Vec<[f64; 2]> {
        vec![[0.0, area], [100.0, 4.0 * area]]
    }

    const TOUCH: Touch = Touch { contact: 1e-6, stick: 5e-7, load: 100.0, force: 20.0 };

    #[test]
    fn what_sees_edges_has_a_least_error() {
        let line = Kind { areas: areas(1e-7), ..KIND };
        let line = LeastError::new(100.0, true, &line);
        let other = Kind { areas: areas(1e-8), line: false, passes: false, ..KIND };
        let other = LeastError::new(100.0, false, &other);
        let across = (400.0 / PI).sqrt() - 1.0;
        for (column, value, expected) in [
            ("force_x_N", -20.0, [0.02, 0.0]),
            ("force_y_N", 0.1, [2e-4, 0.0]),
            ("force_y_N", 1e-6, [1e-9, 0.0]),
            ("creepage", 1e-3, [1e-6, 0.0]),
            ("centre_pressure_Pa", 1e9, [2e5, 2e5]),
            ("peak_pressure_Pa", 1e9, [0.6e9 / 81.0, 1.1e9 / across.powi(2)]),
            ("contact_area_m2", 1e-6, [1.5e-6 / 9.0, 1e-6 / across]),
            ("stick_area_m2", 0.0, [3e-6 / 9.0, 2e-6 / across]),
            ("wear_depth_m", 1e-6, [0.3e-6 / 4.5, 2.2e-6 / across.powi(2)]),
            ("worn_section_pin_m2", 1e-6, [0.3e-6 / 4.5, 1.5e-6 / across.powf(1.5)]),
            ("approach_m", 1e-6, [0.25e-6 / 81.0, 0.25e-6 / across.powi(2)]),
            ("load_N", 1e-6, [0.0, 0.0]),
        ] {
            // Of ten elements nine count, half of which slip; of the other contact, a hundred touch.
            let found = [&line, &other].map(|least| least.of(column, (99.0, value), TOUCH));
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() <= 1e-12 * expected, "{column}: {found}");
            }
        }
        // What a tip is missed by follows from the 10.3 elements across; half of it, or more, is all of what is found.
        for (order, expected) in [(0.5, across.powf(-0.5)), (0.05, 0.5)] {
            let found = other.of_tip(order, 0.0, 1e-6);
            assert!((found - expected / (1.0 - expected)).abs() < 1e-12, "{order}: {found}");
        }
        // Elements are as large as they have become, and what does not touch errs by nothing.
        let of = |progress, contact| {
            other.of("wear_depth_m", (progress, 1e-6), Touch { contact, ..TOUCH })
        };
        let fewer = (100.0 / PI).sqrt() - 1.0;
        let expected = (across / fewer).powi(2);
        assert!((of(100.0, 1e-6) / of(99.0, 1e-6) - expected).abs() < 1e-12);
        assert_eq!(of(99.0, 0.0), 0.0);
    }

    /// Forces by what pressures bring about, relative to the load, and what they wear; where surfaces pass, and by how the
    /// pressure falls.
    #[test]
    fn what_couples_or_passes_has_a_least_error() {
        let of = |kind: Kind, column: &str| {
            let least = LeastError::new(1e9, true, &Kind { areas: areas(1e-6 / 101.0), ..kind });
            least.of(column, (0.0, 1.0), TOUCH)
        };
        let kind = Kind { steepness: [1.0; 2], ..KIND };
        let unlike = Kind { coupled: 0.1, ..kind.clone() };
        let bounded = Kind { grows: 0.1, ..kind.clone() };
        // A hundred elements count, and the force is a fifth of the load.
        for column in ["force_x_N", "creepage", "worn_section_m2", "wear_depth_m"] {
            assert!((of(unlike.clone(), column) - 1e-2).abs() < 1e-12, "{column}");
        }
        let round = |kind: Kind| Kind { line: false, ..kind };
        let across = (404.0 / PI).sqrt() - 1.0;
        for (kind, column, expected) in [
            (bounded.clone(), "force_x_N", 0.015),
            (Kind { grows: 0.3, ..bounded.clone() }, "force_x_N", 1e-17),
            (bounded, "moment_z_Nm", 0.016),
            (kind.clone(), "moment_z_Nm", 1e-3),
            (unlike.clone(), "peak_pressure_Pa", 6e-3),
            (round(unlike), "force_y_N", 3.5 / across.powf(1.5)),
            (kind.clone(), "wear_depth_m", 0.6e-4),
            (round(kind.clone()), "wear_depth_m", 2.0 / across.powf(1.5)),
            (kind.clone(), "worn_section_m2", 1e-17),
            (Kind { steepness: [1.0, 4.0], ..kind.clone() }, "worn_section_m2", 3e-3),
            (Kind { steepness: [1.0, 4.0], ..kind.clone() }, "wear_depth_m", 3e-3),
            (Kind { steepness: [1.0, 9.0], ..kind.clone() }, "worn_section_m2", 3.75e-3),
            (Kind { steepness: [1.0, 4.0], passes: false, ..kind }, "wear_depth_m", 2.4e-4),
        ] {
            let found = of(kind, column);
            assert!((found - expected).abs() < 1e-12, "{column}: {found} for {expected}");
        }
    }
}
