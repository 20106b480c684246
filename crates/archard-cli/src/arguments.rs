//! The command line.

mod run;
mod sweep;

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueHint};
use clap_complete::Shell;

use crate::plot::draw::{Format, Paper, Width};

pub use run::{Case, Check, Run};
pub use sweep::{Design, Layout, Sweep};

use run::{CHECK_EXAMPLES, RUN_EXAMPLES};
use sweep::SWEEP_EXAMPLES;

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
        /// Digital Surf (.sur), SDF (.sdf), X3P (.x3p), Gwyddion (.gwy), NetCDF (.nc), NumPy (.npy), or a matrix of heights (.csv,
        /// .txt, .asc)
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
    /// Measured tables (CSV) to show next to the run, as `archard compare` reads them
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub measured: Vec<PathBuf>,
    #[command(flatten)]
    pub options: crate::compare::Options,
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
    /// readings; if not given, the wear coefficient of each body that has readings
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
