//! How many cycles of a motion are computed, and the contact solves they take.

use super::{Parts, Solves};
use archard::motion::{Control, Shift, Station, Stepping};

/// Contact solves in a jump of fixed length.
const SOLVES_A_JUMP: u64 = 8;
/// Contact solves in a jump chosen by its error, forth and back.
///
/// By the columns `solves` and `true_cycles` of the runs of [`by_error`]: 72, 78, 88, 98 and 107 under the
/// ball (6 over 2,000 cycles with a tolerance of 1e-1, 420 without outputs with 1e-3), 66, 69, 90, 194 and
/// 203 under the punch.
const SOLVES_A_JUMP_BY_ERROR: u64 = 80;

/// Cycles of a motion.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycles {
    /// How many there are.
    pub total: u64,
    /// How many are computed; the others are jumped over.
    pub computed: Solves,
}

impl Cycles {
    /// The cycles of the parts; `None` unless they are pressed and shifted step by step.
    pub(super) fn of(parts: &Parts<'_>) -> Option<Self> {
        let period = parts.motion.increments()?.period();
        let cycle = |place: f64| (place / period - 1e-9).ceil().max(1.0) as u64;
        let total = (parts.schedule.extent / period).round().max(1.0) as u64;
        let mut outputs: Vec<u64> =
            parts.case.output.places(parts.schedule.extent).into_iter().map(cycle).collect();
        outputs.dedup();
        let computed = match parts.schedule.stepping {
            Stepping::Jumps(every) => Solves::Exactly(by_jumps(every as u64, &outputs)),
            Stepping::Tolerance(tolerance) => {
                Solves::About(by_error(tolerance, total, outputs.len() as u64))
            }
            Stepping::Implicit(_) | Stepping::Explicit(_) | Stepping::ToOutputs => {
                Solves::Exactly(total)
            }
        };
        Some(Self { total, computed })
    }

    /// Contact solves of all cycles: one an increment under load, those before the first cycle, and those
    /// of jumps.
    pub(super) fn solves(self, parts: &Parts<'_>, shift: &Shift) -> Solves {
        let under_load = |stations: &[Station]| {
            stations.iter().filter(|station| station.control != Control::Load(0.0)).count() as u64
        };
        // The pressures and friction of unlike bodies may have to be found in turn.
        let coupled = parts.friction.is_some() && !parts.alike();
        let pressing_rubs = coupled || parts.friction.is_some() && parts.case.is_meshed();
        let (lead, cycle) = (under_load(shift.lead(pressing_rubs)), under_load(&shift.cycle));
        match (self.computed, parts.schedule.stepping) {
            (Solves::Exactly(cycles) | Solves::AtLeast(cycles), Stepping::Jumps(_)) => {
                Solves::AtLeast(lead + cycles * cycle + (cycles - 1) * SOLVES_A_JUMP)
            }
            (Solves::About(cycles), _) => {
                // Each jump leaves out a cycle at least.
                let jumps = cycles.min(self.total - cycles);
                Solves::About(lead + cycles * cycle + jumps * SOLVES_A_JUMP_BY_ERROR)
            }
            (Solves::Exactly(cycles) | Solves::AtLeast(cycles), _) => {
                let solves = lead + cycles * cycle;
                if coupled { Solves::AtLeast(solves) } else { Solves::Exactly(solves) }
            }
        }
    }
}

/// Cycles computed with jumps of fixed length: the first, every so many from the last output on, and those
/// with an output.
fn by_jumps(every: u64, outputs: &[u64]) -> u64 {
    let (mut before, mut computed) = (1, 1);
    for &output in outputs {
        computed += (output - before).div_ceil(every.max(1));
        before = output;
    }
    computed
}

/// Cycles computed with jumps chosen by error: jumps grow twofold each, up to what the tolerance allows.
///
/// The column `true_cycles` of `fretting_sphere` (200,000 cycles, ten outputs) ended at 26, 27, 33, 38 and
/// 46 for tolerances of 1e-1, 3e-2, 1e-2, 3e-3 and 1e-3, which the sum meets within a tenth; without outputs
/// on the way at 19 and 25 for 1e-1 and 1e-2, and over 2,000 cycles at 12 and 14 (ten outputs: 19 and 21).
/// A contact that goes on changing takes more: `punch_fretting` 52, 54, 54, 54 and 77, up to three times
/// the sum.
fn by_error(tolerance: f64, total: u64, outputs: u64) -> u64 {
    let sum = (total as f64).log2() + 0.75 * outputs as f64 + 0.65 / tolerance.sqrt();
    (sum.round() as u64).max(1 + outputs).min(total)
}

#[cfg(test)]
mod tests {
    use super::by_jumps;

    /// Cycles 1, 4, 7, 10 and, with an output at 5: 1, 4, 5, 8, 10. Runs of `fretting_sphere` and
    /// `punch_fretting`: 21 by jumps of 10,000 and 31 by jumps of 20.
    #[test]
    fn outputs_are_landed_on() {
        assert_eq!(by_jumps(3, &[10]), 4);
        assert_eq!(by_jumps(3, &[5, 10]), 5);
        assert_eq!((by_jumps(1, &[10]), by_jumps(20, &[10]), by_jumps(20, &[1])), (10, 2, 1));
        let tenths = |step: u64| (1..=10).map(|tenth| tenth * step).collect::<Vec<_>>();
        assert_eq!((by_jumps(10_000, &tenths(20_000)), by_jumps(20, &tenths(50))), (21, 31));
    }
}
