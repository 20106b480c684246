//! How a wheel runs farthest that may be turned to thinner flanges.
//!
//! A flange that is restored costs several times its wear of the radius of the tread. EN 13715 has profiles of thinner flanges for
//! that reason: the active profile lies nearer to the back of the wheel, and the tread is the same. Each turning chooses a thickness, and each
//! run a distance, so that all runs together are the longest. Backward induction finds the best choice for every radius and
//! thickness that may be left (R. Bellman, *Dynamic Programming*, 1957).
//!
//! A profile with a thinner flange wears here as the new one does. It has more play in its track: the shifts of a route may differ.

use super::{COLUMNS, Reprofiling, RouteResult, SideCourse, WornProfile, error_of};
use crate::curve::Curve;
use crate::roots;
use crate::setup::Side;

/// Radii that are told apart. Each turning is rounded up to one of them, so that a life is a little longer than it is said to be: of
/// 30 mm these are steps of 10 micrometres.
const RADII: usize = 3000;
/// Distance (m) between places among which the datum is looked for.
const STEP: f64 = 0.25e-3;
/// Parts of a step of the course after which a wheel may be turned.
const PARTS: usize = 4;

/// Thicknesses of flanges that a wheel is turned to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thicknesses {
    /// That of the new wheel (m).
    pub new: f64,
    /// How much (m) the next one is thinner.
    pub step: f64,
    /// How many there are besides that of the new wheel.
    pub thinner: usize,
    /// The least thickness (m) in service; zero of none.
    pub least: f64,
}

impl Thicknesses {
    /// By how much (m) a turned flange may be thinner than the one that wore, negative where it is thicker: from the thickest on.
    pub fn changes(&self) -> Vec<f64> {
        let last = self.thinner as i32;
        (-last..=last).map(|change| f64::from(change) * self.step).collect()
    }
}

/// A turning.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReprofilingCut {
    /// Share of the distance that a wheel of the new radius would have run since the turning before.
    pub interval: f64,
    /// What it costs (m) of the radius, the allowance with it.
    pub depth: f64,
    /// Thickness (m) of the flange after it.
    pub thickness: f64,
}

/// The best use of a wheel.
#[derive(Debug, Clone, PartialEq)]
pub struct Economy {
    /// Its turnings.
    pub turnings: Vec<ReprofilingCut>,
    /// How far it runs in all, in shares of the distance, and the error of that.
    pub life: [f64; 2],
    /// The same where each turning restores the whole flange.
    pub full: [f64; 2],
}

/// A place on a course: the progress, the depth (m) at the datum of the tread, how much (m) thinner the flange is, and what turning costs
/// (m) for each change of thickness.
#[derive(Debug, Clone, PartialEq)]
struct Place {
    progress: f64,
    tread: f64,
    worn: f64,
    costs: Vec<f64>,
}

/// What is best with a radius and a thickness: how far the wheel runs, and the place of the run and the thickness after it.
#[derive(Debug, Clone, Copy, Default)]
struct Best {
    life: f64,
    choice: Option<(usize, Option<(usize, usize)>)>,
}

impl WornProfile {
    /// How much less (m) the radius is after the profile of a wheel was turned again with a flange that is so much (m) thinner: as
    /// [`turning_depth`](Self::turning_depth), with the profile nearer to the back. The tip of the flange stays as it is.
    pub fn thinning_depth(&self, profile: &Curve, thinner: f64) -> f64 {
        let places = profile.samples(STEP);
        let across = |along: f64| profile.point(along)[0];
        let height = |y: f64| {
            let passes = |pair: &&[f64]| (across(pair[0]) - y) * (across(pair[1]) - y) <= 0.0;
            let pair = places.windows(2).find(passes)?;
            let along = roots::zero(pair[0], pair[1], |along| across(along) - y);
            Some(profile.point(along)[1])
        };
        // The radius counts at the datum.
        let lower = height(thinner).zip(height(0.0)).map_or(0.0, |(there, here)| there - here);
        self.turning_within(&profile.clone().moved(0.0, [-thinner, -lower]), profile)
    }
}

