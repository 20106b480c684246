//! A case file with other values in it, all else as it was written.

use std::ops::Range;

use toml::de::DeTable;

use super::CaseFile;
use super::overlay;
use super::problem::Source;
use super::tree::{Item, Origin, Table};

impl CaseFile {
    /// What the file has at a dotted key, as it is written there; `None` where it has nothing, or no TOML.
    pub fn written_at(&self, key: &str) -> Option<&str> {
        self.text(Source::File).get(self.span_at(key)?)
    }

    /// The file with another value at a dotted key that it has, and its remarks; the value may lack its quotes, as in an option.
    /// `None` where it has nothing there.
    pub fn rewritten(&self, key: &str, value: &str) -> Option<Self> {
        let span = self.span_at(key)?;
        let mut text = self.text(Source::File).to_owned();
        text.replace_range(span, &overlay::as_toml(value));
        Some(self.with_text(text))
    }

    /// Where the value at a key stands (bytes).
    fn span_at(&self, key: &str) -> Option<Range<usize>> {
        let parsed = DeTable::parse(self.text(Source::File)).ok()?;
        let origin = Origin { source: Source::File, start: 0, fixed: None };
        let mut table = &Table::from_toml(parsed.get_ref(), &origin);
        let path = overlay::read_path(key, Source::File)?;
        let ((last, _), tables) = path.split_last()?;
        for (name, _) in tables {
            match &table.get(name)?.node.item {
                Item::Table(inner) => table = inner,
                _ => return None,
            }
        }
        Some(table.get(last)?.node.at.span.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::CaseFile;

    const TEXT: &str = "# a pin\n[body.pin]\nmaterial = { young = \"210 GPa\", poisson = 0.3 } # steel\n\
                        profile.sphere = { radius = \"50 mm\" }\n[motion.sliding]\nload = \"10 N\"\n";

    fn changed(key: &str, value: &str) -> Option<String> {
        let file = CaseFile::from_text("case.toml", TEXT, ".").rewritten(key, value)?;
        Some(file.written_at(key)?.to_owned())
    }

    #[test]
    fn values_are_replaced_with_or_without_quotes_and_remarks_stay() {
        let file = CaseFile::from_text("case.toml", TEXT, ".");
        assert_eq!(file.written_at("motion.sliding.load"), Some("\"10 N\""));
        let steel = "{ young = \"210 GPa\", poisson = 0.3 }";
        assert_eq!(file.written_at("body.pin.material"), Some(steel));
        assert_eq!(changed("motion.sliding.load", "20 N").as_deref(), Some("\"20 N\""));
        assert_eq!(changed("motion.sliding.load", " \"20 N\" ").as_deref(), Some("\"20 N\""));
        let radius = changed("body.pin.profile.sphere.radius", "3 mm");
        assert_eq!(radius.as_deref(), Some("\"3 mm\""));
        let own = changed("body.pin.material", "{ young = 70 GPa, poisson = 0.33 }");
        assert_eq!(own.as_deref(), Some("{ young = \"70 GPa\", poisson = 0.33 }"));
        assert_eq!(
            (changed("body.disc", "x"), changed("motion.sliding.load.x", "x")),
            (None, None)
        );
        let file = file.rewritten("body.pin.material", "100Cr6").unwrap();
        let text = file.to_text();
        assert_eq!(text, TEXT.replace(steel, "\"100Cr6\""));
    }
}
