//! A checked case of a wheel on a rail as a case file.

use std::fmt::{self, Display, Formatter};

use super::{LIMITS, Rolled, WheelRailCase};
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
        for parameter in LIMITS {
            let key = parameter.name;
            match (self.until.number(key), self.until.word(key), parameter.quantity.unit()) {
                (Some(value), _, "") => writeln!(f, "until.{key} = {}", number(value))?,
                (Some(value), _, unit) => writeln!(f, "until.{key} = {}", si(value, unit))?,
                (None, Some(word), _) => writeln!(f, "until.{key} = {}", quoted(word))?,
                (None, None, _) => {}
            }
        }
        Ok(())
    }
}

pub(in crate::case) fn print_body<S>(f: &mut Formatter<'_>, body: &Rolled<S>) -> fmt::Result {
    let Rolled { name, material, hardness, profile, wear } = body;
    let key = format!("body.{name}");
    writeln!(f, "{key}.material.young = {}", si(material.young, "Pa"))?;
    writeln!(f, "{key}.material.poisson = {}", number(material.poisson))?;
    if let Some(hardness) = hardness {
        writeln!(f, "{key}.material.hardness = {}", si(*hardness, "Pa"))?;
    }
    print_chosen(f, &format!("{key}.profile"), profile)?;
    if let Some(wear) = wear {
        print_chosen(f, &format!("{key}.wear"), wear)?;
    }
    writeln!(f)
}
