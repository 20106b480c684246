//! Bodies pressed and shifted against each other step by step, once or in cycles.

use std::f64::consts::TAU;
use std::mem::discriminant;

use super::{Control, Drive, Stepping};
use crate::parameters::{Bound, Invalid, Parameter, Quantity, Values};

/// What holds the bodies at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Load or approach.
    pub control: Control,
    /// What drives them along x and y.
    pub guides: [Drive; 2],
}

impl Station {
    /// Pressed together, not shifted.
    pub fn pressed(control: Control) -> Self {
        Self { control, guides: [Drive::Slip(0.0); 2] }
    }

    /// The same with these guides along x and y.
    #[must_use]
    pub fn guided(self, guides: [Drive; 2]) -> Self {
        Self { guides, ..self }
    }

    /// Whether all its values are finite.
    pub(super) fn is_finite(&self) -> bool {
        let (Control::Load(pressed) | Control::Approach(pressed)) = self.control;
        let [x, y] = self.guides.map(Drive::value);
        [pressed, x, y].into_iter().all(f64::is_finite)
    }

    /// Whether the bodies are pressed and neither shifted nor pushed.
    fn is_still(&self) -> bool {
        self.guides.into_iter().all(Drive::is_still)
    }

    /// Whether the other gives what this one does: a load or an approach, displacements or forces.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        discriminant(&self.control) == discriminant(&other.control)
            && self.guides.each_ref().map(discriminant) == other.guides.each_ref().map(discriminant)
    }

    /// The way here from rest, in that many increments each: first pressed together, then shifted, where it is.
    pub(super) fn lead(self, count: usize) -> Vec<Self> {
        let unmoved = Self { guides: self.share(0.0).guides, ..self };
        let share = |index: usize| index as f64 / count as f64;
        let press = (1..=count).map(|index| unmoved.share(share(index)));
        let moved = if self.guides == unmoved.guides { 0 } else { count };
        let guided = |index| Self { guides: self.share(share(index)).guides, ..self };
        press.chain((1..=moved).map(guided)).collect()
    }

    /// Pressed and guided by that share of all that another one is.
    pub fn share(self, share: f64) -> Self {
        let guides = self.guides.map(|guide| guide.share(share));
        Self { control: self.control.scaled(share), guides }
    }
}

/// A path of increments, gone through once or in cycles. Progress is measured in the motion's own unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Shift {
    /// Ends of the increments that lead from rest to the first cycle; they count as no progress.
    pub lead: Vec<Station>,
    /// Ends of the increments of a cycle.
    pub cycle: Vec<Station>,
    /// Progress at each of them, from the beginning of the cycle on.
    pub places: Vec<f64>,
    /// Whether the bodies are taken apart before each cycle, without rubbing.
    pub released: bool,
    /// Whether all that a pair slips in an increment rubs under the pressure at its end, as in the paper's
    /// eqs. 48 and 53, instead of what it slips in contact under the mean pressure.
    pub end_pressure: bool,
}

impl Shift {
    /// Progress of a whole cycle.
    pub fn period(&self) -> f64 {
        self.places.last().copied().unwrap_or(1.0)
    }

    /// Whether the bodies are guided anywhere.
    pub fn moves(&self) -> bool {
        self.lead.iter().chain(&self.cycle).any(|station| !station.is_still())
    }

    /// Along which axes the bodies are shifted, or pushed.
    pub(super) fn moves_along(&self) -> [bool; 2] {
        let stations = || self.lead.iter().chain(&self.cycle);
        [0, 1].map(|axis| !stations().all(|station| station.guides[axis].is_still()))
    }

    /// The way to the first cycle where pressing alone leaves no friction: bodies are pressed together at once.
    pub fn lead(&self, pressing_rubs: bool) -> &[Station] {
        let pressing = self.lead.iter().take_while(|station| station.is_still()).count();
        &self.lead[if pressing_rubs { 0 } else { pressing.saturating_sub(1) }..]
    }

    /// The station at which the bodies are pressed together most.
    pub fn peak(&self) -> usize {
        let pressed = |station: &Station| match station.control {
            Control::Load(value) | Control::Approach(value) => value,
        };
        let mut peak = 0;
        for (index, station) in self.cycle.iter().enumerate() {
            // The last of equal ones, but for rounding: what a cycle ends with.
            if pressed(station) >= (1.0 - 1e-12) * pressed(&self.cycle[peak]) {
                peak = index;
            }
        }
        peak
    }
}

/// How often a cycle is gone through, and which of them are computed: all, unless it is said otherwise.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Cycles {
    /// None: once, and the progress may be called something else.
    pub(super) count: Option<usize>,
    jumps: Option<Stepping>,
}

impl Cycles {
    /// That many cycles.
    pub fn new(count: usize) -> Self {
        Self { count: Some(count), jumps: None }
    }

    /// The same, so many cycles from one that is computed to the next.
    #[must_use]
    pub fn jump(self, cycles: usize) -> Self {
        Self { jumps: Some(Stepping::Jumps(cycles)), ..self }
    }

    /// The same, jumps chosen by that relative error of the worn depths.
    #[must_use]
    pub fn tolerance(self, tolerance: f64) -> Self {
        Self { jumps: Some(Stepping::Tolerance(tolerance)), ..self }
    }

    /// What motions in cycles take.
    pub(super) fn read(values: &Values) -> Result<Self, Invalid> {
        let count = values.number("cycles").map(|count| count as usize);
        let jumps = match (values.number("jump"), values.number("tolerance")) {
            (None, None) => None,
            _ => Some(match values.one_of("jump", "tolerance")? {
                (Some(jump), _) => Stepping::Jumps(jump as usize),
                (None, tolerance) => Stepping::Tolerance(tolerance.unwrap_or_default()),
            }),
        };
        Ok(Self { count, jumps })
    }

    /// How many there are, and how they are divided where all increments have that length (the motion's unit).
    pub(super) fn divided(self, increment: f64) -> Result<(f64, Stepping), Invalid> {
        let count = CYCLE_COUNT.admit(self.count.unwrap_or(1) as f64)?;
        match self.jumps {
            Some(Stepping::Jumps(cycles)) => JUMP.admit(cycles as f64)?,
            Some(Stepping::Tolerance(tolerance)) => JUMP_TOLERANCE.admit(tolerance)?,
            _ => increment,
        };
        Ok((count, self.jumps.unwrap_or(Stepping::Implicit(increment))))
    }
}

/// Cycles of a motion.
pub(super) const CYCLE_COUNT: Parameter =
    Parameter::optional("cycles", Quantity::Count, "number of cycles; 1 if not given");
/// Fixed jumps.
pub(super) const JUMP: Parameter = Parameter::optional(
    "jump",
    Quantity::Count,
    "cycles from one that is computed to the next; every cycle if neither this nor `tolerance` is given",
);
/// Jumps chosen by error.
pub(super) const JUMP_TOLERANCE: Parameter = Parameter::optional(
    "tolerance",
    Quantity::Number,
    "relative error allowed in the worn depths, to jump over cycles by",
)
.bound(Bound::Between(0.0, 1.0));

/// The sine of a share of a cycle, exact at its quarters.
pub(super) fn wave(index: usize, count: usize) -> f64 {
    match (4 * index).is_multiple_of(count).then(|| 4 * index / count % 4) {
        Some(0 | 2) => 0.0,
        Some(1) => 1.0,
        Some(_) => -1.0,
        None => (TAU * index as f64 / count as f64).sin(),
    }
}
