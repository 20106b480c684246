//! Integrals of Kelvin's solution times the shape functions over one element.
//!
//! Both ways fill vectors of processor width: many points against the same places, and many places against
//! the same point.

use glam::DVec3;
use pulp::{Simd, WithSimd};

use super::blocks::BLOCK;
use super::element::{CURVATURES, evaluate};
use super::kelvin::{ALL, DISPLACEMENT, Kelvin, TRACTIONS};
use super::patch::Patch;
use super::rules::Places;

/// Places evaluated before their values are multiplied by the shape functions: they stay in the cache. A choice of cost.
const CHUNK: usize = 16;
/// Nodes of an element, at most.
pub(super) const NODES: usize = 4;

/// A place on an element in space.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot {
    place: [f64; 3],
    /// Outward, of the length of the area it stands for.
    area_vector: [f64; 3],
    area: f64,
    /// Of the nodes, then of the curvatures.
    shape: [f64; NODES + CURVATURES],
}

impl Spot {
    /// The places in space.
    pub fn on(patch: &Patch, places: &Places, spots: &mut Vec<Self>) {
        spots.clear();
        for ((&s, &t), weight) in places.s.iter().zip(&places.t).zip(&places.weight) {
            let area_vector = *weight * patch.area_vector([s, t]);
            let mut shape = [0.0; NODES + CURVATURES];
            for (shape, polynomial) in shape.iter_mut().zip(patch.element.shape) {
                *shape = evaluate(polynomial, [s, t]);
            }
            if let Some(square) = patch.element.curvature {
                shape[NODES..].copy_from_slice(&[s, t].map(|at| 0.5 * (at * at - square)));
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
    /// Shape functions in use, three or four.
    pub nodes: usize,
    /// Which of the curvatures are wanted, too.
    pub curvatures: [bool; CURVATURES],
    /// Whether the displacements are wanted besides the tractions.
    pub displacement: bool,
    /// The planes the points were mirrored at: -1 along their normals.
    pub image: [f64; 3],
    pub sums: Sums<'a>,
}

/// What integrals are added to, a value a point and [`BLOCK`] of them in a row: a row for each node,
/// then for each curvature, and component xx, xy, xz, yx, ...
pub(super) struct Sums<'a> {
    pub tractions: &'a mut [f64],
    pub displacements: &'a mut [f64],
    /// What a rigid displacement makes of them: a row a component.
    pub rigid: &'a mut [f64],
    /// Of the length [`SCRATCH`]; left without meaning.
    pub scratch: &'a mut [f64],
}

/// Values of the kernel at the places of a chunk, in the widest vectors there are, and what they come from.
pub(super) const SCRATCH: usize = 8 * CHUNK * (ALL + NODES + CURVATURES);

impl WithSimd for Tile<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { kelvin, points, spots, nodes, curvatures, displacement, image, sums } = self;
        let lanes = kelvin.lanes(simd);
        let x = S::as_simd_f64s(points[0]).0;
        let y = S::as_simd_f64s(points[1]).0;
        let z = S::as_simd_f64s(points[2]).0;
        let tractions = S::as_mut_simd_f64s(sums.tractions).0;
        let displacements = S::as_mut_simd_f64s(sums.displacements).0;
        let rigid = S::as_mut_simd_f64s(sums.rigid).0;
        let stride = BLOCK / S::F64_LANES;
        let zero = simd.splat_f64s(0.0);
        let (values, directions) = S::as_mut_simd_f64s(sums.scratch).0.split_at_mut(CHUNK * ALL);
        let (values, directions) =
            (values.as_chunks_mut::<ALL>().0, directions.as_chunks_mut::<4>().0);
        for point in 0..x.len() {
            for spots in spots.chunks(CHUNK) {
                for (spot, direction) in spots.iter().zip(&mut *directions) {
                    let r = [
                        simd.sub_f64s(simd.splat_f64s(spot.place[0]), x[point]),
                        simd.sub_f64s(simd.splat_f64s(spot.place[1]), y[point]),
                        simd.sub_f64s(simd.splat_f64s(spot.place[2]), z[point]),
                    ];
                    *direction = lanes.direction(simd, r);
                }
                for ((spot, values), direction) in spots.iter().zip(&mut *values).zip(&*directions)
                {
                    let n = [
                        simd.splat_f64s(spot.area_vector[0]),
                        simd.splat_f64s(spot.area_vector[1]),
                        simd.splat_f64s(spot.area_vector[2]),
                    ];
                    let area = simd.splat_f64s(spot.area);
                    lanes.values(simd, *direction, n, area, displacement, values);
                }
                let values = &values[..spots.len()];
                let mut total = [zero; TRACTIONS];
                let bent = (0..CURVATURES)
                    .filter(|&curvature| curvatures[curvature])
                    .map(|curvature| NODES + curvature);
                for row in (0..nodes).chain(bent) {
                    let shape = |spot: usize| simd.splat_f64s(spots[spot].shape[row]);
                    let first = 9 * row * stride + point;
                    let rows = first..first + 8 * stride + 1;
                    let products: [_; TRACTIONS] = weighted(simd, values, 0, shape);
                    let tractions = &mut tractions[rows.clone()];
                    for component in 0..9 {
                        let sign = simd.splat_f64s(image[component / 3]);
                        let sum = &mut tractions[component * stride];
                        *sum = simd.mul_add_e_f64s(sign, products[component], *sum);
                    }
                    if row >= NODES {
                        continue;
                    }
                    for component in 0..9 {
                        total[component] = simd.add_f64s(total[component], products[component]);
                    }
                    if displacement {
                        let products: [_; ALL - TRACTIONS] =
                            weighted(simd, values, TRACTIONS, shape);
                        let displacements = &mut displacements[rows];
                        for component in 0..9 {
                            let (i, j) = (component / 3, component % 3);
                            let product = products[DISPLACEMENT[i][j] - TRACTIONS];
                            let sum = &mut displacements[component * stride];
                            *sum = simd.mul_add_e_f64s(simd.splat_f64s(image[i]), product, *sum);
                        }
                    }
                }
                let rigid = &mut rigid[point..point + 8 * stride + 1];
                for component in 0..9 {
                    let mirror = simd.splat_f64s(image[component / 3] * image[component % 3]);
                    let sum = &mut rigid[component * stride];
                    *sum = simd.mul_add_e_f64s(mirror, total[component], *sum);
                }
            }
        }
    }
}

