//! The profiles that a table names.

use archard::units::Measure;
use archard_case::WheelRailCase;
use archard_case::files::{self, Contents};
use archard_case::measured::Table;
use archard_rail::curve::Curve;

use super::super::{Error, Request};
use super::runs;

/// A profile that was measured.
pub(super) struct Measured {
    pub line: u64,
    pub test: String,
    pub file: String,
    pub distance: f64,
    pub side: usize,
    pub curve: Curve,
}

/// The profiles of a table.
pub(super) fn measured(
    case: &WheelRailCase,
    table: &Table,
    request: &Request<'_>,
) -> Result<Vec<Measured>, Error> {
    let texts = |name: &str| table.texts(name);
    let missing = |name: &str, what: &str| {
        let message = format!(
            "{}: has no column `{name}`, {what}; there are {}",
            table.source(),
            table.titles()
        );
        Error::Mismatch(message)
    };
    let tests = texts("test").ok_or_else(|| missing("test", "the name of each wheel"))?;
    let named = texts("file").ok_or_else(|| missing("file", "of profiles after wear"))?;
    let distances = table.all_numbers("distance", &Measure::LENGTH)?;
    let sides = runs::sides(case);
    let of_rows = texts("side");
    let mut all = vec![];
    for (row, line) in table.lines().into_iter().enumerate() {
        let (file, distance) = (named[row], distances[row]);
        let refuse = |why: String| Error::Reading { table: table.source().to_owned(), line, why };
        if distance <= 0.0 {
            return Err(refuse(
                "`distance` has to be greater than zero: nothing has worn before".to_owned(),
            ));
        }
        let side = match (&of_rows, sides.len()) {
            (None, 1) => 0,
            (None, _) => {
                return Err(missing("side", "`left` or `right`, as the case computes both"));
            }
            (Some(own), _) => {
                let at = sides.iter().position(|side| side.name() == own[row]);
                at.ok_or_else(|| {
                    let known: Vec<&str> = sides.iter().map(|side| side.name()).collect();
                    refuse(format!(
                        "`side` = `{}`: the case computes {}",
                        own[row],
                        known.join(" and ")
                    ))
                })?
            }
        };
        let bytes = files::read(&request.files.folder.join(file), Contents::Text);
        let bytes = bytes.map_err(|error| refuse(format!("cannot read `{file}`: {error}")))?;
        let curve = case.worn_wheel(file, &bytes);
        let curve = curve.map_err(|error| refuse(format!("`{file}`: {}", error.message)))?;
        let (test, file) = (tests[row].to_owned(), file.to_owned());
        all.push(Measured { line, test, file, distance, side, curve });
    }
    Ok(all)
}
