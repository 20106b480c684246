//! Where elements are, and which hang together.

use std::collections::HashSet;

use glam::DVec3;

use super::Mesh;

impl Mesh {
    /// The lowest and the highest corner of the box around elements (m).
    pub fn bounds(&self, faces: impl IntoIterator<Item = usize>) -> [DVec3; 2] {
        let corners = faces.into_iter().flat_map(|face| self.faces[face].corners.as_slice());
        let places = corners.map(|&corner| DVec3::from(self.vertices[corner]));
        places.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], place| {
            [low.min(place), high.max(place)]
        })
    }

    /// The elements that hang together with one by edges, of those that are meant, in their order.
    pub(super) fn together(&self, first: usize, meant: impl Fn(usize) -> bool) -> Vec<usize> {
        let edges = self.faces_at_edges();
        let mut known = HashSet::from([first]);
        let mut found = vec![first];
        let mut next = 0;
        while let Some(&face) = found.get(next) {
            next += 1;
            for [a, b] in self.faces[face].corners.edges() {
                for &(other, _) in &edges[&[a.min(b), a.max(b)]] {
                    if meant(other) && known.insert(other) {
                        found.push(other);
                    }
                }
            }
        }
        found.sort_unstable();
        found
    }
}
