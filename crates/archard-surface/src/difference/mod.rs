//! What is worn between two scans of a surface: the later one laid on the earlier one, and subtracted.
//!
//! [`Difference::between`] finds how the later map lies on the earlier one (shift, turn and a plane) by what did not wear, where
//! the surface changed, and the volumes worn off and piled up, with their uncertainties:
//!
//! 1. directions of slopes are correlated for the place to a pixel (`start`);
//! 2. shift, turn and plane are fitted with weights that leave out what changed (`fit`), from the plane of half of the surface (`level`);
//! 3. the covariance of what is left tells the noise (`noise`), by which regions of wear and pile-up stand out (`region`);
//! 4. these are left out, and all from the fit on is done again until they stay;
//! 5. changes are summed over regions with their signs, so that noise adds nothing, and the same covariance is propagated into the
//!    sums (`volume`).
//!
//! Calibration of the instrument is in no uncertainty: scale errors are those of the volume.

mod align;
mod blocks;
mod fit;
mod fourier;
mod level;
mod noise;
mod placement;
mod refusal;
mod region;
mod sample;
mod scar;
mod section;
mod solve;
mod start;
mod sums;
mod volume;

#[cfg(test)]
mod tests;

use align::{Aligned, FEWEST, Pair, levelled, point};
use fit::{Points, weight};
use noise::Noise;
use placement::PARAMETERS;
use region::{Changes, NARROWEST, Region};
use volume::{Falls, ToldBy, Uncertainty};

pub use placement::Placement;
pub use refusal::NoDifference;
pub use scar::Scar;
pub use section::SectionPoint;
pub use volume::Uncertain;

use crate::map::HeightMap;

/// Points of a map, at most; larger maps are averaged over blocks first, which keeps volumes.
const POINTS: usize = 1_500_000;
/// Rounds in which regions and level settle, at most.
const ROUNDS: usize = 12;
/// Standard deviations beyond which a point of a region is counted as changed: 95 % of the others lie within.
const CLEAR: f64 = 2.0;

/// What is known of two scans.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Turns up to this (rad) are sought, either way.
    pub turn: f64,
    /// Whether the middle of both maps is the same place, and neither is turned: nothing but a plane is sought.
    pub placed: bool,
    /// From where to where along x and y of the later map (m) wear is to be found; all else did not wear. Everywhere if not given.
    pub worn: Option<[[f64; 2]; 2]>,
}

impl Default for Options {
    fn default() -> Self {
        Self { turn: 5_f64.to_radians(), placed: false, worn: None }
    }
}

/// What changed between two scans.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// How the later map lies on the earlier one.
    pub placement: Placement,
    /// Standard uncertainties of shift (m), turn (rad), offset (m) and tilt; zero of what was not sought.
    pub uncertainty: Placement,
    /// Whether shift and turn were sought and found; if not there is no texture to find them by, or the maps were said to be placed.
    pub sought: bool,
    /// Share of the later map that has a height in both.
    pub overlap: f64,
    /// The later surface above the earlier one (m): negative where it is worn; not a number where one has no height. On the
    /// points of the later map, or on blocks of them.
    pub change: HeightMap,
    /// At each point -1 in a worn region, 1 in one that is piled up, 0 elsewhere.
    pub regions: Vec<i8>,
    /// How many regions are worn and piled up.
    pub count: [usize; 2],
    /// Volume (m^3) worn off, over all worn regions.
    pub worn: Uncertain,
    /// Volume (m^3) piled up, over its regions; `None` if there are none.
    pub piled: Option<Uncertain>,
    /// Worn off less piled up (m^3).
    pub net: Uncertain,
    /// Greatest depth (m), of means over a Gaussian of 1.5 points.
    pub depth: Uncertain,
    /// Where that is (m), on the later map.
    pub deepest: [f64; 2],
    /// Area (m^2) that stands out as worn.
    pub area: f64,
    /// The largest of the worn regions.
    pub scar: Scar,
    /// Standard deviation (m) of what did not wear.
    pub scatter: f64,
    /// Length (m) of a square over which noise is alike.
    pub alike: f64,
    /// Points without a height in worn regions, whose change was taken from those around them.
    pub missing: usize,
    /// Whether a worn region reaches the rim of the overlap, so that more may be worn beyond it.
    pub reaches_rim: bool,
}

