//! The scar on a measured profile, held against a computed one.
//!
//! [`Scar::find`] finds where the scar lies, the line that the surface lay on, and how far the wear has gone, together: by generalised least
//! squares whose errors are white noise with outliers, texture, and a misfit of the model as a share of its own depth.
//!
//! 1. readings are averaged over blocks, without their spikes (`blocks`);
//! 2. robust least squares at all shifts find the place (`place`);
//! 3. variances, place and weights are found by the restricted likelihood (`settle`, `model`); debris next to the scar is left out;
//! 4. section, depth and width are those of the readings under the level found; the model has a part in the level alone (`worn`).
//!
//! The level is that of what lies next to the scar, where enough was measured there: less than the correlation length of the surface on
//! either side is refused. Calibration of the instrument is in no uncertainty.

mod blocks;
mod model;
mod place;
mod refusal;
mod settle;
mod shape;
mod worn;

#[cfg(test)]
mod tests;

use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

use blocks::Blocks;
use model::Model;
use settle::Settled;
use worn::Worn;

pub use refusal::NoScar;
pub use shape::Shape;

/// Degrees of freedom of Student's t of the readings (K. L. Lange and others, *J. Amer. Statist. Assoc.* 84 (1989) 881).
const FREEDOM: f64 = 4.0;
/// Fewest readings: five numbers and four variances are found, each by two at least.
const FEWEST: usize = 18;
/// Most of the section that may not have been measured: with a misfit of 5 % the rest is known to a hundredth, then.
const UNSEEN: f64 = 0.2;
/// Uncertainty by what lies next to the scar alone, over that by all, beyond which the shape of the model is the level.
const LEANING: f64 = 3.0;
/// Correlation of growth and height beyond which one stands for the other: four fifths of their variance are common then.
const COMMON: f64 = 0.9;
/// Growths of the section that a model is good for: between its fifth and five times.
const GROWN: [f64; 2] = [0.2, 5.0];

/// A value with its uncertainty, in its own unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The value.
    pub value: f64,
    /// Its standard uncertainty.
    pub standard: f64,
    /// Half of its 95 % interval, by Student's t.
    pub expanded: f64,
}

impl Estimate {
    /// The standard uncertainty whose normal distribution has the same 95 % interval: what few degrees of freedom leave uncertain is in it.
    pub fn normal(&self) -> f64 {
        self.expanded / Normal::standard().inverse_cdf(0.975)
    }
}

/// A scar on a profile.
#[derive(Debug, Clone, PartialEq)]
pub struct Scar {
    /// Where the middle of the contact lies on the profile (m).
    pub place: Estimate,
    /// Height (m) of the unworn body's apex on the profile, at its place.
    pub height: f64,
    /// Tilt of the profile.
    pub tilt: f64,
    /// The section of the computed shape that fits the readings best, over that of the shape given.
    pub grown: Estimate,
    /// Worn section (m^2) by the readings.
    pub section: Estimate,
    /// The part of it (m^2) that was not measured and is that of the model.
    pub unseen: f64,
    /// Depth (m) of the parabola through the middle half of the scar; `None` where too little of it was measured.
    pub depth: Option<Estimate>,
    /// Width (m) at a twentieth of the depth; `None` where one edge was not measured.
    pub width: Option<Estimate>,
    /// From where to where the computed scar reaches (m), on the profile.
    pub extent: [f64; 2],
    /// Standard deviation (m) of white noise of a block of readings.
    pub noise: f64,
    /// Standard deviation of texture (m).
    pub texture: f64,
    /// Standard deviation of the misfit of the computed shape, as a share of its depth.
    pub misfit: f64,
    /// Correlation length (m) of noise and texture together.
    pub length: f64,
    /// Correlation lengths next to the scar, less one: the degrees of freedom of section, depth and width.
    pub freedom: f64,
    /// Readings in all.
    pub readings: usize,
    /// Readings that are spikes.
    pub spikes: usize,
    /// Share of the profile that is debris or pile-up next to the scar.
    pub debris: f64,
}

