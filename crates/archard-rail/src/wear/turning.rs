//! What turning a worn wheel costs of its radius.
//!
//! A lathe turns the profile again on a smaller radius, at the same distance from the back of the flange. The profile has to lie within
//! what is left of the wheel: its radius is smaller by the largest distance, towards the axle, of the worn profile from the new one. A
//! flange of inclination d that wears by n along its normal costs n / cos d there, so that a thin flange costs several times its wear.

use super::{RouteResult, WornProfile, error_of};
use crate::curve::Curve;
use crate::flange;
use crate::roots;
use crate::setup::Side;

/// Distance (m) between places among which a point of a profile is looked for. A choice of cost: the place itself is solved for.
const STEP: f64 = 0.25e-3;

impl WornProfile {
    /// How much less (m) the radius is after that profile of a wheel was turned again. Counted is from the tip of the flange to the
    /// field side, where both reach: the back of the flange does not touch.
    pub fn turning_depth(&self, profile: &Curve) -> f64 {
        self.turning_within(profile, profile)
    }

    /// The same from the tip of another profile's flange on.
    pub(super) fn turning_within(&self, profile: &Curve, from: &Curve) -> f64 {
        let places = profile.samples(STEP);
        let y = |along: f64| profile.point(along)[0];
        let across: Vec<f64> = places.iter().map(|&along| y(along)).collect();
        let tip = flange::tip(from).map_or(f64::NEG_INFINITY, |[y, _]| y);
        // y falls from the field side to the flange.
        let height = |wanted: f64| {
            let passes = |pair: &[f64]| (pair[0] - wanted) * (pair[1] - wanted) <= 0.0;
            let at = across.windows(2).position(passes)?;
            let along = roots::zero(places[at], places[at + 1], |along| y(along) - wanted);
            Some(profile.point(along)[1])
        };
        let worn = self.profile().points.into_iter().filter(|[y, _]| *y >= tip);
        worn.filter_map(|[y, z]| Some(height(y)? - z)).fold(0.0, f64::max)
    }
}

/// When wheels are turned again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reprofiling {
    /// Radius (m) of a new wheel.
    pub radius: f64,
    /// Radius (m) down to which it stays in service.
    pub last_radius: f64,
    /// What is turned off (m) below the deepest wear.
    pub allowance: f64,
}

/// A wheel that is turned again each time it has run so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plan {
    /// Share of the distance between two turnings, of a wheel of the new radius, and its error.
    pub interval: [f64; 2],
    /// What each turning costs (m) of the radius, the allowance with it, and its error.
    pub depth: [f64; 2],
    /// How many times it is turned.
    pub turnings: usize,
    /// How far it runs in all, in shares of the distance, and the error of that.
    pub life: [f64; 2],
}

/// A step of a course: its progress, what turning costs (m) then, and the depth (m) at the datum of the tread.
type At = [f64; 3];

impl Reprofiling {
    /// How many times a wheel is turned that costs so much each time: the radius of the last run begins and ends above the last one.
    fn turnings(&self, [_, depth, tread]: At) -> Option<usize> {
        let spare = self.radius - self.last_radius - tread;
        let often = spare / (depth + self.allowance);
        (often >= 0.0 && often.is_finite()).then_some(often as usize)
    }

    /// How far it runs in all. A smaller wheel turns more often on its way, and wears the faster: each run is as much shorter as its
    /// radius is smaller.
    fn life(&self, [progress, depth, _]: At, turnings: usize) -> f64 {
        let turned = turnings as f64;
        // The sum of 1 - i c over i from 0 to n.
        let smaller = (depth + self.allowance) / self.radius;
        progress * (turned + 1.0) * (1.0 - 0.5 * smaller * turned)
    }

    /// Of steps that rise up to a share of the distance, the one at which turning costs the least of each metre.
    fn cheapest(&self, course: &[At], until: f64) -> Option<At> {
        let cost = |at: &At| (at[1] + self.allowance) / at[0];
        let within = course.iter().copied().chain(between(course, until));
        let within = within.filter(|at| at[0] > 0.0 && at[0] <= until);
        within.min_by(|one, other| cost(one).total_cmp(&cost(other)))
    }

    /// The plan of a step, with the errors that the same step of the three runs has. How often a wheel is turned jumps where a loss of
    /// radius goes once more into what there is: it is found at both ends of the errors. `None` of a wheel that is turned before it runs.
    fn plan(&self, found: [Option<At>; 3]) -> Option<Plan> {
        let fine = found[0]?;
        let [interval, depth, tread] = [0, 1, 2].map(|value| match found {
            [Some(fine), Some(coarse), Some(hasty)] => {
                error_of([fine, coarse, hasty].map(|at| at[value]))
            }
            _ => f64::INFINITY,
        });
        let turnings = self.turnings(fine).filter(|_| fine[0] > 0.0)?;
        let life = self.life(fine, turnings);
        let apart = |sign: f64| {
            let least = |value: f64| value.max(0.0);
            let at = [fine[0], least(fine[1] + sign * depth), least(fine[2] + sign * tread)];
            let other = self.turnings(at).map_or(0.0, |turnings| self.life(at, turnings));
            (other - life).abs()
        };
        Some(Plan {
            interval: [fine[0], interval],
            depth: [fine[1] + self.allowance, depth],
            turnings,
            life: [life, apart(-1.0).max(apart(1.0)) + life * interval / fine[0]],
        })
    }
}

