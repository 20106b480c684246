//! Steps over a route.
//!
//! Heun's method, of second order: the rate at the beginning of a step and that at its end, after a step of Euler's, count half
//! each. How much Heun's differs from Euler's is the error of Euler's step, larger than that of the step taken. A step is let pass where
//! it is below the tolerance times all that will be worn off at the present rates; the next one is as long as the error, which grows with
//! the square of the length, lets it be.

use std::ops::ControlFlow;

use archard::numerics::control::{Caution, Control};
use serde::{Deserialize, Serialize};

use super::kept::Kept;
use super::rates::{Depths, Rates};
use super::worn_profile::Lost;
use super::{Journey, WearError, WornProfile, WornSide};

/// How steps change: the usual choice of codes for differential equations (Hairer, Norsett and Wanner 1993, II.4).
const CAUTION: Caution = Caution { aim: 0.8, change: [0.2, 5.0], again: 1.0, failed: 0.2 };

/// A step that was taken.
#[derive(Debug, Clone, Copy)]
pub struct Step<'a> {
    /// Share of the distance that is behind.
    pub progress: f64,
    /// The profiles.
    pub worn: &'a [WornSide],
    /// All that the route needs to go on from here.
    pub kept: &'a Kept,
}

/// Where a route has led to.
pub(super) struct Gone {
    pub worn: Vec<WornSide>,
    /// Steps taken.
    pub steps: usize,
    /// How far loads were off, the mean over the route, at the worst step.
    pub off: f64,
}

/// A place on a route, between two steps.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Place {
    pub progress: f64,
    pub steps: usize,
    pub off: f64,
    control: Control,
    depths: Depths,
    /// What the wheel and the rail of each side have lost.
    pub lost: Vec<[Lost; 2]>,
}

impl Place {
    /// The profiles that have lost so much.
    pub(super) fn worn(&self, unworn: &[WornSide]) -> Result<Vec<WornSide>, WearError> {
        advanced(unworn, &[(&self.lost, 1.0)])
    }
}

impl Journey {
    /// Goes over the whole route, or on from a place on it; `watch` is shown each place.
    pub(super) fn march(
        &self,
        from: Option<Place>,
        mut watch: impl FnMut(&Place, &[WornSide]) -> ControlFlow<()>,
    ) -> Result<Gone, WearError> {
        let unworn = self.unworn()?;
        let mut place = from.unwrap_or_else(|| Place {
            progress: 0.0,
            steps: 0,
            off: 0.0,
            control: Control::first(self.tolerance.sqrt()),
            depths: vec![vec![None; unworn.len()]; self.route.points.len()],
            lost: lost(&unworn),
        });
        let mut worn = place.worn(&unworn)?;
        loop {
            let progress = place.progress;
            if watch(&place, &worn).is_break() {
                return Err(WearError::Stopped { progress });
            }
            if progress >= 1.0 {
                return Ok(Gone { worn, steps: place.steps, off: place.off });
            }
            let (first, off) = self.rates(&worn, progress, &mut place.depths)?;
            place.off = place.off.max(off);
            worn = self.step(&worn, &first, &mut place)?;
            place.lost = lost(&worn);
        }
    }

    /// The profiles after the longest step from a place that is let pass, with the rates there; the place moves with them.
    fn step(
        &self,
        worn: &[WornSide],
        first: &Rates,
        place: &mut Place,
    ) -> Result<Vec<WornSide>, WearError> {
        let Place { progress, control, .. } = place;
        let left = 1.0 - *progress;
        loop {
            let length = control.next().min(left);
            if length < f64::EPSILON.sqrt() {
                return Err(WearError::Unsteady { progress: *progress });
            }
            let mut at_the_end = place.depths.clone();
            let tried = advanced(worn, &[(first, length)])
                .and_then(|end| self.rates(&end, *progress + length, &mut at_the_end));
            let (second, off) = match tried {
                Ok(found) => found,
                // Too far: what is wrong at the beginning of a step is told by the one before.
                Err(error) => {
                    control.failed(length, CAUTION);
                    if control.next() < f64::EPSILON.sqrt() {
                        return Err(error);
                    }
                    continue;
                }
            };
            let error = norm(worn, |one, body| {
                let [a, b] = [first, &second].map(|rates| &rates[one][body].volume);
                a.iter().zip(b).map(|(a, b)| 0.5 * length * (b - a)).collect()
            });
            let whole = norm(worn, |one, body| {
                let gone = worn[one].profiles()[body].gone();
                let rates = &first[one][body].volume;
                gone.iter().zip(rates).map(|(gone, rate)| gone + left * rate).collect()
            });
            let share = if whole > 0.0 { error / (self.tolerance * whole) } else { 0.0 };
            let change = CAUTION.change(share.max(f64::MIN_POSITIVE), 1.0);
            if share > 1.0 {
                control.rejected(length, change, CAUTION);
                continue;
            }
            let worn = advanced(worn, &[(first, 0.5 * length), (&second, 0.5 * length)])?;
            *progress = if length >= left { 1.0 } else { *progress + length };
            control.taken(length, change);
            place.steps += 1;
            place.off = place.off.max(off);
            place.depths = at_the_end;
            return Ok(worn);
        }
    }
}

/// What profiles have lost.
fn lost(worn: &[WornSide]) -> Vec<[Lost; 2]> {
    worn.iter().map(|one| one.profiles().map(WornProfile::lost)).collect()
}

/// The profiles after rates lasted for so long each.
fn advanced(worn: &[WornSide], rates: &[(&Rates, f64)]) -> Result<Vec<WornSide>, WearError> {
    let after = |one: usize, body: usize| {
        let lost: Vec<_> =
            rates.iter().map(|(rates, length)| (&rates[one][body], *length)).collect();
        worn[one].profiles()[body].after(&lost)
    };
    (0..worn.len())
        .map(|one| {
            Ok(WornSide { side: worn[one].side, wheel: after(one, 0)?, rail: after(one, 1)? })
        })
        .collect()
}

/// The size of volumes at the points of all profiles: the root of the sum of the squares of their depths.
fn norm(worn: &[WornSide], volumes: impl Fn(usize, usize) -> Vec<f64>) -> f64 {
    let squares = |one: usize, body: usize| {
        let depths = worn[one].profiles()[body].as_depths(&volumes(one, body));
        depths.iter().map(|depth| depth * depth).sum::<f64>()
    };
    (0..worn.len()).flat_map(|one| [squares(one, 0), squares(one, 1)]).sum::<f64>().sqrt()
}
