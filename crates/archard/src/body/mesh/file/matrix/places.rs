//! Where the nodes of a matrix are: a table of numbers and places, by which they are nodes of a mesh that numbers its own otherwise.

use std::collections::HashMap;

use glam::DVec3;
use rayon::prelude::*;

use super::{Label, Wrong};
use crate::body::mesh::Zone;
use crate::body::mesh::file::inside::Inside;
use crate::numerics::WRITTEN;
use crate::parameters::{Invalid, Quantity};

/// The columns of the table.
pub(in crate::body::mesh::file) const PLACES: &[(&str, Quantity)] = &[
    ("node", Quantity::Number),
    ("x", Quantity::Length),
    ("y", Quantity::Length),
    ("z", Quantity::Length),
];

/// The numbers of nodes and their places (m), in the order of the table.
#[derive(Debug)]
pub(in crate::body::mesh::file) struct Places(Vec<(i64, DVec3)>);

impl Places {
    /// From the columns of a table.
    ///
    /// # Errors
    /// If one is missing, or a node has no whole number of its own.
    pub fn read(columns: &[(String, Vec<f64>)]) -> Result<Self, Invalid> {
        let wrong = |message: String| Invalid::new("places", message);
        let column = |name: &str, written: &str| {
            let found = columns.iter().find(|known| known.0 == name);
            let head = "the table has `node`, `x_mm`, `y_mm` and `z_mm`, or another unit of length";
            found
                .map(|known| &known.1[..])
                .ok_or_else(|| wrong(format!("the column `{written}` is missing: {head}")))
        };
        let (numbers, x) = (column("node", "node")?, column("x", "x_mm")?);
        let (y, z) = (column("y", "y_mm")?, column("z", "z_mm")?);
        let mut known: HashMap<i64, usize> = HashMap::new();
        let mut places = vec![];
        for (index, number) in numbers.iter().enumerate() {
            let row = index + 1;
            if number.fract() != 0.0 || number.abs() > 1.0 / f64::EPSILON {
                return Err(wrong(format!("row {row}, `node`: {number} is no number of a node")));
            }
            let node = *number as i64;
            if let Some(first) = known.insert(node, row) {
                return Err(wrong(format!("row {row}, `node`: {node} is in row {first} already")));
            }
            places.push((node, DVec3::new(x[index], y[index], z[index])));
        }
        Ok(Self(places))
    }

    /// Of each node of a body the number of the place that it lies at, as far as places are written.
    ///
    /// # Errors
    /// If a node of a zone lies at none, or two places are one node.
    pub fn numbers(&self, inside: &Inside, zone: &Zone) -> Result<Vec<Option<i64>>, Wrong> {
        let nodes = inside.places();
        let near = WRITTEN * inside.mesh.extent();
        let nearest = |(_, place): &(i64, DVec3)| {
            let away = |node: &usize| place.distance(nodes[*node].into());
            let node = (0..nodes.len()).min_by(|a, b| away(a).total_cmp(&away(b)));
            node.filter(|node| away(node) <= near)
        };
        let found: Vec<Option<usize>> = self.0.par_iter().map(nearest).collect();
        let mut numbers = vec![None; nodes.len()];
        for ((number, _), node) in self.0.iter().zip(found) {
            let Some(node) = node else { continue };
            if let Some(other) = numbers[node].replace(*number) {
                return Err(Wrong::all(format!(
                    "`places` has the nodes {other} and {number} at one node of the mesh"
                )));
            }
        }
        let mut without: Vec<usize> =
            inside.nodes_of(zone).filter(|node| numbers[*node].is_none()).collect();
        without.sort_unstable();
        without.dedup();
        match without.first() {
            None => Ok(numbers),
            Some(first) => {
                let [x, y, z] = nodes[*first];
                Err(Wrong::all(format!(
                    "{} nodes of the zone are at no place of `places`, the first is at ({x:.6e}, {y:.6e}, {z:.6e}) m: retain all nodes of the contact, and see whether the unit of the table is right",
                    without.len()
                )))
            }
        }
    }

    /// The rows of a matrix of that size that names none: x, y and z of each node, in the order of the table.
    ///
    /// # Errors
    /// If there are more or fewer.
    pub fn labels(&self, size: usize) -> Result<Vec<Label>, Wrong> {
        let count = self.0.len();
        if size != 3 * count {
            return Err(Wrong::all(format!(
                "the matrix has {size} rows, and the {count} nodes of `places` take {}: three a node, in the order of the table",
                3 * count
            )));
        }
        Ok(self.0.iter().flat_map(|(node, _)| [0, 1, 2].map(|along| (*node, along))).collect())
    }
}
