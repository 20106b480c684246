//! How far the hollow of a round stack moves under a pressure that is a harmonic: layers that are shells of a sphere, or rings in plane
//! strain, bonded to something rigid outside, or to a solid without end around a sphere.
//!
//! With s = ln r, u_r = U Y and the displacement along the surface V grad Y (Y: a harmonic, grad: that of the unit sphere or circle),
//! and P = r sigma_rr / G, Q = r sigma_rt / G, equilibrium reads y' = A y for y = (U, V, P, Q), A constant within a layer. With
//! N = l (l + 1) of a sphere, N = n^2 of a circle, e = nu/(1 - nu), m = (1 - 2 nu)/(2 - 2 nu),
//!
//! ```text
//! sphere:  E = 2 U - N V   U' = m P - e E   V' = V - U + Q   P' = (2 e - 1) P + N Q + (4 e + 2) E
//!                          Q' = -2 Q - e P - (2 e + 1) E + (N - 2) V
//! circle:  E = U - N V     U' = m P - e E   V' = V - U + Q   P' = e P + N Q + 2 (1 + e) E
//!                          Q' = -Q - e P - 2 (1 + e) E
//! ```
//!
//! Compliances are carried from outside in, in steps of exp(-A ds), as those of plane layers are. Nothing depends on the degree l but
//! by N, which is even in l + 1/2, so that a wave number k stands for the degree l = k R - 1/2 (of a circle n = k R), between whole ones
//! as well: l = 0 is the even pressure on a thick shell. As l grows, the plane half-space comes out.

use crate::body::profile::Round;
use crate::body::{Layer, Material};

/// From this k h on nothing is felt of what lies below a depth h, as in plane layers.
const DEEP: f64 = 30.0;
/// Terms of the series of exp(-A ds), whose norm is a few: the next one is below 1e-16 of it.
const TERMS: usize = 40;

type Matrix = [[f64; 4]; 4];

/// The radial displacement (m) under a pressure of 1 Pa that varies with the wave number k (1/m) over a hollow of some radius (m) in
/// layers and what they are bonded to, `None` for something rigid, times k.
pub(super) fn compliance(
    (round, radius): (Round, f64),
    layers: &[Layer],
    base: Option<&Material>,
    k: f64,
) -> f64 {
    let degree = k * radius;
    let number = match round {
        Round::Sphere => degree * degree - 0.25,
        Round::Cylinder => degree * degree,
    };
    // Displacements and tractions along the surface in units that keep the numbers of A of one size.
    let scale = degree.max(1.0);
    // Each with its inner radius, from the hollow outwards; a solid without end is a wall without end.
    let solid = base.map(|material| Layer { material: *material, thickness: f64::INFINITY });
    let walls: Vec<(Layer, f64)> = (layers.iter().copied().chain(solid))
        .scan(radius, |inner, layer| {
            let own = *inner;
            *inner += layer.thickness;
            Some((layer, own))
        })
        .collect();
    let mut below = [[0.0; 2]; 2];
    for (layer, inner) in walls.into_iter().rev() {
        let shear = layer.material.shear_modulus();
        let mut way = (layer.thickness / inner).ln_1p();
        let mut inside = below.map(|row| row.map(|value| value * shear));
        if scale * way > DEEP {
            (inside, way) = ([[0.0; 2]; 2], DEEP / scale);
        }
        let steps = (scale * way).ceil().max(1.0);
        let step = inwards(round, layer.material.poisson, [number, scale], way / steps);
        for _ in 0..steps as usize {
            inside = above(&step, inside);
        }
        below = inside.map(|row| row.map(|value| value / shear));
    }
    -degree * below[0][0]
}

/// exp(-A ds).
fn inwards(round: Round, poisson: f64, [number, scale]: [f64; 2], way: f64) -> Matrix {
    let e = poisson / (1.0 - poisson);
    let m = (1.0 - 2.0 * poisson) / (2.0 * (1.0 - poisson));
    // Rows of U', V', P' and Q'; N V and N Q by the scaled unknowns.
    let n = number / scale;
    let a = match round {
        Round::Sphere => [
            [-2.0 * e, e * n, m, 0.0],
            [-scale, 1.0, 0.0, 1.0],
            [8.0 * e + 4.0, -(4.0 * e + 2.0) * n, 2.0 * e - 1.0, n],
            [-(4.0 * e + 2.0) * scale, (2.0 * e + 1.0) * number + number - 2.0, -e * scale, -2.0],
        ],
        Round::Cylinder => [
            [-e, e * n, m, 0.0],
            [-scale, 1.0, 0.0, 1.0],
            [2.0 * (1.0 + e), -2.0 * (1.0 + e) * n, e, n],
            [-2.0 * (1.0 + e) * scale, 2.0 * (1.0 + e) * number, -e * scale, -1.0],
        ],
    };
    // The state in units of the scale: stresses grow with it as well.
    let unit = [1.0, 1.0, scale, scale];
    let mut term = [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| f64::from(u8::from(i == j))));
    let mut sum = term;
    let step = [0, 1, 2, 3]
        .map(|i: usize| [0, 1, 2, 3].map(|j: usize| -way * a[i][j] * unit[j] / unit[i]));
    for order in 1..TERMS {
        term = product(term, step).map(|row| row.map(|value| value / order as f64));
        sum = [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| sum[i][j] + term[i][j]));
    }
    [0, 1, 2, 3].map(|i: usize| [0, 1, 2, 3].map(|j: usize| sum[i][j] * unit[i] / unit[j]))
}

