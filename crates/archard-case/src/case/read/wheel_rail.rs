//! A case of a wheel on a rail.

use super::super::chosen::ChosenPart;
use super::super::key::is_bare;
use super::super::problem::Problem;
use super::super::reader::{Reader, Section};
use super::super::tree::{Entry, Item};
use super::super::wheel_rail::{
    CRACKS, LIMITS, ProfiledPart, RAILS, REPROFILING, WHEEL_RAIL, WHEELS, WheelRailCase,
};
use archard::parameters::{Choice, Parameter, Values};
use archard_rail::contact::Resolution;
use archard_rail::wear::Cracks;

/// The tables of such a case.
const TABLES: &[&str] = &["title", "body", "frame", "friction", "motion", "until", "reprofiling"];
/// What a wheel or a rail may have.
const OF_BODIES: &[&str] = &["material", "thermal", "profile", "wear", "flange_wear", "cracks"];
/// What other bodies may have that roll.
const OF_OTHERS: &[&str] = &["material", "profile", "wear"];

impl Reader<'_> {
    /// Whether a case is about a wheel on a rail.
    pub fn is_wheel_rail(root: &Section<'_>) -> bool {
        let Some((_, motion)) = root.get("motion") else { return false };
        matches!(&motion.node.item, Item::Table(motion) if motion.get("wheel_rail").is_some())
    }

    /// The case, if nothing is wrong with it.
    pub fn wheel_rail(&mut self, root: &Section<'_>) -> Option<WheelRailCase> {
        self.unknown(root, "key", TABLES);
        let title = self.title(root);
        let bodies = self.table(root, "body", "a wheel and a rail, `[body.NAME]` each")?;
        let wheel = self.rolled(&bodies, "wheel", WHEELS);
        let rail = self.rolled(&bodies, "rail", RAILS);
        for entry in &bodies.table.0 {
            if kind(entry).is_none() {
                let message = "is neither wheel nor rail: give `profile.wheel` or `profile.rail`";
                self.push(Problem::error(bodies.key.child(&entry.name), message).at_name());
            }
        }
        let motion = self.table(root, "motion", "how the wheelset stands and runs")?;
        let motion = self.choice(&motion, "motion", WHEEL_RAIL).map(|(chosen, _)| chosen);
        let friction = match root.get("friction") {
            None => {
                self.missing(root.key.child("friction"), "a friction law, `friction.coulomb`");
                None
            }
            Some(_) => self.friction(root).flatten(),
        };
        let elements = self.elements_of_patches(root);
        let until = self.values_of(root, "until", LIMITS);
        let reprofiling = self.values_of(root, "reprofiling", REPROFILING);
        Some(WheelRailCase {
            until: until?,
            reprofiling: reprofiling?,
            title: title?,
            wheel: wheel?,
            rail: rail?,
            friction: friction?,
            motion: motion?,
            elements: elements?,
        })
    }

    /// The values of a section, none where it is left out; `None` if they are wrong.
    fn values_of(
        &mut self,
        root: &Section<'_>,
        name: &str,
        parameters: &'static [Parameter],
    ) -> Option<Values> {
        let Some((key, entry)) = root.get(name) else { return Some(Values::default()) };
        let before = self.problems.len();
        let section = self.as_table(key, &entry.node)?;
        let values = self.values(&section, parameters).0;
        (self.problems.len() == before).then_some(values)
    }

    /// How a body cracks, `Some(None)` where nobody asks for it; `None` if it is wrong.
    fn cracks(&mut self, body: &Section<'_>) -> Option<Option<ChosenPart<Cracks>>> {
        let Some((key, entry)) = body.get("cracks") else { return Some(None) };
        let section = self.as_table(key, &entry.node)?;
        self.required(&section, "model of cracks", CRACKS).map(Some)
    }

    /// The body with that kind of profile.
    fn rolled<S>(
        &mut self,
        bodies: &Section<'_>,
        which: &str,
        choices: &'static [Choice<S>],
    ) -> Option<ProfiledPart<S>> {
        let mut found = bodies.table.0.iter().filter(|entry| kind(entry) == Some(which));
        let Some(entry) = found.next() else {
            self.missing(bodies.key.clone(), &format!("a body with `profile.{which}`"));
            return None;
        };
        if let Some(second) = found.next() {
            let message = format!("a second {which} next to `{}`: keep one", entry.name);
            self.push(Problem::error(bodies.key.child(&second.name), message).at_name());
        }
        self.body_of(bodies, entry, (choices, OF_BODIES))
    }

    /// A body with a profile of a list.
    pub(super) fn rolling_body<S>(
        &mut self,
        bodies: &Section<'_>,
        entry: &Entry,
        choices: &'static [Choice<S>],
    ) -> Option<ProfiledPart<S>> {
        self.body_of(bodies, entry, (choices, OF_OTHERS))
    }

    /// The same, which may have those tables.
    fn body_of<S>(
        &mut self,
        bodies: &Section<'_>,
        entry: &Entry,
        (choices, tables): (&'static [Choice<S>], &[&str]),
    ) -> Option<ProfiledPart<S>> {
        let key = bodies.key.child(&entry.name);
        if !is_bare(&entry.name) {
            let message = "names of bodies are of letters, digits, _ and -";
            self.push(Problem::error(key.clone(), message).at_name());
        }
        let section = self.as_table(key, &entry.node)?;
        self.unknown(&section, "key", tables);
        let material = self.material(&section);
        let made_of = material.as_ref().and_then(Option::as_ref);
        let thermal = self.thermal(&section, made_of);
        let profile = self.table(&section, "profile", "the profile")?;
        let profile = self.choice(&profile, "profile", choices).map(|(chosen, _)| chosen);
        let wear = self.wear(&section);
        let flange_wear = self.wear_of(&section, "flange_wear");
        let cracks = self.cracks(&section);
        let Some(material) = material? else {
            let message = "bodies that roll are elastic";
            self.push(Problem::error(section.key.child("rigid"), message).at_name());
            return None;
        };
        let (name, hardness, material) = (entry.name.clone(), material.hardness, material.elastic);
        let (wear, flange_wear) = (wear?, flange_wear?);
        let (profile, cracks, thermal) = (profile?, cracks?, thermal?);
        Some(ProfiledPart { name, material, hardness, thermal, profile, wear, flange_wear, cracks })
    }

    /// The elements across patches, `Some(None)` where they are not given; `None` if they are wrong.
    fn elements_of_patches(&mut self, root: &Section<'_>) -> Option<Option<usize>> {
        let Some((key, entry)) = root.get("frame") else { return Some(None) };
        let section = self.as_table(key, &entry.node)?;
        self.unknown(&section, "key", &["elements"]);
        let Some((key, entry)) = section.get("elements") else { return Some(None) };
        let elements = self.count(key.clone(), &entry.node)?;
        match (Resolution { elements, ..Resolution::default() }).checked() {
            Ok(_) => Some(Some(elements)),
            Err(invalid) => {
                self.push(Problem::error(key, invalid.message));
                None
            }
        }
    }
}

/// Which of the two a body is, by its profile.
fn kind(entry: &Entry) -> Option<&'static str> {
    let Item::Table(body) = &entry.node.item else { return None };
    let Item::Table(profile) = &body.get("profile")?.node.item else { return None };
    ["wheel", "rail"].into_iter().find(|kind| profile.get(kind).is_some())
}
