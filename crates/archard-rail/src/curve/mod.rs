//! The smooth curve through the points of a profile.
//!
//! Both coordinates are cubic splines of the length along the polygon of the points, which differs from the length
//! of the curve by a part of (spacing/radius)^2/24. A corner of more than [`Smoothing::corner`] stays a corner, if no
//! other is near: the splines end there and begin anew.

mod meeting;
mod spline;

use crate::sorted::Sorted;
use archard::parameters::Invalid;

/// How a curve follows the points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Smoothing {
    /// Waves of this length (m) keep half of their height, longer ones more, shorter ones less; 0: through every point.
    pub wavelength: f64,
    /// Turns of more than this angle (rad) are corners.
    pub corner: f64,
    /// A corner is one only if no other turn of that size lies within this distance (m).
    pub alone: f64,
}

impl Smoothing {
    /// The curve goes through every point; turns of more than 30 degrees alone within 2 mm are corners.
    pub const NONE: Self =
        Self { wavelength: 0.0, corner: std::f64::consts::FRAC_PI_6, alone: 2e-3 };

    /// The same, where waves of that length (m) keep half of their height.
    pub const fn wavelength(wavelength: f64) -> Self {
        Self { wavelength, ..Self::NONE }
    }
}

/// A place on a curve with what is known about it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// y and z (m).
    pub point: [f64; 2],
    /// Unit vector along the curve: y and z.
    pub tangent: [f64; 2],
    /// Curvature (1/m), positive where the material is convex.
    pub curvature: f64,
}

impl Place {
    /// The unit vector out of the material: y and z.
    pub fn normal(&self) -> [f64; 2] {
        [self.tangent[1], -self.tangent[0]]
    }
}

/// One cubic between two nodes: value, slope, half the second and a sixth of the third derivative, each for y and z.
type Cubic = [[f64; 2]; 4];

/// A curve of cubic pieces.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Lengths (m) along the polygon at the nodes, rising from 0.
    nodes: Sorted,
    /// A cubic for each pair of neighbouring nodes.
    cubics: Vec<Cubic>,
}

impl Curve {
    /// The curve of those points (m).
    ///
    /// # Errors
    /// As [`Profile::curve`](crate::Profile::curve).
    pub fn new(points: &[[f64; 2]], smoothing: Smoothing) -> Result<Self, Invalid> {
        if !(0.0..1.0).contains(&smoothing.wavelength) {
            let message = format!("{} m has to lie between 0 and 1 m", smoothing.wavelength);
            return Err(Invalid::new("wavelength", message));
        }
        let (nodes, points) = apart(points);
        if points.len() < 3 {
            return Err(Invalid::new(
                "points",
                "fewer than three points are apart from each other",
            ));
        }
        let mut ends = vec![0];
        ends.extend(corners(&nodes, &points, smoothing));
        ends.push(nodes.len() - 1);
        let cubics = ends
            .windows(2)
            .flat_map(|end| {
                let range = end[0]..=end[1];
                spline::cubics(&nodes[range.clone()], &points[range], smoothing.wavelength)
            })
            .collect();
        Ok(Self { nodes: Sorted::new(nodes), cubics })
    }

    /// The length (m) along the polygon: places go from 0 to here.
    pub fn length(&self) -> f64 {
        self.nodes().last().copied().unwrap_or_default()
    }

    /// The lengths (m) along the polygon at the points, rising.
    pub fn nodes(&self) -> &[f64] {
        self.nodes.values()
    }

    /// The point (y and z, m) at that length (m) along the polygon; beyond an end, the point on the extension of the
    /// last cubic.
    pub fn point(&self, along: f64) -> [f64; 2] {
        let (cubic, d) = self.piece(along);
        [0, 1].map(|axis| {
            cubic[0][axis] + d * (cubic[1][axis] + d * (cubic[2][axis] + d * cubic[3][axis]))
        })
    }

