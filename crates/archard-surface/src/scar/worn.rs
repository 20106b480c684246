//! What is worn off by the readings themselves, under the level that was found, and its uncertainty.
//!
//! Section, depth and width are sums over readings. Each reading has two parts in such a sum: its own, and one through the level and the
//! place. The misfit of the model is wear, and counts in the second alone.

use faer::Mat;

use super::model::{Model, dot};
use super::settle::Settled;

/// Part of the width beyond the scar, on either side, that its section is summed over.
const BEYOND: f64 = 0.05;
/// The part of the width that the parabola of the depth is fitted to: half of it, where a scar hardly differs from a parabola.
const BOTTOM: f64 = 0.5;
/// The width is that at this share of the depth.
pub(super) const EDGE: f64 = 0.05;
/// The weight of a reading below which it says nothing: of four deviations and more.
pub(super) const POOR: f64 = 0.3;
/// Scatter, over the standard deviation of rounding, from which on rounding spreads as noise does: half a step of noise, and the rounding
/// itself.
const DITHERED: f64 = 2.0;
/// Blocks that a depth at the edge is a mean of.
const MEAN: usize = 3;

/// A value and its standard uncertainty.
pub(super) type Found = (f64, f64);

/// Sums over the readings of a profile that lies on its level.
pub(super) struct Worn<'a> {
    model: &'a Model<'a>,
    settled: &'a Settled,
    /// What is worn off at each block (m); of a poor reading what those around it say.
    pub depths: Vec<f64>,
    /// How heights of the unworn body change with the place.
    slopes: Vec<f64>,
    /// The covariance of readings without their misfit, and of the misfit.
    own: Mat<f64>,
    misfit: Mat<f64>,
}

impl<'a> Worn<'a> {
    pub fn of(model: &'a Model<'a>, settled: &'a Settled) -> Self {
        let Settled { shift, grown, scatter, level, residuals, gls, .. } = settled;
        // Wear that the computed shape does not reach is no part of the level, and wear all the same.
        let beyond = |at: usize| settled.debris[at] && residuals[at] < 0.0;
        let weight = |at: usize| if beyond(at) { 1.0 } else { settled.weights[at] };
        let places = &model.blocks.places;
        let worn = model.worn(*shift, *grown);
        let noise = |at: usize| scatter.noise * scatter.noise / weight(at);
        let size = places.len();
        let misfit = Mat::from_fn(size, size, |i, j| {
            worn[i] * worn[j] * scatter.misfit(places[i] - places[j])
        });
        let own = Mat::from_fn(size, size, |i, j| {
            let noise = if i == j { noise(i) } else { 0.0 };
            noise + scatter.texture(places[i] - places[j])
        });
        let solved = gls.covariance.solve(residuals);
        let depth = |at: usize| {
            let unworn =
                (model.nominal)(places[at] - shift) + level[0] + level[1] * model.along[at];
            let smooth = model.blocks.heights[at] - noise(at) * solved[at];
            unworn - if weight(at) > POOR { model.blocks.heights[at] } else { smooth }
        };
        let step = model.near(*grown);
        let slope = |place: &f64| {
            ((model.nominal)(place - shift + step) - (model.nominal)(place - shift - step))
                / (2.0 * step)
        };
        Self {
            model,
            settled,
            depths: (0..size).map(depth).collect(),
            slopes: places.iter().map(slope).collect(),
            own,
            misfit,
        }
    }

    /// How a sum over depths changes with height, tilt, growth and place.
    fn through(&self, shares: &[f64]) -> [f64; 4] {
        let tilt = dot(shares, &self.model.along);
        [shares.iter().sum(), tilt, 0.0, -dot(shares, &self.slopes)]
    }

    /// The variance of a sum over depths that changes so with height, tilt, growth and place.
    fn variance(&self, shares: &[f64], through: [f64; 4]) -> f64 {
        let gls = &self.settled.gls;
        let by = |i: usize| (0..4).map(|j| through[j] * gls.uncertain[(j, i)]).sum::<f64>();
        let by: [f64; 4] = std::array::from_fn(by);
        let level = |at: usize| (0..4).map(|i| by[i] * gls.weighted[i][at]).sum::<f64>();
        let level: Vec<f64> = (0..shares.len()).map(level).collect();
        let all: Vec<f64> = level.iter().zip(shares).map(|(level, own)| level - own).collect();
        square(&self.own, &all) + square(&self.misfit, &level)
    }

    /// A sum over depths.
    fn sum(&self, shares: &[f64]) -> Found {
        (dot(shares, &self.depths), self.variance(shares, self.through(shares)).sqrt())
    }

