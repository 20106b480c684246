//! Headers: the name of a column, and its unit.

use archard::units::{Measure, Scale};

/// A header.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Heading {
    /// As it stands in the table.
    pub title: String,
    /// In small letters, words tied by `_`, without the unit.
    pub name: String,
    /// The unit, if it has one.
    pub unit: Option<String>,
}

impl Heading {
    /// The name and unit of a title.
    pub fn of(title: &str) -> Self {
        let (name, unit) = split(title);
        let unit = unit.map(|unit| if unit == "-" { "1".to_owned() } else { unit });
        Self { title: title.to_owned(), name: plain(&name), unit }
    }

    /// Whether that is its title or name.
    pub fn is(&self, text: &str) -> bool {
        self.title == text.trim() || self.name == plain(text)
    }

    /// Puts another name in the place of its own, and the unit behind that name where it has none; `false` where it has
    /// another one.
    #[must_use]
    pub fn rename(&mut self, name: &str) -> bool {
        let given = Self::of(name);
        self.name = given.name;
        let unit = self.unit.take().or_else(|| given.unit.clone());
        let same =
            given.unit.is_none_or(|given| unit.as_ref().is_some_and(|own| alike(&given, own)));
        self.unit = unit;
        same
    }
}

/// Whether two texts are one unit, as um and µm are.
fn alike(one: &str, other: &str) -> bool {
    let scale = |text: &str| Scale::read_any(text).ok();
    one == other || scale(one).is_some_and(|own| scale(other) == Some(own))
}

/// The header that a column of a name needs: `depth [mm]`.
pub(super) fn like(name: &str, measure: &Measure) -> String {
    match *measure == Measure::NUMBER {
        true => name.to_owned(),
        false => format!("{name} [{}]", measure.units[0]),
    }
}

fn plain(name: &str) -> String {
    name.trim().to_lowercase().split([' ', '-', '_']).filter(|word| !word.is_empty()).fold(
        String::new(),
        |joined, word| match joined.is_empty() {
            true => word.to_owned(),
            false => joined + "_" + word,
        },
    )
}

/// The name and unit of `Distance [mm]`, `depth (um)`, `Tiefe / µm` or `volume_mm3`. Behind `_` stands a unit only if it is
/// one, with `_per_` for `/`.
fn split(title: &str) -> (String, Option<String>) {
    let bracketed = [('[', ']'), ('(', ')')].into_iter().find_map(|(open, close)| {
        let (name, unit) = title.strip_suffix(close)?.split_once(open)?;
        Some((name, unit))
    });
    if let Some((name, unit)) = bracketed.or_else(|| title.split_once(" / ")) {
        let unit = unit.trim();
        return (name.to_owned(), (!unit.is_empty()).then(|| unit.to_owned()));
    }
    let divided = title.replace("_per_", "/");
    match divided.rsplit_once('_') {
        Some((name, unit)) if Scale::read_any(unit).is_ok() => {
            (name.to_owned(), Some(unit.to_owned()))
        }
        _ => (title.to_owned(), None),
    }
}
