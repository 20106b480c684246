//! The increments of a cycle in which bodies rub, as many as there are elements across the contact.

use crate::case::check::Parts;
use crate::case::definition::Case;
use archard::accuracy::{DIVISOR, MOST_INCREMENTS};
use archard::parameters::Value;

const INCREMENTS: &str = "increments";

/// Whether bodies rub in increments whose number can be chosen.
fn rubs(case: &Case) -> bool {
    let declared = case.motion.choice.parameters;
    let takes = declared.iter().any(|parameter| parameter.name == INCREMENTS);
    let rub = |parts: Parts<'_>| parts.friction.is_some() && parts.motion.increments().is_some();
    takes && Parts::of(case).is_ok_and(rub)
}

/// Gives a number of increments to a case that says none, as many in a cycle as there are elements across the contact: what slips
/// comes in from both sides, by one element in an increment. Whether it did.
pub(super) fn choose(case: &mut Case, across: impl FnOnce(&Parts<'_>) -> f64) -> bool {
    let chosen = rubs(case) && of(case).is_none();
    let wanted = Parts::of(case).map(|parts| across(&parts));
    if let Some(wanted) = wanted.ok().filter(|_| chosen) {
        set(case, (((wanted / DIVISOR).ceil() * DIVISOR) as usize).min(MOST_INCREMENTS));
    }
    chosen
}

/// As many as a case says.
fn of(case: &Case) -> Option<usize> {
    case.motion.values.number(INCREMENTS).map(|count| count as usize)
}

pub(super) fn set(case: &mut Case, count: usize) {
    case.motion.values.insert(INCREMENTS, Value::Number(count as f64));
}

/// Those of a case whose bodies rub in increments.
pub(super) fn of_rubbing(case: &Case) -> Option<usize> {
    of(case).filter(|_| rubs(case))
}
