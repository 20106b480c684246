//! Place, variances and weights of a profile together: the variances and the place by the restricted likelihood, the weights by expectation.

use std::f64::consts::{LN_2, SQRT_2};

use argmin::core::{CostFunction, Error, Executor, State};
use argmin::solver::neldermead::NelderMead;
use statrs::function::erf::erfc_inv;

use super::FREEDOM;
use super::model::{Gls, Model, Scatter};
use super::place::{self, GROWN};
use super::shape::LEAST;
use crate::outliers::{BY_MEDIAN, median};

/// The misfit of Archard's law to measured scars, as a share of their depth: their closed forms met four of them within 1 to 6 %. The
/// logarithm of the misfit is normal about that of this, with a deviation of one.
const MISFIT: f64 = 0.05;
/// Least misfit: below it the section is that of the readings to a digit more than they have.
const LEAST_MISFIT: f64 = 1e-3;
/// The longest correlation length, over the width: longer ones are those of the form that is sought, and a parabola has
/// three turns.
const LONGEST: f64 = 1.0 / 6.0;
/// Texture, over the depth, beyond which no scar stands out: ten deviations are never reached by chance.
const MOST_TEXTURE: f64 = 0.1;
/// Rounds of variances and weights, at most; they end where the place changes by less than a tenth of its uncertainty.
const ROUNDS: usize = 12;
const STAYS: f64 = 0.1;
/// Steps of the search for variances, place and growth: twenty moves of each corner of the simplex. A choice of cost.
const STEPS: u64 = 140;
/// A texture this share of the most that it may be stands at that bound: the simplex ends so near to it.
const AT_BOUND: f64 = 0.95;
/// Differences of the logarithm of a likelihood below this are none: one half is a standard deviation.
const STILL: f64 = 0.01;
/// The weight of a reading that is debris.
const NONE: f64 = 1e-4;
/// Neighbours that rise together where there is debris.
const DEBRIS: usize = 3;

/// A profile held against a model.
pub(super) struct Settled {
    pub shift: f64,
    pub grown: f64,
    pub scatter: Scatter,
    pub weights: Vec<f64>,
    /// Readings next to the scar that are no part of the level: debris, pile-up, or wear that the computed shape does not reach.
    pub debris: Vec<bool>,
    /// Height (m) and tilt over the profile (m) of the line that heights lie on.
    pub level: [f64; 2],
    /// What is left of the heights (m).
    pub residuals: Vec<f64>,
    /// The fit of height, tilt, growth and place.
    pub gls: Gls,
    /// Whether texture is as large as it may be.
    pub hidden: bool,
}

/// Noise, texture, misfit, and the correlation length of the last two.
const VARIANCES: usize = 4;
/// The logarithm of the growth has so many times the first step of the place, over the width: widths go with the cube root of a section
/// where the body is round.
const BY_GROWTH: f64 = 3.0;

/// Bounds of the logarithms of variances and lengths.
struct Bounds {
    low: [f64; VARIANCES],
    high: [f64; VARIANCES],
}

/// The likelihood of a place, a growth and variances, restricted to what a line leaves of the heights.
struct Likelihood<'a> {
    model: &'a Model<'a>,
    bounds: &'a Bounds,
    weights: &'a [f64],
    shift: f64,
    grown: f64,
}

impl Bounds {
    fn within(&self, logarithms: &[f64]) -> [f64; VARIANCES] {
        std::array::from_fn(|i| logarithms[i].clamp(self.low[i], self.high[i]))
    }
}

impl Likelihood<'_> {
    /// The place and the growth that numbers stand for: one is worth nothing without the other, so both are sought at once.
    fn place(&self, numbers: &[f64]) -> (f64, f64) {
        let shift = self.shift + numbers[VARIANCES] * self.model.shape.width(self.grown);
        (shift, (self.grown * numbers[VARIANCES + 1].exp()).clamp(GROWN[0], GROWN[1]))
    }

    /// The fit with these numbers.
    fn fit(&self, numbers: &[f64]) -> Option<Gls> {
        let (shift, grown) = self.place(numbers);
        let (columns, heights) = self.model.line(shift, grown);
        let scatter = Scatter::of(self.bounds.within(numbers));
        let worn = self.model.worn(shift, grown);
        Gls::of(self.model.covariance(scatter, self.weights, &worn)?, &columns, &heights)
    }
}

