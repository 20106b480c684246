//! One row of numbers a step.

use super::Report;
use crate::frame::VectorField;
use crate::kinematics::{Rolling, Shift};
use crate::problem::{ContactProblem, ContactState, Tangential};

/// The numbers of a step by column, units in the names.
///
/// Depths and volumes are followed by the body's own name. The columns are the same for every step
/// of a run.
pub fn row(report: &Report<'_>) -> Vec<(String, f64)> {
    let Report { problem, state, effort, .. } = report;
    let frame = &problem.frame;
    let area = frame.area_where(|pair| state.pressure[pair] > 0.0);
    let mut row: Vec<(String, f64)> = vec![
        (problem.kinematics.progress().column.to_owned(), state.progress),
        ("load_N".to_owned(), state.load),
        ("approach_m".to_owned(), state.approach),
        ("peak_pressure_Pa".to_owned(), maximum(&state.pressure)),
        ("centre_pressure_Pa".to_owned(), frame.at_centre(&state.pressure)),
        ("contact_area_m2".to_owned(), area),
    ];
    let bodies = || problem.bodies.iter().zip(&state.worn);
    match problem.kinematics.rolling() {
        None => {
            row.extend(bodies().map(|(body, worn)| {
                (format!("worn_volume_{}_m3", body.name), frame.integrate(worn))
            }))
        }
        Some(rolling) => row.extend(bodies().map(|(body, worn)| {
            (format!("worn_section_{}_m2", body.name), section(problem, rolling, worn))
        })),
    }
    row.extend(bodies().map(|(body, worn)| (format!("wear_depth_{}_m", body.name), maximum(worn))));
    row.push(("wear_depth_m".to_owned(), deepest(state)));
    if let (Some(rolling), Some(tangential)) = (problem.kinematics.rolling(), &state.tangential) {
        let rolling = rolling.at(state.progress);
        row.extend(rolling_columns(problem, &rolling, tangential, &state.pressure));
    }
    if let Some(shift) = problem.kinematics.shift()
        && (problem.friction.is_some() || state.tangential.is_some())
    {
        row.extend(shift_columns(report, shift));
    }
    row.push(("iterations".to_owned(), effort.iterations as f64));
    row.push(("residual".to_owned(), effort.residual));
    row.push(("solves".to_owned(), effort.solves as f64));
    row.push(("rejected".to_owned(), effort.rejected as f64));
    row.push(("time_error".to_owned(), effort.time_error.unwrap_or(f64::NAN)));
    row
}

/// Worn section across the direction of rolling (m^2).
pub fn section(problem: &ContactProblem, rolling: &Rolling, worn: &[f64]) -> f64 {
    let frame = &problem.frame;
    let Ok(flow) = frame.flow(rolling.direction) else { return f64::NAN };
    let images = if frame.mirrored()[1 - rolling.direction.axis] { 2.0 } else { 1.0 };
    images * flow.planes().iter().map(|plane| plane.width * plane.mean(worn)).sum::<f64>()
}

/// Creepages, forces on body 1 and what they dissipate.
fn rolling_columns(
    problem: &ContactProblem,
    rolling: &Rolling,
    tangential: &Tangential,
    pressure: &[f64],
) -> Vec<(String, f64)> {
    let [force_x, force_y] = tangential.force(&problem.frame);
    let columns = [
        ("creepage", tangential.creepage[0]),
        ("lateral_creepage", tangential.creepage[1]),
        ("force_x_N", force_x),
        ("force_y_N", force_y),
        ("moment_z_Nm", tangential.moment(&problem.frame)),
        ("stick_area_m2", tangential.stick_area(problem, pressure)),
        ("frictional_power_per_speed_N", tangential.creep_power(problem, rolling)),
    ];
    columns.map(|(column, value)| (column.to_owned(), value)).to_vec()
}

/// Displacements, forces on body 1 and what friction dissipated since the cycle began.
fn shift_columns(report: &Report<'_>, shift: &Shift) -> Vec<(String, f64)> {
    let Report { problem, state, effort, .. } = report;
    let tangential = state.tangential.as_ref();
    let [shift_x, shift_y] = tangential.map_or([0.0; 2], |tangential| tangential.shift);
    let [force_x, force_y] = tangential.map_or([0.0; 2], |own| force(problem, state, own));
    let stick =
        tangential.map_or(0.0, |tangential| tangential.stick_area(problem, &state.pressure));
    let mut columns = vec![
        ("shift_x_m", shift_x),
        ("shift_y_m", shift_y),
        ("force_x_N", force_x),
        ("force_y_N", force_y),
        ("stick_area_m2", stick),
        ("dissipated_J", effort.dissipated[0]),
        ("true_cycles", effort.true_cycles as f64),
    ];
    if problem.kinematics.progress().column != "cycle" {
        columns.insert(0, ("cycle", state.progress / shift.period()));
    }
    columns.into_iter().map(|(column, value)| (column.to_owned(), value)).collect()
}

/// Force on body 1 along x and y (N); on curved frames the pressures have a part in it.
fn force(problem: &ContactProblem, state: &ContactState, tangential: &Tangential) -> [f64; 2] {
    if problem.frame.is_plane() {
        return tangential.force(&problem.frame);
    }
    let [t1, t2] = tangential.traction.clone();
    let n = state.pressure.iter().map(|pressure| -pressure).collect();
    let [x, y, _] = problem.frame.force(&VectorField { t1, t2, n });
    [x, y]
}

/// Deepest total wear (m).
pub fn deepest(state: &ContactState) -> f64 {
    state.worn[0].iter().zip(&state.worn[1]).map(|(a, b)| a + b).fold(0.0, f64::max)
}

/// Largest value, zero at least.
fn maximum(field: &[f64]) -> f64 {
    field.iter().copied().fold(0.0, f64::max)
}
