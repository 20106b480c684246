//! Fatigue of a body, by the path of stresses that a point goes through.
//!
//! Where points pass through the contact, each row below it along the motion is such a path, from far in front of the contact to far behind
//! it. Where they stay under a contact that goes through a cycle, as in fretting, the instants of the cycle are.

use rayon::prelude::*;

use super::PressedHalfSpace;
use super::maxima::Maximum;
use crate::compliance::half_space::inside::Below;
use crate::stress::criteria::{
    Elastic, crossland, dang_van, fatemi_socie, findley, smith_watson_topper,
};
use crate::stress::{Components, tension};

/// Paths of a depth at which criteria look for a plane of the material: those of the largest amplitude of shear and those of
/// the largest tension. A choice of effort.
const ROWS: usize = 8;
/// Parts that the depth of the worst is placed in, between the depths that are looked at, by golden sections. A choice of effort.
const SECTIONS: usize = 8;

/// The order of even elements.
const ALONG: f64 = 2.0;
/// The order of tractions where pairs stick and slip in turn: an edge between both lies between two elements.
const STICKS: f64 = 1.0;

/// A criterion with its factors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Criterion {
    /// Crossland's: amplitude plus so many times the largest hydrostatic stress (Pa).
    Crossland(f64),
    /// Dang Van's: shear plus so many times the hydrostatic stress (Pa).
    DangVan(f64),
    /// Findley's: amplitude of shear plus so many times the largest normal stress (Pa).
    Findley(f64),
    /// Fatemi and Socie's: amplitude of shear strain, by a factor and a yield stress (Pa).
    FatemiSocie(Elastic, [f64; 2]),
    /// Smith, Watson and Topper's: largest normal stress times the amplitude of normal strain (Pa).
    SmithWatsonTopper(Elastic),
}

impl Criterion {
    /// Its name in files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Crossland(_) => "crossland",
            Self::DangVan(_) => "dang_van",
            Self::Findley(_) => "findley",
            Self::FatemiSocie(..) => "fatemi_socie",
            Self::SmithWatsonTopper(_) => "smith_watson_topper",
        }
    }

    /// What it says of a path of stresses (Pa, a number for the strain of Fatemi and Socie).
    pub fn of(&self, path: &[Components]) -> f64 {
        match *self {
            Self::Crossland(factor) => {
                let [amplitude, hydrostatic] = crossland(path);
                amplitude + factor * hydrostatic
            }
            Self::DangVan(factor) => dang_van(path, factor),
            Self::Findley(factor) => findley(path, factor).0,
            Self::FatemiSocie(elastic, [factor, strength]) => {
                fatemi_socie(path, elastic, (factor, strength)).0
            }
            Self::SmithWatsonTopper(elastic) => smith_watson_topper(path, elastic).0,
        }
    }

    /// Whether it looks for the plane that is worst off.
    fn seeks_a_plane(&self) -> bool {
        !matches!(self, Self::Crossland(_) | Self::DangVan(_))
    }
}

/// The worst of a plane: the value, and where along x and y (m) it is.
type Worst = (f64, [f64; 2]);

/// A path of stresses, and where along x and y (m) its point is.
type Path = ([f64; 2], Vec<Components>);

/// The worst at these depths (m) and between them, of what is worst in a plane on elements of once, twice and four times the size: a field
/// of that order or less.
fn deepest(
    depths: &[f64],
    order: f64,
    worst: &(dyn Fn(usize, f64) -> Option<Worst> + Sync),
) -> Option<Maximum> {
    let all: Vec<Option<Worst>> = depths.iter().map(|&depth| worst(0, depth)).collect();
    let value = |at: usize| all[at].map_or(f64::NEG_INFINITY, |(value, _)| value);
    let best = (0..depths.len()).max_by(|&a, &b| value(a).total_cmp(&value(b)))?;
    let (mut depth, mut largest) = (depths[best], all[best]?);
    // Between the depths next to it, by parts of a golden section.
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let mut ends = [depths[best.saturating_sub(1)], depths[(best + 1).min(depths.len() - 1)]];
    for _ in 0..SECTIONS {
        let width = ends[1] - ends[0];
        if width == 0.0 {
            break;
        }
        let inner = [ends[1] - golden * width, ends[0] + golden * width];
        let found = inner.map(|depth| worst(0, depth));
        for (inner, found) in inner.into_iter().zip(found) {
            if let Some(found) = found.filter(|found| found.0 > largest.0) {
                (depth, largest) = (inner, found);
            }
        }
        let [low, high] = found.map(|found| found.map_or(f64::NEG_INFINITY, |found| found.0));
        if low < high { ends[0] = inner[0] } else { ends[1] = inner[1] }
    }
    let values = [worst(1, depth)?.0, worst(2, depth)?.0];
    let [x, y] = largest.1;
    Some(Maximum::of_order([largest.0, values[0], values[1]], [x, y, -depth], order))
}

