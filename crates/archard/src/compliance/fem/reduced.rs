//! A body whose stiffness or flexibility at some nodes another program found.
//!
//! Pairs act on its nodes and are displaced by them as on the nodes of [tetrahedra](super::Carrier). Rows that bear no traction and
//! that nothing holds are free.

use std::sync::Arc;

use faer::Mat;
use faer::sparse::{SparseColMat, Triplet};
use glam::DVec3;

use super::bearing::OnNodes;
use super::factors::Factors;
use super::held::held;
use crate::body::mesh::Volume;
use crate::body::mesh::reduced::{Holds, ReducedMatrix};
use crate::body::mesh::tetrahedron::EDGES;
use crate::body::{Finite, Material};
use crate::compliance::bem::left_free;
use crate::numerics::SAME;
use crate::numerics::dense::SolveError;

/// Pairs whose columns are found at once.
const AT_ONCE: usize = 64;
/// A unit of length or of force is off by this at least.
const UNIT: f64 = 1e3;

/// Why a matrix says nothing of a body.
#[derive(Debug, Clone, PartialEq)]
pub enum Unfit {
    /// Motions that nothing holds.
    Free(Vec<&'static str>),
    /// Anything else, as a sentence.
    Wrong(String),
}

/// A matrix with its rows at the nodes of a volume.
#[derive(Debug)]
pub struct Superelement {
    reduced: Arc<ReducedMatrix>,
    /// Of each node of the volume the rows along x, y and z and their shares of it: of middles that have none those of both ends.
    seen: Vec<Vec<([usize; 3], f64)>>,
    /// Number among the unknowns, where supports do not hold the row.
    numbers: Vec<Option<usize>>,
}

impl Superelement {
    /// Of a body of that material.
    ///
    /// # Errors
    /// If supports hold what the matrix does not have or leave motions free, or its unit is not that of the material.
    pub fn new(
        (finite, volume): (&Finite, &Volume),
        reduced: &Arc<ReducedMatrix>,
        material: &Material,
    ) -> Result<Self, Unfit> {
        let mut rows = vec![None; volume.nodes.len()];
        reduced.rows.iter().for_each(|(node, own)| rows[*node] = Some(*own));
        let whole = |node: usize| {
            let [x, y, z] = rows[node]?;
            Some([x?, y?, z?])
        };
        let mut seen: Vec<Vec<([usize; 3], f64)>> = (0..rows.len())
            .map(|node| whole(node).map(|own| (own, 1.0)).into_iter().collect())
            .collect();
        for element in &volume.elements {
            for (place, ends) in EDGES.iter().enumerate() {
                let middle = element[4 + place];
                if middle >= volume.numbers.len() && seen[middle].is_empty() {
                    let ends = ends.map(|end| whole(element[end]));
                    seen[middle] = ends.into_iter().flatten().map(|own| (own, 0.5)).collect();
                }
            }
        }
        let numbers = free(finite, volume, &rows, reduced)?;
        let own = Self { reduced: Arc::clone(reduced), seen, numbers };
        own.in_unit(finite, volume, material)?;
        if reduced.holds == Holds::Stiffness {
            own.held(volume)?;
        }
        Ok(own)
    }

    /// Whether its unit can be that of the material: by how much its nodes resist when their neighbours stay where they are, which takes
    /// about E h each, h apart.
    fn in_unit(&self, finite: &Finite, volume: &Volume, material: &Material) -> Result<(), Unfit> {
        let zone = finite.meshed.zone.faces.iter().flat_map(|face| volume.faces[*face]);
        let mut nodes: Vec<usize> = zone.filter(|node| self.seen[*node].len() == 1).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let diagonal = self.reduced.diagonal();
        let mut between = std::collections::HashMap::new();
        let flexible = self.reduced.holds == Holds::Flexibility;
        if flexible {
            let entries = self.reduced.entries.iter();
            between.extend(entries.map(|(row, column, value)| ([*row, *column], *value)));
        }
        let at = |node: usize| DVec3::from(volume.nodes[node]);
        let mut shares: Vec<f64> = nodes
            .iter()
            .filter_map(|&node| {
                let others = nodes.iter().filter(|other| **other != node);
                let (nearest, apart) = others
                    .map(|&other| (other, at(other).distance(at(node))))
                    .min_by(|a, b| a.1.total_cmp(&b.1))?;
                let [own, other] = [node, nearest].map(|node| self.seen[node][0].0);
                let resists = own.iter().zip(other).map(|(&one, other)| {
                    if !flexible {
                        return diagonal[one];
                    }
                    let key = [one.max(other), one.min(other)];
                    let both = between.get(&key).copied().unwrap_or(0.0);
                    2.0 / (diagonal[one] + diagonal[other] - 2.0 * both)
                });
                Some(resists.sum::<f64>() / 3.0 / (material.young * apart))
            })
            .collect();
        shares.sort_by(f64::total_cmp);
        let Some(&median) = shares.get(shares.len() / 2) else { return Ok(()) };
        let off = UNIT.sqrt();
        if median > 1.0 / off && median < off {
            return Ok(());
        }
        Err(Unfit::Wrong(format!(
            "the nodes of the zone resist {median:.1e} times what a material of E = {:e} Pa makes them resist: see whether `compliance_unit`, `unit` and `young` are right",
            material.young
        )))
    }

