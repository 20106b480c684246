//! What the last tractions of a contact make of the inside of meshed bodies.

use std::error::Error as StdError;
use std::path::Path;

use super::elastic::{POINTS, write_points};
use super::table::Table;
use super::{Error, Surface};
use crate::body::Body;
use crate::elastic::{Deformed, ElasticError, Point};
use crate::frame::VectorField;
use crate::simulation::{Observer, Report};

/// The files of displacements, tractions and stresses on the surfaces of body 1 and body 2.
pub(super) const SURFACES: [&str; 2] = ["surface_1.vtu", "surface_2.vtu"];

/// Keeps the last tractions of a run, for the stresses they cause where these are asked for.
#[derive(Debug)]
pub struct Inside {
    points: [Vec<Point>; 2],
    tractions: Option<VectorField>,
}

/// Why stresses inside are not there.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum InsideError {
    /// The body cannot be computed.
    #[error("stresses in `{body}`: {cause}")]
    Body {
        /// The body's name.
        body: String,
        /// What is wrong.
        cause: ElasticError,
    },
    /// A file cannot be written.
    #[error(transparent)]
    Write(#[from] Error),
}

impl Inside {
    /// Stresses at points of body 1 and body 2 (m, in their own coordinates).
    pub fn at(points: [Vec<Point>; 2]) -> Self {
        Self { points, tractions: None }
    }

    /// Writes `points.csv`, a row a point, and for every body with points the fields on its surface,
    /// `surface_1.vtu` or `surface_2.vtu`. The equations of these bodies are made and solved once more.
    ///
    /// # Errors
    /// If a point lies outside of its body, equations have no solution, or a file cannot be written.
    pub fn write(&self, dir: &Path, bodies: [&Body; 2]) -> Result<(), InsideError> {
        let Some(tractions) = &self.tractions else { return Ok(()) };
        let mut table = Table::create(dir.join(POINTS))?;
        for (which, points) in
            self.points.iter().enumerate().filter(|(_, points)| !points.is_empty())
        {
            let body = &bodies[which].name;
            let deformed = Deformed::in_contact(bodies, which, tractions, points)
                .map_err(|cause| InsideError::Body { body: body.clone(), cause })?;
            let Some(deformed) = deformed else { continue };
            Surface::of_elastic(&deformed).write(&dir.join(SURFACES[which]))?;
            write_points(&mut table, &[("body", body.clone())], points, &deformed)?;
        }
        table.flush()?;
        Ok(table.sync()?)
    }
}

impl Observer for Inside {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        if self.points.iter().any(|points| !points.is_empty()) {
            self.tractions = Some(report.state.tractions());
        }
        Ok(())
    }
}
