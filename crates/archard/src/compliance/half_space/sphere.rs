//! A ball, and the hollow of a sphere, as half-spaces with images.
//!
//! Under a pressure the surface of a sphere of radius R moves along its normal by w_l for each harmonic of degree l. In the chord r = 2 R
//! sin(gamma/2) between two places, the generating function of Legendre's polynomials is the influence of a half-space felt from a depth,
//!
//! ```text
//! sum exp(-(l + 1/2) s) P_l(cos gamma) = R/sqrt(r^2 + d^2)     d = 2 R sinh(s/2)
//! ```
//!
//! so that exponentials which meet (l + 1/2) w_l/R at whole degrees l are images, exactly. Nothing lies between whole degrees: a ball has a
//! pole at l = 1. Its two solutions that are finite at the centre (A. E. H. Love, *A Treatise on the Mathematical Theory of Elasticity*,
//! chapter XI) give
//!
//! ```text
//! w_l = R/(2 G) [2 (1 - nu) l^2 + nu l - (1 - 2 nu)] / [(l - 1) (l^2 + (1 + 2 nu) l + 1 + nu)]
//! ```
//!
//! A harmonic of degree 1 is a force, against which something has to hold the ball. Here it is a body force that is the same in all of the
//! ball: stresses are those of a liquid, -p z/R, and over its centre the surface moves by w_1 = (1 - 2 nu) R/(2 E). Another hold with a
//! force on the axis at the centre, or spread evenly on spheres about it, changes w_1 alone, and a motion w_1 cos(theta) closes gaps as an
//! approach does: pressures do not depend on the hold.

use std::f64::consts::PI;

use super::images::{DEPTHS, Image, ROUND, SAMPLES, WAVES, fit, geometric};
use super::stack::{Stack, half_space};
use crate::body::Material;

/// The images of a ball of some radius (m), and by how much they miss its compliance at most, relative to that of a half-space.
pub(super) fn ball(material: &Material, radius: f64) -> (Vec<Image>, f64) {
    let top = half_space(material)[2];
    let by_degree = |degree: f64| (degree + 0.5) / radius * of_ball(material, radius, degree);
    images(radius, [radius; 2], top, by_degree)
}

/// The images of a stack around a hollow of some radius (m) in the same way.
pub(super) fn hollow(stack: &Stack<'_>, radius: f64) -> (Vec<Image>, f64) {
    let thin = stack.layers.first().map_or(f64::INFINITY, |layer| layer.thickness);
    // What a solid around the hollow feels ends with its radius, that of layers on something rigid with their thickness.
    let reach = if stack.base.is_some() { radius.max(stack.reach()) } else { stack.reach() };
    let by_degree = |degree: f64| stack.compliance((degree + 0.5) / radius)[2];
    images(radius, [thin, reach], stack.top()[2], by_degree)
}

/// Displacement (m) into a ball of some radius (m) under a pressure of 1 Pa that is a harmonic of a whole degree.
fn of_ball(material: &Material, radius: f64, degree: f64) -> f64 {
    let (nu, l) = (material.poisson, degree);
    if l == 1.0 {
        return (1.0 - 2.0 * nu) * radius / (2.0 * material.young);
    }
    let above = 2.0 * (1.0 - nu) * l * l + nu * l - (1.0 - 2.0 * nu);
    let below = (l - 1.0) * (l * l + (1.0 + 2.0 * nu) * l + 1.0 + nu);
    radius / (2.0 * material.shear_modulus()) * above / below
}

