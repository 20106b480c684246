//! Half-spaces shifted against each other: the tangential compliance itself.

use super::{HalfSpace, WholeOrPart};
use crate::compliance::{Coarser, SlipMap, StickSlip};

/// The tangential compliance of half-spaces.
#[derive(Debug)]
pub(super) struct Shifting<'a> {
    half_space: WholeOrPart<'a>,
    own: f64,
}

impl<'a> Shifting<'a> {
    pub fn new(half_space: &'a HalfSpace) -> Self {
        Self::on(WholeOrPart::Whole(half_space))
    }

    fn on(half_space: WholeOrPart<'a>) -> Self {
        let own = half_space.influence.tangential_self_term();
        Self { half_space, own }
    }
}

impl SlipMap for Shifting<'_> {
    fn apply(&self, tractions: [&[f64]; 2], slip: [&mut [f64]; 2]) {
        self.half_space.convolution.apply_pair(self.half_space.tangential(), tractions, slip);
    }

    fn own(&self) -> f64 {
        self.own
    }

    /// Division by the spectrum of a frame that repeats itself, as in the normal problem, where the
    /// compliance governs: pairs that stick, and slip as far as its diagonal outweighs their own.
    fn precondition(&self, slip: [&[f64]; 2], rub: &StickSlip, tractions: [&mut [f64]; 2]) {
        let (convolution, inverse) = self.half_space.tangential_inverse();
        let weight = |pair: usize| {
            rub.stick[pair] + rub.slip[pair] * self.own / (self.own + rub.diagonal[pair])
        };
        let roots: Vec<f64> = (0..rub.stick.len()).map(|pair| weight(pair).sqrt()).collect();
        let weighed = slip.map(|slip| -> Vec<f64> {
            slip.iter().zip(&roots).map(|(slip, root)| slip * root).collect()
        });
        let [one, two] = tractions;
        convolution.apply_pair(inverse.each_ref(), [&weighed[0], &weighed[1]], [one, two]);
        for (tractions, slip) in [one, two].into_iter().zip(slip) {
            for (pair, (traction, slip)) in tractions.iter_mut().zip(slip).enumerate() {
                let rest = (1.0 - roots[pair] * roots[pair]) * rub.slip[pair];
                *traction = roots[pair] * *traction + rest * slip / (rub.diagonal[pair] + self.own);
            }
        }
    }

    fn within(&self, elements: [usize; 2]) -> Option<Box<dyn SlipMap + '_>> {
        Some(Box::new(Self::on(WholeOrPart::Part(self.half_space.part(elements)))))
    }

    fn coarser(&self) -> Option<Coarser<'_>> {
        let coarser = self.half_space.coarser();
        let elements = coarser.influence.elements();
        Some(Coarser { map: Box::new(Shifting::new(coarser)), elements, slip: 1.0 })
    }
}
