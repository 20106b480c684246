//! Shows how a run gets on, and those on coarser grids before it: a line on a terminal, one for each tenth elsewhere.

use std::error::Error;

use archard::simulation::history::{self, PEAK_PRESSURE, WEAR_DEPTH};
use archard::simulation::{Observer, Report, row, worn_extent};
use console::Term;
use indicatif::{HumanDuration, ProgressBar, ProgressStyle};

use crate::number::{four, progress};
use crate::say::{on_terminal, tell};

/// Follows a run.
pub struct Follower {
    display: Display,
    plan: Plan,
    /// What is computed, where it is not the run itself.
    before: Option<String>,
    /// The numbers of the last step by column.
    pub last: Vec<(String, f64)>,
    /// How far (m) the scar of each body reached then, along the motion and across, if it has one that stays.
    pub scars: [Option<[f64; 2]>; 2],
}

/// How progress is shown.
enum Display {
    Bar(ProgressBar),
    /// Lines; the tenth of the work the next one is due at.
    Lines(f64),
    Nothing,
}

/// The runs there are, by their work: all that were done, the one that runs, and those to come. Some may be added; the share
/// that is shown never falls.
#[derive(Debug, Default)]
struct Plan {
    done: f64,
    current: f64,
    ahead: Vec<f64>,
    shown: f64,
}

/// Positions of the bar from start to end.
const LENGTH: f64 = 1000.0;
/// Columns of a bar.
const BAR: usize = 22;

impl Plan {
    /// Puts these runs in the place of those to come.
    fn set(&mut self, ahead: Vec<f64>) {
        self.ahead = ahead;
    }

    /// The next run begins.
    fn begin(&mut self) {
        self.done += self.current;
        self.current = if self.ahead.is_empty() { 1.0 } else { self.ahead.remove(0) };
    }

    /// How much of all work is done where the run has come to that share of its own.
    fn at(&mut self, share: f64) -> f64 {
        if self.current == 0.0 {
            self.begin();
        }
        let all = self.done + self.current + self.ahead.iter().sum::<f64>();
        self.shown = self.shown.max((self.done + self.current * share) / all);
        self.shown
    }
}

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
        Self { display, plan: Plan::default(), before: None, last: vec![], scars: [None; 2] }
    }

    /// The bar, if there is one.
    pub fn bar(&self) -> Option<ProgressBar> {
        match &self.display {
            Display::Bar(bar) => Some(bar.clone()),
            Display::Lines(_) | Display::Nothing => None,
        }
    }

    /// The runs that come now, the last of them the run itself, on so many elements each.
    pub fn plan(&mut self, elements: &[[usize; 2]]) {
        self.plan.set(elements.iter().map(|[nx, ny]| (nx * ny) as f64).collect());
    }

    /// A run before the run itself begins, which is for that.
    pub fn begin_before(&mut self, what: String) {
        self.plan.begin();
        let share = self.plan.at(0.0);
        if let Display::Lines(_) = self.display {
            tell(&format!("{:>3.0} %  {what}", 100.0 * share));
        }
        self.before = Some(what);
    }

    /// The run itself begins.
    pub fn begin(&mut self) {
        self.plan.begin();
        self.before = None;
    }

    /// Says something between two steps.
    pub fn tell(&self, text: &str) {
        match &self.display {
            Display::Bar(bar) => bar.suspend(|| tell(text)),
            Display::Lines(_) => tell(text),
            Display::Nothing => {}
        }
    }

    /// Shows where a run is that is no simulation: the share of all work, and words for it.
    pub fn show(&mut self, share: f64, standing: &[String]) {
        match &mut self.display {
            Display::Bar(bar) => {
                bar.set_position((LENGTH * share) as u64);
                let width = usize::from(Term::stderr().size().1).saturating_sub(1);
                let left = format!("{:#}", HumanDuration(bar.eta()));
                bar.set_message(line(width, share, standing, &left));
            }
            Display::Lines(due) if self.before.is_none() && share >= *due - 1e-9 => {
                tell(&format!("{:>3.0} %  {}", 100.0 * share, standing.join(", ")));
                *due = (10.0 * share + 1.0 + 1e-9).floor() / 10.0;
            }
            Display::Lines(_) | Display::Nothing => {}
        }
    }

    /// Takes the bar off.
    pub fn end(&self) {
        if let Display::Bar(bar) = &self.display {
            bar.finish_and_clear();
        }
    }

    /// A number of the last step.
    pub fn number(&self, column: &str) -> Option<f64> {
        history::number(&self.last, column)
    }

    /// Where the run is: "distance 250 mm", "depth 1.46 um", "peak pressure 25.1 MPa".
    fn standing(&self, report: &Report<'_>) -> [String; 3] {
        let place = progress(report.problem.motion.progress, report.state.progress);
        let depth = self.number(WEAR_DEPTH).unwrap_or(0.0) * 1e6;
        let peak = self.number(PEAK_PRESSURE).unwrap_or(0.0) * 1e-6;
        [place, format!("depth {} um", four(depth)), format!("peak pressure {} MPa", four(peak))]
    }
}

