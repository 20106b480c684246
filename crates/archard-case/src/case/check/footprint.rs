//! Memory of a run, from what its parts keep for each pair.

use std::f64::consts::FRAC_PI_4;

use super::{Parts, size};
use archard::compliance::bem;
use archard::motion::{Sequence, Shift, Stepping};
use archard::solve::monolithic::factors_memory;

// Counted from the algorithms, not fitted. The peak resident memory of whole runs, `/usr/bin/time -f %M archard run` with two
// threads, beyond the 22 MB of a debug build, per pair with N elements squared, besides what is counted:
// - `pin_on_disc` 367 bytes (N = 512), counted 256; with a tolerance 540, counted 448; `hertz` 390, counted 480;
// - `twin_disc` without revolutions 310 (256), counted 300; `free_rolling_unlike` 2650 (256), counted 1660;
// - one cycle of `fretting_sphere` in 20 increments 4590 (256), counted 4500; `spence` in 40 increments 14800 (128), counted
//   15000: with as many Krylov iterations as their solver may take.

/// Numbers a pair of a kernel, and of the field that it is applied to: both on twice the elements along both axes.
const KERNEL: f64 = 8.0;
/// Numbers a pair of the vectors of a solver, of the state and its output, and of the kernels of parts of the frame.
const SOLVE: f64 = 24.0;
/// Numbers a pair of a solution: pressure, displacement and depth; where friction or wear rub, tractions, slip and distance;
/// of unlike bodies tractions and displacements of all three components.
const SOLUTION: [f64; 3] = [3.0, 5.0, 6.0];
/// States of bodies that go through increments: before the first, before and after the present one, at the peak of the cycle,
/// and on their way to the observers.
const STATES: f64 = 5.0;
/// Numbers a pair in contact of the Krylov iterations of rolling: 24 of them, with a direction, its image and a vector of the
/// basis, each of two components.
const KRYLOV: f64 = 144.0;
/// Memory of the program before any pair (bytes).
pub(in crate::case) const BYTES_OF_THE_PROGRAM: f64 = 12e6;

/// Memory (bytes) of so many numbers.
fn bytes(numbers: f64) -> f64 {
    size_of::<f64>() as f64 * numbers
}

/// Memory (bytes) of half-spaces that slide, on so many pairs.
pub(in crate::case) fn of_pairs(pairs: f64) -> f64 {
    bytes((KERNEL + SOLVE) * pairs)
}

/// Memory (bytes) of a run.
pub(in crate::case) fn memory(parts: &Parts<'_>) -> f64 {
    let by_error = matches!(parts.schedule.stepping, Stepping::Tolerance(_))
        && parts.motion.increments().is_none();
    let histories = if by_error { 2.0 } else { 1.0 };
    let pairs = parts.pairs() as f64;
    let meshed = bem::memory(parts.bodies.each_ref().map(|body| body.finite.as_ref().map(size)));
    let unlike = if parts.alike() { 0.0 } else { 1.0 };
    let friction = match parts.motion.driven(0.0) {
        Some(_) if parts.friction.is_some() => {
            let goes_on = parts.motion.sequence == Sequence::Steady && parts.schedule.extent > 0.0;
            let [own, rubbing, coupled] = SOLUTION;
            // Before and after a step.
            let wear =
                if goes_on && parts.wears() { 2.0 * histories * (own + rubbing) } else { 0.0 };
            let coupling = unlike * (3.0 * KERNEL + SOLVE + own + rubbing + coupled);
            share_in_contact(parts) * KRYLOV + coupling + wear
        }
        _ => parts.motion.increments().map_or(0.0, |shift| of_a_cycle(parts, shift)),
    };
    let wider = KERNEL * parts.case.doubles.len() as f64;
    // Chords of a sphere take two kernels with their fields and five vectors.
    let fitted = parts.bodies.iter().all(|body| body.profile.fitted().is_some());
    let chords = if fitted && !parts.case.frame.line { 2.0 * KERNEL + 5.0 } else { 0.0 };
    let fields = KERNEL + histories * SOLVE + wider + friction + chords;
    BYTES_OF_THE_PROGRAM + meshed + of_factors(parts) + bytes(fields * pairs)
}

/// Pairs of half-spaces whose run fits into so much memory (bytes).
pub(in crate::case) fn pairs_within(parts: &Parts<'_>, free: f64) -> usize {
    let [own, all] = [memory(parts), free].map(|bytes| bytes - BYTES_OF_THE_PROGRAM);
    (all / own * parts.pairs() as f64) as usize
}

/// Memory (bytes) of the factors that friction of meshed bodies keeps for each increment of a cycle.
fn of_factors(parts: &Parts<'_>) -> f64 {
    match parts.motion.increments() {
        Some(shift) if parts.case.is_meshed() && parts.friction.is_some() => {
            let in_contact = share_in_contact(parts) * parts.pairs() as f64;
            shift.cycle.len() as f64 * factors_memory(in_contact)
        }
        _ => 0.0,
    }
}

/// Numbers a pair of bodies that are pressed and shifted: the solutions of a cycle, which the same increments of the next
/// start from, and the iterations of friction.
fn of_a_cycle(parts: &Parts<'_>, shift: &Shift) -> f64 {
    let unlike = if parts.alike() { 0.0 } else { 1.0 };
    let friction = if parts.friction.is_some() { 1.0 } else { 0.0 };
    let rubs = parts.friction.is_some() || parts.wears();
    let [own, rubbing, coupled] = SOLUTION;
    let state = own + if rubs { rubbing } else { 0.0 };
    let solution = state + friction * unlike * coupled;
    let kept = match parts.schedule.stepping {
        Stepping::Implicit(_) | Stepping::Explicit(_) | Stepping::ToOutputs => solution,
        Stepping::Jumps(_) => solution + state,
        // A jump that is taken back needs the solutions before it.
        Stepping::Tolerance(_) => 2.0 * solution + state,
    };
    // Of each Krylov iteration a direction and a vector of the basis; of unlike bodies all three components on the frame.
    let most = parts.case.friction_solver.build().map_or(0, |one| one.settings().max_iterations);
    let components = if unlike > 0.0 { 3.0 } else { 2.0 * share_in_contact(parts) };
    // A state has its gaps and its factors besides.
    STATES * (solution + 2.0)
        + kept * shift.cycle.len() as f64
        + friction * components * 2.0 * most as f64
        + unlike * 3.0 * KERNEL
}

/// Share of the frame that the contact fills; a half where it is not known.
fn share_in_contact(parts: &Parts<'_>) -> f64 {
    let Some(contact) = parts.subject().contact(parts.schedule.control) else { return 0.5 };
    let across =
        |axis: usize| (2.0 * contact.semi_axes[axis] / parts.case.frame.size[axis]).min(1.0);
    FRAC_PI_4 * across(0) * across(1)
}
