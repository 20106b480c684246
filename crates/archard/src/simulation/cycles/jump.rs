//! Wear of cycles that are jumped over, from the rubbing of one that was computed.
//!
//! What a pair slides in a cycle hardly depends on a little wear; how it is pressed does. A cycle that
//! wore the depth d under the pressure p of its most pressed instant stands for the law d' (p'), a line
//! through (p, d), and the cycles of a jump wear implicitly by it: a normal contact solve with the slope
//! on the diagonal of the compliance.

use serde::{Deserialize, Serialize};

use crate::motion::Control;
use crate::numerics::vector::{map, sum, sum_with, update};
use crate::problem::{ContactProblem, Surface};
use crate::simulation::effort::Effort;
use crate::simulation::error::Error;
use crate::simulation::memory::{History, Increment};
use crate::simulation::setup::Simulation;
use crate::simulation::spread::spread;

/// A part of a jump that an implicit solve stands for (cycles).
#[derive(Clone, Copy)]
struct Stage {
    /// Where it is, behind the beginning of the jump.
    at: f64,
    /// Its weight in its own solve, and in the wear.
    implicit: f64,
    weight: f64,
}

/// Steps of second order that damp what is stiff and wear nothing backwards: two implicit stages, the last one at the end of
/// the step (Alexander, SIAM J. Numer. Anal. 14 (1977), 1006, the method of two stages).
const GAMMA: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;
/// A short step of one stage at the end of a jump, relative to the others. A pair that joins between the stages of a step
/// wears in the last one only, under up to 1 / GAMMA times the pressure next to it; here that levels out.
const LAST: f64 = 0.25;

/// The stages of a jump over so many cycles in so many steps.
fn stages(cycles: f64, steps: usize) -> impl Iterator<Item = Stage> {
    let step = cycles / (steps as f64 + LAST);
    let both = move |index: usize| {
        let stage = |at: f64, weight: f64| Stage {
            at: (index as f64 + at) * step,
            implicit: GAMMA * step,
            weight: weight * step,
        };
        [stage(GAMMA, 1.0 - GAMMA), stage(1.0, GAMMA)]
    };
    let last = Stage { at: cycles, implicit: LAST * step, weight: LAST * step };
    (0..steps).flat_map(both).chain([last])
}

/// Wear a cycle as a function of the pressure at its most pressed instant.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Rate {
    line: Line,
    /// The contact at the most pressed instant.
    reference: History,
    control: Control,
    /// The cycle, the first being 1.
    cycle: usize,
    /// Ones where pairs in contact stuck throughout the cycle, zeros elsewhere.
    pub stuck: Vec<f64>,
}

/// What a cycle does, in terms of the pressures of its most pressed instant; fields have one value a pair.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Line {
    /// Depth at zero pressure (m) and its slope (m/Pa), of body 1 and body 2.
    constant: [Vec<f64>; 2],
    slope: [Vec<f64>; 2],
    /// Gap (m) that friction opens at that instant.
    gap_by_friction: Vec<f64>,
    /// Work of a unit pressure: the distance slid where the pressure stays (m).
    slip: Vec<f64>,
    /// Distance slid under pressure (m).
    distance: Vec<f64>,
    /// Energy dissipated (J).
    dissipated: f64,
}

/// Worn depths and what goes with them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Wear {
    /// The surfaces of body 1 and body 2.
    pub surfaces: [Surface; 2],
    /// Integral of pressure and slip (N m).
    pub load_distance: f64,
    /// Energy dissipated (J).
    pub dissipated: f64,
}

impl Wear {
    /// 2-norm over the pairs of the depth (m) worn off both bodies since an earlier wear: over all, and
    /// over those that stuck in one of two cycles and not in the other.
    pub fn since(&self, earlier: &Wear, stuck: [&[f64]; 2]) -> [f64; 2] {
        let [a, b, c, d] = self.depths_since(earlier);
        sum([a, b, c, d, stuck[0], stuck[1]], |[a, b, c, d, one, other]| {
            let square = (a + b - c - d).powi(2);
            [square, square * (one - other).abs()]
        })
        .map(f64::sqrt)
    }

