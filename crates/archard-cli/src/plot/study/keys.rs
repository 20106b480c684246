//! Keys of a study as axes: numbers, numbers in lists, and whatever else stands at places 1, 2, 3.

use crate::plot::scale::{Unit, phrase};

/// A key that a study goes over or samples.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Key {
    /// Its column, or that and which number of a list varies, with its unit.
    pub name: String,
    /// What stands at the places 1, 2, 3 of its axis, where its values are no numbers.
    pub levels: Vec<String>,
    /// What varies, in words, and its last part ending in its unit.
    words: String,
    column: String,
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
            let column = column_of(name).to_owned();
            let (words, _) = Unit::of_key(&column, 1.0);
            let words = in_words(name, &words);
            return (Self { name: name.to_owned(), words, column, levels: vec![], cells }, values);
        }
        if let Some((which, unit, alone, values)) = one_of_lists(&cells) {
            let column = match &*unit {
                "" => column_of(name).to_owned(),
                unit => format!("{}_{}", column_of(name), unit.replace(['^', ' '], "")),
            };
            let (words, _) = Unit::of_key(&column, 1.0);
            let words = in_words(name, &words);
            let which = which + 1;
            let words = if alone { words } else { format!("{words}, number {which}") };
            let unit = if unit.is_empty() { unit } else { format!(", {unit}") };
            let name = format!("{name}, number {which}{unit}");
            return (Self { name, words, column, levels: vec![], cells }, values);
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
        let column = column_of(name).to_owned();
        let words = in_words(name, &phrase(&column));
        (Self { name: name.to_owned(), words, column, levels, cells }, values)
    }

    /// What stands next to its axis with values up to that (SI): words and the unit they are shown in.
    pub fn axis(&self, largest: f64) -> (String, Unit) {
        (self.words.clone(), Unit::of_key(&self.column, largest).1)
    }

    /// The key and its value in a row, by its number from zero on.
    pub fn with_value(&self, row: usize) -> String {
        format!("{} = {}", self.name, self.cells[row])
    }
}

/// The last part of a key, with its unit.
fn column_of(name: &str) -> &str {
    name.rsplit_once('.').map_or(name, |(_, last)| last)
}

/// A key in words: `body.pin.wear.archard.coefficient_per_Pa` is "Wear coefficient of pin", `motion.sliding.load_N` is "Load".
fn in_words(name: &str, last: &str) -> String {
    let last = match last {
        "Young" => "Young's modulus",
        "Poisson" => "Poisson's ratio",
        last => last,
    };
    let parts: Vec<&str> = name.split('.').collect();
    let after = |first: &str| format!("{} {}", phrase(first), last.to_lowercase());
    match &*parts {
        ["body", body, part @ ("wear" | "thermal"), .., _] => format!("{} of {body}", after(part)),
        ["body", body, .., _] => format!("{last} of {body}"),
        [first @ ("frame" | "friction" | "solver"), .., _] => after(first),
        _ => last.to_owned(),
    }
}

/// A varying number of lists: which, its unit, whether all others are zero, and its value in each.
type Varying = (usize, String, bool, Vec<f64>);

/// Which number of lists varies; `None` where more than one does, or other things are.
fn one_of_lists(cells: &[String]) -> Option<Varying> {
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
    let number = |entry: &&str| entry.split(' ').next().and_then(|one| one.parse::<f64>().ok());
    let mut others = first.iter().enumerate().filter(|(place, _)| *place != which);
    let alone = others.all(|(_, entry)| number(entry) == Some(0.0));
    same.then(|| {
        (which, unit.to_owned(), alone, measures.into_iter().map(|(value, _)| value).collect())
    })
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
    fn axes_have_words_and_units() {
        let axis = |name: &str, cells: &[&str]| {
            let (key, values) =
                Key::read(name, cells.iter().map(|&cell| cell.to_owned()).collect());
            let (words, unit) = key.axis(values.iter().copied().fold(0.0, f64::max));
            unit.label(&words)
        };
        let shifts = [r#"["1e-6 m", "0 m"]"#, r#"["2e-6 m", "0 m"]"#];
        for (name, cells, words) in [
            ("motion.fretting.amplitude", &shifts[..], "Amplitude (µm)"),
            ("motion.fretting.load_N", &["20", "100"], "Load (N)"),
            ("motion.sliding.distance_m", &["20", "100"], "Distance (m)"),
            ("body.pin.profile.sphere.radius_m", &["0.01", "0.02"], "Radius of pin (mm)"),
            ("body.pin.material.young_Pa", &["2e11", "1e11"], "Young's modulus of pin (GPa)"),
            (
                "body.pin.wear.archard.coefficient_per_Pa",
                &["1e-13"],
                "Wear coefficient of pin (10⁻³ mm³/(N m))",
            ),
            ("friction.coulomb.coefficient", &["0.3", "0.6"], "Friction coefficient"),
            ("frame.elements", &["[8, 8]", "[8, 16]"], "Frame elements, number 2"),
        ] {
            assert_eq!(axis(name, cells), words, "{name}");
        }
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
