//! Profiles drawn in standards, in metres and in their own coordinates.

mod rail_60e1;
mod wheel_s1002;

pub use rail_60e1::rail_60e1;
pub use wheel_s1002::{wheel_s1002, wheel_s1002_depth};

use archard::parameters::Invalid;

/// The step (m) between the points of a drawn profile, checked.
fn checked(step: f64) -> Result<f64, Invalid> {
    if (1e-5..=1e-3).contains(&step) {
        Ok(step)
    } else {
        Err(Invalid::new("step", format!("{step} m has to lie between 1e-5 and 1e-3 m")))
    }
}

/// Numbers from one to the other, both with them, no farther apart than the step.
fn between(from: f64, to: f64, step: f64) -> impl Iterator<Item = f64> {
    let parts = ((to - from).abs() / step).ceil().max(1.0) as usize;
    (0..=parts).map(move |part| from + (to - from) * part as f64 / parts as f64)
}

#[cfg(test)]
mod tests;
