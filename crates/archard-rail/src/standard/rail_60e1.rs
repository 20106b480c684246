//! The head of the rail 60E1, formerly UIC 60 (EN 13674-1).
//!
//! Arcs of radius 300 mm over a width of 20.456 mm and 80 mm over 52.053 mm, then 13 mm to sides of slope 20:1, each
//! touching the next. The head is 72 mm wide 14.3 mm below its top: the drawing states it too, and the arcs meet it.

use crate::invalid::Invalid;
use crate::profile::Profile;

/// Radii (mm) from the top outwards.
const RADII: [f64; 3] = [300.0, 80.0, 13.0];
/// Half the widths (mm) at which the first two arcs end.
const HALF_WIDTHS: [f64; 2] = [20.456 / 2.0, 52.053 / 2.0];
/// Depth (mm) below the top at which the sides are left off; the drawing goes on.
const FOOT: f64 = 30.0;

/// Half of the head (mm) as the drawing has it, from the top outwards, y positive.
fn half(step: f64) -> Vec<[f64; 2]> {
    let mut points = vec![[0.0, 0.0]];
    let (mut centre, mut start) = ([0.0, RADII[0]], 0.0f64);
    for (at, radius) in RADII.into_iter().enumerate() {
        if at > 0 {
            let inward = RADII[at - 1] - radius;
            centre = [centre[0] + inward * start.sin(), centre[1] - inward * start.cos()];
        }
        let end = match HALF_WIDTHS.get(at) {
            Some(width) => ((width - centre[0]) / radius).asin(),
            None => 20f64.atan(),
        };
        let arc = super::between(start, end, step / radius).skip(1);
        points.extend(
            arc.map(|angle| [centre[0] + radius * angle.sin(), centre[1] - radius * angle.cos()]),
        );
        start = end;
    }
    let [y, z] = points[points.len() - 1];
    points.extend(super::between(z, FOOT, step).skip(1).map(|down| [y + (down - z) / 20.0, down]));
    points
}

/// The head of the rail 60E1 with points no farther apart than the step (m): upright, its top at the origin, its sides
/// down to 30 mm.
///
/// # Errors
/// If the step does not lie between 0.01 and 1 mm.
pub fn rail_60e1(step: f64) -> Result<Profile, Invalid> {
    let half = half(super::checked(step)? * 1e3);
    let left = half.iter().skip(1).rev().map(|&[y, z]| [-y, z]);
    let points = left.chain(half.iter().copied());
    Profile::new(points.map(|[y, z]| [y * 1e-3, z * 1e-3]).collect())
}
