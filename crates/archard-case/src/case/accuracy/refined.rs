//! What a run takes on the next finer grid, where coarser runs may ask for more elements than it begins with.

use std::fmt;

use crate::case::check::{Parts, Solves, footprint};
use crate::case::resolved::RunnableCase;
use archard::accuracy::{FINER, order};

/// The grid that a run with an accuracy begins with, and the finest that may come next.
#[derive(Debug, Clone, PartialEq)]
pub struct GridRange {
    /// Elements along x and y of the first.
    pub begins: [usize; 2],
    /// Elements along x and y of the next at most, which may be judged too coarse in turn.
    pub elements: [usize; 2],
    /// Contact solves of a run on that one.
    pub solves: Solves,
    /// Its memory (bytes).
    pub memory: f64,
}

impl RunnableCase {
    /// What a run may take that coarser ones find too coarse; `None` where its elements are given.
    pub fn refined(&self) -> Option<GridRange> {
        if !self.chose.elements {
            return None;
        }
        let order = order(&Parts::of(&self.case).ok()?.bodies);
        let case = self.on(&self.grid().finer(FINER[1], order)?).ok()?;
        let parts = Parts::of(&case).ok()?;
        Some(GridRange {
            begins: self.case.frame.elements,
            elements: case.frame.elements,
            solves: Solves::of(&parts),
            memory: footprint::memory(&parts),
        })
    }
}

impl fmt::Display for GridRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { begins: [from_x, from_y], elements: [x, y], solves, memory } = self;
        writeln!(
            f,
            "\nThe run begins with {from_x} x {from_y} elements, as above, and refines them until coarser runs foresee the accuracy.\n\
             The next grid at most:\n"
        )?;
        writeln!(f, "contact solves    {solves}\nelements          {} ({x} x {y})", x * y)?;
        writeln!(f, "memory            about {:.0} MB", (memory * 1e-6).max(1.0))
    }
}
