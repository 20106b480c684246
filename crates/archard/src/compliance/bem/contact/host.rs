//! The contact zone of a meshed body, seen from the frame.

use std::convert::Infallible;

use glam::DVec3;

use super::super::element::evaluate;
use super::normals::Normals;
use super::outline::outlines;
use super::{super::surface::Surface, along};
use crate::body::{Body, Finite, Interpolation};
use crate::compliance::fem::{OnNodes, places};
use crate::frame::Pairs;
use crate::numerics::SAME;

/// A body with the nodes of its contact zone.
pub(super) struct Host<'a> {
    pub finite: &'a Finite,
    pub surface: Surface,
    /// Whether it is body 1, whose outward normal is that of the frame.
    pub first: bool,
    /// Its index, 0 or 1.
    pub which: usize,
    /// The axes of the frame in the coordinates of the body.
    pub axes: [DVec3; 3],
    /// Places (m) and areas (m^2) of the nodes of tractions.
    places: Vec<DVec3>,
    areas: Vec<f64>,
    /// Nodes of tractions in the zone and their bases {t1, t2, n} in the coordinates of the body.
    pub contact: Vec<(usize, [DVec3; 3])>,
    /// Whether the zone is plane, so that the frame's axes serve everywhere.
    pub plane: bool,
    /// Numbers of pairs along x and y where they form a grid.
    pub elements: Option<[usize; 2]>,
    normals: Normals,
}

impl<'a> Host<'a> {
    /// The zone of a meshed body; `None` where it has none.
    ///
    /// The axes are those of the frame in its coordinates, where another body in the same coordinates gives them.
    pub fn new(body: &'a Body, which: usize, given: Option<[DVec3; 3]>) -> Option<Self> {
        let finite = body.finite.as_ref()?;
        let zone = &finite.meshed.zone;
        if zone.faces.is_empty() {
            return None;
        }
        let surface = Surface::new(&finite.meshed.mesh, finite.interpolation, finite.mirrored);
        let (nodes, elements) = nodes_of(finite, &surface);
        let first = which == 0;
        let sign = if first { 1.0 } else { -1.0 };
        let normals = Normals::new(finite, &surface);
        let Means { places, normals: at_nodes, areas } = match finite.elasticity {
            own if own.bears() => Means::new(finite, &surface, &normals),
            _ => Means {
                places: surface.tractions.iter().map(|node| node.place).collect(),
                normals: normals.at_nodes(finite, &surface),
                areas: surface.tractions.iter().map(|node| node.area).collect(),
            },
        };
        let normal = |traction: usize| sign * at_nodes[traction];
        let axes = given.filter(|_| finite.meshed.placed);
        let axes = axes.unwrap_or_else(|| self::axes(finite, sign, &surface));
        let plane = nodes.iter().all(|&node| normal(node).distance(axes[2]) < SAME);
        let basis = |traction: usize| {
            if plane {
                return axes;
            }
            let n = normal(traction);
            // t1 in the plane of x and n.
            let x = if n.dot(axes[0]).abs() > 0.999 {
                -axes[2] * n.dot(axes[0]).signum()
            } else {
                axes[0]
            };
            let t1 = (x - x.dot(n) * n).normalize();
            // Right-handed in the axes of the frame, which may be left-handed in those of the body.
            let t2 = axes[0].cross(axes[1]).dot(axes[2]).signum() * n.cross(t1);
            [t1, t2, n]
        };
        let contact = nodes.into_iter().map(|node| (node, basis(node))).collect();
        Some(Self {
            finite,
            surface,
            first,
            which,
            axes,
            places,
            areas,
            contact,
            plane,
            elements,
            normals,
        })
    }

    /// How far the smooth surface rises (m) above a place on an element of the zone, by its index there.
    pub fn rise(&self, index: usize, at: [f64; 2]) -> f64 {
        if self.plane {
            return 0.0;
        }
        let face = self.finite.meshed.zone.faces[index];
        self.normals.rise(index, &self.surface.patches[face], at)
    }

    /// The outward normal of the smooth surface at a place on an element of the zone, by its index there.
    pub fn outward(&self, index: usize, at: [f64; 2]) -> DVec3 {
        let face = self.finite.meshed.zone.faces[index];
        self.in_frame(self.normals.at(index, &self.surface.patches[face], at))
    }

    pub fn normals(&self) -> &Normals {
        &self.normals
    }

    /// The same at the pairs.
    fn rises(&self) -> Vec<f64> {
        let mut rises = vec![0.0; self.surface.tractions.len()];
        if self.finite.elasticity.bears() {
            return vec![0.0; self.contact.len()];
        }
        for (index, &face) in self.finite.meshed.zone.faces.iter().enumerate() {
            let nodes = self.surface.patches[face].element.nodes;
            for (node, at) in self.surface.tractions_of(face).zip(nodes) {
                rises[node] = self.rise(index, *at);
            }
        }
        self.contact.iter().map(|(node, _)| rises[*node]).collect()
    }

