//! Where on an element to evaluate the kernels, for an integral over it to a tolerance.
//!
//! A point far from the element: a product of Gauss rules, their orders chosen from the distance. A near
//! one: the element is halved along its longest extent until each part is far for its size. A point on it:
//! triangles from the point to the edges, in polar coordinates.

use std::array;
use std::f64::consts::FRAC_PI_2;

use glam::{DMat2, DVec2, DVec3};

use super::patch::{Patch, distance};
use crate::numerics::SAME;
use crate::numerics::quadrature::gauss_legendre;

/// Least and largest order of a rule.
pub(super) const ORDERS: (usize, usize) = (2, 24);
/// Order of the rule that finds areas; exact on plane faces.
pub(super) const OF_AREAS: usize = 4;
/// What a rule has to meet of the tolerance, for the sum of all integrals to meet it.
const SAFETY: f64 = 0.05;
/// Order along the distance of polar coordinates, where integrands are polynomials on parallelograms.
const RADIAL: usize = 3;
/// How far a part has to be, relative to half its extent. A choice of cost: nearer parts are halved, farther ones take lower
/// orders, and all meet the tolerance.
const FAR: f64 = 0.8;

/// Rules for one tolerance.
#[derive(Debug, Clone)]
pub(super) struct Rules {
    /// Rules by order.
    line: Vec<Vec<(f64, f64)>>,
    /// The distance from which an order does, relative to half the element's extent.
    reach: Vec<f64>,
}

/// Places on an element's reference face, and the reference area each stands for.
#[derive(Debug, Clone, Default)]
pub(super) struct Places {
    pub s: Vec<f64>,
    pub t: Vec<f64>,
    pub weight: Vec<f64>,
}

impl Places {
    pub fn clear(&mut self) {
        self.s.clear();
        self.t.clear();
        self.weight.clear();
    }

    pub fn len(&self) -> usize {
        self.s.len()
    }

    fn push(&mut self, [s, t]: [f64; 2], weight: f64) {
        self.s.push(s);
        self.t.push(t);
        self.weight.push(weight);
    }

    /// Fills up to a multiple of eight with places that count for nothing.
    pub fn pad(&mut self) {
        while let (Some(&s), Some(&t)) = (self.s.last(), self.t.last())
            && !self.len().is_multiple_of(8)
        {
            self.push([s, t], 0.0);
        }
    }
}

/// A part of a reference face.
#[derive(Clone, Copy)]
enum Part {
    Rectangle { centre: [f64; 2], half: [f64; 2] },
    Triangle([[f64; 2]; 3]),
}

impl Rules {
    /// Rules for that relative error of the integrals.
    pub fn new(tolerance: f64) -> Self {
        let line = (0..=ORDERS.1).map(gauss_legendre).collect();
        let digits = 0.5 * (1.0 / (SAFETY * tolerance)).ln();
        let reach = (0..=ORDERS.1).map(|order| (digits / order as f64).sinh()).collect();
        Self { line, reach }
    }

    /// The order for a place that far away, relative to half the element's extent: a Gauss rule converges as
    /// the ellipse does whose foci are the ends and on which the place lies, a factor (d + sqrt(1 + d^2))^-2 an
    /// order.
    pub fn order(&self, distance: f64) -> usize {
        (ORDERS.0..ORDERS.1).find(|&order| distance >= self.reach[order]).unwrap_or(ORDERS.1)
    }

    /// Orders along s and t for a place that far away (m).
    pub fn orders(&self, patch: &Patch, distance: f64) -> [usize; 2] {
        patch.half.map(|half| self.order(distance / half))
    }

    /// Whether a place that far away (m) needs no parts.
    pub fn far(patch: &Patch, distance: f64) -> bool {
        distance >= FAR * patch.half[0].max(patch.half[1])
    }

    /// Adds a product of rules on the whole element.
    pub fn whole(&self, patch: &Patch, orders: [usize; 2], places: &mut Places) {
        self.on(whole_of(patch), orders, places);
    }

    fn on(&self, part: Part, [along_s, along_t]: [usize; 2], places: &mut Places) {
        match part {
            Part::Rectangle { centre, half } => {
                for (t, weight_t) in &self.line[along_t] {
                    for (s, weight_s) in &self.line[along_s] {
                        let at = [centre[0] + half[0] * s, centre[1] + half[1] * t];
                        places.push(at, weight_s * weight_t * half[0] * half[1]);
                    }
                }
            }
            Part::Triangle([a, b, c]) => {
                let order = along_s.max(along_t);
                let [ab, ac] = [b, c].map(|corner| [corner[0] - a[0], corner[1] - a[1]]);
                let area = (ab[0] * ac[1] - ab[1] * ac[0]).abs();
                for (u, weight_u) in &self.line[order] {
                    let u = 0.5 * (1.0 + u);
                    for (v, weight_v) in &self.line[order] {
                        let v = 0.5 * (1.0 + v) * (1.0 - u);
                        let at = array::from_fn(|axis| a[axis] + u * ab[axis] + v * ac[axis]);
                        places.push(at, 0.25 * area * (1.0 - u) * weight_u * weight_v);
                    }
                }
            }
        }
    }

