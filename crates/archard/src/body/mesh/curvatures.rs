//! The curvatures of a zone that a file describes, from the places of its vertices.
//!
//! They are those of the polynomial of second degree that lies closest to the vertices, along the normal of the zone and
//! the axes of the plane of contact. A zone that is no such polynomial has none: a flat end with a rounding, a wedge, or
//! one that is curved at an angle to the axes.

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use glam::DVec3;

use super::ContactMesh;
use crate::numerics::WRITTEN;

/// What the polynomial may be off by, of the heights it explains, and how much of the curvature may twist.
const OFF: f64 = 0.05;
/// Height of one curvature relative to that of the other below which the zone is a cylinder.
const STRAIGHT: f64 = 0.01;
/// Vertices that are needed at least, and as many as make it worth leaving out the outer half of the zone.
const FEWEST: usize = 8;
const MANY: usize = 24;

impl ContactMesh {
    /// The axes of the plane of contact, the outward normal of the zone the third of them; `None` without a zone.
    pub fn axes(&self, mirrored: [bool; 2]) -> Option<[DVec3; 3]> {
        let area = |&face: &usize| DVec3::from(self.mesh.area_vector(face));
        let mut mean: DVec3 = self.zone.faces.iter().map(area).sum();
        for axis in (0..2).filter(|&axis| mirrored[axis]) {
            mean[axis] = 0.0;
        }
        mean = mean.normalize_or(DVec3::Z);
        for axis in DVec3::AXES {
            if mean.dot(axis).abs() > 1.0 - 1e-6 {
                mean = mean.dot(axis).signum() * axis;
            }
        }
        (!self.zone.faces.is_empty()).then(|| axes(mean))
    }

    /// Curvatures 1/R (1/m) along the axes of the plane of contact, positive where the zone is convex.
    pub fn curvatures(&self, mirrored: [bool; 2]) -> Option<[f64; 2]> {
        let axes = self.axes(mirrored)?;
        if self.has_plane_zone() {
            return Some([0.0; 2]);
        }
        let mut corners: Vec<usize> = self
            .zone
            .faces
            .iter()
            .flat_map(|&face| self.mesh.faces[face].corners.as_slice())
            .copied()
            .collect();
        corners.sort_unstable();
        corners.dedup();
        let seen = |place: DVec3| axes.map(|axis| axis.dot(place));
        let mut places: Vec<[f64; 3]> =
            corners.iter().map(|&corner| seen(self.mesh.vertices[corner].into())).collect();
        for axis in (0..2).filter(|&axis| mirrored[axis]) {
            let images: Vec<_> = corners
                .iter()
                .map(|&corner| {
                    let mut place = DVec3::from(self.mesh.vertices[corner]);
                    place[axis] = -place[axis];
                    seen(place)
                })
                .collect();
            // Of a quarter two images do: they tell the polynomial as well as three.
            places.extend(images);
        }
        let [[x0, x1], [y0, y1]] = [0, 1].map(|axis| range(&places, axis));
        let (middle, half) =
            ([0.5 * (x0 + x1), 0.5 * (y0 + y1)], [0.5 * (x1 - x0), 0.5 * (y1 - y0)]);
        let within = |share: f64| -> Vec<[f64; 3]> {
            let near = |place: &&[f64; 3]| {
                let away = [0, 1].map(|axis| ((place[axis] - middle[axis]) / half[axis]).abs());
                away[0].max(away[1]) <= share
            };
            places.iter().filter(near).copied().collect()
        };
        let inner = within(0.5);
        let places = if inner.len() >= MANY { inner } else { places };
        fit(&places, middle, half)
    }
}

/// The axes of a plane of contact with that normal, of any length: those of space where they nearly are.
pub fn axes(normal: DVec3) -> [DVec3; 3] {
    let n = normal.normalize_or(DVec3::Z);
    let x = if n.x.abs() > 0.9 { DVec3::Y } else { DVec3::X };
    let t1 = (x - x.dot(n) * n).normalize();
    [t1, n.cross(t1), n]
}

fn range(places: &[[f64; 3]], axis: usize) -> [f64; 2] {
    places.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], place| {
        [low.min(place[axis]), high.max(place[axis])]
    })
}

/// Curvatures along x and y of heights at places (m), if they are those of a polynomial of second degree.
fn fit(places: &[[f64; 3]], middle: [f64; 2], half: [f64; 2]) -> Option<[f64; 2]> {
    let [low, high] = range(places, 2);
    if high - low <= WRITTEN * half[0].max(half[1]) {
        return Some([0.0; 2]);
    }
    if places.len() < FEWEST || half.iter().any(|half| *half <= 0.0) {
        return None;
    }
    let terms = |place: &[f64; 3]| {
        let [x, y] = [0, 1].map(|axis| (place[axis] - middle[axis]) / half[axis]);
        [1.0, x, y, x * x, x * y, y * y]
    };
    let matrix = Mat::from_fn(places.len(), 6, |row, term| terms(&places[row])[term]);
    let heights = Mat::from_fn(places.len(), 1, |row, _| places[row][2] - low);
    let found = matrix.qr().solve_lstsq(&heights);
    let found: [f64; 6] = std::array::from_fn(|term| found[(term, 0)]);
    let height = |place| terms(place).iter().zip(found).map(|(term, one)| term * one).sum::<f64>();
    let off =
        places.iter().map(|place| (height(place) - (place[2] - low)).abs()).fold(0.0, f64::max);
    let scale = found[3].abs().max(found[5].abs());
    let sound = found.iter().all(|one| one.is_finite())
        && off <= OFF * (high - low)
        && found[4].abs() <= OFF * scale;
    let curvature = |term: usize, half: f64| {
        let bent = found[term].abs() > STRAIGHT * scale;
        if bent { -2.0 * found[term] / (half * half) } else { 0.0 }
    };
    sound.then(|| [curvature(3, half[0]), curvature(5, half[1])])
}