impl Drop for Follower {
    fn drop(&mut self) {
        self.end();
    }
}

/// A bar without any place yet.
fn bar() -> ProgressBar {
    let style = ProgressStyle::with_template("{msg}");
    ProgressBar::new(LENGTH as u64)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// A line of at most so many columns: what is done, where the run is, the time left, a bar, and more of its numbers as far
/// as there is room. Nothing is cut.
fn line(width: usize, share: f64, standing: &[String], left: &str) -> String {
    let filled = ((BAR - 2) as f64 * share).round() as usize;
    let bar = format!("[{:<1$}]", "=".repeat(filled), BAR - 2);
    let percent = format!("{:>3.0} %", 100.0 * share);
    let left = format!("{left} left");
    let (place, more) =
        standing.split_first().map_or(("", &[][..]), |(place, more)| (&**place, more));
    // In the order in which they are read, each with its rank.
    let mut pieces = vec![(3, &*bar), (0, &*percent), (1, place)];
    pieces.extend(more.iter().enumerate().map(|(index, text)| (4 + index, &**text)));
    pieces.push((2, &left));
    let length = |rank: usize| {
        let taken = pieces.iter().filter(|(own, _)| *own <= rank);
        taken.map(|(_, text)| text.chars().count() + 2).sum::<usize>().saturating_sub(2)
    };
    let ranks = (0..pieces.len()).rev();
    let most = ranks.into_iter().find(|&rank| length(rank) <= width).unwrap_or(0);
    let taken = pieces.iter().filter(|(own, text)| *own <= most && !text.is_empty());
    taken.map(|(_, text)| *text).collect::<Vec<_>>().join("  ")
}

impl Observer for Follower {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn Error + Send + Sync>> {
        self.last = row(report);
        self.scars = [0, 1].map(|body| worn_extent(report, body));
        // A motion may go nowhere.
        let share = if report.extent > 0.0 { report.state.progress / report.extent } else { 1.0 };
        let share = self.plan.at(share);
        let mut standing = self.standing(report).to_vec();
        if let Some(what) = &self.before {
            standing = vec![what.clone(), standing.swap_remove(0)];
        }
        self.show(share, &standing);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Plan, line};

    /// At every width each number is whole or not there.
    #[test]
    fn lines_fit_and_cut_no_number() {
        let standing =
            ["distance 250.0 mm", "depth 1.445 um", "peak pressure 22.97 MPa"].map(str::to_owned);
        let whole = line(200, 0.5, &standing, "12s");
        assert_eq!(
            whole,
            "[==========          ]   50 %  distance 250.0 mm  depth 1.445 um  peak pressure 22.97 MPa  12s left"
        );
        for width in 5..120 {
            let shown = line(width, 0.5, &standing, "12s");
            assert!(shown.chars().count() <= width, "{width}: {shown}");
            let pieces = shown.split("  ").map(str::trim).filter(|piece| !piece.is_empty());
            for piece in pieces.filter(|piece| !piece.contains(['[', ']'])) {
                let known = standing.iter().any(|own| own == piece);
                assert!(known || ["50 %", "12s left"].contains(&piece), "{width}: `{piece}`");
            }
        }
        assert_eq!(line(40, 0.5, &standing, "12s"), " 50 %  distance 250.0 mm  12s left");
    }

    /// Companions on a quarter and a sixteenth of the elements, found too coarse, then finer ones: the share never falls and
    /// ends at one.
    #[test]
    fn runs_before_are_part_of_the_whole() {
        let mut plan = Plan::default();
        plan.set(vec![4.0, 1.0, 16.0]);
        let mut shares = vec![];
        for _ in 0..2 {
            plan.begin();
            shares.extend([plan.at(0.0), plan.at(1.0)]);
        }
        assert_eq!(shares, [0.0, 4.0 / 21.0, 4.0 / 21.0, 5.0 / 21.0]);
        plan.set(vec![16.0, 4.0, 64.0]);
        for _ in 0..3 {
            plan.begin();
            shares.extend([plan.at(0.0), plan.at(1.0)]);
        }
        assert!(shares.windows(2).all(|two| two[0] <= two[1]), "{shares:?}");
        assert_eq!(shares[4], 5.0 / 21.0);
        assert_eq!(shares[shares.len() - 2], 25.0 / 89.0);
        assert_eq!(shares.last(), Some(&1.0));
        let mut alone = Plan::default();
        assert_eq!([alone.at(0.5), alone.at(1.0)], [0.5, 1.0]);
    }
}
