//! A case of one body without contact.

use super::super::elastic::ElasticCase;
use super::super::key::is_bare;
use super::super::problem::Problem;
use super::super::reader::{Reader, Section};
use super::super::tree::Item;
use super::TABLES;
use archard::elastic::{self, Point};
use archard::parameters::Quantity;

/// Tables that only bodies in contact have.
const OF_CONTACT: &[&str] = &["frame", "friction", "motion", "solver", "friction_solver"];

impl Reader<'_> {
    /// Whether a case is about one meshed body alone.
    pub fn is_elastic(root: &Section<'_>) -> bool {
        let Some((_, bodies)) = root.get("body") else { return false };
        let Item::Table(bodies) = &bodies.node.item else { return false };
        let [body] = &bodies.0[..] else { return false };
        matches!(&body.node.item, Item::Table(body) if body.get("mesh").is_some())
    }

    /// The case, if nothing is wrong with it.
    pub fn elastic(&mut self, root: &Section<'_>) -> Option<ElasticCase> {
        self.unknown(root, "key", TABLES);
        for name in OF_CONTACT {
            if let Some((key, _)) = root.get(name) {
                let message = "is about contact, and this case has one body only";
                let help = "leave it out, or give a second body that touches the first";
                self.push(Problem::error(key, message).at_name().help(help));
            }
        }
        let title = self.title(root);
        let section = self.table(root, "body", "a body, `[body.NAME]`")?;
        let body = section.table.0.first().and_then(|entry| {
            let body = self.body(&section.key, entry)?;
            let inside = self.as_table(section.key.child(&entry.name), &entry.node)?;
            self.alone(&inside);
            Some(body)
        });
        let (points, sections) = (self.points(root), self.sections(root));
        Some(ElasticCase { title: title?, body: body?, points: points?, sections: sections? })
    }

    /// Complains about what only a body in contact has.
    fn alone(&mut self, body: &Section<'_>) {
        for name in ["wear", "profile", "density", "hardness", "thermal"] {
            if let Some((key, _)) = body.get(name) {
                let message = "has no effect on a body that nothing touches: leave it out";
                self.push(Problem::error(key, message).at_name());
            }
        }
    }

    /// The points where displacement and stress are put out.
    fn points(&mut self, root: &Section<'_>) -> Option<Vec<Point>> {
        let Some((key, entry)) = root.get("output") else { return Some(vec![]) };
        let section = self.as_table(key, &entry.node)?;
        self.unknown(&section, "key", &["points", "sections"]);
        let Some((key, entry)) = section.get("points") else { return Some(vec![]) };
        let section = self.as_table(key, &entry.node)?;
        self.places_by_name(&section)
    }

    /// The sections on which they are put out.
    fn sections(&mut self, root: &Section<'_>) -> Option<Vec<elastic::Section>> {
        let Some((key, entry)) = root.get("output") else { return Some(vec![]) };
        // Complained about already if it cannot be one.
        let Item::Table(output) = &entry.node.item else { return None };
        let Some((key, entry)) = (Section { key, table: output }).get("sections") else {
            return Some(vec![]);
        };
        let section = self.as_table(key, &entry.node)?;
        self.sections_by_name(&section)
    }

    /// Sections of a body by their names.
    pub(super) fn sections_by_name(
        &mut self,
        section: &Section<'_>,
    ) -> Option<Vec<elastic::Section>> {
        let mut sections = vec![];
        for entry in &section.table.0 {
            let key = section.key.child(&entry.name);
            if !is_bare(&entry.name) {
                let message = "names of sections are of letters, digits, _ and -";
                self.push(Problem::error(key, message).at_name());
                continue;
            }
            let Some(inside) = self.as_table(key, &entry.node) else { continue };
            let before = self.problems.len();
            let (values, _) = self.values(&inside, elastic::Section::PARAMETERS);
            if self.problems.len() > before {
                continue;
            }
            if let (Some(through), Some(normal), Some(spacing)) =
                (values.triple("through"), values.triple("normal"), values.number("spacing"))
            {
                let (name, size) = (entry.name.clone(), values.pair("size"));
                sections.push(elastic::Section { name, through, normal, spacing, size });
            }
        }
        (sections.len() == section.table.0.len()).then_some(sections)
    }

    /// Places in a body by their names.
    pub(super) fn places_by_name(&mut self, section: &Section<'_>) -> Option<Vec<Point>> {
        let mut points = vec![];
        for entry in &section.table.0 {
            let key = section.key.child(&entry.name);
            if !is_bare(&entry.name) {
                let message = "names of points are of letters, digits, _ and -";
                self.push(Problem::error(key, message).at_name());
                continue;
            }
            let place = self.three(key, &entry.node, |reader, key, node| {
                reader.any_number(key, node, Quantity::Length)
            });
            points.extend(place.map(|place| Point { name: entry.name.clone(), place }));
        }
        (points.len() == section.table.0.len()).then_some(points)
    }
}
