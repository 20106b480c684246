//! How many cycles to go on by, chosen by the error that jumping makes.
//!
//! The cycles of a jump are worn at the rate of the cycle before it. The cycle computed behind it shows how
//! the rate has changed, and the wear of the jump is taken again with a rate that changes evenly in the logarithm of the
//! cycles: wear that begins from nothing depends on powers of them. Relative to the wear made, the difference e of the two is
//! the error of the first. That of the second, which is kept, is taken to be 2 e^2 and what e would change by if the rate
//! changed evenly in the cycles themselves. On balls of 40 x 40 elements, in partial and in gross slip, with one axis and
//! with two, errors from 300 cycles on came to .04 to .68 of what is stated. Where pairs that stuck begin to slip, or the
//! other way round, the rate does not change evenly, and half of the difference there counts instead. Steps within a jump
//! err by what half as many differ.

use serde::{Deserialize, Serialize};

use crate::numerics::control::{Caution, Control};

/// How jumps change: the aim is 0.8 of the length that would err by all that is allowed.
const CAUTION: Caution = Caution { aim: 0.64, change: [0.2, 2.0], again: 0.5, failed: 0.25 };
/// Error that is kept over the square of the one that is corrected.
const SECOND: f64 = 2.0;
/// What is stated of the errors taken together: on the punch of 20 x 20 elements they came to two thirds of the true error
/// at the least.
const STATED: f64 = 1.5;
/// Error of a jump that is kept at most, relative to the tolerance.
const SPARE: f64 = 3.0;
/// Error that a jump which wears little aims at, relative to all wear so far and to the tolerance.
const REST: f64 = 0.02;
/// Error that the steps within a jump may make, relative to what the jump aims at.
const LAG: f64 = 0.2;
/// Most steps within a jump.
const MOST_STEPS: usize = 64;

/// The cycles of the next jump and the error so far.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(super) struct JumpControl {
    tolerance: f64,
    /// Cycles to go on by, the one computed included.
    cycles: Control,
    /// Error (m) of the worn depths, a 2-norm over the pairs.
    error: f64,
}

/// A jump that was corrected.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tried {
    /// Cycles jumped over.
    pub length: usize,
    /// 2-norms over the pairs of the wear made and of its correction (m).
    pub made: f64,
    pub off: f64,
    /// The part of the correction at pairs that stuck before or after, but not both.
    pub flipped: f64,
    /// 2-norm over the pairs of all wear so far (m), the jump's included.
    pub worn: f64,
    /// Error that the lag of the pressures makes within the jump, relative to the wear made.
    pub lag: f64,
    /// Whether a stick zone came or went.
    pub turned: bool,
    /// Cycles before it.
    pub done: usize,
}

impl JumpControl {
    pub fn new(tolerance: f64) -> Self {
        Self { tolerance, cycles: Control::first(2.0), error: 0.0 }
    }

    /// Cycles to jump over before the next one is computed, which may be that many ahead at most.
    pub fn jump(&self, ahead: usize) -> usize {
        let cycles = self.cycles.towards(ahead as f64);
        (cycles.round() as usize).clamp(1, ahead.max(1)) - 1
    }

    /// Whether so many steps within a jump, which make that error relative to the wear made, are enough. The 2-norms over the
    /// pairs of the wear made and of all wear so far (m) are given.
    pub fn resolves(&self, lag: f64, steps: usize, [made, worn]: [f64; 2]) -> bool {
        lag <= LAG * self.aim(made, worn) || steps >= MOST_STEPS
    }

    /// The error that a jump aims at, relative to the wear it makes.
    fn aim(&self, made: f64, worn: f64) -> f64 {
        let rest = if made > 0.0 { REST * worn / made } else { 1.0 };
        self.tolerance * rest.max(1.0)
    }

    /// Makes the next jump shorter than one that could not be carried through.
    pub fn shorten(&mut self, length: usize) {
        self.again(length, CAUTION.failed);
    }

    /// The next jump after one that is not kept: none where there was but one cycle to jump over.
    fn again(&mut self, length: usize, change: f64) {
        let cycles = if length == 1 { 1.0 } else { (1.0 + change * length as f64).max(2.0) };
        self.cycles = Control::first(cycles);
    }

    /// Whether a jump is good enough; sets the next jump.
    pub fn judge(&mut self, tried: Tried) -> bool {
        let Tried { length, made, off, flipped, worn, lag, turned, done } = tried;
        if length == 0 {
            self.cycles.at_least(2.0);
            return true;
        }
        let [even, flipped] = [(off * off - flipped * flipped).max(0.0).sqrt(), flipped]
            .map(|part| if made > 0.0 { part / made } else { 0.0 });
        let uneven = unevenness(done, length) * even;
        let error = SECOND * even * even + uneven + 0.5 * flipped + lag;
        let aim = self.aim(made, worn);
        let change = CAUTION.change(error / aim, 1.0);
        // A turn is met as closely as the tolerance resolves the cycles so far.
        let overrun = turned && length > 1 && length as f64 > self.tolerance * done as f64;
        let total = self.error + made * error;
        // One jump may do worse where those before it did better, or where it adds little.
        let spare = error <= SPARE * aim && total <= self.tolerance * worn;
        if (error > self.tolerance && !spare) || overrun {
            self.again(length, change.min(CAUTION.again));
            return false;
        }
        let cycles = length as f64 + 1.0;
        self.cycles.taken(cycles, (1.0 + change * length as f64) / cycles);
        self.error = total;
        true
    }

