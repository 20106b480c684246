//! A case of one body without contact: what to compute, in SI, and what to expect.

use std::fmt::{self, Display, Formatter};

use super::check::{footprint, memory, slender};
use super::definition::{BodyCase, BuildError, FrameCase};
use super::key::Key;
use super::problem::Problem;
use archard::body::mesh::{ContactMesh, MeshSurface};
use archard::compliance::bem::Size;
use archard::elastic::{ElasticBody, ElasticError, Point, Section};
use archard::parameters::Invalid;

/// A checked case of one elastic body, in SI. It prints as a case file that reads back to the same bits.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct ElasticCase {
    /// What it is about.
    pub title: Option<String>,
    /// The body, which has a mesh.
    pub body: BodyCase,
    /// Points where displacement and stress are put out.
    pub points: Vec<Point>,
    /// Sections on which they are put out.
    pub sections: Vec<Section>,
}

/// What the computation of an elastic body will take.
#[non_exhaustive]
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ElasticForecast {
    /// The surfaces with their numbers of elements.
    pub surfaces: Vec<MeshSurface>,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Number of points inside.
    pub points: usize,
    /// The longest element along a free span over the thickness there; `None` where nothing bends.
    pub slenderness: Option<f64>,
    /// Memory (bytes).
    pub memory: f64,
}

impl ElasticCase {
    /// Builds the body.
    ///
    /// # Errors
    /// If its mesh cannot be made; that of a checked case can.
    pub fn build(&self) -> Result<ElasticBody, BuildError> {
        let missing = |name| BuildError::from(Invalid::new(name, format!("`{name}` is missing")));
        let case = self.body.finite.as_ref().ok_or_else(|| missing("mesh"))?;
        let finite = case.build(&FrameCase::to_be_chosen())?;
        let slenderness = case.slenderness(&finite.meshed)?;
        let material = self.body.material.as_ref().ok_or_else(|| missing("material"))?.elastic;
        let name = self.body.name.clone();
        let (points, sections) = (self.points.clone(), self.sections.clone());
        Ok(ElasticBody { name, material, finite, points, sections, slenderness })
    }
}

/// The forecast of a case and what is wrong with it.
pub(super) fn check(case: &ElasticCase) -> (ElasticForecast, Vec<Problem>) {
    let body = match case.build() {
        Ok(body) => body,
        // A case that was read has been built once already.
        Err(error) => {
            let problem = Problem::error(Key::default(), error.to_string());
            return (ElasticForecast::default(), vec![problem]);
        }
    };
    let surface = body.surface();
    let problems = body.check(&surface).into_iter().map(|error| match &error {
        ElasticError::Outside { point } => {
            let key = Key::of(["output", "points", &point.name]);
            Problem::error(key, "lies outside of the body")
        }
        ElasticError::Section { name, cause } => {
            let key = Key::of(["output", "sections", name, cause.parameter()]);
            Problem::error(key, cause.to_string())
        }
        _ => {
            let key = Key::of(["body", &case.body.name, "supports"]);
            Problem::error(key, error.to_string()).at_name()
        }
    });
    let unknowns = surface.unknowns();
    let memory = footprint::BYTES_OF_THE_PROGRAM + Size { unknowns, ..Size::default() }.memory();
    let long = body.slenderness.and_then(|longest| slender::problem(&case.body, longest));
    let problems = problems.chain(memory::of_body(&case.body, memory)).chain(long).collect();
    let ContactMesh { mesh, zone, .. } = &body.finite.meshed;
    let forecast = ElasticForecast {
        surfaces: mesh.listed(zone),
        unknowns,
        points: body.points.len(),
        slenderness: body.slenderness,
        memory,
    };
    (forecast, problems)
}

impl Display for ElasticForecast {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let total: usize = self.surfaces.iter().map(|surface| surface.elements).sum();
        writeln!(f, "elements          {total}")?;
        for surface in &self.surfaces {
            writeln!(f, "                  {surface}")?;
        }
        writeln!(f, "unknowns          {}", self.unknowns)?;
        writeln!(f, "points            {}", self.points)?;
        if let Some(longest) = self.slenderness {
            let thickness = "of the thickness where the body can bend";
            writeln!(f, "longest element   {longest:.2} {thickness}")?;
        }
        writeln!(f, "memory            about {:.0} MB", self.memory * 1e-6)
    }
}
