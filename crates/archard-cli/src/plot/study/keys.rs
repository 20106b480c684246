//! Keys of a study as axes: numbers, numbers in lists, and whatever else stands at places 1, 2, 3.

/// A key that a study goes over or samples.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Key {
    /// Its column, or that and which number of a list varies, with its unit.
    pub name: String,
    /// What stands at the places 1, 2, 3 of its axis, where its values are no numbers.
    pub levels: Vec<String>,
    /// Its value in each row, as the table has it.
    cells: Vec<String>,
}

impl Key {
    /// A key with its values in all rows, and where each is on its axis.
    pub fn read(name: &str, cells: Vec<String>) -> (Self, Vec<f64>) {
        let numbers = |texts: &[String]| -> Option<Vec<f64>> {
            texts.iter().map(|text| text.parse().ok()).collect()
        };
        if let Some(values) = numbers(&cells) {
            return (Self { name: name.to_owned(), levels: vec![], cells }, values);
        }
        if let Some((which, unit, values)) = one_of_lists(&cells) {
            let unit = if unit.is_empty() { unit } else { format!(", {unit}") };
            let name = format!("{name}, number {}{unit}", which + 1);
            return (Self { name, levels: vec![], cells }, values);
        }
        let mut levels: Vec<String> = vec![];
        let values = cells.iter().map(|cell| {
            let known = levels.iter().position(|level| level == cell);
            let place = known.unwrap_or(levels.len());
            if known.is_none() {
                levels.push(cell.clone());
            }
            (place + 1) as f64
        });
        let values = values.collect();
        (Self { name: name.to_owned(), levels, cells }, values)
    }

    /// The key and its value in a row, by its number from zero on.
    pub fn with_value(&self, row: usize) -> String {
        format!("{} = {}", self.name, self.cells[row])
    }
}

/// Which number of lists varies, its unit, and its value in each; `None` where more than one does, or other things are.
fn one_of_lists(cells: &[String]) -> Option<(usize, String, Vec<f64>)> {
    let lists: Vec<Vec<&str>> = cells.iter().map(|cell| list(cell)).collect::<Option<_>>()?;
    let first = lists.first()?;
    if lists.iter().any(|list| list.len() != first.len()) {
        return None;
    }
    let varies = |place: &usize| lists.iter().any(|list| list[*place] != first[*place]);
    let varying: Vec<usize> = (0..first.len()).filter(varies).collect();
    let &[which] = &varying[..] else { return None };
    let measures = lists.iter().map(|list| {
        let (number, unit) = list[which].split_once(' ').unwrap_or((list[which], ""));
        Some((number.parse().ok()?, unit))
    });
    let measures: Vec<(f64, &str)> = measures.collect::<Option<_>>()?;
    let unit = measures.first()?.1;
    let same = measures.iter().all(|(_, other)| *other == unit);
    same.then(|| (which, unit.to_owned(), measures.into_iter().map(|(value, _)| value).collect()))
}

/// The entries of a list of plain values.
fn list(cell: &str) -> Option<Vec<&str>> {
    let inside = cell.strip_prefix('[')?.strip_suffix(']')?;
    let plain = !inside.contains(['[', '{']);
    plain.then(|| inside.split(',').map(|entry| entry.trim().trim_matches('"')).collect())
}

#[cfg(test)]
mod tests {
    use super::Key;

    fn read(cells: &[&str]) -> (Key, Vec<f64>) {
        Key::read("key", cells.iter().map(|&cell| cell.to_owned()).collect())
    }

    #[test]
    fn lists_in_which_one_number_varies_are_that_number() {
        let lists = [r#"["1e-6 m", "0 m"]"#, r#"["2e-6 m", "0 m"]"#];
        let (key, values) = read(&lists);
        assert_eq!((&*key.name, values), ("key, number 1, m", vec![1e-6, 2e-6]));
        assert!(key.levels.is_empty());
        assert_eq!(key.with_value(1), format!("key, number 1, m = {}", lists[1]));
        let (key, values) = read(&["[8, 8]", "[8, 16]"]);
        assert_eq!((&*key.name, values), ("key, number 2", vec![8.0, 16.0]));
    }

    #[test]
    fn other_values_stand_at_places() {
        let (key, values) = read(&["[8, 8]", "[16, 16]", "[8, 8]"]);
        assert_eq!(values, [1.0, 2.0, 1.0]);
        assert_eq!(key.levels, ["[8, 8]", "[16, 16]"]);
        assert_eq!(read(&["one.csv", "two.csv"]).1, [1.0, 2.0]);
        assert_eq!(read(&["[1]", "2"]).1, [1.0, 2.0]);
    }
}
