//! A case and what is done with it: `check` and `run`.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use archard_case::output::Store;
use clap::Args;

/// A case with options laid over it.
#[derive(Debug, Args)]
pub struct Case {
    /// A case file, a folder with a `case.toml`, or the name of a built-in case
    pub case: PathBuf,
    /// Put a value at a key of the case, e.g. motion.sliding.step="10 mm"; the quotes may be left
    /// out, a table replaces the table that is there, and KEY= removes the key
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// The relative error that is asked for, 0.01 or 1%: what the case does not say of frame, elements and tolerance
    /// follows from it
    #[arg(long, value_name = "ERROR")]
    pub accuracy: Option<String>,
    /// End where a quantity of wear reaches a limit, e.g. wear_depth=0.1mm: the life of the part
    #[arg(long, value_name = "QUANTITY=LIMIT")]
    pub until: Vec<String>,
}

impl Case {
    /// The limits, as settings of their keys.
    pub fn limits(&self) -> impl Iterator<Item = String> {
        self.until.iter().map(|limit| format!("until.{limit}"))
    }

    /// The accuracy that is asked for, as a setting of its key.
    pub fn accuracy(&self) -> Option<String> {
        self.accuracy.as_deref().map(|error| format!("accuracy={}", share(error)))
    }

    /// All settings; the last may be the accuracy.
    pub fn settings(&self) -> Vec<String> {
        self.set.iter().cloned().chain(self.limits()).chain(self.accuracy()).collect()
    }
}

pub(super) const RUN_EXAMPLES: &str = "\
Examples:
  a case as it stands, into results/pin_on_disc:
    archard run cases/pin_on_disc
  at another load, to one per cent:
    archard run cases/pin_on_disc --set motion.sliding.load=\"20 N\" --accuracy 1%
  until a part is worn, with the coefficient of a fit, and how lives scatter from part to part:
    archard run bush.toml --until wear_depth=0.1mm --from results/rig_fit/fit.json
  on with what was interrupted:
    archard run --resume results/pin_on_disc";

pub(super) const CHECK_EXAMPLES: &str = "\
Examples:
  pressure and size of a contact, the depth to expect, the cost of a run:
    archard check cases/pin_on_disc
  the same to one per cent:
    archard check cases/pin_on_disc --accuracy 1%
  for a program:
    archard check cases/pin_on_disc --json";

/// The arguments of `check`.
#[derive(Debug, Args)]
pub struct Check {
    #[command(flatten)]
    pub case: Case,
    /// Print JSON: problems with their places, the case in SI, what to expect
    #[arg(long)]
    pub json: bool,
}

/// The arguments of `run`.
#[derive(Debug, Default, Args)]
pub struct Run {
    /// A case file, a folder with a `case.toml`, or the name of a built-in case
    #[arg(required_unless_present = "resume")]
    pub case: Option<PathBuf>,
    /// Put a value at a key of the case, e.g. motion.sliding.step="10 mm"; the quotes may be left
    /// out, a table replaces the table that is there, and KEY= removes the key
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// The relative error that is asked for, 0.01 or 1%: what the case does not say of frame, elements and tolerance
    /// follows from it
    #[arg(long, value_name = "ERROR", conflicts_with = "resume")]
    pub accuracy: Option<String>,
    /// End where a quantity of wear reaches a limit, e.g. wear_depth=0.1mm: the life of the part
    #[arg(long, value_name = "QUANTITY=LIMIT", conflicts_with = "resume")]
    pub until: Vec<String>,
    /// Take the wear coefficient from a fit (a `fit.json`), and tell how lives scatter as its tests do
    #[arg(long, value_name = "FILE", conflicts_with = "resume")]
    pub from: Option<PathBuf>,
    /// The key in this case of the coefficient of `--from`, where bodies have other names
    #[arg(long = "as", value_name = "KEY", requires = "from")]
    pub key: Option<String>,
    /// Take the wear coefficient at a key from the case where `--from` has none of that body
    #[arg(long, value_name = "KEY", requires = "from")]
    pub assume: Vec<String>,
    /// How long to look for a grid that reaches the accuracy, for example 10min, asked after each grid; then the run
    /// takes the finest one that was judged, and states its error
    #[arg(long, value_name = "TIME", conflicts_with = "resume")]
    pub budget: Option<String>,
    /// Go on with the run in this folder where it was interrupted, to the same results as without
    #[arg(long, value_name = "DIR", conflicts_with_all = ["case", "set", "output", "force"])]
    pub resume: Option<PathBuf>,
    /// Where to write the results; results/NAME if not given, with the values of --set in its name.
    /// Files that an earlier run of the same case wrote there are replaced; all others stay
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Replace the results of another case, or of an earlier version of the program
    #[arg(long)]
    pub force: bool,
    /// Write a page about the run into its folder, as `archard report` does
    #[arg(long)]
    pub report: bool,
    /// Number of threads; if not given one for half-spaces of up to 3600 elements, else as many as there are processors
    #[arg(long, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
    /// Where compliances of meshed bodies are kept for later runs; the user's folder of caches if not
    /// given
    #[arg(long, value_name = "DIR", env = "ARCHARD_CACHE")]
    pub cache: Option<PathBuf>,
    /// Print errors only
    #[arg(short, long)]
    pub quiet: bool,
    /// Print every check of the verdict, the good ones too
    #[arg(short, long, conflicts_with = "quiet")]
    pub verbose: bool,
}

impl Run {
    /// The case, of a run that goes on the one in its folder.
    pub fn case(&self) -> Case {
        let case = self.case.clone().or_else(|| Some(self.resume.clone()?.join("case.toml")));
        let (set, accuracy, until) = (self.set.clone(), self.accuracy.clone(), self.until.clone());
        Case { case: case.unwrap_or_default(), set, accuracy, until }
    }

    /// The folder of compliances, if there is any place for one.
    pub fn store(&self) -> Option<Store> {
        self.cache.clone().map(Store::new).or_else(Store::of_user)
    }
}

/// A share that may be written in percent, or without the zero before its point; anything else stays as it is.
fn share(text: &str) -> String {
    let (number, unit) = text.strip_suffix('%').map_or((text, 1.0), |number| (number, 0.01));
    let number = number.trim().parse::<f64>();
    number.map_or_else(|_| text.to_owned(), |number| (unit * number).to_string())
}
