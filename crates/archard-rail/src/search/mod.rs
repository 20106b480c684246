//! Where a wheel of some attitude touches the rail.
//!
//! A wheel that yaws touches ahead of its axle or behind it. For each place on the profile of the wheel there is one
//! point on its circle at which the surface has a normal without a part along x: with the angle t from the lowest point,
//! sin t = -tan(yaw) t_z/t_y, where t_y and t_z are the tangent of the profile. These points are the locus of possible
//! contact. Along it the gap to the rail is the rail's z less the wheel's at the same y. The least gap says at which
//! height the wheel touches, and at a lower height each stretch of negative gap is a patch.

mod gap;
mod patch;
mod roll;

pub use gap::Gap;
pub use patch::{JOIN, Patch};
pub(crate) use roll::SETTLED;

use glam::{DMat3, DVec3};

use crate::roots;
use crate::setup::{Attitude, Setup};
use archard::parameters::Invalid;

/// Distance (m) between the places at which the gap is first looked at; patches narrower than that may be missed.
pub const STEP: f64 = 5e-5;

/// The same where only the first touch counts, whose valleys are then followed down: wider than profiles are measured, and narrower than
/// the rounding of any.
const COARSE: f64 = 4e-4;

/// Turns in which a place on a roller is found: each leaves the square of the angles of yaw and roll, which are below a quarter of pi, so
/// that so many leave 3e-13 at the most, and at angles that wheels have rounding alone.
const TURNS: usize = 60;

/// A point of the locus with the wheel at height 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Possible {
    /// Where it lies on the profile of the wheel (m along its curve).
    pub on_wheel: f64,
    /// Where the rail has the same y (m along its curve), above the axis of a roller.
    pub on_rail: f64,
    /// The point (m) in the track.
    pub point: DVec3,
    /// The vertical gap (m): the height at which the wheel touches here.
    pub gap: f64,
}

/// The lowest height without overlap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Onset {
    /// The height (m) of the wheelset, as [`Setup::centre`] counts it.
    pub height: f64,
    /// Where it touches first, with the wheel at height 0.
    pub at: Possible,
}

/// A wheel over its rail.
#[derive(Debug, Clone)]
pub struct Search<'a> {
    setup: &'a Setup,
    attitude: Attitude,
    rotation: DMat3,
    /// Sine and cosine of the yaw.
    yaw: [f64; 2],
    /// The middle of the axle (m) with the wheel at height 0.
    centre: DVec3,
    locus: Vec<Possible>,
}

impl<'a> Search<'a> {
    /// The wheel at that attitude, as its side sees it.
    ///
    /// # Errors
    /// If the attitude is out of its bounds.
    pub fn new(setup: &'a Setup, attitude: Attitude) -> Result<Self, Invalid> {
        Self::by(setup, attitude, STEP)
    }

    /// Where a wheel of that attitude begins to touch, from a locus that is looked at in fewer places; `None` if it is nowhere
    /// over the rail.
    ///
    /// # Errors
    /// If the attitude is out of its bounds.
    pub fn first_touch(setup: &'a Setup, attitude: Attitude) -> Result<Option<Onset>, Invalid> {
        Ok(Self::by(setup, attitude, COARSE)?.onset())
    }

    fn by(setup: &'a Setup, attitude: Attitude, step: f64) -> Result<Self, Invalid> {
        let attitude = attitude.checked()?;
        let (sin, cos) = attitude.yaw.sin_cos();
        let mut search = Self {
            setup,
            attitude,
            rotation: attitude.rotation(),
            yaw: [sin, cos],
            centre: setup.centre(&attitude, 0.0),
            locus: vec![],
        };
        let places = setup.wheel().samples_apart(step);
        search.locus = places.into_iter().filter_map(|along| search.possible(along)).collect();
        Ok(search)
    }

