//! Gauss-Seidel sweeps over the pairs: each answers with all three directions of its traction to those of the others
//! as they are.
//!
//! The block of a pair with itself says what closes its gap and, under the limit of the pressure that does, what
//! stops its slip; every change is at once felt by all pairs (M. Jean, *Comput. Methods Appl. Mech. Engrg.* 177
//! (1999) 235). No derivative enters and no guess of which pairs slip: the answer is that of Newton's steps by another
//! way. After a sweep the tractions are scaled to a load that is given, and the approach is that at which the
//! pressures do no work on the gaps.

use faer::Mat;

use super::state::{APPROACH, State};
use super::{Outcome, Settings, Solution, Step};
use crate::frame::VectorField;
use crate::friction::onto_disc;
use crate::kinematics::Control;
use crate::numerics::vector::{sum_with, update};

/// Solves a step, a sweep of which costs as much as an application; `None` where the compliance has no matrix or a
/// force is given along a direction of slip.
pub(in crate::solve) fn sweep(
    step: &Step<'_>,
    start: &Solution,
    settings: Settings,
) -> Option<Outcome> {
    if !step.held.is_empty() {
        return None;
    }
    let pairs: Vec<usize> = (0..step.gap.len()).collect();
    let matrix = step.compliance.matrix(&pairs)?;
    let mut state = State::new(step, start);
    let (mut count, mut applications) = (0, 0);
    loop {
        if state.residual <= settings.tolerance {
            // Once more without what the sweeps have rounded.
            applications += 1;
            let displacement = step.compliance.apply(&state.solution.traction);
            state = state.with(Solution { displacement, ..state.solution.clone() }, step);
        }
        if state.residual <= settings.tolerance || count >= settings.max_iterations {
            let status = state.status(settings.tolerance, step);
            return Some(state.finish(status, count, applications));
        }
        count += 1;
        applications += 1;
        let mut solution = state.solution.clone();
        go_through(&mut solution, &matrix, step, count % 2 == 1);
        state = state.with(solution, step);
        if let Control::Load(load) = step.control {
            state = meet(load, state, step);
        }
    }
}

/// Goes once through all pairs.
fn go_through(solution: &mut Solution, matrix: &Mat<f64>, step: &Step<'_>, forwards: bool) {
    let pairs = step.gap.len();
    let moved = step.frame.moved(APPROACH.map(|component| solution.approach * component));
    let own = |direction: usize, pair: usize| {
        let place = direction * pairs + pair;
        matrix[(place, place)]
    };
    let Solution { traction, displacement, .. } = solution;
    for index in 0..pairs {
        let pair = if forwards { index } else { pairs - 1 - index };
        let gap = step.gap[pair] + moved.n[pair] - displacement.n[pair];
        let pressure = (-traction.n[pair] - gap / own(2, pair)).max(0.0);
        add(displacement, matrix, (2, pair), -pressure - traction.n[pair]);
        traction.n[pair] = -pressure;
        let slip = [
            step.rigid[0][pair] + moved.t1[pair] - displacement.t1[pair],
            step.rigid[1][pair] + moved.t2[pair] - displacement.t2[pair],
        ];
        let stiffest = own(0, pair).max(own(1, pair));
        let before = [traction.t1[pair], traction.t2[pair]];
        let augmented = [0, 1].map(|axis| before[axis] + slip[axis] / stiffest);
        let [x, y] = onto_disc(augmented, step.friction.limit(pressure));
        add(displacement, matrix, (0, pair), x - before[0]);
        add(displacement, matrix, (1, pair), y - before[1]);
        (traction.t1[pair], traction.t2[pair]) = (x, y);
    }
}

/// Adds what a change of the traction (Pa) of a pair along one direction does to all displacements.
fn add(
    displacement: &mut VectorField,
    matrix: &Mat<f64>,
    (direction, pair): (usize, usize),
    change: f64,
) {
    if change == 0.0 {
        return;
    }
    let pairs = displacement.n.len();
    let column = matrix.col_as_slice(direction * pairs + pair);
    let VectorField { t1, t2, n } = displacement;
    for (part, column) in [t1, t2, n].into_iter().zip(column.chunks_exact(pairs)) {
        part.iter_mut().zip(column).for_each(|(sum, own)| *sum += change * own);
    }
}

/// Scales the tractions to a load, with the approach at which the gaps are zero in the mean over the pressures.
fn meet(load: f64, state: State, step: &Step<'_>) -> State {
    let mut solution = state.solution.clone();
    let factor = -load / step.frame.force(&solution.traction)[2];
    if !factor.is_finite() {
        return state;
    }
    for field in [&mut solution.traction, &mut solution.displacement] {
        for part in [&mut field.t1, &mut field.t2, &mut field.n] {
            update(part, [], |value, []| factor * value);
        }
    }
    let scaled = state.with(solution, step);
    let opening = step.frame.moved(APPROACH).n;
    let weight = step.frame.measure().weight;
    let [work, pressed] = sum_with(
        [weight],
        [&scaled.solution.traction.n, &scaled.gap, &opening],
        |[weight], [n, gap, opening]| [weight * n * gap, weight * n * opening],
    );
    let mut solution = scaled.solution.clone();
    solution.approach -= work / pressed;
    scaled.with(solution, step)
}
