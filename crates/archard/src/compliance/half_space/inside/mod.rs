//! Stresses and displacements inside a half-space, under tractions that are even on each element of a uniform frame.
//!
//! Sums of rectangles (`corner.rs`), or of strips (`strip.rs`) under a line of contact, are exact for such tractions: at a point
//! ([`Below::stress`]) corner by corner, far away square by square (`tree.rs`); at all elements in a [plane](Below::plane) below the
//! surface by convolution. What tractions vary by within an element is added (`slope.rs`). Where a body has layers (`layers.rs`), each
//! adds images (`rest.rs`, `far.rs`). Tractions that repeat themselves with the frame are waves (`waves.rs`).

mod corner;
mod far;
mod layers;
mod plane;
mod rest;
mod slope;
mod stacked;
mod strip;
mod sums;
#[cfg(test)]
mod tests;
mod tree;
mod waves;

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::{Arc, OnceLock};

use rayon::prelude::*;

use crate::body::Material;
use crate::frame::{ContactFrame, VectorField};
use crate::numerics::convolution::Convolution;
use crate::stress::Components;
use layers::Layers;
use tree::Tree;
use waves::Waves;

/// What is below even tractions on the elements of a uniform frame.
///
/// Its axes are those of the body: x and y of the frame, z = 0 on the surface and negative in the body.
pub struct Below {
    /// The uppermost material.
    material: Material,
    /// Its layers and what is below them.
    layers: Option<Arc<Layers>>,
    /// The one that it is asked about, whatever the depth; `None` for the one at the depth.
    piece: Option<usize>,
    elements: [usize; 2],
    /// Size of an element along x and y (m).
    spacing: [f64; 2],
    /// The lowest corner of the frame (m).
    corner: [f64; 2],
    /// Tractions on the body along x and y, and into it (Pa), one value an element.
    tractions: Arc<[Vec<f64>; 3]>,
    /// In plane strain: how far below the contact (m) displacements are measured from.
    depth: Option<f64>,
    /// The tractions by squares of elements, once they are needed.
    tree: Arc<OnceLock<Tree>>,
    convolution: Arc<Convolution>,
    /// The tractions as waves, where they repeat themselves with the frame.
    waves: Option<Arc<Waves>>,
}

impl std::fmt::Debug for Below {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Below").field("elements", &self.elements).finish_non_exhaustive()
    }
}

impl Below {
    /// Under tractions (Pa) on the body, along x, y and its outward normal, on a uniform frame; `None` on another one, and under
    /// strips along a line of contact. Under a line displacements are measured from that far (m) below it.
    pub fn new(
        material: &Material,
        frame: &ContactFrame,
        tractions: &VectorField,
        depth: f64,
    ) -> Option<Self> {
        let corner = frame.rectangle().corner();
        let (elements, spacing) = (frame.elements(), frame.spacing());
        let into = tractions.n.iter().map(|normal| -normal).collect();
        let tractions = [tractions.t1.clone(), tractions.t2.clone(), into];
        let depth = frame.is_line().then_some(depth);
        let strips = frame.is_line() && elements[1] > 1;
        (frame.is_uniform() && !strips)
            .then(|| Self::on(*material, (elements, spacing, corner), tractions, depth))
    }

    fn on(
        material: Material,
        (elements, spacing, corner): ([usize; 2], [f64; 2], [f64; 2]),
        tractions: [Vec<f64>; 3],
        depth: Option<f64>,
    ) -> Self {
        Self {
            material,
            layers: None,
            piece: None,
            elements,
            spacing,
            corner,
            tractions: Arc::new(tractions),
            depth,
            tree: Arc::default(),
            convolution: Arc::new(Convolution::padded(elements)),
            waves: None,
        }
    }

    /// The same under tractions that repeat themselves with the frame, whose elements are an even number or one along each axis;
    /// displacements are measured from so far (m) below the contact.
    #[must_use]
    pub fn repeated(self, depth: f64) -> Self {
        Self { waves: Some(Arc::new(Waves::on(self.elements, depth))), ..self }
    }