    /// Point, tangent and curvature at that length (m) along the polygon.
    pub fn place(&self, along: f64) -> Place {
        let (cubic, d) = self.piece(along);
        let slope = [0, 1]
            .map(|axis| cubic[1][axis] + d * (2.0 * cubic[2][axis] + d * 3.0 * cubic[3][axis]));
        let bend = [0, 1].map(|axis| 2.0 * cubic[2][axis] + 6.0 * d * cubic[3][axis]);
        let speed = (slope[0] * slope[0] + slope[1] * slope[1]).sqrt().max(f64::MIN_POSITIVE);
        Place {
            point: self.point(along),
            tangent: slope.map(|value| value / speed),
            curvature: (slope[0] * bend[1] - slope[1] * bend[0]) / speed.powi(3),
        }
    }

    /// The curve turned by that angle (rad) about x, from y towards z, and then moved (y and z, m).
    #[must_use]
    pub fn moved(mut self, angle: f64, by: [f64; 2]) -> Self {
        let (sin, cos) = angle.sin_cos();
        for cubic in &mut self.cubics {
            *cubic = cubic.map(|[y, z]| [y * cos - z * sin, y * sin + z * cos]);
            cubic[0] = [cubic[0][0] + by[0], cubic[0][1] + by[1]];
        }
        self
    }

    /// Lengths (m) along the polygon that hold every node and lie no farther apart than `step` (m).
    pub(crate) fn samples(&self, step: f64) -> Vec<f64> {
        let mut all = vec![0.0];
        for pair in self.nodes().windows(2) {
            let width = pair[1] - pair[0];
            let parts = (width / step).ceil().clamp(1.0, 1e4) as usize;
            all.extend((1..=parts).map(|part| pair[0] + width * part as f64 / parts as f64));
        }
        all
    }

    /// Lengths (m) along the polygon from end to end, evenly and no farther apart than `step` (m).
    pub(crate) fn samples_apart(&self, step: f64) -> Vec<f64> {
        let parts = (self.length() / step).ceil().max(1.0) as usize;
        (0..=parts).map(|part| self.length() * part as f64 / parts as f64).collect()
    }

    fn piece(&self, along: f64) -> (&Cubic, f64) {
        let piece = self.nodes.up_to(along).clamp(1, self.cubics.len()) - 1;
        (&self.cubics[piece], along - self.nodes()[piece])
    }
}

/// Points that lie apart from the one before, and the length of the polygon up to each.
fn apart(points: &[[f64; 2]]) -> (Vec<f64>, Vec<[f64; 2]>) {
    let mut kept: Vec<[f64; 2]> = vec![];
    let mut nodes = vec![];
    for &point in points {
        let step = kept.last().map_or(0.0, |last| distance(*last, point));
        if !kept.is_empty() && step <= crate::oddity::DOUBLED {
            continue;
        }
        nodes.push(nodes.last().map_or(0.0, |last| last + step));
        kept.push(point);
    }
    (nodes, kept)
}

pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The angle (rad, from 0 to pi) by which the way turns at the second of three points.
pub(crate) fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
    (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1]).abs()
}

/// The numbers of the points at which the curve may have a corner.
fn corners(nodes: &[f64], points: &[[f64; 2]], smoothing: Smoothing) -> Vec<usize> {
    let sharp: Vec<usize> = (1..points.len() - 1)
        .filter(|&at| turn(points[at - 1], points[at], points[at + 1]) > smoothing.corner)
        .collect();
    let near = |a: usize, b: usize| nodes[b] - nodes[a] < smoothing.alone;
    (0..sharp.len())
        .filter(|&at| at == 0 || !near(sharp[at - 1], sharp[at]))
        .filter(|&at| at + 1 == sharp.len() || !near(sharp[at], sharp[at + 1]))
        .map(|at| sharp[at])
        .collect()
}

#[cfg(test)]
mod tests;
