//! The search for neighbours: points sorted into square cells along and across the direction.

use std::f64::consts::PI;

use super::DegenerateCloud;
use super::stencil::{Neighbour, Stencil};
use crate::numerics::SAME;

/// Parts of the full angle, the nearest point in each being a neighbour: enough to hold the eight
/// around a point of a grid, in any direction. Even, so that the direction parts two of them.
const SECTORS: usize = 32;
/// Cells searched at first, to either side. A choice of cost: the search goes on until it is complete.
const REACH: f64 = 3.0;

pub(super) struct Cloud {
    /// Places along and across the direction, from the cloud's corner.
    places: Vec<[f64; 2]>,
    /// Extent along and across the direction.
    size: [f64; 2],
    /// Side of a cell, about the distance of neighbours.
    side: f64,
    /// Number of cells along and across the direction.
    counts: [usize; 2],
    /// The points in each cell.
    cells: Vec<Vec<usize>>,
}

impl Cloud {
    pub fn new(places: &[[f64; 2]], direction: [f64; 2]) -> Result<Self, DegenerateCloud> {
        let points = places.len();
        if points < 3 {
            return Err(DegenerateCloud::TooFew { points });
        }
        if let Some(point) = places.iter().position(|place| !place.iter().all(|x| x.is_finite())) {
            return Err(DegenerateCloud::NotFinite { point });
        }
        let length = direction[0].hypot(direction[1]);
        if !(length > 0.0 && length.is_finite()) {
            return Err(DegenerateCloud::NoDirection { direction });
        }
        let (places, size) = turned(places, direction.map(|component| component / length));
        let share = (size[0].sqrt() * size[1].sqrt()) / (points as f64).sqrt();
        let side = share.max(size[0].max(size[1]) / points as f64);
        if side == 0.0 {
            return Err(DegenerateCloud::Coincident { points: [0, 1] });
        }
        let counts = size.map(|size| 1 + (size / side) as usize);
        let cells = vec![vec![]; counts[0] * counts[1]];
        let mut cloud = Self { places, size, side, counts, cells };
        for point in 0..points {
            let [along, across] = cloud.cell(cloud.places[point]);
            cloud.cells[along + counts[0] * across].push(point);
        }
        Ok(cloud)
    }

    /// The cell of a place, or the nearest one.
    fn cell(&self, place: [f64; 2]) -> [usize; 2] {
        [0, 1].map(|axis| ((place[axis] / self.side) as usize).min(self.counts[axis] - 1))
    }

    /// The cheapest stencil of a point, searched for well beyond the neighbours it uses.
    pub fn stencil(&self, point: usize) -> Result<Stencil, DegenerateCloud> {
        let mut radius = REACH * self.side;
        loop {
            let whole = radius >= self.size[0].hypot(self.size[1]);
            match Stencil::cheapest(&self.neighbours(point, radius)?) {
                Some(stencil) if whole || 2.0 * stencil.spread <= radius => return Ok(stencil),
                None if whole => return Err(DegenerateCloud::Collinear),
                _ => radius *= 2.0,
            }
        }
    }

    /// The nearest point of each sector, of those in the cells a radius reaches.
    fn neighbours(&self, point: usize, radius: f64) -> Result<Vec<Neighbour>, DegenerateCloud> {
        let place = self.places[point];
        let first = self.cell(place.map(|x| x - radius));
        let last = self.cell(place.map(|x| x + radius));
        let mut nearest: [Option<Neighbour>; SECTORS] = [None; SECTORS];
        for across in first[1]..=last[1] {
            let row = &self.cells[self.counts[0] * across..][first[0]..=last[0]];
            for &other in row.iter().flatten().filter(|&&other| other != point) {
                let offset = [0, 1].map(|axis| self.places[other][axis] - place[axis]);
                let neighbour = Neighbour { point: other, offset };
                if neighbour.distance() <= SAME * self.side {
                    let points = [point.min(other), point.max(other)];
                    return Err(DegenerateCloud::Coincident { points });
                }
                let known = &mut nearest[sector(offset)];
                if known.is_none_or(|known| neighbour.cost() < known.cost()) {
                    *known = Some(neighbour);
                }
            }
        }
        Ok(nearest.into_iter().flatten().collect())
    }
}

/// Places along and across a unit vector, from their common corner, and their extent.
fn turned(places: &[[f64; 2]], [x, y]: [f64; 2]) -> (Vec<[f64; 2]>, [f64; 2]) {
    let turn = |place: &[f64; 2]| [x * place[0] + y * place[1], x * place[1] - y * place[0]];
    let mut turned: Vec<[f64; 2]> = places.iter().map(turn).collect();
    let size = [0, 1].map(|axis| {
        let along = turned.iter().map(|place| place[axis]);
        let corner = along.clone().fold(f64::INFINITY, f64::min);
        let size = along.fold(f64::NEG_INFINITY, f64::max) - corner;
        turned.iter_mut().for_each(|place| place[axis] -= corner);
        size
    });
    (turned, size)
}

/// The sector an offset points to, counted from upstream.
fn sector([along, across]: [f64; 2]) -> usize {
    let turn = 0.5 + 0.5 * across.atan2(along) / PI;
    ((turn * SECTORS as f64) as usize).min(SECTORS - 1)
}
