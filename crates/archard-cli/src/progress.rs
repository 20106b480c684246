//! Shows how a run gets on: a bar on a terminal, a line a tenth of the run elsewhere.

use std::error::Error;

use archard::simulation::history::{self, PEAK_PRESSURE, WEAR_DEPTH};
use archard::simulation::{Observer, Report, row};
use indicatif::{ProgressBar, ProgressStyle};

use crate::number::{four, progress};
use crate::say::{on_terminal, tell};

/// Follows a run.
pub struct Follower {
    display: Display,
    /// The numbers of the last step by column.
    pub last: Vec<(String, f64)>,
}

/// How progress is shown.
enum Display {
    Bar(ProgressBar),
    /// Lines; the tenth of the run the next one is due at.
    Lines(f64),
    Nothing,
}

/// Positions of the bar from start to end.
const LENGTH: f64 = 1000.0;

impl Follower {
    /// One that shows nothing if `quiet`.
    pub fn new(quiet: bool) -> Self {
        let display = if quiet {
            Display::Nothing
        } else if on_terminal() {
            Display::Bar(bar())
        } else {
            Display::Lines(0.0)
        };
        Self { display, last: vec![] }
    }

    /// The bar, if there is one.
    pub fn bar(&self) -> Option<ProgressBar> {
        match &self.display {
            Display::Bar(bar) => Some(bar.clone()),
            Display::Lines(_) | Display::Nothing => None,
        }
    }

    /// A number of the last step.
    pub fn number(&self, column: &str) -> Option<f64> {
        history::number(&self.last, column)
    }

    /// Where the run is: "distance 250 mm, depth 1.46 um, peak pressure 25.1 MPa".
    fn standing(&self, report: &Report<'_>) -> String {
        let place = progress(report.problem.motion.progress(), report.state.progress);
        let depth = self.number(WEAR_DEPTH).unwrap_or(0.0) * 1e6;
        let peak = self.number(PEAK_PRESSURE).unwrap_or(0.0) * 1e-6;
        format!("{place}, depth {} um, peak pressure {} MPa", four(depth), four(peak))
    }
}

/// A bar without any place yet.
fn bar() -> ProgressBar {
    let template = "[{bar:30}] {percent:>3} %  {wide_msg} ({eta} left)";
    let style = ProgressStyle::with_template(template)
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .progress_chars("=> ");
    ProgressBar::new(LENGTH as u64).with_style(style)
}

impl Observer for Follower {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn Error + Send + Sync>> {
        self.last = row(report);
        // A motion may go nowhere.
        let share = if report.extent > 0.0 { report.state.progress / report.extent } else { 1.0 };
        let standing = self.standing(report);
        match &mut self.display {
            Display::Bar(bar) => {
                bar.set_message(standing);
                bar.set_position((LENGTH * share) as u64);
            }
            Display::Lines(due) if share >= *due - 1e-9 => {
                tell(&format!("{:>3.0} %  {standing}", 100.0 * share));
                *due = (10.0 * share + 1.0 + 1e-9).floor() / 10.0;
            }
            Display::Lines(_) | Display::Nothing => {}
        }
        Ok(())
    }
}
