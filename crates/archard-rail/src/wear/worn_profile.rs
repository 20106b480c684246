//! A profile that wears.
//!
//! Each point of the profile stands for the stretch of the curve that is nearer to it than to its neighbours. What a body
//! loses there is laid down as a volume, of a wheel round its circumference, of a rail on each metre, and taken off along
//! the normal of the unworn curve. A layer of thickness n on a convex curve of curvature c holds less than n a length,
//! and on a wheel of radius r the less the farther in: the integral of (1 - c u)(1 - b u) over u from 0 to n, where b is the
//! part of the normal away from the axle over r. The thickness is the one that holds the volume.

use std::f64::consts::TAU;

use archard::parameters::Invalid;
use serde::{Deserialize, Serialize};

use super::WearError;
use super::filter::Filter;
use crate::curve::{Curve, Smoothing, distance};
use crate::profile::{Part, Profile};

/// Distance (m) between points at which a profile wears, at most. Patches are wider than several of them, and the spline between
/// them is off by parts of (distance/radius)^4. A choice of cost.
const SPACING: f64 = 0.25e-3;

/// Turns of Newton's method after which the thickness of a layer has all digits: each doubles them, and the first guess, the
/// volume over the length, has one.
const NEWTON: usize = 6;

/// A profile with what was worn off it.
#[derive(Debug, Clone, PartialEq)]
pub struct WornProfile {
    part: Part,
    points: Vec<Point>,
    /// Volume (m^3) that is gone at each point; of a rail that of one metre (m^3/m).
    gone: Vec<f64>,
    /// Distance (m) that each point slid under pressure.
    slid: Vec<f64>,
    /// Damage by cracks at each point.
    damage: Vec<f64>,
    curve: Curve,
    filter: Filter,
}

/// What a profile loses at each of its points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Lost {
    /// Volume (m^3, of a rail m^2).
    pub volume: Vec<f64>,
    /// Distance (m) slid under pressure.
    pub slid: Vec<f64>,
    /// Damage by cracks, negative where they are worn off.
    pub damage: Vec<f64>,
}

/// A strip of a curve: its ends (m along the curve), and what it loses or what passes over it.
pub(super) type Strip = ([f64; 2], f64);

/// How far points of a profile slid and how deep they wore so far.
#[derive(Debug)]
pub(super) struct Before {
    /// Where they lie (m along the worn curve), rising, and both (m).
    nodes: Vec<f64>,
    ages: Vec<[f64; 2]>,
}

impl Before {
    /// At a place (m along the worn curve), straight between points.
    pub fn at(&self, along: f64) -> [f64; 2] {
        let after = self.nodes.partition_point(|&node| node <= along);
        let after = after.clamp(1, self.nodes.len() - 1);
        let [from, to] = [self.nodes[after - 1], self.nodes[after]];
        let share = ((along - from) / (to - from)).clamp(0.0, 1.0);
        let [one, other] = [self.ages[after - 1], self.ages[after]];
        [0, 1].map(|part| one[part] + share * (other[part] - one[part]))
    }
}

/// A point of the unworn profile.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Point {
    /// y and z (m).
    at: [f64; 2],
    /// Unit vector out of the material.
    normal: [f64; 2],
    /// Curvature (1/m) along the profile and round the axle: how much shorter a layer is for each metre inwards.
    bends: [f64; 2],
    /// Length (m) of the curve that it stands for.
    length: f64,
    /// Length (m) of the body there: the circumference of a wheel, a metre of a rail.
    girth: f64,
}

impl Point {
    /// Thickness (m) of the layer that holds a volume (m^3).
    fn thickness(&self, volume: f64) -> Option<f64> {
        let wanted = volume / (self.length * self.girth);
        let [c, b] = self.bends;
        let mut thickness = wanted;
        for _ in 0..NEWTON {
            let n = thickness;
            let held = n - (c + b) * n * n / 2.0 + c * b * n * n * n / 3.0;
            let slope = (1.0 - c * n) * (1.0 - b * n);
            if slope <= 0.0 {
                return None;
            }
            thickness -= (held - wanted) / slope;
        }
        Some(thickness)
    }
}

