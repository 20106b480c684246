//! The circumstances that friction depends on, and the grip they make.
//!
//! Speeds are those of the rigid bodies: a law that depends on the slip itself has no one answer where it falls. Distances
//! are those that points have slid under pressure, of both surfaces the longer. Temperatures are those that the heat of
//! this friction makes, so that both have to be found together.

use super::{ContactProblem, ContactState, Flash, Heating};
use crate::frame::Flow;
use crate::friction::{Circumstance, Circumstances, Friction, Grip};
use crate::motion::Drives;
use crate::numerics::SAME;
use crate::wear::Input;

impl ContactProblem {
    /// Whether the law of friction depends on that.
    pub fn grips_by(&self, circumstance: Circumstance) -> bool {
        self.friction.as_ref().is_some_and(|law| law.inputs().contains(&circumstance))
    }

    /// Whether the temperature decides anything.
    pub fn goes_by_temperature(&self) -> bool {
        self.asks(Input::Temperature) || self.grips_by(Circumstance::Temperature)
    }

    /// Whether it matters how far points have slid.
    pub fn counts_distance(&self) -> bool {
        self.asks(Input::Distance) || self.grips_by(Circumstance::Distance)
    }

    /// The grip in a state: that under which its tractions were found, or of bodies that slide, after points slid so much
    /// further (m), which is told by the pair.
    ///
    /// # Errors
    /// With what it was last, if heat and friction do not settle.
    pub fn grip(&self, state: &ContactState, further: impl Fn(usize) -> f64) -> Result<Grip, Grip> {
        if let Some(tangential) = &state.tangential {
            return Ok(tangential.grip.clone());
        }
        let Some(law) = self.friction.as_deref().filter(|law| !law.inputs().is_empty()) else {
            return Ok(Grip::default());
        };
        let speed = self.motion.sliding_speed().unwrap_or_default();
        let under = |flash: Option<Flash>| {
            let at = |pair| Circumstances {
                speed,
                ..self.circumstances(state, &flash, further(pair), pair)
            };
            Grip::of(law, (0..self.frame.len()).map(at))
        };
        let mut grip = under(None);
        if !law.inputs().contains(&Circumstance::Temperature) {
            return Ok(grip);
        }
        let mut before = f64::INFINITY;
        loop {
            let next = under(self.flash_with(state, &grip));
            let apart = next.apart(&grip);
            grip = next;
            if apart <= SAME {
                return Ok(grip);
            }
            // Turns that settle change less and less.
            if apart.is_nan() || apart >= before {
                return Err(grip);
            }
            before = apart;
        }
    }

    /// The grip of bodies that roll, by what a state shows so far; `rigid` is the slip (m) before any traction in a passage of
    /// mean length, without what drives by force.
    pub(crate) fn grip_of_rolling(
        &self,
        law: &dyn Friction,
        state: &ContactState,
        (drives, flow): (&Drives, Flow<'_>),
        rigid: [&[f64]; 2],
    ) -> Grip {
        if law.inputs().is_empty() {
            return Grip::default();
        }
        let found = state.tangential.as_ref().map_or([0.0; 2], |tangential| tangential.creepage);
        let [forward, lateral] = drives.by_force(found);
        let units = [flow.direction().forward(), flow.direction().lateral()];
        let warms = state.tangential.is_some() && self.goes_by_temperature();
        let flash = warms.then(|| self.flash(state)).flatten();
        let at = |pair: usize| {
            let part = |axis: usize| {
                let found = forward * units[0][axis] + lateral * units[1][axis];
                rigid[axis][pair] / flow.advance() + found
            };
            let speed = self.motion.speed.unwrap_or_default() * part(0).hypot(part(1));
            Circumstances { speed, ..self.circumstances(state, &flash, 0.0, pair) }
        };
        Grip::of(law, (0..self.frame.len()).map(at))
    }

    /// The grip of bodies that are shifted against each other.
    pub(crate) fn grip_of_shift(&self, law: &dyn Friction, state: &ContactState) -> Grip {
        if law.inputs().is_empty() {
            return Grip::default();
        }
        let at = |pair| self.circumstances(state, &None, 0.0, pair);
        Grip::of(law, (0..self.frame.len()).map(at))
    }

    /// Temperature (K) of surfaces that touch without friction.
    fn bulk(&self) -> Option<f64> {
        Heating::of(&self.bodies, &self.motion).ok()?.bulk(0.0).ok()
    }

    /// All circumstances of a pair but the speed.
    fn circumstances(
        &self,
        state: &ContactState,
        flash: &Option<Flash>,
        further: f64,
        pair: usize,
    ) -> Circumstances {
        let slid = state.surfaces.each_ref().map(|one| one.before(one.grid.at(pair, [0; 2]))[0]);
        let warm = |flash: &Flash| Some(flash.bulk? + flash.rise[pair]);
        let temperature = flash.as_ref().and_then(warm).or_else(|| self.bulk()).unwrap_or_default();
        Circumstances { speed: 0.0, distance: slid[0].max(slid[1]) + further, temperature }
    }
}