    fn depths_since<'a>(&'a self, earlier: &'a Wear) -> [&'a [f64]; 4] {
        let [[a, b], [c, d]] =
            [self, earlier].map(|wear| wear.surfaces.each_ref().map(|one| &one.depth[..]));
        [a, b, c, d]
    }

    /// 2-norm over the pairs of the depth (m) worn off both bodies since an earlier wear.
    pub fn norm_since(&self, earlier: &Wear) -> f64 {
        let [a, b, c, d] = self.depths_since(earlier);
        let [squares] = sum([a, b, c, d], |[a, b, c, d]| [(a + b - c - d).powi(2)]);
        squares.sqrt()
    }

    /// 2-norm over the pairs of the depth (m) worn off both bodies.
    pub fn total(&self) -> f64 {
        let [squares] =
            sum(self.surfaces.each_ref().map(|one| &one.depth[..]), |[a, b]| [(a + b).powi(2)]);
        squares.sqrt()
    }
}

impl Rate {
    /// Of the cycle that shifted bodies have gone through, with its most pressed instant.
    ///
    /// `cycle` is its number, the first being 1. `begun` holds the pressures (Pa) at its beginning where that is the same
    /// instant, one cycle earlier: a pair that has joined since was rubbed for a part of the cycle only, and is given what
    /// its neighbours were.
    pub fn of(
        history: &History,
        reference: History,
        (cycle, begun): (usize, Option<&[f64]>),
        control: Control,
        problem: &ContactProblem,
    ) -> Self {
        let pressure = &reference.state.pressure;
        let frame = &problem.frame;
        let known = rubbed_throughout(pressure, begun);
        let control = match control {
            // On curved frames friction bears a part of the load.
            Control::Load(_) if !frame.is_plane() => Control::Load(frame.measure().load(pressure)),
            other => other,
        };
        let per_pressure = |field: &Vec<f64>| -> Vec<f64> {
            let quotient =
                map(
                    [field, pressure],
                    |[value, pressure]| {
                        if pressure > 0.0 { value / pressure } else { 0.0 }
                    },
                );
            spread(quotient, &known, frame)
        };
        let constant = [0, 1].map(|body| {
            let (depths, slopes) = (&history.rubbed.depths[body], &history.rubbed.slopes[body]);
            map(
                [depths, slopes, pressure],
                |[depth, slope, pressure]| {
                    if pressure > 0.0 { depth - slope } else { depth }
                },
            )
        });
        let couples = problem.compliance.couples();
        let gap_by_friction =
            if couples { reference.opened_by_friction(problem) } else { vec![0.0; pressure.len()] };
        let stuck = map([pressure, &history.rubbed.slip], |[pressure, slip]| {
            f64::from(pressure > 0.0 && slip == 0.0)
        });
        Self {
            line: Line {
                constant,
                slope: history.rubbed.slopes.each_ref().map(per_pressure),
                gap_by_friction,
                slip: per_pressure(&history.rubbed.work),
                distance: history.rubbed.slip.clone(),
                dissipated: history.rubbed.dissipated,
            },
            cycle,
            stuck,
            reference: reference.pressed_alone(),
            control,
        }
    }

    /// Wear after a number of cycles behind this one's in a number of steps, while the rate goes from this one to that of a
    /// later cycle, evenly in the logarithm of the cycles.
    pub fn wear_on(
        &self,
        other: &Rate,
        start: &Wear,
        (cycles, steps): (usize, usize),
        simulation: &Simulation,
        effort: &mut Effort,
    ) -> Result<Wear, Error> {
        let problem = &simulation.problem;
        let mut history = self.reference.clone();
        history.state.surfaces.clone_from(&start.surfaces);
        if problem.compliance.couples() {
            history.find_displacement(problem, effort);
        }
        let mut wear = start.clone();
        let progress = history.state.progress;
        let increment = Increment { advance: 0.0, progress, control: self.control };
        let mut earlier: Option<Vec<f64>> = None;
        // Rates are those of the middle of their cycles.
        let [first, last] = [self, other].map(|rate| rate.cycle as f64 - 0.5);
        let share = |passed: f64| {
            if last > first {
                (1.0 + (0.5 + passed) / first).ln() / (last / first).ln()
            } else {
                0.0
            }
        };
        for Stage { at, implicit, weight } in stages(cycles as f64, steps) {
            let line = self.line.towards(&other.line, share(at));
            let slope = map([&line.slope[0], &line.slope[1]], |[one, two]| implicit * (one + two));
            let undeformed = history.undeformed_gap(problem);
            let gap = map(
                [&undeformed, &line.gap_by_friction, &line.constant[0], &line.constant[1]],
                |[gap, gap_by_friction, one, two]| gap + gap_by_friction + implicit * (one + two),
            );
            if let Some(earlier) = earlier.replace(history.state.pressure.clone()) {
                history.foresee(&earlier, problem);
            }
            history.solve_normal(
                simulation,
                increment,
                &gap,
                &slope,
                &*problem.compliance,
                effort,
            )?;
            let pressure = &history.state.pressure;
            for (body, surface) in history.state.surfaces.iter_mut().enumerate() {
                let fields: [&[f64]; 3] = [&line.constant[body], &line.slope[body], pressure];
                update(&mut surface.depth, fields, |worn, [constant, slope, pressure]| {
                    worn + weight * (constant + slope * pressure).max(0.0)
                });
            }
            let measure = problem.frame.measure();
            let [work] =
                sum_with([measure.weight], [&line.slip, pressure], |[weight], [slip, p]| {
                    [weight * (slip * p)]
                });
            wear.load_distance += weight * work * measure.area;
            wear.dissipated += weight * line.dissipated;
            for surface in history.state.surfaces.iter_mut().filter(|one| !one.slid.is_empty()) {
                update(&mut surface.slid, [&line.distance], |slid, [distance]| {
                    slid + weight * distance
                });
            }
        }
        wear.surfaces = history.state.surfaces;
        Ok(wear)
    }
}

