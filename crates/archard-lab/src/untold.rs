//! Wear of which no test tells anything.

use archard_case::{BodyCase, Case};

/// The wear law of a body that nothing tells.
#[derive(Debug, Clone, PartialEq)]
pub struct Untold {
    /// Its key.
    pub key: String,
    /// What the case has there (SI) and its unit; `None` where that is no single number.
    pub value: Option<(f64, String)>,
}

impl Untold {
    /// The laws of a case, but those that wear by nothing, of which none of these keys tells anything.
    pub fn of(case: &Case, told: &[impl AsRef<str>]) -> Vec<Self> {
        let own = |body: &BodyCase| {
            let wear = format!("body.{}.wear", body.name);
            if told.iter().any(|key| key.as_ref().starts_with(&wear)) {
                return None;
            }
            let law = format!("{wear}.{}", body.wear.as_ref()?.choice.name);
            let key = format!("{law}.coefficient");
            Some(match case.number_at(&key) {
                Some((0.0, _)) => return None,
                Some(value) => Self { key, value: Some(value) },
                None => Self { key: law, value: None },
            })
        };
        case.bodies.iter().filter_map(own).collect()
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
