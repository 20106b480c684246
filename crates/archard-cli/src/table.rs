//! Measured tables, with the names that options give their columns.

use std::path::Path;

use archard_case::files::{self, Contents};
use archard_case::measured::Table;

/// Names and titles, of options like `depth="Tiefe [um]"`.
///
/// # Errors
/// If an option is not one of these.
pub fn names(options: &[String]) -> Result<Vec<(&str, &str)>, String> {
    let like = |option: &str| {
        format!("--column {option}: write a name and a title, like depth=\"Tiefe [um]\"")
    };
    options
        .iter()
        .map(|option| {
            let (name, title) = option.split_once('=').ok_or_else(|| like(option))?;
            Ok((name, title.trim_matches('"')))
        })
        .collect()
}

/// Reads the table in a file, with names for some of its columns.
///
/// # Errors
/// If there is no such file, it is no table, or has no such columns.
pub fn read(path: &Path, names: &[(&str, &str)]) -> Result<Table, String> {
    let bytes = files::read(path, Contents::Text)
        .map_err(|error| format!("cannot read `{}`: {error}", path.display()))?;
    let table = Table::read(&path.display().to_string(), &bytes);
    table.and_then(|table| table.naming(names)).map_err(|error| error.to_string())
}