impl Scatter {
    fn of(logarithms: [f64; VARIANCES]) -> Self {
        let [noise, texture, misfit, length] = logarithms.map(f64::exp);
        Self { noise, texture, misfit, length }
    }
}

impl CostFunction for Likelihood<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, numbers: &Self::Param) -> Result<f64, Error> {
        let within = self.bounds.within(numbers);
        // A way back from beyond the bounds.
        let beyond: f64 =
            within.iter().zip(numbers).map(|(own, number)| (number - own).powi(2)).sum();
        let prior = 0.5 * (within[2] - MISFIT.ln()).powi(2);
        let likelihood = self.fit(numbers).map_or(-1e12, |fit| fit.likelihood);
        Ok(10.0 * beyond + prior - likelihood)
    }
}

impl Settled {
    /// Of a model; `None` where the readings ask for no scar of its kind anywhere.
    pub fn of(model: &Model<'_>) -> Option<Self> {
        let blocks = model.blocks;
        let noise = white(&blocks.heights).max(LEAST * model.shape.deepest(1.0));
        let (mut shift, mut grown) = place::roughly(model, noise)?;
        let (width, deepest) = (model.shape.width(grown), model.shape.deepest(grown));
        let floor = blocks.rounding.max(LEAST * deepest);
        let most_texture = MOST_TEXTURE * deepest;
        let shortest = 1.5 * blocks.step();
        let longest = (LONGEST * width).max(2.0 * shortest);
        // Heights in steps may be rounded by more than what is sought.
        let bounds = Bounds {
            low: [floor, floor, LEAST_MISFIT, shortest].map(f64::ln),
            high: [deepest.max(floor), most_texture.max(floor), 1.0, longest].map(f64::ln),
        };
        let mut logarithms = bounds.within(&[noise, noise, MISFIT, 0.05 * width].map(f64::ln));
        let mut weights = vec![1.0; blocks.len()];
        let mut debris = vec![false; blocks.len()];
        for round in 1..=ROUNDS {
            let likelihood = Likelihood { model, bounds: &bounds, weights: &weights, shift, grown };
            let found = likelihood.greatest(&logarithms, 0.02 / round as f64)?;
            logarithms = bounds.within(&found);
            let gls = likelihood.fit(&found)?;
            let before = shift;
            (shift, grown) = likelihood.place(&found);
            let scatter = Scatter::of(logarithms);
            weights = expected(&gls, scatter.noise, &weights);
            settle_debris(&mut debris, (&gls.residuals, floor), &model.worn(shift, grown));
            (weights.iter_mut().zip(&debris)).filter(|own| *own.1).for_each(|own| *own.0 = NONE);
            let settled = Self::at((model, scatter), (shift, grown), (&weights, &debris))?;
            if (shift - before).abs() <= STAYS * settled.gls.uncertain[(3, 3)].sqrt() {
                let hidden = scatter.texture.max(floor) > AT_BOUND * most_texture;
                return Some(Self { hidden, ..settled });
            }
        }
        None
    }

