//! Place, level, noise and regions in turns, until regions stay.

use super::fit::{Fitted, Points, Sought, weight};
use super::kept::{Kept, kept};
use super::level::{self, densest};
use super::noise::Noise;
use super::placement::{PARAMETERS, Placement};
use super::refusal::NoDifference;
use super::region::{Changes, Region};
use super::sample::{Spline, missed};
use super::start::Start;
use super::volume::ToldBy;
use crate::filter::gaussian;
use crate::map::HeightMap;
use crate::outliers::rounding;

/// Points that the first fit counts, at most. A choice of cost.
const POINTS: usize = 20_000;
/// Rounds at most, and the one from which on regions only grow: what changes sides at their edge has no end else.
const ROUNDS: usize = 10;
const GROWING: usize = 5;
/// Standard deviations beyond which a point is no noise, as long as nothing is known of regions.
const NOISE: f64 = 6.0;
/// The chi-square of three numbers that chance exceeds once in twenty times: a form that is less is within the noise.
const CHANCE: f64 = 7.815;
/// How many times what interpolation misses is taken where nothing seems to be as it was: 68 % of places have no more than that once, and
/// the steepest several times as much.
const MISSED: f64 = 5.0;
/// Share of the overlap above which another level is tried: most of it.
const MOST: f64 = 0.5;
/// Share of the overlap that may have changed.
const CHANGED: f64 = 0.95;

/// Both scans, and where wear is to be found.
pub(super) struct Scans {
    pub(super) before: HeightMap,
    pub(super) after: HeightMap,
    pub(super) spline: Spline,
    pub(super) part: Option<Vec<bool>>,
    /// What heights are not known better than (m), by their steps and by interpolation.
    rounding: f64,
    missed: f64,
    floor: f64,
    pub(super) reach: f64,
    pub(super) pixel: f64,
}

/// A round: changes and regions.
pub(super) struct Round {
    pub(super) placement: Placement,
    /// Changes (m); not a number where they are not known.
    pub(super) change: Vec<f64>,
    pub(super) scatter: f64,
    pub(super) noise: Noise,
    pub(super) regions: Vec<Region>,
    /// What belongs to regions or the part.
    pub(super) excluded: Vec<bool>,
    /// Depth (m) and width (m) of what would just stand out.
    pub(super) least: [f64; 2],
    pub(super) sought: Sought,
}

impl Scans {
    pub(super) fn of(before: HeightMap, after: HeightMap, part: Option<Vec<bool>>) -> Self {
        let pixel = [&before, &after].iter().flat_map(|map| map.pixel()).fold(0.0, f64::max);
        let [x, y] = after.size();
        let rounding = rounding(&before).max(rounding(&after));
        let (spline, missed, reach) = (Spline::of(&before), missed(&before), 0.5 * x.hypot(y));
        let floor = rounding.hypot(missed);
        Self { before, after, spline, part, rounding, missed, floor, reach, pixel }
    }

    /// Nothing is interpolated between points that lie on each other.
    pub(super) fn as_measured(&mut self) {
        self.spline = Spline::of(&self.before).up_to_the_rim();
        let same = |own: fn(&HeightMap) -> [f64; 2]| own(&self.before) == own(&self.after);
        if same(HeightMap::pixel) && same(HeightMap::size) {
            self.missed = 0.0;
        }
    }

    /// The last round from a start. Where nothing is as it was the scans may differ in form, or interpolation misses more.
    ///
    /// # Errors
    /// If the maps hardly overlap, or nothing is left as it was.
    pub(super) fn laid(&mut self, start: Start, place: bool) -> Result<Round, NoDifference> {
        let mut last = Err(NoDifference::AllWorn { share: 1.0 });
        for (form, times) in [(false, 1.0), (true, 1.0), (false, MISSED)] {
            self.floor = self.rounding.hypot(times * self.missed);
            last = self.settled(start, Sought { place, form });
            if !matches!(last, Err(NoDifference::AllWorn { .. })) {
                break;
            }
        }
        // A strip of a bent scan is level, and all else seems worn: where the bent level leaves far less of it, that is the level of most.
        let share = |round: &Round| self.changed(round);
        if let Some(level) = last.as_ref().ok().filter(|own| !own.sought.form && share(own) > MOST)
        {
            let bent = self.settled(start, Sought { place, form: true });
            if let Some(bent) = bent.ok().filter(|bent| share(bent) < MOST * share(level)) {
                return Ok(bent);
            }
        }
        last
    }

