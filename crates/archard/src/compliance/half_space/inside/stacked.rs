//! What is below tractions where a body has layers.

use std::sync::Arc;

use super::Below;
use super::layers::Layers;
use super::tree::MISSED;
use crate::body::{Layer, Material};

impl Below {
    /// The same below layers from the surface down, with what is below them unless it is rigid.
    #[must_use]
    pub fn layered(self, layers: &[Layer], base: Option<&Material>) -> Self {
        let Some(uppermost) = layers.first() else { return self };
        let layers = Some(Arc::new(Layers::new(layers, base.copied())));
        Self { material: uppermost.material, layers, ..self }
    }

    /// The same in one layer, or below all of them where the index is their number, whatever the depth that is asked for: on an
    /// interface it is one side of it.
    #[must_use]
    pub fn within(&self, piece: usize) -> Self {
        Self {
            piece: Some(piece),
            layers: self.layers.clone(),
            tractions: self.tractions.clone(),
            tree: self.tree.clone(),
            convolution: self.convolution.clone(),
            waves: self.waves.clone(),
            ..*self
        }
    }

    /// How deep (m) each layer begins and ends, then what is below them unless it is rigid: of a body without layers one.
    pub fn pieces(&self) -> Vec<[f64; 2]> {
        let of = |layers: &Arc<Layers>| (0..layers.count()).map(|own| layers.faces(own)).collect();
        self.layers.as_ref().map_or(vec![[0.0, f64::INFINITY]], of)
    }

    /// By how much (Pa) images of layers and sums over squares of elements miss the stresses at a depth (m).
    pub fn missed(&self, depth: f64) -> f64 {
        let images = self.piece(depth).map_or(0.0, |(layers, piece)| layers.missed(piece));
        let squares = if self.is_line() || self.repeats() { 0.0 } else { MISSED };
        let largest = self.tractions.iter().flatten().fold(0.0, |most, t| t.abs().max(most));
        (images + squares) * largest
    }

    /// The layer at a depth (m).
    pub(super) fn piece(&self, depth: f64) -> Option<(&Layers, usize)> {
        let layers = self.layers.as_ref()?;
        Some((layers, self.piece.unwrap_or_else(|| layers.at(depth))))
    }

    /// The material at a depth (m).
    pub(super) fn material(&self, depth: f64) -> Material {
        self.piece(depth).map_or(self.material, |(layers, piece)| layers.material(piece))
    }
}
