//! A run that goes on in a frame twice as wide, with elements twice as large.
//!
//! A scar grows to many times the contact that it began with. Elements that resolve the first contact are more than the
//! scar needs at the end: as many elements, twice as large, hold twice its width. Lines of contact have elements enough, and
//! measure their approach from a depth that depends on the width of the frame.

use std::iter::successors;

use super::setup::Simulation;
use crate::frame::ContactFrame;
use crate::motion::Motion;
use crate::parameters::Invalid;

/// Frames agree to this, relative to their size.
const SAME: f64 = 1e-9;

/// What a run goes on with.
#[non_exhaustive]
#[derive(Debug)]
pub struct Wider {
    /// From which progress on (the motion's own unit).
    pub from: f64,
    /// The same in a frame twice as wide.
    pub simulation: Simulation,
}

impl Simulation {
    /// The same, to go on from a place on (the motion's own unit), once that is passed, in another frame: one about the
    /// same centre with as many elements, all twice as large.
    ///
    /// # Errors
    /// If the frames are others, the bodies do more than slide, or the place is before those of the other one.
    pub fn widened(mut self, from: f64, wider: Self) -> Result<Self, Invalid> {
        let wrong = |message: &str| Err(Invalid::new("doubles", message));
        if !can_widen(&self.problem.motion) {
            return wrong("frames become wider only where bodies slide, and neither swings");
        }
        let [own, other] = [&self, &wider].map(|one| &one.problem.frame);
        if !is_double(own, other) {
            return wrong(
                "the wider frame has as many elements, an even number along both axes, twice as large, about the same centre",
            );
        }
        if wider.wider.as_ref().is_some_and(|next| next.from < from) {
            return wrong("frames become wider in the order of their places");
        }
        self.wider = Some(Box::new(Wider { from, simulation: wider }));
        Ok(self)
    }

    /// What a run begins with, and in order all that it goes on with.
    pub(crate) fn frames(&self) -> impl Iterator<Item = &Self> {
        successors(Some(self), |one| one.wider.as_ref().map(|wider| &wider.simulation))
    }

    /// Does something to what the run begins with, and to all that it goes on with.
    ///
    /// # Errors
    /// The first that comes up.
    pub fn each_frame<E>(
        &mut self,
        change: &mut impl FnMut(&mut Self) -> Result<(), E>,
    ) -> Result<(), E> {
        change(self)?;
        match &mut self.wider {
            Some(wider) => wider.simulation.each_frame(change),
            None => Ok(()),
        }
    }
}

/// Whether a motion can go on in a wider frame: bodies that slide, whose surfaces stay where they are or pass along it.
pub fn can_widen(motion: &Motion) -> bool {
    motion.lever_arm().is_some() && !motion.has_positions()
}

fn is_double(own: &ContactFrame, other: &ContactFrame) -> bool {
    let (from, to, elements) = (own.rectangle(), other.rectangle(), own.elements());
    let grids = [own, other].iter().all(|frame| frame.is_uniform() && !frame.is_line());
    let close = |one: f64, other: f64| (one - other).abs() <= SAME * from.size[0].max(from.size[1]);
    grids
        && elements == other.elements()
        && (0..2).all(|axis| {
            elements[axis].is_multiple_of(2)
                && close(2.0 * from.size[axis], to.size[axis])
                && close(from.centre[axis], to.centre[axis])
        })
}
