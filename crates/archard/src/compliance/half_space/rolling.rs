//! Steady rolling on half-spaces: the upwind difference taken in the transforms.

use super::{HalfSpace, WholeOrPart};
use crate::compliance::{Coarser, PairStatus, SlipMap};
use crate::frame::{Direction, Part};
use crate::numerics::convolution::Difference;

/// What stands for the map on slipping pairs, in self terms: on the diagonal, and what is passed on from the pair ahead. A choice
/// of cost: it only preconditions.
const SLIPPING: f64 = 5.0;
const PASSED_ON: f64 = 4.0;

/// The tangential compliance of half-spaces, differenced along the direction of rolling.
#[derive(Debug)]
pub(super) struct Rolling<'a> {
    half_space: WholeOrPart<'a>,
    direction: Direction,
    difference: Difference,
    own: f64,
}

impl<'a> Rolling<'a> {
    pub fn new(half_space: &'a HalfSpace, direction: Direction) -> Self {
        Self::on(WholeOrPart::Whole(half_space), direction)
    }

    fn on(half_space: WholeOrPart<'a>, direction: Direction) -> Self {
        // The pair ahead is the one of higher index.
        let Direction { axis, reversed } = direction;
        let difference = Difference::new(&half_space.convolution, axis, !reversed);
        let own = half_space.influence.rolling_self_term(axis);
        Self { half_space, direction, difference, own }
    }
}

impl SlipMap for Rolling<'_> {
    fn apply(&self, tractions: [&[f64]; 2], slip: [&mut [f64]; 2]) {
        let kernels = self.half_space.tangential();
        self.half_space.convolution.apply_differenced(kernels, &self.difference, tractions, slip);
    }

    fn own(&self) -> f64 {
        self.own
    }

    /// Where pairs stick, steps of the traction from pair to pair, found as in the normal problem by
    /// dividing by the spectrum of a frame that repeats itself, are summed up from the leading edge on.
    /// Where they slip, a recursion along the line stands for the map.
    fn precondition(&self, slip: [&[f64]; 2], status: &[PairStatus], tractions: [&mut [f64]; 2]) {
        let (convolution, inverse) = self.half_space.tangential_inverse();
        let sticking = slip.map(|slip| -> Vec<f64> {
            let sticks = |status: &PairStatus| *status == PairStatus::Stick;
            let values = slip.iter().zip(status);
            values.map(|(slip, status)| if sticks(status) { *slip } else { 0.0 }).collect()
        });
        let [one, two] = tractions;
        convolution.apply_pair(inverse.each_ref(), [&sticking[0], &sticking[1]], [one, two]);
        let elements = self.half_space.influence.elements();
        for (tractions, slip) in [one, two].into_iter().zip(slip) {
            for line in self.direction.lines(elements) {
                let (mut sum, mut passed) = (0.0, 0.0);
                for pair in line {
                    (tractions[pair], passed) = match status[pair] {
                        PairStatus::Open => (0.0, 0.0),
                        PairStatus::Stick => {
                            sum += tractions[pair];
                            (sum, 0.0)
                        }
                        PairStatus::Slip { diagonal } => {
                            let slip = slip[pair] + PASSED_ON * self.own * passed;
                            let passed = slip / (diagonal + SLIPPING * self.own);
                            (passed, passed)
                        }
                    };
                }
            }
        }
    }

    fn within(&self, part: &Part) -> Option<Box<dyn SlipMap + '_>> {
        let part = WholeOrPart::Part(self.half_space.part(part.size()));
        Some(Box::new(Rolling::on(part, self.direction)))
    }

    fn coarser(&self) -> Option<Coarser<'_>> {
        let coarser = self.half_space.on_coarser();
        let elements = coarser.influence.elements();
        // Passing an element of twice the size takes twice the slip.
        let map = Box::new(Rolling::new(coarser, self.direction));
        Some(Coarser { map, elements, slip: 2.0 })
    }
}
