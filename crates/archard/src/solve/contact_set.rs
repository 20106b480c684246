//! Which pairs are in contact, and when that is asked again.
//!
//! A set of pairs is kept until the violations of those that are about to change sides outweigh the gaps left on the set
//! (proportioning with a factor of one: Z. Dostál and J. Schöberl, *Comput. Optim. Appl.* 30 (2005) 23). Where a set was
//! left at no lower residual than one before it, the next are solved more exactly.

use super::residual::Measure;

/// Sums of squares (Pa^2): the gaps left on the set by the pairs' own compliance, the violations of the pairs about to
/// change sides and of all pairs, and the pressures.
pub(super) struct Violations {
    pub gaps: f64,
    pub changing: f64,
    pub all: f64,
    pub pressures: f64,
}

impl Violations {
    pub fn residual(&self) -> f64 {
        Measure::relative(self.all, self.pressures)
    }
}

/// How exactly a set is solved before the next is chosen.
pub(super) struct Proportioning {
    /// How many times the gaps left on the set the violations of the pairs about to change sides may reach.
    factor: f64,
    /// The lowest residual at which a set was left.
    lowest: f64,
}

impl Default for Proportioning {
    fn default() -> Self {
        Self { factor: 1.0, lowest: f64::INFINITY }
    }
}

impl Proportioning {
    pub fn asks_for_another_set(&self, violations: &Violations) -> bool {
        violations.changing > self.factor * self.factor * violations.gaps
    }

    /// The set was left at this residual.
    pub fn changed(&mut self, residual: f64) {
        if residual >= self.lowest {
            self.factor *= 2.0;
        }
        self.lowest = self.lowest.min(residual);
    }
}

/// What a pair starts the next set with, by its pressure (Pa), gap (m), compliance to its own pressure (m/Pa) and hardness
/// (Pa): its pressure, and one where that may change, zero where it is held at none or at the hardness.
pub(super) fn settle(pressure: f64, gap: f64, own: f64, hardness: f64) -> [f64; 2] {
    if pressure * own <= gap {
        [0.0, 0.0]
    } else if pressure >= hardness && (pressure - hardness) * own >= gap {
        [hardness, 0.0]
    } else {
        [pressure, 1.0]
    }
}

#[cfg(test)]
mod tests {
    use super::{Proportioning, Violations};

    /// Pairs that change sides have to outweigh the gaps left, by twice as much where the last sets brought nothing.
    #[test]
    fn sets_are_solved_more_exactly_where_that_did_not_suffice() {
        let mut proportioning = Proportioning::default();
        let at = |gaps: f64, changing: f64| Violations { gaps, changing, all: 1.0, pressures: 1.0 };
        assert!(!proportioning.asks_for_another_set(&at(1.0, 1.0)));
        assert!(proportioning.asks_for_another_set(&at(1.0, 1.1)));
        proportioning.changed(0.5);
        proportioning.changed(0.4);
        assert!(proportioning.asks_for_another_set(&at(1.0, 1.1)));
        proportioning.changed(0.4);
        assert!(!proportioning.asks_for_another_set(&at(1.0, 4.0)));
        assert!(proportioning.asks_for_another_set(&at(1.0, 4.1)));
    }
}