    /// The pair of each node of tractions; none away from the zone.
    pub fn pair_of(&self) -> Vec<Option<usize>> {
        let mut pair_of = vec![None; self.surface.tractions.len()];
        for (pair, (node, _)) in self.contact.iter().enumerate() {
            pair_of[*node] = Some(pair);
        }
        pair_of
    }

    /// Where the pairs act on the nodes inside the body, by the functions of its elements; `None` of what has no inside.
    pub fn bearing(&self) -> Option<Vec<OnNodes>> {
        let volume = self.finite.meshed.volume.as_ref()?;
        let pair_of = self.pair_of();
        let mut pairs: Vec<OnNodes> =
            self.contact.iter().map(|(_, basis)| OnNodes::along(*basis)).collect();
        for spot in spots(self.finite, &self.surface, &self.normals) {
            let normal = self.sign() * spot.normal;
            for (node, share) in spot.shares(&self.surface) {
                pairs[pair_of[node]?].add((volume, spot.face), spot.at, (share, normal));
            }
        }
        Some(pairs.into_iter().map(OnNodes::gathered).collect())
    }

    /// What a distance (m) along z, by the place in the frame, is along the normal of each pair: there, or in the mean where elements
    /// bear the contact, as they are displaced.
    pub fn closed<E>(&self, distance: impl Fn(DVec3) -> Result<f64, E>) -> Result<Vec<f64>, E> {
        if !self.finite.elasticity.bears() {
            let at = |pair: usize| Ok(distance(self.place(pair))? * self.closing(pair));
            return (0..self.contact.len()).map(at).collect();
        }
        let mut means = vec![0.0; self.contact.len()];
        let pair_of = self.pair_of();
        let closing = self.sign() * self.axes[2];
        for spot in spots(self.finite, &self.surface, &self.normals) {
            let found = distance(self.in_frame(spot.place))? * closing.dot(spot.normal);
            for (node, share) in spot.shares(&self.surface) {
                if let Some(pair) = pair_of[node] {
                    means[pair] += share * found;
                }
            }
        }
        means.iter_mut().enumerate().for_each(|(pair, mean)| *mean /= self.area(pair));
        Ok(means)
    }

    /// How far the plane z = 0 is from the pairs along their normals (m).
    pub fn heights(&self) -> Vec<f64> {
        let Ok(heights) = self.closed(|place| Ok::<_, Infallible>(-self.sign() * place.z));
        heights
    }

    /// The mean of its outward normals along z: zero of a zone that goes all around.
    pub fn looks(&self) -> f64 {
        let faces = &self.finite.meshed.zone.faces;
        let vectors =
            faces.iter().map(|face| DVec3::from(self.finite.meshed.mesh.area_vector(*face)));
        let [sum, all] = vectors.fold([0.0; 2], |[sum, all], vector| {
            [sum + self.in_frame(vector).z, all + vector.length()]
        });
        if all > 0.0 { sum / all } else { 0.0 }
    }

    /// One for body 1, whose outward normal is that of the frame; minus one for body 2.
    fn sign(&self) -> f64 {
        if self.first { 1.0 } else { -1.0 }
    }

    /// The area (m^2) of a pair, mirror images left out.
    pub fn area(&self, pair: usize) -> f64 {
        self.areas[self.contact[pair].0]
    }

    /// The place of a contact node in the axes of the frame (m).
    pub fn place(&self, pair: usize) -> DVec3 {
        self.in_frame(self.places[self.contact[pair].0])
    }

    /// A vector in the axes of the frame.
    pub fn in_frame(&self, vector: DVec3) -> DVec3 {
        along(self.axes, vector)
    }

    /// How much of the approach closes the gap of a pair.
    pub fn closing(&self, pair: usize) -> f64 {
        self.contact[pair].1[2].dot(self.axes[2])
    }

    /// The number of mirror images, the body itself among them.
    pub fn images(&self) -> f64 {
        self.surface.images().len() as f64
    }

    /// The pairs, their gaps those to the plane z = 0.
    pub fn pairs(&self) -> Pairs {
        let count = self.contact.len();
        let heights = self.heights();
        let rises = self.rises();
        let bases = if self.plane {
            vec![]
        } else {
            let bases = self.contact.iter();
            bases.map(|(_, basis)| basis.map(|unit| self.in_frame(unit).to_array())).collect()
        };
        let areas = self.contact.iter();
        Pairs {
            places: (0..count).map(|pair| self.place(pair).to_array()).collect(),
            areas: areas.map(|(node, _)| self.images() * self.areas[*node]).collect(),
            bases,
            gap: heights.iter().zip(rises).map(|(height, rise)| height - rise).collect(),
            outlines: outlines(self),
            elements: self.elements,
            mirrored: self.surface.mirrored,
            closed: false,
        }
    }
}

/// What the nodes of tractions are on the smooth surface.
///
/// Where elements bear the contact, a node meets it in the mean by its function, and its pressure acts along the normals of the surface
/// all around. Its area and its normal are the vector that this adds up to: taken at the node itself, normals would be off by what the
/// mean lies off it, and pressures would alternate however small the elements are.
struct Means {
    places: Vec<DVec3>,
    normals: Vec<DVec3>,
    areas: Vec<f64>,
}

