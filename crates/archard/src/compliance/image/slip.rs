//! How tangential tractions change the slip on half-spaces with image fields.

use super::term::Term;
use crate::compliance::{Coarser, PairStatus, SlipMap};
use crate::frame::Part;

/// A slip map of half-spaces and what image fields add to it.
#[derive(Debug)]
pub(super) struct Imaged<'a> {
    pub half_space: Box<dyn SlipMap + 'a>,
    pub term: Term,
}

impl SlipMap for Imaged<'_> {
    fn apply(&self, tractions: [&[f64]; 2], [one, two]: [&mut [f64]; 2]) {
        self.half_space.apply(tractions, [&mut *one, &mut *two]);
        let [x, y] = tractions;
        self.term.add([(0, x), (1, y)], [(0, one), (1, two)]);
    }

    fn own(&self) -> f64 {
        self.half_space.own()
    }

    fn precondition(&self, slip: [&[f64]; 2], status: &[PairStatus], tractions: [&mut [f64]; 2]) {
        self.half_space.precondition(slip, status, tractions);
    }

    fn within(&self, part: &Part) -> Option<Box<dyn SlipMap + '_>> {
        let half_space = self.half_space.within(part)?;
        Some(Box::new(Imaged { half_space, term: self.term.within(part) }))
    }

    fn coarser(&self) -> Option<Coarser<'_>> {
        let Coarser { map, elements, slip } = self.half_space.coarser()?;
        let map = Box::new(Imaged { half_space: map, term: self.term.coarser() });
        Some(Coarser { map, elements, slip })
    }
}
