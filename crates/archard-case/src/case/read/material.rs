//! What the bodies of a case are made of, by name or by values.

use crate::case::key::Key;
use crate::case::material::MaterialCase;
use crate::case::materials::HandbookMaterial;
use crate::case::problem::Problem;
use crate::case::reader::{Reader, Section};
use crate::case::tree::Item;
use archard::body::Thermal;
use archard::parameters::Values;

/// What lies below layers that is not elastic.
const RIGID: &str = "rigid";

impl Reader<'_> {
    /// The material of an elastic body, `Some(None)` where that is rigid; `None` if it is wrong.
    pub(super) fn material(&mut self, body: &Section<'_>) -> Option<Option<MaterialCase>> {
        if let Some((key, entry)) = body.get("substrate") {
            let known = matches!(&entry.node.item, Item::Text(word) if word == RIGID);
            if !known || body.get("layers").is_none() || body.get("material").is_some() {
                let message = "stands for the material below layers: `substrate = \"rigid\"` with `layers` and without `material`";
                self.push(Problem::error(key, message));
                return None;
            }
            return Some(None);
        }
        let rigid = self.boolean(body, "rigid")?.unwrap_or(false);
        if rigid {
            if let Some((key, _)) = body.get("material") {
                let message = "a rigid body does not deform: its material has no effect";
                self.push(Problem::warning(key, message).at_name());
            }
            return Some(None);
        }
        let meaning = match body.get("layers") {
            None => {
                "`{ young = \"210 GPa\", poisson = 0.3 }`, a name like \"100Cr6\", or `rigid = true` next to it"
            }
            Some(_) => "what the layers are on, or `substrate = \"rigid\"`",
        };
        let Some((key, entry)) = body.get("material") else {
            self.missing(body.key.child("material"), meaning);
            return None;
        };
        // Steels have numbers for names: `material = 304`.
        if let Item::Text(name) | Item::Number { text: name, .. } = &entry.node.item {
            let named = self.known(key, name)?;
            return MaterialCase::read(&Values::default(), Some(named)).ok().map(Some);
        }
        let section = self.as_table(key, &entry.node)?;
        let named = self.named_in(&section)?;
        let before = self.problems.len();
        let (values, _) = self.values(&section, MaterialCase::parameters(named.is_some()));
        if self.problems.len() > before {
            return None;
        }
        match MaterialCase::read(&values, named) {
            Ok(material) => Some(Some(material)),
            Err(invalid) => {
                self.invalid(&section, invalid);
                None
            }
        }
    }

    /// The material that a table names, `Some(None)` where it names none; `None` if there is no such one.
    pub(super) fn named_in(
        &mut self,
        section: &Section<'_>,
    ) -> Option<Option<&'static HandbookMaterial>> {
        match section.get("name").map(|(key, entry)| (key, &entry.node.item)) {
            Some((key, Item::Text(name))) => self.known(key, name).map(Some),
            _ => Some(None),
        }
    }

    /// The material of a name that stands at a key.
    fn known(&mut self, key: Key, name: &str) -> Option<&'static HandbookMaterial> {
        let found = HandbookMaterial::find(name);
        if let Err(unknown) = &found {
            self.push(Problem::error(key, unknown.to_string()).help(unknown.help()));
        }
        found.ok()
    }

    /// How a body conducts heat, `Some(None)` where nothing is said; `None` if it is wrong.
    pub(super) fn thermal(
        &mut self,
        body: &Section<'_>,
        material: Option<&MaterialCase>,
    ) -> Option<Option<Thermal>> {
        let Some((key, entry)) = body.get("thermal") else { return Some(None) };
        let section = self.as_table(key, &entry.node)?;
        let before = self.problems.len();
        let (values, _) = self.values(&section, MaterialCase::thermal_parameters(material));
        if self.problems.len() > before {
            return None;
        }
        match MaterialCase::heat(material, &values) {
            Ok(thermal) => Some(Some(thermal)),
            Err(invalid) => {
                self.invalid(&section, invalid);
                None
            }
        }
    }
}