impl Difference {
    /// What changed from an earlier map to a later one.
    ///
    /// # Errors
    /// If the maps do not overlap, the one is not found in the other, nothing or too much is worn, or the part that is given is none.
    pub fn between(
        before: &HeightMap,
        after: &HeightMap,
        options: &Options,
    ) -> Result<Self, NoDifference> {
        let [before, after] = [before, after].map(|map| few(&map.clear().0));
        let part = options.worn.map(|[x, y]| inside(&after, [x, y]));
        let outside = part.clone().unwrap_or_else(|| vec![false; after.heights().len()]);
        if let Some(part) = &part {
            let (within, beyond): (Vec<usize>, Vec<usize>) = (0..part.len())
                .filter(|&at| !after.heights()[at].is_nan())
                .partition(|&at| part[at]);
            let [inside, outside] = [within.len(), beyond.len()];
            if inside.min(outside) < FEWEST {
                return Err(NoDifference::Part { inside, outside, least: FEWEST });
            }
        }
        let pair = Pair::of(&before, &after);
        let aligned = match options.placed {
            true => Aligned { placement: Placement::default(), sought: false },
            false => pair.sought(options.turn, &outside)?,
        };
        settled(&Scans { before, after, pair, part }, aligned)
    }
}

/// Both scans, and where wear is to be found.
struct Scans {
    before: HeightMap,
    after: HeightMap,
    pair: Pair,
    part: Option<Vec<bool>>,
}

/// A round: changes and regions.
struct Round {
    placement: Placement,
    change: Vec<f64>,
    scatter: f64,
    noise: Noise,
    regions: Vec<Region>,
    least: [f64; 2],
}

impl Scans {
    /// Level, noise and regions where the points excluded do not count; the first round finds the plane of half of them.
    fn round(
        &self,
        placement: Placement,
        excluded: &[bool],
        first: bool,
    ) -> Result<Round, NoDifference> {
        let few = |points| NoDifference::NoOverlap { points, least: FEWEST };
        let (before, reach) = (&self.before, self.pair.reach);
        let all = (0..excluded.len()).filter(|&at| !excluded[at]);
        let after: Vec<([f64; 2], f64)> = all.filter_map(|at| point(&self.after, at)).collect();
        let points = Points { before, after, reach };
        let common = points.changes(&placement).len();
        if common < FEWEST {
            let share = excluded.iter().filter(|one| **one).count() as f64 / excluded.len() as f64;
            return Err(if first { few(common) } else { NoDifference::AllWorn { share } });
        }
        let start = if first { levelled(&points, placement) } else { Some(placement) };
        let start = start.ok_or(few(common))?;
        let fitted = points.fitted(start, false).ok_or(few(common))?;
        let placement = fitted.placement;
        let change: Vec<f64> = (0..excluded.len())
            .map(|at| {
                let change = placement.change(before, point(&self.after, at)?, reach);
                change.map(|change| change.0)
            })
            .map(|change| change.unwrap_or(f64::NAN))
            .collect();
        let rest = change.iter().zip(excluded).map(|(change, excluded)| {
            let counts = !excluded && weight(*change, fitted.scatter) > 0.0;
            if counts { *change } else { f64::NAN }
        });
        let noise = Noise::of(self.after.elements(), &rest.collect::<Vec<f64>>());
        let (elements, pixel) = (self.after.elements(), self.after.pixel());
        let changes = Changes { elements, pixel, values: &change, within: self.part.as_deref() };
        let (regions, least) = changes.regions(&noise);
        Ok(Round { placement, change, scatter: fitted.scatter, noise, regions, least })
    }

    /// Points that regions and the part take.
    fn excluded(&self, regions: &[Region]) -> Vec<bool> {
        let mut excluded =
            self.part.clone().unwrap_or_else(|| vec![false; self.after.heights().len()]);
        regions.iter().flat_map(Region::points).for_each(|&at| excluded[at] = true);
        excluded
    }

