//! What further tests would narrow: the interval of a coefficient by the scatter found so far.

use super::effects::factor;
use super::estimate::{Estimate, MANY, OWN};

/// The half of an interval, relative, whose number of tests is said.
pub const WANTED: f64 = 0.05;
/// Most tests that are counted.
const MOST: usize = 1000;

/// What further tests would narrow.
#[derive(Debug, Clone, PartialEq)]
pub struct More {
    /// Numbers of tests, the present one first, and the half of the 95 % interval that is expected of them, relative.
    pub halves: Vec<(usize, f64)>,
    /// Tests for an interval of 5 %; `None` where what all tests have in common is more, or more than a thousand would be needed.
    pub wanted: Option<usize>,
    /// Half of the interval by what all tests have in common, relative: no number of tests is below it.
    pub common: f64,
}

impl Estimate {
    /// What further tests would narrow; `None` of one test: the scatter is unknown.
    pub fn more(&self) -> Option<More> {
        let count = self.tests.len();
        self.between?;
        let sum = |own: bool| -> f64 {
            let parts =
                self.budget.iter().filter(|(source, _)| OWN.contains(&source.as_str()) == own);
            parts.map(|(_, part)| part * part).sum::<f64>().sqrt()
        };
        let (own, common) = (sum(true), factor(MANY) * sum(false));
        let half = |tests: usize| {
            let own = own * (count as f64 / tests as f64).sqrt() * factor(tests as f64 - 1.0);
            own.hypot(common).exp_m1()
        };
        let wanted = (common.exp_m1() < WANTED)
            .then(|| (count..=MOST).find(|&tests| half(tests) <= WANTED))
            .flatten();
        let tests = [count, count + 1, count + 2, 2 * count, 4 * count, 8 * count];
        let mut halves: Vec<(usize, f64)> = tests.map(|tests| (tests, half(tests))).to_vec();
        halves.dedup();
        Some(More { halves, wanted, common: common.exp_m1() })
    }
}

impl More {
    /// In words.
    pub fn in_words(&self) -> String {
        let percent = |own: f64| format!("{:.0} %", 100.0 * own);
        let halves = self.halves.iter().map(|(tests, half)| format!("{tests}: {}", percent(*half)));
        let halves = halves.collect::<Vec<_>>().join(", ");
        let wanted = match self.wanted {
            Some(tests) => format!("{} take {tests} tests", percent(WANTED)),
            None if self.common >= WANTED => {
                format!("what all tests have in common leaves {}", percent(self.common))
            }
            None => format!("{} take more than {MOST} tests", percent(WANTED)),
        };
        format!("half of the interval by number of tests {halves}; {wanted}")
    }
}

#[cfg(test)]
mod tests {
    use crate::{Expectation, Reading, Study, Test};

    /// Tests read without error: the half of the interval is t s / root n, with Student's t of any table.
    #[test]
    fn more_tests_narrow_as_student_says() {
        let test = |(at, k): (usize, f64)| Test {
            name: at.to_string(),
            load: None,
            readings: vec![Reading {
                line: at as u64,
                quantity: 0,
                progress: 1.0,
                value: k,
                uncertainty: None,
            }],
        };
        let tests: Vec<Test> = [0.8f64, 1.0, 1.25].into_iter().enumerate().map(test).collect();
        let study = Study { quantities: vec!["volume".to_owned()], tests };
        let mut model =
            |_: usize, log_k: f64| -> Result<Vec<Expectation>, std::convert::Infallible> {
                Ok(vec![Expectation { log: log_k, slope: 1.0 }])
            };
        let found = study.estimate((1.0, 1e-9), &[], &mut model).unwrap();
        let more = found.more().unwrap();
        // Logarithms -0.2231, 0, 0.2231.
        let deviation = 1.25f64.ln();
        let half = |t: f64, n: f64| (t * deviation / n.sqrt()).exp_m1();
        for ((tests, found), expected) in
            more.halves.iter().zip([half(4.3027, 3.0), half(3.1824, 4.0), half(2.7764, 5.0)])
        {
            assert!((found / expected - 1.0).abs() < 1e-3, "{tests}: {found} {expected}");
        }
        // t of 80 tests is 1.9905: 0.04966 / ln 1.05 = 1.018; of 83: 1.000.
        let wanted = more.wanted.unwrap();
        assert!((80..=86).contains(&wanted), "{wanted}");
    }
}
