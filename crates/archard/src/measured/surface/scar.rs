//! The scar on a measured surface, found by the readings alone: levelled by what lies beside it, and measured.
//!
//! The level is first found roughly ([`rough`](super::rough)). What lies below it by more than chance, in one piece, is the
//! scar; the plane is fitted anew to the readings beside it, and so on until the scar stays where it is. The middle of what
//! is worn off counts as the middle of the contact, where the body had its apex.

use super::super::plane::{DEBRIS, FEWEST, Height, Plane};
use super::noise::repeats;
use super::{Surface, rough};

/// What a surface was before it was worn.
#[derive(Clone, Copy)]
pub struct Unworn<'a> {
    /// Height (m) out of the material at a place (m) from the middle of the contact; not a number beyond the body.
    pub height: &'a dyn Fn([f64; 2]) -> f64,
    /// Axes along which the scar runs on beyond a map, as a track does.
    pub through: [bool; 2],
}

/// A scar, in the coordinates of the instrument.
#[derive(Debug, Clone, PartialEq)]
pub struct Scar {
    /// The plane that the surface lay on beside its shape.
    pub plane: Plane,
    /// The middle of the scar (m).
    pub middle: [f64; 2],
    /// From where to where it reaches along x and y (m).
    pub extent: [[f64; 2]; 2],
    /// What is worn off: the section of a profile, or on average of the map of a track (m^2); the volume of a map (m^3).
    pub worn: f64,
    /// Its standard uncertainty by the scatter beside the scar and the level (the same unit).
    pub uncertainty: f64,
    /// The greatest depth, averaged over a fiftieth of the surface along each axis (m).
    pub deepest: f64,
    /// Places in the scar without a reading.
    pub gaps: usize,
}

/// Why no scar is found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoScar {
    /// Nothing to be seen.
    #[error(
        "no scar stands out from the shape of the body and a plane: see that heights rise out of the material, that the units \
         are right, that the shape of the body was not taken off, and that enough was measured beside the scar"
    )]
    Nothing,
    /// Nothing to level by.
    #[error(
        "the scar reaches the end of what was measured along {axis}, or nearly: nothing lies beside it to level by; measure \
         half as wide again as the scar"
    )]
    Fills {
        /// The axis.
        axis: &'static str,
    },
    /// Too many places without a reading.
    #[error("{:.0} % of the scar have no reading: measure them, or interpolate them yourself", 100.0 * .share)]
    Gaps {
        /// Their share.
        share: f64,
    },
    /// What is worn off is not told.
    #[error(
        "what is worn off is uncertain by {:.0} %: the scar is {:.3} um deep, and the surface beside it off its shape by \
         {:.3} um; see that units and shape of the body are right, or measure more and wider",
        100.0 * .share, 1e6 * .deepest, 1e6 * .scatter
    )]
    Uncertain {
        /// The standard uncertainty, relative.
        share: f64,
        /// Depth of the scar (m).
        deepest: f64,
        /// Scatter beside it (m).
        scatter: f64,
    },
}

/// Deviations within which readings lie on the level, and beyond which smoothed ones are worn.
const WITHIN: f64 = 2.5;
const WORN: f64 = 3.0;
/// Share of its width that the scar is measured beyond its edges, and beyond which readings lie beside it.
const MARGIN: f64 = 0.1;
const BESIDE: f64 = 0.15;
/// Parts of the extent that depths are averaged over.
const PARTS: usize = 50;
/// Rounds in which scar and level settle.
const ROUNDS: usize = 12;
/// Most that may be uncertain.
const UNCERTAIN: f64 = 0.3;

