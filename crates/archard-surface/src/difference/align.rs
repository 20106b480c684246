//! The later map laid on the earlier one, and whether it belongs there.

use super::blocks::smoothed;
use super::fit::{Fitted, Points, weight};
use super::level::{PATCHES, robust};
use super::noise::Noise;
use super::placement::{PARAMETERS, Placement};
use super::refusal::NoDifference;
use super::region::{FALSE_ALARM, NARROWEST, exceeded};
use super::start;
use super::volume::ToldBy;
use crate::filter::gaussian;
use crate::level::Level;
use crate::map::HeightMap;
use crate::outliers::median;

/// Points that a placement is fitted to, at most. A choice of cost.
const POINTS: usize = 20_000;
/// Fewest points in common: one in each patch of the first level.
pub(super) const FEWEST: usize = PATCHES * PATCHES;
/// Points that count as one in means over noise without texture: one, and some chance.
const FEATURELESS: f64 = 2.0;

/// Both maps level and smoothed for their slopes, which noise would hide.
///
/// Interpolated noise scatters less between points than on them, and differences would be least half-way (pixel locking). Smoothed
/// by 1.5 points it scatters alike everywhere.
pub(super) struct Pair {
    level: [HeightMap; 2],
    /// The earlier one, smoothed.
    pub(super) before: HeightMap,
    after: HeightMap,
    /// Both, smoothed, without their rims.
    inner: [HeightMap; 2],
    /// Width (m) of their Gaussian.
    width: f64,
    pub(super) reach: f64,
}

/// How the maps lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Aligned {
    pub(super) placement: Placement,
    /// Whether shift and turn were found, not taken as measured.
    pub(super) sought: bool,
}

impl Pair {
    pub(super) fn of(before: &HeightMap, after: &HeightMap) -> Self {
        let level =
            [before, after].map(|map| map.levelled(Level::Plane).unwrap_or_else(|_| map.clone()));
        let pixel = [before, after].iter().flat_map(|map| map.pixel()).fold(0.0, f64::max);
        let width = NARROWEST * pixel;
        let [earlier, later] = [0, 1].map(|own| by_gaussian(&level[own], width));
        let inner = [whole(&level[0], &earlier, width), whole(&level[1], &later, width)];
        let [x, y] = after.size();
        Self { level, before: earlier, after: later, inner, width, reach: 0.5 * x.hypot(y) }
    }

    /// The placement found by all points but those excluded, from the directions of slopes or the place as measured, whichever fits
    /// better.
    ///
    /// # Errors
    /// If the maps do not overlap, or the one is not found in the other.
    pub(super) fn sought(&self, turn: f64, excluded: &[bool]) -> Result<Aligned, NoDifference> {
        let [before, after] = &self.level;
        let start = start::found(before, after, turn);
        let mut best: Option<(Fitted, f64)> = None;
        for (placement, tried) in [(start.placement, start.tried), (Placement::default(), 1.0)] {
            let Some(fitted) = self.from(placement, start.pixel, excluded) else { continue };
            if best.as_ref().is_none_or(|(best, _)| fitted.scatter < best.scatter) {
                best = Some((fitted, tried));
            }
        }
        let Some((fitted, tried)) = best else {
            return Err(NoDifference::NoOverlap { points: 0, least: FEWEST });
        };
        let texture = Noise::of(before.elements(), before.heights());
        let (correlation, chance) = self.correlation(&fitted, tried, excluded);
        match (correlation > chance, texture.alike < FEATURELESS) {
            (true, _) => Ok(Aligned { placement: fitted.placement, sought: true }),
            (false, true) => Ok(Aligned { placement: Placement::default(), sought: false }),
            (false, false) => Err(NoDifference::Different { correlation, chance }),
        }
    }

    /// What tells the place: points and their weights as [`refined`](Self::refined) has them.
    pub(super) fn told_by(&self, placement: &Placement, excluded: &[bool]) -> Option<ToldBy> {
        let [before, after] = &self.inner;
        let fitted = self.points(before, after, excluded).fitted(*placement, true)?;
        let stride = stride(after);
        let nx = after.elements()[0];
        let own = |at: usize| {
            let kept = (at % nx).is_multiple_of(stride)
                && (at / nx).is_multiple_of(stride)
                && !excluded[at];
            let point = point(after, at).filter(|_| kept)?;
            let (change, falls) = fitted.placement.change(before, point, self.reach)?;
            Some((weight(change, fitted.scatter), falls))
        };
        let points = (0..after.heights().len()).map(own).collect();
        Some(ToldBy::of(points, 0..PARAMETERS))
    }

    /// The Gaussian of the smoothed maps (points of the later one along x and y).
    pub(super) fn deviation(&self) -> [f64; 2] {
        self.after.pixel().map(|own| self.width / own)
    }

    /// A placement made better by all points that are not excluded.
    pub(super) fn refined(&self, placement: Placement, excluded: &[bool]) -> Option<Fitted> {
        let [before, after] = &self.inner;
        self.points(before, after, excluded).fitted(placement, true)
    }

