//! Linear user elements, as Abaqus and CalculiX write substructures (Abaqus Keywords Guide, *USER ELEMENT and *MATRIX).
//!
//! The head gives the number of nodes and, from a place among them on, their directions; comments name the nodes. CalculiX makes each
//! direction a node of its own, named as often as it has directions. Rows follow up to the diagonal, four values a line.

use super::{Label, Written, Wrong, cut, lines, whole};

/// What is read at present.
#[derive(PartialEq)]
enum Part {
    Else,
    /// The directions of nodes.
    Head,
    /// Values of the stiffness.
    Values,
}

pub(super) fn read(text: &str) -> Result<Written, Wrong> {
    let mut written = Written { stiffness: true, ..Written::default() };
    let (mut part, mut named, mut square) = (Part::Else, false, false);
    let mut count = 0;
    let mut nodes: Vec<i64> = vec![];
    let mut directions: Vec<(usize, Vec<usize>)> = vec![];
    let mut values: Vec<f64> = vec![];
    let (mut head, mut last) = (0, 0);
    for (number, line) in lines(text) {
        let words = || line.split(',').map(str::trim).filter(|word| !word.is_empty());
        let capitals = line.trim().to_ascii_uppercase();
        if let Some(comment) = capitals.strip_prefix("**") {
            let numbers: Vec<i64> =
                comment.split(',').filter_map(|word| word.trim().parse().ok()).collect();
            match (named, numbers.is_empty()) {
                (_, true) => named = comment.contains("ELEMENT NODES"),
                (true, false) => nodes.extend(numbers),
                (false, false) => {}
            }
        } else if capitals.starts_with('*') {
            named = false;
            let keyword = capitals.split(',').next().unwrap_or_default().trim_end();
            let has = |word: &str| {
                capitals.split(',').any(|part| part.trim().replace(' ', "").starts_with(word))
            };
            part = match keyword {
                "*USER ELEMENT" if count > 0 => {
                    let message = "a second element: give a file with one substructure";
                    return Err(Wrong::at(number, message));
                }
                "*USER ELEMENT" => {
                    let word = capitals.split(',').find_map(|part| {
                        part.trim().strip_prefix("NODES")?.trim_start().strip_prefix('=')
                    });
                    count = whole(word.unwrap_or_default(), number, "`NODES=` and their number")?;
                    square = has("UNSYMM");
                    head = number;
                    Part::Head
                }
                "*MATRIX" if has("TYPE=STIFFNESS") => Part::Values,
                _ => Part::Else,
            };
        } else if part == Part::Head {
            let all: Vec<usize> =
                words().map(|word| whole(word, number, "a direction")).collect::<Result<_, _>>()?;
            let (from, along) = match directions.is_empty() {
                true => (1, &all[..]),
                false => (all[0], &all[1..]),
            };
            if from == 0 || from > count || along.contains(&0) {
                let message = format!(
                    "expected a node of 1 to {count} and its directions, found `{}`",
                    cut(line)
                );
                return Err(Wrong::at(number, message));
            }
            directions.push((from, along.iter().map(|own| own - 1).collect()));
        } else if part == Part::Values {
            last = number;
            for word in words() {
                values.push(written.value(word, number)?);
            }
        }
    }
    if nodes.len() != count {
        let message = format!(
            "the element has {count} nodes and {} are named under `** ELEMENT NODES`: write the file once more",
            nodes.len()
        );
        return Err(Wrong::at(head, message));
    }
    let labels = labels(&nodes, &directions);
    let size = labels.len();
    let expected = if square { size * size } else { size * (size + 1) / 2 };
    if size == 0 || values.len() != expected {
        let message = format!(
            "{size} directions of {count} nodes take {expected} values of stiffness, found {}: the file is cut off or of another element",
            values.len()
        );
        return Err(Wrong::at(last, message));
    }
    written.size = size;
    written.full = square;
    let mut values = values.into_iter();
    for one in 0..size {
        let end = if square { size } else { one + 1 };
        written.entries.extend((0..end).zip(values.by_ref()).map(|(other, value)| {
            // Unsymmetric ones are written column by column.
            if square { (other, one, value) } else { (one, other, value) }
        }));
    }
    written.labels = Some(labels);
    Ok(written)
}

/// The rows: the directions of a node are those given last, from its place or one before it on.
fn labels(nodes: &[i64], directions: &[(usize, Vec<usize>)]) -> Vec<Label> {
    let of = |place: usize| directions.iter().rfind(|(from, _)| *from <= place + 1);
    let rows = |(place, node): (usize, &i64)| {
        let own = of(place).map_or(&[][..], |(_, along)| along);
        own.iter().map(|along| (*node, *along)).collect::<Vec<Label>>()
    };
    nodes.iter().enumerate().flat_map(rows).collect()
}
