//! Heights and slopes of a map between its points, by cubic splines.
//!
//! The spline through the points of a map (M. Unser, *IEEE Signal Processing Magazine* 16 (1999) 22) is exact for polynomials of the third
//! degree. Holes are filled by harmonic functions first, and places next to them count as unknown. Slopes are those of the map smoothed by a
//! Gaussian: between points the noise of a spline and of its own slope have common parts, by which a fit is drawn to half pixels.

use super::blocks::smoothed;
use crate::map::HeightMap;

/// Poles of the filter that turns heights into coefficients of B-splines, of the third degree and of the fifth (Unser, table 1).
const CUBIC: [f64; 1] = [-0.267_949_192_431_122_7];
const QUINTIC: [f64; 2] = [-0.430_575_347_099_973_8, -0.043_096_288_203_264_65];
/// Rim (points) within which the spline depends on how it goes on beyond the map: 0.27^2 is 7 %.
const RIM: f64 = 2.0;
/// Deviation (points) of the Gaussian of slopes: it has the same weight wherever it lies between points, to exp(-2 pi^2).
pub(super) const SMOOTH: f64 = 1.0;
/// A place so near to a point (points) is on it.
const ON: f64 = 0.01;
/// Places between points at which the error is sought, about. A choice of cost.
const PLACES: usize = 20_000;

/// A map that is known between its points.
#[derive(Debug, Clone)]
pub(super) struct Spline {
    elements: [usize; 2],
    pixel: [f64; 2],
    coefficients: Vec<f64>,
    /// Those of the smoothed map.
    smooth: Vec<f64>,
    /// Whether a point was measured, and whether its neighbours were, too.
    known: Vec<[bool; 2]>,
    rim: f64,
}

impl Spline {
    /// Without what is uncertain at the rim.
    pub(super) fn of(map: &HeightMap) -> Self {
        let filled = map.filled().unwrap_or_else(|_| map.clone());
        let elements = map.elements();
        let smooth = smoothed(elements, filled.heights(), [SMOOTH; 2]);
        let [coefficients, smooth] =
            [filled.heights(), &smooth].map(|heights| coefficients(elements, heights, &CUBIC));
        let known = (0..map.heights().len()).map(|at| known(map, at)).collect();
        Self { elements, pixel: map.pixel(), coefficients, smooth, known, rim: RIM }
    }

    /// Up to the last points, for places that lie on points.
    pub(super) fn up_to_the_rim(self) -> Self {
        Self { rim: 0.0, ..self }
    }

    /// Whether a place (m, from the middle) is on the map.
    pub(super) fn holds(&self, place: [f64; 2]) -> bool {
        (0..2).all(|axis| {
            let along = self.along(axis, place[axis]);
            // Rounding of places on the last points.
            let rim = self.rim - 1e-9;
            along >= rim && along <= (self.elements[axis] - 1) as f64 - rim
        })
    }

    fn along(&self, axis: usize, place: f64) -> f64 {
        place / self.pixel[axis] + 0.5 * (self.elements[axis] - 1) as f64
    }

    /// Height (m) and smoothed slopes at a place (m, from the middle); `None` beyond the map or next to a hole.
    pub(super) fn at(&self, place: [f64; 2]) -> Option<(f64, [f64; 2])> {
        if !self.holds(place) {
            return None;
        }
        let [nx, _] = self.elements;
        let mut low = [0; 2];
        let mut share = [0.0; 2];
        for axis in 0..2 {
            let along = self.along(axis, place[axis]).max(0.0);
            low[axis] = (along as usize).min(self.elements[axis] - 2);
            share[axis] = along - low[axis] as f64;
        }
        let between = usize::from(share.iter().any(|t| (ON..1.0 - ON).contains(t)));
        let near = |t: f64| (if t > ON { 1 } else { 0 }, if t < 1.0 - ON { 0 } else { 1 });
        let ((x1, x0), (y1, y0)) = (near(share[0]), near(share[1]));
        for y in [y0, y1] {
            for x in [x0, x1] {
                if !self.known[low[0] + x + nx * (low[1] + y)][between] {
                    return None;
                }
            }
        }
        let [(wx, sx), (wy, sy)] = share.map(cubic);
        let (mut height, mut slope) = (0.0, [0.0; 2]);
        let columns: [usize; 4] =
            std::array::from_fn(|x| mirrored(low[0] as isize + x as isize - 1, nx));
        for y in 0..4 {
            let row = nx * mirrored(low[1] as isize + y as isize - 1, self.elements[1]);
            for x in 0..4 {
                let smooth = self.smooth[row + columns[x]];
                height += wy[y] * wx[x] * self.coefficients[row + columns[x]];
                slope[0] += wy[y] * sx[x] * smooth;
                slope[1] += sy[y] * wx[x] * smooth;
            }
        }
        Some((height, [slope[0] / self.pixel[0], slope[1] / self.pixel[1]]))
    }
}

