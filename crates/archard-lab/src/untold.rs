//! Wear that no test says anything of.

use archard_case::Case;

/// A wear law that nothing gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Untold {
    /// Its key.
    pub key: String,
    /// What the case has there (SI) and its unit; `None` where that is no single number.
    pub value: Option<(f64, String)>,
}

impl Untold {
    /// The laws of a case, but those that wear by nothing, that none of these keys says anything of: keys in their table, or
    /// tables around it.
    pub fn of(case: &Case, told: &[impl AsRef<str>]) -> Vec<Self> {
        let told: Vec<String> = told.iter().map(|key| dotted(key.as_ref())).collect();
        let is_told = |table: &String| {
            let within =
                |key: &String| key.starts_with(table) || table.starts_with(&format!("{key}."));
            told.iter().any(within)
        };
        let laws = laws(case).into_iter().filter(|(table, _)| !is_told(table));
        let own = |(table, law): (String, &str)| {
            let law = format!("{table}.{law}");
            let key = format!("{law}.coefficient");
            match case.number_at(&key) {
                Some((0.0, _)) => None,
                Some(value) => Some(Self { key, value: Some(value) }),
                None => Some(Self { key: law, value: None }),
            }
        };
        laws.filter_map(own).collect()
    }

    /// Some of them with their values, in words.
    pub fn values(all: &[Self]) -> String {
        let one = |own: &Self| match &own.value {
            Some((value, unit)) => {
                format!("`{}`, which is {value:.3e} {unit} in the case", own.key)
            }
            None => format!("`{}`", own.key),
        };
        all.iter().map(one).collect::<Vec<_>>().join(" and no ")
    }

    /// The options that take them from the case.
    pub fn options(all: &[Self]) -> String {
        all.iter().map(|own| format!("--assume {}", own.key)).collect::<Vec<_>>().join(" ")
    }
}

/// The tables of wear of a case, of bodies and of their layers, each with the name of its law.
pub(super) fn laws(case: &Case) -> Vec<(String, &'static str)> {
    let mut laws = vec![];
    for body in &case.bodies {
        let own = [("wear".to_owned(), &body.wear)].into_iter();
        let layers = body.layers.iter().enumerate();
        let layers = layers.map(|(place, layer)| (format!("layers.{place}.wear"), &layer.wear));
        for (table, law) in own.chain(layers) {
            laws.extend(
                law.as_ref().map(|law| (format!("body.{}.{table}", body.name), law.choice.name)),
            );
        }
    }
    laws
}

/// A key with the number of an element of a list between dots.
pub(super) fn dotted(key: &str) -> String {
    key.replace('[', ".").replace(']', "")
}
