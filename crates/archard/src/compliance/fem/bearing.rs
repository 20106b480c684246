//! A body in tetrahedra that bears the tractions of a contact on its own nodes.
//!
//! A pair has a function on the surface, one there and zero at its neighbours. Its pressure acts by that function along the normals all
//! around, its other tractions along its own axes, and it is displaced by what that does work on: the compliance is symmetric in the
//! product of areas.

use std::sync::Arc;

use faer::Mat;
use glam::DVec3;
use rayon::prelude::*;

use super::Solid;
use super::surplus::Surplus;
use super::triangle::{Point, points};
use crate::body::mesh::Volume;
use crate::body::{Finite, Material, Support};
use crate::numerics::dense::SolveError;

/// What a pair is on the nodes of a volume.
#[derive(Debug, Clone, PartialEq)]
pub struct OnNodes {
    /// Its axes in the coordinates of the body.
    pub basis: [DVec3; 3],
    /// Integrals (m^2) of its function times those of nodes.
    shares: Vec<(usize, Share)>,
    /// Integrals (m^2) of its function times the cubic ones of triangles of the surface: of their three edges and their middle.
    beyond: Vec<(usize, [Share; 4])>,
    /// The area (m^2) that its pressure acts on.
    area: f64,
}

/// An integral (m^2), by itself and times the normals.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Share {
    all: f64,
    normal: DVec3,
}

impl Share {
    fn add(&mut self, other: Self) {
        self.all += other.all;
        self.normal += other.normal;
    }
}

impl OnNodes {
    /// Of a pair with these axes, nothing known of its function.
    pub fn along(basis: [DVec3; 3]) -> Self {
        Self { basis, shares: vec![], beyond: vec![], area: 0.0 }
    }

    /// Adds what its function is at a place on a triangle of the surface, by the last two coordinates there, times the area (m^2) that
    /// the place stands for; with the normal there.
    pub fn add(
        &mut self,
        (volume, face): (&Volume, usize),
        [s, t]: [f64; 2],
        (share, normal): (f64, DVec3),
    ) {
        let Point { nodes, edges: [a, b, c], middle, .. } = Point::at([1.0 - s - t, s, t]);
        let of = |own: f64| Share { all: share * own, normal: share * own * normal };
        self.shares.extend(volume.faces[face].into_iter().zip(nodes.map(of)));
        self.beyond.push((face, [a, b, c, middle].map(of)));
    }

    /// The same with each node and each triangle once.
    #[must_use]
    pub fn gathered(mut self) -> Self {
        self.shares.sort_by_key(|(node, _)| *node);
        self.shares.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1.add(next.1);
            }
            same
        });
        self.beyond.sort_by_key(|(face, _)| *face);
        self.beyond.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1.iter_mut().zip(next.1).for_each(|(kept, next)| kept.add(next));
            }
            same
        });
        self.area = self.shares.iter().map(|(_, share)| share.normal).sum::<DVec3>().length();
        self
    }

    /// The force (N) of tractions (Pa) along its axes on what has that share of it.
    fn force(&self, tractions: &[f64], share: Share) -> DVec3 {
        let [t1, t2, _] = self.basis;
        share.all * (tractions[0] * t1 + tractions[1] * t2) + tractions[2] * share.normal
    }

    /// The forces (N) of tractions (Pa) along its axes on nodes.
    pub(super) fn forces(&self, tractions: &[f64; 3]) -> impl Iterator<Item = (usize, DVec3)> {
        self.shares.iter().map(|(node, share)| (*node, self.force(tractions, *share)))
    }

    /// What it is displaced by along its axes, where nodes are displaced so.
    pub(super) fn displaced(&self, at: impl Fn(usize) -> DVec3) -> [f64; 3] {
        self.seen(self.shares.iter().map(|(node, share)| (*share, at(*node))))
    }

    /// What it is displaced by along its axes, where what has shares of it is displaced so.
    fn seen(&self, displaced: impl Iterator<Item = (Share, DVec3)>) -> [f64; 3] {
        let [t1, t2, _] = self.basis;
        let mut sum = [0.0; 3];
        for (share, own) in displaced {
            sum[0] += share.all * t1.dot(own);
            sum[1] += share.all * t2.dot(own);
            sum[2] += share.normal.dot(own);
        }
        sum.map(|sum| sum / self.area)
    }
}