    /// The set-up that is searched.
    pub fn setup(&self) -> &'a Setup {
        self.setup
    }

    /// The attitude of the wheelset, as the side sees it.
    pub fn attitude(&self) -> &Attitude {
        &self.attitude
    }

    /// A point of the track (m) as the wheel has it at that height (m) of the wheelset: x forward, y and z as in its
    /// profile, turned with roll and yaw.
    pub fn in_wheel(&self, point: DVec3, height: f64) -> DVec3 {
        let wheelset = self.setup.wheelset();
        let own = self.rotation.transpose() * (point - self.setup.centre(&self.attitude, height));
        own - DVec3::new(0.0, wheelset.arm(), wheelset.nominal_radius)
    }

    /// The points of possible contact, in the order of the profile of the wheel; none where the wheel does not face
    /// downwards or has no rail below it.
    pub fn locus(&self) -> &[Possible] {
        &self.locus
    }

    /// The height at which the wheel begins to touch; `None` if it is nowhere over the rail.
    pub fn onset(&self) -> Option<Onset> {
        let gap = |at: usize| self.locus.get(at).map_or(f64::INFINITY, |one| one.gap);
        let before = |at: usize| at.checked_sub(1).map_or(f64::INFINITY, gap);
        let valleys = (0..self.locus.len()).filter(|&at| gap(at) <= before(at).min(gap(at + 1)));
        let at = valleys.map(|at| self.least(at)).min_by(|a, b| a.gap.total_cmp(&b.gap))?;
        Some(Onset { height: at.gap, at })
    }

    /// The point (y and z, m, in the track) of the top of the rail at that y (m), if it reaches there.
    pub(crate) fn on_rail(&self, y: f64) -> Option<[f64; 2]> {
        let rail = self.setup.rail();
        Some(rail.point(self.setup.below(y)?))
    }

    /// The angle (rad) by which the top of the rail is turned about x at that y (m), if it reaches there.
    pub fn inclination(&self, y: f64) -> Option<f64> {
        let rail = self.setup.rail();
        let [along_y, along_z] = rail.place(self.setup.below(y)?).tangent;
        Some(along_z.atan2(along_y))
    }

    /// The least gap next to a sample of the locus.
    fn least(&self, best: usize) -> Possible {
        let (left, right) = (best.saturating_sub(1), (best + 1).min(self.locus.len() - 1));
        let [from, to] = [left, right].map(|at| self.locus[at].on_wheel);
        let found = roots::least(from, to, |along| self.gap_at(along));
        let found = self.possible(found).filter(|found| found.gap < self.locus[best].gap);
        found.unwrap_or(self.locus[best])
    }

    /// The gap (m) at a place on the wheel, infinite where none exists.
    fn gap_at(&self, along: f64) -> f64 {
        self.possible(along).map_or(f64::INFINITY, |possible| possible.gap)
    }

    /// The point of the locus at a place on the wheel.
    fn possible(&self, along: f64) -> Option<Possible> {
        let place = self.setup.wheel().place(along);
        let [along_y, along_z] = place.tangent;
        // The wheel faces down where its profile runs towards -y.
        let [sin, cos] = self.yaw;
        let straight = -sin / cos * along_z / along_y;
        if along_y >= 0.0 || straight.abs() >= 1.0 {
            return None;
        }
        let seen = |point: DVec3| {
            let on_rail = self.setup.below(point.y)?;
            let rail = self.setup.roller().at(self.setup.rail().point(on_rail)[1], point.x)?;
            Some((Possible { on_wheel: along, on_rail, point, gap: rail.z - point.z }, rail))
        };
        let (mut found, mut rail) = seen(self.on_circle(place.point, straight))?;
        let Some(radius) = self.setup.roller().radius() else { return Some(found) };
        // Where the rail rises and falls with x, the wheel has to: N_x = -slope N_z of its normal.
        let mut at = straight;
        let own = self.setup.wheelset().nominal_radius + place.point[1];
        for _ in 0..TURNS {
            let normal = self.rotation
                * DVec3::new(-along_y * at, along_z, -along_y * (1.0 - at * at).sqrt());
            let off = (normal.x + rail.slope * normal.z) / (-along_y * cos);
            let next = at - off / (1.0 + own / radius);
            if next.is_nan() || next.abs() >= 1.0 {
                return None;
            }
            let change = (next - at).abs();
            at = next;
            (found, rail) = seen(self.on_circle(place.point, at))?;
            if change <= f64::EPSILON {
                break;
            }
        }
        Some(found)
    }

    /// The point of the wheel's surface (m, in the track, at height 0) above a point of its profile, at the angle about
    /// the axle with that sine.
    fn on_circle(&self, [y, z]: [f64; 2], sin: f64) -> DVec3 {
        let wheelset = self.setup.wheelset();
        let radius = wheelset.nominal_radius + z;
        let own = DVec3::new(radius * sin, wheelset.arm() + y, radius * (1.0 - sin * sin).sqrt());
        self.rotation * own + self.centre
    }

    /// The sine of the angle about the axle at which the circle through a point of the profile passes the plane of a normal (in the axes of
    /// the wheelset) so far (m) from the middle of the axle; not a number where it does not.
    fn sine(&self, [y, z]: [f64; 2], (normal, far): (DVec3, f64)) -> f64 {
        let wheelset = self.setup.wheelset();
        let radius = wheelset.nominal_radius + z;
        let (a, b) = (normal.x * radius, normal.z * radius);
        let c = far - normal.y * (wheelset.arm() + y);
        let squares = a * a + b * b;
        (c * a - b * (squares - c * c).sqrt()) / squares
    }
}