impl Scar {
    /// The scar on a surface.
    ///
    /// # Errors
    /// If none stands out, nothing lies beside it, or it is not told well enough.
    pub fn find(surface: &Surface, unworn: Unworn<'_>) -> Result<Self, NoScar> {
        let mut middle = [0, 1].map(|axis| surface.extent(axis).iter().sum::<f64>() / 2.0);
        let mut level = surface.rough_level(&surface.less(unworn, middle))?;
        let mut last: Option<[[usize; 2]; 2]> = None;
        for _ in 0..ROUNDS {
            let depths = surface.depths(unworn, middle, &level);
            let found = surface.largest_piece(&depths, &level).ok_or(NoScar::Nothing)?;
            let extent = surface.with_through(found, unworn.through)?;
            middle = surface.middle_of(&depths, extent, unworn.through);
            let beside = surface.beside(&surface.less(unworn, middle), extent, unworn.through)?;
            level = Level::of(surface, &beside).ok_or(NoScar::Nothing)?;
            if last == Some(found) {
                break;
            }
            last = Some(found);
        }
        surface.measure(unworn, (middle, level), last.ok_or(NoScar::Nothing)?)
    }

    /// What is worn off at each reading (m), and its place from the middle of the scar.
    pub fn depths(&self, surface: &Surface, unworn: Unworn<'_>) -> Vec<Height> {
        let [x, y] = self.middle;
        let less = surface.less(unworn, self.middle).into_iter();
        let depth = |own: Height| [own[0] - x, own[1] - y, -self.plane.above(&own)];
        less.map(depth).filter(|own| own[2].is_finite()).collect()
    }
}

/// The plane beside a scar, and in how many readings there is one that is independent.
#[derive(Debug, Clone, Copy)]
struct Level {
    plane: Plane,
    repeats: f64,
}

impl Level {
    /// Of readings beside a scar; those of gaps and of the scar are not numbers.
    fn of(surface: &Surface, beside: &[Height]) -> Option<Self> {
        let known: Vec<Height> = beside.iter().copied().filter(|own| own[2].is_finite()).collect();
        let plane = Plane::through(&known)?;
        let off = |own: &Height| {
            let above = plane.above(own);
            if above.abs() <= DEBRIS * plane.scatter { above } else { f64::NAN }
        };
        let off: Vec<f64> = beside.iter().map(off).collect();
        Some(Self { plane, repeats: repeats(&off, surface.places[0].len()) })
    }

    /// Standard deviation of a reading (m).
    fn scatter(&self) -> f64 {
        self.plane.scatter
    }
}

impl Surface {
    /// Heights less those of the unworn body around a middle.
    fn less(&self, unworn: Unworn<'_>, middle: [f64; 2]) -> Vec<Height> {
        let one = |cell: usize| {
            let [x, y, z] = self.at(cell);
            [x, y, z - (unworn.height)([x - middle[0], y - middle[1]])]
        };
        (0..self.heights.len()).map(one).collect()
    }

    /// The level without knowing where the scar is.
    fn rough_level(&self, heights: &[Height]) -> Result<Level, NoScar> {
        let known: Vec<Height> = heights.iter().copied().filter(|own| own[2].is_finite()).collect();
        if known.len() < 3 * FEWEST {
            return Err(NoScar::Nothing);
        }
        let mut plane = rough::level(self, &known).ok_or(NoScar::Nothing)?;
        let mut deviation = rough::deviation(&plane, &known);
        for _ in 0..ROUNDS {
            let on = |own: &&Height| plane.above(own).abs() <= WITHIN * deviation;
            let on: Vec<Height> = known.iter().filter(on).copied().collect();
            let Some(found) = Plane::through(&on) else { break };
            (plane, deviation) = (found, found.scatter.max(f64::MIN_POSITIVE));
        }
        Ok(Level { plane, repeats: 1.0 })
    }

    /// What is worn off at each cell (m); not a number in gaps.
    fn depths(&self, unworn: Unworn<'_>, middle: [f64; 2], level: &Level) -> Vec<f64> {
        self.less(unworn, middle).iter().map(|own| -level.plane.above(own)).collect()
    }

    /// Cells on either side that a depth is averaged over.
    fn reach(&self) -> [usize; 2] {
        [0, 1].map(|axis| self.places[axis].len() / (2 * PARTS))
    }

