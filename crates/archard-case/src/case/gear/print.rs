//! A checked case of two gears as a case file.

use std::fmt::{self, Display, Formatter};

use super::GearCase;
use crate::case::lines;

impl Display for GearCase {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let [one, two] = &self.gears;
        let how = (self.friction.as_ref(), &self.motion);
        lines::print(f, self.title.as_deref(), (one, two), how, self.until)
    }
}
