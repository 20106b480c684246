//! Matrix Market (R. F. Boisvert, R. Pozo and K. A. Remington, *The Matrix Market exchange formats*, NISTIR 5935, 1996).

use super::{Written, Wrong, cut, lines, whole};

pub(super) fn read(text: &str) -> Result<Written, Wrong> {
    let mut all = lines(text);
    let (first, head) = all.next().ok_or_else(|| Wrong::all("there is nothing in it"))?;
    let head: Vec<String> = head.split_whitespace().map(str::to_ascii_lowercase).collect();
    let words: Vec<&str> = head.iter().map(String::as_str).collect();
    let (array, symmetric) = match words[..] {
        [
            _,
            "matrix",
            kind @ ("array" | "coordinate"),
            "real" | "integer" | "double",
            form @ ("general" | "symmetric"),
        ] => (kind == "array", form == "symmetric"),
        _ => {
            let message = "expected `%%MatrixMarket matrix coordinate` or `array`, then `real general` or `real symmetric`";
            return Err(Wrong::at(first, message));
        }
    };
    let mut all = all.filter(|(_, line)| !line.trim_start().starts_with('%'));
    let (line, sizes) = all.next().ok_or_else(|| Wrong::at(first, "the sizes are missing"))?;
    let sizes: Vec<usize> = sizes
        .split_whitespace()
        .map(|word| whole(word, line, "a size"))
        .collect::<Result<_, _>>()?;
    let (size, expected) = match (array, &sizes[..]) {
        (true, [rows, columns]) if rows == columns => {
            (*rows, if symmetric { rows * (rows + 1) / 2 } else { rows * rows })
        }
        (false, [rows, columns, count]) if rows == columns => (*rows, *count),
        _ => {
            return Err(Wrong::at(
                line,
                "expected as many rows as columns, and the number of values of a list",
            ));
        }
    };
    let mut written = Written { size, full: !symmetric, ..Written::default() };
    // Columns one after the other, from the diagonal down where they are symmetric.
    let (mut row, mut column) = (0, 0);
    let mut last = line;
    for (number, line) in all {
        last = number;
        let words: Vec<&str> = line.split_whitespace().collect();
        let ([one, other], value) = match (array, &words[..]) {
            (true, [value]) => ([row, column], value),
            (false, [one, other, value]) => {
                let place = |word: &str| -> Result<usize, Wrong> {
                    let one: usize = whole(word, number, "a row or column, counted from 1")?;
                    let inside = (1..=size).contains(&one);
                    inside.then(|| one - 1).ok_or_else(|| {
                        Wrong::at(number, format!("there is no row or column {one} of {size}"))
                    })
                };
                ([place(one)?, place(other)?], value)
            }
            _ => return Err(Wrong::at(number, format!("expected a value, found `{}`", cut(line)))),
        };
        if column >= size {
            return Err(Wrong::at(number, format!("more than {expected} values")));
        }
        let value = written.value(value, number)?;
        written.entries.push((one, other, value));
        row += 1;
        if array && row == size {
            column += 1;
            row = if symmetric { column } else { 0 };
        }
    }
    if written.entries.len() != expected {
        let message = format!("expected {expected} values, found {}", written.entries.len());
        return Err(Wrong::at(last, message));
    }
    Ok(written)
}
