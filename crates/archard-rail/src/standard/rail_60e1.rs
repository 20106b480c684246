//! The head of the rail 60E1, formerly UIC 60 (EN 13674-1).
//!
//! Arcs of radius 300, 80 and 13 mm touch each other, and the last one touches a side of slope 20:1. It does so 14.3 mm
//! below the top, where the head is 72 mm wide. That leaves nothing free. The centre of the last arc follows from where
//! it ends. The centres of the first and the last arc are the ends of a chain of two links, 300 - 80 and 80 - 13 mm
//! long, whose directions are the normals at which the arcs meet. The first two arcs are then 20.456 and 52.053 mm
//! wide, as the drawing states.

use crate::profile::Profile;
use archard::parameters::Invalid;

/// Radii (mm) from the top outwards.
const RADII: [f64; 3] = [300.0, 80.0, 13.0];
/// y and z (mm) at which the last arc ends on the side.
const SIDE: [f64; 2] = [36.0, 14.3];
/// Depth (mm) below the top at which the sides are left off; the drawing goes on.
const FOOT: f64 = 30.0;

/// Angles (rad) from the vertical of the normals at which the arcs end.
fn ends() -> [f64; 3] {
    let side = 20f64.atan();
    let (long, short) = (RADII[0] - RADII[1], RADII[1] - RADII[2]);
    let across = SIDE[0] - RADII[2] * side.sin();
    let up = RADII[0] - (SIDE[1] + RADII[2] * side.cos());
    let turn = (across.powi(2) + up.powi(2) - long.powi(2) - short.powi(2)) / (2.0 * long * short);
    let turn = turn.acos();
    let first = across.atan2(up) - (short * turn.sin()).atan2(long + short * turn.cos());
    [first, first + turn, side]
}

/// Half of the head (mm) as the drawing has it, from the top outwards, y positive.
fn half(step: f64) -> Vec<[f64; 2]> {
    let mut points = vec![[0.0, 0.0]];
    let (mut centre, mut start) = ([0.0, RADII[0]], 0.0f64);
    for (at, (radius, end)) in RADII.into_iter().zip(ends()).enumerate() {
        if at > 0 {
            let inward = RADII[at - 1] - radius;
            centre = [centre[0] + inward * start.sin(), centre[1] - inward * start.cos()];
        }
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
