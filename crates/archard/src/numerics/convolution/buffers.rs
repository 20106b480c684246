//! Memory that outlives the transforms it serves.

use std::cell::RefCell;

use rayon::prelude::*;
use realfft::num_complex::Complex64;

/// Work space of a thread, kept between transforms: fresh memory each time would cost the threads
/// more than the transforms of a row.
#[derive(Default)]
pub(super) struct Buffers {
    values: Vec<f64>,
    spectra: Vec<Complex64>,
    scratch: Vec<Complex64>,
}

impl Buffers {
    /// Lends buffers of these lengths, with anything in them.
    pub fn lend(
        [values, spectra, scratch]: [usize; 3],
        work: impl FnOnce(&mut [f64], &mut [Complex64], &mut [Complex64]),
    ) {
        thread_local! {
            static BUFFERS: RefCell<Buffers> = RefCell::default();
        }
        BUFFERS.with_borrow_mut(|own| {
            own.values.resize(values.max(own.values.len()), 0.0);
            own.spectra.resize(spectra.max(own.spectra.len()), Complex64::default());
            own.scratch.resize(scratch.max(own.scratch.len()), Complex64::default());
            work(
                &mut own.values[..values],
                &mut own.spectra[..spectra],
                &mut own.scratch[..scratch],
            );
        });
    }
}

/// Brings a work space to a length at least; the threads touch fresh memory together.
pub(super) fn grow(space: &mut Vec<Complex64>, length: usize) {
    if space.len() < length {
        *space =
            (0..length).into_par_iter().with_min_len(4096).map(|_| Complex64::default()).collect();
    }
}
