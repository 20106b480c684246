//! Rings of elements away from what is meshed already, coarser with every ring where there is room.
//!
//! A front of vertices advances along rays, one a vertex. Between two pinned rays two neighbouring
//! edges become one wherever the longer edge still fits the ring; three triangles make the
//! transition. An odd number of edges leaves the middle one alone or joins it with both neighbours, so
//! that symmetric fronts stay symmetric.

use std::f64::consts::FRAC_PI_8;

use super::axis::Axis;
use super::builder::Builder;

/// The front of a mesh that grows ring by ring.
///
/// Walking along it, seen from outside, the meshed part lies on the left. A closed front names its
/// first ray again at the end.
#[derive(Debug)]
pub(super) struct Rings<'a> {
    /// The mesh.
    pub builder: &'a mut Builder,
    /// The part of the surface new elements belong to.
    pub surface: usize,
    /// The rays the front still has.
    rays: Vec<usize>,
    vertices: Vec<usize>,
    pinned: Vec<bool>,
}

impl<'a> Rings<'a> {
    /// The front of these vertices; the pinned ones are never left out.
    pub fn new(
        builder: &'a mut Builder,
        surface: usize,
        vertices: Vec<usize>,
        pinned: Vec<bool>,
    ) -> Self {
        Self { builder, surface, rays: (0..vertices.len()).collect(), vertices, pinned }
    }

    /// Adds a ring: to where `place` (m) puts the rays, joining edges where the longer one `fits`.
    pub fn advance(
        &mut self,
        place: impl Fn(usize) -> [f64; 3],
        fits: impl Fn(usize, usize) -> bool,
    ) {
        let groups = self.groups(fits);
        let (mut at, mut rays, mut vertices) = (0, vec![self.rays[0]], vec![]);
        vertices.push(self.builder.vertex(place(self.rays[0])));
        for group in groups {
            let near: Vec<usize> = self.vertices[at..=at + group].to_vec();
            at += group;
            let left = vertices[vertices.len() - 1];
            let right = self.builder.vertex(place(self.rays[at]));
            self.element(&near, left, right);
            rays.push(self.rays[at]);
            vertices.push(right);
        }
        (self.rays, self.vertices) = (rays, vertices);
    }

    /// Closes the front with triangles to one vertex.
    pub fn close(self, apex: [f64; 3]) {
        let apex = self.builder.vertex(apex);
        for pair in self.vertices.windows(2) {
            self.builder.triangle(self.surface, [pair[0], apex, pair[1]]);
        }
    }

    /// The rays the front still has.
    pub fn rays(&self) -> &[usize] {
        &self.rays
    }

    /// Elements between one, two or three edges near and one far.
    fn element(&mut self, near: &[usize], left: usize, right: usize) {
        let (builder, surface) = (&mut *self.builder, self.surface);
        match *near {
            [a, b, c] => {
                builder.triangle(surface, [a, left, b]);
                builder.triangle(surface, [b, left, right]);
                builder.triangle(surface, [b, right, c]);
            }
            [a, b, c, d] => {
                builder.triangle(surface, [a, left, b]);
                builder.quad(surface, [b, left, right, c]);
                builder.triangle(surface, [c, right, d]);
            }
            _ => builder.quad(surface, [near[0], left, right, near[near.len() - 1]]),
        }
    }

    /// How many edges become one, along the front.
    fn groups(&self, fits: impl Fn(usize, usize) -> bool) -> Vec<usize> {
        let mut groups = vec![];
        let mut start = 0;
        for end in 1..self.rays.len() {
            if !self.pinned[self.rays[end]] && end + 1 < self.rays.len() {
                continue;
            }
            let joined = joined(end - start);
            let mut at = start;
            let all_fit = joined.iter().all(|&group| {
                at += group;
                group == 1 || fits(self.rays[at - group], self.rays[at])
            });
            groups.extend(if all_fit { joined } else { vec![1; end - start] });
            start = end;
        }
        groups
    }
}

