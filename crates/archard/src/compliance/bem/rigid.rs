//! Motions of a body without deformation that nothing holds.

use glam::DVec3;

use super::conditions::Conditions;
use super::surface::Surface;
use crate::numerics::SAME;

/// Names of the six motions.
const MODES: [&str; 6] = [
    "displacement along x",
    "displacement along y",
    "displacement along z",
    "rotation about x",
    "rotation about y",
    "rotation about z",
];

/// The motions that supports and planes of symmetry leave free, each named by its largest part.
pub(super) fn free_modes(surface: &Surface, conditions: &Conditions) -> Vec<&'static str> {
    let count = surface.nodes.len() as f64;
    let centre = surface.nodes.iter().sum::<DVec3>() / count;
    let size = surface.nodes.iter().map(|node| node.distance(centre)).fold(0.0, f64::max);
    // Gram matrix of what is held: one term a displacement that is known, one a mirror's own.
    let mut held = [[0.0; 6]; 6];
    let mut hold = |row: [f64; 6]| {
        for (line, value) in held.iter_mut().zip(row) {
            line.iter_mut().zip(row).for_each(|(sum, other)| *sum += value * other / count);
        }
    };
    // Mirrors hold displacements across them and rotations about axes within.
    for (axis, mirrored) in surface.mirrored.into_iter().enumerate() {
        for mode in [axis, 3 + (axis + 1) % 3, 3 + (axis + 2) % 3] {
            let mut row = [0.0; 6];
            row[mode] = if mirrored { count.sqrt() } else { 0.0 };
            hold(row);
        }
    }
    for (node, condition) in surface.nodes.iter().zip(&conditions.nodes) {
        // About the origin where a mirror runs through it.
        let origin = DVec3::new(
            if surface.mirrored[0] { 0.0 } else { centre.x },
            if surface.mirrored[1] { 0.0 } else { centre.y },
            centre.z,
        );
        let arm = (*node - origin) / size;
        for (direction, known) in condition.basis.iter().zip(condition.known) {
            if known.is_some() {
                let turn = arm.cross(*direction);
                hold([direction.x, direction.y, direction.z, turn.x, turn.y, turn.z]);
            }
        }
    }
    left_free(held, SAME)
}

/// The motions that a symmetric matrix of six, by how firmly they are held, leaves free: those held by no more than that.
pub(crate) fn left_free(mut held: [[f64; 6]; 6], least: f64) -> Vec<&'static str> {
    // Elimination with diagonal pivots: what has none left is free.
    let mut open: Vec<usize> = (0..6).collect();
    loop {
        let Some(&pivot) = open
            .iter()
            .max_by(|&&a, &&b| held[a][a].total_cmp(&held[b][b]))
            .filter(|&&pivot| held[pivot][pivot] > least)
        else {
            return open.into_iter().map(|mode| MODES[mode]).collect();
        };
        open.retain(|&mode| mode != pivot);
        let lead = held[pivot];
        for &mode in &open {
            let factor = held[mode][pivot] / lead[pivot];
            held[mode].iter_mut().zip(lead).for_each(|(value, lead)| *value -= factor * lead);
        }
    }
}
