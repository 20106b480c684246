//! Numbers as a tribologist reads them.

use archard::motion::Progress;
use archard::parameters::Quantity;
pub use archard_case::verdict::four;

/// An energy (J) in a unit that suits it: "13.85 nJ".
pub fn energy(value: f64) -> String {
    in_one_of(value, [(1.0, "J"), (1e3, "mJ"), (1e6, "uJ"), (1e9, "nJ")])
}

/// A length (m) as a microscope shows it: "1.250 mm", "85.30 um".
pub fn length(value: f64) -> String {
    in_one_of(value, [(1e3, "mm"), (1e6, "um"), (1e9, "nm"), (1e9, "nm")])
}

/// A mass (kg) in a unit that a balance shows: "1.250 mg".
pub fn mass(value: f64) -> String {
    in_one_of(value, [(1e3, "g"), (1e6, "mg"), (1e9, "ug"), (1e12, "ng")])
}

/// A value (SI) in the first unit in which it is no broken part, or in the last; each with its factor from SI.
fn in_one_of(value: f64, units: [(f64, &str); 4]) -> String {
    let suits = |(factor, _): &&(f64, &str)| value == 0.0 || (value * factor).abs() >= 1.0;
    let (factor, unit) = units.iter().find(suits).unwrap_or(&units[3]);
    format!("{} {unit}", four(value * factor))
}

/// A relative error in percent with two significant digits: "0.34 %".
pub fn percent(relative: f64) -> String {
    let percent = 100.0 * relative;
    let decimals = (1.0 - percent.log10().floor()).clamp(0.0, 4.0) as usize;
    format!("{percent:.decimals$} %")
}

/// What the numbers of a line of contact of that length (m) are of.
pub fn of_a_line(extent: f64) -> String {
    let extent = if extent == 1.0 { "1 m".to_owned() } else { length(extent) };
    format!("forces, areas and volumes are those of {extent} of it")
}

/// A number of things that may be done in part: whole if it is, with four significant digits otherwise.
pub fn count(value: f64) -> String {
    let whole = value.round();
    if (value - whole).abs() < 1e-9 * whole.abs().max(1.0) {
        format!("{whole:.0}")
    } else {
        four(value)
    }
}

/// Where a motion is (its own unit): "distance 250.0 mm", "cycle 12", "time 1.500 s".
pub fn progress(progress: Progress, value: f64) -> String {
    let value = match progress.quantity {
        Quantity::Length if value >= 2e3 => format!("{} km", four(value * 1e-3)),
        Quantity::Length if value >= 2.0 => format!("{} m", four(value)),
        Quantity::Length => format!("{} mm", four(value * 1e3)),
        Quantity::Time => format!("{} s", four(value)),
        _ => count(value),
    };
    format!("{} {value}", progress.name)
}

#[cfg(test)]
mod tests {
    use archard::motion::Progress;
    use archard::parameters::Quantity;

    use super::{energy, mass, of_a_line, percent, progress};

    #[test]
    fn errors_have_two_digits() {
        let shown = [0.0033561, 0.0018, 0.0604, 0.271, 1.5, 2e-7].map(percent);
        assert_eq!(shown, ["0.34 %", "0.18 %", "6.0 %", "27 %", "150 %", "0.0000 %"]);
    }

    #[test]
    fn energies_are_readable() {
        let shown = [-0.0, 13.85e-9, 7.757e-6, 13.4e-3, 2.0].map(energy);
        assert_eq!(shown, ["0 J", "13.85 nJ", "7.757 uJ", "13.40 mJ", "2.000 J"]);
    }

    #[test]
    fn lines_say_what_their_numbers_are_of() {
        let shown = [1.0, 20e-3].map(of_a_line);
        let expected = ["1 m", "20.00 mm"];
        let expected =
            expected.map(|one| format!("forces, areas and volumes are those of {one} of it"));
        assert_eq!(shown, expected);
    }

    #[test]
    fn masses_are_those_of_a_balance() {
        let shown = [0.0, 4.71e-8, 1.25e-6, 3e-3].map(mass);
        assert_eq!(shown, ["0 g", "47.10 ug", "1.250 mg", "3.000 g"]);
    }

    #[test]
    fn places_have_the_units_of_their_motion() {
        let measured = |name, quantity| Progress { name, column: name, quantity };
        let cycle = measured("cycle", Quantity::Number);
        assert_eq!(progress(cycle, 12.0), "cycle 12");
        assert_eq!(progress(cycle, 200_000.0), "cycle 200000");
        assert_eq!(progress(cycle, 12.05), "cycle 12.05");
        assert_eq!(progress(measured("time", Quantity::Time), 1.5), "time 1.500 s");
        assert_eq!(progress(measured("distance", Quantity::Length), 0.25), "distance 250.0 mm");
        assert_eq!(progress(measured("distance", Quantity::Length), 12.5), "distance 12.50 m");
        assert_eq!(progress(measured("distance", Quantity::Length), 15e3), "distance 15.00 km");
    }
}