/// Images that meet a compliance times the wave number at whole degrees, from a length (m) below which it is that of its top, and by how
/// much they miss it at most, relative to the top.
fn images(
    radius: f64,
    [thin, reach]: [f64; 2],
    top: f64,
    by_degree: impl Fn(f64) -> f64,
) -> (Vec<Image>, f64) {
    let (count, first) = (ROUND.0, (DEPTHS[0] * thin).min(ROUND.1 * radius));
    let ways = geometric(first, DEPTHS[1] * reach, count);
    let highest = DEPTHS[0] * WAVES[1] / first * radius;
    let mut degrees: Vec<f64> = geometric(0.5, highest, SAMPLES * count)
        .into_iter()
        .map(|degree| (degree - 0.5).round())
        .collect();
    degrees.dedup();
    let waves: Vec<f64> = degrees.iter().map(|degree| (degree + 0.5) / radius).collect();
    let wanted: Vec<[f64; 1]> = degrees.iter().map(|degree| [by_degree(*degree) - top]).collect();
    let Some((weights, missed)) = fit((&ways, reach), &waves, (&wanted, None)) else {
        return (vec![], f64::INFINITY);
    };
    let image = |(way, [weight]): (&f64, [f64; 1])| Image {
        depth: 2.0 * radius * (0.5 * way / radius).sinh(),
        scalars: [0.0, 0.0, weight / (2.0 * PI), 0.0],
    };
    (ways.iter().zip(weights).map(image).collect(), missed / top)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use super::{ball, half_space, hollow, of_ball};
    use crate::body::profile::Round;
    use crate::body::{Layer, Material};
    use crate::compliance::half_space::images::Image;
    use crate::compliance::half_space::stack::Stack;
    use crate::numerics::quadrature::{gauss_legendre, legendre_polynomials};

    const RADIUS: f64 = 14e-3;

    fn material(poisson: f64) -> Material {
        Material { young: 210e9, poisson }
    }

    /// The displacement (m) of a harmonic of a degree under 1 Pa: the integral of half-space and images over the sphere. Areas are those of
    /// circles whose radius is the chord.
    fn integrated(images: &[Image], top: f64, degree: usize) -> f64 {
        let terms = gauss_legendre(400).into_iter().map(|(place, weight)| {
            let chord = RADIUS * (1.0 + place);
            let z = 1.0 - 0.5 * (chord / RADIUS).powi(2);
            let polynomial = legendre_polynomials(degree + 1, z)[degree];
            let felt: f64 =
                images.iter().map(|image| image.scalars[2] / chord.hypot(image.depth)).sum();
            weight * RADIUS * 2.0 * PI * chord * (top / (2.0 * PI * chord) + felt) * polynomial
        });
        terms.sum()
    }

    /// Under an even pressure a ball shrinks by p R (1 - 2 nu)/E; under a force it is pressed as a liquid is.
    #[test]
    fn images_of_a_ball_are_its_harmonics() {
        for poisson in [0.0, 0.23, 0.3, 0.45, 0.5] {
            let material = material(poisson);
            let (images, missed) = ball(&material, RADIUS);
            assert!(missed < 1e-4, "{poisson} {missed}");
            let top = half_space(&material)[2];
            let even = RADIUS * (1.0 - 2.0 * poisson) / material.young;
            let known = [even, 0.5 * even]
                .into_iter()
                .chain([2.0, 3.0, 5.0, 20.0].map(|degree| of_ball(&material, RADIUS, degree)));
            for (degree, known) in [0, 1, 2, 3, 5, 20].into_iter().zip(known) {
                let found = integrated(&images, top, degree);
                let unit = top * RADIUS;
                assert!((found - known).abs() < 1e-4 * unit, "{poisson} {degree} {found} {known}");
            }
        }
    }

    /// What decays outwards around a hollow is what decays inwards in a ball at the degree -l - 1, of the other sign.
    #[test]
    fn solids_without_end_mirror_balls() {
        for poisson in [0.0, 0.3, 0.48] {
            let material = material(poisson);
            let stack =
                Stack { layers: &[], base: Some(&material), hollow: Some((Round::Sphere, RADIUS)) };
            for degree in [0.0, 1.0, 2.0, 7.0, 60.0] {
                let k = (degree + 0.5) / RADIUS;
                let mirrored = -of_ball(&material, RADIUS, -degree - 1.0);
                assert_relative_eq!(stack.compliance(k)[2] / k, mirrored, max_relative = 1e-8);
            }
            assert!(hollow(&stack, RADIUS).1 < 1e-4);
        }
    }

    #[test]
    fn images_of_shells_are_their_harmonics() {
        for thickness in [0.3e-3, 4e-3, 28e-3] {
            let layers = [Layer { material: material(0.3), thickness }];
            for base in [None, Some(&Material { young: 10e9, poisson: 0.4 })] {
                let stack = Stack { layers: &layers, base, hollow: Some((Round::Sphere, RADIUS)) };
                let (images, missed) = hollow(&stack, RADIUS);
                assert!(missed < 1e-4, "{thickness} {base:?} {missed}");
                for degree in [0, 1, 4, 12] {
                    let k = (degree as f64 + 0.5) / RADIUS;
                    let (known, top) = (stack.compliance(k)[2] / k, stack.top()[2]);
                    let found = integrated(&images, top, degree);
                    assert_relative_eq!(
                        found,
                        known,
                        max_relative = 1e-3,
                        epsilon = 1e-4 * top * thickness
                    );
                }
            }
        }
    }
}
