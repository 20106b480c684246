//! A compliance as a matrix: bodies whose equations were condensed to the pairs.

use std::fmt;

use faer::MatRef;
use pulp::{Arch, Simd, WithSimd};
use rayon::prelude::*;

use super::Compliance;
use super::bem::Balance;
use super::bem::contact::Near;
use crate::frame::{ContactFrame, VectorField};
use crate::numerics::SAME;
use crate::numerics::large::{Large, NoMemory};

/// The compliance of both bodies as one matrix on the tractions along t1, t2 and n.
///
/// An application costs O(N^2) in the number of pairs, and so does the memory.
pub struct Dense {
    pairs: usize,
    /// Columns of the matrix one after the other: along t1 of all pairs, along t2, along n; so the rows.
    columns: Large<f64>,
    normal_self_term: f64,
    tangential_self_term: f64,
    couples: bool,
    balance: Vec<(usize, Balance)>,
    near: Vec<Near>,
}

/// Rows that go through the columns together: as many as a thread has, for memory is read in long runs then, as long
/// as their sums stay in the nearest cache.
const ROWS: (usize, usize) = (128, 2048);
/// Values of the matrix that are worth a thread. A choice of cost.
const WORK: usize = 1 << 21;
/// Columns that are added at once.
const AT_ONCE: usize = 4;

impl fmt::Debug for Dense {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Dense").field("pairs", &self.pairs).finish_non_exhaustive()
    }
}

impl Dense {
    /// The sum of the compliances of bodies that have the same pairs, each with row 3 i + d for the displacement (m) of
    /// pair i along direction d of its basis and column 3 j + e for the traction (Pa) of pair j along e.
    ///
    /// Collocation leaves them a little unsymmetric, by the order of the elements, and they stay so: made symmetric, they would turn an even pressure into tangential displacements that
    /// alternate from node to node.
    ///
    /// # Errors
    /// If there is no memory for it.
    pub(super) fn new(bodies: &[MatRef<'_, f64>]) -> Result<Self, NoMemory> {
        let pairs = bodies.iter().map(|body| body.nrows() / 3).max().unwrap_or_default();
        let mut own = Self::empty(pairs)?;
        own.columns.values_mut().par_chunks_mut(3 * pairs).enumerate().for_each(
            |(column, values)| {
                let (e, j) = (column / pairs, column % pairs);
                for (row, value) in values.iter_mut().enumerate() {
                    let (d, i) = (row / pairs, row % pairs);
                    *value = bodies.iter().map(|body| body[(3 * i + d, 3 * j + e)]).sum();
                }
            },
        );
        Ok(own.filled())
    }

    /// Of so many pairs, nothing known yet.
    ///
    /// # Errors
    /// If there is no memory for it.
    pub(super) fn empty(pairs: usize) -> Result<Self, NoMemory> {
        Ok(Self {
            pairs,
            columns: Large::zeros(3 * pairs, 3 * pairs)?,
            normal_self_term: 0.0,
            tangential_self_term: 0.0,
            couples: true,
            balance: vec![],
            near: vec![],
        })
    }

    /// Puts in the displacements (m), three a pair, under a unit traction (Pa) of a pair along an axis.
    pub(super) fn fill(&mut self, pair: usize, along: usize, displacements: &[f64]) {
        let pairs = self.pairs;
        let column =
            &mut self.columns.values_mut()[(along * pairs + pair) * 3 * pairs..][..3 * pairs];
        for (row, value) in column.iter_mut().enumerate() {
            *value = displacements[3 * (row % pairs) + row / pairs];
        }
    }

    /// The same with what follows from the matrix once it is there.
    #[must_use]
    pub(super) fn filled(mut self) -> Self {
        let Self { pairs, columns, .. } = &self;
        let pairs = *pairs;
        let own = |d: usize| {
            let diagonal =
                (0..pairs).map(|pair| columns.values()[(d * pairs + pair) * (3 * pairs + 1)]);
            diagonal.fold(0.0, f64::max)
        };
        let (normal_self_term, tangential_self_term) = (own(2), own(0).max(own(1)));
        let coupled = |row: usize, column: usize| {
            columns.values()[column * 3 * pairs + row].abs() > SAME * normal_self_term
        };
        let couples = (0..2 * pairs).any(|row| (2 * pairs..3 * pairs).any(|n| coupled(row, n)));
        self.normal_self_term = normal_self_term;
        self.tangential_self_term = tangential_self_term;
        self.couples = couples;
        self
    }

    /// The same with what is left of the balance of the bodies of these indices.
    #[must_use]
    pub(super) fn balanced(self, balance: Vec<(usize, Balance)>) -> Self {
        Self { balance, ..self }
    }

    /// The same with what bodies may be off by where they are loaded.
    #[must_use]
    pub(super) fn judged(self, near: Vec<Near>) -> Self {
        Self { near, ..self }
    }

    /// The displacements that tractions in a range of columns make in a range of rows.
    fn multiply(&self, first_row: usize, first_column: usize, vector: &[f64], image: &mut [f64]) {
        let height = 3 * self.pairs;
        let pressed: Vec<(f64, &[f64])> = vector
            .iter()
            .enumerate()
            .filter(|(_, value)| **value != 0.0)
            .map(|(column, &value)| {
                let start = (first_column + column) * height + first_row;
                (value, &self.columns.values()[start..start + image.len()])
            })
            .collect();
        let arch = Arch::new();
        let alone = pressed.len() * image.len() < WORK;
        let threads = if alone { 1 } else { rayon::current_num_threads() };
        let rows = image.len().div_ceil(threads).next_multiple_of(8).clamp(ROWS.0, ROWS.1);
        let add = |(chunk, sums): (usize, &mut [f64])| {
            sums.fill(0.0);
            arch.dispatch(Columns { columns: &pressed, first: chunk * rows, sums });
        };
        if alone {
            image.chunks_mut(rows).enumerate().for_each(add);
        } else {
            image.par_chunks_mut(rows).enumerate().for_each(add);
        }
    }
}

/// Adds multiples of columns, from one of their rows on.
struct Columns<'a> {
    columns: &'a [(f64, &'a [f64])],
    first: usize,
    sums: &'a mut [f64],
}

