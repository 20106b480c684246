//! Loads of a body besides what its conditions say: tractions on its free faces and displacements of what is held.

use faer::Mat;
use glam::DVec3;

use super::conditions::Conditions;

/// Loads, each by itself, on a body of the same conditions.
#[derive(Debug, Clone, Default)]
pub struct Loads {
    /// Tractions (Pa), one a load, at row 3 i + d along direction d of the basis of the node of tractions i, where they are given.
    pub tractions: Vec<Vec<f64>>,
    /// Displacements (m), one a load, at row 3 i + d along direction d of the basis of the node i, where they are known.
    pub displacements: Vec<Vec<f64>>,
}

/// What loads make of a body.
#[derive(Debug)]
pub struct LoadResponse {
    /// What is sought at its nodes: a column for what the conditions say, and one for each load.
    pub(super) sought: Mat<f64>,
    /// What tractions are multiplied by in the equations (m/Pa).
    pub(super) unit: f64,
}

impl Loads {
    /// How many there are.
    pub fn count(&self) -> usize {
        self.tractions.first().or(self.displacements.first()).map_or(0, Vec::len)
    }

    /// Whether any puts a traction on a node.
    pub(super) fn loads(&self, traction: usize) -> bool {
        let rows = self.tractions[3 * traction..].iter().take(3);
        rows.flatten().any(|value| *value != 0.0)
    }
}

impl LoadResponse {
    /// The displacement (m) under a load along a direction of the basis of a node, where it is sought.
    pub(super) fn displacement(
        &self,
        conditions: &Conditions,
        (node, direction): (usize, usize),
        load: usize,
    ) -> f64 {
        self.sought[(conditions.columns[node] + direction, load + 1)]
    }

    /// The traction (Pa) there, where the displacement is known.
    pub(super) fn traction(
        &self,
        conditions: &Conditions,
        (node, direction): (usize, usize),
        load: usize,
    ) -> f64 {
        self.displacement(conditions, (node, direction), load) / self.unit
    }
}

impl Conditions {
    /// The direction of a node's basis that is along a unit vector, along which it is held.
    pub(super) fn own(&self, node: usize, unit: DVec3) -> usize {
        let along = |own: &usize| self.nodes[node].basis[*own].dot(unit).abs();
        (0..3).max_by(|one, other| along(one).total_cmp(&along(other))).unwrap_or_default()
    }
}
