//! A checked case of a cam and its follower as a case file.

use std::fmt::{self, Display, Formatter};

use super::CamCase;
use crate::case::lines;

impl Display for CamCase {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let how = (self.friction.as_ref(), &self.motion);
        let bodies = (&self.cam, &self.follower);
        lines::print(f, self.title.as_deref(), bodies, how, self.until)
    }
}
