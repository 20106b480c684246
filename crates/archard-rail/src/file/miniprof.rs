//! MiniProf `.ban` and `.whl`.
//!
//! Two ways of writing them are read: a head of lines `Key=Value`, and the older one, a line with `#` and lines of any
//! text. After an empty line come rows of X and Y in millimetres, Y upwards. `ColumnDef` says where X and Y stand; of the
//! other keys `XYPoints` is checked, and offsets and angles that are not zero are told as not used. Quotes round lines of
//! the head and before rows are taken off. The order of the points is turned so that the material lies on the right hand.
//!
//! The files of segments, `.mpt`, are not read. The tests are of text made up after descriptions of the format, not of files
//! that an instrument wrote.

use std::fmt::Write;

use super::{Cause, Document, Flavour, Points, ReadError, lines};
use crate::oddity::Oddity;
use crate::profile::{Part, Profile};

/// What the head says that counts.
struct Head {
    /// Columns of X and of Y.
    columns: [usize; 2],
    /// The number of points it states, and the line.
    stated: Option<Stated>,
}

struct Stated {
    line: usize,
    count: f64,
}

pub(super) fn read(text: &str, part: Part, mirrored: bool) -> Result<Document, ReadError> {
    let mut points = Points::default();
    let mut head = Head { columns: [0, 1], stated: None };
    let mut in_head = true;
    for (line, row) in lines::numbered(text) {
        let row = row.trim_matches('"').trim();
        if in_head && (!row.is_empty() || line == 1) {
            head.take(line, row, &mut points)?;
            continue;
        }
        in_head = false;
        if row.is_empty() {
            continue;
        }
        let words: Vec<&str> = row.split_whitespace().collect();
        let picked = head.columns.map(|column| words.get(column).copied());
        let [Some(x), Some(y)] = picked else {
            let needed = 1 + head.columns[0].max(head.columns[1]);
            return Err(ReadError { line, cause: Cause::Columns { found: words.len(), needed } });
        };
        points.push(line, lines::pair(line, [x, y].into_iter())?)?;
    }
    let last = lines::count(text);
    if in_head {
        return Err(ReadError {
            line: last,
            cause: Cause::Missing { what: "an empty line after the head" },
        });
    }
    head.check(&mut points);
    let sign = if mirrored { -1.0 } else { 1.0 };
    points.map(|[x, y]| [sign * x * 1e-3, -y * 1e-3]);
    if let [Some(first), Some(last)] = [points.values.first(), points.values.last()]
        && (last[0] - first[0]) * part.direction() < 0.0
    {
        points.reverse();
    }
    points.finish(part, last)
}

impl Head {
    fn take(&mut self, line: usize, row: &str, points: &mut Points) -> Result<(), ReadError> {
        let Some((key, value)) = row.split_once('=') else { return Ok(()) };
        let (key, value) = (key.trim(), value.trim());
        match key {
            "ColumnDef" => self.columns = columns(line, value)?,
            "XYPoints" => self.stated = Some(Stated { line, count: lines::number(line, value)? }),
            "XOffset" | "YOffset" | "RailAngle"
                if value.parse() != Ok(0.0) && !value.is_empty() =>
            {
                points.odd(line, Oddity::Ignored { key: key.to_owned() });
            }
            _ => {}
        }
        Ok(())
    }

    fn check(&self, points: &mut Points) {
        let found = points.values.len();
        if let Some(Stated { line, count }) = self.stated
            && count != found as f64
        {
            points.odd(line, Oddity::Count { stated: count as usize, found });
        }
    }
}

/// The columns of X and of Y in a definition such as `X,Y,A`.
fn columns(line: usize, value: &str) -> Result<[usize; 2], ReadError> {
    let names: Vec<&str> = value.split(',').map(str::trim).collect();
    let find = |wanted: &'static str| {
        let missing = ReadError { line, cause: Cause::Missing { what: wanted } };
        names.iter().position(|name| name.eq_ignore_ascii_case(wanted)).ok_or(missing)
    };
    Ok([find("X")?, find("Y")?])
}

pub(super) fn write(profile: &Profile, part: Part, mirrored: bool, flavour: Flavour) -> String {
    let count = profile.points.len();
    let mut text = match (flavour, part) {
        (Flavour::Keys, _) => format!("XYPoints={count}\nColumnDef=X,Y\n\n"),
        (Flavour::Free, Part::Wheel) => "#MINIWHEELPROF\n\n".to_owned(),
        (Flavour::Free, Part::Rail) => "#MINIRAILPROF\n\n".to_owned(),
    };
    let sign = if mirrored { -1.0 } else { 1.0 };
    for [y, z] in &profile.points {
        let _ = writeln!(text, "{}\t{}", sign * y * 1e3, -z * 1e3);
    }
    text
}
