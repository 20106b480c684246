//! Measures of a stress, or of a path of stresses, without contact: what yields, opens and tires by it.

mod ball;
pub mod criteria;
pub mod planes;

pub use ball::smallest_ball;

/// Components of a symmetric stress (Pa), positive in tension, in the order xx, yy, zz, xy, xz, yz.
pub type Components = [f64; 6];

/// Indentation hardness over yield stress (D. Tabor, *The Hardness of Metals*, 1951).
pub const TABOR: f64 = 2.8;

/// A measure of a stress (Pa), with its name.
pub type Measure = (&'static str, fn(&Components) -> f64);

/// What a stress is judged by.
pub const MEASURES: [Measure; 4] = [
    ("von_mises", von_mises),
    ("shear", shear),
    ("tension", tension),
    ("orthogonal_shear", orthogonal_shear),
];

/// The equivalent stress of von Mises (Pa).
pub fn von_mises(&[xx, yy, zz, xy, xz, yz]: &Components) -> f64 {
    let apart = [xx - yy, yy - zz, zz - xx].iter().map(|value| value * value).sum::<f64>();
    (0.5 * apart + 3.0 * (xy * xy + xz * xz + yz * yz)).sqrt()
}

/// The principal stresses (Pa), the largest first: the roots of the characteristic polynomial by its cosines.
pub fn principal(stress: &Components) -> [f64; 3] {
    let mean = stress[..3].iter().sum::<f64>() / 3.0;
    let [x, y, z] = [0, 1, 2].map(|axis| stress[axis] - mean);
    let [.., xy, xz, yz] = *stress;
    let radius = von_mises(stress) / 3.0;
    if radius == 0.0 {
        return [mean; 3];
    }
    let third = x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz);
    let angle = (third / (2.0 * radius.powi(3))).clamp(-1.0, 1.0).acos() / 3.0;
    let turn = std::f64::consts::TAU / 3.0;
    [0.0, -turn, turn].map(|turned| mean + 2.0 * radius * (angle + turned).cos())
}

/// The largest and the least normal stress (Pa) on planes that stand on the surface.
pub fn along_surface(&[xx, yy, _, xy, ..]: &Components) -> [f64; 2] {
    let (mean, radius) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
    [mean + radius, mean - radius]
}

/// The largest tension (Pa) in any direction; negative under pressure from all sides.
pub fn tension(stress: &Components) -> f64 {
    principal(stress)[0]
}

/// The largest shear (Pa) on any plane: half of what the principal stresses differ by.
pub fn shear(stress: &Components) -> f64 {
    let [first, _, last] = principal(stress);
    0.5 * (first - last)
}

/// The shear (Pa) along the surface, on planes parallel to z = 0.
pub fn orthogonal_shear(&[.., xz, yz]: &Components) -> f64 {
    xz.hypot(yz)
}

#[cfg(test)]
mod tests {
    use super::{Components, principal, shear, tension, von_mises};

    #[test]
    fn principal_stresses_have_the_invariants_of_the_stress() {
        let all: [Components; 4] = [
            [3.0, -1.0, 2.0, 0.5, -0.7, 1.1],
            [1.0, 1.0, 1.0, 0.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 2.0, 0.0, 0.0],
            [-5.0, 4.0, 4.0, 0.0, 0.0, 0.0],
        ];
        for stress in all {
            let [xx, yy, zz, xy, xz, yz] = stress;
            let [a, b, c] = principal(&stress);
            assert!(a >= b && b >= c, "{stress:?}");
            let second = xx * yy + yy * zz + zz * xx - xy * xy - xz * xz - yz * yz;
            let third =
                xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
            for (found, known) in
                [(a + b + c, xx + yy + zz), (a * b + b * c + c * a, second), (a * b * c, third)]
            {
                assert!((found - known).abs() < 1e-6, "{stress:?}: {found} {known}");
            }
        }
        // Tension, and shear alone.
        assert!((von_mises(&[0.0, 3.0, 0.0, 0.0, 0.0, 0.0]) - 3.0).abs() < 1e-15);
        let sheared = [0.0, 0.0, 0.0, 0.0, 2.0, 0.0];
        assert!((von_mises(&sheared) - 2.0 * 3f64.sqrt()).abs() < 1e-15);
        assert!((shear(&sheared) - 2.0).abs() < 1e-12 && (tension(&sheared) - 2.0).abs() < 1e-12);
    }
}
