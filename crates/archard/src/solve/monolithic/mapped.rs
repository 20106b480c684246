//! A step of contact and friction in tractions whose admissible set is a disc.

use std::ops::Deref;

use super::{Outcome, Solution, Step, newton};
use crate::compliance;
use crate::frame::VectorField;
use crate::friction::Map;
use crate::solve::Settings;

/// A step whose compliance, rigid slip and tangential tractions are mapped; forces and approach are not.
pub(super) struct Mapped<'a> {
    step: Step<'a>,
    map: Map,
}

impl<'a> Deref for Mapped<'a> {
    type Target = Step<'a>;

    fn deref(&self) -> &Step<'a> {
        &self.step
    }
}

impl Mapped<'_> {
    /// Displacement of the pairs, its tangential part mapped as slip is, when body 2 moves by a vector (m) in the axes
    /// of the frame.
    pub fn moved(&self, vector: [f64; 3]) -> VectorField {
        tangentially(self.map, self.frame.moved(vector))
    }

    /// Force (N) of mapped tractions (Pa) in the axes of the frame.
    pub fn force(&self, tractions: &VectorField) -> [f64; 3] {
        if self.map.is_identity() {
            return self.frame.force(tractions);
        }
        self.frame.force(&tangentially(self.map, tractions.clone()))
    }
}

/// Solves a step, whose tractions and slips are those of the pairs as are those of the solutions, from one known or
/// foreseen.
pub(in crate::solve) fn solve(
    step: &Step<'_>,
    start: &Solution,
    foreseen: Option<&Solution>,
    settings: Settings,
) -> Outcome {
    let map = step.friction.map();
    if map.is_identity() {
        return newton(&Mapped { step: *step, map }, start, foreseen, settings);
    }
    let compliance = compliance::MappedCompliance::new(step.compliance, map);
    let rigid = map.images(step.rigid);
    let inner = Step { compliance: &compliance, rigid: [&rigid[0], &rigid[1]], ..*step };
    let inverse = map.inverse();
    let inside = |solution: &Solution| solution.clone().mapped(inverse, map);
    let foreseen = foreseen.map(inside);
    let outcome = newton(&Mapped { step: inner, map }, &inside(start), foreseen.as_ref(), settings);
    Outcome { solution: outcome.solution.mapped(map, inverse), ..outcome }
}

impl Solution {
    /// With the tangential parts of tractions and displacements mapped; the factors are those of mapped ones always.
    fn mapped(self, tractions: Map, displacements: Map) -> Self {
        Self {
            traction: tangentially(tractions, self.traction),
            displacement: tangentially(displacements, self.displacement),
            ..self
        }
    }
}

/// The field with its tangential part mapped.
fn tangentially(map: Map, mut field: VectorField) -> VectorField {
    map.apply_to([&mut field.t1, &mut field.t2]);
    field
}