    /// Relative error of worn depths of that 2-norm over the pairs (m).
    pub fn estimate(&self, worn: f64) -> f64 {
        if worn > 0.0 { STATED * self.error / worn } else { 0.0 }
    }
}

/// How much larger the correction of a jump over so many cycles behind those done is where the rate changes evenly in their
/// logarithm than where it changes evenly in the cycles, relative to the latter.
fn unevenness(done: usize, length: usize) -> f64 {
    let longer = length as f64 / (done as f64 + 0.5);
    let mean = 1.0 + 1.0 / longer - 1.0 / longer.ln_1p();
    2.0 * mean - 1.0
}

#[cfg(test)]
mod tests {
    use super::{JumpControl, STATED, Tried, unevenness};

    const GOOD: Tried = Tried {
        length: 1,
        made: 1.0,
        off: 0.01,
        flipped: 0.0,
        worn: 1.0,
        lag: 1e-3,
        turned: false,
        done: 10,
    };

    #[test]
    fn strides_grow_and_land_on_what_is_ahead() {
        let mut jump_control = JumpControl::new(0.01);
        assert_eq!(jump_control.jump(50), 1);
        assert!(jump_control.judge(GOOD) && jump_control.judge(Tried { length: 2, ..GOOD }));
        assert_eq!(jump_control.jump(50), 4);
        // Five and then the rest, or two of about the same length.
        assert_eq!((jump_control.jump(6), jump_control.jump(5), jump_control.jump(1)), (2, 4, 0));
    }

    #[test]
    fn errors_and_turns_shorten_them() {
        let mut jump_control = JumpControl::new(0.01);
        assert!(!jump_control.judge(Tried { length: 40, off: 0.2, ..GOOD }));
        assert_eq!(jump_control.jump(100), 9);
        assert!(!jump_control.judge(Tried { length: 8, turned: true, ..GOOD }));
        assert!(jump_control.judge(Tried { length: 1, turned: true, ..GOOD }));
    }

    /// What flips between stick and slip counts by half, what is even by twice its square and by how unevenly it may go; the
    /// sum stays.
    #[test]
    fn errors_are_of_both_kinds_and_add_up() {
        let error = |off: f64, flipped: f64| {
            let mut jump_control = JumpControl::new(0.5);
            assert!(jump_control.judge(Tried { off, flipped, lag: 0.0, ..GOOD }));
            jump_control.estimate(1.0) / STATED
        };
        let even = |off: f64| 2.0 * off * off + unevenness(GOOD.done, GOOD.length) * off;
        assert!((error(0.1, 0.0) - even(0.1)).abs() < 1e-15);
        assert!((error(0.1, 0.1) - 0.5 * 0.1).abs() < 1e-15);
        assert!((error(0.05, 0.04) - (even(0.03) + 0.5 * 0.04)).abs() < 1e-15);
        let mut jump_control = JumpControl::new(0.5);
        for jumps in 1..=3 {
            assert!(jump_control.judge(Tried { off: 0.1, lag: 0.0, worn: 10.0, ..GOOD }));
            let error = even(0.1) * f64::from(jumps);
            assert!((jump_control.estimate(1.0) / STATED - error).abs() < 1e-15);
        }
    }

    /// A rate that goes as ln t, from 1 to 3 at 10.5 and 20.5 cycles, wears more than one that goes evenly by what is told.
    #[test]
    fn logarithms_and_cycles_are_told_apart() {
        let rate = |t: f64| 1.0 + 2.0 * (t / 10.5).ln() / (20.5_f64 / 10.5).ln();
        let count = 100_000;
        let mean: f64 = (0..count)
            .map(|i| rate(10.5 + 10.0 * (f64::from(i) + 0.5) / f64::from(count)) / f64::from(count))
            .sum();
        let even = 2.0;
        assert!(((mean - even) / (even - 1.0) - unevenness(10, 10)).abs() < 1e-8);
        assert!(unevenness(1_000_000, 1) < 1e-6 && unevenness(1, 1_000_000) < 1.0);
    }

    /// One jump may do worse where others did better, but not by more than a factor; lags are resolved.
    #[test]
    fn what_was_spared_may_be_spent_within_bounds() {
        let accepts = |lag: f64, worn: f64| {
            JumpControl::new(0.01).judge(Tried { lag, off: 0.0, length: 4, worn, ..GOOD })
        };
        assert!(accepts(0.009, 1.0) && !accepts(0.02, 1.0));
        assert!(accepts(0.02, 3.0) && !accepts(0.04, 30.0) && accepts(0.04, 100.0));
        let jump_control = JumpControl::new(0.01);
        assert!(
            jump_control.resolves(0.001, 2, [1.0, 1.0])
                && !jump_control.resolves(0.01, 2, [1.0, 1.0])
                && jump_control.resolves(0.01, 64, [1.0, 1.0])
                && jump_control.resolves(0.01, 2, [1e-3, 1.0])
        );
    }

    /// Jumps that fail are shortened until every cycle is computed.
    #[test]
    fn failures_shorten_to_every_cycle() {
        let mut jump_control = JumpControl::new(0.01);
        for (failed, next) in [(40, 10), (10, 3), (3, 1), (1, 0)] {
            jump_control.shorten(failed);
            assert_eq!(jump_control.jump(100), next);
        }
    }
}
