//! A boundary element in space.

use glam::{DMat3, DVec3};

use super::element::Element;

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

/// Distance of a point from a face, of which each half is taken as plane.
pub(crate) fn distance(point: DVec3, corners: &[DVec3]) -> f64 {
    let first = from_triangle(point, [corners[0], corners[1], corners[2]]);
    match corners.get(3) {
        Some(&fourth) => first.min(from_triangle(point, [corners[0], corners[2], fourth])),
        None => first,
    }
}

/// Distance of a point from a triangle.
fn from_triangle(point: DVec3, corners: [DVec3; 3]) -> f64 {
    let shares = on_triangle(point, corners);
    let nearest: DVec3 =
        shares.into_iter().zip(corners).map(|(share, corner)| share * corner).sum();
    point.distance(nearest)
}

/// What the corners of a triangle count for at the place nearest to a point (C. Ericson, *Real-Time Collision
/// Detection*, Morgan Kaufmann 2005, section 5.1.5).
pub(super) fn on_triangle(point: DVec3, [a, b, c]: [DVec3; 3]) -> [f64; 3] {
    let (ab, ac, ap) = (b - a, c - a, point - a);
    let normal = ab.cross(ac);
    let square = normal.length_squared();
    if square > 0.0 {
        let v = ap.cross(ac).dot(normal) / square;
        let w = ab.cross(ap).dot(normal) / square;
        if v >= 0.0 && w >= 0.0 && v + w <= 1.0 {
            return [1.0 - v - w, v, w];
        }
    }
    let edge = |from: usize, to: usize| {
        let corners = [a, b, c];
        let along = corners[to] - corners[from];
        let square = along.length_squared();
        let share = (point - corners[from]).dot(along) / square;
        let share = if square > 0.0 { share.clamp(0.0, 1.0) } else { 0.0 };
        let mut shares = [0.0; 3];
        (shares[from], shares[to]) = (1.0 - share, share);
        (point.distance(corners[from] + share * along), shares)
    };
    let edges = [edge(0, 1), edge(1, 2), edge(2, 0)];
    edges.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).map_or([1.0, 0.0, 0.0], |edge| edge.1)
}