    /// What all readings may be rounded by together (m): rounding spreads as noise does from half a step of noise on.
    fn rounded(&self) -> f64 {
        let Model { blocks, .. } = self.model;
        let noise =
            self.settled.scatter.noise * blocks.step / blocks.rounding.max(f64::MIN_POSITIVE);
        let scatter = noise.hypot(self.settled.scatter.texture);
        if scatter < DITHERED * blocks.step { blocks.step } else { 0.0 }
    }

    /// From where to where the section is summed (m): over the scar of the model, and on to where readings no longer lie below the level
    /// by more than they scatter.
    fn zone(&self) -> [f64; 2] {
        let Settled { shift, grown, scatter, .. } = self.settled;
        let [low, high] = self.model.shape.extent(*grown);
        let half = high.max(-low) + BEYOND * (high - low);
        let level = scatter.noise.hypot(scatter.texture);
        let [from, to] = edges(&self.model.blocks.places, &self.depths, level)
            .map_or([*shift; 2], |[from, to]| [from.0, to.0]);
        [from.min(shift - half), to.max(shift + half)]
    }

    /// The worn section (m^2), the part of it that was not measured and is the model's, and its change with height, tilt, growth
    /// and place. Differences from the model are summed over readings, and the model between them, so that few are enough.
    pub fn section(&self) -> (Found, f64, [f64; 4]) {
        let Settled { shift, grown, scatter, .. } = self.settled;
        let Model { shape, blocks, .. } = self.model;
        let [low, high] = self.zone();
        let places = &blocks.places;
        let (lengths, mut holes) = blocks.cover();
        let within =
            |at: usize| if low < places[at] && places[at] < high { lengths[at] } else { 0.0 };
        let shares: Vec<f64> = (0..places.len()).map(within).collect();
        let half = 0.5 * blocks.step();
        holes.extend([
            [f64::NEG_INFINITY, places[0] - half],
            [places[places.len() - 1] + half, f64::INFINITY],
        ]);
        let unseen =
            |[from, to]: &[f64; 2]| shape.section_within(*grown, [from - shift, to - shift]);
        let missing: f64 = holes.iter().map(unseen).sum();
        let between =
            |grown: f64| shape.section(grown) - dot(&shares, &self.model.worn(*shift, grown));
        let mut through = self.through(&shares);
        through[2] = (between(1.01 * grown) - between(*grown)) / (0.01 * grown);
        let variance = self.variance(&shares, through) + (scatter.misfit * missing).powi(2);
        let by_steps = shares.iter().sum::<f64>() * self.rounded();
        let deviation = variance.sqrt().hypot(by_steps);
        ((dot(&shares, &self.depths) + between(*grown), deviation), missing, through)
    }

    /// The depth (m) of the parabola through the middle half of the scar, and its weights; `None` where too few readings lie there.
    pub fn depth(&self) -> Option<(Found, Vec<f64>)> {
        let [low, high] = self.model.shape.extent(self.settled.grown);
        let (middle, half) = (self.settled.shift + 0.5 * (low + high), 0.5 * BOTTOM * (high - low));
        let weights =
            deepest(&self.model.blocks.places, &self.depths, [middle - half, middle + half])?;
        let (depth, deviation) = self.sum(&weights);
        Some(((depth, deviation.hypot(self.rounded())), weights))
    }

    /// The width (m) between the places at which a twentieth of the depth is worn off; `None` where one of them was not measured.
    pub fn width(&self, (depth, bottom): (f64, &[f64])) -> Option<Found> {
        let places = &self.model.blocks.places;
        let edges = edges(places, &self.depths, EDGE * depth)?;
        let mut shares: Vec<f64> = vec![0.0; places.len()];
        for (_, slope, at) in edges {
            // The place moves by the depth there less the share of the depth, over the slope.
            let own = 1.0 / slope.abs();
            shares[at - 1..=at + 1].iter_mut().for_each(|share| *share += own / MEAN as f64);
            shares.iter_mut().zip(bottom).for_each(|(share, bottom)| *share -= EDGE * own * bottom);
        }
        let variance = self.variance(&shares, self.through(&shares));
        // Means over three places lie beyond the foot of a wall: as far as those of the model do.
        let Settled { shift, grown, .. } = self.settled;
        let model = self.model.worn(*shift, *grown);
        let [low, high] = self::edges(places, &model, EDGE * dot(bottom, &model))?;
        let exact = self.model.shape.width_at(EDGE, *grown)?;
        let beyond = (high.0 - low.0) - exact;
        Some((edges[1].0 - edges[0].0 - beyond, variance.sqrt()))
    }