    /// Depths averaged over the cells around each; those of gaps over what is there.
    fn smoothed(&self, depths: &[f64]) -> Vec<f64> {
        let [columns, rows] = [0, 1].map(|axis| self.places[axis].len());
        // Sums over all cells before each, along both axes.
        let mut sums = vec![[0.0; 2]; (columns + 1) * (rows + 1)];
        let at = |column: usize, row: usize| row * (columns + 1) + column;
        for row in 0..rows {
            for column in 0..columns {
                let depth = depths[row * columns + column];
                let own = if depth.is_finite() { [depth, 1.0] } else { [0.0; 2] };
                sums[at(column + 1, row + 1)] = [0, 1].map(|i| {
                    own[i] + sums[at(column, row + 1)][i] + sums[at(column + 1, row)][i]
                        - sums[at(column, row)][i]
                });
            }
        }
        let reach = self.reach();
        let mean = |cell: usize| {
            let [column, row] = [cell % columns, cell / columns];
            let [left, low] = [column.saturating_sub(reach[0]), row.saturating_sub(reach[1])];
            let [right, high] =
                [(column + reach[0] + 1).min(columns), (row + reach[1] + 1).min(rows)];
            let [sum, count] = [0, 1].map(|i| {
                sums[at(right, high)][i] - sums[at(left, high)][i] - sums[at(right, low)][i]
                    + sums[at(left, low)][i]
            });
            sum / count
        };
        (0..columns * rows).map(mean).collect()
    }

    /// First and last cell along each axis of the piece that lies below the level by more than chance and has lost most.
    fn largest_piece(&self, depths: &[f64], level: &Level) -> Option<[[usize; 2]; 2]> {
        let [columns, rows] = [0, 1].map(|axis| self.places[axis].len());
        let smoothed = self.smoothed(depths);
        let averaged = self.reach().iter().map(|reach| 2.0 * *reach as f64 + 1.0).product::<f64>();
        let least = WORN * level.scatter() * (level.repeats / averaged).min(1.0).sqrt();
        let mut free: Vec<bool> = smoothed.iter().map(|depth| *depth > least).collect();
        let mut best: Option<(f64, [[usize; 2]; 2])> = None;
        for start in 0..free.len() {
            if !std::mem::take(&mut free[start]) {
                continue;
            }
            let (mut lost, mut reaches) = (0.0, [[usize::MAX, 0]; 2]);
            let mut open = vec![start];
            while let Some(cell) = open.pop() {
                lost += smoothed[cell];
                let place = [cell % columns, cell / columns];
                for (reach, index) in reaches.iter_mut().zip(place) {
                    *reach = [reach[0].min(index), reach[1].max(index)];
                }
                let [column, row] = place;
                for other_row in row.saturating_sub(1)..=(row + 1).min(rows - 1) {
                    for other in column.saturating_sub(1)..=(column + 1).min(columns - 1) {
                        let next = other_row * columns + other;
                        if std::mem::take(&mut free[next]) {
                            open.push(next);
                        }
                    }
                }
            }
            if best.is_none_or(|(most, _)| lost > most) {
                best = Some((lost, reaches));
            }
        }
        best.map(|(_, reaches)| reaches)
    }

    /// From where to where a piece reaches (m); all along where it runs through.
    fn with_through(
        &self,
        piece: [[usize; 2]; 2],
        through: [bool; 2],
    ) -> Result<[[f64; 2]; 2], NoScar> {
        let mut extent = [[0.0; 2]; 2];
        for axis in 0..2 {
            let places = &self.places[axis];
            if through[axis] || places.len() == 1 {
                extent[axis] = self.extent(axis);
                continue;
            }
            let [first, last] = piece[axis];
            if first == 0 || last + 1 == places.len() {
                return Err(NoScar::Fills { axis: ["x", "y"][axis] });
            }
            extent[axis] = [places[first], places[last]];
        }
        Ok(extent)
    }

