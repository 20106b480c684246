//! Lines of a name, a value and its error, in columns.

use crate::failure::Failure;
use crate::say::say;

/// The least width of the names.
const NAMES: usize = 18;

/// Lines that are printed below each other.
#[derive(Debug, Default)]
pub struct Lines(Vec<[String; 3]>);

impl Lines {
    /// Adds a line; the error may be empty.
    pub fn add(&mut self, name: impl Into<String>, value: impl Into<String>, error: String) {
        self.0.push([name.into(), value.into(), error]);
    }

    /// Says all of them.
    pub fn say(&self) -> Result<(), Failure> {
        self.shown().iter().try_for_each(|line| say(line))
    }

    /// The lines: values begin below each other, and so do errors.
    fn shown(&self) -> Vec<String> {
        let width = |column: usize, of: &dyn Fn(&&[String; 3]) -> bool| {
            let cells = self.0.iter().filter(|line| of(line));
            cells.map(|line| line[column].chars().count() + 2).max().unwrap_or(0)
        };
        let names = width(0, &|_| true).max(NAMES);
        let values = width(1, &|line| !line[2].is_empty());
        let shown = |[name, value, error]: &[String; 3]| match error.is_empty() {
            true => format!("{name:<names$}{value}"),
            false => format!("{name:<names$}{value:<values$}{error}"),
        };
        self.0.iter().map(shown).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Lines;

    #[test]
    fn columns_stand_below_each_other() {
        let mut lines = Lines::default();
        lines.add("peak pressure", "15.91 MPa", "+- 3.1 %".to_owned());
        lines.add("worn volume (pin)", "6.783e-4 mm^3", "+- 0.18 %".to_owned());
        lines.add("time", "a value that is longer than all others", String::new());
        let expected = [
            "peak pressure      15.91 MPa      +- 3.1 %",
            "worn volume (pin)  6.783e-4 mm^3  +- 0.18 %",
            "time               a value that is longer than all others",
        ];
        assert_eq!(lines.shown(), expected);
    }
}
