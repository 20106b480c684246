//! Steady rolling on half-spaces: the upwind difference taken in the transforms.

use super::HalfSpace;
use crate::compliance::SlipMap;
use crate::frame::Direction;
use crate::numerics::convolution::Difference;

/// The tangential compliance of half-spaces, differenced along the direction of rolling.
#[derive(Debug)]
pub(super) struct Rolling<'a> {
    half_space: &'a HalfSpace,
    direction: Direction,
    difference: Difference,
}

impl<'a> Rolling<'a> {
    pub fn new(half_space: &'a HalfSpace, direction: Direction) -> Self {
        // The pair ahead is the one of higher index.
        let Direction { axis, reversed } = direction;
        let difference = Difference::new(&half_space.convolution, axis, !reversed);
        Self { half_space, direction, difference }
    }
}

impl SlipMap for Rolling<'_> {
    fn apply(&self, tractions: [&[f64]; 2], slip: [&mut [f64]; 2]) {
        let kernels = self.half_space.tangential();
        self.half_space.convolution.apply_differenced(kernels, &self.difference, tractions, slip);
    }

    fn own(&self) -> f64 {
        self.half_space.influence.rolling_self_term(self.direction.axis)
    }

    /// Steps of the traction from pair to pair, found as in the normal problem by dividing by the
    /// spectrum of a frame that repeats itself, are summed up from the leading edge on.
    fn undo(&self, slip: [&[f64]; 2], stick: &[f64], tractions: [&mut [f64]; 2]) {
        let (convolution, inverse) = self.half_space.tangential_inverse();
        let [one, two] = tractions;
        convolution.apply_pair(inverse.each_ref(), slip, [one, two]);
        for tractions in [one, two] {
            for plane in self.direction.planes(self.half_space.influence.elements()) {
                let mut sum = 0.0;
                for pair in plane {
                    sum += stick[pair] * tractions[pair];
                    tractions[pair] = stick[pair] * sum;
                }
            }
        }
    }

    fn coarser(&self) -> Option<(Box<dyn SlipMap + '_>, [usize; 2])> {
        let coarser = self.half_space.coarser();
        let elements = coarser.influence.elements();
        Some((Box::new(Rolling::new(coarser, self.direction)), elements))
    }
}
