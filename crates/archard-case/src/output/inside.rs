//! What the last tractions of a contact make of the inside of meshed bodies.

use std::error::Error as StdError;
use std::path::Path;

use super::elastic::{POINTS, section_file, write_points, write_sections};
use super::table::Table;
use super::{Error, Manifest, Store, Surface};
use archard::body::{Body, Finite, Material};
use archard::compliance::Unsolved;
use archard::compliance::bem::Boundary;
use archard::compliance::bem::contact::Job;
use archard::elastic::{self, Deformed, ElasticError, Point, Section};
use archard::frame::VectorField;
use archard::simulation::{Observer, Report};

/// The files of displacements, tractions and stresses on the surfaces of body 1 and body 2, where they lie in contact.
pub(super) const SURFACES: [&str; 2] = ["surface_1.vtu", "surface_2.vtu"];

/// Keeps the last tractions and the wear of a run, for the stresses inside where these are asked for.
#[derive(Debug)]
pub struct Inside {
    points: [Vec<Point>; 2],
    sections: [Vec<Section>; 2],
    store: Option<Store>,
    last: Option<(VectorField, [Vec<f64>; 2])>,
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

/// What the files of a body's sections begin with.
fn prefix(body: &str) -> String {
    format!("{body}_")
}

impl Inside {
    /// Stresses at points of body 1 and body 2 (m, in their own coordinates).
    pub fn at(points: [Vec<Point>; 2]) -> Self {
        Self { points, sections: [vec![], vec![]], store: None, last: None }
    }

    /// Stresses on sections of body 1 and body 2 as well.
    #[must_use]
    pub fn on(self, sections: [Vec<Section>; 2]) -> Self {
        Self { sections, ..self }
    }

    /// The same with a store: equations are solved for all tractions of the contact once, and what comes out is kept
    /// there, so that no later run of the body solves them.
    #[must_use]
    pub fn keeping(self, store: Option<Store>) -> Self {
        Self { store, ..self }
    }

    /// The files that [`Inside::write`] writes for bodies of these names, by their names in the folder.
    pub fn files(&self, bodies: [&str; 2]) -> Vec<String> {
        let table = self.points.iter().any(|points| !points.is_empty());
        let mut files: Vec<String> = table.then(|| POINTS.to_owned()).into_iter().collect();
        for (which, body) in bodies.into_iter().enumerate().filter(|(which, _)| self.wants(*which))
        {
            files.push(SURFACES[which].to_owned());
            let sections = &self.sections[which];
            files.extend(sections.iter().map(|one| section_file(&prefix(body), &one.name)));
        }
        files
    }

    /// Whether anything of a body is wanted.
    fn wants(&self, which: usize) -> bool {
        !self.points[which].is_empty() || !self.sections[which].is_empty()
    }

    /// Writes `points.csv`, a row a point, and for every body with points or sections the fields on its surface,
    /// `surface_1.vtu` or `surface_2.vtu`, and a file a section in `sections`. Without a store the equations of these
    /// bodies are made and solved once more.
    ///
    /// # Errors
    /// If a point lies outside of its body, equations have no solution, or a file cannot be written.
    pub fn write(&self, dir: &Path, bodies: [&Body; 2]) -> Result<(), InsideError> {
        let Some((tractions, worn)) = &self.last else { return Ok(()) };
        let any = self.points.iter().any(|points| !points.is_empty());
        let mut manifest = Manifest::read(dir)?;
        let path = any.then(|| manifest.claim(POINTS)).transpose()?;
        let mut table = path.map(Table::create).transpose()?;
        for which in (0..2).filter(|&which| self.wants(which)) {
            let body = &bodies[which].name;
            let solve = |finite: &Finite, material: &Material, job: &Job<'_>, acting: &[f64]| {
                self.solve(finite, material, job, acting)
            };
            let acting = (tractions, &worn[which][..]);
            let wanted = (&self.points[which][..], &self.sections[which][..]);
            let deformed = Deformed::in_contact_by(bodies, which, acting, wanted, &solve)
                .map_err(|cause| InsideError::Body { body: body.clone(), cause })?;
            let Some(deformed) = deformed else { continue };
            let placed = bodies[which].finite.as_ref().is_none_or(|finite| finite.meshed.placed);
            let turned = which == 1 && !placed;
            let surface = Surface::of_elastic(&deformed);
            let surface = if turned { surface.turned_over() } else { surface };
            surface.write(&manifest.claim(SURFACES[which])?)?;
            if let Some(table) = &mut table {
                write_points(table, &[("body", body.clone())], &self.points[which], &deformed)?;
            }
            write_sections(&mut manifest, &prefix(body), &deformed, turned)?;
        }
        if let Some(mut table) = table {
            table.flush()?;
            table.sync()?;
        }
        Ok(())
    }

    /// Displacements and tractions all over a body under tractions of contact.
    fn solve(
        &self,
        finite: &Finite,
        material: &Material,
        job: &Job<'_>,
        acting: &[f64],
    ) -> Result<Boundary, Unsolved> {
        let Some(store) = &self.store else { return elastic::solve(finite, material, job, acting) };
        let responses = store.respond(finite, material, job)?;
        Ok(responses.boundary((job.surface, job.conditions), material, acting))
    }
}

impl Observer for Inside {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        if (0..2).any(|which| self.wants(which)) {
            self.last = Some((
                report.state.tractions(),
                [0, 1].map(|body| report.state.worn(body).into_owned()),
            ));
        }
        Ok(())
    }
}
