//! Fatigue of a body whose points pass through the contact: each row below it along the motion is the path of stresses that a point goes
//! through, from far in front of the contact to far behind it.

use rayon::prelude::*;

use super::Pressed;
use super::maxima::Maximum;
use crate::compliance::half_space::inside::Below;
use crate::stress::criteria::{
    Elastic, crossland, dang_van, fatemi_socie, findley, smith_watson_topper,
};
use crate::stress::{Components, tension};

/// Rows of a plane at which criteria that look for a plane of the material are asked, those of the largest amplitude of shear and those of
/// the largest tension. A choice of effort.
const ROWS: usize = 8;
/// Parts that the depth of the worst is placed in, between the depths that are looked at, by golden sections. A choice of effort.
const SECTIONS: usize = 8;

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

/// The worst of a plane: the value, and the place (m) of its row across the motion.
type Worst = (f64, f64);

impl Pressed {
    /// What a criterion says at most of points that pass along an axis, at these depths (m) and between them, with an even stress added.
    /// The place has no meaning along the motion. `None` where no row is known.
    pub fn fatigue(
        &self,
        criterion: &Criterion,
        (depths, initial): (&[f64], &Components),
        axis: usize,
    ) -> Option<Maximum> {
        let worst =
            |below: &Below, depth: f64| self.worst(below, depth, (criterion, initial), axis);
        let all: Vec<Option<Worst>> =
            depths.iter().map(|&depth| worst(&self.below, depth)).collect();
        let value = |at: usize| all[at].map_or(f64::NEG_INFINITY, |(value, _)| value);
        let best = (0..depths.len()).max_by(|&a, &b| value(a).total_cmp(&value(b)))?;
        let (mut depth, mut largest) = (depths[best], all[best]?);
        // Between the depths next to it, by parts of a golden section.
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        let mut ends = [depths[best.saturating_sub(1)], depths[(best + 1).min(depths.len() - 1)]];
        for _ in 0..SECTIONS {
            let width = ends[1] - ends[0];
            let inner = [ends[1] - golden * width, ends[0] + golden * width];
            let found = inner.map(|depth| worst(&self.below, depth));
            for (inner, found) in inner.into_iter().zip(found) {
                if let Some(found) = found.filter(|found| found.0 > largest.0) {
                    (depth, largest) = (inner, found);
                }
            }
            let [low, high] = found.map(|found| found.map_or(f64::NEG_INFINITY, |found| found.0));
            if low < high { ends[0] = inner[0] } else { ends[1] = inner[1] }
        }
        let coarse = self.below.coarser();
        let far = coarse.coarser();
        let values = [worst(&coarse, depth)?.0, worst(&far, depth)?.0];
        let mut place = [0.0, 0.0, -depth];
        place[1 - axis] = largest.1;
        Some(Maximum::of([largest.0, values[0], values[1]], place))
    }

    /// The worst row of a plane.
    fn worst(
        &self,
        below: &Below,
        depth: f64,
        (criterion, initial): (&Criterion, &Components),
        axis: usize,
    ) -> Option<Worst> {
        let plane = below.plane(depth);
        let elements = below.elements();
        let [along, across] = [elements[axis], elements[1 - axis]];
        let row = |row: usize| -> Option<(f64, Vec<Components>)> {
            let element = |step: usize| {
                if axis == 0 { step + elements[0] * row } else { row + elements[0] * step }
            };
            let place = below.place(element(0))[1 - axis];
            let mut path: Vec<Components> = vec![*initial];
            for step in 0..along {
                let element = element(step);
                let [x, y] = below.place(element);
                if !self.knows([x, y, -depth]) {
                    return None;
                }
                path.push(std::array::from_fn(|i| plane[i][element] + initial[i]));
            }
            Some((place, path))
        };
        let rows: Vec<(f64, Vec<Components>)> = (0..across).filter_map(row).collect();
        let chosen =
            if criterion.seeks_a_plane() { foremost(&rows) } else { (0..rows.len()).collect() };
        let values: Vec<Worst> = chosen
            .into_par_iter()
            .map(|row: usize| (criterion.of(&rows[row].1), rows[row].0))
            .collect();
        values.into_iter().max_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// The rows of the largest amplitudes of shear, and those of the largest tension.
fn foremost(rows: &[(f64, Vec<Components>)]) -> Vec<usize> {
    let foremost = |measure: &(dyn Fn(&[Components]) -> f64 + Sync)| {
        let values: Vec<f64> = rows.par_iter().map(|(_, path)| measure(path)).collect();
        let mut order: Vec<usize> = (0..rows.len()).collect();
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
