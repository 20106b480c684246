//! Lines of a verdict in words, with their numbers as people write them.

use super::{Bound, Line, Word};

/// How a number is written.
#[derive(Clone, Copy)]
enum Number {
    /// A part of a whole, in percent; a tiny one by its power of ten.
    Share,
    /// What is left of an equation, which is rounding at best.
    Residual,
    /// A pure number.
    Plain,
    /// Yes or no, which words say.
    Unsaid,
}

/// What a good line says, by its subject; its number stands at `{}`, what it is said of any other at `{text}`.
const GOOD: [(&str, &str, Number); 50] = [
    ("load", "load met to {}", Number::Residual),
    ("edges", "{} of the load at the edge of the frame", Number::Share),
    ("elements", "{} elements across the first contact", Number::Plain),
    ("contact", "{} elements across the contact", Number::Plain),
    ("stick zone", "{} elements across the stick zone", Number::Plain),
    ("time", "error by steps in time {}", Number::Share),
    ("accuracy", "{} {text}", Number::Share),
    ("energy", "work and dissipation of a cycle agree to {}", Number::Residual),
    ("touch", "{} of the solves left unsettled before touch", Number::Share),
    ("volume", "volume closes to {}", Number::Residual),
    ("heat", "smallest Peclet number {}", Number::Plain),
    ("pressures", "pressures ragged by {} of the peak", Number::Share),
    ("forces", "forces balance to {}", Number::Residual),
    ("moments", "moments balance to {}", Number::Residual),
    ("bending", "longest element {} of the thickness that bends", Number::Share),
    ("conformity", "the normal of the rail turns by {} degrees within a patch", Number::Plain),
    ("hardness", "largest pressure {} times the hardness", Number::Plain),
    ("strain", "largest pressure {} of Young's modulus", Number::Share),
    ("layers", "{} of a layer worn off", Number::Share),
    ("half-space", "contact reaches {} of the smallest radius", Number::Share),
    ("form", "profiles differ from circles by {} of the gap", Number::Share),
    ("slope", "the bodies slope by {} at the edge of the contact", Number::Plain),
    ("line", "line {} times as long as wide", Number::Plain),
    ("temperature", "warmest place at {} K", Number::Plain),
    ("creepage", "creepage {}", Number::Share),
    ("friction", "coefficient of friction {}", Number::Plain),
    ("complete", "the run came to its end", Number::Unsaid),
    ("warning", "no warning", Number::Unsaid),
    ("stated", "largest stated error {}", Number::Share),
    ("run", "the run can be believed", Number::Unsaid),
    ("settled", "runs and readings agree on the coefficients", Number::Unsaid),
    ("law's shape", "{text}", Number::Unsaid),
    ("constant k", "{text}", Number::Unsaid),
    ("next test", "the tests say where the next will lie", Number::Unsaid),
    ("missing", "{} of the points without a height", Number::Share),
    ("flange", "no contact above the steepest place of the flange", Number::Unsaid),
    ("climb", "lateral over vertical force {} of Nadal's limit", Number::Share),
    ("lateral", "lateral forces off those of the history by {} of the load", Number::Share),
    ("image", "image field known to {}", Number::Share),
    ("shakedown", "largest pressure {} of the shakedown limit", Number::Share),
    ("yield", "largest equivalent stress {} of the yield strength", Number::Share),
    ("shares", "pairs of teeth bear the load to {}", Number::Residual),
    ("flanks", "wear displaces the contact by {} of the pitch", Number::Share),
    ("tip", "no gear is deepest at a tip", Number::Unsaid),
    ("history", "points of the route lose {} of the history", Number::Share),
    ("stations", "{} {text}", Number::Share),
    ("apart", "the contact moves by {} of its width where stations are left out", Number::Share),
    ("worn shape", "worn shapes change the deepest wear by {}", Number::Share),
    ("strips", "strips neglect {} of the load of one", Number::Share),
    ("mesh", "displacements known to {} with these tetrahedra", Number::Share),
];

/// The place of a subject among all.
pub(crate) fn place_of(subject: &str) -> Option<u8> {
    GOOD.iter().position(|(own, ..)| *own == subject)?.try_into().ok()
}

