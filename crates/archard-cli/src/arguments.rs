//! The command line.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::str::FromStr;

use archard_case::output::Store;
use clap::{Args, Parser, Subcommand, ValueEnum, ValueHint};
use clap_complete::Shell;

use crate::plot::draw::{Format, Paper, Width};

/// Predicts contact and wear of elastic bodies from a case file.
#[derive(Debug, Parser)]
#[command(name = "archard", version, about, propagate_version = true)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run a case and write its results into a folder
    #[command(after_help = RUN_EXAMPLES)]
    Run(Run),
    /// Show a case in SI, what to expect of it and what is doubtful about it
    #[command(after_help = CHECK_EXAMPLES)]
    Check(Check),
    /// Write a case to start from: of a rig, or a built-in one
    #[command(after_help = NEW_EXAMPLES)]
    New(New),
    /// List the laws of wear and friction, with their formulas, the motions they suit and what they take; or show one in full
    #[command(after_help = LAWS_EXAMPLES)]
    Laws {
        /// A law, for example energy or friction.table
        name: Option<String>,
    },
    /// List the materials that a case can name, with what handbooks say of them; or show one with its source
    #[command(after_help = MATERIALS_EXAMPLES)]
    Materials {
        /// A material, for example 100Cr6
        name: Option<String>,
    },
    /// Draw the pictures of a result folder, or of a study
    #[command(after_help = PLOT_EXAMPLES)]
    Plot(Plot),
    /// Write the worn surfaces of a result folder for ParaView, and a macro that shows them
    Paraview {
        /// A folder written by `run`; the files go into its folder `paraview`
        #[arg(value_hint = ValueHint::DirPath)]
        dir: PathBuf,
    },
    /// Write a page about a run, a study or a fit that opens in any browser: results, verdict, theory, curves, maps
    Report(Report),
    /// Keep the page of a run up to date while it goes on; the browser reloads it
    #[command(after_help = WATCH_EXAMPLES)]
    Watch {
        /// The folder that `run` writes into
        #[arg(value_hint = ValueHint::DirPath)]
        dir: PathBuf,
    },
    /// Hold a run against measured profiles, readings over the motion, or other runs; or tell what is worn between two scans
    #[command(after_help = COMPARE_EXAMPLES)]
    Compare(Compare),
    /// Run a study: a case over lists, ranges and distributions of its values
    #[command(after_help = SWEEP_EXAMPLES)]
    Sweep(Sweep),
    /// Find wear coefficients from measured tests: median, interval, and where the next test will lie
    #[command(after_help = FIT_EXAMPLES)]
    Fit(Fit),
    /// Predict measured tests by each other, and hold the predictions against what was measured
    Validate(Validate),
    /// Show what is in the file of a measured surface: its size, its texture after ISO 25178-2, its spectrum, and what preparing
    /// takes off
    #[command(after_help = SURFACE_EXAMPLES)]
    Surface {
        /// Digital Surf (.sur), SDF (.sdf), NumPy (.npy), or a matrix of heights (.csv, .txt, .asc)
        #[arg(value_hint = ValueHint::FilePath)]
        file: PathBuf,
        /// A key of `profile.surface` and its value
        #[arg(long = "set", value_name = "KEY=VALUE")]
        set: Vec<String>,
        /// Draw the heights and the power spectra into this file (.png, .svg, or .pdf if built with it)
        #[arg(short, long, value_name = "PICTURE", value_hint = ValueHint::FilePath)]
        output: Option<PathBuf>,
    },
    /// Read logs of tribometers: columns, the steady part, wear rate and friction with their 95 % intervals
    #[command(after_help = LOG_EXAMPLES)]
    Log(Log),
    /// Show threads, vectors, memory and cache of this machine, and run a self-test of two seconds
    Doctor,
    /// Print what completes the command line in a shell
    #[command(after_help = COMPLETIONS_EXAMPLES)]
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Write the manual pages
    Man {
        /// The folder they go into
        #[arg(value_hint = ValueHint::DirPath)]
        dir: PathBuf,
    },
}

/// Logs, and what they do not hold.
#[derive(Debug, Args)]
pub struct Log {
    /// Text as the instrument writes it, or that text in gzip; tests of one name or set-up are held against each other
    #[arg(required = true, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub files: Vec<PathBuf>,
    /// A column by its title, e.g. wear="Displacement [um]"; a minus before the title turns the sign
    #[arg(long, value_name = "NAME=TITLE")]
    pub column: Vec<String>,
    /// A value that the log does not hold: load, radius, speed, stroke, or from, where the steady part begins; one for each step
    /// as load="5 N; 10 N"
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Print the results in SI as JSON
    #[arg(long)]
    pub json: bool,
    /// Draw depth and friction over the distance into this file (.png, .svg, or .pdf if built with it)
    #[arg(long, value_name = "PICTURE", value_hint = ValueHint::FilePath)]
    pub picture: Option<PathBuf>,
    /// A profile of what the test wore, for the rows: of the log in the same place
    #[arg(long, value_name = "PROFILE", value_hint = ValueHint::FilePath)]
    pub profile: Vec<PathBuf>,
    /// Write the rows that `archard fit` reads into this file, which must not exist
    #[arg(short, long, value_name = "ROWS", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
}

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

    /// All settings, the last of which may be the accuracy.
    pub fn settings(&self) -> Vec<String> {
        self.set.iter().cloned().chain(self.limits()).chain(self.accuracy()).collect()
    }
}

