//! Why a measured table cannot be used.

use archard::units;

/// Why a measured table cannot be read, or has not what is asked for.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// It is no table at all.
    #[error("{table}: cannot read the table: {cause}")]
    Unreadable {
        /// What the table is called.
        table: String,
        /// Why.
        cause: csv::Error,
    },
    /// Nothing stands in it.
    #[error("{table}: the first line has to be a header, like `test,distance_m,depth_um`")]
    NoHeader {
        /// What the table is called.
        table: String,
    },
    /// A header alone.
    #[error("{table}: there is nothing below the header")]
    Empty {
        /// What the table is called.
        table: String,
    },
    /// A row of another length.
    #[error(
        "{table}, line {line}: expected {expected} cells, found {found}; with decimal commas, separate cells by `;`"
    )]
    Ragged {
        /// What the table is called.
        table: String,
        /// The line.
        line: u64,
        /// Cells of the header.
        expected: usize,
        /// Cells of the row.
        found: usize,
    },
    /// Two columns of one name.
    #[error("{table}: the columns `{one}` and `{other}` have one name: remove one, or rename it")]
    Twice {
        /// What the table is called.
        table: String,
        /// The title of the first.
        one: String,
        /// The title of the second.
        other: String,
    },
    /// Decimal commas and points.
    #[error(
        "{table}: `{one}` in line {line} has a comma and `{other}` in line {other_line} a point: write all numbers with the \
         same decimal sign, and without separators of thousands"
    )]
    TwoDecimalSigns {
        /// What the table is called.
        table: String,
        /// The line of the number with a comma.
        line: u64,
        /// That number.
        one: String,
        /// The line of the number with a point.
        other_line: u64,
        /// That number.
        other: String,
    },
    /// A comma that may separate thousands.
    #[error(
        "{table}, line {line}: `{text}` may be a decimal number or one with a separator of thousands: write a decimal point"
    )]
    Thousands {
        /// What the table is called.
        table: String,
        /// The line.
        line: u64,
        /// The number.
        text: String,
    },
    /// No column has the title.
    #[error("{table}: no column is titled `{title}`; there are {titles}")]
    NoTitle {
        /// What the table is called.
        table: String,
        /// The title.
        title: String,
        /// Those there are.
        titles: String,
    },
    /// A column is given a name with another unit than that of its title.
    #[error(
        "{table}: the column `{title}` has another unit than `{name}`: leave the unit out of that name"
    )]
    OtherUnit {
        /// What the table is called.
        table: String,
        /// The title.
        title: String,
        /// The name.
        name: String,
    },
    /// A column that is needed is missing.
    #[error(
        "{table}: a column `{wanted}` is needed; there are {titles} (to use one of them: --column {name}=\"its header\")"
    )]
    NoColumn {
        /// What the table is called.
        table: String,
        /// A header that would do.
        wanted: String,
        /// The name of the column.
        name: String,
        /// The titles there are.
        titles: String,
    },
    /// A column has no unit and needs one.
    #[error("{table}: the column `{column}` has no unit: title it like `{like}`")]
    NoUnit {
        /// What the table is called.
        table: String,
        /// Its title.
        column: String,
        /// A header that would do.
        like: String,
    },
    /// The unit of a column is not one of what it holds.
    #[error("{table}: the column `{column}`: {cause}; title it like `{like}`")]
    WrongUnit {
        /// What the table is called.
        table: String,
        /// Its title.
        column: String,
        /// What is wrong with the unit.
        cause: Box<units::Error>,
        /// A header that would do.
        like: String,
    },
    /// A cell that is not a number.
    #[error(
        "{table}, line {line}: `{text}` in the column `{column}` is not a finite number; leave the cell empty where nothing \
         was measured"
    )]
    NotANumber {
        /// What the table is called.
        table: String,
        /// The line.
        line: u64,
        /// The title of the column.
        column: String,
        /// What stands there.
        text: String,
    },
    /// A number whose powers are none.
    #[error(
        "{table}, line {line}: {value:e} in the column `{column}` (SI) is too large to compute with"
    )]
    TooLarge {
        /// What the table is called.
        table: String,
        /// The line.
        line: u64,
        /// The name of the column.
        column: String,
        /// The value (SI).
        value: f64,
    },
    /// A reading that cannot be what it says.
    #[error("{table}, line {line}: {why}")]
    Reading {
        /// What the table is called.
        table: String,
        /// The line.
        line: u64,
        /// Why, and what to do.
        why: String,
    },
    /// An empty cell where a value is needed.
    #[error("{table}, line {line}: the column `{column}` needs a value in every row")]
    NoValue {
        /// What the table is called.
        table: String,
        /// The line.
        line: u64,
        /// The name of the column.
        column: String,
    },
}
