use approx::assert_relative_eq;
use proptest::prelude::*;

use super::{Dimension, Error, Measure, Scale, measured, read};

#[test]
fn every_notation_of_a_length_is_the_same_number() {
    for text in
        ["0.45 mm", "0.45mm", "450 um", "450 \u{b5}m", "450 \u{3bc}m", "0.00045 m", "45e-3 cm"]
    {
        assert_eq!(read(text, &Measure::LENGTH), Ok(0.45e-3), "{text}");
    }
}

#[test]
fn wear_coefficients_in_all_their_units() {
    let texts = [
        "1.33e-13 1/Pa",
        "1.33e-13/Pa",
        "1.33e-13 Pa^-1",
        "1.33e-7 1/MPa",
        "1.33e-7 MPa^-1",
        "1.33e-7 MPa⁻¹",
        "1.33e-7 mm^2/N",
        "1.33e-7 mm²/N",
        "1.33e-4 mm^3/(N m)",
        "1.33e-4 mm3/(N m)",
        "1.33e-4 mm3/(N·m)",
        "1.33e-4 mm3/(N*m)",
        "1.33e-4 mm3/Nm",
        "1.33e-4 mm^3/N/m",
        "1.33e-4 mm^3 N^-1 m^-1",
        "1.33e-4 mm³·N⁻¹·m⁻¹",
    ];
    for text in texts {
        assert_eq!(read(text, &Measure::WEAR_COEFFICIENT), Ok(1.33e-13), "{text}");
    }
}

#[test]
fn pressures_and_forces() {
    for text in ["210 GPa", "2.1e5 N/mm^2", "210000 MPa", "2.1e6 bar", "210e9 kg/(m s^2)"] {
        assert_eq!(read(text, &Measure::PRESSURE), Ok(2.1e11), "{text}");
    }
    assert_eq!(read("0.0102 kN", &Measure::FORCE), Ok(10.2));
    assert_eq!(read("10.2 kg m/s^2", &Measure::FORCE), Ok(10.2));
}

#[test]
fn a_symbol_of_its_own_goes_before_a_prefixed_one() {
    let measure = |dimension| Measure { dimension, ..Measure::LENGTH };
    assert_eq!(read("2 min", &measure(Dimension::TIME)), Ok(120.0));
    let rotation = Dimension::ANGLE.times(Dimension::TIME.to_the(-1.0));
    let radians = read("30 rev/min", &measure(rotation)).unwrap();
    assert_relative_eq!(radians, std::f64::consts::PI, epsilon = 1e-15);
}

#[test]
fn broken_powers_of_length() {
    let measure = Measure::length_to_the(-1.5);
    assert_relative_eq!(read("2 mm^-1.5", &measure).unwrap(), 2.0 * 10f64.powf(4.5));
    assert_eq!(read("2 1/mm^3", &Measure::length_to_the(-3.0)), Ok(2e9));
    assert_eq!(read("2 mm^(-3)", &Measure::length_to_the(-3.0)), Ok(2e9));
}

#[test]
fn messages_say_what_is_expected() {
    let message = |text, measure: &Measure| read(text, measure).unwrap_err().to_string();
    assert_eq!(
        message("50 mm", &Measure::PRESSURE),
        "expected a pressure (for example \"210 GPa\"), found a length"
    );
    assert_eq!(message("50", &Measure::LENGTH), "needs a unit: write \"50 mm\" or \"50 m\"");
    assert_eq!(
        message("wide", &Measure::LENGTH),
        "expected a length (for example \"50 mm\"), found `wide`"
    );
    assert_eq!(
        message("5 furlong", &Measure::LENGTH),
        "`furlong` is not a known unit; a length is written like \"50 mm\""
    );
    assert_eq!(
        message("5 mm^", &Measure::LENGTH),
        "cannot read the unit `mm^`: `^` needs a number behind it"
    );
    assert_eq!(message("1e999 mm", &Measure::LENGTH), "`1e999` is not a finite number");
    assert!(matches!(read("nan mm", &Measure::LENGTH), Err(Error::NoNumber { .. })));
}

#[test]
fn anything_with_a_unit_of_si_can_be_read() {
    let work = Measure::in_si("a work per area", "J/m^2").expect("a unit");
    assert_eq!(read("2 mJ/mm^2", &work).unwrap(), 2e3);
    assert_eq!(read("3 N/m", &work).unwrap(), 3.0);
    for (wrong, said) in [
        ("5", "needs a unit: write \"5 J/m^2\""),
        ("5 Pa", "expected a work per area (for example \"1 J/m^2\"), found a pressure"),
    ] {
        assert_eq!(read(wrong, &work).unwrap_err().to_string(), said);
    }
    for unit in ["mJ/mm^2", "rpm", "J/m^", "widgets"] {
        assert_eq!(Measure::in_si("anything", unit), None, "{unit}");
    }
}

