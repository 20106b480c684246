//! What says how a meshed body deforms.

use crate::case::chosen::ChosenPart;
use crate::case::problem::Problem;
use crate::case::reader::{Reader, Section};
use crate::case::tree::Item;
use archard::body::Elasticity;
use archard::body::mesh::Shape;

/// Why a matrix does.
const GIVEN: &str = "the case gives one";

impl Reader<'_> {
    /// What says how a body of that mesh deforms, whether the case says so, and why where it says so by another key.
    pub(super) fn elasticity(
        &mut self,
        body: &Section<'_>,
        mesh: &ChosenPart<Box<dyn Shape>>,
    ) -> Option<(Elasticity, bool, Option<&'static str>)> {
        let given = mesh.values.get("compliance").is_some();
        let Some((key, entry)) = body.get("elasticity") else {
            return Some(match given {
                true => (Elasticity::Reduced, true, Some(GIVEN)),
                false => (Elasticity::default(), false, None),
            });
        };
        let elasticity = match &entry.node.item {
            Item::Text(word) if word == "boundary_elements" => Elasticity::BoundaryElements,
            Item::Text(word) if word == "image" => Elasticity::Image,
            Item::Text(word) if word == "finite_elements" => Elasticity::FiniteElements,
            Item::Text(word) if word == "compliance" => Elasticity::Reduced,
            Item::Text(word) if word == "half_space" => Elasticity::HalfSpace,
            _ => {
                let message = "expected \"image\", \"boundary_elements\", \"finite_elements\", \"compliance\" or \"half_space\"";
                self.push(Problem::error(key, message));
                return None;
            }
        };
        if given && elasticity != Elasticity::Reduced {
            let mesh = body.key.child("mesh").child(mesh.choice.name).child("compliance");
            let message = "has no effect: `elasticity` says something else than \"compliance\"";
            self.push(Problem::warning(mesh, message).at_name());
        }
        Some((elasticity, true, None))
    }
}