impl Criterion {
    /// What it says at most of paths.
    fn worst(&self, paths: &[Path]) -> Option<Worst> {
        let chosen =
            if self.seeks_a_plane() { foremost(paths) } else { (0..paths.len()).collect() };
        let values: Vec<Worst> = chosen
            .into_par_iter()
            .map(|path: usize| (self.of(&paths[path].1), paths[path].0))
            .collect();
        values.into_iter().max_by(|a, b| a.0.total_cmp(&b.0))
    }
}

impl PressedHalfSpace {
    /// What a criterion says at most of points that pass along an axis, at these depths (m) and between them, with an even stress added.
    /// The place has no meaning along the motion. `None` where no row is known, and as of [`PressedHalfSpace::maxima`].
    pub fn fatigue(
        &self,
        criterion: &Criterion,
        (depths, initial): (&[f64], &Components),
        axis: usize,
    ) -> Option<Maximum> {
        if !self.is_judged() {
            return None;
        }
        let coarser = self.coarser();
        deepest(depths, ALONG, &|level, depth| {
            let below = self.level(&coarser, level);
            criterion.worst(&self.rows(below, depth, initial, axis))
        })
    }

    /// What is below on elements of twice and four times the size.
    fn coarser(&self) -> [Below; 2] {
        let coarse = self.below.coarser();
        let far = coarse.coarser();
        [coarse, far]
    }

    /// What is below on elements of that level, from these on.
    fn level<'a>(&'a self, coarser: &'a [Below; 2], level: usize) -> &'a Below {
        level.checked_sub(1).map_or(&self.below, |level| &coarser[level])
    }

    /// The paths of points that pass along an axis at a depth (m); rows that are not known are left out.
    fn rows(&self, below: &Below, depth: f64, initial: &Components, axis: usize) -> Vec<Path> {
        let plane = below.plane(depth);
        let elements = below.elements();
        let [along, across] = [elements[axis], elements[1 - axis]];
        let row = |row: usize| -> Option<Path> {
            let element = |step: usize| {
                if axis == 0 { step + elements[0] * row } else { row + elements[0] * step }
            };
            let mut path: Vec<Components> = vec![*initial];
            for step in 0..along {
                let element = element(step);
                let [x, y] = below.place(element);
                if !self.knows([x, y, -depth]) {
                    return None;
                }
                path.push(std::array::from_fn(|i| plane[i][element] + initial[i]));
            }
            Some((below.place(element(0)), path))
        };
        (0..across).filter_map(row).collect()
    }
}

/// A half-space at each instant of a cycle of its contact. Its points stay where they are below the frame.
#[derive(Debug)]
pub struct Cycle {
    instants: Vec<(PressedHalfSpace, [Below; 2])>,
    /// The force of friction on the body at each, over the largest of the cycle; none without friction.
    pushes: Option<Vec<f64>>,
}

/// Even stresses (Pa) that are added at all instants of a cycle, and in phase with friction: these as they are where it pushes the body
/// forward along the motion by most.
pub type Added<'a> = (&'a Components, &'a Components);

impl Cycle {
    /// Of the half-space at the instants, in their order, moved along that axis.
    pub fn of(instants: Vec<PressedHalfSpace>, axis: usize) -> Self {
        let pushes: Vec<f64> = instants.iter().map(|own| own.below.push(axis)).collect();
        let largest = pushes.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
        let pushes = pushes.into_iter().map(|own| own / largest).collect();
        let pushes = (largest > 0.0).then_some(pushes);
        let levels = |pressed: PressedHalfSpace| {
            let coarser = pressed.coarser();
            (pressed, coarser)
        };
        Self { instants: instants.into_iter().map(levels).collect(), pushes }
    }