impl WornProfile {
    /// The unworn profile of a wheel of that nominal radius (m), whose wear is smoothed so that waves of that length (m),
    /// 0 or more, keep half of their height.
    ///
    /// # Errors
    /// If the wheel reaches to its axle.
    pub fn wheel(curve: &Curve, nominal_radius: f64, smoothing: f64) -> Result<Self, Invalid> {
        Self::new(curve, Part::Wheel, smoothing, |z| Some(nominal_radius + z))
    }

    /// The unworn profile of a rail, likewise.
    ///
    /// # Errors
    /// If its points make no curve.
    pub fn rail(curve: &Curve, smoothing: f64) -> Result<Self, Invalid> {
        Self::new(curve, Part::Rail, smoothing, |_| None)
    }

    fn new(
        curve: &Curve,
        part: Part,
        smoothing: f64,
        radius: impl Fn(f64) -> Option<f64>,
    ) -> Result<Self, Invalid> {
        let along = curve.samples(SPACING);
        let lengths: Vec<f64> =
            along.windows(2).map(|pair| length(curve, [pair[0], pair[1]])).collect();
        let stands_for = |at: usize| {
            let side = |index: Option<usize>| index.and_then(|at| lengths.get(at)).unwrap_or(&0.0);
            0.5 * (side(at.checked_sub(1)) + side(Some(at)))
        };
        let point = |(at, &along): (usize, &f64)| {
            let place = curve.place(along);
            let radius = radius(place.point[1]);
            Point {
                at: place.point,
                normal: place.normal(),
                bends: [place.curvature, radius.map_or(0.0, |radius| place.normal()[1] / radius)],
                length: stands_for(at),
                girth: radius.map_or(1.0, |radius| TAU * radius),
            }
        };
        let points: Vec<Point> = along.iter().enumerate().map(point).collect();
        if points.iter().any(|point| point.girth <= 0.0) {
            return Err(Invalid::new("radius", "the profile of the wheel reaches to the axle"));
        }
        let weights: Vec<f64> = points.iter().map(|point| point.length * point.girth).collect();
        let links = points.windows(2).zip(&lengths);
        let links = links.map(|(pair, length)| 0.5 * (pair[0].girth + pair[1].girth) / length);
        let filter = Filter::new(smoothing, weights, links.collect());
        let gone = vec![0.0; points.len()];
        let curve = through(points.iter().map(|point| point.at).collect())?;
        let none = || gone.clone();
        Ok(Self { part, points, slid: none(), damage: none(), gone, curve, filter })
    }

    /// The worn curve (m).
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// The points of the worn profile.
    pub fn profile(&self) -> Profile {
        Profile { points: self.points.iter().zip(self.depths()).map(moved).collect() }
    }

    /// The points of the unworn profile, in the same order.
    pub fn unworn(&self) -> Profile {
        Profile { points: self.points.iter().map(|point| point.at).collect() }
    }

