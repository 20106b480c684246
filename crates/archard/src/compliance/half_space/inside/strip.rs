//! What even tractions on a strip without end do to a half-space below it, edge by edge: plane strain.
//!
//! The terms of [rectangles](super::corner) with waves along x alone, c = 1 or -1: with X from an edge to the point, over pi,
//!
//! ```text
//! E         atan(X/z)          q E      z X/(X^2 + z^2)
//! i sgn E   -ln(X^2 + z^2)/2   i sgn q E  z^2/(X^2 + z^2)
//! E/k       X - X ln(hypot(X, z)) - z atan(X/z)
//! i sgn E/k z ln(hypot(X, z)) - X atan(X/z)
//! ```

/// Antiderivatives at an edge, or sums of them, in the order above.
pub(super) type Functions = [f64; 6];

/// The antiderivatives at an edge, from which a point is X away and z deep (m). On the edge at z = 0 one is not finite.
pub(super) fn functions(x: f64, z: f64) -> Functions {
    let square = x * x + z * z;
    let (e, ln) = (x.atan2(z), 0.5 * square.ln());
    [e, z * x / square, -ln, z * z / square, x - x * ln - z * e, z * ln - x * e]
}

/// Stresses from unit tractions along x, y and into the solid, as those of rectangles.
pub(super) fn stress(functions: &Functions, poisson: f64) -> [[f64; 6]; 3] {
    let [e, q, i, iq, ..] = *functions;
    [
        [2.0 * i - iq, 2.0 * poisson * i, iq, 0.0, q - e, 0.0],
        [0.0, 0.0, 0.0, i, 0.0, -e],
        [q - e, -2.0 * poisson * e, -(e + q), 0.0, iq, 0.0],
    ]
}

/// Displacements times twice the modulus of shear (m), as those of rectangles.
pub(super) fn displacement(functions: &Functions, poisson: f64, z: f64) -> [[f64; 3]; 3] {
    let [e, _, i, _, n, ni] = *functions;
    let far = 1.0 - 2.0 * poisson;
    [
        [(1.0 + far) * n - z * e, 0.0, -far * ni - z * i],
        [0.0, 2.0 * n, 0.0],
        [far * ni - z * i, 0.0, (1.0 + far) * n + z * e],
    ]
}

/// What a traction adds to the displacements (m) per width of a strip, where they are measured from a depth (m) below it.
pub(super) fn from_depth(poisson: f64, depth: f64) -> [f64; 3] {
    let ln = 2.0 * (1.0 - poisson) * depth.ln();
    [ln + 1.0, 2.0 * depth.ln(), ln - 1.0]
}
