//! Why a file of a profile cannot be read.

use crate::profile::{MOST_POINTS, Part};

/// What cannot be read, and where.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("line {line}: {cause}")]
pub struct ReadError {
    /// The line, numbered from 1.
    pub line: usize,
    /// What is wrong.
    pub cause: Cause,
}

/// What cannot be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Cause {
    /// A word that should be a number.
    #[error("`{word}` is not a finite number")]
    Number {
        /// The word.
        word: String,
    },
    /// A row with the wrong number of values.
    #[error("{found} values in a row, and {needed} are needed")]
    Columns {
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A line or a value that the format asks for.
    #[error("`{what}` is missing")]
    Missing {
        /// Its name.
        what: &'static str,
    },
    /// A key with a value that this reader does not follow.
    #[error("`{key}` is not supported: {advice}")]
    Unsupported {
        /// The key.
        key: String,
        /// What to do.
        advice: &'static str,
    },
    /// A profile of the other part.
    #[error("this is the profile of a {found:?}, and that of a {wanted:?} is asked for")]
    Part {
        /// The part that the file states.
        found: Part,
        /// The part that was asked for.
        wanted: Part,
    },
    /// A unit that is not greater than zero.
    #[error("a unit has to be finite and greater than zero")]
    Unit,
    /// A point beyond a kilometre.
    #[error("the point lies beyond a kilometre")]
    Far,
    /// Fewer points than a curve needs.
    #[error("the file ends after {found} points, and three are needed")]
    TooFew {
        /// How many there are.
        found: usize,
    },
    /// More points than can be searched for loops.
    #[error("more than {MOST_POINTS} points: thin them out")]
    TooMany,
    /// A file that is too long for a profile.
    #[error("the file is too long for a profile")]
    TooLong,
}
