//! A checked case of two gears as a case file.

use std::fmt::{self, Display, Formatter};

use super::GearCase;
use crate::case::lines;

impl Display for GearCase {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let [one, two] = &self.gears;
        let friction = self.friction.as_ref();
        lines::print(f, self.title.as_deref(), (one, two), friction, &self.motion, self.until)
    }
}
