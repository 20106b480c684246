//! What passes between two meshed surfaces whose nodes need not face each other.
//!
//! With N and M the shape functions of the host and of the other body, and the integral over their common
//! surface
//!
//! ```text
//! K_ik = integral of N_i M_k
//! ```
//!
//! tractions of the host act on the other body as K^T t over the areas of its nodes, and its displacements
//! are seen by the pairs as K u over the areas of the pairs. The force is kept, and the work (C. Bernardi, Y.
//! Maday and A. T. Patera, the mortar method, *Asymptotic and Numerical Methods for PDEs*, Kluwer 1993).

use faer::Mat;
use glam::DVec3;

use super::super::element::evaluate;
use super::super::patch::Patch;
use super::ContactError;
use super::STEEP;
use super::host::Host;
use super::project::{Hit, project, project_beside};
use crate::compliance::fem::OnNodes;

/// Points of the rule along each side of a host's element: edges of the other mesh run through it.
const POINTS: usize = 8;

/// The two zones against each other.
pub(super) struct Transfer {
    /// What is added to the gaps of the pairs to the plane z = 0 to give those to the other body (m).
    pub gap: Vec<f64>,
    /// K, a row a pair.
    rows: Vec<Vec<(usize, f64)>>,
    /// The pairs on the nodes inside the other body, if that is one of finite elements.
    inside: Option<Vec<OnNodes>>,
    areas: Vec<f64>,
    /// Bases of the pairs in the axes of the frame.
    bases: Vec<[DVec3; 3]>,
    /// Areas of the other body's nodes, and their bases in the axes of the frame.
    other_areas: Vec<f64>,
    other_bases: Vec<[DVec3; 3]>,
}