/// Places on a triangle for functions of the fourth degree: the last two coordinates, and the weight relative to the area.
pub fn places() -> Vec<([f64; 2], f64)> {
    points().iter().map(|point| (point.place(), 2.0 * point.weight)).collect()
}

/// Forces (N) on nodes, each once or more often.
type Load = Vec<(usize, DVec3)>;

/// A body with the pairs that act on it.
#[derive(Debug)]
pub struct Carrier {
    solid: Solid,
    pairs: Vec<OnNodes>,
    /// What its supports and loads elsewhere displace (m), three values a node.
    given: Vec<f64>,
}

impl Carrier {
    /// A body with its equations factorised.
    ///
    /// # Errors
    /// If the equations are singular, or there is no memory for them.
    pub fn new(
        (finite, volume): (&Finite, &Arc<Volume>),
        material: &Material,
        pairs: Vec<OnNodes>,
    ) -> Result<Self, SolveError> {
        let solid = Solid::new(finite, volume, material)?;
        let given = solid.under_its_loads(finite);
        Ok(Self { solid, pairs, given })
    }

    pub(super) fn volume(&self) -> &Arc<Volume> {
        &self.solid.volume
    }

    pub(super) fn material(&self) -> &Material {
        &self.solid.material
    }

    /// Displacements (m) of the pairs along their axes, three a pair, that supports and loads elsewhere make.
    pub fn free(&self) -> Vec<f64> {
        self.seen(|node| DVec3::from_slice(&self.given[3 * node..][..3]))
    }

    /// The same under tractions (Pa) of the pairs alone, three a pair.
    pub fn displaced(&self, tractions: &[f64]) -> Vec<f64> {
        let sought = self.solid.sought(&[self.load(tractions)]);
        self.seen(|node| self.solid.moved(&sought, 0, node))
    }

    /// The same under a unit traction along each axis of some pairs, a vector each.
    pub fn columns(&self, acting: &[usize]) -> Vec<Vec<f64>> {
        let of_pair = |pair: &OnNodes| {
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|unit| -> Load {
                let force = |(node, share): &(usize, Share)| (*node, pair.force(&unit, *share));
                pair.shares.iter().map(force).collect()
            })
        };
        let loads: Vec<Load> = acting.iter().flat_map(|pair| of_pair(&self.pairs[*pair])).collect();
        let sought = self.solid.sought(&loads);
        let columns = (0..loads.len()).into_par_iter();
        columns.map(|load| self.seen(|node| self.solid.moved(&sought, load, node))).collect()
    }

    /// Displacements (m) of all nodes, three each, under tractions (Pa) of the pairs and all else.
    pub(super) fn nodes(&self, tractions: &[f64]) -> Vec<f64> {
        let sought = self.solid.sought(&[self.load(tractions)]);
        let own = (0..self.solid.nodes.len()).flat_map(|node| {
            let moved = self.solid.moved(&sought, 0, node);
            moved.to_array()
        });
        own.zip(&self.given).map(|(own, given)| own + given).collect()
    }

    /// About what cubic functions and all further degrees would add to the displacements (m) of the pairs under tractions (Pa), three
    /// each.
    pub fn missed(&self, tractions: &[f64]) -> Vec<f64> {
        let sought = self.solid.sought(&[self.load(tractions)]);
        let nodes = 0..self.solid.nodes.len();
        let displaced: Vec<f64> =
            nodes.flat_map(|node| self.solid.moved(&sought, 0, node).to_array()).collect();
        let mut surplus = Surplus::new(&self.solid.volume, 1);
        for (pair, own) in self.pairs.iter().zip(tractions.chunks_exact(3)) {
            for (face, shares) in &pair.beyond {
                surplus.bear(*face, shares.map(|share| pair.force(own, share)));
            }
        }
        let added = surplus.added(&self.solid, displaced);
        let of_pair = |pair: &OnNodes| {
            let nodes = pair.shares.iter().map(|(node, share)| (*share, added.node(*node)));
            let beyond = pair
                .beyond
                .iter()
                .flat_map(|(face, shares)| shares.iter().copied().zip(added.face(*face)));
            pair.seen(nodes.chain(beyond))
        };
        self.pairs.iter().flat_map(of_pair).collect()
    }

    fn load(&self, tractions: &[f64]) -> Load {
        let of_pair = |(pair, own): (&OnNodes, &[f64])| {
            let on_nodes = pair.shares.iter();
            on_nodes.map(|(node, share)| (*node, pair.force(own, *share))).collect::<Load>()
        };
        let acting = self.pairs.iter().zip(tractions.chunks_exact(3));
        acting.filter(|(_, own)| own.iter().any(|one| *one != 0.0)).flat_map(of_pair).collect()
    }

    fn seen(&self, at: impl Fn(usize) -> DVec3) -> Vec<f64> {
        let of_pair =
            |pair: &OnNodes| pair.seen(pair.shares.iter().map(|(node, share)| (*share, at(*node))));
        self.pairs.iter().flat_map(of_pair).collect()
    }
}