const RUN_EXAMPLES: &str = "\
Examples:
  a case as it stands, into results/pin_on_disc:
    archard run cases/pin_on_disc
  at another load, to one per cent:
    archard run cases/pin_on_disc --set motion.sliding.load=\"20 N\" --accuracy 1%
  until a part is worn, with the coefficient of a fit and the lives of parts alike:
    archard run bush.toml --until wear_depth=0.1mm --from results/rig_fit/fit.json
  on with what was interrupted:
    archard run --resume results/pin_on_disc";

const CHECK_EXAMPLES: &str = "\
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

const LAWS_EXAMPLES: &str = "\
Examples:
  all laws:
    archard laws
  one, with its bounds, an example and its source:
    archard laws energy";

const MATERIALS_EXAMPLES: &str = "\
Examples:
  all materials:
    archard materials
  one, with heat and its source:
    archard materials 100Cr6";

const WATCH_EXAMPLES: &str = "\
Examples:
  beside a run in another terminal; then open results/pin_on_disc/report.html:
    archard watch results/pin_on_disc";

const NEW_EXAMPLES: &str = "\
Examples:
  asks which rig it is, then for its materials, sizes and loads:
    archard new
  asks for those of a reciprocating rig:
    archard new reciprocating --ask
  a case of a reciprocating rig, in the folder monday:
    archard new reciprocating -o monday
  all rigs and cases:
    archard new --list";

