//! Kalker's linear theory: forces of a rolling elliptic contact at creepages so small that it sticks
//! all over.
//!
//! J. J. Kalker, *On the Rolling Contact of Two Elastic Bodies in the Presence of Dry Friction*,
//! thesis, Delft (1967); the table is E.3 of his *Three-Dimensional Elastic Bodies in Rolling
//! Contact* (1990), as printed, also where C11 at a/b = 1/2 and a Poisson ratio of 1/2 is some 0.6 %
//! lower than its neighbours and a numerical solution suggest.
//!
//! For bodies of one material, or of two with nearly the same (1 - 2 nu)/G: 1/G and nu/G are then the
//! means of both.
//!
//! The axes are right-handed: x leads to the leading edge, against the flow of the particles through
//! the contact, and y across. Creepage and spin are those of body 1 over body 2 relative to the speed
//! of rolling; the forces act on body 1 and resist them:
//!
//! ```text
//! Fx = -G a b C11 xi,
//! Fy = -G a b (C22 eta + sqrt(a b) C23 phi),
//! Mz = -G (a b)^(3/2) (sqrt(a b) C33 phi - C23 eta).
//! ```
//!
//! With creepages counted as those of body 2 over body 1 the same forces act on body 2.

/// Kalker's creepage coefficients of an ellipse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// C11: force along the rolling direction by creepage along it.
    pub longitudinal: f64,
    /// C22: force across by creepage across.
    pub lateral: f64,
    /// C23 = -C32: force across by spin, and moment by creepage across.
    pub lateral_spin: f64,
    /// C33: moment by spin.
    pub spin: f64,
}

/// What a contact passes on to body 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resultant {
    /// Forces along the rolling direction and across (N).
    pub force: [f64; 2],
    /// Moment about the normal x cross y, at the centre of the contact (N m).
    pub moment: f64,
}

impl Coefficients {
    /// The coefficients of an ellipse of axis ratio a/b, its a along the rolling direction.
    ///
    /// `None` outside the table: it covers ratios from 1/10 to 10 and Poisson ratios from 0 to 1/2.
    /// Between its values C33 and the inverses of the others are quadratic in the Poisson ratio, which
    /// costs at most 1 % of C33 and 0.1 % of the others, and all are cubic in ln(a/b), logarithms over
    /// logarithms, which costs at most 0.2 %; the table has three digits.
    pub fn at(axis_ratio: f64, poisson: f64) -> Option<Self> {
        if !(0.1..=10.0).contains(&axis_ratio) || !(0.0..=0.5).contains(&poisson) {
            return None;
        }
        let [longitudinal, lateral, lateral_spin, spin] =
            std::array::from_fn(|column| interpolate(column, axis_ratio.ln(), poisson).exp());
        Some(Self { longitudinal, lateral, lateral_spin, spin })
    }

    /// Forces and moment on body 1: shear modulus (Pa), semi-axes along the rolling direction and
    /// across (m), creepages of body 1 over body 2 along and across, and spin of body 1 over body 2
    /// about the normal x cross y over the speed of rolling (1/m).
    ///
    /// Friction sets no limit here; [`super::vermeulen_johnson::force`] does.
    pub fn resultant(
        &self,
        shear_modulus: f64,
        [a, b]: [f64; 2],
        [xi, eta]: [f64; 2],
        spin: f64,
    ) -> Resultant {
        let size = (a * b).sqrt();
        let scale = -shear_modulus * size * size;
        let turn = spin * size;
        Resultant {
            force: [
                scale * self.longitudinal * xi,
                scale * (self.lateral * eta + self.lateral_spin * turn),
            ],
            moment: scale * size * (self.spin * turn - self.lateral_spin * eta),
        }
    }
}

/// ln C of a column of the table at a place ln(a/b), by the cubic between two of its rows that has at
/// each the slope of the parabola through the row and its neighbours.
fn interpolate(column: usize, place: f64, poisson: f64) -> f64 {
    let row = (1..TABLE.len() - 1).filter(|row| log_axis_ratio(*row) <= place).count();
    let point = |row: usize| (log_axis_ratio(row), at_poisson(column, row, poisson).ln());
    let slope = |row: usize| {
        let middle = row.clamp(1, TABLE.len() - 2);
        parabola_slope([middle - 1, middle, middle + 1].map(point), log_axis_ratio(row))
    };
    let ((left, start), (right, end)) = (point(row), point(row + 1));
    let width = right - left;
    let s = (place - left) / width;
    let bend = s * (1.0 - s) * width * ((1.0 - s) * slope(row) - s * slope(row + 1));
    (1.0 - s).powi(2) * (1.0 + 2.0 * s) * start + s * s * (3.0 - 2.0 * s) * end + bend
}

/// A coefficient in a row of the table.
fn at_poisson(column: usize, row: usize, poisson: f64) -> f64 {
    let given = TABLE[row][column];
    if column == SPIN {
        quadratic(given, poisson)
    } else {
        1.0 / quadratic(given.map(f64::recip), poisson)
    }
}

