//! Scattered pairs, with the derivative along the direction in which particles pass them. It is of first order in the
//! distance of the pairs, and so is rolling on them.

use std::sync::OnceLock;

use super::line::{self, Line};
use super::pairs::Pairs;
use super::{Direction, Measure};
use crate::numerics::WRITTEN;
use crate::numerics::upwind::{DegenerateCloud, Derivative};

/// The clouds of a frame by direction, made when first needed.
#[derive(Debug, Clone, Default)]
pub(super) struct Clouds([OnceLock<Result<Cloud, DegenerateCloud>>; 4]);

impl Clouds {
    pub fn along(
        &self,
        direction: Direction,
        pairs: &Pairs,
        measure: Measure<'_>,
    ) -> Result<&Cloud, DegenerateCloud> {
        let index = 2 * direction.axis + usize::from(direction.reversed);
        let made = self.0[index].get_or_init(|| Cloud::new(direction, pairs, measure.side));
        made.as_ref().map_err(|error| *error)
    }
}

/// Pairs passed along a direction, and their images across the plane of symmetry along it.
#[derive(Debug, Clone)]
pub(super) struct Cloud {
    derivative: Derivative,
    /// The pairs whose images follow the pairs themselves.
    images: Vec<usize>,
    /// The side of a mean pair (m): how far a contact rolls in one passage.
    pub side: f64,
    /// The pair nearest to the centre of those that particles reach from others.
    pub middle: usize,
    pub lines: Vec<Line>,
}

impl Cloud {
    fn new(direction: Direction, pairs: &Pairs, side: f64) -> Result<Self, DegenerateCloud> {
        let across = 1 - direction.axis;
        let off = |pair: &usize| pairs.places[*pair][across].abs() > WRITTEN * side;
        let images: Vec<usize> = if pairs.mirrored[across] {
            (0..pairs.places.len()).filter(off).collect()
        } else {
            vec![]
        };
        let mut places: Vec<[f64; 2]> = pairs.places.iter().map(|[x, y, _]| [*x, *y]).collect();
        for &pair in &images {
            let mut image = places[pair];
            image[across] = -image[across];
            places.push(image);
        }
        let flow = direction.forward().map(|component| -component);
        let derivative = Derivative::along(&places, flow)?;
        let from_centre = |pair: &usize| places[*pair][0].hypot(places[*pair][1]);
        let middle = (0..pairs.places.len())
            .filter(|pair| derivative.extrapolated().binary_search(pair).is_err())
            .min_by(|a, b| from_centre(a).total_cmp(&from_centre(b)))
            .unwrap_or_default();
        let lines = line::strips(direction, pairs, side);
        Ok(Self { derivative, images, side, middle, lines })
    }

    /// The derivative of a field that is odd across the plane of symmetry or even, times the side of a mean pair.
    pub fn gained(&self, field: &[f64], odd: bool) -> Vec<f64> {
        let mut gained = self.through(field, odd, Derivative::apply);
        gained.iter_mut().for_each(|gained| *gained *= self.side);
        gained
    }

    /// An even field where particles come from.
    pub fn upstream(&self, field: &[f64]) -> Vec<f64> {
        self.through(field, false, Derivative::upstream)
    }

    fn through(
        &self,
        field: &[f64],
        odd: bool,
        of: impl Fn(&Derivative, &[f64], &mut [f64]),
    ) -> Vec<f64> {
        let sign = if odd { -1.0 } else { 1.0 };
        let images = self.images.iter().map(|&pair| sign * field[pair]);
        let whole: Vec<f64> = field.iter().copied().chain(images).collect();
        let mut out = vec![0.0; whole.len()];
        of(&self.derivative, &whole, &mut out);
        out.truncate(field.len());
        out
    }
}