/// The arguments of `new`.
#[derive(Debug, Args)]
pub struct New {
    /// A rig, or a built-in case; on a terminal you are asked for the rig and its values if none is named
    pub name: Option<String>,
    /// List the rigs and the built-in cases
    #[arg(long, conflicts_with_all = ["name", "output"])]
    pub list: bool,
    /// Ask for the materials, sizes and loads of the rig; Enter keeps those of its case
    #[arg(long, conflicts_with = "list")]
    pub ask: bool,
    /// The folder to write it into; the case's name if not given
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

const LOG_EXAMPLES: &str = "\
Examples:
    archard log test_1.tsv.gz test_2.tsv.gz --picture tests.png -o rows.csv
    archard log t11.csv --set load=\"10 N\" --set radius=\"10 mm\"
    archard log csm.txt --profile csm_profile.csv -o rows.csv";

const SURFACE_EXAMPLES: &str = "\
Examples:
  what an instrument wrote:
    archard surface scan.sur
  a matrix, whose file tells no sizes, less its tilt:
    archard surface scan.npy --set pixel=\"2 um\" --set unit=um --set level=plane
  the roughness of a ball below 0.8 mm, without its spikes, and a picture:
    archard surface ball.sur --set form=sphere --set outliers=remove --set rough=\"0.8 mm\" -o ball.png";

const PLOT_EXAMPLES: &str = "\
Examples:
  the pictures of a run:
    archard plot results/pin_on_disc
  its wear beside that of another run:
    archard plot results/pin_on_disc --with results/other";

const COMPLETIONS_EXAMPLES: &str = "\
Examples:
    archard completions bash > ~/.local/share/bash-completion/completions/archard
    archard completions zsh > ~/.zfunc/_archard
    archard completions fish > ~/.config/fish/completions/archard.fish";

/// The arguments of `plot`.
#[derive(Debug, Args)]
pub struct Plot {
    /// A folder written by `run`; the pictures go into its folder `plots`
    pub dir: PathBuf,
    /// Folders of other runs, whose wear is compared with that of the first
    #[arg(long, value_name = "DIR", num_args = 1..)]
    pub with: Vec<PathBuf>,
    /// What the pictures of a study show: a column of the history, e.g. worn_volume_ball_m3; if not given the wear depth of each
    /// body, or the peak pressure where nothing wears
    #[arg(long, value_name = "COLUMN", conflicts_with = "with")]
    pub quantity: Vec<String>,
    /// The width to fill in print, with letters to match; that of a screen if not given
    #[arg(long, value_enum)]
    pub size: Option<Width>,
    /// The files to write, e.g. svg,png, or pdf if built with it; SVG and PNG if not given
    #[arg(long, value_enum, value_delimiter = ',')]
    pub format: Vec<Format>,
}

impl Plot {
    /// What the pictures are for.
    pub fn paper(&self) -> Paper {
        Paper { width: self.size, formats: self.format.clone() }
    }
}

const COMPARE_EXAMPLES: &str = "\
Examples:
  a profile across a scar, with columns `x [mm]` and `z [um]`, as the instrument has written it:
    archard compare results/pin_on_disc scar.csv
  depths over the distance, under the titles of the laboratory:
    archard compare results/pin_on_disc wear.csv --column distance=\"Weg [m]\" --column depth=\"Tiefe [um]\"
  another run:
    archard compare results/pin_on_disc results/pin_on_disc_both
  what is worn between two scans of a surface:
    archard compare --before unworn.sur --after worn.sur -o results/scar";

/// The arguments of `compare`.
#[derive(Debug, Args)]
pub struct Compare {
    /// A folder written by `run`; the picture goes into its folder `plots`
    #[arg(required_unless_present = "before")]
    pub dir: Option<PathBuf>,
    /// Measured tables (CSV), and folders of other runs
    #[arg(required_unless_present = "before", value_name = "MEASURED.csv|DIR")]
    pub others: Vec<PathBuf>,
    #[command(flatten)]
    pub options: crate::compare::Options,
    #[command(flatten)]
    pub scans: crate::compare::scans::Scans,
}

/// The arguments of `report`.
#[derive(Debug, Default, Args)]
pub struct Report {
    /// A folder written by `run`, `sweep` or `fit`; after one of `run` those of other runs to compare it with
    #[arg(required = true, value_name = "DIR")]
    pub dirs: Vec<PathBuf>,
    /// The page; report.html in the first folder if not given
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Measured tables (CSV) to show beside the run, as `archard compare` reads them
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub measured: Vec<PathBuf>,
    #[command(flatten)]
    pub options: crate::compare::Options,
}

const SWEEP_EXAMPLES: &str = "\
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

const FIT_EXAMPLES: &str = "\
Data: a row a reading, with columns like
  test,distance_m,depth_um,u_depth_um
  A,100,1.21,0.05
`test` says which readings are of one test. How far a reading is: distance, turns, revolutions, cycles or time, as the
motion of the case goes. What was measured: volume, depth, width, section, length, diameter or mass, followed by _BODY
where both bodies wear, and u_... for its standard uncertainty. `load` where tests have loads of their own. Headers may
be like `Distance [mm]`, separators `,` `;` or tabs, numbers with decimal commas.

Examples:
    archard fit cases/pin_on_disc --data scars.csv -o results/fit
    archard fit CASE --data scars.csv --column depth=\"Tiefe [um]\" --uncertain motion.sliding.load=1%
    archard sweep CASE --from results/fit/fit.json --samples 200 -o results/prediction";

/// The arguments of `fit`.
#[derive(Debug, Args)]
pub struct Fit {
    /// The case of the tests.
    #[command(flatten)]
    pub case: Case,
    /// The measured tests, as CSV, a row a reading: test, how far it was (distance, turns, cycles, time), and volume, depth,
    /// section, mass, width, length or diameter, or in the column file the name of a profile or height map
    #[arg(long, value_name = "FILE")]
    pub data: PathBuf,
    /// The key to be fitted, e.g. body.disc.layers.0.wear.archard.coefficient, or several, which are fitted together from all
    /// readings; if not given, the wear coefficient of each body of which there are readings
    #[arg(long, value_name = "KEY")]
    pub parameter: Vec<String>,
    /// Use a column of another header, e.g. depth="Tiefe [um]"; x, y and z are those of profiles and height maps
    #[arg(long, value_name = "NAME=HEADER")]
    pub column: Vec<String>,
    /// Take the wear coefficient at a key from the case though there are no readings of that body, or give the one that is fitted though
    /// the tests do not wear by its law
    #[arg(long, value_name = "KEY")]
    pub assume: Vec<String>,
    /// A standard uncertainty that all tests have in common, e.g. motion.sliding.load=1% or distance=0.5%
    #[arg(long, value_name = "KEY=PERCENT")]
    pub uncertain: Vec<String>,
    /// Where `fit.json`, `fit.csv`, the picture and the runs go; results/NAME_fit if not given
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Where compliances of meshed bodies are kept for later runs; the user's folder of caches if not
    /// given
    #[arg(long, value_name = "DIR", env = "ARCHARD_CACHE")]
    pub cache: Option<PathBuf>,
    /// Print errors only
    #[arg(short, long)]
    pub quiet: bool,
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

/// Arguments of `archard validate`.
#[derive(Debug, clap::Args)]
pub struct Validate {
    /// A set of measured tests (a folder with `set.toml`), or a folder of sets
    #[arg(default_value = "validation", value_hint = ValueHint::DirPath)]
    pub folder: PathBuf,
    /// Print the results in SI as JSON
    #[arg(long)]
    pub json: bool,
    /// Write the results as a page of Markdown
    #[arg(short, long, value_name = "PAGE", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// Keep compliances of meshed bodies there
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub cache: Option<PathBuf>,
    /// Print nothing but what has to be known
    #[arg(short, long)]
    pub quiet: bool,
}
