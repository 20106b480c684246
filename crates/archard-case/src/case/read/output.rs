//! When a case puts out fields.

use crate::case::definition::{BodyCase, Output};
use crate::case::finite::FiniteCase;
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::case::quantity::measure;
use crate::case::reader::{Reader, Section};
use crate::case::tree::{Entry, Item};
use crate::output::Limit;
use archard::body::Elasticity;
use archard::elastic::{self, Point};
use archard::motion::{Motion, Planned, Progress, Shift};
use archard::parameters::{Quantity, Values};

impl Reader<'_> {
    /// When fields are put out; ten times where nothing is said, at the ends of cycles if there are
    /// several.
    pub(super) fn output(
        &mut self,
        root: &Section<'_>,
        (motion, schedule): &Planned,
    ) -> Option<Output> {
        let default = Output::Every(tenth(motion, schedule.extent));
        let Some((key, entry)) = root.get("output") else { return Some(default) };
        let section = self.as_table(key, &entry.node)?;
        self.unknown(&section, "key", &["every", "at", "points", "sections", "stress"]);
        let quantity = motion.progress.quantity;
        match (section.get("every"), section.get("at")) {
            (None, None) => Some(default),
            (Some(_), Some((key, _))) => {
                let message = "`every` and `at` exclude each other: keep one";
                self.push(Problem::error(key, message).at_name());
                None
            }
            (Some((key, entry)), None) => {
                let interval = self.number(key.clone(), &entry.node, quantity)?;
                self.few_outputs(key, interval, schedule.extent)
            }
            (None, Some((key, entry))) => {
                self.places(key, entry, quantity, schedule.extent).map(Output::At)
            }
        }
    }

    /// The limits at which the run ends.
    pub(super) fn until(
        &mut self,
        root: &Section<'_>,
        bodies: &[BodyCase; 2],
    ) -> Option<Vec<Limit>> {
        let Some((key, entry)) = root.get("until") else { return Some(vec![]) };
        let section = self.as_table(key, &entry.node)?;
        let columns = Limit::columns(bodies.each_ref().map(|body| &*body.name));
        let names: Vec<&str> = columns.iter().map(|(name, ..)| &**name).collect();
        self.unknown(&section, "quantity with a limit", &names);
        let (mut limits, before) = (vec![], self.problems.len());
        for (name, column, unit) in &columns {
            let Some((key, entry)) = section.get(name) else { continue };
            let value = self.number(key, &entry.node, of_unit(unit));
            limits.extend(value.map(|value| Limit { column: column.clone(), value }));
        }
        (self.problems.len() == before).then_some(limits)
    }

    /// The points of each body where displacement and stress are put out.
    pub(super) fn points_of_bodies(
        &mut self,
        root: &Section<'_>,
        bodies: &[BodyCase; 2],
    ) -> Option<[Vec<Point>; 2]> {
        let of_a_body =
            "points are those of a body: `output.points.BODY.NAME = [\"0 m\", \"0 m\", \"-1 mm\"]`";
        self.of_bodies(root, bodies, ("points", of_a_body), Self::places_by_name)
    }

    /// The sections of each body on which they are put out.
    pub(super) fn sections_of_bodies(
        &mut self,
        root: &Section<'_>,
        bodies: &[BodyCase; 2],
    ) -> Option<[Vec<elastic::Section>; 2]> {
        let of_a_body = "sections are those of a body: `output.sections.BODY.NAME = { through = [\"0 m\", \"0 m\", \"0 m\"], normal = [0, 1, 0], spacing = \"0.1 mm\" }`";
        self.of_bodies(root, bodies, ("sections", of_a_body), Self::sections_by_name)
    }

    /// What of each body is put out besides its surface, in tables by the names of the bodies.
    pub(super) fn of_bodies<T>(
        &mut self,
        root: &Section<'_>,
        bodies: &[BodyCase; 2],
        (name, of_a_body): (&str, &str),
        read: fn(&mut Self, &Section<'_>) -> Option<Vec<T>>,
    ) -> Option<[Vec<T>; 2]> {
        let mut found = [vec![], vec![]];
        let Some((key, entry)) = root.get("output") else { return Some(found) };
        // Complained about already if it cannot be one.
        let Item::Table(output) = &entry.node.item else { return Some(found) };
        let Some((key, entry)) = (Section { key, table: output }).get(name) else {
            return Some(found);
        };
        let section = self.as_table(key, &entry.node)?;
        let before = self.problems.len();
        for entry in &section.table.0 {
            let key = section.key.child(&entry.name);
            let Some(body) = bodies.iter().position(|body| body.name == entry.name) else {
                let names = bodies.each_ref().map(|body| format!("`{}`", body.name)).join(" or ");
                let message = "is the name of no body";
                let help = format!("{of_a_body}, with {names} for BODY");
                self.push(Problem::error(key, message).at_name().help(help));
                continue;
            };
            let deforms = |finite: &FiniteCase| {
                !matches!(finite.elasticity, Elasticity::HalfSpace | Elasticity::Reduced)
            };
            if bodies[body].material.is_none() && bodies[body].layers.is_empty()
                || bodies[body].finite.as_ref().is_some_and(|finite| !deforms(finite))
            {
                let message = "has no stress to put out: that takes an elastic body, a half-space or one with a `mesh` and `elasticity = \"image\"`, `\"boundary_elements\"` or `\"finite_elements\"`";
                self.push(Problem::error(key, message).at_name());
                continue;
            }
            if let Some(section) = self.as_table(key, &entry.node) {
                found[body] = read(self, &section).unwrap_or_default();
            }
        }
        (self.problems.len() == before).then_some(found)
    }

    /// An interval between outputs that does not ask for more of them than anyone would look at.
    fn few_outputs(&mut self, key: Key, interval: f64, extent: f64) -> Option<Output> {
        const MANY: f64 = 1e5;
        if extent / interval > MANY {
            let message =
                format!("asks for {:.1e} outputs, at most {MANY:e} are written", extent / interval);
            self.push(Problem::error(key, message));
            return None;
        }
        Some(Output::Every(interval))
    }

    /// Places of the motion in a list, rising.
    pub(super) fn places(
        &mut self,
        key: Key,
        entry: &Entry,
        quantity: Quantity,
        extent: f64,
    ) -> Option<Vec<f64>> {
        let Item::Array(nodes) = &entry.node.item else {
            let example = measure(quantity, &Values::default())
                .map_or("0.5".to_owned(), |measure| format!("\"{}\"", measure.example));
            let message =
                format!("expected a list like [{example}], found {}", entry.node.item.kind());
            self.push(Problem::error(key, message));
            return None;
        };
        let (mut sound, mut places) = (true, vec![]);
        for (index, node) in nodes.iter().enumerate() {
            let key = key.index(index);
            let place = self.number(key.clone(), node, quantity);
            sound &= place.is_some();
            match place {
                Some(place) if place > extent => {
                    let message = "lies beyond the end of the motion: nothing happens there";
                    self.push(Problem::warning(key, message));
                }
                place => places.extend(place),
            }
        }
        places.sort_by(f64::total_cmp);
        places.dedup();
        sound.then_some(places)
    }
}

/// A tenth of a motion, in whole cycles where it counts them or repeats itself.
fn tenth(motion: &Motion, extent: f64) -> f64 {
    let tenth = extent / 10.0;
    let Some(period) = motion.increments().map(Shift::period) else { return tenth };
    let counts = motion.progress == Progress::CYCLES || extent > 1.5 * period;
    if counts { period * (tenth / period - 1e-9).ceil().max(1.0) } else { tenth }
}

/// What a column of that unit measures.
fn of_unit(unit: &str) -> Quantity {
    match unit {
        "m^2" => Quantity::Measured { name: "an area", unit: "m^2" },
        "m^3" => Quantity::Measured { name: "a volume", unit: "m^3" },
        "kg" => Quantity::Measured { name: "a mass", unit: "kg" },
        _ => Quantity::Length,
    }
}
