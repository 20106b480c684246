//! Why a log, or a part of it, cannot be read.

use thiserror::Error;

/// What is wrong with a log as a whole. Each message names the place and what to do.
#[derive(Debug, Error, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// The compressed file is damaged.
    #[error("{log}: the gzip file is damaged ({why}): copy it from the instrument again")]
    Damaged {
        /// The log.
        log: String,
        /// What the decompressor says.
        why: String,
    },
    /// No line holds two numbers.
    #[error(
        "{log}: there are no rows of numbers: export the readings as text, with tabs, semicolons or commas between the columns"
    )]
    NoRows {
        /// The log.
        log: String,
    },
    /// Numbers begin, and no line above names the columns.
    #[error(
        "{log}:{line}: rows of numbers begin here, and no line above names their columns: put a line of names and units there, like `time [s];distance [m];wear [um];load [N]`"
    )]
    NoHeading {
        /// The log.
        log: String,
        /// The first line of numbers.
        line: usize,
    },
    /// A row has more cells than there are names, or not as many where blanks separate them.
    #[error(
        "{log}:{line}: there are {values} cells in this row and {names} names in line {heading}: export with one separator that is no decimal sign, and a name for each column"
    )]
    Width {
        /// The log.
        log: String,
        /// The first row.
        line: usize,
        /// Its cells.
        values: usize,
        /// The names.
        names: usize,
        /// The line of the names.
        heading: usize,
    },
    /// Another table begins within the file.
    #[error(
        "{log}:{line}: the columns have other names from here on (`{heading}`): give each table a file of its own"
    )]
    OtherTable {
        /// The log.
        log: String,
        /// The line of the other names.
        line: usize,
        /// That line.
        heading: String,
    },
    /// A height over a length and nothing else.
    #[error(
        "{log}:{line}: this is a profile ({titles}), not a log of a test: name it in the column `file` of the table that `archard fit` reads, or give it to `archard compare`"
    )]
    Profile {
        /// The log.
        log: String,
        /// The line of the names.
        line: usize,
        /// The titles.
        titles: String,
    },
    /// An option names no column.
    #[error("{log}:{line}: no column is called `{title}`; there are {titles}")]
    NoColumn {
        /// The log.
        log: String,
        /// The line of the names.
        line: usize,
        /// What was asked for.
        title: String,
        /// The titles there are.
        titles: String,
    },
    /// Columns of one name hold different values.
    #[error(
        "{log}:{line}: two columns are called `{title}` and differ (first at line {differ}): choose with --column {role}=\"{title}#1\" or \"{title}#2\""
    )]
    TwoOfAName {
        /// The log.
        log: String,
        /// The line of the names.
        line: usize,
        /// The title.
        title: String,
        /// Where they first differ.
        differ: usize,
        /// What the column is for.
        role: &'static str,
    },
    /// A column without a unit that nothing else confirms.
    #[error(
        "{log}:{line}: the column `{title}` has no unit: say which, like --column {role}=\"{title} [{unit}]\""
    )]
    NoUnit {
        /// The log.
        log: String,
        /// The line of the names.
        line: usize,
        /// The title.
        title: String,
        /// What the column is for.
        role: &'static str,
        /// A unit that would do.
        unit: &'static str,
    },
    /// A unit of another measure.
    #[error(
        "{log}:{line}: `{title}` is in {unit}, which is not a unit of {measure}: choose another column with --column {role}=TITLE"
    )]
    OtherMeasure {
        /// The log.
        log: String,
        /// The line of the names.
        line: usize,
        /// The title.
        title: String,
        /// Its unit.
        unit: String,
        /// The measure that is needed.
        measure: &'static str,
        /// What the column is for.
        role: &'static str,
    },
    /// Nothing says how far the bodies slid.
    #[error("{log}:{line}: nothing says how far the bodies slid, in columns {titles}: {remedy}")]
    NoDistance {
        /// The log.
        log: String,
        /// The line of the names.
        line: usize,
        /// The titles.
        titles: String,
        /// What to give.
        remedy: String,
    },
    /// An option states another unit than the log or its rig.
    #[error(
        "{log}:{line}: `{title}` is in {known}, and --column {role} says {asked}: leave the unit out, or correct the heading of the log"
    )]
    TwoUnits {
        /// The log.
        log: String,
        /// The line of the names.
        line: usize,
        /// The title.
        title: String,
        /// The unit of the log or of its rig.
        known: String,
        /// The unit of the option.
        asked: String,
        /// What the column is for.
        role: &'static str,
    },
    /// Columns contradict one another by a factor that only a unit makes.
    #[error(
        "{log}:{line}: {one} is {ratio} times that from {other}: one of their units is wrong; correct the heading, or state what is missing with --column or --set"
    )]
    Disagree {
        /// The log.
        log: String,
        /// The line of the names.
        line: usize,
        /// What contradicts.
        one: String,
        /// What it contradicts.
        other: String,
        /// The factor.
        ratio: String,
    },
    /// An option cannot be one.
    #[error("{option}: {help}")]
    Option {
        /// As it was given.
        option: String,
        /// What to write.
        help: String,
    },
}
