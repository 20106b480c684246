//! Every element divided in four.

use std::collections::HashMap;

use super::{Corners, Face, Mesh};

impl Mesh {
    /// The same surface on elements half as long: each is divided at the middles of its edges.
    #[must_use]
    pub fn divided(&self) -> Self {
        let mut divided = Self { faces: vec![], ..self.clone() };
        let mut known = HashMap::new();
        for &Face { corners, surface } in &self.faces {
            let vertices = &mut divided.vertices;
            let mut middle = |ends: &[usize]| {
                let mut key = ends.to_vec();
                key.sort_unstable();
                *known.entry(key).or_insert_with(|| {
                    let sum =
                        |axis: usize| ends.iter().map(|&end| vertices[end][axis]).sum::<f64>();
                    vertices.push([0, 1, 2].map(|axis| sum(axis) / ends.len() as f64));
                    vertices.len() - 1
                })
            };
            let parts = match corners {
                Corners::Triangle([a, b, c]) => {
                    let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|edge| middle(&edge));
                    let parts = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
                    parts.map(Corners::Triangle)
                }
                Corners::Quad([a, b, c, d]) => {
                    let [ab, bc, cd, da] =
                        [[a, b], [b, c], [c, d], [d, a]].map(|edge| middle(&edge));
                    let m = middle(&[a, b, c, d]);
                    let parts = [[a, ab, m, da], [ab, b, bc, m], [m, bc, c, cd], [da, m, cd, d]];
                    parts.map(Corners::Quad)
                }
            };
            divided.faces.extend(parts.map(|corners| Face { corners, surface }));
        }
        divided
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Corners, Face, Mesh};

    #[test]
    fn parts_cover_what_was_divided_and_share_their_edges() {
        let vertices =
            vec![[0.0; 3], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 3.0, 0.0]];
        let faces = [Corners::Quad([0, 1, 2, 3]), Corners::Triangle([3, 2, 4])];
        let faces = faces.map(|corners| Face { corners, surface: 0 }).to_vec();
        let mesh = Mesh { vertices, faces, surfaces: vec!["top".to_owned()] };
        let divided = mesh.divided();
        assert_eq!((divided.faces.len(), divided.vertices.len()), (8, 5 + 4 + 1 + 2));
        let area = |face: usize| divided.area_vector(face)[2];
        assert!((0..4).all(|face| (area(face) - 0.5).abs() < 1e-15));
        assert!((4..8).all(|face| (area(face) - 0.5).abs() < 1e-15));
    }
}
