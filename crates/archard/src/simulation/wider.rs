//! A run that goes on in a frame twice as wide, with elements twice as large.
//!
//! A scar grows to many times the contact that it began with. Elements that resolve the first contact are more than the
//! scar needs at the end: as many elements, twice as large, hold twice its width. What was worn off four elements is worn off the
//! one that takes their place, to the same volume. Lines of contact have elements enough, and measure their approach from a
//! depth that goes by the width of the frame.

use std::iter::successors;

use super::evolution::{Evolution, Increment};
use super::{Effort, Error, Simulation};
use crate::frame::ContactFrame;
use crate::motion::Motion;
use crate::parameters::Invalid;
use crate::problem::{ContactProblem, ContactState, Surface};

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
    pub(super) fn frames(&self) -> impl Iterator<Item = &Self> {
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
    matches!(motion, Motion::Sliding(_)) && motion.swing().is_none()
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

impl Evolution {
    /// The same in a frame that is twice as wide, pressed together there.
    pub(super) fn widened(
        &self,
        from: &ContactProblem,
        to: &Simulation,
        effort: &mut Effort,
    ) -> Result<Self, Error> {
        let problem = &to.problem;
        let mut evolution = Self::new(problem);
        let state = &self.state;
        evolution.state = ContactState {
            progress: state.progress,
            approach: state.approach,
            load: state.load,
            pressure: means(&state.pressure, from.frame.elements()),
            surfaces: state.surfaces.each_ref().map(widened),
            ..evolution.state
        };
        (evolution.load_distance, evolution.forward) = (self.load_distance, self.forward);
        evolution.find_displacement(problem, effort);
        let progress = state.progress;
        let control = to.schedule.control_at(progress);
        evolution.press(to, Increment { advance: 0.0, progress, control }, effort)?;
        Ok(evolution)
    }
}

/// A surface on the elements of a frame twice as wide; unworn beside the smaller one.
pub(super) fn widened(surface: &Surface) -> Surface {
    surface.map(surface.grid, |field| means(field, surface.grid.elements()))
}

/// Values of elements, as those of elements twice as large in a frame twice as wide; 0 beside the smaller one. Along an axis
/// with one element that is all there is.
fn means(field: &[f64], elements: [usize; 2]) -> Vec<f64> {
    let [nx, ny] = elements;
    let mut wide = vec![0.0; field.len()];
    let share = elements.map(|count| if count == 1 { 1.0 } else { 0.5 });
    for (element, value) in field.iter().enumerate() {
        let [x, y] =
            [(element % nx, nx), (element / nx, ny)].map(|(index, count)| (index + count / 2) / 2);
        wide[x + nx * y] += share[0] * share[1] * value;
    }
    wide
}

#[cfg(test)]
mod tests {
    use super::{means, widened};
    use crate::problem::{Grid, Surface};

    /// Sums over elements of four times the area are those of the parts, wherever these are.
    #[test]
    fn volumes_stay() {
        for elements in [[8, 8], [6, 10], [2, 4]] {
            let field: Vec<f64> =
                (0..elements[0] * elements[1]).map(|pair| (1.7 * pair as f64).sin()).collect();
            let wide = means(&field, elements);
            let [before, after] = [field.iter().sum::<f64>(), 4.0 * wide.iter().sum::<f64>()];
            assert!((before - after).abs() < 1e-12, "{before} {after}");
            if elements.iter().all(|count| count.is_multiple_of(4)) {
                // Of the element right above the middle.
                let [nx, ny] = elements;
                let row = |y: usize| field[nx / 2 + nx * y] + field[nx / 2 + 1 + nx * y];
                let expected = 0.25 * (row(ny / 2) + row(ny / 2 + 1));
                assert!((wide[nx / 2 + nx * (ny / 2)] - expected).abs() < 1e-15);
            }
        }
    }

    /// Of a surface that passes, the section stays.
    #[test]
    fn sections_stay() {
        for axis in [0, 1] {
            let mut surface = Surface::unworn(Grid::passing([8, 12], axis), false, false);
            surface.depth.iter_mut().enumerate().for_each(|(i, depth)| *depth = (i as f64).cos());
            let wide = widened(&surface);
            let section = |one: &Surface| one.depth.iter().sum::<f64>();
            assert!((section(&surface) - 2.0 * section(&wide)).abs() < 1e-12);
        }
    }
}
