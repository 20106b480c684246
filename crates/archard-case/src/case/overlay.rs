//! The `--set` options: KEY=VALUE laid over the case as written.
//!
//! The value is read as TOML, or as plain text where it is not TOML, so that the quotes may be left
//! out or lost to a shell; inside lists and tables likewise. It replaces what stands at the key,
//! tables included. Nothing behind the `=` removes the key.

use toml::de::{DeTable, DeValue};

use super::key::Key;
use super::print::quoted;
use super::problem::{Location, Problem, Source};
use super::tree::{Entry, Item, Node, Origin, Table};

/// Lays the option of that index over a tree.
pub(super) fn apply(table: &mut Table, index: usize, text: &str) -> Result<(), Problem> {
    let source = Source::Option(index);
    let whole = Location { source, span: 0..text.len() };
    let malformed = |message: &str| Problem {
        location: Some(whole.clone()),
        ..Problem::error(Key::default(), message)
            .help("write --set KEY=VALUE, for example --set motion.sliding.step=\"10 mm\"")
    };
    let (left, right) = text.split_once('=').ok_or_else(|| malformed("an option without `=`"))?;
    let path = read_path(left, source)
        .ok_or_else(|| malformed("the key of this option cannot be read"))?;
    let node = (!right.trim().is_empty()).then(|| read_value(right, left.len() + 1, source));
    put(table, &Key::default(), &path, node)
}

/// The names of a dotted key and where they stand.
pub(super) fn read_path(text: &str, source: Source) -> Option<Vec<(String, Location)>> {
    let assignment = format!("{}=0", dotted(text));
    let parsed = DeTable::parse(&assignment).ok()?;
    let origin = Origin { source, start: 0, fixed: None };
    let mut table = Table::from_toml(parsed.get_ref(), &origin);
    let mut path = vec![];
    loop {
        let entry = table.0.pop().filter(|_| table.0.is_empty())?;
        path.push((entry.name, entry.at));
        match entry.node.item {
            Item::Table(inner) => table = inner,
            _ => return Some(path),
        }
    }
}

/// A key whose elements of lists stand in brackets as one with dots, of the same length: `layers[0].k` as `layers.0 .k`.
fn dotted(text: &str) -> String {
    match text.contains(['"', '\'']) {
        true => text.to_owned(),
        false => text.replace('[', ".").replace(']', " "),
    }
}

/// A value as TOML has it, whether or not it has its quotes.
pub(super) fn as_toml(text: &str) -> String {
    let trimmed = text.trim();
    let is_toml = |text: &str| DeValue::parse(text).is_ok();
    if is_toml(trimmed) {
        return trimmed.to_owned();
    }
    Some(trimmed)
        .filter(|text| text.starts_with(['[', '{']))
        .map(quote_words)
        .filter(|quoted| is_toml(quoted))
        .unwrap_or_else(|| quoted(trimmed))
}

/// Reads a value as TOML, as TOML that lost its quotes, or as text.
fn read_value(text: &str, start: usize, source: Source) -> Node {
    let leading = text.len() - text.trim_start().len();
    let trimmed = text.trim();
    let start = start + leading;
    let span = start..start + trimmed.len();
    let literal = Origin { source, start, fixed: None };
    if let Ok(value) = DeValue::parse(trimmed) {
        return Node::from_toml(&value, &literal);
    }
    if trimmed.starts_with(['[', '{']) {
        let fixed = Origin { fixed: Some(span.clone()), ..literal };
        if let Ok(value) = DeValue::parse(&quote_words(trimmed)) {
            return Node::from_toml(&value, &fixed);
        }
    }
    Node { item: Item::Text(trimmed.to_owned()), at: Location { source, span } }
}

/// Puts quotes around whatever stands between the marks of lists and tables and is not TOML.
fn quote_words(text: &str) -> String {
    let mut quoted = String::new();
    let mut word_start = 0;
    for (place, mark) in text.match_indices(['[', ']', '{', '}', ',', '=']) {
        let word = &text[word_start..place];
        if mark == "=" || word.trim().is_empty() || DeValue::parse(word.trim()).is_ok() {
            quoted.push_str(word);
        } else {
            let before = word.len() - word.trim_start().len();
            quoted.push_str(&format!("{}{:?}", &word[..before], word.trim()));
        }
        quoted.push_str(mark);
        word_start = place + mark.len();
    }
    quoted + &text[word_start..]
}