/// That many edges in groups of two, from both ends equally.
fn joined(edges: usize) -> Vec<usize> {
    if edges.is_multiple_of(2) {
        return vec![2; edges / 2];
    }
    let middle = if edges % 4 == 3 { 3 } else { 1 };
    let side = (edges - middle) / 4;
    [vec![2; side], vec![middle], vec![2; side]].concat()
}

/// A ray from the rim of a rectangular zone outwards.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ray {
    /// Where it starts, in the coordinates of the zone (m).
    pub start: [f64; 2],
    /// The azimuth it ends at, as its cosine and sine.
    pub direction: [f64; 2],
}

impl Ray {
    /// The rays from the rim of a zone, counter-clockwise, closed unless a plane of symmetry cuts
    /// it, and whether each is at a corner or on an axis and hence pinned.
    pub fn around(x: &Axis, y: &Axis, mirrored: [bool; 2]) -> (Vec<Self>, Vec<bool>) {
        let [xs, ys] = [x, y].map(|axis| &axis.places[axis.zone.start..=axis.zone.end]);
        let (a, b) = (xs[xs.len() - 1], ys[ys.len() - 1]);
        let right: Vec<_> = ys.iter().map(|&y| [a, y]).collect();
        let above: Vec<_> = xs.iter().rev().map(|&x| [x, b]).collect();
        let left: Vec<_> = ys.iter().rev().map(|&y| [-a, y]).collect();
        let below: Vec<_> = xs.iter().map(|&x| [x, -b]).collect();
        let sides = match mirrored {
            [true, true] => vec![right, above],
            [true, false] => vec![below, right, above],
            [false, true] => vec![right, above, left],
            [false, false] => vec![right, above, left, below],
        };
        let mut starts = sides.concat();
        starts.dedup();
        let pinned =
            starts.iter().map(|&[x, y]| x == 0.0 || y == 0.0 || (x.abs() == a && y.abs() == b));
        let pinned = pinned.collect();
        (starts.into_iter().map(|start| Self::from(start, [a, b])).collect(), pinned)
    }

    /// The ray from a place on the rim of a zone with that corner. Azimuths are spread evenly along
    /// each side, and not too unevenly over the sides.
    fn from(start: [f64; 2], [a, b]: [f64; 2]) -> Self {
        let right = std::f64::consts::FRAC_PI_2;
        let corner = b.atan2(a).clamp(0.28 * right, 0.72 * right);
        let [x, y] = start.map(f64::abs);
        let azimuth = if x == a { corner * y / b } else { right - (right - corner) * x / a };
        let signed =
            |value: f64, along: f64| if along == 0.0 { 0.0 } else { value.copysign(along) };
        let direction = [signed(azimuth.cos(), start[0]), signed(azimuth.sin(), start[1])];
        Self { start, direction }
    }

    /// Whether the angle (rad) between two rays is at most that, give or take what they are uneven.
    pub fn within(self, other: Self, angle: f64) -> bool {
        distance(self.direction, other.direction) < 1.02 * angle
    }
}

/// The widest angle (rad) an element may take of a circle of that radius (m): an eighth of half a turn,
/// less if the chord would come close to the other side of a wall that thick (m).
pub(super) fn widest_angle(radius: f64, wall: f64) -> f64 {
    let sagitta = 0.25 * wall / radius;
    FRAC_PI_8.min(2.0 * (1.0 - sagitta.min(1.0)).acos())
}

/// Distance of two places.
pub(super) fn distance<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::joined;

    #[test]
    fn groups_are_symmetric_and_complete() {
        for edges in 1..40 {
            let groups = joined(edges);
            assert_eq!(groups.iter().sum::<usize>(), edges);
            assert!(groups.iter().eq(groups.iter().rev()));
            assert!(groups.len() <= edges / 2 + 1);
        }
    }
}