fn product(one: Matrix, other: Matrix) -> Matrix {
    one.map(|row| [0, 1, 2, 3].map(|j| (0..4).map(|k| row[k] * other[k][j]).sum()))
}

/// The compliance above a step from that below it: (X11 C + X12) (X21 C + X22)^-1.
fn above(step: &Matrix, below: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let carried = |row: usize| -> [f64; 2] {
        [0, 1].map(|j| (0..2).map(|k| step[row][k] * below[k][j]).sum::<f64>() + step[row][2 + j])
    };
    let [[a, b], [c, d]] = [carried(2), carried(3)];
    let determinant = a * d - b * c;
    [carried(0), carried(1)]
        .map(|[x, y]| [(x * d - y * c) / determinant, (y * a - x * b) / determinant])
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::compliance;
    use crate::body::profile::Round;
    use crate::body::{Layer, Material};

    fn layer(thickness: f64, young: f64, poisson: f64) -> Layer {
        Layer { material: Material { young, poisson }, thickness }
    }

    /// Displacement (um/MPa) of a sphere by degree, of a circle by order.
    fn by_degree(round: Round, layers: &[Layer], degree: f64) -> f64 {
        let half = if round == Round::Sphere { 0.5 } else { 0.0 };
        let k = (degree + half) / 14e-3;
        1e12 * compliance((round, 14e-3), layers, None, k) / k
    }

    /// Sums of four powers of r that meet Navier's equation, by another program: four digits.
    #[test]
    fn shells_are_as_by_four_powers() {
        let degrees = [0.0, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 40.0];
        for (poisson, known) in [
            (0.4, [3.8248, 3.9228, 3.9882, 3.9582, 3.5754, 2.2244, 1.1463, 0.58039]),
            (0.46, [2.2635, 2.8461, 3.2473, 3.4176, 3.2701, 2.0941, 1.0779, 0.54517]),
        ] {
            for (degree, known) in degrees.into_iter().zip(known) {
                let found = by_degree(Round::Sphere, &[layer(8e-3, 1e9, poisson)], degree);
                assert_relative_eq!(found, known, max_relative = 1e-4);
            }
        }
    }

    /// Under an even pressure a shell or a ring in a rigid housing is a thick-walled vessel (Lame).
    #[test]
    fn an_even_pressure_is_lames() {
        let (radius, young) = (14e-3, 1e9);
        for poisson in [0.0, 0.3, 0.49] {
            for thickness in [0.1e-3, 3e-3, 40e-3] {
                let ratio: f64 = 1.0 + thickness / radius;
                let squeezed = 1.0 / (1.0 - 2.0 * poisson);
                let sphere = young / radius * (squeezed + 2.0 * ratio.powi(3) / (1.0 + poisson))
                    / (ratio.powi(3) - 1.0);
                let ring = young / (radius * (1.0 + poisson)) * (squeezed + ratio.powi(2))
                    / (ratio.powi(2) - 1.0);
                for (round, known) in [(Round::Sphere, sphere), (Round::Cylinder, ring)] {
                    // A circle has no number at k = 0, and the order counts by its square.
                    let degree = if round == Round::Sphere { 0.0 } else { 1e-6 };
                    let found = by_degree(round, &[layer(thickness, young, poisson)], degree);
                    assert_relative_eq!(found, 1e12 / known, max_relative = 1e-9);
                }
            }
        }
    }

    /// Two layers of one material are one; short waves feel the plane half-space of the uppermost one.
    #[test]
    fn layers_add_up_and_short_waves_see_a_plane() {
        let both = [layer(3e-3, 2e9, 0.35), layer(5e-3, 2e9, 0.35)];
        for round in [Round::Sphere, Round::Cylinder] {
            for degree in [0.2, 0.7, 1.0, 4.0, 30.0, 500.0] {
                let one = by_degree(round, &[layer(8e-3, 2e9, 0.35)], degree);
                assert_relative_eq!(by_degree(round, &both, degree), one, max_relative = 1e-10);
            }
            let k = 1e5 / 14e-3;
            let plane = 2.0 * (1.0 - 0.35 * 0.35) / 2e9;
            let found = compliance((round, 14e-3), &both, None, k);
            assert_relative_eq!(found, plane, max_relative = 1e-5);
        }
    }
}