/// The quadratic through values at Poisson ratios 0, 1/4 and 1/2.
fn quadratic([first, second, third]: [f64; 3], poisson: f64) -> f64 {
    let steps = 4.0 * poisson;
    let curvature = 0.5 * (first - 2.0 * second + third);
    first + steps * (second - first + (steps - 1.0) * curvature)
}

/// The slope at a place of the parabola through three points.
fn parabola_slope([(x0, f0), (x1, f1), (x2, f2)]: [(f64, f64); 3], place: f64) -> f64 {
    let (rise, next) = ((f1 - f0) / (x1 - x0), (f2 - f1) / (x2 - x1));
    rise + (next - rise) / (x2 - x0) * (2.0 * place - x0 - x1)
}

/// ln(a/b) of a row: a/b = 0.1 to 1, then b/a = 0.9 to 0.1.
fn log_axis_ratio(row: usize) -> f64 {
    let tenths = if row < 10 { row + 1 } else { 19 - row };
    let share = (tenths as f64 / 10.0).ln();
    if row < 10 { share } else { -share }
}

/// The column of C33.
const SPIN: usize = 3;

/// C11, C22, C23 and C33, each at Poisson ratios 0, 1/4 and 1/2.
#[rustfmt::skip]
#[expect(clippy::approx_constant, reason = "a coefficient of 3.14 is not pi")]
const TABLE: [[[f64; 3]; 4]; 19] = [
    [[2.51, 3.31, 4.85], [2.51, 2.52, 2.53], [0.334, 0.473, 0.731], [6.42, 8.28, 11.7]],
    [[2.59, 3.37, 4.81], [2.59, 2.63, 2.66], [0.483, 0.603, 0.809], [3.46, 4.27, 5.66]],
    [[2.68, 3.44, 4.80], [2.68, 2.75, 2.81], [0.607, 0.715, 0.889], [2.49, 2.96, 3.72]],
    [[2.78, 3.53, 4.82], [2.78, 2.88, 2.98], [0.720, 0.823, 0.977], [2.02, 2.32, 2.77]],
    [[2.88, 3.62, 4.83], [2.88, 3.01, 3.14], [0.827, 0.929, 1.07], [1.74, 1.93, 2.22]],
    [[2.98, 3.72, 4.91], [2.98, 3.14, 3.31], [0.930, 1.03, 1.18], [1.56, 1.68, 1.86]],
    [[3.09, 3.81, 4.97], [3.09, 3.28, 3.48], [1.03, 1.14, 1.29], [1.43, 1.50, 1.60]],
    [[3.19, 3.91, 5.05], [3.19, 3.41, 3.65], [1.13, 1.25, 1.40], [1.34, 1.37, 1.42]],
    [[3.29, 4.01, 5.12], [3.29, 3.54, 3.82], [1.23, 1.36, 1.51], [1.27, 1.27, 1.27]],
    [[3.40, 4.12, 5.20], [3.40, 3.67, 3.98], [1.33, 1.47, 1.63], [1.21, 1.19, 1.16]],
    [[3.51, 4.22, 5.30], [3.51, 3.81, 4.16], [1.44, 1.59, 1.77], [1.16, 1.11, 1.06]],
    [[3.65, 4.36, 5.42], [3.65, 3.99, 4.39], [1.58, 1.75, 1.94], [1.10, 1.04, 0.954]],
    [[3.82, 4.54, 5.58], [3.82, 4.21, 4.67], [1.76, 1.95, 2.18], [1.05, 0.965, 0.852]],
    [[4.06, 4.78, 5.80], [4.06, 4.50, 5.04], [2.01, 2.23, 2.50], [1.01, 0.892, 0.751]],
    [[4.37, 5.10, 6.11], [4.37, 4.90, 5.56], [2.35, 2.62, 2.96], [0.958, 0.819, 0.650]],
    [[4.84, 5.57, 6.57], [4.84, 5.48, 6.31], [2.88, 3.24, 3.70], [0.912, 0.747, 0.549]],
    [[5.57, 6.34, 7.34], [5.57, 6.40, 7.51], [3.79, 4.32, 5.01], [0.868, 0.674, 0.446]],
    [[6.96, 7.78, 8.82], [6.96, 8.14, 9.79], [5.72, 6.63, 7.89], [0.828, 0.601, 0.341]],
    [[10.7, 11.7, 12.9], [10.7, 12.8, 16.0], [12.2, 14.6, 18.0], [0.795, 0.526, 0.228]],
];

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use super::{Coefficients, TABLE, log_axis_ratio};

    fn coefficients(axis_ratio: f64, poisson: f64) -> [f64; 4] {
        let found = Coefficients::at(axis_ratio, poisson).unwrap();
        [found.longitudinal, found.lateral, found.lateral_spin, found.spin]
    }

    /// Reference values: the circle and a/b = 1/2 at a Poisson ratio of 1/4.
    #[test]
    fn rows_of_the_table() {
        for (axis_ratio, printed) in [(1.0, [4.12, 3.67, 1.47]), (0.5, [3.62, 3.01, 0.929])] {
            let found = coefficients(axis_ratio, 0.25);
            for (found, printed) in found.into_iter().zip(printed) {
                assert_relative_eq!(found, printed, max_relative = 1e-12);
            }
        }
    }

    /// Independent values: half-spaces that stick all over, collocated on 36 to 66 squared cells with
    /// upwind differences and extrapolated; good for 1 %, their C33 for 1.5 %.
    #[test]
    fn between_the_rows() {
        let solved = [
            (0.14, 0.35, [3.8099, 2.5730, 0.60241, 6.7454]),
            (0.65, 0.3, [3.9557, 3.2455, 1.11089, 1.60935]),
            (1.0, 0.3, [4.2918, 3.7265, 1.49499, 1.17835]),
            (2.2, 0.3, [5.4648, 5.2786, 2.93758, 0.75228]),
            (7.0, 0.3, [9.6605, 10.5595, 10.0014, 0.50740]),
        ];
        for (axis_ratio, poisson, solved) in solved {
            let found = coefficients(axis_ratio, poisson);
            for column in 0..4 {
                let bound = if column == 3 { 0.015 } else { 0.01 };
                assert_relative_eq!(found[column], solved[column], max_relative = bound);
            }
        }
    }

    /// The cubic through the four neighbours of a row, over ln(a/b), at that row.
    fn from_neighbours(row: usize, value: impl Fn(usize) -> f64) -> f64 {
        let neighbours = [row - 2, row - 1, row + 1, row + 2];
        let weight = |at: usize| -> f64 {
            let others = neighbours.iter().filter(|&&other| other != at);
            others
                .map(|&other| {
                    let distance = |row: usize| log_axis_ratio(row) - log_axis_ratio(other);
                    distance(row) / distance(at)
                })
                .product()
        };
        neighbours.iter().map(|&at| weight(at) * value(at)).sum()
    }

    /// Every value but the outermost two of a column against its neighbours: three digits leave 0.7 %.
    #[test]
    fn no_value_stands_out() {
        for row in 2..TABLE.len() - 2 {
            for place in 0..12 {
                let value = |row: usize| TABLE[row][place / 3][place % 3].ln();
                assert_relative_eq!(value(row), from_neighbours(row, value), epsilon = 7.5e-3);
            }
        }
    }

    /// Without Poisson effect both directions are equal.
    #[test]
    fn directions_are_alike_without_a_poisson_ratio() {
        for axis_ratio in [0.1, 0.17, 1.0, 3.0, 10.0] {
            let [longitudinal, lateral, ..] = coefficients(axis_ratio, 0.0);
            assert_relative_eq!(longitudinal, lateral, max_relative = 1e-14);
        }
    }

    /// Limits of an ellipse that is narrow along the rolling direction, plane in every section:
    /// pi^2/(4 (1 - nu)), pi^2/4 and pi^2 b/(16 (1 - nu) a). At a/b = 1/10 they are 5 % off.
    #[test]
    fn narrow_ellipses_roll_like_cylinders() {
        for poisson in [0.0, 0.25, 0.5] {
            let [longitudinal, lateral, _, spin] = coefficients(0.1, poisson);
            let plane = PI * PI / 4.0;
            assert_relative_eq!(longitudinal, plane / (1.0 - poisson), max_relative = 0.05);
            assert_relative_eq!(lateral, plane, max_relative = 0.05);
            assert_relative_eq!(spin, 2.5 * plane / (1.0 - poisson), max_relative = 0.055);
        }
    }

    #[test]
    fn forces_resist_creepage_and_scale_with_the_ellipse() {
        let found = Coefficients::at(0.5, 0.25).unwrap();
        let resultant = found.resultant(80e9, [1e-3, 2e-3], [1e-4, -2e-4], 0.5);
        assert_relative_eq!(resultant.force[0], -80e9 * 2e-6 * 3.62e-4, max_relative = 1e-12);
        let size = 2e-6_f64.sqrt();
        let across = -80e9 * 2e-6 * (-2.0 * 3.01e-4 + 0.929 * size * 0.5);
        assert_relative_eq!(resultant.force[1], across, max_relative = 1e-12);
        let moment = -80e9 * size.powi(3) * (2.0 * 0.929e-4 + 1.93 * size * 0.5);
        assert_relative_eq!(resultant.moment, moment, max_relative = 1e-12);
    }

    #[test]
    fn nothing_outside_the_table() {
        for (axis_ratio, poisson) in [(0.09, 0.3), (11.0, 0.3), (1.0, -0.1), (1.0, 0.6)] {
            assert_eq!(Coefficients::at(axis_ratio, poisson), None);
        }
        assert_eq!(Coefficients::at(f64::NAN, 0.3), None);
        assert!(Coefficients::at(0.1, 0.0).is_some() && Coefficients::at(10.0, 0.5).is_some());
    }
}
