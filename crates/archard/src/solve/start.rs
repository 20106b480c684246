//! Pressures to start from when nothing is known.

use std::f64::consts::PI;

use super::Step;
use crate::motion::Control;
use crate::numerics::SAME;
use crate::numerics::vector::{map, sum_with};

/// Hertz's relations between the depth at the edge of the contact, the contact area and the load or
/// approach, carried over to any shape: pressure (Pa) falls with the root of the distance below the
/// edge. Also returns the approach (m) that belongs to it.
///
/// For a sphere of radius R and contact radius a the gap at the edge is z = a^2 / (2 R), the approach
/// 2 z, the mean pressure 8 E* z / (3 pi a).
pub(super) fn first_guess(step: &Step<'_>) -> (Vec<f64>, f64) {
    // Self term of a square element of side h: (4 / (pi E*)) h asinh(1).
    let modulus = 4.0 * 1f64.asinh() / PI * step.measure.side / step.compliance.normal_self_term();
    let lowest = step.gap.iter().copied().fold(f64::INFINITY, f64::min);
    let highest = step.gap.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let area = |edge: f64| {
        let [count] = sum_with([step.measure.weight], [step.gap], |[weight], [gap]| {
            [weight * f64::from(gap - lowest <= edge)]
        });
        count * step.measure.area
    };
    let edge = match step.control {
        Control::Approach(approach) => 0.5 * (approach - lowest),
        Control::Load(load) => {
            let load_at =
                |edge: f64, area: f64| 8.0 / (3.0 * PI) * modulus * edge * (PI * area).sqrt();
            let (mut low, mut high) = (0.0, highest - lowest);
            // What pairs count whose gaps are up to the low end, and those between both ends.
            let mut inside = 0.0;
            let weighed = |(pair, gap): (usize, &f64)| [gap - lowest, step.measure.weight.at(pair)];
            let mut open: Vec<[f64; 2]> = step.gap.iter().enumerate().map(weighed).collect();
            while high - low > SAME * (highest - lowest) {
                let middle = 0.5 * (low + high);
                let closed = open.iter().filter(|[gap, _]| *gap <= middle);
                let all = inside + closed.map(|[_, weight]| weight).sum::<f64>();
                if load_at(middle, all * step.measure.area) < load {
                    (low, inside) = (middle, all);
                    open.retain(|[gap, _]| *gap > middle);
                } else {
                    high = middle;
                    open.retain(|[gap, _]| *gap <= middle);
                }
            }
            high
        }
    };
    if let (true, Control::Load(_)) = (edge <= 0.0, step.control) {
        // Even gaps: all of them bear the load.
        return (map([step.gap], |[gap]| f64::from(gap <= lowest)), lowest);
    }
    if edge <= 0.0 {
        return (vec![0.0; step.gap.len()], lowest + 2.0 * edge);
    }
    let peak = 4.0 * modulus * edge / (PI * area(edge)).sqrt();
    let pressure = |[gap]: [f64; 1]| peak * (1.0 - (gap - lowest) / edge).max(0.0).sqrt();
    (map([step.gap], pressure), lowest + 2.0 * edge)
}