/// The course of a side with places between its steps.
fn course(told: &[SideCourse], side: Side) -> Vec<Place> {
    let column = |name: &str| COLUMNS.iter().position(|own| *own == name);
    let (Some(tread), Some(thick)) = (column("tread_depth_m"), column("flange_thickness_m")) else {
        return vec![];
    };
    let own: Vec<&SideCourse> = told.iter().filter(|told| told.side == side).collect();
    let Some(first) = own.first() else { return vec![] };
    let place = |told: &SideCourse| Place {
        progress: told.progress,
        tread: told.values[tread],
        worn: first.values[thick] - told.values[thick],
        costs: told.thinner.clone(),
    };
    let between = |pair: &[&SideCourse]| {
        let [one, other] = [place(pair[0]), place(pair[1])];
        let at = move |part: usize| one.towards(&other, part as f64 / PARTS as f64);
        (1..=PARTS).map(at).collect::<Vec<_>>()
    };
    own.windows(2).flat_map(between).collect()
}

impl Place {
    /// A share of the way to another.
    fn towards(&self, other: &Self, share: f64) -> Self {
        let at = |one: f64, other: f64| one + share * (other - one);
        Self {
            progress: at(self.progress, other.progress),
            tread: at(self.tread, other.tread),
            worn: at(self.worn, other.worn),
            costs: self.costs.iter().zip(&other.costs).map(|(a, b)| at(*a, *b)).collect(),
        }
    }
}

impl RouteResult {
    /// The best use of the wheel of a side that is turned to one of those thicknesses each time, and reaches its other limits at those
    /// shares of the distance in the three runs, in the order of [`error_of`]; `None` where it cannot run.
    pub fn economy(
        &self,
        turning: &Reprofiling,
        thicknesses: &Thicknesses,
        side: Side,
        until: [f64; 3],
    ) -> Option<Economy> {
        let found = |run: usize, thicknesses: &Thicknesses| {
            let mut places = course(&self.told[run], side);
            places.retain(|place| place.progress <= until[run]);
            best(turning, thicknesses, &places)
        };
        let full = Thicknesses { thinner: 0, ..*thicknesses };
        let lives = |thicknesses: &Thicknesses| [0, 1, 2].map(|run| found(run, thicknesses).0);
        let (life, turnings) = found(0, thicknesses);
        let with_error = |lives: [f64; 3]| [lives[0], error_of(lives)];
        (life > 0.0).then(|| Economy {
            turnings,
            life: with_error(lives(thicknesses)),
            full: with_error(lives(&full)),
        })
    }
}

