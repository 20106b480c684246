//! Whether the forces on a body balance each other, and their moments, as they do on a body at rest.
//!
//! Collocation meets the equations of a body at points; that its tractions balance is no part of them and
//! follows as elements become small. What is left over is therefore a measure of their error, and on slender
//! bodies the one that counts: elements longer than the body is thick lose the moments.

use glam::DVec3;

use super::conditions::{AxisCondition, Conditions};
use super::element::evaluate;
use super::rules::{OF_AREAS, Places, Rules};
use super::solid::Boundary;
use super::surface::Surface;

/// Least scale of forces against the sum of all tractions.
const LEAST: f64 = 1e-3;

/// What is left of the forces and the moments on a body, mirror images included.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Balance {
    /// The resultant of all tractions next to the load.
    pub force: f64,
    /// Its moment about the middle of the surface next to the load times half of the body's extent.
    pub moment: f64,
}

/// Forces, their moments about a point, and the sum of their magnitudes.
#[derive(Debug, Clone, Copy, Default)]
struct Resultant {
    force: DVec3,
    moment: DVec3,
    magnitude: f64,
}

impl Balance {
    /// That of a body whose tractions (Pa) are known, a value a node of tractions.
    pub(crate) fn of(surface: &Surface, conditions: &Conditions, tractions: &[DVec3]) -> Self {
        let given: Vec<DVec3> =
            (0..tractions.len()).map(|node| given(conditions, node, tractions[node])).collect();
        let (middle, extent) = middle(surface);
        let mut parts = vec![Resultant::default(); surface.names().len()];
        let mut load = 0.0;
        each_place(surface, |face, shares, place, area| {
            let at = |values: &[DVec3]| -> DVec3 {
                let nodes = surface.tractions_of(face).zip(shares);
                nodes.map(|(node, share)| *share * values[node]).sum()
            };
            let (traction, given) = (area * at(tractions), area * at(&given));
            let first = surface.tractions_of(face).next().unwrap_or_default();
            let part = &mut parts[surface.tractions[first].surface];
            for image in surface.images() {
                part.force += image * traction;
                part.moment += (image * place - middle).cross(image * traction);
                part.magnitude += traction.length();
                load += given.length();
            }
        });
        let force: DVec3 = parts.iter().map(|part| part.force).sum();
        let moment: DVec3 = parts.iter().map(|part| part.moment).sum();
        let forces: f64 = parts.iter().map(|part| part.force.length()).sum();
        let moments: f64 = parts.iter().map(|part| part.moment.length()).sum();
        let all: f64 = parts.iter().map(|part| part.magnitude).sum();
        // Displaced bodies have no load but what their supports bear.
        let scale = load.max(0.5 * forces).max(moments / extent).max(LEAST * all);
        if scale == 0.0 {
            return Self::default();
        }
        Self { force: force.length() / scale, moment: 2.0 * moment.length() / (scale * extent) }
    }

    /// The larger of two, each by itself; what is no number stays one.
    #[must_use]
    pub(crate) fn worst(self, other: Self) -> Self {
        let worst = |a: f64, b: f64| if a.is_nan() || a > b { a } else { b };
        Self { force: worst(self.force, other.force), moment: worst(self.moment, other.moment) }
    }
}

/// Forces (N) on the surfaces, mirror images left out: those given by loads as they are, those of supports with
/// what is left of the balance shared out among them in proportion to what they bear. A support that stands alone
/// so bears exactly what the loads say. Across a plane of symmetry, which bears a part that nobody knows, forces are
/// those of the tractions.
pub fn forces(surface: &Surface, conditions: &Conditions, boundary: &Boundary) -> Vec<[f64; 3]> {
    let mut all = vec![[0.0; 3]; surface.names().len()];
    let mut borne = all.clone();
    for (index, (node, traction)) in surface.tractions.iter().zip(&boundary.traction).enumerate() {
        let given = given(conditions, index, *traction);
        for axis in 0..3 {
            all[node.surface][axis] += node.area * traction[axis];
            borne[node.surface][axis] += node.area * (*traction - given)[axis];
        }
    }
    let mirrored = surface.mirrored();
    for axis in (0..3).filter(|&axis| axis == 2 || !mirrored[axis]) {
        let left: f64 = all.iter().map(|force| force[axis]).sum();
        let sum: f64 = borne.iter().map(|force| force[axis].abs()).sum();
        if sum > 0.0 {
            for (force, borne) in all.iter_mut().zip(&borne) {
                force[axis] -= left * borne[axis].abs() / sum;
            }
        }
    }
    all
}

/// The part of a node's traction that is given, and not that of a support.
fn given(conditions: &Conditions, node: usize, traction: DVec3) -> DVec3 {
    let condition = &conditions.tractions[node];
    let along = condition.basis.iter().zip(condition.given);
    let given = along.filter(|(_, given)| !matches!(given, AxisCondition::Displacement(_)));
    given.map(|(along, _)| along.dot(traction) * *along).sum()
}

/// The middle of the surface and the largest extent (m) of the body along an axis.
fn middle(surface: &Surface) -> (DVec3, f64) {
    let (mut sum, mut all) = (DVec3::ZERO, 0.0);
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let images = surface.images();
    each_place(surface, |_, _, place, area| {
        for image in &images {
            sum += area * *image * place;
            all += area;
            low = low.min(*image * place);
            high = high.max(*image * place);
        }
    });
    (sum / all, (high - low).max_element())
}

/// Shows the places of a rule: the element, the shares of its nodes, the place (m) and the area (m^2).
fn each_place(surface: &Surface, mut show: impl FnMut(usize, &[f64], DVec3, f64)) {
    let rules = Rules::new(1e-6);
    let mut places = Places::default();
    for (face, patch) in surface.patches.iter().enumerate() {
        places.clear();
        rules.whole(patch, [OF_AREAS; 2], &mut places);
        for ((&s, &t), weight) in places.s.iter().zip(&places.t).zip(&places.weight) {
            let shares: Vec<f64> =
                patch.element.shape.iter().map(|shape| evaluate(shape, [s, t])).collect();
            show(face, &shares, patch.at([s, t]), weight * patch.area_vector([s, t]).length());
        }
    }
}
