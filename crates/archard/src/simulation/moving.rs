//! What lies on one frame, on another.
//!
//! Both frames are parts of one endless grid, or the second has elements twice as large about the same centre. What was neither
//! pressed nor worn is so beyond, but for lines of surfaces that pass, which are worn all along. What was worn off four elements
//! is worn off the one that takes their place, to the same volume.

use super::memory::{History, Rubbed, unworn};
use super::setup::Simulation;
use crate::frame::Part;
use crate::numerics::vector::map;
use crate::problem::{ContactProblem, ContactState, Gap, Surface, Tangential};

/// From one frame to another.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moving<'a> {
    /// What both frames share, as a part of each; `None` where the elements of the second are twice as large.
    pub shared: Option<[Part; 2]>,
    /// What goes on in the second.
    pub simulation: &'a Simulation,
}

/// What has its values on a frame.
pub(super) trait Move {
    /// The same on another frame.
    #[must_use]
    fn moved(&self, to: &Moving<'_>) -> Self;
}

impl<'a> Moving<'a> {
    /// The problem on the second frame.
    pub fn problem(&self) -> &'a ContactProblem {
        &self.simulation.problem
    }

    /// Pairs of the second frame.
    pub fn pairs(&self) -> usize {
        self.problem().frame.len()
    }

    /// Values of what both frames share, others beyond; those alone on elements twice as large.
    pub fn over<T: Clone>(&self, values: &[T], beyond: Vec<T>) -> Vec<T> {
        match self.shared {
            Some([own, there]) => there.pasted(&own.cut(values), beyond),
            None => beyond,
        }
    }

    /// Where something is known on the second frame that was known in a part of the first: everywhere if `None`.
    fn known(&self, part: Option<Part>) -> Option<Part> {
        let nowhere = Part::none(self.problem().frame.elements());
        let Some([own, there]) = self.shared else { return Some(nowhere) };
        let part = match part.filter(|part| !part.holds(&own.extent())) {
            None => there,
            Some(part) => part.seen_from(&own).map_or(nowhere, |part| part.lying_in(&there)),
        };
        (part.size() != part.frame()).then_some(part)
    }
}

impl<T: Move> Move for Option<T> {
    fn moved(&self, to: &Moving<'_>) -> Self {
        self.as_ref().map(|one| one.moved(to))
    }
}

/// A field of the frame, zero beyond; an empty one stays empty.
impl Move for Vec<f64> {
    fn moved(&self, to: &Moving<'_>) -> Self {
        match to.shared {
            _ if self.is_empty() => vec![],
            Some(_) => to.over(self, vec![0.0; to.pairs()]),
            None => means(self, to.problem().frame.elements()),
        }
    }
}

impl Move for [Vec<f64>; 2] {
    fn moved(&self, to: &Moving<'_>) -> Self {
        self.each_ref().map(|field| field.moved(to))
    }
}

/// The surfaces of both bodies.
impl Move for [Surface; 2] {
    fn moved(&self, to: &Moving<'_>) -> Self {
        let there = unworn(to.problem());
        [0, 1].map(|body| {
            let (surface, grid) = (&self[body], there[body].grid);
            let Some(shared) = to.shared else { return doubled(surface) };
            let [own, there] = shared.map(|part| part.extent().map(|range| range.start as isize));
            surface.moved([0, 1].map(|axis| there[axis] - own[axis]), grid)
        })
    }
}

impl Move for Tangential {
    fn moved(&self, to: &Moving<'_>) -> Self {
        Self {
            traction: self.traction.moved(to),
            slip: self.slip.moved(to),
            grip: self.grip.map(|grip| to.over(grip, vec![1.0; to.pairs()])),
            ..*self
        }
    }
}

/// Its gap beyond is that without what the pressures open it by.
impl Move for ContactState {
    fn moved(&self, to: &Moving<'_>) -> Self {
        let surfaces = self.surfaces.moved(to);
        let [one, two] = surfaces.each_ref().map(Surface::lowered);
        let apart = map([to.problem().frame.gap(), &one, &two], |[gap, one, two]| {
            gap + one + two - self.approach
        });
        let gap = Gap { values: to.over(&self.gap.values, apart), part: to.known(self.gap.part) };
        let (pressure, tangential) = (self.pressure.moved(to), self.tangential.moved(to));
        Self { pressure, gap, surfaces, tangential, ..*self }
    }
}

impl Move for History {
    fn moved(&self, to: &Moving<'_>) -> Self {
        Self {
            state: self.state.moved(to),
            displacement: self.displacement.moved(to),
            known: to.known(self.known),
            elastic_displacement: self.elastic_displacement.moved(to),
            // The pairs that close show their course anew.
            course: None,
            until_touch: None,
            rubbed: self.rubbed.moved(to),
            ..*self
        }
    }
}

impl Move for Rubbed {
    fn moved(&self, to: &Moving<'_>) -> Self {
        let whole = match self.whole.is_empty() {
            true => vec![],
            false => to.over(&self.whole, vec![None; to.pairs()]),
        };
        Self {
            depths: self.depths.moved(to),
            slopes: self.slopes.moved(to),
            slip: self.slip.moved(to),
            work: self.work.moved(to),
            dissipated: self.dissipated,
            whole,
        }
    }
}

/// A surface on elements twice as large.
fn doubled(surface: &Surface) -> Surface {
    surface.map(surface.grid, |field| means(field, surface.grid.elements()))
}

/// Values of elements, as those of elements twice as large in a frame twice as wide; 0 next to the smaller one. Along an axis
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
    use super::{doubled, means};
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
            let wide = doubled(&surface);
            let section = |one: &Surface| one.depth.iter().sum::<f64>();
            assert!((section(&surface) - 2.0 * section(&wide)).abs() < 1e-12);
        }
    }
}
