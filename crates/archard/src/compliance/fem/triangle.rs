//! Functions on a triangle of six nodes, and where to integrate them.

use glam::DVec3;

/// A point of a rule on a triangle: values of the functions of its six nodes, of the cubic functions of its three edges, odd and with
/// their first end, and of its middle; what the functions of the nodes rise by along its first two edges; and the weight.
pub(super) struct Point {
    pub nodes: [f64; 6],
    pub edges: [f64; 3],
    pub middle: f64,
    slopes: [[f64; 2]; 6],
    pub weight: f64,
}

/// Points of a rule that is exact for polynomials of degree four (D. A. Dunavant, Int. J. Numer. Methods Eng. 21 (1985), 1129).
pub(super) fn points() -> Vec<Point> {
    let rule = [
        (0.445_948_490_915_965, 0.223_381_589_678_011),
        (0.091_576_213_509_771, 0.109_951_743_655_322),
    ];
    let point = |(share, weight): (f64, f64), corner: usize| {
        let mut at = [share; 3];
        at[corner] = 1.0 - 2.0 * share;
        Point::new(at, 0.5 * weight)
    };
    rule.into_iter().flat_map(|one| (0..3).map(move |corner| point(one, corner))).collect()
}

impl Point {
    fn new(at: [f64; 3], weight: f64) -> Self {
        let along = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];
        let ends = |edge: usize| [edge, (edge + 1) % 3];
        let mut nodes = [0.0; 6];
        let mut slopes = [[0.0; 2]; 6];
        let mut edges = [0.0; 3];
        for corner in 0..3 {
            nodes[corner] = at[corner] * (2.0 * at[corner] - 1.0);
            slopes[corner] = along[corner].map(|slope| (4.0 * at[corner] - 1.0) * slope);
            let [one, other] = ends(corner);
            nodes[3 + corner] = 4.0 * at[one] * at[other];
            slopes[3 + corner] = [0, 1]
                .map(|axis| 4.0 * (at[one] * along[other][axis] + at[other] * along[one][axis]));
            edges[corner] = at[one] * at[other] * (at[one] - at[other]);
        }
        Self { nodes, edges, middle: at.iter().product(), slopes, weight }
    }

    /// The functions at a place by its three coordinates.
    pub fn at(at: [f64; 3]) -> Self {
        Self::new(at, 0.0)
    }

    /// Its last two coordinates: the functions of nodes add up to them.
    pub fn place(&self) -> [f64; 2] {
        let own = &self.nodes;
        [own[1] + 0.5 * (own[3] + own[4]), own[2] + 0.5 * (own[4] + own[5])]
    }

    /// Its place (m) on a triangle with nodes at these places (m), and the outward normal there, as long as the area (m^2) that it
    /// stands for.
    pub fn on(&self, places: &[DVec3; 6]) -> [DVec3; 2] {
        let sum = |weights: &dyn Fn(usize) -> f64| {
            places.iter().enumerate().map(|(node, place)| weights(node) * *place).sum::<DVec3>()
        };
        let [one, other] = [0, 1].map(|axis| sum(&|node| self.slopes[node][axis]));
        [sum(&|node| self.nodes[node]), self.weight * one.cross(other)]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use glam::DVec3;

    use super::points;

    /// On a plane triangle the rule gives its area, its middle and what cubic functions are by hand.
    #[test]
    fn integrals_over_a_plane_triangle_are_known() {
        let [a, b, c] = [DVec3::ZERO, 2.0 * DVec3::X, 3.0 * DVec3::Y];
        let places = [a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)];
        let (mut area, mut middle) = (DVec3::ZERO, DVec3::ZERO);
        let (mut bubble, mut edge) = (0.0, DVec3::ZERO);
        for point in points() {
            let [place, normal] = point.on(&places);
            area += normal;
            middle += normal.z * place;
            bubble += normal.z * point.middle;
            edge += normal.z * point.edges[0] * place;
            assert_relative_eq!(point.nodes.iter().sum::<f64>(), 1.0, max_relative = 1e-12);
        }
        assert!(area.abs_diff_eq(3.0 * DVec3::Z, 1e-12));
        assert!(middle.abs_diff_eq(3.0 * (a + b + c) / 3.0, 1e-12));
        // 2 A i! j! k! / (i + j + k + 2)!
        assert_relative_eq!(bubble, 6.0 / 120.0, max_relative = 1e-12);
        // ab (a - b) b: 2 A (2!2! - 3!) / 6!, times the place of corner b; and with a: the other sign, at zero.
        assert!(edge.abs_diff_eq(6.0 * (4.0 - 6.0) / 720.0 * b, 1e-12), "{edge}");
    }
}