/// Puts a value at a path, or removes what is there.
fn put(
    table: &mut Table,
    key: &Key,
    path: &[(String, Location)],
    node: Option<Node>,
) -> Result<(), Problem> {
    let Some(((name, at), rest)) = path.split_first() else { return Ok(()) };
    let key = key.child(name);
    if rest.is_empty() {
        return match node {
            Some(node) => {
                replace(table, Entry { name: name.clone(), at: at.clone(), node });
                Ok(())
            }
            None => remove(table, &key, name, at),
        };
    }
    if table.get(name).is_none() && node.is_some() {
        let node = Node { item: Item::Table(Table::default()), at: at.clone() };
        table.0.push(Entry { name: name.clone(), at: at.clone(), node });
    }
    match table.get_mut(name).map(|entry| &mut entry.node.item) {
        Some(Item::Table(inner)) => put(inner, &key, rest, node),
        Some(Item::Array(values)) => put_into(values, &key, rest, node),
        Some(_) => Err(Problem {
            location: Some(at.clone()),
            ..Problem::error(key, "is not a table in the case: nothing can be set inside it")
        }),
        None => Err(nothing_to_remove(&key, at)),
    }
}

/// Puts a value into an element of a list, or in its place; removes no element, which would number the others anew.
fn put_into(
    values: &mut [Node],
    key: &Key,
    path: &[(String, Location)],
    node: Option<Node>,
) -> Result<(), Problem> {
    let Some(((name, at), rest)) = path.split_first() else { return Ok(()) };
    let count = values.len();
    let wrong = |message: String| Problem {
        location: Some(at.clone()),
        ..Problem::error(key.clone(), message)
            .help(format!("write an element by its number from 0, like {key}.0 or {key}[0]"))
    };
    let index = name.parse::<usize>().map_err(|_| {
        wrong(format!("is a list in the case: `{name}` is not the number of an element"))
    })?;
    let Some(value) = values.get_mut(index) else {
        return Err(wrong(format!("has no element {index}: it has {count} in the case")));
    };
    let key = key.index(index);
    match (&mut value.item, node) {
        (_, Some(node)) if rest.is_empty() => {
            *value = node;
            Ok(())
        }
        (_, None) if rest.is_empty() => {
            Err(wrong("loses no element by an option: set the whole list".to_owned()))
        }
        (Item::Table(inner), node) => put(inner, &key, rest, node),
        (Item::Array(inner), node) => put_into(inner, &key, rest, node),
        _ => Err(Problem {
            location: Some(at.clone()),
            ..Problem::error(key, "is not a table in the case: nothing can be set inside it")
        }),
    }
}

/// Replaces an entry in its place, or adds it at the end.
fn replace(table: &mut Table, entry: Entry) {
    match table.get_mut(&entry.name) {
        Some(old) => *old = entry,
        None => table.0.push(entry),
    }
}

fn remove(table: &mut Table, key: &Key, name: &str, at: &Location) -> Result<(), Problem> {
    let before = table.0.len();
    table.0.retain(|entry| entry.name != name);
    if table.0.len() == before { Err(nothing_to_remove(key, at)) } else { Ok(()) }
}

fn nothing_to_remove(key: &Key, at: &Location) -> Problem {
    Problem {
        location: Some(at.clone()),
        ..Problem::error(key.clone(), "is not in the case, there is nothing to remove")
            .help("an option with nothing behind the `=` removes its key")
    }
}

#[cfg(test)]
mod tests {
    use super::super::problem::Source;
    use super::read_path;

    #[test]
    fn elements_of_lists_have_two_spellings() {
        let names = |text: &str| -> Vec<String> {
            read_path(text, Source::Option(0)).unwrap().into_iter().map(|own| own.0).collect()
        };
        let dotted = names("body.disc.layers.0.thickness");
        assert_eq!(dotted, ["body", "disc", "layers", "0", "thickness"]);
        assert_eq!(names("body.disc.layers[0].thickness"), dotted);
        assert_eq!(names("a[1]"), ["a", "1"]);
    }
}
