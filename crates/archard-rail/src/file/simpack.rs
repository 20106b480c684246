//! SIMPACK `.prr` and `.prw`.
//!
//! Blocks `header`, `spline` and `point` hold keys with values and rows of y and z; `!` begins a comment. Points are
//! shifted, then mirrored, then divided by the unit, then put into the opposite order if `inversion` asks for it.

use std::fmt::Write;

use super::{Cause, Document, Points, ReadError, lines};
use crate::oddity::Oddity;
use crate::profile::{Part, Profile};

/// The values of the keys that count.
struct Keys {
    shift: [f64; 2],
    mirror: [bool; 2],
    inversion: bool,
    unit: f64,
    bounds: [Bound; 4],
}

/// An end of the range of y or z that counts.
#[derive(Clone, Copy)]
struct Bound {
    value: f64,
    line: usize,
}

impl Keys {
    fn new() -> Self {
        // A least bound above the largest one does not count, as SIMPACK writes it.
        let bounds = [1.0, 0.0, 1.0, 0.0].map(|value| Bound { value, line: 1 });
        Self { shift: [0.0; 2], mirror: [false; 2], inversion: false, unit: 1.0, bounds }
    }

    /// Takes in a key of the spline block.
    fn set(
        &mut self,
        line: usize,
        key: &str,
        word: &str,
        points: &mut Points,
    ) -> Result<(), ReadError> {
        let number = || lines::number(line, word);
        match key {
            "shift.y" => self.shift[0] = number()?,
            "shift.z" => self.shift[1] = number()?,
            "mirror.y" => self.mirror[0] = number()? != 0.0,
            "mirror.z" => self.mirror[1] = number()? != 0.0,
            "inversion" => self.inversion = number()? != 0.0,
            "units.len.f" => {
                self.unit = number()?;
                if self.unit <= 0.0 {
                    return Err(ReadError { line, cause: Cause::Unit });
                }
            }
            "bound.y.min" => self.bounds[0] = Bound { value: number()?, line },
            "bound.y.max" => self.bounds[1] = Bound { value: number()?, line },
            "bound.z.min" => self.bounds[2] = Bound { value: number()?, line },
            "bound.z.max" => self.bounds[3] = Bound { value: number()?, line },
            "rotate" if number()? != 0.0 => {
                let advice = "set it to 0 and turn the points";
                let cause = Cause::Unsupported { key: key.to_owned(), advice };
                return Err(ReadError { line, cause });
            }
            "approx.smooth" | "point.dist.min" if number()? != 0.0 => {
                points.odd(line, Oddity::Ignored { key: key.to_owned() });
            }
            _ => {}
        }
        Ok(())
    }

    /// The points in metres, in order.
    fn apply(&self, points: &mut Points) -> Result<(), ReadError> {
        for (axis, name) in ["bound.y", "bound.z"].into_iter().enumerate() {
            let [least, most] = [self.bounds[2 * axis], self.bounds[2 * axis + 1]];
            let outside = |value: f64| value < least.value || value > most.value;
            let cut = points.values.iter().any(|point| outside(point[axis] + self.shift[axis]));
            if least.value <= most.value && cut {
                let advice =
                    "leave out the points beyond it and set the least bound above the largest";
                let cause = Cause::Unsupported { key: name.to_owned(), advice };
                return Err(ReadError { line: least.line.max(most.line), cause });
            }
        }
        let sign = self.mirror.map(|mirror| if mirror { -1.0 } else { 1.0 });
        points.map(|point| {
            [0, 1].map(|axis| (point[axis] + self.shift[axis]) * sign[axis] / self.unit)
        });
        if self.inversion {
            points.reverse();
        }
        Ok(())
    }
}

pub(super) fn read(text: &str, wanted: Part) -> Result<Document, ReadError> {
    let (mut keys, mut points) = (Keys::new(), Points::default());
    let (mut block, mut complete) = (String::new(), false);
    let mut unit_line = None;
    for (line, row) in lines::numbered(text) {
        let row = without_comment(row);
        if row.is_empty() {
            continue;
        }
        if let Some(name) = row.strip_suffix(".begin") {
            block = name.to_owned();
        } else if let Some(name) = row.strip_suffix(".end") {
            complete |= name == "point";
            block = if name == "point" { "spline".to_owned() } else { String::new() };
        } else if block == "point" {
            let words: Vec<&str> = row.split_whitespace().collect();
            points.push(line, lines::pair(line, words.iter().copied())?)?;
            if let Some(weight) = words.get(2)
                && lines::number(line, weight)? != 1.0
            {
                points.odd(line, Oddity::Ignored { key: "weight".to_owned() });
            }
        } else if let Some((key, word)) = row.split_once('=') {
            let (key, word) = (key.trim(), word.trim());
            match block.as_str() {
                "header" if key == "type" => stated(line, word, wanted)?,
                "spline" => keys.set(line, key, word, &mut points)?,
                _ => {}
            }
            unit_line = unit_line.or((key == "units.len.f").then_some(line));
        }
    }
    let last = lines::count(text);
    let missing = |what| Err(ReadError { line: last, cause: Cause::Missing { what } });
    if !complete {
        return missing("point.end");
    }
    if unit_line.is_none() {
        return missing("units.len.f");
    }
    keys.apply(&mut points)?;
    points.finish(wanted, last)
}

/// Holds the part that the header states against the one that was asked for.
fn stated(line: usize, word: &str, wanted: Part) -> Result<(), ReadError> {
    let found = match lines::number(line, word)? {
        0.0 => Part::Rail,
        1.0 => Part::Wheel,
        _ => {
            let cause =
                Cause::Unsupported { key: "type".to_owned(), advice: "0 is a rail and 1 a wheel" };
            return Err(ReadError { line, cause });
        }
    };
    if found == wanted {
        Ok(())
    } else {
        Err(ReadError { line, cause: Cause::Part { found, wanted } })
    }
}

/// The line up to the first `!` that is not in quotes.
fn without_comment(row: &str) -> &str {
    let mut quoted = false;
    let end = row.find(|letter| {
        quoted ^= letter == '\'';
        letter == '!' && !quoted
    });
    row[..end.unwrap_or(row.len())].trim()
}

pub(super) fn write(profile: &Profile, part: Part) -> String {
    let kind = match part {
        Part::Rail => 0,
        Part::Wheel => 1,
    };
    let mut text = format!(
        "header.begin\n  version = 1\n  type = {kind} ! 0=rail profile, 1=wheel profile\nheader.end\nspline.begin\n"
    );
    for key in ["approx.smooth", "point.dist.min", "shift.y", "shift.z", "rotate"] {
        let _ = writeln!(text, "  {key} = 0.0");
    }
    for key in ["bound.y", "bound.z"] {
        let _ = writeln!(text, "  {key}.min = 1.0\n  {key}.max = 0.0");
    }
    for key in ["mirror.y", "mirror.z", "inversion"] {
        let _ = writeln!(text, "  {key} = 0");
    }
    text.push_str("  units.len.f = 1000.0 ! mm\n  units.ang.f = 1.0\n  point.begin\n");
    for [y, z] in &profile.points {
        let _ = writeln!(text, "{:e} {:e}", y * 1e3, z * 1e3);
    }
    text.push_str("  point.end\nspline.end\n");
    text
}
