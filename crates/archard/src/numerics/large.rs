//! Large matrices, on pages that the threads which fill them touch first.
//!
//! Memory from the allocator is cleared by the thread that asks for it, in pages of 4 KiB. Here pages come as large as
//! the system gives them, cleared when they are first written to. What a process pays for pages it has not had before
//! is up to the system, and on a virtual machine no less than for small ones.

use std::alloc::{Layout, handle_alloc_error};
use std::fmt;
use std::marker::PhantomData;

use faer::traits::RealField;
use faer::{Mat, MatMut, MatRef};
use memmap2::MmapMut;
use pulp::bytemuck::{Pod, cast_slice, cast_slice_mut};

/// A matrix, one column after the other.
pub struct Large<T> {
    memory: MmapMut,
    rows: usize,
    columns: usize,
    element: PhantomData<T>,
}

impl<T> fmt::Debug for Large<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Large")
            .field("rows", &self.rows)
            .field("columns", &self.columns)
            .finish_non_exhaustive()
    }
}

impl<T: Pod> Large<T> {
    /// A matrix of zeros.
    pub fn zeros(rows: usize, columns: usize) -> Self {
        let count = rows.saturating_mul(columns);
        let Ok(memory) = MmapMut::map_anon(count.saturating_mul(size_of::<T>())) else {
            handle_alloc_error(Layout::array::<T>(count).unwrap_or(Layout::new::<T>()))
        };
        // Where the system has no large pages, small ones do.
        #[cfg(target_os = "linux")]
        memory.advise(memmap2::Advice::HugePage).ok();
        Self { memory, rows, columns, element: PhantomData }
    }

    /// Number of rows.
    pub fn nrows(&self) -> usize {
        self.rows
    }

    /// All values, a column after the other.
    pub fn values(&self) -> &[T] {
        cast_slice(&self.memory)
    }

    /// All values, to be written to.
    pub fn values_mut(&mut self) -> &mut [T] {
        cast_slice_mut(&mut self.memory)
    }

    /// The matrix, to be read.
    pub fn as_ref(&self) -> MatRef<'_, T> {
        MatRef::from_column_major_slice(self.values(), self.rows, self.columns)
    }

    /// The matrix, to be written to.
    pub fn as_mut(&mut self) -> MatMut<'_, T> {
        MatMut::from_column_major_slice_mut(
            cast_slice_mut(&mut self.memory),
            self.rows,
            self.columns,
        )
    }
}

impl<T: RealField + Pod> From<Mat<T>> for Large<T> {
    fn from(matrix: Mat<T>) -> Self {
        let mut large = Self::zeros(matrix.nrows(), matrix.ncols());
        large.as_mut().copy_from(&matrix);
        large
    }
}

#[cfg(test)]
mod tests {
    use faer::Mat;

    use super::Large;

    #[test]
    fn values_stand_column_by_column() {
        let mut large = Large::<f64>::zeros(3, 2);
        large.as_mut()[(2, 1)] = 5.0;
        assert_eq!(large.values(), [0.0, 0.0, 0.0, 0.0, 0.0, 5.0]);
        let copy = Large::from(Mat::from_fn(2, 3, |row, column| (10 * row + column) as f32));
        assert_eq!(copy.values(), [0.0, 10.0, 1.0, 11.0, 2.0, 12.0]);
        assert_eq!((copy.nrows(), copy.as_ref()[(1, 2)]), (2, 12.0));
        assert!(Large::<f64>::zeros(0, 4).values().is_empty());
    }
}