    /// How uncertain the section is by what lies next to the scar alone, over what it is by all: `None` where too little lies there.
    pub fn leaning(&self, (uncertainty, through): (f64, [f64; 4])) -> Option<f64> {
        let Settled { shift, grown, scatter, debris, gls, .. } = self.settled;
        let places = &self.model.blocks.places;
        let worn = self.model.worn(*shift, *grown);
        let unworn: Vec<usize> =
            (0..places.len()).filter(|&at| worn[at] <= 0.0 && !debris[at]).collect();
        // A correlation length on either side: one independent reading.
        let step = self.model.blocks.step();
        let least = (scatter.correlated(step) / step).max(3.0);
        let before = unworn.iter().filter(|&&at| places[at] < *shift).count();
        if (before.min(unworn.len() - before) as f64) < least {
            return None;
        }
        let whole = &gls.covariance.whole;
        let part = Mat::from_fn(unworn.len(), unworn.len(), |i, j| whole[(unworn[i], unworn[j])]);
        let columns =
            Mat::from_fn(
                unworn.len(),
                2,
                |i, j| if j == 0 { 1.0 } else { self.model.along[unworn[i]] },
            );
        let by_inverse = super::model::solved(&part, &columns)?;
        let information = columns.transpose() * by_inverse;
        let [[a, b], [_, c]] = [0, 1].map(|i| [0, 1].map(|j| information[(i, j)]));
        let whole = a * c - b * b;
        let [height, tilt] = [through[0], through[1]];
        let variance = (height * height * c - 2.0 * height * tilt * b + tilt * tilt * a) / whole;
        Some(variance.sqrt() / uncertainty)
    }
}

/// A quadratic form.
fn square(matrix: &Mat<f64>, vector: &[f64]) -> f64 {
    let row = |i: usize| (0..vector.len()).map(|j| matrix[(i, j)] * vector[j]).sum::<f64>();
    (0..vector.len()).map(|i| vector[i] * row(i)).sum()
}

/// The weights of depths in that of the parabola through those between two places, at its vertex or at the end next to it.
pub(super) fn deepest(places: &[f64], depths: &[f64], [low, high]: [f64; 2]) -> Option<Vec<f64>> {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let inside: Vec<usize> =
        (0..places.len()).filter(|&at| (low..=high).contains(&places[at])).collect();
    // Three numbers, and one to see that they fit.
    if inside.len() < 4 {
        return None;
    }
    let powers = |at: usize| {
        let x = (places[at] - middle) / half;
        [1.0, x, x * x]
    };
    let columns = Mat::from_fn(inside.len(), 3, |i, j| powers(inside[i])[j]);
    let information = columns.transpose() * &columns;
    let by_inverse = super::model::solved(&information, &columns.transpose().to_owned())?;
    let number = |j: usize| {
        inside.iter().enumerate().map(|(i, &at)| by_inverse[(j, i)] * depths[at]).sum::<f64>()
    };
    let bend = number(2);
    let vertex = if bend < 0.0 { (-0.5 * number(1) / bend).clamp(-1.0, 1.0) } else { 0.0 };
    let mut weights = vec![0.0; places.len()];
    for (i, &at) in inside.iter().enumerate() {
        weights[at] =
            by_inverse[(0, i)] + vertex * by_inverse[(1, i)] + vertex * vertex * by_inverse[(2, i)];
    }
    Some(weights)
}

/// Where depths, averaged over three, first come down to a level on either side of the deepest, with the slope there and the index of the
/// nearest; `None` where one does not.
pub(super) fn edges(places: &[f64], depths: &[f64], level: f64) -> Option<[(f64, f64, usize); 2]> {
    let mean = |at: usize| depths[at - 1..=at + 1].iter().sum::<f64>() / MEAN as f64;
    let inner = 1..depths.len().checked_sub(1)?;
    let deepest = inner.clone().max_by(|&one, &other| mean(one).total_cmp(&mean(other)))?;
    let crossing = |inside: usize, outside: usize| {
        let [one, other] = [mean(inside), mean(outside)];
        let share = (one - level) / (one - other);
        let place = places[inside] + share * (places[outside] - places[inside]);
        let slope = (other - one) / (places[outside] - places[inside]);
        (place, slope, if share < 0.5 { inside } else { outside })
    };
    let low = (inner.start..deepest).rev().find(|&at| mean(at) <= level)?;
    let high = (deepest + 1..inner.end).find(|&at| mean(at) <= level)?;
    Some([crossing(low + 1, low), crossing(high - 1, high)])
}
