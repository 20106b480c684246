//! The increments of a cycle in which bodies rub: they err as elements do, are chosen with them, and companions take fewer.

use crate::case::check::Parts;
use crate::case::definition::Case;
use crate::parameters::Value;

const INCREMENTS: &str = "increments";
/// How many there are at first.
const FIRST: usize = 20;
/// The most that are chosen.
const MOST: usize = 400;
/// Those of fretting are a multiple of this.
const DIVISOR: f64 = 4.0;

/// The period of bodies that rub in increments whose number can be chosen (the motion's own unit).
pub(super) fn period(parts: &Parts<'_>) -> Option<f64> {
    let declared = parts.case.motion.choice.parameters;
    let takes = declared.iter().any(|parameter| parameter.name == INCREMENTS);
    parts.motion.period().filter(|_| takes && parts.friction.is_some())
}

fn rubs(case: &Case) -> bool {
    Parts::of(case).is_ok_and(|parts| period(&parts).is_some())
}

/// Gives a number of increments to a case that says none; whether it did.
pub(super) fn choose(case: &mut Case) -> bool {
    let chosen = rubs(case) && of(case).is_none();
    if chosen {
        set(case, FIRST);
    }
    chosen
}

fn of(case: &Case) -> Option<usize> {
    case.motion.values.number(INCREMENTS).map(|count| count as usize)
}

fn set(case: &mut Case, count: usize) {
    case.motion.values.insert(INCREMENTS, Value::Number(count as f64));
}

/// The case with that share of its increments, or that many times as many; as it is where bodies do not rub in increments.
pub(super) fn scaled(case: &mut Case, share: f64) {
    let Some(own) = of(case).filter(|_| rubs(case)) else { return };
    let asked = (share * own as f64 / DIVISOR).round().max(1.0) * DIVISOR;
    let asked = (asked as usize).min(MOST.max(own));
    if (share < 1.0) == (asked < own) {
        set(case, asked);
    }
}
