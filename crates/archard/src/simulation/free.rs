//! An inner body that is free to move across its load, as a head in a cup: where the hollow is worn to one side it moves there, until the
//! pressures leave no force across the axis of the load.
//!
//! A move s closes the gap at a pair by s . e, with e the part of the outward normal across the axis. The force of the pressures along e
//! is brought to zero by Newton's method with the stiffness of columns, K = sum p^2 / sum p v, where v is what a pair gives way by. A
//! ball tilts its layer in a wave that is long for the layer, in which columns are good: few solves are needed.

use super::effort::Effort;
use super::error::Error;
use super::memory::{History, Increment};
use super::setup::Simulation;
use crate::compliance::Compliance;
use crate::frame::Wrap;
use crate::numerics::vector;

/// Solves for a move before it counts as not found.
const PASSES: usize = 30;
/// The force left across the axis over that along it. A thirtieth of it is left in volumes (see the line `side` of the verdict).
const LEFT: f64 = 1e-4;

impl History {
    /// As [`History::solve_normal`], the inner body moved to where no force is left across the load.
    pub(super) fn solve_free(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        (gap, addition): (&[f64], &[f64]),
        (compliance, wrap): (&dyn Compliance, Wrap),
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let frame = &simulation.problem.frame;
        let normals: Vec<[f64; 3]> =
            (0..frame.len()).map(|pair| wrap.outwards(frame.place(pair))[2]).collect();
        let mut side = self.moved(&normals, gap, addition);
        for _ in 0..PASSES {
            let closed: Vec<f64> = gap
                .iter()
                .zip(&normals)
                .map(|(gap, [x, y, _])| gap - side[0] * x - side[1] * y)
                .collect();
            self.solve_normal(simulation, increment, &closed, addition, compliance, effort)?;
            let pressure = &self.state.pressure;
            let [across, along, stiffness] = balance(&normals, pressure);
            let force = across[0].hypot(across[1]);
            if force <= LEFT * along[0] {
                return Ok(());
            }
            let given =
                vector::map([&self.displacement, addition, pressure], |[up, add, p]| up + add * p);
            let work: f64 = given.iter().zip(pressure).map(|(given, p)| given * p).sum();
            let square: f64 = pressure.iter().map(|p| p * p).sum();
            // Of a shaft nothing gives way along its axis.
            let [xx, mut yy, xy] = stiffness.map(|one| square / work * one);
            if yy == 0.0 {
                yy = xx;
            }
            let determinant = xx * yy - xy * xy;
            side[0] -= (yy * across[0] - xy * across[1]) / determinant;
            side[1] -= (xx * across[1] - xy * across[0]) / determinant;
        }
        let (measure, progress) = (simulation.problem.motion.progress, increment.progress);
        Err(Error::NotConsistent { measure, progress, passes: PASSES })
    }

    /// Where (m) the inner body lies across the axis by the contact as it is: pairs under pressure have no gap.
    fn moved(&self, normals: &[[f64; 3]], gap: &[f64], addition: &[f64]) -> [f64; 2] {
        if self.known.is_some() {
            return [0.0; 2];
        }
        let mut matrix = [[0.0; 3]; 3];
        let mut right = [0.0; 3];
        for (pair, pressure) in self.state.pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
            let open = gap[pair] + self.displacement[pair] + addition[pair] * pressure;
            let normal = normals[pair];
            for i in 0..3 {
                right[i] += normal[i] * open;
                (0..3).for_each(|j| matrix[i][j] += normal[i] * normal[j]);
            }
        }
        if matrix[1][1] == 0.0 {
            matrix[1][1] = 1.0;
        }
        let whole = determinant(matrix);
        let by = |column: usize| {
            let mut other = matrix;
            (0..3).for_each(|row| other[row][column] = right[row]);
            determinant(other) / whole
        };
        let side = [by(0), by(1)];
        if side.iter().all(|one| one.is_finite()) { side } else { [0.0; 2] }
    }
}

/// Sums over all pairs: of the pressures across the axis, along it, and of e e^T over the pairs under pressure (xx, yy, xy).
fn balance(normals: &[[f64; 3]], pressure: &[f64]) -> [[f64; 3]; 3] {
    let mut sums = [[0.0; 3]; 3];
    for ([x, y, z], p) in normals.iter().zip(pressure).filter(|(_, p)| **p > 0.0) {
        for (sum, terms) in
            sums.iter_mut().zip([[p * x, p * y, 0.0], [p * z, 0.0, 0.0], [x * x, y * y, x * y]])
        {
            (0..3).for_each(|i| sum[i] += terms[i]);
        }
    }
    sums
}

fn determinant([a, b, c]: [[f64; 3]; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}
