//! Shells that touch or cross one another: parts of a body that were never united.

use glam::DVec3;
use rayon::prelude::*;

use super::Mesh;
use crate::numerics::SAME;
use crate::numerics::triangle::distance;

impl Mesh {
    /// A place (m) where two of some shells touch or cross; `None` where each lies next to the others or within them.
    pub(super) fn crossing(&self, shells: &[Vec<usize>]) -> Option<[f64; 3]> {
        let near = DVec3::splat(SAME * self.extent());
        let boxes: Vec<[DVec3; 2]> =
            shells.iter().map(|shell| self.bounds(shell.iter().copied())).collect();
        let both = |one: usize, other: usize| {
            let low = boxes[one][0].max(boxes[other][0]) - near;
            let high = boxes[one][1].min(boxes[other][1]) + near;
            low.cmple(high).all().then_some([low, high])
        };
        let pairs = (0..shells.len()).flat_map(|one| (0..one).map(move |other| (one, other)));
        pairs.filter_map(|(one, other)| Some((one, other, both(one, other)?))).find_map(
            |(one, other, common)| {
                let [one, other] = [one, other].map(|shell| self.among(&shells[shell], common));
                self.meet(&one, &other, near.x).or_else(|| self.meet(&other, &one, near.x))
            },
        )
    }

    /// The elements of a shell that reach into a box.
    fn among(&self, shell: &[usize], [low, high]: [DVec3; 2]) -> Vec<usize> {
        let reaches = |face: &usize| {
            let [least, most] = self.bounds([*face]);
            least.cmple(high).all() && most.cmpge(low).all()
        };
        shell.iter().copied().filter(reaches).collect()
    }

    /// A place where an edge of some elements meets others.
    fn meet(&self, edges_of: &[usize], others: &[usize], near: f64) -> Option<[f64; 3]> {
        let triangles: Vec<[DVec3; 3]> = others
            .iter()
            .flat_map(|&face| {
                let corners = self.faces[face].corners.as_slice();
                (2..corners.len()).map(|last| [0, last - 1, last].map(|at| corners[at]))
            })
            .map(|corners| corners.map(|vertex| DVec3::from(self.vertices[vertex])))
            .collect();
        edges_of.par_iter().find_map_first(|&face| {
            self.faces[face].corners.edges().find_map(|edge| {
                let edge = edge.map(|vertex| DVec3::from(self.vertices[vertex]));
                triangles.iter().find_map(|triangle| pierced(edge, *triangle, near))
            })
        })
    }
}

/// Where an edge pierces a triangle, or begins on it.
fn pierced([from, to]: [DVec3; 2], triangle: [DVec3; 3], near: f64) -> Option<[f64; 3]> {
    let [a, b, c] = triangle;
    let (low, high) = (a.min(b).min(c) - near, a.max(b).max(c) + near);
    if from.min(to).cmpgt(high).any() || from.max(to).cmplt(low).any() {
        return None;
    }
    if distance(from, triangle) <= near {
        return Some(from.to_array());
    }
    let normal = (b - a).cross(c - a);
    let [above, below] = [from, to].map(|end| normal.dot(end - a));
    if above * below >= 0.0 {
        return None;
    }
    let place = from + (to - from) * (above / (above - below));
    (distance(place, triangle) <= near).then(|| place.to_array())
}