    /// The placement from a start that is known to a pixel (m): on smooth maps first.
    fn from(&self, start: Placement, pixel: f64, excluded: &[bool]) -> Option<Fitted> {
        let finest = self.before.pixel().into_iter().chain(self.after.pixel()).fold(0.0, f64::max);
        let mut width = pixel * NARROWEST;
        let mut placement = start;
        let mut first = true;
        loop {
            let fine = width <= finest * NARROWEST * 1.01;
            let fitted = if fine {
                self.stage((&self.before, &self.after), placement, first, excluded)?
            } else {
                let [before, after] = [0, 1].map(|own| by_gaussian(&self.level[own], width));
                self.stage((&before, &after), placement, first, excluded)?
            };
            if fine {
                return Some(fitted);
            }
            (placement, first) = (fitted.placement, false);
            width = (0.5 * width).max(finest * NARROWEST);
        }
    }

    fn stage(
        &self,
        (before, after): (&HeightMap, &HeightMap),
        placement: Placement,
        first: bool,
        excluded: &[bool],
    ) -> Option<Fitted> {
        let points = self.points(before, after, excluded);
        let start = if first { levelled(&points, placement)? } else { placement };
        points.fitted(start, true)
    }

    fn points<'a>(
        &self,
        before: &'a HeightMap,
        after: &HeightMap,
        excluded: &[bool],
    ) -> Points<'a> {
        let stride = stride(after);
        let nx = after.elements()[0];
        let kept =
            |at: &usize| (at % nx).is_multiple_of(stride) && (at / nx).is_multiple_of(stride);
        let all = (0..after.heights().len()).filter(kept).filter(|&at| !excluded[at]);
        Points { before, after: all.filter_map(|at| point(after, at)).collect(), reach: self.reach }
    }

    /// The correlation of heights at a placement where they agree, and what chance would make of unlike surfaces, by Fisher's
    /// transformation and as many independent points as the texture has.
    fn correlation(&self, fitted: &Fitted, tried: f64, excluded: &[bool]) -> (f64, f64) {
        let points = self.points(&self.before, &self.after, excluded);
        let mut pairs = vec![];
        for (place, height) in &points.after {
            let own = (*place, *height);
            let Some((change, _)) = fitted.placement.change(&self.before, own, self.reach) else {
                continue;
            };
            if weight(change, fitted.scatter) > 0.0 {
                let later = height - fitted.placement.level(*place);
                pairs.push([later - change, later]);
            }
        }
        let count = pairs.len() as f64;
        let mean = [0, 1].map(|own| pairs.iter().map(|pair| pair[own]).sum::<f64>() / count);
        let moment = |one: usize, other: usize| -> f64 {
            pairs.iter().map(|pair| (pair[one] - mean[one]) * (pair[other] - mean[other])).sum()
        };
        let size = (moment(0, 0) * moment(1, 1)).sqrt();
        let correlation = if size > 0.0 { moment(0, 1) / size } else { 0.0 };
        let texture = Noise::of(self.before.elements(), self.before.heights());
        let cell = |map: &HeightMap| map.pixel()[0] * map.pixel()[1];
        let share = count / points.after.len() as f64;
        let area = share * self.after.heights().len() as f64 * cell(&self.after);
        let independent = area / (texture.alike * cell(&self.before));
        let chance = exceeded(FALSE_ALARM / tried) / (independent - 3.0).max(1.0).sqrt();
        (correlation, chance.tanh())
    }
}

/// Every how manyth point along each axis counts.
fn stride(map: &HeightMap) -> usize {
    (map.heights().len() as f64 / POINTS as f64).sqrt().ceil() as usize
}

/// The place (m) and height (m) of a point; `None` if it has none.
pub(super) fn point(map: &HeightMap, at: usize) -> Option<([f64; 2], f64)> {
    let nx = map.elements()[0];
    let height = map.heights()[at];
    (!height.is_nan()).then(|| ([map.place(0, at % nx), map.place(1, at / nx)], height))
}

/// The placement with the plane that half of the patches have.
pub(super) fn levelled(points: &Points<'_>, placement: Placement) -> Option<Placement> {
    let flat = Placement { offset: 0.0, tilt: [0.0; 2], ..placement };
    let change =
        |own: &([f64; 2], f64)| Some((own.0, flat.change(points.before, *own, points.reach)?.0));
    let changes: Vec<([f64; 2], f64)> = points.after.iter().filter_map(change).collect();
    let corners =
        changes.iter().fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |ends, (place, _)| {
            [
                [0, 1].map(|axis| ends[0][axis].min(place[axis])),
                [0, 1].map(|axis| ends[1][axis].max(place[axis])),
            ]
        });
    let (offset, tilt) = robust(&changes, corners)?;
    Some(Placement { offset, tilt, ..placement })
}

/// A map smoothed by a Gaussian of that width (m).
fn by_gaussian(map: &HeightMap, width: f64) -> HeightMap {
    map.of_heights(smoothed(map.elements(), map.heights(), map.pixel().map(|own| width / own)))
}

/// Share of the usual weights below which a point is one-sided: the Gaussian moves the surface there.
const WHOLE: f64 = 0.98;

/// A smoothed map without the points beside the rim and holes of the one that was smoothed.
fn whole(map: &HeightMap, smooth: &HeightMap, width: f64) -> HeightMap {
    let all = gaussian(map.elements(), map.heights(), map.pixel().map(|own| width / own));
    let known = all.iter().filter(|(mean, _)| !mean.is_nan()).map(|(_, share)| *share);
    let least = WHOLE * median(&mut known.collect::<Vec<f64>>()).unwrap_or(0.0);
    let own = |((_, share), height): ((f64, f64), &f64)| {
        if share < least { f64::NAN } else { *height }
    };
    map.of_heights(all.into_iter().zip(smooth.heights()).map(own).collect())
}
