//! Integrals of Kelvin's solution times the shape functions over one element.
//!
//! Both ways fill vectors of processor width: many points against the same places, and many places against
//! the same point.

use glam::DVec3;
use pulp::{Simd, WithSimd};

use super::element::evaluate;
use super::kelvin::{ALL, Kelvin, TRACTIONS};
use super::patch::Patch;
use super::rules::Places;

/// Places evaluated before their values are multiplied by the shape functions.
const CHUNK: usize = 8;

/// A place on an element in space.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot {
    place: [f64; 3],
    /// Outward, of the length of the area it stands for.
    area_vector: [f64; 3],
    area: f64,
    shape: [f64; 4],
}

impl Spot {
    /// The places in space.
    pub fn on(patch: &Patch, places: &Places, spots: &mut Vec<Self>) {
        spots.clear();
        for ((&s, &t), weight) in places.s.iter().zip(&places.t).zip(&places.weight) {
            let area_vector = *weight * patch.area_vector([s, t]);
            let mut shape = [0.0; 4];
            for (shape, polynomial) in shape.iter_mut().zip(patch.element.shape) {
                *shape = evaluate(polynomial, [s, t]);
            }
            spots.push(Self {
                place: patch.at([s, t]).into(),
                area_vector: area_vector.into(),
                area: area_vector.length(),
                shape,
            });
        }
    }
}

/// Many points against the same places.
pub(super) struct Tile<'a> {
    pub kelvin: Kelvin,
    /// Coordinates of the points, a multiple of eight of them.
    pub points: [&'a [f64]; 3],
    pub spots: &'a [Spot],
    /// Shape functions in use.
    pub nodes: usize,
    /// Whether the displacements are wanted beside the tractions.
    pub displacement: bool,
    /// The integrals: for each node and each row of the kernel, a value a point.
    pub sums: &'a mut [f64],
}

impl WithSimd for Tile<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let lanes = self.kelvin.lanes(simd);
        let [x, y, z] = self.points.map(|points| S::as_simd_f64s(points).0);
        let width = x.len();
        let (sums, _) = S::as_mut_simd_f64s(self.sums);
        let rows = if self.displacement { ALL } else { TRACTIONS };
        let zero = simd.splat_f64s(0.0);
        let mut values = [[zero; ALL]; CHUNK];
        for point in 0..width {
            for (chunk, spots) in self.spots.chunks(CHUNK).enumerate() {
                for (spot, values) in spots.iter().zip(&mut values) {
                    let r = [
                        simd.sub_f64s(simd.splat_f64s(spot.place[0]), x[point]),
                        simd.sub_f64s(simd.splat_f64s(spot.place[1]), y[point]),
                        simd.sub_f64s(simd.splat_f64s(spot.place[2]), z[point]),
                    ];
                    let n = [
                        simd.splat_f64s(spot.area_vector[0]),
                        simd.splat_f64s(spot.area_vector[1]),
                        simd.splat_f64s(spot.area_vector[2]),
                    ];
                    lanes.values(simd, r, n, simd.splat_f64s(spot.area), self.displacement, values);
                }
                for row in 0..rows {
                    for node in 0..self.nodes {
                        let at = (node * ALL + row) * width + point;
                        let mut sum = if chunk == 0 { zero } else { sums[at] };
                        for (spot, values) in spots.iter().zip(&values) {
                            let shape = simd.splat_f64s(spot.shape[node]);
                            sum = simd.mul_add_e_f64s(shape, values[row], sum);
                        }
                        sums[at] = sum;
                    }
                }
            }
        }
    }
}

/// The integrals for each node and each row of the kernel.
pub(super) type Integrals = [[f64; ALL]; 4];

/// One point against many places.
pub(super) struct Beam<'a> {
    pub kelvin: Kelvin,
    pub point: DVec3,
    pub patch: &'a Patch,
    /// A multiple of eight.
    pub places: &'a Places,
    pub displacement: bool,
}

impl WithSimd for Beam<'_> {
    type Output = Integrals;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Integrals {
        let lanes = self.kelvin.lanes(simd);
        let splat = |value: f64| simd.splat_f64s(value);
        let map = self.patch.map.map(|term| term.to_array().map(splat));
        let point = self.point.to_array().map(splat);
        let zero = splat(0.0);
        let mut shape = [[zero; 4]; 4];
        for (shape, polynomial) in shape.iter_mut().zip(self.patch.element.shape) {
            *shape = polynomial.map(splat);
        }
        let nodes = self.patch.element.shape.len();
        let rows = if self.displacement { ALL } else { TRACTIONS };
        let Places { s, t, weight } = self.places;
        let [s, t, weight] = [s, t, weight].map(|list| S::as_simd_f64s(list).0);
        let mut sums = [[zero; ALL]; 4];
        let mut values = [zero; ALL];
        for ((&s, &t), &weight) in s.iter().zip(t).zip(weight) {
            let both = simd.mul_f64s(s, t);
            let mut r = [zero; 3];
            let (mut along_s, mut along_t) = ([zero; 3], [zero; 3]);
            for axis in 0..3 {
                along_s[axis] = simd.mul_add_e_f64s(map[3][axis], t, map[1][axis]);
                along_t[axis] = simd.mul_add_e_f64s(map[3][axis], s, map[2][axis]);
                let place = simd.mul_add_e_f64s(map[1][axis], s, map[0][axis]);
                let place = simd.mul_add_e_f64s(t, along_t[axis], place);
                r[axis] = simd.sub_f64s(place, point[axis]);
            }
            let cross = |i: usize, j: usize| {
                let product = simd.mul_f64s(along_s[j], along_t[i]);
                let product = simd.sub_f64s(simd.mul_f64s(along_s[i], along_t[j]), product);
                simd.mul_f64s(weight, product)
            };
            let n = [cross(1, 2), cross(2, 0), cross(0, 1)];
            let square = simd.mul_f64s(n[0], n[0]);
            let square = simd.mul_add_e_f64s(n[1], n[1], square);
            let area = simd.sqrt_f64s(simd.mul_add_e_f64s(n[2], n[2], square));
            lanes.values(simd, r, n, area, self.displacement, &mut values);
            for (sums, shape) in sums.iter_mut().zip(&shape).take(nodes) {
                let share = simd.mul_add_e_f64s(shape[1], s, shape[0]);
                let share = simd.mul_add_e_f64s(shape[2], t, share);
                let share = simd.mul_add_e_f64s(shape[3], both, share);
                for (sum, value) in sums.iter_mut().zip(&values).take(rows) {
                    *sum = simd.mul_add_e_f64s(share, *value, *sum);
                }
            }
        }
        sums.map(|sums| sums.map(|sum| simd.reduce_sum_f64s(sum)))
    }
}