/// What cubic splines miss of a map half-way between points (m): the standard deviation by which those of the fifth degree differ, of
/// the size that 68 % of places have at most.
pub(super) fn missed(map: &HeightMap) -> f64 {
    let filled = map.filled().unwrap_or_else(|_| map.clone());
    let elements @ [nx, ny] = map.elements();
    let of = |poles: &[f64]| coefficients(elements, filled.heights(), poles);
    let (cubic, quintic) = (of(&CUBIC), of(&QUINTIC));
    let (three, five): ([f64; 4], [f64; 6]) = (
        [1.0, 23.0, 23.0, 1.0].map(|own| own / 48.0),
        [1.0, 237.0, 1682.0, 1682.0, 237.0, 1.0].map(|own| own / 3840.0),
    );
    let sum = |field: &[f64], weights: &[f64], corner: [usize; 2]| -> f64 {
        let row = |(y, weight): (usize, &f64)| {
            let from = corner[0] + nx * (corner[1] + y);
            weight * weights.iter().zip(&field[from..]).map(|(one, own)| one * own).sum::<f64>()
        };
        weights.iter().enumerate().map(row).sum()
    };
    // Off the rim by as much as both splines need.
    let rim = 4;
    let all = (rim..ny.saturating_sub(rim + 1))
        .flat_map(|y| (rim..nx.saturating_sub(rim + 1)).map(move |x| [x, y]));
    let mut sizes: Vec<f64> = all
        .step_by((nx * ny / PLACES + 1) | 1)
        .map(|[x, y]| sum(&quintic, &five, [x - 2, y - 2]) - sum(&cubic, &three, [x - 1, y - 1]))
        .map(f64::abs)
        .collect();
    let within = (sizes.len() * 68) / 100;
    if sizes.is_empty() {
        return 0.0;
    }
    *sizes.select_nth_unstable_by(within, f64::total_cmp).1
}

/// Whether a point was measured, and whether its neighbours were, too.
fn known(map: &HeightMap, at: usize) -> [bool; 2] {
    let [nx, ny] = map.elements();
    let (x, y) = (at % nx, at / nx);
    let own = !map.heights()[at].is_nan();
    let near = [
        (x > 0).then(|| at - 1),
        (x + 1 < nx).then(|| at + 1),
        (y > 0).then(|| at - nx),
        (y + 1 < ny).then(|| at + nx),
    ];
    [own, own && near.into_iter().flatten().all(|at| !map.heights()[at].is_nan())]
}

/// An index on a map that goes on as in a mirror on its first and last point.
fn mirrored(index: isize, count: usize) -> usize {
    let last = count as isize - 1;
    let folded = index.rem_euclid((2 * last).max(1));
    (if folded > last { 2 * last - folded } else { folded }) as usize
}

/// Weights of four coefficients for the value and for the slope, a share `t` of the way from the second to the third.
fn cubic(t: f64) -> ([f64; 4], [f64; 4]) {
    let s = 1.0 - t;
    let inner = |t: f64| 2.0 / 3.0 - 0.5 * t * t * (2.0 - t);
    let rise = |t: f64| 0.5 * t * (3.0 * t - 4.0);
    (
        [s * s * s / 6.0, inner(t), inner(s), t * t * t / 6.0],
        [-0.5 * s * s, rise(t), -rise(s), 0.5 * t * t],
    )
}

