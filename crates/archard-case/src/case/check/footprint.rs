//! Memory of a run, from what its parts keep for each pair.

use std::f64::consts::FRAC_PI_4;

use super::{Parts, size};
use archard::compliance::bem;
use archard::motion::{Shift, Stepping};
use archard::solve::monolithic::factors_memory;

// Measured as the peak resident memory of whole runs, `/usr/bin/time -f %M archard run` with two threads, per pair
// and beyond that of the program, with N elements squared:
// - `pin_on_disc`, steps of 20 mm: 209 bytes (N = 256), 205 (512), 213 (1024) and 198 (2048); with a tolerance 372,
//   382 and 382 (256, 512, 1024);
// - `hertz`: 474, 477, 475 and 481 (256, 512, 768, 1024), but 388 (2048); in 3, 10 and 40 increments 516 (256), 687
//   (256) and 1337 (128);
// - `fretting_sphere`, one cycle of 8 and of 20 increments: 1330 and 2119 (256), of 20 increments 2130 (128);
// - `twin_disc` without revolutions 374 and 422 (256, 512), in a frame of 2 mm by 6.4 mm 278 (256); with wear in
//   steps of 50 revolutions 488 and 532 (256, 512), with a tolerance 789 (256);
// - unlike bodies: `spence` in 8, 16 and 40 increments 2200, 3207 and 5932 (128), `free_rolling_unlike` 1463 (256).

/// Memory a run takes for each pair (bytes): padded spectra, the fields of solver and state, and an output.
pub(crate) const BYTES_A_PAIR: f64 = 210.0;
/// Memory for each pair of half-spaces beyond that (bytes): kernels of the parts of the frame that were solved on.
// With parts `pin_on_disc` took 41 and 50 bytes a pair more (256, 512), with a tolerance 33 (256).
const BYTES_A_PAIR_OF_PARTS: f64 = 50.0;
/// Memory for each pair and each wider frame that the run goes on in (bytes): its gap and its kernels.
// With 1, 2 and 4 of them `pin_on_disc` took 36, 65 and 203 bytes a pair more (512).
const BYTES_A_PAIR_OF_A_WIDER_FRAME: f64 = 50.0;
/// Memory for each pair beyond that (bytes) where two histories are kept to choose steps by error.
const BYTES_A_PAIR_OF_HISTORIES: f64 = 170.0;
/// The same of histories that keep tractions and slip as well.
const BYTES_A_PAIR_OF_ROLLING_HISTORIES: f64 = 275.0;
/// Memory for each pair in contact that rolls with friction (bytes): the vectors of Krylov iterations.
const BYTES_A_PAIR_OF_FRICTION: f64 = 1150.0;
/// Memory for each pair of bodies that wear as they roll (bytes).
const BYTES_A_PAIR_OF_PLANES: f64 = 110.0;
/// Memory for each pair of unlike bodies that roll (bytes): kernels and fields of three components.
const BYTES_A_PAIR_OF_COUPLING: f64 = 400.0;
/// The same of bodies that go through increments, where the other fields are among the states.
const BYTES_A_PAIR_OF_CROSSED_KERNELS: f64 = 180.0;
/// Memory for each pair of bodies that go through increments (bytes): the states before the first, before and after
/// the present one, at the peak of the cycle, and on their way to the observers.
const BYTES_A_PAIR_OF_STATES: f64 = 155.0;
/// What these states leave behind (bytes a pair) as they are made and dropped, where a field is a block that the
/// allocator keeps: glibc gives blocks of 32 MiB and more back to the system (mallopt(3), `M_MMAP_THRESHOLD`).
const BYTES_A_PAIR_OF_HOLES: f64 = 85.0;
/// The size (bytes) of these blocks.
const GIVEN_BACK: f64 = 32.0 * 1048576.0;
/// Memory for each pair and increment of a cycle (bytes): a solution to start the next cycle from.
const BYTES_A_PAIR_OF_AN_INCREMENT: f64 = 24.0;
/// Memory for each pair and increment beyond that (bytes) where friction or wear keep tractions, slip and depths.
const BYTES_A_PAIR_OF_RUBBING: f64 = 42.0;
/// Memory for each pair and increment of unlike bodies beyond that (bytes): tractions and displacements.
const BYTES_A_PAIR_OF_BOTH: f64 = 48.0;
/// Memory of the program before any pair (bytes).
const BYTES_OF_THE_PROGRAM: f64 = 12e6;

