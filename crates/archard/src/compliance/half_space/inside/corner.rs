//! What even tractions on a rectangle do to a half-space below it, corner by corner.
//!
//! Love, *Phil. Trans. R. Soc. A* 228 (1929) 377; Ahmadi, Keer & Mura, *Int. J. Solids Structures* 19 (1983) 843. A wave
//! exp(i k x) of tractions makes stresses that are polynomials of c = kx/k, s = ky/k and q = k z times E = exp(-q): see [`stress`].
//! Each of these terms has an antiderivative over a rectangle, whose difference over its corners, over 2 pi, is what the
//! rectangle does: with X and Y from a corner to the point and R^2 = X^2 + Y^2 + z^2,
//!
//! ```text
//! E         atan(XY/(zR))                  q c^2 E    z X Y/((X^2 + z^2) R)
//! c^2 E     atan(Y/X) - atan(zY/(XR))      q c s E    -z/R
//! c s E     ln(R + z)                      i q c E    z^2 Y/((X^2 + z^2) R)
//! i c E     asinh(Y/hypot(X, z))           i q c s^2 E  z Y/(R (R + z))
//! i c s^2 E Y/(R + z)
//! ```
//!
//! and the same with x and y exchanged. Those of displacements are integrals of these along z, as in
//! [images](super::super::images).

/// Antiderivatives at a corner, or sums of them: those of stresses, then those of displacements.
///
/// In their order `E`, `c^2 E`, `c s E`, `i c E`, `i s E`, `i c s^2 E`, `i s c^2 E`; times q `c^2`, `s^2`, `c s`, `i c`, `i s`,
/// `i c s^2`, `i s c^2`; over k (m) `c^2`, `s^2`, `c s`, `i c`, `i s`.
pub(super) type Functions = [f64; 19];

/// The antiderivatives at a corner, from which a point is X and Y away and z deep (m). On an edge at z = 0 some are not finite.
pub(super) fn functions([x, y]: [f64; 2], z: f64) -> Functions {
    let (x2, y2) = (x * x + z * z, y * y + z * z);
    let r = (x2 + y * y).sqrt();
    let e = (x * y).atan2(z * r);
    let cc = (x * y).atan2(x * x) - (z * x * y).atan2(x * x * r);
    let ss = e - cc;
    let cs = (r + z).ln();
    let (ic, is) = ((y / x2.sqrt()).asinh(), (x / y2.sqrt()).asinh());
    let (icss, iscc) = (y / (r + z), x / (r + z));
    let [qcc, qss] = [x2, y2].map(|square| z * x * y / (square * r));
    [
        e,
        cc,
        cs,
        ic,
        is,
        icss,
        iscc,
        qcc,
        qss,
        -z / r,
        z * z * y / (x2 * r),
        z * z * x / (y2 * r),
        z * icss / r,
        z * iscc / r,
        times(x, ic) - z * cc,
        times(y, is) - z * ss,
        r - times(z, cs),
        -x * cc - times(y, cs) - times(z, ic),
        -y * ss - times(x, cs) - times(z, is),
    ]
}

/// The product of a length and a function that grows as the logarithm of lengths, towards whose singularity the product vanishes.
fn times(length: f64, function: f64) -> f64 {
    if length == 0.0 { 0.0 } else { length * function }
}

/// Stresses from unit tractions along x, y and into the solid, in the order xx, yy, zz, xy, xz, yz; tension is positive, z goes into
/// the solid.
pub(super) fn stress(functions: &Functions, poisson: f64) -> [[f64; 6]; 3] {
    let [e, cc, cs, ic, is, icss, iscc, qcc, qss, qcs, qic, qis, qicss, qiscc, ..] = *functions;
    let (ss, n) = (e - cc, 2.0 * poisson);
    let (iccc, isss, qiccc, qisss) = (ic - icss, is - iscc, qic - qicss, qis - qiscc);
    [
        [2.0 * ic - qiccc + n * icss, n * iccc - qicss, qic, is - qiscc - n * iscc, qcc - e, qcs],
        [n * isss - qiscc, 2.0 * is - qisss + n * iscc, qis, ic - qicss - n * icss, qcs, qss - e],
        [qcc - cc - n * ss, qss - ss - n * cc, -(e + qcc + qss), qcs - (1.0 - n) * cs, qic, qis],
    ]
}

/// Displacements along x, y and into the solid, times twice the modulus of shear (m), from the same tractions.
pub(super) fn displacement(functions: &Functions, poisson: f64, z: f64) -> [[f64; 3]; 3] {
    let [e, cc, cs, ic, is, .., ncc, nss, ncs, nic, nis] = *functions;
    let (ss, n, all) = (e - cc, 2.0 * poisson, ncc + nss);
    let [z_cs, z_ic, z_is] = [cs, ic, is].map(|function| times(z, function));
    [
        [2.0 * all - z * cc - n * ncc, -n * ncs - z_cs, -(1.0 - n) * nic - z_ic],
        [-n * ncs - z_cs, 2.0 * all - z * ss - n * nss, -(1.0 - n) * nis - z_is],
        [(1.0 - n) * nic - z_ic, (1.0 - n) * nis - z_is, (2.0 - n) * all + z * e],
    ]
}