    /// The middle of what is worn off within an extent, and of the map where the scar runs through.
    fn middle_of(&self, depths: &[f64], extent: [[f64; 2]; 2], through: [bool; 2]) -> [f64; 2] {
        let wide = wider(extent, MARGIN);
        let inside = |cell: &usize| depths[*cell].is_finite() && holds(wide, self.at(*cell));
        let cells: Vec<usize> = (0..depths.len()).filter(inside).collect();
        let all: f64 = cells.iter().map(|&cell| depths[cell]).sum();
        [0, 1].map(|axis| {
            let moment: f64 = cells.iter().map(|&cell| depths[cell] * self.at(cell)[axis]).sum();
            let [low, high] = extent[axis];
            let through = through[axis] || low == high || all <= 0.0;
            if through { 0.5 * (low + high) } else { (moment / all).clamp(low, high) }
        })
    }

    /// Heights beside a scar, in the place of the others no number.
    fn beside(
        &self,
        heights: &[Height],
        extent: [[f64; 2]; 2],
        through: [bool; 2],
    ) -> Result<Vec<Height>, NoScar> {
        let wide = wider(extent, BESIDE);
        for axis in 0..2 {
            let places = &self.places[axis];
            let below = places.iter().filter(|place| **place < wide[axis][0]).count();
            let above = places.iter().filter(|place| **place > wide[axis][1]).count();
            if !through[axis] && places.len() > 1 && below.min(above) < FEWEST / 2 {
                return Err(NoScar::Fills { axis: ["x", "y"][axis] });
            }
        }
        let left = |own: &Height| {
            if holds(wide, *own) { [own[0], own[1], f64::NAN] } else { *own }
        };
        Ok(heights.iter().map(left).collect())
    }

    /// What is worn off, once it is known where.
    fn measure(
        &self,
        unworn: Unworn<'_>,
        (middle, level): ([f64; 2], Level),
        piece: [[usize; 2]; 2],
    ) -> Result<Scar, NoScar> {
        let extent = self.with_through(piece, unworn.through)?;
        let depths = self.depths(unworn, middle, &level);
        let zone = wider(extent, MARGIN);
        let (weights, gaps) = self.weights(&depths, zone)?;
        // Ridges and debris take nothing off what is worn.
        let debris = -DEBRIS * level.scatter();
        let worn = |cell: usize| if depths[cell] < debris { 0.0 } else { depths[cell] };
        let mean = [0, 1].map(|axis| self.extent(axis)).map(|[low, high]| high - low);
        let along: f64 =
            (0..2).filter(|&axis| unworn.through[axis]).map(|axis| mean[axis].max(0.0)).product();
        let scale = if self.axis.is_none() && along > 0.0 { 1.0 / along } else { 1.0 };
        let sum = |part: &dyn Fn(usize, f64) -> f64| -> f64 {
            weights.iter().map(|&(cell, weight)| part(cell, weight * scale)).sum()
        };
        let (all, whole) = (sum(&|cell, weight| weight * worn(cell)), sum(&|_, weight| weight));
        let centre = [0, 1].map(|axis| sum(&|cell, weight| weight * self.at(cell)[axis]) / whole);
        let readings = sum(&|_, weight| weight * weight);
        let of_level = whole * whole * level.plane.variance_at(centre);
        let uncertainty = level.scatter() * (level.repeats * (readings + of_level)).sqrt();
        let smoothed = self.smoothed(&depths);
        let deepest = weights.iter().map(|(cell, _)| smoothed[*cell]).fold(0.0, f64::max);
        let share = uncertainty / all;
        if all <= 0.0 || share.is_nan() || share > UNCERTAIN {
            let (share, scatter) = (share.abs(), level.scatter());
            return Err(NoScar::Uncertain { share, deepest, scatter });
        }
        Ok(Scar { plane: level.plane, middle, extent, worn: all, uncertainty, deepest, gaps })
    }
}

/// An extent with a share of its width on either side.
fn wider(extent: [[f64; 2]; 2], share: f64) -> [[f64; 2]; 2] {
    extent.map(|[low, high]| [low - share * (high - low), high + share * (high - low)])
}

/// Whether a place lies in an extent.
fn holds(extent: [[f64; 2]; 2], [x, y, _]: Height) -> bool {
    let within = |[low, high]: [f64; 2], place: f64| (low..=high).contains(&place);
    within(extent[0], x) && within(extent[1], y)
}
