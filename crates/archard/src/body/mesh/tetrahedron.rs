//! Functions on a tetrahedron of ten nodes, and where to integrate them.

use glam::{DMat3, DVec3};

/// The edges of a tetrahedron between its corners, in the order of the nodes on them.
pub const EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
/// A place in a tetrahedron: its four barycentric coordinates.
pub type Place = [f64; 4];

/// Points of a rule that is exact for polynomials of degree five, with weights relative to the volume (N. J. Walkington, *Quadrature on
/// simplices of arbitrary dimension*, Carnegie Mellon University 2000).
pub fn points() -> [(Place, f64); 14] {
    const NEAR: f64 = 0.310_885_919_263_300_6;
    const FAR: f64 = 0.092_735_250_310_891_23;
    const BETWEEN: f64 = 0.045_503_704_125_649_65;
    let weights = [0.018_781_320_953_002_64, 0.012_248_840_519_393_658, 0.007_091_003_462_846_911];
    let mut points = [([0.0; 4], 0.0); 14];
    for corner in 0..4 {
        for (kind, share) in [NEAR, FAR].into_iter().enumerate() {
            let mut at = [share; 4];
            at[corner] = 1.0 - 3.0 * share;
            points[2 * corner + kind] = (at, 6.0 * weights[kind]);
        }
    }
    for (index, [one, other]) in EDGES.into_iter().enumerate() {
        let mut at = [BETWEEN; 4];
        (at[one], at[other]) = (0.5 - BETWEEN, 0.5 - BETWEEN);
        points[8 + index] = (at, 6.0 * weights[2]);
    }
    points
}

/// Slopes of the barycentric coordinates along the last three of them, in which a place is written.
const ALONG: [DVec3; 4] = [DVec3::NEG_ONE, DVec3::X, DVec3::Y, DVec3::Z];

/// The ten functions that are one at a node and zero at the others.
pub fn values(at: Place) -> [f64; 10] {
    std::array::from_fn(|node| match node {
        0..4 => at[node] * (2.0 * at[node] - 1.0),
        _ => {
            let [one, other] = EDGES[node - 4];
            4.0 * at[one] * at[other]
        }
    })
}

/// Slopes of the ten functions that are one at a node and zero at the others, along the last three coordinates.
pub fn slopes(at: Place) -> [DVec3; 10] {
    let corner = |corner: usize| (4.0 * at[corner] - 1.0) * ALONG[corner];
    let edge = |[one, other]: [usize; 2]| 4.0 * (at[one] * ALONG[other] + at[other] * ALONG[one]);
    std::array::from_fn(|node| if node < 4 { corner(node) } else { edge(EDGES[node - 4]) })
}

/// Slopes of the ten functions of the next degree: of each edge, odd about its middle and with its first end, and of each side, which
/// lies across from a corner.
pub fn cubic_slopes(at: Place) -> [DVec3; 10] {
    let edge = |[one, other]: [usize; 2]| {
        let [a, b] = [at[one], at[other]];
        b * (2.0 * a - b) * ALONG[one] + a * (a - 2.0 * b) * ALONG[other]
    };
    let side = |corner: usize| {
        let others = (0..4).filter(|&other| other != corner);
        let but = |own: usize| -> f64 {
            others.clone().filter(|&other| other != own).map(|other| at[other]).product()
        };
        others.clone().map(|own| but(own) * ALONG[own]).sum::<DVec3>()
    };
    std::array::from_fn(|index| if index < 6 { edge(EDGES[index]) } else { side(index - 6) })
}

/// What small steps along the last three coordinates are in space, one a column, of a tetrahedron with nodes at these places (m).
pub fn turn(places: &[DVec3; 10], at: Place) -> DMat3 {
    let slopes = slopes(at);
    let along = |axis: usize| {
        places.iter().zip(&slopes).map(|(place, slope)| *place * slope[axis]).sum::<DVec3>()
    };
    let [one, two, three] = [0, 1, 2].map(along);
    DMat3::from_cols(one, two, three)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use glam::DVec3;

    use super::{cubic_slopes, points, slopes, turn, values};

    /// The functions, by which slopes are checked.
    fn all(at: [f64; 4]) -> [f64; 20] {
        std::array::from_fn(|index| match index {
            0..10 => values(at)[index],
            10..16 => {
                let [one, other] = super::EDGES[index - 10];
                at[one] * at[other] * (at[one] - at[other])
            }
            _ => (0..4).filter(|other| *other != index - 16).map(|other| at[other]).product(),
        })
    }

    #[test]
    fn slopes_are_those_of_the_functions() {
        let (at, step) = ([0.1, 0.35, 0.2, 0.35], 1e-6);
        let found = [slopes(at), cubic_slopes(at)].concat();
        for axis in 0..3 {
            let moved = |way: f64| {
                let mut at = at;
                at[axis + 1] += way;
                at[0] -= way;
                all(at)
            };
            let (after, before) = (moved(step), moved(-step));
            for (index, slope) in found.iter().enumerate() {
                let known = (after[index] - before[index]) / (2.0 * step);
                assert!((slope[axis] - known).abs() < 1e-9, "{index} {axis}: {slope} {known}");
            }
        }
    }

    /// The integral of a^i b^j c^k over a tetrahedron is 6 V i! j! k! / (i + j + k + 3)!.
    #[test]
    fn the_rule_is_exact_to_the_fifth_degree() {
        let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
        for [i, j, k] in [[0, 0, 0], [1, 0, 0], [2, 1, 0], [2, 2, 1], [5, 0, 0], [3, 1, 1]] {
            let of = |at: [f64; 4]| at[0].powi(i) * at[1].powi(j) * at[2].powi(k);
            let found: f64 = points().into_iter().map(|(at, weight)| weight * of(at)).sum();
            let known = 6.0 * factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 3);
            assert_relative_eq!(found, known, max_relative = 1e-12);
        }
    }

    #[test]
    fn a_step_in_a_straight_tetrahedron_is_the_same_everywhere() {
        let corners = [DVec3::ZERO, DVec3::X, 2.0 * DVec3::Y, 3.0 * DVec3::Z];
        let places = std::array::from_fn(|node| match node {
            0..4 => corners[node],
            _ => {
                let [one, other] = super::EDGES[node - 4];
                0.5 * (corners[one] + corners[other])
            }
        });
        for (at, _) in points() {
            assert_relative_eq!(turn(&places, at).determinant(), 6.0, max_relative = 1e-12);
        }
    }
}
