//! How wheel and rail change over a route, in a few numbers.

use super::{Travelled, Worn, error_of};
use crate::flange::Flange;
use crate::setup::Side;

/// The column of the equivalent conicity.
pub const CONICITY: &str = "equivalent_conicity";

/// The names of what is told of a side, each with its unit, in the order of [`Told::values`].
///
/// Of the wheel the worn area of its section, its worn volume, its largest depth, the depth at the datum of the tread (y = 0), and
/// height, thickness and gradient of the [`Flange`]; of the rail the worn area and the largest depth;
/// of both the equivalent conicity, if it is asked for.
pub const COLUMNS: [&str; 10] = [
    "wheel_worn_area_m2",
    "wheel_worn_volume_m3",
    "wheel_depth_m",
    "tread_depth_m",
    "flange_height_m",
    "flange_thickness_m",
    "flange_gradient_m",
    "rail_worn_area_m2",
    "rail_depth_m",
    CONICITY,
];

/// What is told of a side at a share of the distance.
#[derive(Debug, Clone, PartialEq)]
pub struct Told {
    /// Share of the distance that is behind.
    pub progress: f64,
    /// The side.
    pub side: Side,
    /// The values by [`COLUMNS`]; not a number where the wheel has no flange or no tread.
    pub values: Vec<f64>,
}

impl Worn {
    /// What is told of it by all of [`COLUMNS`] but the last, for a wheel whose back lies at that y (m).
    pub fn told(&self, back: f64) -> Vec<f64> {
        let deepest = |depths: Vec<f64>| depths.into_iter().fold(0.0, f64::max);
        let flange = Flange::of(self.wheel.curve(), back);
        let flange = flange.map_or([f64::NAN; 3], |of| [of.height, of.thickness, of.gradient]);
        let [height, thickness, gradient] = flange;
        vec![
            self.wheel.area(),
            self.wheel.volume(),
            deepest(self.wheel.depths()),
            self.wheel.depth_at(0.0),
            height,
            thickness,
            gradient,
            self.rail.area(),
            deepest(self.rail.depths()),
        ]
    }
}

impl Travelled {
    /// What is told after each step as asked for, and the errors of the values.
    pub fn course(&self) -> Vec<(Told, Vec<f64>)> {
        let [fine, coarse, hasty] = &self.told;
        let with_errors = |told: &Told| {
            let [coarse, hasty] = [coarse, hasty].map(|course| at(course, told));
            let error = |at: usize| error_of([told.values[at], coarse[at], hasty[at]]);
            let errors = (0..told.values.len()).map(error).collect();
            (told.clone(), errors)
        };
        fine.iter().map(with_errors).collect()
    }
}

/// The values of a course at the progress of another, straight between its steps.
fn at(course: &[Told], wanted: &Told) -> Vec<f64> {
    let own: Vec<&Told> = course.iter().filter(|told| told.side == wanted.side).collect();
    let after = own.partition_point(|told| told.progress < wanted.progress).min(own.len() - 1);
    let (before, after) = (own[after.saturating_sub(1)], own[after]);
    let width = after.progress - before.progress;
    let share = if width > 0.0 { (wanted.progress - before.progress) / width } else { 1.0 };
    let between = |(one, other): (&f64, &f64)| one + share * (other - one);
    before.values.iter().zip(&after.values).map(between).collect()
}