/// A course at a share of the distance, straight between its steps; `None` beyond its end.
fn between(course: &[At], progress: f64) -> Option<At> {
    let after = course.iter().position(|at| at[0] >= progress)?;
    let (one, other) = (course[after.saturating_sub(1)], course[after]);
    let width = other[0] - one[0];
    let share = if width > 0.0 { (progress - one[0]) / width } else { 0.0 };
    Some([0, 1, 2].map(|value| one[value] + share * (other[value] - one[value])))
}

impl RouteResult {
    /// What it takes of a wheel to turn it after the shares of the distance at which the three runs reach something, in the order of
    /// [`error_of`]; `None` where the wheel does not last till then. Errors are infinite where not all of them get so far.
    pub fn plan(&self, turning: &Reprofiling, side: Side, at: [f64; 3]) -> Option<Plan> {
        let courses = self.turned(side);
        turning.plan([0, 1, 2].map(|run| between(&courses[run], at[run])))
    }

    /// The plan that costs least of the radius on each metre, up to that share of the distance: its interval is a choice, which has no
    /// error.
    pub fn cheapest_plan(&self, turning: &Reprofiling, side: Side, until: f64) -> Option<Plan> {
        let courses = self.turned(side);
        let [at, ..] = turning.cheapest(&courses[0], until)?;
        turning.plan([0, 1, 2].map(|run| between(&courses[run], at)))
    }

    /// The steps of a side in the three runs.
    fn turned(&self, side: Side) -> [Vec<At>; 3] {
        let place = |column: &str| super::COLUMNS.iter().position(|own| *own == column);
        let columns = ["turning_depth_m", "tread_depth_m"].map(place);
        let [Some(depth), Some(tread)] = columns else { return Default::default() };
        self.told.each_ref().map(|course| {
            let own = course.iter().filter(|told| told.side == side);
            own.map(|told| [told.progress, told.values[depth], told.values[tread]]).collect()
        })
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Reprofiling, WornProfile};
    use crate::curve::{Curve, Smoothing};

    /// A straight flank of that inclination, from the field side down to a tip at y = 0 and up again behind it.
    fn flank(slope: f64) -> Curve {
        let points = (0..=400).map(|at| {
            let y = 20e-3 - 1e-4 * f64::from(at);
            [y, -slope * y.abs()]
        });
        Curve::new(&points.collect::<Vec<_>>(), Smoothing::NONE).unwrap()
    }

    /// A flank of 60 degrees that wears evenly by n costs n / cos 60 of the radius, a tread that wears as deep costs n.
    #[test]
    fn a_flank_costs_its_depth_over_the_cosine() {
        for angle in [0.0f64, 30.0, 60.0] {
            let angle = angle.to_radians();
            let new = flank(angle.tan());
            let profile = WornProfile::wheel(&new, 1e6, 0.0).unwrap();
            let depth = 0.2e-3;
            // So thin on so large a wheel that its volume is its area by the girth; at the field side of the flank alone.
            let gone = profile
                .unworn()
                .points
                .into_iter()
                .zip(profile.as_depths(&vec![1.0; profile.len()]));
            let gone =
                gone.map(|([y, _], thin)| if y > 5e-3 && y < 15e-3 { depth / thin } else { 0.0 });
            let worn = profile.worn_to(gone.collect()).unwrap();
            assert_relative_eq!(worn.turning_depth(&new), depth / angle.cos(), max_relative = 1e-3);
            assert!(profile.turning_depth(&new) < 1e-12);
        }
    }

    /// Wear of c s + d s^2 with an allowance of a costs least of each metre at the root of a / d. A wheel that loses 5 mm a turning from
    /// 460 to 430 mm, 2 mm of them on the tread before it is turned, is turned 5 times and runs 6 times, the less the smaller it is.
    #[test]
    fn a_plan_is_that_of_its_sums() {
        let turning = Reprofiling { radius: 0.46, last_radius: 0.43, allowance: 0.5e-3 };
        let course = (0..=1000).map(|at| 1e-3 * f64::from(at));
        let course: Vec<_> = course.map(|s| [s, 1e-3 * s + 2e-3 * s * s, 2e-3]).collect();
        let cheapest = turning.cheapest(&course, 1.0).unwrap();
        assert!((cheapest[0] - 0.5).abs() < 2e-3, "{cheapest:?}");
        let early = turning.cheapest(&course, 0.25).unwrap();
        assert_relative_eq!(early[0], 0.25);
        let at = [1.0, 4.5e-3, 2e-3];
        let turnings = turning.turnings(at).unwrap();
        assert_eq!(turnings, 5);
        let runs = (0..6).map(|turned| (0.46 - 5e-3 * f64::from(turned)) / 0.46);
        assert_relative_eq!(turning.life(at, turnings), runs.sum::<f64>(), max_relative = 1e-12);
        assert_eq!(turning.turnings([1.0, 4.5e-3, 31e-3]), None);
        // A limit that new profiles are at leaves nothing to plan.
        assert_eq!(turning.plan([Some([0.0; 3]); 3]), None);
    }
}
