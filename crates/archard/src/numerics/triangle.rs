//! Triangles in space.

use glam::DVec3;

/// What the corners of a triangle count for at the place nearest to a point (C. Ericson, *Real-Time Collision
/// Detection*, Morgan Kaufmann 2005, section 5.1.5).
pub(crate) fn on_triangle(point: DVec3, [a, b, c]: [DVec3; 3]) -> [f64; 3] {
    let (ab, ac, ap) = (b - a, c - a, point - a);
    let normal = ab.cross(ac);
    let square = normal.length_squared();
    if square > 0.0 {
        let v = ap.cross(ac).dot(normal) / square;
        let w = ab.cross(ap).dot(normal) / square;
        if v >= 0.0 && w >= 0.0 && v + w <= 1.0 {
            return [1.0 - v - w, v, w];
        }
    }
    let edge = |from: usize, to: usize| {
        let corners = [a, b, c];
        let along = corners[to] - corners[from];
        let square = along.length_squared();
        let share = (point - corners[from]).dot(along) / square;
        let share = if square > 0.0 { share.clamp(0.0, 1.0) } else { 0.0 };
        let mut shares = [0.0; 3];
        (shares[from], shares[to]) = (1.0 - share, share);
        (point.distance(corners[from] + share * along), shares)
    };
    let edges = [edge(0, 1), edge(1, 2), edge(2, 0)];
    edges.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).map_or([1.0, 0.0, 0.0], |edge| edge.1)
}

/// Distance of a point from a triangle.
pub fn distance(point: DVec3, corners: [DVec3; 3]) -> f64 {
    let shares = on_triangle(point, corners);
    let nearest: DVec3 =
        shares.into_iter().zip(corners).map(|(share, corner)| share * corner).sum();
    point.distance(nearest)
}

/// The solid angle a triangle fills as seen from the origin, positive from behind (A. Van Oosterom and J.
/// Strackee, *IEEE Transactions on Biomedical Engineering* 30 (1983), 125-126).
pub(crate) fn solid_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let lengths = [a, b, c].map(DVec3::length);
    let volume = a.dot(b.cross(c));
    let sum = lengths[0] * lengths[1] * lengths[2]
        + a.dot(b) * lengths[2]
        + b.dot(c) * lengths[0]
        + c.dot(a) * lengths[1];
    2.0 * volume.atan2(sum)
}
