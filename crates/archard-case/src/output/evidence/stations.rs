//! What the stations lose that a long table leaves out.

use archard::motion::{StationLoss, Table};
use serde::{Deserialize, Serialize};

use crate::verdict::{self, Line};

/// The stations of a table that leaves some out.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Stations {
    /// Those that are gone through, and all.
    counts: [usize; 2],
    /// Load by distance slid that is lost, relative to all of it.
    loss: f64,
    /// How far (m) places are off at most.
    displaced: f64,
    /// How far (m) the contact moves where stations are left out, at most.
    apart: f64,
}

impl Stations {
    /// Those of a table; `None` where none are left out.
    pub fn of(table: &Table) -> Option<Self> {
        let StationLoss { rows, loss, displaced, apart, .. } = table.merged()?;
        Some(Self { counts: [table.rows().len(), rows], loss, displaced, apart })
    }

    /// The lines that follow, of a contact of that width (m) where it is known.
    pub fn lines(&self, width: Option<f64>) -> impl Iterator<Item = Line> + use<> {
        let Self { counts, loss, displaced, apart } = *self;
        let width = width.filter(|width| *width > 0.0);
        let near = width.map(|width| verdict::apart(apart / width));
        [verdict::stations(loss, counts, displaced)].into_iter().chain(near)
    }
}