/// How far a wheel runs at best, and its turnings.
fn best(
    turning: &Reprofiling,
    thicknesses: &Thicknesses,
    places: &[Place],
) -> (f64, Vec<ReprofilingCut>) {
    let Reprofiling { radius, last_radius, allowance } = *turning;
    let unit = (radius - last_radius) / RADII as f64;
    let count = thicknesses.thinner + 1;
    let thickness = |index: usize| thicknesses.new - index as f64 * thicknesses.step;
    let mut all: Vec<Vec<Best>> = Vec::with_capacity(RADII + 1);
    for left in 0..=RADII {
        let spare = left as f64 * unit;
        // A smaller wheel turns more often on its way.
        let share = (last_radius + spare) / radius;
        let of_thickness = |now: usize| {
            let mut best = Best::default();
            for (at, place) in places.iter().enumerate() {
                if place.tread > spare || thickness(now) - place.worn < thicknesses.least {
                    continue;
                }
                let run = share * place.progress;
                if run > best.life {
                    best = Best { life: run, choice: Some((at, None)) };
                }
                // What turning costs to each thickness, the thickest first.
                let Some(first) = (place.costs.len() / 2).checked_sub(now) else { continue };
                for (next, cost) in place.costs.iter().skip(first).take(count).enumerate() {
                    let units = ((cost + allowance) / unit).ceil().max(1.0) as usize;
                    let Some(after) = left.checked_sub(units) else { continue };
                    let life = run + all[after][next].life;
                    // A wheel that never runs again is not turned.
                    if life > best.life && all[after][next].life > 0.0 {
                        best = Best { life, choice: Some((at, Some((after, next)))) };
                    }
                }
            }
            best
        };
        let row = (0..count).map(of_thickness).collect();
        all.push(row);
    }
    let (mut left, mut now, mut turnings) = (RADII, 0, vec![]);
    while let Some((at, Some((after, next)))) = all[left][now].choice {
        let place = &places[at];
        let middle = place.costs.len() / 2;
        turnings.push(ReprofilingCut {
            interval: place.progress,
            depth: place.costs[middle + next - now] + allowance,
            thickness: thickness(next),
        });
        (left, now) = (after, next);
    }
    (all[RADII][0].life, turnings)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Place, Thicknesses, best};
    use crate::curve::Smoothing;
    use crate::standard::wheel_s1002;
    use crate::wear::{Reprofiling, WornProfile};

    /// The flank of S1002 has a slope of 2.7475, the tread one of 0.0336 at its datum: a flange that is thicker by t lies deeper by their
    /// difference. One that is thinner lies within the wheel, but for the bend of the tread.
    #[test]
    fn a_thicker_flange_costs_the_slope_of_its_flank() {
        let curve = wheel_s1002(0.2e-3).unwrap().curve(Smoothing::NONE).unwrap();
        let new = WornProfile::wheel(&curve, 0.46, 0.0).unwrap();
        for t in [0.25e-3, 0.5e-3, 1e-3] {
            let thicker = new.thinning_depth(&curve, -t);
            assert_relative_eq!(thicker, (2.7475 - 0.0336) * t, max_relative = 5e-3);
            assert!(new.thinning_depth(&curve, t) < 0.04 * t);
        }
        assert!(new.thinning_depth(&curve, 0.0) < 1e-9);
    }

    /// A flange that loses 1 mm on each run, and a tread of 1 mm: what is not restored of the flange saves three times as much of the
    /// radius. With 10 mm of radius a wheel that restores its flange is turned every 3 mm and runs four times; one that may be 1 and 2 mm
    /// thinner costs 1 mm until it is as thin as it may be, and runs so twice more before it does.
    #[test]
    fn thin_flanges_save_radius() {
        let turning = Reprofiling { radius: 1.0, last_radius: 0.99, allowance: 0.0 };
        // The cost of a flange that is so much thinner than the one that wore, for -2 .. 2 mm.
        let cost = |thinner: f64| f64::max(1e-3, 3e-3 - 3.0 * thinner);
        let changes = [-2e-3, -1e-3, 0.0, 1e-3, 2e-3];
        let places =
            [Place { progress: 1.0, tread: 1e-3, worn: 1e-3, costs: changes.map(cost).to_vec() }];
        let thicknesses = |thinner| Thicknesses { new: 30e-3, step: 1e-3, thinner, least: 26.9e-3 };
        let (full, turnings) = best(&turning, &thicknesses(0), &places);
        // 0, 3, 6 and 9 mm are gone: the last run needs 1 mm of its tread.
        assert_eq!(turnings.len(), 3);
        assert_relative_eq!(full, 4.0 - (0.003 + 0.006 + 0.009), max_relative = 1e-12);
        let (thin, turnings) = best(&turning, &thicknesses(2), &places);
        // 0, 1, 2, 5 and 8 mm: two turnings to a thinner flange, and then as before.
        let depths: Vec<f64> = turnings.iter().map(|own| 1e3 * own.depth).collect();
        assert_eq!(turnings.len(), 4, "{turnings:?}");
        assert_relative_eq!(depths.iter().sum::<f64>(), 8.0, max_relative = 1e-9);
        assert_relative_eq!(turnings[3].thickness, 28e-3, max_relative = 1e-12);
        // Early or late, it is thinner for as long.
        assert!(thin > 5.0 - (0.001 + 0.002 + 0.005 + 0.008) - 1e-9, "{thin}");
    }
}
