//! Half-spaces with image fields: bodies of finite shape that touch with flat faces, away from their edges.
//!
//! The compliance is that of half-spaces, by Fourier transforms, and the image fields of the bodies (`bem::image`), which are smooth
//! and of low rank: C = H + Phi K Phi^T with polynomials Phi, averaged over the elements.

mod ends;
mod known;
mod slip;
mod term;

use std::fmt;
use std::sync::{Arc, OnceLock};

use faer::Mat;

use super::bem::contact::ContactError;
use super::{Compliance, HalfSpace, Preconditioner, SlipMap};
use crate::body::Body;
use crate::frame::{ContactFrame, Flow, Part, Rectangle, VectorField};

#[cfg(test)]
mod tests;

pub use ends::Ends;
use known::{Fields, Known};
use slip::Imaged;
use term::Term;

/// The compliance of two bodies that touch with flat faces on a uniform frame, those of finite shape with image fields.
pub struct Image {
    half_space: Arc<HalfSpace>,
    known: Arc<Known>,
    fields: Fields,
    term: Term,
    coarser: OnceLock<Box<Image>>,
}

impl fmt::Debug for Image {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let degree = self.fields.polynomials.degree;
        f.debug_struct("Image").field("degree", &degree).finish_non_exhaustive()
    }
}

impl Image {
    /// The half-spaces of two bodies on a frame, with the image fields of those whose [`Elasticity`](crate::body::Elasticity) says
    /// so.
    ///
    /// # Errors
    /// As [`Image::moved`].
    pub fn new(bodies: [&Body; 2], frame: &ContactFrame) -> Result<Self, ContactError> {
        Self::moved(bodies, [[0.0; 2].into(); 2], frame)
    }

    /// The same of bodies that are moved under the contact by offsets (m). The field is that in the middle: how it differs at the ends
    /// of their ways is [missed](Compliance::missed).
    ///
    /// # Errors
    /// If a face ends within the frame, a body is not held, or equations have no solution.
    pub fn moved(
        bodies: [&Body; 2],
        offsets: [Rectangle; 2],
        frame: &ContactFrame,
    ) -> Result<Self, ContactError> {
        let materials = bodies.map(|body| body.material.as_ref());
        let layers = bodies.map(|body| &body.layers[..]);
        let half_space = Arc::new(HalfSpace::layered(materials, layers, frame));
        let known = Arc::new(Known::new(bodies, offsets, frame.rectangle()));
        let fields = known.over(frame.rectangle())?;
        Ok(Self::of(half_space, known, fields, frame))
    }

    /// Whether bodies with image fields are held, and their faces hold a rectangle, moved under the contact by offsets (m).
    ///
    /// # Errors
    /// If they are not.
    pub fn meets(
        bodies: [&Body; 2],
        offsets: [Rectangle; 2],
        rectangle: Rectangle,
    ) -> Result<(), ContactError> {
        Known::new(bodies, offsets, rectangle).meets()
    }

    fn of(
        half_space: Arc<HalfSpace>,
        known: Arc<Known>,
        fields: Fields,
        frame: &ContactFrame,
    ) -> Self {
        let parts = (Arc::clone(&fields.polynomials), Arc::clone(&fields.compliance));
        let term = Term::new(parts, frame.rectangle(), frame.elements());
        Self { half_space, known, fields, term, coarser: OnceLock::new() }
    }

    /// The same fields on other elements.
    fn beside(&self, half_space: Arc<HalfSpace>, term: Term) -> Self {
        let (known, fields) = (Arc::clone(&self.known), self.fields.clone());
        Self { half_space, known, fields, term, coarser: OnceLock::new() }
    }
}

impl Compliance for Image {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        let mut displacements = self.half_space.apply(tractions);
        self.term.add_all(tractions, &mut displacements);
        displacements
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.half_space.apply_normal(pressure, displacement);
        self.term.add([(2, pressure)], [(2, displacement)]);
    }

    fn normal_self_term(&self) -> f64 {
        self.half_space.normal_self_term()
    }

    fn tangential_self_term(&self, frame: &ContactFrame) -> f64 {
        self.half_space.tangential_self_term(frame)
    }

    /// A body that ends somewhere gives way to friction along its normal as well.
    fn couples(&self) -> bool {
        true
    }

    /// What halving the elements of the bodies changed, the last degree of the polynomials adds, and moving the bodies changes.
    fn missed(&self, tractions: &VectorField) -> Option<f64> {
        let displacements = self.apply(tractions);
        let largest = |field: &VectorField| {
            let of = |pair: usize| field.components().map(|along| along[pair] * along[pair]);
            let squares = (0..field.n.len()).filter(|pair| tractions.n[*pair] != 0.0).map(of);
            squares.map(|own| own.iter().sum::<f64>()).fold(0.0, f64::max).sqrt()
        };
        let of = |compliance: &Arc<Mat<f64>>| {
            let mut changes = VectorField::zeros(tractions.n.len());
            self.term.of(compliance).add_all(tractions, &mut changes);
            largest(&changes)
        };
        let all = largest(&displacements);
        let Fields { change, last, moved, .. } = &self.fields;
        let moved = moved.iter().map(|ends| ends.iter().map(of).fold(0.0, f64::max)).sum::<f64>();
        (all > 0.0).then(|| (of(change) + of(last) + moved) / all)
    }

    fn at_the_rim(&self, pressure: &[f64]) -> f64 {
        let mut smooth = vec![0.0; pressure.len()];
        self.term.add([(2, pressure)], [(2, &mut smooth)]);
        let [columns, rows] = self.term.elements();
        let outermost = |pair: usize| {
            let (x, y) = (pair % columns, pair / columns);
            x == 0 || y == 0 || x + 1 == columns || y + 1 == rows
        };
        let rim = (0..smooth.len()).filter(|pair| outermost(*pair)).map(|pair| smooth[pair]);
        rim.fold(f64::INFINITY, f64::min)
    }

    fn rolling<'a>(&'a self, flow: Flow<'a>) -> Box<dyn SlipMap + 'a> {
        let term = self.term.gained(flow.direction());
        Box::new(Imaged { half_space: self.half_space.rolling(flow), term })
    }

    fn shifting<'a>(&'a self, frame: &'a ContactFrame) -> Box<dyn SlipMap + 'a> {
        let half_space = self.half_space.shifting(frame);
        Box::new(Imaged { half_space, term: self.term.clone() })
    }

    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        self.half_space.normal_preconditioner(addition)
    }

    fn within(&self, part: &Part) -> Option<Box<dyn Compliance + '_>> {
        let half_space = self.half_space.part(part.size());
        Some(Box::new(self.beside(half_space, self.term.within(part))))
    }

    fn on(&self, frame: &ContactFrame) -> Option<Arc<dyn Compliance>> {
        let half_space = self.half_space.part(frame.elements());
        let fields = self.known.over(frame.rectangle()).ok()?;
        Some(Arc::new(Self::of(half_space, Arc::clone(&self.known), fields, frame)))
    }

    fn coarser(&self) -> Option<&dyn Compliance> {
        let made = self.coarser.get_or_init(|| {
            let half_space = Arc::clone(self.half_space.on_coarser());
            Box::new(self.beside(half_space, self.term.coarser()))
        });
        Some(&**made)
    }

    fn least_displacement(&self, away: [usize; 2]) -> f64 {
        self.half_space.least_displacement(away)
    }
}
