//! What regions amount to.

use super::blocks::smoothed;
use super::depth::{self, Deepest};
use super::gaps::{Gaps, Surface};
use super::placement::{PARAMETERS, Placement};
use super::region::{NARROWEST, Region};
use super::rounds::{Round, Scans};
use super::volume::{Besides, Uncertain, Uncertainty};
use super::{Difference, NoDifference, Scar, slopes, walls};
use crate::map::HeightMap;

/// The variance of an even distribution over its half width squared is one over this, that of a triangle one over twice as much.
const EVEN: f64 = 3.0;
/// A gap is deeper than all that was measured where its plate is by a tenth, or by as many standard deviations as no noise has.
const DEEPER: f64 = 1.1;
const NOISE: f64 = 6.0;

/// The last round, and the uncertainty of its sums.
pub(super) struct Sums<'a> {
    pub(super) scans: &'a Scans,
    pub(super) round: &'a Round,
    /// Changes (m).
    pub(super) map: HeightMap,
    pub(super) uncertainty: Uncertainty<'a>,
}

/// Gaps in regions, filled.
struct Filled {
    plate: Gaps,
    /// Changes (m) with the plate in gaps, and with the membrane.
    by_plate: HeightMap,
    by_membrane: HeightMap,
    /// Half of the range (m) of changes around points in wide gaps.
    ranges: Vec<(usize, f64)>,
}

