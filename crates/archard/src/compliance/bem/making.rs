//! How far the equations of a body are: large ones take minutes, and whoever waits is told.

use std::fmt;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What is done with the equations of a body, in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Integrals over its elements.
    Assembling,
    /// The factors of its matrix, all at once.
    Factorising,
    /// What each traction of the zone displaces.
    Condensing,
}

/// How far a stage is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StageProgress {
    /// Number of equations.
    pub equations: usize,
    /// The stage.
    pub stage: Stage,
    /// What is done of it, from zero to one.
    pub share: f64,
}

/// Whoever is told, from any thread; nobody by default.
#[derive(Clone, Copy, Default)]
pub struct Listener<'a>(Option<&'a (dyn Fn(StageProgress) + Sync)>);

impl<'a> Listener<'a> {
    /// Tells that function.
    pub fn by(tell: &'a (dyn Fn(StageProgress) + Sync)) -> Self {
        Self(Some(tell))
    }

    /// Tells how far a stage of so many equations is.
    pub(super) fn tell(self, equations: usize, stage: Stage, share: f64) {
        if let Some(tell) = self.0 {
            tell(StageProgress { equations, stage, share });
        }
    }
}

impl fmt::Debug for Listener<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Told({})", if self.0.is_some() { "somebody" } else { "nobody" })
    }
}

/// Counts parts of the assembly, which end on any thread.
pub(super) struct Parts<'a> {
    told: Listener<'a>,
    equations: usize,
    done: AtomicUsize,
    all: usize,
}

impl<'a> Parts<'a> {
    pub fn new(told: Listener<'a>, equations: usize, all: usize) -> Self {
        told.tell(equations, Stage::Assembling, 0.0);
        Self { told, equations, done: AtomicUsize::new(0), all }
    }

    /// One more is done.
    pub fn one(&self) {
        let done = 1 + self.done.fetch_add(1, Ordering::Relaxed);
        self.told.tell(self.equations, Stage::Assembling, done as f64 / self.all as f64);
    }
}