#[test]
fn values_may_say_themselves_what_they_measure() {
    assert_eq!(measured("30 MPa"), Ok((3e7, Dimension::PRESSURE)));
    assert_eq!(measured(" 2e-4 mm^3/(N m)"), Ok((2e-13, Dimension::WEAR_COEFFICIENT)));
    assert_eq!(measured("4"), Ok((4.0, Dimension::NUMBER)));
    let message = |text| measured(text).unwrap_err().to_string();
    assert_eq!(
        message("5 furlong"),
        "`furlong` is not a known unit; a number, or one with its unit is written like \"30 MPa\""
    );
    assert_eq!(
        message("wide"),
        "expected a number, or one with its unit (for example \"30 MPa\"), found `wide`"
    );
    assert_eq!(message("1,5 m"), "`1,5 m`: write a decimal point, not a comma");
    assert_eq!(message("1e999 m"), "`1e999` is not a finite number");
}

#[test]
fn columns_share_a_scale() {
    let scale = Scale::read("um", &Measure::LENGTH).unwrap();
    assert_eq!(scale.apply(" 450 "), Some(0.45e-3));
    assert_eq!(["", "nan", "inf", "12 mm", "a"].map(|text| scale.apply(text)), [None; 5]);
}

proptest! {
    #[test]
    fn a_change_of_unit_changes_no_bit(mantissa in -999_999_999i64..=999_999_999, exponent in -40i32..40) {
        let metres = read(&format!("{mantissa}e{exponent} m"), &Measure::LENGTH);
        for (unit, tens) in [("km", 3), ("mm", -3), ("um", -6), ("nm", -9)] {
            let text = format!("{mantissa}e{}{unit}", exponent - tens);
            prop_assert_eq!(read(&text, &Measure::LENGTH), metres.clone());
        }
    }

    #[test]
    fn printed_numbers_come_back(value in proptest::num::f64::NORMAL) {
        prop_assert_eq!(read(&format!("{value:e} Pa"), &Measure::PRESSURE), Ok(value));
        prop_assert_eq!(read(&format!("{value} Pa"), &Measure::PRESSURE), Ok(value));
    }

    #[test]
    fn no_text_panics(text in "\\PC{0,24}", unit in "[-0-9 a-zA-Zµ^/()*·²⁻.]{0,16}") {
        let _ = read(&text, &Measure::LENGTH);
        let _ = read(&format!("1 {unit}"), &Measure::LENGTH);
    }
}

/// Degrees Celsius alone are absolute, in a product a difference.
#[test]
fn temperatures_in_kelvin_and_celsius() {
    for text in ["20 degC", "20 °C", "20degC", "293.15 K", "293150 mK", "0.29315e3 K", "20 1 degC"]
    {
        assert_eq!(read(text, &Measure::TEMPERATURE), Ok(293.15), "{text}");
    }
    assert_eq!(read("-273.15 degC", &Measure::TEMPERATURE), Ok(0.0));
    let conductivity = Measure::in_si("a thermal conductivity", "W/(m K)").unwrap();
    for text in ["50 W/(m K)", "50 W/(m degC)", "50 W/m/°C", "0.05 kW/(m K)", "0.5 W/(cm K)"] {
        assert_relative_eq!(read(text, &conductivity).unwrap(), 50.0, max_relative = 1e-15);
    }
    let known = read("50 W/(m K)", &Measure::SPEED).unwrap_err().to_string();
    assert!(known.ends_with("found a thermal conductivity"), "{known}");
    let column = Scale::read("°C", &Measure::TEMPERATURE).unwrap();
    assert_eq!(column.apply("-20"), Some(253.14999999999998));
}

/// A difference, and a constant that may be one, has to be in K.
#[test]
fn celsius_is_refused_where_a_difference_may_be_meant() {
    let difference = Measure::in_si("a difference of temperatures", "K").unwrap();
    assert_eq!(read("50 K", &difference), Ok(50.0));
    assert_eq!(read("50 degC", &difference), Err(Error::NoAbsolute));
    assert_eq!(measured("50 degC"), Err(Error::NoAbsolute));
    assert_eq!(measured("50 K").map(|one| one.1), Ok(Dimension::TEMPERATURE));
    let per_degree = measured("0.002 1/degC").unwrap();
    assert_eq!(per_degree, (0.002, Dimension::TEMPERATURE.to_the(-1.0)));
    assert!(Measure::in_si("a temperature", "degC").is_none());
}
