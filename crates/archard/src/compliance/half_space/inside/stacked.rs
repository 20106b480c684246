//! What is below tractions where a body has layers.

use std::f64::consts::PI;
use std::sync::Arc;

use rayon::prelude::*;

use super::Below;
use super::layers::Layers;
use super::rest::{self, Rest};
use crate::body::{Layer, Material};
use crate::stress::Components;

/// Elements that are summed up at once. A choice of effort.
const CHUNK: usize = 4096;

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
            changes: self.changes.clone(),
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

    /// By how much (Pa) images miss the stresses at a depth (m); nothing without layers.
    pub fn missed(&self, depth: f64) -> f64 {
        let Some((layers, piece)) = self.piece(depth) else { return 0.0 };
        let largest = self.tractions.iter().flatten().fold(0.0, |most, t| t.abs().max(most));
        layers.missed(piece) * largest
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

    /// What layers add at a place and a depth (m) to the stress (Pa), and to the displacement times twice the shear modulus there, with z
    /// into the body.
    pub(super) fn rest(&self, at: [f64; 2], z: f64) -> (Components, [f64; 3]) {
        let nothing = ([0.0; 6], [0.0; 3]);
        let Some((layers, piece)) = self.piece(z) else { return nothing };
        let add = |sum: &mut (Components, [f64; 3]), own: &Rest, tractions: [f64; 3]| {
            for ((stress, moved), t) in own.0.iter().zip(&own.1).zip(tractions) {
                sum.0.iter_mut().zip(stress).for_each(|(sum, own)| *sum += t * own);
                sum.1.iter_mut().zip(moved).for_each(|(sum, own)| *sum += t * own);
            }
        };
        if self.depth.is_some() {
            let (seen, mut sum) = (layers.seen(piece, z), nothing);
            for (edge, change) in self.changes.iter() {
                let own = rest::at_edge(&seen, at[0] - edge[0]);
                add(&mut sum, &own, change.map(|change| change / PI));
            }
            return sum;
        }
        let far = layers.far(piece, z);
        let half = self.spacing.map(|h| 0.5 * h);
        let count = self.tractions[2].len();
        let part = |first: usize| {
            let mut sum = nothing;
            for element in first..(first + CHUNK).min(count) {
                let tractions = [0, 1, 2].map(|axis| self.tractions[axis][element]);
                if tractions != [0.0; 3] {
                    let place = self.place(element);
                    let from = [0, 1].map(|axis| at[axis] - place[axis]);
                    add(&mut sum, &far.element(from, half), tractions);
                }
            }
            sum
        };
        // Summed up in the same order on any number of threads.
        let firsts: Vec<usize> = (0..count).step_by(CHUNK).collect();
        let parts: Vec<_> = firsts.into_par_iter().map(part).collect();
        let mut sum = nothing;
        for (stress, moved) in parts {
            sum.0.iter_mut().zip(stress).for_each(|(sum, own)| *sum += own);
            sum.1.iter_mut().zip(moved).for_each(|(sum, own)| *sum += own);
        }
        sum
    }
}
