//! A route that is kept between two steps, to go on with after an interruption.

use serde::{Deserialize, Serialize};

use super::march::Place;
use super::{Pass, SideCourse};

/// All that a route needs to go on: the end of the passes that are behind, and the place on the one that is under way. It belongs to the journey that
/// it is of; [`Journey::go_on`](super::Journey::go_on) takes the same steps from there on.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Kept {
    /// The place on each pass, in their order.
    pub(super) places: Vec<Place>,
    /// What was told after each step of each pass.
    pub(super) told: [Vec<SideCourse>; 3],
}

impl Kept {
    /// Where a pass goes on: at its start, or at its last step, which was told.
    pub(super) fn begin(&mut self, pass: Pass) -> Option<Place> {
        let place = self.places.get(pass as usize)?.clone();
        // It is told again.
        self.told[pass as usize].retain(|told| told.progress < place.progress);
        Some(place)
    }

    /// Takes a step in.
    pub(super) fn take(
        &mut self,
        pass: Pass,
        place: &Place,
        told: impl Iterator<Item = SideCourse>,
    ) {
        self.told[pass as usize].extend(told);
        match self.places.get_mut(pass as usize) {
            Some(own) => own.clone_from(place),
            None => self.places.push(place.clone()),
        }
    }
}
