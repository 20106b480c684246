//! A boundary element in space.

use glam::{DMat3, DVec3};

use super::element::Element;
use crate::numerics::triangle;

/// An element on a face of the mesh.
#[derive(Debug, Clone)]
pub(super) struct Patch {
    pub element: &'static Element,
    /// Place as a polynomial in s and t: coefficients of 1, s, t and s t.
    pub map: [DVec3; 4],
    /// Corners in order.
    pub corners: Vec<DVec3>,
    /// A ball around the element.
    pub centre: DVec3,
    pub radius: f64,
    /// Half the longest extent along s and along t.
    pub half: [f64; 2],
    pub bounds: Bounds,
}

/// The box around an element, along its first edge, across it and along the normal.
#[derive(Debug, Clone)]
pub(super) struct Bounds {
    axes: DMat3,
    centre: DVec3,
    half: DVec3,
}

impl Bounds {
    fn new(corners: &[DVec3]) -> Self {
        let first = (corners[1] - corners[0]).normalize();
        let last = corners[corners.len() - 1] - corners[0];
        let normal = first.cross(last).normalize();
        let axes = DMat3::from_cols(first, normal.cross(first), normal).transpose();
        let seen = corners.iter().map(|corner| axes * *corner);
        let low = seen.clone().fold(DVec3::INFINITY, DVec3::min);
        let high = seen.fold(DVec3::NEG_INFINITY, DVec3::max);
        Self { axes, centre: 0.5 * (low + high), half: 0.5 * (high - low) }
    }

    /// Distance of a point from the box, which is no more than that from the element.
    pub fn distance(&self, point: DVec3) -> f64 {
        ((self.axes * point - self.centre).abs() - self.half).max(DVec3::ZERO).length()
    }
}

impl Patch {
    pub fn new(corners: Vec<DVec3>, element: &'static Element) -> Self {
        let mut map = [DVec3::ZERO; 4];
        for (corner, polynomial) in corners.iter().zip(element.map) {
            for (sum, factor) in map.iter_mut().zip(polynomial) {
                *sum += *factor * *corner;
            }
        }
        let centre = corners.iter().sum::<DVec3>() / corners.len() as f64;
        let radius = corners.iter().map(|corner| corner.distance(centre)).fold(0.0, f64::max);
        let side = |a: usize, b: usize| 0.5 * corners[a].distance(corners[b]);
        let half = match corners.len() {
            3 => [side(0, 1).max(side(1, 2)), side(0, 2).max(side(1, 2))],
            _ => [side(0, 1).max(side(3, 2)), side(0, 3).max(side(1, 2))],
        };
        let bounds = Bounds::new(&corners);
        Self { element, map, corners, centre, radius, half, bounds }
    }

    pub fn triangle(&self) -> bool {
        self.corners.len() == 3
    }

    /// Whether place is linear in s and t.
    pub fn is_parallelogram(&self) -> bool {
        self.map[3].length() <= 1e-9 * self.radius
    }

    /// The place of reference coordinates.
    pub fn at(&self, [s, t]: [f64; 2]) -> DVec3 {
        let [one, along_s, along_t, both] = self.map;
        one + s * along_s + t * along_t + s * t * both
    }

    /// Reference coordinates of the middle, the mean of the corners.
    pub fn middle_reference(&self) -> [f64; 2] {
        if self.triangle() { [1.0 / 3.0; 2] } else { [0.0; 2] }
    }

    /// The place of the middle.
    pub fn middle(&self) -> DVec3 {
        self.at(self.middle_reference())
    }

    /// Derivatives of the place with respect to s and t.
    pub fn tangents(&self, [s, t]: [f64; 2]) -> [DVec3; 2] {
        let [_, along_s, along_t, both] = self.map;
        [along_s + t * both, along_t + s * both]
    }

    /// Outward unit normal.
    pub fn normal(&self, at: [f64; 2]) -> DVec3 {
        self.area_vector(at).normalize()
    }

    /// Outward area vector a unit of reference area.
    pub fn area_vector(&self, at: [f64; 2]) -> DVec3 {
        let [along_s, along_t] = self.tangents(at);
        along_s.cross(along_t)
    }
}

/// Distance of a point from a face, each half taken as plane.
pub fn distance(point: DVec3, corners: &[DVec3]) -> f64 {
    let first = triangle::distance(point, [corners[0], corners[1], corners[2]]);
    match corners.get(3) {
        Some(&fourth) => first.min(triangle::distance(point, [corners[0], corners[2], fourth])),
        None => first,
    }
}
