//! The integrals of a block of nodes over one element after the other.
//!
//! Elements far from the block are seen equally by all of its nodes, which go through the places of one rule
//! together. Nearer ones are integrated for groups of nodes with the same rule, the nearest for each node by
//! itself.

use glam::DVec3;

use super::assemble::Assembly;
use super::blocks::BLOCK;
use super::element::CURVATURES;
use super::integrate::{Beam, Integrals, NODES, SCRATCH, Spot, Sums, Tile};
use super::kelvin::{DISPLACEMENT, Evaluations};
use super::rules::{ORDERS, Places, Rules};

/// Nodes below which each does better against many places at once than all against one place. A choice of cost: rules meet the
/// tolerance either way.
const FEW: usize = 3;
/// How far a block has to be from an element, relative to half its extent, to be treated as one. A choice of cost: the order is
/// that of its nearest node.
const APART: f64 = 3.0;

/// A block of nodes on its way through the elements.
pub(super) struct Strip<'a> {
    assembly: &'a Assembly<'a>,
    pub nodes: Vec<usize>,
    /// Their places, seen from each image.
    points: Vec<Points>,
    centre: DVec3,
    radius: f64,
    /// Integrals over the last element; what a rigid displacement makes of those so far.
    pub sums: Stock,
    /// Whether there are integrals with each curvature among them.
    pub bent: [bool; CURVATURES],
    /// Those of some of the nodes on their way there.
    some: Stock,
    /// Nodes near to an element, by the orders of their rules.
    near: Vec<([usize; 2], usize)>,
    places: Places,
    spots: Vec<Spot>,
    pub evaluations: Evaluations,
}

/// Coordinates of places, filled up with the last of them.
struct Points([[f64; BLOCK]; 3]);

impl Points {
    fn new(places: impl Iterator<Item = DVec3>) -> Self {
        let mut points = [[0.0; BLOCK]; 3];
        let mut filled = 0;
        for place in places.take(BLOCK) {
            (0..3).for_each(|axis| points[axis][filled] = place[axis]);
            filled += 1;
        }
        for points in &mut points {
            let last = points[filled.saturating_sub(1)];
            points[filled..].fill(last);
        }
        Self(points)
    }

    /// Those of some of the places.
    fn of(&self, some: &[usize]) -> Self {
        Self::new(some.iter().map(|&at| DVec3::from(self.0.map(|points| points[at]))))
    }

    fn up_to(&self, width: usize) -> [&[f64]; 3] {
        self.0.each_ref().map(|points| &points[..width])
    }
}

/// See [`Sums`].
pub(super) struct Stock {
    pub tractions: Vec<f64>,
    pub displacements: Vec<f64>,
    pub rigid: Vec<f64>,
    scratch: Vec<f64>,
}

impl Stock {
    pub fn new() -> Self {
        let zeros = |rows: usize| vec![0.0; rows * BLOCK];
        let scratch = vec![0.0; SCRATCH];
        Self { tractions: zeros(54), displacements: zeros(36), rigid: zeros(9), scratch }
    }

    /// Makes the first values of all rows zero.
    fn clear(&mut self, width: usize) {
        for rows in [&mut self.tractions, &mut self.displacements, &mut self.rigid] {
            rows.chunks_exact_mut(BLOCK).for_each(|row| row[..width].fill(0.0));
        }
    }

    /// Adds the first values of another's rows to those of these nodes.
    fn add(&mut self, other: &Self, nodes: &[usize], displacements: bool) {
        let add = |to: &mut [f64], from: &[f64]| {
            for (to, from) in to.chunks_exact_mut(BLOCK).zip(from.chunks_exact(BLOCK)) {
                nodes.iter().zip(from).for_each(|(&at, value)| to[at] += value);
            }
        };
        add(&mut self.tractions, &other.tractions);
        add(&mut self.rigid, &other.rigid);
        if displacements {
            add(&mut self.displacements, &other.displacements);
        }
    }

    pub fn lend(&mut self) -> Sums<'_> {
        let Self { tractions, displacements, rigid, scratch } = self;
        Sums { tractions, displacements, rigid, scratch }
    }
}

impl<'a> Strip<'a> {
    pub fn new(assembly: &'a Assembly<'a>, nodes: Vec<usize>) -> Self {
        let place = |node: usize| assembly.surface.nodes[node];
        let centre = nodes.iter().map(|&node| place(node)).sum::<DVec3>() / nodes.len() as f64;
        let radius = nodes.iter().map(|&node| place(node).distance(centre)).fold(0.0, f64::max);
        let seen = |image: &DVec3| Points::new(nodes.iter().map(|&node| *image * place(node)));
        let points = assembly.images.iter().map(seen).collect();
        Self {
            assembly,
            nodes,
            points,
            centre,
            radius,
            sums: Stock::new(),
            bent: [false; CURVATURES],
            some: Stock::new(),
            near: vec![],
            places: Places::default(),
            spots: vec![],
            evaluations: Evaluations::default(),
        }
    }

    /// Integrates over an element, seen from all images of the nodes.
    pub fn integrate(&mut self, face: usize) {
        self.sums.tractions.fill(0.0);
        self.bent = [false; CURVATURES];
        if self.assembly.loaded[face] {
            self.sums.displacements.fill(0.0);
        }
        for image in 0..self.assembly.images.len() {
            self.integrate_image(face, image);
        }
    }