    /// What a criterion says at most of all points, at these depths (m) and between them, with even stresses added. `None` where
    /// nothing is known, where there is no friction that a stress is in phase with, and as of [`PressedHalfSpace::maxima`].
    pub fn fatigue(
        &self,
        criterion: &Criterion,
        (depths, added): (&[f64], Added<'_>),
    ) -> Option<Maximum> {
        let in_phase = *added.1 == [0.0; 6] || self.pushes.is_some();
        if !in_phase || !self.instants.iter().all(|(pressed, _)| pressed.is_judged()) {
            return None;
        }
        deepest(depths, STICKS, &|level, depth| criterion.worst(&self.paths(level, depth, added)))
    }

    /// The depths of [`PressedHalfSpace::depths`] at the first instant.
    pub fn depths(&self) -> Vec<f64> {
        self.instants.first().map_or(vec![], |(pressed, _)| pressed.depths())
    }

    /// What a criterion says of the points below the centres of elements of a size times two to that power, at a depth (m), with even
    /// stresses added; no number where a stress is not known.
    pub(super) fn values(
        &self,
        criterion: &Criterion,
        (level, depth): (usize, f64),
        added: Added<'_>,
    ) -> Vec<f64> {
        let paths = self.all_paths((level, depth), added);
        let value = |path: Option<Path>| path.map_or(f64::NAN, |(_, path)| criterion.of(&path));
        paths.into_par_iter().map(value).collect()
    }

    /// Where along x and y (m) the centres of the same elements are.
    pub(super) fn columns(&self, level: usize) -> Vec<[f64; 2]> {
        let below = self.instants.first().map(|(pressed, coarser)| pressed.level(coarser, level));
        let places = |below: &Below| {
            (0..below.pressure().len()).map(|element| below.place(element)).collect()
        };
        below.map_or(vec![], places)
    }

    /// Means of a field of the elements over those of twice the size.
    pub(super) fn halved(&self, field: &[f64]) -> Vec<f64> {
        let Some((pressed, [coarse, _])) = self.instants.first() else { return vec![] };
        let ([nx, _], [mx, my]) = (pressed.below.elements(), coarse.elements());
        let mut sums = vec![[0.0; 2]; mx * my];
        for (index, value) in field.iter().enumerate() {
            let sum = &mut sums[index % nx / 2 + mx * (index / nx / 2)];
            (sum[0], sum[1]) = (sum[0] + value, sum[1] + 1.0);
        }
        sums.into_iter().map(|[sum, count]| sum / count).collect()
    }

    /// The paths of points below the centres of elements at a depth (m); those that are not known at all instants are left out.
    fn paths(&self, level: usize, depth: f64, added: Added<'_>) -> Vec<Path> {
        self.all_paths((level, depth), added).into_iter().flatten().collect()
    }

    /// The same of each element.
    fn all_paths(
        &self,
        (level, depth): (usize, f64),
        (initial, swinging): Added<'_>,
    ) -> Vec<Option<Path>> {
        let push = |instant: usize| self.pushes.as_ref().map_or(0.0, |pushes| pushes[instant]);
        let planes = self.instants.iter().enumerate().map(|(instant, (one, own))| {
            let added = std::array::from_fn(|i| initial[i] + push(instant) * swinging[i]);
            (one.level(own, level).plane(depth), added)
        });
        let planes: Vec<([Vec<f64>; 6], Components)> = planes.collect();
        let Some((pressed, coarser)) = self.instants.first() else { return vec![] };
        let below = pressed.level(coarser, level);
        let path = |element: usize| {
            let [x, y] = below.place(element);
            let known = self.instants.iter().all(|(pressed, _)| pressed.knows([x, y, -depth]));
            let stress = |(plane, added): &([Vec<f64>; 6], Components)| -> Components {
                std::array::from_fn(|i| plane[i][element] + added[i])
            };
            known.then(|| ([x, y], planes.iter().map(stress).collect()))
        };
        (0..below.pressure().len()).map(path).collect()
    }
}

/// The paths of the largest amplitudes of shear, and those of the largest tension.
fn foremost(paths: &[Path]) -> Vec<usize> {
    let foremost = |measure: &(dyn Fn(&[Components]) -> f64 + Sync)| {
        let values: Vec<f64> = paths.par_iter().map(|(_, path)| measure(path)).collect();
        let mut order: Vec<usize> = (0..paths.len()).collect();
        order.sort_by(|&a, &b| values[b].total_cmp(&values[a]));
        order.into_iter().take(ROWS)
    };
    let pull = |path: &[Components]| path.iter().map(tension).fold(f64::NEG_INFINITY, f64::max);
    let mut chosen: Vec<usize> =
        foremost(&|path| crossland(path)[0]).chain(foremost(&pull)).collect();
    chosen.sort_unstable();
    chosen.dedup();
    chosen
}
