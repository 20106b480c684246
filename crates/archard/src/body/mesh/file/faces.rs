//! Surfaces divided into smooth faces, which supports and contact can name.

use crate::body::mesh::Mesh;
use crate::body::mesh::smooth::Turns;

impl Mesh {
    /// Divides surfaces at edges where elements turn by more than that (rad): a surface `s` that falls apart becomes
    /// `s_1`, `s_2`, in the order of their first elements; names that are there are left out.
    pub(super) fn split(&mut self, feature_angle: f64, name: impl Fn(&str) -> String) {
        let faces = Turns::of(self).faces(feature_angle);
        // The faces of each surface, in order.
        let mut parts: Vec<Vec<usize>> = vec![vec![]; self.surfaces.len()];
        for (element, face) in self.faces.iter().zip(&faces) {
            if !parts[element.surface].contains(face) {
                parts[element.surface].push(*face);
            }
        }
        let mut names: Vec<String> = vec![];
        let mut first = vec![];
        for (surface, parts) in self.surfaces.iter().zip(&parts) {
            first.push(names.len());
            match parts.len() {
                1 => names.push(surface.clone()),
                count => {
                    let numbered = (1..).map(|part| format!("{}_{part}", name(surface)));
                    let free = numbered.filter(|one| !self.surfaces.contains(one));
                    let free = free.filter(|one| !names.contains(one));
                    names = [&names[..], &free.take(count).collect::<Vec<_>>()].concat();
                }
            }
        }
        for (element, face) in self.faces.iter_mut().zip(&faces) {
            let part = parts[element.surface].iter().position(|part| part == face);
            element.surface = first[element.surface] + part.unwrap_or(0);
        }
        self.surfaces = names;
    }
}
