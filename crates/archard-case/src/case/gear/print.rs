//! A checked case of two gears as a case file.

use std::fmt::{self, Display, Formatter};

use super::GearCase;
use crate::case::print::{print_chosen, quoted, si};
use crate::case::wheel_rail::print::print_body;

impl Display for GearCase {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if let Some(title) = &self.title {
            writeln!(f, "title = {}\n", quoted(title))?;
        }
        self.gears.iter().try_for_each(|gear| print_body(f, gear))?;
        if let Some(friction) = &self.friction {
            print_chosen(f, "friction", friction)?;
        }
        print_chosen(f, "motion", &self.motion)?;
        for (gear, limit) in self.gears.iter().zip(self.until) {
            if let Some(depth) = limit {
                writeln!(f, "until.wear_depth_{} = {}", gear.name, si(depth, "m"))?;
            }
        }
        Ok(())
    }
}