    /// The same and all points near them, into whose smoothed heights they reach.
    fn spread(&self, excluded: &[bool]) -> Vec<bool> {
        let values: Vec<f64> = excluded.iter().map(|one| f64::from(*one)).collect();
        let deviation = self
            .after
            .pixel()
            .map(|own| self.after.pixel()[0].max(self.after.pixel()[1]) * NARROWEST / own);
        let near = blocks::smoothed(self.after.elements(), &values, deviation);
        // Less than the weight of one point at three deviations.
        near.into_iter().map(|share| share > 1e-3).collect()
    }
}

/// Rounds until regions stay.
fn settled(scans: &Scans, aligned: Aligned) -> Result<Difference, NoDifference> {
    let mut placement = aligned.placement;
    let mut excluded = scans.excluded(&[]);
    let mut refined = !aligned.sought;
    for left in (0..ROUNDS).rev() {
        let round = scans.round(placement, &excluded, left + 1 == ROUNDS)?;
        let known = round.change.iter().filter(|change| !change.is_nan()).count();
        let seeds = round.regions.iter().flat_map(|region| &region.seeds);
        let clear = |at: &&usize| round.change[**at].abs() > CLEAR * round.scatter;
        let changed = seeds.filter(clear).count();
        let share = changed as f64 / known.max(1) as f64;
        let next = scans.excluded(&round.regions);
        let same = next == excluded;
        if left == 0 || (same && refined) {
            if scans.part.is_none() && share > 0.5 {
                return Err(NoDifference::AllWorn { share });
            }
            return found(scans, &round, aligned.sought);
        }
        excluded = next;
        placement = round.placement;
        if aligned.sought {
            let better = scans.pair.refined(placement, &scans.spread(&excluded));
            let Placement { shift, turn, .. } =
                better.ok_or(NoDifference::AllWorn { share })?.placement;
            placement = Placement { shift, turn, ..placement };
            refined = true;
        }
    }
    Err(NoDifference::AllWorn { share: 1.0 })
}

/// What came of the last round.
fn found(scans: &Scans, round: &Round, sought: bool) -> Result<Difference, NoDifference> {
    let Round { placement, change, scatter, noise, .. } = round;
    let map = scans.after.of_heights(change.clone());
    let count = change.len();
    let excluded = scans.excluded(&round.regions);
    let falls: Vec<Option<Falls>> = (0..count)
        .map(|at| {
            let point = point(&scans.after, at)?;
            Some(placement.change(&scans.pair.before, point, scans.pair.reach)?.1)
        })
        .collect();
    let told = (0..count).map(|at| {
        let weight = weight(change[at], *scatter);
        falls[at].filter(|_| !excluded[at] && weight > 0.0).map(|falls| (weight, falls))
    });
    let level = ToldBy::of(told.collect(), placement::LEVEL..PARAMETERS);
    let near = scans.spread(&excluded);
    let told = Some(()).filter(|()| sought).and_then(|()| scans.pair.told_by(placement, &near));
    let place = told.map(|told| (told, map.elements(), scans.pair.deviation()));
    let uncertainty = Uncertainty { noise, falls: &falls, level, place };
    sums::Sums { scans, round, map, uncertainty, sought }.difference()
}

/// The map, or means over its blocks where it has very many points.
fn few(map: &HeightMap) -> HeightMap {
    let mut side = 1;
    while map.heights().len() / (side * side) > POINTS {
        side += 2;
    }
    blocks::means(map, side).unwrap_or_else(|| map.clone())
}

/// The points of a map within a rectangle (m).
fn inside(map: &HeightMap, [x, y]: [[f64; 2]; 2]) -> Vec<bool> {
    let nx = map.elements()[0];
    let within = |at: usize| {
        let place = [map.place(0, at % nx), map.place(1, at / nx)];
        [x, y].iter().zip(place).all(|([low, high], place)| (low..=high).contains(&&place))
    };
    (0..map.heights().len()).map(within).collect()
}
