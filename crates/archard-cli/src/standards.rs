//! Volumes after test standards, in words.

use archard::problem::ContactProblem;
use archard_case::output::Standard;

use crate::lines::Lines;
use crate::number::four;

/// Difference from the worn volume below which both are called the same: it would be written as 0.0 %.
const SAME: f64 = 5e-4;

/// Adds what standards make of the scar and the track of a test at a row of its history.
pub fn add_all(problem: &ContactProblem, row: &[(String, f64)], lines: &mut Lines) {
    let standards = Standard::of(problem, row);
    for standard in &standards {
        let Standard { name, measured, body, volume, .. } = standard;
        let label = format!("{name}, {measured} ({})", problem.bodies[*body].name);
        let volume = format!("{} mm^3, {}", four(volume * 1e9), beside(standard.difference()));
        lines.add(label, volume, String::new());
    }
    if !standards.is_empty() && problem.bodies.iter().all(|body| body.wear.is_some()) {
        lines.add("", "the formula takes one body to wear; here both do", String::new());
    }
}

/// A relative difference from the worn volume in words.
fn beside(difference: f64) -> String {
    let (ratio, percent) = (1.0 + difference, 100.0 * difference.abs());
    match difference {
        same if same.abs() < SAME => "as worn".to_owned(),
        _ if !(0.5..2.0).contains(&ratio) => format!("{ratio:.2} times what is worn"),
        more if more > 0.0 => format!("{percent:.1} % more than worn"),
        _ => format!("{percent:.1} % less than worn"),
    }
}

#[cfg(test)]
mod tests {
    use super::beside;

    #[test]
    fn differences_are_said_in_words() {
        let said = [-0.0301, 0.0719, 1e-5, 6.2, -0.7].map(beside);
        let expected = [
            "3.0 % less than worn",
            "7.2 % more than worn",
            "as worn",
            "7.20 times what is worn",
            "0.30 times what is worn",
        ];
        assert_eq!(said, expected);
    }
}
