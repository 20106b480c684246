//! What is worn off bodies in all: volumes, sections, masses.

use super::report::Report;
use crate::body::Body;
use crate::frame::Line;
use crate::motion::Passage;

/// A layer is worn off where this part of it is: the rest is rounding.
const THROUGH: f64 = 1.0 - 1e-9;

/// Thickness (m) of all layers of a body that has some.
fn coated(report: &Report<'_>, body: usize) -> Option<f64> {
    Some(report.problem.bodies[body].coated()).filter(|thickness| *thickness > 0.0)
}

/// Volume (m^3) worn off the layers of a body that has some; `None` in rolling.
pub(super) fn layer_volume(report: &Report<'_>, body: usize) -> Option<f64> {
    let coated = coated(report, body)?;
    volume(report, body, |depth| depth.min(coated))
}

/// Area (m^2) where all layers of a body that has some are worn off; `None` in rolling.
pub(super) fn exposed_area(report: &Report<'_>, body: usize) -> Option<f64> {
    let coated = coated(report, body)?;
    volume(report, body, |depth| f64::from(u8::from(depth >= THROUGH * coated)))
}

/// Worn volume (m^3) of a body, of the whole track of one that passes; `None` in rolling.
pub(super) fn worn_volume(report: &Report<'_>, body: usize) -> Option<f64> {
    volume(report, body, |depth| depth)
}

/// What some function of the depth (m) of a body comes to over its surface, the whole track where it passes; `None` in rolling.
fn volume(report: &Report<'_>, body: usize, of: impl Fn(f64) -> f64) -> Option<f64> {
    let Report { problem, state, .. } = report;
    match problem.motion.surfaces[body] {
        Passage::Passes(Some(track)) => Some(track.length * section(report, body, of)?),
        Passage::Passes(None) => None,
        _ => {
            let surface = &state.surfaces[body];
            let of_all = each(&surface.depth, of);
            Some(match surface.grid.swings() {
                Some(_) => problem.frame.area(0) * of_all.iter().sum::<f64>(),
                None => problem.frame.integrate(&of_all),
            })
        }
    }
}

/// Mass (kg) of the worn volume of a body that wears and whose density is known.
pub(super) fn mass_loss(report: &Report<'_>, body: usize) -> Option<f64> {
    let Body { density, wear, .. } = &report.problem.bodies[body];
    wear.as_ref()?;
    Some((*density)? * worn_volume(report, body)?)
}

/// A function of every depth.
fn each(depths: &[f64], of: impl Fn(f64) -> f64) -> Vec<f64> {
    depths.iter().map(|&depth| of(depth)).collect()
}

/// Worn section (m^2) of a body that passes, across the motion; `None` of others.
pub(super) fn worn_section(report: &Report<'_>, body: usize) -> Option<f64> {
    section(report, body, |depth| depth)
}

/// The same of some function of the depth.
fn section(report: &Report<'_>, body: usize, of: impl Fn(f64) -> f64) -> Option<f64> {
    let (frame, motion) = (&report.problem.frame, &report.problem.motion);
    if !motion.surfaces[body].grooves() {
        return None;
    }
    let direction = motion.direction;
    let Ok(flow) = frame.flow(direction) else { return Some(f64::NAN) };
    let images = if frame.mirrored()[1 - direction.axis] { 2.0 } else { 1.0 };
    let worn = each(&report.state.worn(body), of);
    let section = |line: &Line| line.width * line.mean(&worn);
    Some(images * flow.lines().iter().map(section).sum::<f64>())
}

/// Worn volume of a body over the load and the distance (1/Pa), which is k again; `None` without a track.
pub(super) fn wear_rate(report: &Report<'_>, body: usize) -> Option<f64> {
    report.problem.motion.track()?;
    let worked = report.effort.load_distance;
    let volume = worn_volume(report, body)?;
    Some(if worked > 0.0 { volume / worked } else { 0.0 })
}
