//! Bodies that bear a contact on their own finite elements.
//!
//! Each application solves the equations of these bodies, which were factorised. A matrix of all pairs is made once as much was spent on
//! applications as it takes: whatever a run asks for, it costs at most twice what it had to (R. M. Karp, *On-line algorithms versus
//! off-line algorithms*, IFIP 1992).

use std::fmt;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use faer::{Mat, MatRef};
use glam::DVec3;

use super::bem::contact::Near;
use super::dense::off;
use super::fem::Carrier;
use super::{Balance, Compliance, Dense};
use crate::frame::{ContactFrame, VectorField};
use crate::numerics::large::NoMemory;

/// Pairs whose columns are found at once: enough for products of matrices to be as quick as with all of them.
const AT_ONCE: usize = 64;
/// Columns found at once for the time of a single application, about.
const FOR_ONE: usize = 5;

/// The compliance of bodies, one of them at least with the contact on its own elements.
pub struct MeshCompliance {
    pairs: usize,
    /// Normals of the pairs, where they differ.
    normals: Vec<DVec3>,
    /// What is known of the other body as a matrix.
    rest: Option<Mat<f64>>,
    bodies: Vec<Carrier>,
    balance: Vec<(usize, Balance)>,
    /// What the parts that are known may be off by where they are loaded.
    near: Vec<Near>,
    self_terms: [f64; 2],
    applied: AtomicUsize,
    /// All as one matrix; `None` where there is no memory for it.
    whole: OnceLock<Option<Dense>>,
}

impl fmt::Debug for MeshCompliance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Carried").field("pairs", &self.pairs).finish_non_exhaustive()
    }
}

impl MeshCompliance {
    /// Of bodies that see the same pairs, and of parts that are known: row 3 i + d for the displacement (m) of pair i along direction d
    /// of its basis, column 3 j + e for the traction (Pa) of pair j along e.
    pub(super) fn new(
        frame: &ContactFrame,
        bodies: Vec<Carrier>,
        (parts, balance): (Vec<Mat<f64>>, Vec<(usize, Balance)>),
    ) -> Self {
        let pairs = frame.len();
        let rest = parts.into_iter().reduce(|sum, part| sum + part);
        let normals = (0..pairs).map(|pair| DVec3::from(frame.basis(pair)[2])).collect();
        let largest = (0..pairs).max_by(|a, b| frame.area(*a).total_cmp(&frame.area(*b)));
        let mut own = Self {
            pairs,
            normals,
            rest,
            bodies,
            balance,
            near: vec![],
            self_terms: [0.0; 2],
            applied: AtomicUsize::new(0),
            whole: OnceLock::new(),
        };
        if let Some(largest) = largest {
            let columns = own.columns(&[largest]);
            let at = |along: usize| columns[along][3 * largest + along];
            own.self_terms = [at(0).max(at(1)), at(2)];
        }
        own
    }

    /// The same with what the parts that are known may be off by where they are loaded.
    #[must_use]
    pub(super) fn judged(self, near: Vec<Near>) -> Self {
        Self { near, ..self }
    }

    /// Displacements (m) under a unit traction (Pa) along each axis of some pairs, three a pair, a vector each.
    fn columns(&self, acting: &[usize]) -> Vec<Vec<f64>> {
        let rest = |column: usize| -> Vec<f64> {
            let own = |rest: &Mat<f64>| rest.col(column).iter().copied().collect();
            self.rest.as_ref().map_or_else(|| vec![0.0; 3 * self.pairs], own)
        };
        let mut sum: Vec<Vec<f64>> = acting
            .iter()
            .flat_map(|pair| (0..3).map(move |along| rest(3 * pair + along)))
            .collect();
        for body in &self.bodies {
            for (sum, own) in sum.iter_mut().zip(body.columns(acting)) {
                sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
            }
        }
        sum
    }

    /// All as one matrix, where that was made or is worth it after one more application.
    fn whole(&self) -> Option<&Dense> {
        let applied = self.applied.fetch_add(1, Ordering::Relaxed);
        if let Some(made) = self.whole.get() {
            return made.as_ref();
        }
        if applied * FOR_ONE < 3 * self.pairs { None } else { self.made() }
    }

    fn made(&self) -> Option<&Dense> {
        if let Some(made) = self.whole.get() {
            return made.as_ref();
        }
        // Nobody waits meanwhile: threads that wait for others may come here.
        let made = self.condensed().ok();
        self.whole.get_or_init(|| made).as_ref()
    }

    fn condensed(&self) -> Result<Dense, NoMemory> {
        let mut dense = Dense::empty(self.pairs)?;
        let all: Vec<usize> = (0..self.pairs).collect();
        for acting in all.chunks(AT_ONCE) {
            let columns = self.columns(acting);
            for (place, column) in columns.iter().enumerate() {
                dense.fill(acting[place / 3], place % 3, column);
            }
        }
        Ok(dense.filled())
    }

    /// Tractions or displacements, three a pair.
    fn interleaved(&self, field: &VectorField) -> Vec<f64> {
        let along = field.components();
        (0..self.pairs).flat_map(|pair| along.map(|values| values[pair])).collect()
    }

