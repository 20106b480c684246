//! The part of the surface that each pair stands for, for pictures.

use glam::DVec3;

use super::host::Host;
use crate::body::Interpolation;

/// Corners (m) of the part of every pair, in the axes of the frame.
pub(super) fn outlines(host: &Host<'_>) -> Vec<Vec<[f64; 3]>> {
    let mut parts: Vec<Vec<[DVec3; 4]>> = vec![vec![]; host.contact.len()];
    let pair_of = host.pair_of();
    for &face in &host.finite.meshed.zone.faces {
        for (node, part) in host.surface.tractions_of(face).zip(host.surface.parts_of(face)) {
            if let Some(pair) = pair_of[node] {
                parts[pair].push(part);
            }
        }
    }
    parts
        .iter()
        .enumerate()
        .map(|(pair, parts)| {
            let outline = match host.finite.interpolation {
                Interpolation::Discontinuous => parts.first().map_or(vec![], |part| part.to_vec()),
                Interpolation::Continuous => around(parts, host.contact[pair].1),
            };
            outline.into_iter().map(|corner| host.in_frame(corner).to_array()).collect()
        })
        .collect()
}

/// The outline of parts that meet at a node, in the order of their angles about it.
fn around(parts: &[[DVec3; 4]], [t1, t2, _]: [DVec3; 3]) -> Vec<DVec3> {
    let Some([node, ..]) = parts.first() else { return vec![] };
    let mut corners: Vec<DVec3> = vec![];
    for corner in parts.iter().flat_map(|[_, rest @ ..]| rest) {
        if corners.iter().all(|known| known.distance(*corner) > 1e-9 * corner.distance(*node)) {
            corners.push(*corner);
        }
    }
    let angle = |corner: &DVec3| (*corner - *node).dot(t2).atan2((*corner - *node).dot(t1));
    corners.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    // At the edge of the zone the node itself is a corner, in the widest gap.
    let count = corners.len();
    if count > 2 * parts.len() {
        let wide = |index: usize| {
            let turn = angle(&corners[(index + 1) % count]) - angle(&corners[index]);
            if turn < 0.0 { turn + std::f64::consts::TAU } else { turn }
        };
        let widest = (0..count).max_by(|&a, &b| wide(a).total_cmp(&wide(b))).unwrap_or(0);
        corners.insert(widest + 1, *node);
    }
    corners
}
