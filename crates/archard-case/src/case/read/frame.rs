//! The frame of a case.

use crate::case::check::footprint;
use crate::case::definition::{BodyCase, FrameCase, MOST};
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::case::reader::{Line, Reader, Section};
use crate::case::tree::{Entry, Item, Node};
use archard::body::Profile;
use archard::motion::Planned;
use archard::parameters::Quantity;
use archard::simulation::can_widen;

/// The readings of a surface that was measured on an even grid, each an element; `None` where no body has one, or they differ.
pub(super) fn measured(bodies: &[BodyCase; 2]) -> Option<FrameCase> {
    let [one, two] = bodies.each_ref().map(|body| patch(&*body.profile.build().ok()?));
    match (one, two) {
        (Some(patch), None) | (None, Some(patch)) => Some(patch),
        (Some(one), Some(two)) if one == two => Some(one),
        _ => None,
    }
}

/// That of one surface.
fn patch(profile: &dyn Profile) -> Option<FrameCase> {
    let axis = |places: &[f64]| -> Option<(f64, f64, usize)> {
        let [first, .., last] = *places else { return None };
        let step = (last - first) / (places.len() - 1) as f64;
        let even =
            |(i, place): (usize, &f64)| (place - first - i as f64 * step).abs() < EVEN * step;
        let all = places.iter().enumerate().all(even);
        all.then_some((0.5 * (first + last), places.len() as f64 * step, places.len()))
    };
    let [x, y] = profile.places().map(axis);
    let ((x, width, columns), (y, height, rows)) = (x?, y?);
    Some(FrameCase {
        centre: [x, y],
        size: [width, height],
        elements: [columns, rows],
        ..FrameCase::to_be_chosen()
    })
}

/// By how much readings may be off an even grid, relative to their distance: what a file is rounded to.
const EVEN: f64 = 1e-2;