impl WithSimd for Columns<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { columns, first, sums } = self;
        let (blocks, rest) = columns.as_chunks::<AT_ONCE>();
        let length = sums.len();
        let (head, tail) = S::as_mut_simd_f64s(sums);
        let split = length - tail.len();
        for block in blocks {
            let factors = block.map(|(factor, _)| simd.splat_f64s(factor));
            let parts = block.map(|(_, values)| &values[first..first + length]);
            let heads = parts.map(|values| S::as_simd_f64s(values).0);
            let [a, b, c, d] = heads.map(|values| &values[..head.len()]);
            for (index, sum) in head.iter_mut().enumerate() {
                let one = simd.mul_add_e_f64s(factors[0], a[index], *sum);
                let two = simd.mul_add_e_f64s(factors[1], b[index], one);
                let three = simd.mul_add_e_f64s(factors[2], c[index], two);
                *sum = simd.mul_add_e_f64s(factors[3], d[index], three);
            }
            for (index, sum) in tail.iter_mut().enumerate() {
                for ((factor, _), values) in block.iter().zip(&parts) {
                    *sum += factor * values[split + index];
                }
            }
        }
        for (factor, values) in rest {
            let values = &values[first..first + length];
            let factors = simd.splat_f64s(*factor);
            for (sum, value) in head.iter_mut().zip(S::as_simd_f64s(values).0) {
                *sum = simd.mul_add_e_f64s(factors, *value, *sum);
            }
            for (sum, value) in tail.iter_mut().zip(&values[split..]) {
                *sum += factor * value;
            }
        }
    }
}

impl Compliance for Dense {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        let vector = tractions.components().concat();
        let mut image = vec![0.0; vector.len()];
        self.multiply(0, 0, &vector, &mut image);
        let n = image.split_off(2 * self.pairs);
        let t2 = image.split_off(self.pairs);
        VectorField { t1: image, t2, n }
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.multiply(2 * self.pairs, 2 * self.pairs, pressure, displacement);
    }

    fn matrix(&self, pairs: &[usize]) -> Option<Vec<f64>> {
        let at = |direction: usize| pairs.iter().map(move |pair| direction * self.pairs + pair);
        let places: Vec<usize> = (0..3).flat_map(at).collect();
        let mut matrix = Vec::with_capacity(places.len() * places.len());
        for &place in &places {
            let from = &self.columns.values()[place * 3 * self.pairs..][..3 * self.pairs];
            matrix.extend(places.iter().map(|&row| from[row]));
        }
        Some(matrix)
    }

    fn normal_self_term(&self) -> f64 {
        self.normal_self_term
    }

    fn tangential_self_term(&self, _: &ContactFrame) -> f64 {
        self.tangential_self_term
    }

    fn couples(&self) -> bool {
        self.couples
    }

    fn balance(&self) -> Vec<(usize, f64, f64)> {
        self.balance.iter().map(|(body, one)| (*body, one.force, one.moment)).collect()
    }

    /// The work that elements of bodies miss, which were made elsewhere.
    fn missed(&self, tractions: &VectorField) -> Option<f64> {
        off(&self.near, &tractions.n, || super::normal_displacement(self, &tractions.n))
    }
}

/// The work of pressures (Pa) that bodies miss where they are loaded, relative to that on all displacements (m); `None` where nothing is
/// loaded or nothing says so.
pub(super) fn off(
    near: &[Near],
    pressure: &[f64],
    displacement: impl Fn() -> Vec<f64>,
) -> Option<f64> {
    let all = near.first()?.work(pressure, &displacement());
    (all > 0.0).then(|| near.iter().map(|one| one.missed(pressure)).sum::<f64>() / all)
}
