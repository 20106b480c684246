//! Ctrl-C: the run ends after the step it is at, with what was computed so far in its files.

use std::error::Error;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use archard::simulation::{Observer, Report};

/// The user has had enough.
#[derive(Debug, thiserror::Error)]
#[error("interrupted")]
pub struct Interrupted;

/// Watches for Ctrl-C.
pub struct Watch(Arc<AtomicBool>);

impl Watch {
    /// Takes over what Ctrl-C does; where that is refused, it ends the program as ever.
    pub fn set() -> Self {
        let pressed = Arc::new(AtomicBool::new(false));
        let flag = pressed.clone();
        let _ = ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed));
        Self(pressed)
    }
}

impl Observer for Watch {
    fn observe(&mut self, _report: &Report<'_>) -> Result<(), Box<dyn Error + Send + Sync>> {
        if self.0.load(Ordering::Relaxed) { Err(Interrupted.into()) } else { Ok(()) }
    }
}
