//! The coefficients of one point's derivative, from one or two neighbours.

use crate::numerics::SAME;

/// How many times a coefficient counts that is negative or takes from downstream. Measured on square
/// grids of spacing h whose points are shaken by up to a share of h: at 4 no inner point extrapolates
/// up to 30 %, and 3 % of them do at 50 % (at 8 fewer, at 3 more). The larger, the more points on a
/// ragged entering edge look to those abreast: coefficients at 20 % are below 5/h at 4 and reach 7/h
/// at 8 and 15/h at 16.
const PENALTY: f64 = 4.0;
/// Weight of diffusion across the direction. A little below one, it decides between the two triangles
/// of a square for the one that damps every oscillation.
const ACROSS: f64 = 0.9;

/// Neighbours with their coefficients (1 / unit of the places), which may be zero.
pub(super) type Row = [(usize, f64); 2];
/// What each neighbour of a row contributes to the derivative of the place along the direction; one together.
pub(super) type Shares = [f64; 2];

/// A neighbour and where it lies from the point, along and across the direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbour {
    pub point: usize,
    pub offset: [f64; 2],
}

impl Neighbour {
    /// What a coefficient costs: the diffusion it brings.
    pub fn cost(&self) -> f64 {
        let [along, across] = self.offset;
        along * along + ACROSS * across * across
    }

    pub fn distance(&self) -> f64 {
        self.offset[0].hypot(self.offset[1])
    }
}

/// Consistent coefficients.
#[derive(Debug)]
pub(super) struct Stencil {
    pub row: Row,
    pub shares: Shares,
    cost: f64,
    /// Sum of coefficients times squared distance (unit of the places).
    pub spread: f64,
    /// Whether some coefficient is negative or takes from downstream.
    pub extrapolates: bool,
}

impl Stencil {
    /// The cheapest one from these neighbours, if there is any.
    pub fn cheapest(neighbours: &[Neighbour]) -> Option<Self> {
        let alone = neighbours.iter().filter_map(Self::of_one);
        let pairs = neighbours.iter().enumerate().flat_map(|(i, first)| {
            neighbours[..i].iter().filter_map(move |second| Self::of_two(first, second))
        });
        alone.chain(pairs).min_by(|a, b| a.cost.total_cmp(&b.cost))
    }

    /// From one neighbour, if it lies along the direction.
    fn of_one(neighbour: &Neighbour) -> Option<Self> {
        let [along, across] = neighbour.offset;
        let aligned = across.abs() <= SAME * along.abs();
        aligned.then(|| Self::new([(neighbour, -1.0 / along), (neighbour, 0.0)]))
    }

    /// From two neighbours in different directions.
    fn of_two(first: &Neighbour, second: &Neighbour) -> Option<Self> {
        let (a, b) = (first.offset, second.offset);
        let area = a[0] * b[1] - a[1] * b[0];
        let apart = area.abs() > SAME * first.distance() * second.distance();
        apart.then(|| Self::new([(first, -b[1] / area), (second, a[1] / area)]))
    }

    fn new(terms: [(&Neighbour, f64); 2]) -> Self {
        let row = terms.map(|(neighbour, weight)| (neighbour.point, weight));
        let shares = terms.map(|(neighbour, weight)| {
            let share = -weight * neighbour.offset[0];
            if share.abs() > SAME { share } else { 0.0 }
        });
        let mut stencil = Self { row, shares, cost: 0.0, spread: 0.0, extrapolates: false };
        for (neighbour, weight) in terms {
            let (distance, size) = (neighbour.distance(), weight.abs());
            let upwind = weight >= 0.0 && neighbour.offset[0] < 0.0;
            stencil.cost += size * neighbour.cost() * if upwind { 1.0 } else { PENALTY };
            stencil.spread += size * distance * distance;
            stencil.extrapolates |= !upwind && size * distance > SAME;
        }
        stencil
    }
}