impl Means {
    fn new(finite: &Finite, surface: &Surface, normals: &Normals) -> Self {
        let zero = vec![DVec3::ZERO; surface.tractions.len()];
        let (mut places, mut vectors, mut weights) =
            (zero.clone(), zero, vec![0.0; surface.tractions.len()]);
        for spot in spots(finite, surface, normals) {
            for (node, share) in spot.shares(surface) {
                weights[node] += share;
                places[node] += share * spot.place;
                vectors[node] += share * spot.normal;
            }
        }
        let there = places.iter_mut().zip(weights).filter(|(_, weight)| *weight > 0.0);
        there.for_each(|(place, weight)| *place /= weight);
        let areas = vectors.iter().map(|vector| vector.length()).collect();
        vectors.iter_mut().for_each(|vector| *vector = vector.normalize_or_zero());
        Self { places, normals: vectors, areas }
    }
}

/// A place on the zone that stands for a part of it.
pub(super) struct Spot {
    pub face: usize,
    /// Its last two coordinates on that triangle.
    pub at: [f64; 2],
    /// The area (m^2) that it stands for.
    area: f64,
    /// Its place (m) on the smooth surface and the outward normal there.
    place: DVec3,
    normal: DVec3,
}

impl Spot {
    /// The nodes of tractions around it with their shares of the area (m^2).
    pub fn shares(&self, surface: &Surface) -> impl Iterator<Item = (usize, f64)> {
        let shapes = surface.patches[self.face].element.shape.iter();
        let share = |shape| self.area * evaluate(shape, self.at);
        surface.tractions_of(self.face).zip(shapes.map(share))
    }
}

/// The places of a rule on the triangles of a zone.
pub(super) fn spots(finite: &Finite, surface: &Surface, normals: &Normals) -> Vec<Spot> {
    let rule = places();
    let on_face = |(index, &face): (usize, &usize)| {
        let patch = &surface.patches[face];
        let area = 0.5 * patch.area_vector([0.0; 2]).length();
        let spot = |&(at, weight): &([f64; 2], f64)| {
            let normal = normals.at(index, patch, at);
            let place = patch.at(at) + normals.rise(index, patch, at) * normal;
            Spot { face, at, area: area * weight, place, normal }
        };
        rule.iter().map(spot).collect::<Vec<_>>()
    };
    finite.meshed.zone.faces.iter().enumerate().flat_map(on_face).collect()
}

/// Nodes of tractions in the zone; along x and y where its elements form a grid.
fn nodes_of(finite: &Finite, surface: &Surface) -> (Vec<usize>, Option<[usize; 2]>) {
    let zone = &finite.meshed.zone;
    let Some([nx, ny]) = zone.grid else {
        let mut nodes: Vec<usize> = vec![];
        let mut known = vec![false; surface.tractions.len()];
        for node in zone.faces.iter().flat_map(|&face| surface.tractions_of(face)) {
            if !std::mem::replace(&mut known[node], true) {
                nodes.push(node);
            }
        }
        return (nodes, None);
    };
    // Corners and nodes of a quadrilateral by their places along x and y.
    let local = |a: usize, b: usize| [[0, 3], [1, 2]][a][b];
    let node = |ix: usize, iy: usize, a: usize, b: usize| {
        surface.local[zone.faces[ix + nx * iy]][local(a, b)].traction
    };
    match finite.interpolation {
        Interpolation::Discontinuous => {
            let at = |y: usize| (0..2 * nx).map(move |x| node(x / 2, y / 2, x % 2, y % 2));
            ((0..2 * ny).flat_map(at).collect(), Some([2 * nx, 2 * ny]))
        }
        Interpolation::Continuous => {
            let last = |index: usize, count: usize| (index.min(count - 1), index / count);
            let at = |y: usize| {
                (0..=nx).map(move |x| {
                    let ((ix, a), (iy, b)) = (last(x, nx), last(y, ny));
                    node(ix, iy, a, b)
                })
            };
            ((0..=ny).flat_map(at).collect(), Some([nx + 1, ny + 1]))
        }
    }
}

/// The axes of the frame in the coordinates of the body: n is the outward normal of body 1.
fn axes(finite: &Finite, sign: f64, surface: &Surface) -> [DVec3; 3] {
    if !finite.meshed.placed {
        // The zone lies on top; body 2 is turned over, x and y as they are.
        return [DVec3::X, DVec3::Y, sign * DVec3::Z];
    }
    let faces = &finite.meshed.zone.faces;
    let weighed = |face: &usize| DVec3::from(finite.meshed.mesh.area_vector(*face));
    let mean: DVec3 = surface
        .images()
        .iter()
        .map(|image| *image * faces.iter().map(weighed).sum::<DVec3>())
        .sum();
    crate::body::mesh::axes(sign * mean)
}
