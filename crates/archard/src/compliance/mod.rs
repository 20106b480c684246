//! How two bodies deform, seen from the contact frame: one linear map from the tractions of the
//! pairs to their relative displacements.

#[doc(hidden)]
pub mod bem;
mod carried;
mod dense;
#[doc(hidden)]
pub mod fem;
pub mod half_space;
mod image;
mod mapped;
mod slip;
mod worn_lines;

use std::fmt::Debug;
use std::sync::Arc;

use crate::frame::{ContactFrame, Flow, Part, VectorField};

#[doc(hidden)]
pub use crate::numerics::dense::SolveError;
#[doc(hidden)]
pub use crate::numerics::large::NoMemory;
pub use bem::contact::ContactError;
#[doc(hidden)]
pub use bem::{Balance, Indeterminacy};
#[doc(hidden)]
pub use carried::MeshCompliance;
pub use dense::Dense;
pub use half_space::{HalfSpace, Periodic};
#[doc(hidden)]
pub use image::{Ends, Image};
#[doc(hidden)]
pub use mapped::MappedCompliance;
#[doc(hidden)]
pub use slip::Coarser;
pub use slip::{PairStatus, SlipMap};
#[doc(hidden)]
pub use worn_lines::WornLines;

use slip::{Differenced, Direct};

/// A linear map from tractions (Pa) to relative displacements (m) of the pairs.
///
/// It is positive definite, and symmetric in the product of fields weighted by the areas of the pairs, nearly
/// so at least. Tractions act on body 1, and the displacement returned is
/// that of body 1 less that of body 2: the C L of the gap k = k_g + k_o + w n - C L.
pub trait Compliance: Debug + Send + Sync {
    /// Relative displacements (m) under tractions (Pa).
    fn apply(&self, tractions: &VectorField) -> VectorField;

    /// Normal displacement (m) that pressures alone (Pa) press the surfaces apart by, into
    /// `displacement`.
    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        let zeros = vec![0.0; pressure.len()];
        let tractions = VectorField { t1: zeros.clone(), t2: zeros, n: pressure.to_vec() };
        displacement.copy_from_slice(&self.apply(&tractions).n);
    }

    /// What `apply` makes of the tractions of some pairs there, as a matrix (m/Pa), column after column: row by pair
    /// displaced, column by pair drawn, along t1 of all of them, then along t2, then along n. `None` where no matrix is
    /// at hand.
    fn matrix(&self, _pairs: &[usize]) -> Option<Vec<f64>> {
        None
    }

    /// Normal displacement (m) of a pair under a unit pressure (Pa) on it alone, mirror images left out; the
    /// largest of unequal pairs.
    fn normal_self_term(&self) -> f64;

    /// Tangential displacement (m) of a pair under a unit traction (Pa) on it alone, the larger of both
    /// directions; the largest of unequal pairs, by default that of one of the largest pairs.
    fn tangential_self_term(&self, frame: &ContactFrame) -> f64 {
        slip::self_term(|tractions| self.apply(tractions), frame)
    }

    /// Whether the surfaces repeat themselves with the frame, and tractions with them.
    fn repeats(&self) -> bool {
        false
    }

    /// Whether tangential tractions displace the pairs along n, and pressures across it.
    fn couples(&self) -> bool {
        true
    }

    /// What is left of the balance of forces and of moments, relative to the load and to the load times half of the
    /// body's extent, of every body whose equations were solved: its index, 0 or 1, and both, the worst under even
    /// loads. None where no equations are.
    fn balance(&self) -> Vec<(usize, f64, f64)> {
        vec![]
    }

    /// By how much the displacements of pairs under tractions (Pa) may be off because of the compliance itself, relative to the
    /// largest of them, as far as that is known; `None` where only the size of elements counts.
    fn missed(&self, _tractions: &VectorField) -> Option<f64> {
        None
    }

    /// The least normal displacement (m) that what is smooth in it adds at the rim of a uniform frame, and so about as much
    /// beyond, under pressures (Pa).
    fn at_the_rim(&self, _pressure: &[f64]) -> f64 {
        0.0
    }

    /// How tangential tractions change the slip in the passage to each pair; where passages are unequal, in one of
    /// the [mean](Flow::advance) length at the rate of each pair.
    fn rolling<'a>(&'a self, flow: Flow<'a>) -> Box<dyn SlipMap + 'a> {
        Box::new(Differenced::new(self, flow))
    }

    /// How tangential tractions change the slip of bodies that are shifted against each other.
    fn shifting<'a>(&'a self, frame: &'a ContactFrame) -> Box<dyn SlipMap + 'a> {
        Box::new(Direct::new(self, frame))
    }

    /// An approximate inverse of `apply_normal` with `addition` (m/Pa) on its diagonal, for
    /// iterations; positive definite, and symmetric as the compliance is. By default a division by the
    /// diagonal.
    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        Box::new(Diagonal(1.0 / (self.normal_self_term() + addition)))
    }

    /// The same bodies where only the pairs of a part of the frame bear tractions and are displaced; `None` where that
    /// is not possible.
    fn within(&self, _part: &Part) -> Option<Box<dyn Compliance + '_>> {
        None
    }

    /// The same bodies under the elements of another frame, of the same size, for a problem of its own; `None` where that is
    /// not possible.
    fn on(&self, _frame: &ContactFrame) -> Option<Arc<dyn Compliance>> {
        None
    }

    /// The same bodies under elements of twice the size that begin where these do, one more along an axis
    /// with an odd number of them; `None` where that is not possible.
    fn coarser(&self) -> Option<&dyn Compliance> {
        None
    }

    /// Where it has parts: the least normal displacement (m) that a unit pressure (Pa) on a pair makes, apart from what is
    /// [smooth](Self::at_the_rim), of pairs of a
    /// uniform frame that are at most so many elements away along x and y; on pairs that bear no pressure themselves.
    fn least_displacement(&self, _away: [usize; 2]) -> f64 {
        f64::NEG_INFINITY
    }
}

/// Normal displacement (m) that pressures alone (Pa) press the surfaces apart by.
pub(crate) fn normal_displacement(compliance: &dyn Compliance, pressure: &[f64]) -> Vec<f64> {
    let mut displacement = vec![0.0; pressure.len()];
    compliance.apply_normal(pressure, &mut displacement);
    displacement
}

/// A positive definite map from displacements (m) to pressures (Pa), symmetric in the product of fields weighted
/// by the areas of the pairs.
pub trait Preconditioner: Debug {
    /// The contact of what follows: one for each pair in it, zero for others, where displacements are zero too.
    fn keep_to(&mut self, _contact: &[f64]) {}

    /// The pressures that answer to `displacement`, into `pressure`.
    fn apply(&self, displacement: &[f64], pressure: &mut [f64]);
}

/// Multiplication by a constant (Pa/m).
#[derive(Debug)]
struct Diagonal(f64);

impl Preconditioner for Diagonal {
    fn apply(&self, displacement: &[f64], pressure: &mut [f64]) {
        pressure.iter_mut().zip(displacement).for_each(|(p, d)| *p = self.0 * d);
    }
}
