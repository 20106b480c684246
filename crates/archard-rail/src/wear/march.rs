//! Steps over a route.
//!
//! Heun's method, of second order: the rate at the beginning of a step and that at its end, after a step of Euler's, count half
//! each. How much Heun's differs from Euler's is the error of Euler's step, larger than that of the step taken. A step is let pass where
//! it is below the tolerance times all that will be worn off at the present rates; the next one is as long as the error, which grows with
//! the square of the length, lets it be.

use std::ops::ControlFlow;

use archard::numerics::control::{Caution, Control};

use super::rates::{Depths, Rates};
use super::{Journey, WearError, Worn, WornProfile};

/// How steps change: the usual choice of codes for differential equations (Hairer, Norsett and Wanner 1993, II.4).
const CAUTION: Caution = Caution { aim: 0.8, change: [0.2, 5.0], again: 1.0, failed: 0.2 };

/// A step that was taken.
#[derive(Debug, Clone, Copy)]
pub struct Step<'a> {
    /// Share of the distance that is behind.
    pub progress: f64,
    /// The profiles.
    pub worn: &'a [Worn],
}

/// Where a route has led to.
pub(super) struct Gone {
    pub worn: Vec<Worn>,
    /// Steps taken.
    pub steps: usize,
    /// How far loads were off, the mean over the route, at the worst step.
    pub off: f64,
}

impl Journey {
    /// Goes over the whole route.
    pub(super) fn march(
        &self,
        mut watch: impl FnMut(&Step<'_>) -> ControlFlow<()>,
    ) -> Result<Gone, WearError> {
        let mut worn = self.unworn()?;
        let mut depths: Depths = vec![vec![None; worn.len()]; self.route.points.len()];
        let (mut progress, mut steps) = (0.0, 0);
        let mut control = Control::first(self.tolerance.sqrt());
        let mut show = |progress: f64, worn: &[Worn]| match watch(&Step { progress, worn }) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(WearError::Stopped { progress }),
        };
        show(progress, &worn)?;
        let (mut first, mut off) = self.rates(&worn, progress, &mut depths)?;
        while progress < 1.0 {
            let left = 1.0 - progress;
            let length = control.next().min(left);
            if length < f64::EPSILON.sqrt() {
                return Err(WearError::Unsteady { progress });
            }
            let mut at_the_end = depths.clone();
            let tried = advanced(&worn, &[(&first, length)])
                .and_then(|end| self.rates(&end, progress + length, &mut at_the_end));
            let (second, off_then) = match tried {
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
            let error = norm(&worn, |one, body| {
                let [a, b] = [&first, &second].map(|rates| &rates[one][body]);
                a.iter().zip(b).map(|(a, b)| 0.5 * length * (b - a)).collect()
            });
            let whole = norm(&worn, |one, body| {
                let gone = profile(&worn[one], body).gone();
                gone.iter().zip(&first[one][body]).map(|(gone, rate)| gone + left * rate).collect()
            });
            let share = if whole > 0.0 { error / (self.tolerance * whole) } else { 0.0 };
            let change = CAUTION.change(share.max(f64::MIN_POSITIVE), 1.0);
            if share <= 1.0 {
                worn = advanced(&worn, &[(&first, 0.5 * length), (&second, 0.5 * length)])?;
                progress = if length >= left { 1.0 } else { progress + length };
                steps += 1;
                off = off.max(off_then);
                show(progress, &worn)?;
                depths = at_the_end;
                if progress < 1.0 {
                    let off_now;
                    (first, off_now) = self.rates(&worn, progress, &mut depths)?;
                    off = off.max(off_now);
                }
                control.taken(length, change);
            } else {
                control.rejected(length, change, CAUTION);
            }
        }
        Ok(Gone { worn, steps, off })
    }
}

/// The wheel, or the rail.
fn profile(worn: &Worn, body: usize) -> &WornProfile {
    [&worn.wheel, &worn.rail][body]
}

/// The profiles after rates lasted for so long each.
fn advanced(worn: &[Worn], rates: &[(&Rates, f64)]) -> Result<Vec<Worn>, WearError> {
    let after = |one: usize, body: usize| {
        let before = profile(&worn[one], body);
        let mut gone = before.gone().to_vec();
        for (rates, length) in rates {
            gone.iter_mut().zip(&rates[one][body]).for_each(|(gone, rate)| *gone += length * rate);
        }
        before.worn_to(gone)
    };
    (0..worn.len())
        .map(|one| Ok(Worn { side: worn[one].side, wheel: after(one, 0)?, rail: after(one, 1)? }))
        .collect()
}

/// The size of volumes at the points of all profiles: the root of the sum of the squares of their depths.
fn norm(worn: &[Worn], volumes: impl Fn(usize, usize) -> Vec<f64>) -> f64 {
    let squares = |one: usize, body: usize| {
        let depths = profile(&worn[one], body).as_depths(&volumes(one, body));
        depths.iter().map(|depth| depth * depth).sum::<f64>()
    };
    (0..worn.len()).flat_map(|one| [squares(one, 0), squares(one, 1)]).sum::<f64>().sqrt()
}