    /// Whether no motion without deformation is left free, as far as the digits of the file say.
    fn held(&self, volume: &Volume) -> Result<(), Unfit> {
        let size = self.reduced.size();
        let mut motions = vec![[0.0; 6]; size];
        for (row, (_, along)) in self.reduced.labels.iter().enumerate() {
            if *along < 6 {
                motions[row][*along] = 1.0;
            }
        }
        let places = self.reduced.rows.iter().map(|(node, _)| DVec3::from(volume.nodes[*node]));
        let count = self.reduced.rows.len() as f64;
        let centre = places.clone().sum::<DVec3>() / count;
        let extent = places.map(|place| place.distance(centre)).fold(0.0, f64::max);
        let mut placed = 0;
        for (node, rows) in &self.reduced.rows {
            let arm = (DVec3::from(volume.nodes[*node]) - centre) / extent;
            for (axis, row) in rows.iter().enumerate() {
                let Some(row) = row else { continue };
                placed += 1;
                for turn in 0..3 {
                    motions[*row][3 + turn] = DVec3::AXES[turn].cross(arm)[axis];
                }
            }
        }
        let (mut held, mut all) = ([[0.0; 6]; 6], [0.0; 6]);
        let mut add = |row: usize, column: usize, value: f64| {
            for one in 0..6 {
                for other in 0..6 {
                    held[one][other] += motions[row][one] * value * motions[column][other];
                }
                all[one] += (motions[row][one] * value * motions[column][one]).abs();
            }
        };
        for &(row, column, value) in &self.reduced.entries {
            add(row, column, value);
            if row != column {
                add(column, row, value);
            } else if self.numbers[row].is_none() {
                // What is held resists besides as much as its own stiffness.
                add(row, column, value);
            }
        }
        for one in 0..6 {
            for other in 0..6 {
                if all[one] > 0.0 && all[other] > 0.0 {
                    held[one][other] /= (all[one] * all[other]).sqrt();
                }
            }
            // Of rows in unknown places it is not known how they turn.
            if placed < size && one >= 3 {
                held[one] = [0.0; 6];
                (0..6).for_each(|other| held[other][one] = 0.0);
                held[one][one] = 1.0;
            }
        }
        let modes = left_free(held, self.reduced.rounding.max(SAME));
        if modes.is_empty() { Ok(()) } else { Err(Unfit::Free(modes)) }
    }

