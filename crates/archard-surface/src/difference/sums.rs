//! What regions amount to.

use std::f64::consts::PI;

use super::blocks::smoothed;
use super::placement::{PARAMETERS, Placement};
use super::region::{NARROWEST, Region};
use super::volume::{Uncertain, Uncertainty};
use super::{Difference, NoDifference, Round, Scans, Scar};
use crate::map::HeightMap;

/// The standard deviation of an even distribution is its half width over this.
const EVEN: f64 = 1.732_050_807_568_877_2;

/// The last round, and the uncertainty of its sums.
pub(super) struct Sums<'a> {
    pub(super) scans: &'a Scans,
    pub(super) round: &'a Round,
    /// Changes (m).
    pub(super) map: HeightMap,
    pub(super) uncertainty: Uncertainty<'a>,
    pub(super) sought: bool,
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
            region
                .points()
                .iter()
                .map(|&at| -self.round.change[at])
                .filter(|one| one.is_finite())
                .sum()
        };
        let Some(largest) =
            worn.iter().max_by(|one, other| removed(one).total_cmp(&removed(other)))
        else {
            let [depth, width] = self.round.least;
            let scatter = self.round.noise.variance.sqrt();
            return Err(match self.round.noise.endless {
                true => NoDifference::NoReference { scatter },
                false => NoDifference::NothingWorn { depth, width },
            });
        };
        let filled = self.map.filled().unwrap_or_else(|_| self.map.clone());
        let (depth, deepest) = self.depth(&worn);
        let cell = self.map.pixel()[0] * self.map.pixel()[1];
        let mut labels = vec![0; self.round.change.len()];
        for region in worn.iter().chain(&piled) {
            region.points().iter().for_each(|&at| labels[at] = if region.worn { -1 } else { 1 });
        }
        let points = worn.iter().flat_map(|region| region.points());
        let known = self.round.change.iter().filter(|change| !change.is_nan()).count();
        Ok(Difference {
            placement: self.round.placement,
            uncertainty: self.of_placement(),
            sought: self.sought,
            overlap: known as f64 / self.round.change.len() as f64,
            count: [worn.len(), piled.len()],
            worn: self.volume(&worn, &filled, -1.0),
            piled: (!piled.is_empty()).then(|| self.volume(&piled, &filled, 1.0)),
            net: self.volume(&[&worn[..], &piled[..]].concat(), &filled, -1.0),
            depth,
            deepest,
            area: cell * worn.iter().map(|region| region.seeds.len()).sum::<usize>() as f64,
            scar: Scar::of(&self.map, &largest.seeds),
            scatter: self.round.noise.variance.sqrt(),
            alike: (self.round.noise.alike * cell).sqrt(),
            missing: points.filter(|&&at| self.round.change[at].is_nan()).count(),
            reaches_rim: worn
                .iter()
                .flat_map(|region| &region.seeds)
                .any(|&at| self.at_the_rim(at)),
            regions: labels,
            change: self.map,
        })
    }

    /// A volume (m^3) over regions, `sign` times the change.
    fn volume(&self, regions: &[&Region], filled: &HeightMap, sign: f64) -> Uncertain {
        let cell = self.map.pixel()[0] * self.map.pixel()[1] * sign;
        let mut weights = vec![0.0; self.round.change.len()];
        let mut bridged = 0.0;
        for &at in regions.iter().flat_map(|region| region.points()) {
            match self.round.change[at].is_nan() {
                true => bridged += cell * filled.heights()[at],
                false => weights[at] = cell,
            }
        }
        let over = |points: fn(&Region) -> &[usize]| -> f64 {
            regions
                .iter()
                .flat_map(|region| points(region))
                .map(|&at| cell * filled.heights()[at])
                .sum()
        };
        let own = over(Region::points);
        let ring = [over(Region::inner), over(Region::outer)].map(|other| (other - own).abs());
        let edge = (ring[0].max(ring[1]) / EVEN).hypot(0.5 * bridged / EVEN);
        self.uncertainty.of(own, &weights, edge)
    }

    /// The greatest depth (m) of worn regions and where it is (m).
    fn depth(&self, worn: &[&Region]) -> (Uncertain, [f64; 2]) {
        let (elements, pixel) = (self.map.elements(), self.map.pixel());
        let width = NARROWEST * pixel[0].max(pixel[1]);
        let smooth = smoothed(elements, self.map.heights(), pixel.map(|own| width / own));
        let all =
            worn.iter().flat_map(|region| &region.seeds).filter(|&&at| smooth[at].is_finite());
        let at = all
            .min_by(|&&one, &&other| smooth[one].total_cmp(&smooth[other]))
            .copied()
            .unwrap_or(0);
        let place =
            |at: usize| [self.map.place(0, at % elements[0]), self.map.place(1, at / elements[0])];
        let deepest = place(at);
        let weight = |at: usize| {
            let [x, y] = place(at);
            let far = (x - deepest[0]).hypot(y - deepest[1]) / width;
            let share = pixel[0] * pixel[1] / (2.0 * PI * width * width);
            if self.round.change[at].is_nan() { 0.0 } else { -share * (-0.5 * far * far).exp() }
        };
        let mut weights: Vec<f64> = (0..smooth.len()).map(weight).collect();
        let all: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|one| *one /= -all);
        (self.uncertainty.of(-smooth[at], &weights, 0.0), deepest)
    }

    /// Standard uncertainties of the placement.
    fn of_placement(&self) -> Placement {
        let deviation = |one: usize| {
            let mut factors = [0.0; PARAMETERS];
            factors[one] = 1.0;
            self.uncertainty.of_numbers(factors)
        };
        let by: [f64; PARAMETERS] = std::array::from_fn(deviation);
        Placement::default().changed(by, self.scans.pair.reach)
    }

    /// Whether a neighbour of a point lies beyond one of the maps.
    fn at_the_rim(&self, at: usize) -> bool {
        let [nx, ny] = self.map.elements();
        let (x, y) = (at % nx, at / nx);
        if x == 0 || y == 0 || x + 1 == nx || y + 1 == ny {
            return true;
        }
        [at - 1, at + 1, at - nx, at + nx].into_iter().any(|at| {
            let place = [self.map.place(0, at % nx), self.map.place(1, at / nx)];
            let earlier = self.round.placement.on_the_earlier(place);
            let before = &self.scans.before;
            // Interpolation needs two points beyond the place.
            (0..2).any(|axis| {
                earlier[axis].abs() > 0.5 * before.size()[axis] - 2.5 * before.pixel()[axis]
            })
        })
    }
}