impl Solid {
    /// What is sought under loads, a column each.
    fn sought(&self, loads: &[Load]) -> Mat<f64> {
        let mut sought = Mat::zeros(self.unknowns(), loads.len());
        for (load, forces) in loads.iter().enumerate() {
            for (node, force) in forces {
                for along in self.nodes[*node].count..3 {
                    sought[(self.numbers[*node][along], load)] +=
                        force.dot(self.nodes[*node].basis[along]);
                }
            }
        }
        self.solve_sought(&mut sought);
        sought
    }

    /// What a node is displaced by (m) where that was sought, nothing else being displaced.
    fn moved(&self, sought: &Mat<f64>, load: usize, node: usize) -> DVec3 {
        let held = &self.nodes[node];
        let along = (held.count..3)
            .map(|along| sought[(self.numbers[node][along], load)] * held.basis[along]);
        along.sum()
    }

    /// Displacements (m) that supports and loads elsewhere make, three a node.
    fn under_its_loads(&self, finite: &Finite) -> Vec<f64> {
        let mut displacements = vec![0.0; 3 * self.volume.nodes.len()];
        let mut forces = displacements.clone();
        if !finite.supports.iter().any(|(_, support)| support.loads()) {
            return displacements;
        }
        let rule = points();
        for (face, nodes) in self.volume.faces.iter().enumerate() {
            let surface = finite.meshed.mesh.faces[face].surface;
            let support = finite.supports.iter().find(|(own, _)| *own == surface);
            let places = nodes.map(|node| DVec3::from(self.volume.nodes[node]));
            match support.map(|(_, support)| *support) {
                Some(Support::Displacement(given)) => {
                    for node in nodes {
                        let given = given.map(|one| one.unwrap_or(0.0));
                        let held = self.nodes[*node].held(DVec3::from_array(given));
                        for axis in (0..3).filter(|axis| held[*axis] != 0.0) {
                            displacements[3 * node + axis] = held[axis];
                        }
                    }
                }
                Some(support @ (Support::Traction(_) | Support::Pressure(_))) => {
                    for point in &rule {
                        let [_, normal] = point.on(&places);
                        let force = match support {
                            Support::Traction(traction) => {
                                normal.length() * DVec3::from_array(traction)
                            }
                            Support::Pressure(pressure) => -pressure * normal,
                            _ => DVec3::ZERO,
                        };
                        for (node, share) in nodes.iter().zip(point.nodes) {
                            for axis in 0..3 {
                                forces[3 * node + axis] += share * force[axis];
                            }
                        }
                    }
                }
                _ => {}
            }
        }
        let mut all = [displacements];
        self.solve(&mut all, &[forces]);
        let [displacements] = all;
        displacements
    }
}
