//! Brackets that are opened in a case and never closed.
//!
//! The errors of the crate `toml` are words alone. Those of its parser `toml_parser` say besides what should have stood
//! there, and a closing bracket alone is what a list, an inline table or a header lacks that never ends.

use toml_parser::parser::{Event, RecursionGuard, parse_document};
use toml_parser::{Expected, ParseError, Source};

/// Lists and tables within each other that are followed; as many as by the crate `toml`.
const DEPTH: u32 = 80;

/// The first list, table or header of a text that never ends, in words.
pub(super) fn unclosed(text: &str) -> Option<String> {
    let tokens = Source::new(text).lex().into_vec();
    let mut errors: Vec<ParseError> = vec![];
    let mut ignored = |_: Event| {};
    parse_document(&tokens, &mut RecursionGuard::new(&mut ignored, DEPTH), &mut errors);
    errors.iter().find_map(|error| match error.expected() {
        Some([Expected::Literal(bracket @ ("]" | "]]" | "}"))]) => {
            Some(format!("{}, expected `{bracket}`", error.description()))
        }
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use super::unclosed;

    #[test]
    fn what_never_ends_is_named() {
        for (text, said) in [
            ("a = [1, 2\n\n[b]\nc = 1\n", "unclosed array, expected `]`"),
            ("a = { b = 1\nc = 2\n", "unclosed inline table, expected `}`"),
            ("a = { b = [1, 2 }\n", "unclosed array, expected `]`"),
            ("[a\nb = 1\n", "unclosed table, expected `]`"),
            ("[[a]\nb = 1\n", "unclosed array table, expected `]`"),
            ("[[a\nb = 1\n", "unclosed array table, expected `]]`"),
        ] {
            assert_eq!(unclosed(text).as_deref(), Some(said), "{text}");
        }
    }

    #[test]
    fn other_mistakes_are_none() {
        for text in [
            "a = [1, 2]\n",
            "a = \"unclosed\n",
            "a = [1,, 2]\n",
            "a = 1 ]\n",
            "unclosed = \nb = 1\n",
            "[]\n",
        ] {
            assert_eq!(unclosed(text), None, "{text}");
        }
    }

    /// The crate `toml` finds the same brackets, wherever the text breaks off, and however deep it goes.
    #[test]
    fn the_words_are_those_of_the_reader() {
        let text = "[[a.b]]\nc = { d = [1, [\"}\", 2]], e = {} }\n[f]\ng = '''h]''' # [{\n";
        let deep = format!("a = {}", "[".repeat(10_000));
        for text in (0..text.len()).map(|end| &text[..end]).chain([&*deep]) {
            let errors = toml::de::DeTable::parse_recoverable(text).1;
            let mut said = errors.iter().map(toml::de::Error::message);
            let first = said.find(|message| message.starts_with("unclosed"));
            assert_eq!(unclosed(text).as_deref(), first, "{text}");
        }
    }
}