impl Sums<'_> {
    pub(super) fn difference(self) -> Result<Difference, NoDifference> {
        let regions = &self.round.regions;
        let mut worn: Vec<&Region> = regions.iter().filter(|region| region.worn).collect();
        let piled: Vec<&Region> = regions.iter().filter(|region| !region.worn).collect();
        // A part that was given is integrated though nothing stands out of it.
        let given = self.scans.part.as_ref().filter(|_| worn.is_empty()).map(|part| {
            Region::whole(
                (0..part.len()).filter(|&at| part[at] && self.round.change[at].is_finite()),
            )
        });
        worn.extend(&given);
        let removed = |region: &&&Region| -> f64 {
            let changes = region.points().iter().map(|&at| -self.round.change[at]);
            changes.filter(|one| one.is_finite()).sum()
        };
        let Some(largest) =
            worn.iter().max_by(|one, other| removed(one).total_cmp(&removed(other)))
        else {
            let [depth, width] = self.round.least;
            let scatter = self.round.noise.variance.sqrt().hypot(self.bend());
            return Err(match self.round.noise.endless || self.round.sought.form {
                true => NoDifference::NoReference { scatter },
                false => NoDifference::NothingWorn { depth, width },
            });
        };
        let both = [&worn[..], &piled[..]].concat();
        let filled = self.filled(&both);
        let (depth, deepest) = self.depth(&worn, &filled);
        let cell = self.map.pixel()[0] * self.map.pixel()[1];
        let mut labels = vec![0; self.round.change.len()];
        for region in &both {
            region.points().iter().for_each(|&at| labels[at] = if region.worn { -1 } else { 1 });
        }
        let points = self.mask(&worn);
        let known = self.round.change.iter().filter(|change| !change.is_nan()).count();
        let missing = |at: &usize| points[*at] && self.round.change[*at].is_nan();
        let net = self.volume(&both, &filled, -1.0);
        let (uncertainty, undetermined) = self.of_placement();
        Ok(Difference {
            placement: self.round.placement,
            uncertainty,
            sought: self.round.sought.place,
            undetermined,
            overlap: known as f64 / self.round.change.len() as f64,
            count: [worn.len(), piled.len()],
            worn: if piled.is_empty() { net } else { self.volume(&worn, &filled, -1.0) },
            piled: (!piled.is_empty()).then(|| self.volume(&piled, &filled, 1.0)),
            net,
            depth,
            deepest,
            area: cell * worn.iter().map(|region| region.seeds.len()).sum::<usize>() as f64,
            scar: Scar::of(&self.map, &largest.seeds),
            scatter: self.round.noise.variance.sqrt(),
            alike: (self.round.noise.alike * cell).sqrt(),
            missing: (0..points.len()).filter(missing).count(),
            at_least: self.is_deeper(&points, &filled),
            reaches_rim: worn
                .iter()
                .flat_map(|region| &region.seeds)
                .any(|&at| self.at_the_rim(at)),
            regions: labels,
            change: self.map,
        })
    }

    /// Standard deviation (m) of what the form adds to the plane, over the map.
    fn bend(&self) -> f64 {
        let [xx, xy, yy] = self.round.placement.form;
        let [x, y] = self.map.size().map(|size| size * size / 12.0);
        // Of even distributions x^2 has 4/5 of the square of its mean as variance.
        (0.8 * ((xx * x).powi(2) + (yy * y).powi(2)) + xy * xy * x * y).sqrt()
    }

    /// The points of regions that are on both maps.
    fn mask(&self, regions: &[&Region]) -> Vec<bool> {
        let mut mask = vec![false; self.round.change.len()];
        for &at in regions.iter().flat_map(|region| region.points()) {
            mask[at] = self.scans.holds(&self.round.placement, at);
        }
        mask
    }

    /// The gaps of regions, filled.
    fn filled(&self, regions: &[&Region]) -> Filled {
        let mut wanted = self.mask(regions);
        // A gap goes on beyond the rim of its region.
        for &at in regions.iter().flat_map(|region| region.around()) {
            wanted[at] = self.scans.holds(&self.round.placement, at);
        }
        let plate = Gaps::of(&self.map, &wanted, Surface::Plate);
        let by_plate = plate.filled(&self.map);
        let by_membrane = Gaps::of(&self.map, &wanted, Surface::Membrane).filled(&self.map);
        let ranges = plate.ranges(&self.map);
        Filled { plate, by_plate, by_membrane, ranges }
    }

    /// Whether a wide gap of a region is deeper than all that was measured in it.
    fn is_deeper(&self, mask: &[bool], filled: &Filled) -> bool {
        let own = |at: usize| -self.round.change[at];
        let deepest = (0..mask.len())
            .filter(|&at| mask[at] && !own(at).is_nan())
            .map(own)
            .fold(0.0, f64::max);
        let least = (DEEPER * deepest).max(NOISE * self.round.scatter);
        let mut gaps = filled.ranges.iter().filter(|(at, _)| mask[*at]);
        gaps.any(|(at, _)| -filled.by_plate.heights()[*at] > least)
    }

    /// A volume (m^3) over regions, `sign` times the change.
    fn volume(&self, regions: &[&Region], filled: &Filled, sign: f64) -> Uncertain {
        let cell = self.map.pixel()[0] * self.map.pixel()[1] * sign;
        let mask = self.mask(regions);
        let missing = |at: usize| self.round.change[at].is_nan();
        let own = |at: usize| if mask[at] { cell } else { 0.0 };
        let mut weights: Vec<f64> =
            (0..mask.len()).map(|at| if missing(at) { 0.0 } else { own(at) }).collect();
        let heights = filled.by_plate.heights();
        let inside = || (0..mask.len()).filter(|&at| mask[at]);
        // A hole without any point around stays one.
        let value: f64 = inside().map(|at| cell * heights[at]).filter(|one| one.is_finite()).sum();
        let mut besides = Besides::default();
        if inside().any(missing) {
            let gaps: Vec<f64> = (0..mask.len()).map(own).collect();
            let around = filled.plate.weights(&gaps);
            weights.iter_mut().zip(around).for_each(|(one, more)| *one += more);
            let off = |at: usize| heights[at] - filled.by_membrane.heights()[at];
            let between: f64 = inside().filter(|&at| missing(at)).map(off).sum();
            // Walls that no point shows have one cause: their errors are added as they are.
            let wide = filled.ranges.iter().filter(|(at, _)| mask[*at]);
            let range: f64 = wide.map(|(_, half)| half).sum();
            besides.missing =
                cell.abs() * (between.powi(2) / EVEN + range.powi(2) / (2.0 * EVEN)).sqrt();
        }
        // One ring more, as far as it is no noise, and a third of it as it may end anywhere.
        let mut ring = vec![0.0; mask.len()];
        for &at in regions.iter().flat_map(|region| region.around()) {
            ring[at] = if missing(at) || mask[at] { 0.0 } else { cell };
        }
        let more: f64 = ring
            .iter()
            .zip(&self.round.change)
            .filter(|(weight, _)| **weight != 0.0)
            .map(|(weight, change)| weight * change)
            .sum();
        let chance = self.uncertainty.variance_of(&ring);
        let edge = (more * more - chance).max(0.0) + chance / EVEN;
        besides.edge = (edge + walls::variance(&filled.by_plate, &mask, self.round.scatter)).sqrt();
        self.uncertainty.of(value, &weights, besides)
    }

    /// The greatest depth (m) of worn regions and where it is (m).
    fn depth(&self, worn: &[&Region], filled: &Filled) -> (Uncertain, [f64; 2]) {
        let (elements, pixel) = (self.map.elements(), self.map.pixel());
        let mask = self.mask(worn);
        let own = |at: usize| {
            let height = filled.by_plate.heights()[at];
            if mask[at] && height.is_finite() { height } else { 0.0 }
        };
        let widest = pixel[0].max(pixel[1]);
        let deviation = pixel.map(|own| NARROWEST * widest / own);
        let smooth = smoothed(elements, &(0..mask.len()).map(own).collect::<Vec<f64>>(), deviation);
        let inside = (0..mask.len()).filter(|&at| mask[at]);
        let place =
            |at: usize| [self.map.place(0, at % elements[0]), self.map.place(1, at / elements[0])];
        let lowest =
            inside.min_by(|&one, &other| smooth[one].total_cmp(&smooth[other])).unwrap_or(0);
        let middle = place(lowest);
        let area = mask.iter().filter(|own| **own).count() as f64 * pixel[0] * pixel[1];
        let radius = depth::radius(area, widest);
        let points: Vec<(usize, [f64; 2], f64)> = (0..mask.len())
            .filter(|&at| mask[at] && !self.round.change[at].is_nan())
            .map(|at| (at, place(at), -self.round.change[at]))
            .filter(|(_, [x, y], _)| (x - middle[0]).hypot(y - middle[1]) <= radius)
            .collect();
        let mut weights = vec![0.0; mask.len()];
        let fitted = Some(()).filter(|()| !self.is_deeper(&mask, filled));
        let fitted = fitted.and_then(|()| depth::found(&points, middle, radius));
        let Some(Deepest { depth, place, weights: own, scatter, whole }) = fitted else {
            // Nothing was measured there: the plate goes on to at least that depth.
            let off = filled.by_plate.heights()[lowest] - filled.by_membrane.heights()[lowest];
            let range = filled.ranges.iter().find(|(at, _)| *at == lowest).map_or(0.0, |own| own.1);
            let missing = (off.powi(2) / EVEN + range.powi(2) / (2.0 * EVEN)).sqrt();
            let besides = Besides { edge: 0.0, missing };
            return (self.uncertainty.of(-smooth[lowest], &weights, besides), middle);
        };
        own.into_iter().for_each(|(at, weight)| weights[at] = -weight);
        // What the polynomial leaves, of as many points as count by themselves.
        let left = scatter * (self.round.noise.alike / points.len() as f64).sqrt();
        // What few points leave out, the plate has.
        let plate = -filled.by_plate.heights()[lowest];
        let mut missing = if whole { 0.0 } else { (plate - depth).abs() };
        let mut value = depth;
        let bottom = self.bottom(&mask, (&smooth, lowest), deviation);
        if bottom.len() as f64 * pixel[0] * pixel[1] > std::f64::consts::PI * radius * radius {
            // Flat as far as noise lets anyone see, the bottom lies at its mean; round, at its deepest place.
            let mean =
                -bottom.iter().map(|&at| self.round.change[at]).sum::<f64>() / bottom.len() as f64;
            value = 0.5 * (depth + mean);
            missing = missing.hypot(0.5 * (depth - mean).abs() / EVEN.sqrt());
        }
        (self.uncertainty.of(value, &weights, Besides { edge: left, missing }), place)
    }

    /// Measured points of a mask that noise alone may set apart from the lowest one of smoothed changes (m): a flat bottom spreads by
    /// the height that one hill of smoothed noise reaches in the mean, to both sides.
    fn bottom(
        &self,
        mask: &[bool],
        (smooth, lowest): (&[f64], usize),
        deviation: [f64; 2],
    ) -> Vec<usize> {
        let noise = self.round.noise.smoothed(deviation);
        let side = (mask.iter().filter(|own| **own).count() as f64).sqrt() as usize;
        let height = noise.height_of(1.0, [side; 2]);
        let within = smooth[lowest] + 2.0 * height * noise.deviation;
        let is = |&at: &usize| mask[at] && smooth[at] <= within && !self.round.change[at].is_nan();
        (0..mask.len()).filter(is).collect()
    }

    /// Standard uncertainties of the placement, and the direction along which the shift is open.
    fn of_placement(&self) -> (Placement, Option<f64>) {
        let of = |numbers: &[usize]| {
            let mut factors = [0.0; PARAMETERS];
            numbers.iter().for_each(|&one| factors[one] = 1.0);
            self.uncertainty.of_numbers(factors)
        };
        let by: [f64; PARAMETERS] = std::array::from_fn(|one| of(&[one]));
        let by = Placement::default().changed(by, self.scans.reach);
        if !self.round.sought.place {
            return (by, None);
        }
        let [xx, yy, sum] = [by.shift[0], by.shift[1], of(&[0, 1])].map(|own| own * own);
        let known = slopes::known(self.scans, self.round, [xx, 0.5 * (sum - xx - yy), yy]);
        (Placement { shift: known.by, ..by }, known.open)
    }

    /// Whether a neighbour of a point lies beyond one of the maps.
    fn at_the_rim(&self, at: usize) -> bool {
        let [nx, ny] = self.map.elements();
        let (x, y) = (at % nx, at / nx);
        if x == 0 || y == 0 || x + 1 == nx || y + 1 == ny {
            return true;
        }
        let near = [at - 1, at + 1, at - nx, at + nx];
        near.into_iter().any(|at| !self.scans.holds(&self.round.placement, at))
    }
}