    /// The compliance of pairs: row 3 i + d for the displacement (m) of pair i along direction d of its basis, column 3 j + e for the
    /// traction (Pa) of pair j along e.
    ///
    /// # Errors
    /// If the equations are singular.
    pub fn compliance(&self, pairs: &[OnNodes]) -> Result<Mat<f64>, SolveError> {
        let unknowns = self.numbers.iter().flatten().count();
        let free = |row: usize, column: usize| Some((self.numbers[row]?, self.numbers[column]?));
        let lower: Vec<Triplet<usize, usize, f64>> = self
            .reduced
            .entries
            .iter()
            .filter_map(|(row, column, value)| {
                let (row, column) = free(*row, *column)?;
                Some(Triplet::new(row.max(column), row.min(column), *value))
            })
            .collect();
        let singular = || SolveError::Singular { size: unknowns };
        let matrix = SparseColMat::try_new_from_triplets(unknowns, unknowns, &lower)
            .map_err(|_| singular())?;
        let factors = match self.reduced.holds {
            Holds::Stiffness => Some(Factors::new(&matrix)?),
            Holds::Flexibility => None,
        };
        let mut whole = Mat::zeros(3 * pairs.len(), 3 * pairs.len());
        for (chunk, acting) in pairs.chunks(AT_ONCE).enumerate() {
            let mut sides = Mat::zeros(unknowns, 3 * acting.len());
            for (place, pair) in acting.iter().enumerate() {
                for along in 0..3 {
                    let unit = std::array::from_fn::<f64, 3, _>(|own| f64::from(own == along));
                    for (node, force) in pair.forces(&unit) {
                        for (rows, share) in &self.seen[node] {
                            for (axis, row) in rows.iter().enumerate() {
                                if let Some(number) = self.numbers[*row] {
                                    sides[(number, 3 * place + along)] += share * force[axis];
                                }
                            }
                        }
                    }
                }
            }
            match &factors {
                Some(factors) => factors.solve(&mut sides),
                None => sides = times(&lower, &sides),
            }
            for column in 0..sides.ncols() {
                let at = |node: usize| {
                    let along = |rows: &[usize; 3]| {
                        let own =
                            |row: usize| self.numbers[row].map_or(0.0, |own| sides[(own, column)]);
                        DVec3::from_array(rows.map(own))
                    };
                    self.seen[node].iter().map(|(rows, share)| *share * along(rows)).sum()
                };
                for (row, pair) in pairs.iter().enumerate() {
                    for (along, value) in pair.displaced(at).into_iter().enumerate() {
                        whole[(3 * row + along, 3 * AT_ONCE * chunk + column)] = value;
                    }
                }
            }
        }
        Ok(whole)
    }
}

/// A symmetric matrix, by its part on and below the diagonal, times some columns.
fn times(lower: &[Triplet<usize, usize, f64>], columns: &Mat<f64>) -> Mat<f64> {
    let mut sums = Mat::zeros(columns.nrows(), columns.ncols());
    for column in 0..columns.ncols() {
        let (own, sum) = (columns.col_as_slice(column), sums.col_as_slice_mut(column));
        for Triplet { row, col, val } in lower {
            sum[*row] += val * own[*col];
            if row != col {
                sum[*col] += val * own[*row];
            }
        }
    }
    sums
}

/// Numbers of the rows that supports leave free.
fn free(
    finite: &Finite,
    volume: &Volume,
    rows: &[Option<[Option<usize>; 3]>],
    reduced: &ReducedMatrix,
) -> Result<Vec<Option<usize>>, Unfit> {
    let wrong = |message: String| Err(Unfit::Wrong(message));
    let mut is_held = vec![false; reduced.size()];
    let named = |surface: usize| &finite.meshed.mesh.surfaces[surface];
    if let Some((surface, _)) = finite.supports.iter().find(|(_, support)| support.loads()) {
        return wrong(format!(
            "`{}` loads the body, and a matrix says nothing of other loads: hold it there by `\"clamped\"`, or load it where the matrix is made",
            named(*surface)
        ));
    }
    if let (Some((surface, _)), Holds::Flexibility) = (finite.supports.first(), reduced.holds) {
        return wrong(format!(
            "`{}` is to be held, and a flexibility is that of a body which is held already: leave it out of `supports`",
            named(*surface)
        ));
    }
    let [nodes, _] = held(finite, volume);
    for (node, held) in nodes.iter().enumerate().filter(|(_, held)| held.count > 0) {
        // Middles of edges that the matrix does not know are held with their ends.
        let Some(own) = rows[node] else {
            if node >= volume.numbers.len() {
                continue;
            }
            return wrong(format!(
                "node {} is to be held, and the matrix does not have it: retain the nodes of supports too, or hold them where the matrix is made and leave `supports` out",
                volume.numbers[node]
            ));
        };
        for (axis, row) in own.into_iter().enumerate() {
            let share = held.held(DVec3::AXES[axis]).length();
            if share > SAME && share < 1.0 - SAME {
                return wrong(format!(
                    "node {} is to be held along a direction between the axes, and a matrix has rows along x, y and z: clamp it, or hold it where the matrix is made",
                    volume.numbers[node]
                ));
            }
            if let (true, Some(row)) = (share > 0.5, row) {
                is_held[row] = true;
            }
        }
    }
    let mut count = 0;
    let number = |held: bool| {
        (!held).then(|| {
            count += 1;
            count - 1
        })
    };
    Ok(is_held.into_iter().map(number).collect())
}
