//! A case of two gears in mesh.

use super::super::gear::{GEARS, GearCase, MESH};
use super::super::problem::Problem;
use super::super::reader::{Reader, Section};
use super::super::tree::{Entry, Item};
use super::super::wheel_rail::ProfiledPart;
use archard::parameters::Quantity;
use archard_gear::Gear;

/// The tables of such a case.
pub(super) const TABLES: &[&str] = &["title", "body", "friction", "motion", "until"];

impl Reader<'_> {
    /// Whether a case is about two gears.
    pub fn is_gear(root: &Section<'_>) -> bool {
        let Some((_, motion)) = root.get("motion") else { return false };
        matches!(&motion.node.item, Item::Table(motion) if motion.get("mesh").is_some())
    }

    /// The case, if nothing is wrong with it.
    pub fn gear(&mut self, root: &Section<'_>) -> Option<GearCase> {
        self.unknown(root, "key", TABLES);
        let title = self.title(root);
        let bodies = self.table(root, "body", "two gears, `[body.NAME]` each")?;
        let involute = |entry: &&Entry| match &entry.node.item {
            Item::Table(body) => match body.get("profile").map(|profile| &profile.node.item) {
                Some(Item::Table(profile)) => profile.get("involute").is_some(),
                _ => false,
            },
            _ => false,
        };
        for entry in bodies.table.0.iter().filter(|entry| !involute(entry)) {
            let message = "is no gear: give `profile.involute`";
            self.push(Problem::error(bodies.key.child(&entry.name), message).at_name());
        }
        let gears: Vec<&Entry> = bodies.table.0.iter().filter(involute).collect();
        let [one, two] = gears[..] else {
            let message = format!("two gears mesh, here are {}", gears.len());
            self.push(Problem::error(bodies.key.clone(), message));
            return None;
        };
        let gears = [one, two].map(|entry| self.rolling_body::<Gear>(&bodies, entry, GEARS));
        let motion = self.table(root, "motion", "how the gears mesh")?;
        let motion = self.choice(&motion, "motion", MESH).map(|(chosen, _)| chosen);
        let friction = self.friction(root);
        let until = self.worn_depths(root, [&one.name, &two.name]);
        let [one, two] = gears;
        let gears: [ProfiledPart<Gear>; 2] = [one?, two?];
        Some(GearCase { title: title?, gears, friction: friction?, motion: motion?, until: until? })
    }

    /// The worn depths at which lives of two bodies end.
    pub(super) fn worn_depths(
        &mut self,
        root: &Section<'_>,
        names: [&str; 2],
    ) -> Option<[Option<f64>; 2]> {
        let Some((key, entry)) = root.get("until") else { return Some([None; 2]) };
        let section = self.as_table(key, &entry.node)?;
        let keys = names.map(|name| format!("wear_depth_{name}"));
        self.unknown(&section, "quantity with a limit", &keys.each_ref().map(|key| &**key));
        let before = self.problems.len();
        let depths = keys.map(|name| {
            let (key, entry) = section.get(&name)?;
            let depth = self.number(key.clone(), &entry.node, Quantity::Length)?;
            if depth <= 0.0 {
                let message = "the depth must be greater than zero";
                self.push(Problem::error(key, message));
            }
            Some(depth)
        });
        (self.problems.len() == before).then_some(depths)
    }
}
