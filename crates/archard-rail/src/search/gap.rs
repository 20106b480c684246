//! The undeformed gap normal to the tangent plane of a patch.
//!
//! In a plane at some x the wheel's surface is a curve: the circle through a point of its profile at radius r and
//! distance y from the middle of the axle passes there at sin t = (x + y sin(yaw))/(r cos(yaw)). In the frame of the
//! contact this curve and the rail's profile are depths n over s; the gap is the rail's less the wheel's.

use glam::DVec3;

use super::{Patch, Search};
use crate::roots;

/// Distance (m) between the places of a profile between which a depth is looked for.
const STEP: f64 = 2e-4;

/// The gap over a tangent plane.
#[derive(Debug, Clone)]
pub struct Gap<'a> {
    search: &'a Search<'a>,
    patch: Patch,
    rail: Depths,
    /// Places (m) along the profile of the wheel, near the patch.
    wheel: Vec<f64>,
}

impl<'a> Search<'a> {
    /// The gap over the tangent plane of that patch.
    pub fn gap(&'a self, patch: &Patch) -> Gap<'a> {
        let rail = self.setup.rail();
        let centre = self.top.below(rail, patch.reference.y).unwrap_or(0.0);
        let rail = Depths::new(rail.samples(STEP), centre, |along| {
            let [y, z] = rail.point(along);
            patch.local(DVec3::new(patch.reference.x, y, z))
        });
        Gap { search: self, patch: patch.clone(), rail, wheel: self.setup.wheel().samples(STEP) }
    }
}

impl Gap<'_> {
    /// The gap (m) at that x (m) and each s (m) of the tangent plane, from the reference point; negative where the
    /// bodies overlap, infinite where the rail or the wheel does not reach.
    pub fn column(&self, x: f64, across: &[f64]) -> Vec<f64> {
        let on_wheel = |along: f64| self.on_wheel(x, along);
        let wheel = Depths::new(self.wheel.clone(), self.patch.deepest, on_wheel);
        let depth = |s: f64| {
            let rail = self.on_rail(self.rail.place(s, |along| self.on_rail(along))?);
            let gap = rail.z - on_wheel(wheel.place(s, on_wheel)?).z;
            gap.is_finite().then_some(gap)
        };
        across.iter().map(|&s| depth(s).unwrap_or(f64::INFINITY)).collect()
    }

    /// Where (m along the curves) the wheel and the rail have each s (m) at x = 0; `None` where one does not reach.
    pub fn places(&self, across: &[f64]) -> Option<[Vec<f64>; 2]> {
        let on_wheel = |along: f64| self.on_wheel(0.0, along);
        let depths = Depths::new(self.wheel.clone(), self.patch.deepest, on_wheel);
        let wheel = across.iter().map(|&s| depths.place(s, on_wheel)).collect::<Option<_>>()?;
        let on_rail = |along: f64| self.on_rail(along);
        let rail = across.iter().map(|&s| self.rail.place(s, on_rail)).collect::<Option<_>>()?;
        Some([wheel, rail])
    }

    /// The gap (m) over the grid of those x and s (m), x by x: the value at x number i and s number j stands at
    /// i times the number of s plus j.
    pub fn grid(&self, along: &[f64], across: &[f64]) -> Vec<f64> {
        along.iter().flat_map(|&x| self.column(x, across)).collect()
    }

    /// The point of the rail at a place of its profile, in the frame of the contact.
    fn on_rail(&self, along: f64) -> DVec3 {
        let [y, z] = self.search.setup.rail().point(along);
        self.patch.local(DVec3::new(self.patch.reference.x, y, z))
    }

    /// The point of the wheel's surface at that x (m from the reference point) on the circle through a place of its
    /// profile, in the frame of the contact; not a number where the circle does not reach.
    fn on_wheel(&self, x: f64, along: f64) -> DVec3 {
        let search = self.search;
        let point = search.setup.wheel().point(along);
        let sin = search.sine(point, self.patch.reference.x + x);
        self.patch.local(search.on_circle(point, sin) + DVec3::Z * self.patch.height)
    }
}

/// The part of a profile about a place on which s runs one way.
#[derive(Debug, Clone)]
struct Depths {
    /// Places (m) along the curve in the order of rising s.
    places: Vec<f64>,
    /// s (m) there.
    across: Vec<f64>,
}

impl Depths {
    fn new(places: Vec<f64>, centre: f64, local: impl Fn(f64) -> DVec3) -> Self {
        let across: Vec<f64> = places.iter().map(|&along| local(along).y).collect();
        let middle = places.partition_point(|&place| place < centre).clamp(1, places.len() - 1);
        let direction = (across[middle] - across[middle - 1]).signum();
        let on = |at: usize| (across[at + 1] - across[at]) * direction > 0.0;
        let first = (0..middle).rev().find(|&at| !on(at)).map_or(0, |at| at + 1);
        let last = (middle - 1..places.len() - 1).find(|&at| !on(at)).unwrap_or(places.len() - 1);
        let (mut places, mut across) =
            (places[first..=last.max(first)].to_vec(), across[first..=last.max(first)].to_vec());
        if direction < 0.0 {
            places.reverse();
            across.reverse();
        }
        Self { places, across }
    }

    /// Where (m along the curve) the surface has that s (m), if it reaches there.
    fn place(&self, s: f64, local: impl Fn(f64) -> DVec3) -> Option<f64> {
        let after = self.across.partition_point(|&across| across <= s);
        if after == 0 || after == self.across.len() {
            return None;
        }
        Some(roots::zero(self.places[after - 1], self.places[after], |along| local(along).y - s))
    }
}
