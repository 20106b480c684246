//! A checked case of a wheel on a rail as a case file.

use std::fmt::{self, Display, Formatter};

use archard::body::Thermal;
use archard::parameters::{Parameter, Values};

use super::{LIMITS, ProfiledPart, REPROFILING, WheelRailCase};
use crate::case::print::{number, print_chosen, quoted, si};

impl Display for WheelRailCase {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if let Some(title) = &self.title {
            writeln!(f, "title = {}\n", quoted(title))?;
        }
        print_body(f, &self.wheel)?;
        print_body(f, &self.rail)?;
        if let Some(elements) = self.elements {
            writeln!(f, "frame.elements = {elements}")?;
        }
        print_chosen(f, "friction", &self.friction)?;
        print_chosen(f, "motion", &self.motion)?;
        print_values(f, "until", &self.until, LIMITS)?;
        print_values(f, "reprofiling", &self.reprofiling, REPROFILING)
    }
}

/// The values of a section.
fn print_values(
    f: &mut Formatter<'_>,
    section: &str,
    values: &Values,
    parameters: &[Parameter],
) -> fmt::Result {
    for parameter in parameters {
        let key = parameter.name;
        match (values.number(key), values.word(key), parameter.quantity.unit()) {
            (Some(value), _, "") => writeln!(f, "{section}.{key} = {}", number(value))?,
            (Some(value), _, unit) => writeln!(f, "{section}.{key} = {}", si(value, unit))?,
            (None, Some(word), _) => writeln!(f, "{section}.{key} = {}", quoted(word))?,
            (None, None, _) => {}
        }
    }
    Ok(())
}

pub(in crate::case) fn print_body<S>(f: &mut Formatter<'_>, body: &ProfiledPart<S>) -> fmt::Result {
    let ProfiledPart { name, material, hardness, thermal, profile, wear, flange_wear, cracks } =
        body;
    let key = format!("body.{name}");
    writeln!(f, "{key}.material.young = {}", si(material.young, "Pa"))?;
    writeln!(f, "{key}.material.poisson = {}", number(material.poisson))?;
    if let Some(hardness) = hardness {
        writeln!(f, "{key}.material.hardness = {}", si(*hardness, "Pa"))?;
    }
    for (parameter, value) in thermal.iter().flat_map(Thermal::values) {
        let value = si(value, parameter.quantity.unit());
        writeln!(f, "{key}.thermal.{} = {value}", parameter.name)?;
    }
    print_chosen(f, &format!("{key}.profile"), profile)?;
    if let Some(wear) = wear {
        print_chosen(f, &format!("{key}.wear"), wear)?;
    }
    if let Some(wear) = flange_wear {
        print_chosen(f, &format!("{key}.flange_wear"), wear)?;
    }
    if let Some(cracks) = cracks {
        print_chosen(f, &format!("{key}.cracks"), cracks)?;
    }
    writeln!(f)
}
