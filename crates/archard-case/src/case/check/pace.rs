//! How long the equations of meshed bodies take, at the pace of this machine.

use std::fmt;
use std::time::Instant;

use faer::Mat;

use archard::numerics::dense::Lu;

/// Operations that are quick on any machine: nothing is said of them, and nothing is measured.
const QUICK: f64 = 1e10;

/// The time to factorise and condense the equations of meshed bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::case) struct Pace {
    /// Operations on numbers.
    operations: f64,
    /// How many this machine does in a second.
    rate: f64,
}

impl Pace {
    /// That of so many operations, measured now; `None` of equations that are quick.
    pub fn of(operations: f64) -> Option<Self> {
        (operations > QUICK).then(|| Self { operations, rate: rate() })
    }

    /// The time (s) that other equations of so many operations take.
    pub fn seconds(&self, operations: f64) -> f64 {
        operations / self.rate
    }
}

impl fmt::Display for Pace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { operations, rate } = self;
        let time = duration(self.seconds(*operations));
        writeln!(
            f,
            "equations         about {time} to factorise and condense, at {:.1e} operations a second as measured now",
            rate
        )
    }
}

/// A time (s) in words.
pub(super) fn duration(seconds: f64) -> String {
    match seconds {
        short if short < 100.0 => format!("{short:.0} s"),
        middle if middle < 6000.0 => format!("{:.0} min", middle / 60.0),
        long => format!("{:.1} h", long / 3600.0),
    }
}

/// Operations a second as a matrix of a thousand unknowns is factorised.
fn rate() -> f64 {
    const SIZE: usize = 1024;
    let near = |row: usize, column: usize| 1.0 / (1 + row.abs_diff(column)) as f64;
    let matrix =
        Mat::from_fn(SIZE, SIZE, |row, column| near(row, column) + f64::from(row == column));
    let begun = Instant::now();
    // Only the time counts.
    let _ = std::hint::black_box(Lu::of(&matrix));
    2.0 / 3.0 * (SIZE as f64).powi(3) / begun.elapsed().as_secs_f64()
}

#[cfg(test)]
mod tests {
    use super::{Pace, duration};

    #[test]
    fn only_what_takes_long_is_measured() {
        assert_eq!(Pace::of(1e9), None);
        let pace = Pace::of(1e13).unwrap();
        // Between a pocket calculator and the largest of machines.
        assert!(pace.rate > 1e6 && pace.rate < 1e14, "{pace:?}");
        let said = Pace { rate: 2e9, ..pace }.to_string();
        assert!(said.contains("about 83 min") && said.contains("as measured now"), "{said}");
        assert_eq!([30.0, 6000.0].map(duration), ["30 s", "1.7 h"]);
    }
}
