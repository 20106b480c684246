//! The smoothing cubic spline (Reinsch 1967): of all curves f the one with the least
//! sum of w |x - f|^2 + (L/2 pi)^4 times the integral of |f''|^2.
//!
//! With w half the distance to the two neighbours the sum is an integral, and a wave of length l keeps 1/(1 + (L/l)^4)
//! of its height however dense the points are. The second derivatives g at the inner nodes solve
//! (R + k Q' W^-1 Q) g = Q' x, with k = (L/2 pi)^4, Q' x the differences of slopes and R the tridiagonal matrix of the
//! natural spline; then f = x - k W^-1 Q g.

use std::f64::consts::TAU;

use super::Cubic;

/// The cubics between those nodes; at both ends the second derivative is zero.
pub(super) fn cubics(nodes: &[f64], points: &[[f64; 2]], wavelength: f64) -> Vec<Cubic> {
    let system = System::new(nodes, (wavelength / TAU).powi(4));
    let axes = [0, 1].map(|axis| {
        let values: Vec<f64> = points.iter().map(|point| point[axis]).collect();
        system.solve(&values)
    });
    (0..nodes.len() - 1)
        .map(|at| {
            let width = nodes[at + 1] - nodes[at];
            let [y, z] = [0, 1].map(|axis| axes[axis].cubic(at, width));
            [0, 1, 2, 3].map(|order| [y[order], z[order]])
        })
        .collect()
}

/// Values and second derivatives at the nodes.
struct Fit {
    values: Vec<f64>,
    bends: Vec<f64>,
}

impl Fit {
    fn cubic(&self, at: usize, width: f64) -> [f64; 4] {
        let (value, bend, next) = (self.values[at], self.bends[at], self.bends[at + 1]);
        let slope = (self.values[at + 1] - value) / width - width * (2.0 * bend + next) / 6.0;
        [value, slope, bend / 2.0, (next - bend) / (6.0 * width)]
    }
}

/// The equations of a smoothing spline, which do not depend on the values.
struct System {
    widths: Vec<f64>,
    /// k/w at each node.
    give: Vec<f64>,
    /// The diagonals of R + k Q' W^-1 Q: main, first and second.
    diagonals: [Vec<f64>; 3],
}

impl System {
    fn new(nodes: &[f64], stiffness: f64) -> Self {
        let widths: Vec<f64> = nodes.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let last = nodes.len() - 1;
        let give = (0..=last)
            .map(|at| {
                let before = if at > 0 { widths[at - 1] } else { 0.0 };
                let after = if at < last { widths[at] } else { 0.0 };
                2.0 * stiffness / (before + after)
            })
            .collect();
        let mut system = Self { widths, give, diagonals: [vec![], vec![], vec![]] };
        for row in 1..last {
            for off in 0..3 {
                let entry = system.entry(row, off, last);
                system.diagonals[off].push(entry);
            }
        }
        system
    }

    /// The column of Q that belongs to the inner node `at`: its entries at the node before, there and after.
    fn column(&self, at: usize) -> [f64; 3] {
        let (before, after) = (1.0 / self.widths[at - 1], 1.0 / self.widths[at]);
        [before, -before - after, after]
    }

    fn entry(&self, row: usize, off: usize, last: usize) -> f64 {
        if row + off >= last {
            return 0.0;
        }
        let (a, b) = (self.column(row), self.column(row + off));
        let natural = match off {
            0 => (self.widths[row - 1] + self.widths[row]) / 3.0,
            1 => self.widths[row] / 6.0,
            _ => 0.0,
        };
        let shared = (off..3).map(|at| a[at] * self.give[row - 1 + at] * b[at - off]);
        natural + shared.sum::<f64>()
    }

    fn solve(&self, values: &[f64]) -> Fit {
        let last = values.len() - 1;
        let mut right: Vec<f64> = (1..last)
            .map(|at| {
                // As differences, which keep what the sum of three products would round away.
                let [before, _, after] = self.column(at);
                after * (values[at + 1] - values[at]) - before * (values[at] - values[at - 1])
            })
            .collect();
        self.eliminate(&mut right);
        let mut bends = vec![0.0; last + 1];
        bends[1..last].copy_from_slice(&right);
        let mut values = values.to_vec();
        for at in 1..last {
            let column = self.column(at);
            for (off, entry) in column.into_iter().enumerate() {
                values[at - 1 + off] -= self.give[at - 1 + off] * entry * bends[at];
            }
        }
        Fit { values, bends }
    }

    /// Solves the five-diagonal symmetric system in place, by L D L'.
    fn eliminate(&self, right: &mut [f64]) {
        let count = right.len();
        let [main, first, second] = &self.diagonals;
        let (mut d, mut l1, mut l2) = (vec![0.0; count], vec![0.0; count], vec![0.0; count]);
        for at in 0..count {
            let (mut pivot, mut next) = (main[at], first[at]);
            if at > 0 {
                pivot -= d[at - 1] * l1[at - 1] * l1[at - 1];
                next -= d[at - 1] * l1[at - 1] * l2[at - 1];
                right[at] -= l1[at - 1] * right[at - 1];
            }
            if at > 1 {
                pivot -= d[at - 2] * l2[at - 2] * l2[at - 2];
                right[at] -= l2[at - 2] * right[at - 2];
            }
            d[at] = pivot;
            (l1[at], l2[at]) = (next / pivot, second[at] / pivot);
        }
        for at in (0..count).rev() {
            right[at] /= d[at];
            if at + 1 < count {
                right[at] -= l1[at] * right[at + 1];
            }
            if at + 2 < count {
                right[at] -= l2[at] * right[at + 2];
            }
        }
    }
}