    fn points(&self, map: &HeightMap, sought: Sought, kept: impl Fn(usize) -> bool) -> Points<'_> {
        let all = (0..map.heights().len()).filter(|&at| kept(at));
        let after = all.filter_map(|at| point(map, at)).collect();
        let (before, reach, pixel, floor) = (&self.spline, self.reach, self.pixel, self.floor);
        Points { before, after, reach, pixel, sought, floor }
    }

    /// From a start to the place and level of the densest plane, on smooth maps first where the start is coarse.
    fn first(&self, start: Start, sought: Sought) -> Option<Fitted> {
        let outside = |at: usize| self.part.as_ref().is_none_or(|part| !part[at]);
        let nx = self.after.elements()[0];
        let stride = (self.after.heights().len() as f64 / POINTS as f64).sqrt().ceil() as usize;
        let some = |at: usize| {
            (at % nx).is_multiple_of(stride) && (at / nx).is_multiple_of(stride) && outside(at)
        };
        let mut placement = start.placement;
        let mut width = start.pixel;
        while sought.place && width > 1.01 * self.pixel {
            let [before, after] = [&self.before, &self.after].map(|map| by_gaussian(map, width));
            let (spline, part) = (Spline::of(&before), None);
            let smooth = Self { spline, part, after, before, ..*self };
            let points = smooth.points(&smooth.after, sought, some);
            placement = points.fitted(levelled(&points, placement)?, true)?.placement;
            width *= 0.5;
        }
        let points = self.points(&self.after, sought, some);
        points.fitted(levelled(&points, placement)?, true)
    }

    /// Changes of all points, and how they fall with the numbers of a placement.
    pub(super) fn changes(&self, placement: &Placement) -> Vec<Option<(f64, [f64; PARAMETERS])>> {
        let change =
            |at: usize| placement.change(&self.spline, point(&self.after, at)?, self.reach);
        (0..self.after.heights().len()).map(change).collect()
    }

    /// Noise and regions about a fit, the first or a later one, where `excluded` does not count.
    fn round(&self, fitted: Fitted, excluded: &[bool], (sought, first): (Sought, bool)) -> Round {
        let Fitted { placement, scatter } = fitted;
        let changes = self.changes(&placement);
        let change: Vec<f64> =
            changes.iter().map(|own| own.map_or(f64::NAN, |own| own.0)).collect();
        let elements = self.after.elements();
        let rest = change.iter().zip(excluded).map(|(own, excluded)| {
            let changed = *excluded || first && own.abs() > NOISE * scatter;
            if changed { f64::NAN } else { *own }
        });
        let rest: Vec<f64> = rest.collect();
        let noise = Noise::of(elements, &rest, (sought.count(), self.floor));
        let (pixel, within) = (self.after.pixel(), self.part.as_deref());
        let found = Changes { elements, pixel, values: &change, scatter, within };
        let (regions, least) = found.regions(&noise);
        let excluded = self.excluded(&regions);
        Round { placement, change, scatter, noise, regions, excluded, least, sought }
    }

    /// Points that regions and the part take.
    fn excluded(&self, regions: &[Region]) -> Vec<bool> {
        let mut excluded =
            self.part.clone().unwrap_or_else(|| vec![false; self.after.heights().len()]);
        regions.iter().flat_map(Region::points).for_each(|&at| excluded[at] = true);
        excluded
    }

    /// Rounds until regions stay.
    ///
    /// # Errors
    /// If the maps hardly overlap, or nothing is left as it was.
    fn settled(&self, start: Start, sought: Sought) -> Result<Round, NoDifference> {
        let common = || self.changes(&start.placement).iter().flatten().count();
        let few = || NoDifference::NoOverlap { points: common(), least: FEWEST };
        if common() < FEWEST {
            return Err(few());
        }
        let mut sought = sought;
        let mut fitted = self.first(start, sought).ok_or_else(few)?;
        let mut excluded = self.excluded(&[]);
        let mut asked = sought.form;
        for number in 0..ROUNDS {
            let points = self.points(&self.after, sought, |at| !excluded[at]);
            let share = excluded.iter().filter(|own| **own).count() as f64 / excluded.len() as f64;
            // The first fit knows what changed by its cut alone.
            if number > 0 {
                fitted = points.fitted(fitted, false).ok_or(NoDifference::AllWorn { share })?;
            }
            let mut round = self.round(fitted, &excluded, (sought, number == 0));
            if number >= GROWING {
                round.excluded.iter_mut().zip(&excluded).for_each(|(one, other)| *one |= other);
            }
            let other = round.excluded.iter().zip(&excluded).filter(|(one, other)| one != other);
            let same = number > 0 && other.count() * 1000 <= excluded.len();
            if same && !asked && self.is_bent(&round, fitted) {
                sought.form = true;
            } else if same || number + 1 == ROUNDS {
                return self.judged(round);
            }
            asked |= same;
            excluded = round.excluded;
        }
        Err(NoDifference::AllWorn { share: 1.0 })
    }

    /// The round, if enough of the overlap is as it was.
    fn judged(&self, round: Round) -> Result<Round, NoDifference> {
        let share = self.changed(&round);
        if self.part.is_none() && share > CHANGED {
            return Err(NoDifference::AllWorn { share });
        }
        Ok(round)
    }

    /// The share of the overlap that changed.
    fn changed(&self, round: &Round) -> f64 {
        let known = || (0..round.change.len()).filter(|&at| !round.change[at].is_nan());
        let changed = known().filter(|&at| round.excluded[at]).count();
        changed as f64 / known().count().max(1) as f64
    }

    /// Whether what did not change differs in form by more than chance: the noise is that of a fit with the form.
    fn is_bent(&self, round: &Round, fitted: Fitted) -> bool {
        let sought = Sought { form: true, ..round.sought };
        let points = self.points(&self.after, sought, |at| !round.excluded[at]);
        let Some(bent) = points.fitted(fitted, false) else { return false };
        let own = self.round(bent, &round.excluded, (sought, false));
        // Both are known where the fit moved by no more than their rims.
        let gain: f64 = (0..own.change.len())
            .filter(|&at| !round.excluded[at])
            .map(|at| {
                let [one, other] = [round.change[at], own.change[at]];
                weight(one, round.scatter) * (one * one - other * other)
            })
            .filter(|one| !one.is_nan())
            .sum();
        gain > CHANCE * own.noise.variance * own.noise.alike
    }

    /// What is left of the texture.
    pub(super) fn kept(&self, round: &Round) -> Kept {
        kept(&self.after, &round.change, &self.weights(round), self.floor)
    }

    /// Weights of the points that did not change.
    fn weights(&self, round: &Round) -> Vec<f64> {
        let own = |at: usize| {
            let own = round.change[at];
            if round.excluded[at] || own.is_nan() { 0.0 } else { weight(own, round.scatter) }
        };
        (0..round.change.len()).map(own).collect()
    }

    /// What gives the numbers of the placement, of the changes and how they fall.
    pub(super) fn told(&self, round: &Round, falls: &[Option<[f64; PARAMETERS]>]) -> ToldBy {
        let weights = self.weights(round);
        let own = |(weight, falls): (f64, &Option<[f64; PARAMETERS]>)| {
            let mut falls = (*falls).filter(|_| weight > 0.0)?;
            let idle = (0..PARAMETERS).filter(|&number| !round.sought.has(number));
            idle.for_each(|number| falls[number] = 0.0);
            Some((weight, falls))
        };
        ToldBy::of(weights.into_iter().zip(falls).map(own).collect())
    }

    /// Whether a place on the later map is on the earlier one, too.
    pub(super) fn holds(&self, placement: &Placement, at: usize) -> bool {
        let nx = self.after.elements()[0];
        let place = [self.after.place(0, at % nx), self.after.place(1, at / nx)];
        self.spline.holds(placement.on_the_earlier(place))
    }
}

/// Fewest points in common: enough in each of the fewest patches.
pub(super) const FEWEST: usize = 4 * level::FEWEST;

/// The place (m) and height (m) of a point; `None` if it has none.
fn point(map: &HeightMap, at: usize) -> Option<([f64; 2], f64)> {
    let nx = map.elements()[0];
    let height = map.heights()[at];
    (!height.is_nan()).then(|| ([map.place(0, at % nx), map.place(1, at / nx)], height))
}

/// The placement with the densest plane, and the scatter within patches.
fn levelled(points: &Points<'_>, placement: Placement) -> Option<Fitted> {
    let flat = Placement { offset: 0.0, tilt: [0.0; 2], form: [0.0; 3], ..placement };
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
    let plane = densest(&changes, corners, points.floor)?;
    let placement = Placement { offset: plane.offset, tilt: plane.tilt, ..flat };
    Some(Fitted { placement, scatter: plane.scatter })
}

/// A map smoothed by a Gaussian of that width (m).
fn by_gaussian(map: &HeightMap, width: f64) -> HeightMap {
    let smooth = gaussian(map.elements(), map.heights(), map.pixel().map(|own| width / own));
    map.of_heights(smooth.into_iter().map(|(mean, _)| mean).collect())
}
