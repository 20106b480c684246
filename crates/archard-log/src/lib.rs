//! Logs of tribometers: text as instruments write it -> columns in SI -> steps and parts of the test -> wear rate and friction with
//! intervals that know that readings a second apart are not independent.
//!
//! [`Log::read`] knows nothing of cases, of simulation or of the terminal.

mod derive;
mod error;
mod groups;
mod head;
mod noise;
mod number;
mod options;
mod rate;
mod report;
mod roles;
mod rows;
mod step;
mod steps;
mod table;
mod text;
mod transducer;
mod unit;

pub use error::Error;
pub use groups::{Group, groups};
pub use options::Options;
pub use rate::Rate;
pub use rows::{NoMatch, ROWS, ROWS_OF_PROFILES, rows, with_profile};
pub use step::{Course, Step};

use rate::FEWEST;
use table::Table;

/// A log, read and judged.
#[derive(Debug, Clone)]
pub struct Log {
    /// What messages call it.
    pub source: String,
    /// Lines that say what was read and what was derived: name and words.
    pub said: Vec<(String, String)>,
    /// Its steps, in order.
    pub steps: Vec<Step>,
}

impl Log {
    /// Reads the bytes of a log; `source` is what messages call it.
    ///
    /// # Errors
    /// If it is no log, or nothing says how far the bodies slid.
    pub fn read(source: &str, bytes: &[u8], options: &Options) -> Result<Self, Error> {
        options.check()?;
        let table = Table::read(source, bytes)?;
        if table.is_profile() {
            let (log, line, titles) = (source.to_owned(), table.heading, table.titles());
            return Err(Error::Profile { log, line, titles });
        }
        let mut all = derive::derive(&table, options)?;
        let from = options.each("from", all.steps.len())?;
        // A rig closes a test with a step of a reading or two.
        let readings = |step: &usize| all.steps[*step].len();
        let longest = (0..all.steps.len()).rev().max_by_key(readings);
        let (told, short): (Vec<usize>, Vec<usize>) = (0..all.steps.len())
            .partition(|step| readings(step) >= FEWEST || longest == Some(*step));
        if !short.is_empty() {
            let lines = short.iter().map(|step| table.lines[all.steps[*step].start].to_string());
            let lines: Vec<String> = lines.take(5).collect();
            let words = format!(
                "steps of fewer than {FEWEST} readings passed over: {}, at lines {}",
                short.len(),
                lines.join(", ")
            );
            all.said.push(("reading".to_owned(), words));
        }
        let of = |step: &usize| {
            let start = from.as_ref().map(|from| from[*step]);
            Step::of(&table, &all, all.steps[*step].clone(), start)
        };
        let steps = told.iter().map(of).collect();
        Ok(Self { source: source.to_owned(), said: all.said, steps })
    }

    /// The step of the longest distance with a rate, or else the longest.
    pub fn main_step(&self) -> Option<&Step> {
        let longest = |one: &&Step, other: &&Step| one.distance.total_cmp(&other.distance);
        let told = self.steps.iter().filter(|step| step.steady.is_some()).max_by(longest);
        told.or_else(|| self.steps.iter().max_by(longest))
    }

    /// The name of its file, without folder and ending.
    pub fn name(&self) -> String {
        let name = self.source.rsplit(['/', '\\']).next().unwrap_or_default();
        let stem = |name: &str| name.rsplit_once('.').map(|(stem, _)| stem.to_owned());
        let plain = name.strip_suffix(".gz").unwrap_or(name);
        stem(plain)
            .filter(|stem| !stem.is_empty())
            .unwrap_or(plain.to_owned())
            .replace([',', '"', ';', '\t'], "_")
    }
}
