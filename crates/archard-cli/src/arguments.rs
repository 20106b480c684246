//! The command line.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use archard::output::Store;
use clap::{Args, Parser, Subcommand};

/// Predicts contact and wear of elastic bodies from a case file.
#[derive(Debug, Parser)]
#[command(version, about, propagate_version = true)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run a case and write its results into a folder
    Run(Run),
    /// Show a case in SI, what to expect of it and what is doubtful about it
    Check(Case),
    /// List the built-in cases, or write one out to start from
    New(New),
    /// List the laws of wear and friction, with their formulas, the motions they suit and what they take
    Laws,
    /// Draw the pictures of a result folder
    Plot(Plot),
}

/// A case with options laid over it.
#[derive(Debug, Args)]
pub struct Case {
    /// A case file, or a folder with a `case.toml`
    pub case: PathBuf,
    /// Put a value at a key of the case, e.g. motion.sliding.step="10 mm"; the quotes may be left
    /// out, a table replaces the table that is there, and KEY= removes the key
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
}

/// The arguments of `run`.
#[derive(Debug, Args)]
pub struct Run {
    /// A case file, or a folder with a `case.toml`
    #[arg(required_unless_present = "resume")]
    pub case: Option<PathBuf>,
    /// Put a value at a key of the case, e.g. motion.sliding.step="10 mm"; the quotes may be left
    /// out, a table replaces the table that is there, and KEY= removes the key
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Go on with the run in this folder where it was interrupted, to the same results as without
    #[arg(long, value_name = "DIR", conflicts_with_all = ["case", "set", "output", "force"])]
    pub resume: Option<PathBuf>,
    /// Where to write the results; results/NAME if not given, with the values of --set in its name.
    /// Files of an earlier run of the same case in it are replaced, others left alone
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Replace the results of another case
    #[arg(long)]
    pub force: bool,
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
}

impl Run {
    /// The case, of a run that goes on the one in its folder.
    pub fn case(&self) -> Case {
        let case = self.case.clone().or_else(|| Some(self.resume.clone()?.join("case.toml")));
        Case { case: case.unwrap_or_default(), set: self.set.clone() }
    }

    /// The folder of compliances, if there is any place for one.
    pub fn store(&self) -> Option<Store> {
        self.cache.clone().map(Store::new).or_else(Store::of_user)
    }
}

/// The arguments of `new`.
#[derive(Debug, Args)]
pub struct New {
    /// A built-in case; all are listed if none is named
    pub name: Option<String>,
    /// The folder to write it into; the case's name if not given
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

/// The arguments of `plot`.
#[derive(Debug, Args)]
pub struct Plot {
    /// A folder written by `run`; the pictures go into its folder `plots`
    pub dir: PathBuf,
    /// Folders of other runs, whose wear is compared with that of the first
    #[arg(long, value_name = "DIR", num_args = 1..)]
    pub with: Vec<PathBuf>,
}
