//! The plane through a point that is worst off.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use super::Components;
use super::ball::smallest_ball;

/// The normal of a plane, of unit length.
pub type Plane = [f64; 3];

/// Steps of the planes that are tried between the pole and the equator: ten degrees each. A choice of effort.
const STEPS: usize = 9;
/// How many of them are refined: a choice of effort, too. Two maxima may be about as large.
const BEST: usize = 6;
/// How closely (rad): a maximum is met to the square of it, which is rounding.
const CLOSE: f64 = 1e-7;
/// By how much of a value a step has to lead up: above the rounding of the smallest circle, below any stress's own error.
const GAINED: f64 = 1e-10;

/// What a path of stresses, or strains, does on a plane.
#[doc(hidden)]
#[derive(Debug, Clone, PartialEq)]
pub struct OnPlane {
    /// Normal to it, a value a moment.
    pub normal: Vec<f64>,
    /// Along it, in two directions.
    pub shear: Vec<[f64; 2]>,
}

impl OnPlane {
    /// On a plane.
    pub fn of(path: &[Components], plane: Plane) -> Self {
        let [u, v] = axes(plane);
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let on = |&[xx, yy, zz, xy, xz, yz]: &Components| {
            let drawn = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].map(|row| dot(row, plane));
            (dot(drawn, plane), [dot(drawn, u), dot(drawn, v)])
        };
        let (normal, shear) = path.iter().map(on).unzip();
        Self { normal, shear }
    }

    /// The radius of the smallest circle around the shear.
    pub fn shear_amplitude(&self) -> f64 {
        smallest_ball(&self.shear).1
    }

    /// The largest normal component.
    pub fn largest_normal(&self) -> f64 {
        self.normal.iter().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// Half of the range of the normal component.
    pub fn normal_amplitude(&self) -> f64 {
        let least = self.normal.iter().copied().fold(f64::INFINITY, f64::min);
        0.5 * (self.largest_normal() - least)
    }
}

/// The largest value over all planes, and where: the best of some are refined.
pub fn worst(value: impl Fn(Plane) -> f64) -> (f64, Plane) {
    let mut tried: Vec<(f64, Plane)> = planes().into_iter().map(|one| (value(one), one)).collect();
    tried.sort_by(|a, b| b.0.total_cmp(&a.0));
    let refined = tried.into_iter().take(BEST).map(|start| refine(&value, start));
    refined.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::NAN, [0.0, 0.0, 1.0]))
}

/// Climbs from a plane to the next maximum: to the best of eight planes around it, or of the quadric that goes through them, which
/// follows the ridge that a stress about even around an axis has. Steps double where the quadric leads, and halve where nothing does.
fn refine(value: &impl Fn(Plane) -> f64, (mut best, mut plane): (f64, Plane)) -> (f64, Plane) {
    let first = FRAC_PI_2 / STEPS as f64;
    let mut step = first;
    while step > CLOSE {
        let [u, v] = axes(plane);
        let moved = |x: f64, y: f64| {
            let next = unit([0, 1, 2].map(|i| plane[i] + x * u[i] + y * v[i]));
            (value(next), next)
        };
        let eighths: [[f64; 2]; 8] = std::array::from_fn(|eighth| {
            let (sin, cos) = (eighth as f64 * FRAC_PI_4).sin_cos();
            [cos, sin]
        });
        let around = eighths.map(|[x, y]| moved(step * x, step * y));
        let [x, y] = highest(best, &eighths, &around.map(|(value, _)| value));
        let led = moved(step * x, step * y);
        let better = around.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or(led);
        let climbs = |there: f64| there > best + GAINED * best.abs();
        if led.0 >= better.0 && climbs(led.0) {
            (best, plane) = led;
            step = (2.0 * step).min(first);
        } else if climbs(better.0) {
            (best, plane) = better;
        } else {
            step *= 0.5;
        }
    }
    (best, plane)
}

/// Where the quadric through a value and those at eight places on the circle of radius one around it, by least squares, is highest; by
/// twice that radius at most along each of its axes.
fn highest(middle: f64, places: &[[f64; 2]; 8], values: &[f64; 8]) -> [f64; 2] {
    let mean = |weight: &dyn Fn(f64, f64) -> f64| {
        let each = places.iter().zip(values);
        each.map(|([x, y], value)| weight(*x, *y) * (value - middle)).sum::<f64>() / 8.0
    };
    // On the circle the quadric is a series of Fourier: its means give slope and curvature.
    let slope = [mean(&|x, _| 2.0 * x), mean(&|_, y| 2.0 * y)];
    let (all, cos, sin) =
        (2.0 * mean(&|_, _| 1.0), mean(&|x, y| 4.0 * (x * x - y * y)), mean(&|x, y| 8.0 * x * y));
    let (half, length) = (0.5 * sin.atan2(cos), cos.hypot(sin));
    let axis = [half.cos(), half.sin()];
    let along = |axis: [f64; 2], curved: f64| {
        let slope = axis[0] * slope[0] + axis[1] * slope[1];
        let length =
            if curved < 0.0 { (slope / -curved).clamp(-2.0, 2.0) } else { slope.signum() * 2.0 };
        axis.map(|own| own * length)
    };
    let [first, second] = [along(axis, all + length), along([-axis[1], axis[0]], all - length)];
    [first[0] + second[0], first[1] + second[1]]
}

/// Normals over half of the sphere, about evenly.
fn planes() -> Vec<Plane> {
    let mut planes = vec![];
    for row in 0..=STEPS {
        let polar = FRAC_PI_2 * row as f64 / STEPS as f64;
        let equator = row == STEPS;
        let all = (4.0 * STEPS as f64 * polar.sin()).round().max(1.0);
        let (count, turn) = if equator { (2.0 * STEPS as f64, PI) } else { (all, 2.0 * PI) };
        for index in 0..count as usize {
            let (sin, cos) = (turn * index as f64 / count).sin_cos();
            planes.push([polar.sin() * cos, polar.sin() * sin, polar.cos()]);
        }
    }
    planes
}

/// Two directions in a plane, at right angles.
fn axes([x, y, z]: Plane) -> [[f64; 3]; 2] {
    // Across the normal and the axis that it is not along.
    let first = if x.abs() < 0.7 { [0.0, z, -y] } else { [-z, 0.0, x] };
    let first = unit(first);
    let [a, b, c] = first;
    [first, [y * c - z * b, z * a - x * c, x * b - y * a]]
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = vector.iter().map(|value| value * value).sum::<f64>().sqrt();
    vector.map(|value| value / length)
}
