//! Units a reader of pictures expects.

use archard::motion::Progress;

/// A unit and how many of it are in one SI unit.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Unit {
    /// As shown next to an axis; empty for pure numbers.
    pub(crate) name: String,
    /// Factor from SI.
    pub(crate) factor: f64,
}

impl Unit {
    /// A unit of that name and factor.
    fn new(name: impl Into<String>, factor: f64) -> Self {
        Self { name: name.into(), factor }
    }

    /// Megapascals.
    pub(crate) fn pressure() -> Self {
        Self::new("MPa", 1e-6)
    }

    /// For masses up to `largest` (kg).
    pub(crate) fn mass(largest: f64) -> Self {
        if largest >= 1e-3 { Self::new("g", 1e3) } else { Self::new("mg", 1e6) }
    }

    /// Kelvin.
    pub(crate) fn kelvin() -> Self {
        Self::new("K", 1.0)
    }

    /// For lengths across the contact up to `largest` (m): mm, or µm where those would be tiny.
    pub(crate) fn across(largest: f64) -> Self {
        if largest >= 0.05e-3 { Self::new("mm", 1e3) } else { Self::new("µm", 1e6) }
    }

    /// For depths and approaches up to `largest` (m): µm, or nm or mm where those fit better.
    pub(crate) fn depth(largest: f64) -> Self {
        match largest {
            large if large >= 1e-3 => Self::new("mm", 1e3),
            small if small < 0.05e-6 => Self::new("nm", 1e9),
            _ => Self::new("µm", 1e6),
        }
    }

    /// For forces up to `largest` (N).
    pub(crate) fn force(largest: f64) -> Self {
        match largest {
            large if large >= 1e6 => Self::new("MN", 1e-6),
            large if large >= 1e4 => Self::new("kN", 1e-3),
            small if small < 0.05 && small > 0.0 => Self::new("mN", 1e3),
            _ => Self::new("N", 1.0),
        }
    }

    /// For volumes up to `largest` (m^3).
    pub(crate) fn volume(largest: f64) -> Self {
        Self::by_thousands("mm³", 1e9, largest)
    }

    /// For worn sections up to `largest` (m^2).
    pub(crate) fn section(largest: f64) -> Self {
        Self::by_thousands("mm²", 1e6, largest)
    }

    /// A unit by the power of a thousand that leaves readable numbers.
    fn by_thousands(name: &str, factor: f64, largest: f64) -> Self {
        if largest <= 0.0 {
            return Self::new(name, factor);
        }
        // Between a tenth and a hundred of the unit.
        let digits = (largest * factor).log10() + 1.0;
        let thousands = digits.div_euclid(3.0).min(0.0);
        let power = 3 * thousands as i32;
        let name =
            if power == 0 { name.to_owned() } else { format!("10{} {name}", superscript(power)) };
        Self::new(name, factor * 10f64.powi(-power))
    }

    /// The power of a thousand that leaves readable numbers, of values up to `largest` in a unit that is named elsewhere.
    pub(crate) fn by_powers(largest: f64) -> Self {
        let power = match largest {
            none if none <= 0.0 => 0,
            middle if (0.01..1e4).contains(&middle) => 0,
            other => 3 * (other.log10() / 3.0).floor() as i32,
        };
        let name = if power == 0 { String::new() } else { format!("10{}", superscript(power)) };
        Self::new(name, 10f64.powi(-power))
    }

    /// Per cent.
    pub(crate) fn share() -> Self {
        Self::new("%", 100.0)
    }

    /// For distances slid up to `largest` (m).
    fn distance(largest: f64) -> Self {
        match largest {
            far if far >= 2e3 => Self::new("km", 1e-3),
            far if far >= 2.0 => Self::new("m", 1.0),
            _ => Self::new("mm", 1e3),
        }
    }

    /// What a column of results holds, in words, and its unit, with values up to `largest`.
    pub(crate) fn of_result(column: &str, largest: f64) -> (String, Self) {
        type Chosen = fn(f64) -> Unit;
        let units: [(&str, Chosen); 7] = [
            ("_m2", Self::section),
            ("_m3", Self::volume),
            ("_m", Self::depth),
            ("_N", Self::force),
            ("_kg", Self::mass),
            ("_Pa", |_| Self::pressure()),
            ("_K", |_| Self::kelvin()),
        ];
        let known = units.iter().find_map(|(end, unit)| Some((column.strip_suffix(end)?, unit)));
        match known {
            Some((name, unit)) => (phrase(name), unit(largest)),
            None => (phrase(column), Self::by_powers(largest)),
        }
    }

    /// What a key of a case holds, in words, and its unit, with values up to `largest`.
    pub(crate) fn of_key(column: &str, largest: f64) -> (String, Self) {
        match column {
            far if far.ends_with("_m") && largest >= 2.0 => (phrase(far), Self::distance(largest)),
            stiff if stiff.ends_with("_Pa") && largest >= 5e9 && !stiff.ends_with("_per_Pa") => {
                (phrase(stiff.trim_end_matches("_Pa")), Self::new("GPa", 1e-9))
            }
            wear if wear.ends_with("_per_Pa") => (
                phrase(wear.trim_end_matches("_per_Pa")),
                Self::by_thousands("mm³/(N m)", 1e9, largest),
            ),
            other => Self::of_result(other, largest),
        }
    }