/// The sums over the places of some rows of values times a shape function.
#[inline(always)]
fn weighted<S: Simd, const ROWS: usize>(
    simd: S,
    values: &[[S::f64s; ALL]],
    first: usize,
    shape: impl Fn(usize) -> S::f64s,
) -> [S::f64s; ROWS] {
    let mut sums = [simd.splat_f64s(0.0); ROWS];
    for (place, values) in values.iter().enumerate() {
        let shape = shape(place);
        for row in 0..ROWS {
            sums[row] = simd.mul_add_e_f64s(shape, values[first + row], sums[row]);
        }
    }
    sums
}

/// The integrals for each node, then each curvature, and each row of the kernel; those of curvatures of tractions only.
pub(super) type Integrals = [[f64; ALL]; NODES + CURVATURES];

/// One point against many places.
pub(super) struct Beam<'a> {
    pub kelvin: Kelvin,
    pub point: DVec3,
    pub patch: &'a Patch,
    /// A multiple of eight.
    pub places: &'a Places,
    pub displacement: bool,
    /// Of the length [`SCRATCH`]; left without meaning.
    pub scratch: &'a mut [f64],
}

impl WithSimd for Beam<'_> {
    type Output = Integrals;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Integrals {
        let lanes = self.kelvin.lanes(simd);
        let zero = simd.splat_f64s(0.0);
        let (mut map, mut polynomials) = ([[zero; 3]; 4], [[zero; 4]; 4]);
        for (map, term) in map.iter_mut().zip(&self.patch.map) {
            for axis in 0..3 {
                map[axis] = simd.splat_f64s(term[axis]);
            }
        }
        for (splat, polynomial) in polynomials.iter_mut().zip(self.patch.element.shape) {
            for (splat, coefficient) in splat.iter_mut().zip(polynomial) {
                *splat = simd.splat_f64s(*coefficient);
            }
        }
        let nodes = self.patch.element.nodes.len();
        let point = self.point.to_array();
        let s = S::as_simd_f64s(&self.places.s).0;
        let t = S::as_simd_f64s(&self.places.t).0;
        let weight = S::as_simd_f64s(&self.places.weight).0;
        let mut sums = [[zero; ALL]; NODES + CURVATURES];
        let curvature = self.patch.element.curvature.map(|square| simd.splat_f64s(-0.5 * square));
        let half = simd.splat_f64s(0.5);
        let (values, shapes) = S::as_mut_simd_f64s(self.scratch).0.split_at_mut(CHUNK * ALL);
        let (values, shapes) =
            (values.as_chunks_mut::<ALL>().0, shapes.as_chunks_mut::<{ NODES + CURVATURES }>().0);
        for ((s, t), weight) in s.chunks(CHUNK).zip(t.chunks(CHUNK)).zip(weight.chunks(CHUNK)) {
            for place in 0..s.len() {
                let (s, t, weight) = (s[place], t[place], weight[place]);
                let (mut r, mut along_s, mut along_t) = ([zero; 3], [zero; 3], [zero; 3]);
                for axis in 0..3 {
                    along_s[axis] = simd.mul_add_e_f64s(map[3][axis], t, map[1][axis]);
                    along_t[axis] = simd.mul_add_e_f64s(map[3][axis], s, map[2][axis]);
                    let at = simd.mul_add_e_f64s(map[1][axis], s, map[0][axis]);
                    let at = simd.mul_add_e_f64s(t, along_t[axis], at);
                    r[axis] = simd.sub_f64s(at, simd.splat_f64s(point[axis]));
                }
                let (a, b) = (along_s, along_t);
                let mut n = [zero; 3];
                for (axis, n) in n.iter_mut().enumerate() {
                    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                    let product = simd.mul_f64s(a[j], b[i]);
                    let product = simd.sub_f64s(simd.mul_f64s(a[i], b[j]), product);
                    *n = simd.mul_f64s(weight, product);
                }
                let square = simd.mul_f64s(n[0], n[0]);
                let square = simd.mul_add_e_f64s(n[1], n[1], square);
                let area = simd.sqrt_f64s(simd.mul_add_e_f64s(n[2], n[2], square));
                let direction = lanes.direction(simd, r);
                lanes.values(simd, direction, n, area, self.displacement, &mut values[place]);
                let both = simd.mul_f64s(s, t);
                for (shape, [one, along_s, along_t, along_both]) in
                    shapes[place].iter_mut().zip(&polynomials)
                {
                    let share = simd.mul_add_e_f64s(*along_s, s, *one);
                    let share = simd.mul_add_e_f64s(*along_t, t, share);
                    *shape = simd.mul_add_e_f64s(*along_both, both, share);
                }
                if let Some(constant) = curvature {
                    for (shape, at) in shapes[place][NODES..].iter_mut().zip([s, t]) {
                        *shape = simd.mul_add_e_f64s(simd.mul_f64s(half, at), at, constant);
                    }
                }
            }
            let (values, shapes) = (&values[..s.len()], &shapes[..s.len()]);
            let bent = NODES..if curvature.is_some() { NODES + CURVATURES } else { NODES };
            for row in (0..nodes).chain(bent) {
                let (shape, sums) = (|place: usize| shapes[place][row], &mut sums[row]);
                let products: [_; TRACTIONS] = weighted(simd, values, 0, shape);
                for (sum, product) in sums.iter_mut().zip(&products) {
                    *sum = simd.add_f64s(*sum, *product);
                }
                if self.displacement && row < NODES {
                    let products: [_; ALL - TRACTIONS] = weighted(simd, values, TRACTIONS, shape);
                    for (sum, product) in sums[TRACTIONS..].iter_mut().zip(&products) {
                        *sum = simd.add_f64s(*sum, *product);
                    }
                }
            }
        }
        let mut integrals = [[0.0; ALL]; NODES + CURVATURES];
        for (integrals, sums) in integrals.iter_mut().zip(&sums) {
            for (integral, sum) in integrals.iter_mut().zip(sums) {
                *integral = simd.reduce_sum_f64s(*sum);
            }
        }
        integrals
    }
}
