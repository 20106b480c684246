//! Where the later map lies on the earlier one, to a pixel: by the directions of slopes.
//!
//! Orientation correlation (A. J. Fitch and others, *British Machine Vision Conference* 2002, 133): slopes as complex numbers of length one
//! are correlated by Fourier transforms, at turns one pixel apart at the corners. Offsets have no slope; tilts are taken off as
//! the medians of slopes; a deep scar counts no more than as many points of texture.

use rustfft::num_complex::Complex;

use super::blocks::{means, smoothed};
use super::fourier::Fourier;
use super::placement::Placement;
use super::sample;
use crate::map::HeightMap;
use crate::outliers::median;

/// Most points along an axis of the maps that are correlated.
const MOST: f64 = 160.0;

/// What was found, and among how many places.
pub(super) struct Start {
    pub(super) placement: Placement,
    /// Pixel (m) of the maps that were correlated: the place is known to about that.
    pub(super) pixel: f64,
    /// How many shifts and turns were tried.
    pub(super) tried: f64,
}

/// The shift and turn, up to `most` (rad) either way, where slopes agree best.
pub(super) fn found(before: &HeightMap, after: &HeightMap, most: f64) -> Start {
    let longest = [before, after].iter().flat_map(|map| map.size()).fold(0.0, f64::max);
    let finest = [before, after].iter().flat_map(|map| map.pixel()).fold(0.0, f64::max);
    let pixel = finest.max(longest / MOST);
    let [before, after] = [before, after].map(|map| fewer(map, pixel));
    let size =
        [before.size(), after.size()].map(|size| size.map(|size| (size / pixel).ceil() as usize));
    let reach = 0.5 * after.size()[0].hypot(after.size()[1]);
    let fourier = Fourier::at_least([size[0][0] + size[1][0], size[0][1] + size[1][1]]);
    let earlier = fourier.of(size[0], &directions(&before, size[0], pixel, 0.0));
    let turns = (most * reach / pixel).ceil() as i32;
    let mut best = (f64::NEG_INFINITY, Placement::default());
    for index in -turns..=turns {
        let turn = most * f64::from(index) / f64::from(turns.max(1));
        let later = fourier.of(size[1], &directions(&after, size[1], pixel, turn));
        let product = later.iter().zip(&earlier).map(|(later, earlier)| later.conj() * earlier);
        let agreement = fourier.back(product.collect());
        let peak =
            agreement.iter().enumerate().max_by(|one, other| one.1.re.total_cmp(&other.1.re));
        if let Some((at, value)) = peak.filter(|(_, value)| value.re > best.0) {
            let lag = fourier.lag(at);
            let shift = [0, 1].map(|axis| {
                pixel * (lag[axis] as f64 - 0.5 * (size[0][axis] as f64 - size[1][axis] as f64))
            });
            best = (value.re, Placement { shift, turn, ..Placement::default() });
        }
    }
    let tried = f64::from(2 * turns + 1) * (fourier.size()[0] * fourier.size()[1]) as f64;
    Start { placement: best.1, pixel, tried }
}

/// The map with pixels of about that size.
fn fewer(map: &HeightMap, pixel: f64) -> HeightMap {
    let side = map.pixel().map(|own| (pixel / own) as usize).into_iter().min().unwrap_or(1);
    // Odd, so that the middle stays.
    let side = side - (side + 1) % 2;
    means(map, side.max(1)).unwrap_or_else(|| map.clone())
}

/// The directions of slopes of a map on square pixels about its middle, turned: of length one, zero where there is no slope.
fn directions(map: &HeightMap, size: [usize; 2], pixel: f64, turn: f64) -> Vec<Complex<f64>> {
    let deviation = map.pixel().map(|own| 0.5 * pixel / own);
    let smooth = map.of_heights(smoothed(map.elements(), map.heights(), deviation));
    let back = Placement { turn: -turn, ..Placement::default() };
    let slope = |at: usize| {
        let index = [at % size[0], at / size[0]];
        let place = [0, 1].map(|axis| pixel * (index[axis] as f64 - 0.5 * (size[axis] - 1) as f64));
        let (_, slope) = sample::at(&smooth, back.on_the_earlier(place))?;
        // Slopes turn with the map.
        Some(Complex::new(slope[0], slope[1]) * Complex::from_polar(1.0, turn))
    };
    let slopes: Vec<Option<Complex<f64>>> = (0..size[0] * size[1]).map(slope).collect();
    let middle = |part: fn(&Complex<f64>) -> f64| {
        median(&mut slopes.iter().flatten().map(part).collect::<Vec<f64>>()).unwrap_or(0.0)
    };
    let tilt = Complex::new(middle(|one| one.re), middle(|one| one.im));
    let direction = |slope: &Option<Complex<f64>>| {
        let slope = slope.map_or(Complex::default(), |slope| slope - tilt);
        let length = slope.norm();
        if length > 0.0 { slope / length } else { Complex::default() }
    };
    slopes.iter().map(direction).collect()
}