    /// For readings of worn bodies up to `largest` (SI) that are shown in a unit of that name and factor.
    pub(crate) fn of_readings((name, factor): (&str, f64), largest: f64) -> Self {
        match name {
            "um" => Self::depth(largest),
            "mm" => Self::across(largest),
            "mg" => Self::mass(largest),
            "mm2" if largest < 1e-9 => Self::new("µm²", 1e12),
            "mm2" => Self::section(largest),
            "mm3" => Self::volume(largest),
            _ => Self::new(name, factor),
        }
    }

    /// For a column whose name ends in its SI unit, with values up to `largest`.
    pub(crate) fn of_column(column: &str, largest: f64) -> Self {
        if column.ends_with("_m") {
            Self::distance(largest)
        } else if column.ends_with("_s") {
            Self::new("s", 1.0)
        } else if column == Progress::SHARE.column {
            Self::share()
        } else {
            Self::new("", 1.0)
        }
    }

    /// "what (unit)".
    pub(crate) fn label(&self, what: &str) -> String {
        if self.name.is_empty() { what.to_owned() } else { format!("{what} ({})", self.name) }
    }

    /// A value (SI) with this unit, to three digits.
    pub(crate) fn show(&self, value: f64) -> String {
        format!("{} {}", plain(value * self.factor), self.name).trim_end().to_owned()
    }
}

/// A number to three digits.
pub(crate) fn plain(value: f64) -> String {
    let decimals = match value.abs() {
        large if large >= 100.0 || large == 0.0 => 0,
        middle => (2 - middle.log10().floor() as i32).clamp(0, 9) as usize,
    };
    let digits = format!("{value:.decimals$}");
    match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => digits,
    }
}

/// A whole number in raised digits.
pub(crate) fn superscript(number: i32) -> String {
    let raise = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    number.to_string().chars().map(raise).collect()
}

/// A tick without superfluous zeros.
pub(crate) fn tick(value: f64) -> String {
    let rounded = format!("{value:.4}");
    let short = rounded.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.replace('-', "\u{2212}") }
}

/// A tick of a logarithmic axis: a power of ten, or nothing between two of them.
pub(crate) fn tick_of_decades(value: f64) -> String {
    let power = value.log10();
    let whole = (power - power.round()).abs() < 1e-6;
    if whole { format!("10{}", superscript(power.round() as i32)) } else { String::new() }
}

/// A column name as a phrase: "share" is "Share", "distance_m" is "Distance".
pub(crate) fn phrase(column: &str) -> String {
    let words = column.strip_suffix("_m").or(column.strip_suffix("_s")).unwrap_or(column);
    let words = words.replace('_', " ");
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::{Unit, phrase, tick, tick_of_decades};

    #[test]
    fn volumes_keep_readable_numbers() {
        let small = Unit::volume(6.8e-13);
        assert_eq!(small.name, "10⁻³ mm³");
        assert!((small.factor * 6.8e-13 - 0.68).abs() < 1e-12);
        assert_eq!(Unit::volume(2e-9).name, "mm³");
        assert_eq!(Unit::volume(2e-3).name, "mm³");
        assert_eq!(Unit::section(9e-8).name, "10⁻³ mm²");
    }

    /// A section of 61 um^2 has no tick labels of zero.
    #[test]
    fn units_follow_what_was_read() {
        let unit = |name, factor, largest| Unit::of_readings((name, factor), largest).name;
        assert_eq!(unit("mm2", 1e6, 61e-12), "µm²");
        assert_eq!(unit("mm2", 1e6, 3e-9), "10⁻³ mm²");
        assert_eq!(unit("mm", 1e3, 20e-6), "µm");
        assert_eq!(unit("mm", 1e3, 0.5e-3), "mm");
        assert_eq!(unit("mm3", 1e9, 4.6e-14), "10⁻⁶ mm³");
        let (name, unit) = Unit::of_result("worn_volume_ball_m3", 2e-9);
        assert_eq!((&*name, &*unit.name), ("Worn volume ball", "mm³"));
        assert_eq!(Unit::of_result("revolutions", 30.0).0, "Revolutions");
    }

    #[test]
    fn values_are_short() {
        let mm = Unit::of_column("distance_m", 0.5);
        assert_eq!(mm.show(0.5), "500 mm");
        assert_eq!(mm.show(0.0), "0 mm");
        assert_eq!(mm.show(0.00123456), "1.23 mm");
        assert_eq!(Unit::of_column("share", 1.0).show(0.25), "25 %");
        assert_eq!(Unit::of_column("distance_m", 110.0).show(110.0), "110 m");
        assert_eq!(Unit::of_column("distance_m", 5e3).show(500.0), "0.5 km");
        assert_eq!(tick(-0.00001), "0");
        assert_eq!(tick(0.5), "0.5");
        assert_eq!([1e-12, 2e-12, 10.0].map(tick_of_decades), ["10⁻¹²", "", "10¹"]);
        assert_eq!(phrase("share"), "Share");
        assert_eq!(phrase("distance_m"), "Distance");
        assert_eq!(Unit::of_column("time_s", 9.0).label(&phrase("time_s")), "Time (s)");
    }
}
