//! Half-spaces shifted against each other: the tangential compliance itself.

use super::{HalfSpace, WholeOrPart};
use crate::compliance::{Coarser, PairStatus, SlipMap, slip::precondition_by_share};
use crate::frame::Part;

/// The tangential compliance of half-spaces.
#[derive(Debug)]
pub(super) struct Shifting<'a> {
    half_space: WholeOrPart<'a>,
    own: f64,
}

impl<'a> Shifting<'a> {
    pub fn new(half_space: &'a HalfSpace) -> Self {
        Self::on(WholeOrPart::Whole(half_space))
    }

    fn on(half_space: WholeOrPart<'a>) -> Self {
        let own = half_space.influence.tangential_self_term();
        Self { half_space, own }
    }
}

impl SlipMap for Shifting<'_> {
    fn apply(&self, tractions: [&[f64]; 2], slip: [&mut [f64]; 2]) {
        self.half_space.convolution.apply_pair(self.half_space.tangential(), tractions, slip);
    }

    fn own(&self) -> f64 {
        self.own
    }

    /// Division by the spectrum of a frame that repeats itself, as in the normal problem, where the
    /// compliance governs.
    fn precondition(&self, slip: [&[f64]; 2], status: &[PairStatus], tractions: [&mut [f64]; 2]) {
        let (convolution, inverse) = self.half_space.tangential_inverse();
        precondition_by_share(self.own, slip, status, tractions, |slip, tractions| {
            convolution.apply_pair(inverse.each_ref(), slip, tractions);
        });
    }

    fn within(&self, part: &Part) -> Option<Box<dyn SlipMap + '_>> {
        Some(Box::new(Self::on(WholeOrPart::Part(self.half_space.part(part.size())))))
    }

    fn coarser(&self) -> Option<Coarser<'_>> {
        let coarser = self.half_space.on_coarser();
        let elements = coarser.influence.elements();
        Some(Coarser { map: Box::new(Shifting::new(coarser)), elements, slip: 1.0 })
    }
}