impl Line {
    /// Between two lines.
    fn towards(&self, other: &Self, share: f64) -> Self {
        let blend = |one: &[f64], two: &[f64]| {
            map([one, two], |[one, two]| (1.0 - share) * one + share * two)
        };
        let both = |one: &[Vec<f64>; 2], two: &[Vec<f64>; 2]| {
            [blend(&one[0], &two[0]), blend(&one[1], &two[1])]
        };
        Self {
            constant: both(&self.constant, &other.constant),
            slope: both(&self.slope, &other.slope),
            gap_by_friction: blend(&self.gap_by_friction, &other.gap_by_friction),
            slip: blend(&self.slip, &other.slip),
            distance: blend(&self.distance, &other.distance),
            dissipated: (1.0 - share) * self.dissipated + share * other.dissipated,
        }
    }
}

/// Which pairs were under pressure from the beginning of the cycle on; all under pressure where none were.
fn rubbed_throughout(pressure: &[f64], begun: Option<&[f64]>) -> Vec<bool> {
    let pressed = |pressure: &[f64]| -> Vec<bool> { pressure.iter().map(|&p| p > 0.0).collect() };
    let now = pressed(pressure);
    let Some(begun) = begun else { return now };
    let both: Vec<bool> = pressed(begun).iter().zip(&now).map(|(one, two)| *one && *two).collect();
    if both.contains(&true) { both } else { now }
}

#[cfg(test)]
mod tests {
    use super::{rubbed_throughout, stages};

    /// What decays at a rate, by stages as the wear of a jump takes them, is met to the second order, and a decay that is
    /// much faster than the steps is over at the end.
    #[test]
    fn stages_are_of_the_second_order_and_damp() {
        let left = |rate: f64, steps: usize| {
            stages(3.0, steps).fold(1.0, |left: f64, stage| {
                let slope = -rate * left / (1.0 + rate * stage.implicit);
                left + stage.weight * slope
            })
        };
        let error = |steps: usize| (left(0.5, steps) - (-1.5_f64).exp()).abs();
        for steps in [4, 8, 16] {
            let order = (error(steps) / error(2 * steps)).log2();
            assert!((1.7..2.3).contains(&order), "{order}");
        }
        assert!(left(1e6, 1).abs() < 1e-5);
        let total: f64 = stages(7.0, 3).map(|stage| stage.weight).sum();
        assert!((total - 7.0).abs() < 1e-12);
        assert_eq!(stages(7.0, 3).last().unwrap().at, 7.0);
    }

    #[test]
    fn what_joined_in_the_cycle_is_not_known() {
        let now = [0.0, 1.0, 2.0];
        assert_eq!(rubbed_throughout(&now, Some(&[0.0, 0.0, 3.0])), [false, false, true]);
        assert_eq!(rubbed_throughout(&now, Some(&[1.0, 0.0, 0.0])), [false, true, true]);
        assert_eq!(rubbed_throughout(&now, None), [false, true, true]);
    }
}
