//! What an assembly can at best be measured by: its inner loops on points that stay in the cache.

use glam::DVec3;
use pulp::{Arch, Simd, WithSimd};

use super::blocks::BLOCK;
use super::element::{CURVATURES, element};
use super::integrate::{Spot, Tile};
use super::kelvin::{ALL, Evaluations, Kelvin};
use super::patch::Patch;
use super::rules::{Places, Rules};
use super::strip::Stock;
use crate::body::Interpolation;

/// Evaluates Kelvin's solution that many times and does nothing with it but add it up.
pub fn evaluate_alone(evaluations: Evaluations) -> f64 {
    let kelvin = Kelvin::new(0.3, 1.0);
    let alone = |evaluations, displacement| {
        Arch::new().dispatch(Alone { kelvin, evaluations, displacement })
    };
    alone(evaluations.tractions, false) + alone(evaluations.both, true)
}

/// Integrates Kelvin's solution over an element by that many evaluations, products with the shape functions
/// included.
pub fn integrate_alone(evaluations: Evaluations) -> f64 {
    let corners = vec![DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y];
    let patch = Patch::new(corners, element(Interpolation::Discontinuous, 4));
    let (mut places, mut spots) = (Places::default(), vec![]);
    Rules::new(1e-6).whole(&patch, [3, 3], &mut places);
    Spot::on(&patch, &places, &mut spots);
    let points = [0.1, 0.2, 0.3]
        .map(|step| -> [f64; BLOCK] { std::array::from_fn(|point| 2.0 + step * point as f64) });
    let (arch, mut stock) = (Arch::new(), Stock::new());
    for (evaluations, displacement) in [(evaluations.tractions, false), (evaluations.both, true)] {
        for _ in 0..evaluations.div_ceil(BLOCK * spots.len()) {
            arch.dispatch(Tile {
                kelvin: Kelvin::new(0.3, 1.0),
                points: points.each_ref().map(|points| &points[..]),
                spots: &spots,
                nodes: patch.element.nodes.len(),
                curvatures: [false; CURVATURES],
                displacement,
                image: [1.0; 3],
                sums: stock.lend(),
            });
        }
    }
    stock.tractions.iter().chain(&stock.displacements).sum()
}

/// A loop over points along a line.
struct Alone {
    kelvin: Kelvin,
    evaluations: usize,
    displacement: bool,
}

impl WithSimd for Alone {
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> f64 {
        let lanes = self.kelvin.lanes(simd);
        let mut points = [[0.0; BLOCK]; 3];
        for (axis, points) in points.iter_mut().enumerate() {
            for (index, point) in points.iter_mut().enumerate() {
                *point = 1.0 + (0.1 + axis as f64) * index as f64;
            }
        }
        let x = S::as_simd_f64s(&points[0]).0;
        let y = S::as_simd_f64s(&points[1]).0;
        let z = S::as_simd_f64s(&points[2]).0;
        let normal = [simd.splat_f64s(0.6), simd.splat_f64s(0.0), simd.splat_f64s(0.8)];
        let zero = simd.splat_f64s(0.0);
        let (mut values, mut sums) = ([zero; ALL], [zero; ALL]);
        for pass in 0..self.evaluations.div_ceil(BLOCK) {
            // Moved a little each time, so that no value can be kept.
            let shift = simd.splat_f64s(1e-9 * pass as f64);
            for point in 0..x.len() {
                let r = [simd.add_f64s(x[point], shift), y[point], z[point]];
                let area = simd.splat_f64s(1.0);
                lanes.values(
                    simd,
                    lanes.direction(simd, r),
                    normal,
                    area,
                    self.displacement,
                    &mut values,
                );
                for (sum, value) in sums.iter_mut().zip(&values) {
                    *sum = simd.add_f64s(*sum, *value);
                }
            }
        }
        let mut total = 0.0;
        for sum in &sums {
            total += simd.reduce_sum_f64s(*sum);
        }
        total
    }
}
