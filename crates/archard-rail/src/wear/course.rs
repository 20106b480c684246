//! How wheel and rail change over a route, in a few numbers.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{Journey, RouteResult, WornSide, error_of};
use crate::flange::Flange;
use crate::setup::Side;

/// The column of the equivalent conicity.
pub const CONICITY: &str = "equivalent_conicity";

/// The columns that are not a number unless they are asked for.
pub const ASKED: [&str; 3] = ["wheel_crack_damage", "rail_crack_damage", CONICITY];

/// The names of what is told of a side, each with its unit, in the order of [`SideCourse::values`].
///
/// Of the wheel the worn area of its section, its worn volume, its largest depth, the depth at the datum of the tread (y = 0), height,
/// thickness and gradient of the [`Flange`], and what turning the new profile again costs of the radius; of the rail the worn area and the
/// largest depth;
/// then of each its largest damage by cracks, and of both the equivalent conicity, if they are asked for.
pub const COLUMNS: [&str; 13] = [
    "wheel_worn_area_m2",
    "wheel_worn_volume_m3",
    "wheel_depth_m",
    "tread_depth_m",
    "flange_height_m",
    "flange_thickness_m",
    "flange_gradient_m",
    "turning_depth_m",
    "rail_worn_area_m2",
    "rail_depth_m",
    ASKED[0],
    ASKED[1],
    CONICITY,
];

/// What is told of a side at a share of the distance.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SideCourse {
    /// Share of the distance that is behind.
    pub progress: f64,
    /// The side.
    pub side: Side,
    /// The values by [`COLUMNS`]; not a number where the wheel has no flange or no tread.
    pub values: Vec<f64>,
    /// What turning costs (m) with a flange that is thinner by what was asked for; empty where nothing was.
    pub thinner: Vec<f64>,
}

impl Journey {
    /// What turning costs (m) for each change of the flange.
    pub(super) fn thinned(&self, worn: &WornSide) -> Vec<f64> {
        let cost = |thinner: &f64| worn.wheel.thinning_depth(self.setup.wheel(), *thinner);
        self.thinnings.par_iter().map(cost).collect()
    }

    /// What is told of a side by all of [`COLUMNS`] but the last.
    pub(super) fn told(&self, worn: &WornSide) -> Vec<f64> {
        let WornSide { wheel, rail, .. } = worn;
        let deepest = |depths: &[f64]| depths.iter().copied().fold(0.0, f64::max);
        let flange = Flange::of(wheel.curve(), self.setup.wheelset().flange_back_position);
        let flange = flange.map_or([f64::NAN; 3], |of| [of.height, of.thickness, of.gradient]);
        let [height, thickness, gradient] = flange;
        let damage = |body: usize| match self.cracks[body] {
            Some(_) => deepest(worn.profiles()[body].damage()),
            None => f64::NAN,
        };
        vec![
            wheel.area(),
            wheel.volume(),
            deepest(&wheel.depths()),
            wheel.depth_at(0.0),
            height,
            thickness,
            gradient,
            wheel.turning_depth(self.setup.wheel()),
            rail.area(),
            deepest(&rail.depths()),
            damage(0),
            damage(1),
        ]
    }
}

impl RouteResult {
    /// What is told after each step as asked for, and the errors of the values.
    pub fn course(&self) -> Vec<(SideCourse, Vec<f64>)> {
        let [fine, coarse, hasty] = &self.told;
        let with_errors = |told: &SideCourse| {
            let [coarse, hasty] = [coarse, hasty].map(|course| at(course, told));
            let error = |at: usize| error_of([told.values[at], coarse[at], hasty[at]]);
            let errors = (0..told.values.len()).map(error).collect();
            (told.clone(), errors)
        };
        fine.iter().map(with_errors).collect()
    }
}

/// The values of a course at the progress of another, straight between its steps.
fn at(course: &[SideCourse], wanted: &SideCourse) -> Vec<f64> {
    let own: Vec<&SideCourse> = course.iter().filter(|told| told.side == wanted.side).collect();
    let after = own.partition_point(|told| told.progress < wanted.progress).min(own.len() - 1);
    let (before, after) = (own[after.saturating_sub(1)], own[after]);
    let width = after.progress - before.progress;
    let share = if width > 0.0 { (wanted.progress - before.progress) / width } else { 1.0 };
    let between = |(one, other): (&f64, &f64)| one + share * (other - one);
    before.values.iter().zip(&after.values).map(between).collect()
}
