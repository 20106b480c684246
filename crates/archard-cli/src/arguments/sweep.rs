//! A study: `sweep`, the design of its rows and a task's share of them.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::str::FromStr;

use clap::{Args, ValueEnum};

use super::Case;

pub(super) const SWEEP_EXAMPLES: &str = "\
Examples:
  three loads, each at six coefficients of friction:
    archard sweep CASE --over motion.rolling.load=\"100 N,200 N,300 N\" \\
      --over friction.coulomb.coefficient=0.1:0.6:6 -o results/study
  two amplitudes, each along x and y:
    archard sweep CASE --over 'motion.fretting.amplitude=[\"1 um\", \"0 um\"]; [\"2 um\", \"0 um\"]' -o results/amplitudes
  200 samples of a wear coefficient, known to a factor:
    archard sweep CASE --sample \"body.pin.wear.archard.coefficient=lognormal(1.4e-4 mm^3/(N m), 0.4)\" \\
      --samples 200 -o results/scatter
  the shares of two scattering values in the scatter of the results (Sobol indices):
    archard sweep CASE --sample \"motion.sliding.load=normal(10 N, 1 N)\" \\
      --sample \"body.pin.profile.sphere.radius=uniform(45 mm, 55 mm)\" \\
      --samples 128 --design saltelli -o results/shares
  a part of the rows in each task of a Slurm array:
    archard sweep CASE ... --task $SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT

The same command goes on where it was interrupted. `archard plot DIR` draws the study.";

/// The arguments of `sweep`.
#[derive(Debug, Clone, Args)]
pub struct Sweep {
    /// A case file, a folder with a `case.toml`, or the name of a built-in case
    pub case: PathBuf,
    /// Put a value at a key of the case in all rows
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// The relative error that is asked for in all rows, 0.01 or 1%: what the case does not say of frame,
    /// elements and tolerance follows from it
    #[arg(long, value_name = "ERROR")]
    pub accuracy: Option<String>,
    /// Go over values of a key: "5 N,10 N,20 N", lists or tables likewise, or a range "5 N:20 N:4" of four; each with each
    /// value of other keys
    #[arg(long, value_name = "KEY=VALUES")]
    pub over: Vec<String>,
    /// Draw values of a key: normal(mean, deviation), lognormal(median, deviation of the logarithm) or
    /// uniform(from, to)
    #[arg(long, value_name = "KEY=DISTRIBUTION", requires = "samples")]
    pub sample: Vec<String>,
    /// Draw the coefficients of a fit (a `fit.json`) as the next test will have them
    #[arg(long, value_name = "FILE", requires = "samples")]
    pub from: Option<PathBuf>,
    /// Take the wear coefficient at a key from the case where `--from` has none of that body
    #[arg(long, value_name = "KEY", requires = "from")]
    pub assume: Vec<String>,
    /// How the first two coefficients of `--from` go together, where they come from the same tests: correlation of their
    /// logarithms
    #[arg(skip)]
    pub together: Option<f64>,
    /// Number of samples, at each value of --over
    #[arg(long, value_name = "N")]
    pub samples: Option<NonZeroUsize>,
    /// Tells sets of samples apart
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u32,
    /// How samples are laid
    #[arg(long, value_name = "DESIGN", value_enum)]
    pub design: Option<Design>,
    /// The folder of the study: `design.csv`, `sweep.csv` and a result folder a row in `rows`
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Rows that run at once; as many as there are processors if not given
    #[arg(short, long, value_name = "N")]
    pub jobs: Option<NonZeroUsize>,
    /// Threads a row
    #[arg(long, value_name = "N", default_value = "1")]
    pub threads: NonZeroUsize,
    /// Run every N-th row, from row I on: other tasks run the others, at the same time or not
    #[arg(long, value_name = "I/N")]
    pub task: Option<Share>,
    /// Run each row by itself, those too that one run could tell because only k s counts
    #[arg(long)]
    pub separate: bool,
    /// Where compliances of meshed bodies are kept for later runs; the user's folder of caches if not
    /// given
    #[arg(long, value_name = "DIR", env = "ARCHARD_CACHE")]
    pub cache: Option<PathBuf>,
    /// Print errors only
    #[arg(short, long)]
    pub quiet: bool,
}

impl Sweep {
    /// The case of all rows.
    pub fn case(&self) -> Case {
        let Self { case, set, accuracy, .. } = self.clone();
        Case { case, set, accuracy, until: vec![] }
    }
}

/// How the rows of a study are laid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Design {
    /// Each value with each of the others, without samples; the default where there are none
    Grid,
    /// Latin hypercube; the default of samples
    Latin,
    /// Sobol sequence, scrambled
    Sobol,
    /// Two Sobol samples and their mixtures, N (d + 2) rows for d sampled keys: what Sobol indices take
    Saltelli,
}

/// How samples are laid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// Latin hypercube.
    Latin,
    /// Sobol sequence.
    Sobol,
    /// Two Sobol samples and their mixtures.
    Saltelli,
}

/// A task's share of the rows: those whose number leaves a remainder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Share {
    /// The remainder.
    task: usize,
    /// Number of tasks.
    of: NonZeroUsize,
}

impl Share {
    /// Whether what has that number, from zero on, is in the share.
    pub fn holds(self, index: usize) -> bool {
        index % self.of == self.task % self.of
    }
}

impl FromStr for Share {
    type Err = &'static str;

    /// `0/8` to `7/8`; or, where tasks are counted from one, `1/8` to `8/8`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const LIKE: &str = "write a task and the number of tasks, like 0/8 to 7/8";
        let (task, of) = text.split_once('/').ok_or(LIKE)?;
        let share = Share { task: task.parse().or(Err(LIKE))?, of: of.parse().or(Err(LIKE))? };
        if share.task <= share.of.get() { Ok(share) } else { Err(LIKE) }
    }
}
