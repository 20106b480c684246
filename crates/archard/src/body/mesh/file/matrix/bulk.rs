//! Direct matrix input at grid points: the entries `DMIG` of Nastran's bulk data, in fields of 8 or 16 columns or between commas
//! (MSC Nastran Quick Reference Guide, DMIG).

use std::collections::HashMap;

use super::{Written, Wrong, lines, whole};

/// Columns of the first and the last field of a line, and of fields in between in the narrow and the wide format.
const NARROW: usize = 8;
const WIDE: usize = 16;

/// An entry: the line where it begins and its fields behind the name of the entry.
struct Entry<'a> {
    line: usize,
    wide: bool,
    fields: Vec<&'a str>,
}

pub(super) fn read(text: &str) -> Result<Written, Wrong> {
    let mut entries = vec![];
    let mut open: Option<Entry<'_>> = None;
    for (line, text) in lines(text).filter(|(_, line)| !line.starts_with('$')) {
        let (name, fields) = fields(text, open.as_ref().is_some_and(|entry| entry.wide));
        let capitals = name.to_ascii_uppercase();
        if capitals.trim_end_matches('*') == "DMIG" {
            entries.extend(open.take());
            open = Some(Entry { line, wide: capitals.ends_with('*'), fields });
        } else if name.is_empty() || name.starts_with(['+', '*']) {
            if let Some(entry) = &mut open {
                entry.fields.extend(fields);
            }
        } else {
            // Other entries stand among them.
            entries.extend(open.take());
        }
    }
    entries.extend(open);
    let name = named(&entries)?;
    let mut written = Written::default();
    let mut known = HashMap::new();
    for Entry { line, fields, .. } in
        entries.iter().filter(|one| one.fields[0].eq_ignore_ascii_case(&name))
    {
        let field = |at: usize| fields.get(at).copied().unwrap_or_default();
        if field(1) == "0" {
            let (form, kind) = (field(2), field(3));
            if !["1", "6"].contains(&form) || !["1", "2"].contains(&kind) {
                let message = format!(
                    "expected a square or symmetric matrix (1 or 6) of real numbers (1 or 2), found form `{form}` and type `{kind}`"
                );
                return Err(Wrong::at(*line, message));
            }
            written.full = form == "1";
            continue;
        }
        let label = |at: usize| -> Result<(i64, usize), Wrong> {
            let along: usize = match field(at + 1) {
                // Scalar points have no direction.
                "" | "0" => 7,
                word => whole(word, *line, "a direction, 1 to 6")?,
            };
            Ok((whole(field(at), *line, "the number of a grid point")?, along - 1))
        };
        let column = written.row(label(1)?, &mut known);
        for at in (4..fields.len()).step_by(4).filter(|at| !field(*at).is_empty()) {
            let row = written.row(label(at)?, &mut known);
            let value = written.value(field(at + 2), *line)?;
            written.entries.push((row, column, value));
        }
    }
    if written.entries.is_empty() {
        return Err(Wrong::all(format!("the matrix {name} has no values")));
    }
    Ok(written)
}

/// The name of the matrix that is meant: the only one, or the only one of stiffness.
fn named(entries: &[Entry<'_>]) -> Result<String, Wrong> {
    let mut names: Vec<String> = vec![];
    for Entry { line, fields, .. } in entries {
        let name = fields.first().copied().unwrap_or_default().to_ascii_uppercase();
        if name.is_empty() {
            return Err(Wrong::at(*line, "the matrix has no name"));
        }
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let stiff: Vec<&String> = names.iter().filter(|name| name.starts_with('K')).collect();
    match (&names[..], &stiff[..]) {
        ([one], _) => Ok(one.clone()),
        (_, [one]) => Ok((*one).clone()),
        _ => Err(Wrong::all(format!(
            "there are the matrices {}: leave one of them in the file, or one whose name begins with K",
            names.join(", ")
        ))),
    }
}

/// The first field of a line and the others, without the one that marks a continuation; where no mark says so, as wide as the entry is.
fn fields(line: &str, wide: bool) -> (&str, Vec<&str>) {
    if line.contains(',') {
        let mut all = line.split(',').map(str::trim);
        let name = all.next().unwrap_or_default();
        return (name, all.take(8).collect());
    }
    let part =
        |from: usize, to: usize| line.get(from..to.min(line.len())).unwrap_or_default().trim();
    let name = part(0, NARROW);
    let (width, count) =
        match name.ends_with('*') || name.starts_with('*') || (wide && name.is_empty()) {
            true => (WIDE, 4),
            false => (NARROW, 8),
        };
    let field = |at: usize| part(NARROW + at * width, NARROW + (at + 1) * width);
    (name, (0..count).map(field).collect())
}

#[cfg(test)]
mod tests {
    use super::fields;

    #[test]
    fn fields_are_cut_by_columns_or_commas() {
        let (name, all) =
            fields("DMIG    KAAX           1       1               1       12.5+5", false);
        assert_eq!((name, &all[..3]), ("DMIG", &["KAAX", "1", "1"][..]));
        assert_eq!(all[4..8], ["1", "1", "2.5+5", ""]);
        let (name, all) = fields("*                      1               1 2.500000000D+05", true);
        assert_eq!((name, all[2]), ("*", "2.500000000D+05"));
        assert_eq!(fields("DMIG,KAAX,0,6,1", false).1, ["KAAX", "0", "6", "1"]);
    }
}