    /// The level, and the covariance of all four numbers, at a place and a growth.
    fn at(
        (model, scatter): (&Model<'_>, Scatter),
        (shift, grown): (f64, f64),
        (weights, debris): (&[f64], &[bool]),
    ) -> Option<Self> {
        let (mut columns, heights) = model.linear(shift, grown);
        let covariance = model.covariance(scatter, weights, &model.worn(shift, grown))?;
        let Gls { covariance, numbers, residuals, .. } = Gls::of(covariance, &columns, &heights)?;
        columns.push(model.by_place(shift, grown));
        let gls = Gls::of(covariance, &columns, &heights)?;
        let (weights, debris) = (weights.to_vec(), debris.to_vec());
        let level = [numbers[0], numbers[1]];
        Some(Self { shift, grown, scatter, weights, debris, level, residuals, gls, hidden: false })
    }
}

impl Likelihood<'_> {
    /// The numbers at which it is greatest, by J. A. Nelder's and R. Mead's simplex, from one around logarithms of variances, a place and a growth.
    fn greatest(&self, logarithms: &[f64; VARIANCES], near: f64) -> Option<Vec<f64>> {
        // A factor of two each way for variances.
        let reach = [LN_2; VARIANCES].into_iter().chain([near, BY_GROWTH * near]);
        let start: Vec<f64> = logarithms.iter().copied().chain([0.0; 2]).collect();
        let corner = |(at, reach): (usize, f64)| {
            let mut corner = start.clone();
            corner[at] += reach;
            corner
        };
        let corners: Vec<Vec<f64>> =
            [start.clone()].into_iter().chain(reach.enumerate().map(corner)).collect();
        let solver = NelderMead::new(corners).with_sd_tolerance(STILL).ok()?;
        let own =
            Likelihood { model: self.model, bounds: self.bounds, weights: self.weights, ..*self };
        let ended =
            Executor::new(own, solver).configure(|state| state.max_iters(STEPS)).run().ok()?;
        ended.state().get_best_param().cloned()
    }
}

/// The weights of readings that the white part of what is left of them asks for (K. L. Lange and others, *J. Amer. Statist. Assoc.* 84 (1989) 881).
fn expected(gls: &Gls, noise: f64, weights: &[f64]) -> Vec<f64> {
    let solved = gls.covariance.solve(&gls.residuals);
    let diagonal = gls.covariance.inverse_diagonal();
    let variance = noise * noise;
    let weight = |at: usize| {
        let own = variance / weights[at];
        let error = own * solved[at];
        let left = (own - own * own * diagonal[at]).max(0.0);
        (FREEDOM + 1.0) / (FREEDOM + (error * error + left) / variance)
    };
    (0..weights.len()).map(weight).collect()
}

/// Marks what is no part of the level next to the scar: neighbours that lie off together by more than texture there. Where they rise they
/// are debris and pile-up, where they lie lower they are wear that the computed shape does not reach.
fn settle_debris(debris: &mut [bool], (residuals, least): (&[f64], f64), worn: &[f64]) {
    let unworn: Vec<usize> = (0..worn.len()).filter(|&at| worn[at] <= 0.0).collect();
    // The median of fewer may be that of debris.
    if unworn.len() <= 4 * DEBRIS {
        return;
    }
    let mut own: Vec<f64> = unworn.iter().map(|&at| residuals[at]).collect();
    let middle = median(&mut own).unwrap_or(0.0);
    let mut sizes: Vec<f64> = unworn.iter().map(|&at| (residuals[at] - middle).abs()).collect();
    let spread = (BY_MEDIAN * median(&mut sizes).unwrap_or(0.0)).max(least);
    let bound = SQRT_2 * erfc_inv(0.5 / residuals.len() as f64) * spread;
    for at in 1..residuals.len() - 1 {
        let next: Vec<usize> = (at - 1..=at + 1).filter(|&own| worn[own] <= 0.0).collect();
        let mean = next.iter().map(|&own| residuals[own]).sum::<f64>() / next.len() as f64 - middle;
        if worn[at] <= 0.0 && next.len() > 1 && mean.abs() > bound {
            // It reaches a reading into the scar.
            debris[at - 1..=at + 1].fill(true);
        }
    }
}

/// The standard deviation of white noise in values, by their differences.
fn white(values: &[f64]) -> f64 {
    let steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let middle = median(&mut steps.clone()).unwrap_or(0.0);
    let mut sizes: Vec<f64> = steps.iter().map(|own| (own - middle).abs()).collect();
    BY_MEDIAN * median(&mut sizes).unwrap_or(0.0) / SQRT_2
}