    /// Each point of the unworn profile (m) with its normal.
    pub(super) fn stations(&self) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
        self.points.iter().map(|point| (point.at, point.normal))
    }

    /// Depth (m) along the normal at each point.
    pub fn depths(&self) -> Vec<f64> {
        let thickness = |(point, gone): (&Point, &f64)| point.thickness(*gone).unwrap_or(f64::NAN);
        self.points.iter().zip(&self.gone).map(thickness).collect()
    }

    /// Depth (m) where the unworn profile has that y (m) first; not a number where it does not reach.
    pub fn depth_at(&self, y: f64) -> f64 {
        let depths = self.depths();
        let across = |at: usize| self.points[at].at[0];
        let meets = |at: &usize| (across(*at) - y) * (across(*at + 1) - y) <= 0.0;
        let Some(at) = (0..self.points.len() - 1).find(meets) else { return f64::NAN };
        let width = across(at + 1) - across(at);
        let share = if width == 0.0 { 0.0 } else { (y - across(at)) / width };
        depths[at] + share * (depths[at + 1] - depths[at])
    }

    /// Volume (m^3) that is gone at each point; of a rail that of one metre (m^2).
    pub fn gone(&self) -> &[f64] {
        &self.gone
    }

    /// Distance (m) that each point slid under pressure.
    pub fn slid(&self) -> &[f64] {
        &self.slid
    }

    /// How far its points slid and how deep they wore so far.
    pub(super) fn before(&self) -> Before {
        let ages = self.slid.iter().zip(self.depths()).map(|(slid, depth)| [*slid, depth]);
        Before { nodes: self.curve.nodes().to_vec(), ages: ages.collect() }
    }

    /// Damage by cracks at each point: at 1 a crack is expected.
    pub fn damage(&self) -> &[f64] {
        &self.damage
    }

    /// All that it has lost.
    pub(super) fn lost(&self) -> Lost {
        Lost { volume: self.gone.clone(), slid: self.slid.clone(), damage: self.damage.clone() }
    }

    /// Volume (m^3) that is gone; of a rail that of one metre (m^2).
    pub fn volume(&self) -> f64 {
        self.gone.iter().sum()
    }

    /// Area (m^2) of the cross-section that is gone.
    pub fn area(&self) -> f64 {
        self.areas().into_iter().sum()
    }

    /// The same of each point.
    pub fn areas(&self) -> Vec<f64> {
        let of = |(point, gone): (&Point, &f64)| gone / point.girth;
        self.points.iter().zip(&self.gone).map(of).collect()
    }

    /// What strips of the present curve lose at each point: `strips` holds the ends of each (m along the curve), and what it loses.
    pub(super) fn lay(&self, strips: &[Strip], onto: &mut [f64]) {
        for &(ends, lost) in strips {
            self.under(ends, |at, share, _| onto[at] += lost * share);
        }
    }

    /// What passes over strips of the present curve, at each point: `strips` holds the ends of each (m along the curve), and what all the
    /// metres do that roll over it. A place of a wheel is met once on each of its circumferences, that of a rail at each axle.
    pub(super) fn cover(&self, strips: &[Strip], onto: &mut [f64]) {
        for &(ends, passing) in strips {
            self.under(ends, |at, _, covered| {
                onto[at] += passing * covered / self.points[at].girth;
            });
        }
    }

    /// Calls with each point that a strip lies on, the share of the strip that lies on it, and the share of the point that it covers.
    fn under(&self, [one, other]: [f64; 2], mut each: impl FnMut(usize, f64, f64)) {
        let nodes = self.curve.nodes();
        let last = nodes.len() - 1;
        let edge = |at: usize| match at {
            0 => f64::NEG_INFINITY,
            at if at > last => f64::INFINITY,
            at => 0.5 * (nodes[at - 1] + nodes[at]),
        };
        let (from, to) = (one.min(other), one.max(other));
        let first = nodes.partition_point(|&node| node < from).saturating_sub(1);
        for at in (first..=last).take_while(|&at| edge(at) < to) {
            let on = (edge(at + 1).min(to) - edge(at).max(from)).max(0.0);
            let width = edge(at + 1).min(self.curve.length()) - edge(at).max(0.0);
            each(at, on / (to - from), on / width);
        }
    }

    /// Volumes at the points as depths (m) of thin layers.
    pub(super) fn as_depths(&self, volumes: &[f64]) -> Vec<f64> {
        let of = |(point, volume): (&Point, &f64)| volume / (point.length * point.girth);
        self.points.iter().zip(volumes).map(of).collect()
    }

    /// How many points it has.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// The volumes with their waves smoothed, the whole kept.
    pub(super) fn smoothed(&self, volumes: Vec<f64>) -> Vec<f64> {
        self.filter.smooth(volumes)
    }

    /// Distances (m) at the points with their waves smoothed as those of depths are.
    pub(super) fn smoothed_depths(&self, depths: &[f64]) -> Vec<f64> {
        let weight = |point: &Point| point.length * point.girth;
        let volumes = self.points.iter().zip(depths).map(|(point, depth)| depth * weight(point));
        self.as_depths(&self.smoothed(volumes.collect()))
    }

    /// The same after those losses lasted for so long each.
    ///
    /// # Errors
    /// As [`worn_to`](Self::worn_to).
    pub(super) fn after(&self, losses: &[(&Lost, f64)]) -> Result<Self, WearError> {
        let Lost { volume: mut gone, mut slid, mut damage } = self.lost();
        for (lost, length) in losses {
            gone.iter_mut().zip(&lost.volume).for_each(|(gone, rate)| *gone += length * rate);
            slid.iter_mut().zip(&lost.slid).for_each(|(all, rate)| *all += length * rate);
            damage.iter_mut().zip(&lost.damage).for_each(|(all, rate)| *all += length * rate);
        }
        // What is worn off where nothing is cracked leaves no credit.
        damage.iter_mut().for_each(|damage| *damage = damage.max(0.0));
        Ok(Self { slid, damage, ..self.worn_to(gone)? })
    }

    /// The same with so much gone (m^3, of a rail m^2) at each point.
    ///
    /// # Errors
    /// If a layer is thicker than its curve is round, or the profile crosses itself.
    pub(super) fn worn_to(&self, gone: Vec<f64>) -> Result<Self, WearError> {
        let layer = |(point, gone): (&Point, &f64)| {
            let thickness = point.thickness(*gone);
            thickness
                .map(|thickness| moved((point, thickness)))
                .ok_or(WearError::Deep { part: self.part, y: point.at[0] })
        };
        let points = self.points.iter().zip(&gone).map(layer).collect::<Result<Vec<_>, _>>()?;
        let curve = through(points)?;
        if curve.nodes().len() != self.points.len() {
            return Err(WearError::Deep { part: self.part, y: f64::NAN });
        }
        Ok(Self { gone, curve, ..self.clone() })
    }
}

