//! What is worn between two scans of a surface: the later one laid on the earlier one, and subtracted.
//!
//! [`Difference::between`] finds how the later map lies on the earlier one (shift, turn and a plane) by what did not wear, where
//! the surface changed, and the volumes worn off and piled up, with their uncertainties:
//!
//! 1. spikes of either scan become points that were not measured;
//! 2. directions of slopes are correlated for the place to a pixel (`start`), and most patches that agree have the plane (`level`);
//! 3. shift, turn and plane are fitted with weights by which what changed hardly counts (`fit`), to splines of the earlier scan (`sample`);
//! 4. the covariance of what is left gives the noise (`noise`), by which regions of wear and pile-up stand out (`region`);
//! 5. these are left out, and all from the fit on is done again until they stay (`rounds`);
//! 6. a difference that keeps the texture is of two places, and refused (`kept`);
//! 7. changes are summed over regions with their signs, so that noise adds nothing, and over gaps in them (`gaps`); the same covariance is
//!    propagated into the sums (`volume`).
//!
//! Calibration of the instrument is in no uncertainty: scale errors are those of the volume.

mod blocks;
mod depth;
mod fit;
mod fourier;
mod gaps;
mod kept;
mod level;
mod noise;
mod placement;
mod refusal;
mod region;
mod rounds;
mod sample;
mod scar;
mod section;
mod slopes;
mod solve;
mod start;
mod sums;
mod volume;
mod walls;

#[cfg(test)]
mod tests;

use kept::MOST as MOST_KEPT;
use rounds::{FEWEST, Round, Scans};
use start::Start;
use volume::Uncertainty;

pub use placement::Placement;
pub use refusal::NoDifference;
pub use scar::Scar;
pub use section::SectionPoint;
pub use volume::Uncertain;

use crate::map::HeightMap;

/// Points of a map, at most; larger maps are averaged over blocks first, which keeps volumes.
const POINTS: usize = 1_500_000;
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
    /// The direction from the x axis (rad) along which the shift is not known to a point: that of the lay. `None` if all are.
    pub undetermined: Option<f64>,
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
    /// Greatest depth (m), of a polynomial of the fourth degree around it. That of a flat bottom is too great by up to four of its
    /// standard uncertainties: noise has a maximum, too.
    pub depth: Uncertain,
    /// Where that is (m), on the later map.
    pub deepest: [f64; 2],
    /// Area (m^2) that stands out as worn.
    pub area: f64,
    /// The largest of the worn regions.
    pub scar: Scar,
    /// Standard deviation (m) of what did not wear.
    pub scatter: f64,
    /// Length (m) of a square over which noise is correlated.
    pub alike: f64,
    /// Points without a height in worn regions, whose change was taken from those around them.
    pub missing: usize,
    /// Whether the deepest part was not measured, so that at least that volume is worn.
    pub at_least: bool,
    /// Whether a worn region reaches the rim of the overlap, so that more may be worn beyond it.
    pub reaches_rim: bool,
}

impl Difference {
    /// What changed from an earlier map to a later one.
    ///
    /// # Errors
    /// If the maps do not overlap, the one is not found in the other, nothing or too much is worn, or the part that is given does not exist.
    pub fn between(
        before: &HeightMap,
        after: &HeightMap,
        options: &Options,
    ) -> Result<Self, NoDifference> {
        let [before, after] = [before, after].map(|map| few(&map.clear().0));
        let part = options.worn.map(|[x, y]| inside(&after, [x, y]));
        if let Some(part) = &part {
            let (within, beyond): (Vec<usize>, Vec<usize>) = (0..part.len())
                .filter(|&at| !after.heights()[at].is_nan())
                .partition(|&at| part[at]);
            let [inside, outside] = [within.len(), beyond.len()];
            if inside.min(outside) < FEWEST {
                return Err(NoDifference::Part { inside, outside, least: FEWEST });
            }
        }
        let mut scans = Scans::of(before, after, part);
        let placed = Start { placement: Placement::default(), pixel: scans.pixel, at_limit: false };
        if options.placed {
            scans.as_measured();
            let round = scans.laid(placed, false)?;
            return found(&scans, &round);
        }
        let start = start::found(&scans.before, &scans.after, options.turn);
        let mut round = scans.laid(start, true)?;
        let kept = scans.kept(&round);
        if kept.hidden {
            scans.as_measured();
            round = scans.laid(placed, false)?;
        } else if kept.share > MOST_KEPT {
            return Err(match start.at_limit {
                true => NoDifference::Turned { turn: options.turn },
                false => NoDifference::Different { kept: kept.share, most: MOST_KEPT },
            });
        }
        found(&scans, &round)
    }
}

/// What came of the last round.
fn found(scans: &Scans, round: &Round) -> Result<Difference, NoDifference> {
    let falls: Vec<_> =
        scans.changes(&round.placement).iter().map(|own| own.map(|own| own.1)).collect();
    let told = scans.told(round, &falls);
    let uncertainty = Uncertainty { noise: &round.noise, falls: &falls, told };
    let map = scans.after.of_heights(round.change.clone());
    sums::Sums { scans, round, map, uncertainty }.difference()
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