    /// Adds rules on parts of the element for a place next to it, on all of it for one that is far.
    pub fn near(&self, patch: &Patch, point: DVec3, places: &mut Places) {
        let mut waiting = vec![whole_of(patch)];
        while let Some(part) = waiting.pop() {
            let corners = part.corners(patch);
            let away = distance(point, &corners);
            let side = |a: usize, b: usize| 0.5 * corners[a].distance(corners[b]);
            let half = match corners.len() {
                3 => [side(0, 1).max(side(1, 2)).max(side(0, 2)); 2],
                _ => [side(0, 1).max(side(3, 2)), side(0, 3).max(side(1, 2))],
            };
            // A place on an edge is next to every part.
            let size = half[0].max(half[1]);
            if away >= FAR * size || size <= SAME * patch.radius {
                self.on(part, half.map(|half| self.order(away / half)), places);
            } else {
                waiting.extend(part.divide(half));
            }
        }
    }

    /// Adds places for a point on the element, around which integrands grow as the inverse distance.
    ///
    /// In the plane that touches the element there, each triangle from the point to an edge has a height h;
    /// with u = asinh(tan(angle from the height)) and the distance in parts s of that to the edge the area is
    /// h^2 cosh(u) s du ds.
    pub fn polar(&self, patch: &Patch, at: [f64; 2], places: &mut Places) {
        let tangents = patch.tangents(at);
        let first = tangents[0].normalize();
        let second = tangents[0].cross(tangents[1]).cross(first).normalize();
        let plane = |vector: DVec3| DVec2::new(vector.dot(first), vector.dot(second));
        let to_plane = DMat2::from_cols(plane(tangents[0]), plane(tangents[1]));
        let (to_reference, area) = (to_plane.inverse(), to_plane.determinant().abs());
        let at = DVec2::from(at);
        let corners: Vec<DVec2> = patch
            .element
            .corners
            .iter()
            .map(|&corner| to_plane * (DVec2::from(corner) - at))
            .collect();
        let size = corners.iter().map(|corner| corner.length()).fold(0.0, f64::max);
        for (index, &from) in corners.iter().enumerate() {
            let to = corners[(index + 1) % corners.len()];
            let along = (to - from).normalize();
            let foot = from - from.dot(along) * along;
            let height = foot.length();
            if height < 1e-10 * size {
                continue;
            }
            let limits = [from, to].map(|end| (end.dot(along) / height).asinh());
            let (middle, half) = (0.5 * (limits[0] + limits[1]), 0.5 * (limits[1] - limits[0]));
            // 1 / cosh has its poles at +- i pi / 2.
            let order = self.order(FRAC_PI_2 / half);
            let radial = if patch.is_parallelogram() { RADIAL } else { order };
            for (u, weight_u) in &self.line[order] {
                let u = middle + half * u;
                let edge = foot + height * u.sinh() * along;
                for (share, weight) in &self.line[radial] {
                    let share = 0.5 * (1.0 + share);
                    let weight = 0.5 * weight * weight_u * half * share;
                    let place = at + to_reference * (share * edge);
                    places.push(place.into(), weight * height * height * u.cosh() / area);
                }
            }
        }
    }
}

fn whole_of(patch: &Patch) -> Part {
    if patch.triangle() {
        Part::Triangle([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    } else {
        Part::Rectangle { centre: [0.0; 2], half: [1.0; 2] }
    }
}

impl Part {
    fn corners(&self, patch: &Patch) -> Vec<DVec3> {
        match *self {
            Part::Rectangle { centre: [s, t], half: [hs, ht] } => {
                [[s - hs, t - ht], [s + hs, t - ht], [s + hs, t + ht], [s - hs, t + ht]]
                    .map(|at| patch.at(at))
                    .to_vec()
            }
            Part::Triangle(corners) => corners.map(|at| patch.at(at)).to_vec(),
        }
    }

    /// Two halves of a rectangle across its longer extent, four quarters of a triangle.
    fn divide(self, [along_s, along_t]: [f64; 2]) -> Vec<Part> {
        match self {
            Part::Rectangle { centre, half } => {
                let axis = usize::from(along_t > along_s);
                let mut half = half;
                half[axis] *= 0.5;
                [-1.0, 1.0]
                    .map(|sign| {
                        let mut centre = centre;
                        centre[axis] += sign * half[axis];
                        Part::Rectangle { centre, half }
                    })
                    .to_vec()
            }
            Part::Triangle([a, b, c]) => {
                let middle = |a: [f64; 2], b: [f64; 2]| array::from_fn(|i| 0.5 * (a[i] + b[i]));
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [bc, ca, ab]].map(Part::Triangle).to_vec()
            }
        }
    }
}
