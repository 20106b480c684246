//! The frame of a case.

use crate::case::check::footprint::BYTES_A_PAIR;
use crate::case::definition::FrameCase;
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::case::reader::{Reader, Section};
use crate::case::tree::{Item, Node};
use crate::parameters::Quantity;

impl Reader<'_> {
    /// Size and elements.
    pub(super) fn frame(&mut self, section: &Section<'_>) -> Option<FrameCase> {
        self.unknown(section, "key", &["size", "elements"]);
        let size = self.pair(
            section,
            "size",
            "its size along x and y, `[\"1 mm\", \"1 mm\"]`",
            |reader, key, node| reader.number(key, node, Quantity::Length),
        );
        let elements = self.pair(
            section,
            "elements",
            "the number of elements along x and y, `[30, 30]`",
            |reader, key, node| reader.count(key, node),
        );
        let elements = elements.filter(|&elements| self.not_too_many(section, elements));
        Some(FrameCase { size: size?, elements: elements? })
    }

    /// Whether a machine can hold that many elements.
    fn not_too_many(&mut self, section: &Section<'_>, elements: [usize; 2]) -> bool {
        const MOST: f64 = 4096.0 * 4096.0;
        let number = elements[0] as f64 * elements[1] as f64;
        if number > MOST {
            let message = format!(
                "{number:.1e} elements would take about {:.0} GB: 4096 by 4096 is the most",
                number * BYTES_A_PAIR * 1e-9
            );
            self.push(Problem::error(section.key.child("elements"), message));
        }
        number <= MOST
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