    /// Whether tractions repeat themselves with the frame.
    pub fn repeats(&self) -> bool {
        self.waves.is_some()
    }

    /// Length (m) of the frame along x and y.
    fn size(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.spacing[axis] * self.elements[axis] as f64)
    }

    /// Under the means of the same tractions over elements of twice the size, one more where their number is odd.
    pub fn coarser(&self) -> Self {
        let [nx, ny] = self.elements;
        let line = self.depth.is_some();
        let [mx, my] = [nx.div_ceil(2), if line { 1 } else { ny.div_ceil(2) }];
        let spacing = [2.0 * self.spacing[0], if line { 1.0 } else { 2.0 } * self.spacing[1]];
        let share = if line { 0.5 } else { 0.25 };
        let mean = |own: &Vec<f64>| {
            let mut coarse = vec![0.0; mx * my];
            for (index, value) in own.iter().enumerate() {
                let row = if line { 0 } else { index / nx / 2 };
                coarse[index % nx / 2 + mx * row] += share * value;
            }
            coarse
        };
        let tractions = self.tractions.each_ref().map(mean);
        let coarser =
            Self::on(self.material, ([mx, my], spacing, self.corner), tractions, self.depth);
        let coarser = Self { layers: self.layers.clone(), piece: self.piece, ..coarser };
        match &self.waves {
            Some(waves) => coarser.repeated(waves.depth()),
            None => coarser,
        }
    }

    /// Size of an element along x and y (m), along x alone under a line of contact.
    pub fn spacing(&self) -> [f64; 2] {
        self.depth.map_or(self.spacing, |_| [self.spacing[0]; 2])
    }

    /// The centre of an element (m).
    pub fn place(&self, element: usize) -> [f64; 2] {
        let index = [element % self.elements[0], element / self.elements[0]];
        [0, 1].map(|axis| self.corner[axis] + self.spacing[axis] * (index[axis] as f64 + 0.5))
    }

    /// Number of elements along x and y.
    pub fn elements(&self) -> [usize; 2] {
        self.elements
    }

    /// Pressure (Pa), one value an element.
    pub fn pressure(&self) -> &[f64] {
        &self.tractions[2]
    }

    /// Whether it is a line of contact in plane strain.
    pub fn is_line(&self) -> bool {
        self.depth.is_some()
    }

    /// The sum of the tractions (Pa) of friction on the body along an axis over all elements, which are equal.
    pub fn push(&self, axis: usize) -> f64 {
        self.tractions[axis].iter().sum()
    }

    /// Whether there is friction along an axis.
    pub fn rubs_along(&self, axis: usize) -> bool {
        self.tractions[axis].iter().any(|traction| *traction != 0.0)
    }

    /// Whether there is friction.
    fn rubs(&self) -> bool {
        self.rubs_along(0) || self.rubs_along(1)
    }

    /// Stress (Pa) at a place (m), in the body or on its surface.
    ///
    /// Up to an element deep it is interpolated from the centres of the elements around: the stresses of even tractions have
    /// steps at their edges.
    pub fn stress(&self, place: [f64; 3]) -> Components {
        let depth = 0.0 - place[2];
        if let Some(waves) = &self.waves {
            return turned(waves.at(self, &[[place[0], place[1]]], depth)[0].0);
        }
        let [hx, hy] = self.spacing();
        if depth >= hx.max(hy) {
            return self.even([place[0], place[1]], depth);
        }
        let cell = [0, 1].map(|axis| (place[axis] - self.corner[axis]) / self.spacing[axis] - 0.5);
        let line = self.depth.is_some();
        let mut stress = [0.0; 6];
        for (right, above) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let at = [cell[0].floor() + f64::from(right), cell[1].floor() + f64::from(above)];
            let share = [0, 1].map(|axis| 1.0 - (cell[axis] - at[axis]).abs());
            let share = if line { share[0] * f64::from(1 - above) } else { share[0] * share[1] };
            if share > 0.0 {
                let own = self.at_centre(at, depth);
                stress.iter_mut().zip(own).for_each(|(sum, own)| *sum += share * own);
            }
        }
        stress
    }

    /// Displacement (m) at a place (m) along x, y and z: from far away, or from its depth under a line of contact and where tractions
    /// repeat themselves.
    pub fn displacement(&self, place: [f64; 3]) -> [f64; 3] {
        self.fields(&[place])[0].0
    }

    /// Displacements (m), as those of [`Below::displacement`], and stresses (Pa), as those of [`Below::stress`], at places (m).
    pub fn fields(&self, places: &[[f64; 3]]) -> Vec<([f64; 3], Components)> {
        let depth = |place: &[f64; 3]| 0.0 - place[2];
        let Some(waves) = &self.waves else {
            let [hx, hy] = self.spacing();
            let field = |place: &[f64; 3]| {
                let z = depth(place);
                let (stress, sum) = self.sums([place[0], place[1]], z);
                let shallow = z < hx.max(hy);
                (self.moved(z, sum), if shallow { self.stress(*place) } else { turned(stress) })
            };
            return places.par_iter().map(field).collect();
        };
        let mut planes: BTreeMap<u64, Vec<usize>> = BTreeMap::new();
        for (index, place) in places.iter().enumerate() {
            planes.entry(depth(place).to_bits()).or_default().push(index);
        }
        let mut fields = vec![Default::default(); places.len()];
        for (z, indices) in planes {
            let z = f64::from_bits(z);
            let at: Vec<_> = indices.iter().map(|own| [places[*own][0], places[*own][1]]).collect();
            for (index, (stress, sum)) in indices.into_iter().zip(waves.at(self, &at, z)) {
                fields[index] = (self.moved(z, sum), turned(stress));
            }
        }
        fields
    }

    /// The displacement (m) along x, y and z at a depth (m), of sums there times twice the shear modulus and into the body.
    fn moved(&self, z: f64, sum: [f64; 3]) -> [f64; 3] {
        let mut moved = sum.map(|value| 0.5 * value / self.material(z).shear_modulus());
        // Far away all is as in what is below the layers.
        let base = self.layers.as_ref().map_or(Some(self.material), |layers| layers.base());
        if let (Some(depth), Some(base), false) = (self.depth, base, self.repeats()) {
            let added = strip::from_depth(base.poisson, depth);
            for axis in 0..3 {
                let all: f64 = self.tractions[axis].iter().sum();
                let each = all * self.spacing[0] / PI;
                moved[axis] += 0.5 * added[axis] * each / base.shear_modulus();
            }
        }
        let [x, y, into] = moved;
        [x, y, -into]
    }

    /// The stress at the centre of an element, which may lie outside of the frame, `depth` (m) below it.
    fn at_centre(&self, index: [f64; 2], depth: f64) -> Components {
        let centre =
            [0, 1].map(|axis| self.corner[axis] + self.spacing[axis] * (index[axis] + 0.5));
        let mut stress = self.even(centre, depth);
        let counts = self.elements;
        if (0..2).all(|axis| (0.0..counts[axis] as f64).contains(&index[axis])) {
            let element = index[0] as usize + counts[0] * index[1] as usize;
            let added = self.varying(depth).at(self, element);
            stress.iter_mut().zip(added).for_each(|(sum, added)| *sum += added);
        }
        stress
    }

    /// The stress (Pa) of even elements at a place and a depth (m); on the surface not finite at the edges of those that are pressed.
    pub fn even(&self, at: [f64; 2], z: f64) -> Components {
        turned(self.sums(at, z).0)
    }
}

/// The stress in the axes of the body, from one with z into it.
fn turned([xx, yy, zz, xy, xz, yz]: Components) -> Components {
    [xx, yy, zz, xy, -xz, -yz]
}