/// The subject at a place.
pub(crate) fn subject_at(place: u8) -> Option<&'static str> {
    GOOD.get(usize::from(place)).map(|(subject, ..)| *subject)
}

/// A residual that is nothing but rounding.
const ROUNDING: f64 = 1e-12;
/// The least share that is written in percent.
const LEAST: f64 = 1e-4;

impl Number {
    fn write(self, value: f64) -> String {
        match self {
            Number::Unsaid => String::new(),
            _ if !value.is_finite() => value.to_string(),
            Number::Residual if value.abs() < ROUNDING => "rounding".to_owned(),
            Number::Plain => plain(value),
            Number::Share | Number::Residual if value == 0.0 => "0 %".to_owned(),
            Number::Share | Number::Residual if value.abs() < LEAST => format!("{value:.0e}"),
            Number::Share | Number::Residual => format!("{} %", two(100.0 * value)),
        }
    }
}

/// A part of a whole: "0.34 %".
pub(super) fn share(value: f64) -> String {
    Number::Share.write(value)
}

/// Two significant digits, without an exponent.
fn two(value: f64) -> String {
    let decimals = (1.0 - value.abs().log10().floor()).max(0.0) as usize;
    let digits = format!("{value:.decimals$}");
    match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => digits,
    }
}

/// A pure number: whole if it is or is large.
fn plain(value: f64) -> String {
    let whole = value == value.round() || value.abs() >= 100.0;
    match value != 0.0 && !(1e-3..1e6).contains(&value.abs()) {
        true => format!("{value:.1e}"),
        false if whole => format!("{value:.0}"),
        false => two(value),
    }
}

impl Line {
    /// What was found, in words: the number of a good line; of any other what it means, its bound, and what to do.
    pub fn finding(&self) -> String {
        let known = GOOD.iter().find(|(subject, ..)| *subject == self.subject);
        let number = known.map_or(Number::Plain, |(_, _, number)| *number);
        let (side, bounds) = match self.bound {
            Bound::AtMost(bounds) => ("up to", bounds),
            Bound::AtLeast(bounds) => ("from", bounds),
        };
        // A bound that is rounding at best is still written as a number.
        let bound = match number {
            Number::Plain => plain(bounds[0]),
            _ => share(bounds[0]),
        };
        let value = number.write(self.value);
        match known {
            Some((_, _, Number::Unsaid)) if self.word() != Word::Good => self.text.clone(),
            _ if self.word() != Word::Good => {
                format!("{value} {} (good {side} {bound})", self.text)
            }
            Some((_, words, _)) => words.replace("{}", &value).replace("{text}", &self.text),
            None => format!("{value}, good {side} {bound}"),
        }
    }

    /// The line with its subject, and with its word where it is not good.
    pub fn in_words(&self) -> String {
        let word = match self.word() {
            Word::Good => String::new(),
            word => format!("{}: ", word.text()),
        };
        format!("{:<16}{word}{}", self.subject, self.finding())
    }
}

impl std::fmt::Display for Line {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.subject, self.finding())
    }
}

#[cfg(test)]
mod tests {
    use crate::verdict::{self, Accuracy, Bound, Line, Word};

    const ACCURACY: Accuracy =
        Accuracy { error: 0.003356, largest: 0.004, asked: 0.01, worst: None, other: None };

    /// What an error is of is said, and what has a larger one than all that count.
    #[test]
    fn the_worst_quantity_has_its_name() {
        let accuracy = Accuracy {
            worst: Some("wear_depth_pin_m".to_owned()),
            other: Some(("peak_pressure_Pa".to_owned(), 0.025)),
            ..ACCURACY
        };
        let expected = "0.34 % estimated error of `wear_depth_pin_m` at the end, 1 % asked; up to 0.4 % at outputs before it; `peak_pressure_Pa`, which does not count, has 2.5 %";
        assert_eq!(verdict::accuracy(&accuracy).finding(), expected);
    }