impl Transfer {
    pub fn new(host: &Host<'_>, other: &Host<'_>) -> Result<Self, ContactError> {
        let patches = zone(other);
        let own = zone(host);
        let local = |host: &Host<'_>| {
            let pair_of = host.pair_of();
            let zone = host.finite.meshed.zone.faces.iter();
            zone.map(|&face| host.surface.tractions_of(face).map(|node| pair_of[node]).collect())
                .collect::<Vec<Vec<Option<usize>>>>()
        };
        let (own_pairs, other_pairs) = (local(host), local(other));
        let steep = (0..host.contact.len()).any(|pair| host.closing(pair) < STEEP);
        let bases = |host: &Host<'_>| -> Vec<[DVec3; 3]> {
            host.contact.iter().map(|(_, basis)| basis.map(|unit| host.in_frame(unit))).collect()
        };
        let own_bases = bases(host);
        let off = |place: DVec3| {
            let place = host.axes.iter().zip(place.to_array()).map(|(axis, value)| value * *axis);
            ContactError::NotOpposite { body: host.which, place: place.sum::<DVec3>().to_array() }
        };
        let mut rows: Vec<Vec<(usize, f64)>> = vec![vec![]; host.contact.len()];
        let carries = other.finite.elasticity.bears();
        let volume = other.finite.meshed.volume.as_ref().filter(|_| carries);
        let on_other = |basis: &[DVec3; 3]| {
            let turned = |unit: DVec3| {
                let along = other.axes.iter().zip(unit.to_array());
                along.map(|(axis, value)| value * *axis).sum()
            };
            OnNodes::along(basis.map(turned))
        };
        let mut inside: Option<Vec<OnNodes>> =
            volume.map(|_| own_bases.iter().map(on_other).collect());
        let line = crate::numerics::quadrature::gauss_legendre(POINTS);
        // Elements that bear the contact meet it in the mean, as they are displaced.
        let mean = host.finite.elasticity.bears();
        let mut means = vec![0.0; host.contact.len()];
        let sign = if host.first { 1.0 } else { -1.0 };
        for (index, (patch, pairs)) in own.iter().zip(&own_pairs).enumerate() {
            for (at, weight) in points(patch, &line) {
                let vector = patch.area_vector(at);
                let direction = match (mean, steep) {
                    (true, _) => host.outward(index, at),
                    (false, true) => vector.normalize(),
                    (false, false) => DVec3::Z,
                };
                let place = patch.at(at);
                let found = match mean {
                    true => project_beside(place, direction, &patches),
                    false => project(place, direction, &patches),
                };
                let Some(Hit { patch: hit, at: there, distance }) = found else {
                    return Err(off(place));
                };
                let normal = match volume.is_some() || mean {
                    true => sign * host.outward(index, at),
                    false => DVec3::Z,
                };
                let distance = match mean {
                    true => distance - other.rise(hit, there) - host.rise(index, at),
                    false => 0.0,
                };
                let area = weight * vector.length();
                for (pair, polynomial) in pairs.iter().zip(patch.element.shape) {
                    let Some(pair) = pair else { continue };
                    let share = area * evaluate(polynomial, at);
                    means[*pair] += share * distance;
                    if let (Some(volume), Some(inside)) = (volume, &mut inside) {
                        let face = other.finite.meshed.zone.faces[hit];
                        let along = other.axes.iter().zip(normal.to_array());
                        let normal = along.map(|(axis, value)| value * *axis).sum();
                        inside[*pair].add((volume, face), there, (share, normal));
                    }
                    let other = other_pairs[hit].iter().zip(patches[hit].element.shape);
                    for (node, polynomial) in other {
                        if let Some(node) = node {
                            rows[*pair].push((*node, share * evaluate(polynomial, there)));
                        }
                    }
                }
            }
        }
        let areas: Vec<f64> =
            rows.iter().map(|row| row.iter().map(|(_, share)| share).sum()).collect();
        let mut gap = vec![];
        let heights = host.heights();
        for (pair, &[_, _, n]) in own_bases.iter().enumerate() {
            if mean {
                gap.push(means[pair] / host.area(pair) - heights[pair]);
                continue;
            }
            let place = host.place(pair);
            let direction = if steep { n } else { DVec3::Z };
            let hit = project(place, direction, &patches).ok_or_else(|| off(place))?;
            let rise = other.rise(hit.patch, hit.at);
            let distance = sign * hit.distance * direction.dot(n) - rise;
            // The pairs have counted the distance to z = 0 already.
            gap.push(distance - heights[pair]);
        }
        Ok(Self {
            gap,
            areas,
            rows: rows.into_iter().map(gathered).collect(),
            inside: inside.map(|pairs| pairs.into_iter().map(OnNodes::gathered).collect()),
            bases: own_bases,
            other_areas: other
                .contact
                .iter()
                .map(|(node, _)| other.surface.tractions[*node].area)
                .collect(),
            other_bases: bases(other),
        })
    }

    /// The pairs on the nodes inside the other body, if it is one of finite elements.
    pub fn bearing(&self) -> Option<Vec<OnNodes>> {
        self.inside.clone()
    }

    /// Turns a vector at a node of the other body into the basis of a pair.
    fn turn(&self, pair: usize, node: usize, d: usize, e: usize) -> f64 {
        self.bases[pair][d].dot(self.other_bases[node][e])
    }

    /// Displacements of the other body along the normals of the pairs (m).
    pub fn displacements(&self, nodal: &[f64]) -> Vec<f64> {
        let normal = |pair: usize| {
            let row = self.rows[pair].iter();
            let sum: f64 = row
                .map(|&(node, share)| {
                    let along = (0..3).map(|e| self.turn(pair, node, 2, e) * nodal[3 * node + e]);
                    share * along.sum::<f64>()
                })
                .sum();
            sum / self.areas[pair]
        };
        (0..self.rows.len()).map(normal).collect()
    }

    /// The tractions (Pa) of the other body's nodes in their bases, three a node, under those of the pairs.
    pub fn act(&self, pairs: &[f64]) -> Vec<f64> {
        let mut nodal = vec![0.0; 3 * self.other_areas.len()];
        for (pair, row) in self.rows.iter().enumerate() {
            for &(node, share) in row {
                for e in 0..3 {
                    let along = (0..3).map(|d| self.turn(pair, node, d, e) * pairs[3 * pair + d]);
                    nodal[3 * node + e] += share * along.sum::<f64>() / self.other_areas[node];
                }
            }
        }
        nodal
    }

    /// Means at the other body's nodes of values of the pairs; none of none.
    pub fn mean(&self, pairs: &[f64]) -> Vec<f64> {
        if pairs.is_empty() {
            return vec![];
        }
        let mut sums = vec![(0.0, 0.0); self.other_areas.len()];
        for (row, value) in self.rows.iter().zip(pairs) {
            for &(node, share) in row {
                sums[node].0 += share * value;
                sums[node].1 += share;
            }
        }
        let mean = |(sum, share): (f64, f64)| if share > 0.0 { sum / share } else { 0.0 };
        sums.into_iter().map(mean).collect()
    }

    /// The compliance of the other body at the pairs.
    pub fn compliance(&self, nodal: &Mat<f64>) -> Mat<f64> {
        let pairs = self.rows.len();
        // From tractions of the pairs to those of the nodes, and back from displacements.
        let mut act = Mat::<f64>::zeros(nodal.ncols(), 3 * pairs);
        let mut see = Mat::<f64>::zeros(3 * pairs, nodal.nrows());
        for (pair, row) in self.rows.iter().enumerate() {
            for &(node, share) in row {
                for d in 0..3 {
                    for e in 0..3 {
                        let turn = self.turn(pair, node, d, e);
                        act[(3 * node + e, 3 * pair + d)] += share * turn / self.other_areas[node];
                        see[(3 * pair + d, 3 * node + e)] += share * turn / self.areas[pair];
                    }
                }
            }
        }
        see * (nodal * act)
    }
}

/// The elements of a zone in the axes of the frame.
fn zone(host: &Host<'_>) -> Vec<Patch> {
    let faces = host.finite.meshed.zone.faces.iter();
    faces
        .map(|&face| {
            let patch = &host.surface.patches[face];
            let corners = patch.corners.iter().map(|&corner| host.in_frame(corner)).collect();
            Patch::new(corners, patch.element)
        })
        .collect()
}

/// Points of a product rule on an element and the reference areas they stand for.
fn points(patch: &Patch, line: &[(f64, f64)]) -> Vec<([f64; 2], f64)> {
    let mut points = vec![];
    for (s, weight_s) in line {
        for (t, weight_t) in line {
            let weight = weight_s * weight_t;
            if patch.triangle() {
                let (s, t) = (0.5 * (1.0 + s), 0.5 * (1.0 + t));
                points.push(([s, t * (1.0 - s)], 0.25 * weight * (1.0 - s)));
            } else {
                points.push(([*s, *t], weight));
            }
        }
    }
    points
}

/// A sparse row with every column once.
fn gathered(mut row: Vec<(usize, f64)>) -> Vec<(usize, f64)> {
    row.sort_by_key(|(column, _)| *column);
    row.dedup_by(|next, kept| {
        let same = next.0 == kept.0;
        if same {
            kept.1 += next.1;
        }
        same
    });
    row
}