    fn field(values: &[f64]) -> VectorField {
        let along = |own: usize| values.iter().skip(own).step_by(3).copied().collect();
        VectorField { t1: along(0), t2: along(1), n: along(2) }
    }

    fn solved(&self, tractions: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; tractions.len()];
        if let Some(rest) = &self.rest {
            let acting = MatRef::from_column_major_slice(tractions, tractions.len(), 1);
            let own = rest * acting;
            sum.iter_mut().enumerate().for_each(|(row, sum)| *sum += own[(row, 0)]);
        }
        for body in &self.bodies {
            let own = body.displaced(tractions);
            sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        }
        sum
    }

    /// The largest of some vectors along the axes of pairs (m), three a pair.
    fn largest(values: &[f64], counts: &[bool]) -> f64 {
        let lengths = values.chunks_exact(3).zip(counts).filter(|(_, counts)| **counts);
        let square = |own: &[f64]| own.iter().map(|one| one * one).sum::<f64>();
        lengths.map(|(own, _)| square(own)).fold(0.0, f64::max).sqrt()
    }

    /// Normal displacements (m) but for those of a body moved as a whole, weighed by pressures; three a pair, along the normal alone.
    fn bent(&self, values: &[f64], weights: &[f64]) -> Vec<f64> {
        let normals = |pair: usize| self.normals[pair];
        let mut system = glam::DMat3::ZERO;
        let mut right = DVec3::ZERO;
        for (pair, weight) in weights.iter().enumerate() {
            let n = normals(pair);
            system += *weight * glam::DMat3::from_cols(n.x * n, n.y * n, n.z * n);
            right += *weight * values[3 * pair + 2] * n;
        }
        // Along directions that no normal has nothing is moved.
        let scale = system.x_axis.x + system.y_axis.y + system.z_axis.z;
        let moved =
            (system + crate::numerics::SAME * scale * glam::DMat3::IDENTITY).inverse() * right;
        let along = |pair: usize| values[3 * pair + 2] - moved.dot(normals(pair));
        (0..self.pairs).flat_map(|pair| [0.0, 0.0, along(pair)]).collect()
    }
}

impl Compliance for MeshCompliance {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        match self.whole() {
            Some(whole) => whole.apply(tractions),
            None => Self::field(&self.solved(&self.interleaved(tractions))),
        }
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        if let Some(whole) = self.whole() {
            return whole.apply_normal(pressure, displacement);
        }
        let tractions: Vec<f64> = pressure.iter().flat_map(|one| [0.0, 0.0, *one]).collect();
        let found = self.solved(&tractions);
        displacement.iter_mut().zip(found.chunks_exact(3)).for_each(|(one, own)| *one = own[2]);
    }

    fn matrix(&self, pairs: &[usize]) -> Option<Vec<f64>> {
        let applied = self.applied.fetch_add(3 * pairs.len() / FOR_ONE, Ordering::Relaxed);
        if self.whole.get().is_some() || applied * FOR_ONE + 3 * pairs.len() >= 3 * self.pairs {
            return self.made()?.matrix(pairs);
        }
        let columns = self.columns(pairs);
        let at = |along: usize| (0..pairs.len()).map(move |pair| 3 * pair + along);
        let rows = |along: usize| pairs.iter().map(move |pair| 3 * pair + along);
        let order = (0..3).flat_map(at);
        let of = |column: usize| (0..3).flat_map(rows).map(move |row| (column, row));
        Some(order.flat_map(of).map(|(column, row)| columns[column][row]).collect())
    }

    fn normal_self_term(&self) -> f64 {
        self.self_terms[1]
    }

    fn tangential_self_term(&self, _: &ContactFrame) -> f64 {
        self.self_terms[0]
    }

    fn balance(&self) -> Vec<(usize, f64, f64)> {
        self.balance.iter().map(|(body, one)| (*body, one.force, one.moment)).collect()
    }

    /// What cubic functions would add: to all displacements, and to what the bodies are bent by, whichever is more. Pressures follow
    /// what bends.
    fn missed(&self, tractions: &VectorField) -> Option<f64> {
        let acting = self.interleaved(tractions);
        let loaded: Vec<bool> = tractions.n.iter().map(|pressure| *pressure != 0.0).collect();
        let weights: Vec<f64> = tractions.n.iter().map(|pressure| pressure.abs()).collect();
        let all = self.interleaved(&self.apply(tractions));
        let mut missed = vec![0.0; all.len()];
        for body in &self.bodies {
            let own = body.missed(&acting);
            missed.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        }
        let share = |missed: &[f64], all: &[f64]| {
            let [missed, all] = [missed, all].map(|values| Self::largest(values, &loaded));
            if all > 0.0 { missed / all } else { 0.0 }
        };
        let bent = |values: &[f64]| self.bent(values, &weights);
        let known =
            off(&self.near, &tractions.n, || all.iter().skip(2).step_by(3).copied().collect());
        loaded.contains(&true).then(|| {
            let own = share(&missed, &all).max(share(&bent(&missed), &bent(&all)));
            own + known.unwrap_or(0.0)
        })
    }
}
