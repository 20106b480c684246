//! The undeformed gap normal to the tangent plane of a patch.
//!
//! In a plane at some x the wheel's surface is a curve: where the circle through each point of its profile passes there, on a straight rail
//! at sin t = (x + y sin(yaw))/(r cos(yaw)), with the radius r and the distance y from the middle of the axle. In the frame of the
//! contact this curve and the rail's profile, on a roller as it lies at that x, are depths n over s; the gap is the rail's less the wheel's.

use glam::DVec3;

use super::{Patch, Search};
use crate::roots;

/// The gap over a tangent plane.
#[derive(Debug, Clone)]
pub struct Gap<'a> {
    search: &'a Search<'a>,
    patch: Patch,
    /// The normal of the planes at each x, in the axes of the wheelset.
    normal: DVec3,
    /// How far (m) along it the reference point lies from the middle of the axle.
    far: f64,
}

impl<'a> Search<'a> {
    /// The gap over the tangent plane of that patch.
    pub fn gap(&'a self, patch: &Patch) -> Gap<'a> {
        let normal = patch.frame().x_axis;
        let centre = self.setup.centre(&self.attitude, patch.height);
        let far = normal.dot(patch.reference - centre);
        let normal = self.rotation.transpose() * normal;
        Gap { search: self, patch: patch.clone(), normal, far }
    }
}

impl Gap<'_> {
    /// The gap (m) at that x (m) and each s (m) of the tangent plane, from the reference point; negative where the
    /// bodies overlap, infinite where the rail or the wheel does not reach.
    pub fn column(&self, x: f64, across: &[f64]) -> Vec<f64> {
        self.between(x, across, &self.rail(x, across))
    }

    /// Where (m along the curves) the wheel and the rail have each s (m) at x = 0; `None` where one does not reach.
    pub fn places(&self, across: &[f64]) -> Option<[Vec<f64>; 2]> {
        let wheel = self.wheel(0.0, across).into_iter().collect::<Option<_>>()?;
        let rail = self.rail(0.0, across).into_iter().collect::<Option<_>>()?;
        Some([wheel, rail])
    }

    /// The gap (m) over the grid of those x and s (m), x by x: the value at x number i and s number j stands at
    /// i times the number of s plus j.
    pub fn grid(&self, along: &[f64], across: &[f64]) -> Vec<f64> {
        let straight = self.search.setup.roller().radius().is_none();
        let rail = straight.then(|| self.rail(0.0, across));
        let column = |&x: &f64| match &rail {
            Some(rail) => self.between(x, across, rail),
            None => self.column(x, across),
        };
        along.iter().flat_map(column).collect()
    }

    /// The gap at that x and each s, where the rail has those places.
    fn between(&self, x: f64, across: &[f64], rail: &[Option<f64>]) -> Vec<f64> {
        let gap = |(wheel, rail): (Option<f64>, &Option<f64>)| {
            let gap = self.on_rail(x, (*rail)?)[1] - self.on_wheel(x, wheel?).z;
            gap.is_finite().then_some(gap)
        };
        let wheel = self.wheel(x, across).into_iter();
        wheel.zip(rail).map(|both| gap(both).unwrap_or(f64::INFINITY)).collect()
    }

    /// Where (m along its curve) the wheel has each s at that x.
    fn wheel(&self, x: f64, across: &[f64]) -> Vec<Option<f64>> {
        let s = |along: f64| self.on_wheel(x, along).y;
        let depths =
            Depths::new(&self.search.setup.samples()[0], self.patch.deepest, over(across), s);
        let meets =
            |s_there: f64, [from, to]: [f64; 2]| roots::zero(from, to, |along| s(along) - s_there);
        across.iter().map(|&s| depths.around(s).map(|around| meets(s, around))).collect()
    }

