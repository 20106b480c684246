//! How much is told of what is wrong: as much as a screen shows.

/// Lines and columns of the usual terminal, since the DEC VT100. More problems than lines have few causes, each is looked up in the
/// whole case, and nobody reads a message of more than a screen.
const LINES: usize = 24;
const COLUMNS: usize = 80;

/// Most problems of a case that are looked up and told.
pub(super) const PROBLEMS: usize = LINES;

/// A message of a screen at most: of a longer one, as it comes of a name or a list without end, the middle is left out.
#[must_use]
pub fn told(text: String) -> String {
    const MOST: usize = LINES * COLUMNS;
    // It has no more characters than bytes.
    let count = if text.len() <= MOST { 0 } else { text.chars().count() };
    if count <= MOST {
        return text;
    }
    let start: String = text.chars().take(MOST / 2).collect();
    let end: String = text.chars().skip(count - MOST / 2).collect();
    format!("{start} ... {end}")
}

#[cfg(test)]
mod tests {
    use super::{COLUMNS, LINES, told};

    #[test]
    fn both_ends_of_a_long_message_are_told() {
        let whole = "µ".repeat(LINES * COLUMNS);
        assert_eq!(told(whole.clone()), whole);
        let long = format!("a{}b", "µ".repeat(1_000_000));
        let short = told(long);
        assert!(short.starts_with("aµ") && short.ends_with("µb") && short.contains(" ... "));
        assert_eq!(short.chars().count(), LINES * COLUMNS + 5);
    }
}
