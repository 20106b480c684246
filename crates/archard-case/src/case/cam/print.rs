//! A checked case of a cam and its follower as a case file.

use std::fmt::{self, Display, Formatter};

use super::CamCase;
use crate::case::lines;

impl Display for CamCase {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let friction = self.friction.as_ref();
        let bodies = (&self.cam, &self.follower);
        lines::print(f, self.title.as_deref(), bodies, friction, &self.motion, self.until)
    }
}