impl Reader<'_> {
    /// Size and elements; those that are to be chosen may be missing.
    pub(super) fn frame(
        &mut self,
        section: &Section<'_>,
        chosen: bool,
        measured: Option<FrameCase>,
    ) -> Option<FrameCase> {
        self.unknown(
            section,
            "key",
            &[
                "centre",
                "size",
                "elements",
                "element",
                "doubles",
                "plane_strain",
                "length",
                "periodic",
            ],
        );
        let periodic = self.boolean(section, "periodic")?.unwrap_or(false);
        let element = self.element(section)?;
        let chosen = (chosen || element.is_some()) && !periodic;
        let says = ["centre", "size", "elements", "element", "plane_strain", "length"]
            .into_iter()
            .any(|name| section.get(name).is_some());
        let frame = match (measured.filter(|_| !chosen && !says), self.line_of_contact(section)?) {
            (Some(measured), _) => Some(measured),
            (None, Some(length)) => self.line(section, length, chosen),
            (None, None) => self.rectangle(section, chosen),
        };
        let mut frame = FrameCase { periodic, ..frame? };
        if let Some(element) = element {
            frame.element = element;
            if frame.size[0] > 0.0 {
                frame.count();
            }
            let counted = frame.elements[0] == 0 || self.not_too_many(section, frame.elements);
            counted.then_some(())?;
        }
        if periodic {
            self.cell = Some(frame.size[0] * frame.size[1]);
            let along = if frame.line { 1 } else { 2 };
            if frame.elements[..along].iter().any(|count| !count.is_multiple_of(2)) {
                let message = "surfaces that repeat themselves take an even number of elements";
                self.push(Problem::error(section.key.child("elements"), message));
                return None;
            }
        }
        Some(frame)
    }

    /// How large elements are to be along x and y (m), `Some(None)` where nobody says; `None` if that is wrong.
    fn element(&mut self, section: &Section<'_>) -> Option<Option<[f64; 2]>> {
        let Some((key, entry)) = section.get("element") else { return Some(None) };
        if section.get("elements").is_some() {
            let message =
                "says how large elements are, and `elements` how many there are: give one of both";
            self.push(Problem::error(key, message).at_name());
            return None;
        }
        let element = match &entry.node.item {
            Item::Array(_) => self.pair(
                section,
                "element",
                "the size of an element, `\"5 um\"`, or that along x and y",
                |reader, key, node| reader.number(key, node, Quantity::Length),
            )?,
            _ => [self.number(key, &entry.node, Quantity::Length)?; 2],
        };
        Some(Some(element))
    }

    /// That of an area.
    fn rectangle(&mut self, section: &Section<'_>, chosen: bool) -> Option<FrameCase> {
        let none = FrameCase::to_be_chosen();
        let centre = match section.get("centre") {
            None => Some(none.centre),
            _ => self.pair(
                section,
                "centre",
                "its centre along x and y, `[\"0 mm\", \"0 mm\"]`",
                |reader, key, node| reader.any_number(key, node, Quantity::Length),
            ),
        };
        let size = match section.get("size") {
            None if chosen => Some(none.size),
            _ => self.pair(
                section,
                "size",
                "its size along x and y, `[\"1 mm\", \"1 mm\"]`",
                |reader, key, node| reader.number(key, node, Quantity::Length),
            ),
        };
        let elements = match section.get("elements") {
            None if chosen || section.get("element").is_some() => Some(none.elements),
            _ => self.pair(
                section,
                "elements",
                "the number of elements along x and y, `[30, 30]`",
                |reader, key, node| reader.count(key, node),
            ),
        };
        let elements = elements.filter(|&elements| self.not_too_many(section, elements));
        Some(FrameCase { centre: centre?, size: size?, elements: elements?, ..none })
    }

    /// From where on the frame is twice as wide: nowhere, if the key is not there.
    pub(super) fn doubles(
        &mut self,
        root: &Section<'_>,
        frame: Option<FrameCase>,
        (motion, schedule): &Planned,
    ) -> Option<Vec<f64>> {
        let Some((key, entry)) = root.get("frame") else { return Some(vec![]) };
        let Item::Table(table) = &entry.node.item else { return Some(vec![]) };
        let Some((key, entry)) = (Section { key, table }).get("doubles") else {
            return Some(vec![]);
        };
        let frame = frame?;
        let wrong = if frame.line || !can_widen(motion) {
            Some(
                "frames become wider only where bodies slide and neither swings, and no line of contact does",
            )
        } else if frame.size[0] == 0.0 || frame.elements[0] == 0 {
            Some(
                "tells how an explicit frame becomes wider: give its `size` and `elements`, or leave this out",
            )
        } else if frame.elements.iter().any(|count| !count.is_multiple_of(2)) {
            Some("takes an even number of elements along both axes: two of them become one")
        } else {
            None
        };
        if let Some(wrong) = wrong {
            self.push(Problem::error(key, wrong).at_name());
            return None;
        }
        self.places(key, entry, motion.progress.quantity, schedule.extent)
    }

    /// The length (m) of a line of contact, `Some(None)` where the frame has no such line; `None` if that is wrong. Loads are read
    /// accordingly from here on.
    fn line_of_contact(&mut self, section: &Section<'_>) -> Option<Option<f64>> {
        let plane = self.boolean(section, "plane_strain")?;
        let length = match section.get("length") {
            None => None,
            Some((key, entry)) => Some(self.number(key, &entry.node, Quantity::Length)?),
        };
        if plane == Some(false) && length.is_some() {
            let message =
                "only a line of contact has a `length`: without plane strain `size` says all";
            self.push(Problem::error(section.key.child("length"), message).at_name());
            return None;
        }
        self.line = (plane == Some(true) || length.is_some()).then_some(Line { length });
        Some(self.line.map(Line::length))
    }

    /// Width and elements of a line of contact.
    fn line(&mut self, section: &Section<'_>, length: f64, chosen: bool) -> Option<FrameCase> {
        let centre = match section.get("centre") {
            None => Some(0.0),
            _ => self.along_x(
                section,
                "centre",
                "its centre along x, `\"0 mm\"`",
                "of a line of contact `centre` is that along x alone",
                |reader, key, node| reader.any_number(key, node, Quantity::Length),
            ),
        };
        let size = match section.get("size") {
            None if chosen => Some(0.0),
            _ => self.along_x(
                section,
                "size",
                "its size along x, `\"1 mm\"`",
                "of a line of contact `size` is that along x alone; how long it is says `length`",
                |reader, key, node| reader.number(key, node, Quantity::Length),
            ),
        };
        let elements = match section.get("elements") {
            None if chosen || section.get("element").is_some() => Some([0, 1]),
            _ => self.in_strips(section),
        };
        let elements = elements.filter(|&elements| self.not_too_many(section, elements));
        let (centre, size, elements) = ([centre?, 0.0], [size?, length], elements?);
        let none = FrameCase::to_be_chosen();
        Some(FrameCase { centre, size, elements, line: true, ..none })
    }

    /// The number of elements of a line of contact along x and, where there are strips, that of these along it.
    fn in_strips(&mut self, section: &Section<'_>) -> Option<[usize; 2]> {
        let list =
            |entry: &Entry| matches!(&entry.node.item, Item::Array(values) if values.len() == 2);
        let meaning = "the number of elements along x, `240`";
        if section.get("elements").is_some_and(|(_, entry)| list(entry)) {
            let elements = self
                .pair(section, "elements", meaning, |reader, key, node| reader.count(key, node))?;
            if elements[1] > 1 && self.line.is_none_or(|line| line.length.is_none()) {
                let message = "strips lie along the `length` of the line, which is not given";
                self.push(Problem::error(section.key.child("elements"), message));
                return None;
            }
            return Some(elements);
        }
        let two = "of a line of contact: the number of elements along x and, where it has strips, that of strips along y";
        let count = |reader: &mut Self, key, node: &Node| reader.count(key, node);
        Some([self.along_x(section, "elements", meaning, two, count)?, 1])
    }

    /// A value along x, by itself or in a list.
    fn along_x<T>(
        &mut self,
        section: &Section<'_>,
        name: &str,
        meaning: &str,
        two: &str,
        read: impl Fn(&mut Self, Key, &Node) -> Option<T>,
    ) -> Option<T> {
        let Some((key, entry)) = section.get(name) else {
            self.missing(section.key.child(name), meaning);
            return None;
        };
        match &entry.node.item {
            Item::Array(values) => match &values[..] {
                [value] => read(self, key.index(0), value),
                _ => {
                    self.push(Problem::error(key, two));
                    None
                }
            },
            _ => read(self, key, &entry.node),
        }
    }

    /// Whether a machine can hold that many elements.
    fn not_too_many(&mut self, section: &Section<'_>, elements: [usize; 2]) -> bool {
        let most = (MOST * MOST) as f64;
        let number = elements[0] as f64 * elements[1] as f64;
        if number > most {
            let message = format!(
                "{number:.1e} elements would take about {:.0} GB: {MOST} by {MOST} is the most",
                footprint::of_pairs(number) * 1e-9
            );
            self.push(Problem::error(section.key.child("elements"), message));
        }
        number <= most
    }

    /// Two values in a list, along x and y.
    fn pair<T>(
        &mut self,
        section: &Section<'_>,
        name: &str,
        meaning: &str,
        read: impl Fn(&mut Self, Key, &Node) -> Option<T>,
    ) -> Option<[T; 2]> {
        let Some((key, entry)) = section.get(name) else {
            self.missing(section.key.child(name), meaning);
            return None;
        };
        let values = match &entry.node.item {
            Item::Array(values) if values.len() == 2 => values,
            Item::Array(values) => {
                let message = format!("expected two values, along x and y, found {}", values.len());
                self.push(Problem::error(key, message));
                return None;
            }
            other => {
                let message = format!("expected {meaning}, found {}", other.kind());
                self.push(Problem::error(key, message));
                return None;
            }
        };
        let [x, y] = [0, 1].map(|axis| read(self, key.index(axis), &values[axis]));
        Some([x?, y?])
    }
}
