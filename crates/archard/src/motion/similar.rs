//! Wear by k s alone: one run that passes through the ends of others.
//!
//! Under a constant load a law linear in k, such as Holm-Archard's depth = k p s, wears by the product of coefficient and
//! progress: the state at k and s is that at k / c and c s. Of cases that differ by the factor of all their coefficients, the
//! one with the largest goes through the end of every other.

use super::{Control, Motion, Schedule, Sequence, Stepping};

/// Places closer than this, relative to the extent, are not told apart by a run.
const APART: f64 = 1e-8;
/// Places that differ by less than this, relative to their size, are the same.
const SAME: f64 = 1e-12;

impl Motion {
    /// Whether what is worn follows from the product of wear coefficient and progress, where the law is linear in the
    /// coefficient and asks for nothing else: surfaces slide or roll steadily.
    pub fn is_steady(&self) -> bool {
        self.sequence == Sequence::Steady && !self.has_positions()
    }
}

impl Schedule {
    /// Whether the load is constant, and steps of wear are implicit.
    pub fn is_steady(&self) -> bool {
        let implicit = matches!(self.stepping, Stepping::Implicit(_) | Stepping::Tolerance(_));
        implicit
            && !self.ramped
            && self.extent > 0.0
            && matches!(self.control, Control::Load(load) if load > 0.0)
    }

    /// Whether one run separates both shares of the extent, each greater than zero, or takes them for one.
    pub fn tells(&self, share: f64, other: f64) -> bool {
        let difference = (share - other).abs();
        difference <= SAME * share.max(other) || difference >= APART
    }

    /// The schedule of a run that ends a step at these shares of its extent, rising to 1, where runs end whose wear
    /// coefficients are these shares of its own.
    ///
    /// Steps chosen by error end there. Fixed steps become shorter: up to a share no step is longer than the run that ends
    /// there would take itself, so that its error is no larger. Up to the first they are those of that run.
    #[must_use]
    pub fn through(&self, shares: &[f64]) -> Self {
        let mut places: Vec<f64> = shares.iter().map(|share| share * self.extent).collect();
        places.dedup_by(|next, place| *next - *place <= SAME * *next);
        let Stepping::Implicit(step) = self.stepping else {
            let apart = |place: &f64| {
                places.iter().all(|known| (known - place).abs() >= APART * self.extent)
            };
            let own: Vec<f64> = self.outputs.iter().copied().filter(apart).collect();
            places.extend(own);
            places.sort_by(f64::total_cmp);
            return Self { outputs: places, ..self.clone() };
        };
        let mut outputs: Vec<f64> = vec![];
        for (index, &place) in places.iter().enumerate() {
            let last = if index == 0 { 0.0 } else { places[index - 1] };
            let longest = place * (step / self.extent);
            let count = ((place - last) / longest - 1e-9).ceil().max(1.0);
            // The first run ends on a shorter step where its extent is no multiple; others share the rest evenly.
            let length = if index == 0 { longest } else { (place - last) / count };
            outputs.extend((1..count as u64).map(|number| last + number as f64 * length));
            outputs.push(place);
        }
        Self { outputs, stepping: Stepping::ToOutputs, ..self.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::{Control, Schedule, Stepping};

    fn schedule(stepping: Stepping) -> Schedule {
        Schedule {
            outputs: vec![5.0, 10.0],
            ..Schedule::steady(Control::Load(1.0), 10.0, stepping)
        }
    }

    /// Up to the first place the run's own steps, the last one shorter; then none longer than a run to the next would take.
    #[test]
    fn fixed_steps_are_no_longer_than_those_of_any_run() {
        let through = schedule(Stepping::Implicit(4.0)).through(&[0.25, 0.5, 0.5, 1.0]);
        assert_eq!(through.stepping, Stepping::ToOutputs);
        assert_eq!(through.outputs, [1.0, 2.0, 2.5, 3.75, 5.0, 7.5, 10.0]);
    }

    #[test]
    fn steps_by_error_keep_their_outputs() {
        let through = schedule(Stepping::Tolerance(1e-3)).through(&[0.25, 0.5 + 1e-11, 1.0]);
        assert_eq!(through.outputs, [2.5, 5.0 + 1e-10, 10.0]);
        assert_eq!(through.stepping, Stepping::Tolerance(1e-3));
    }

    #[test]
    fn only_a_constant_load_is_steady() {
        let steady = schedule(Stepping::Implicit(1.0));
        assert!(steady.is_steady());
        assert!(!Schedule { ramped: true, ..steady.clone() }.is_steady());
        assert!(!Schedule { control: Control::Approach(1e-6), ..steady.clone() }.is_steady());
        assert!(!Schedule { stepping: Stepping::Explicit(1.0), ..steady.clone() }.is_steady());
        assert!(steady.tells(0.5, 0.5 + 1e-13) && steady.tells(0.5, 0.51));
        assert!(!steady.tells(0.5, 0.5 + 1e-10));
    }
}
