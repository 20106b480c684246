//! Shows how far the equations of meshed bodies are: on the bar, or a line a tenth elsewhere.

use std::sync::Mutex;

use archard::compliance::bem::{Stage, StageProgress};
use indicatif::ProgressBar;

use crate::say::tell;

/// Equations from which on their stages are told where there is no bar: fewer take a moment.
const MANY: usize = 2000;

/// Follows the equations.
pub struct Equations {
    bar: Option<ProgressBar>,
    quiet: bool,
    /// The last stage that was told, and the share of it that is told next.
    next: Mutex<Option<(usize, Stage, f64)>>,
}

impl Equations {
    /// On that bar, or on none.
    pub fn new(bar: Option<ProgressBar>, quiet: bool) -> Self {
        Self { bar, quiet, next: Mutex::new(None) }
    }

    /// Shows how far they are.
    pub fn are(&self, StageProgress { equations, stage, share }: StageProgress) {
        if let Some(bar) = &self.bar {
            bar.set_message(format!("{} {equations} equations", word(stage)));
            let length = bar.length().unwrap_or_default() as f64;
            return bar.set_position((length * share) as u64);
        }
        let Ok(mut next) = self.next.lock() else { return };
        let due = next
            .is_none_or(|(others, last, due)| (others, last) != (equations, stage) || share >= due);
        if due && !self.quiet && equations >= MANY {
            let what = word(stage);
            let share = match stage {
                Stage::Factorising => String::new(),
                _ => format!(", {:.0} %", 100.0 * share),
            };
            tell(&format!("{what} {equations} equations{share}"));
        }
        if due {
            *next = Some((equations, stage, ((10.0 * share).floor() + 1.0) / 10.0));
        }
    }

    /// The bar is that of the run again.
    pub fn done(&self) {
        self.bar.iter().for_each(ProgressBar::reset);
    }
}

fn word(stage: Stage) -> &'static str {
    match stage {
        Stage::Assembling => "assembling",
        Stage::Factorising => "factorising",
        Stage::Condensing => "condensing",
    }
}
