//! Where the later map lies on the earlier one, to a pixel: by the directions of slopes.
//!
//! Orientation correlation (A. J. Fitch and others, *British Machine Vision Conference* 2002, 133): slopes as complex numbers of length one
//! are correlated by Fourier transforms, at turns one pixel apart at the corners. Offsets have no slope; tilts are taken off as
//! the medians of slopes; a deep scar counts no more than as many points of texture.

use rustfft::num_complex::Complex;

use super::blocks::{means, smoothed};
use super::fourier::Fourier;
use super::placement::Placement;
use super::sample::Spline;
use crate::map::HeightMap;
use crate::outliers::median;

/// Most points along an axis of the maps that are correlated.
const MOST: f64 = 160.0;

/// Share of the weights of a smoothed slope that points have which were measured, at least: where two thirds are missing it is found still.
const MEASURED: f64 = 0.15;

/// What was found.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start {
    pub(super) placement: Placement,
    /// Pixel (m) of the maps that were correlated: the place is known to about that.
    pub(super) pixel: f64,
    /// Whether the turn is the largest that was sought.
    pub(super) at_limit: bool,
}

/// The shift and turn, up to `most` (rad) either way, where slopes agree best.
pub(super) fn found(before: &HeightMap, after: &HeightMap, most: f64) -> Start {
    let longest = [before, after].iter().flat_map(|map| map.size()).fold(0.0, f64::max);
    let finest = [before, after].iter().flat_map(|map| map.pixel()).fold(0.0, f64::max);
    let pixel = finest.max(longest / MOST);
    let [before, after] = [before, after].map(|map| Slopes::of(map, pixel));
    let size =
        [before.size, after.size].map(|size| size.map(|size| (size / pixel).ceil() as usize));
    let reach = 0.5 * after.size[0].hypot(after.size[1]);
    let fourier = Fourier::at_least([size[0][0] + size[1][0], size[0][1] + size[1][1]]);
    let earlier = fourier.of(size[0], &before.directions(size[0], pixel, 0.0));
    let turns = (most * reach / pixel).ceil() as i32;
    let mut best = (f64::NEG_INFINITY, Placement::default(), false);
    for index in -turns..=turns {
        let turn = most * f64::from(index) / f64::from(turns.max(1));
        let later = fourier.of(size[1], &after.directions(size[1], pixel, turn));
        let product = later.iter().zip(&earlier).map(|(later, earlier)| later.conj() * earlier);
        let agreement = fourier.back(product.collect());
        let peak =
            agreement.iter().enumerate().max_by(|one, other| one.1.re.total_cmp(&other.1.re));
        if let Some((at, value)) = peak.filter(|(_, value)| value.re > best.0) {
            let lag = fourier.lag(at);
            let shift = [0, 1].map(|axis| {
                pixel * (lag[axis] as f64 - 0.5 * (size[0][axis] as f64 - size[1][axis] as f64))
            });
            let at_limit = turns > 0 && index.abs() == turns;
            best = (value.re, Placement { shift, turn, ..Placement::default() }, at_limit);
        }
    }
    Start { placement: best.1, pixel, at_limit: best.2 }
}

/// The map with pixels of about that size.
fn fewer(map: &HeightMap, pixel: f64) -> HeightMap {
    let side = map.pixel().map(|own| (pixel / own) as usize).into_iter().min().unwrap_or(1);
    // Odd, so that the middle stays.
    let side = side - (side + 1) % 2;
    means(map, side.max(1)).unwrap_or_else(|| map.clone())
}

/// A map whose slopes are compared.
struct Slopes {
    size: [f64; 2],
    /// Means of the points that were measured, over a Gaussian.
    smooth: Spline,
    /// The share of all weights that they have.
    share: HeightMap,
}

impl Slopes {
    /// On pixels of about that size (m).
    fn of(map: &HeightMap, pixel: f64) -> Self {
        let measured = map.heights().iter().map(|height| f64::from(!height.is_nan()));
        let share = map.of_heights(measured.collect());
        let own = |height: &f64| if height.is_nan() { 0.0 } else { *height };
        let heights = map.of_heights(map.heights().iter().map(own).collect());
        let [heights, share] = [heights, share].map(|map| {
            let map = fewer(&map, pixel);
            let deviation = map.pixel().map(|own| pixel / own);
            map.of_heights(smoothed(map.elements(), map.heights(), deviation))
        });
        let means = heights.heights().iter().zip(share.heights());
        let mean = |(sum, share): (&f64, &f64)| if *share > 1e-9 { sum / share } else { f64::NAN };
        let smooth = Spline::of(&share.of_heights(means.map(mean).collect()));
        Self { size: share.size(), smooth, share }
    }

    /// Directions on square pixels about the middle, turned: of length one, zero where there is no slope.
    fn directions(&self, size: [usize; 2], pixel: f64, turn: f64) -> Vec<Complex<f64>> {
        let back = Placement { turn: -turn, ..Placement::default() };
        let known = |place: [f64; 2]| {
            let [x, y] = [0, 1].map(|axis| {
                let along = (place[axis] - self.share.place(axis, 0)) / self.share.pixel()[axis];
                (along.round().max(0.0) as usize).min(self.share.elements()[axis] - 1)
            });
            self.share.at(x, y) > MEASURED
        };
        let slope = |at: usize| {
            let index = [at % size[0], at / size[0]];
            let place =
                [0, 1].map(|axis| pixel * (index[axis] as f64 - 0.5 * (size[axis] - 1) as f64));
            let place = back.on_the_earlier(place);
            let (_, slope) = self.smooth.at(place).filter(|_| known(place))?;
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
}