    /// Adds the integrals over an element, seen from an image of the nodes.
    fn integrate_image(&mut self, face: usize, index: usize) {
        let assembly = self.assembly;
        let Assembly { surface, rules, images, .. } = assembly;
        let image = images[index];
        let patch = &surface.patches[face];
        let away = (image * self.centre).distance(patch.centre) - self.radius - patch.radius;
        if away >= APART * patch.half[0].max(patch.half[1]) {
            self.tile(face, index, rules.orders(patch, away), None);
            return;
        }
        let mut near = std::mem::take(&mut self.near);
        near.clear();
        let locals = &surface.local[face][..patch.element.nodes.len()];
        for at in 0..self.nodes.len() {
            let node = self.nodes[at];
            let point = surface.nodes[node];
            let own = locals.iter().position(|local| local.node == node);
            if own.is_some() && image * point == point {
                self.beam(face, index, at, own);
                continue;
            }
            let away = patch.bounds.distance(image * point);
            if Rules::far(patch, away) {
                near.push((rules.orders(patch, away), at));
            } else {
                self.beam(face, index, at, None);
            }
        }
        near.sort_unstable();
        for group in near.chunk_by(|one, other| one.0 == other.0) {
            if group.len() < FEW {
                group.iter().for_each(|(_, at)| self.beam(face, index, *at, None));
            } else {
                let nodes: Vec<usize> = group.iter().map(|(_, at)| *at).collect();
                self.tile(face, index, group[0].0, Some(&nodes));
            }
        }
        self.near = near;
    }

    /// Nodes, all of the block or some, against the places of a rule.
    fn tile(&mut self, face: usize, image: usize, orders: [usize; 2], group: Option<&[usize]>) {
        let patch = &self.assembly.surface.patches[face];
        self.places.clear();
        self.assembly.rules.whole(patch, orders, &mut self.places);
        Spot::on(patch, &self.places, &mut self.spots);
        let width = group.map_or(self.nodes.len(), <[usize]>::len).next_multiple_of(8);
        let mut points = &self.points[image];
        let some = group.map(|group| points.of(group));
        if let Some(some) = &some {
            points = some;
        }
        // The two places of the least rule are those of the nodes, where curvatures are zero.
        let has_curvatures = !self.assembly.curvatures[face].is_empty();
        let curvatures = orders.map(|order| has_curvatures && order > ORDERS.0);
        (0..CURVATURES).for_each(|curvature| self.bent[curvature] |= curvatures[curvature]);
        let displacement = self.assembly.loaded[face];
        self.evaluations.count(width * self.spots.len(), displacement);
        let sums = match group {
            None => &mut self.sums,
            Some(_) => &mut self.some,
        };
        if group.is_some() {
            sums.clear(width);
        }
        self.assembly.arch.dispatch(Tile {
            kelvin: self.assembly.kelvin,
            points: points.up_to(width),
            spots: &self.spots,
            nodes: patch.element.nodes.len(),
            curvatures,
            displacement,
            image: self.assembly.images[image].to_array(),
            sums: sums.lend(),
        });
        if let Some(group) = group {
            self.sums.add(&self.some, group, displacement);
        }
    }

    /// One node against places around it, or on the element it lies on itself.
    fn beam(&mut self, face: usize, image: usize, at: usize, own: Option<usize>) {
        let patch = &self.assembly.surface.patches[face];
        let image = self.assembly.images[image];
        let point = image * self.assembly.surface.nodes[self.nodes[at]];
        self.places.clear();
        match own {
            None => self.assembly.rules.near(patch, point, &mut self.places),
            Some(own) => {
                self.assembly.rules.polar(patch, patch.element.nodes[own], &mut self.places);
            }
        }
        self.places.pad();
        self.bent = [!self.assembly.curvatures[face].is_empty(); CURVATURES];
        let displacement = self.assembly.loaded[face];
        self.evaluations.count(self.places.len(), displacement);
        let kelvin = self.assembly.kelvin;
        let (places, scratch) = (&self.places, &mut self.sums.scratch[..]);
        let beam = Beam { kelvin, point, patch, places, displacement, scratch };
        let integrals: Integrals = self.assembly.arch.dispatch(beam);
        for (node, values) in integrals[..patch.element.nodes.len()].iter().enumerate() {
            for i in 0..3 {
                for j in 0..3 {
                    let component = 3 * i + j;
                    let slot = (9 * node + component) * BLOCK + at;
                    self.sums.displacements[slot] += image[i] * values[DISPLACEMENT[i][j]];
                    // The own traction, strongly singular, follows from all others.
                    if own != Some(node) {
                        self.sums.tractions[slot] += image[i] * values[component];
                        let mirror = image[i] * image[j];
                        self.sums.rigid[component * BLOCK + at] += mirror * values[component];
                    }
                }
            }
        }
        for (row, values) in integrals.iter().enumerate().skip(NODES) {
            for component in 0..9 {
                let slot = (9 * row + component) * BLOCK + at;
                self.sums.tractions[slot] += image[component / 3] * values[component];
            }
        }
    }
}
