//! Large matrices, on pages that the threads which fill them touch first.
//!
//! Memory from the allocator is cleared by the thread that asks for it, in pages of 4 KiB. Here pages come as large as
//! the system gives them, cleared when they are first written to. What a process pays for pages it has not had before
//! is up to the system, and on a virtual machine no less than for small ones.

use std::fmt;
use std::marker::PhantomData;

use faer::{MatMut, MatRef};
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

/// Memory that the system does not give.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the system has no {} MB of memory for a matrix", .bytes / 1_000_000)]
pub struct NoMemory {
    /// What was asked for.
    pub bytes: usize,
}

impl<T: Pod> Large<T> {
    /// A matrix of zeros.
    ///
    /// # Errors
    /// If the system does not give the memory.
    pub fn zeros(rows: usize, columns: usize) -> Result<Self, NoMemory> {
        let bytes = rows.saturating_mul(columns).saturating_mul(size_of::<T>());
        let memory = MmapMut::map_anon(bytes).map_err(|_| NoMemory { bytes })?;
        // Where the system has no large pages, small ones do.
        #[cfg(target_os = "linux")]
        memory.advise(memmap2::Advice::HugePage).ok();
        Ok(Self { memory, rows, columns, element: PhantomData })
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

#[cfg(test)]
mod tests {
    use super::Large;

    #[test]
    fn values_stand_column_by_column() {
        let mut large = Large::<f64>::zeros(3, 2).unwrap();
        large.as_mut()[(2, 1)] = 5.0;
        assert_eq!(large.values(), [0.0, 0.0, 0.0, 0.0, 0.0, 5.0]);
        assert_eq!((large.nrows(), large.as_ref()[(2, 1)]), (3, 5.0));
        assert!(Large::<f64>::zeros(0, 4).unwrap().values().is_empty());
        let too_large = Large::<f64>::zeros(usize::MAX / 64, 4).map(|_| ()).unwrap_err();
        assert!(too_large.to_string().contains("no 9223372036854 MB"));
    }
}