/// Memory (bytes) of a run.
pub(in crate::case) fn memory(parts: &Parts<'_>) -> f64 {
    let by_error = matches!(parts.schedule.stepping, Stepping::Tolerance(_))
        && parts.motion.period().is_none();
    let histories = if by_error { BYTES_A_PAIR_OF_HISTORIES } else { 0.0 };
    let pairs = parts.pairs() as f64;
    let meshed = bem::memory(parts.bodies.each_ref().map(|body| body.finite.as_ref().map(size)));
    let friction = match parts.motion.rolling() {
        Some(rolling) if parts.friction.is_some() => {
            let goes_on = !rolling.swept && parts.schedule.extent > 0.0;
            let wears = goes_on && parts.wears();
            let wear = if wears { BYTES_A_PAIR_OF_PLANES } else { 0.0 };
            // The histories keep tractions and slip as well.
            let both = if by_error { BYTES_A_PAIR_OF_ROLLING_HISTORIES - histories } else { 0.0 };
            let unlike = if parts.alike() { 0.0 } else { 1.0 };
            let iterations = share_in_contact(parts) * BYTES_A_PAIR_OF_FRICTION;
            iterations + unlike * BYTES_A_PAIR_OF_COUPLING + wear + both
        }
        _ => match parts.motion.shift() {
            Some(shift) => cycle_memory(parts, shift),
            None => 0.0,
        },
    };
    let factors = of_factors(parts);
    let kernels = if parts.case.is_meshed() { 0.0 } else { BYTES_A_PAIR_OF_PARTS };
    let wider = BYTES_A_PAIR_OF_A_WIDER_FRAME * parts.case.doubles.len() as f64;
    let fields = (BYTES_A_PAIR + kernels + wider + histories + friction) * pairs;
    BYTES_OF_THE_PROGRAM + meshed + factors + fields
}

/// Pairs of half-spaces whose run fits into so much memory (bytes).
pub(in crate::case) fn pairs_within(parts: &Parts<'_>, free: f64) -> usize {
    let [own, all] = [memory(parts), free].map(|bytes| bytes - BYTES_OF_THE_PROGRAM);
    (all / own * parts.pairs() as f64) as usize
}

/// Memory (bytes) of the factors that friction of meshed bodies keeps for each increment of a cycle.
fn of_factors(parts: &Parts<'_>) -> f64 {
    match parts.motion.shift() {
        Some(shift) if parts.case.is_meshed() && parts.friction.is_some() => {
            let in_contact = share_in_contact(parts) * parts.pairs() as f64;
            shift.cycle.len() as f64 * factors_memory(in_contact)
        }
        _ => 0.0,
    }
}

/// Memory for each pair (bytes) of bodies that are pressed and shifted: the solutions of a cycle, which the
/// same increments of the next start from, and the iterations of friction.
fn cycle_memory(parts: &Parts<'_>, shift: &Shift) -> f64 {
    let unlike = if parts.alike() { 0.0 } else { 1.0 };
    let friction = if parts.friction.is_some() { 1.0 } else { 0.0 };
    let rubs = parts.friction.is_some() || parts.wears();
    let rubbing = if rubs { BYTES_A_PAIR_OF_RUBBING } else { 0.0 };
    let state = BYTES_A_PAIR_OF_AN_INCREMENT + rubbing;
    let solution = state + friction * unlike * BYTES_A_PAIR_OF_BOTH;
    let kept = match parts.schedule.stepping {
        Stepping::Implicit(_) | Stepping::Explicit(_) | Stepping::ToOutputs => solution,
        Stepping::Jumps(_) => solution + state,
        // A jump that is taken back needs the solutions before it.
        Stepping::Tolerance(_) => 2.0 * solution + state,
    };
    let field = parts.pairs() as f64 * size_of::<f64>() as f64;
    let holes = if field < GIVEN_BACK { BYTES_A_PAIR_OF_HOLES } else { 0.0 };
    let iterations = share_in_contact(parts) * BYTES_A_PAIR_OF_FRICTION;
    BYTES_A_PAIR_OF_STATES
        + holes
        + kept * shift.cycle.len() as f64
        + friction * iterations
        + unlike * BYTES_A_PAIR_OF_CROSSED_KERNELS
}

/// Share of the frame that the contact fills; a half where it is not known.
fn share_in_contact(parts: &Parts<'_>) -> f64 {
    let Some(contact) = parts.subject().contact(parts.schedule.control) else { return 0.5 };
    let across =
        |axis: usize| (2.0 * contact.semi_axes[axis] / parts.case.frame.size[axis]).min(1.0);
    FRAC_PI_4 * across(0) * across(1)
}