impl Scar {
    /// The scar on readings, places and heights out of the material (m), of a body with a height (m) at each place from the middle of the
    /// contact, held against a computed shape.
    ///
    /// # Errors
    /// If no scar of such a shape stands out, or too little was measured next to it for its level.
    pub fn find(
        readings: &[[f64; 2]],
        nominal: &dyn Fn(f64) -> f64,
        shape: &Shape,
    ) -> Result<Self, NoScar> {
        let blocks = Blocks::of(readings);
        if blocks.len() < FEWEST || blocks.span() <= 0.0 {
            return Err(NoScar::Few { readings: blocks.readings, least: FEWEST });
        }
        let model = Model::new(&blocks, nominal, shape);
        let settled = Settled::of(&model).ok_or(NoScar::Nothing)?;
        let worn = Worn::of(&model, &settled);
        let ((section, of_section), unseen, through) = worn.section();
        let Settled { shift, grown, scatter, gls, .. } = &settled;
        let deviation = |i: usize| gls.uncertain[(i, i)].sqrt();
        let correlated = scatter.correlated(blocks.step());
        if settled.hidden {
            let (texture, deepest) = (scatter.texture, shape.deepest(1.0));
            return Err(NoScar::Hidden { texture, deepest });
        }
        if unseen > UNSEEN * section {
            return Err(NoScar::Unseen { share: unseen / section });
        }
        let correlation = gls.uncertain[(0, 2)] / deviation(0) / deviation(2);
        let leaning = worn.leaning((of_section, through));
        if leaning.is_none_or(|own| own > LEANING) || correlation.abs() > COMMON {
            return Err(NoScar::Unlevelled { length: correlated });
        }
        if !(GROWN[0]..=GROWN[1]).contains(grown) {
            return Err(NoScar::OtherSize { grown: *grown });
        }
        let debris = settled.debris.iter().filter(|own| **own).count() as f64 / blocks.len() as f64;
        let [low, high] = shape.extent(*grown).map(|place| place + shift);
        let next_to_it = blocks.span() * (1.0 - debris) - (high - low);
        let freedom = (next_to_it / correlated - 1.0).max(1.0);
        // Growth and place are found by the scar, too: by as many independent stretches as it has, less these two.
        let within = ((high - low) / scatter.length - 2.0).max(1.0).min(freedom);
        let estimate = |(value, standard): (f64, f64), freedom: f64| {
            let factor = StudentsT::new(0.0, 1.0, freedom)
                .map_or(f64::INFINITY, |own| own.inverse_cdf(0.975));
            Estimate { value, standard, expanded: factor * standard }
        };
        // Of blocks of one reading, those without weight are spikes, too.
        let single = blocks.len() == blocks.readings;
        let weights = settled.weights.iter().zip(&settled.debris);
        let poor = weights.filter(|own| single && *own.0 < worn::POOR && !own.1).count();
        let depth = worn.depth();
        let width = depth.as_ref().and_then(|(found, weights)| worn.width((found.0, weights)));
        let middle = blocks.places.iter().sum::<f64>() / blocks.len() as f64;
        let tilt = settled.level[1] / blocks.span();
        Ok(Self {
            place: estimate((*shift, deviation(3)), within),
            height: settled.level[0] + tilt * (shift - middle),
            tilt,
            grown: estimate((*grown, deviation(2)), within),
            section: estimate((section, of_section), freedom),
            unseen,
            depth: depth.map(|own| estimate(own.0, freedom)),
            width: width.map(|own| estimate(own, freedom)),
            extent: [low, high],
            noise: scatter.noise,
            texture: scatter.texture,
            misfit: scatter.misfit,
            length: correlated,
            freedom,
            readings: blocks.readings,
            spikes: blocks.spikes + poor,
            debris,
        })
    }

    /// What is worn off (m) at a reading, and its place from the middle of the contact (m).
    pub fn depth_at(&self, [place, height]: [f64; 2], nominal: &dyn Fn(f64) -> f64) -> [f64; 2] {
        let from = place - self.place.value;
        [from, nominal(from) + self.height + self.tilt * from - height]
    }
}

/// Depth (m) of the parabola through the middle half of a computed shape, and its width (m) at a twentieth of that, as [`Scar`] has those of
/// readings; `None` of a shape with too few points.
pub fn depth_and_width(shape: &Shape) -> Option<[f64; 2]> {
    Some([shape.depth()?, shape.width_at(worn::EDGE, 1.0)?])
}