    #[test]
    fn good_lines_are_short_and_their_numbers_sensible() {
        let said = [
            verdict::load(4.441e-16),
            verdict::volume(1.2e-9),
            verdict::volume(3.4e-3),
            verdict::accuracy(&ACCURACY),
            verdict::edges(0.0, 0),
            verdict::contact(54.0),
            verdict::roughness(2.76e-4),
            verdict::heat(123.4),
        ]
        .map(|line| line.finding());
        let expected = [
            "load met to rounding",
            "volume closes to 1e-9",
            "volume closes to 0.34 %",
            "0.34 % estimated error at the end, 1 % asked; up to 0.4 % at outputs before it",
            "0 % of the load at the edge of the frame",
            "54 elements across the contact",
            "pressures ragged by 0.028 % of the peak",
            "smallest Peclet number 123",
        ];
        assert_eq!(said, expected);
    }

    #[test]
    fn other_lines_say_what_it_means_and_what_is_good() {
        let line = verdict::edges(0.0123, 12);
        let finding = "1.2 % of the load at the edge of the frame, on 12 elements: enlarge `frame.size`, or the zone of the mesh (good up to 0 %)";
        assert_eq!(line.finding(), finding);
        assert_eq!(line.in_words(), format!("edges           doubtful: {finding}"));
        assert_eq!(line.to_string(), format!("edges: {finding}"));
        let stopped = verdict::complete("interrupted").finding();
        assert_eq!(stopped, "the run stopped before its end: interrupted");
        let few = verdict::contact(4.0).finding();
        assert!(few.starts_with("4 elements across the contact") && few.ends_with("(good from 6)"));
        let other = Line::new("other", 3.0, Bound::AtMost([5.0, 9.0]), "of something");
        assert_eq!(other.finding(), "3, good up to 5");
        let missing = Line::new("load", f64::NAN, Bound::AtMost([1e-5, 1e-3]), "off");
        assert_eq!(missing.finding(), "NaN off (good up to 1e-5)");
    }

    /// Every line there is has words of its own where it is good.
    #[test]
    fn all_lines_have_words() {
        let [forces, moments] = verdict::balance(0.1, 0.1);
        let all = [
            verdict::load(0.0),
            verdict::edges(0.0, 0),
            verdict::first_contact(20.0),
            verdict::contact(20.0),
            verdict::stick_zone(20.0),
            verdict::time(1e-3, 1e-2),
            verdict::accuracy(&ACCURACY),
            verdict::energy(1e-3),
            verdict::touch(1e-3),
            verdict::volume(1e-3),
            verdict::heat(20.0),
            verdict::roughness(1e-3),
            forces,
            moments,
            verdict::slenderness(0.5),
            verdict::conformity(3.0),
            verdict::hardness(0.5, "pin"),
            verdict::modulus(0.01, "pin"),
            verdict::layers(0.05, "disc"),
            verdict::radius(0.1, "pin"),
            verdict::form(0.01),
            verdict::slope(0.1),
            verdict::length(20.0),
            verdict::temperature(400.0),
            verdict::creepage(0.01),
            verdict::friction(0.3),
            verdict::stated(0.01, "peak_pressure_Pa"),
            verdict::climbs(0),
            verdict::gathered(0.01),
            verdict::stations(0.01, [100, 1000], 1e-6),
            verdict::apart(0.1),
            verdict::strips(0.01),
            verdict::reshaped(0.01, "cam"),
            verdict::yields(0.5, "flat"),
            verdict::shared(1e-3),
            verdict::flanks(0.01),
            verdict::tip("pinion"),
            verdict::nadal(0.2),
            verdict::lateral(0.05, "the left wheel at point 3"),
            verdict::shakedown(0.2, "rail"),
            verdict::measured(0.01, "depth"),
            verdict::of_run(Word::Good, ""),
            verdict::missing(0.0),
            verdict::settled(Word::Good, ""),
            verdict::shape(Word::Good, "exponent 1.01"),
            verdict::constant(Word::Good, "exponent 0.01"),
            verdict::next_test(true, "k"),
        ];
        for line in all {
            assert!(!line.finding().contains("good"), "{line}");
        }
    }
}
