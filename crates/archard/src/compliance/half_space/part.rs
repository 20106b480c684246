//! The half-spaces of a frame, or of a part of it, as one compliance.

use std::ops::Deref;
use std::sync::Arc;

use super::HalfSpace;
use crate::compliance::{Compliance, Preconditioner};
use crate::frame::VectorField;

/// Half-spaces of the whole frame, or of a part of it.
#[derive(Debug)]
pub(super) enum WholeOrPart<'a> {
    Whole(&'a HalfSpace),
    Part(Arc<HalfSpace>),
}

impl Deref for WholeOrPart<'_> {
    type Target = HalfSpace;

    fn deref(&self) -> &HalfSpace {
        match self {
            WholeOrPart::Whole(half_space) => half_space,
            WholeOrPart::Part(half_space) => half_space,
        }
    }
}

impl Compliance for WholeOrPart<'_> {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        (**self).apply(tractions)
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        (**self).apply_normal(pressure, displacement);
    }

    fn normal_self_term(&self) -> f64 {
        (**self).normal_self_term()
    }

    fn couples(&self) -> bool {
        (**self).couples()
    }

    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        (**self).normal_preconditioner(addition)
    }
}
