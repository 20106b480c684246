//! Values one by one: a node and a direction for the row and the column each, as Abaqus writes by `*MATRIX GENERATE`
//! (`FORMAT=MATRIX INPUT`) and CalculiX by `OUTPUT FILE=MATRIX`; or row and column alone (`FORMAT=COORDINATE`).

use std::collections::HashMap;

use super::{Written, Wrong, cut, lines, whole};

pub(super) fn read(text: &str) -> Result<Written, Wrong> {
    let mut written = Written::default();
    let mut known = HashMap::new();
    let mut count = 0;
    for (number, line) in lines(text).filter(|(_, line)| !line.trim_start().starts_with('*')) {
        let words: Vec<&str> = line
            .split(|c: char| c == ',' || c.is_whitespace())
            .filter(|word| !word.is_empty())
            .collect();
        let expected = "expected the node and direction of a row, those of a column, and a value; or row, column and value: a file of Abaqus (`*SUBSTRUCTURE MATRIX OUTPUT`, `*MATRIX GENERATE`), CalculiX, Nastran (DMIG) or Matrix Market";
        if count != 0 && words.len() != count || ![3, 5].contains(&words.len()) {
            return Err(Wrong::at(number, format!("{expected}; found `{}`", cut(line))));
        }
        count = words.len();
        let place = |word: &str| -> Result<usize, Wrong> {
            let one: usize = whole(word, number, "a row or column, counted from 1")?;
            one.checked_sub(1).ok_or_else(|| Wrong::at(number, "rows are counted from 1"))
        };
        let value = written.value(words[count - 1], number)?;
        let [row, column] = if count == 5 {
            let label = |at: usize| -> Result<_, Wrong> {
                let along: usize = whole(words[at + 1], number, "a direction")?;
                let along = along.checked_sub(1);
                let along =
                    along.ok_or_else(|| Wrong::at(number, "directions are counted from 1"))?;
                Ok((whole(words[at], number, "the number of a node")?, along))
            };
            [label(0)?, label(2)?].map(|label| written.row(label, &mut known))
        } else {
            let [row, column] = [place(words[0])?, place(words[1])?];
            written.size = written.size.max(row + 1).max(column + 1);
            [row, column]
        };
        written.entries.push((row, column, value));
    }
    if written.entries.is_empty() {
        return Err(Wrong::all("there is no value in it"));
    }
    Ok(written)
}