    /// Where (m along its curve) the rail has each s at that x.
    fn rail(&self, x: f64, across: &[f64]) -> Vec<Option<f64>> {
        let Self { search, patch, .. } = self;
        let rail = search.setup.rail();
        let centre = search.setup.below(patch.reference.y).unwrap_or(0.0);
        let s = |along: f64| self.on_rail(x, along)[0];
        let depths = Depths::new(&search.setup.samples()[1], centre, over(across), s);
        // s is a coordinate of the profile, from that of the reference point.
        let (sin, cos) = patch.angle.sin_cos();
        let own = patch.reference.y * cos + patch.on_profile * sin;
        let straight = search.setup.roller().radius().is_none();
        let meets = |wanted: f64, around: [f64; 2]| match straight {
            true => rail.meets(around, [cos, sin], own + wanted),
            false => roots::zero(around[0], around[1], |along| s(along) - wanted),
        };
        across.iter().map(|&s| depths.around(s).map(|around| meets(s, around))).collect()
    }

    /// s and n of the point of the rail's surface at that x (m from the reference point) through a place of its profile; not a number
    /// where a roller does not reach.
    fn on_rail(&self, x: f64, along: f64) -> [f64; 2] {
        let setup = self.search.setup;
        let [y, z] = setup.rail().point(along);
        let z = setup.roller().at(z, x).map_or(f64::NAN, |at| at.z);
        self.patch.in_the_plane([y, z])
    }

    /// The point of the wheel's surface at that x (m from the reference point) on the circle through a place of its
    /// profile, in the frame of the contact; not a number where the circle does not reach.
    fn on_wheel(&self, x: f64, along: f64) -> DVec3 {
        let search = self.search;
        let point = search.setup.wheel().point(along);
        let sin = search.sine(point, (self.normal, self.far + x));
        self.patch.local(search.on_circle(point, sin) + DVec3::Z * self.patch.height)
    }
}

/// The least and the largest of those s (m).
fn over(across: &[f64]) -> [f64; 2] {
    let least = across.iter().copied().fold(f64::INFINITY, f64::min);
    [least, across.iter().copied().fold(f64::NEG_INFINITY, f64::max)]
}

/// The part of a profile about a place on which s runs one way, as far as it is asked for.
#[derive(Debug, Clone)]
struct Depths {
    /// Places (m) along the curve in the order of rising s.
    places: Vec<f64>,
    /// s (m) there.
    across: Vec<f64>,
}

impl Depths {
    fn new(all: &[f64], centre: f64, [least, largest]: [f64; 2], s: impl Fn(f64) -> f64) -> Self {
        let middle = all.partition_point(|&place| place < centre).clamp(1, all.len() - 1);
        let direction = (s(all[middle]) - s(all[middle - 1])).signum();
        let forward = |at: usize| direction * s(all[at]);
        let ends = [direction * least, direction * largest];
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let (mut first, mut last) = (middle - 1, middle);
        let (mut down, mut up) = (vec![forward(first)], vec![forward(last)]);
        while first > 0 && down[down.len() - 1] > low {
            let next = forward(first - 1);
            if next.is_nan() || next >= down[down.len() - 1] {
                break;
            }
            down.push(next);
            first -= 1;
        }
        while last + 1 < all.len() && up[up.len() - 1] <= high {
            let next = forward(last + 1);
            if next.is_nan() || next <= up[up.len() - 1] {
                break;
            }
            up.push(next);
            last += 1;
        }
        let mut places = all[first..=last].to_vec();
        let mut across: Vec<f64> = down.into_iter().rev().chain(up).collect();
        if direction < 0.0 {
            places.reverse();
            across.reverse();
            across.iter_mut().for_each(|s| *s = -*s);
        }
        Self { places, across }
    }

    /// The places (m along the curve) next to each other between which the surface has that s (m), if it reaches there.
    fn around(&self, s: f64) -> Option<[f64; 2]> {
        let after = self.across.partition_point(|&across| across <= s);
        (after > 0 && after < self.across.len())
            .then(|| [self.places[after - 1], self.places[after]])
    }
}