/// A point, by a thickness (m) further in.
fn moved((point, thickness): (&Point, f64)) -> [f64; 2] {
    [0, 1].map(|axis| point.at[axis] - thickness * point.normal[axis])
}

/// The curve through points.
fn through(points: Vec<[f64; 2]>) -> Result<Curve, Invalid> {
    Curve::new(&points, Smoothing::NONE)
}

/// The length (m) of the curve between two places: Simpson's rule on chords has the error of the fourth order that the spline
/// has too.
fn length(curve: &Curve, [from, to]: [f64; 2]) -> f64 {
    let point = |share: f64| curve.point(from + share * (to - from));
    let whole = distance(point(0.0), point(1.0));
    let halves = distance(point(0.0), point(0.5)) + distance(point(0.5), point(1.0));
    halves + (halves - whole) / 3.0
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::WornProfile;
    use crate::curve::{Curve, Smoothing};

    /// A layer of even thickness on a tread that is an arc: its volume between two angles is that of a turned sector.
    #[test]
    fn a_layer_holds_the_volume_of_a_turned_sector() {
        let (radius, centre, thickness) = (13e-3, 0.45, 0.5e-3);
        let angles = (-200..=200).rev().map(|at| f64::from(at) * 5e-3);
        // y falls, and the wheel is convex downwards.
        let points: Vec<[f64; 2]> = angles
            .map(|angle: f64| [radius * angle.sin(), radius * angle.cos() - radius])
            .collect();
        let curve = Curve::new(&points, Smoothing::NONE).unwrap();
        // The middle of the arc lies at that distance from the axle.
        let new = WornProfile::wheel(&curve, centre + radius, 0.0).unwrap();
        let inside = radius - thickness;
        let [second, third] = [2, 3].map(|power| radius.powi(power) - inside.powi(power));
        let gone = new.points.iter().map(|point| {
            let (angle, cos) = (point.length / radius, point.at[1] / radius + 1.0);
            TAU * angle * (centre * second / 2.0 + cos * third / 3.0)
        });
        let worn = new.worn_to(gone.collect()).unwrap();
        let depths = worn.depths();
        for depth in &depths[10..depths.len() - 10] {
            assert!((depth / thickness - 1.0).abs() < 1e-6, "{depth}");
        }
        // The curve through the points is the smaller arc.
        let middle = worn.curve().point(0.5 * worn.curve().length());
        assert!((middle[0].hypot(middle[1] + radius) - inside).abs() < 1e-9);
    }
}