/// Coefficients of B-splines through values on a grid.
fn coefficients([nx, ny]: [usize; 2], values: &[f64], poles: &[f64]) -> Vec<f64> {
    let mut field = values.to_vec();
    field.chunks_exact_mut(nx).for_each(|row| filter(row, poles));
    let mut turned = crate::filter::transposed(&field, nx);
    turned.chunks_exact_mut(ny).for_each(|row| filter(row, poles));
    crate::filter::transposed(&turned, ny)
}

/// The same along a line: a recursion there and back for each pole.
fn filter(line: &mut [f64], poles: &[f64]) {
    let count = line.len();
    for &pole in poles {
        // Further ones are below rounding.
        let reach = (f64::EPSILON.ln() / pole.abs().ln()).ceil() as isize;
        let first =
            (0..=reach).map(|at| pole.powi(at as i32) * line[mirrored(at, count)]).sum::<f64>();
        let gain = (1.0 - pole) * (1.0 - 1.0 / pole);
        line.iter_mut().for_each(|one| *one *= gain);
        line[0] = gain * first;
        for at in 1..count {
            line[at] += pole * line[at - 1];
        }
        line[count - 1] = pole / (pole * pole - 1.0) * (line[count - 1] + pole * line[count - 2]);
        for at in (0..count - 1).rev() {
            line[at] = pole * (line[at + 1] - line[at]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Spline, missed};
    use crate::map::HeightMap;

    fn wave(length: f64) -> (HeightMap, impl Fn(f64) -> [f64; 2]) {
        let k = 2.0 * std::f64::consts::PI / length;
        let blank = HeightMap::new([61, 40], [1.0, 2.0], vec![0.0; 61 * 40]).unwrap();
        let heights = (0..61 * 40).map(|at| (k * blank.place(0, at % 61)).sin()).collect();
        (blank.of_heights(heights), move |x: f64| [(k * x).sin(), k * (k * x).cos()])
    }

    /// Points are met, and waves of ten points are to some thousandths between them; their slopes follow, as a Gaussian leaves them.
    #[test]
    fn waves_are_met() {
        let (map, exact) = wave(10.0);
        let spline = Spline::of(&map);
        for x in [0.0, 3.0, 0.5, -7.3, 20.25] {
            let (height, slope) = spline.at([x, 3.3]).unwrap();
            let [value, rise] = exact(x);
            let off = if x.fract() == 0.0 { 1e-9 } else { 2e-3 };
            let kept = (-0.5 * (0.2 * std::f64::consts::PI).powi(2)).exp();
            assert!((height - value).abs() < off && (slope[0] - kept * rise).abs() < 1e-2);
            assert!(slope[1].abs() < 1e-9);
        }
        assert!(spline.at([28.5, 0.0]).is_none() && spline.at([28.0, 0.0]).is_some());
        assert!(spline.up_to_the_rim().at([30.0, -39.0]).is_some());
    }

    /// Places next to a hole are unknown, and points next to it are known.
    #[test]
    fn holes_are_unknown() {
        let (map, _) = wave(10.0);
        let holed = map.heights().iter().enumerate();
        let holed = holed.map(|(at, own)| if at == 30 + 61 * 20 { f64::NAN } else { *own });
        let spline = Spline::of(&map.of_heights(holed.collect()));
        let [x, y] = [map.place(0, 30), map.place(1, 20)];
        assert!(spline.at([x, y]).is_none() && spline.at([x + 1.5, y]).is_none());
        assert!(spline.at([x + 1.0, y]).is_some() && spline.at([x + 2.5, y]).is_some());
    }

    /// The error that is sought is that of sines, about: 68 % of their places have 0.88 of the amplitude at most.
    #[test]
    fn the_error_of_splines_is_found() {
        for length in [5.0, 8.0, 14.0] {
            let (map, exact) = wave(length);
            let spline = Spline::of(&map);
            let off = |at: i32| {
                let x = 0.1 * f64::from(at) + 0.5;
                (spline.at([x.round() + 0.5, 0.0]).unwrap().0 - exact(x.round() + 0.5)[0]).abs()
            };
            let worst = (-200..200).map(off).fold(0.0, f64::max);
            let found = missed(&map);
            assert!(found > 0.5 * worst && found < 1.2 * worst, "{length}: {found} {worst}");
        }
    }
}
