//! How long a run takes, at the pace that this machine has with its contact solves.

use std::fmt;
use std::time::{Duration, Instant};

use super::pace::duration;
use super::words::three;
use super::{Forecast, Solves};
use crate::case::definition::Case;
use archard::simulation::Run;

/// Pairs times solves that are quick on any machine: nothing is measured. A solve takes as long as some pairs at least.
const QUICK: f64 = 3e5;
const OF_A_SOLVE: usize = 1000;
/// Pairs on which solves are timed: enough that they, and no overhead, take the time, and few enough for an answer at once.
const PAIRS: usize = 64 * 64;
/// How long solves are timed. The step that is under way is not broken off.
const TIMED: Duration = Duration::from_millis(300);

/// The time of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::case) enum Runtime {
    /// No time to speak of, on these elements where an accuracy may ask for more.
    Quick {
        /// Whether it may.
        searched: bool,
    },
    /// So long.
    Measured {
        /// In all (s).
        seconds: f64,
        /// Of a contact solve (s).
        solve: f64,
        /// Whether it is the least: more solves may follow, or runs on coarser grids come before.
        least: bool,
    },
}

impl Runtime {
    /// That of a case, measured now; `None` where the equations of meshes take the time, or the first contacts are not found.
    pub fn of(case: &Case, forecast: &Forecast) -> Option<Self> {
        let (solves, more) = match forecast.solves {
            Solves::Exactly(solves) | Solves::About(solves) => (solves as f64, false),
            Solves::AtLeast(solves) => (solves as f64, true),
        };
        let pairs = forecast.pairs;
        if case.is_meshed() {
            return None;
        }
        if solves * (pairs + OF_A_SOLVE) as f64 <= QUICK {
            return Some(Self::Quick { searched: case.accuracy.is_some() });
        }
        let mut coarse = Case { accuracy: None, ..case.clone() };
        while coarse.frame.elements.iter().product::<usize>() > PAIRS {
            coarse.frame.elements = coarse.frame.elements.map(|n| n.div_ceil(2));
        }
        let timed = coarse.frame.elements.iter().product();
        let solve = a_solve(&coarse)? * work(pairs) / work(timed);
        let least = more || case.accuracy.is_some();
        Some(Self::Measured { seconds: solves * solve, solve, least })
    }
}

/// The time (s) of a contact solve of a case, in the mean over its first steps.
fn a_solve(case: &Case) -> Option<f64> {
    let simulation = case.build().ok()?;
    let begun = Instant::now();
    let mut run = Run::begin(simulation).ok()?;
    while begun.elapsed() < TIMED && run.step().ok()? {}
    let solves = run.report().effort.solves;
    (solves > 0).then(|| begun.elapsed().as_secs_f64() / solves as f64)
}

/// What an application of the compliance by Fourier transforms depends on; the iterations of a solve hardly depend on the pairs.
pub(super) fn work(pairs: usize) -> f64 {
    let pairs = pairs as f64;
    pairs * pairs.log2().max(1.0)
}

impl fmt::Display for Runtime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (seconds, solve, least) = match self {
            Self::Measured { seconds, solve, least } => (seconds, solve, least),
            Self::Quick { searched } => {
                let on = if *searched { "on these elements" } else { "at most" };
                return writeln!(f, "time              some seconds {on}");
            }
        };
        let about = if *least { "at least" } else { "about" };
        let time =
            if *seconds < 10.0 { format!("{} s", three(*seconds)) } else { duration(*seconds) };
        let solve = three(1e3 * solve);
        writeln!(
            f,
            "time              {about} {time}, at {solve} ms a contact solve as measured now"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::Runtime;
    use crate::CaseFile;

    const FRETTING: &str = "body.ball.material = { young = \"210 GPa\", poisson = 0.3 }\n\
        body.ball.profile.sphere.radius = \"10 mm\"\n\
        body.flat.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.flat.profile.flat = {}\n\
        friction.coulomb.coefficient = 0.6\n\
        frame = { size = [\"0.45 mm\", \"0.45 mm\"], elements = [16, 16] }\n\
        motion.fretting = { load = \"50 N\", amplitude = [\"1 um\", \"0 um\"], cycles = 1, increments = 20 }\n";

    /// The time is that of a solve times the solves, of any number of elements and of cycles; what is quick has none.
    #[test]
    fn the_time_is_that_of_all_solves() {
        let of = |cycles: u32, elements: u32| {
            let file = CaseFile::from_text("case", FRETTING, "");
            let file = file.set(format!("motion.fretting.cycles={cycles}"));
            let file = file.set(format!("frame.elements=[{elements}, {elements}]"));
            let resolved = file.resolve().unwrap();
            let time = Runtime::of(&resolved.case, &resolved.forecast);
            (time.unwrap(), resolved.expectations())
        };
        let (quick, said) = of(1, 16);
        assert_eq!(quick, Runtime::Quick { searched: false });
        assert!(said.contains("time              some seconds at most"), "{said}");
        for (cycles, elements) in [(100, 16), (2, 256)] {
            let (time, said) = of(cycles, elements);
            let Runtime::Measured { seconds, solve, .. } = time else { panic!("{said}") };
            let solves = seconds / solve;
            assert!((20.0 * f64::from(cycles)..25.0 * f64::from(cycles) + 25.0).contains(&solves));
            let line = said.lines().find(|line| line.starts_with("time  ")).unwrap();
            assert!(line.contains(" ms a contact solve as measured now"), "{line}");
            // Between a pocket calculator and the largest of machines.
            assert!(solve > 1e-6 && solve < 1e3, "{time:?}");
        }
    }
}
