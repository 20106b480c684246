//! The factors of a sparse matrix that is positive definite, and solutions with them.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SparseColMat;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::{Conj, Mat, MatMut, Side, get_global_parallelism};

use crate::numerics::dense::SolveError;

/// Values that are multiplied and added at once.
const LANES: usize = 8;

/// L of A = L L^T, its rows and columns in another order, in blocks of columns with the same rows.
#[derive(Debug)]
pub(super) struct Factors {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
}

impl Factors {
    /// Of a matrix by its part below the diagonal.
    ///
    /// # Errors
    /// If it is not positive definite, or there is no memory for it.
    pub fn new(matrix: &SparseColMat<usize, f64>) -> Result<Self, SolveError> {
        let singular = || SolveError::Singular { size: matrix.ncols() };
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..CholeskySymbolicParams::default()
        };
        let (side, order) = (Side::Lower, SymmetricOrdering::Amd);
        let symbolic = factorize_symbolic_cholesky(matrix.symbolic(), side, order, params)
            .map_err(|_| singular())?;
        let mut values = vec![0.0; symbolic.len_val()];
        let parallel = get_global_parallelism();
        let needed = symbolic.factorize_numeric_llt_scratch::<f64>(parallel, Default::default());
        let mut memory = MemBuffer::try_new(needed).map_err(|_| singular())?;
        symbolic
            .factorize_numeric_llt(
                &mut values,
                matrix.as_ref(),
                side,
                Default::default(),
                parallel,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .map_err(|_| singular())?;
        Ok(Self { symbolic, values })
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.symbolic.nrows()
    }

    /// Puts solutions in the place of right-hand sides.
    pub fn solve(&self, sides: &mut Mat<f64>) {
        let SymbolicCholeskyRaw::Supernodal(blocks) = self.symbolic.raw() else {
            return self.solve_together(sides.as_mut());
        };
        // Columns by themselves are read at the pace of the memory, several together are multiplied.
        if sides.ncols() >= LANES {
            return self.solve_together(sides.as_mut());
        }
        for column in 0..sides.ncols() {
            let order = self.symbolic.perm().map(|perm| perm.arrays());
            let side = sides.col_as_slice_mut(column);
            let Some((forward, inverse)) = order else {
                self.solve_one(blocks, side);
                continue;
            };
            let mut ordered: Vec<f64> = forward.iter().map(|row| side[*row]).collect();
            self.solve_one(blocks, &mut ordered);
            side.iter_mut().zip(inverse).for_each(|(value, row)| *value = ordered[*row]);
        }
    }

    fn solve_together(&self, sides: MatMut<'_, f64>) {
        let parallel = get_global_parallelism();
        let needed = self.symbolic.solve_in_place_scratch::<f64>(sides.ncols(), parallel);
        let mut memory = MemBuffer::new(needed);
        let stack = MemStack::new(&mut memory);
        let factors = LltRef::new(&self.symbolic, &self.values);
        factors.solve_in_place_with_conj(Conj::No, sides, parallel, stack);
    }

    fn solve_one(&self, blocks: &SymbolicSupernodalCholesky<usize>, side: &mut [f64]) {
        let mut below = vec![];
        // The columns of a block, one after the other, with its own rows first and those of others behind them.
        let block = |index: usize| {
            let first = blocks.supernode_begin()[index];
            let width = blocks.supernode_end()[index] - first;
            let rows = blocks.supernode(index).pattern();
            let values = &self.values[blocks.col_ptr_for_val()[index]..];
            let height = width + rows.len();
            let column = move |own: usize| values[own * height..][..height].split_at(width);
            (first, width, rows, column)
        };
        for index in 0..blocks.n_supernodes() {
            let (first, width, rows, column) = block(index);
            below.clear();
            below.resize(rows.len(), 0.0);
            for own in 0..width {
                let (within, left) = column(own);
                let value = side[first + own] / within[own];
                side[first + own] = value;
                let next = side[first + own + 1..first + width].iter_mut();
                next.zip(&within[own + 1..]).for_each(|(one, factor)| *one -= value * factor);
                below.iter_mut().zip(left).for_each(|(sum, factor)| *sum += value * factor);
            }
            rows.iter().zip(&below).for_each(|(row, sum)| side[*row] -= sum);
        }
        for index in (0..blocks.n_supernodes()).rev() {
            let (first, width, rows, column) = block(index);
            below.clear();
            below.extend(rows.iter().map(|row| side[*row]));
            for own in (0..width).rev() {
                let (within, left) = column(own);
                let later = dot(&within[own + 1..], &side[first + own + 1..first + width]);
                let value = side[first + own] - later - dot(left, &below);
                side[first + own] = value / within[own];
            }
        }
    }
}

/// The product of two vectors, in as many sums as are added at once.
fn dot(one: &[f64], other: &[f64]) -> f64 {
    let (ones, rest) = one.as_chunks::<LANES>();
    let (others, last) = other.as_chunks::<LANES>();
    let mut sums = [0.0; LANES];
    for (one, other) in ones.iter().zip(others) {
        for lane in 0..LANES {
            sums[lane] += one[lane] * other[lane];
        }
    }
    sums.iter().sum::<f64>() + rest.iter().zip(last).map(|(one, other)| one * other).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use faer::Mat;
    use faer::sparse::{SparseColMat, Triplet};

    use super::{Factors, LANES};

    /// Springs between neighbours on a grid and to the ground: solutions meet the equations, one by one and together.
    #[test]
    fn solutions_meet_the_equations() {
        let (n, size) = (17, 17 * 17);
        let mut entries = vec![];
        let mut resists = vec![0.3; size];
        for row in 0..n {
            for column in 0..n {
                let own = column + n * row;
                let near = [(column + 1 < n, own + 1), (row + 1 < n, own + n)];
                for (_, other) in near.into_iter().filter(|(there, _)| *there) {
                    let spring = 1.0 + 0.1 * (own % 7) as f64;
                    entries.push(Triplet::new(other, own, -spring));
                    resists[own] += spring;
                    resists[other] += spring;
                }
            }
        }
        entries.extend((0..size).map(|own| Triplet::new(own, own, resists[own])));
        let matrix = SparseColMat::try_new_from_triplets(size, size, &entries).unwrap();
        let factors = Factors::new(&matrix).unwrap();
        for columns in [1, LANES - 1, LANES + 1] {
            let sides =
                Mat::from_fn(size, columns, |row, column| (row * (column + 2) % 11) as f64 - 5.0);
            let mut found = sides.clone();
            factors.solve(&mut found);
            for column in 0..columns {
                let mut image = vec![0.0; size];
                for entry in &entries {
                    image[entry.row] += entry.val * found[(entry.col, column)];
                    if entry.row != entry.col {
                        image[entry.col] += entry.val * found[(entry.row, column)];
                    }
                }
                for (row, value) in image.iter().enumerate() {
                    assert!((value - sides[(row, column)]).abs() < 1e-10, "{columns} {row}");
                }
            }
        }
    }
}
